//! `explore`.

use std::process::ExitCode;

use curveto::compare::Criterion;
use curveto::page::{PageDocument, PageRequest, html};
use curveto::write::json;

use super::Outcome;
use super::args::explore::{ExploreArgs, Explored, ExploredShape, PageFormat};
use super::args::shape::{Direction, ShapeWords};
use super::compare::check_segments;
use super::formats::choose;

/// The numbers of segments to choose from where none were named: of a closed shape, of an open one.
const COUNTS: [&[usize]; 2] = [&[2, 3, 4, 5, 6, 8], &[1, 2, 3, 4, 6, 8]];

pub(super) fn run(args: &ExploreArgs) -> Outcome {
    match &args.shape {
        ExploredShape::Circle(explored) => explore(explored),
        ExploredShape::Ellipse(explored) => explore(explored),
        ExploredShape::Arc(explored) => explore(explored),
        ExploredShape::Conic(explored) => explore(explored),
    }
}

fn explore<S: ShapeWords + clap::Args>(args: &Explored<S>) -> Outcome {
    let shape = args.shape.shape(Direction::default())?;
    let closed = shape.outline().is_some_and(|outline| outline.unit.closed);
    let counts = if args.segments.is_empty() {
        COUNTS[usize::from(!closed)]
    } else {
        &args.segments
    };
    check_segments(counts)?;
    let document = PageDocument::new(&PageRequest {
        shape,
        open: args.shape.open(),
        rules: &args.rules(),
        counts,
        spans: &[],
        by: Criterion::default(),
        words: None,
    })?;
    let text = match choose(args.format, args.output.path())? {
        PageFormat::Html => html(&document)?,
        PageFormat::Json => json::to_string(&document)? + "\n",
    };
    args.output.target().write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
