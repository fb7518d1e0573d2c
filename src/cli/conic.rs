//! `conic`.

use std::process::ExitCode;

use curveto::approximate::Options;
use curveto::conic::{Conic, ConicDrawing};

use super::Outcome;
use super::args::{ApproximationArgs, ConicShape, Draw};
use super::draw;
use super::failure::Failure;
use super::output::write_drawn;

pub(super) fn run(args: &Draw<ConicShape>) -> Outcome {
    let conic = args.shape.conic()?;
    if conic.arc()?.is_some() {
        return draw::run(args);
    }
    let format = args.output.format()?;
    let (precision, transform) = (args.output.rounding(format), args.output.transform());
    let rule = args.approximation.rule()?;
    let options = Options {
        rule,
        cut: args.approximation.cut(),
        precision,
        transform,
    };
    let drawing = drawing(&conic, &args.approximation, &options)?;
    let manner = args.output.options(format)?;
    write_drawn(&drawing, format, &manner, &args.output)?;
    Ok(ExitCode::SUCCESS)
}

/// The drawing of a parabola or a hyperbola.
pub(super) fn drawing(
    conic: &Conic,
    approximation: &ApproximationArgs,
    options: &Options,
) -> Result<ConicDrawing, Failure> {
    if approximation.extremes {
        return Err(Failure::request_with_hint(
            "--extremes is for circles and ellipses, not for a parabola or a hyperbola",
            "-n and -t cut them",
        ));
    }
    Ok(conic.draw(options)?)
}
