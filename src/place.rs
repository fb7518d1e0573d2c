//! Pieces of the unit circle become segments in user space: the only place where they do, but for `engine`'s cubics at equal angles, whose
//! joints are turned from the one before them and not computed each on its own.

use kurbo::{Affine, PathSeg, Point, Vec2};

use crate::angle::Angle;
use crate::curve::Curve;
use crate::joints::cutting::Cutting;
use crate::method::{Piece, in_frame};
use crate::shape::Outline;

/// A cut piece of the unit circle, and where it lies.
#[derive(Debug)]
pub(crate) struct Placed<'a, C> {
    pub(crate) cutting: &'a C,
    /// The map from the unit circle.
    pub(crate) placement: Affine,
    /// The ends, where they were given.
    pub(crate) ends: Option<[Point; 2]>,
}

impl<'a, C: Cutting> Placed<'a, C> {
    /// An outline, cut.
    pub(crate) const fn new(outline: &Outline, cutting: &'a C) -> Self {
        Self {
            cutting,
            placement: outline.placement,
            ends: outline.ends,
        }
    }

    /// The segments of these pieces, each as [`crate::method::Rule::pieces`] gives it: seen from its start, and from its end.
    pub(crate) fn segments(
        &self,
        pieces: impl IntoIterator<Item = [Piece; 2]>,
    ) -> impl Iterator<Item = PathSeg> {
        let sign = self.cutting.sign();
        let mut before = self.joint(0);
        let mut from = None;
        let pieces = pieces.into_iter().zip(1..=self.cutting.count());
        pieces.map(move |([first, last], i)| {
            let after = self.joint(i);
            let p0 = from.unwrap_or_else(|| self.point(&before, first.end_radius, 0.0));
            let p1 = self.point(&before, first.handle.x, sign * first.handle.y);
            let p2 = self.point(&after, last.handle.x, -sign * last.handle.y);
            let p3 = self.point(&after, last.end_radius, 0.0);
            (before, from) = (after, Some(p3));
            first.segment([p0, p1, p2, p3])
        })
    }

    /// The same as a curve.
    pub(crate) fn curve(
        &self,
        pieces: impl IntoIterator<Item = [Piece; 2]>,
        closed: bool,
    ) -> Curve {
        let segments = self.segments(pieces).collect();
        Curve { segments, closed }
    }

    /// The points of the true shape at these joints.
    pub(crate) fn points(
        &self,
        joints: impl IntoIterator<Item = usize>,
    ) -> impl Iterator<Item = Point> {
        let joints = joints.into_iter();
        joints.map(|i| self.point(&self.joint(i), 1.0, 0.0))
    }

    /// A joint, reached from the nearer given end, so that it is met exactly and a huge radius does not swallow the digits.
    fn joint(&self, i: usize) -> PlacedJoint {
        let last = self.cutting.count();
        let from = self.ends.map(|ends| {
            let (nearer, end) = if 2 * i <= last {
                (0, ends[0])
            } else {
                (last, ends[1])
            };
            let chord = if i == nearer {
                Vec2::ZERO
            } else {
                chord(self.cutting.angle(nearer), self.cutting.angle(i))
            };
            (end, chord)
        });
        PlacedJoint {
            direction: self.cutting.direction(i),
            from,
        }
    }

    /// The point at `radial` along the radius of a joint and `along` its tangent.
    #[inline]
    fn point(&self, joint: &PlacedJoint, radial: f64, along: f64) -> Point {
        let Some((end, chord)) = joint.from else {
            return self.placement * in_frame(joint.direction, radial, along).to_point();
        };
        let local = chord + in_frame(joint.direction, radial - 1.0, along);
        let [a, b, c, d, _, _] = self.placement.as_coeffs();
        end + Vec2::new(a * local.x + c * local.y, b * local.x + d * local.y)
    }
}

/// Where a joint lies on the unit circle.
struct PlacedJoint {
    direction: Vec2,
    /// The given end that it is reached from, and the way from there on the unit circle; else it is reached from the centre.
    from: Option<(Point, Vec2)>,
}

/// From one angle of the unit circle to another: 2 sin(δ/2) across the direction halfway.
fn chord(from: f64, to: f64) -> Vec2 {
    let halfway = Angle::from_degrees(f64::midpoint(from, to)).direction();
    Vec2::new(-halfway.y, halfway.x) * (2.0 * libm::sin(((to - from) / 2.0).to_radians()))
}
