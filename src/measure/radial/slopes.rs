//! How the distance from an ellipse changes along a segment, without cancellation where it is tiny.
//!
//! The larger radius is the unit of length. In the frame where the ellipse is the unit circle let q be the point at t, F = |q|² - 1,
//! αᵢ the reciprocal squares of the radii, and s the largest root of Σ (mᵢ qᵢ)² = 1 with mᵢ = 1/(1 + s αᵢ). The nearest point is
//! mᵢ qᵢ, and with g = Σ αᵢ (mᵢ qᵢ)² the distance is d = s √g and
//!
//!   d' = N / √g,  N = F'/2 - s W,  N' = F''/2 - s' V - s U,  s' = (F'/2 - s (V + W)) / D,
//!   V = Σ αᵢ mᵢ² qᵢ qᵢ',  W = Σ αᵢ mᵢ qᵢ qᵢ',  U = Σ αᵢ mᵢ (qᵢ'² + qᵢ qᵢ''),  D = Σ αᵢ mᵢ³ qᵢ².

use super::part::Motion;
use crate::numeric::ball::{Ball, Number};

/// N, N' and s'.
pub(super) struct Slopes<T> {
    pub(super) slope: T,
    pub(super) bend: T,
    pub(super) rate: T,
}

impl<T: Number> Motion<T> {
    /// At a place, or between what they lie on a part, where s is so. Where it is called, what is not asked for is not computed.
    #[inline(always)]
    pub(super) fn slopes(&self, alpha: [f64; 2], s: T) -> Slopes<T> {
        let [mut u, mut v, mut w, mut d] = [T::exact(0.0); 4];
        for (i, alpha) in alpha.into_iter().enumerate() {
            let (q, velocity) = (self.place[i], self.velocity[i]);
            let m = (T::exact(1.0) + s.scaled(alpha)).reciprocal();
            let along = (q * velocity).scaled(alpha) * m;
            let turning = velocity * velocity + q * self.acceleration[i];
            let foot = q * m;
            w = w + along;
            v = v + along * m;
            u = u + turning.scaled(alpha) * m;
            d = d + (foot * foot).scaled(alpha) * m;
        }
        let half = self.rising.scaled(0.5);
        let rate = (half - s * (v + w)) * d.reciprocal();
        Slopes {
            slope: half - s * w,
            bend: self.bending.scaled(0.5) - rate * v - s * u,
            rate,
        }
    }
}

/// What s lies between on a part that is near, about its value at the middle.
pub(super) fn multipliers(
    [low, high]: [f64; 2],
    [least, most]: [f64; 2],
    x: f64,
    middle: Ball,
) -> Ball {
    let outer = |excess: f64| excess / (2.0 * least) * (1.0 + 3.0 * x);
    let inner = |excess: f64| excess / (2.0 * most) * (1.0 - 3.0 * x);
    let upper = if high > 0.0 { outer(high) } else { inner(high) };
    let lower = if low < 0.0 { outer(low) } else { inner(low) };
    let radius = f64::max(upper - middle.middle, middle.middle - lower);
    Ball::new(middle.middle, radius.max(0.0) + middle.radius)
}

/// The same where it is known how fast s changes along the part, of which the middle is half of the way from either end.
pub(super) fn narrowed(s: Ball, middle: Ball, rate: f64) -> Ball {
    Ball::new(s.middle, s.radius.min(middle.radius + rate / 2.0))
}
