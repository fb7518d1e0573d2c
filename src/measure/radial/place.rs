//! The nearest point of an ellipse at one place of a segment.

use super::part::{CubicPart, Motion};
use crate::numeric::ball::Ball;
use crate::numeric::foot::FootByExcess;

/// How far off a distance may be that is stated, as a share of it.
pub(super) const EXACT: f64 = 1e-10;

/// The nearest point at a place, and how far the distance and s may be off.
pub(super) struct NearestPoint {
    pub(super) foot: FootByExcess,
    pub(super) margin: f64,
    off: f64,
}

impl NearestPoint {
    /// Of a part of which F is off so far at most at the place: how s, and with it the distance, follows from F and from q.
    pub(super) fn new(
        alpha: [f64; 2],
        part: &CubicPart,
        motion: &Motion<f64>,
        foot: FootByExcess,
        rounding: f64,
    ) -> Self {
        let (q, off) = (motion.place, part.moved());
        let distance = foot.foot.distance.abs();
        let s = foot.multiplier;
        let (mut moved, mut strayed, mut d, mut g) = (0.0, 0.0, 0.0, 0.0);
        for (i, alpha) in alpha.into_iter().enumerate() {
            let m = 1.0 / (1.0 + s * alpha);
            let off = off[i] + f64::EPSILON * q[i].abs();
            let along = alpha * m * q[i].abs() * off;
            moved += along * (1.0 + m);
            strayed += along * m;
            d += alpha * m * m * m * q[i] * q[i];
            g += alpha * m * m * q[i] * q[i];
        }
        let share = moved / d + strayed / g + 16.0 * f64::EPSILON;
        Self {
            foot,
            margin: distance * share + rounding * 0.6 * g.sqrt() / d,
            off: s.abs() * (moved / d + 8.0 * f64::EPSILON) + rounding * 0.6 / d,
        }
    }

    /// Bounds of the signed distance, where it may be so much larger beside the place.
    pub(super) fn between(&self, more: f64) -> [f64; 2] {
        let off = self.margin + more;
        [-off, off].map(|off| self.foot.foot.distance + off)
    }

    pub(super) fn multiplier(&self) -> Ball {
        Ball::new(self.foot.multiplier, self.off)
    }

    /// Whether the distance is known well enough to be stated, within so little or as a share of it.
    pub(super) fn is_exact(&self, last_place: f64) -> bool {
        let allowed = EXACT * self.foot.foot.distance.abs() + last_place;
        self.foot.is_exact && self.margin <= allowed
    }
}
