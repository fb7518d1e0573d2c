//! What is known of the largest distance on either side while it is searched: 0 is outside, 1 inside.

/// A bound that is above a known distance by so little is stated, as a share of the distance.
const CLOSE: f64 = 1e-11;

/// The same where the peak has to be known nearly only.
const NEARLY: f64 = 0.01;

/// What is known of one segment or of several from the same shape, over the larger radius.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    /// What the largest distance is at least.
    least: [f64; 2],
    /// The largest that was stated.
    stated: [f64; 2],
    /// Where it is more than this, nothing more is asked.
    limit: f64,
    close: f64,
}

impl Default for Known {
    fn default() -> Self {
        Self {
            least: [0.0; 2],
            stated: [0.0; 2],
            limit: f64::INFINITY,
            close: CLOSE,
        }
    }
}

impl Known {
    /// What makes all pass that is at most so large.
    pub(crate) fn within(limit: f64) -> Self {
        Self {
            least: [limit; 2],
            stated: [limit; 2],
            limit,
            close: CLOSE,
        }
    }

    /// For a peak that has to be known nearly, and not at all beyond a limit.
    pub(crate) fn nearly(limit: f64) -> Self {
        Self {
            limit,
            close: NEARLY,
            ..Self::default()
        }
    }

    /// Whether it is more than the limit for certain.
    pub(crate) fn is_beyond(&self) -> bool {
        self.peak() > self.limit
    }

    /// What the larger of both is at least.
    pub(crate) fn peak(&self) -> f64 {
        self.least[0].max(self.least[1])
    }

    /// Whether a bound on a part leaves open that it lies farther than what is known.
    pub(super) fn is_open(&self, side: usize, bound: f64) -> bool {
        bound > self.stated[side] && bound >= self.least[side]
    }

    /// The same on any side.
    pub(super) fn is_any_open(&self, bounds: [f64; 2]) -> bool {
        self.is_open(0, bounds[0]) || self.is_open(1, bounds[1])
    }

    /// Whether a bound is so little above what is known that it may be stated.
    pub(super) fn is_close(&self, side: usize, bound: f64, rounding: f64) -> bool {
        bound <= self.least[side] * (1.0 + self.close) + rounding
    }

    /// How little that is on both sides.
    pub(super) fn close_by(&self) -> f64 {
        self.close * self.least[0].min(self.least[1])
    }

    /// How far bounds lie above what is known, at most.
    pub(super) fn most_above(&self, bounds: [f64; 2]) -> f64 {
        (bounds[0] - self.least[0]).max(bounds[1] - self.least[1])
    }

    /// Takes that it is at least so large.
    pub(super) fn learn(&mut self, side: usize, least: f64) {
        self.least[side] = self.least[side].max(least);
    }

    /// Takes that so much was stated.
    pub(super) fn state(&mut self, side: usize, most: f64) {
        self.stated[side] = self.stated[side].max(most);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_is_open_above_what_is_known_and_what_was_stated() {
        let mut known = Known::default();
        known.learn(0, 0.25);
        known.learn(1, 0.5);
        known.learn(1, 0.125);
        assert_eq!((known.least, known.peak()), ([0.25, 0.5], 0.5));
        assert!(!known.is_open(0, 0.2) && known.is_open(0, 0.25) && known.is_open(0, 0.3));
        assert!(!known.is_open(1, 0.4) && known.is_open(1, 0.6));
        known.state(0, 0.375);
        known.state(0, 0.3);
        assert_eq!(known.stated, [0.375, 0.0]);
        assert!(!known.is_open(0, 0.375) && known.is_open(0, 0.4));
        for (bounds, is_open) in [
            ([0.4, 0.4], true),
            ([0.3, 0.6], true),
            ([0.4, 0.6], true),
            ([0.3, 0.4], false),
        ] {
            assert_eq!(known.is_any_open(bounds), is_open, "{bounds:?}");
        }
        assert_eq!(known.most_above([0.5, 0.5]), 0.25);
        assert_eq!(known.most_above([0.25, 0.625]), 0.125);
        // Infinite is the limit, which nothing is beyond.
        assert!(!known.is_beyond());
    }

    #[test]
    fn a_bound_is_close_by_a_share_or_by_rounding() {
        let mut known = Known::default();
        known.learn(0, 2.0);
        known.learn(1, 4.0);
        assert!(known.is_close(0, 2.0 + 1.9e-11, 0.0) && !known.is_close(0, 2.0 + 2.1e-11, 0.0));
        assert!(known.is_close(1, 4.0 + 3.9e-11, 0.0));
        assert!(known.is_close(0, 2.4, 0.5) && !known.is_close(0, 2.6, 0.5));
        assert!((known.close_by() - 2e-11).abs() < 1e-20);
        let mut nearly = Known::nearly(3.0);
        nearly.learn(0, 2.0);
        assert!(nearly.is_close(0, 2.019, 0.0) && !nearly.is_close(0, 2.021, 0.0));
        assert!(!nearly.is_beyond() && nearly.is_open(1, 0.1));
        nearly.learn(1, 3.0);
        assert!(!nearly.is_beyond());
        nearly.learn(1, 3.1);
        assert!(nearly.is_beyond());
    }

    #[test]
    fn within_a_limit_nothing_is_open() {
        let mut known = Known::within(0.5);
        assert!(!known.is_any_open([0.5; 2]) && known.is_any_open([0.0, 0.51]));
        assert!(!known.is_beyond());
        known.learn(0, 0.51);
        assert!(known.is_beyond());
    }
}
