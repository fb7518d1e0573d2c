//! Conics within a tolerance.

use kurbo::ParamCurve;

use super::branch::Branch;
use super::{Conic, ConicDrawing, error};
use crate::approximate::Options;
use crate::error::{Error, ReachError, Remedy, Result, RuleName};
use crate::method::Method;

/// How closely the end of a segment is found, by halves of what is left.
const HALVINGS: u32 = 30;

/// The most segments that a tolerance may ask for.
const MOST_SEGMENTS: usize = 10_000;

/// The parts of a tolerance for which joints are tried, the largest first: rounding takes its share.
const PARTS: [f64; 6] = [1.0, 0.97, 0.94, 0.91, 0.8, 0.5];

impl Conic {
    /// The fewest segments within a tolerance after rounding: each is as long as it can be.
    pub(super) fn within(
        &self,
        tolerance: f64,
        method: Method,
        branch: &Branch,
        options: &Options,
    ) -> Result<ConicDrawing> {
        for part in PARTS {
            let segments = self.pieces(
                &self.marched(part * tolerance, method, branch)?,
                Some(method),
            )?;
            let drawing = self.finish(segments, Some(method), branch, options)?;
            if drawing.error.peak() <= tolerance {
                return Ok(drawing);
            }
        }
        Err(Error::ToleranceOutOfReach {
            method: RuleName::Method(method.id()),
            tolerance,
            why: ReachError::Rounding,
            remedy: Remedy::MoreDecimalsOrTolerance,
        })
    }

    /// Joints each as far from the one before as the tolerance lets it be.
    fn marched(&self, tolerance: f64, method: Method, branch: &Branch) -> Result<Vec<f64>> {
        let frame = branch.frame(self);
        let end = frame.half;
        let reaches = |from: f64, to: f64| -> Result<bool> {
            let segment = self.piece(&frame, [from, to], Some(method))?;
            let (weight, reach) = frame.piece(to - from);
            let start = segment.start();
            let piece = Self {
                from: start,
                control: start + frame.derivative(from) * reach,
                to: segment.end(),
                weight,
            };
            let ends = [from, to];
            Ok(error::is_within(
                branch, &frame, &piece, ends, segment, tolerance,
            ))
        };
        let mut joints = vec![-end];
        let mut from = -end;
        while !reaches(from, end)? {
            let (mut low, mut high) = (from, end);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(low, high);
                if reaches(from, middle)? {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            if low <= from || joints.len() > MOST_SEGMENTS {
                return Err(Error::ToleranceOutOfReach {
                    method: RuleName::Method(method.id()),
                    tolerance,
                    why: ReachError::Segments(MOST_SEGMENTS),
                    remedy: Remedy::LargerTolerance("minimax"),
                });
            }
            from = low;
            joints.push(from);
        }
        joints.push(end);
        Ok(joints)
    }
}
