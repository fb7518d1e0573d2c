//! `minimax-g0` and `minimax-g0-free`: cubics with two free numbers at each end, whose error oscillates like a Chebyshev
//! polynomial (derived; the class of Vavpetič & Žagar 2020). Their tangents leave the circle's by a hair: joints are corners.
//!
//! With τ = 2t - 1 and λ = 1 (`free`), or λ = cos(acos(-R/2)/6) so that the ends lie on the circle,
//!
//! ```text
//! |p|² = 1 + R² + 2R T6(λτ),   T6(x) = 32x⁶ - 48x⁴ + 18x² - 1
//! X = x0 + x2 τ²,  Y = y1 τ + y3 τ³:   x0 = 1-R,  y3 = -8 √R λ³,  2 x0 x2 + y1² = 36 R λ²,  x2² + 2 y1 y3 = -96 R λ⁴,
//! (x0 + x2) sin h = (y1 + y3) cos h
//! ```
//!
//! Written with g = R^(1/6), x2 = -γ g² and y1 = β g, nothing vanishes or cancels as the angle does:
//! β² = 2(1-R)γ + 36g⁴λ², γ² = 16λ³β - 96g²λ⁴, and g is near h/(4λ).

use kurbo::Vec2;

use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::{Degree, Piece, Span};
use crate::numeric::root_near;

/// Newton's method for β doubles its digits from a start that is within a third of it.
const NEWTON_STEPS: usize = 12;

#[derive(Clone, Copy)]
struct Solution {
    r: f64,
    x0: f64,
    x2: f64,
    y1: f64,
    y3: f64,
}

impl Solution {
    /// The curve of the peak error R = g⁶, whatever angle it spans.
    fn new(g: f64, ends_on_circle: bool) -> Self {
        let r = power(g, 6);
        let lambda = if ends_on_circle {
            libm::cos(libm::acos(-r / 2.0) / 6.0)
        } else {
            1.0
        };
        let square = g * g;
        let gamma =
            |beta: f64| (beta * beta - 36.0 * power(square * lambda, 2)) / (2.0 * (1.0 - r));
        let mut beta = 4.0 * lambda;
        for _ in 0..NEWTON_STEPS {
            let c = gamma(beta);
            let value = c * c - 16.0 * power(lambda, 3) * beta + 96.0 * square * power(lambda, 4);
            let slope = 2.0 * c * beta / (1.0 - r) - 16.0 * power(lambda, 3);
            beta -= value / slope;
        }
        Self {
            r,
            x0: 1.0 - r,
            x2: -gamma(beta) * square,
            y1: beta * g,
            y3: -8.0 * power(g * lambda, 3),
        }
    }

    /// The curve that spans the angle.
    fn spanning(span: &Span, ends_on_circle: bool) -> Self {
        let miss = |g: f64| {
            let s = Self::new(g, ends_on_circle);
            (s.y1 + s.y3) * span.ch - (s.x0 + s.x2) * span.sh
        };
        let guess = span.a / 8.0;
        Self::new(root_near(miss, guess, guess / 8.0, 0.5), ends_on_circle)
    }

    fn piece(&self, span: &Span, end_radius: f64) -> Piece {
        // A third of the derivative by t at the start, seen in the frame of the start.
        let third = Vec2::new(-2.0 * self.x2, self.y1 + 3.0 * self.y3) * (2.0 / 3.0);
        let along = third.x * span.ch - third.y * span.sh;
        let across = third.x * span.sh + third.y * span.ch;
        Piece {
            degree: Degree::Cubic,
            end_radius,
            handle: Vec2::new(end_radius + along, across),
        }
    }
}

pub(super) fn on_circle(span: &Span) -> Piece {
    Solution::spanning(span, true).piece(span, 1.0)
}

pub(super) fn on_circle_error(span: &Span) -> RadialError {
    RadialError::balanced(Solution::spanning(span, true).r)
}

pub(super) fn free(span: &Span) -> Piece {
    let solution = Solution::spanning(span, false);
    solution.piece(span, 1.0 + solution.r)
}

pub(super) fn free_error(span: &Span) -> RadialError {
    RadialError::balanced(Solution::spanning(span, false).r)
}
