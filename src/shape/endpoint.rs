//! Arcs given by their end points: the SVG form (SVG 2, appendix B.2, whose equation numbers are cited), three points, the DXF bulge.

use kurbo::{Point, Vec2};

use super::frame::{circle_between, cotangent_between, products_about};
use super::svg_arc::FLAT;
pub use super::svg_arc::SvgArc;
pub(crate) use super::svg_arc::{Chord, Half};
use super::{Arc, Given, Line, Shape, finite_point};
use crate::angle::Angle;
use crate::error::{Error, Result, ShapeError, finite, positive};
use crate::numeric::double::Double;
use crate::path_data::grammar::after_space;
use crate::path_data::{PathFault, Segments};

/// The arc of path data `M x y A rx ry rotation large sweep x y`, in any form that the grammar of SVG allows.
///
/// # Errors
///
/// [`Error::Syntax`] with the column where it does not parse, and where it is not one moveto and one arc.
pub fn parse_svg_arc(text: &str) -> Result<SvgArc> {
    const MOVETO: &str = "a moveto 'M x y'";
    const ARC: &str = "an arc 'A rx ry rotation large sweep x y'";
    let wrong = |at: usize, why: &str| Error::Syntax {
        what: "the SVG arc",
        text: text.to_owned(),
        column: text[..at].chars().count() + 1,
        why: why.to_owned(),
    };
    let mut segments = Segments::new(text, 0..text.len());
    let mut next = |expected: &str| {
        let segment = segments.next();
        let too_large = segment.and_then(|segment| PathFault::too_large(text, &segment));
        match too_large.or_else(|| segments.fault()) {
            None => Ok(segment),
            Some(PathFault::Ends) => {
                let why = format!("it ends where {expected} should go on");
                Err(wrong(text.len(), &why))
            }
            Some(PathFault::Comma(at) | PathFault::Unexpected(at) | PathFault::TooLarge(at)) => {
                Err(wrong(at, &format!("expected {expected}")))
            }
        }
    };
    let after = |end: usize| after_space(text.as_bytes(), end);
    let Some(moveto) = next(MOVETO)? else {
        return Err(wrong(after(0), &format!("expected {MOVETO}")));
    };
    let [x, y] = moveto.values(text);
    let second = next(ARC)?;
    let arc = second.and_then(|arc| SvgArc::of_segment(Point::new(x, y), &arc, text));
    let arc = arc.ok_or_else(|| {
        let at = second.map_or(after(moveto.end), |segment| segment.start);
        wrong(
            at,
            "expected one arc 'A rx ry rotation large sweep x y' after the moveto",
        )
    })?;
    match next("the end")? {
        None => Ok(arc),
        Some(third) => Err(wrong(third.start, "expected one arc and nothing after it")),
    }
}

/// The arc from `from` through `on` to `to`; a line where the three lie on one, in that order; the whole circle on the diameter
/// from `from` to `on` where the ends are the same.
///
/// # Errors
///
/// Where `on` is one of the ends, and where they lie on a line with `on` outside.
pub fn through(from: Point, on: Point, to: Point) -> Result<Shape> {
    for p in [from, on, to] {
        finite_point("point", p)?;
    }
    if from == to && from != on {
        return full_circle(from, from.midpoint(on), false);
    }
    if from == on || on == to {
        let all = from == on && on == to;
        return Err(Error::Shape(ShapeError::SamePoints { all }));
    }
    let (u, v) = (from - on, to - on);
    let point = |p: Point| [p.x, p.y].map(Double::of);
    let products = products_about(point(on), [from, to].map(point));
    let [cross, dot] = products.map(Double::value);
    // What rounding alone can make of the cross product of points on a line.
    let largest = [from, on, to]
        .iter()
        .flat_map(|p| [p.x.abs(), p.y.abs()])
        .fold(0.0, f64::max);
    if cross.abs() <= 4.0 * f64::EPSILON * largest * (u.hypot() + v.hypot()) {
        if dot > 0.0 {
            return Err(Error::Shape(ShapeError::PointsOnLine));
        }
        return Ok(Shape::Line(Line { from, to }));
    }
    inscribed([from, to], Given::Through(on), cross < 0.0)
}

/// The circular arc between two ends that something else gives, in the direction of growing angles or against it.
pub(super) fn inscribed(ends: [Point; 2], given: Given, forth: bool) -> Result<Shape> {
    let [from, to] = ends;
    let line = Ok(Shape::Line(Line { from, to }));
    let Some(cotangent) = cotangent_between(ends, given, Double::of) else {
        return line;
    };
    // The cotangent of half the sweep, which is that of no more than half a turn where it is positive.
    let along = if forth { 1.0 } else { -1.0 } * cotangent.value();
    if along * FLAT >= 1.0 || along.is_nan() {
        return line;
    }
    let (center, radius) = circle_between(ends, cotangent);
    let center = finite_point("centre", center)?;
    let (start, size) = (from - center, cotangent.value());
    let sweep = match given {
        Given::Bulge(bulge) => 4.0 * libm::atan(bulge),
        // Half the sweep lies within half a turn.
        _ if forth => 2.0 * libm::atan2(1.0, size),
        _ => -2.0 * libm::atan2(1.0, -size),
    };
    Ok(Shape::Arc(Arc {
        center,
        radii: Vec2::new(positive("radius", radius)?, radius),
        rotation: Angle::ZERO,
        start: Angle::from_radians(libm::atan2(start.y, start.x)),
        sweep: Angle::from_radians(sweep),
        ends: Some(ends),
        given,
    }))
}

/// The arc from `from` to `to` with the DXF bulge tan(sweep/4), positive in the direction of growing angles; a line where it is 0.
///
/// # Errors
///
/// Where a number is not finite or too large.
pub fn from_bulge(from: Point, to: Point, bulge: f64) -> Result<Shape> {
    let (from, to) = (
        finite_point("start point", from)?,
        finite_point("end point", to)?,
    );
    finite("bulge", bulge)?;
    if from == to {
        return Ok(Shape::Empty);
    }
    if bulge == 0.0 {
        return Ok(Shape::Line(Line { from, to }));
    }
    inscribed([from, to], Given::Bulge(bulge), bulge > 0.0)
}

/// The whole circle from a point of it.
pub(super) fn full_circle(from: Point, center: Point, reverse: bool) -> Result<Shape> {
    let out = from - center;
    let radius = positive("radius", out.hypot())?;
    Ok(Shape::Arc(Arc {
        center,
        radii: Vec2::new(radius, radius),
        rotation: Angle::ZERO,
        start: Angle::from_radians(libm::atan2(out.y, out.x)),
        sweep: Angle::from_degrees(if reverse { -360.0 } else { 360.0 }),
        ends: Some([from, from]),
        given: Given::Sweep,
    }))
}
