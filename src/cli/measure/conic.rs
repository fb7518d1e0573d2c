//! `measure conic`, where that is no arc of an ellipse.

use std::process::ExitCode;

use curveto::conic::{Conic, ConicDrawing};
use curveto::measure::Quantity;
use curveto::number::{compact, rounded_up};
use curveto::picture::plot::Chart;
use curveto::write::conic::{ConicMeasurement, conic_csv};

use super::super::args::ConicShape;
use super::super::args::measure::{Measured, ReportFormat};
use super::super::conic::drawing;
use super::super::failure::Failure;
use super::super::formats::choose;
use super::super::output::OutputTarget;
use super::Outcome;
use super::{draw_panels, each_drawing, samples, words, written};
use crate::cli::table::{close_up, lines, plain};

/// A drawing, and the number of its panel in a plot.
struct ConicSubject {
    drawing: ConicDrawing,
    title: String,
    panel: usize,
}

/// Measures a parabola or a hyperbola as it would be drawn, by each method that was named.
pub(super) fn run(conic: &Conic, args: &Measured<ConicShape>) -> Outcome {
    let report = &args.report;
    if report.coordinate_tolerance.is_some() {
        return Err(Failure::request_with_hint(
            "--coordinate-tolerance goes with circles and ellipses, but this conic is none",
            "leave it out, or take a weight below 0.9999",
        ));
    }
    if report.plot.is_some() && report.quantity.contains(&Quantity::AngleLag) {
        return Err(Failure::request_with_hint(
            "a parabola and a hyperbola have no angle about a centre, and so no angle-lag",
            "take --quantity error, curvature, curvature-d1 or curvature-d2, or a weight below 0.9999",
        ));
    }
    let subjects = drawn(conic, args)?;
    if let Some(file) = &report.plot {
        draw_panels(&subjects, |subject| subject.panel, file, report, chart)?;
    }
    let output = report.output.path();
    let format = choose(report.format, output)?;
    let drawings: Vec<&ConicDrawing> = subjects.iter().map(|subject| &subject.drawing).collect();
    let text = match report.samples {
        Some(count) => samples::conic_text(&drawings, count, format)?,
        None => report_text(&drawings, format)?,
    };
    OutputTarget::new(output).write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// The drawings by each method and of each number of segments.
fn drawn(conic: &Conic, args: &Measured<ConicShape>) -> Result<Vec<ConicSubject>, Failure> {
    let drawings = each_drawing(args, |options| {
        let drawing = drawing(conic, &args.approximation, &options)?;
        let count = drawing.curve.segments.len();
        Ok((drawing, count))
    })?;
    let subject = |(drawing, panel)| ConicSubject {
        title: ConicMeasurement::from(&drawing).title,
        drawing,
        panel,
    };
    Ok(drawings.into_iter().map(subject).collect())
}

/// The quantity along the drawings of one panel.
fn chart(subjects: &[&ConicSubject], quantity: Quantity) -> Result<Chart, Failure> {
    let drawings: Vec<(&str, &ConicDrawing)> = subjects
        .iter()
        .map(|subject| (subject.drawing.method_name(), &subject.drawing))
        .collect();
    let title = match subjects {
        [one] => one.title.as_str(),
        // Several methods of one conic: what comes before the method is the same.
        [one, ..] => one.title.split(" by ").next().unwrap_or_default(),
        [] => "",
    };
    let title = format!("{}: {title}", words(quantity));
    Ok(Chart::along_conics(&title, quantity, &drawings)?)
}

/// Every figure of each drawing.
fn report_text(drawings: &[&ConicDrawing], format: ReportFormat) -> Result<String, Failure> {
    let all: Vec<ConicMeasurement> = drawings.iter().map(|&drawing| drawing.into()).collect();
    written(&all, format, false, table, conic_csv)
}

fn table(found: &ConicMeasurement) -> String {
    let (error, report) = (&found.error, &found.report);
    let bound = |x: f64| compact(rounded_up(x, 7), 7);
    let share = format!(
        "{} of half the longer side of the three points",
        compact(rounded_up(error.relative_peak, 6), 6)
    );
    let extent = format!(
        "true {}; {}",
        compact(report.length.truth, 7),
        compact(report.length.difference, 4)
    );
    let order = report
        .continuity
        .map_or_else(|| "-".to_owned(), |order| order.to_string());
    let joints = match report.continuity {
        None => "no joints".to_owned(),
        Some(_) => format!("largest turn {} degrees", compact(report.largest_turn, 3)),
    };
    let mut table = plain();
    table.add_rows([
        [
            "outward",
            &bound(error.outward),
            "towards the control point",
        ],
        ["inward", &bound(error.inward), ""],
        ["peak", &bound(error.peak), &share],
        ["length", &compact(report.length.curve, 7), &extent],
        [
            "true curvature to",
            &compact(report.true_largest_curvature, 7),
            "",
        ],
        ["continuity", &order, &joints],
    ]);
    close_up(&mut table, 2, &[]);
    format!("{}\n\n{}", found.title, lines(&table, ""))
}
