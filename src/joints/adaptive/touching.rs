//! A cubic that touches the unit circle at both ends, seen from the middle of its angle a = 2h. With v = 2t - 1 and u = t(1-t) = (1-v²)/4
//! (derived)
//!
//! ```text
//! x = cos h + 3u k sin h,   y = v (sin h + u (2 sin h - 3k cos h)),   F = x² + y² - 1 = -u² (H + G u)
//! ```
//!
//! and F is extreme in the middle and where u = -2H/(3G), at most three lobes.

use crate::angle::first_direction;
use crate::method::{Rule, Span};
use crate::numeric::lanes::Real;

/// Such a cubic.
#[derive(Clone, Copy)]
pub(super) struct TouchingCubic {
    /// x = `cos` + 3u `bulge`, y = v (`sin` + u `lean`).
    pub(super) cos: f64,
    pub(super) sin: f64,
    pub(super) bulge: f64,
    pub(super) lean: f64,
    /// H and G.
    pub(super) excess: [f64; 2],
}

impl TouchingCubic {
    /// Of a piece of this many degrees; `None` where the rule gives none, or none that touches the circle.
    pub(super) fn new(rule: Rule, size: f64) -> Option<Self> {
        let span = if size <= 180.0 {
            Span::of_quarter(size / 4.0, first_direction(size / 4.0))
        } else {
            Span::from_degrees(size)
        };
        let piece = rule.piece(&span).ok()?;
        let (sin, cos, k) = (span.sh, span.ch, piece.handle.y);
        Some(Self {
            cos,
            sin,
            bulge: k * sin,
            lean: 2.0 * sin - 3.0 * k * cos,
            excess: piece.excess(&span)?,
        })
    }

    /// Where on either side of the middle F is extreme again: curves that stay on one side have one lobe.
    pub(super) fn outer(&self) -> Option<f64> {
        let [h, g] = self.excess;
        let outer = (1.0 + 8.0 * h / (3.0 * g)).max(0.0).sqrt();
        (outer < 1.0).then_some(outer)
    }

    /// u.
    #[inline(always)]
    pub(super) fn u<S: Real>(v: S) -> S {
        (S::exact(1.0) - v * v).scaled(0.25)
    }

    /// x and y.
    #[inline(always)]
    pub(super) fn point<S: Real>(&self, v: S, u: S) -> [S; 2] {
        [
            S::exact(self.cos) + u.scaled(3.0 * self.bulge),
            v * (S::exact(self.sin) + u.scaled(self.lean)),
        ]
    }

    /// F.
    #[inline(always)]
    pub(super) fn excess<S: Real>(&self, u: S) -> S {
        let [h, g] = self.excess;
        S::exact(0.0) - u * u * (S::exact(h) + u.scaled(g))
    }
}
