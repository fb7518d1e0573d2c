//! Pieces of the unit circle become segments in user space.

use kurbo::{CubicBez, PathSeg, Point, QuadBez, Vec2};

use crate::curve::Curve;
use crate::joints::Joints;
use crate::method::{Degree, Piece};
use crate::shape::Outline;

/// The pieces placed by the outline's affine map; the pieces come as [`crate::method::Rule::pieces`] gives them.
pub(crate) fn place(outline: &Outline, joints: &Joints, pieces: &[[Piece; 2]]) -> Curve {
    let frames = Frames { outline, joints };
    let end = |i: usize, piece: &Piece| frames.point(i, piece.end_radius, 0.0, 1.0);
    let mut last = pieces
        .first()
        .map_or(Point::ZERO, |[first, _]| end(0, first));
    let segments = pieces
        .iter()
        .enumerate()
        .map(|(i, [start, end_piece])| {
            let (p0, p3) = (last, end(i + 1, end_piece));
            last = p3;
            let p1 = frames.point(i, start.handle.x, start.handle.y, 1.0);
            let p2 = frames.point(i + 1, end_piece.handle.x, end_piece.handle.y, -1.0);
            match start.degree {
                Degree::Cubic => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
                Degree::Quadratic => PathSeg::Quad(QuadBez::new(p0, p1.midpoint(p2), p3)),
            }
        })
        .collect();
    Curve {
        segments,
        closed: joints.closed,
    }
}

/// The points of the true shape at the joints, the ends of an arc left out.
pub(crate) fn joint_points<'a>(
    outline: &'a Outline,
    joints: &'a Joints,
) -> impl Iterator<Item = Point> + 'a {
    let frames = Frames { outline, joints };
    let first = usize::from(!joints.closed);
    (first..joints.count()).map(move |i| frames.point(i, 1.0, 0.0, 1.0))
}

/// Finds points in the frames of the joints.
struct Frames<'a> {
    outline: &'a Outline,
    joints: &'a Joints,
}

impl Frames<'_> {
    /// The point at `radial` along the radius of joint `i` and `along` its tangent, in or (`sense` -1) against the direction of travel.
    fn point(&self, i: usize, radial: f64, along: f64, sense: f64) -> Point {
        let radius = self.joints.directions[i];
        let tangent = Vec2::new(-radius.y, radius.x) * (self.joints.sign * sense * along);
        let map = |v: Vec2| self.outline.placement * v.to_point();
        let Some(ends) = self.outline.ends else {
            return map(radius * radial + tangent);
        };
        // From the nearer given end, so that it is met exactly and a huge radius does not swallow the digits.
        let last = self.joints.count();
        let (nearer, end) = if 2 * i <= last {
            (0, ends[0])
        } else {
            (last, ends[1])
        };
        let local = self.chord(nearer, i) + radius * (radial - 1.0) + tangent;
        let [a, b, c, d, _, _] = self.outline.placement.as_coeffs();
        end + Vec2::new(a * local.x + c * local.y, b * local.x + d * local.y)
    }

    /// From one joint to another on the unit circle: 2 sin(δ/2) across the direction halfway.
    fn chord(&self, from: usize, to: usize) -> Vec2 {
        let (a, b) = (self.joints.angles[from], self.joints.angles[to]);
        let halfway = crate::angle::Angle::from_degrees(f64::midpoint(a, b)).direction();
        Vec2::new(-halfway.y, halfway.x) * (2.0 * libm::sin(((b - a) / 2.0).to_radians()))
    }
}
