//! SVG 2 path data as segments with byte spans: a command letter with one set of arguments each.

use super::number;

/// One command and one set of its arguments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Segment {
    /// The command letter; for implicit repetition the one that applies (`L` after `M`).
    pub(super) letter: u8,
    /// Whether the letter stands in the text.
    pub(super) explicit: bool,
    /// The first byte: the letter, or the first argument of a repetition.
    pub(super) start: usize,
    /// The first byte of the first argument.
    pub(super) arguments: usize,
    /// The first byte of the end point's text (of the last argument for `H` and `V`).
    pub(super) tail: usize,
    /// The index behind the last argument.
    pub(super) end: usize,
}

impl Segment {
    /// The command as a small letter.
    pub(super) const fn kind(&self) -> u8 {
        self.letter.to_ascii_lowercase()
    }

    /// The arguments, flags as 0 or 1; `None` where one is beyond `f64`.
    pub(super) fn values(&self, data: &str) -> Option<[f64; 7]> {
        let mut values = [0.0; 7];
        let (count, _) = arguments(self.kind());
        let mut at = self.arguments;
        for (index, value) in values.iter_mut().enumerate().take(count) {
            let start = at
                + data.as_bytes()[at..]
                    .iter()
                    .take_while(|b| is_separator(**b))
                    .count();
            if is_flag(self.kind(), index) {
                *value = f64::from(data.as_bytes()[start] - b'0');
                at = start + 1;
            } else {
                (*value, at) = number::read(data.as_bytes(), start)?;
            }
        }
        Some(values)
    }

    /// The end point's numbers (for `H` and `V` the one there is); `None` where one is beyond `f64`.
    pub(super) fn end_values(&self, data: &str) -> Option<[f64; 2]> {
        let (first, behind) = number::read(data.as_bytes(), self.tail)?;
        if matches!(self.kind(), b'h' | b'v') {
            return Some([first, 0.0]);
        }
        let second = behind
            + data.as_bytes()[behind..]
                .iter()
                .take_while(|b| is_separator(**b))
                .count();
        Some([first, number::read(data.as_bytes(), second)?.0])
    }

    /// Whether coordinates count from the current point.
    pub(super) const fn is_relative(&self) -> bool {
        self.letter.is_ascii_lowercase()
    }
}

/// Reads path data up to its end or its first error.
#[derive(Debug, Clone)]
pub(super) struct Segments<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The letter that a further set of arguments repeats.
    repeated: Option<u8>,
    /// Whether a command has been read: the first has to be a `moveto`.
    begun: bool,
    /// Where the grammar broke, if it did.
    error: Option<usize>,
}

/// The number of arguments, and the index of the argument that begins the end point.
const fn arguments(kind: u8) -> (usize, usize) {
    match kind {
        b'm' | b'l' | b't' => (2, 0),
        b'h' | b'v' => (1, 0),
        b's' | b'q' => (4, 2),
        b'c' => (6, 4),
        b'a' => (7, 5),
        _ => (0, 0),
    }
}

const fn is_flag(kind: u8, index: usize) -> bool {
    kind == b'a' && (index == 3 || index == 4)
}

const fn is_separator(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0c | b',')
}

#[inline]
fn behind_space(bytes: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\n' | b'\r' | 0x0c) = bytes.get(at) {
        at += 1;
    }
    at
}

/// The index behind white space with at most one comma.
#[inline]
fn behind_separator(bytes: &[u8], at: usize) -> usize {
    // Digits, points and minus signs lie above, white space and commas do not.
    if bytes.get(at).is_some_and(|byte| *byte > b',') {
        return at;
    }
    let at = behind_space(bytes, at);
    if bytes.get(at) == Some(&b',') {
        behind_space(bytes, at + 1)
    } else {
        at
    }
}

impl<'a> Segments<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self {
            bytes: text.as_bytes(),
            at: 0,
            repeated: None,
            begun: false,
            error: None,
        }
    }

    /// The index at which the data stop being path data; what stands behind it is not drawn.
    pub(super) const fn error(&self) -> Option<usize> {
        self.error
    }

    #[inline]
    fn skip_space(&mut self) {
        self.at = behind_space(self.bytes, self.at);
    }

    /// The arguments of a command whose letter has been read; `None` at an error.
    fn segment(&mut self, letter: u8, explicit: bool, start: usize) -> Option<Segment> {
        let kind = letter.to_ascii_lowercase();
        let (count, tail_index) = arguments(kind);
        let mut segment = Segment {
            letter,
            explicit,
            start,
            arguments: self.at,
            tail: self.at,
            end: self.at,
        };
        let mut at = self.at;
        for index in 0..count {
            if index > 0 {
                at = behind_separator(self.bytes, at);
            }
            if index == tail_index {
                segment.tail = at;
            }
            at = if is_flag(kind, index) {
                matches!(self.bytes.get(at), Some(b'0' | b'1')).then_some(at + 1)?
            } else {
                number::skip(self.bytes, at)?
            };
            segment.end = at;
        }
        self.at = at;
        if count == 0 {
            segment.end = start + 1;
        }
        Some(segment)
    }

    /// A segment that begins with its letter.
    fn command(&mut self, letter: u8) -> Option<Segment> {
        let start = self.at;
        let kind = letter.to_ascii_lowercase();
        if !matches!(
            kind,
            b'm' | b'l' | b'h' | b'v' | b'c' | b's' | b'q' | b't' | b'a' | b'z'
        ) || !self.begun && kind != b'm'
        {
            return None;
        }
        self.begun = true;
        self.at += 1;
        if kind == b'z' {
            self.repeated = None;
        } else {
            self.skip_space();
            self.repeated = Some(match letter {
                b'm' => b'l',
                b'M' => b'L',
                other => other,
            });
        }
        self.segment(letter, true, start)
    }

    /// A further set of arguments for the last letter.
    fn repetition(&mut self) -> Option<Segment> {
        let letter = self.repeated?;
        self.at = behind_separator(self.bytes, self.at);
        self.segment(letter, false, self.at)
    }

    fn fail<T>(&mut self, at: usize) -> Option<T> {
        self.error = Some(at);
        self.at = self.bytes.len();
        self.repeated = None;
        None
    }
}

impl Iterator for Segments<'_> {
    type Item = Segment;

    fn next(&mut self) -> Option<Segment> {
        self.skip_space();
        let start = self.at;
        let byte = *self.bytes.get(start)?;
        let segment = if byte.is_ascii_alphabetic() {
            self.command(byte)
        } else {
            self.repetition()
        };
        if segment.is_none() {
            self.fail(start)
        } else {
            segment
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn letters(text: &str) -> (String, Option<usize>) {
        let mut segments = Segments::new(text);
        let read: String = segments.by_ref().map(|s| s.letter as char).collect();
        (read, segments.error())
    }

    #[test]
    fn commands_repeat_implicitly() {
        assert_eq!(
            letters("M0 0 1 1l2,2-3-3zm1 1 2 2Z"),
            ("MLllzmlZ".to_owned(), None)
        );
        assert_eq!(
            letters(" m0 0h1 2v3 4q1 1 1 1t2 2c1 1 1 1 1 1s1 1 1 1"),
            ("mhhvvqtcs".to_owned(), None)
        );
        assert_eq!(letters(""), (String::new(), None));
    }

    #[test]
    fn reading_stops_at_the_first_error() {
        assert_eq!(letters("L0 0"), (String::new(), Some(0)));
        assert_eq!(letters("M0 0 L1 x"), ("M".to_owned(), Some(5)));
        assert_eq!(letters("M0 0,,1 1"), ("M".to_owned(), Some(4)));
        assert_eq!(letters("M0 0z1 1"), ("Mz".to_owned(), Some(5)));
        assert_eq!(letters("M0 0a1 1 0 2 0 1 1"), ("M".to_owned(), Some(4)));
        assert_eq!(letters("M0 0b1"), ("M".to_owned(), Some(4)));
        assert_eq!(letters("M0 0 L1 1, L2 2"), ("ML".to_owned(), Some(9)));
        assert_eq!(letters("none"), (String::new(), Some(0)));
    }

    #[test]
    fn compact_arcs_have_exact_spans() {
        let text = "M600,350a25,25-30 0150-25l 1,1";
        let arc = Segments::new(text).nth(1).unwrap();
        assert_eq!(&text[arc.start..arc.end], "a25,25-30 0150-25");
        assert_eq!(&text[arc.tail..arc.end], "50-25");
        assert_eq!(
            arc.values(text).unwrap(),
            [25.0, 25.0, -30.0, 0.0, 1.0, 50.0, -25.0]
        );
    }

    #[test]
    fn a_repeated_arc_begins_with_its_first_argument() {
        let text = "M0 0a1 1 0 0 1 2 2, .5.5 0 00.1.1";
        let arc = Segments::new(text).nth(2).unwrap();
        assert_eq!(&text[arc.start..arc.end], ".5.5 0 00.1.1");
        assert_eq!(
            arc.values(text).unwrap(),
            [0.5, 0.5, 0.0, 0.0, 0.0, 0.1, 0.1]
        );
        assert!(!arc.explicit);
    }
}
