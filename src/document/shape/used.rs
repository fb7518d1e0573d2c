//! A shape by the lengths with which it is drawn.

use crate::document::shape::length::Length;
use crate::joints::Cut;
use crate::number::decimals_for;

/// A shape with its used values: `auto` resolved, radii clamped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::document) enum UsedShape {
    /// Centre and radii.
    Ellipse([Length; 2], [Length; 2]),
    /// Left top corner, size, corner radii.
    Rect([Length; 2], [Length; 2], [Length; 2]),
    /// A rectangle with square corners: nothing to do.
    Square,
}

impl UsedShape {
    /// With the digits of computed lengths that a tolerance asks for: they move a point by a fiftieth of it at most, as far as doubles have them.
    pub(in crate::document) fn fine_enough(self, cut: &Cut) -> Self {
        let Cut::Tolerance(tolerance) = cut else {
            return self;
        };
        let finer = |radii: [Length; 2]| {
            let larger = radii[0].value.max(radii[1].value);
            let decimals = decimals_for(tolerance.for_radius(larger), 2);
            move |lengths: [Length; 2]| lengths.map(|length| length.with_decimals(decimals))
        };
        match self {
            Self::Ellipse(center, radii) => {
                let finer = finer(radii);
                Self::Ellipse(finer(center), finer(radii))
            }
            Self::Rect(corner, size, radii) => {
                let finer = finer(radii);
                Self::Rect(finer(corner), finer(size), finer(radii))
            }
            Self::Square => self,
        }
    }
}
