//! Joints at which the errors of all segments are alike, by Newton's method.
//!
//! With the logarithms e of the errors and the slopes p, q of each by its start and its end, a step δ of the joints that brings all of
//! them to one level L obeys e + p δ' + q δ = L, δ' that of the joint before: a recursion that is linear in L, and the last joint, which
//! stays, tells L.
//!
//! Of two cuts into as many segments one has a segment that contains one of the other's. Where a longer segment errs more, no
//! cut into as many segments therefore errs less than the least of these errors.

use super::lobes::{Lobes, Peak};
use super::{Balance, Joints, MOST};
use crate::numeric::functions::power;

/// The most steps, and the ratio of the largest to the least error that ends them.
const MOST_STEPS: usize = 12;
const ALIKE: f64 = 1.001;

/// The largest change of a segment in a step, as a part of it.
const CHANGE: f64 = 0.6;

/// Up to this change the errors are alike after a step, without a look: what is left of them is three times its square.
const SMALL: f64 = 0.02;

/// How far beyond an error, as a multiple, one segment less has to be by the method's order to be left out without a look.
const BEYOND: f64 = 1.5;

/// How far the lobes' error may be from the true one, as a part of it.
const LOBES_OFF: f64 = 2e-3;

/// A cut whose errors become alike, step by step.
pub(crate) struct Level {
    /// The ways to the joints, both ends included, in degrees.
    pub(super) ways: Vec<f64>,
    /// The peaks between them.
    peaks: Vec<Peak>,
    /// The least and the largest error, over the larger radius.
    pub(super) least: f64,
    pub(super) most: f64,
    steps: usize,
}

impl Level {
    /// A cut of `whole` degrees from the start on into this many segments, from where the steps begin. `None` where the lobes do not tell.
    fn new(balance: &Balance, whole: f64, pieces: usize) -> Option<Self> {
        let from = balance.past_axis(0.0);
        let mut level = Self {
            ways: Lobes::spread(balance.root, from, whole, pieces),
            peaks: Vec::with_capacity(pieces),
            least: 0.0,
            most: 0.0,
            steps: 1,
        };
        level.measure(&balance.lobes, from)?;
        Some(level)
    }

    /// Makes the errors alike; no more is computed once all of them are less than an edge, or more. `None` where the lobes do not tell.
    fn refine(&mut self, lobes: &Lobes, from: f64, edge: f64) -> Option<()> {
        while self.steps < MOST_STEPS {
            let is_settled = self.least > edge || self.most < edge && edge.is_finite();
            if is_settled || self.most <= ALIKE * self.least {
                break;
            }
            self.steps += 1;
            let LevelStep { change, level } = step(&mut self.ways, &self.peaks)?;
            if change <= SMALL {
                let size = libm::exp(level);
                (self.least, self.most) = (size, size);
            } else {
                self.measure(lobes, from)?;
            }
        }
        Some(())
    }

    fn measure(&mut self, lobes: &Lobes, from: f64) -> Option<()> {
        self.peaks.clear();
        (self.least, self.most) = (f64::INFINITY, 0.0);
        for pair in self.ways.windows(2) {
            let peak = lobes.of(from + pair[0], pair[1] - pair[0])?;
            self.least = self.least.min(peak.size);
            self.most = self.most.max(peak.size);
            self.peaks.push(peak);
        }
        Some(())
    }
}

/// The least count of segments whose errors may all be within an error, and a cut into as many that is on its way to equal ones.
pub(crate) struct Least {
    pub(crate) count: usize,
    pub(crate) level: Level,
}

impl Balance {
    /// This many segments, of `whole` degrees from the start on, whose errors are refined up to an edge, where the lobes tell them.
    fn level(&self, whole: f64, pieces: usize, edge: f64) -> Option<Level> {
        if !self.errors.is_quick() {
            return None;
        }
        let mut level = Level::new(self, whole, pieces)?;
        level.refine(&self.lobes, self.past_axis(0.0), edge)?;
        Some(level)
    }

    /// This many segments of equal error, from a cut into as many that was begun where there is one.
    pub(super) fn levelled(
        &self,
        whole: f64,
        pieces: usize,
        begun: Option<Level>,
    ) -> Option<Level> {
        match begun {
            Some(mut level) => {
                level.refine(&self.lobes, self.past_axis(0.0), f64::INFINITY)?;
                Some(level)
            }
            None => self.level(whole, pieces, f64::INFINITY),
        }
    }

    /// Joints for a count as for no error, where those for one are narrowed down from it: both end a little apart.
    pub(crate) fn narrowed_joints(&self, count: usize) -> Option<Joints> {
        let joints = || self.joints_from(count, None, f64::INFINITY);
        self.errors
            .is_quick()
            .then(joints)?
            .map(|(joints, _)| joints)
    }

    /// The least count of segments that the method's largest angle lets be, at least 1.
    pub(crate) fn least_by_angle(&self) -> usize {
        ((self.computed(false) / self.largest_angle).ceil() as usize).max(1)
    }

    /// The least count of segments whose errors, over the larger radius, may all be within `allowed`: with one less they are beyond for
    /// any joints. `None` where the lobes do not tell.
    pub(crate) fn least(&self, allowed: f64) -> Option<Least> {
        let allowed = allowed * (1.0 + LOBES_OFF);
        let whole = self.computed(false);
        // What no count up to it can do.
        let mut beyond = self.least_by_angle() - 1;
        let by_law = |count: usize, error: f64| {
            let times = libm::pow(error / allowed, 1.0 / self.order);
            (count as f64 * times).min(MOST as f64).ceil() as usize
        };
        let quarters = whole / 90.0;
        let mean = f64::midpoint(1.0, self.root);
        let first = libm::pow(self.errors.on_circle(90.0) / allowed, 1.0 / self.order);
        let mut count = (quarters * mean * first).ceil().min(MOST as f64) as usize;
        let mut within: Option<Least> = None;
        // Each look leaves fewer counts, and of as many segments as degrees the lobes do not tell.
        loop {
            let most = within.as_ref().map_or(usize::MAX, |least| least.count);
            count = count.clamp(beyond + 1, most - 1);
            let level = self.level(whole, count, allowed)?;
            if level.least > allowed {
                beyond = count;
                count = by_law(count, level.least);
            } else {
                // By the order, which mostly says enough of one segment less.
                let fewer = power(count as f64 / (count - 1).max(1) as f64, self.order as i32);
                if level.least * fewer > BEYOND * allowed {
                    beyond = count - 1;
                }
                let next = by_law(count, level.most);
                within = Some(Least { count, level });
                count = next;
            }
            if within
                .as_ref()
                .is_some_and(|least| least.count == beyond + 1)
            {
                return within;
            }
        }
    }
}

/// The largest change of a segment in a step, as a part of it, and the level that was aimed at.
struct LevelStep {
    change: f64,
    level: f64,
}

/// Moves the joints.
fn step(ways: &mut [f64], peaks: &[Peak]) -> Option<LevelStep> {
    // δ = a + b L.
    let mut steps = Vec::with_capacity(ways.len());
    let (mut a, mut b) = (0.0, 0.0);
    steps.push((a, b));
    for peak in peaks {
        let [before, after] = peak.slopes;
        a = -(libm::log(peak.size) + before * a) / after;
        b = (1.0 - before * b) / after;
        steps.push((a, b));
    }
    let level = -a / b;
    let moved = |(a, b): (f64, f64)| a + b * level;
    let change = steps
        .windows(2)
        .zip(ways.windows(2))
        .map(|(step, way)| ((moved(step[1]) - moved(step[0])) / (way[1] - way[0])).abs())
        .fold(0.0, f64::max);
    let part = (CHANGE / change).min(1.0);
    for (way, &step) in ways.iter_mut().zip(&steps).take(peaks.len()).skip(1) {
        *way += part * moved(step);
    }
    change.is_finite().then_some(LevelStep { change, level })
}

#[cfg(test)]
mod tests;
