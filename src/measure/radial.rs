//! The signed distance of a curve from a circle or an ellipse: its extremes, from roots and never from sampling alone.
//!
//! In the frame where the true shape is a unit circle about the origin, |p(t)|² - 1 is a polynomial of degree 6 (4 for a
//! quadratic). Its coefficients are formed in twice the digits of `f64`, from the centre or, where an arc was given by its ends,
//! from those; so errors far below 1e-16 of the radius are stated as what they are. On a circle the extremes of the distance are
//! the roots of its derivative. On an ellipse the true distance along the normal is taken, from the nearest point.

mod ellipse;
mod far;
mod first;
mod framed;
mod known;
pub(crate) mod nearly;
mod part;
mod peaks;
mod place;
mod quick;
mod search;
mod settle;
mod slopes;
mod tangents;
mod twins;

pub(crate) use known::Known;

use core::iter;

use kurbo::{ParamCurve, PathSeg, Point, Vec2};

use self::framed::{FramedPoints, decimals_of};
use self::twins::Twins;
use super::curvature;
use crate::curve::{control_points, largest_coordinate};
use crate::numeric::adaptive_integral;
use crate::numeric::bernstein::{ParameterList, Polynomial};
use crate::numeric::double::Double;
use crate::numeric::foot::{Foot, foot};
use crate::numeric::instructions::by_the_best;
use crate::radial_error::RadialError;
use crate::shape::{Exact, Truth};

/// How far distances may be off that are formed in twice the digits, some 106 bits, as a part of the larger radius; a 0 is an exact one.
const NOISE: f64 = f64::EPSILON * f64::EPSILON * 1024.0;

/// The same of decimals, as a part of the largest coordinate.
const DECIMAL_NOISE: f64 = f64::EPSILON * f64::EPSILON * 64.0;

/// What the extremes of a cubic that touches a circle at its ends, nearly, and crosses it twice lie between: one beside each end, which
/// rounding moves to either side, and three lobes.
const BESIDE_EXTREMES: [f64; 8] = [-0.125, 0.0, 0.08, 0.34, 0.66, 0.92, 1.0, 1.125];

/// The largest distances of these segments from the true shape, both by the shortest decimals that read as their numbers, rounded outward:
/// docs/methods.md says how far they can be trusted.
#[must_use]
pub fn error<'a>(segments: impl IntoIterator<Item = &'a PathSeg>, truth: &Truth) -> RadialError {
    error_within(segments, truth, f64::INFINITY)
}

/// The same where they are within a limit; else those of the segments up to the first that is not.
pub(crate) fn error_within<'a>(
    segments: impl IntoIterator<Item = &'a PathSeg>,
    truth: &Truth,
    limit: f64,
) -> RadialError {
    let mut range = RadialError::default();
    let (mut known, mut twins) = (Known::default(), Twins::default());
    let exact = truth.frame.exact(truth.radii);
    for segment in segments {
        let Some(framed) = twins.without_twin(segment, truth, &exact, range.smaller()) else {
            continue;
        };
        let profile = Profile::framed(segment, truth, &exact, framed);
        profile.visit_bounds(&mut known, |_, bounds| range.take_in_all(bounds));
        if range.peak() > limit {
            break;
        }
    }
    range.with_more(twins.apart)
}

/// Whether they are within a limit: what is not beyond it needs no closer look.
pub(crate) fn is_within<'a>(
    segments: impl IntoIterator<Item = &'a PathSeg>,
    truth: &Truth,
    limit: f64,
) -> bool {
    let known = Known::within(limit / truth.larger_radius());
    peak_by(known, segments, truth)[1] <= limit
}

/// A lower and an upper bound of the peak, apart by a hundredth or better; beyond a limit, no more than that.
pub(crate) fn peak_nearly<'a>(
    segments: impl IntoIterator<Item = &'a PathSeg>,
    truth: &Truth,
    limit: f64,
) -> [f64; 2] {
    let known = Known::nearly(limit / truth.larger_radius());
    peak_by(known, segments, truth)
}

/// A lower and an upper bound of the peak of these segments and of what was known: infinite as soon as it is beyond the limit.
fn peak_by<'a>(
    mut known: Known,
    segments: impl IntoIterator<Item = &'a PathSeg>,
    truth: &Truth,
) -> [f64; 2] {
    let larger = truth.larger_radius();
    let exact = truth.frame.exact(truth.radii);
    let [mut least, mut most] = [0.0_f64; 2];
    for segment in segments {
        let profile = Profile::within(segment, truth, &exact);
        profile.visit_bounds(&mut known, |_, [low, high]| {
            least = least.max(low).max(-high);
            most = most.max(high).max(-low);
        });
        least = least.max(known.peak() * larger);
        if known.is_beyond() {
            return [least, f64::INFINITY];
        }
    }
    [least, most]
}

/// Visits the ends and every extreme of the signed distance of a segment as (t, distance), positive outside.
pub fn visit_extremes(segment: &PathSeg, truth: &Truth, visit: impl FnMut(f64, f64)) {
    Profile::new(segment, truth).visit_extremes(visit);
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
    /// What all of this was rounded from.
    framed: FramedPoints,
    exact: Exact,
    /// The direction of the first radius, as the images of that frame see it.
    axis: Vec2,
    largest_coordinate: f64,
}

impl Profile {
    pub(crate) fn new(segment: &PathSeg, truth: &Truth) -> Self {
        Self::within(segment, truth, &truth.frame.exact(truth.radii))
    }

    /// The same where the frame of the true shape is at hand.
    fn within(segment: &PathSeg, truth: &Truth, exact: &Exact) -> Self {
        let framed = FramedPoints::of_truth(&decimals_of(segment), truth, exact);
        Self::framed(segment, truth, exact, framed)
    }

    /// The same where the points are in that frame already.
    fn framed(segment: &PathSeg, truth: &Truth, exact: &Exact, framed: FramedPoints) -> Self {
        let excess = by_the_best(
            #[inline(always)]
            || framed.excess().scaled(exact.unit),
        );
        let axis = if exact.is_mapped() {
            truth.axis
        } else {
            Vec2::new(1.0, 0.0)
        };
        let turned = |v: Vec2| Vec2::new(v.dot(axis), axis.cross(v));
        let [x, y] = exact.center().map(Double::value);
        Self {
            own: framed.segment(exact, turned),
            center: turned(exact.image(Vec2::new(x, y))),
            radii: truth.radii * exact.grown,
            excess,
            framed,
            exact: *exact,
            axis,
            largest_coordinate: largest_coordinate([segment]),
        }
    }

    fn is_circle(&self) -> bool {
        self.radii.x == self.radii.y && !self.exact.is_conic
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

    /// Bounds of the distance from a circle that was found at t.
    ///
    /// At the ends the excess is one coefficient, with one rounding. Between them de Casteljau's algorithm makes at most three
    /// roundings in each of its steps, six for a cubic, of what the sizes of the coefficients would sum up to.
    fn bounds(&self, t: f64, distance: f64) -> [f64; 2] {
        let size = distance.abs();
        let mut margin = 4.0 * f64::EPSILON * size;
        if t > 0.0 && t < 1.0 {
            let rough = self.rounding(self.excess.largest());
            if rough > 1e-10 * size
                && let Some(bounds) = self.bounds_exactly(t)
            {
                return bounds;
            }
            // Beside the end t = 1 the place of an extreme is known to ε/2 only, and |F''| is at most 120 times the largest coefficient.
            margin += 16.0 * f64::EPSILON * rough;
            margin += if rough <= 1e-10 * size {
                rough
            } else {
                1e-11 * size + self.rounding(self.excess.sizes().at(t))
            };
            if distance < -0.5 * self.radii.x {
                margin += self.nearer(t);
            }
        }
        [distance - margin, distance + margin]
    }

    /// What the rounding of an excess that sums up to this does to the distance from a circle.
    fn rounding(&self, excess: f64) -> f64 {
        9.0 * f64::EPSILON * excess * 0.6 / self.radii.x
    }

    /// The same from the excess in twice the digits, where the coefficients are so large that de Casteljau's algorithm leaves nothing of
    /// it. One more step of Newton's method leads to a t from where the extreme is F'(t)² / |F''(t)| farther at most: up to there F'' stays
    /// above half of what it is, as |F'''| is at most 960 times the largest coefficient. `None` where F'' is too small for that.
    fn bounds_exactly(&self, t: f64) -> Option<[f64; 2]> {
        let at = |t: f64| self.framed.excess_at(t).map(|x| x * self.exact.unit);
        let bend = |t: f64| self.excess.derivative().derivative().at(t);
        let t = (t - at(t)[1] / bend(t)).clamp(0.0, 1.0);
        let ([excess, slope], bend, radius) = (at(t), bend(t).abs(), self.radii.x);
        let step = slope.abs() / bend;
        let is_flat = 4000.0 * self.excess.largest() * step <= bend;
        let distance = excess / (radius + (radius * radius + excess).sqrt());
        if !is_flat || distance.is_nan() || distance < -0.1 * radius {
            return None;
        }
        let margin = 0.6 * slope.abs() * step / radius + 4.0 * f64::EPSILON * distance.abs();
        Some([distance - margin, distance + margin])
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

    /// Visits places with what the distance there lies between for certain; the whole segment lies between the largest and the least, those
    /// included that were `known` before.
    pub(crate) fn visit_bounds(&self, known: &mut Known, mut visit: impl FnMut(f64, [f64; 2])) {
        let noise = NOISE * self.larger_radius().min(self.reach())
            + DECIMAL_NOISE * self.largest_coordinate
            + self.exact.unsure * self.larger_radius();
        let mut visit = |t: f64, [low, high]: [f64; 2]| {
            let beyond = |bound: f64| if bound > 0.0 { bound + noise } else { bound };
            visit(t, [-beyond(-low), beyond(high)]);
        };
        if self.is_circle() {
            self.visit_on_circle(|t, distance| visit(t, self.bounds(t, distance)));
        } else {
            peaks::visit(self, known, visit);
        }
    }

    /// How far the sums of which the excess is made reach, in all: about the end of a short chord of a circle nothing grows with the radius.
    fn reach(&self) -> f64 {
        if !self.is_circle() || self.exact.is_about_center() || self.exact.is_mapped() {
            return f64::INFINITY;
        }
        let sizes = control_points(&self.own)
            .into_iter()
            .map(|p| p.to_vec2().hypot());
        sizes.fold(self.exact.chord_size(), f64::max) * 2.0
    }

    fn visit_on_circle(&self, mut visit: impl FnMut(f64, f64)) {
        let slope = self.excess.differences();
        let turning = slope.sign_changes_between(&BESIDE_EXTREMES);
        let turning = turning.unwrap_or_else(|| slope.sign_changes());
        for t in iter::once(0.0).chain(turning.iter()).chain(iter::once(1.0)) {
            visit(t, self.distance_from_circle(t));
        }
    }

    /// Where it changes its sign.
    pub(crate) fn crossings(&self) -> ParameterList {
        self.excess.sign_changes()
    }

    /// Where it crosses the long axis of an ellipse: there the nearest point jumps to the other side, and the distance has a corner.
    fn axis_crossings(&self) -> ParameterList {
        let across = |v: Vec2| {
            if self.radii.x > self.radii.y {
                v.y
            } else {
                v.x
            }
        };
        let coordinates: Vec<f64> = control_points(&self.own)
            .iter()
            .map(|p| across(p.to_vec2() - self.center))
            .collect();
        Polynomial::new(&coordinates).sign_changes()
    }

    /// The integral of f(t, |distance|) over t, with a joint wherever the distance changes its sign or has a corner.
    pub(crate) fn integral(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        let value = |t: f64| f(t, self.at(t).abs());
        let noise = f64::EPSILON / 16.0 * self.larger_radius();
        let mut joints = vec![0.0, 1.0];
        joints.extend(self.crossings().iter());
        if !self.is_circle() {
            joints.extend(self.axis_crossings().iter());
        }
        joints.sort_by(f64::total_cmp);
        joints
            .windows(2)
            .map(|pair| adaptive_integral(&value, pair[0], pair[1], noise))
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

#[cfg(test)]
mod checks;
