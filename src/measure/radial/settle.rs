//! The one extreme of a part, by Newton's method.

use super::part::CubicPart;
use super::peaks::{Search, vector};
use super::place::NearestPoint;
use super::slopes::Slopes;
use crate::numeric::foot::foot_in_unit;

/// What Newton's method may leave of the distance, as a share of it.
const LEFT: f64 = 1e-12;

/// How many steps of Newton's method are taken at most, and how many by s nearly, which cost half; these end with one that is so small.
const MOST_STEPS: usize = 8;
const MOST_QUICK: usize = 3;
const NEARLY: f64 = 1e-3;

/// A smaller step is not worth another.
const SETTLED: f64 = 1e-6;

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Finds the extreme of a part on which |N'| is at least `curving`, by steps from t on; whether it did. From a place on, the distance
    /// grows by N² / (2 √g curving) at most.
    pub(super) fn settle(&mut self, part: &CubicPart, mut t: f64, curving: f64) -> bool {
        for _ in 0..MOST_QUICK {
            t = t.clamp(0.0, 1.0);
            let step = self.step(&part.motion_at(t, self.center));
            t += step;
            if step.abs() <= NEARLY {
                break;
            }
        }
        for steps in 0..MOST_STEPS {
            t = t.clamp(0.0, 1.0);
            let motion = part.motion_at(t, self.center);
            let point = self.image(vector(motion.place));
            let foot = foot_in_unit(self.radii, self.alpha, point, motion.excess);
            let Slopes { slope, bend, .. } = motion.slopes(self.alpha, foot.multiplier);
            let step = -slope / bend;
            if step.abs() > SETTLED && (t + step).clamp(0.0, 1.0) != t && steps + 1 < MOST_STEPS {
                t += step;
                continue;
            }
            let place = NearestPoint::new(self.alpha, part, &motion, foot, part.rounding());
            if !place.is_exact(self.last_place) {
                return false;
            }
            let at = part.rounded(&motion).slopes(self.alpha, place.multiplier());
            let steep = at.slope.size();
            // g is at least 0.6 G where a part is near.
            let gradient = motion.gradient(self.alpha);
            let more = 0.7 * steep * steep / (curving * gradient.sqrt());
            let is_beyond = (t == 0.0 && step < 0.0) || (t == 1.0 && step > 0.0);
            if is_beyond || more <= LEFT * place.foot.foot.distance.abs() + self.last_place {
                let more = if is_beyond { 0.0 } else { more };
                self.take(part.parameter(t), place.between(more));
                return true;
            }
            t += step;
        }
        false
    }
}
