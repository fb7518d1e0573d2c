//! `measure conic`, where that is no arc of an ellipse.

use std::process::ExitCode;

use curveto::approximate::Options;
use curveto::conic::{Conic, Drawing};
use curveto::number::{Precision, compact, rounded_up};
use curveto::write::conic::{ConicMeasurement, conic_csv};
use curveto::write::json;

use super::super::args::measure::{Measured, ReportArgs, ReportFormat};
use super::super::args::{ConicShape, PrecisionWord};
use super::super::conic::drawing;
use super::super::failure::Failure;
use super::super::formats::choose;
use super::super::output::Target;
use super::Outcome;
use super::table::{close_up, lines, plain};

/// Measures a parabola or a hyperbola as it would be drawn, by each method that was named.
pub(super) fn run(conic: &Conic, args: &Measured<ConicShape>) -> Outcome {
    refuse_what_needs_angles(&args.report)?;
    let precision = args
        .precision
        .map_or(Some(Precision::Full), PrecisionWord::precision);
    let transform = args.transform.unwrap_or_default();
    let mut drawings: Vec<Drawing> = Vec::new();
    for cut in args.approximation.cuts() {
        for rule in args.approximation.rules()? {
            let options = Options {
                rule,
                cut: cut.clone(),
                precision,
                transform,
            };
            drawings.push(drawing(conic, &args.approximation, &options)?);
        }
    }
    let all: Vec<ConicMeasurement> = drawings.iter().map(Into::into).collect();
    let output = args.report.output.as_deref();
    let text = match (choose(args.report.format, output)?, all.as_slice()) {
        (ReportFormat::Table, all) => all.iter().map(table).collect::<Vec<_>>().join("\n"),
        (ReportFormat::Csv, all) => conic_csv(all),
        (ReportFormat::Json, [one]) => json::to_string(one)? + "\n",
        (ReportFormat::Json, all) => json::to_string(&all)? + "\n",
    };
    Target::new(output).write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

fn refuse_what_needs_angles(report: &ReportArgs) -> Result<(), Failure> {
    let asked = [
        (report.plot.is_some(), "--plot"),
        (report.samples.is_some(), "--samples"),
        (
            report.coordinate_tolerance.is_some(),
            "--coordinate-tolerance",
        ),
    ];
    match asked.iter().find(|(given, _)| *given) {
        Some((_, option)) => Err(Failure::request_with_hint(
            format!("{option} goes with circles and ellipses, but this conic is none"),
            "leave it out, or take a weight below 0.9999",
        )),
        None => Ok(()),
    }
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
    let order = report.continuity.clone().unwrap_or_else(|| "-".to_owned());
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
    format!("{}\n\n{}", found.title, lines(&table))
}
