//! The distance of a curve from a conic, both ways.

use kurbo::{ParamCurve, PathSeg};

use super::Conic;
use super::frame::Frame;
use crate::curve::{control_points, largest_coordinate};
use crate::measure::radial::visit_between;
use crate::numeric::bernstein::Polynomial;
use crate::radial_error::RadialError;

/// How many points of a segment are set beside the conic where it bends too sharply for its normals.
const PAIRS: u32 = 512;

/// The largest distances of these segments from the conic, outside (towards its control point) and inside.
///
/// From the curve to the conic they are those along the normal, at the roots of their derivative. While they are smaller than the
/// conic's smallest radius of curvature, the nearest points cover the whole arc, and the other way is no farther. Else both sides
/// hold the largest distance of points on the same line through the control point, which bounds both ways.
pub(super) fn error(conic: &Conic, frame: &Frame, segments: &[PathSeg]) -> RadialError {
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
    if range.peak() * frame.largest_curvature() >= 0.5 {
        let apart = segments.iter().map(|segment| apart(frame, segment));
        range = range.with(RadialError::balanced(apart.fold(0.0, f64::max)));
    }
    // What rounding may hide.
    let hidden = 4.0 * f64::EPSILON * largest_coordinate(segments);
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

/// How far points of the segment lie at most from those of the conic on the same line through its control point: the largest of
/// many, and what may lie between two of them.
fn apart(frame: &Frame, segment: &PathSeg) -> f64 {
    let distance = |i: u32| {
        let p = segment.eval(f64::from(i) / f64::from(PAIRS));
        p.distance(frame.point(frame.opposite(p)))
    };
    let all: Vec<f64> = (0..=PAIRS).map(distance).collect();
    let largest = all.iter().copied().fold(0.0, f64::max);
    let steps = all.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    largest + steps.fold(0.0, f64::max)
}
