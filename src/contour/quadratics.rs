//! Cubics as quadratics.

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, QuadBez, Rect};

use crate::approximate::ROUNDING_SHARE;
use crate::error::{Error, Result, positive};
use crate::joints::{Cut, MOST_SEGMENTS, Tolerance};

/// How many quadratics a cubic becomes: the fewest of equal parameter length that stay, with the tenth that rounding may add,
/// within the tolerance, or within a thousandth of the larger side of its control points' box.
pub(super) fn count_of_quadratics(cubic: &CubicBez, cut: &Cut) -> Result<usize> {
    let tolerance = match *cut {
        Cut::Tolerance(Tolerance::Absolute(distance)) => positive("tolerance", distance)?,
        Cut::Tolerance(Tolerance::Relative(share)) => share * size(cubic) / 2.0,
        _ => size(cubic) / 1000.0,
    };
    let whole = (1.0 + ROUNDING_SHARE) * distance_of_quadratics(cubic, 1);
    if whole == 0.0 {
        return Ok(1);
    }
    // The distance falls with the third power of the count.
    let count = libm::cbrt(whole / tolerance).ceil().max(1.0);
    if count >= MOST_SEGMENTS as f64 {
        return Err(Error::TooManySegments {
            tolerance,
            most: MOST_SEGMENTS,
            enough: f64::INFINITY,
        });
    }
    // The rounding of the root may have cost one.
    let count = count as usize;
    let short = (1.0 + ROUNDING_SHARE) * distance_of_quadratics(cubic, count) > tolerance;
    Ok(count + usize::from(short))
}

/// The larger side of the box of the control points.
fn size(cubic: &CubicBez) -> f64 {
    let bounds = Rect::from_points(cubic.p0, cubic.p3)
        .union_pt(cubic.p1)
        .union_pt(cubic.p2);
    bounds.width().max(bounds.height())
}

/// A bound of how far quadratics lie from the parts of equal parameter length of the cubic in whose place they stand: that of their difference
/// at each parameter, a cubic, by its control points after it was cut into [`PARTS`].
pub(super) fn distance_from(cubic: &CubicBez, quadratics: &[PathSeg]) -> f64 {
    let count = quadratics.len() as f64;
    let parts = quadratics.iter().enumerate().map(|(i, quadratic)| {
        let piece = cubic.subsegment(i as f64 / count..(i + 1) as f64 / count);
        let raised = quadratic.to_cubic();
        let control = |p: Point, q: Point| (p - q).to_point();
        let difference = CubicBez::new(
            control(piece.p0, raised.p0),
            control(piece.p1, raised.p1),
            control(piece.p2, raised.p2),
            control(piece.p3, raised.p3),
        );
        let part = |k: u32| f64::from(k) / f64::from(PARTS);
        let hulls = (0..PARTS).map(|k| difference.subsegment(part(k)..part(k + 1)));
        let points = hulls.flat_map(|hull| [hull.p0, hull.p1, hull.p2, hull.p3]);
        points.map(|p| p.to_vec2().hypot2()).fold(0.0, f64::max)
    });
    parts.fold(0.0, f64::max).sqrt() * (1.0 + ROUNDING)
}

/// Cut into so many parts the control points of a cubic lie within about a hundredth of its size from it.
const PARTS: u32 = 16;

/// What rounding may take from a distance between points of about its size.
const ROUNDING: f64 = 1e-12;

/// A cubic cut into parts of equal parameter length, each of them as the quadratic that meets its ends and lies nearest to it in
/// the middle: P1 = (3(p1 + p2) - p0 - p3)/4.
pub(super) fn quadratics(cubic: &CubicBez, count: usize) -> impl Iterator<Item = QuadBez> {
    let mut last = cubic.p0;
    (0..count).map(move |i| {
        let part = |k: usize| k as f64 / count as f64;
        let piece = cubic.subsegment(part(i)..part(i + 1));
        let end = if i + 1 == count { cubic.p3 } else { piece.p3 };
        let [p0, p1, p2, p3] = [last, piece.p1, piece.p2, end].map(Point::to_vec2);
        last = end;
        let control = (3.0 * (p1 + p2) - p0 - p3) / 4.0;
        QuadBez::new(p0.to_point(), control.to_point(), end)
    })
}

/// How far those quadratics lie from the cubic at most: the difference is |p3 - 3p2 + 3p1 - p0|/n³ times t(1-t)|1-2t|/2, whose
/// largest value is sqrt(3)/36.
pub(super) fn distance_of_quadratics(cubic: &CubicBez, count: usize) -> f64 {
    let [p0, p1, p2, p3] = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(Point::to_vec2);
    let third = (p3 - 3.0 * p2 + 3.0 * p1 - p0).length();
    let count = count as f64;
    3.0_f64.sqrt() / 36.0 * third / (count * count * count)
}
