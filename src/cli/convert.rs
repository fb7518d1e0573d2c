//! `convert`: files in, files out, several at a time.

mod report;
mod tree;

use std::io::{self, IsTerminal, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use anyhow::Context;
use curveto::document::{self, Counts, Note, Options};
use flate2::Compression;
use flate2::read::MultiGzDecoder;
use flate2::write::GzEncoder;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use self::report::FileReport;
use self::tree::{Destination, Input, Job};
use super::Outcome;
use super::args::ConvertArgs;
use super::failure::Failure;
use super::output::{Target, write_file};

/// A compressed file may not unfold to more than this.
const MOST_BYTES: u64 = 1 << 30;
/// From this many files on, a terminal sees how far it is.
const MANY_FILES: usize = 50;

pub(super) fn run(args: &ConvertArgs) -> Outcome {
    let options = args.options()?;
    let jobs = tree::jobs(&args.inputs, &args.destination)?;
    if jobs.is_empty() {
        args.talk.note("there is no .svg or .svgz file to convert");
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(args.each.jobs.map_or(0, Into::into))
        .build()
        .context("cannot start threads")?;
    let bar = progress(jobs.len());
    let reports: Vec<FileReport> = pool.install(|| {
        jobs.par_iter()
            .map(|job| {
                let report = FileReport::of(job, process(job, &options));
                bar.inc(1);
                report
            })
            .collect()
    });
    bar.finish_and_clear();
    if reports.iter().any(FileReport::is_closed_pipe) {
        return Ok(ExitCode::SUCCESS);
    }
    report::tell(&reports, args.report, args.talk);
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
    let mut out = io::stdout().lock();
    for report in reports.iter().filter(|report| report.changed) {
        writeln!(out, "{}", report.file)?;
    }
    Ok(out.flush()?)
}

/// Why one file failed.
#[derive(Debug)]
enum Trouble {
    /// The document; its message begins with line and column.
    Document(document::Error),
    /// Reading or writing.
    Other(Failure),
}

impl<E: Into<Failure>> From<E> for Trouble {
    fn from(error: E) -> Self {
        Self::Other(error.into())
    }
}

/// Converts one file: what was replaced, and what was left.
fn process(job: &Job, options: &Options) -> Result<(Counts, Vec<Note>), Trouble> {
    let raw = read(&job.input)?;
    let compressed = raw.starts_with(&[0x1f, 0x8b]);
    let bytes = if compressed {
        inflate(&raw)?
    } else {
        Vec::new()
    };
    let text =
        document::decode(if compressed { &bytes } else { &raw }).map_err(Trouble::Document)?;
    let converted = document::convert(text, options).map_err(Trouble::Document)?;
    let changed = converted.replaced.total() > 0;
    let done = (converted.replaced, converted.notes);
    let target = match &job.destination {
        Destination::Nowhere => return Ok(done),
        Destination::InPlace(_) if !changed => return Ok(done),
        Destination::InPlace(path) | Destination::OutDir(path) | Destination::File(path) => {
            Target::File(path.clone())
        }
        Destination::Stdout => Target::Stdout,
    };
    let compress = match &job.destination {
        // The name tells: `-o icon.svgz`.
        Destination::File(path) => is_svgz(path),
        _ => compressed,
    };
    let text = converted.text.as_bytes();
    if !changed && compress == compressed {
        write(&target, &raw)?;
    } else if compress {
        write(&target, &deflate(text)?)?;
    } else {
        write(&target, text)?;
    }
    Ok(done)
}

fn is_svgz(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("svgz"))
}

fn read(input: &Input) -> Result<Vec<u8>, Trouble> {
    match input {
        Input::File(path) => Ok(std::fs::read(path).context("cannot read it")?),
        Input::Stdin => {
            let mut bytes = Vec::new();
            io::stdin()
                .lock()
                .read_to_end(&mut bytes)
                .context("cannot read it")?;
            Ok(bytes)
        }
        Input::Unreadable(_, why) => Err(anyhow::anyhow!("{why}").into()),
    }
}

fn write(target: &Target, bytes: &[u8]) -> Result<(), Trouble> {
    if let Target::File(path) = target {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)
                .with_context(|| format!("cannot make {}", folder.display()))?;
        }
        write_file(path, bytes).with_context(|| format!("cannot write {}", path.display()))?;
        return Ok(());
    }
    Ok(target.write(bytes)?)
}

fn inflate(bytes: &[u8]) -> Result<Vec<u8>, Trouble> {
    let mut out = Vec::new();
    MultiGzDecoder::new(bytes)
        .take(MOST_BYTES + 1)
        .read_to_end(&mut out)
        .context("cannot unpack it")?;
    if out.len() as u64 > MOST_BYTES {
        return Err(anyhow::anyhow!("it unpacks to more than a gibibyte").into());
    }
    Ok(out)
}

fn deflate(bytes: &[u8]) -> Result<Vec<u8>, Trouble> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}
