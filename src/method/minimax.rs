//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64. With e = 1 - `r_mid` = G q the condition is
//!
//! ```text
//! w0³ = 432 q (2 + G q),   1 - w0 = 64 q (2 - G q)
//! ```
//!
//! a polynomial of q that heeds the angle through G alone. For G -> 0 its root is Goldapp's, 128 q = 1 - w0. G heeds w0 so weakly that
//! every step of Newton's method takes it anew. A step s leaves at most 3e-5 G s of itself, and the handle heeds w0 by at most
//! 0.03 G: the steps end where what they leave is beyond its last digit.

use crate::measure::RadialError;

use super::Span;
use super::tangent::{GOLDAPP_ZERO, big_g, family, family_error};

/// The steps end where one times G² is smaller; a millionth of it, which bounds what is left in the handle, is a tenth of its last digit.
const HANDLE_TOLERANCE: f64 = 1e-11;

/// At most so many steps; half a turn takes four, a quarter two, an eighth one.
const MOST_STEPS: usize = 8;

/// q for G -> 0, and its derivative by G there.
const FIRST: f64 = (1.0 - GOLDAPP_ZERO) / 128.0;
const FIRST_SLOPE: f64 = FIRST * FIRST * (192.0 * GOLDAPP_ZERO * GOLDAPP_ZERO - 432.0)
    / (864.0 + 384.0 * GOLDAPP_ZERO * GOLDAPP_ZERO);

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
#[inline]
fn zero(span: &Span) -> f64 {
    let mut w0 = GOLDAPP_ZERO;
    let mut g = big_g(span, w0);
    let mut q = FIRST + FIRST_SLOPE * g;
    for _ in 0..MOST_STEPS {
        let e = g * q;
        let w = 1.0 - 64.0 * q * (2.0 - e);
        let square = w * w;
        let miss = w * square - 432.0 * q * (2.0 + e);
        let slope = 384.0 * square * (1.0 - e) + 864.0 * (1.0 + e);
        q += miss / slope;
        let next = 1.0 - 64.0 * q * (2.0 - g * q);
        let step = (next - w0).abs();
        w0 = next;
        if step * (g * g) <= HANDLE_TOLERANCE {
            break;
        }
        g = big_g(span, w0);
    }
    w0
}

#[cfg(test)]
mod tests {
    use super::super::numeric::root_near;
    use super::super::tangent::root_minus_1;
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
            // The rounding of the formula on either side: three units in the last place.
            assert!(off <= 6.7e-16, "{off:e} at {} degrees", span.degrees());
        }
    }
}
