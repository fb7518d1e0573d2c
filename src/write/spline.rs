//! A spline as a figure and as JSON.

#[cfg(feature = "serde")]
mod document;

use kurbo::Affine;

use super::Writable;
use crate::curve::Curve;
use crate::picture::figure::Figure;
use crate::spline::Spline;
#[cfg(feature = "serde")]
pub use document::{SplineDocument, SplineSegmentDocument};

/// A spline that was drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineDrawing<'a> {
    /// The spline.
    pub spline: &'a Spline,
    /// Its curve, as [`Spline::curve`] gives it.
    pub curve: Curve,
    /// The map that was applied to the curve.
    pub transform: Affine,
}

impl Writable for SplineDrawing<'_> {
    fn figure(&self) -> Figure {
        Figure::of_spline(self.spline, self.curve.clone())
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> crate::Result<String> {
        super::json::to_string(&SplineDocument::new(self))
    }
}
