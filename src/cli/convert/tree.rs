//! Which files are read, and where each result goes.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::cli::args::DestinationArgs;
use crate::cli::failure::Failure;

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
    Stdout,
    /// The file of `-o`.
    File(PathBuf),
    /// A file below the folder of `--out-dir`.
    OutDir(PathBuf),
    /// The input itself.
    InPlace(PathBuf),
    /// Nowhere: `--check`.
    Nowhere,
}

/// One file to convert.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Job {
    pub(super) input: Input,
    pub(super) destination: Destination,
}

impl Job {
    /// The name that messages give.
    pub(super) fn name(&self) -> String {
        match &self.input {
            Input::File(path) | Input::Unreadable(path, _) => path.display().to_string(),
            Input::Stdin => "<stdin>".to_owned(),
        }
    }
}

/// A file that was found, and its place below the folder that was named.
struct Found {
    input: Input,
    below: PathBuf,
}

/// The jobs for these words; refuses what cannot be meant.
pub(super) fn jobs(inputs: &[PathBuf], destination: &DestinationArgs) -> Result<Vec<Job>, Failure> {
    let stdin = [PathBuf::from("-")];
    let inputs = if inputs.is_empty() { &stdin } else { inputs };
    check(inputs, destination)?;
    let mut found = Vec::new();
    for input in inputs {
        find(input, &mut found);
    }
    let jobs = found
        .into_iter()
        .map(|Found { input, below }| {
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
                (
                    DestinationArgs {
                        output: Some(path), ..
                    },
                    _,
                ) if path.as_os_str() != "-" => Destination::File(path.clone()),
                _ => Destination::Stdout,
            };
            Job { input, destination }
        })
        .collect();
    without_clashes(jobs)
}

fn check(inputs: &[PathBuf], destination: &DestinationArgs) -> Result<(), Failure> {
    let hint = "give --in-place, --out-dir DIR or --check";
    let DestinationArgs {
        output,
        out_dir,
        in_place,
        check,
    } = destination;
    let many = inputs.len() > 1 || inputs.iter().any(|input| input.is_dir());
    if inputs
        .iter()
        .filter(|input| input.as_os_str() == "-")
        .count()
        > 1
    {
        return Err(Failure::request("standard input can be read only once"));
    }
    let stdin = inputs.iter().any(|input| input.as_os_str() == "-");
    if many && output.is_some() {
        return Err(Failure::request_with_hint(
            "-o takes the result of one file, not of several or of a folder",
            hint,
        ));
    }
    if many && !in_place && !check && out_dir.is_none() {
        return Err(Failure::request_with_hint(
            "several files or a folder have no place on standard output",
            hint,
        ));
    }
    if stdin && (*in_place || out_dir.is_some()) {
        return Err(Failure::request_with_hint(
            "standard input has no name to be written under",
            "give -o FILE, or take the result from standard output",
        ));
    }
    Ok(())
}

/// Adds a file, or all SVG files of a folder in the order of their names. Links to folders are not followed.
fn find(input: &Path, found: &mut Vec<Found>) {
    if input.as_os_str() == "-" {
        return found.push(Found {
            input: Input::Stdin,
            below: PathBuf::new(),
        });
    }
    if !input.is_dir() {
        let below = input.file_name().map(PathBuf::from).unwrap_or_default();
        return found.push(Found {
            input: Input::File(input.to_owned()),
            below,
        });
    }
    let mut folders = vec![input.to_owned()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        match entries(&folder) {
            Ok(entries) => {
                for (path, is_folder) in entries {
                    if is_folder {
                        folders.push(path);
                    } else if is_svg(&path) {
                        files.push(path);
                    }
                }
            }
            Err(error) => {
                let why = format!("cannot read it: {error}");
                found.push(Found {
                    input: Input::Unreadable(folder, why),
                    below: PathBuf::new(),
                });
            }
        }
    }
    files.sort();
    found.extend(files.into_iter().map(|path| {
        let below = path.strip_prefix(input).unwrap_or(&path).to_owned();
        Found {
            input: Input::File(path),
            below,
        }
    }));
}

/// What a folder holds, and whether each is a folder itself.
fn entries(folder: &Path) -> std::io::Result<Vec<(PathBuf, bool)>> {
    fs::read_dir(folder)?
        .map(|entry| {
            let entry = entry?;
            Ok((entry.path(), entry.file_type()?.is_dir()))
        })
        .collect()
}

fn is_svg(path: &Path) -> bool {
    let named = |extension: &std::ffi::OsStr| {
        ["svg", "svgz"]
            .iter()
            .any(|svg| extension.eq_ignore_ascii_case(svg))
    };
    path.extension().is_some_and(named) && !path.is_dir()
}

/// Drops a file that was named twice; refuses two files that would be written to one place.
fn without_clashes(jobs: Vec<Job>) -> Result<Vec<Job>, Failure> {
    let mut taken: HashMap<PathBuf, Input> = HashMap::new();
    let mut kept = Vec::with_capacity(jobs.len());
    for job in jobs {
        let place = match &job.destination {
            Destination::OutDir(path) | Destination::File(path) => path.clone(),
            // One file by two names is one file.
            Destination::InPlace(path) => fs::canonicalize(path).unwrap_or_else(|_| path.clone()),
            Destination::Stdout | Destination::Nowhere => {
                kept.push(job);
                continue;
            }
        };
        match taken.get(&place) {
            Some(other)
                if *other == job.input || matches!(job.destination, Destination::InPlace(_)) =>
            {
                continue;
            }
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
