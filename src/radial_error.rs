//! How far a curve strays from the true shape, outside and inside.

use crate::error::{Error, Result};
use crate::number::rounded_up;

/// The largest distances of a curve from the true shape, both at least 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RadialError {
    /// The largest distance outside.
    pub outward: f64,
    /// The largest distance inside.
    pub inward: f64,
}

/// Refuses what rounding takes farther away than a tolerance.
pub(crate) fn within(distance: f64, tolerance: f64) -> Result<()> {
    if distance <= tolerance {
        return Ok(());
    }
    let distance = rounded_up(distance, 3);
    Err(Error::Rounding {
        distance,
        tolerance,
    })
}

impl RadialError {
    /// The larger of the two.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.outward.max(self.inward)
    }

    /// The smaller of the two.
    pub(crate) fn smaller(&self) -> f64 {
        self.outward.min(self.inward)
    }

    /// The same distance on both sides.
    #[must_use]
    pub(crate) const fn balanced(distance: f64) -> Self {
        Self {
            outward: distance,
            inward: distance,
        }
    }

    /// The larger of both on either side.
    #[must_use]
    pub(crate) fn with(self, other: Self) -> Self {
        Self {
            outward: self.outward.max(other.outward),
            inward: self.inward.max(other.inward),
        }
    }

    /// The distances after everything may have moved so far.
    #[must_use]
    pub(crate) fn with_more(self, moved: f64) -> Self {
        Self {
            outward: self.outward + moved,
            inward: self.inward + moved,
        }
    }

    /// The distances where everything is this many times as large.
    #[must_use]
    pub(crate) fn times(self, factor: f64) -> Self {
        Self {
            outward: self.outward * factor,
            inward: self.inward * factor,
        }
    }

    /// The range of signed distances, positive outside.
    pub(crate) fn of_range(signed: impl IntoIterator<Item = f64>) -> Self {
        let mut range = Self::default();
        range.take_in_all(signed);
        range
    }

    /// Widens the range by signed distances, positive outside.
    pub(crate) fn take_in_all(&mut self, signed: impl IntoIterator<Item = f64>) {
        for distance in signed {
            self.outward = self.outward.max(distance);
            self.inward = self.inward.max(-distance);
        }
    }
}
