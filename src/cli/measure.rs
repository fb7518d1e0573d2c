//! `measure`.

mod conic;
mod foreign;
mod samples;
mod table;

use std::path::Path;
use std::process::ExitCode;

use curveto::approximate::{Drawing, Options};
use curveto::curve::Curve;
use curveto::measure::{Quantity, Reference};
use curveto::number::Precision;
use curveto::picture::plot::Chart;
use curveto::write::json;
use curveto::write::measurement::{Measurement, csv};
use curveto::write::plot;
use curveto::{Cut, Rule};
use serde::Serialize;

use super::Outcome;
use super::args::MeasureArgs;
use super::args::measure::{Measured, MeasuredShape, ReportArgs, ReportFormat};
use super::args::shape::{Direction, ShapeWords};
use super::draw;
use super::failure::Failure;
use super::formats::{choose, of_plot};
use super::output::OutputTarget;

/// The most segments that one run measures, all curves together.
const MOST_SEGMENTS: usize = 100_000;

/// Refuses what would take minutes.
fn check_segments(segments: usize) -> Result<(), Failure> {
    if segments <= MOST_SEGMENTS {
        return Ok(());
    }
    Err(Failure::request_with_hint(
        format!("at most {MOST_SEGMENTS} segments are measured at once, not {segments}"),
        "take fewer segments or methods; the error of a drawing of any size stands in its JSON: curveto circle 50 -n 200000 -f json",
    ))
}

/// Refuses counts of segments that would take minutes, before any is drawn.
fn check_counts(rules: &[Rule], cuts: &[Cut]) -> Result<(), Failure> {
    let counted = cuts.iter().map(|cut| match cut {
        Cut::Count(count) | Cut::Adaptive(count) => *count,
        _ => 0,
    });
    let counted = counted.fold(0, usize::saturating_add);
    check_segments(rules.len().saturating_mul(counted))
}

/// What was measured, with what a plot needs of it.
struct MeasuredSubject {
    /// What a plot calls it.
    name: String,
    curve: Curve,
    reference: Reference,
    measurement: Measurement,
    /// The number of its panel in a plot.
    panel: usize,
}

pub(super) fn run(args: &MeasureArgs) -> Outcome {
    match &args.shape {
        Some(MeasuredShape::Circle(shape)) => drawn(shape),
        Some(MeasuredShape::Ellipse(shape)) => drawn(shape),
        Some(MeasuredShape::Arc(shape)) => drawn(shape),
        Some(MeasuredShape::Conic(shape)) => {
            let conic = shape.shape.conic()?;
            match conic.arc()? {
                Some(_) => drawn(shape),
                None => conic::run(&conic, shape),
            }
        }
        None => {
            let subjects = foreign::measured(&args.foreign, &args.report)?;
            tell(&subjects, &args.report, args.foreign.file.is_some())
        }
    }
}

/// What is drawn by each method that was named and of each number of segments, which is that of a panel in a plot: refused where all together
/// have too many. `draw` tells of one how many segments it has.
fn each_drawing<S: clap::Args, T>(
    args: &Measured<S>,
    draw: impl Fn(Options) -> Result<(T, usize), Failure>,
) -> Result<Vec<(T, usize)>, Failure> {
    let precision = args
        .precision
        .map_or(Some(Precision::Full), super::args::PrecisionWord::precision);
    let (rules, cuts) = (args.approximation.rules()?, args.approximation.cuts());
    check_counts(&rules, &cuts)?;
    let (mut all, mut segments) = (Vec::new(), 0);
    for &rule in &rules {
        for (panel, cut) in cuts.iter().enumerate() {
            let (drawn, count) = draw(Options {
                rule,
                cut: cut.clone(),
                precision,
                transform: args.transform.unwrap_or_default(),
            })?;
            segments += count;
            check_segments(segments)?;
            all.push((drawn, panel));
        }
    }
    Ok(all)
}

/// Measures a shape as it would be drawn, by each method that was named.
fn drawn<S: ShapeWords + clap::Args>(args: &Measured<S>) -> Outcome {
    let (default, extremes) = (Direction::default(), args.approximation.extremes);
    let drawings = each_drawing(args, |options| {
        let options = Options {
            cut: draw::started(&args.shape, options.cut)?,
            ..options
        };
        let drawing = draw::drawing(&args.shape, default, &options, extremes)?;
        let count = drawing.curve.segments.len();
        Ok((drawing, count))
    })?;
    let subjects = drawings
        .into_iter()
        .map(|(drawing, panel)| drawn_subject(drawing, args, panel));
    let subjects: Vec<MeasuredSubject> = subjects.collect::<Result<_, _>>()?;
    tell(&subjects, &args.report, false)
}

/// Measures a drawing.
fn drawn_subject<S: clap::Args>(
    drawing: Drawing,
    args: &Measured<S>,
    panel: usize,
) -> Result<MeasuredSubject, Failure> {
    let measurement = Measurement::of_drawing(&drawing, args.report.coordinate_tolerance()?)?;
    let (Some(measurement), Some(outline)) = (measurement, &drawing.outline) else {
        return Err(Failure::request(
            "there is nothing to measure: the shape is a straight line or nothing, and that is exact",
        ));
    };
    Ok(MeasuredSubject {
        name: drawing.rule.id().to_owned(),
        reference: Reference::from(outline),
        curve: drawing.curve,
        measurement,
        panel,
    })
}

/// Writes the report, and the plot where one was asked for.
fn tell(subjects: &[MeasuredSubject], args: &ReportArgs, always_array: bool) -> Outcome {
    if let Some(file) = &args.plot {
        draw_plot(subjects, file, args)?;
    }
    let format = choose(args.format, args.output.path())?;
    let text = match args.samples {
        Some(count) => samples::text(subjects, count, format, always_array)?,
        None => report_text(subjects, format, always_array)?,
    };
    args.output.target().write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// Every figure of each subject.
fn report_text(
    subjects: &[MeasuredSubject],
    format: ReportFormat,
    always_array: bool,
) -> Result<String, Failure> {
    let measurements: Vec<&Measurement> = subjects.iter().map(|s| &s.measurement).collect();
    written(
        &measurements,
        format,
        always_array,
        |m| table::render(m),
        csv,
    )
}

/// What was found, as a table each, as CSV, or as JSON: one document or an array of them.
fn written<T: Serialize>(
    all: &[T],
    format: ReportFormat,
    always_array: bool,
    table: impl Fn(&T) -> String,
    csv: impl Fn(&[T]) -> String,
) -> Result<String, Failure> {
    Ok(match (format, all) {
        (ReportFormat::Table, all) => all.iter().map(table).collect::<Vec<_>>().join("\n"),
        (ReportFormat::Csv, all) => csv(all),
        (ReportFormat::Json, [one]) if !always_array => json::to_string(one)? + "\n",
        (ReportFormat::Json, all) => json::to_string(&all)? + "\n",
    })
}

/// Draws each quantity along every subject.
fn draw_plot(subjects: &[MeasuredSubject], file: &Path, args: &ReportArgs) -> Result<(), Failure> {
    draw_panels(
        subjects,
        |subject| subject.panel,
        file,
        args,
        |subjects, quantity| {
            let curves: Vec<(&str, &Curve, &Reference)> = subjects
                .iter()
                .map(|s| (s.name.as_str(), &s.curve, &s.reference))
                .collect();
            Ok(Chart::along(&title(subjects, quantity), quantity, &curves))
        },
    )
}

/// Draws the chart of each quantity and each panel's subjects, one below the other where there are several.
fn draw_panels<T>(
    subjects: &[T],
    panel: impl Fn(&T) -> usize,
    file: &Path,
    args: &ReportArgs,
    chart: impl Fn(&[&T], Quantity) -> Result<Chart, Failure>,
) -> Result<(), Failure> {
    let image = of_plot(file)?;
    let target = OutputTarget::new(Some(file));
    if target == OutputTarget::Stdout && args.output.target() == target {
        return Err(Failure::request_with_hint(
            "the report and the plot would both go to standard output",
            "name a file for the plot, or one for the report with -o",
        ));
    }
    let asked = args.quantity.as_slice();
    let quantities = if asked.is_empty() {
        &[Quantity::default()]
    } else {
        asked
    };
    let mut in_panels: Vec<&T> = subjects.iter().collect();
    in_panels.sort_by_key(|subject| panel(subject));
    let mut charts = Vec::new();
    for &quantity in quantities {
        for subjects in in_panels.chunk_by(|a, b| panel(a) == panel(b)) {
            charts.push(chart(subjects, quantity)?);
        }
    }
    let Some(chart) = charts.into_iter().reduce(Chart::above) else {
        return Ok(());
    };
    target.write(&plot(&chart, image, args.size)?)
}

/// What a plot of it is called.
fn words(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Error => "Distance from the true shape",
        Quantity::Curvature => "Curvature",
        Quantity::CurvatureD1 => "First derivative of curvature by arc length",
        Quantity::CurvatureD2 => "Second derivative of curvature by arc length",
        Quantity::AngleLag => "How far the angle is ahead of linear in t",
        Quantity::Drawing => "The curve with its control points",
    }
}

fn title(subjects: &[&MeasuredSubject], quantity: Quantity) -> String {
    let what = words(quantity);
    match subjects {
        [one] => format!("{what}: {}", one.measurement.subject.title),
        // Several methods of one shape: what comes before the method is the same.
        [one, ..] if one.measurement.subject.shape.is_some() => {
            let title = &one.measurement.subject.title;
            let shape = title.split(" by ").next().unwrap_or(title);
            format!("{what}: {shape}")
        }
        _ => what.to_owned(),
    }
}

impl ReportArgs {
    fn coordinate_tolerance(&self) -> Result<Option<f64>, Failure> {
        match self.coordinate_tolerance {
            Some(d) if !(d.is_finite() && d >= 0.0) => Err(Failure::request(format!(
                "a coordinate tolerance is a distance of at least 0, not {d}"
            ))),
            tolerance => Ok(tolerance),
        }
    }
}
