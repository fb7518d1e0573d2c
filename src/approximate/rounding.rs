//! What the precision that was asked for does to a whole shape: it may leave nothing of it, and move the ends of an arc.

use kurbo::Point;

use super::{Request, Sketch};
use crate::angle::Angle;
use crate::curve::{Curve, largest_move};
use crate::error::Result;
use crate::number::Precision;
use crate::numeric::functions::power;
use crate::radial_error::{RadialError, within};

impl Request<'_> {
    /// Refuses a precision that leaves nothing of a shape: no extent of a closed one, a point of an arc.
    pub(super) fn check_extent(&self, sketch: &Sketch) -> Result<()> {
        let radii = self.outline.truth.radii;
        let precision = self.options.precision;
        let Some(Precision::Fixed(decimals)) = precision else {
            return Ok(());
        };
        let unit = power(10.0, i32::from(decimals));
        let (closed, sweep) = (self.outline.unit.closed, self.outline.unit.sweep.degrees());
        let is_small = if closed {
            radii.x.min(radii.y) * unit < 1.0
        } else {
            radii.x.max(radii.y) * sweep.abs().to_radians() * unit < 2.0
        };
        if !is_small {
            return Ok(());
        }
        sketch.curve.check_left(&sketch.rounded(), precision)
    }

    /// Refuses a precision that moves an end of an arc farther than the tolerance, whatever the number of segments.
    pub(super) fn check_ends(&self, tolerance: f64) -> Result<()> {
        within(self.ends_moved(), tolerance)
    }

    /// How far the precision that was asked for moves the ends of an arc.
    pub(super) fn ends_moved(&self) -> f64 {
        let unit = &self.outline.unit;
        let Some(precision) = self.options.precision.filter(|_| !unit.closed) else {
            return 0.0;
        };
        if self.keeps_ends && self.outline.ends.is_some() {
            return 0.0;
        }
        let end = Angle::from_degrees(unit.start.degrees() + unit.sweep.degrees());
        let on_circle = |angle: Angle| self.outline.placement * angle.direction().to_point();
        let ends = self
            .outline
            .ends
            .unwrap_or_else(|| [unit.start, end].map(on_circle));
        let moved = |p: Point| p.distance(precision.round_point(p));
        ends.map(moved).into_iter().fold(0.0, f64::max)
    }
}

/// The error of a straight line that rounding moves, which is exact without; refuses one that it moves farther than a tolerance.
pub(super) fn of_line(
    exact: &Curve,
    rounded: &Curve,
    tolerance: Option<f64>,
) -> Result<RadialError> {
    let moved = largest_move(exact, rounded);
    within(moved, tolerance.unwrap_or(f64::INFINITY))?;
    Ok(RadialError::balanced(moved))
}
