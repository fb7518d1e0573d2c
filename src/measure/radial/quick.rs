//! Whether the distance has an extreme on a part, by the sizes of its derivatives alone: a tenth of the time that balls take, and mostly
//! enough. The letters are those of `slopes`.

use super::part::{Motion, Part, Sizes};
use super::peaks::Search;

/// How the distance runs along a part.
enum Course {
    /// It rises or falls all along.
    Monotone,
    /// It has one extreme at most, of which |N'| is at least `curving`: a largest distance outside, `side` 0, or inside, 1.
    OneExtreme { side: usize, curving: f64 },
}

/// What the roundings of a few sums are off at most, as a part of those of sizes.
const ROUNDING: f64 = 1e-12;

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Whether sizes alone tell that the distance has no extreme on a near part, or lead to the one that it has.
    pub(super) fn is_found_quickly(
        &mut self,
        part: &Part,
        middle: &Motion<f64>,
        excess: [f64; 2],
        gradient: f64,
        bounds: [f64; 2],
    ) -> bool {
        let farthest = excess[1].max(-excess[0]);
        match self.course(part, middle, farthest, gradient) {
            None => false,
            Some(Course::Monotone) => true,
            Some(Course::OneExtreme { side, curving }) => {
                let open = self.open(part, bounds, self.last_place);
                let start = 0.5 - middle.rising / middle.bending;
                !open[side] || self.settle(part, start, curving)
            }
        }
    }

    /// How it runs along a part that is near, |F| and G being at most and at least so; `None` where sizes do not tell.
    ///
    /// There |s| αᵢ is at most n = 0.13 and mᵢ between 0.88 and 1.15, so that U is at most 1.15 times the sum of the sizes and D at least
    /// 0.68 G. V and W are Σ αᵢ qᵢ qᵢ', which is small along a shape and differs from that in the middle by half of its largest change,
    /// but for 2.82 n and 1.15 n times the sum of the sizes.
    fn course(
        &self,
        part: &Part,
        middle: &Motion<f64>,
        excess: f64,
        gradient: f64,
    ) -> Option<Course> {
        let Sizes {
            place,
            velocity,
            acceleration,
            bending: [low, high],
            rising,
            rising_off,
        } = part.sizes(middle);
        let (mut along, mut sizes, mut turning) = (0.0, 0.0, 0.0);
        for (i, alpha) in self.alpha.into_iter().enumerate() {
            along += alpha * middle.place[i] * middle.velocity[i];
            sizes += alpha * place[i] * velocity[i];
            turning += alpha * (velocity[i] * velocity[i] + place[i] * acceleration[i]);
        }
        // At most 1 + 3x with x at most 0.1.
        let multiplier = |excess: f64| 0.65 * excess / gradient;
        let s = multiplier(excess);
        let n = s * self.alpha[0].max(self.alpha[1]) + ROUNDING;
        let v = along.abs() + 0.5 * turning + 2.82 * n * sizes;
        let w = along.abs() + 0.5 * turning + 1.15 * n * sizes;
        let rate = (0.5 * rising + s * (v + w)) / (0.68 * gradient);
        let slack = (rate * v + 1.15 * s * turning) * (1.0 + ROUNDING);
        let [low, high] = [0.5 * low - slack, 0.5 * high + slack];
        let steepest = 0.5 * low.abs().max(high.abs()) * (1.0 + ROUNDING);
        let turned = multiplier(middle.excess.abs() + part.rounding()) * w * (1.0 + ROUNDING);
        let slope = 0.5 * (middle.rising.abs() - rising_off) - turned;
        if slope > steepest {
            return Some(Course::Monotone);
        }
        let one = |side, curving| Some(Course::OneExtreme { side, curving });
        match () {
            () if low > 0.0 => one(1, low),
            () if high < 0.0 => one(0, -high),
            () => None,
        }
    }
}
