//! Numbers rounded as machines and drawings of CAD hold them, and how far that moves what they describe.

use core::f64::consts::FRAC_PI_2;

use kurbo::{Point, Vec2};

use super::{CircularArc, Course, CourseStep, within_a_turn};
use crate::angle::Angle;
use crate::number::Precision;

impl CircularArc {
    /// A bound of how far an arc lies from what it was before its points were rounded, where its ends moved by up to `shift`; infinite where it
    /// no longer turns as far, since what is left of a short one may end where it starts. The radius is that from the rounded centre, and a machine
    /// makes up for another one at its end.
    ///
    /// It leaves the old circle no farther than [`Self::off_circle`] says, and where the end of one arc lies beyond that of the other, they are
    /// no farther apart than `shift`.
    ///
    /// Where the centre is far away, digits cancel there. Let it have moved by d. Seen from it, in the direction u, the new arc lies d·(u - n)
    /// farther from the old centre than at its start, in the direction n, to first order: next to nothing where it hardly turns. The second
    /// order is that of the sagitta.
    pub(crate) fn strayed(&self, new: &Self, from: Point, shift: f64) -> f64 {
        let sweep = self.sweep.degrees();
        let turned = new.turned(from, new.to);
        if (turned - sweep.abs()).abs() > 180.0 {
            return f64::INFINITY;
        }
        let off = self.off_circle(new, from, turned);
        if self.is_circle() {
            return off;
        }
        // Else an end may lie on the other side of the centre.
        let far = if off.max(shift) < 0.5 * self.radius {
            off.max(shift)
        } else {
            off + shift
        };
        let [radius, last] = [from, new.to].map(|end| end.distance(new.center));
        let rough = self.center.distance(new.center) + (radius - self.radius).abs();
        let least = radius.min(self.radius) - 2.0 * rough;
        let half = 0.5 * sweep.abs().to_radians() + 2.0 * rough / least;
        if least > 0.0 && half < FRAC_PI_2 {
            let moved = self.center.distance(new.center);
            let bent = 2.0 * moved * libm::sin(half) + 2.0 * rough * (rough / least);
            return far.min(shift + bent + (last - radius).abs());
        }
        far
    }

    /// A bound of how far the arc that starts here and turns so far leaves this one's circle.
    ///
    /// Let the centre have moved by d. The point at the distance ρ from the new one in the direction u is h = ρ + d·u from the old one along u,
    /// and by less than d²/2h farther in all. A machine's ρ lies between those of its ends.
    fn off_circle(&self, new: &Self, from: Point, turned: f64) -> f64 {
        let d = new.center - self.center;
        let moved = d.hypot2().sqrt();
        let ends = [from, new.to].map(|end| end - new.center);
        let [radius, last] = ends.map(|end| end.hypot2().sqrt());
        let at_ends = ends.map(|end| d.dot(end) / end.hypot2().sqrt());
        let farthest = |towards: Vec2, at: f64| {
            let is_met = new.turned(from, new.center + towards) <= turned;
            if is_met { moved } else { at }
        };
        let outward = farthest(d, at_ends[0].max(at_ends[1]));
        let inward = farthest(-d, -at_ends[0].min(at_ends[1]));
        let h = radius.min(last) - moved;
        let second = if h > 0.0 {
            0.5 * moved * (moved / h)
        } else {
            f64::INFINITY
        };
        let outward = radius.max(last) - self.radius + moved.min(outward + second);
        let inward = self.radius - radius.min(last) + inward;
        outward.max(inward) + 4.0 * f64::EPSILON * self.radius
    }

    /// The angle, in degrees, by which it turns from one direction, seen from its centre, to another: a whole turn where both are the same point.
    fn turned(&self, from: Point, to: Point) -> f64 {
        if from == to {
            return 360.0;
        }
        let [from, to] = [from, to].map(|p| Angle::of(p - self.center).degrees());
        within_a_turn((to - from) * self.sweep.degrees().signum())
    }

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
