//! One picture: a scene of strokes, fills and dots, whatever it shows.

mod deviation;
pub mod figure;
mod painter;
pub mod plot;
pub mod scene;
pub mod style;
