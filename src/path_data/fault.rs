//! What is wrong with path data.

use super::grammar::{after_separator, after_space, is_space};
use super::{Segment, is_arc};
use crate::number::read as number;

/// What is wrong with path data, and at which byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PathFault {
    /// They end where something is missing.
    Ends,
    /// A number should follow the comma here.
    Comma(usize),
    /// What stands here is neither a command nor the number that is missing.
    Unexpected(usize),
    /// The number here is beyond `f64`.
    TooLarge(usize),
}

impl PathFault {
    /// The number of a segment that is beyond `f64`, if one is.
    pub(crate) fn too_large(text: &str, segment: &Segment) -> Option<Self> {
        let fault = Self::find(text.as_bytes(), segment.start, Some(segment.letter));
        matches!(fault, Self::TooLarge(_)).then_some(fault)
    }

    /// The fault of the segment that begins at a byte, by a letter or as a repetition of the one before.
    #[cold]
    pub(super) fn find(bytes: &[u8], start: usize, repeated: Option<u8>) -> Self {
        let given = bytes.get(start).filter(|byte| byte.is_ascii_alphabetic());
        let (letter, mut at) = match (given, repeated) {
            (Some(letter), _) => (*letter, after_space(bytes, start + 1)),
            (None, Some(letter)) => (letter, after_separator(bytes, start)),
            (None, None) => return Self::Unexpected(start),
        };
        let count = match letter.to_ascii_lowercase() {
            b'h' | b'v' => 1,
            b'm' | b'l' | b't' => 2,
            b's' | b'q' => 4,
            b'c' => 6,
            b'a' => 7,
            _ => return Self::Unexpected(start),
        };
        for index in 0..count {
            if index > 0 {
                at = after_separator(bytes, at);
            }
            if is_arc(letter) && matches!(index, 3 | 4) {
                if !matches!(bytes.get(at), Some(b'0' | b'1')) {
                    return Self::missing(bytes, at);
                }
                at += 1;
                continue;
            }
            match number::read(bytes, at) {
                None => return Self::missing(bytes, at),
                Some((value, _)) if value.is_infinite() => return Self::TooLarge(at),
                Some((_, end)) => at = end,
            }
        }
        Self::Unexpected(start)
    }

    /// The fault where a number or a flag is missing.
    fn missing(bytes: &[u8], at: usize) -> Self {
        let next = bytes.get(at);
        let last = bytes[..at]
            .iter()
            .rposition(|byte| !is_space(char::from(*byte)));
        match last.filter(|last| bytes[*last] == b',') {
            Some(comma) if next.is_none_or(u8::is_ascii_alphabetic) => Self::Comma(comma),
            _ if next.is_none() => Self::Ends,
            _ => Self::Unexpected(at),
        }
    }
}
