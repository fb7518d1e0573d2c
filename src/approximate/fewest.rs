//! The fewest segments within a tolerance.

use core::cell::OnceCell;
use core::ops::RangeInclusive;

use super::{Options, ROUNDING_SHARE, Request, Sketch};
use crate::error::{Error, ReachError, Remedy, Result};
use crate::joints::adaptive::{self, Balance};
use crate::joints::{Joints, MOST_SEGMENTS, Tolerance, quarters};
use crate::measure::radial;
use crate::method::{Method, Rule, Span};
use crate::number::{Precision, rounded_up};
use crate::numeric::functions::power;
use crate::place::Placed;
use crate::shape::Shape;
use equal::fewest_equal;

/// From this part of a tolerance on rounding tells which count serves.
const COARSE: f64 = 0.05;

/// How many counts beyond twice the estimate are looked at.
const MOST_BEYOND_TWICE: usize = 64;

/// How many counts are tried from the one on that marching takes.
const MOST_BEYOND: usize = 8;

/// How many counts below that one are tried where the marched joints may be too many.
const BELOW: usize = 2;

/// How far beyond a tolerance, as a part of it, all joints are tried that rounding may bring within.
const LUCK: f64 = 1.03;

/// The parts of a tolerance, the largest first, for which joints are marched out: the measure decides which of them serves.
const NEARLY: [f64; 14] = [
    1.1, 1.03, 0.99, 0.96, 0.93, 0.9, 0.87, 0.84, 0.8, 0.7, 0.6, 0.5, 0.4, 0.33,
];

/// By how much of a segment joints of equal error are moved where rounding alone brings them beyond a tolerance.
const NUDGES: [f64; 4] = [1e-3, -1e-3, 2e-3, -2e-3];

#[cfg(test)]
thread_local! {
    /// How many curves were cut: what a search costs, to one who counts.
    pub(super) static TRIES: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

/// A bound on how far rounding may bring a curve nearer to the true shape.
pub(crate) fn rounding(precision: Option<Precision>, tolerance: f64) -> f64 {
    match precision {
        Some(Precision::Fixed(decimals)) => power(10.0, -i32::from(decimals)),
        _ => tolerance * ROUNDING_SHARE,
    }
}

/// The finest tolerance that coordinates of such a size leave digits for.
pub(crate) const fn finest(reach: f64) -> f64 {
    8.0 * f64::EPSILON * reach
}

/// The count of a circle's equal segments from which on they are tried for a tolerance.
pub(crate) fn least_count(circle: &Shape, options: &Options, tolerance: f64) -> Option<usize> {
    let request = Request::new(circle, options).ok()??;
    Some(request.least_count(tolerance))
}

/// Joints that are marched out when they are asked for.
struct Marched<'a> {
    balance: &'a Balance,
    allowed: f64,
    parts: [OnceCell<Vec<Joints>>; NEARLY.len()],
}

impl<'a> Marched<'a> {
    const fn new(balance: &'a Balance, allowed: f64) -> Self {
        Self {
            balance,
            allowed,
            parts: [const { OnceCell::new() }; NEARLY.len()],
        }
    }

    /// Those for every so many of the parts of a tolerance.
    fn every(&self, step: usize) -> impl Iterator<Item = &Vec<Joints>> {
        let parts = self.parts.iter().zip(NEARLY).step_by(step);
        parts.map(|(joints, part)| {
            joints.get_or_init(|| self.balance.greedy(part * self.allowed).collect())
        })
    }

    /// The least count. The largest error takes it, but where a sharp end makes a longer segment err less: there some are looked at.
    fn least_count(&self) -> Option<usize> {
        if !self.balance.is_sharp() {
            return self.balance.marched_count(NEARLY[0] * self.allowed);
        }
        self.every(4).flatten().map(Joints::count).min()
    }

    /// Those of this count; a smaller error takes no fewer, with the same exception.
    fn of_count(&self, count: usize) -> impl Iterator<Item = &Joints> {
        let is_sharp = self.balance.is_sharp();
        let reaches =
            move |joints: &&Vec<Joints>| is_sharp || joints.iter().any(|all| all.count() <= count);
        let marched = self.every(1).take_while(reaches).flatten();
        marched.filter(move |joints| joints.count() == count)
    }
}

impl Request<'_> {
    /// The fewest segments whose rounded curve is within the tolerance.
    pub(super) fn fewest(&self, tolerance: Tolerance) -> Result<Sketch> {
        let truth = &self.outline.truth;
        let tolerance = tolerance.checked(truth.larger_radius())?;
        self.check_tolerance(tolerance)?;
        self.check_ends(tolerance)?;
        if self.is_hopeless(tolerance) {
            return Err(self.refusal(tolerance, None));
        }
        let balance = Balance::new(&self.outline, self.options.rule);
        if let Some(balance) = &balance
            && let Some(sketch) = self.fewest_adaptive(balance, tolerance)
        {
            return Ok(sketch);
        }
        let counts = self.counts(tolerance);
        let first = *counts.start();
        let (mut serves, mut last_refusal) = (false, None);
        let at = |count| {
            let joints = Joints::equal(&self.outline.unit, count);
            match joints.and_then(|joints| self.within(joints, None, tolerance)) {
                Ok(found) => {
                    serves = true;
                    found
                }
                Err(refusal) => {
                    last_refusal = Some(refusal);
                    None
                }
            }
        };
        let found = fewest_equal(counts, balance.is_none() || self.is_uneven(tolerance), at);
        let found = found.or_else(|| {
            let beyond = || self.fewest_by_doubling(balance.as_ref(), first, tolerance);
            serves.then(beyond).flatten()
        });
        found.ok_or_else(|| self.refusal(tolerance, last_refusal.filter(|_| !serves)))
    }

    /// Whether more segments may err more: those of a literal handle, and where rounding tells.
    fn is_uneven(&self, tolerance: f64) -> bool {
        let is_coarse = self.rounding(tolerance) > COARSE * tolerance;
        let is_fixed = matches!(self.options.precision, Some(Precision::Fixed(_)));
        matches!(self.options.rule, Rule::Handle(_)) || is_fixed && is_coarse
    }

    /// The curve through these joints, where it is within the tolerance as it is written; `told` as in [`Request::cut`].
    fn within(&self, joints: Joints, told: Option<f64>, tolerance: f64) -> Result<Option<Sketch>> {
        if self.has_joint_beyond(&joints, tolerance) {
            return Ok(None);
        }
        let mut sketch = self.cut(joints, told, Some(tolerance))?;
        Ok(self.is_within(&mut sketch, tolerance).then_some(sketch))
    }

    /// Whether rounding alone moves a joint of the true shape beyond the tolerance: then nothing else needs to be looked at.
    pub(super) fn has_joint_beyond(&self, joints: &Joints, tolerance: f64) -> bool {
        let truth = &self.outline.truth;
        match self.options.precision {
            Some(precision @ Precision::Fixed(_)) if adaptive::serves(self.options.rule) => {
                let allowed = tolerance + 16.0 * f64::EPSILON * self.reach();
                // The ends of an arc are looked at by themselves.
                let inner = usize::from(!joints.closed)..joints.count();
                Placed::new(&self.outline, joints)
                    .points(inner)
                    .any(|p| radial::distance(truth, precision.round_point(p)).abs() > allowed)
            }
            _ => false,
        }
    }

    /// Refuses tolerances that no curve could meet.
    pub(super) fn check_tolerance(&self, tolerance: f64) -> Result<()> {
        let finest = finest(self.reach());
        if tolerance < finest {
            let typed = rounded_up(finest, 2);
            let remedy = if self.may_reach(typed) {
                Remedy::FinestTolerance(typed)
            } else {
                Remedy::LargerToleranceAlone
            };
            return Err(self.out_of_reach(tolerance, ReachError::Digits, remedy));
        }
        Ok(())
    }

    /// Whether the error of the method falls as far as this, and the decimals that were asked for do not keep it from that.
    fn may_reach(&self, tolerance: f64) -> bool {
        let method = self.options.rule.method();
        let counts = self.counts(tolerance);
        method.is_some_and(|method| method.card().law.is_some())
            && self.too_few_decimals(tolerance).is_none()
            && counts.start() < counts.end()
    }

    /// Why no count was found; `refused` is what the method said where it serves none.
    pub(super) fn refusal(&self, tolerance: f64, refused: Option<Error>) -> Error {
        match (refused, self.too_few_decimals(tolerance)) {
            (Some(refused), _) => refused,
            (None, Some(decimals)) => self.out_of_reach(
                tolerance,
                ReachError::Decimals(decimals),
                Remedy::MoreDecimals,
            ),
            _ => self.out_of_reach(
                tolerance,
                ReachError::Order,
                Remedy::LargerToleranceOrOrder("minimax"),
            ),
        }
    }

    /// The decimals that were asked for where their last one is larger than the tolerance.
    pub(super) fn too_few_decimals(&self, tolerance: f64) -> Option<u8> {
        match self.options.precision {
            Some(Precision::Fixed(decimals)) => Some(decimals),
            _ => None,
        }
        .filter(|&decimals| power(10.0, -i32::from(decimals)) > tolerance)
    }

    fn out_of_reach(&self, tolerance: f64, why: ReachError, remedy: Remedy) -> Error {
        Error::ToleranceOutOfReach {
            method: self.options.rule.name(),
            tolerance,
            why,
            remedy,
        }
    }

    /// The fewest segments at joints that equalise the error, at equal angles where those are fewer, or each as long as it can be.
    fn fewest_adaptive(&self, balance: &Balance, tolerance: f64) -> Option<Sketch> {
        let within_if_told = |joints, told| self.within(joints, told, tolerance).ok().flatten();
        let within = |joints: Joints| within_if_told(joints, None);
        let radius = self.outline.truth.larger_radius();
        let allowed = (tolerance + self.rounding(tolerance)) / radius;
        // Rounding moves the error either way, and where the lobes do not tell it the weights know it to first order only.
        let marched = Marched::new(balance, allowed);
        let least = balance.least(allowed);
        let is_told = least.is_some();
        let first = least.as_ref().map(|least| least.count);
        let mut first = first.or_else(|| marched.least_count())?;
        if !is_told && balance.may_take_fewer(allowed) {
            first = first.saturating_sub(BELOW).max(1);
        }
        if !is_told && let Some(fewer) = self.least_equal(balance, first, tolerance) {
            return Some(fewer);
        }
        let mut begun = least.map(|least| least.level);
        let found = (first..=MOST_SEGMENTS)
            .take(BELOW + MOST_BEYOND)
            .find_map(|count| {
                let adaptive = balance.joints_from(count, begun.take(), LUCK * allowed);
                let told = adaptive.as_ref().and_then(|(_, told)| *told);
                let equal = || within(Joints::equal(&self.outline.unit, count).ok()?);
                let other = || {
                    // What rounding would have to bring far is not worth a look.
                    let near = LUCK * tolerance / radius;
                    let least = || balance.least(near).map(|least| least.count);
                    if is_told && least() > Some(count) {
                        return None;
                    }
                    if told.is_some() {
                        return self.nudged(balance, count, tolerance);
                    }
                    let mut all = marched.of_count(count);
                    let greedy = all.find_map(|joints| within(joints.clone()));
                    let narrowed = || balance.narrowed_joints(count).and_then(within);
                    greedy.or_else(narrowed)
                };
                let adaptive = adaptive.and_then(|(joints, told)| within_if_told(joints, told));
                adaptive.or_else(equal).or_else(other)
            })?;
        let count = found.curve.segments.len();
        let fewer = balance
            .may_be_beaten(allowed, first, count)
            .then(|| self.fewer_truly(balance, count, tolerance));
        let found = fewer.flatten().unwrap_or(found);
        let fewer = found.curve.segments.len() - 1;
        let mut leaping = balance.leaping(fewer, LUCK * allowed);
        Some(leaping.find_map(within).unwrap_or(found))
    }

    /// This many segments whose error is alike and that rounding alone brings beyond the tolerance: that of other joints may not.
    fn nudged(&self, balance: &Balance, count: usize, tolerance: f64) -> Option<Sketch> {
        let (joints, _) = balance.joints_from(count, None, f64::INFINITY)?;
        let unit = &self.outline.unit;
        let mut nudged = NUDGES.iter().map(|part| joints.nudged(unit, *part));
        nudged.find_map(|joints| self.within(joints, None, tolerance).ok()?)
    }

    /// The counts that may be the fewest, ascending.
    fn counts(&self, tolerance: f64) -> RangeInclusive<usize> {
        let sweep = self.outline.unit.sweep.degrees().abs();
        let rule = self.options.rule;
        let quarters = quarters(self.outline.unit.sweep);
        let (first, last) = match rule {
            Rule::Method(Method::LancasterBest) => (1, 8),
            Rule::Method(Method::LancasterDrawellipse) => (quarters, quarters),
            Rule::Method(Method::MinimaxEllipseFree) if !self.outline.truth.is_circle() => {
                (quarters, quarters)
            }
            // On an open arc its ends have the circle's derivatives, and it errs less than on a closed shape, which the estimate knows.
            Rule::Method(Method::Chen1) if !self.outline.unit.closed => {
                ((self.least_count(tolerance) / 2).max(1), MOST_SEGMENTS)
            }
            // The error of a literal handle is least near its own angle and grows again beyond it.
            Rule::Handle(k) => (
                1,
                (sweep / (4.0 * libm::atan(0.75 * k.abs())).to_degrees()).min(1e4) as usize + 3,
            ),
            _ => (self.least_count(tolerance), MOST_SEGMENTS),
        };
        // Rounding and the error of joints beyond the estimate ask for a few more segments; a rule whose error does not fall ends here.
        first..=last.min(2 * first + MOST_BEYOND_TWICE)
    }

    fn rounding(&self, tolerance: f64) -> f64 {
        rounding(self.options.precision, tolerance)
    }

    /// A count below which even the flattest place of the shape would be beyond the tolerance; more than the most where that
    /// one is not enough.
    fn least_count(&self, tolerance: f64) -> usize {
        let truth = &self.outline.truth;
        let sweep = self.outline.unit.sweep.degrees().abs();
        let allowed = (tolerance + self.rounding(tolerance)) / truth.radii.x.min(truth.radii.y);
        let beyond = |count: usize| {
            self.options
                .rule
                .radial_error(&Span::from_degrees(sweep / count as f64))
                .map_or(true, |error| error.peak() > allowed)
        };
        // From the count that the method's order asks for, in growing steps.
        let (mut high, mut step) = (self.count_by_order(allowed), 1);
        let mut low = high - 1;
        if beyond(high) {
            while high < MOST_SEGMENTS && beyond(high) {
                (low, high, step) = (high, (high + step).min(MOST_SEGMENTS), 2 * step);
            }
        } else {
            while low > 0 && !beyond(low) {
                (low, high, step) = (low.saturating_sub(step), low, 2 * step);
            }
        }
        while low + 1 < high {
            let middle = usize::midpoint(low, high);
            if beyond(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        if high >= MOST_SEGMENTS && beyond(MOST_SEGMENTS) {
            return MOST_SEGMENTS + 1;
        }
        high.clamp(1, MOST_SEGMENTS)
    }

    /// About how many equal segments err so much on the unit circle: as many as the leading term asks for.
    fn count_by_order(&self, allowed: f64) -> usize {
        let sweep = self.outline.unit.sweep.degrees().abs().to_radians();
        let law = self
            .options
            .rule
            .method()
            .and_then(|method| method.card().law);
        law.map_or(1, |law| {
            let count = sweep * libm::pow(law.constant / allowed, 1.0 / f64::from(law.order));
            (count.ceil() as usize).clamp(1, MOST_SEGMENTS)
        })
    }
}

mod equal;
mod hopeless;
mod truly;

#[cfg(test)]
mod checks;
#[cfg(test)]
mod costs;
