//! How many decimals a curve deserves.

use kurbo::{PathSeg, Point, Vec2};

use super::Options;
use super::segments::Beziers;
use crate::approximate::ROUNDING_SHARE;
use crate::joints::adaptive;
use crate::measure::radial::{self, nearly::decided};
use crate::method::Rule;
use crate::number::Precision;
use crate::number::decimal::MAX_DECIMALS;
use crate::shape::{Axes, Truth};

/// Equal pieces of the unit circle that a curve is the image of.
pub(super) struct Pieces<F> {
    /// Their peak error.
    pub(super) error: f64,
    pub(super) axes: Axes,
    pub(super) count: usize,
    /// Their size in degrees, with the sign of their direction.
    pub(super) size: f64,
    /// The angle that each runs from.
    pub(super) from: F,
}

impl<F: Fn(usize) -> f64> Pieces<F> {
    /// Between what the peak error lies on an ellipse of this larger radius, by their lobes.
    fn between(&self, rule: Rule, larger: f64, largest: f64) -> Option<[f64; 2]> {
        let pieces = (0..self.count).map(|i| ((self.from)(i), self.size.abs()));
        let sizes = [larger, larger + largest];
        adaptive::nearly(rule, self.axes, sizes, 1.0_f64.copysign(self.size), pieces)
    }
}

/// The decimals for the control points: those asked for, or the fewest d for which 10^-d/√2 is at most a tenth of the peak error.
/// The curve begins at `start`; that and its points are offsets from `base`.
pub(super) fn decimals(
    truth: &Truth,
    start: Vec2,
    base: Point,
    pieces: &Pieces<impl Fn(usize) -> f64>,
    options: &Options,
    drawn: &Beziers,
) -> u32 {
    if let Some(decimals) = options.precision {
        return most(Precision::Fixed(decimals));
    }
    let size = |p: &Vec2| (base.x + p.x).abs().max((base.y + p.y).abs());
    let largest = drawn
        .points()
        .iter()
        .map(size)
        .fold(f64::MIN_POSITIVE, f64::max);
    if truth.is_circle() {
        return fewest(pieces.error * truth.radii.x, largest);
    }
    let segments = || drawn.path_segments(base + start, |offset| base + offset);
    let told = pieces.between(options.rule, truth.larger_radius(), largest);
    decided(told, segments, truth, |peak| fewest(peak, largest)).unwrap_or_else(|| {
        let segments: Vec<PathSeg> = segments().collect();
        fewest(radial::error(&segments, truth).peak(), largest)
    })
}

/// The fewest decimals for this peak error; no more than coordinates up to `largest` have digits.
fn fewest(peak: f64, largest: f64) -> u32 {
    most(Precision::moving_at_most(ROUNDING_SHARE * peak, largest))
}

/// The decimals of a precision, as many as a number is given.
pub(super) fn most(precision: Precision) -> u32 {
    match precision {
        Precision::Fixed(decimals) => u32::from(decimals).min(MAX_DECIMALS),
        Precision::Full => MAX_DECIMALS,
    }
}
