//! Cosines and sines to some thirty digits.

use super::Angle;
use crate::numeric::double::{Double, Twice};

impl Angle {
    /// (cosine, sine) to some thirty digits.
    pub(crate) fn exact_direction(self) -> Twice {
        // Both are exact, as in `direction`.
        let within = self.degrees % 360.0;
        let quarters = (within / 90.0).round();
        let rest = within - quarters * 90.0;
        let [cos, sin] = if rest == 0.0 {
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

/// (cosine, sine) of at most 45 degrees to some thirty digits, from Taylor's series nested as 1 - y/(1·2) (1 - y/(3·4) (1 - ...)) with
/// y the square of the angle. The terms from the 17th power on are so small that the digits of `f64` are enough for them.
fn exact_sin_cos(degrees: f64) -> Twice {
    /// π/180.
    const RADIANS: Double =
        Double::of_parts(0.017_453_292_519_943_295, 2.948_652_270_870_168_7e-19);
    let x = RADIANS.scaled(degrees);
    let y = x.times(x).scaled(-1.0);
    let nested = |first: f64| {
        let divisor = |k: i32| (first + 2.0 * f64::from(k)) * (first + 2.0 * f64::from(k) + 1.0);
        let rest = (8..14)
            .rev()
            .fold(1.0, |sum, k| 1.0 + y.value() / divisor(k) * sum);
        (0..8).rev().fold(Double::of(rest), |sum, k| {
            y.times(sum).over(divisor(k)).plus(Double::of(1.0))
        })
    };
    [nested(1.0), x.times(nested(2.0))]
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
