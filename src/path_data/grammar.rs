//! What stands between the numbers of path data, and the arguments that are skipped unread.

use crate::number::read as number;

/// Whether a character is white space, as path data and lists of points have it.
pub(crate) const fn is_space(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r' | '\x0c')
}

/// The index after white space.
#[inline]
pub(crate) fn after_space(bytes: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\n' | b'\r' | 0x0c) = bytes.get(at) {
        at += 1;
    }
    at
}

/// The index after white space with at most one comma.
#[inline]
pub(crate) fn after_separator(bytes: &[u8], at: usize) -> usize {
    /// The bit of each byte that parts numbers.
    const SEPARATORS: u64 =
        1 << b' ' | 1 << b'\t' | 1 << b'\n' | 1 << b'\r' | 1 << 0x0c | 1 << b',';
    // Mostly one separator or none stands before a digit, a point or a minus sign, which lie above them all. Which of both it is
    // can not be foreseen, so that a sum is faster than a branch.
    let one = bytes.get(at).map_or(0, |byte| {
        u64::from(*byte < 64) & (SEPARATORS >> (byte & 63))
    });
    let after = at + (one & 1) as usize;
    match bytes.get(after) {
        Some(b'-'..) => after,
        _ => after_separators(bytes, at),
    }
}

/// [`after_separator`] for any white space.
fn after_separators(bytes: &[u8], at: usize) -> usize {
    let at = after_space(bytes, at);
    if bytes.get(at) == Some(&b',') {
        after_space(bytes, at + 1)
    } else {
        at
    }
}

/// The index after `COUNT` numbers and what parts them from the next one.
#[inline]
pub(crate) fn after_numbers<const COUNT: usize>(bytes: &[u8], mut at: usize) -> Option<usize> {
    for _ in 0..COUNT {
        at = after_separator(bytes, number::skip(bytes, at)?);
    }
    Some(at)
}

/// The index of the first byte above the digits, such as a letter; the end of the text where there is none.
#[inline]
pub(crate) fn after_arguments(bytes: &[u8], mut at: usize) -> usize {
    const HIGH: u64 = 0x8080_8080_8080_8080;
    while let Some(chunk) = bytes.get(at..).and_then(<[u8]>::first_chunk) {
        let word = u64::from_le_bytes(*chunk);
        // The highest bit of every byte above '9', which 0x46 lifts to it.
        let above = (((word & !HIGH) + 0x4646_4646_4646_4646) | word) & HIGH;
        if above != 0 {
            return at + above.trailing_zeros() as usize / 8;
        }
        at += 8;
    }
    let is_above = |byte: &u8| *byte > b'9';
    let rest = bytes.get(at..).unwrap_or_default();
    at + rest.iter().position(is_above).unwrap_or(rest.len())
}

/// The index after a flag.
#[inline]
fn after_flag(bytes: &[u8], at: usize) -> Option<usize> {
    matches!(bytes.get(at), Some(b'0' | b'1')).then_some(at + 1)
}

/// The index after the radii, the rotation and the flags of an arc.
#[inline]
pub(crate) fn after_arc_shape(bytes: &[u8], at: usize) -> Option<usize> {
    let large = after_numbers::<3>(bytes, at)?;
    let sweep = after_separator(bytes, after_flag(bytes, large)?);
    Some(after_separator(bytes, after_flag(bytes, sweep)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every text of up to four of these.
    fn texts() -> Vec<Vec<u8>> {
        let mut texts = vec![Vec::new()];
        let mut from = 0;
        for _ in 0..4 {
            let until = texts.len();
            for i in from..until {
                for byte in *b" \t\x0c,0.-+a`l\xff" {
                    let longer = [&texts[i][..], &[byte]].concat();
                    texts.push(longer);
                }
            }
            from = until;
        }
        texts
    }

    #[test]
    fn one_separator_is_skipped_as_any() {
        for text in texts() {
            assert_eq!(
                after_separator(&text, 0),
                after_separators(&text, 0),
                "{text:?}"
            );
        }
    }

    #[test]
    fn arguments_end_at_the_first_letter() {
        for byte in 0..=u8::MAX {
            for length in 0..20 {
                for place in 0..=length {
                    let mut text = b"0123 5.7,9-1 3+5\t7 9"[..length].to_vec();
                    text.insert(place, byte);
                    let is_above = |byte: &u8| *byte > b'9';
                    let end = text.iter().position(is_above).unwrap_or(text.len());
                    assert_eq!(after_arguments(&text, 0), end, "{text:?}");
                    let later = if place > 0 { end } else { 1 + length };
                    assert_eq!(after_arguments(&text, 1), later, "{text:?}");
                }
            }
        }
    }
}
