//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64, so the condition is an equation in w0.
//! Its root lies just beside Goldapp's, which is its limit for a -> 0; the handle depends on w0 only weakly, so that an error of
//! the root in its last digits does not reach the handle's.

use crate::measure::RadialError;

use super::Span;
use super::numeric;
use super::tangent::{big_g, family, family_error, goldapp_zero, root_minus_1};

pub(super) fn handle(span: &Span) -> f64 {
    family(span, zero(span))
}

pub(super) fn error(span: &Span) -> RadialError {
    RadialError::balanced(family_error(span, zero(span)).peak())
}

/// The value of v = 4t(1-t) at which the balanced curve crosses the circle.
fn zero(span: &Span) -> f64 {
    let unbalance = |w0: f64| {
        let g = big_g(span, w0);
        // Divided by G, which only scales it.
        (root_minus_1(g * w0.powi(3) / 432.0) + root_minus_1(-g * (1.0 - w0) / 64.0)) / g
    };
    let limit = goldapp_zero();
    numeric::root_near(unbalance, limit, 1e-3, 0.0, 1.0)
}
