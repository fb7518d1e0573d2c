//! The distance of a curve from a conic, both ways, as bounds: docs/conics.md has the proof.

use kurbo::{Affine, ParamCurve, PathSeg};

use super::Conic;
use super::branch::Branch;
use super::frame::ConicFrame;
use super::halving::SLACK;
use super::{back, bound};
use crate::curve::largest_coordinate;
use crate::radial_error::RadialError;

/// How far the ends of a curve may lie from those of the arc, as a part of its chord, for the conic beyond these to stand for it.
const SHORT: f64 = 0.25;

/// The largest distances of these segments from the whole conic, outside (towards its control point) and inside.
///
/// While they are smaller than half of the arc's smallest radius of curvature, and the ends are moved by less than that, the nearest points
/// cover the arc between the ends, and the other way is no farther. Else both sides hold the larger distance of both ways.
pub(super) fn error(branch: &Branch, conic: &Conic, segments: &[PathSeg]) -> RadialError {
    let frame = branch.frame(conic);
    let range = bound::bound(branch, &frame, segments, None);
    let gap = gap(conic, segments);
    let is_short = gap <= SHORT * conic.from.distance(conic.to);
    if is_short && frame.is_covered(frame.ends(), range.peak().max(gap)) {
        return range;
    }
    RadialError::balanced(back::bound(
        branch,
        conic.weight,
        segments,
        range.peak(),
        None,
    ))
}

/// How far the curve's ends lie from the arc's.
fn gap(conic: &Conic, segments: &[PathSeg]) -> f64 {
    let (Some(first), Some(last)) = (segments.first(), segments.last()) else {
        return f64::INFINITY;
    };
    let start = first.start().distance(conic.from);
    start.max(last.end().distance(conic.to))
}

/// Whether that error of a piece of a conic between two parameters and of a segment is within a tolerance, which takes less time to know.
///
/// Where the whole conic is not covered the normals of other places may be nearer, so that it is no proof; but the drawing is measured again.
pub(super) fn is_within(
    branch: &Branch,
    frame: &ConicFrame,
    piece: &Conic,
    ends: [f64; 2],
    segment: PathSeg,
    tolerance: f64,
) -> bool {
    let segments = [segment];
    let hidden = 4.0 * f64::EPSILON * largest_coordinate([&segment]);
    let allowed = tolerance * (1.0 - 2.0 * SLACK) - hidden;
    if allowed.is_nan() || allowed <= 0.0 {
        return false;
    }
    let range = bound::bound(branch, frame, &segments, Some(allowed));
    if range.peak() > allowed || frame.is_covered(ends, allowed) {
        return range.peak() <= allowed;
    }
    let own = Branch::new(piece, Affine::IDENTITY);
    back::bound(&own, piece.weight, &segments, 0.0, Some(allowed)) <= allowed
}
