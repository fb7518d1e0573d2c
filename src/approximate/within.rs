//! Whether a curve is within a tolerance as it is written.

use kurbo::PathSeg;

use super::{Request, Sketch};
use crate::curve::Curve;
use crate::measure::radial;
use crate::measure::radial::nearly::{bound, circle_decided, closer_bound, nearly};
use crate::number::Precision;
use crate::shape::Truth;

/// How far above the peak a bound by few samples lies, at most and mostly.
const LOOSE: f64 = 1.15;

/// From how many roundings of a coordinate on a tolerance may be less by one.
const ROUNDINGS: f64 = 1e3;

/// Whether a curve of this peak error before rounding is within the tolerance as it is written; `None` where rounding decides.
pub(crate) fn by_formula(
    peak: f64,
    precision: Precision,
    reach: f64,
    tolerance: f64,
) -> Option<bool> {
    let Precision::Fixed(_) = precision else {
        return None;
    };
    let moved = precision.farthest_moved() + 8.0 * f64::EPSILON * reach;
    if peak + moved <= tolerance {
        return Some(true);
    }
    (peak - moved > tolerance).then_some(false)
}

/// Whether a curve is within a tolerance of a circle whose centre is given.
pub(crate) fn of_circle(segments: &[PathSeg], truth: &Truth, tolerance: f64) -> bool {
    circle_decided(segments, truth, tolerance)
        .unwrap_or_else(|| radial::error_within(segments, truth, tolerance).peak() <= tolerance)
}

impl Request<'_> {
    /// Whether the curve as it is written is within the tolerance; measured only where rounding decides.
    pub(super) fn is_within(&self, sketch: &mut Sketch, tolerance: f64) -> bool {
        if let Some(peak) = sketch.peak
            && let Some(is_within) = by_formula(peak, sketch.precision, self.reach(), tolerance)
        {
            return is_within;
        }
        let curve = sketch.rounded();
        let is_within = self
            .by_bounds(&curve.segments, tolerance)
            .unwrap_or_else(|| self.is_within_for_certain(sketch, &curve, tolerance));
        if is_within {
            sketch.written = Some(curve);
        }
        is_within
    }

    /// The same by few samples, and then by many, where they tell.
    pub(super) fn by_bounds(&self, curve: &[PathSeg], tolerance: f64) -> Option<bool> {
        let truth = &self.outline.truth;
        let segments = || curve.iter().copied();
        // A centre that follows from given ends is known to half the digits at worst.
        let knows_center = self.outline.ends.is_none() || tolerance > 1e-6 * self.reach();
        if truth.is_circle() {
            return knows_center
                .then(|| circle_decided(curve, truth, tolerance))
                .flatten();
        }
        let is_certain = |most: f64| knows_center && most <= tolerance;
        let most = bound(segments(), truth);
        if is_certain(most) {
            return Some(true);
        }
        if nearly(segments(), truth).is_some_and(|[low, _]| low > tolerance) {
            return Some(false);
        }
        let is_bounded = is_certain(most / LOOSE) && is_certain(closer_bound(segments(), truth));
        is_bounded.then_some(true)
    }

    /// The same by the distance itself.
    pub(super) fn is_within_for_certain(
        &self,
        sketch: &mut Sketch,
        curve: &Curve,
        tolerance: f64,
    ) -> bool {
        let truth = &self.outline.truth;
        let rounding = 8.0 * f64::EPSILON * self.reach();
        if truth.is_circle() || tolerance < ROUNDINGS * rounding {
            let error = radial::error_within(&curve.segments, truth, tolerance);
            sketch.measured = Some(error);
            return error.peak() <= tolerance;
        }
        // What is stated of it afterwards must not be beyond by its rounding.
        let limit = tolerance * (1.0 - 1e-9) - rounding;
        radial::is_within(&curve.segments, truth, limit)
    }
}
