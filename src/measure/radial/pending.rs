//! The parts of a segment that wait to be halved.

use core::cmp::Ordering;

use super::part::Part;

/// A part, how often it may be halved, and its bounds on either side: the largest of a heap is the one whose bound lies farthest above
/// what is known.
pub(super) struct Pending {
    pub(super) above: f64,
    pub(super) part: Part,
    pub(super) cuts: u32,
    pub(super) bounds: [f64; 2],
}

impl Ord for Pending {
    fn cmp(&self, other: &Self) -> Ordering {
        self.above.total_cmp(&other.above)
    }
}

impl PartialOrd for Pending {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Pending {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Pending {}
