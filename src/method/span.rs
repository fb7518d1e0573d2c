//! The angle of one piece with its sines and cosines, computed once.

use kurbo::Vec2;

use crate::angle::Angle;
use crate::error::{Result, finite};

/// The angle of one piece, positive, with the sines and cosines that the formulas ask for.
///
/// In the notation of the sources the angle is a, its half is h, and s = sin a, c = cos a.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    degrees: f64,
    /// The angle a in radians.
    pub a: f64,
    /// sin a.
    pub s: f64,
    /// cos a.
    pub c: f64,
    /// sin h.
    pub sh: f64,
    /// cos h.
    pub ch: f64,
}

/// The smallest angle for formulas, in degrees: its sixth power and the squares of its fourth are far from the end of `f64`.
const SMALLEST: f64 = 1e-30;

impl Span {
    /// The size of `angle`, whatever its sign.
    #[must_use]
    pub fn new(angle: Angle) -> Self {
        let degrees = angle.degrees().abs();
        let half = Angle::from_degrees(degrees / 2.0).direction();
        let full = Angle::from_degrees(degrees).direction();
        Self {
            degrees,
            a: degrees.to_radians(),
            s: full.y,
            c: full.x,
            sh: half.y,
            ch: half.x,
        }
    }

    /// Four times this many degrees, from 0 to 45 and in this direction, at less cost: all from their sine and cosine, right but for the
    /// last digit.
    #[inline(always)]
    pub(crate) fn of_quarter(degrees: f64, quarter: Vec2) -> Self {
        let half = Vec2::new(
            (quarter.x - quarter.y) * (quarter.x + quarter.y),
            2.0 * quarter.y * quarter.x,
        );
        let degrees = 4.0 * degrees;
        Self {
            degrees,
            a: degrees.to_radians(),
            s: 2.0 * half.y * half.x,
            c: (half.x - half.y) * (half.x + half.y),
            sh: half.y,
            ch: half.x,
        }
    }

    /// A span of this many degrees.
    #[must_use]
    pub fn from_degrees(degrees: f64) -> Self {
        Self::new(Angle::from_degrees(degrees))
    }

    /// The angle in degrees.
    #[must_use]
    pub const fn degrees(&self) -> f64 {
        self.degrees
    }

    /// Refuses an angle that is no finite number.
    pub(crate) fn check(&self) -> Result<()> {
        finite("angle of a segment", self.degrees).map(drop)
    }

    /// Itself and 1; where powers of the angle leave the range of `f64`, an angle where they do not, and what part of it this one is.
    /// At both a piece is straight but for what no digit shows, so that its handle goes with the angle and its error with a power of it.
    #[inline]
    pub(crate) fn in_range(&self) -> (Self, f64) {
        if self.degrees >= SMALLEST {
            (*self, 1.0)
        } else {
            (Self::from_degrees(SMALLEST), self.degrees / SMALLEST)
        }
    }

    /// 1 - cos a without cancellation.
    #[inline(always)]
    pub(crate) fn versine(&self) -> f64 {
        2.0 * self.sh * self.sh
    }

    /// 1 - cos h without cancellation.
    pub(crate) fn half_versine(&self) -> f64 {
        self.sh * self.sh / (1.0 + self.ch)
    }

    /// Whether the angle is beyond this one by more than the rounding of an angle that was computed.
    pub(crate) fn exceeds(&self, degrees: f64) -> bool {
        self.degrees > degrees + 1e-9
    }

    /// Whether the angle is this one, up to the rounding of an angle that was computed.
    pub(crate) fn is_about(&self, degrees: f64) -> bool {
        (self.degrees - degrees).abs() < 1e-9
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_of_a_quarter_is_the_whole_s() {
        for degrees in [0.001, 1.0, 11.25, 22.5, 30.0, 44.9, 45.0] {
            let span = Span::of_quarter(degrees, Angle::from_degrees(degrees).direction());
            let whole = Span::from_degrees(4.0 * degrees);
            assert_eq!((span.degrees, span.a), (whole.degrees, whole.a));
            for (number, right) in [
                (span.s, whole.s),
                (span.c, whole.c),
                (span.sh, whole.sh),
                (span.ch, whole.ch),
            ] {
                assert!(
                    (number - right).abs() < 5e-16,
                    "{degrees}: {number} {right}"
                );
            }
        }
    }
}
