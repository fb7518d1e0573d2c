//! SVG path data: read as curves, and written; transforms, the path operators of PostScript and curves in equation space read.

mod postscript;
#[cfg(feature = "serde")]
mod power;
mod read;
mod refusal;
mod text;
mod transform;
mod write;

pub use postscript::postscript;
#[cfg(feature = "serde")]
pub use power::contours_of_power;
pub use read::{contours, curve, curves, shortened};
#[cfg(feature = "document")]
pub(crate) use refusal::place as place_of;
#[cfg(feature = "document")]
pub(crate) use text::PathText;
pub use transform::transform;
pub use write::{data, data_of_courses, push_curve};
#[cfg(feature = "batch")]
pub(crate) use write::{push_kept, push_rounded};
