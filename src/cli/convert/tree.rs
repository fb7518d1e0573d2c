//! Which files are read, and where each result goes.

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use walkdir::{DirEntry, WalkDir};

use crate::cli::args::{DestinationArgs, TalkArgs};
use crate::cli::failure::Failure;
use crate::cli::formats;
use crate::cli::input::Source;
use crate::cli::new_file::folder_of;
use crate::cli::output::{OutputTarget, place_of};

/// What is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Input {
    File(PathBuf),
    Stdin,
    /// A folder or a file that cannot be looked into, and why.
    Unreadable(PathBuf, String),
}

/// Where the result goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Destination {
    /// What `-o` names, or standard output.
    Output(OutputTarget),
    /// A file below the folder of `--out-dir`.
    OutDir(PathBuf),
    /// The input itself.
    InPlace(PathBuf),
    /// Nowhere: `--check`.
    Nowhere,
}

/// One file to convert.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FileJob {
    pub(super) input: Input,
    pub(super) destination: Destination,
}

impl FileJob {
    /// The name that messages give.
    pub(super) fn name(&self) -> String {
        match &self.input {
            Input::File(path) | Input::Unreadable(path, _) => path.display().to_string(),
            Input::Stdin => Source::Stdin.name(),
        }
    }
}

/// A file that was found, and its place below the folder that was named.
struct FoundFile {
    input: Input,
    below: PathBuf,
}

/// The jobs for these words; refuses what cannot be meant.
pub(super) fn jobs(
    inputs: &[PathBuf],
    destination: &DestinationArgs,
    hidden: bool,
    talk: TalkArgs,
) -> Result<Vec<FileJob>, Failure> {
    let stdin = [PathBuf::from("-")];
    let inputs = if inputs.is_empty() { &stdin } else { inputs };
    check(inputs, destination)?;
    let mut found = Vec::new();
    let walk = Walk {
        hidden,
        left_out: destination
            .out_dir
            .as_ref()
            .and_then(|dir| fs::canonicalize(dir).ok()),
        talk,
    };
    for input in inputs {
        walk.find(input, &mut found);
    }
    if let Some(dir) = &destination.out_dir {
        refuse_own_folder(inputs, dir)?;
    }
    let jobs = found
        .into_iter()
        .map(|FoundFile { input, below }| {
            let destination = match (destination, &input) {
                (DestinationArgs { check: true, .. }, _) => Destination::Nowhere,
                (DestinationArgs { in_place: true, .. }, Input::File(path)) => {
                    Destination::InPlace(path.clone())
                }
                (
                    DestinationArgs {
                        out_dir: Some(dir), ..
                    },
                    _,
                ) => Destination::OutDir(dir.join(below)),
                (DestinationArgs { output, .. }, _) => {
                    Destination::Output(OutputTarget::new(output.as_deref()))
                }
            };
            FileJob { input, destination }
        })
        .collect();
    without_clashes(jobs)
}

/// The remedy where an input has no place for its result.
const ELSEWHERE: &str = "give -o FILE, or take the result from standard output";

fn check(inputs: &[PathBuf], destination: &DestinationArgs) -> Result<(), Failure> {
    let hint = "give --in-place, --out-dir DIR or --check";
    let DestinationArgs {
        output,
        out_dir,
        in_place,
        check,
    } = destination;
    let many = inputs.len() > 1 || inputs.iter().any(|input| input.is_dir());
    let stdin = inputs.iter().filter(|input| Source::of(input).is_stdin());
    let stdin = stdin.count();
    if stdin > 1 {
        return Err(Failure::request("standard input can be read only once"));
    }
    if many && output.is_some() {
        return Err(Failure::request_with_hint(
            "-o takes the result of one file, not of several or of a folder",
            hint,
        ));
    }
    if let Some(format) = output.as_deref().and_then(formats::of_extension)
        && !format.has_path_commands()
    {
        return Err(Failure::request_with_hint(
            format!("the result is SVG, and no {format}"),
            format!(
                "'curveto path FILE.svg --to arcs -f {format}' draws its shapes in another format"
            ),
        ));
    }
    if many && !in_place && !check && out_dir.is_none() {
        return Err(Failure::request_with_hint(
            "several files or a folder have no place on standard output",
            hint,
        ));
    }
    if stdin == 1 && (*in_place || out_dir.is_some()) {
        return Err(Failure::request_with_hint(
            "standard input has no name to be written under",
            ELSEWHERE,
        ));
    }
    let special =
        |input: &&PathBuf| fs::metadata(input).is_ok_and(|data| !data.is_file() && !data.is_dir());
    if *in_place && let Some(input) = inputs.iter().find(special) {
        return Err(Failure::request_with_hint(
            format!(
                "{} is no regular file, which --in-place could replace",
                input.display()
            ),
            ELSEWHERE,
        ));
    }
    Ok(())
}

/// Refuses to write results over the files that they are made from.
fn refuse_own_folder(inputs: &[PathBuf], dir: &Path) -> Result<(), Failure> {
    let Ok(dir) = fs::canonicalize(dir) else {
        return Ok(());
    };
    let own = |input: &PathBuf| {
        let folder = if input.is_dir() {
            input.as_path()
        } else {
            folder_of(input)
        };
        fs::canonicalize(folder).is_ok_and(|folder| folder == dir)
    };
    match inputs.iter().find(|input| own(input)) {
        Some(input) => Err(Failure::request_with_hint(
            format!("--out-dir is the folder of {} itself", input.display()),
            "--in-place replaces files where they are",
        )),
        None => Ok(()),
    }
}

/// How folders are walked.
struct Walk {
    /// Whether hidden files and folders are taken too.
    hidden: bool,
    /// The folder of results, which is not walked.
    left_out: Option<PathBuf>,
    talk: TalkArgs,
}

impl Walk {
    /// Adds a file, or all SVG files of a folder in the order of their names. Links to folders are not followed, nor links to
    /// files outside of the folder; what is no plain file is left out.
    fn find(&self, input: &Path, found: &mut Vec<FoundFile>) {
        if Source::of(input).is_stdin() {
            return found.push(FoundFile {
                input: Input::Stdin,
                below: PathBuf::new(),
            });
        }
        if !input.is_dir() {
            let below = input.file_name().map(PathBuf::from).unwrap_or_default();
            return found.push(FoundFile {
                input: Input::File(input.to_owned()),
                below,
            });
        }
        let root = fs::canonicalize(input).unwrap_or_else(|_| input.to_owned());
        let entries = WalkDir::new(input).sort_by_file_name().into_iter();
        let mut files = Vec::new();
        for entry in entries.filter_entry(|entry| entry.depth() == 0 || self.is_walked(entry)) {
            match entry {
                Ok(entry) => {
                    let path = entry.path();
                    if is_svg(path) && self.is_ours(path, &root) {
                        files.push(FoundFile {
                            below: path.strip_prefix(input).unwrap_or(path).to_owned(),
                            input: Input::File(path.to_owned()),
                        });
                    }
                }
                Err(error) => found.push(unreadable(input, &error)),
            }
        }
        found.append(&mut files);
    }

    /// Whether an entry is taken: hidden ones are not, unless they are asked for, nor is the folder of results.
    fn is_walked(&self, entry: &DirEntry) -> bool {
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        let is_left_out = entry.file_type().is_dir()
            && self.left_out.is_some()
            && fs::canonicalize(entry.path()).ok() == self.left_out;
        (self.hidden || !is_hidden) && !is_left_out
    }

    /// Whether a name leads to a plain file of the folder; what cannot be looked at does, so that it is reported.
    fn is_ours(&self, path: &Path, root: &Path) -> bool {
        let left = |why: &str| {
            self.talk
                .note(&format!("{}: is left: {why}", path.display()));
            false
        };
        let is_link = fs::symlink_metadata(path).is_ok_and(|data| data.is_symlink());
        match fs::metadata(path) {
            Ok(data) if data.is_file() => {}
            Ok(_) => return left("it is no plain file"),
            Err(error) if is_link && error.kind() != io::ErrorKind::PermissionDenied => {
                return left("the link leads nowhere");
            }
            Err(_) => return true,
        }
        if is_link && !fs::canonicalize(path).is_ok_and(|target| target.starts_with(root)) {
            return left("the link leads out of the folder; name the file itself to convert it");
        }
        true
    }
}

/// A folder that cannot be looked into.
fn unreadable(input: &Path, error: &walkdir::Error) -> FoundFile {
    let folder = error.path().unwrap_or(input).to_owned();
    let why = error
        .io_error()
        .map_or_else(|| error.to_string(), ToString::to_string);
    let why = format!("cannot read it: {why}");
    FoundFile {
        input: Input::Unreadable(folder, why),
        below: PathBuf::new(),
    }
}

fn is_svg(path: &Path) -> bool {
    let named = |extension: &std::ffi::OsStr| {
        ["svg", "svgz"]
            .iter()
            .any(|svg| extension.eq_ignore_ascii_case(svg))
    };
    path.extension().is_some_and(named) && !path.is_dir()
}

/// Refuses a folder of results below which a link leads to a file of the run.
fn refuse_inputs_as_results(jobs: &[FileJob]) -> Result<(), Failure> {
    let inputs = jobs
        .iter()
        .filter_map(|job| match (&job.input, &job.destination) {
            (Input::File(path), Destination::OutDir(_)) => {
                Some((fs::canonicalize(path).ok()?, path))
            }
            _ => None,
        });
    let inputs: HashMap<_, _> = inputs.collect();
    for job in jobs {
        if let Destination::OutDir(path) = &job.destination
            && let Some(input) = inputs.get(&place_of(path))
        {
            return Err(Failure::request_with_hint(
                format!(
                    "the result of {} would be written over {}",
                    job.name(),
                    input.display()
                ),
                format!("{} leads there", path.display()),
            ));
        }
    }
    Ok(())
}

/// Whether two inputs are one file.
fn is_same(one: &Input, other: &Input) -> bool {
    match (one, other) {
        (Input::File(one), Input::File(other)) => place_of(one) == place_of(other),
        _ => one == other,
    }
}

/// Drops a file that was named twice; refuses two files that would be written to one place.
fn without_clashes(jobs: Vec<FileJob>) -> Result<Vec<FileJob>, Failure> {
    refuse_inputs_as_results(&jobs)?;
    let mut taken: HashMap<PathBuf, Input> = HashMap::new();
    let mut kept = Vec::with_capacity(jobs.len());
    for job in jobs {
        let place = match &job.destination {
            // A link below the folder of results may lead two of them to one file, and one file by two names is one file.
            Destination::OutDir(path) | Destination::InPlace(path) => place_of(path),
            // These are the place of one result.
            Destination::Output(_) | Destination::Nowhere => {
                kept.push(job);
                continue;
            }
        };
        match taken.get(&place) {
            Some(other) if is_same(other, &job.input) => continue,
            Some(Input::File(other)) if !matches!(job.input, Input::Unreadable(..)) => {
                return Err(Failure::request_with_hint(
                    format!(
                        "{} and {} would both be written to {}",
                        other.display(),
                        job.name(),
                        place.display()
                    ),
                    "convert them in two runs with different folders",
                ));
            }
            _ => {}
        }
        taken.insert(place, job.input.clone());
        kept.push(job);
    }
    Ok(kept)
}
