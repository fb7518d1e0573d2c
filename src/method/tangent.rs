//! Cubics that touch the circle at both ends: `midpoint`, `goldapp`, `curvature`, and the family that they belong to.
//!
//! Control points (1,0), (1,k), (c+ks, s-kc), (c,s). With u = t(1-t),
//!
//! ```text
//! r² - 1 = -u² (H + G u),   H = 6(1-c) - 6ks - 9k²,   G = 8(1-c) - 24ks + 18(1+c)k² = 4 (3k cos h - 2 sin h)²
//! ```
//!
//! so that the radius errs at most at t = 1/2 and at u = -2H/(3G). The whole family has one parameter w0, the value of
//! v = 4t(1-t) at which the error vanishes, H = -G w0/4:
//!
//! ```text
//! k(a, w0) = (2/3) (3 + w0) sin h / ((1 + w0) cos h + R),   R = sqrt(4 - (1-w0) sin² h)
//! ```
//!
//! What the error needs is y = 3k cos h - 2 sin h, in which H cos² h = -4 sin⁴ h - 4y sin h (1 + cos² h) - y² and G = 4y². A member of
//! the family has
//!
//! ```text
//! y = -2 sin³ h / (1 + cos² h + R cos h)
//! ```
//!
//! in which nothing cancels at any angle, so that its error is known to the last digits where H and G have long lost theirs.
//!
//! w0 = 1 is `midpoint`, k = (4/3) tan(a/4) (Lancaster 2005; Mortenson's first, as Chen 1996 tells it; Dokken et al. 1990);
//! w0 = 0 is `curvature` (de Boor, Höllig, Sabin 1987; Apprich et al. tell it as curvature = 1 at the ends);
//! w0 = (3/2)(cbrt(√2+1) - cbrt(√2-1)), the root of 4w0³ + 27w0 = 27, balances r² - 1: `goldapp` (Goldapp 1991).

use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::{Piece, Span};

/// R² of the family's member.
#[inline(always)]
pub(super) fn root_square(span: &Span, w0: f64) -> f64 {
    4.0 - (1.0 - w0) * (span.sh * span.sh)
}

/// The handle k(a, w0).
#[inline(always)]
pub(super) fn family(span: &Span, w0: f64) -> f64 {
    let root = root_square(span, w0).sqrt();
    2.0 / 3.0 * (3.0 + w0) * span.sh / ((1.0 + w0) * span.ch + root)
}

/// y of the family's member.
pub(super) fn family_y(span: &Span, w0: f64) -> f64 {
    let root = root_square(span, w0).sqrt();
    -2.0 * power(span.sh, 3) / (1.0 + span.ch * span.ch + span.ch * root)
}

/// The error of the family's member: extremes of r² - 1 at v = 2 w0/3 and v = 1.
pub(super) fn family_error(span: &Span, w0: f64) -> RadialError {
    let g = 4.0 * power(family_y(span, w0), 2);
    RadialError {
        outward: root_minus_1(g * power(w0, 3) / 432.0),
        inward: -root_minus_1(-g * (1.0 - w0) / 64.0),
    }
}

/// The error of any handle k. Where k is nearly right for a small angle, H and G cancel: below a degree no sixth digit is left.
pub(super) fn error(span: &Span, k: f64) -> RadialError {
    let h = 6.0 * span.versine() - 6.0 * k * span.s - 9.0 * k * k;
    error_of(h, 4.0 * power(3.0 * k * span.ch - 2.0 * span.sh, 2))
}

/// The error of the handle k that its y describes too, of which H keeps its digits at small angles; at large ones it has no need.
pub(super) fn error_by_y(span: &Span, k: f64, y: f64) -> RadialError {
    let [h, g] = excess(span, k, y);
    error_of(h, g)
}

/// H and G of the handle k and its y.
pub(super) fn excess(span: &Span, k: f64, y: f64) -> [f64; 2] {
    let g = 4.0 * y * y;
    if span.a > 1.0 {
        return [6.0 * span.versine() - 6.0 * k * span.s - 9.0 * k * k, g];
    }
    let square = span.ch * span.ch;
    let h = -(4.0 * power(span.sh, 4) + 4.0 * y * span.sh * (1.0 + square) + y * y) / square;
    [h, g]
}

/// The extremes of r² - 1 = -u² (H + G u), at u = 1/4 and u = -2H/(3G).
fn error_of(h: f64, g: f64) -> RadialError {
    let squared_at = |u: f64| -u * u * (h + g * u);
    let turning = -2.0 * h / (3.0 * g);
    let inner = if turning > 0.0 && turning < 0.25 {
        squared_at(turning)
    } else {
        0.0
    };
    RadialError::of_range([0.0, root_minus_1(squared_at(0.25)), root_minus_1(inner)])
}

/// sqrt(1 + x) - 1 without cancellation.
#[inline]
pub(super) fn root_minus_1(x: f64) -> f64 {
    x / ((1.0 + x).max(0.0).sqrt() + 1.0)
}

/// (4/3) tan(a/4), with tan(a/4) = sin h / (1 + cos h).
pub(super) fn midpoint(span: &Span) -> f64 {
    4.0 / 3.0 * span.sh / (1.0 + span.ch)
}

/// The zero of v that balances r² - 1: (3/2)(cbrt(√2+1) - cbrt(√2-1)).
pub const GOLDAPP_ZERO: f64 = 0.894_107_456_974_982_3;

pub(super) fn goldapp(span: &Span) -> f64 {
    family(span, GOLDAPP_ZERO)
}

/// (sqrt(s² + 6(1-c)) - s)/3, rid of its cancellation.
pub(super) fn curvature(span: &Span) -> f64 {
    family(span, 0.0)
}

/// All control points of `midpoint` times 2/(1 + sqrt(1+E)), E = (4/27) sin⁶(a/4)/cos²(a/4), which centres its one-sided error.
pub(super) fn minimax_free(span: &Span) -> Piece {
    let outward = midpoint_error(span);
    Piece::tangent(midpoint(span)).scaled(2.0 / (2.0 + outward))
}

pub(super) fn minimax_free_error(span: &Span) -> RadialError {
    let outward = midpoint_error(span);
    RadialError::balanced(outward / (2.0 + outward))
}

/// sqrt(1 + E) - 1.
fn midpoint_error(span: &Span) -> f64 {
    family_error(span, 1.0).outward
}

/// All control points of `curvature` times 2/(1 + r(1/2)).
pub(super) fn curvature_scaled(span: &Span) -> Piece {
    Piece::tangent(curvature(span)).scaled(2.0 / (2.0 - curvature_error(span)))
}

pub(super) fn curvature_scaled_error(span: &Span) -> RadialError {
    let inward = curvature_error(span);
    RadialError::balanced(inward / (2.0 - inward))
}

fn curvature_error(span: &Span) -> f64 {
    family_error(span, 0.0).inward
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_balancing_zero_is_the_root_of_its_cubic() {
        let root2 = core::f64::consts::SQRT_2;
        let closed = 1.5 * ((root2 + 1.0).cbrt() - (root2 - 1.0).cbrt());
        assert!((GOLDAPP_ZERO - closed).abs() < 1e-15);
        let cubic = |w: f64| 4.0 * w.powi(3) + 27.0 * w - 27.0;
        assert!(cubic(GOLDAPP_ZERO.next_down()) <= 0.0 && cubic(GOLDAPP_ZERO.next_up()) >= 0.0);
    }
}
