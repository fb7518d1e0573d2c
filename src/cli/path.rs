//! `path`.

use std::process::ExitCode;

use curveto::Cut;
use curveto::approximate::Options;
use curveto::arcs;
use curveto::contour::{Contour, Step, draw};
use curveto::path::{contours, contours_of_power};
use curveto::write::Format;

use super::args::{PathArgs, PathKind};
use super::failure::Failure;
use super::output::write_drawn;
use super::{Outcome, input};

/// The contours of path data that messages call `name`; says what reads other files.
fn read((data, name): &(String, String)) -> Result<Vec<Contour>, Failure> {
    let hint = match data.trim_start().chars().next() {
        Some('<') => {
            "an SVG file goes through 'curveto convert'; 'curveto measure --file' measures its paths"
        }
        Some('%') => "'curveto diff' reads PostScript drawings",
        _ => return contours(data).map_err(|error| input::named(name, error)),
    };
    contours(data).map_err(|error| input::named(name, error).with_hint(hint))
}

/// Refuses joints where there is no arc that could have them.
fn check_joints(args: &PathArgs, contours: &[Contour]) -> Result<(), Failure> {
    let mut steps = contours.iter().flat_map(|contour| &contour.steps);
    if let Cut::At(_) = args.approximation.cut()
        && !steps.any(|step| matches!(step, Step::Arc(_)))
    {
        return Err(Failure::request_with_hint(
            "the path has no arc, so that --joints has nothing to say",
            "leave it out: lines and Béziers keep their ends",
        ));
    }
    Ok(())
}

pub(super) fn run(args: &PathArgs) -> Outcome {
    let format = args.output.format()?;
    if args.approximation.extremes {
        return Err(Failure::request_with_hint(
            "--extremes is for a circle, an ellipse or an arc",
            "draw each shape by itself, or leave it out",
        ));
    }
    let elliptic = args.elliptic()?;
    let contours = match &args.power {
        Some(words) => contours_of_power(&input::coefficients(words)?)?,
        None => read(&input::path_data(
            args.source.as_deref().unwrap_or_default(),
        )?)?,
    };
    check_joints(args, &contours)?;
    let (precision, transform) = (args.output.rounding(format), args.output.transform());
    let mut drawing = match args.kind() {
        PathKind::Beziers(target) => {
            let options = Options {
                rule: args.rule()?,
                cut: args.approximation.cut(),
                precision,
                transform,
            };
            draw(&contours, target, &options)?
        }
        kind @ (PathKind::Lines | PathKind::Arcs) => {
            let options = arcs::Options {
                tolerance: args
                    .approximation
                    .only_tolerance("lines and circular arcs follow")?,
                precision,
                transform,
                elliptic,
                rounds_again: format == Format::Gcode,
            };
            match kind {
                PathKind::Arcs => arcs::arcs(&contours, &options)?,
                _ => arcs::lines(&contours, &options)?,
            }
        }
    };
    if args.open {
        for subpath in &mut drawing.subpaths {
            subpath.curve.closed = false;
            if let Some(course) = &mut subpath.course {
                course.closed = false;
            }
        }
    }
    let manner = args.output.options(format)?;
    write_drawn(&drawing, format, &manner, &args.output)?;
    Ok(ExitCode::SUCCESS)
}
