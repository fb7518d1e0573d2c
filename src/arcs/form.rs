//! What stands in place of a stretch of cubics, before it is rounded.

use kurbo::{CubicBez, Point, Vec2};

use super::bound::from_arc;
use super::from_chord::from_chord;
use super::oval::Oval;
use crate::shape::Shape;
use crate::shape::endpoint::SvgArc;

/// What stands in place of cubics.
#[derive(Debug, Clone, Copy)]
pub(super) enum Replacement {
    Line,
    /// An arc of a circle by half its sweep, in radians, positive to the left.
    Circular(f64),
    /// An arc of an ellipse.
    Elliptical(Oval),
}

/// A line or an arc, and the cubics that it replaces.
#[derive(Debug, Clone)]
pub(super) struct Fitted {
    pub(super) parts: Vec<CubicBez>,
    pub(super) form: Replacement,
    /// Whether it ends where a cubic does.
    pub(super) ends_given: bool,
}

/// The arc between two points that turns as much on either side of its middle.
fn arc_of(from: Point, to: Point, half: f64) -> SvgArc {
    SvgArc {
        from,
        radii: Vec2::splat(0.5 * from.distance(to) / libm::sin(half.abs())),
        rotation: crate::Angle::ZERO,
        large_arc: half.abs() > core::f64::consts::FRAC_PI_2,
        sweep: half < 0.0,
        to,
    }
}

impl Fitted {
    /// The arc between these ends, radii and rotation as they are before rounding; `None` of a line.
    pub(super) fn arc(&self, from: Point, to: Point) -> Option<SvgArc> {
        match self.form {
            Replacement::Line => None,
            Replacement::Circular(half) => Some(arc_of(from, to, half)),
            Replacement::Elliptical(oval) => oval.arc(from, to),
        }
    }

    /// A bound, both ways, of its distance from the cubics.
    pub(super) fn bound(&self) -> f64 {
        let ends = self.parts.first().zip(self.parts.last());
        let Some(arc) = ends.and_then(|(first, last)| self.arc(first.p0, last.p3)) else {
            return from_chord(&self.parts);
        };
        match arc.shape() {
            Ok(Shape::Arc(arc)) => from_arc(&self.parts, &arc),
            _ => f64::INFINITY,
        }
    }
}
