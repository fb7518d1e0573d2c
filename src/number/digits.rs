//! What the readers and writers of numbers share: powers of ten, digits in a machine word, rounding by an addition.

/// `b"00000000"` as a number.
pub(crate) const ZEROS: u64 = 0x3030_3030_3030_3030;

/// The powers of ten that `f64` holds exactly: a whole number up to 2^53 over one of them is the correctly rounded quotient
/// (Clinger 1990).
pub(crate) const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// 3 2^51: a small number added to it is rounded to a whole one, which the lowest bits of the sum then hold.
pub(crate) const ROUNDING: f64 = (3_u64 << 51) as f64;

/// The eight digits of `n` < 10^8 as the bytes of the result, the first digit lowest.
///
/// Halves, then quarters, then single digits, all lanes at once; the multipliers are reciprocals of
/// 10^4, 10^2 and 10, exact for the lanes that they meet.
#[inline]
pub(crate) const fn digits(n: u64) -> u64 {
    let high = (n * 109_951_163) >> 40;
    let fours = high | ((n - 10_000 * high) << 32);
    let high = ((fours * 10_486) >> 20) & 0x0000_007f_0000_007f;
    let pairs = high | ((fours - 100 * high) << 16);
    let high = ((pairs * 103) >> 10) & 0x000f_000f_000f_000f;
    high | ((pairs - 10 * high) << 8)
}
