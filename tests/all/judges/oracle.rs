//! An oracle for tests: what every method draws and how far it is off, in 256-bit arithmetic and
//! from the definitions alone. It shares no line and no formula of the error with the library.

#![allow(unreachable_pub)]

mod along;
pub mod bezier;
pub mod conic;
pub mod ellipse;
mod equioscillating;
pub mod methods;
pub mod real;
pub mod solve;
mod tangent;

pub use bezier::{
    arc_length, curvature_derivatives, mean_abs_radial_error_angle, mean_abs_radial_error_t,
    radial_extremes, rms_radial_error_t, sector_area,
};
pub use ellipse::ellipse_distance_extremes;
pub use methods::{IDS, Oracle, method};
pub use real::{Point, Real, decimal, int, parse, pi, radians, real, to_f64};
