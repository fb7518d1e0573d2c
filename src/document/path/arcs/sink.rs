//! Where the edits of path data go.

use core::ops::Range;

use crate::document::reason::Reason;

/// Receives the edits, in order, and the notes with their place in the data.
pub(in crate::document) trait Sink {
    /// The bytes of `range` become what the caller appends to the text that this gives.
    fn edit(&mut self, range: Range<usize>) -> &mut Vec<u8>;
    /// Whether no more can be taken, so that the rest is of no use.
    fn is_full(&self) -> bool;
    /// The arc at `at` is left.
    fn note(&mut self, at: usize, reason: Reason);
}
