//! The number type: binary floating point of [`PRECISION`] bits, correctly rounded by `dashu-float`.

use dashu_float::{DBig, FBig, round::mode::HalfEven};
use std::str::FromStr;

/// A real number of [`PRECISION`] bits. Results take the larger precision of their operands, so
/// every value must enter through [`real`], [`int`] or [`parse`].
pub type Real = FBig<HalfEven, 2>;

/// A point or a vector.
pub type Point = [Real; 2];

/// Working precision in bits: 77 significant digits.
///
/// At 0.01 degrees a sixth-order method is wrong by about 1e-28 of a radius, and that is the
/// difference of numbers near 1, so 49 digits of an error are left there: the same precision
/// serves every angle.
pub const PRECISION: usize = 256;

/// An `f64` as it is, without rounding.
pub fn real(x: f64) -> Real {
    Real::try_from(x)
        .expect("a finite number")
        .with_precision(PRECISION)
        .value()
}

/// The shortest decimal that reads as an `f64`: what is printed of it, and what was typed.
pub fn decimal(x: f64) -> Real {
    parse(&x.to_string())
}

/// A whole number.
pub fn int<N>(n: N) -> Real
where
    Real: From<N>,
{
    Real::from(n).with_precision(PRECISION).value()
}

/// The fraction `n / d`.
pub fn ratio(n: i64, d: i64) -> Real {
    int(n) / int(d)
}

/// `2^exponent`.
pub fn power_of_two(exponent: isize) -> Real {
    Real::from_parts(1.into(), exponent)
        .with_precision(PRECISION)
        .value()
}

/// A decimal literal such as `-1.25e-7`, rounded once.
pub fn parse(text: &str) -> Real {
    DBig::from_str(text)
        .expect("a decimal number")
        .with_rounding::<HalfEven>()
        .with_base_and_precision::<2>(PRECISION)
        .value()
}

/// The nearest `f64`.
pub fn to_f64(x: &Real) -> f64 {
    x.to_f64().value()
}

/// π.
pub fn pi() -> Real {
    Real::pi(PRECISION)
}

/// Degrees to radians.
pub fn radians(degrees: &Real) -> Real {
    degrees * pi() / int(180)
}

/// True for both zeros.
pub fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

/// -1, 0 or 1.
pub fn sign(x: &Real) -> i32 {
    if is_zero(x) {
        0
    } else if *x > int(0) {
        1
    } else {
        -1
    }
}

/// `|x|`.
pub fn abs(x: &Real) -> Real {
    if sign(x) < 0 { -x } else { x.clone() }
}

/// The larger of two numbers.
pub fn max(x: Real, y: Real) -> Real {
    if x < y { y } else { x }
}

/// The cross product `x_1 y_2 - y_1 x_2`.
pub fn cross(p: &Point, q: &Point) -> Real {
    &p[0] * &q[1] - &p[1] * &q[0]
}

/// The dot product.
pub fn dot(p: &Point, q: &Point) -> Real {
    &p[0] * &q[0] + &p[1] * &q[1]
}

/// The length of a vector.
pub fn norm(p: &Point) -> Real {
    dot(p, p).sqrt()
}

/// One unit of the last printed digit; for a printed 0, which is exact, 1e-40.
fn last_place(printed: &str) -> Real {
    if printed == "0" {
        return parse("1e-40");
    }
    let (digits, exponent) = printed.split_once('e').unwrap_or((printed, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    parse(&format!("1e{exponent}")) / Real::from(10).powi(decimals.into())
}

/// Whether a value agrees with all digits of a printed number, the last one give or take one.
pub fn agrees(value: &Real, printed: &str) -> bool {
    abs(&(value - parse(printed))) <= last_place(printed)
}
