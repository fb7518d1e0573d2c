//! A path as a figure and as JSON.

#[cfg(feature = "serde")]
mod document;

use super::Writable;
use crate::contour::PathDrawing;
use crate::picture::figure::{self, Figure};
#[cfg(feature = "serde")]
pub use document::{ArcDocument, PathDocument, PathSegmentDocument, SubpathDocument};

impl Writable for PathDrawing {
    fn figure(&self) -> Figure {
        Figure::of_path(self)
    }

    fn summary(&self) -> String {
        figure::path_summary(self)
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> crate::Result<String> {
        super::json::to_string(&PathDocument::from(self))
    }
}
