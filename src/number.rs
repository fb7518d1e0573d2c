//! Numbers as text: the only place of this crate that turns a float into digits.
//!
//! Two forms, both in plain notation (never an exponent, never `-0`, no idle zero after the point):
//! a fixed number of decimals, and the shortest digits that read back as the same float.
//!
//! A float is the integer m times 2^-s. For a fixed number d of decimals it splits without error into
//! a whole part, m >> s, and a fraction whose product with 10^d fits 128 bits; the bits below the point
//! of that product decide the rounding exactly, ties included. Numbers of few digits take a product of floats wherever that is
//! far enough from a tie to be on the right side of it for certain.

pub(crate) mod decimal;
pub(crate) mod digits;
#[cfg(feature = "batch")]
pub(crate) mod memo;
mod people;
pub(crate) mod read;
mod shortest;

pub(crate) use shortest::as_decimal;

pub use people::{compact, counted, round_one_two_five, rounded_up, significant};

use crate::numeric::functions;
use kurbo::Point;
use std::io::Write as _;

use decimal::{After, BelowOne, Decimal};
use digits::{EXACT_POWERS, ZEROS, digits};

/// How many decimals a number is printed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// The shortest digits that read back as the same float.
    Full,
    /// At most this many decimals after the point.
    Fixed(u8),
}

impl Precision {
    /// The fewest decimals d for which 10^-d/sqrt(2), the farthest that rounding moves a point, is at most `distance`, and full
    /// digits where even all those of a coordinate as large as `largest` are not enough.
    #[must_use]
    pub fn moving_at_most(distance: f64, largest: f64) -> Self {
        for (decimals, (farthest, scale)) in (0..).zip(FARTHEST.iter().zip(EXACT_POWERS)) {
            // More decimals than the coordinates have digits say nothing.
            if decimals > 0 && largest * scale > 1e15 {
                break;
            }
            if *farthest <= distance {
                return Self::Fixed(decimals);
            }
        }
        Self::Full
    }

    /// 10^-d/sqrt(2), the farthest that rounding to d decimals moves a point; 0 in full.
    #[must_use]
    pub fn farthest_moved(self) -> f64 {
        match self {
            Self::Full => 0.0,
            Self::Fixed(decimals) => {
                core::f64::consts::FRAC_1_SQRT_2 / functions::power(10.0, i32::from(decimals))
            }
        }
    }

    /// That of angles in degrees beside lengths of this one: two decimals more.
    #[must_use]
    pub(crate) const fn of_angles(self) -> Self {
        match self {
            Self::Full => Self::Full,
            Self::Fixed(decimals) => Self::Fixed(decimals.saturating_add(2)),
        }
    }

    /// The float that a reader of the printed number gets: `x` itself or [`round`] of it.
    #[must_use]
    #[inline]
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::Full => x,
            Self::Fixed(decimals) => round(x, decimals),
        }
    }

    /// The point of both coordinates rounded so.
    #[inline]
    pub(crate) fn round_point(self, p: Point) -> Point {
        Point::new(self.round(p.x), self.round(p.y))
    }
}

/// Appends `x` with at most `decimals` decimals.
///
/// Rounds the exact binary value to nearest, ties to even, as `format!("{x:.decimals$}")` does, then drops
/// trailing zeros and the sign of a zero: `0.125` gives `0.12` with two decimals and `-0.001` gives `0`.
///
/// A float that is not finite prints as `0`: no writer may emit `NaN` or `inf`, and it is the caller who
/// has to refuse such a number where a user can still be informed.
pub fn push_fixed(out: &mut Vec<u8>, x: f64, decimals: u8) {
    if let Some(number) = Decimal::nearest(x, decimals) {
        number.write(out, After::Letter, BelowOne::Plain);
    } else if let Some((whole, fraction)) = power(decimals).and_then(|power| split(x, power)) {
        let negative = x.is_sign_negative() && (whole | fraction) != 0;
        push_long(out, negative, whole, fraction, decimals);
    } else {
        push_fixed_by_std(out, x, decimals);
    }
}

/// Appends the shortest digits that read back as `x`: of several the nearest to it, of two equally near the
/// even one (the upper one at powers of two, as std has it everywhere), so that zmij and `serde_json` give the
/// same digits. `-0.0` gives `0`.
///
/// A float that is not finite prints as `0`; see [`push_fixed`].
pub fn push_shortest(out: &mut Vec<u8>, x: f64) {
    if let Some(number) = Decimal::of_few_digits(x) {
        number.write(out, After::Letter, BelowOne::Plain);
        return;
    }
    if !x.is_finite() {
        out.push(b'0');
        return;
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(x);
    let bytes = text.as_bytes();
    // Within this range zmij writes plain notation, so that there is no exponent to look for.
    if (1e-4..1e15).contains(&x.abs()) || !text.contains('e') {
        let short = if let [rest @ .., b'.', b'0'] = bytes {
            rest
        } else {
            bytes
        };
        out.extend_from_slice(short);
    } else if let Some((digits, exponent)) = text.split_once("e-") {
        push_tiny(out, digits, exponent.parse().unwrap_or(0));
    } else {
        // From 2^53 on no float lies halfway between two shorter decimals: std agrees. A `Vec` cannot fail.
        let _ = write!(out, "{x}");
    }
}

/// The float nearest to the decimal number that [`push_fixed`] prints, `0.0` for a zero of either sign.
///
/// What is measured on rounded numbers therefore holds for the printed ones. Up to 15 significant digits,
/// [`push_shortest`] of the result is the text of [`push_fixed`], digit for digit. A float that is not
/// finite is returned as it is, so that a measurement still shows it.
#[must_use]
pub fn round(x: f64, decimals: u8) -> f64 {
    match Decimal::nearest(x, decimals) {
        Some(number) if number.units == 0 => 0.0,
        // Both operands of the quotient are exact, 10^19 too, so that it is the nearest float.
        Some(number) if number.units.unsigned_abs() <= EXACT_STEPS => number.value(),
        None if power(decimals).is_none() => round_by_std(x, decimals),
        // Decimals are closer together here than floats: x is the nearest to its own rounding.
        _ => x,
    }
}

/// The sum of two decimals as a person would write it: 0.1 and 0.2 make 0.3.
pub(crate) fn decimal_sum(a: f64, b: f64) -> f64 {
    let decimals = decimals_of(a).max(decimals_of(b));
    if decimals <= 15 {
        round(a + b, decimals)
    } else {
        a + b
    }
}

/// A third of a decimal as a person would write it: that of 8.244 is 2.748, though the nearest float to the quotient is another.
pub(crate) fn decimal_third(x: f64) -> f64 {
    let third = x / 3.0;
    let rounded = round(third, decimals_of(x));
    let thrice = decimal_sum(rounded, decimal_sum(rounded, rounded));
    if thrice == x { rounded } else { third }
}

/// The number that a word spells. A whole number up to 2^53 over an exact power of ten is the nearest float (Clinger 1990); what is
/// longer or has an exponent is left to the standard library.
#[inline]
pub(crate) fn parse(word: &str) -> Option<f64> {
    match Decimal::read(word) {
        Some(number) if number.units != 0 => Some(number.value()),
        // A zero may have a sign.
        _ => word.parse().ok(),
    }
}

/// How many decimals leave a number of this size about so many digits.
#[cfg(feature = "document")]
pub(crate) fn decimals_for(size: f64, digits: i32) -> u32 {
    let before = libm::log10(size.abs().max(1e-300)).ceil() as i32;
    (digits - before).max(0).unsigned_abs()
}

/// The number of decimals of the shortest form of `x`: 2 for `0.25`, 7 for `1e-7`, 0 for `50`; 255 at most.
#[must_use]
pub fn decimals_of(x: f64) -> u8 {
    if let Some(number) = Decimal::of_few_digits(x) {
        return number.decimals_written() as u8;
    }
    let mut text = Vec::with_capacity(32);
    push_shortest(&mut text, x);
    let decimals = text
        .iter()
        .rev()
        .position(|&byte| byte == b'.')
        .unwrap_or(0);
    u8::try_from(decimals).unwrap_or(u8::MAX)
}

/// The shortest text of a number; see [`push_shortest`].
#[must_use]
pub fn text(x: f64) -> String {
    let mut out = Vec::new();
    push_shortest(&mut out, x);
    String::from_utf8_lossy(&out).into_owned()
}

/// `digits` times 10^-`exponent` in plain notation; `digits` has one digit before its point, if any.
fn push_tiny(out: &mut Vec<u8>, digits: &str, exponent: usize) {
    if digits.starts_with('-') {
        out.push(b'-');
    }
    out.extend_from_slice(b"0.");
    out.resize(out.len() + exponent.saturating_sub(1), b'0');
    out.extend(digits.bytes().filter(u8::is_ascii_digit));
}

/// 10^0 to 10^19, the powers of ten that an `u64` holds.
const POWERS: [u64; 20] = {
    let mut powers = [1; 20];
    let mut i = 1;
    while i < 20 {
        powers[i] = 10 * powers[i - 1];
        i += 1;
    }
    powers
};
/// 10^-d/sqrt(2) for each number d of decimals that a precision is chosen from.
const FARTHEST: [f64; 21] = {
    let mut farthest = [core::f64::consts::FRAC_1_SQRT_2; 21];
    let mut d = 0;
    while d < 21 {
        farthest[d] /= EXACT_POWERS[d];
        d += 1;
    }
    farthest
};
/// Whole numbers up to here are floats, every one.
const EXACT_STEPS: u64 = 1 << 53;
/// Eight decimal digits to a block.
const BLOCK: u64 = 100_000_000;

#[inline]
fn power(exponent: u8) -> Option<u64> {
    POWERS.get(usize::from(exponent)).copied()
}

/// |x| rounded to a multiple of 1/`power`, as its whole part and the count of 1/`power` beyond it.
/// `None` for 2^64 and above, and for what is not finite.
#[inline]
fn split(x: f64, power: u64) -> Option<(u64, u64)> {
    const HALF: u64 = 1 << 63;
    let bits = x.to_bits();
    // |x| = m 2^-s. (A subnormal has no leading bit, but is far too small for that to matter.)
    let m = (bits & ((1 << 52) - 1)) | (1 << 52);
    let s = 1075 - ((bits >> 52) & 0x7ff).cast_signed();
    // The product of fraction and power: whole steps, and what is left as a fraction of 2^64.
    let (whole, steps, left) = if (1..64).contains(&s) {
        let product = u128::from(m << (64 - s)) * u128::from(power);
        (m >> s, (product >> 64) as u64, product as u64)
    } else if s >= 64 {
        // m 10^19 < 2^117, so that from s = 119 on nothing rounds up any more.
        let s = s.min(127);
        let product = u128::from(m) * u128::from(power);
        let below = product << (128 - s);
        let sticky = u64::from(below as u64 != 0);
        (0, (product >> s) as u64, (below >> 64) as u64 | sticky)
    } else if s > -12 {
        return Some((m << -s, 0));
    } else {
        return None;
    };
    // `power` is odd only where it is 1; then it is the whole part that has to be even.
    let odd = (steps ^ (whole & power)) & 1;
    // Above half, or half and odd, in one comparison: a branch here would be mispredicted every second time.
    let steps = steps + u64::from(left > HALF - odd);
    let carry = u64::from(steps == power);
    Some((whole + carry, if carry == 1 { 0 } else { steps }))
}

/// The digits of `n` < 10^8 without leading zeros as ASCII, the first one lowest, and how many they are.
#[inline]
const fn leading_block(n: u64) -> (u64, u32) {
    let digits = digits(n);
    // A zero keeps one digit.
    let skip = (digits | (1 << 56)).trailing_zeros() / 8;
    ((digits | ZEROS) >> (8 * skip), 8 - skip)
}

/// Any whole part, up to 19 decimals.
fn push_long(out: &mut Vec<u8>, negative: bool, whole: u64, fraction: u64, decimals: u8) {
    if negative {
        out.push(b'-');
    }
    push_whole(out, whole);
    if fraction == 0 {
        return;
    }
    out.push(b'.');
    let mut rest = fraction;
    let mut left = usize::from(decimals);
    while left > 8 {
        left -= 8;
        push_block(out, rest / POWERS[left]);
        rest %= POWERS[left];
    }
    push_block(out, rest * POWERS[8 - left]);
    drop_zeros(out);
}

fn push_whole(out: &mut Vec<u8>, n: u64) {
    if n < BLOCK {
        let (text, count) = leading_block(n);
        let end = out.len() + count as usize;
        out.extend_from_slice(&text.to_le_bytes());
        out.truncate(end);
    } else {
        push_whole(out, n / BLOCK);
        push_block(out, n % BLOCK);
    }
}

/// Eight digits of `n` < 10^8, leading zeros kept.
fn push_block(out: &mut Vec<u8>, n: u64) {
    out.extend_from_slice(&(digits(n) | ZEROS).to_le_bytes());
}

/// Takes zeros, and then a point, from the end of a text that has a point.
fn drop_zeros(out: &mut Vec<u8>) {
    while out.last() == Some(&b'0') {
        out.pop();
    }
    if out.last() == Some(&b'.') {
        out.pop();
    }
}

/// [`push_fixed`] for more than 19 decimals, for 2^64 and above, and for what is not finite.
#[cold]
fn push_fixed_by_std(out: &mut Vec<u8>, x: f64, decimals: u8) {
    let start = out.len();
    if x.is_finite() {
        // Writing to a `Vec` cannot fail.
        let _ = write!(out, "{x:.*}", usize::from(decimals));
        if decimals > 0 {
            drop_zeros(out);
        }
    }
    if matches!(&out[start..], b"" | b"-0") {
        out.truncate(start);
        out.push(b'0');
    }
}

/// [`round`] for more than 19 decimals.
#[cold]
fn round_by_std(x: f64, decimals: u8) -> f64 {
    // Above 10^-3 twenty decimals are finer than the float.
    if x.abs() >= 1e-3 || x.is_nan() {
        return x;
    }
    let mut text = Vec::new();
    push_fixed_by_std(&mut text, x, decimals);
    str::from_utf8(&text)
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(x)
}

#[cfg(test)]
mod tests;
