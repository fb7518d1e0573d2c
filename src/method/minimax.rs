//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64. With r = `r_mid` the condition is a cubic in w0,
//!
//! ```text
//! 4 w0³ = 27 ρ (1 - w0),   ρ = (3 - r)/(1 + r)
//! ```
//!
//! in which ρ is 1 for a -> 0, so that Goldapp's zero is the limit, and depends on w0 only weakly, by about G/128. With that slope a
//! step of Newton's method leaves about 1 - r of itself, and the handle heeds w0 no more than 34 (1 - r): the steps end where what
//! they leave is beyond its last digit.

use crate::measure::RadialError;

use super::Span;
use super::tangent::{GOLDAPP_ZERO, big_g, family, family_error, root_minus_1};

/// The steps end where one times (1 - r)², which bounds what it leaves in the handle, is smaller: two digits beyond the handle's last.
const HANDLE_TOLERANCE: f64 = 1e-18;

/// At most so many steps; half a turn takes four, a quarter two.
const MOST_STEPS: usize = 8;

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
    (family(span, w0), big_g(span, w0) * (w0 * w0 * w0 / 432.0))
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
        if step.abs() * (depth * depth) <= HANDLE_TOLERANCE {
            break;
        }
    }
    w0
}

#[cfg(test)]
mod tests {
    use super::super::numeric::root_near;
    use super::*;

    #[test]
    fn the_steps_end_at_the_root_at_every_angle() {
        for i in 1..=3600 {
            let span = Span::from_degrees(f64::from(i) * 0.05);
            // The condition itself, divided by G, which only scales it.
            let unbalance = |w0: f64| {
                let g = big_g(&span, w0);
                (root_minus_1(g * w0.powi(3) / 432.0) + root_minus_1(-g * (1.0 - w0) / 64.0)) / g
            };
            let searched = family(&span, root_near(unbalance, GOLDAPP_ZERO, 1e-3, 0.0, 1.0));
            let off = (handle(&span) / searched - 1.0).abs();
            assert!(off <= 4.5e-16, "{off:e} at {} degrees", span.degrees());
        }
    }
}
