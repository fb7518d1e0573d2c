//! The quadratics: one inner control point at radius m on the bisector (all but the first derived).
//!
//! In the frame of the bisector, with τ = 2t - 1, the curve is X = x0 + x2 τ², Y = y1 τ, and m = x0 - x2.
//!
//! - `quadratic-tangent` m = 1/cos h, `quadratic-midpoint` m = 2 - cos h, `quadratic-area` m = (3a - s)/(4 sin h)
//! - `quadratic-minimax` and `quadratic-minimax-free`: |p|² = 1 + R² + 2R T4(λτ), T4(x) = 8x⁴ - 8x² + 1, R = q²,
//!   x0 = 1+R, x2 = -4qλ², y1 = λ (1-q) sqrt(8q), (x0 + x2) sin h = y1 cos h; λ = 1 with free ends,
//!   λ = cos(acos(-R/2)/4) with the ends on the circle. The latter is the root of (cos h + m)/2 - 1 = 1 - sqrt(1 - B²/(4A)),
//!   A = (cos h - m)²/4, B = sin² h + (cos h - m) cos h.

use kurbo::Vec2;

use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::tangent::root_minus_1;
use super::{Degree, Piece, Span};
use crate::numeric::{angle_minus_sine, area_excess, root_near};

fn with_apex(span: &Span, end_radius: f64, m: f64) -> Piece {
    Piece {
        degree: Degree::Quadratic,
        end_radius,
        handle: Vec2::new(m * span.ch, m * span.sh),
    }
}

pub(super) fn tangent(span: &Span) -> Piece {
    Piece {
        degree: Degree::Quadratic,
        end_radius: 1.0,
        handle: Vec2::new(1.0, span.sh / span.ch),
    }
}

/// (1 - cos h)²/(2 cos h), at t = 1/2.
pub(super) fn tangent_error(span: &Span) -> RadialError {
    let versine = span.half_versine();
    RadialError {
        outward: versine * versine / (2.0 * span.ch),
        inward: 0.0,
    }
}

pub(super) fn midpoint(span: &Span) -> Piece {
    with_apex(span, 1.0, 2.0 - span.ch)
}

/// r² = 1 - x2² τ² (1 - τ²) with x2 = cos h - 1, least at τ² = 1/2.
pub(super) fn midpoint_error(span: &Span) -> RadialError {
    RadialError {
        outward: 0.0,
        inward: -root_minus_1(-power(span.half_versine(), 2) / 4.0),
    }
}

fn area_apex(span: &Span) -> f64 {
    (2.0 * span.a + angle_minus_sine(span.a)) / (4.0 * span.sh)
}

pub(super) fn area(span: &Span) -> Piece {
    with_apex(span, 1.0, area_apex(span))
}

/// r² - 1 = (1 - τ²)(b - x2² τ²), with b = x0² - 1 the excess in the middle, where x0 - 1 = (3a + s - 8 sin h)/(8 sin h).
pub(super) fn area_error(span: &Span) -> RadialError {
    let middle = area_excess(span.a) / (8.0 * span.sh);
    let x2 = -span.half_versine() - middle;
    let (b, q) = (middle * (2.0 + middle), x2 * x2);
    // The turning point τ² = (b + q)/(2q).
    let inner = -power(q - b, 2) / (4.0 * q);
    RadialError::of_range([0.0, middle, root_minus_1(inner)])
}

/// The equioscillating curve of the peak error R = g⁴.
struct Balanced {
    r: f64,
    x0: f64,
    x2: f64,
    y1: f64,
}

impl Balanced {
    fn new(g: f64, ends_on_circle: bool) -> Self {
        let q = g * g;
        let r = q * q;
        let lambda = if ends_on_circle {
            libm::cos(libm::acos(-r / 2.0) / 4.0)
        } else {
            1.0
        };
        Self {
            r,
            x0: 1.0 + r,
            x2: -4.0 * q * lambda * lambda,
            y1: lambda * (1.0 - q) * 8.0_f64.sqrt() * g,
        }
    }

    fn spanning(span: &Span, ends_on_circle: bool) -> Self {
        let miss = |g: f64| {
            let s = Self::new(g, ends_on_circle);
            s.y1 * span.ch - (s.x0 + s.x2) * span.sh
        };
        let guess = span.a / 32.0_f64.sqrt();
        Self::new(root_near(miss, guess, guess / 8.0, 0.8), ends_on_circle)
    }
}

pub(super) fn minimax(span: &Span) -> Piece {
    let curve = Balanced::spanning(span, true);
    with_apex(span, 1.0, curve.x0 - curve.x2)
}

pub(super) fn minimax_error(span: &Span) -> RadialError {
    RadialError::balanced(Balanced::spanning(span, true).r)
}

pub(super) fn minimax_free(span: &Span) -> Piece {
    // The ends lie at T4(1) = 1, where |p| = 1 + R.
    let curve = Balanced::spanning(span, false);
    with_apex(span, 1.0 + curve.r, curve.x0 - curve.x2)
}

pub(super) fn minimax_free_error(span: &Span) -> RadialError {
    RadialError::balanced(Balanced::spanning(span, false).r)
}
