//! `convert`: files in, files out, several at a time.

mod folders;
mod report;
mod tree;

use std::ffi::OsStr;
use std::fs::{File, Metadata};
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::SystemTime;

use anyhow::Context;
use curveto::document::{self, Counts, Note, Options};
use flate2::Compression;
use flate2::write::GzEncoder;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use self::report::FileReport;
use self::tree::{Destination, FileJob, Input};
use super::Outcome;
use super::args::ConvertArgs;
use super::failure::{Failure, tell};
use super::input::{self, InputKind};
use super::output::{OutputTarget, replace_input};
use super::signals;

/// The most threads.
const MOST_THREADS: usize = 256;
/// From this many files on, a terminal sees how far it is.
const MANY_FILES: usize = 50;

pub(super) fn run(args: &ConvertArgs) -> Outcome {
    let options = args.options()?;
    let jobs = tree::jobs(&args.inputs, &args.destination, args.hidden, args.talk)?;
    if jobs.is_empty() {
        args.talk.note("there is no .svg or .svgz file to convert");
    }
    // More threads than files, or than any machine has processors, would only take time to start.
    let threads = args.each.jobs.map_or(0, Into::into);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.min(jobs.len().clamp(1, MOST_THREADS)))
        .build()
        .context("cannot start threads")?;
    if args.destination.in_place || args.destination.out_dir.is_some() {
        signals::finish_files_first().context("cannot watch for signals")?;
    }
    let bar = progress(jobs.len());
    let reports: Vec<FileReport> = pool.install(|| {
        jobs.par_iter()
            .filter(|_| signals::heard().is_none())
            .map(|job| {
                let report = FileReport::of(job, process(job, &options));
                bar.inc(1);
                report
            })
            .collect()
    });
    bar.finish_and_clear();
    for folder in folders::written(&jobs) {
        folders::remove_left_overs(&folder);
        if args.destination.in_place && reports.iter().any(|report| report.changed) {
            folders::sync(&folder);
        }
    }
    if reports.iter().any(FileReport::is_closed_pipe) {
        return Ok(ExitCode::SUCCESS);
    }
    let way = report::DoneTo {
        back: args.goes_back(),
        only_checks: args.destination.check,
    };
    report::tell(&reports, args.report, args.talk, way);
    if let Some(signal) = signals::heard() {
        let (done, all) = (reports.len(), jobs.len());
        tell(&format!(
            "error: interrupted after {done} of {all} files; each is whole, old or new\n"
        ));
        return Ok(ExitCode::from(128 + signal));
    }
    if args.destination.check {
        list_changed(&reports)?;
    }
    let failed = reports.iter().any(|report| report.error.is_some());
    let found_work = args.destination.check && reports.iter().any(|report| report.changed);
    Ok(ExitCode::from(u8::from(failed || found_work)))
}

fn progress(count: usize) -> ProgressBar {
    if count < MANY_FILES || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} files");
    ProgressBar::new(count as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// The names of the files with something to do, one a line.
fn list_changed(reports: &[FileReport]) -> Result<(), Failure> {
    let changed = reports.iter().filter(|report| report.changed);
    let lines: String = changed.flat_map(|report| [&report.file, "\n"]).collect();
    OutputTarget::Stdout.write(lines.as_bytes())
}

/// Why one file failed.
#[derive(Debug)]
enum Trouble {
    /// The document, whose message begins with line and column, and what would help.
    Document(document::Error, Option<&'static str>),
    /// Reading or writing.
    Other(Failure),
}

impl<E: Into<Failure>> From<E> for Trouble {
    fn from(error: E) -> Self {
        Self::Other(error.into())
    }
}

/// What became of one file.
struct Done {
    replaced: Counts,
    notes: Vec<Note>,
    /// How far new arcs and shapes lie from their Béziers at most.
    strayed: f64,
}

/// Converts one file.
fn process(job: &FileJob, options: &Options) -> Result<Done, Trouble> {
    let seen = job.input.stamp();
    let raw = read(&job.input)?;
    let compressed = input::is_packed(&raw);
    let bytes = if compressed {
        input::unpacked(&raw, "it")?
    } else {
        Vec::new()
    };
    let plain = if compressed { &bytes } else { &raw };
    let converted = document::convert_bytes(plain, options).map_err(|error| {
        let hint = match error {
            document::Error::TooLarge { .. } => {
                Some("fewer segments (-n) or a larger tolerance (-t) take less")
            }
            _ => InputKind::of(OsStr::new(&job.name()), plain)
                .remedy(None, Some("path data alone goes through 'curveto path'")),
        };
        Trouble::Document(error, hint)
    })?;
    let changed = converted.replaced.total() > 0;
    let done = Done {
        replaced: converted.replaced,
        notes: converted.notes,
        strayed: converted.strayed,
    };
    match &job.destination {
        Destination::Nowhere => return Ok(done),
        Destination::InPlace(_) if !changed => return Ok(done),
        _ => {}
    }
    let compress = match &job.destination {
        // The name tells: `-o icon.svgz`.
        Destination::Output(OutputTarget::File(path)) => is_svgz(path),
        _ => compressed,
    };
    let text = &*converted.bytes;
    if !changed && compress == compressed {
        job.destination.write(&raw, seen)?;
    } else if compress {
        job.destination.write(&deflate(text)?, seen)?;
    } else {
        job.destination.write(text, seen)?;
    }
    Ok(done)
}

fn is_svgz(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("svgz"))
}

fn read(input: &Input) -> Result<Vec<u8>, Trouble> {
    match input {
        Input::File(path) => {
            let bytes = || {
                let file = File::open(path).context("cannot read it")?;
                input::bytes(file, "it")
            };
            let is_plain = path.metadata().is_ok_and(|data| data.is_file());
            Ok(if is_plain {
                bytes()
            } else {
                signals::waiting(bytes)
            }?)
        }
        Input::Stdin => Ok(signals::waiting(|| input::bytes(io::stdin().lock(), "it"))?),
        Input::Unreadable(_, why) => Err(anyhow::anyhow!("{why}").into()),
    }
}

impl Destination {
    /// Writes a result here; `seen` is what the input was like before it was read.
    fn write(&self, bytes: &[u8], seen: Option<Stamp>) -> Result<(), Failure> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Output(OutputTarget::File(path)) | Self::OutDir(path) => {
                if let Some(folder) = path.parent() {
                    std::fs::create_dir_all(folder)
                        .with_context(|| format!("cannot make {}", folder.display()))?;
                }
                OutputTarget::File(path.clone()).write(bytes)
            }
            Self::Output(target) => target.write(bytes),
            Self::InPlace(path) => {
                let changed = |now: &Metadata| Stamp::of(now) != seen;
                let replaced = replace_input(path, bytes, changed)
                    .with_context(|| format!("cannot write {}", path.display()))?;
                if !replaced {
                    let why =
                        "it was changed by someone else while it was read, and is left as it is";
                    return Err(anyhow::anyhow!(why).into());
                }
                Ok(())
            }
        }
    }
}

/// What tells whether a file is still the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Stamp {
    size: u64,
    modified: SystemTime,
    inode: u64,
}

impl Stamp {
    fn of(data: &Metadata) -> Option<Self> {
        #[cfg(unix)]
        let inode = std::os::unix::fs::MetadataExt::ino(data);
        #[cfg(not(unix))]
        let inode = 0;
        Some(Self {
            size: data.len(),
            modified: data.modified().ok()?,
            inode,
        })
    }
}

impl Input {
    /// What the file is like now.
    fn stamp(&self) -> Option<Stamp> {
        match self {
            Self::File(path) => Stamp::of(&std::fs::metadata(path).ok()?),
            Self::Stdin | Self::Unreadable(..) => None,
        }
    }
}

fn deflate(bytes: &[u8]) -> Result<Vec<u8>, Trouble> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}
