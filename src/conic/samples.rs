//! A drawn parabola or hyperbola point by point.

use kurbo::{ParamCurve, PathSeg};

use super::{ConicDrawing, ConicFrame};
use crate::error::{Error, Result, UnmeasurableError};
use crate::measure::samples::{SamplePoint, sampled};
use crate::measure::{Quantity, profile};
use crate::radial_error::RadialError;

/// What rounding may leave of a place at the start.
const NOISE: f64 = 1e-14;

/// A point of a curve beside the true conic. Lengths are in user units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Sample"))]
pub struct ConicSample {
    /// The point.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub at: SamplePoint,
    /// Its distance from the conic along the normal, positive towards the control point.
    pub error: f64,
    /// Where along the conic it lies, from 0 at its start to 1 at its end, in equal steps of the conic's own parameter: a hyperbola's
    /// hyperbolic angle, an ellipse's angle.
    pub place: f64,
}

/// A drawn conic while it is sampled.
struct SampledConic<'a> {
    drawing: &'a ConicDrawing,
    frame: ConicFrame,
    /// 1 where the conic turns from +x towards +y, else -1.
    sense: f64,
}

impl<'a> SampledConic<'a> {
    fn new(drawing: &'a ConicDrawing) -> Self {
        let conic = &drawing.conic;
        let turn = (conic.control - conic.from).cross(conic.to - conic.control);
        Self {
            drawing,
            frame: ConicFrame::new(conic),
            sense: 1.0_f64.copysign(turn),
        }
    }

    fn error(&self, segment: &PathSeg, t: f64) -> f64 {
        if self.drawing.error == RadialError::default() {
            return 0.0;
        }
        self.frame.foot(segment.eval(t)).distance
    }

    fn place(&self, segment: &PathSeg, t: f64) -> f64 {
        let half = self.frame.half;
        let place = (self.frame.opposite(segment.eval(t)) + half) / (2.0 * half);
        if place.abs() < NOISE { 0.0 } else { place }
    }
}

impl ConicDrawing {
    /// `count` points of each segment at equal steps of t, both ends among them.
    ///
    /// # Errors
    ///
    /// Where `count` is below 2 or all points are more than a million.
    pub fn samples(&self, count: usize) -> Result<Vec<ConicSample>> {
        let bench = &SampledConic::new(self);
        sampled(&self.curve, count, |_, &segment| {
            move |at| ConicSample {
                error: bench.error(&segment, at.t),
                place: bench.place(&segment, at.t),
                at,
            }
        })
    }

    /// The quantity along each segment, as (place along the conic, value) at `steps` + 1 equal steps of t; curvature is positive
    /// where the curve bends as the conic does.
    ///
    /// # Errors
    ///
    /// For the angle lag, since there is no centre about which an angle could be.
    pub fn along(&self, quantity: Quantity, steps: u32) -> Result<Vec<Vec<(f64, f64)>>> {
        if quantity == Quantity::AngleLag {
            return Err(Error::Unmeasurable(UnmeasurableError::NoAngleLag));
        }
        if quantity == Quantity::Drawing {
            return Ok(profile::points(&self.curve, steps));
        }
        let bench = SampledConic::new(self);
        let of_segment = |segment: &PathSeg| {
            let value = |t: f64| match quantity {
                Quantity::Error => Some(bench.error(segment, t)),
                _ => profile::curvature(segment, quantity, t, 1.0).map(|k| k * bench.sense),
            };
            profile::profile(steps, |t| bench.place(segment, t), value)
        };
        Ok(self.curve.segments.iter().map(of_segment).collect())
    }
}
