//! What is known of the pieces of an arc, however that is kept.

use kurbo::Vec2;

use crate::angle::Angle;
use crate::error::Result;
use crate::numeric::functions::angle_of;
use crate::shape::UnitArc;
use crate::shape::endpoint::Chord;

use super::check_count;

/// Pieces of the unit circle, each of which starts where the one before it ends. Joint 0 is the start of the first.
pub(crate) trait Cutting {
    /// The number of pieces; the last joint is that of this number.
    fn count(&self) -> usize;
    /// The angle of a joint in degrees.
    fn angle(&self, joint: usize) -> f64;
    /// The point of the unit circle at a joint; the last of a closed shape is the first.
    fn direction(&self, joint: usize) -> Vec2;
    /// The size of a piece in degrees.
    fn size(&self, piece: usize) -> f64;
    /// 1 where angles grow along the pieces, else -1.
    fn sign(&self) -> f64;
}

/// Pieces of equal size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EqualPieces {
    arc: UnitArc,
    count: usize,
}

impl EqualPieces {
    /// Refuses what [`check_count`] does.
    pub(crate) fn new(arc: UnitArc, count: usize) -> Result<Self> {
        check_count(count)?;
        Ok(Self { arc, count })
    }
}

impl Cutting for EqualPieces {
    fn count(&self) -> usize {
        self.count
    }

    /// Counted from the nearer end, so that both halves round alike.
    fn angle(&self, joint: usize) -> f64 {
        let (start, sweep) = (self.arc.start.degrees(), self.arc.sweep.degrees());
        if 2 * joint <= self.count {
            start + sweep * (joint as f64 / self.count as f64)
        } else {
            start + sweep - sweep * ((self.count - joint) as f64 / self.count as f64)
        }
    }

    fn direction(&self, joint: usize) -> Vec2 {
        if self.arc.sweep.degrees().abs() == 360.0 {
            let joint = if self.arc.closed && joint == self.count {
                0
            } else {
                joint
            };
            let start = self.arc.start;
            start.direction_in_turn(self.sign(), joint, self.count)
        } else {
            Angle::from_degrees(self.angle(joint)).direction()
        }
    }

    fn size(&self, _: usize) -> f64 {
        (self.arc.sweep.degrees() / self.count as f64).abs()
    }

    fn sign(&self) -> f64 {
        1.0_f64.copysign(self.arc.sweep.degrees())
    }
}

/// One piece, whose ends are known without an angle.
impl Cutting for Chord {
    fn count(&self) -> usize {
        1
    }

    fn angle(&self, joint: usize) -> f64 {
        angle_of(self.direction(joint)).to_degrees()
    }

    fn direction(&self, joint: usize) -> Vec2 {
        self.directions()[joint]
    }

    fn size(&self, _: usize) -> f64 {
        self.sweep.abs()
    }

    fn sign(&self) -> f64 {
        1.0_f64.copysign(self.sweep)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::angle::Angle;
    use crate::shape::endpoint::parse_svg_arc;

    #[test]
    fn equal_joints_keep_their_digits_beside_either_end() {
        for count in [7, 998, 999] {
            let arc = UnitArc {
                start: Angle::ZERO,
                sweep: Angle::from_degrees(360.0),
                closed: true,
            };
            let equal = EqualPieces::new(arc, count).unwrap();
            let first = 360.0 / count as f64;
            assert!((equal.angle(1) / first - 1.0).abs() < 4e-16);
            for joint in 0..=count / 2 {
                assert_eq!(equal.angle(count - joint), 360.0 - equal.angle(joint));
            }
        }
    }

    #[test]
    fn a_chord_runs_the_way_of_its_flag() {
        for (flag, sign) in [(0, -1.0), (1, 1.0)] {
            let arc = parse_svg_arc(&format!("M0 0A5 3 0 0 {flag} 3 4")).unwrap();
            assert_eq!(arc.chord().unwrap().unwrap().sign(), sign);
        }
    }

    #[test]
    fn an_arc_of_numbers_that_are_not_finite_has_no_chord() {
        let arc = parse_svg_arc("M0 0A5 3 0 0 1 3 4").unwrap();
        for wrong in [f64::NAN, f64::INFINITY] {
            let mut radius = arc;
            radius.radii.y = wrong;
            let mut end = arc;
            end.to.x = wrong;
            assert!(radius.check().is_err() && end.check().is_err());
        }
        assert!(arc.check().is_ok());
    }
}
