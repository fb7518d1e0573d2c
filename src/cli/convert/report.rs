//! What `convert` tells on standard error.

use std::io::{self, BufWriter, Write};

use curveto::document::{Counts, ElementKind, Note};
use curveto::number::{compact, counted, rounded_up};
use serde::Serialize;

use super::tree::FileJob;
use super::{Done, Trouble};
use crate::cli::args::{ReportForm, TalkArgs};
use crate::cli::failure::{Failure, fit_for_terminals};

/// What became of one file.
#[derive(Debug, Serialize)]
pub(super) struct FileReport {
    pub(super) file: String,
    /// Whether something was replaced, or would be.
    pub(super) changed: bool,
    replaced: Counts,
    notes: Vec<Note>,
    /// How far what was made lies from what stood there at most, in the user units of each element.
    #[serde(skip_serializing_if = "is_zero")]
    strayed: f64,
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
    pub(super) fn of(job: &FileJob, result: Result<Done, Trouble>) -> Self {
        let mut report = Self {
            file: job.name(),
            changed: false,
            replaced: Counts::default(),
            notes: Vec::new(),
            strayed: 0.0,
            error: None,
            hint: None,
            closed_pipe: false,
        };
        match result {
            Ok(done) => {
                report.changed = done.replaced.total() > 0;
                report.replaced = done.replaced;
                report.notes = done.notes;
                report.strayed = done.strayed;
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

#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(distance: &f64) -> bool {
    *distance == 0.0
}

/// What was done to the files.
#[derive(Debug, Clone, Copy)]
pub(super) struct DoneTo {
    /// Whether Béziers became arcs.
    pub(super) back: bool,
    /// Whether nothing was written.
    pub(super) only_checks: bool,
}

/// Tells about all files: errors and what was left, and with `--report` or `--verbose` the counts.
pub(super) fn tell(reports: &[FileReport], form: Option<ReportForm>, talk: TalkArgs, way: DoneTo) {
    // Where standard error is gone, nobody is left to tell.
    let _ = if form == Some(ReportForm::Json) {
        json(reports, &mut BufWriter::new(io::stderr().lock()))
    } else {
        let counts = (form.is_some() || talk.verbose).then_some(way);
        let mut out = BufWriter::new(anstream::stderr().lock());
        text(reports, counts, !talk.notes.quiet, &mut out)
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

/// `counts`: what was done, where the counts are told.
fn text(
    reports: &[FileReport],
    counts: Option<DoneTo>,
    notes: bool,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut say = |line: &str| out.write_all(fit_for_terminals(line).as_bytes());
    for report in reports {
        let file = &report.file;
        if let Some(error) = &report.error {
            say(&format!("error: {error}\n"))?;
        }
        if let Some(hint) = &report.hint {
            say(&format!("hint: {hint}\n"))?;
        }
        for note in report.notes.iter().filter(|_| notes) {
            let Note {
                line,
                column,
                element,
                reason,
            } = note;
            say(&format!(
                "note: {file}:{line}:{column}: <{element}> is left: {reason}\n"
            ))?;
        }
        if let Some(way) = counts.filter(|_| report.error.is_none()) {
            let told = told(&report.replaced, report.strayed, way);
            say(&format!("{file}: {told}\n"))?;
        }
    }
    if let Some(way) = counts.filter(|_| reports.len() > 1) {
        let changed = reports.iter().filter(|report| report.changed).count();
        let strayed = reports
            .iter()
            .map(|report| report.strayed)
            .fold(0.0, f64::max);
        let (files, told) = (reports.len(), told(&total(reports), strayed, way));
        say(&format!("{changed} of {files} files: {told}\n"))?;
    }
    Ok(())
}

/// The counts in words, and how far what was made lies from what stood there.
fn told(counts: &Counts, strayed: f64, way: DoneTo) -> String {
    let words: Vec<String> = ElementKind::ALL
        .into_iter()
        .filter(|kind| counts.of(*kind) > 0)
        .map(|kind| {
            let count = counts.of(kind);
            let noun = if kind == ElementKind::Path {
                "arc"
            } else {
                kind.name()
            };
            counted(count, noun)
        })
        .collect();
    if words.is_empty() {
        return "nothing to replace".to_owned();
    }
    let within = compact(rounded_up(strayed, 3), 3);
    let words = words.join(", ");
    let would = if way.only_checks { "would be " } else { "" };
    if way.back {
        format!("{words} {would}made, within {within} of the curves")
    } else {
        format!("{words} {would}replaced, within {within} of the true shapes")
    }
}
