//! SVG path data: read as curves, and written; transforms read.

mod read;
mod transform;
mod write;

pub use read::{contours, curves, shortened};
pub use transform::transform;
#[cfg(feature = "batch")]
pub(crate) use write::push_rounding;
pub use write::{data, data_of_courses, push_curve};
