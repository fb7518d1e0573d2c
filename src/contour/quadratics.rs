//! Cubics as quadratics.

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, QuadBez, Rect};

use super::{Contour, Step};
use crate::approximate::{self, ROUNDING_SHARE};
use crate::curve::check_size;
use crate::error::{Error, Result};
use crate::joints::{Cut, MOST_SEGMENTS};
use crate::number::rounded_up;

/// How many quadratics a cubic becomes: the fewest of equal parameter length that stay, with the tenth that rounding may add,
/// within the tolerance, or within a thousandth of half the larger side of its control points' box.
pub(super) fn count_of_quadratics(cubic: &CubicBez, cut: &Cut) -> Result<usize> {
    count_within(cubic, tolerance(cubic, cut)?)
}

fn tolerance(cubic: &CubicBez, cut: &Cut) -> Result<f64> {
    let size = size(cubic) / 2.0;
    match *cut {
        // A dot has no size that a part could be of; nothing of it strays.
        Cut::Tolerance(tolerance) => tolerance.checked(if size > 0.0 { size } else { 1.0 }),
        _ => Ok(size / 1000.0),
    }
}

/// Refuses contours whose cubics under a map become more quadratics together than this many, with a tolerance by which they do not, and
/// those that are too small; tells how many they become.
pub(super) fn check_contours(
    contours: &[Contour],
    options: &approximate::Options,
    most: usize,
) -> Result<usize> {
    let steps = contours.iter().flat_map(|contour| &contour.steps);
    let given = steps.filter_map(|step| match step {
        Step::Given(segment) => Some(options.transform * *segment),
        Step::Arc(_) => None,
    });
    let cubics = given.clone().filter_map(|segment| match segment {
        PathSeg::Cubic(cubic) => Some(cubic),
        _ => None,
    });
    if cubics.clone().next().is_some() {
        check_size(given)?;
    }
    check_count(&cubics, &options.cut, most)
}

fn check_count(
    cubics: &(impl Iterator<Item = CubicBez> + Clone),
    cut: &Cut,
    most: usize,
) -> Result<usize> {
    let (mut total, mut finest) = (0_usize, f64::INFINITY);
    for cubic in cubics.clone() {
        let tolerance = tolerance(&cubic, cut)?;
        finest = finest.min(tolerance);
        total = total.saturating_add(count_within(&cubic, tolerance).unwrap_or(usize::MAX));
    }
    if total <= most {
        return Ok(total);
    }
    Err(Error::TooManySegments {
        tolerance: finest,
        most,
        enough: enough(cubics, finest, most),
    })
}

/// A tolerance of one digit by which all become few enough; infinite where each of them is too many already.
fn enough(cubics: &(impl Iterator<Item = CubicBez> + Clone), beyond: f64, most: usize) -> f64 {
    let serves = |tolerance: f64| {
        let counts = cubics.clone().map(|cubic| count_within(&cubic, tolerance));
        let total = counts.fold(0_usize, |sum, count| {
            sum.saturating_add(count.unwrap_or(usize::MAX))
        });
        total <= most
    };
    let farthest = cubics
        .clone()
        .map(|cubic| distance_of_quadratics(&cubic, 1));
    let (mut low, mut high) = (beyond, 2.0 * farthest.fold(beyond, f64::max));
    if !serves(high) {
        return f64::INFINITY;
    }
    while high > 1.1 * low {
        // The product may be too small.
        let middle = low.sqrt() * high.sqrt();
        if serves(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    rounded_up(high, 1)
}

fn count_within(cubic: &CubicBez, tolerance: f64) -> Result<usize> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joints::Tolerance;

    #[test]
    fn a_tolerance_that_is_named_serves() {
        let cubics: Vec<CubicBez> = (0..2000)
            .map(|i| {
                let size = 1.0 + f64::from(i % 17);
                CubicBez::new((0.0, 0.0), (size, 3.0 * size), (-size, 7.0), (9.0, size))
            })
            .collect();
        let count = |cubics: &[CubicBez], cut: &Cut| {
            check_count(&cubics.iter().copied(), cut, MOST_SEGMENTS)
        };
        let absolute = |tolerance| Cut::Tolerance(Tolerance::Absolute(tolerance));
        for cut in [
            absolute(1e-9),
            absolute(1e-12),
            Cut::Tolerance(Tolerance::Relative(1e-10)),
        ] {
            let Err(Error::TooManySegments { enough, .. }) = count(&cubics, &cut) else {
                panic!("{cut:?} is not refused");
            };
            assert!(count(&cubics, &absolute(enough)).is_ok(), "{cut:?}");
            assert!(count(&cubics, &absolute(0.4 * enough)).is_err());
        }
        // One quadratic each is too many already.
        let many =
            vec![CubicBez::new((0.0, 0.0), (1.0, 2.0), (3.0, 5.0), (4.0, 0.0)); MOST_SEGMENTS + 1];
        let refused = count(&many, &absolute(1.0));
        assert!(matches!(
            refused,
            Err(Error::TooManySegments { enough, .. }) if enough.is_infinite()
        ));
    }
}
