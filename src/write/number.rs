//! Numbers as text: the only place of this crate that turns a float into digits.
//!
//! Two forms, both in plain notation (never an exponent, never `-0`, no idle zero after the point):
//! a fixed number of decimals, and the shortest digits that read back as the same float.
//!
//! A float is the integer m times 2^-s. For a fixed number d of decimals it splits without error into
//! a whole part, m >> s, and a fraction whose product with 10^d fits 128 bits; the bits below the point
//! of that product decide the rounding exactly, ties included. No float is multiplied on the way.

use std::io::Write as _;

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
        let mut scale = 1.0;
        for decimals in 0..=20 {
            // More decimals than the coordinates have digits say nothing.
            if decimals > 0 && largest * scale > 1e15 {
                break;
            }
            if core::f64::consts::FRAC_1_SQRT_2 / scale <= distance {
                return Self::Fixed(decimals);
            }
            scale *= 10.0;
        }
        Self::Full
    }

    /// Appends `x` to `out`, by [`push_shortest`] or [`push_fixed`].
    #[inline]
    pub fn push(self, out: &mut Vec<u8>, x: f64) {
        match self {
            Self::Full => push_shortest(out, x),
            Self::Fixed(decimals) => push_fixed(out, x, decimals),
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
}

/// Appends `x` with at most `decimals` decimals.
///
/// Rounds the exact binary value to nearest, ties to even, as `format!("{x:.decimals$}")` does, then drops
/// trailing zeros and the sign of a zero: `0.125` gives `0.12` with two decimals and `-0.001` gives `0`.
///
/// A float that is not finite prints as `0`: no writer may emit `NaN` or `inf`, and it is the caller who
/// has to refuse such a number where a user can still be told.
pub fn push_fixed(out: &mut Vec<u8>, x: f64, decimals: u8) {
    let Some((whole, fraction)) = power(decimals).and_then(|power| split(x, power)) else {
        return push_fixed_by_std(out, x, decimals);
    };
    let negative = x.is_sign_negative() && (whole | fraction) != 0;
    if whole < SHORT_WHOLE && decimals <= 8 {
        push_short(out, negative, whole, fraction, decimals);
    } else {
        push_long(out, negative, whole, fraction, decimals);
    }
}

/// Appends the shortest digits that read back as `x`: of several the nearest to it, of two equally near the
/// even one (the upper one at powers of two, as std has it everywhere), so that zmij and `serde_json` give the
/// same digits. `-0.0` gives `0`.
///
/// A float that is not finite prints as `0`; see [`push_fixed`].
pub fn push_shortest(out: &mut Vec<u8>, x: f64) {
    if x == 0.0 || !x.is_finite() {
        out.push(b'0');
        return;
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(x);
    // Within this range zmij writes plain notation, so that there is no exponent to look for.
    if (1e-4..1e15).contains(&x.abs()) || !text.contains('e') {
        out.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
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
    let Some(power) = power(decimals) else {
        return round_by_std(x, decimals);
    };
    let steps = split(x, power)
        .and_then(|(whole, fraction)| whole.checked_mul(power)?.checked_add(fraction));
    match steps {
        Some(0) => 0.0,
        // Both operands are exact, 10^19 too, so the quotient is the nearest float.
        Some(steps) if steps <= EXACT_STEPS => (steps as f64 / power as f64).copysign(x),
        // Decimals are closer together here than floats: x is the nearest to its own rounding.
        _ => x,
    }
}

/// The number of decimals of the shortest form of `x`: 2 for `0.25`, 7 for `1e-7`, 0 for `50`; 255 at most.
#[must_use]
pub fn decimals_of(x: f64) -> u8 {
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

/// The text of a number with so many significant digits, for prose.
#[must_use]
pub fn significant(x: f64, digits: u8) -> String {
    let magnitude = if x == 0.0 || !x.is_finite() {
        0.0
    } else {
        x.abs().log10().floor()
    };
    let decimals = (f64::from(digits) - 1.0 - magnitude).clamp(0.0, 60.0);
    let mut out = Vec::new();
    push_fixed(&mut out, x, decimals as u8);
    String::from_utf8_lossy(&out).into_owned()
}

/// The number nearest to `x`, by ratio, that is a 1, 2 or 5 with zeros; 1 where `x` is not positive and finite.
#[must_use]
pub fn round_one_two_five(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let exponent = x.log10().floor() as i32;
    // One rounding only: 10^22 and less are exact.
    let scaled = |digit: f64| match exponent {
        0.. => digit * 10_f64.powi(exponent),
        _ => digit / 10_f64.powi(-exponent),
    };
    [1.0, 2.0, 5.0, 10.0]
        .map(scaled)
        .into_iter()
        .min_by(|a, b| (a / x).ln().abs().total_cmp(&(b / x).ln().abs()))
        .unwrap_or(1.0)
}

/// The text of a number for tables: so many significant digits, trailing zeros kept so that columns align; as `1.96076e-4` below
/// a thousandth and from ten millions on. A number that is not finite gives `-`.
#[must_use]
pub fn compact(x: f64, digits: u8) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return "-".to_owned();
    }
    let digits = digits.max(1);
    let text = format!("{x:.*e}", usize::from(digits) - 1);
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    match exponent {
        Some(exponent @ -3..7) => {
            let decimals = (i32::from(digits) - 1 - exponent).max(0);
            format!("{x:.*}", decimals as usize)
        }
        _ => text,
    }
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
/// Whole numbers up to here are floats, every one.
const EXACT_STEPS: u64 = 1 << 53;
/// Below this a sign, the whole part, the point and eight decimals fit 16 bytes.
const SHORT_WHOLE: u64 = 1_000_000;
/// Eight decimal digits to a block.
const BLOCK: u64 = 100_000_000;
/// `b"00000000"` as a number.
const ZEROS: u64 = 0x3030_3030_3030_3030;

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

/// The eight digits of `n` < 10^8 as the bytes of the result, the first digit lowest.
///
/// Halves, then quarters, then single digits, all lanes at once; the multipliers are reciprocals of
/// 10^4, 10^2 and 10, exact for the lanes that they meet.
#[inline]
const fn digits(n: u64) -> u64 {
    let high = (n * 109_951_163) >> 40;
    let fours = high | ((n - 10_000 * high) << 32);
    let high = ((fours * 10_486) >> 20) & 0x0000_007f_0000_007f;
    let pairs = high | ((fours - 100 * high) << 16);
    let high = ((pairs * 103) >> 10) & 0x000f_000f_000f_000f;
    high | ((pairs - 10 * high) << 8)
}

/// The digits of `n` < 10^8 without leading zeros as ASCII, the first one lowest, and how many they are.
#[inline]
const fn leading_block(n: u64) -> (u64, u32) {
    let digits = digits(n);
    // A zero keeps one digit.
    let skip = (digits | (1 << 56)).trailing_zeros() / 8;
    ((digits | ZEROS) >> (8 * skip), 8 - skip)
}

/// The common case, without a branch: the text grows in two words and is stored at once.
#[inline]
fn push_short(out: &mut Vec<u8>, negative: bool, whole: u64, fraction: u64, decimals: u8) {
    let (whole, count) = leading_block(whole);
    let sign = u32::from(negative);
    // At most 7 bytes stand before the point.
    let point = sign + count;
    let decimals = digits(fraction * POWERS[usize::from(8 - decimals.min(8))]);
    let used = 8 - decimals.leading_zeros() / 8;
    let ascii = decimals | ZEROS;

    let minus = u64::from(b'-') * u64::from(sign);
    let low = minus
        | (whole << (8 * sign))
        | (u64::from(b'.') << (8 * point))
        | (ascii << (8 * point) << 8);
    let high = ascii >> (56 - 8 * point);
    let text = u128::from(low) | (u128::from(high) << 64);
    let length = point + used + u32::from(used > 0);
    let end = out.len() + length as usize;
    out.extend_from_slice(&text.to_le_bytes());
    out.truncate(end);
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
mod tests {
    use super::*;

    #[test]
    fn compact_numbers_keep_their_digits() {
        let texts = [
            0.015_213_035,
            1.960_76e-4,
            0.0,
            -123.456,
            9.999_999_9,
            1e7,
            f64::NAN,
        ]
        .map(|x| compact(x, 6));
        assert_eq!(
            texts,
            [
                "0.0152130",
                "1.96076e-4",
                "0",
                "-123.456",
                "10.0000",
                "1.00000e7",
                "-"
            ]
        );
    }
    use proptest::prelude::*;
    use std::thread;

    fn fixed(x: f64, decimals: u8) -> String {
        let mut out = b"#".to_vec();
        push_fixed(&mut out, x, decimals);
        String::from_utf8(out).unwrap().split_off(1)
    }

    fn shortest(x: f64) -> String {
        let mut out = b"#".to_vec();
        push_shortest(&mut out, x);
        String::from_utf8(out).unwrap().split_off(1)
    }

    /// The text of std, brought to our form.
    fn plain(mut text: String) -> String {
        if text.contains('.') {
            text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
        }
        if text == "-0" { "0".to_owned() } else { text }
    }

    /// All that this file promises of one finite number.
    fn check(x: f64, decimals: u8) {
        let text = fixed(x, decimals);
        assert_eq!(
            text,
            plain(format!("{x:.*}", usize::from(decimals))),
            "{x:e} with {decimals} decimals"
        );
        let rounded = round(x, decimals);
        let read: f64 = text.parse().unwrap();
        assert_eq!(
            rounded.to_bits(),
            read.to_bits(),
            "{x:e} rounded to {decimals} decimals"
        );
        if text.trim_start_matches(['-', '0', '.']).len() <= 15 {
            assert_eq!(
                shortest(rounded),
                text,
                "{x:e} rounded to {decimals} decimals, in full"
            );
        }
        check_shortest(x);
    }

    /// Equal to std, or as short, a reading of the same float, and the even one of two equally near.
    fn check_shortest(x: f64) {
        let (text, std) = (shortest(x), plain(format!("{x}")));
        if text != std {
            let decimals = std
                .split_once('.')
                .map_or(0, |(_, decimals)| decimals.len());
            assert_eq!(text, format!("{x:.decimals$}"), "{x:e} in full");
            assert_eq!(
                (text.parse(), text.len()),
                (Ok(x), std.len()),
                "{x:e} in full"
            );
        }
    }

    /// `SplitMix64`: the same numbers in every run.
    struct Numbers(u64);

    impl Numbers {
        fn bits(&mut self) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }

        /// Coordinates, decimals, exact ties, their neighbours, and any bits at all.
        fn sample(&mut self) -> (f64, u8) {
            let choice = self.bits();
            let decimals = (choice >> 8) % 21;
            let value = self.bits();
            let near = value.cast_signed() >> (11 + (choice >> 16) % 53);
            let x = match choice % 6 {
                0 => near as f64 / 2f64.powi(((choice >> 24) % 60) as i32),
                1 => (near as f64 / 2f64.powi(((choice >> 24) % 20) as i32)).next_up(),
                2 => near as f64 / 10f64.powi(((choice >> 24) % 20) as i32),
                3 => ((value % 2_000_000) as f64 + 0.5) / 10f64.powi(decimals as i32),
                4 => 500.0 * ((value >> 11) as f64 / 2f64.powi(52) - 1.0),
                _ => f64::from_bits(value),
            };
            (if x.is_finite() { x } else { 0.5 }, decimals as u8)
        }
    }

    #[test]
    fn trailing_zeros_and_point_are_dropped_and_the_leading_zero_is_kept() {
        assert_eq!(fixed(0.5, 3), "0.5");
        assert_eq!(fixed(-27.596, 3), "-27.596");
        assert_eq!(fixed(50.0, 8), "50");
        assert_eq!(fixed(100.0, 0), "100");
        assert_eq!(fixed(1200.0, 12), "1200");
        assert_eq!(fixed(0.1, 17), "0.10000000000000001");
    }

    #[test]
    fn a_tie_of_the_binary_value_goes_to_even_and_no_other_is_a_tie() {
        assert_eq!(fixed(0.125, 2), "0.12");
        assert_eq!(fixed(0.375, 2), "0.38");
        assert_eq!(fixed(2.5, 0), "2");
        assert_eq!(fixed(3.5, 0), "4");
        // The float is a little more, or less, than the decimal in the source.
        assert_eq!(fixed(1.005, 2), "1");
        assert_eq!(fixed(0.15, 1), "0.1");
        assert_eq!(fixed(0.35, 1), "0.3");
        assert_eq!(fixed(0.45, 1), "0.5");
    }

    #[test]
    fn a_carry_reaches_the_whole_part() {
        assert_eq!(fixed(0.9999, 3), "1");
        assert_eq!(fixed(-999_999.999_999_99, 3), "-1000000");
        assert_eq!(fixed(99_999_999.999_999_99, 3), "100000000");
    }

    #[test]
    fn zero_has_no_sign() {
        for x in [0.0, -0.0, -1e-9, -5e-324] {
            assert_eq!(fixed(x, 3), "0");
            assert_eq!(fixed(x, 0), "0");
            assert_eq!(round(x, 3).to_bits(), 0);
        }
        assert_eq!(fixed(-5e-324, 255), "0");
        assert_eq!(round(-5e-324, 255).to_bits(), 0);
        assert_eq!(shortest(-0.0), "0");
    }

    #[test]
    fn no_magnitude_needs_an_exponent() {
        assert_eq!(shortest(1e21), "1000000000000000000000");
        assert_eq!(shortest(-1e-7), "-0.0000001");
        assert_eq!(fixed(1e21, 2), "1000000000000000000000");
        assert_eq!(fixed(1e-20, 30), "0.00000000000000000001");
        for exponent in -323..=308 {
            let x: f64 = format!("1e{exponent}").parse().unwrap();
            for x in [x, x.next_down(), -x.next_up(), f64::MAX, f64::MIN_POSITIVE] {
                (0..=40).for_each(|decimals| check(x, decimals));
                check(x, 255);
            }
        }
    }

    #[test]
    fn what_is_not_finite_prints_as_zero_and_stays_in_a_measurement() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for decimals in [0, 3, 19, 20, 255] {
                assert_eq!(fixed(x, decimals), "0");
                assert_eq!(round(x, decimals).is_nan(), x.is_nan());
                assert!(!round(x, decimals).is_finite());
            }
            assert_eq!(shortest(x), "0");
            assert_eq!(decimals_of(x), 0);
        }
    }

    #[test]
    fn of_two_shortest_forms_the_even_one_is_printed() {
        assert_eq!(shortest(13_100_520_720.5 / 512.0), "25586954.532226562");
    }

    #[test]
    fn decimals_are_counted_on_the_shortest_form() {
        let cases = [
            (0.25, 2),
            (1e-7, 7),
            (50.0, 0),
            (-0.0, 0),
            (27.596, 3),
            (1e300, 0),
            (5e-324, 255),
        ];
        for (x, decimals) in cases {
            assert_eq!(decimals_of(x), decimals, "{x}");
        }
    }

    #[test]
    fn precision_chooses_the_form() {
        let mut out = Vec::new();
        Precision::Full.push(&mut out, 1.0625);
        out.push(b' ');
        Precision::Fixed(1).push(&mut out, 1.0625);
        assert_eq!(out, b"1.0625 1.1");
        assert_eq!(Precision::Full.round(1.0625), 1.0625);
        assert_eq!(Precision::Fixed(1).round(1.0625), 1.1);
    }

    #[test]
    fn eight_digits_are_split_without_error() {
        for n in (0..10_000)
            .chain((0..BLOCK).step_by(997))
            .chain([BLOCK - 1])
        {
            assert_eq!(
                (digits(n) | ZEROS).to_le_bytes(),
                format!("{n:08}").as_bytes()
            );
        }
    }

    proptest! {
        #[test]
        fn any_bits_print_as_std_prints_them(bits: u64, decimals in 0..30u8) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            check(x, decimals);
        }

        #[test]
        fn decimal_inputs_print_as_std_prints_them(n in -1_000_000_000_000i64..1_000_000_000_000, scale in 0..16i32, decimals in 0..20u8) {
            check(n as f64 / 10f64.powi(scale), decimals);
        }

        #[test]
        fn exact_ties_print_as_std_prints_them(k in -(1i64 << 53)..(1 << 53), drop in 0..53u32, n in 0..70i32, decimals in 0..20u8) {
            check((k >> drop) as f64 / 2f64.powi(n), decimals);
        }
    }

    fn check_many(count: u64) {
        let threads = thread::available_parallelism().map_or(1, usize::from) as u64;
        thread::scope(|scope| {
            for seed in 0..threads {
                scope.spawn(move || {
                    let mut numbers = Numbers(seed << 40);
                    for _ in 0..count.div_ceil(threads) {
                        let (x, decimals) = numbers.sample();
                        check(x, decimals);
                    }
                });
            }
        });
    }

    #[test]
    fn a_million_mixed_numbers_print_as_std_prints_them() {
        check_many(1_000_000);
    }

    /// Fewer with `CURVETO_NUMBERS`: `CURVETO_NUMBERS=100000000 cargo test --release -- --ignored number`.
    #[test]
    #[ignore = "long: a billion numbers against std"]
    fn a_billion_mixed_numbers_print_as_std_prints_them() {
        check_many(
            std::env::var("CURVETO_NUMBERS").map_or(1_000_000_000, |count| count.parse().unwrap()),
        );
    }
}
