//! The signed distance of a curve from a circle or an ellipse: its extremes, from roots and never from sampling alone.
//!
//! In the frame where the true shape is a unit circle about the origin, |p(t)|² - 1 is a polynomial of degree 6 (4 for a
//! quadratic). Its coefficients are formed in twice the digits of `f64`, from the centre or, where an arc was given by its ends,
//! from those; so errors far below 1e-16 of the radius are stated as what they are. On a circle the extremes of the distance are
//! the roots of its derivative. On an ellipse the true distance along the normal is taken, from the nearest point.

mod ellipse;
pub(crate) mod nearly;
mod search;

pub(crate) use search::visit_between;

use core::iter;

use kurbo::{CubicBez, Line, ParamCurve, PathSeg, Point, QuadBez, Vec2};

use crate::numeric::adaptive_integral;
use crate::numeric::bernstein::{Parameters, Polynomial, binomial};
use crate::numeric::double::Double;
use crate::numeric::foot::{Foot, foot};
use crate::radial_error::RadialError;
use crate::shape::Truth;

/// The largest distances of these segments from the true shape, rounded outward: docs/methods.md says how far they can be trusted.
#[must_use]
pub fn error<'a>(segments: impl IntoIterator<Item = &'a PathSeg>, truth: &Truth) -> RadialError {
    let mut range = RadialError::default();
    for segment in segments {
        let profile = Profile::new(segment, truth);
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
    points: [[Double; 2]; 4],
    /// What is added to the dot products: minus the square of the radius, or the pencil's linear part at each point.
    levels: [Double; 4],
    count: usize,
    /// The other end of the chord.
    chord: Vec2,
    center: Vec2,
}

impl FramedPoints {
    /// The frame's unit is the user's for a circle; for an ellipse it makes both radii 1.
    fn new(segment: &PathSeg, truth: &Truth) -> Self {
        let (points, count) = match *segment {
            PathSeg::Line(l) => ([l.p0, l.p1, l.p1, l.p1], 2),
            PathSeg::Quad(q) => ([q.p0, q.p1, q.p2, q.p2], 3),
            PathSeg::Cubic(c) => ([c.p0, c.p1, c.p2, c.p3], 4),
        };
        let origin = truth.pencil.map_or(truth.center, |pencil| pencil.from);
        let framed = |p: Point| {
            let (x, y) = (
                Double::difference(p.x, origin.x),
                Double::difference(p.y, origin.y),
            );
            if truth.is_circle() {
                return [x, y];
            }
            let Vec2 { x: cos, y: sin } = truth.axis;
            [
                x.scaled(cos).plus(y.scaled(sin)).over(truth.radii.x),
                y.scaled(cos).plus(x.scaled(-sin)).over(truth.radii.y),
            ]
        };
        let points = points.map(framed);
        let Some(pencil) = truth.pencil else {
            let radius = if truth.is_circle() {
                truth.radii.x
            } else {
                1.0
            };
            let radius = Double::difference(radius, 0.0);
            return Self {
                points,
                levels: [radius.times(radius).scaled(-1.0); 4],
                count,
                chord: Vec2::ZERO,
                center: Vec2::ZERO,
            };
        };
        let chord = framed(pencil.to);
        let level = |[x, y]: [Double; 2]| {
            let across = x.times(chord[1]).plus(y.times(chord[0]).scaled(-1.0));
            let along = x.times(chord[0]).plus(y.times(chord[1]));
            across.scaled(pencil.cotangent).plus(along.scaled(-1.0))
        };
        let half = Vec2::new(chord[0].value(), chord[1].value()) / 2.0;
        Self {
            points,
            levels: points.map(level),
            count,
            chord: 2.0 * half,
            // The inscribed angle's cotangent is the centre's distance from the chord over half of that.
            center: half + Vec2::new(-half.y, half.x) * pencil.cotangent,
        }
    }

    /// How far rounding of the numbers that tell the true shape may move it beside these points.
    fn slack(&self, truth: &Truth) -> f64 {
        let mut slack = truth.rounding;
        if let Some(pencil) = truth.pencil {
            // cot' = -(1 + cot²); half the sweep is off by a few roundings of its own, and at a right angle by one.
            let cotangent = pencil.cotangent;
            let half = libm::atan2(1.0, cotangent.abs());
            let rounding = if cotangent == 0.0 {
                0.0
            } else {
                f64::EPSILON * (2.0 * half).min(1.5) * (1.0 + cotangent * cotangent)
            };
            let chord = self.chord;
            let across = self
                .points
                .iter()
                .take(self.count)
                .fold(0.0, |most, [x, y]| {
                    f64::max(most, (x.value() * chord.y - y.value() * chord.x).abs())
                });
            slack += rounding * across * distance_of_excess(truth.radii);
        }
        slack
    }

    /// |p(t)|² - radius² about the centre.
    fn excess(&self) -> Polynomial {
        let degree = self.count - 1;
        let mut coefficients = [0.0; 7];
        for (k, coefficient) in coefficients.iter_mut().enumerate().take(2 * degree + 1) {
            let mut sum = Double::difference(0.0, 0.0);
            // The terms of i with k - i and of k - i with i are the same.
            for i in k.saturating_sub(degree)..=k / 2 {
                let (p, q) = (self.points[i], self.points[k - i]);
                let level = self.levels[i].plus(self.levels[k - i]).scaled(0.5);
                let term = p[0].times(q[0]).plus(p[1].times(q[1])).plus(level);
                let twice = if 2 * i == k { 1.0 } else { 2.0 };
                sum = sum.plus(term.scaled(twice * binomial(degree, i) * binomial(degree, k - i)));
            }
            *coefficient = sum.over(binomial(2 * degree, k)).value();
        }
        Polynomial::new(&coefficients[..=2 * degree])
    }

    /// The segment about the origin of the frame, along the axes of the true shape, its radii as large as these.
    fn segment(&self, radii: Vec2) -> PathSeg {
        let [p0, p1, p2, p3] = self
            .points
            .map(|[x, y]| Point::new(x.value() * radii.x, y.value() * radii.y));
        match self.count {
            2 => PathSeg::Line(Line::new(p0, p1)),
            3 => PathSeg::Quad(QuadBez::new(p0, p1, p2)),
            _ => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
        }
    }
}

/// The most that the distance grows with the excess: half, over the radius of a circle, or times the larger radius where the
/// excess is that of the unit frame; a little more inside, up to a quarter of the radius.
fn distance_of_excess(radii: Vec2) -> f64 {
    if radii.x == radii.y {
        0.6 / radii.x
    } else {
        0.6 * radii.x.max(radii.y)
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
    /// How far the true shape that is meant may lie from the one that is measured against.
    slack: f64,
    /// Whether the axes are not level, so that the direction of the first is rounded.
    is_turned: bool,
}

impl Profile {
    pub(crate) fn new(segment: &PathSeg, truth: &Truth) -> Self {
        let framed = FramedPoints::new(segment, truth);
        let unit = if truth.is_circle() {
            Vec2::new(1.0, 1.0)
        } else {
            truth.radii
        };
        Self {
            own: framed.segment(unit),
            center: Vec2::new(framed.center.x * unit.x, framed.center.y * unit.y),
            radii: truth.radii,
            excess: framed.excess(),
            slack: framed.slack(truth),
            is_turned: !truth.is_circle() && truth.axis.x != 0.0 && truth.axis.y != 0.0,
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

    /// Between what the distance that was found at t lies for certain.
    ///
    /// At the ends the excess is one coefficient, with one rounding. Between them de Casteljau's algorithm makes at most two
    /// roundings in each of its steps, six for a cubic, of what the sizes of the coefficients would sum up to; and the place of an
    /// extreme on an ellipse, or of one that is tiny beside the others, is known to some six digits, where the distance is flat.
    /// `knows_excess` says that the distance came from the excess, and not from the coordinates.
    fn bounds(&self, t: f64, distance: f64, knows_excess: bool) -> [f64; 2] {
        let size = distance.abs();
        let is_circle = self.is_circle();
        let mut margin = 4.0 * f64::EPSILON * size + self.slack;
        if !is_circle {
            margin += 1e-11 * size;
        }
        if self.is_turned {
            margin += f64::EPSILON / 2.0 * self.own.eval(t).to_vec2().hypot();
        }
        if !knows_excess {
            // The nearest point then comes from the coordinates, each with the rounding of a few steps.
            let smaller = self.radii.x.min(self.radii.y);
            margin += 2.0 * f64::EPSILON * (self.arm(t).hypot() + 4.0 * smaller);
        } else if t > 0.0 && t < 1.0 {
            let unit = distance_of_excess(self.radii);
            let rounding = |excess: f64| 6.0 * f64::EPSILON * excess * unit;
            let rough = rounding(self.excess.largest());
            margin += if rough <= 1e-10 * size {
                rough
            } else {
                1e-11 * size + rounding(self.excess.sizes().at(t))
            };
        }
        [distance - margin, distance + margin]
    }

    /// Visits the ends and every extreme of the signed distance as (t, distance), positive outside.
    pub(crate) fn visit_extremes(&self, mut visit: impl FnMut(f64, f64)) {
        if self.is_circle() {
            self.visit_on_circle(visit);
        } else if let Some(turning) = self.sampson() {
            self.visit_near(&turning, &mut visit);
        } else {
            self.visit_far(&mut visit);
        }
    }

    /// The same with what the distance lies between for certain.
    pub(crate) fn visit_bounds(&self, mut visit: impl FnMut(f64, [f64; 2])) {
        let mut known = |t, distance| visit(t, self.bounds(t, distance, true));
        if self.is_circle() {
            self.visit_on_circle(known);
        } else if let Some(turning) = self.sampson() {
            self.visit_near(&turning, &mut known);
        } else {
            self.visit_far(&mut |t, distance| {
                visit(t, self.bounds(t, distance, self.foot_near(t).is_some()));
            });
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
    let outward = own.outward;
    Foot {
        outward: Vec2::new(
            outward.x * axis.x - outward.y * axis.y,
            outward.x * axis.y + outward.y * axis.x,
        ),
        ..own
    }
}
