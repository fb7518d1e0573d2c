//! `measure --samples`: a curve point by point.

use comfy_table::Table;
use curveto::conic::ConicDrawing;
use curveto::measure::samples::{Sample, SamplePoint, samples};
use curveto::number::{compact, significant};
use curveto::write::conic::{ConicSamples, conic_samples_csv};
use curveto::write::measurement::{Samples, samples_csv};

use super::super::args::measure::ReportFormat;
use super::super::failure::Failure;
use super::{MeasuredSubject, written};
use crate::cli::table::{close_up, lines, plain};

/// The points of every subject.
pub(super) fn text(
    subjects: &[MeasuredSubject],
    count: usize,
    format: ReportFormat,
    always_array: bool,
) -> Result<String, Failure> {
    let all: Vec<Samples<'_>> = subjects
        .iter()
        .map(|subject| sampled(subject, count))
        .collect::<Result<_, _>>()?;
    written(&all, format, always_array, render, samples_csv)
}

fn sampled(subject: &MeasuredSubject, count: usize) -> Result<Samples<'_>, Failure> {
    Ok(Samples {
        version: 1,
        subject: &subject.measurement.subject,
        samples: samples(&subject.curve, &subject.reference, count)?,
    })
}

/// The points of parabolas and hyperbolas.
pub(super) fn conic_text(
    drawings: &[&ConicDrawing],
    count: usize,
    format: ReportFormat,
) -> Result<String, Failure> {
    let all: Vec<ConicSamples> = drawings
        .iter()
        .map(|drawing| ConicSamples::new(drawing, count))
        .collect::<Result<_, _>>()?;
    written(&all, format, false, render_conic, conic_samples_csv)
}

/// The table for people.
fn render(samples: &Samples<'_>) -> String {
    let mut table = plain();
    table.set_header(["segment", "t", "x", "y", "radius", "error", "degrees"]);
    table.add_rows(samples.samples.iter().map(row));
    let errors = samples.samples.iter().map(|s| s.error);
    captioned(&samples.subject.title, &mut table, errors)
}

fn render_conic(samples: &ConicSamples) -> String {
    let mut table = plain();
    table.set_header(["segment", "t", "x", "y", "error", "place"]);
    table.add_rows(samples.samples.iter().map(|s| {
        let [segment, t, x, y] = place(&s.at);
        let place = significant(s.place, 8);
        [segment, t, x, y, compact(s.error, 6), place]
    }));
    let errors = samples.samples.iter().map(|s| s.error);
    captioned(&samples.title, &mut table, errors)
}

/// A table below its title, with the peak and the average of what it shows.
fn captioned(title: &str, table: &mut Table, errors: impl Iterator<Item = f64>) -> String {
    close_up(table, 2, &[0, 1, 2, 3, 4, 5, 6]);
    let (count, peak, sum) = errors.fold((0, 0.0_f64, 0.0), |(count, peak, sum), e| {
        (count + 1, peak.max(e.abs()), sum + e.abs())
    });
    format!(
        "{title}\n\n{}\nof {count} points: peak {}, average {}\n",
        lines(table, ""),
        compact(peak, 6),
        compact(sum / f64::from(count), 6),
    )
}

fn row(s: &Sample) -> [String; 7] {
    let [segment, t, x, y] = place(&s.at);
    let (radius, degrees) = (compact(s.radius, 9), significant(s.degrees, 8));
    [segment, t, x, y, radius, compact(s.error, 6), degrees]
}

fn place(at: &SamplePoint) -> [String; 4] {
    [
        at.segment.to_string(),
        significant(at.t, 6),
        compact(at.x, 9),
        compact(at.y, 9),
    ]
}
