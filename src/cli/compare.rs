//! `compare`.

use std::process::ExitCode;

use curveto::compare::Comparison;
use curveto::number::text;
use curveto::page::{PageDocument, PageRequest, html};
use curveto::picture::plot::Chart;
use curveto::write::comparison::{csv, table};
use curveto::write::json;
use curveto::write::{Image, plot};
use curveto::{Angle, Circle, Ellipse, Rule, Shape};

use super::Outcome;
use super::args::CompareArgs;
use super::args::compare::ComparisonFormat;
use super::failure::Failure;
use super::formats::choose;
use super::output::OutputTarget;

/// The most segments of all circles together.
const MOST_SEGMENTS: usize = 10_000;

/// Refuses what would take minutes.
pub(super) fn check_segments(counts: &[usize]) -> Result<(), Failure> {
    let segments = counts
        .iter()
        .fold(0_usize, |sum, &count| sum.saturating_add(count));
    if segments <= MOST_SEGMENTS {
        return Ok(());
    }
    Err(Failure::request_with_hint(
        format!("methods are compared on at most {MOST_SEGMENTS} segments in all, not {segments}"),
        "their errors fall by powers of the number of segments: the order is in the table; 'curveto measure' takes 100000",
    ))
}

pub(super) fn run(args: &CompareArgs) -> Outcome {
    check_segments(&args.segments)?;
    args.check_quadrature()?;
    let target = args.output.target();
    let format = choose(args.format, args.output.path())?;
    args.check_size(format)?;
    if format == ComparisonFormat::Html {
        target.write(page(args)?.as_bytes())?;
        return Ok(ExitCode::SUCCESS);
    }
    let comparisons: Vec<Comparison> = args
        .by
        .iter()
        .map(|&by| args.comparison(by))
        .collect::<Result<_, _>>()?;
    let bytes = match (format, comparisons.as_slice()) {
        (ComparisonFormat::Table, all) => {
            let tables: Vec<String> = all.iter().map(table).collect();
            tables.join("\n").into_bytes()
        }
        (ComparisonFormat::Json, [one]) => (json::to_string(one)? + "\n").into_bytes(),
        (ComparisonFormat::Json, all) => (json::to_string(&all)? + "\n").into_bytes(),
        (format, [one]) => one_only(format, one, args, &target)?,
        _ => {
            return Err(Failure::request_with_hint(
                "a plot or CSV shows one criterion",
                "-f table, -f json and -f html take several",
            ));
        }
    };
    target.write(&bytes)?;
    Ok(ExitCode::SUCCESS)
}

/// The page of the circle or the ellipse, which has all criteria and begins with the first that was named.
fn page(args: &CompareArgs) -> Result<String, Failure> {
    let shape = match args.ellipse {
        None => Shape::Circle(Circle::new((0.0, 0.0), 1.0)?),
        Some(ratio) => Shape::Ellipse(Ellipse::new((0.0, 0.0), (1.0, ratio), Angle::ZERO)?),
    };
    let mut words = vec!["compare".to_owned()];
    if let Some(ratio) = args.ellipse {
        words.extend(["--ellipse".to_owned(), text(ratio)]);
    }
    let rules = args.rules();
    if rules.contains(&Rule::CHEN_2_GAUSS_2) {
        words.push("--quadrature gauss2".to_owned());
    }
    let document = PageDocument::new(&PageRequest {
        shape,
        open: false,
        rules: &rules,
        counts: &args.segments,
        spans: &args.spans,
        by: args.by.first().copied().unwrap_or_default(),
        words: Some(words.join(" ")),
    })?;
    Ok(html(&document)?)
}

/// A comparison in a format that shows one criterion only.
fn one_only(
    format: ComparisonFormat,
    comparison: &Comparison,
    args: &CompareArgs,
    target: &OutputTarget,
) -> Result<Vec<u8>, Failure> {
    let chart = |image| plot(&Chart::comparison(comparison), image, args.size);
    Ok(match format {
        ComparisonFormat::Plot(image) => {
            if image == Image::Png {
                target.refuse_terminal()?;
            }
            chart(image)?
        }
        _ => csv(comparison).into_bytes(),
    })
}
