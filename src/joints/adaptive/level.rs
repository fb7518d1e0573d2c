//! Joints at which the errors of all segments are alike, by Newton's method.
//!
//! With the logarithms e of the errors and the slopes p, q of each by its start and its end, a step δ of the joints that brings all of
//! them to one level L obeys e + p δ' + q δ = L, δ' that of the joint before: a recursion that is linear in L, and the last joint, which
//! stays, tells L.
//!
//! Of two cuts into as many segments one has a segment that contains one of the other's. Where a longer segment errs more, no
//! cut into as many segments therefore errs less than the least of these errors.

use super::lobes::{Lobes, Peak};
use super::{Balance, MOST};

/// The most steps, and the ratio of the largest to the least error that ends them.
const MOST_STEPS: usize = 12;
const ALIKE: f64 = 1.001;

/// The largest change of a segment in a step, as a part of it.
const CHANGE: f64 = 0.6;

/// How far the lobes' error may be from the true one, as a part of it.
const LOBES_OFF: f64 = 2e-3;

/// A cut whose errors are alike.
pub(super) struct Level {
    /// The ways to the joints, both ends included, in degrees.
    pub(super) ways: Vec<f64>,
    /// The least and the largest error, over the larger radius.
    pub(super) least: f64,
    pub(super) most: f64,
}

impl Level {
    /// The cut of `whole` degrees, which begin `from` degrees after the short axis, into this many segments; no more is computed once all
    /// of them err less than an edge, or more. `None` where the lobes do not tell.
    pub(super) fn new(
        lobes: &Lobes,
        from: f64,
        whole: f64,
        pieces: usize,
        edge: f64,
    ) -> Option<Self> {
        let mut ways = lobes.spread(from, whole, pieces);
        let mut peaks = Vec::with_capacity(pieces);
        for _ in 0..MOST_STEPS {
            peaks.clear();
            for pair in ways.windows(2) {
                peaks.push(lobes.of(from + pair[0], pair[1] - pair[0])?);
            }
            let sizes = || peaks.iter().map(|peak| peak.size);
            let least = sizes().fold(f64::INFINITY, f64::min);
            let most = sizes().fold(0.0, f64::max);
            let is_settled = least > edge || most < edge && edge.is_finite();
            if is_settled || most <= ALIKE * least {
                return Some(Self { ways, least, most });
            }
            step(&mut ways, &peaks)?;
        }
        None
    }
}

impl Balance {
    /// This many segments of equal error, of `whole` degrees from the start on, where the lobes tell it.
    pub(super) fn level(&self, whole: f64, pieces: usize, beyond: f64) -> Option<Level> {
        if !self.errors.is_quick() {
            return None;
        }
        Level::new(&self.lobes, self.past_axis(0.0), whole, pieces, beyond)
    }

    /// The least count of segments whose errors, over the larger radius, may all be within `allowed`: with one less they are beyond for
    /// any joints. `None` where the lobes do not tell.
    pub(crate) fn least_count(&self, allowed: f64) -> Option<usize> {
        let allowed = allowed * (1.0 + LOBES_OFF);
        let whole = self.computed(false);
        // What no count up to it can do.
        let mut beyond = ((whole / self.largest_angle).ceil() as usize).max(1) - 1;
        let by_law = |count: usize, error: f64| {
            let times = libm::pow(error / allowed, 1.0 / self.order);
            (count as f64 * times).min(MOST as f64).ceil() as usize
        };
        let quarters = whole / 90.0;
        let mean = f64::midpoint(1.0, libm::pow(self.errors.short(), 1.0 / self.order));
        let first = libm::pow(self.errors.on_circle(90.0) / allowed, 1.0 / self.order);
        let mut count = (quarters * mean * first).ceil().min(MOST as f64) as usize;
        let mut within = usize::MAX;
        for _ in 0..MOST_STEPS {
            count = count.clamp(beyond + 1, within - 1);
            let level = self.level(whole, count, allowed)?;
            if level.least > allowed {
                beyond = count;
                count = by_law(count, level.least);
            } else {
                within = count;
                count = by_law(count, level.most).min(count - 1);
            }
            if within == beyond + 1 {
                return Some(within);
            }
        }
        None
    }
}

/// Moves the joints.
fn step(ways: &mut [f64], peaks: &[Peak]) -> Option<()> {
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
    change.is_finite().then_some(())
}
