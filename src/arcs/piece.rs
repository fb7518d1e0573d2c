//! A step of a contour by its parameter from 0 to 1, and how far a chord of it lies from it.

use core::f64::consts::PI;

use kurbo::{Affine, CubicBez, Line, ParamCurve as _, PathSeg, Point, Rect, Vec2};

use crate::contour::Step;
use crate::error::Result;
use crate::numeric::functions::unit_vector;
use crate::shape::Outline;

/// How far a height above a chord may be off, as a part of the vectors that it was made from.
const HEIGHT: f64 = 4.0 * f64::EPSILON;

/// A step of a contour.
#[derive(Debug, Clone, Copy)]
pub(super) enum Piece {
    Line(Line),
    /// A Bézier, raised to a cubic.
    Cubic(CubicBez),
    Arc(Turn),
}

/// An arc of an ellipse: the image of directions of the unit circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    placement: Affine,
    /// In radians.
    start: f64,
    /// In radians, with its sign.
    sweep: f64,
    ends: Option<[Point; 2]>,
}

impl Piece {
    pub(super) fn new(step: &Step, transform: Affine) -> Result<Self> {
        Ok(match step {
            Step::Given(segment) => match transform * *segment {
                PathSeg::Line(line) => Self::Line(line),
                bezier => Self::Cubic(bezier.to_cubic()),
            },
            Step::Arc(arc) => Self::Arc(Turn::new(&arc.outline().transformed(transform)?)),
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

    /// A bound, both ways, of the distance of the part between two parameters from its chord.
    ///
    /// Let the part run along its chord from 0 to L in x, at the distance y from the chord's line. Every x of the chord is taken by
    /// some point of the part, so that no point of the chord is farther than the largest |y|; and no point of the part is farther
    /// than that and its overshoot of the chord's ends, as the sides of a right triangle.
    pub(super) fn chord_distance(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Cubic(cubic) => cubic_from_chord(&cubic.subsegment(from..to)),
            Self::Arc(turn) => turn.chord_distance(from, to),
        }
    }
}

/// The largest |y| exactly, y = 3t(1-t)((1-t)a + tb) with a, b of the inner control points, and the overshoot of these.
pub(super) fn cubic_from_chord(cubic: &CubicBez) -> f64 {
    let chord = cubic.p3 - cubic.p0;
    let length = chord.hypot2().sqrt();
    let inner = [cubic.p1 - cubic.p0, cubic.p2 - cubic.p0];
    if length == 0.0 {
        return inner
            .map(Vec2::hypot2)
            .into_iter()
            .fold(0.0, f64::max)
            .sqrt();
    }
    let along = chord / length;
    let [a, b] = inner.map(|v| along.cross(v));
    let height = |t: f64| (3.0 * t * (1.0 - t) * ((1.0 - t) * a + t * b)).abs();
    // y' = 0: 3(a-b)t² + (2b-4a)t + a = 0.
    let (p, q, r) = (3.0 * (a - b), 2.0 * b - 4.0 * a, a);
    let root = (q * q - 4.0 * p * r).max(0.0).sqrt();
    let s = -0.5 * (q + root.copysign(q));
    let roots = [s / p, r / s];
    let inside = |t: &f64| (0.0..=1.0).contains(t);
    let highest = roots
        .into_iter()
        .filter(inside)
        .map(height)
        .fold(0.0, f64::max);
    let over = inner
        .map(|v| along.dot(v))
        .map(|x| (-x).max(x - length).max(0.0));
    // Within the hull the curve goes no farther beyond an end than 4/9 of one control point and 4/9 of the other.
    let over = 4.0 / 9.0 * (over[0] + over[1]);
    away(highest, over, inner.into_iter().fold(chord, longer))
}

/// How far a point is from a chord that is so high above its line and so far beyond its end; a height is off by some roundings of
/// the longest vector that it was made from.
pub(super) fn away(height: f64, over: f64, longest: Vec2) -> f64 {
    let height = if height > 0.0 {
        height + HEIGHT * longest.hypot2().sqrt()
    } else {
        0.0
    };
    (height * height + over * over).sqrt()
}

pub(super) fn longer(a: Vec2, b: Vec2) -> Vec2 {
    if b.hypot2() > a.hypot2() { b } else { a }
}

/// The largest |y| of a cubic, by its control points from a chord's start, and how far its hull goes beyond the chord's ends.
pub(super) fn height_and_overshoot(points: [Vec2; 4], along: Vec2, length: f64) -> (f64, f64) {
    let y = points.map(|v| along.cross(v));
    let at = |t: f64| {
        let s = 1.0 - t;
        (s * s * (s * y[0] + 3.0 * t * y[1]) + t * t * (3.0 * s * y[2] + t * y[3])).abs()
    };
    // y'/3 = (1-t)² d₀ + 2t(1-t) d₁ + t² d₂ = 0.
    let d = [y[1] - y[0], y[2] - y[1], y[3] - y[2]];
    let (p, q, r) = (d[0] - 2.0 * d[1] + d[2], 2.0 * (d[1] - d[0]), d[0]);
    let root = (q * q - 4.0 * p * r).max(0.0).sqrt();
    let s = -0.5 * (q + root.copysign(q));
    let inside = |t: &f64| (0.0..=1.0).contains(t);
    let inner = [s / p, r / s].into_iter().filter(inside).map(at);
    let highest = inner.fold(y[0].abs().max(y[3].abs()), f64::max);
    let beyond = points.map(|v| along.dot(v)).map(|x| (-x).max(x - length));
    (highest, beyond.into_iter().fold(0.0, f64::max))
}

impl Turn {
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

    /// On the unit circle the chord's line is 1 - cos h from the middle of the arc, half the part being h; the affine image keeps
    /// that this is the farthest point, as it keeps parallels.
    fn chord_distance(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * (to - from) * self.sweep;
        if half.abs() > core::f64::consts::FRAC_PI_2 {
            return f64::INFINITY;
        }
        let [a, b, c, d, _, _] = self.placement.as_coeffs();
        let image = |v: Vec2| Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y);
        let middle = unit_vector(self.start + 0.5 * (from + to) * self.sweep);
        let (sin, cos) = libm::sincos(half.abs());
        let rise = 2.0 * libm::sin(half / 2.0) * libm::sin(half / 2.0);
        let chord = image(Vec2::new(-middle.y, middle.x));
        let length = chord.hypot2().sqrt();
        let along = chord / length;
        let [across, slant] = [along.cross(image(middle)), along.dot(image(middle))];
        let height = (rise * across).abs();
        // Along the chord the part has length·sin φ + slant·(cos φ - cos h); it ends at ±length·sin h.
        let most = (length * length + slant * slant).sqrt();
        let over = if libm::atan2(length, slant.abs()) < half.abs() {
            (most - slant.abs() * cos - length * sin).max(0.0)
        } else {
            0.0
        };
        (height * height + over * over).sqrt()
    }
}
