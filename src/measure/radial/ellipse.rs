//! The extremes of the distance from an ellipse.
//!
//! Near the ellipse they lie beside those of Sampson's distance, which are roots of a polynomial: with F = |q|² - 1 of the point in
//! the frame where the ellipse is the unit circle, and G the squares of q over the radii, it is F / (2 √G) and its slope has the sign of
//! 2 F' G - F G'. Newton's method takes each to the extreme of the true distance. Far from the ellipse, and about very flat ones,
//! the extremes are roots of the derivative of the distance, bracketed between the crossings.

use kurbo::{ParamCurve, ParamCurveDeriv, PathSeg, Point, Vec2};

use super::Profile;
use super::search::{derivative, visit_between};
use crate::numeric::bernstein::{Bernstein, MOST, Parameters, Polynomial};
use crate::numeric::foot::{BentFoot, Foot, foot, foot_by_excess};

/// The largest product of the distance with the ellipse's largest curvature that passes for near: Sampson's distance is then that
/// part off at most, and its extremes lie beside the true ones.
const NEAR: f64 = 0.1;

/// How well the places of Sampson's extremes need to be known: Newton's method starts there.
const PLACE: f64 = 1e-4;

/// The most steps of Newton's method, which takes two or three.
const MOST_STEPS: usize = 8;

/// A step that changes the distance by less than this part of it needs no further one: what is left is of third order.
const LAST_CHANGE: f64 = 1e-11;

impl Profile {
    /// The nearest point of the ellipse at t.
    pub(super) fn foot(&self, t: f64) -> Foot {
        self.foot_near(t)
            .map_or_else(|| foot(self.radii, self.arm(t)), |near| near.foot)
    }

    /// The same where the excess knows the distance with more digits than the point does.
    pub(super) fn foot_near(&self, t: f64) -> Option<BentFoot> {
        foot_by_excess(self.radii, self.arm(t), self.excess.at(t))
    }

    /// The larger radius over the smaller one.
    fn flatness(&self) -> f64 {
        self.larger_radius() / self.radii.x.min(self.radii.y)
    }

    /// Where Sampson's distance has its extremes, if it can stand for the true one all along.
    pub(super) fn sampson(&self) -> Option<Turning> {
        let larger = self.larger_radius();
        let radii = self.radii / larger;
        let [x, y] = self.coordinates(larger);
        let (x, y) = (
            x.scaled(1.0 / (radii.x * radii.x)),
            y.scaled(1.0 / (radii.y * radii.y)),
        );
        let gradient = x.times(&x).minus(&y.times(&y).scaled(-1.0));
        let rising: Bernstein<MOST> = self.excess.differences().scaled(2.0).product(&gradient);
        let slope = rising.minus(&self.excess.product(&gradient.differences()));
        let distance = |t: f64| (self.excess.at(t) / (2.0 * gradient.at(t).sqrt())).abs();
        let places = slope.sign_changes_within(PLACE);
        let ends = [distance(0.0), distance(1.0)];
        let peak = places.iter().map(distance).chain(ends).fold(0.0, f64::max);
        let flat = self.flatness();
        (peak * flat * flat <= NEAR).then(|| Turning {
            places,
            enters: [slope.at(0.0), -slope.at(1.0)].map(|slope| slope > 0.0),
            peak: peak * larger,
        })
    }

    pub(super) fn visit_near(&self, turning: &Turning, visit: &mut impl FnMut(f64, f64)) {
        let end = |i: usize, visit: &mut dyn FnMut(f64, f64)| {
            let t = i as f64;
            let foot = self.foot(t);
            // Beside an end the true distance may have an extreme where Sampson's has none.
            let inward = if i == 0 { 1.0 } else { -1.0 };
            let grows = derivative(&self.own, t).dot(foot.outward) * inward > 0.0;
            let hidden = grows != turning.enters[i] && foot.distance.abs() > 1e-3 * turning.peak;
            let beside = hidden.then(|| self.settled(t));
            if i == 0 {
                visit(t, foot.distance);
            }
            if let Some((t, distance)) = beside {
                visit(t, distance);
            }
            if i == 1 {
                visit(t, foot.distance);
            }
        };
        end(0, visit);
        for t in turning.places.iter() {
            let (t, distance) = self.settled(t);
            visit(t, distance);
        }
        end(1, visit);
    }

    /// The extreme of the distance near t, by Newton's method: the slope of the distance is n·p', and its derivative
    /// n·p'' + κ (τ·p')², κ the curvature of the parallel curve through the point.
    fn settled(&self, mut t: f64) -> (f64, f64) {
        for _ in 0..MOST_STEPS {
            let Some(BentFoot { foot, curvature }) = self.foot_near(t) else {
                break;
            };
            let (velocity, acceleration) = (derivative(&self.own, t), self.second_derivative(t));
            let normal = foot.outward;
            let slope = velocity.dot(normal);
            let along = velocity.cross(normal);
            let parallel = curvature / (1.0 + curvature * foot.distance);
            let bend = acceleration.dot(normal) + parallel * along * along;
            let step = -slope / bend;
            if !step.is_finite() || step.abs() > 0.1 {
                break;
            }
            let next = (t + step).clamp(0.0, 1.0);
            let change = slope * step / 2.0;
            if change.abs() < LAST_CHANGE * foot.distance.abs() && next == t + step {
                return (next, foot.distance + change);
            }
            if next == t {
                break;
            }
            t = next;
        }
        (t, self.foot(t).distance)
    }

    pub(super) fn visit_far(&self, visit: &mut impl FnMut(f64, f64)) {
        // Where the curve crosses the long axis, the nearest point jumps to the other side, and the distance has a peak without a slope.
        let [x, y] = self.coordinates(1.0);
        let axis = if self.radii.x >= self.radii.y { y } else { x }.sign_changes();
        for t in axis.iter() {
            visit(t, self.at(t));
        }
        let cuts: Vec<f64> = self.crossings().iter().chain(axis.iter()).collect();
        visit_between(&self.own, &cuts, |t| self.foot(t), visit);
    }

    /// x and y about the centre as polynomials, in this unit.
    fn coordinates(&self, unit: f64) -> [Polynomial; 2] {
        let polynomials = |points: &[Point]| {
            let mut own = [[0.0; 4]; 2];
            for (i, p) in points.iter().enumerate() {
                own[0][i] = (p.x - self.center.x) / unit;
                own[1][i] = (p.y - self.center.y) / unit;
            }
            own.map(|coordinates| Polynomial::new(&coordinates[..points.len()]))
        };
        match self.own {
            PathSeg::Line(l) => polynomials(&[l.p0, l.p1]),
            PathSeg::Quad(q) => polynomials(&[q.p0, q.p1, q.p2]),
            PathSeg::Cubic(c) => polynomials(&[c.p0, c.p1, c.p2, c.p3]),
        }
    }

    fn second_derivative(&self, t: f64) -> Vec2 {
        match &self.own {
            PathSeg::Line(_) => Vec2::ZERO,
            PathSeg::Quad(quad) => quad.deriv().deriv().eval(t).to_vec2(),
            PathSeg::Cubic(cubic) => cubic.deriv().deriv().eval(t).to_vec2(),
        }
    }
}

/// Where Sampson's distance turns.
pub(super) struct Turning {
    places: Parameters,
    /// Whether it grows from the first end on, and towards the last.
    enters: [bool; 2],
    /// Its largest size.
    peak: f64,
}
