//! Decimal numbers, held exactly and written shortly: what rounding a number gives.

use super::digits::{EXACT_POWERS, ROUNDING, ZEROS, digits};
#[cfg(feature = "batch")]
use super::memo::Memo;
use super::{POWERS, push_long, split};

/// A decimal number held exactly: `units` times ten to the minus `decimals`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Decimal {
    pub(crate) units: i64,
    /// At most 19.
    pub(crate) decimals: u32,
}

/// How many decimals, at most seven, eight digits leave to a number below this power of two: 2^i 10^d < 10^8.
const MOST_OF_EIGHT: [u8; 27] = {
    let mut most = [7; 27];
    let mut i = 0;
    while i < 27 {
        while (1 << i) * POWERS[most[i] as usize] >= POWERS[8] {
            most[i] -= 1;
        }
        i += 1;
    }
    most
};

/// Room for a mark, eight digits and a point, and for what is written beyond them.
const ROOM: usize = 32;

/// The most decimals that a number in full is given where it is written as a decimal.
pub(crate) const MAX_DECIMALS: u32 = 15;

impl Decimal {
    pub(crate) const ZERO: Self = Self {
        units: 0,
        decimals: 0,
    };

    /// The number that `text` spells, if it has no exponent and few enough digits to be held exactly.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let bytes = text.as_bytes();
        let (negative, rest) = match bytes.first()? {
            b'-' => (true, &bytes[1..]),
            b'+' => (false, &bytes[1..]),
            _ => (false, bytes),
        };
        let (mut units, mut count, mut point) = (0_u64, 0, None);
        for &byte in rest {
            let digit = byte.wrapping_sub(b'0');
            if digit < 10 {
                units = units.wrapping_mul(10).wrapping_add(u64::from(digit));
                count += 1;
            } else if byte == b'.' && point.is_none() {
                point = Some(count);
            } else {
                return None;
            }
        }
        let decimals = point.map_or(0, |point| count - point);
        // Nineteen digits cannot have left the word.
        let fits = (1..=19).contains(&count) && units < 1 << 53 && decimals <= MAX_DECIMALS;
        let number = Self {
            units: units.cast_signed(),
            decimals,
        };
        fits.then_some(if negative { number.negated() } else { number })
    }

    /// The nearest multiple of ten to the minus `decimals` to the exact binary value, of two as near the even one; `None` for
    /// more than 19 decimals, and where the units leave 64 bits.
    #[inline]
    pub(crate) fn nearest(x: f64, decimals: u8) -> Option<Self> {
        Self::nearest_short(x, decimals).or_else(|| Self::nearest_long(x, decimals))
    }

    /// The number whose nearest float is `x`, if there is one of at most eight digits and seven decimals that is found at once: then
    /// its digits without idle zeros are the shortest of `x`, because no two decimals of 15 digits have one float.
    #[inline]
    pub(crate) fn of_few_digits(x: f64) -> Option<Self> {
        // As many decimals as eight digits leave at |x| < 2^size.
        let size = ((x.to_bits() >> 52) & 0x7ff).saturating_sub(1022);
        let decimals = *MOST_OF_EIGHT.get(size as usize)?;
        let power = EXACT_POWERS[usize::from(decimals)];
        let product = x * power;
        let shifted = product + ROUNDING;
        let whole = shifted - ROUNDING;
        // The quick comparison rejects most of the others, so that the quotient, which decides, is seldom computed for nothing.
        let is_whole = (product - whole).abs() < 1e-7 && whole / power == x;
        is_whole.then_some(Self {
            units: i64::from((shifted.to_bits() as u32).cast_signed()),
            decimals: u32::from(decimals),
        })
    }

    /// How many decimals are left without the idle zeros, of eight digits at most.
    pub(crate) fn decimals_written(self) -> u32 {
        let trailing = digits(self.units.unsigned_abs()).leading_zeros() / 8;
        self.decimals - trailing.min(self.decimals)
    }

    /// The product with the power of ten decides, wherever it is far enough from a tie to be on the right side of it for certain:
    /// below 10^8 it errs by 2^-27 at most.
    #[inline]
    fn nearest_short(x: f64, decimals: u8) -> Option<Self> {
        const CLOSE_TO_TIE: f64 = 0.5 - 1e-6;
        let product = x * EXACT_POWERS.get(usize::from(decimals))?;
        let shifted = product + ROUNDING;
        let whole = shifted - ROUNDING;
        let is_certain = product.abs() < 99_999_999.5 && (product - whole).abs() < CLOSE_TO_TIE;
        // The lowest bits of the sum hold the whole number, of either sign.
        let units = i64::from((shifted.to_bits() as u32).cast_signed());
        (is_certain && decimals < 20).then_some(Self {
            units,
            decimals: u32::from(decimals),
        })
    }

    #[cold]
    fn nearest_long(x: f64, decimals: u8) -> Option<Self> {
        let power = *POWERS.get(usize::from(decimals))?;
        let (whole, fraction) = split(x, power)?;
        let units = whole.checked_mul(power)?.checked_add(fraction)?;
        let units = i64::try_from(units).ok()?;
        Some(Self {
            units: if x < 0.0 { -units } else { units },
            decimals: u32::from(decimals),
        })
    }

    /// As [`Decimal::nearest`]; fewer decimals where the digits would be noise.
    pub(crate) fn round(x: f64, decimals: u32) -> Self {
        let mut decimals = decimals.min(MAX_DECIMALS);
        while decimals > 0 && x.abs() * EXACT_POWERS[decimals as usize] >= 9e15 {
            decimals -= 1;
        }
        Self::nearest(x, decimals as u8).unwrap_or(Self {
            // The least i64 has no number of the other sign.
            units: (x as i64).max(-i64::MAX),
            decimals: 0,
        })
    }

    /// The difference, exact unless it leaves the range (then rounded).
    pub(crate) fn minus(self, other: Self) -> Self {
        let decimals = self.decimals.max(other.decimals);
        match (self.at(decimals), other.at(decimals)) {
            (Some(a), Some(b)) => Self {
                units: a.saturating_sub(b).max(-i64::MAX),
                decimals,
            },
            _ => Self::round(self.value() - other.value(), decimals),
        }
    }

    /// The sum, exact unless it leaves the range (then rounded).
    pub(crate) fn plus(self, other: Self) -> Self {
        self.minus(other.negated())
    }

    /// The number of the other sign.
    pub(crate) const fn negated(self) -> Self {
        Self {
            units: self.units.wrapping_neg(),
            ..self
        }
    }

    fn at(self, decimals: u32) -> Option<i64> {
        self.units
            .checked_mul(10_i64.checked_pow(decimals - self.decimals)?)
    }

    /// The nearest float, as the units are below 2^53.
    pub(crate) fn value(self) -> f64 {
        self.units as f64 / EXACT_POWERS[self.decimals as usize]
    }

    /// Writes the number without idle zeros after the point, an exponent or a negative zero; with a space before it where it
    /// would otherwise run into the number that `out` ends with. Returns whether it has a point.
    #[inline(always)]
    pub(crate) fn write(self, out: &mut Vec<u8>, after: After, form: BelowOne) -> bool {
        let units = self.units.unsigned_abs();
        if units >= 100_000_000 || self.decimals > 7 {
            return self.write_long(out, after, form);
        }
        // All digits in a word, the first one lowest, and how many of them are zeros at either end that are left out. No branch
        // depends on the digits or the sign, which nobody can foresee.
        let digits = digits(units);
        let whole = 8 - self.decimals;
        let keeps_zero = (units == 0) | matches!(form, BelowOne::Plain);
        let leading = (digits.trailing_zeros() / 8).min(whole - u32::from(keeps_zero));
        let trailing = (digits.leading_zeros() / 8).min(self.decimals);
        let (before, decimals) = (whole - leading, self.decimals - trailing);

        // A minus sign or a space, never both.
        let negative = self.units < 0;
        let mark = if negative { b'-' } else { b' ' };
        let prefix = usize::from(negative | after.is_continued(before == 0));
        let point = prefix + (before & 15) as usize;
        let end = out.len() + point + usize::from(decimals > 0) + decimals as usize;
        // What stands before the point, the point, and what stands after it: each is written over the idle end of the one before.
        out.extend_from_slice(&[mark; ROOM]);
        if let Some(text) = out.last_chunk_mut::<ROOM>() {
            let digits = digits | ZEROS;
            text[prefix..prefix + 8].copy_from_slice(&(digits >> (8 * leading)).to_le_bytes());
            text[point] = b'.';
            let fraction = (digits >> (4 * whole)) >> (4 * whole);
            text[point + 1..point + 9].copy_from_slice(&fraction.to_le_bytes());
        }
        out.truncate(end);
        decimals > 0
    }

    /// [`Decimal::write`] for any number.
    #[cold]
    fn write_long(self, out: &mut Vec<u8>, after: After, form: BelowOne) -> bool {
        let power = POWERS[self.decimals as usize];
        let units = self.units.unsigned_abs();
        let (whole, fraction) = (units / power, units % power);
        let drops_zero = whole == 0 && fraction > 0 && matches!(form, BelowOne::Short);
        let first = match () {
            () if self.units < 0 => b'-',
            () if drops_zero => b'.',
            () => b'0',
        };
        if after.runs_into(first) {
            out.push(b' ');
        }
        let start = out.len();
        push_long(out, self.units < 0, whole, fraction, self.decimals as u8);
        if drops_zero {
            out.remove(start + usize::from(self.units < 0));
        }
        fraction > 0
    }
}

/// How a number below one begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BelowOne {
    /// With a zero, as people write it.
    Plain,
    /// With its point, which is a byte less.
    Short,
}

/// What a text ends with, which decides whether a number after it needs a separator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum After {
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
    pub(crate) fn text(text: &[u8]) -> Self {
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
    pub(crate) const fn runs_into(self, first: u8) -> bool {
        !matches!(first, b'-' | b'+') && self.is_continued(first == b'.')
    }

    /// The same for a point or a digit.
    #[inline]
    const fn is_continued(self, by_point: bool) -> bool {
        match self {
            Self::Letter => false,
            Self::Whole => true,
            Self::Point => !by_point,
        }
    }

    /// Appends a number.
    #[inline]
    pub(crate) fn push(&mut self, out: &mut Vec<u8>, number: Decimal, form: BelowOne) {
        *self = if number.write(out, *self, form) {
            Self::Point
        } else {
            Self::Whole
        };
    }

    /// Appends a number in full, by its shortest digits.
    pub(crate) fn push_shortest(&mut self, out: &mut Vec<u8>, number: f64) {
        if let Some(short) = Decimal::of_few_digits(number) {
            return self.push(out, short, BelowOne::Plain);
        }
        let start = out.len();
        super::push_shortest(out, number);
        if self.runs_into(out[start]) {
            out.insert(start, b' ');
        }
        *self = Self::text(&out[start..]);
    }

    /// [`After::push_shortest`] by texts that are kept: a number in full never begins with its point.
    #[cfg(feature = "batch")]
    pub(crate) fn push_kept(&mut self, out: &mut Vec<u8>, number: f64, memo: &mut Memo) {
        if self.is_continued(false) && number >= 0.0 {
            out.push(b' ');
        }
        memo.push(out, number);
        *self = Self::Whole;
    }

    /// Appends the space that parts numbers from what stands before, where one is needed.
    #[inline]
    pub(crate) fn part(self, out: &mut Vec<u8>, text: &[u8]) {
        if text.first().is_some_and(|first| self.runs_into(*first)) {
            out.push(b' ');
        }
    }

    /// Appends the text of one or more numbers.
    pub(crate) fn push_text(&mut self, out: &mut Vec<u8>, text: &[u8]) {
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
            d.write(&mut out, After::Letter, BelowOne::Short);
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
                let has_point = number.write_long(&mut long, After::Whole, BelowOne::Short);
                let mut out = Vec::new();
                assert_eq!(
                    number.write(&mut out, After::Whole, BelowOne::Short),
                    has_point
                );
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
            after.push(&mut out, Decimal::round(value, 2), BelowOne::Short);
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
