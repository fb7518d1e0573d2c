//! Circles, ellipses and arcs as Bézier curves, with the error of what was drawn.

pub mod angle;
pub mod approximate;
pub mod curve;
pub mod error;
pub mod joints;
pub mod measure;
pub mod method;
pub mod power;
pub mod shape;
mod tridiagonal;
pub mod write;

pub use angle::Angle;
pub use approximate::{Drawing, Options, approximate};
pub use curve::Curve;
pub use error::{Error, Result};
pub use joints::{Cut, Tolerance};
pub use measure::RadialError;
pub use method::{Method, Rule};
pub use shape::{Arc, Circle, Ellipse, Shape};
