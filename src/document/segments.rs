//! Bézier segments between the joints of an arc, in a buffer that serves one arc after the other.

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, QuadBez, Vec2};

use crate::method::{Degree, Piece};

/// The inner control points and the end of each segment, as offsets from where the whole arc is counted from.
#[derive(Debug, Clone, Default)]
pub(super) struct Beziers {
    pub(super) points: Vec<Vec2>,
    /// 2 for a quadratic, 3 for a cubic.
    per_segment: usize,
    /// The decimals for its control points.
    pub(super) decimals: u32,
}

impl Beziers {
    /// The segments.
    pub(super) fn segments(&self) -> impl ExactSizeIterator<Item = &[Vec2]> {
        self.points.chunks_exact(self.per_segment.max(1))
    }

    /// The segments in the plane, from a start, their points where `place` puts them.
    pub(super) fn path_segments(
        &self,
        start: Point,
        place: impl Fn(Vec2) -> Point,
    ) -> impl Iterator<Item = PathSeg> {
        let mut from = start;
        self.segments().map(move |points| {
            let segment = match points {
                [p1, p2] => PathSeg::Quad(QuadBez::new(from, place(*p1), place(*p2))),
                _ => PathSeg::Cubic(CubicBez::new(
                    from,
                    place(points[0]),
                    place(points[1]),
                    place(points[2]),
                )),
            };
            from = segment.end();
            segment
        })
    }

    /// All points in their order.
    pub(super) fn points(&self) -> &[Vec2] {
        &self.points
    }

    /// Whether the segments are quadratics.
    pub(super) const fn is_quadratic(&self) -> bool {
        self.per_segment == 2
    }

    /// Adds a segment by its control points on the unit circle.
    pub(super) fn segment(&mut self, p1: Vec2, p2: Vec2, p3: Vec2, place: impl Fn(Vec2) -> Vec2) {
        if self.is_quadratic() {
            self.points.extend([
                place(p1.to_point().midpoint(p2.to_point()).to_vec2()),
                place(p3),
            ]);
        } else {
            self.points.extend([place(p1), place(p2), place(p3)]);
        }
    }

    /// Adds the segment between two joints. Each point is reached from its own joint: a huge radius does not swallow the digits.
    pub(super) fn between(
        &mut self,
        [before, after]: [Joint; 2],
        piece: &Piece,
        sign: f64,
        place: impl Fn(Vec2) -> Vec2,
    ) {
        let p1 = before.offset + place(before.way(piece, sign));
        let p2 = after.offset + place(after.way(piece, -sign));
        if self.is_quadratic() {
            let middle = p1.to_point().midpoint(p2.to_point());
            self.points.extend([middle.to_vec2(), after.offset]);
        } else {
            self.points.extend([p1, p2, after.offset]);
        }
    }

    pub(super) fn begin(&mut self, degree: Degree) {
        self.points.clear();
        self.per_segment = match degree {
            Degree::Cubic => 3,
            Degree::Quadratic => 2,
        };
    }
}

/// A joint: its radius on the unit circle, and where it lies.
#[derive(Clone, Copy)]
pub(super) struct Joint {
    pub(super) radius: Vec2,
    pub(super) offset: Vec2,
}

impl Joint {
    /// The control point beside the joint, on the unit circle.
    pub(super) fn control(&self, piece: &Piece, sense: f64) -> Vec2 {
        self.radius + self.way(piece, sense)
    }

    /// The way from the joint to the control point beside it, on the unit circle.
    fn way(&self, piece: &Piece, sense: f64) -> Vec2 {
        self.radius * (piece.handle.x - 1.0)
            + Vec2::new(-self.radius.y, self.radius.x) * (sense * piece.handle.y)
    }
}
