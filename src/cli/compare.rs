//! `compare`.

use std::process::ExitCode;

use curveto::compare::Comparison;
use curveto::picture::plot::Chart;
use curveto::write::comparison::{csv, html, table};
use curveto::write::json;
use curveto::write::{Image, plot};

use super::Outcome;
use super::args::CompareArgs;
use super::args::compare::ComparisonFormat;
use super::failure::Failure;
use super::formats::choose;
use super::output::Target;

/// The most segments of all circles together.
const MOST_SEGMENTS: usize = 10_000;

/// Refuses what would take minutes.
fn check_segments(counts: &[usize]) -> Result<(), Failure> {
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
    let comparisons: Vec<Comparison> = args
        .by
        .iter()
        .map(|&by| args.comparison(by))
        .collect::<Result<_, _>>()?;
    let target = Target::new(args.output.as_deref());
    let bytes = match (
        choose(args.format, args.output.as_deref())?,
        comparisons.as_slice(),
    ) {
        (ComparisonFormat::Table, all) => {
            let tables: Vec<String> = all.iter().map(table).collect();
            tables.join("\n").into_bytes()
        }
        (ComparisonFormat::Json, [one]) => (json::to_string(one)? + "\n").into_bytes(),
        (ComparisonFormat::Json, all) => (json::to_string(&all)? + "\n").into_bytes(),
        (format, [one]) => one_only(format, one, args, &target)?,
        _ => {
            return Err(Failure::request_with_hint(
                "a plot, a page or CSV shows one criterion",
                "-f table and -f json take several",
            ));
        }
    };
    target.write(&bytes)?;
    Ok(ExitCode::SUCCESS)
}

/// A comparison in a format that shows one criterion only.
fn one_only(
    format: ComparisonFormat,
    comparison: &Comparison,
    args: &CompareArgs,
    target: &Target,
) -> Result<Vec<u8>, Failure> {
    let chart = |image| plot(&Chart::comparison(comparison), image, args.size);
    Ok(match format {
        ComparisonFormat::Plot(image) => {
            if image == Image::Png {
                target.refuse_terminal()?;
            }
            chart(image)?
        }
        ComparisonFormat::Html => {
            let svg = chart(Image::Svg)?;
            html(comparison, &String::from_utf8_lossy(&svg)).into_bytes()
        }
        _ => csv(comparison).into_bytes(),
    })
}
