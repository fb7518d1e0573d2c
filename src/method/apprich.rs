//! `apprich`, `apprich-plus`, `apprich-scaled`: four times continuously differentiable at joints of equal pieces.
//!
//! Apprich, Dietrich, Höllig et al.: with f the graph x = f(y) of the curve near the joint,
//! f''' = 0 is a quadratic equation for the handle,
//!
//! ```text
//! k = (1-c) / (3s(3+2c)) (2(4+3c) ∓ sqrt(2(5+3c)))
//! ```
//!
//! δ-minus (`apprich`) has order 6, lies inside the circle and errs most at t = 1/2, where 1 - r² = E; δ-plus has order 2.
//! `apprich-scaled` is the paper's p* = 2/(1 + sqrt(1-E)) p, which balances the error of δ-minus. The paper's
//! E = (9/32)(c-1)k² - (3/4)ks + (1-c)/2 cancels at small angles; with q = sqrt(2(5+3c)) and N = 2 + 2c + q the same number is
//!
//! ```text
//! E = sin⁶ h (4 + 8c + q(5+c)/2) / (N² cos² h (4+q))
//! ```

use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::tangent::root_minus_1;
use super::{Piece, Span};

/// δ-minus.
pub(super) fn minus(span: &Span) -> f64 {
    handle(span, -1.0)
}

/// δ-plus.
pub(super) fn plus(span: &Span) -> f64 {
    handle(span, 1.0)
}

fn handle(span: &Span, sign: f64) -> f64 {
    let c = span.c;
    let half_tangent = span.sh / span.ch; // (1-c)/s
    half_tangent / (3.0 * (3.0 + 2.0 * c))
        * (2.0 * (4.0 + 3.0 * c) + sign * (2.0 * (5.0 + 3.0 * c)).sqrt())
}

/// E, the largest value of 1 - r².
fn big_e(span: &Span) -> f64 {
    let c = span.c;
    let q = (2.0 * (5.0 + 3.0 * c)).sqrt();
    let n = 2.0 + 2.0 * c + q;
    let numerator = power(span.sh, 6) * (4.0 + 8.0 * c + q * (5.0 + c) / 2.0);
    numerator / (power(n * span.ch, 2) * (4.0 + q))
}

pub(super) fn minus_error(span: &Span) -> RadialError {
    RadialError {
        outward: 0.0,
        inward: -root_minus_1(-big_e(span)),
    }
}

pub(super) fn scaled(span: &Span) -> Piece {
    Piece::tangent(minus(span)).scaled(2.0 / (2.0 - minus_error(span).inward))
}

pub(super) fn scaled_error(span: &Span) -> RadialError {
    let inward = minus_error(span).inward;
    RadialError::balanced(inward / (2.0 - inward))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_handle_is_longest_near_130_degrees_and_vanishes_at_its_end() {
        let handle = |degrees: f64| minus(&Span::from_degrees(degrees));
        let longest = (1000..1800)
            .map(|tenths| f64::from(tenths) / 10.0)
            .max_by(|&a, &b| handle(a).total_cmp(&handle(b)))
            .unwrap();
        assert!((longest - 129.8).abs() < 0.15, "{longest}");
        assert!(handle(179.99) < 0.01, "{}", handle(179.99));
    }
}
