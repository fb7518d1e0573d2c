//! Decimal numbers, held exactly and written shortly.

use crate::number::digits::{EXACT_POWERS, ZEROS, digits};

/// A decimal number held exactly: `units` times ten to the minus `decimals`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Decimal {
    pub(super) units: i64,
    pub(super) decimals: u32,
}

/// The most decimals that a generated number carries.
pub(super) const MAX_DECIMALS: u32 = 15;

impl Decimal {
    /// The number that `text` spells, if it has no exponent and few enough digits to be held exactly.
    pub(super) fn read(text: &str) -> Option<Self> {
        let bytes = text.as_bytes();
        let (negative, rest) = match bytes.first()? {
            b'-' => (true, &bytes[1..]),
            b'+' => (false, &bytes[1..]),
            _ => (false, bytes),
        };
        let (mut units, mut decimals, mut point) = (0_i64, 0, false);
        for &byte in rest {
            match byte {
                b'0'..=b'9' => {
                    units = units.checked_mul(10)?.checked_add(i64::from(byte - b'0'))?;
                    decimals += u32::from(point);
                }
                b'.' if !point => point = true,
                _ => return None,
            }
        }
        (decimals <= MAX_DECIMALS && units < 1 << 53).then_some(Self {
            units: if negative { -units } else { units },
            decimals,
        })
    }

    /// The nearest multiple of ten to the minus `decimals`; fewer decimals where the digits would be noise.
    pub(super) fn round(value: f64, decimals: u32) -> Self {
        let mut decimals = decimals.min(MAX_DECIMALS);
        let mut scaled = value * EXACT_POWERS[decimals as usize];
        while decimals > 0 && scaled.abs() >= 9e15 {
            decimals -= 1;
            scaled = value * EXACT_POWERS[decimals as usize];
        }
        // Half away from zero, without a call into the mathematics library.
        Self {
            units: (scaled + 0.5_f64.copysign(scaled)) as i64,
            decimals,
        }
    }

    /// The difference, exact unless it leaves the range (then rounded).
    pub(super) fn minus(self, other: Self) -> Self {
        let decimals = self.decimals.max(other.decimals);
        match (self.at(decimals), other.at(decimals)) {
            (Some(a), Some(b)) => Self {
                units: a.saturating_sub(b),
                decimals,
            },
            _ => Self::round(self.value() - other.value(), decimals),
        }
    }

    /// The sum, exact unless it leaves the range (then rounded).
    pub(super) fn plus(self, other: Self) -> Self {
        self.minus(Self {
            units: -other.units,
            ..other
        })
    }

    fn at(self, decimals: u32) -> Option<i64> {
        self.units
            .checked_mul(10_i64.checked_pow(decimals - self.decimals)?)
    }

    /// The value, correctly rounded.
    pub(super) fn value(self) -> f64 {
        self.units as f64 / EXACT_POWERS[self.decimals as usize]
    }

    /// Writes the number without trailing zeros, a leading zero before the point, an exponent or a negative zero; with a space
    /// before it where it would otherwise run into the number that `out` ends with. Returns whether it has a point.
    #[inline]
    pub(super) fn write(self, out: &mut Vec<u8>, after: After) -> bool {
        let units = self.units.unsigned_abs();
        if units >= 10_000_000 || self.decimals > 7 {
            return self.write_long(out, after);
        }
        // All digits in a word, the first one lowest, and how many of them are zeros at either end that are left out. No branch
        // depends on the digits, which nobody can foresee.
        let digits = digits(units);
        let whole = 8 - self.decimals;
        let leading = (digits.trailing_zeros() / 8).min(whole - u32::from(units == 0));
        let trailing = (digits.leading_zeros() / 8).min(self.decimals);
        let (before, decimals) = (whole - leading, self.decimals - trailing);
        // A zero leads, so that there is a byte left for the point.
        let text = (digits | ZEROS) >> (8 * leading);
        let behind = u64::MAX << (8 * before);
        let text = (text & !behind) | u64::from(b'.') << (8 * before) | (text & behind) << 8;

        let negative = self.units < 0;
        let first = if negative { b'-' } else { text as u8 };
        // A minus sign or a space, never both.
        let prefix = u32::from(negative | after.runs_into(first));
        let mark = u128::from(if negative { b'-' } else { b' ' } * prefix as u8);
        let text = (u128::from(text) << (8 * prefix) | mark).to_le_bytes();
        let length = prefix + before + u32::from(decimals > 0) + decimals;
        let end = out.len() + length as usize;
        out.extend_from_slice(&text);
        out.truncate(end);
        decimals > 0
    }

    /// [`Decimal::write`] for any number.
    #[cold]
    fn write_long(self, out: &mut Vec<u8>, after: After) -> bool {
        const LENGTH: usize = 24;
        let (mut units, mut decimals) = (self.units.unsigned_abs(), self.decimals);
        while decimals > 0 && units.is_multiple_of(10) {
            units /= 10;
            decimals -= 1;
        }
        let mut text = [0; LENGTH];
        let mut at = LENGTH;
        let mut put = |byte: u8| {
            at -= 1;
            text[at] = byte;
        };
        let mut place = 0;
        while units > 0 || place < decimals || place == 0 {
            put(b'0' + (units % 10) as u8);
            units /= 10;
            place += 1;
            if place == decimals {
                put(b'.');
                if units == 0 {
                    break;
                }
            }
        }
        if self.units < 0 {
            put(b'-');
        }
        after.part(out, &text[at..]);
        out.extend_from_slice(&text[at..]);
        decimals > 0
    }
}

/// What a text ends with, which decides whether a number behind it needs a separator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum After {
    /// A letter or a separator.
    #[default]
    Letter,
    /// A number without a point: a digit or a point would continue it.
    Whole,
    /// A number with a point: only a digit would continue it.
    Point,
}

impl After {
    /// What a text of numbers ends with.
    pub(super) fn text(text: &[u8]) -> Self {
        let mut number = text
            .iter()
            .rev()
            .take_while(|b| b.is_ascii_digit() || **b == b'.');
        if number.any(|b| *b == b'.') {
            Self::Point
        } else {
            Self::Whole
        }
    }

    /// Whether a number that begins with this byte would be read as a part of what stands before.
    pub(super) const fn runs_into(self, first: u8) -> bool {
        match first {
            b'-' | b'+' => false,
            b'.' => matches!(self, Self::Whole),
            _ => !matches!(self, Self::Letter),
        }
    }

    /// Appends a number.
    pub(super) fn push(&mut self, out: &mut Vec<u8>, number: Decimal) {
        *self = if number.write(out, *self) {
            Self::Point
        } else {
            Self::Whole
        };
    }

    /// Appends the space that parts numbers from what stands before, where one is needed.
    #[inline]
    pub(super) fn part(self, out: &mut Vec<u8>, text: &[u8]) {
        if text.first().is_some_and(|first| self.runs_into(*first)) {
            out.push(b' ');
        }
    }

    /// Appends the text of one or more numbers.
    pub(super) fn push_text(&mut self, out: &mut Vec<u8>, text: &[u8]) {
        self.part(out, text);
        out.extend_from_slice(text);
        *self = Self::text(text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_and_short() {
        let text = |d: Decimal| {
            let mut out = Vec::new();
            d.write(&mut out, After::Letter);
            String::from_utf8(out).unwrap()
        };
        assert_eq!(text(Decimal::round(0.5, 3)), ".5");
        assert_eq!(text(Decimal::round(-0.0001, 3)), "0");
        assert_eq!(text(Decimal::round(-12.3456, 2)), "-12.35");
        assert_eq!(text(Decimal::round(100.0, 3)), "100");
        let end = Decimal::read("-0.30").unwrap();
        assert_eq!(text(end.minus(Decimal::round(1.0 / 3.0, 4))), "-.6333");
        assert_eq!(Decimal::read("1e5"), None);
        assert_eq!(text(Decimal::round(0.0, 4)), "0");
        // What a machine word holds, and what it does not, read the same.
        for units in [1_i64, 20, 300, 40_050, 99_999_999, 100_000_000, 1 << 52] {
            for decimals in 0..=MAX_DECIMALS {
                let number = Decimal {
                    units: -units,
                    decimals,
                };
                let mut long = Vec::new();
                let has_point = number.write_long(&mut long, After::Whole);
                let mut out = Vec::new();
                assert_eq!(number.write(&mut out, After::Whole), has_point);
                assert_eq!(out, long, "{number:?}");
                assert_eq!(text(number).parse(), Ok(number.value()));
            }
        }
    }

    #[test]
    fn numbers_are_parted_only_where_they_would_run_together() {
        let mut out = Vec::new();
        let mut after = After::Letter;
        for value in [1.0, 0.5, 0.25, 2.0, -3.0, 4.0, 0.0, -0.5] {
            after.push(&mut out, Decimal::round(value, 2));
        }
        after.push_text(&mut out, b"0.1,2");
        after.push_text(&mut out, b".5");
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "1 .5.25 2-3 4 0-.5 0.1,2 .5"
        );
    }

    #[test]
    fn huge_numbers_lose_decimals_rather_than_their_value() {
        let d = Decimal::round(1e14, 9);
        assert_eq!(d.value(), 1e14);
    }
}
