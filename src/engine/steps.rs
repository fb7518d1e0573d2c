//! How many steps an arc takes, and what all of them share.
//!
//! The count is found from below: the peak error of `minimax` is at least 1.29263358e-5 a⁶ at every angle a up to half a turn, and
//! its exact value decides whether one segment more is needed.

use kurbo::Vec2;

use crate::angle::first_direction;
use crate::error::{Error, MethodError, Remedy, Result};
use crate::joints::check_count;
use crate::method::{Method, Rule, Span};
use crate::number::digits::ROUNDING;
use crate::numeric::functions::larger;

/// (180/π)⁶ over 1.29263358e-5, the leading constant of `minimax`: its peak error falls to that times a⁶ as the angle a does.
const DEGREES_6: f64 = 2_736_909_018_401_684.5;

/// Half turns to a degree, less a trace that keeps rounding from adding a segment.
const HALF_TURNS: f64 = (1.0 - 1e-12) / 180.0;

/// The finest relative tolerance that differs from none at all.
const FINEST: f64 = 64.0 * f64::EPSILON;

/// Equal steps along an arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steps {
    pub(super) count: f64,
    /// sin δ, 1 - cos δ and the handle, of the sign of the sweep.
    pub(super) sine: f64,
    pub(super) versine: f64,
    pub(super) handle: f64,
    /// The peak of r² - 1.
    pub(super) square: f64,
}

impl Steps {
    /// The fewest `minimax` segments of this many degrees within a tolerance relative to the larger radius.
    #[inline(always)]
    pub(super) fn within(sweep: f64, tolerance: f64) -> Self {
        Self::of(sweep, Self::least(sweep, tolerance)).refined(sweep, tolerance)
    }

    /// As many as are needed at least. Without a branch, as [`Self::by_span`].
    #[inline(always)]
    pub(super) fn least(sweep: f64, tolerance: f64) -> f64 {
        let size = sweep.abs();
        let least = larger(
            size * inverse_sixth_root(tolerance * DEGREES_6),
            size * HALF_TURNS,
        );
        // Rounded up; what is a trace above a whole number is left to the exact error.
        larger(nearest(least + (0.5 - 1e-9)), 1.0)
    }

    /// As many more as the exact error asks for.
    #[inline(always)]
    pub(super) fn refined(mut self, sweep: f64, tolerance: f64) -> Self {
        while !self.serve(tolerance) {
            self = Self::of(sweep, self.count + 1.0);
        }
        self
    }

    /// Whether the curve is within the tolerance: r² - 1 = 2t + t² where r - 1 = t.
    #[inline(always)]
    pub(super) fn serve(&self, tolerance: f64) -> bool {
        let beyond = self.square > tolerance * (2.0 + tolerance);
        !beyond
    }

    #[inline(always)]
    fn of(sweep: f64, count: f64) -> Self {
        let quarter = Self::quarter(sweep, count);
        Self::by_quarter(sweep, count, first_direction(quarter))
    }

    /// A quarter of a step, in degrees.
    #[inline(always)]
    pub(super) fn quarter(sweep: f64, count: f64) -> f64 {
        0.25 * sweep.abs() / count
    }

    #[inline(always)]
    pub(super) fn by_quarter(sweep: f64, count: f64, quarter: Vec2) -> Self {
        let span = Span::of_quarter(Self::quarter(sweep, count), quarter);
        let (handle, square) = Method::minimax_with_square(&span);
        Self {
            count,
            sine: span.s.copysign(sweep),
            versine: span.versine(),
            handle: handle.copysign(sweep),
            square,
        }
    }

    /// So many by any rule, on an ellipse that is a circle or not.
    pub(super) fn by(rule: Rule, count: usize, sweep: f64, is_circle: bool) -> Result<Self> {
        check_count(count)?;
        let sees_ellipse = rule.method().is_some_and(Method::sees_ellipse);
        let span = Span::from_degrees(sweep / count as f64);
        let piece = rule.piece(&span)?;
        if piece.is_tangent_cubic() && (is_circle || !sees_ellipse) {
            let sign = 1.0_f64.copysign(sweep);
            return Ok(Self {
                count: count as f64,
                sine: sign * span.s,
                versine: span.versine(),
                handle: sign * piece.handle.y,
                square: 0.0,
            });
        }
        Err(Error::Impossible {
            method: rule.name(),
            why: MethodError::Handles,
            remedy: Remedy::Approximate,
        })
    }
}

/// A tolerance in user units as a part of the larger radius.
#[inline(always)]
pub(super) fn relative(tolerance: f64, radii: Vec2) -> f64 {
    larger(tolerance / larger(radii.x, radii.y), FINEST)
}

/// The nearest whole number to one below 2^51.
#[inline(always)]
pub(super) fn nearest(x: f64) -> f64 {
    (x + ROUNDING) - ROUNDING
}

/// x^(-1/6) of a positive number, up to 0.5 % too small and never too large: one step of Newton's method, which comes from below,
/// from the bits of the number, of which a sixth is a sixth of its logarithm but for some hundredths.
#[inline(always)]
fn inverse_sixth_root(x: f64) -> f64 {
    /// 2^32 / 6, rounded up.
    const SIXTH: u64 = 715_827_883;
    /// 7/6 of the bits of 1, less what centres the error.
    const BIAS: u64 = (0x3ff << 52) / 6 * 7 - (30 << 43);
    // A sixth of the upper half, by a product that processors have in lanes.
    let sixth = ((x.to_bits() >> 32) * SIXTH) & 0xffff_ffff_0000_0000;
    let guess = f64::from_bits(BIAS - sixth);
    let cube = guess * guess * guess;
    guess * (7.0 - x * (cube * cube)) * (1.0 / 6.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sixth_root_is_a_lower_bound() {
        for i in -14_000..5_000 {
            let x = 10_f64.powf(f64::from(i) / 1000.0);
            let ratio = inverse_sixth_root(x) * x.powf(1.0 / 6.0);
            assert!((0.995..1.0 + 1e-15).contains(&ratio), "{x} {ratio}");
        }
    }
}
