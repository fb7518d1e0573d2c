//! Segments as long as an error lets them be, one after the other.

use core::iter;

use super::{Balance, Joints, MOST, MOST_STEPS};
use crate::angle::Angle;
use crate::shape::UnitArc;

/// How often joints are marched out for the error that equalises such segments, and by how much the last of them may be too short, as a
/// part of it.
const NARROWINGS: u32 = 12;
const SHORT: f64 = 0.01;

/// The part of a segment up to which the last one may not be needed from the other end on.
const STUB: f64 = 0.1;

/// How closely the length of a segment on the circle is found, as a part of its error.
const ROUGHLY: f64 = 0.05;

/// How far below the error of equal angles it may lie, and how closely it is narrowed down, both as ratios.
const WIDE: f64 = 1000.0;
const NARROW: f64 = 1.02;

/// The ratio of the lengths that are tried where a longer segment may err less.
const LONGER: f64 = 1.15;

/// How well the longest of them is known then, as a part of it: closer, it takes more looks and saves no segment.
const SETTLED: f64 = 3e-3;

/// The largest such logarithm that counts.
const MOST_BEYOND: f64 = 40.0;

/// A segment that is within an error and a longer one that is beyond, with the logarithms of their errors over what is allowed.
struct Bracket {
    low: f64,
    high: f64,
    below: f64,
    above: f64,
}

impl Bracket {
    /// The longest segment within, by secants, to so little of that logarithm.
    fn longest(mut self, settled: f64, beyond: impl Fn(f64) -> f64) -> f64 {
        for _ in 0..MOST_STEPS {
            let is_narrow = self.high - self.low <= SETTLED * self.low;
            if is_narrow || self.below >= -settled {
                break;
            }
            let part = (self.below + 0.5 * settled) / (self.below - self.above);
            let size = self.low + (self.high - self.low) * part.clamp(0.05, 0.95);
            let reached = beyond(size);
            if reached <= 0.0 {
                (self.low, self.below) = (size, reached);
            } else {
                (self.high, self.above) = (size, reached);
            }
        }
        self.low
    }
}

impl Balance {
    /// The longest segment from `way`, up to `most`, whose error is `allowed`, starting the search from `guess`; where a longer
    /// segment may err less, one of the first of `sizes` is within it anywhere and one of the other nowhere.
    fn longest(
        &self,
        way: f64,
        allowed: f64,
        guess: f64,
        most: f64,
        sizes: Option<[f64; 2]>,
    ) -> f64 {
        let largest = if sizes.is_some() {
            most
        } else {
            self.largest_angle
        };
        if let Some(size) = self.longest_by_lobes(way, allowed, guess, largest) {
            return size;
        }
        let Some([safe, nowhere]) = sizes else {
            return self.settled(way, allowed, guess);
        };
        // The sharp ends of a flat ellipse are harmless at a joint, so that a longer segment may err less than a shorter one.
        let from = self.past_axis(way);
        let most = most.min(nowhere);
        let least = safe.min(most);
        // How far beyond what is allowed, by its logarithm.
        let beyond = |size: f64| {
            let reached = self.lobes.size_up_to(from, size, allowed);
            libm::log(reached / allowed).clamp(-MOST_BEYOND, MOST_BEYOND)
        };
        let mut bracket = Bracket {
            low: most,
            high: most,
            below: beyond(most),
            above: 0.0,
        };
        while bracket.below > 0.0 && bracket.low > least {
            (bracket.high, bracket.above) = (bracket.low, bracket.below);
            bracket.low = (bracket.low / LONGER).max(least);
            bracket.below = beyond(bracket.low);
        }
        // A sharp end where the curve crosses the ellipse is harmless too.
        for size in self.lobes.crossing_sharp_end(from) {
            if size > bracket.low && size <= most {
                let below = beyond(size);
                if below <= 0.0 {
                    bracket = Bracket {
                        low: size,
                        high: (size * LONGER).min(most),
                        below,
                        above: self.order * (LONGER - 1.0),
                    };
                }
            }
        }
        let low = bracket.longest(self.order * SETTLED, beyond);
        let within = |size: f64| size <= most && beyond(size) <= 0.0;
        let quarters = (from + low) / 90.0;
        let to_axis = low + 90.0 * (quarters.ceil() - quarters);
        let axes = [to_axis, to_axis + 90.0].into_iter();
        axes.filter(|&size| within(size)).fold(low, f64::max)
    }

    /// The lengths of a segment that is within an error anywhere, and of one that is nowhere: the affine map scales a distance from the
    /// circle by no more than one and no less than the ratio of the radii.
    pub(super) fn sizes(&self, allowed: f64) -> [f64; 2] {
        let safe = self.on_circle((1.0 - ROUGHLY) * allowed, 45.0);
        let least = allowed / self.lobes.short;
        let most = self.resized(safe, least / allowed);
        let most = self.on_circle((1.0 + ROUGHLY) * least, most);
        let is_beyond = self.errors.on_circle(most) >= least;
        [safe, if is_beyond { most } else { self.largest_angle }]
    }

    /// The length of a segment of such an error on the circle.
    fn on_circle(&self, aim: f64, guess: f64) -> f64 {
        let mut size = guess.min(self.largest_angle);
        for _ in 0..MOST_STEPS {
            let error = self.errors.on_circle(size);
            if (error / aim - 1.0).abs() < ROUGHLY {
                break;
            }
            let next = self.resized(size, aim / error);
            if next == size {
                break;
            }
            size = next;
        }
        size
    }

    /// A segment's length for this many times its error, by the method's order.
    fn resized(&self, size: f64, times: f64) -> f64 {
        let factor = libm::pow(times, 1.0 / self.order);
        (size * factor.clamp(0.25, 4.0)).min(self.largest_angle)
    }

    /// The length at which the error is `allowed`, near `guess`.
    pub(super) fn settled(&self, way: f64, allowed: f64, guess: f64) -> f64 {
        let mut size = guess.min(self.largest_angle);
        // The power of the size that the error grows with, by the last two of them.
        let (mut power, mut before) = (self.order, None::<[f64; 2]>);
        for _ in 0..MOST_STEPS {
            let error = self.error(way, size);
            if let Some([size_before, error_before]) = before {
                let growth = libm::log(error / error_before) / libm::log(size / size_before);
                if growth.is_finite() {
                    power = growth.clamp(0.5 * self.order, 2.0 * self.order);
                }
            }
            let factor = libm::pow(allowed / error, 1.0 / power).clamp(0.25, 4.0);
            let next = (size * factor).min(self.largest_angle);
            let settled = (next - size).abs() <= 1e-7 * size;
            (before, size) = (Some([size, error]), next);
            if settled {
                break;
            }
        }
        size
    }

    /// How many segments of this error the way takes, the last one counted by its part, or more than `most`; their joints.
    pub(super) fn march(
        &self,
        whole: f64,
        allowed: f64,
        most: usize,
        joints: &mut Vec<f64>,
    ) -> f64 {
        joints.clear();
        joints.push(0.0);
        let (mut way, mut size) = (0.0, whole.min(30.0));
        let is_rough = self.errors.is_worth_a_look(allowed);
        let sizes = is_rough.then(|| self.sizes(allowed));
        loop {
            size = self
                .longest(
                    way,
                    allowed,
                    size,
                    self.largest_angle.min(whole - way),
                    sizes,
                )
                .max(whole / (4 * MOST) as f64);
            let left = whole - way;
            if size >= left || joints.len() > most {
                // Where no more than what is left was looked for, its error tells its part.
                let part = if is_rough && size >= left {
                    libm::pow(self.error(way, left) / allowed, 1.0 / self.order).min(1.0)
                } else {
                    left / size
                };
                return (joints.len() - 1) as f64 + part;
            }
            way += size;
            joints.push(way);
        }
    }

    /// The longest segment from `way` whose error is `allowed`, by Newton's method from a guess, where the lobes tell it.
    fn longest_by_lobes(&self, way: f64, allowed: f64, guess: f64, most: f64) -> Option<f64> {
        let from = self.past_axis(way);
        let mut size = guess.min(most);
        for _ in 0..MOST_STEPS {
            let peak = self
                .errors
                .is_quick()
                .then(|| self.lobes.of(from, size))??;
            let step = libm::log(allowed / peak.size) / peak.slopes[1];
            let next = (size + step.clamp(-0.5 * size, size)).min(most);
            if (next - size).abs() <= 1e-6 * size {
                return Some(next);
            }
            size = next;
        }
        None
    }

    /// Joints of this many segments of equal error where longer ones may err less: the error is narrowed down from that of `equal` angles on,
    /// or from `most` where that is less, between errors that take more and no more of them: by secants of both logarithms, and evenly
    /// where these do not bring it down, as a sharp end makes the count leap. `None` where more are taken for `most`.
    fn narrowed(&self, whole: f64, pieces: usize, equal: f64, most: f64) -> Option<Vec<f64>> {
        let (count, mut high) = (pieces as f64, equal.min(most));
        let (mut low, mut allowed) = (high / WIDE, high);
        // The last segment is to be a little too short rather than one too many.
        let aim = count - 0.5 * SHORT;
        // The one before, and how the logarithm of the error falls with that of the count.
        let (mut before, mut fall) = (None, self.order);
        let (mut found, mut joints) = (None, Vec::new());
        let (mut is_enclosed, mut is_narrower) = (false, true);
        for _ in 0..NARROWINGS {
            let ratio = high / low;
            let taken = self.march(whole, allowed, pieces, &mut joints);
            if taken > count {
                if allowed == most {
                    return None;
                }
                low = allowed;
                is_enclosed = true;
            } else {
                high = allowed;
                joints.push(whole);
                self.fill(&mut joints, pieces);
                found = Some(joints.clone());
                if taken > count - SHORT {
                    break;
                }
            }
            if high <= NARROW * low {
                break;
            }
            if let Some((error, count)) = before.replace((allowed, taken)) {
                let secant = libm::log(error / allowed) / libm::log(taken / count);
                let is_falling = secant > 0.0;
                fall = if is_falling { secant } else { self.order };
                fall = fall.clamp(0.5 * self.order, 4.0 * self.order);
            }
            let next = allowed * libm::pow(taken / aim, fall);
            let is_between = next > low && next < high && is_narrower;
            is_narrower = !is_between || !is_enclosed || high * high <= ratio * low * low;
            allowed = if is_between {
                next
            } else {
                (low * high).sqrt()
            };
        }
        found
    }

    /// The joints of [`Self::narrowed`], or those that mirror one another where these err less.
    pub(super) fn evened(
        &self,
        whole: f64,
        pieces: usize,
        equal: f64,
        most: f64,
    ) -> Option<Vec<f64>> {
        let marched = self.narrowed(whole, pieces, equal, most);
        // Of more than three the marched ones are about as near.
        let is_odd = pieces == 3 && self.is_sharp() && self.mirrors();
        let even = is_odd
            .then(|| self.mirrored(whole, pieces, equal.min(most)))
            .flatten();
        let less = |a: Vec<f64>, b: Vec<f64>| if self.most(&b) < self.most(&a) { b } else { a };
        marched.into_iter().chain(even).reduce(less)
    }

    /// Joints of an odd number of segments that mirror one another over the opposite end of the axis: the error is narrowed down for which
    /// those from the start on meet a middle one that has no larger one; `None` where that takes more than `most`.
    fn mirrored(&self, whole: f64, pieces: usize, most: f64) -> Option<Vec<f64>> {
        let half = pieces / 2;
        let (mut low, mut high, mut allowed) = (most / WIDE, most, most);
        let (mut found, mut joints) = (None, Vec::new());
        for _ in 0..NARROWINGS {
            self.march(whole, allowed, half, &mut joints);
            let reached = joints.get(half).filter(|reached| 2.0 * **reached < whole);
            let is_beyond =
                reached.is_some_and(|&way| self.error(way, whole - 2.0 * way) > allowed);
            if is_beyond {
                low = allowed;
            } else {
                high = allowed;
                if reached.is_some() {
                    let back = joints.iter().rev().map(|way| whole - way);
                    found = Some(joints.iter().copied().chain(back).collect());
                }
            }
            if high <= NARROW * low || low == most {
                break;
            }
            allowed = (low * high).sqrt();
        }
        found
    }

    /// Halves the segments of the largest error until there are as many.
    fn fill(&self, joints: &mut Vec<f64>, pieces: usize) {
        while joints.len() <= pieces {
            let errors = self.errors_between(joints).enumerate();
            let worst = errors.max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((at, _)) = worst else { return };
            joints.insert(at + 1, f64::midpoint(joints[at], joints[at + 1]));
        }
    }

    /// How many segments are taken that are as long as `allowed` lets them be, from the start on; from the end on too where the last of
    /// them is so short that one less may do. `None` for more than [`MOST`].
    pub(crate) fn marched_count(&self, allowed: f64) -> Option<usize> {
        let whole = self.computed(false);
        let mut ways = Vec::new();
        let taken = self.march(whole, allowed, MOST, &mut ways);
        let forth = ways.len();
        if !self.arc.closed && taken < forth as f64 - 1.0 + STUB {
            self.reversed().march(whole, allowed, MOST, &mut ways);
        }
        Some(forth.min(ways.len())).filter(|&count| count < MOST)
    }

    /// The segments that are as long as `allowed` lets them be, over the larger radius, from the start or from the end on; the
    /// last one may be shorter.
    pub(crate) fn greedy(&self, allowed: f64) -> impl Iterator<Item = Joints> {
        let whole = self.computed(false);
        let longest = |balance: &Self| {
            let mut ways = Vec::new();
            balance.march(whole, allowed, MOST, &mut ways);
            ways.push(whole);
            ways
        };
        let forth = longest(self);
        let back = (!self.arc.closed).then(|| {
            let ways = longest(&self.reversed());
            ways.iter().rev().map(|way| whole - way).collect()
        });
        let joints = |ways: Vec<f64>| Joints::after(&self.arc, &ways);
        iter::once(forth)
            .chain(back)
            .filter(|ways| ways.len() <= MOST)
            .map(joints)
    }

    /// The arc from its end to its start.
    fn reversed(&self) -> Self {
        let (start, sweep) = (self.arc.start.degrees(), self.arc.sweep.degrees());
        Self {
            arc: UnitArc {
                start: Angle::from_degrees(start + sweep),
                sweep: Angle::from_degrees(-sweep),
                ..self.arc
            },
            errors: self.errors.clone(),
            ..*self
        }
    }
}

#[cfg(test)]
mod tests;
