//! What is measured of a drawn conic beside its error.

use super::{ConicDrawing, ConicFrame};
use crate::continuity::Continuity;
use crate::curve::largest_coordinate;
use crate::measure::continuity::{Joint, joint};
use crate::measure::extent;
use crate::measure::report::Extent;
use crate::numeric::adaptive_integral;

/// The length and the joints of a drawn conic.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Report {
    /// How many segments it has.
    pub segments: usize,
    /// Its arc length, beside the true one.
    pub length: Extent,
    /// The largest curvature of the true conic.
    pub true_largest_curvature: f64,
    /// The lowest order of all joints, as `measure` states it; `null` where there are none.
    pub continuity: Option<Continuity>,
    /// The largest turn of the tangent at a joint, in degrees.
    pub largest_turn: f64,
}

impl ConicDrawing {
    /// Measures its length and its joints.
    #[must_use]
    pub fn report(&self) -> Report {
        let frame = ConicFrame::new(&self.conic);
        let segments = &self.curve.segments;
        let speed = |x: f64| frame.derivative(x).hypot();
        let largest = largest_coordinate(segments);
        let joints: Vec<Joint> = segments
            .windows(2)
            .map(|pair| joint(&pair[0], &pair[1], 4.0 * f64::EPSILON * largest))
            .collect();
        let turns = joints.iter().map(|joint| joint.turn.abs());
        Report {
            segments: segments.len(),
            length: Extent::new(
                segments.iter().map(extent::length).sum(),
                adaptive_integral(&speed, -frame.half, 0.0, 0.0)
                    + adaptive_integral(&speed, 0.0, frame.half, 0.0),
            ),
            true_largest_curvature: frame.largest_curvature(),
            continuity: joints.iter().map(|joint| joint.continuity).min(),
            largest_turn: turns.fold(0.0, f64::max),
        }
    }
}
