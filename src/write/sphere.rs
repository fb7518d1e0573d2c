//! A sphere as a figure and as JSON.

#[cfg(feature = "serde")]
mod document;

use super::Writable;
use crate::picture::figure::{Figure, Hidden};
use crate::sphere::SphereView;
#[cfg(feature = "serde")]
pub use document::{PartDocument, SphereDocument, SphereShapeDocument, ViewDocument};

/// A sphere that was drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SphereDrawing {
    /// The sphere as it is seen.
    pub picture: SphereView,
    /// What becomes of its hidden halves.
    pub hidden: Hidden,
}

impl Writable for SphereDrawing {
    fn figure(&self) -> Figure {
        Figure::of_sphere(&self.picture, self.hidden)
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> crate::Result<String> {
        super::json::to_string(&SphereDocument::new(&self.picture, self.hidden))
    }
}
