//! SVG path data: read as curves, and written.

mod read;
mod write;

pub use read::curves;
pub(crate) use read::shortened;
pub(crate) use write::push_rounding;
pub use write::{data, push_curve};
