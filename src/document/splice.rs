//! The output: the source, byte for byte, with replacements where it was told so.

use core::ops::Range;

/// Copies a text lazily; edits come in the order of their place.
#[derive(Debug)]
pub(super) struct Splice<'a> {
    source: &'a str,
    out: Vec<u8>,
    copied: usize,
    /// The most bytes that the new text may have.
    most: usize,
    /// Whether it became more: it is of no use then, and takes no memory.
    is_full: bool,
}

impl<'a> Splice<'a> {
    pub(super) const fn new(source: &'a str, most: usize) -> Self {
        Self {
            source,
            out: Vec::new(),
            copied: 0,
            most,
            is_full: false,
        }
    }

    /// Whether the new text became too long.
    pub(super) const fn is_full(&self) -> bool {
        self.is_full || self.out.len() > self.most
    }

    /// The bytes of `range` become what is appended to the text that this gives. Ranges ascend and do not overlap.
    pub(super) fn edit(&mut self, range: Range<usize>) -> &mut Vec<u8> {
        if self.is_full() {
            (self.out, self.is_full) = (Vec::new(), true);
            return &mut self.out;
        }
        if self.copied == 0 {
            self.out.reserve(self.source.len() / 2 * 3);
        }
        if let Some(kept) = self.source.as_bytes().get(self.copied..range.start) {
            self.out.extend_from_slice(kept);
        }
        self.copied = range.end;
        &mut self.out
    }

    /// The bytes of `range` become `text`.
    pub(super) fn replace(&mut self, range: Range<usize>, text: &[u8]) {
        self.edit(range).extend_from_slice(text);
    }

    /// The finished text; `None` where nothing was replaced.
    pub(super) fn finish(mut self) -> Option<String> {
        if self.copied == 0 {
            return None;
        }
        self.out.extend_from_slice(
            self.source
                .get(self.copied..)
                .unwrap_or_default()
                .as_bytes(),
        );
        // Whole pieces of a text, and ASCII between them.
        Some(
            String::from_utf8(self.out)
                .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_replaced_stays() {
        let mut splice = Splice::new("abcdef", 100);
        splice.replace(1..2, b"XY");
        splice.replace(4..4, b"-");
        assert_eq!(splice.finish().as_deref(), Some("aXYcd-ef"));
        assert_eq!(Splice::new("abc", 100).finish(), None);
    }

    #[test]
    fn a_text_that_grows_too_long_takes_no_memory() {
        let mut splice = Splice::new("abcdef", 100);
        for at in 0..6 {
            splice.replace(at..at, &[b'x'; 30]);
            assert_eq!(splice.is_full(), at >= 3);
        }
        // The last piece alone.
        assert_eq!(splice.out.len(), 30);
    }
}
