//! The distance of a curve from a conic, both ways.

use kurbo::{ParamCurve, PathSeg};

use super::Conic;
use super::frame::Frame;
use crate::curve::{control_points, largest_coordinate};
use crate::measure::hausdorff::{are_within, hausdorff};
use crate::measure::radial::visit_between;
use crate::method::Method;
use crate::numeric::bernstein::Polynomial;
use crate::radial_error::RadialError;

/// The most cubics that stand for a conic which bends too sharply for its normals.
const MOST_CUBICS: usize = 1 << 12;

/// How far these may stray, as a part of a distance that is stated and of a tolerance that decides, and how far the bound may lie above
/// such a distance besides, but in hard cases.
const NEAR: f64 = 1e-6;
const NEAR_ENOUGH: f64 = 1e-4;
const GOAL: f64 = 1e-5;

/// The largest distances of these segments from the conic between two parameters, outside (towards its control point) and inside.
///
/// From the curve to the conic they are those along the normal, at the roots of their derivative. While they are smaller than the
/// conic's smallest radius of curvature, the nearest points cover the whole arc, and the other way is no farther. Else both sides
/// hold the larger distance of both ways.
pub(super) fn error(
    conic: &Conic,
    frame: &Frame,
    ends: [f64; 2],
    segments: &[PathSeg],
) -> RadialError {
    let mut range = along_normals(conic, frame, segments);
    let hidden = hidden(segments);
    if !frame.is_covered(range.peak()) {
        let apart = both_ways(conic, frame, ends, segments);
        range = RadialError::balanced(apart.unwrap_or(f64::INFINITY));
    }
    let seen = |distance: f64| {
        if distance > 0.0 {
            distance + hidden
        } else {
            0.0
        }
    };
    RadialError {
        outward: seen(range.outward),
        inward: seen(range.inward),
    }
}

/// Whether that error is within a tolerance, which takes less time to know.
pub(super) fn is_within(
    conic: &Conic,
    frame: &Frame,
    ends: [f64; 2],
    segments: &[PathSeg],
    tolerance: f64,
) -> bool {
    let peak = along_normals(conic, frame, segments).peak();
    let allowed = tolerance - hidden(segments);
    if frame.is_covered(peak) {
        return peak <= allowed;
    }
    cubics(conic, frame, ends, NEAR_ENOUGH * tolerance)
        .is_some_and(|fine| are_within([segments, &fine], allowed - NEAR_ENOUGH * tolerance))
}

/// What rounding may hide of a distance.
fn hidden(segments: &[PathSeg]) -> f64 {
    4.0 * f64::EPSILON * largest_coordinate(segments)
}

/// The extremes of the distance along the normals.
fn along_normals(conic: &Conic, frame: &Frame, segments: &[PathSeg]) -> RadialError {
    let mut range = RadialError::default();
    for segment in segments {
        let crossings = crossings(conic, segment);
        visit_between(
            segment,
            &crossings,
            |t| frame.foot(segment.eval(t)),
            |_, distance| {
                range.take_in_all([distance]);
            },
        );
    }
    range
}

/// The distance both ways, by cubics in place of the conic: what these stray is hardly a part of it, or of the digits of coordinates.
fn both_ways(conic: &Conic, frame: &Frame, ends: [f64; 2], segments: &[PathSeg]) -> Option<f64> {
    let least = 32.0 * f64::EPSILON * conic.size();
    let mut strayed = conic.size();
    loop {
        let fine = cubics(conic, frame, ends, strayed)?;
        let apart = hausdorff([segments, &fine], f64::NAN, GOAL).at_most;
        if strayed <= least.max(NEAR * apart) {
            return Some(apart + strayed);
        }
        strayed = least.max(0.5 * NEAR * apart);
    }
}

/// Cubics of equal parameter that stray from the conic by no more than that, both ways; `None` where it takes too many.
///
/// All of them have the same coordinates (a, b, c) over their ends and the meeting point of their tangents. On a line through that point the
/// conic lies s = 1/(a + c + 2w sqrt(ac)) times as far from it as the cubic, so that they are apart by |1 - s| of the longer of the two
/// tangents at most, and each of the conic's points lies on such a line.
fn cubics(
    conic: &Conic,
    frame: &Frame,
    [from, to]: [f64; 2],
    strayed: f64,
) -> Option<Vec<PathSeg>> {
    /// How many places are looked at, between which |1 - s| may be so many times as large.
    const LOOKS: u32 = 64;
    const MARGIN: f64 = 1.1;
    let joints =
        |count: usize| (0..=count).map(move |i| from + (to - from) * (i as f64 / count as f64));
    let counts = (2..)
        .map(|exponent| 1 << exponent)
        .take_while(|&count| count <= MOST_CUBICS);
    for count in counts {
        let (weight, reach) = frame.piece((to - from) / count as f64);
        let handle = Method::Midpoint.conic_handle(weight).ok()?;
        let apart = (1..LOOKS).map(|i| {
            let t = f64::from(i) / f64::from(LOOKS);
            let part = |t: f64| (1.0 - t) * (1.0 - t) * (1.0 - t + 3.0 * t * (1.0 - handle));
            let (a, c) = (part(t), part(1.0 - t));
            (1.0 - 1.0 / (a + c + 2.0 * weight * (a * c).sqrt())).abs()
        });
        let apart = apart.fold(0.0, f64::max);
        let tangents = joints(count).map(|x| reach * frame.derivative(x).hypot());
        if MARGIN * apart * tangents.fold(0.0, f64::max) <= strayed {
            let joints: Vec<f64> = joints(count).collect();
            return conic.pieces(&joints, Some(Method::Midpoint)).ok();
        }
    }
    None
}

/// Where a segment crosses the conic: the roots of b² - 4w²ac.
fn crossings(conic: &Conic, segment: &PathSeg) -> Vec<f64> {
    let (u, v) = (conic.from - conic.control, conic.to - conic.control);
    let area = u.cross(v);
    let points: Vec<_> = control_points(segment)
        .into_iter()
        .map(|p| p - conic.control)
        .collect();
    let axis = |of: &dyn Fn(kurbo::Vec2) -> f64| {
        Polynomial::new(&points.iter().map(|&p| of(p)).collect::<Vec<f64>>())
    };
    let a = axis(&|p| p.cross(v) / area);
    let c = axis(&|p| u.cross(p) / area);
    let b = axis(&|p| 1.0 - (p.cross(v) + u.cross(p)) / area);
    let product = a.times(&c).scaled(4.0 * conic.weight * conic.weight);
    b.times(&b).minus(&product).sign_changes().iter().collect()
}
