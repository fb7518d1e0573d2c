//! The largest distance of any point of a curve, part by part: what is not within the bound is halved.

use std::collections::VecDeque;

/// How far above the largest distance that is found its bound may lie, as a part of it.
pub(super) const SLACK: f64 = 0.9e-9;

/// How many parts are halved at most where there is a tolerance, beside some for each segment.
const MOST_FOR_TOLERANCE: usize = 200;

/// What ends a search: what is left then is bounded roughly.
pub(super) struct Bounds {
    /// What rounding may leave of a distance, and what one that is more is at least.
    pub(super) least: f64,
    pub(super) floor: f64,
    /// A bound beyond it may be any that is beyond.
    pub(super) limit: f64,
    /// How often a part is halved at most.
    pub(super) most_cuts: u32,
    /// How many parts are halved at most for a statement, beside some for each segment.
    pub(super) most_parts: usize,
}

impl Bounds {
    /// Bounds the distances of all parts of a curve beside one of so many segments, beginning with a bound that need not hold.
    pub(super) fn bound<H: Halving>(
        &self,
        search: &H,
        parts: impl IntoIterator<Item = H::Part>,
        segments: usize,
        mut bound: f64,
    ) -> f64 {
        let parts = parts.into_iter().map(|part| (part, self.most_cuts));
        let mut pending: VecDeque<(H::Part, u32)> = parts.collect();
        let most = if self.limit.is_finite() {
            MOST_FOR_TOLERANCE
        } else {
            self.most_parts
        };
        let mut left = most + 64 * segments;
        while let Some((part, cuts)) = pending.pop_front() {
            let (halves, places) = search.halves(&part);
            for place in &places {
                let distance = search.distance(place);
                if distance > self.least {
                    bound = bound.max(self.floor).max(distance * (1.0 + SLACK));
                }
            }
            if bound > self.limit {
                return bound;
            }
            if search.is_within(&part, &places, bound) {
                continue;
            }
            if cuts == 0 || left == 0 {
                bound = bound.max(search.roughly(&part, &places));
                continue;
            }
            left -= 1;
            pending.extend(halves.map(|half| (half, cuts - 1)));
        }
        bound
    }
}

/// What the parts of a curve tell.
pub(super) trait Halving {
    type Part;
    /// What is known of a point.
    type Place;

    /// The halves of a part, and its start, middle and end.
    fn halves(&self, part: &Self::Part) -> ([Self::Part; 2], [Self::Place; 3]);

    fn distance(&self, place: &Self::Place) -> f64;

    /// Whether no point of a part is farther than that.
    fn is_within(&self, part: &Self::Part, places: &[Self::Place; 3], most: f64) -> bool;

    /// A bound that always holds.
    fn roughly(&self, part: &Self::Part, places: &[Self::Place; 3]) -> f64;
}
