//! SVG 2 path data as segments with byte spans: a command letter with one set of arguments each.

mod fault;
pub(crate) mod grammar;

use core::ops::Range;

use kurbo::Vec2;

use crate::number::read as number;
pub(crate) use fault::PathFault;
use grammar::{after_arc_shape, after_arguments, after_numbers, after_separator, after_space};

/// One command and one set of its arguments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Segment {
    /// The command letter; for implicit repetition the one that applies (`L` after `M`).
    pub(crate) letter: u8,
    /// Whether the letter stands in the text.
    pub(crate) explicit: bool,
    /// The first byte: the letter, or the first argument of a repetition.
    pub(crate) start: usize,
    /// The first byte of the first argument.
    pub(crate) arguments: usize,
    /// The first byte of the end point's text (of the last argument for `H` and `V`); the end where the arc is known.
    pub(crate) tail: usize,
    /// The index after the last argument.
    pub(crate) end: usize,
    /// The end point's numbers, for `H` and `V` the one there is, if they are wanted; infinite where one is beyond `f64`.
    pub(crate) to: [f64; 2],
}

impl Segment {
    /// The command as a small letter.
    pub(crate) const fn kind(&self) -> u8 {
        self.letter.to_ascii_lowercase()
    }

    /// Whether coordinates count from the current point.
    pub(crate) const fn is_relative(&self) -> bool {
        self.letter.is_ascii_lowercase()
    }

    /// Whether the end point's numbers are within `f64`.
    pub(crate) const fn is_finite(&self) -> bool {
        self.to[0].is_finite() && self.to[1].is_finite()
    }

    /// The texts of its numbers; of an arc, whose flags are no numbers, they are none.
    pub(crate) fn numbers<'t>(&self, text: &'t str) -> impl Iterator<Item = &'t str> + use<'t> {
        let (mut at, end) = (self.arguments, self.end);
        core::iter::from_fn(move || {
            let bytes = text.as_bytes();
            let start = at;
            let after = (start < end).then(|| number::skip(bytes, start))??;
            at = after_separator(bytes, after);
            text.get(start..after)
        })
    }

    /// Its first numbers, as many as it has; those of a segment that is no arc.
    pub(crate) fn values<const N: usize>(&self, text: &str) -> [f64; N] {
        let mut values = [0.0; N];
        let mut at = self.arguments;
        for value in &mut values {
            if at < self.end
                && let Some((number, end)) = number::read(text.as_bytes(), at)
            {
                *value = number;
                at = after_separator(text.as_bytes(), end);
            }
        }
        values
    }

    /// The arguments of an arc, flags as 0 or 1; `None` where it is none.
    pub(crate) fn arc_values(&self, text: &str) -> Option<[f64; 7]> {
        if !is_arc(self.letter) {
            return None;
        }
        let bytes = text.as_bytes();
        let mut values = [0.0; 7];
        let mut at = self.arguments;
        for (index, value) in values.iter_mut().enumerate() {
            if let 3 | 4 = index {
                *value = f64::from(bytes.get(at)? - b'0');
                at += 1;
            } else {
                (*value, at) = number::read(bytes, at)?;
            }
            at = after_separator(bytes, at);
        }
        Some(values)
    }
}

/// What a Bézier has before its end point, and how its numbers are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Handles {
    /// Its control points, as many as it spells.
    pub(crate) points: [Vec2; 2],
    /// The most decimals of its numbers; [`WITH_EXPONENT`](number::WITH_EXPONENT) where one has an exponent.
    pub(crate) decimals: u8,
}

/// Reads path data up to its end or its first error.
#[derive(Debug, Clone)]
pub(crate) struct Segments<'a> {
    bytes: &'a [u8],
    at: usize,
    end: usize,
    /// Whether the numbers of end points are wanted.
    wants_ends: bool,
    /// Those of the last Bézier, where they are wanted.
    handles: Option<Handles>,
    /// The letter that a further set of arguments repeats.
    repeated: Option<u8>,
    /// Whether a command has been read: the first has to be a `moveto`.
    begun: bool,
    /// Where the grammar broke, if it did.
    error: Option<usize>,
}

impl<'a> Segments<'a> {
    /// The path data in `text[span]`. After them the text ends or goes on with a quote, which no number does.
    pub(crate) const fn new(text: &'a str, span: Range<usize>) -> Self {
        Self {
            bytes: text.as_bytes(),
            at: span.start,
            end: span.end,
            wants_ends: false,
            handles: None,
            repeated: None,
            begun: false,
            error: None,
        }
    }

    /// The segments with the numbers of their end points.
    pub(crate) const fn with_ends(self, wants_ends: bool) -> Self {
        Self { wants_ends, ..self }
    }

    /// The same with the numbers of control points.
    pub(crate) const fn with_handles(self) -> Self {
        Self {
            wants_ends: true,
            handles: Some(Handles {
                points: [Vec2::ZERO; 2],
                decimals: 0,
            }),
            ..self
        }
    }

    /// What the last segment has, a Bézier, before its end point, where that is wanted.
    pub(crate) const fn handles(&self) -> Option<Handles> {
        self.handles
    }

    /// The index at which the data stop being path data; what stands after it is not drawn.
    pub(crate) const fn error(&self) -> Option<usize> {
        self.error
    }

    /// What is wrong at the error, to the byte.
    #[cold]
    pub(crate) fn fault(&self) -> Option<PathFault> {
        let at = self.error?;
        if !self.begun {
            return Some(PathFault::Unexpected(at));
        }
        Some(PathFault::find(self.bytes, at, self.repeated))
    }

    /// The index of the error, if it is a number too many or the first of too few.
    pub(crate) fn number_at_error(&self) -> Option<usize> {
        self.error
            .filter(|&at| number::skip(self.bytes, after_separator(self.bytes, at)).is_some())
    }

    /// The next segment, if it is a relative arc alone after its letter and `known` knows the text of its arguments, with what that
    /// gives: the index of the arc and its end point. Most arcs of icons have been met before, and are not read again.
    #[inline]
    pub(crate) fn next_known(
        &mut self,
        known: impl FnOnce(&[u8]) -> Option<(usize, [f64; 2])>,
    ) -> Option<(Segment, usize)> {
        let start = after_space(self.bytes, self.at);
        if !self.begun || self.bytes.get(start) != Some(&b'a') {
            return None;
        }
        let arguments = start + 1;
        let end = after_arguments(self.bytes, arguments).min(self.end);
        // What ends in the middle of a number is another one.
        if let Some(b'e' | b'E') = self.bytes.get(end) {
            return None;
        }
        let (index, to) = known(self.bytes.get(arguments..end)?)?;
        self.at = end;
        self.repeated = Some(b'a');
        let segment = Segment {
            letter: b'a',
            explicit: true,
            start,
            arguments,
            tail: end,
            end,
            to,
        };
        Some((segment, index))
    }

    /// Whether the data have an error right here where a reader that forgives it would find a smooth command: then an arc before it
    /// must stay an arc.
    pub(crate) fn is_broken_smooth(&self) -> bool {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let next = rest
            .iter()
            .find(|byte| !matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | b','));
        // Before a letter the data have not ended: nothing more is read where an error is.
        matches!(next, Some(b's' | b'S' | b't' | b'T')) && self.clone().next().is_none()
    }

    /// The arguments of a command whose letter has been read; `None` at an error.
    #[inline]
    fn segment(&mut self, letter: u8, explicit: bool, start: usize) -> Option<Segment> {
        let mut segment = Segment {
            letter,
            explicit,
            start,
            arguments: self.at,
            tail: self.at,
            end: self.at,
            to: [0.0; 2],
        };
        let (bytes, at) = (self.bytes, self.at);
        segment.tail = match segment.kind() {
            _ if self.handles.is_some() && is_bezier(letter) => {
                self.bezier(&mut segment)?;
                self.at = segment.end;
                return Some(segment);
            }
            b'm' | b'l' | b't' | b'h' | b'v' => at,
            b's' | b'q' => after_numbers::<2>(bytes, at)?,
            b'c' => after_numbers::<4>(bytes, at)?,
            b'a' => after_arc_shape(bytes, at)?,
            b'z' => return Some(segment),
            _ => return None,
        };
        let single = matches!(segment.kind(), b'h' | b'v');
        if self.wants_ends {
            (segment.to[0], segment.end) = number::read(bytes, segment.tail)?;
            if !single {
                let second = after_separator(bytes, segment.end);
                (segment.to[1], segment.end) = number::read(bytes, second)?;
            }
        } else {
            segment.end = number::skip(bytes, segment.tail)?;
            if !single {
                segment.end = number::skip(bytes, after_separator(bytes, segment.end))?;
            }
        }
        self.at = segment.end;
        Some(segment)
    }

    /// Reads all numbers of a Bézier.
    #[inline]
    fn bezier(&mut self, segment: &mut Segment) -> Option<()> {
        let (bytes, mut at) = (self.bytes, self.at);
        let inner = match segment.kind() {
            b't' => 0,
            b'c' => 4,
            _ => 2,
        };
        let (mut values, mut most) = ([0.0; 6], 0);
        for (index, value) in values[..inner + 2].iter_mut().enumerate() {
            if index > 0 {
                at = after_separator(bytes, at);
            }
            if index == inner {
                segment.tail = at;
            }
            let decimals;
            (*value, at, decimals) = number::read_counted(bytes, at)?;
            most = most.max(decimals);
        }
        segment.end = at;
        segment.to = [values[inner], values[inner + 1]];
        let [a, b, c, d, ..] = values;
        self.handles = Some(Handles {
            points: [Vec2::new(a, b), Vec2::new(c, d)],
            decimals: most,
        });
        Some(())
    }

    /// A segment that begins with its letter.
    #[inline]
    fn command(&mut self, letter: u8) -> Option<Segment> {
        let start = self.at;
        if !self.begun && !matches!(letter, b'm' | b'M') {
            return None;
        }
        self.begun = true;
        self.at += 1;
        self.repeated = match letter {
            b'm' => Some(b'l'),
            b'M' => Some(b'L'),
            b'z' | b'Z' => None,
            other => Some(other),
        };
        if self.repeated.is_some() {
            self.at = after_space(self.bytes, self.at);
        }
        self.segment(letter, true, start)
    }

    /// A further set of arguments for the last letter.
    #[inline]
    fn repetition(&mut self) -> Option<Segment> {
        let letter = self.repeated?;
        self.at = after_separator(self.bytes, self.at);
        self.segment(letter, false, self.at)
    }

    #[cold]
    fn fail<T>(&mut self, at: usize) -> Option<T> {
        self.error = Some(at);
        self.at = self.end;
        None
    }
}

const fn is_arc(letter: u8) -> bool {
    matches!(letter, b'a' | b'A')
}

const fn is_bezier(letter: u8) -> bool {
    matches!(letter | 0x20, b'c' | b's' | b'q' | b't')
}

impl Iterator for Segments<'_> {
    type Item = Segment;

    #[inline]
    fn next(&mut self) -> Option<Segment> {
        self.at = after_space(self.bytes, self.at);
        let start = self.at;
        if start >= self.end {
            return None;
        }
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
mod tests;
