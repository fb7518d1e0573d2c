//! Where a pass writes: the new text, and the notes with their places.

use core::ops::Range;

use super::Note;
use super::path::arcs;
use super::reason::Reason;
use super::splice::Splice;
use super::xml::place::Places;

/// The new text, and the notes.
pub(super) struct NewText<'a> {
    pub(super) splice: Splice<'a>,
    pub(super) places: Places<'a>,
    pub(super) notes: Vec<Note>,
}

impl NewText<'_> {
    pub(super) fn note(&mut self, element: &'static str, at: usize, reason: Reason) {
        let (line, column) = self.places.locate(at);
        let note = Note {
            line,
            column,
            element,
            reason,
        };
        // What keeps a path from being a shape may keep its curves from being arcs.
        if self.notes.last() != Some(&note) {
            self.notes.push(note);
        }
    }
}

/// Brings edits of path data to their place in the file.
pub(super) struct EditSink<'r, 'a> {
    pub(super) output: &'r mut NewText<'a>,
    /// The name of the element whose data they are.
    pub(super) element: &'static str,
    /// Where the value begins, and the way back from resolved references, where there are some.
    pub(super) origin: Option<(usize, &'r [usize])>,
}

impl EditSink<'_, '_> {
    fn place(&self, at: usize) -> usize {
        self.origin.map_or(at, |(base, origin)| {
            base + origin.get(at).copied().unwrap_or(at)
        })
    }
}

impl arcs::Sink for EditSink<'_, '_> {
    fn edit(&mut self, range: Range<usize>) -> &mut Vec<u8> {
        let range = self.place(range.start)..self.place(range.end);
        self.output.splice.edit(range)
    }

    fn is_full(&self) -> bool {
        self.output.splice.is_full()
    }

    fn note(&mut self, at: usize, reason: Reason) {
        let place = self.place(at);
        self.output.note(self.element, place, reason);
    }
}
