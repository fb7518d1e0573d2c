//! `measure`.

mod conic;
mod foreign;
mod samples;
mod table;

use std::path::Path;
use std::process::ExitCode;

use curveto::Cut;
use curveto::approximate::Options;
use curveto::curve::Curve;
use curveto::measure::{Quantity, Reference};
use curveto::number::Precision;
use curveto::picture::plot::Chart;
use curveto::write::json;
use curveto::write::measurement::{Measurement, csv};
use curveto::write::plot;

use super::Outcome;
use super::args::MeasureArgs;
use super::args::measure::{Measured, MeasuredShape, ReportArgs, ReportFormat};
use super::args::shape::{Direction, ShapeWords};
use super::draw;
use super::failure::Failure;
use super::formats::{choose, of_plot};
use super::output::Target;

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

/// What was measured, with what a plot needs of it.
struct Subject {
    /// What a plot calls it.
    name: String,
    curve: Curve,
    reference: Reference,
    measurement: Measurement,
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

/// Measures a shape as it would be drawn, by each method that was named.
fn drawn<S: ShapeWords + clap::Args>(args: &Measured<S>) -> Outcome {
    let precision = args
        .precision
        .map_or(Some(Precision::Full), super::args::PrecisionWord::precision);
    let mut subjects = Vec::new();
    let rules = args.approximation.rules()?;
    let counts = args.approximation.counts();
    let planned = counts.iter().fold(0_usize, |sum, &n| sum.saturating_add(n));
    check_segments(rules.len().saturating_mul(planned))?;
    let cut = draw::cut(&args.shape, &args.approximation)?;
    let cuts: Vec<Cut> = match cut {
        Cut::Adaptive(_) => counts.iter().copied().map(Cut::Adaptive).collect(),
        Cut::Count(_) => counts.iter().copied().map(Cut::Count).collect(),
        other => vec![other],
    };
    let several = cuts.len() > 1;
    let ways = rules
        .iter()
        .flat_map(|&rule| cuts.iter().map(move |cut| (rule, cut)));
    let mut segments = 0;
    for (rule, cut) in ways {
        let options = Options {
            rule,
            cut: cut.clone(),
            precision,
            transform: args.transform.unwrap_or_default(),
        };
        let drawing = draw::drawing(
            &args.shape,
            Direction::default(),
            &options,
            args.approximation.extremes,
        )?;
        segments += drawing.curve.segments.len();
        check_segments(segments)?;
        let measurement = Measurement::of_drawing(&drawing, args.report.coordinate_tolerance()?)?;
        let (Some(measurement), Some(outline)) = (measurement, &drawing.outline) else {
            return Err(Failure::request(
                "there is nothing to measure: the shape is a straight line or nothing, and that is exact",
            ));
        };
        subjects.push(Subject {
            name: match cut {
                Cut::Count(count) | Cut::Adaptive(count) if several => {
                    format!("{}, {count} segments", rule.id())
                }
                _ => rule.id().to_owned(),
            },
            reference: Reference::from(outline),
            curve: drawing.curve,
            measurement,
        });
    }
    tell(&subjects, &args.report, false)
}

/// Writes the report, and the plot where one was asked for.
fn tell(subjects: &[Subject], args: &ReportArgs, always_array: bool) -> Outcome {
    if let Some(file) = &args.plot {
        draw_plot(subjects, file, args)?;
    }
    let format = choose(args.format, args.output.as_deref())?;
    let text = match args.samples {
        Some(count) => samples::text(subjects, count, format, always_array)?,
        None => report_text(subjects, format, always_array)?,
    };
    Target::new(args.output.as_deref()).write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// Every figure of each subject.
fn report_text(
    subjects: &[Subject],
    format: ReportFormat,
    always_array: bool,
) -> Result<String, Failure> {
    let measurements: Vec<&Measurement> = subjects.iter().map(|s| &s.measurement).collect();
    Ok(match format {
        ReportFormat::Table => {
            let tables: Vec<String> = measurements.iter().map(|m| table::render(m)).collect();
            tables.join("\n")
        }
        ReportFormat::Csv => csv(&measurements),
        ReportFormat::Json => match measurements.as_slice() {
            [one] if !always_array => json::to_string(one)? + "\n",
            all => json::to_string(&all)? + "\n",
        },
    })
}

/// Draws the quantity along every subject.
fn draw_plot(subjects: &[Subject], file: &Path, args: &ReportArgs) -> Result<(), Failure> {
    let image = of_plot(file)?;
    let quantity = args.quantity.unwrap_or_default();
    let curves: Vec<(&str, &Curve, &Reference)> = subjects
        .iter()
        .map(|s| (s.name.as_str(), &s.curve, &s.reference))
        .collect();
    let chart = Chart::along(&title(subjects, quantity), quantity, &curves);
    Target::new(Some(file)).write(&plot(&chart, image, args.size)?)
}

fn title(subjects: &[Subject], quantity: Quantity) -> String {
    let what = match quantity {
        Quantity::Error => "Distance from the true shape",
        Quantity::Curvature => "Curvature",
        Quantity::CurvatureD1 => "First derivative of curvature by arc length",
        Quantity::CurvatureD2 => "Second derivative of curvature by arc length",
        Quantity::AngleLag => "How far the angle is ahead of linear in t",
    };
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
