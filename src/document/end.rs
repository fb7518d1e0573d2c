//! What path data that are being written end with.

use super::decimal::After;
use super::path_data::Segment;

/// What the output ends with.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct End {
    /// The command letter that a number without one would repeat; 0 where the letter has to be written.
    pub(super) letter: u8,
    /// Behind an arc that was replaced: what its text ends with.
    pub(super) after: After,
}

impl End {
    /// Writes the letter of what an arc becomes, where it is needed.
    pub(super) fn letter(&mut self, out: &mut Vec<u8>, arc: &Segment, small: u8) {
        let letter = if arc.is_relative() {
            small
        } else {
            small.to_ascii_uppercase()
        };
        if arc.explicit || self.letter != letter {
            out.push(letter);
            self.after = After::Letter;
        }
        self.letter = letter;
    }
}
