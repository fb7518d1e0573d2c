//! `minimax`: the handle with the least peak error, `r_out` + `r_mid` = 2 (Mortenson's second, as Chen 1996 tells it).
//!
//! In the family of `tangent`, `r_out²` = 1 + G w0³/432 and `r_mid²` = 1 - G (1-w0)/64. Squared twice, the condition loses its roots:
//!
//! ```text
//! P = γ Q²,   P = 4 w0³ + 27 w0 - 27,   Q = P + 54 (1 - w0),   γ = G/13824
//! ```
//!
//! For γ = 0 it is Goldapp's. Written in d, what w0 exceeds Goldapp's by (at most 0.00103, at half a turn), P has no constant term,
//! and γ follows from Goldapp's γ and R:
//!
//! ```text
//! γ(d) = γ (1 - κ d (1 - μ d) + ...),   κ = sin² h cos h / (R (1 + cos² h + R cos h)),   μ = (sin² h / R² + 3κ)/4
//! ```
//!
//! Two terms of d by powers of γ err by at most 4e-8, and one step of Newton's method from there by at most 1e-15, which the handle
//! moves by an eighth. Nothing here takes a branch, so that a processor works at several arcs at once.

use crate::radial_error::RadialError;

use super::Span;
use super::tangent::{GOLDAPP_ZERO, family, root_minus_1, root_square};

/// γ by y², G = 4y².
const GAMMA: f64 = 4.0 / 13_824.0;

/// P = `P_1` d + `P_2` d² + 4 d³, Q = `Q_0` + `Q_1` d + `P_2` d² + 4 d³.
const P_1: f64 = 27.0 + 12.0 * GOLDAPP_ZERO * GOLDAPP_ZERO;
const P_2: f64 = 12.0 * GOLDAPP_ZERO;
const Q_0: f64 = 54.0 * (1.0 - GOLDAPP_ZERO);
const Q_1: f64 = P_1 - 54.0;

/// d = `FIRST` γ to begin with; the next term is the square of that times -(`SECOND` + κ).
const FIRST: f64 = Q_0 * Q_0 / P_1;
const SECOND: f64 = P_2 / P_1 - 2.0 * Q_1 / Q_0;

/// The value w0 of v = 4t(1-t) at which the balanced curve crosses the circle, and γ.
#[inline(always)]
fn zero(span: &Span) -> (f64, f64) {
    let (c, square) = (span.ch, span.sh * span.sh);
    let root_square = root_square(span, GOLDAPP_ZERO);
    // One division for all that G and its derivative ask for: y = -2 sin³ h R times this.
    let reciprocal = 1.0 / ((1.0 + c * c) * root_square.sqrt() + c * root_square);
    let first =
        (4.0 * GAMMA) * (square * square * square) * root_square * (reciprocal * reciprocal);
    let kappa = square * c * reciprocal;
    // R², between 3.89 and 4, decides no digit here.
    let mu = square * (0.25 / 3.9) + 0.75 * kappa;
    let gamma = |d: f64| first - (first * (kappa * d)) * (1.0 - mu * d);
    let d = FIRST * first;
    let d = d - (d * d) * (SECOND + kappa);
    let at = gamma(d);
    let higher = (d * d) * (P_2 + 4.0 * d);
    let (p, q) = (P_1 * d + higher, (Q_0 + Q_1 * d) + higher);
    let growing = d * (2.0 * P_2 + 12.0 * d);
    let slope = (P_1 + growing) - (at * q) * (2.0 * (Q_1 + growing) - q * kappa);
    let d = d - (p - at * (q * q)) / slope;
    (GOLDAPP_ZERO + d, gamma(d))
}

#[inline]
pub(super) fn handle(span: &Span) -> f64 {
    family(span, zero(span).0)
}

pub(super) fn error(span: &Span) -> RadialError {
    let (w0, gamma) = zero(span);
    RadialError::balanced(root_minus_1(square(w0, gamma)))
}

/// The handle and the peak of r² - 1, which saves the root of an error that is only compared.
#[inline(always)]
pub(super) fn handle_with_square(span: &Span) -> (f64, f64) {
    let (w0, gamma) = zero(span);
    (family(span, w0), square(w0, gamma))
}

/// The peak of r² - 1, G w0³/432.
#[inline(always)]
fn square(w0: f64, gamma: f64) -> f64 {
    gamma * (32.0 * (w0 * w0 * w0))
}

#[cfg(test)]
mod tests {
    use super::super::tangent::family_y;
    use super::*;
    use crate::numeric::root_near;

    #[test]
    fn one_step_ends_at_the_root_at_every_angle() {
        for i in 1..=3600 {
            let span = Span::from_degrees(f64::from(i) * 0.05);
            // The condition itself, divided by G, which only scales it.
            let unbalance = |w0: f64| {
                let g = 4.0 * family_y(&span, w0).powi(2);
                (root_minus_1(g * w0.powi(3) / 432.0) + root_minus_1(-g * (1.0 - w0) / 64.0)) / g
            };
            let searched = family(&span, root_near(unbalance, GOLDAPP_ZERO, 1e-3, 1.0));
            let off = (handle(&span) / searched - 1.0).abs();
            // The rounding of the formula on either side: three units in the last place.
            assert!(off <= 6.7e-16, "{off:e} at {} degrees", span.degrees());
        }
    }
}
