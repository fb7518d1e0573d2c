//! A path as a figure and as JSON.

#[cfg(feature = "serde")]
mod document;

use super::Writable;
use crate::contour::PathDrawing;
use crate::picture::figure::Figure;
use crate::picture::words;
#[cfg(feature = "serde")]
pub use document::{ArcDocument, PathDocument, PathSegmentDocument, SubpathDocument};

impl Writable for PathDrawing {
    fn figure(&self) -> Figure {
        Figure::of_path(self)
    }

    fn summary(&self) -> String {
        words::path_summary(self)
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> crate::Result<String> {
        super::json::to_string(&PathDocument::from(self))
    }
}
