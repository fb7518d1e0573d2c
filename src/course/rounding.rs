//! Numbers rounded as a drawing of CAD holds them.

use core::f64::consts::FRAC_PI_2;

use kurbo::{Point, Vec2};

use super::{CircularArc, Course, CourseStep};
use crate::angle::Angle;
use crate::number::Precision;

impl CircularArc {
    /// The arc with its centre, its radius and its angles rounded, and how far that moves it at most; `None` where it leaves no arc.
    fn rounded_by_center(&self, precision: Precision) -> Option<(Self, f64)> {
        let first = self.start.degrees();
        let ends = [first, first + self.sweep.degrees()];
        let rounded_ends = ends.map(|angle| precision.of_angles().round(angle));
        let whole = self.is_circle();
        let mut arc = Self {
            radius: precision.round(self.radius),
            ..self.rounded(precision)
        };
        let mut turned = 0.0_f64;
        if !whole {
            let [start, end] = rounded_ends;
            arc.start = Angle::from_degrees(start);
            arc.sweep = Angle::from_degrees(end - start);
            turned = (start - ends[0]).abs().max((end - ends[1]).abs());
        }
        arc.to = arc.point(1.0);
        let moved = self.center.distance(arc.center)
            + (self.radius - arc.radius).abs()
            + self.radius * turned.to_radians();
        let is_left = arc.radius > 0.0 && arc.sweep.degrees() != 0.0 && arc.is_circle() == whole;
        is_left.then_some((arc, moved))
    }

    /// The arc of the same bulge between rounded ends, and how far it is moved at most; `None` where its ends become one point.
    ///
    /// A map p ↦ from' + z (to' - from'), z = (p - from)/(to - from), moves a point by (1 - z) d + z e where the ends move by d and e. Neither factor is
    /// larger on the arc than 1, or the diameter over the chord where it is more than half a turn.
    fn rounded_by_ends(&self, precision: Precision, from: Point) -> Option<(Self, f64)> {
        let old = [from, self.to];
        let new = old.map(|p| precision.round_point(p));
        let [chord, other] = [old, new].map(|[from, to]| to - from);
        if chord == Vec2::ZERO || other == Vec2::ZERO {
            return None;
        }
        let at = self.center - old[0];
        let (along, across) = (
            at.dot(chord) / chord.hypot2(),
            chord.cross(at) / chord.hypot2(),
        );
        let center = new[0] + along * other + across * Vec2::new(-other.y, other.x);
        let half = 0.5 * self.sweep.radians().abs();
        let most = if half > FRAC_PI_2 {
            1.0 / libm::sin(half)
        } else {
            1.0
        };
        let arc = Self {
            to: new[1],
            center,
            radius: self.radius * (other.hypot2() / chord.hypot2()).sqrt(),
            start: Angle::of(new[0] - center),
            ..*self
        };
        let moved = old[0].distance(new[0]) + old[1].distance(new[1]);
        Some((arc, most * moved))
    }
}

impl Course {
    /// The course with the numbers rounded that a drawing of CAD holds, and how far that moves it at most: of one arc its centre, its radius and
    /// its angles, unless its ends were given; else its points, and arcs keep their bulges. `None` where it leaves nothing of an arc.
    #[must_use]
    pub fn rounded_for_cad(&self, precision: Precision) -> Option<(Self, f64)> {
        if precision == Precision::Full {
            return Some((self.clone(), 0.0));
        }
        let (mut steps, mut moved) = (Vec::with_capacity(self.steps.len()), 0.0_f64);
        let (mut from, mut start) = (self.start, precision.round_point(self.start));
        for step in &self.steps {
            let (new, off) = match step {
                CourseStep::Arc(arc)
                    if self.steps.len() == 1 && (arc.is_circle() || !arc.ends_given) =>
                {
                    let (arc, off) = arc.rounded_by_center(precision)?;
                    start = arc.point(0.0);
                    (CourseStep::Arc(arc), off)
                }
                CourseStep::Arc(arc) => {
                    let (arc, off) = arc.rounded_by_ends(precision, from)?;
                    (CourseStep::Arc(arc), off)
                }
                CourseStep::Line(_) | CourseStep::Elliptical(_) => {
                    let to = precision.round_point(step.to());
                    let off = from.distance(precision.round_point(from));
                    (CourseStep::Line(to), off.max(step.to().distance(to)))
                }
            };
            moved = moved.max(off);
            from = step.to();
            steps.push(new);
        }
        let closed = self.closed;
        Some((
            Self {
                start,
                steps,
                closed,
            },
            moved,
        ))
    }
}
