//! What a heap holds that gives out the largest first.

use core::cmp::Ordering;

/// Something that is ordered by a number alone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ranked<T> {
    pub(crate) rank: f64,
    pub(crate) of: T,
}

impl<T> Ord for Ranked<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank.total_cmp(&other.rank)
    }
}

impl<T> PartialOrd for Ranked<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T> PartialEq for Ranked<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<T> Eq for Ranked<T> {}
