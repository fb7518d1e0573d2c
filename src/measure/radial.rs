//! The signed distance of a curve from a circle or an ellipse: its extremes, from roots and never from sampling alone.
//!
//! On a circle |p(t)|² - r² is a polynomial of degree 6 (4 for a quadratic); its coefficients are formed in twice the digits of
//! `f64`, so that errors far below 1e-16 of the radius are told as what they are, and the extremes are the roots of its
//! derivative. On an ellipse the true distance along the normal is taken, from the nearest point; its extremes are roots of the
//! derivative of the distance, bracketed between the crossings.

use core::iter;

use kurbo::{CubicBez, Line, ParamCurve, ParamCurveDeriv, PathSeg, Point, QuadBez, Vec2};

use crate::numeric::bernstein::{Parameters, Polynomial, binomial};
use crate::numeric::double::Double;
use crate::numeric::foot::{Foot, foot};
use crate::numeric::{adaptive_integral, root};
use crate::radial_error::RadialError;
use crate::shape::Truth;

/// How many brackets the search on an ellipse begins with between two crossings; they narrow towards the crossings, as the
/// distance does where the curve touches the ellipse.
const BRACKETS: u32 = 32;

/// A bracket in which the ellipse's normal turns by more than this, as a cosine, is halved: at the tips of a flat ellipse the
/// distance varies with the normal, far faster than with t.
const NORMAL_TURN: f64 = 0.95;

/// How often a bracket is halved at most.
const MOST_HALVINGS: u32 = 24;

/// The largest distances of these segments from the true shape.
#[must_use]
pub fn error<'a>(segments: impl IntoIterator<Item = &'a PathSeg>, truth: &Truth) -> RadialError {
    let mut range = RadialError::default();
    for segment in segments {
        visit_extremes(segment, truth, |_, distance| range.take_in_all([distance]));
    }
    range
}

/// Visits the ends and every extreme of the signed distance as (t, distance), positive outside.
pub fn visit_extremes(segment: &PathSeg, truth: &Truth, mut visit: impl FnMut(f64, f64)) {
    if truth.is_circle() {
        let excess = excess(segment, truth.center, truth.radii.x);
        let turning = excess.differences().sign_changes();
        for t in iter::once(0.0).chain(turning.iter()).chain(iter::once(1.0)) {
            visit(t, distance_from_circle(segment, truth, &excess, t));
        }
        return;
    }
    let (segment, truth) = &about_the_centre(segment, truth);
    let foot = |p| nearest(truth, p);
    let crossings = Profile::new(segment, truth).crossings();
    // Where the curve crosses the long axis, the nearest point jumps to the other side, and the distance has a peak without a slope.
    let axis = short_coordinate(segment, truth).sign_changes();
    for t in axis.iter() {
        visit(t, foot(segment.eval(t)).distance);
    }
    let cuts: Vec<f64> = crossings.iter().chain(axis.iter()).collect();
    visit_between(segment, &cuts, foot, visit);
}

/// Visits the ends and every extreme of the signed distance as (t, distance), each between two of these places at which the
/// distance changes its sign or jumps; `foot` finds the nearest point of the true shape.
pub(crate) fn visit_between(
    segment: &PathSeg,
    cuts: &[f64],
    foot: impl Fn(Point) -> Foot,
    mut visit: impl FnMut(f64, f64),
) {
    let search = Search { segment, foot };
    visit(0.0, search.distance(0.0));
    let mut cuts = cuts.to_vec();
    cuts.sort_by(f64::total_cmp);
    let ends = iter::once(0.0).chain(cuts.iter().copied());
    for (from, to) in ends.zip(cuts.iter().copied().chain(iter::once(1.0))) {
        let mut before = search.sample(from);
        for i in 1..=BRACKETS {
            let part = libm::cos(core::f64::consts::PI * f64::from(i) / f64::from(BRACKETS));
            let after = search.sample(from + (to - from) * (1.0 - part) / 2.0);
            search.bracket(&before, &after, MOST_HALVINGS, &mut visit);
            before = after;
        }
    }
    visit(1.0, search.distance(1.0));
}

/// The segment and the shape with the shape's centre as the origin.
///
/// Far from the origin the points of a small shape share their leading digits; each difference loses at most half a unit in its
/// own last place, while a point evaluated at its absolute coordinates would lose one of theirs.
fn about_the_centre(segment: &PathSeg, truth: &Truth) -> (PathSeg, Truth) {
    let own = |p: Point| (p - truth.center).to_point();
    let segment = match *segment {
        PathSeg::Line(l) => PathSeg::Line(Line::new(own(l.p0), own(l.p1))),
        PathSeg::Quad(q) => PathSeg::Quad(QuadBez::new(own(q.p0), own(q.p1), own(q.p2))),
        PathSeg::Cubic(c) => {
            PathSeg::Cubic(CubicBez::new(own(c.p0), own(c.p1), own(c.p2), own(c.p3)))
        }
    };
    let truth = Truth {
        center: Point::ORIGIN,
        ..*truth
    };
    (segment, truth)
}

/// How far the segment lies from the long axis of the ellipse, with a sign, in the frame where that is the unit circle.
fn short_coordinate(segment: &PathSeg, truth: &Truth) -> Polynomial {
    let framed = truth.placement().inverse() * *segment;
    let is_wide = truth.radii.x >= truth.radii.y;
    let short = |p: Point| if is_wide { p.y } else { p.x };
    match framed {
        PathSeg::Line(l) => Polynomial::new(&[short(l.p0), short(l.p1)]),
        PathSeg::Quad(q) => Polynomial::new(&[q.p0, q.p1, q.p2].map(short)),
        PathSeg::Cubic(c) => Polynomial::new(&[c.p0, c.p1, c.p2, c.p3].map(short)),
    }
}

/// The search for the extremes of the distance from a shape whose nearest points are known.
struct Search<'a, F> {
    segment: &'a PathSeg,
    foot: F,
}

/// A place on the segment with the derivative of the distance there.
struct Sample {
    t: f64,
    slope: f64,
    normal: Vec2,
}

impl<F: Fn(Point) -> Foot> Search<'_, F> {
    fn distance(&self, t: f64) -> f64 {
        (self.foot)(self.segment.eval(t)).distance
    }

    fn sample(&self, t: f64) -> Sample {
        let (p, derivative) = eval(self.segment, t);
        let normal = (self.foot)(p).outward;
        Sample {
            t,
            slope: derivative.dot(normal),
            normal,
        }
    }

    /// Visits the extreme between two places, halving where the normal turns far.
    fn bracket(
        &self,
        before: &Sample,
        after: &Sample,
        halvings: u32,
        visit: &mut impl FnMut(f64, f64),
    ) {
        if halvings > 0 && before.normal.dot(after.normal) < NORMAL_TURN {
            let middle = self.sample(f64::midpoint(before.t, after.t));
            self.bracket(before, &middle, halvings - 1, visit);
            self.bracket(&middle, after, halvings - 1, visit);
        } else if (before.slope > 0.0) != (after.slope > 0.0) {
            let t = root(|t| self.sample(t).slope, before.t, after.t);
            visit(t, self.distance(t));
        }
    }
}

/// The signed distance of one segment from the true shape as a function of t, positive outside.
pub(crate) struct Profile {
    segment: PathSeg,
    truth: Truth,
    /// |p|² - r² about a circle; in the frame where an ellipse is the unit circle for one.
    excess: Polynomial,
}

impl Profile {
    pub(crate) fn new(segment: &PathSeg, truth: &Truth) -> Self {
        let (own, own_truth) = about_the_centre(segment, truth);
        let (segment, truth, excess) = if truth.is_circle() {
            let excess = excess(segment, truth.center, truth.radii.x);
            (*segment, *truth, excess)
        } else {
            let framed = own_truth.placement().inverse() * own;
            (own, own_truth, excess(&framed, Point::ORIGIN, 1.0))
        };
        Self {
            segment,
            truth,
            excess,
        }
    }

    /// The signed distance at t.
    pub(crate) fn at(&self, t: f64) -> f64 {
        if self.truth.is_circle() {
            distance_from_circle(&self.segment, &self.truth, &self.excess, t)
        } else {
            distance(&self.truth, self.segment.eval(t))
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
        let noise = f64::EPSILON / 16.0 * self.truth.larger_radius();
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

/// The point and the derivative at t.
fn eval(segment: &PathSeg, t: f64) -> (Point, Vec2) {
    match segment {
        PathSeg::Line(line) => (line.eval(t), line.p1 - line.p0),
        PathSeg::Quad(quad) => (quad.eval(t), quad.deriv().eval(t).to_vec2()),
        PathSeg::Cubic(cubic) => (cubic.eval(t), cubic.deriv().eval(t).to_vec2()),
    }
}

/// sqrt(r² + excess) - r without cancellation. Close to the centre the sum cancels instead, and the point itself is taken.
fn distance_from_circle(segment: &PathSeg, truth: &Truth, excess: &Polynomial, t: f64) -> f64 {
    let radius = truth.radii.x;
    let excess = excess.at(t);
    let square = radius * radius + excess;
    if square < radius * radius / 4.0 {
        let (own, _) = about_the_centre(segment, truth);
        return own.eval(t).to_vec2().hypot() - radius;
    }
    excess / (radius + square.sqrt())
}

/// |p(t) - center|² - radius², its coefficients formed in twice the digits.
fn excess(segment: &PathSeg, center: Point, radius: f64) -> Polynomial {
    let (points, count) = match *segment {
        PathSeg::Line(l) => ([l.p0, l.p1, l.p1, l.p1], 2),
        PathSeg::Quad(q) => ([q.p0, q.p1, q.p2, q.p2], 3),
        PathSeg::Cubic(c) => ([c.p0, c.p1, c.p2, c.p3], 4),
    };
    let points = points.map(|p| {
        [
            Double::difference(p.x, center.x),
            Double::difference(p.y, center.y),
        ]
    });
    let degree = count - 1;
    let radius = Double::difference(radius, 0.0);
    let minus_square = radius.times(radius).scaled(-1.0);
    let mut coefficients = [0.0; 7];
    for (k, coefficient) in coefficients.iter_mut().enumerate().take(2 * degree + 1) {
        let mut sum = minus_square.scaled(binomial(2 * degree, k));
        // The products of i with k - i and of k - i with i are the same.
        for i in k.saturating_sub(degree)..=k / 2 {
            let (p, q) = (points[i], points[k - i]);
            let dot = p[0].times(q[0]).plus(p[1].times(q[1]));
            let twice = if 2 * i == k { 1.0 } else { 2.0 };
            sum = sum.plus(dot.scaled(twice * binomial(degree, i) * binomial(degree, k - i)));
        }
        *coefficient = sum.value() / binomial(2 * degree, k);
    }
    Polynomial::new(&coefficients[..=2 * degree])
}

/// The nearest point of the true shape: the distance from there, and the unit normal there in the plane.
pub(crate) fn nearest(truth: &Truth, p: Point) -> Foot {
    let offset = p - truth.center;
    let axis = truth.axis;
    let own = foot(truth.radii, Vec2::new(offset.dot(axis), axis.cross(offset)));
    let outward = own.outward;
    Foot {
        distance: own.distance,
        outward: Vec2::new(
            outward.x * axis.x - outward.y * axis.y,
            outward.x * axis.y + outward.y * axis.x,
        ),
    }
}
