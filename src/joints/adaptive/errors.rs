//! How far a method's segments stray from an ellipse: quickly, and right to first order at least.

use core::cell::RefCell;

use kurbo::{ParamCurve, Point, Vec2};

use crate::angle::Angle;
use crate::method::{Law, Method, Rule, Span, ellipse};
use crate::numeric::foot::foot_in_unit;
use crate::numeric::functions::power;
use crate::numeric::{self, root};

/// The parts into which a segment is cut to look for its peak; the peak between two samples follows from a parabola.
const SAMPLES: usize = 12;
/// The same of an equioscillating one, whose outer lobes are narrow: its parts become smaller towards the ends.
const EQUIOSCILLATING_SAMPLES: usize = 16;

/// A smaller radial error drowns in the rounding of samples; the formula tells it, at the extremes of the error on the circle.
const NOISE: f64 = 1e-11;
const LOBES: [f64; 3] = [0.18, 0.5, 0.82];
/// Those of the Chebyshev polynomial of degree 6, stretched to vanish at both ends.
const EQUIOSCILLATING_LOBES: [f64; 5] = [0.052, 0.241, 0.5, 0.759, 0.948];

/// Where the error is a larger part of the smallest radius of curvature than this, the first order is too rough, and the error
/// no longer grows with the length of a segment alone.
const FIRST_ORDER: f64 = 1e-4;

/// Of flatter ellipses the first order tells too little beside the sharp ends where lobes are narrow: there the nearest point is taken.
const FLAT: f64 = 0.25;

/// Flatter ellipses have sharp ends.
const SHARP: f64 = 0.03;

#[cfg(test)]
thread_local! {
    /// How often a segment was looked at: what a search costs, to one who counts.
    pub(crate) static LOOKS: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

/// The ratio of the lengths of short segments whose errors are computed: between them a power tells them, but for a part of the square of
/// such a length.
const STEP: f64 = 1.1;

/// A method on an ellipse. Angles count from an end of its short axis.
#[derive(Clone)]
pub(super) struct Errors {
    rule: Rule,
    /// That of its error on the circle.
    law: Law,
    /// The logarithms of the errors of short segments on the circle, by the power of [`STEP`] that is their length in degrees: with some methods
    /// they would cost most of a search.
    short_ones: RefCell<Vec<(i32, f64)>>,
    /// The smaller radius over the larger one.
    short: f64,
    /// w(θ)^-2 = 1 + swing cos² θ, over the larger radius.
    swing: f64,
    /// Whether a piece costs no search.
    is_quick: bool,
}

impl Errors {
    pub(super) fn new(rule: Rule, law: Law, short: f64) -> Self {
        Self {
            rule,
            law,
            short_ones: RefCell::default(),
            short,
            swing: (1.0 - short) * (1.0 + short) / (short * short),
            is_quick: matches!(
                rule,
                Rule::Method(
                    Method::Midpoint
                        | Method::Minimax
                        | Method::Goldapp
                        | Method::Curvature
                        | Method::Apprich
                        | Method::Area
                        | Method::Chen3
                )
            ),
        }
    }

    /// Whether the ellipse is that flat.
    pub(super) fn is_sharp(&self) -> bool {
        self.short < SHARP
    }

    /// Whether a piece costs no search.
    pub(super) const fn is_quick(&self) -> bool {
        self.is_quick
    }

    /// Whether the circle tells nothing of its pieces.
    pub(super) fn sees_ellipse(&self) -> bool {
        self.rule.method().is_some_and(Method::sees_ellipse)
    }

    fn is_equioscillating(&self) -> bool {
        self.rule == Rule::Method(Method::MinimaxG0)
    }

    /// The error of a segment of `size` degrees on the unit circle.
    pub(super) fn on_circle(&self, size: f64) -> f64 {
        let error = self.rule.radial_error(&Span::from_degrees(size));
        error.map_or(f64::INFINITY, |error| error.peak())
    }

    /// The same of a short one, nearly.
    fn of_short(&self, size: f64) -> f64 {
        let place = libm::log(size) / libm::log(STEP);
        let before = place.floor();
        let [low, high] = [0, 1].map(|i| self.logarithm_at(before as i32 + i));
        libm::exp(low + (high - low) * (place - before))
    }

    fn logarithm_at(&self, place: i32) -> f64 {
        let mut known = self.short_ones.borrow_mut();
        if let Some((_, error)) = known.iter().find(|(own, _)| *own == place) {
            return *error;
        }
        let error = libm::log(self.on_circle(power(STEP, place)));
        known.push((place, error));
        error
    }

    /// The error of a segment of `size` degrees that begins `from` degrees after the short axis, over the larger radius.
    pub(super) fn of(&self, from: f64, size: f64) -> f64 {
        #[cfg(test)]
        LOOKS.set(LOOKS.get() + 1);
        if self.rule == Rule::Method(Method::MinimaxEllipse) {
            return ellipse::peak(self.short, from, size).unwrap_or(f64::INFINITY);
        }
        let span = Span::from_degrees(size);
        if self.law.constant * power(span.a, i32::from(self.law.order)) < NOISE {
            let lobes = if self.is_equioscillating() {
                &EQUIOSCILLATING_LOBES[..]
            } else {
                &LOBES
            };
            let weights = lobes.iter().map(|part| self.weight(from + part * size));
            return self.of_short(size) * weights.fold(0.0, f64::max);
        }
        let Ok(piece) = self.rule.piece(&span) else {
            return f64::INFINITY;
        };
        let ends = [from, from + size].map(|degrees| Angle::from_degrees(degrees).direction());
        let segment = piece.between(ends);
        let mut errors = [0.0; EQUIOSCILLATING_SAMPLES + 1];
        let (errors, place): (_, fn(usize) -> f64) = if self.is_equioscillating() {
            (&mut errors[..], |i| {
                let part = i as f64 / EQUIOSCILLATING_SAMPLES as f64;
                part * part * (3.0 - 2.0 * part)
            })
        } else {
            (&mut errors[..=SAMPLES], |i| i as f64 / SAMPLES as f64)
        };
        let last = errors.len() - 1;
        let (mut before, mut tip) = (segment.start().x, 0.0_f64);
        for (i, error) in errors.iter_mut().enumerate().skip(1) {
            let t = place(i);
            let point = segment.eval(t);
            if i < last {
                *error = self.strays(point);
            }
            // Where the curve passes a sharp end the distance has a peak that falls between samples.
            if (before > 0.0) != (point.x > 0.0) {
                let crossing = root(|t| segment.eval(t).x, place(i - 1), t);
                tip = tip.max(self.strays(segment.eval(crossing)));
            }
            before = point.x;
        }
        peak(errors).max(tip)
    }

    /// w at this many degrees, over the larger radius.
    fn weight(&self, degrees: f64) -> f64 {
        let cos = libm::cos(degrees.to_radians());
        (1.0 + self.swing * cos * cos).sqrt().recip()
    }

    /// How far a point in the frame where the ellipse is the unit circle, its short axis along x, lies from the ellipse.
    fn strays(&self, point: Point) -> f64 {
        let square = point.to_vec2().hypot2();
        // r - 1 by r² - 1, which keeps its digits.
        let radial = (square - 1.0).abs() / (square.sqrt() + 1.0);
        if self.short >= FLAT || !self.is_equioscillating() {
            return radial / (1.0 + self.swing * (point.x * point.x) / square).sqrt();
        }
        let (radii, squares) = (Vec2::new(self.short, 1.0), [1.0 + self.swing, 1.0]);
        let place = Vec2::new(self.short * point.x, point.y);
        let foot = foot_in_unit(radii, squares, place, square - 1.0);
        foot.foot.distance.abs()
    }

    /// Whether the first order does not tell errors of this size, over the larger radius.
    pub(super) fn is_rough(&self, error: f64) -> bool {
        error > FIRST_ORDER * self.short * self.short
    }

    /// The same, where the method's formula is short enough to find out.
    pub(super) fn is_worth_a_look(&self, error: f64) -> bool {
        self.is_quick && self.is_rough(error)
    }
}

/// The largest of evenly spaced samples of a smooth curve, by the parabola through it and its neighbours.
fn peak(samples: &[f64]) -> f64 {
    let highest = samples
        .iter()
        .copied()
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((i, top)) = highest else {
        return 0.0;
    };
    let (Some(before), Some(after)) = (
        i.checked_sub(1).and_then(|i| samples.get(i)),
        samples.get(i + 1),
    ) else {
        return top;
    };
    numeric::top([*before, top, *after])
}

#[cfg(test)]
mod tests;
