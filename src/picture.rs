//! One picture: a scene of strokes, fills, dots and words, whatever it shows.
//!
//! A [`Figure`](figure::Figure) and a chart of `plot` become a [`Scene`](scene::Scene); the formats know nothing else.

mod color_space;
mod deviation;
pub mod figure;
pub mod paint;
mod painter;
mod palette;
#[cfg(feature = "plot")]
pub mod plot;
pub mod scene;
pub mod size;
pub mod style;
#[cfg(feature = "plot")]
pub mod text;
pub mod words;
