//! An arc as SVG path data gives it, and its chord (SVG 2, appendix B.2, whose equation numbers are cited).

use kurbo::{Point, Vec2};

use super::{Arc, Given, Line, Shape, Truth, check_flatness, finite_point, positive_radii};
use crate::angle::{Angle, quadrant_degrees};
use crate::error::{Result, finite};
use crate::number::decimal_sum;
use crate::numeric::double::Double;
use crate::path_data::Segment;

/// An arc as SVG path data gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SvgArc {
    /// The current point.
    pub from: Point,
    /// The radii, of any sign; zero makes it a line.
    pub radii: Vec2,
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: Angle,
    /// Whether it takes the longer way.
    pub large_arc: bool,
    /// Whether it runs in the direction of growing angles.
    pub sweep: bool,
    /// The last point.
    pub to: Point,
}

impl SvgArc {
    /// The arc of a command of path data that begins at `from`; `None` where it is another command.
    pub(crate) fn of_segment(from: Point, segment: &Segment, data: &str) -> Option<Self> {
        let [rx, ry, rotation, large_arc, sweep, x, y] = segment.arc_values(data)?;
        let to = if segment.is_relative() {
            Point::new(decimal_sum(from.x, x), decimal_sum(from.y, y))
        } else {
            Point::new(x, y)
        };
        Some(Self {
            from,
            radii: Vec2::new(rx, ry),
            rotation: Angle::from_degrees(rotation),
            large_arc: large_arc != 0.0,
            sweep: sweep != 0.0,
            to,
        })
    }

    /// The arc in centre form, by the rules for parameters out of range: equal ends are nothing, a zero radius is a line,
    /// negative radii count as positive, radii too small are scaled up.
    ///
    /// # Errors
    ///
    /// Where a number is not finite or too large, or the ellipse too flat.
    pub fn shape(&self) -> Result<Shape> {
        let Some(chord) = self.chord()? else {
            let (from, to) = (self.from, self.to);
            return Ok(if from == to {
                Shape::Empty
            } else {
                Shape::Line(Line { from, to })
            });
        };
        let truth = chord.truth();
        let [start, _] = chord.directions();
        Ok(Shape::Arc(Arc {
            center: truth.center,
            radii: truth.radii,
            rotation: self.rotation,
            start: Angle::of(start),
            sweep: Angle::from_degrees(chord.sweep),
            ends: Some([self.from, self.to]),
            given: chord.given(self),
        }))
    }

    /// The arc as its chord sees it; `None` where it is a line or nothing.
    #[inline]
    pub(crate) fn chord(&self) -> Result<Option<Chord>> {
        self.check()?;
        if self.is_straight() {
            return Ok(None);
        }
        check_flatness(self.positive_radii())?;
        let near = self.near_chord();
        let half = Half::new(&near, self.rotation.direction()).with_all_digits(&near);
        let half = half.with_size_of_trace();
        if half.size == 0.0 {
            return Ok(None);
        }
        let chord = half.chord(&near);
        positive_radii(chord.radii)?;
        Ok(Some(chord))
    }

    /// The same arc: radii far too small for the chord, of which only the quotient counts, are multiplied by a power of two, so that nothing
    /// leaves the range of `f64`.
    #[inline]
    pub(crate) fn near_chord(&self) -> Self {
        let (chord, radius) = (
            self.chord_size(),
            self.radii.x.abs().max(self.radii.y.abs()),
        );
        if radius >= TOO_SMALL * chord {
            return *self;
        }
        let by = libm::ilogb(TOO_SMALL * chord) - libm::ilogb(radius);
        let radii = Vec2::new(
            libm::scalbn(self.radii.x, by),
            libm::scalbn(self.radii.y, by),
        );
        Self { radii, ..*self }
    }

    /// The larger difference of the coordinates of the ends.
    #[inline(always)]
    fn chord_size(&self) -> f64 {
        let chord = self.to - self.from;
        chord.x.abs().max(chord.y.abs())
    }

    /// Refuses numbers that are not finite, or too large.
    #[inline]
    pub(crate) fn check(&self) -> Result<()> {
        finite_point("start point", self.from)?;
        finite_point("end point", self.to)?;
        finite("radius", self.radii.x)?;
        finite("radius", self.radii.y)?;
        finite("rotation", self.rotation.degrees())?;
        Ok(())
    }

    #[inline(always)]
    fn positive_radii(&self) -> Vec2 {
        Vec2::new(self.radii.x.abs(), self.radii.y.abs())
    }

    /// Whether it is a line or nothing, to the last digit: with c the chord, r the smaller radius and R the larger one, the shorter arc
    /// leaves the chord by at most R (c/r)² / 8.
    #[inline]
    pub(crate) fn is_straight(&self) -> bool {
        let radii = self.positive_radii();
        let (short, long) = (radii.x.min(radii.y), radii.x.max(radii.y));
        let is_flat = || (self.chord_size() / short) * (long / short) <= FLAT;
        self.from == self.to || short == 0.0 || !self.large_arc && is_flat()
    }
}

/// The part of a chord below which radii are scaled before anything is computed from them.
const TOO_SMALL: f64 = 1e-9;

/// What an arc leaves its chord by at most where it is a line, in eighths of the chord: 2^-93, far below the last digit of its ends.
pub(super) const FLAT: f64 = 1e-28;

/// Half the chord of an arc in the frame where its ellipse is the unit circle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Half {
    pub(crate) axis: Vec2,
    /// From the middle of the chord to the start, and its size.
    pub(crate) along: Vec2,
    pub(crate) size: f64,
    /// How far the centre is from the chord; 0 where the radii are too small.
    pub(crate) depth: f64,
}

impl Half {
    /// Without a branch, as all that follows but [`Self::with_all_digits`].
    #[inline(always)]
    pub(crate) fn new(arc: &SvgArc, axis: Vec2) -> Self {
        // (5.1) in the frame of the ellipse's axes, (6.1) divided by the radii.
        let half = (arc.from - arc.to) / 2.0;
        let along = Vec2::new(
            whole_half((axis.x * half.x + axis.y * half.y) / arc.radii.x.abs()),
            whole_half((axis.x * half.y - axis.y * half.x) / arc.radii.y.abs()),
        );
        // Where the arc is all of the ellipse but a trace, squares of the trace would vanish.
        let size = (along * UP).hypot() / UP;
        // The chord of a quarter is as long as it is deep, to the last digit.
        let square = if along.hypot2() == 0.5 {
            0.5
        } else {
            (1.0 - size) * (1.0 + size)
        };
        Self {
            axis,
            along,
            size,
            depth: if square > 0.0 { square } else { 0.0 }.sqrt(),
        }
    }

    /// Near a semicircle, with the digits of the depth that cancelled.
    #[inline(always)]
    pub(crate) fn with_all_digits(self, arc: &SvgArc) -> Self {
        if self.lacks_digits() {
            Self {
                depth: depth_of(arc.from, arc.to, arc.rotation, arc.radii),
                ..self
            }
        } else {
            self
        }
    }

    /// With the size of a chord so small that even scaled squares vanish.
    fn with_size_of_trace(self) -> Self {
        if self.size > 0.0 {
            return self;
        }
        let size = (self.along * UP * UP).hypot() / UP / UP;
        Self { size, ..self }
    }

    #[inline(always)]
    pub(crate) fn lacks_digits(&self) -> bool {
        self.size > NEARLY_SEMICIRCLE && self.size < 2.0 - NEARLY_SEMICIRCLE
    }

    #[inline(always)]
    pub(crate) fn chord(&self, arc: &SvgArc) -> Chord {
        // (6.2), (6.3): radii too small are scaled up, and the centre is the middle of the chord.
        let (within, scale) = if self.depth == 0.0 {
            (1.0, self.size)
        } else {
            (self.size, 1.0)
        };
        // (5.5), (5.6): twice the angle whose sine is half the chord.
        let short = 2.0 * quadrant_degrees(within, self.depth);
        let size = if arc.large_arc { 360.0 - short } else { short };
        let side = if arc.large_arc == arc.sweep {
            -1.0
        } else {
            1.0
        };
        let (along, across) = (within / self.size, side * self.depth / self.size);
        Chord {
            middle: arc.from.midpoint(arc.to),
            radii: arc.positive_radii() * scale,
            axis: self.axis,
            along: self.along * along,
            across: Vec2::new(self.along.y, -self.along.x) * across,
            sweep: if arc.sweep { size } else { -size },
        }
    }
}

/// 1/2 in place of what rounding makes of it: the chord of a quarter between ends on the axes, which so is one to the last digit.
#[inline(always)]
fn whole_half(x: f64) -> f64 {
    if (x.abs() - 0.5).abs() <= 2.0 * f64::EPSILON {
        0.5_f64.copysign(x)
    } else {
        x
    }
}

/// 2^400, which takes part in no rounding.
const UP: f64 = f64::from_bits((1023 + 400) << 52);

/// The part of the diameter from which on 1 - size² loses digits; as much beyond a diameter it is negative for certain.
const NEARLY_SEMICIRCLE: f64 = 0.99;

/// The distance of the chord from the centre on the unit circle, with the digits that cancel near a semicircle; 0 where the radii
/// are too small.
fn depth_of(from: Point, to: Point, rotation: Angle, radii: Vec2) -> f64 {
    let [cos, sin] = rotation.exact_direction();
    let half = [(from.x, to.x), (from.y, to.y)].map(|(a, b)| Double::difference(a, b).scaled(0.5));
    let along = half[0].times(cos).plus(half[1].times(sin));
    let across = half[1].times(cos).plus(half[0].times(sin).scaled(-1.0));
    let (x, y) = (along.over(radii.x.abs()), across.over(radii.y.abs()));
    let square = x.times(x).plus(y.times(y));
    let rest = Double::difference(1.0, 0.0).plus(square.scaled(-1.0));
    rest.value().max(0.0).sqrt()
}

/// The square of half a chord on the unit circle from which on the arc is all of the ellipse, and its centre tells more.
const TRACE: f64 = 1e-200;

/// An elliptical arc by its chord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Chord {
    middle: Point,
    /// The radii, large enough.
    pub(crate) radii: Vec2,
    axis: Vec2,
    /// Half the chord on the unit circle, from its middle to the start.
    along: Vec2,
    /// From the chord's middle on the unit circle to the centre (5.2).
    across: Vec2,
    /// In degrees, with its sign.
    pub(crate) sweep: f64,
}

impl Chord {
    /// The ellipse.
    #[inline(always)]
    pub(crate) fn truth(&self) -> Truth {
        let middle = Truth::new(self.middle, self.radii, self.axis);
        let center = self.middle + middle.image(self.across);
        Truth::new(center, self.radii, self.axis)
    }

    /// The ellipse, given by this arc of it.
    pub(crate) fn truth_of(&self, arc: &SvgArc) -> Truth {
        let (ends, sweep) = ([arc.from, arc.to], Angle::from_degrees(self.sweep));
        let truth = self.truth().turned(arc.rotation);
        truth.through(ends, sweep, self.given(arc))
    }

    /// What gives an arc this chord.
    fn given(&self, arc: &SvgArc) -> Given {
        if self.across == Vec2::ZERO {
            Given::Enlarged(arc.near_chord().positive_radii())
        } else if self.along.hypot2() < TRACE {
            Given::Sweep
        } else {
            Given::Radii {
                large: arc.large_arc,
            }
        }
    }

    /// The ends on the unit circle.
    #[inline(always)]
    pub(crate) fn directions(&self) -> [Vec2; 2] {
        [self.along - self.across, -self.along - self.across]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joints::cutting::Cutting;

    #[test]
    fn a_chord_knows_the_angles_of_its_ends() {
        let arc = SvgArc {
            from: (2.0, 0.0).into(),
            radii: Vec2::new(2.0, 1.0),
            rotation: Angle::ZERO,
            large_arc: false,
            sweep: true,
            to: (0.0, 1.0).into(),
        };
        let chord = arc.chord().unwrap().unwrap();
        let angles = [0, 1].map(|joint| chord.angle(joint));
        assert!(angles[0].abs() < 1e-13 && (angles[1] - 90.0).abs() < 1e-13);
        assert_eq!((Cutting::count(&chord), chord.sign()), (1, 1.0));
        assert!((chord.size(0) - 90.0).abs() < 1e-13);
    }

    #[test]
    fn a_depth_lacks_digits_near_a_semicircle_only() {
        let half = Half {
            axis: Vec2::new(1.0, 0.0),
            along: Vec2::new(0.0, 1.0),
            size: 0.0,
            depth: 0.0,
        };
        for (size, lacks) in [
            (0.5, false),
            (0.98, false),
            (0.995, true),
            (1.0, true),
            (1.005, true),
            (1.02, false),
            (3.0, false),
        ] {
            assert_eq!(Half { size, ..half }.lacks_digits(), lacks, "{size}");
        }
    }
}
