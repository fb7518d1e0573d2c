//! `measure --samples`: a curve point by point.

use curveto::measure::samples::{Sample, samples};
use curveto::number::{compact, significant};
use curveto::write::json;
use curveto::write::measurement::{Samples, samples_csv};

use super::super::args::measure::ReportFormat;
use super::super::failure::Failure;
use super::Subject;
use super::table::{close_up, lines, plain};

/// The points of every subject.
pub(super) fn text(
    subjects: &[Subject],
    count: usize,
    format: ReportFormat,
    always_array: bool,
) -> Result<String, Failure> {
    let all: Vec<Samples<'_>> = subjects
        .iter()
        .map(|subject| sampled(subject, count))
        .collect::<Result<_, _>>()?;
    Ok(match (format, all.as_slice()) {
        (ReportFormat::Table, all) => all.iter().map(render).collect::<Vec<_>>().join("\n"),
        (ReportFormat::Csv, all) => samples_csv(all),
        (ReportFormat::Json, [one]) if !always_array => json::to_string(one)? + "\n",
        (ReportFormat::Json, all) => json::to_string(&all)? + "\n",
    })
}

fn sampled(subject: &Subject, count: usize) -> Result<Samples<'_>, Failure> {
    Ok(Samples {
        version: 1,
        subject: &subject.measurement.subject,
        samples: samples(&subject.curve, &subject.reference, count)?,
    })
}

/// The table for people, with the peak and the average of what it shows.
fn render(samples: &Samples<'_>) -> String {
    let mut table = plain();
    table.set_header(["segment", "t", "x", "y", "radius", "error", "degrees"]);
    table.add_rows(samples.samples.iter().map(row));
    close_up(&mut table, 2, &[0, 1, 2, 3, 4, 5, 6]);
    let sizes = samples.samples.iter().map(|s| s.error.abs());
    let count = samples.samples.len();
    let (peak, sum) = sizes.fold((0.0_f64, 0.0), |(peak, sum), e| (peak.max(e), sum + e));
    format!(
        "{}\n\n{}\nof {count} points: peak {}, average {}\n",
        samples.subject.title,
        lines(&table),
        compact(peak, 6),
        compact(sum / count as f64, 6),
    )
}

fn row(s: &Sample) -> [String; 7] {
    [
        s.segment.to_string(),
        significant(s.t, 6),
        compact(s.x, 9),
        compact(s.y, 9),
        compact(s.radius, 9),
        compact(s.error, 6),
        significant(s.degrees, 8),
    ]
}
