//! What `convert` tells on standard error.

use std::io::{self, BufWriter, Write};

use curveto::document::{Counts, Kind, Note};
use serde::Serialize;

use super::Trouble;
use super::tree::Job;
use crate::cli::args::{Report, TalkArgs};
use crate::cli::failure::Failure;

/// What became of one file.
#[derive(Debug, Serialize)]
pub(super) struct FileReport {
    pub(super) file: String,
    /// Whether something was replaced, or would be.
    pub(super) changed: bool,
    replaced: Counts,
    notes: Vec<Note>,
    /// Why it failed.
    pub(super) error: Option<String>,
    /// What would help.
    #[serde(skip)]
    hint: Option<String>,
    #[serde(skip)]
    closed_pipe: bool,
}

/// The whole report.
#[derive(Debug, Serialize)]
struct Document<'a> {
    version: u32,
    replaced: Counts,
    changed: usize,
    failed: usize,
    notes: usize,
    files: &'a [FileReport],
}

impl FileReport {
    pub(super) fn of(job: &Job, result: Result<(Counts, Vec<Note>), Trouble>) -> Self {
        let mut report = Self {
            file: job.name(),
            changed: false,
            replaced: Counts::default(),
            notes: Vec::new(),
            error: None,
            hint: None,
            closed_pipe: false,
        };
        match result {
            Ok((replaced, notes)) => {
                report.changed = replaced.total() > 0;
                report.replaced = replaced;
                report.notes = notes;
            }
            Err(Trouble::Document(error, hint)) => {
                report.error = Some(format!("{}:{error}", report.file));
                report.hint = hint.map(str::to_owned);
            }
            Err(Trouble::Other(Failure::ClosedPipe)) => report.closed_pipe = true,
            Err(Trouble::Other(Failure::Request { message, hint })) => {
                report.error = Some(format!("{}: {message}", report.file));
                report.hint = hint;
            }
            Err(Trouble::Other(Failure::Running(error))) => {
                report.error = Some(format!("{}: {error:#}", report.file));
            }
        }
        report
    }

    pub(super) fn is_closed_pipe(&self) -> bool {
        self.closed_pipe
    }
}

/// Tells about all files: errors and what was left, and with `--report` or `--verbose` the counts.
pub(super) fn tell(reports: &[FileReport], form: Option<Report>, talk: TalkArgs) {
    let mut out = BufWriter::new(io::stderr().lock());
    // Where standard error is gone, nobody is left to tell.
    let _ = if form == Some(Report::Json) {
        json(reports, &mut out)
    } else {
        text(
            reports,
            form.is_some() || talk.verbose,
            !talk.quiet,
            &mut out,
        )
    };
}

fn total(reports: &[FileReport]) -> Counts {
    reports
        .iter()
        .fold(Counts::default(), |sum, report| sum + report.replaced)
}

fn json(reports: &[FileReport], out: &mut impl Write) -> io::Result<()> {
    let document = Document {
        version: 1,
        replaced: total(reports),
        changed: reports.iter().filter(|report| report.changed).count(),
        failed: reports
            .iter()
            .filter(|report| report.error.is_some())
            .count(),
        notes: reports.iter().map(|report| report.notes.len()).sum(),
        files: reports,
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}

fn text(reports: &[FileReport], counts: bool, notes: bool, out: &mut impl Write) -> io::Result<()> {
    for report in reports {
        let file = &report.file;
        if let Some(error) = &report.error {
            writeln!(out, "error: {error}")?;
        }
        if let Some(hint) = &report.hint {
            writeln!(out, "hint: {hint}")?;
        }
        for note in report.notes.iter().filter(|_| notes) {
            let Note {
                line,
                column,
                element,
                reason,
            } = note;
            writeln!(
                out,
                "note: {file}:{line}:{column}: <{element}> is left: {reason}"
            )?;
        }
        if counts && report.error.is_none() {
            writeln!(out, "{file}: {}", told(&report.replaced))?;
        }
    }
    if counts && reports.len() > 1 {
        let changed = reports.iter().filter(|report| report.changed).count();
        let (files, told) = (reports.len(), told(&total(reports)));
        writeln!(out, "{changed} of {files} files: {told}")?;
    }
    Ok(())
}

/// The counts in words.
fn told(counts: &Counts) -> String {
    let words: Vec<String> = Kind::ALL
        .into_iter()
        .filter(|kind| counts.of(*kind) > 0)
        .map(|kind| {
            let count = counts.of(kind);
            let noun = if kind == Kind::Path {
                "arc"
            } else {
                kind.name()
            };
            format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
        })
        .collect();
    if words.is_empty() {
        "nothing to replace".to_owned()
    } else {
        format!("{} replaced", words.join(", "))
    }
}
