//! A step of a contour by its parameter from 0 to 1, and how far a chord of it lies from it.

use core::f64::consts::PI;

use kurbo::{Affine, CubicBez, Line, ParamCurve as _, PathSeg, Point, Rect, Vec2};

use super::from_chord::{Above, of_arc};
use crate::contour::Step;
use crate::error::Result;
use crate::numeric::functions::unit_vector;
use crate::shape::Outline;

/// A step of a contour.
#[derive(Debug, Clone, Copy)]
pub(super) enum StepCurve {
    Line(Line),
    /// A Bézier, raised to a cubic.
    Cubic(CubicBez),
    Arc(EllipseTurn),
}

/// An arc of an ellipse: the image of directions of the unit circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct EllipseTurn {
    placement: Affine,
    /// In radians.
    start: f64,
    /// In radians, with its sign.
    sweep: f64,
    ends: Option<[Point; 2]>,
}

impl StepCurve {
    pub(super) fn new(step: &Step, transform: Affine) -> Result<Self> {
        Ok(match step {
            Step::Given(segment) => match transform * *segment {
                PathSeg::Line(line) => Self::Line(line),
                bezier => Self::Cubic(bezier.to_cubic()),
            },
            Step::Arc(arc) => Self::Arc(EllipseTurn::new(&arc.outline().transformed(transform)?)),
        })
    }

    /// Whether it is a cubic of no length, which has no direction: it neither ends a curve nor begins one.
    pub(super) fn is_dot(&self) -> bool {
        let same = |cubic: &CubicBez| [cubic.p1, cubic.p2, cubic.p3] == [cubic.p0; 3];
        matches!(self, Self::Cubic(cubic) if same(cubic))
    }

    pub(super) const fn is_line(&self) -> bool {
        matches!(self, Self::Line(_))
    }

    pub(super) fn start(&self) -> Point {
        match self {
            Self::Line(line) => line.p0,
            Self::Cubic(cubic) => cubic.p0,
            Self::Arc(turn) => turn.ends.map_or_else(|| turn.point(0.0), |[from, _]| from),
        }
    }

    pub(super) fn end(&self) -> Point {
        match self {
            Self::Line(line) => line.p1,
            Self::Cubic(cubic) => cubic.p3,
            Self::Arc(turn) => turn.ends.map_or_else(|| turn.point(1.0), |[_, to]| to),
        }
    }

    pub(super) fn point(&self, t: f64) -> Point {
        match self {
            Self::Line(line) => line.eval(t),
            Self::Cubic(cubic) => cubic.eval(t),
            Self::Arc(turn) => turn.point(t),
        }
    }

    /// The smallest upright box around it.
    pub(super) fn bounding_box(&self) -> Rect {
        match self {
            Self::Line(line) => Rect::from_points(line.p0, line.p1),
            Self::Cubic(cubic) => kurbo::Shape::bounding_box(cubic),
            Self::Arc(turn) => turn.bounding_box(),
        }
    }

    /// Whether the part between two parameters surely turns to one side alone, by less than half a turn.
    pub(super) fn is_convex(&self, from: f64, to: f64) -> bool {
        match self {
            Self::Line(_) => true,
            Self::Cubic(cubic) => {
                let part = cubic.subsegment(from..to);
                let legs = [part.p1 - part.p0, part.p2 - part.p1, part.p3 - part.p2];
                let [a, b, c] = [(0, 1), (1, 2), (0, 2)].map(|(i, j)| legs[i].cross(legs[j]));
                (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0)
            }
            Self::Arc(turn) => (to - from) * turn.sweep.abs() <= PI,
        }
    }

    /// The distance, both ways, of the part between two parameters from its chord.
    pub(super) fn chord_distance(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Cubic(cubic) => above(cubic, from, to).farthest(),
            Self::Arc(turn) => turn.chord_distance((from, to), f64::INFINITY),
        }
    }

    /// Whether that is no more than a limit.
    pub(super) fn is_chord_within(&self, from: f64, to: f64, limit: f64) -> bool {
        match self {
            Self::Line(_) => 0.0 <= limit,
            Self::Cubic(cubic) => above(cubic, from, to).is_within(limit),
            Self::Arc(turn) => turn.chord_distance((from, to), limit) <= limit,
        }
    }
}

fn above(cubic: &CubicBez, from: f64, to: f64) -> Above {
    let part = cubic.subsegment(from..to);
    Above::new(&part, [part.p0, part.p3])
}

impl EllipseTurn {
    fn new(outline: &Outline) -> Self {
        Self {
            placement: outline.placement,
            start: outline.unit.start.degrees().to_radians(),
            sweep: outline.unit.sweep.degrees().to_radians(),
            ends: outline.ends,
        }
    }

    /// From the start where this is given, so that a centre far away takes no digits: on the unit circle the chord of an angle a is 2 sin(a/2)
    /// long and square to the direction of its middle.
    fn point(&self, t: f64) -> Point {
        let Some([from, to]) = self.ends else {
            return self.placement * unit_vector(self.start + t * self.sweep).to_point();
        };
        let [a, b, c, d, ..] = self.placement.as_coeffs();
        let way = |t: f64| {
            let half = 0.5 * t * self.sweep;
            let (middle, length) = (unit_vector(self.start + half), 2.0 * libm::sin(half));
            let v = Vec2::new(-middle.y, middle.x) * length;
            Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y)
        };
        from + way(t) + t * ((to - from) - way(1.0))
    }

    /// Its ends, and where it turns back in x and in y.
    fn bounding_box(&self) -> Rect {
        let [a, b, c, d, ..] = self.placement.as_coeffs();
        let mut bounds = Rect::from_points(self.point(0.0), self.point(1.0));
        let turns = [libm::atan2(c, a), libm::atan2(d, b)].map(|angle| [angle, angle + PI]);
        for angle in turns.into_iter().flatten() {
            let ahead = (angle - self.start) * self.sweep.signum();
            let t = ahead.rem_euclid(2.0 * PI) / self.sweep.abs();
            if t < 1.0 {
                bounds = bounds.union_pt(self.point(t));
            }
        }
        bounds
    }

    /// The affine image keeps parallels: with a direction of the middle of the part, and one square to it, as the plane where it is the unit
    /// circle has them, the image of the second runs along the chord.
    fn chord_distance(&self, (from, to): (f64, f64), limit: f64) -> f64 {
        let half = 0.5 * (to - from) * self.sweep.abs();
        let [a, b, c, d, _, _] = self.placement.as_coeffs();
        let image = |v: Vec2| Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y);
        let middle = unit_vector(self.start + 0.5 * (from + to) * self.sweep);
        let chord = image(Vec2::new(-middle.y, middle.x));
        let length = chord.hypot2().sqrt();
        let (along, middle) = (chord / length, image(middle));
        of_arc(
            [length, along.dot(middle), along.cross(middle)],
            half,
            limit,
        )
    }
}
