//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64, so the condition is an equation in w0.
//! Its root lies just beside Goldapp's, which is its limit for a -> 0: the difference is a⁶ times a smooth even function of the
//! angle, and [`SERIES`] gives that to the last digit of the handle for every angle up to half a turn.

use crate::angle::sum;
use crate::measure::RadialError;

use super::Span;
use super::tangent::{GOLDAPP_ZERO, family, family_error};

/// (w0 - Goldapp's)/a⁶ as a polynomial in a²: the interpolant at nine Chebyshev nodes of [0, π²], computed with 50 digits (derived).
const SERIES: [f64; 9] = [
    1.009_961_750_375_190_3e-6,
    3.342_106_820_215_351_7e-9,
    2.613_372_139_738_243_4e-10,
    -3.430_729_816_030_358_5e-13,
    6.911_014_295_624_221e-14,
    -5.128_918_902_845_118e-16,
    2.138_371_083_961_575_6e-17,
    -2.391_824_297_955_729_7e-19,
    4.709_263_297_951_557_6e-21,
];

pub(super) fn handle(span: &Span) -> f64 {
    family(span, zero(span))
}

pub(super) fn error(span: &Span) -> RadialError {
    RadialError::balanced(family_error(span, zero(span)).peak())
}

/// The handle and the peak of r² - 1, which saves the roots of an error that is only compared.
#[inline]
pub(super) fn handle_with_square(span: &Span) -> (f64, f64) {
    let w0 = zero(span);
    let k = family(span, w0);
    // G by the handle, which is at hand; it cancels at small angles, by 1e-11 at a degree.
    let y = 3.0 * k * span.ch - 2.0 * span.sh;
    (k, y * y * (w0 * w0 * w0 * (1.0 / 108.0)))
}

/// The value of v = 4t(1-t) at which the balanced curve crosses the circle.
#[inline]
fn zero(span: &Span) -> f64 {
    let square = span.a * span.a;
    let [first, rest @ ..] = SERIES;
    GOLDAPP_ZERO + square * square * square * (first + square * sum(square, rest))
}

#[cfg(test)]
mod tests {
    use super::super::{
        numeric,
        tangent::{big_g, root_minus_1},
    };
    use super::*;

    /// The root of the condition by search.
    fn searched(span: &Span) -> f64 {
        let unbalance = |w0: f64| {
            let g = big_g(span, w0);
            // Divided by G, which only scales it.
            (root_minus_1(g * w0.powi(3) / 432.0) + root_minus_1(-g * (1.0 - w0) / 64.0)) / g
        };
        numeric::root_near(unbalance, GOLDAPP_ZERO, 1e-3, 0.0, 1.0)
    }

    #[test]
    fn the_series_is_the_root_at_every_angle() {
        for i in 1..=3600 {
            let span = Span::from_degrees(f64::from(i) * 0.05);
            let (ours, theirs) = (handle(&span), family(&span, searched(&span)));
            assert!(
                (ours / theirs - 1.0).abs() <= 4.5e-16,
                "{ours} against {theirs} at {} degrees",
                span.degrees()
            );
        }
    }

    #[test]
    fn tiny_angles_keep_every_digit() {
        for exponent in 0..=24 {
            let a = 1e-6 * 10_f64.powf(f64::from(exponent) / 4.0);
            let span = Span::from_degrees(a.to_degrees());
            // k = a/3 + a³/144 + O(a⁵), 2e-6 a⁵ above by the leading terms of the family
            let series = a / 3.0 * (1.0 + a * a / 48.0);
            assert!(
                (handle(&span) / series - 1.0).abs() < 1e-15 + a.powi(4) / 1000.0,
                "{a}"
            );
        }
    }
}
