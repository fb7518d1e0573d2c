//! SVG path data: read as curves, and written; transforms and the path operators of PostScript read.

mod postscript;
mod read;
mod transform;
mod write;

pub use postscript::postscript;
pub use read::{contours, curve, curves, shortened};
pub use transform::transform;
#[cfg(feature = "batch")]
pub(crate) use write::push_rounding;
pub use write::{data, data_of_courses, push_curve};
