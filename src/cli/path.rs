//! `path`.

use std::ffi::OsStr;
use std::process::ExitCode;

use curveto::approximate::Options;
use curveto::arcs;
use curveto::contour::{BezierTarget, Contour, PathDrawing, Step, Subpath, draw};
use curveto::joints::MOST_IN_ALL;
use curveto::path::contours_of_power;
use curveto::write::Format;
use curveto::{Cut, Error};
use kurbo::Affine;

use super::Outcome;
use super::args::{PathArgs, PathKind, QuietArgs};
use super::failure::Failure;
use super::input::{self, InputKind, SvgShape};
use super::output::write_drawn;

/// Contours with one map, which are drawn together.
struct PathPart {
    contours: Vec<Contour>,
    map: Affine,
    /// What messages call each shape of a file and how many of the contours are its own.
    shapes: Vec<(String, usize)>,
}

impl PathPart {
    /// Contours that stand alone.
    fn alone(contours: Vec<Contour>) -> Self {
        Self {
            contours,
            map: Affine::IDENTITY,
            shapes: Vec::new(),
        }
    }

    /// The part as what it is to become; a failure names the shape, where it is of one.
    fn drawn(&self, args: &PathArgs, format: Format) -> Result<PathDrawing, Failure> {
        let target = PathTarget::new(args, format, self.map)?;
        let error = match target.draw(&self.contours) {
            Err(error) if !matches!(error, Error::Count { .. } | Error::NotPositive { .. }) => {
                error
            }
            drawn => return Ok(drawn?),
        };
        let mut rest = self.contours.as_slice();
        for (place, count) in &self.shapes {
            let (contours, others) = rest.split_at(*count);
            if let Err(error) = target.draw(contours) {
                return Err(input::named(place, error));
            }
            rest = others;
        }
        Err(error.into())
    }
}

/// What is drawn by path data or by the shapes of an SVG file; says what reads other files.
fn read(source: &OsStr, notes: QuietArgs) -> Result<Vec<PathPart>, Failure> {
    let (bytes, name) = input::drawing(source)?;
    if InputKind::of(source, &bytes) == InputKind::Svg {
        let parts = together(input::shapes(&bytes, &name, notes)?);
        if parts.is_empty() {
            let why = "has no path and no shape that is drawn";
            return Err(Failure::request(format!("{name} {why}")));
        }
        return Ok(parts);
    }
    Ok(vec![PathPart::alone(input::contours(
        source, bytes, &name, None,
    )?)])
}

/// Shapes that follow one another with the same map as one part, whose points are rounded alike.
fn together(shapes: Vec<SvgShape>) -> Vec<PathPart> {
    let mut parts: Vec<PathPart> = Vec::new();
    for shape in shapes {
        let named = (shape.place, shape.contours.len());
        match parts.last_mut() {
            Some(last) if last.map == shape.map => {
                last.contours.extend(shape.contours);
                last.shapes.push(named);
            }
            _ => parts.push(PathPart {
                contours: shape.contours,
                map: shape.map,
                shapes: vec![named],
            }),
        }
    }
    parts
}

/// Refuses joints where there is no arc that could have them.
fn check_joints(args: &PathArgs, parts: &[PathPart]) -> Result<(), Failure> {
    let contours = parts.iter().flat_map(|part| &part.contours);
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
    parts: &[PathPart],
) -> Result<Option<PathDrawing>, Failure> {
    let mut whole: Option<PathDrawing> = None;
    let (mut count, mut given) = (0, 0);
    for part in parts {
        let drawing = part.drawn(args, format)?;
        count += drawing.subpaths.iter().map(Subpath::count).sum::<usize>();
        given += part
            .contours
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
            vec![PathPart::alone(contours)]
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

/// What contours are to become, and how.
enum PathTarget {
    Beziers(BezierTarget, Options),
    Lines(arcs::Options),
    Arcs(arcs::Options),
}

impl PathTarget {
    /// What was asked for contours with this map.
    fn new(args: &PathArgs, format: Format, map: Affine) -> Result<Self, Failure> {
        let elliptic = args.elliptic()?;
        let precision = args.output.rounding(format);
        let transform = args.output.transform() * map;
        let of_arcs = || {
            Ok::<_, Failure>(arcs::Options {
                tolerance: args
                    .approximation
                    .only_tolerance("lines and circular arcs follow")?,
                precision,
                transform,
                elliptic,
                rounds_again: format == Format::Gcode,
            })
        };
        Ok(match args.kind() {
            PathKind::Lines => Self::Lines(of_arcs()?),
            PathKind::Arcs => Self::Arcs(of_arcs()?),
            PathKind::Beziers(target) => {
                let options = Options {
                    rule: args.rule()?,
                    cut: args.approximation.cut(),
                    precision,
                    transform,
                };
                Self::Beziers(target, options)
            }
        })
    }

    fn draw(&self, contours: &[Contour]) -> curveto::Result<PathDrawing> {
        match self {
            Self::Beziers(target, options) => draw(contours, *target, options),
            Self::Lines(options) => arcs::lines(contours, options),
            Self::Arcs(options) => arcs::arcs(contours, options),
        }
    }
}
