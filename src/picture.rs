//! One picture: a scene of strokes, fills, dots and words, whatever it shows.
//!
//! A [`Figure`](figure::Figure) and a [`Chart`](plot::Chart) become a [`Scene`](scene::Scene); the formats know nothing else.

mod deviation;
pub mod figure;
pub mod paint;
mod painter;
mod palette;
pub mod plot;
pub mod scene;
pub mod size;
pub mod style;
pub mod text;
