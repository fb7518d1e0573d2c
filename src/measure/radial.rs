//! The signed distance of a curve from a circle or an ellipse: its extremes, from roots and never from sampling alone.
//!
//! In the frame where the true shape is a unit circle about the origin, |p(t)|² - 1 is a polynomial of degree 6 (4 for a
//! quadratic). Its coefficients are formed in twice the digits of `f64`, from the centre or, where an arc was given by its ends,
//! from those; so errors far below 1e-16 of the radius are stated as what they are. On a circle the extremes of the distance are
//! the roots of its derivative. On an ellipse the true distance along the normal is taken, from the nearest point.

mod ellipse;
pub(crate) mod nearly;
mod part;
mod peaks;
mod search;
mod slopes;

pub(crate) use search::visit_between;

use core::iter;

use kurbo::{CubicBez, Line, ParamCurve, PathSeg, Point, QuadBez, Vec2};

use super::curvature;
use crate::curve::control_points;
use crate::numeric::adaptive_integral;
use crate::numeric::bernstein::{Parameters, Polynomial};
use crate::numeric::double::{Double, Twice};
use crate::numeric::foot::{Foot, foot};
use crate::radial_error::RadialError;
use crate::shape::{Exact, Truth};

/// The largest distances of these segments from the true shape, rounded outward: docs/methods.md says how far they can be trusted.
#[must_use]
pub fn error<'a>(segments: impl IntoIterator<Item = &'a PathSeg>, truth: &Truth) -> RadialError {
    let mut range = RadialError::default();
    let exact = truth.frame.exact(truth.radii);
    for segment in segments {
        let profile = Profile::within(segment, truth, &exact);
        profile.visit_bounds(|_, bounds| range.take_in_all(bounds));
    }
    range
}

/// Visits the ends and every extreme of the signed distance of a segment as (t, distance), positive outside.
pub fn visit_extremes(segment: &PathSeg, truth: &Truth, visit: impl FnMut(f64, f64)) {
    Profile::new(segment, truth).visit_extremes(visit);
}

/// A segment's points in the frame of a true shape: about its centre, or about an end of its chord.
struct FramedPoints {
    points: [Twice; 4],
    /// What is added to the dot products: minus the square of the radius, or the pencil's linear part at each point.
    levels: [Double; 4],
    count: usize,
}

impl FramedPoints {
    fn new(segment: &PathSeg, exact: &Exact) -> Self {
        let (points, count) = match *segment {
            PathSeg::Line(l) => ([l.p0, l.p1, l.p1, l.p1], 2),
            PathSeg::Quad(q) => ([q.p0, q.p1, q.p2, q.p2], 3),
            PathSeg::Cubic(c) => ([c.p0, c.p1, c.p2, c.p3], 4),
        };
        Self::of(points.map(|p| exact.point(p)), count, exact)
    }

    /// The same as a cubic.
    fn raised(self, exact: &Exact) -> Self {
        let [a, b, c, _] = self.points;
        // (u + n v) / (n + 1)
        let between = |u: Twice, v: Twice, n: f64| {
            let part = |i: usize| u[i].plus(v[i].scaled(n)).over(n + 1.0);
            [part(0), part(1)]
        };
        let points = match self.count {
            2 => [a, between(b, a, 2.0), between(a, b, 2.0), b],
            3 => [a, between(a, b, 2.0), between(c, b, 2.0), c],
            _ => return self,
        };
        Self::of(points, 4, exact)
    }

    fn of(points: [Twice; 4], count: usize, exact: &Exact) -> Self {
        Self {
            points,
            levels: points.map(|q| exact.level(q)),
            count,
        }
    }

    /// |p(t)|² - radius² about the centre.
    fn excess(&self) -> Polynomial {
        let term = |i: usize, j: usize| {
            let level = self.levels[i].near(self.levels[j]);
            Double::dot(self.points[i], self.points[j]).near(level.scaled(0.5))
        };
        let mean = |one: Double, a: f64, other: Double, b: f64| {
            one.scaled(a).near(other.scaled(b)).over(a + b).value()
        };
        match self.count {
            2 => Polynomial::new(&[[0, 0], [0, 1], [1, 1]].map(|[i, j]| term(i, j).value())),
            3 => Polynomial::new(&[
                term(0, 0).value(),
                term(0, 1).value(),
                mean(term(0, 2), 1.0, term(1, 1), 2.0),
                term(1, 2).value(),
                term(2, 2).value(),
            ]),
            _ => Polynomial::new(&[
                term(0, 0).value(),
                term(0, 1).value(),
                mean(term(0, 2), 2.0, term(1, 1), 3.0),
                mean(term(0, 3), 1.0, term(1, 2), 9.0),
                mean(term(1, 3), 2.0, term(2, 2), 3.0),
                term(2, 3).value(),
                term(3, 3).value(),
            ]),
        }
    }

    /// The segment about the origin of the frame, in the user's unit and along the axes `turned` to those of the true shape.
    fn segment(&self, exact: &Exact, turned: impl Fn(Vec2) -> Vec2) -> PathSeg {
        let [p0, p1, p2, p3] = self
            .points
            .map(|[x, y]| turned(exact.image(Vec2::new(x.value(), y.value()))).to_point());
        match self.count {
            2 => PathSeg::Line(Line::new(p0, p1)),
            3 => PathSeg::Quad(QuadBez::new(p0, p1, p2)),
            _ => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
        }
    }
}

/// The signed distance of one segment from the true shape as a function of t, positive outside.
pub(crate) struct Profile {
    /// The segment about the origin of its frame, along the axes.
    own: PathSeg,
    /// The centre from there.
    center: Vec2,
    radii: Vec2,
    /// |p|² - r² about a circle; in the frame where an ellipse is the unit circle for one.
    excess: Polynomial,
    /// How exactly the coordinates of `own` are known, as a part of the larger radius.
    coordinates: f64,
}

impl Profile {
    pub(crate) fn new(segment: &PathSeg, truth: &Truth) -> Self {
        Self::within(segment, truth, &truth.frame.exact(truth.radii))
    }

    /// The same where the frame of the true shape is at hand.
    fn within(segment: &PathSeg, truth: &Truth, exact: &Exact) -> Self {
        let mut framed = FramedPoints::new(segment, exact);
        if !truth.is_circle() {
            framed = framed.raised(exact);
        }
        let axis = truth.axis;
        let turned = |v: Vec2| {
            if exact.is_mapped() {
                Vec2::new(v.dot(axis), axis.cross(v))
            } else {
                v
            }
        };
        Self {
            own: framed.segment(exact, turned),
            center: turned(exact.image(exact.center())),
            radii: truth.radii,
            excess: framed.excess().scaled(exact.unit),
            coordinates: if exact.is_mapped() {
                8.0 * f64::EPSILON
            } else {
                0.0
            },
        }
    }

    fn is_circle(&self) -> bool {
        self.radii.x == self.radii.y
    }

    fn larger_radius(&self) -> f64 {
        self.radii.x.max(self.radii.y)
    }

    /// From the centre to the point at t, along the axes.
    fn arm(&self, t: f64) -> Vec2 {
        self.own.eval(t).to_vec2() - self.center
    }

    /// The signed distance at t.
    pub(crate) fn at(&self, t: f64) -> f64 {
        if self.is_circle() {
            self.distance_from_circle(t)
        } else {
            self.foot(t).distance
        }
    }

    /// sqrt(r² + excess) - r without cancellation. Close to the centre the sum cancels instead, and the point itself is taken.
    fn distance_from_circle(&self, t: f64) -> f64 {
        let radius = self.radii.x;
        let excess = self.excess.at(t);
        let square = radius * radius + excess;
        if square < radius * radius / 4.0 {
            return self.arm(t).hypot() - radius;
        }
        excess / (radius + square.sqrt())
    }

    /// Between what the distance from a circle that was found at t lies for certain.
    ///
    /// At the ends the excess is one coefficient, with one rounding. Between them de Casteljau's algorithm makes at most three
    /// roundings in each of its steps, six for a cubic, of what the sizes of the coefficients would sum up to; and the place of an
    /// extreme that is tiny beside the others is known to some six digits, where the distance is flat.
    fn bounds(&self, t: f64, distance: f64) -> [f64; 2] {
        let size = distance.abs();
        let mut margin = 4.0 * f64::EPSILON * size;
        if t > 0.0 && t < 1.0 {
            let rounding = |excess: f64| 9.0 * f64::EPSILON * excess * 0.6 / self.radii.x;
            let rough = rounding(self.excess.largest());
            // Beside the end t = 1 the place of an extreme is known to ε/2 only, and |F''| is at most 120 times the largest coefficient.
            margin += 16.0 * f64::EPSILON * rough;
            margin += if rough <= 1e-10 * size {
                rough
            } else {
                1e-11 * size + rounding(self.excess.sizes().at(t))
            };
            if distance < -0.5 * self.radii.x {
                margin += self.nearer(t);
            }
        }
        [distance - margin, distance + margin]
    }

    /// How much nearer to the centre a point may be than the one found at t, a root of q·q' but for the rounding of this product.
    ///
    /// For a small q the derivatives of the product are |q'|², 3 q'·q'' and 3 |q''|²; the one that counts says how far off the root may
    /// be. Where the curve turns back at the centre that is some 1e-5, elsewhere next to nothing.
    fn nearer(&self, t: f64) -> f64 {
        let points = control_points(&self.own);
        let [first, second, _] = curvature::derivatives(&points, t).map(Vec2::hypot);
        let rounding = 64.0 * f64::EPSILON * self.excess.largest();
        let off = (rounding / (first * first))
            .min((rounding / (first * second)).sqrt())
            .min(libm::cbrt(rounding / (second * second)))
            .min(1.0);
        first * off + second * off * off
    }

    /// Visits the ends and the extremes of the signed distance as (t, distance), positive outside.
    pub(crate) fn visit_extremes(&self, visit: impl FnMut(f64, f64)) {
        if self.is_circle() {
            self.visit_on_circle(visit);
        } else {
            self.visit_by_search(visit);
        }
    }

    /// Visits places with what the distance there lies between for certain; the whole segment lies between the largest and the least.
    pub(crate) fn visit_bounds(&self, mut visit: impl FnMut(f64, [f64; 2])) {
        if self.is_circle() {
            self.visit_on_circle(|t, distance| visit(t, self.bounds(t, distance)));
        } else {
            peaks::visit(self, visit);
        }
    }

    fn visit_on_circle(&self, mut visit: impl FnMut(f64, f64)) {
        let turning = self.excess.differences().sign_changes();
        for t in iter::once(0.0).chain(turning.iter()).chain(iter::once(1.0)) {
            visit(t, self.distance_from_circle(t));
        }
    }

    /// Where it changes its sign.
    pub(crate) fn crossings(&self) -> Parameters {
        self.excess.sign_changes()
    }

    /// The integral of f(t, |distance|) over t, with a joint wherever the distance changes its sign.
    pub(crate) fn integral(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        let crossings = self.crossings();
        let value = |t: f64| f(t, self.at(t).abs());
        let noise = f64::EPSILON / 16.0 * self.larger_radius();
        crossings
            .pieces()
            .map(|(from, to)| adaptive_integral(&value, from, to, noise))
            .sum()
    }
}

/// The signed distance of a point from the true shape, positive outside.
#[must_use]
pub fn distance(truth: &Truth, p: Point) -> f64 {
    nearest(truth, p).distance
}

/// The nearest point of the true shape: the distance from there, and the unit normal there in the plane.
pub(crate) fn nearest(truth: &Truth, p: Point) -> Foot {
    let offset = p - truth.center;
    let axis = truth.axis;
    let own = foot(truth.radii, Vec2::new(offset.dot(axis), axis.cross(offset)));
    Foot {
        outward: own.outward.rotate_scale(axis),
        ..own
    }
}
