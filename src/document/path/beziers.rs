//! Bézier segments in a buffer that serves one arc after the other.

use kurbo::{PathSeg, Point};

use crate::curve::{map_points, points_of};

/// The segments of a curve, counted from a point of its own, and the decimals for its control points.
#[derive(Debug, Clone, Default)]
pub(in crate::document) struct Beziers {
    pub(in crate::document) segments: Vec<PathSeg>,
    pub(in crate::document) decimals: u32,
}

impl Beziers {
    /// Whether the segments are quadratics.
    pub(in crate::document) fn is_quadratic(&self) -> bool {
        matches!(self.segments.first(), Some(PathSeg::Quad(_)))
    }

    /// The segments with their points where `place` puts them.
    pub(in crate::document) fn placed(
        &self,
        place: impl Fn(Point) -> Point,
    ) -> impl Iterator<Item = PathSeg> {
        let segments = self.segments.iter();
        segments.map(move |segment| map_points(segment, &place))
    }
}

/// What a command for the segment is given: its inner control points and its end, in an array, and how many they are.
#[inline]
pub(in crate::document) fn arguments(segment: &PathSeg) -> ([Point; 3], usize) {
    let ([_, points @ ..], count) = points_of(segment);
    (points, count - 1)
}
