//! The shortest decimals of a float, as a number: what is printed of it, and what was typed.

use super::POWERS;
use super::digits::EXACT_POWERS;
use crate::numeric::double::Double;

/// Where what is nearest to 10^k times a number, k at most 17, is told by one word.
const QUICK: core::ops::Range<f64> = 0.004..1e15;

/// Where no power of ten that it takes leaves the range of `f64`.
const RANGE: core::ops::Range<f64> = 1e-270..1e290;

/// The shortest decimal that reads as `x`, off by a few parts in 2^105; `x` itself where that is huge, tiny or no number.
#[inline]
pub(crate) fn as_decimal(x: f64) -> Double {
    if QUICK.contains(&x.abs())
        && let Some(low) = beside(x.abs())
    {
        return Double::of_parts(x, low * 1.0_f64.copysign(x));
    }
    by_all_digits(x)
}

/// How far beyond x = m 2^-s that decimal lies. Of m 10^k 2^-s, which has 17 digits mostly, it is the nearest multiple of 100, of 10 or of 1,
/// the first that reads as x, and of two as near the even one. Lengths are in units of 2^-s: half a unit in the last place of x is 10^k / 2.
#[inline]
fn beside(x: f64) -> Option<f64> {
    let bits = x.to_bits();
    let exponent = bits >> 52;
    let (m, s) = ((bits & ((1 << 52) - 1)) | (1 << 52), 1075 - exponent);
    // The logarithm of 2 is 1233 / 4096.
    let digits = ((exponent.cast_signed() - 1023) * 1233) >> 12;
    let power = POWERS[(16 - digits).min(17) as usize];
    let product = u128::from(m) * u128::from(power);
    let whole = (product >> s) as u64;
    let rest = (whole % 1000) as u32;
    // Never so much that it leaves a word times 2^s: numbers whose whole part has 16 digits are below 0.1, and s is 60 at most.
    let steps: &[u32] = if whole < POWERS[16] {
        &[10, 1]
    } else if whole < POWERS[17] {
        &[100, 10, 1]
    } else {
        &[1000, 100, 10]
    };
    // Below a power of two floats are as near again.
    let half = power / if m == 1 << 52 { 4 } else { 2 };
    let near = (half >> s) as u32 + 1;
    let fraction = product as u64 & ((1 << s) - 1);
    for &step in steps {
        let over = rest % step;
        if over > near && step - over > near {
            continue;
        }
        let above = (u64::from(over) << s) + fraction;
        let below = (u64::from(step) << s) - above;
        let least = above.min(below);
        if least < half {
            let size = least as f64 / power as f64 * f64::from_bits((1023 - s) << 52);
            let is_even = (whole / u64::from(step)).is_multiple_of(2);
            let is_above = above < below || above == below && is_even;
            return Some(if is_above { -size } else { size });
        }
    }
    None
}

fn by_all_digits(x: f64) -> Double {
    if !RANGE.contains(&x.abs()) {
        return Double::of(x);
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(x.abs());
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let number = |units: u64, byte: u8| 10 * units + u64::from(byte - b'0');
    let units = whole.bytes().chain(fraction.bytes()).fold(0, number);
    let mut places = exponent.parse().unwrap_or(0) - (fraction.len() as u32).cast_signed();
    let high = units as f64;
    let low = units.cast_signed().wrapping_sub(high as i64);
    let mut decimal = Double::of_parts(high, low as f64);
    while places != 0 {
        let step = places.unsigned_abs().min(22);
        let power = EXACT_POWERS[step as usize];
        if places < 0 {
            decimal = decimal.over(power);
            places += step.cast_signed();
        } else {
            decimal = decimal.scaled(power);
            places -= step.cast_signed();
        }
    }
    decimal.scaled(1.0_f64.copysign(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_is_as_far_from_its_float_as_its_digits_say() {
        // 0.1 is 2^-54 / 10 less than its float 3602879701896397 / 2^55, whose decimals go on with 55511151231257827.
        for (x, low) in [
            (0.1, -5.551_115_123_125_783e-18),
            (-0.1, 5.551_115_123_125_783e-18),
            (1e23, 8_388_608.0),
            (0.5, 0.0),
            (1234.0, 0.0),
            (9_007_199_254_740_991.0, 0.0),
            (0.0, 0.0),
            (f64::MAX, 0.0),
        ] {
            let rest = as_decimal(x).minus(Double::of(x)).value();
            assert_eq!(rest, low, "{x}");
        }
        for x in [f64::INFINITY, 5e-324, 1e-280] {
            assert_eq!(as_decimal(x), Double::of(x));
        }
    }

    #[test]
    fn whole_parts_and_printed_digits_say_the_same() {
        let mut found = 0;
        for i in 1..20_000_i32 {
            let few = [1e1, 1e4, 1e7].map(|power| f64::from(i * 37) / power);
            let all =
                [1e-3, 0.7, 30.0, 1e4, 1e9, 1e14].map(|size| size * (1.0 + 1.0 / f64::from(i)));
            let powers = [libm::scalbn(1.0, i % 50), libm::scalbn(1.0, -(i % 10))];
            for x in few.into_iter().chain(all).chain(powers) {
                let (quick, long) = (as_decimal(x), by_all_digits(x));
                let apart = quick.minus(long).value().abs();
                assert!(apart <= 1e-31 * x && quick.value() == x, "{x}: {apart}");
                found += usize::from(QUICK.contains(&x) && beside(x).is_some());
            }
        }
        assert!(found > 190_000, "{found}");
    }
}
