//! Cubics that touch a conic at both ends, whatever its weight: the family of `tangent.rs` beyond the circle.
//!
//! A conic from P0 to P2 with the control point P1 and the weight w is b² = 4w²ac in the coordinates p = a P0 + b P1 + c P2,
//! a + b + c = 1. A cubic with the handles λ(P1 - P0) and λ(P1 - P2) has, with u = t(1-t),
//!
//! ```text
//! b² - 4w²ac = u² (9λ² - 4w² (3 - 3λ + (2-3λ)² u))
//! ```
//!
//! which vanishes at 4u = w0 for (derived; on the circle w = cos h and λ = k/tan h)
//!
//! ```text
//! λ(w, w0) = (2/3) (3 + w0) w / ((1 + w0) w + sqrt(3 + w0 + (1-w0) w²))
//! ```
//!
//! So `midpoint`, `curvature` and `goldapp` are the same w0 for a hyperbola, w = cosh h, as for the circle. About its centre a
//! hyperbola is x² - y² = 1 in a frame of its own, as an ellipse is x² + y² = 1: r² = x² - y² = 1 + (1-w²)/w² (b² - 4w²ac), and
//! `minimax` balances r, 4w0³ = 27ρ(1-w0) with ρ = (3 - r(1/2))/(1 + r(1/2)).

use super::{Method, tangent};
use crate::error::{MethodError, Remedy, Result};
use crate::numeric::root;

impl Method {
    /// The part λ of the way to the control point at which the handles of a conic of this weight end.
    ///
    /// # Errors
    ///
    /// [`Error::Impossible`](crate::Error::Impossible) where the method is made for circles and ellipses only.
    pub(crate) fn conic_handle(self, weight: f64) -> Result<f64> {
        let zero = match self {
            Self::Midpoint => 1.0,
            Self::Curvature => 0.0,
            Self::Goldapp => tangent::GOLDAPP_ZERO,
            Self::Minimax => balanced_zero(weight),
            _ => {
                return Err(self.refuse(
                    MethodError::Conic,
                    Remedy::Methods(&["minimax", "midpoint", "goldapp", "curvature"]),
                ));
            }
        };
        Ok(handle(weight, zero))
    }
}

/// λ(w, w0).
fn handle(w: f64, w0: f64) -> f64 {
    let root = (3.0 + w0 + (1.0 - w0) * w * w).sqrt();
    2.0 / 3.0 * (3.0 + w0) * w / ((1.0 + w0) * w + root)
}

/// The w0 for which r errs alike on both sides.
fn balanced_zero(w: f64) -> f64 {
    let unbalanced = |w0: f64| {
        // At t = 1/2, where a = c = (1-b)/2.
        let b = 0.75 * handle(w, w0);
        let form = (b - w * (1.0 - b)) * (b + w * (1.0 - b));
        let r = (1.0 + form * (1.0 - w) * (1.0 + w) / (w * w))
            .max(0.0)
            .sqrt();
        4.0 * w0 * w0 * w0 - 27.0 * (3.0 - r) / (1.0 + r) * (1.0 - w0)
    };
    root(unbalanced, 0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::super::{Span, minimax};
    use super::*;

    #[test]
    fn on_a_circle_they_are_the_circles_handles() {
        for degrees in [10.0, 45.0, 90.0, 150.0] {
            let span = Span::from_degrees(degrees);
            let tangent_of_half = span.sh / span.ch;
            for w0 in [0.0, 0.5, tangent::GOLDAPP_ZERO, 1.0] {
                let k = handle(span.ch, w0) * tangent_of_half;
                assert!((k - tangent::family(&span, w0)).abs() < 1e-15);
            }
            let k = handle(span.ch, balanced_zero(span.ch)) * tangent_of_half;
            assert!((k - minimax::handle(&span)).abs() < 1e-13, "{degrees}");
        }
    }
}
