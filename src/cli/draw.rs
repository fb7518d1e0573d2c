//! `circle`, `ellipse` and `arc`.

use std::process::ExitCode;

use clap::Args;
use curveto::approximate::{Drawing, Options, approximate, approximate_at_extremes};
use curveto::write::Format;
use curveto::{Angle, Cut, Rule, Shape};

use super::Outcome;
use super::args::Draw;
use super::args::shape::{Direction, ShapeWords};
use super::failure::Failure;
use super::output::write_drawn;

pub(super) fn run<S: ShapeWords + Args>(args: &Draw<S>) -> Outcome {
    let Draw {
        shape,
        approximation,
        output,
    } = args;
    let format = output.format()?;
    let default = if format.runs_as_drawellipse() {
        Direction {
            start: Angle::from_degrees(180.0),
            reverse: true,
        }
    } else {
        Direction::default()
    };
    let is_gcode = format == Format::Gcode;
    let asked = started(shape, approximation.cut())?;
    // G-code has the arc itself: how one would approximate it says nothing.
    let (rule, cut) = if is_gcode {
        (Rule::default(), Cut::Quarters)
    } else {
        (approximation.rule()?, asked.clone())
    };
    let options = Options {
        rule,
        cut,
        precision: output.rounding(format),
        transform: output.transform(),
    };
    let drawing = drawing(shape, default, &options, approximation.extremes)?;
    let mut manner = output.options(format)?;
    // Where nothing is said of how an arc is approximated, a format that has arcs gets the arc.
    manner.exact = approximation.is_silent() && matches!(drawing.shape, Shape::Arc(_));
    manner.room = match asked {
        Cut::Tolerance(tolerance) => Some(tolerance.for_radius(drawing.larger_radius())),
        _ => None,
    };
    write_drawn(&drawing, format, &manner, output)?;
    if matches!(drawing.shape, Shape::Empty) {
        output
            .talk
            .note("the arc has no length, so that nothing is drawn");
    }
    Ok(ExitCode::SUCCESS)
}

/// The drawing of a shape that was asked for.
pub(super) fn drawing(
    shape: &impl ShapeWords,
    default: Direction,
    options: &Options,
    extremes: bool,
) -> Result<Drawing, Failure> {
    let shape_asked = shape.shape(default)?;
    let mut drawing = if extremes {
        approximate_at_extremes(&shape_asked, shape.start().is_some(), options)?
    } else {
        approximate(&shape_asked, options)?
    };
    if shape.open() {
        drawing.curve.closed = false;
    }
    Ok(drawing)
}

/// The cut, in which joints that were asked for begin where the shape was asked to start.
pub(super) fn started(shape: &impl ShapeWords, mut cut: Cut) -> Result<Cut, Failure> {
    if let (Cut::At(joints), Some(start)) = (&mut cut, shape.start()) {
        let same = |joint: &Angle| (joint.degrees() - start.degrees()).rem_euclid(360.0) == 0.0;
        let Some(first) = joints.iter().position(same) else {
            return Err(Failure::request_with_hint(
                format!("--start {} is not one of the joints", start.degrees()),
                "with --joints a closed shape starts at the first of them; --start may name another of them",
            ));
        };
        joints.rotate_left(first);
    }
    Ok(cut)
}
