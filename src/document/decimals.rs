//! How many decimals a curve deserves.

use kurbo::{PathSeg, Point, Vec2};

use super::Options;
use super::segments::Beziers;
use crate::approximate::ROUNDING_SHARE;
use crate::measure::radial::{self, nearly::nearly};
use crate::number::Precision;
use crate::number::decimal::MAX_DECIMALS;
use crate::shape::Truth;

/// The decimals for the control points: those asked for, or the fewest d for which 10^-d/√2 is at most a tenth of the peak error.
/// The curve begins at `start`; that and its points are offsets from `base`. On the unit circle its peak error is `error`.
pub(super) fn decimals(
    truth: &Truth,
    start: Vec2,
    base: Point,
    error: f64,
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
        return fewest(error * truth.radii.x, largest);
    }
    let segments = || drawn.path_segments(base + start, |offset| base + offset);
    if let Some([low, high]) = nearly(segments(), truth).between {
        let most = fewest(low, largest);
        if most == fewest(high, largest) {
            return most;
        }
    }
    let segments: Vec<PathSeg> = segments().collect();
    fewest(radial::error(&segments, truth).peak(), largest)
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
