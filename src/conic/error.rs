//! The distance of a curve from a conic, both ways, as bounds: docs/conics.md has the proof.

use kurbo::{Affine, ParamCurve, PathSeg, Vec2};

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
/// While the inner one is smaller than the way from the arc along any normal to the axis, and the ends are moved by less than that, the nearest
/// points cover the arc between those of the ends, and the other way is no farther. Else both sides hold the larger distance of both ways.
pub(super) fn error(branch: &Branch, conic: &Conic, segments: &[PathSeg]) -> RadialError {
    let frame = branch.frame(conic);
    let range = bound::bound(branch, &frame, segments, None);
    if let Some(moved) = moved(conic, segments) {
        let gap = moved.map(Vec2::hypot).into_iter().fold(0.0, f64::max);
        let is_short = gap <= SHORT * conic.from.distance(conic.to);
        if is_short && frame.is_covered(frame.around(moved), range.inward.max(gap)) {
            return range;
        }
    }
    RadialError::balanced(back::bound(
        branch,
        conic.weight,
        segments,
        range.peak(),
        None,
    ))
}

/// The ways from the arc's ends to the curve's.
fn moved(conic: &Conic, segments: &[PathSeg]) -> Option<[Vec2; 2]> {
    let (first, last) = (segments.first()?, segments.last()?);
    Some([first.start() - conic.from, last.end() - conic.to])
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
