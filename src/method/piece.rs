//! What a method gives: the control points of one piece.

use kurbo::{CubicBez, PathSeg, Point, QuadBez, Vec2};

use super::{Degree, Span, tangent};

/// The control points of one piece, in the frames of its own ends, so that one value serves every position and both senses.
///
/// The frame of an end has its first axis along the radius through that end and its second along the tangent into the
/// piece; the piece is the same seen from either end. A cubic's first inner control point is `handle` in the frame of the
/// start, its second is `handle` in the frame of the end. A quadratic's only inner point is `handle` in both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The degree of the curve.
    pub degree: Degree,
    /// The distance of both ends from the centre; 1 where they lie on the circle.
    pub end_radius: f64,
    /// (along the radius, along the tangent).
    pub handle: Vec2,
}

impl Piece {
    /// A cubic with its ends on the circle and its handles, of length `k`, along the tangents.
    pub(crate) const fn tangent(k: f64) -> Self {
        Self {
            degree: Degree::Cubic,
            end_radius: 1.0,
            handle: Vec2::new(1.0, k),
        }
    }

    /// The piece with all its control points farther from the centre by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self {
            end_radius: self.end_radius * factor,
            handle: self.handle * factor,
            ..self
        }
    }

    /// The piece of this part of its angle, both so small that it is straight.
    pub(crate) fn shortened(self, part: f64) -> Self {
        Self {
            handle: Vec2::new(self.handle.x, self.handle.y * part),
            ..self
        }
    }

    /// The piece on the unit circle from one direction counter-clockwise to another.
    pub(crate) fn between(&self, [first, last]: [Vec2; 2]) -> PathSeg {
        let [p0, p3] = [first, last].map(|end| end * self.end_radius);
        let p1 = in_frame(first, self.handle.x, self.handle.y);
        let p2 = in_frame(last, self.handle.x, -self.handle.y);
        self.segment([p0, p1, p2, p3].map(Vec2::to_point))
    }

    /// The segment with these ends and the control points of either end's frame.
    #[inline]
    pub(crate) fn segment(&self, [p0, p1, p2, p3]: [Point; 4]) -> PathSeg {
        match self.degree {
            Degree::Cubic => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
            Degree::Quadratic => PathSeg::Quad(QuadBez::new(p0, p1.midpoint(p2), p3)),
        }
    }

    /// Whether it is a cubic that touches the circle at both ends, described by its handle alone.
    #[must_use]
    pub(crate) fn is_tangent_cubic(&self) -> bool {
        self.degree == Degree::Cubic && self.end_radius == 1.0 && self.handle.x == 1.0
    }

    /// H and G of r² - 1 = -u² (H + G u), u = t(1-t), where it is a cubic that touches the circle at both ends.
    #[must_use]
    pub(crate) fn excess(&self, span: &Span) -> Option<[f64; 2]> {
        let k = self.handle.y;
        let y = 3.0 * k * span.ch - 2.0 * span.sh;
        self.is_tangent_cubic().then(|| tangent::excess(span, k, y))
    }

    /// The length of the handle: how far the first inner control point lies from the end.
    #[must_use]
    pub fn handle_length(&self) -> f64 {
        libm::hypot(self.handle.x - self.end_radius, self.handle.y)
    }

    /// How far the tangent at an end leaves the circle's tangent outward, in degrees: half the corner at a joint of equal pieces.
    #[must_use]
    pub fn tangent_lift(&self) -> f64 {
        libm::atan2(self.handle.x - self.end_radius, self.handle.y).to_degrees()
    }
}

/// The point of an end's frame: `radial` along the radius through that end and `along` its tangent.
#[inline]
pub(crate) fn in_frame(end: Vec2, radial: f64, along: f64) -> Vec2 {
    end * radial + Vec2::new(-end.y, end.x) * along
}
