//! `path`.

use std::ffi::OsStr;
use std::process::ExitCode;

use curveto::approximate::Options;
use curveto::arcs;
use curveto::contour::{Contour, PathDrawing, Step, Subpath, draw};
use curveto::joints::MOST_IN_ALL;
use curveto::path::{contours, contours_of_power};
use curveto::write::Format;
use curveto::{Cut, Error};
use kurbo::Affine;

use super::args::{PathArgs, PathKind, QuietArgs};
use super::failure::Failure;
use super::output::write_drawn;
use super::{Outcome, input};

/// Contours and the map that is to be applied to them.
type PlacedContours = (Vec<Contour>, Affine);

/// What is drawn by path data or by the shapes of an SVG file; says what reads other files.
fn read(source: &OsStr, notes: QuietArgs) -> Result<Vec<PlacedContours>, Failure> {
    let (bytes, name) = input::drawing(source)?;
    if input::is_svg(&bytes) {
        let parts = together(input::shapes(&bytes, &name, notes)?);
        if parts.is_empty() {
            let why = "has no path and no shape that is drawn";
            return Err(Failure::request(format!("{name} {why}")));
        }
        return Ok(parts);
    }
    let data = input::in_utf8(bytes, &name)?;
    let contours = contours(&data).map_err(|error| {
        let failure = input::named(&name, error);
        if data.trim_start().starts_with('%') {
            failure.with_hint("'curveto diff' reads PostScript drawings")
        } else {
            failure
        }
    });
    Ok(vec![(contours?, Affine::IDENTITY)])
}

/// Shapes that follow one another with the same map as one part, whose points are rounded alike.
fn together(shapes: Vec<PlacedContours>) -> Vec<PlacedContours> {
    let mut parts: Vec<PlacedContours> = Vec::new();
    for (contours, map) in shapes {
        match parts.last_mut() {
            Some((last, own)) if *own == map => last.extend(contours),
            _ => parts.push((contours, map)),
        }
    }
    parts
}

/// Refuses joints where there is no arc that could have them.
fn check_joints(args: &PathArgs, parts: &[PlacedContours]) -> Result<(), Failure> {
    let contours = parts.iter().flat_map(|(contours, _)| contours);
    let mut steps = contours.flat_map(|contour| &contour.steps);
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

/// All parts as what they are to become; `None` where there are none.
fn joined(
    args: &PathArgs,
    format: Format,
    parts: &[PlacedContours],
) -> Result<Option<PathDrawing>, Failure> {
    let mut whole: Option<PathDrawing> = None;
    let (mut count, mut given) = (0, 0);
    for part in parts {
        let drawing = drawn(args, format, part)?;
        count += drawing.subpaths.iter().map(Subpath::count).sum::<usize>();
        given += part
            .0
            .iter()
            .map(|contour| contour.steps.len())
            .sum::<usize>();
        if count > MOST_IN_ALL.max(given) {
            let most = MOST_IN_ALL;
            return Err(Error::Count { count, most }.into());
        }
        match &mut whole {
            Some(whole) => whole.subpaths.extend(drawing.subpaths),
            None => whole = Some(drawing),
        }
    }
    Ok(whole)
}

pub(super) fn run(args: &PathArgs) -> Outcome {
    let format = args.output.format()?;
    if args.approximation.extremes {
        return Err(Failure::request_with_hint(
            "--extremes is for a circle, an ellipse or an arc",
            "draw each shape by itself, or leave it out",
        ));
    }
    let parts = match (&args.power, &args.source) {
        (Some(words), _) => {
            let contours = contours_of_power(&input::coefficients(words)?)?;
            vec![(contours, Affine::IDENTITY)]
        }
        (None, source) => read(
            source.as_deref().unwrap_or_default(),
            args.output.talk.notes,
        )?,
    };
    check_joints(args, &parts)?;
    let Some(mut drawing) = joined(args, format, &parts)? else {
        return Ok(ExitCode::SUCCESS);
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

/// A part as what it is to become.
fn drawn(
    args: &PathArgs,
    format: Format,
    (contours, map): &PlacedContours,
) -> Result<PathDrawing, Failure> {
    let elliptic = args.elliptic()?;
    let precision = args.output.rounding(format);
    let transform = args.output.transform() * *map;
    let target = match args.kind() {
        PathKind::Beziers(target) => target,
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
            return Ok(match kind {
                PathKind::Arcs => arcs::arcs(contours, &options)?,
                _ => arcs::lines(contours, &options)?,
            });
        }
    };
    let options = Options {
        rule: args.rule()?,
        cut: args.approximation.cut(),
        precision,
        transform,
    };
    Ok(draw(contours, target, &options)?)
}
