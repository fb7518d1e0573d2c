//! The finished curve: Bézier segments in user space.

use kurbo::{Affine, CubicBez, PathSeg, Point, QuadBez, Rect, Vec2};

use crate::joints::Joints;
use crate::method::{Degree, Piece};
use crate::shape::Outline;
use crate::write::number::{Precision, round};

/// A chain of Bézier segments, each of which starts where the one before it ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// The segments in their order.
    pub segments: Vec<PathSeg>,
    /// Whether the last point is the first and the curve is to be closed.
    pub closed: bool,
}

impl Curve {
    /// The pieces placed by the outline's affine map; the pieces come as [`crate::method::Rule::pieces`] gives them.
    pub(crate) fn place(outline: &Outline, joints: &Joints, pieces: &[[Piece; 2]]) -> Self {
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
        Self {
            segments,
            closed: joints.closed,
        }
    }

    /// The first point.
    #[must_use]
    pub fn start(&self) -> Option<Point> {
        self.segments.first().map(kurbo::ParamCurve::start)
    }

    /// The smallest rectangle around the curve itself, not its control points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<Rect> {
        self.segments
            .iter()
            .map(kurbo::Shape::bounding_box)
            .reduce(|a, b| a.union(b))
    }

    /// The curve with its control points mapped.
    #[must_use]
    pub fn transformed(&self, map: Affine) -> Self {
        Self {
            segments: self.segments.iter().map(|&segment| map * segment).collect(),
            closed: self.closed,
        }
    }

    /// The curve with its control points rounded once, in absolute coordinates; shared points stay shared. Points in `kept` are
    /// not rounded.
    #[must_use]
    pub fn rounded(&self, precision: Precision, kept: &[Point]) -> Self {
        let Precision::Fixed(decimals) = precision else {
            return self.clone();
        };
        self.map_points(|p| {
            if kept.contains(&p) {
                p
            } else {
                Point::new(round(p.x, decimals), round(p.y, decimals))
            }
        })
    }

    fn map_points(&self, f: impl Fn(Point) -> Point) -> Self {
        let map = |segment: &PathSeg| match *segment {
            PathSeg::Line(l) => PathSeg::Line(kurbo::Line::new(f(l.p0), f(l.p1))),
            PathSeg::Quad(q) => PathSeg::Quad(QuadBez::new(f(q.p0), f(q.p1), f(q.p2))),
            PathSeg::Cubic(c) => PathSeg::Cubic(CubicBez::new(f(c.p0), f(c.p1), f(c.p2), f(c.p3))),
        };
        Self {
            segments: self.segments.iter().map(map).collect(),
            closed: self.closed,
        }
    }
}

/// The control points of a segment: two of a line, three of a quadratic, four of a cubic.
#[must_use]
pub fn control_points(segment: &PathSeg) -> Vec<Point> {
    match *segment {
        PathSeg::Line(l) => vec![l.p0, l.p1],
        PathSeg::Quad(q) => vec![q.p0, q.p1, q.p2],
        PathSeg::Cubic(c) => vec![c.p0, c.p1, c.p2, c.p3],
    }
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
        Vec2::new(-halfway.y, halfway.x) * (2.0 * ((b - a) / 2.0).to_radians().sin())
    }
}
