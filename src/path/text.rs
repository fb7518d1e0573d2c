//! The text of path data: which letter is written, and what parts numbers.

use crate::number::decimal::{After, BelowOne, Decimal};

/// What path data that are being written end with.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathText {
    pub(crate) after: After,
    /// The command that numbers without a letter would repeat; 0 where the letter has to be written.
    pub(crate) letter: u8,
    form: BelowOne,
}

impl PathText {
    /// Path data of which nothing is written yet. In the plain form each command has its letter, in the short one only those that
    /// need it.
    pub(crate) const fn new(form: BelowOne) -> Self {
        Self {
            after: After::Letter,
            letter: 0,
            form,
        }
    }

    /// Writes a command's letter, unless the form is short and numbers alone would repeat it.
    pub(crate) fn letter(&mut self, out: &mut Vec<u8>, letter: u8) {
        if self.form == BelowOne::Plain || self.letter != letter {
            out.push(letter);
            self.after = After::Letter;
        }
        self.letter = letter;
    }

    /// Writes a number.
    #[inline]
    pub(crate) fn push(&mut self, out: &mut Vec<u8>, number: Decimal) {
        self.after.push(out, number, self.form);
    }
}
