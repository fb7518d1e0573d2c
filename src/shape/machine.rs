//! Circular arcs as machines take them: two ends with the radius or the centre, as G2 and G3.

use kurbo::{Point, Vec2};

use super::endpoint::{SvgArc, full_circle, inscribed};
use super::{Given, Shape, finite_point};
use crate::angle::Angle;
use crate::error::{Error, Result, ShapeError, positive};

/// How far a radius may be off by the rounding of the program that wrote it, as a part of itself.
const RADIUS_SHARE: f64 = 1e-3;

/// What rounding to three decimals does to a distance, at most: programs for machines write no fewer.
const RADIUS_ROUNDING: f64 = 1.5e-3;

/// Whether a difference of radii is what rounding makes.
fn is_rounding(difference: f64, radius: f64) -> bool {
    difference.abs() <= (RADIUS_SHARE * radius).max(RADIUS_ROUNDING.min(radius / 10.0))
}

/// The circular arc between two points with this radius, as G2 and G3 with R: the shorter way or the longer, in the direction of
/// growing angles unless reversed. A radius that falls short of half the chord by no more than rounding explains makes it half a circle.
///
/// # Errors
///
/// Where a number is not finite, the radius is not positive or too small, or the points are the same.
pub fn from_radius(
    from: Point,
    to: Point,
    radius: f64,
    large_arc: bool,
    reverse: bool,
) -> Result<Shape> {
    let radius = positive("radius", radius)?;
    let (from, to) = (
        finite_point("start point", from)?,
        finite_point("end point", to)?,
    );
    if from == to {
        return Err(Error::Shape(ShapeError::SameEnds));
    }
    let half = (to - from).hypot() / 2.0;
    if half > radius && !is_rounding(half - radius, half) {
        let distance = 2.0 * half;
        return Err(Error::Shape(ShapeError::SmallRadius { radius, distance }));
    }
    SvgArc {
        from,
        radii: Vec2::new(radius, radius),
        rotation: Angle::ZERO,
        large_arc,
        sweep: !reverse,
        to,
    }
    .shape()
}

/// The circular arc between two points about a centre, as G2 and G3 with I and J, in the direction of growing angles unless
/// reversed; equal ends are a whole turn. The centre moves to the chord's bisector, so that both ends are met exactly.
///
/// # Errors
///
/// Where a number is not finite, the centre is one of the ends, or the radii at both ends differ by more than rounding explains:
/// 0.1 % of the radius, or 0.0015 where that is more.
pub fn about_center(from: Point, to: Point, center: Point, reverse: bool) -> Result<Shape> {
    let (from, to, center) = (
        finite_point("start point", from)?,
        finite_point("end point", to)?,
        finite_point("centre", center)?,
    );
    if from == to {
        return full_circle(from, center, reverse);
    }
    let (first, last) = ((from - center).hypot(), (to - center).hypot());
    positive("radius", first.min(last))?;
    if !is_rounding(first - last, first.min(last)) {
        return Err(Error::Shape(ShapeError::Centre { first, last }));
    }
    inscribed([from, to], Given::Center(center), !reverse)
}
