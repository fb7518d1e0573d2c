//! The fewest segments within a tolerance where estimates of their number are far too low.

use super::{Request, Sketch};
use crate::joints::Joints;
use crate::joints::adaptive::Balance;
use crate::measure::radial;

/// Up to this many segments they are doubled, if that leaves no more than such a part of the error.
const MOST_DOUBLED: usize = 50_000;
const FALLING: f64 = 0.7;

impl Request<'_> {
    /// Counts are doubled as long as that brings the error down, and halved in between.
    pub(super) fn fewest_by_doubling(
        &self,
        balance: Option<&Balance>,
        first: usize,
        tolerance: f64,
    ) -> Option<Sketch> {
        if self.too_few_decimals(tolerance).is_some() || first > MOST_DOUBLED {
            return None;
        }
        let truth = &self.outline.truth;
        // The nearer of both ways to place joints.
        let at = |count: usize| {
            let adaptive = balance.and_then(|all| all.joints_from(count, None, f64::INFINITY));
            let equal = Joints::equal(&self.outline.unit, count).ok();
            let joints = adaptive.map(|(joints, _)| joints).into_iter().chain(equal);
            let sketches = joints.filter_map(|joints| self.cut(joints, None, Some(tolerance)).ok());
            let measured = sketches.map(|mut sketch| {
                let curve = sketch.rounded();
                let error = radial::error(&curve.segments, truth);
                (sketch.measured, sketch.written) = (Some(error), Some(curve));
                (sketch, error.peak())
            });
            measured.min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let (mut low, mut high, mut before) = (first.max(1), first.max(1), f64::INFINITY);
        let mut found = loop {
            let (sketch, error) = at(high)?;
            if error <= tolerance {
                break sketch;
            }
            if error > FALLING * before || high >= MOST_DOUBLED {
                return None;
            }
            (low, high, before) = (high, 2 * high, error);
        };
        while low + 1 < high {
            let middle = usize::midpoint(low, high);
            match at(middle) {
                Some((sketch, error)) if error <= tolerance => (found, high) = (sketch, middle),
                _ => low = middle,
            }
        }
        Some(found)
    }
}
