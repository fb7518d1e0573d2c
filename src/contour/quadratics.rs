//! Cubics as quadratics.

mod distance;

use kurbo::{Affine, CubicBez, ParamCurve as _, PathSeg, Point, QuadBez, Rect, Vec2};

use super::{Contour, Step};
use crate::approximate::{self, ROUNDING_SHARE};
use crate::curve::check_size;
use crate::error::{Error, Result};
use crate::joints::{Cut, MOST_IN_ALL, MOST_SEGMENTS};
use crate::number::rounded_up;
pub(super) use distance::Replaced;

/// How far quadratics may lie from a cubic: asked for, or a thousandth of half the larger side of its control points' box.
pub(super) fn tolerance(cubic: &CubicBez, cut: &Cut) -> Result<f64> {
    let size = size(cubic) / 2.0;
    match *cut {
        // A dot has no size that a part could be of; nothing of it strays.
        Cut::Tolerance(tolerance) => tolerance.checked(if size > 0.0 { size } else { 1.0 }),
        _ => Ok(size / 1000.0),
    }
}

/// The cubics among the steps of a contour under a map.
fn cubics(contour: &Contour, map: Affine) -> impl Iterator<Item = Option<CubicBez>> + Clone {
    contour.steps.iter().map(move |step| match step {
        Step::Given(PathSeg::Cubic(cubic)) => Some(map * *cubic),
        _ => None,
    })
}

/// How many quadratics each step of contours becomes under a map, 0 for what is no cubic.
///
/// Refuses contours whose cubics become more quadratics than a curve may have, or five times as many in all, with a tolerance by which they
/// do not, and those that are too small.
pub(super) fn counts(
    contours: &[Contour],
    options: &approximate::Options,
) -> Result<Vec<Vec<u32>>> {
    let cubics = |contour| cubics(contour, options.transform);
    let (mut all, mut total) = (Vec::with_capacity(contours.len()), 0);
    for contour in contours {
        if cubics(contour).flatten().next().is_some() {
            let given = contour.steps.iter().filter_map(|step| match step {
                Step::Given(segment) => Some(options.transform * *segment),
                Step::Arc(_) => None,
            });
            check_size(given)?;
        }
        let (counts, count) = counted(&cubics(contour), &options.cut, MOST_SEGMENTS)?;
        all.push(counts);
        total += count;
    }
    let given: usize = contours.iter().map(|contour| contour.steps.len()).sum();
    let most = MOST_IN_ALL.max(given);
    if total > most {
        return Err(refusal(
            &contours.iter().flat_map(cubics),
            &options.cut,
            most,
        )?);
    }
    Ok(all)
}

/// How many each becomes, and how many all do.
fn counted(
    cubics: &(impl Iterator<Item = Option<CubicBez>> + Clone),
    cut: &Cut,
    most: usize,
) -> Result<(Vec<u32>, usize)> {
    let (mut counts, mut total) = (Vec::new(), 0);
    for cubic in cubics.clone() {
        let count = match &cubic {
            Some(cubic) => count_within(cubic, tolerance(cubic, cut)?),
            None => Some(0),
        };
        total += count.unwrap_or(most + 1);
        if total > most {
            return Err(refusal(cubics, cut, most)?);
        }
        counts.push(count.unwrap_or_default() as u32);
    }
    Ok((counts, total))
}

/// Why cubics become more quadratics together than so many.
fn refusal(
    cubics: &(impl Iterator<Item = Option<CubicBez>> + Clone),
    cut: &Cut,
    most: usize,
) -> Result<Error> {
    let cubics = cubics.clone().flatten();
    let tolerances = cubics.clone().map(|cubic| tolerance(&cubic, cut));
    let finest = tolerances.reduce(|a, b| Ok(a?.min(b?))).transpose()?;
    let tolerance = finest.unwrap_or(f64::INFINITY);
    Ok(Error::TooManySegments {
        tolerance,
        most,
        enough: enough(&cubics, tolerance, most),
    })
}

/// A tolerance of one digit by which all become few enough; infinite where each of them is too many already.
fn enough(cubics: &(impl Iterator<Item = CubicBez> + Clone), beyond: f64, most: usize) -> f64 {
    let serves = |tolerance: f64| {
        let counts = cubics
            .clone()
            .map(|cubic| count_by_parameter(&cubic, tolerance));
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

/// The fewest of equal parameter length that stay, with the tenth that rounding may add, within a tolerance; beyond [`MOST_TRIED`] a count that
/// does of which one fewer does not. `None` beyond what a curve may have.
fn count_within(cubic: &CubicBez, tolerance: f64) -> Option<usize> {
    let surely = count_by_parameter(cubic, tolerance)?;
    let limit = room(tolerance);
    let serves = |count: usize| {
        count >= surely || {
            let quadratics: Vec<PathSeg> = quadratics(cubic, count).map(PathSeg::Quad).collect();
            let quadratics = &quadratics;
            Replaced { cubic, quadratics }.is_within(limit)
        }
    };
    if surely <= MOST_TRIED {
        return (1..=surely).find(|&count| serves(count));
    }
    if surely > MOST_MEASURED {
        return Some(surely);
    }
    // The distance falls with the third power of the count.
    let across = distance::across(cubic, MOST_TRIED)[0] * distance_of_third(1.0, 1);
    let guess = (libm::cbrt(across / limit).ceil() as usize).clamp(1, surely);
    if serves(guess) {
        let fewer = (1..guess).rev().take_while(|&count| serves(count)).last();
        return Some(fewer.unwrap_or(guess));
    }
    (guess + 1..=surely).find(|&count| serves(count))
}

/// What the tenth that rounding may add leaves of a tolerance.
pub(super) fn room(tolerance: f64) -> f64 {
    tolerance / (1.0 + ROUNDING_SHARE)
}

/// The most of which all fewer are tried.
const MOST_TRIED: usize = 8;

/// The most that are measured to find fewer of them.
const MOST_MEASURED: usize = 32;

/// The fewest of which no point is farther than a tolerance, with that tenth, from that of the same parameter.
fn count_by_parameter(cubic: &CubicBez, tolerance: f64) -> Option<usize> {
    let whole = (1.0 + ROUNDING_SHARE) * distance_of_quadratics(cubic, 1);
    if whole == 0.0 {
        return Some(1);
    }
    // The distance falls with the third power of the count.
    let count = libm::cbrt(whole / tolerance).ceil().max(1.0);
    if count >= MOST_SEGMENTS as f64 {
        return None;
    }
    // The rounding of the root may have cost one.
    let count = count as usize;
    let short = (1.0 + ROUNDING_SHARE) * distance_of_quadratics(cubic, count) > tolerance;
    Some(count + usize::from(short))
}

/// The larger side of the box of the control points.
fn size(cubic: &CubicBez) -> f64 {
    let bounds = hull(cubic);
    bounds.width().max(bounds.height())
}

/// The box of the control points.
fn hull(cubic: &CubicBez) -> Rect {
    Rect::from_points(cubic.p0, cubic.p3)
        .union_pt(cubic.p1)
        .union_pt(cubic.p2)
}

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

/// How far those quadratics lie from the points of the cubic of the same parameter.
pub(super) fn distance_of_quadratics(cubic: &CubicBez, count: usize) -> f64 {
    distance_of_third(third_difference(cubic).length(), count)
}

/// The difference is |p3 - 3p2 + 3p1 - p0|/n³ times t(1-t)|1-2t|/2, whose largest value is sqrt(3)/36.
fn distance_of_third(length: f64, count: usize) -> f64 {
    let count = count as f64;
    3.0_f64.sqrt() / 36.0 * length / (count * count * count)
}

fn third_difference(cubic: &CubicBez) -> Vec2 {
    let [p0, p1, p2, p3] = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(Point::to_vec2);
    p3 - 3.0 * p2 + 3.0 * p1 - p0
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
            counted(&cubics.iter().copied().map(Some), cut, MOST_SEGMENTS)
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
