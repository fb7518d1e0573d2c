//! Angles in degrees, with the units of CSS, and the exact sines and cosines that symmetric output needs.

mod exact;

use core::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use core::fmt;
use core::str::FromStr;

use kurbo::Vec2;

use crate::error::{Error, Result, finite};
use crate::number::digits::ROUNDING;
use crate::numeric::functions::angle_of;

/// An angle, held in degrees so that quarters, eighths and twelfths of a turn are exact.
///
/// ```
/// use curveto::Angle;
/// let quarter: Angle = "0.25turn".parse()?;
/// assert_eq!(quarter, Angle::from_degrees(90.0));
/// assert_eq!(quarter.direction(), kurbo::Vec2::new(0.0, 1.0)); // no 6e-17
/// # Ok::<(), curveto::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Angle {
    degrees: f64,
}

impl Angle {
    /// No turn at all.
    pub const ZERO: Self = Self { degrees: 0.0 };
    /// A full turn in the positive direction.
    pub const TURN: Self = Self { degrees: 360.0 };

    /// An angle of this many degrees.
    #[must_use]
    pub const fn from_degrees(degrees: f64) -> Self {
        Self { degrees }
    }

    /// An angle of this many radians.
    #[must_use]
    pub fn from_radians(radians: f64) -> Self {
        Self {
            degrees: radians.to_degrees(),
        }
    }

    /// The angle of a vector, from +x towards +y.
    pub(crate) fn of(vector: Vec2) -> Self {
        Self::from_radians(angle_of(vector))
    }

    /// The angle in degrees.
    #[must_use]
    pub const fn degrees(self) -> f64 {
        self.degrees
    }

    /// The angle in radians.
    #[must_use]
    pub fn radians(self) -> f64 {
        self.degrees.to_radians()
    }

    /// The sweep from this angle to another, which is raised by whole turns until it is not below this one, as PostScript's `arc`
    /// reads it, or reversed, as `arcn` does, lowered until it is not above.
    #[must_use]
    pub fn sweep_to(self, end: Self, reverse: bool) -> Self {
        let sign = if reverse { -1.0 } else { 1.0 };
        let sweep = sign * (end.degrees - self.degrees);
        let sweep = if sweep < 0.0 {
            sweep.rem_euclid(360.0)
        } else {
            sweep
        };
        Self::from_degrees(sign * sweep)
    }

    /// (cosine, sine), exact at every multiple of 30 and 45 degrees that has a rational or square-root-of-two value,
    /// and equal to the last digit at angles that mirror one another in an axis or a diagonal.
    #[must_use]
    #[inline]
    pub fn direction(self) -> Vec2 {
        direction_within(self.within_turn())
    }

    /// Degrees of the same direction, at most a turn of them; the remainder is exact.
    #[inline]
    pub(crate) fn within_turn(self) -> f64 {
        let size = self.degrees.abs();
        if size <= 360.0 {
            self.degrees
        } else if size <= 720.0 {
            self.degrees - 360.0_f64.copysign(self.degrees)
        } else {
            self.degrees % 360.0
        }
    }

    /// The direction at `part / parts` of a full turn in the sense of `sign`, counted from this angle.
    ///
    /// From a multiple of a quarter turn the fraction is reduced in whole numbers, so that `part` and `parts - part` mirror exactly.
    pub(crate) fn direction_in_turn(self, sign: f64, part: usize, parts: usize) -> Vec2 {
        // The product is exact, so that it decides.
        let start = (self.degrees / 90.0) as i64;
        if start.unsigned_abs() > 1 << 46 || start as f64 * 90.0 != self.degrees {
            return Self::from_degrees(self.degrees + sign * 360.0 * (part as f64 / parts as f64))
                .direction();
        }
        let quarters = (4 * part + parts / 2) / parts;
        let rest = (4 * part) as f64 - (quarters * parts) as f64;
        let within = if rest == 0.0 {
            Vec2::new(1.0, 0.0)
        } else {
            residual_direction(sign * 90.0 * rest / parts as f64)
        };
        quarter_turns(
            within,
            (start + (sign * quarters as f64) as i64).cast_unsigned(),
        )
    }
}

/// The direction of an angle of at most a turn, without a branch. The subtraction of a whole number of quarters is exact.
#[inline(always)]
pub(crate) fn direction_within(degrees: f64) -> Vec2 {
    let quarters = degrees * (1.0 / 90.0) + ROUNDING;
    quarter_turns(
        residual_direction(degrees - (quarters - ROUNDING) * 90.0),
        quarters.to_bits(),
    )
}

/// The direction of an angle of at most 45 degrees (a little more where rounding made it so).
#[inline(always)]
fn residual_direction(degrees: f64) -> Vec2 {
    let size = first_direction(degrees.abs());
    Vec2::new(size.x, size.y.copysign(degrees))
}

/// The cosine of 30 degrees, as the square root of 0.75 is rounded.
const HALF_ROOT_3: f64 = 0.866_025_403_784_438_6;

/// The direction of an angle from 0 to 45 degrees.
#[inline(always)]
pub(crate) fn first_direction(degrees: f64) -> Vec2 {
    let (sin, cos) = sin_cos(degrees.to_radians());
    // A choice between values takes no branch, and may be made for many angles at once.
    let (sin, cos) = if degrees == 30.0 {
        (0.5, HALF_ROOT_3)
    } else {
        (sin, cos)
    };
    let (sin, cos) = if degrees == 45.0 {
        (FRAC_1_SQRT_2, FRAC_1_SQRT_2)
    } else {
        (sin, cos)
    };
    Vec2::new(cos, sin)
}

/// Sine and cosine of an angle of at most an eighth of a turn, from Taylor's series up to the 17th power, whose rest is below 1e-19
/// there. The sums are nested in pairs, which a processor adds side by side.
#[inline(always)]
fn sin_cos(x: f64) -> (f64, f64) {
    let y = x * x;
    let sin = sum(
        y,
        [
            -1.0 / 6.0,
            1.0 / 120.0,
            -1.0 / 5_040.0,
            1.0 / 362_880.0,
            -1.0 / 39_916_800.0,
            1.0 / 6_227_020_800.0,
            -1.0 / 1_307_674_368_000.0,
            1.0 / 355_687_428_096_000.0,
        ],
    );
    let cos = sum(
        y,
        [
            1.0 / 24.0,
            -1.0 / 720.0,
            1.0 / 40_320.0,
            -1.0 / 3_628_800.0,
            1.0 / 479_001_600.0,
            -1.0 / 87_178_291_200.0,
            1.0 / 20_922_789_888_000.0,
            -1.0 / 6_402_373_705_728_000.0,
        ],
    );
    (x + (x * y) * sin, 1.0 - (0.5 * y - y * y * cos))
}

/// The angle in degrees of a point of the first quadrant, with an error of two units in the last place: exactly 0 and 90 on its
/// axes and 45 on its diagonal. Without a branch.
///
/// An angle beyond π/8 is taken from the nearer of the diagonal and the y axis, so that one quotient u of at most tan(π/8) is left. There
/// atan(u) = u + u³ p(u²), with p of Remez's algorithm, errs by at most 5e-20 u.
#[inline(always)]
pub(crate) fn quadrant_degrees(y: f64, x: f64) -> f64 {
    const EIGHTH: f64 = SQRT_2 - 1.0;
    let (over, under, base) = (y - x, y + x, 45.0);
    let (over, under, base) = if x < EIGHTH * y {
        (-x, y, 90.0)
    } else {
        (over, under, base)
    };
    let (over, under, base) = if y < EIGHTH * x {
        (y, x, 0.0)
    } else {
        (over, under, base)
    };
    let u = over / under;
    let square = u * u;
    let low = sum(
        square,
        [
            -0.333_333_333_333_333_26,
            0.199_999_999_999_976_95,
            -0.142_857_142_853_911_46,
            0.111_111_110_883_672_08,
            -0.090_909_081_512_013_6,
            0.076_922_829_069_109_48,
            -0.066_662_289_185_260_38,
            0.058_770_427_609_107_986,
        ],
    );
    let (c8, c9) = (-0.052_185_383_866_417_07, 0.045_040_914_572_489_314);
    let (c10, c11) = (-0.033_487_027_315_515_24, 0.015_207_883_959_423_331);
    let high = (c8 + c9 * square) + (square * square) * (c10 + c11 * square);
    let fourth = (square * square) * (square * square);
    base + (u + (u * square) * (low + (fourth * fourth) * high)).to_degrees()
}

/// c0 + c1 y + ... + c7 y⁷.
#[inline(always)]
pub(crate) fn sum(y: f64, c: [f64; 8]) -> f64 {
    let (y2, y4) = (y * y, (y * y) * (y * y));
    let low = (c[0] + c[1] * y) + y2 * (c[2] + c[3] * y);
    let high = (c[4] + c[5] * y) + y2 * (c[6] + c[7] * y);
    low + y4 * high
}

/// `v` turned by a whole number of quarters, of which the last two bits count, without a rounding error, a negative zero, or a branch that random angles would
/// mispredict.
#[inline(always)]
fn quarter_turns(v: Vec2, quarters: u64) -> Vec2 {
    let (x, y) = (v.x.to_bits(), v.y.to_bits());
    // One and three quarters swap the coordinates; x turns its sign for one and two of them, y for two and three.
    let exchange = (x ^ y) & (quarters & 1).wrapping_neg();
    let x = (x ^ exchange) ^ ((quarters.wrapping_add(1) & 2) << 62);
    let y = (y ^ exchange) ^ ((quarters & 2) << 62);
    Vec2::new(f64::from_bits(x) + 0.0, f64::from_bits(y) + 0.0)
}

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}deg", self.degrees)
    }
}

impl FromStr for Angle {
    type Err = Error;

    /// Reads a CSS angle: a number with `deg` (the default), `rad`, `grad` or `turn`.
    fn from_str(text: &str) -> Result<Self> {
        const UNITS: [(&str, f64); 4] =
            [("grad", 0.9), ("rad", 0.0), ("turn", 360.0), ("deg", 1.0)];
        // The units of CSS have no case.
        let lower = text.trim().to_ascii_lowercase();
        let trimmed = lower.as_str();
        let (number, unit) = UNITS
            .iter()
            .find_map(|&(unit, factor)| trimmed.strip_suffix(unit).map(|number| (number, factor)))
            .unwrap_or((trimmed, 1.0));
        let value: f64 = number.trim_end().parse().map_err(|_| Error::Syntax {
            what: "the angle",
            text: text.to_owned(),
            column: 1,
            why: "an angle is a number of degrees, or a number followed by deg, rad, grad or turn"
                .to_owned(),
        })?;
        let value = finite("angle", value)?;
        Ok(if unit == 0.0 {
            Self::from_radians(value)
        } else {
            Self::from_degrees(value * unit)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_css() {
        for text in [
            "90",
            "90deg",
            "100grad",
            "0.25turn",
            "0.25TURN",
            "1.5707963267948966rad",
            " 90 deg ",
        ] {
            assert_eq!(text.parse::<Angle>().unwrap().degrees(), 90.0, "{text}");
        }
        assert!("".parse::<Angle>().is_err());
        assert!("1e999".parse::<Angle>().is_err());
        assert!("NaN".parse::<Angle>().is_err());
        assert!("ninety".parse::<Angle>().is_err());
    }

    #[test]
    fn quadrants_are_exact() {
        for turn in -8..=8 {
            let d = Angle::from_degrees(90.0 * f64::from(turn)).direction();
            assert_eq!(d.x.abs() + d.y.abs(), 1.0);
            assert!(d.x == 0.0 && d.x.is_sign_positive() || d.y == 0.0 && d.y.is_sign_positive());
        }
        assert_eq!(
            Angle::from_degrees(60.0).direction(),
            Vec2::new(0.5, 0.75_f64.sqrt())
        );
        let eighth = Angle::from_degrees(-135.0).direction();
        assert_eq!(eighth, Vec2::new(-FRAC_1_SQRT_2, -FRAC_1_SQRT_2));
    }

    #[test]
    fn angles_of_the_quadrant_agree_with_the_standard_library() {
        assert_eq!(quadrant_degrees(0.0, 3.0), 0.0);
        assert_eq!(quadrant_degrees(2.0, 2.0), 45.0);
        assert_eq!(quadrant_degrees(1e-9, 0.0), 90.0);
        for i in 1..100_000 {
            let angle = f64::from(i) * (core::f64::consts::FRAC_PI_2 / 1e5);
            let (y, x) = (3.0 * angle.sin(), 3.0 * angle.cos());
            let expected = y.atan2(x).to_degrees();
            let off = (quadrant_degrees(y, x) / expected - 1.0).abs();
            assert!(off <= 4.5e-16, "{off:e} at {expected} degrees");
        }
    }

    #[test]
    fn parts_of_a_turn_mirror_to_the_last_digit() {
        for start in [0.0, 90.0, 180.0, -90.0] {
            let start = Angle::from_degrees(start);
            for parts in 1..60 {
                for part in 0..=parts {
                    let a = start.direction_in_turn(1.0, part, parts);
                    let b = start.direction_in_turn(1.0, parts - part, parts);
                    let c = start.direction_in_turn(-1.0, part, parts);
                    assert_eq!(b, c);
                    let axis = start.direction();
                    assert_eq!(a.dot(axis), b.dot(axis));
                    assert_eq!(a.cross(axis), -b.cross(axis));
                }
            }
        }
    }

    #[test]
    fn directions_agree_with_the_standard_library() {
        for i in -2000..2000 {
            let angle = Angle::from_degrees(f64::from(i) * 0.37);
            let d = angle.direction();
            assert!((d.x - angle.radians().cos()).abs() < 3e-15);
            assert!((d.y - angle.radians().sin()).abs() < 3e-15);
        }
    }
}
