//! Figures of the cards that no formula of a method gives, in degrees and on the unit circle.

use super::{Method, Span};
use crate::error::Result;

pub use super::tangent::GOLDAPP_ZERO;

/// The angle in degrees at which a quarter with the handle k first crosses the circle: with u = t(1-t), where H + G u = 0.
#[must_use]
pub fn crossing(k: f64) -> f64 {
    let (h, g) = (6.0 - 6.0 * k - 9.0 * k * k, 8.0 - 24.0 * k + 18.0 * k * k);
    let t = (1.0 - (1.0 + 4.0 * h / g).sqrt()) / 2.0;
    let along = |t: f64| t * t * (3.0 - 2.0 * t) + 3.0 * k * t * (1.0 - t) * (1.0 - t);
    libm::atan2(along(t), along(1.0 - t)).to_degrees()
}

/// The handle of a quarter that crosses the circle at 30 degrees; the higher the handle, the later it does.
#[must_use]
pub fn handle_crossing_at_30() -> f64 {
    let (mut low, mut high) = (0.551_8, 0.552);
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if crossing(middle) < 30.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The curvature at the ends, (2/3) times the distance of the second inner control point from the tangent over k².
///
/// # Errors
///
/// As [`Method::piece`].
pub fn end_curvature(method: Method, degrees: f64) -> Result<f64> {
    let span = Span::from_degrees(degrees);
    let k = method.piece(&span)?.handle_length();
    Ok(2.0 * (1.0 - span.c - k * span.s) / (3.0 * k * k))
}
