//! Numbers as a file spells them: SVG 2's grammar and the exact byte span.

use super::digits::{EXACT_POWERS, ZEROS};
use super::parse;

/// The index after the number at `bytes[at..]`; `None` where none begins.
///
/// The grammar is SVG 2's: `[+-]? ([0-9]+ | [0-9]* "." [0-9]+) ([eE] [+-]? [0-9]+)?`. An `e` without digits after it belongs to
/// what follows (`1em`).
#[inline]
pub(crate) fn skip(bytes: &[u8], at: usize) -> Option<usize> {
    let whole = after_sign(bytes, at);
    match Short::at(bytes, whole) {
        Some(short) => Some(whole + short.length()),
        None => skip_long(bytes, at),
    }
}

/// The number at `bytes[at..]` and the index after it; infinite where it is beyond `f64`, `None` where none begins.
#[inline]
pub(crate) fn read(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    match read_short(bytes, at) {
        Some((value, end, _)) => Some((value, end)),
        None => read_long(bytes, at),
    }
}

/// [`read`], and with how many decimals the number is spelled; [`WITH_EXPONENT`] where it has an exponent.
#[inline]
pub(crate) fn read_counted(bytes: &[u8], at: usize) -> Option<(f64, usize, u8)> {
    if let Some(read) = read_short(bytes, at) {
        return Some(read);
    }
    let (value, end) = read_long(bytes, at)?;
    let decimals = decimals_spelled(&bytes[at..end]).unwrap_or(WITH_EXPONENT);
    Some((value, end, decimals))
}

/// The same of a number of few digits without an exponent.
#[inline(always)]
fn read_short(bytes: &[u8], at: usize) -> Option<(f64, usize, u8)> {
    let whole = after_sign(bytes, at);
    let short = Short::at(bytes, whole)?;
    let sign = u64::from(bytes.get(at) == Some(&b'-')) << 63;
    let value = f64::from_bits(short.value().to_bits() | sign);
    Some((value, whole + short.length(), short.decimals() as u8))
}

/// What stands for the decimals of a number with an exponent.
pub(crate) const WITH_EXPONENT: u8 = u8::MAX;

/// The most decimals of the numbers in a text, below [`WITH_EXPONENT`]; `None` where one has an exponent.
pub(crate) fn decimals_spelled(text: &[u8]) -> Option<u8> {
    let (mut most, mut after, mut point) = (0_u8, 0_u8, false);
    for byte in text {
        match byte {
            b'0'..=b'9' => {
                after = after.saturating_add(u8::from(point));
                most = most.max(after);
            }
            b'e' | b'E' => return None,
            byte => (after, point) = (0, *byte == b'.'),
        }
    }
    Some(most.min(WITH_EXPONENT - 1))
}

#[inline]
fn after_sign(bytes: &[u8], at: usize) -> usize {
    at + usize::from(matches!(bytes.get(at), Some(b'-' | b'+')))
}

/// A number without sign and exponent that ends within eight bytes, as most do.
///
/// It is found and read in a machine word and without a branch: a loop over its bytes would end at another one each time, and a
/// processor that guessed the number of digits wrong loses more time than all of this takes.
#[derive(Clone, Copy)]
struct Short {
    /// The text, the first byte lowest.
    word: u64,
    /// The bits before the point, or before the end where there is none.
    whole: u32,
    /// The bits of the text.
    end: u32,
    /// All ones where there is a point.
    has_point: u64,
}

impl Short {
    /// The highest bit of every byte.
    const HIGH: u64 = 0x8080_8080_8080_8080;

    #[inline]
    fn at(bytes: &[u8], at: usize) -> Option<Self> {
        let word = u64::from_le_bytes(*bytes.get(at..)?.first_chunk()?);
        // What is no digit has the highest bit, or gets it by adding 0x76 to its difference from '0'.
        let digits = word ^ ZEROS;
        let others = (((digits & !Self::HIGH) + 0x7676_7676_7676_7676) | digits) & Self::HIGH;
        let after = others & others.wrapping_sub(1);
        let (first, second) = (others.trailing_zeros() & !7, after.trailing_zeros() & !7);
        // A point belongs to the number where digits follow it. What follows one at the end of the word is not known: by the remainder
        // that number counts as one that goes on after it.
        let is_point = (word >> (first & 63)) as u8 == b'.';
        let goes_on = second > (first + 8) % 64;
        let has_point = (u64::from(is_point) & u64::from(goes_on)).wrapping_neg();
        let end = first ^ ((first ^ second) & has_point as u32);
        let next = (word >> (end & 63)) as u8;
        (end > 0 && end < 64 && next | 0x20 != b'e').then_some(Self {
            word,
            whole: first,
            end,
            has_point,
        })
    }

    #[inline]
    const fn length(self) -> usize {
        (self.end / 8) as usize
    }

    /// How many digits stand after the point.
    #[inline]
    const fn decimals(self) -> u32 {
        let bits = self.end - (self.has_point as u32 & 8);
        (bits - self.whole) / 8
    }

    /// The value: a mantissa below 2^53 by an exact power of ten is the correctly rounded quotient.
    #[inline]
    fn value(self) -> f64 {
        // The digits after the point close up.
        let after = u64::MAX << self.whole;
        let text = self.word ^ ((self.word ^ (self.word >> 8)) & after & self.has_point);
        let bits = self.end - (self.has_point as u32 & 8);
        // The last digit comes to the highest byte, what is after it falls off, and zeros come before the first.
        let digits = (text ^ ZEROS) << (64 - bits);
        eight_digits(digits) as f64 / EXACT_POWERS[self.decimals() as usize & 7]
    }
}

/// The number of eight digits, one a byte, the first one lowest: pairs, then fours, then all, side by side.
#[inline]
const fn eight_digits(digits: u64) -> u64 {
    const BYTES: u64 = 0x00ff_00ff_00ff_00ff;
    const PAIRS: u64 = 0x0000_ffff_0000_ffff;
    let pairs = 10 * (digits & BYTES) + ((digits >> 8) & BYTES);
    let fours = 100 * (pairs & PAIRS) + ((pairs >> 16) & PAIRS);
    10_000 * (fours & 0xffff_ffff) + (fours >> 32)
}

/// [`skip`] for any number.
#[cold]
fn skip_long(bytes: &[u8], at: usize) -> Option<usize> {
    let whole = after_sign(bytes, at);
    let mut end = skip_digits(bytes, whole);
    if let Some(b'.') = bytes.get(end)
        && let fraction = skip_digits(bytes, end + 1)
        && fraction > end + 1
    {
        end = fraction;
    }
    (end > whole).then(|| after_exponent(bytes, end))
}

fn skip_digits(bytes: &[u8], mut at: usize) -> usize {
    while let Some(b'0'..=b'9') = bytes.get(at) {
        at += 1;
    }
    at
}

/// [`read`] for any number.
#[cold]
fn read_long(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let end = skip_long(bytes, at)?;
    let value = parse(core::str::from_utf8(&bytes[at..end]).ok()?)?;
    Some((value, end))
}

/// The index after the exponent at `bytes[at..]`; `at` itself where there is none.
fn after_exponent(bytes: &[u8], at: usize) -> usize {
    if !matches!(bytes.get(at), Some(b'e' | b'E')) {
        return at;
    }
    let digits = at + 1 + usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
    let count = bytes.get(digits..).map_or(0, |rest| {
        rest.iter().take_while(|b| b.is_ascii_digit()).count()
    });
    if count == 0 { at } else { digits + count }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_end_where_the_grammar_ends_them() {
        for (text, value, end) in [
            ("1", 1.0, 1),
            ("-.5.5", -0.5, 3),
            ("1.", 1.0, 1),
            ("1e3", 1000.0, 3),
            ("1em", 1.0, 1),
            ("+1e-2x", 0.01, 5),
            ("0150", 150.0, 4),
            (
                "123456789012345678901234567890",
                123_456_789_012_345_678_901_234_567_890.0,
                30,
            ),
            ("1e999", f64::INFINITY, 5),
            ("-12345.6", -12345.6, 8),
            ("-1234567", -1_234_567.0, 8),
            ("12345678", 12_345_678.0, 8),
            ("0.1234567890123456789012", 0.123_456_789_012_345_68, 24),
        ] {
            assert_eq!(read(text.as_bytes(), 0), Some((value, end)), "{text}");
            // A whole word of text after it changes nothing.
            let followed = format!("{text}\" fill=\"none\"/>");
            assert_eq!(read(followed.as_bytes(), 0), Some((value, end)), "{text}");
            assert_eq!(skip(followed.as_bytes(), 0), Some(end), "{text}");
            for spelled in [text, &followed] {
                let decimals = decimals_spelled(&text.as_bytes()[..end]).unwrap_or(WITH_EXPONENT);
                let counted = read_counted(spelled.as_bytes(), 0);
                assert_eq!(counted, Some((value, end, decimals)), "{text}");
            }
        }
        for text in ["", ".", "-", "e5", ".e5", "--1"] {
            assert_eq!(read(text.as_bytes(), 0), None, "{text}");
        }
    }

    #[test]
    fn a_point_may_stand_after_any_number_of_digits() {
        for whole in 0..12 {
            for decimals in 0..12 {
                for next in ["", " 5", ".5", "-5", "\" d=\"M0 0\""] {
                    let digits = |count| &"123456789123"[..count];
                    let number = format!("{}.{}", digits(whole), digits(decimals));
                    let text = format!("{number}{next}");
                    // Without digits after it a point belongs to what follows, if to anything.
                    let number = match decimals {
                        0 => digits(whole),
                        _ => &number,
                    };
                    let expected = number.parse().ok().map(|value: f64| (value, number.len()));
                    assert_eq!(read(text.as_bytes(), 0), expected, "{text}");
                    assert_eq!(
                        skip(text.as_bytes(), 0),
                        expected.map(|(_, end)| end),
                        "{text}"
                    );
                }
            }
        }
    }
}
