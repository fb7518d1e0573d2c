//! Byte offsets as lines and columns.

/// Counts forwards from the last place asked for, so that many notes on one long line stay linear.
#[derive(Debug)]
pub(in crate::document) struct Places<'a> {
    text: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Places<'a> {
    pub(in crate::document) const fn new(text: &'a str) -> Self {
        Self {
            text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// The line and the column of a byte offset, both counted from 1; columns count characters, and a byte order mark is none.
    pub(in crate::document) fn locate(&mut self, offset: usize) -> (usize, usize) {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        if offset < self.offset {
            *self = Self::new(self.text);
        }
        for (at, character) in self.text[self.offset..].char_indices() {
            if self.offset + at >= offset {
                break;
            }
            match character {
                '\n' => {
                    self.line += 1;
                    self.column = 1;
                }
                '\u{feff}' if self.offset + at == 0 => {}
                _ => self.column += 1,
            }
        }
        self.offset = offset;
        (self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_and_lines_end_at_line_feeds() {
        let text = "\u{feff}añb\r\nxy";
        let mut places = Places::new(text);
        assert_eq!(places.locate(text.find('b').unwrap()), (1, 3));
        assert_eq!(places.locate(text.find('y').unwrap()), (2, 2));
        assert_eq!(places.locate(text.find('a').unwrap()), (1, 1));
        assert_eq!(places.locate(text.len()), (2, 3));
        assert_eq!(places.locate(1 << 20), (2, 3));
        // A byte within a character has the character's place.
        let letter = text.find('ñ').unwrap();
        for offset in [letter, letter + 1, letter + 2] {
            let column = if offset < letter + 2 { 2 } else { 3 };
            assert_eq!(places.locate(offset), (1, column));
        }
        assert_eq!(Places::new("a\u{feff}b").locate(4), (1, 3));
    }
}
