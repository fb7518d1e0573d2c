//! What a platform's mathematical library would answer, but with the same digits everywhere. The crate `libm` answers for the rest;
//! `clippy.toml` forbids the methods of `f64` and of kurbo that ask the platform.

use kurbo::Vec2;

/// x^n by repeated squaring. The standard `powi` leaves the order of its roundings to the platform.
#[inline]
pub(crate) fn power(mut x: f64, n: i32) -> f64 {
    let mut rest = n.unsigned_abs();
    let mut product = 1.0;
    loop {
        if rest & 1 == 1 {
            product *= x;
        }
        rest >>= 1;
        if rest == 0 {
            break;
        }
        x *= x;
    }
    if n < 0 { 1.0 / product } else { product }
}

/// The angle of a vector in radians, from +x towards +y.
#[inline]
pub(crate) fn angle_of(v: Vec2) -> f64 {
    libm::atan2(v.y, v.x)
}

/// The unit vector at an angle in radians.
#[inline]
pub(crate) fn unit_vector(radians: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(radians);
    Vec2::new(cos, sin)
}

/// The larger of two numbers, with one instruction as neither is NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_and_two_are_exact() {
        for n in 0..=22 {
            let exact: f64 = format!("1e{n}").parse().unwrap();
            assert_eq!(power(10.0, n), exact);
            assert_eq!(power(10.0, -n), 1.0 / exact);
        }
        assert_eq!(power(2.0, -1022), f64::MIN_POSITIVE);
        assert_eq!(power(-3.0, 3), -27.0);
        assert_eq!(power(7.0, i32::MIN), 0.0);
    }

    #[test]
    fn a_unit_vector_has_the_angle_it_was_made_of() {
        for radians in [-3.0, -1.0, 0.0, 0.5, 1.5, 3.0] {
            assert!((angle_of(unit_vector(radians)) - radians).abs() < 4e-16);
        }
    }
}
