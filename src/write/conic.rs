//! A conic as a figure and as JSON.

#[cfg(feature = "serde")]
mod document;

use super::Writable;
use crate::conic::ConicDrawing;
use crate::picture::figure::Figure;
use crate::picture::words::conic_summary;
#[cfg(feature = "serde")]
pub use document::{
    ConicDocument, ConicMeasurement, ConicSamples, ConicShapeDocument, conic_csv, conic_samples_csv,
};

impl Writable for ConicDrawing {
    fn figure(&self) -> Figure {
        Figure::of_conic(self)
    }

    fn summary(&self) -> String {
        conic_summary(self)
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> crate::Result<String> {
        super::json::to_string(&ConicDocument::from(self))
    }
}
