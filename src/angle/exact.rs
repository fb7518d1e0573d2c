//! Cosines and sines to some thirty digits.

use std::sync::LazyLock;

use super::Angle;
use crate::numeric::double::{Double, Twice};
use crate::numeric::instructions::by_the_best;

impl Angle {
    /// (cosine, sine) to some thirty digits.
    pub(crate) fn exact_direction(self) -> Twice {
        Self::direction_of(Double::of(self.degrees))
    }

    /// The same of degrees in twice the digits.
    pub(crate) fn direction_of(degrees: Double) -> Twice {
        let [high, low] = degrees.parts();
        // Both are exact, as in `direction`.
        let within = high % 360.0;
        let quarters = (within / 90.0).round();
        let rest = Double::difference(within - quarters * 90.0, -low);
        let [cos, sin] = if rest == Double::of(0.0) {
            [1.0, 0.0].map(Double::of)
        } else {
            exact_sin_cos(rest)
        };
        match (quarters as i64).rem_euclid(4) {
            0 => [cos, sin],
            1 => [sin.scaled(-1.0), cos],
            2 => [cos.scaled(-1.0), sin.scaled(-1.0)],
            _ => [sin, cos.scaled(-1.0)],
        }
    }
}

/// How many terms of Taylor's series take twice the digits, and how many there are.
const TWICE: usize = 8;
const TERMS: usize = 14;

/// 1/(1·2), 1/(3·4), ... of the cosine and 1/(2·3), 1/(4·5), ... of the sine.
static FACTORS: LazyLock<[[Double; TERMS]; 2]> = LazyLock::new(|| {
    [1.0, 2.0].map(|first| {
        core::array::from_fn(|k| {
            let n = first + 2.0 * k as f64;
            Double::of(1.0).divided(Double::of(n * (n + 1.0)))
        })
    })
});

/// The series of these factors at y = -x², without a last factor x.
#[inline(always)]
fn nested(y: Double, factors: &[Double; TERMS]) -> Double {
    let (few, many) = factors.split_at(TWICE);
    let more = |sum: f64, factor: &Double| 1.0 + y.value() * factor.value() * sum;
    let rest = many.iter().rev().fold(1.0, more);
    let mut sum = Double::of(rest);
    for &factor in few.iter().rev() {
        sum = y.times(sum).times(factor).plus(Double::of(1.0));
    }
    sum
}

/// (cosine, sine) of at most 45 degrees to some thirty digits, from Taylor's series nested as 1 - y/(1·2) (1 - y/(3·4) (1 - ...)) with
/// y the square of the angle. The terms from the 17th power on are so small that the digits of `f64` are enough for them.
fn exact_sin_cos(degrees: Double) -> Twice {
    /// π/180.
    const RADIANS: Double =
        Double::of_parts(0.017_453_292_519_943_295, 2.948_652_270_870_168_7e-19);
    let factors = &*FACTORS;
    by_the_best(
        #[inline(always)]
        || {
            let x = RADIANS.times(degrees);
            let y = x.times(x).scaled(-1.0);
            [nested(y, &factors[0]), x.times(nested(y, &factors[1]))]
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_directions_lie_on_the_unit_circle_and_add_up() {
        let product = |[a, b]: Twice, [c, d]: Twice| {
            let less = |x: Double, y: Double| x.plus(y.scaled(-1.0));
            [less(a.times(c), b.times(d)), a.times(d).plus(b.times(c))]
        };
        for i in -2000..2000 {
            let degrees = f64::from(i) * 0.375;
            let [cos, sin] = Angle::from_degrees(degrees).exact_direction();
            let near = Angle::from_degrees(degrees).direction();
            assert!((cos.value() - near.x).abs() < 3e-16 && (sin.value() - near.y).abs() < 3e-16);
            let twice = product([cos, sin], [cos, sin]);
            let other = Angle::from_degrees(2.0 * degrees).exact_direction();
            for (a, b) in twice.into_iter().zip(other) {
                assert!(a.plus(b.scaled(-1.0)).value().abs() < 1e-30, "{degrees}");
            }
        }
        let third = Angle::from_degrees(60.0).exact_direction()[0];
        assert!(third.plus(Double::of(-0.5)).value().abs() < 1e-31);
    }
}
