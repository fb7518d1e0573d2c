//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64. With r = `r_mid` the condition is a cubic in w0,
//!
//! ```text
//! 4 w0³ = 27 ρ (1 - w0),   ρ = (3 - r)/(1 + r)
//! ```
//!
//! in which ρ is 1 for a -> 0, so that Goldapp's zero is the limit, and depends on w0 only weakly, by about G/128: with that slope each of
//! Newton's steps leaves less than a thousandth of itself at half a turn and a hundred-thousandth at a quarter.

use crate::measure::RadialError;

use super::Span;
use super::tangent::{GOLDAPP_ZERO, big_g, family, family_error, root_minus_1};

/// The steps end with one that is smaller than this: what it leaves of the root is far below the last digit of the handle.
const SMALLEST_STEP: f64 = 3e-11;

/// At most so many steps; half a turn takes four, a quarter three.
const MOST_STEPS: usize = 8;

pub(super) fn handle(span: &Span) -> f64 {
    family(span, zero(span))
}

pub(super) fn error(span: &Span) -> RadialError {
    RadialError::balanced(family_error(span, zero(span)).peak())
}

/// The value of v = 4t(1-t) at which the balanced curve crosses the circle.
fn zero(span: &Span) -> f64 {
    let mut w0 = GOLDAPP_ZERO;
    for _ in 0..MOST_STEPS {
        let g = big_g(span, w0);
        let depth = -root_minus_1(-g * (1.0 - w0) / 64.0); // 1 - r
        let rho = (2.0 + depth) / (2.0 - depth);
        let square = w0 * w0;
        let miss = 4.0 * w0 * square - 27.0 * rho * (1.0 - w0);
        let slope = 12.0 * square + 27.0 * (rho + (1.0 - w0) * g / 128.0);
        let step = miss / slope;
        w0 -= step;
        if step.abs() <= SMALLEST_STEP {
            break;
        }
    }
    w0
}
