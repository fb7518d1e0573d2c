//! Circles, ellipses and arcs as Bézier curves, with the error of what was drawn.
//!
//! ```
//! use curveto::{Circle, Method, Options, Rule, Shape, approximate};
//! use curveto::path;
//!
//! let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
//! let drawing = approximate(&circle, &Options { rule: Rule::Method(Method::Minimax), ..Options::default() })?;
//! assert!(path::data([&drawing.curve], false).starts_with("M50 0C50 27.596 27.596 50 0 50C"));
//! println!("within {} of the true circle", drawing.error.peak());
//! # Ok::<(), curveto::Error>(())
//! ```
//!
//! The data go one way: a [`Shape`] is a piece of the unit circle and an affine placement; [`joints`] cut the piece; a [`Method`]
//! turns each cut into control points; [`approximate()`] places them as a [`Curve`] and measures it; [`write`](mod@write) knows the
//! formats. [`measure`] reads finished curves only, so that it judges any method and any rounding.
//!
//! Lengths are in user units, angles are [`Angle`]s; positive ones turn from +x towards +y.

// A room does not know the features of the rooms above it, for which it may hold what nobody else calls.
#![cfg_attr(
    not(all(feature = "batch", feature = "document", feature = "plot")),
    allow(dead_code)
)]
// The tests ask the platform's functions, as judges.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod angle;
pub mod approximate;
pub mod arcs;
#[cfg(feature = "batch")]
pub mod batch;
pub mod compare;
pub mod conic;
pub mod continuity;
pub mod contour;
pub mod course;
pub mod curve;
pub mod diff;
#[cfg(feature = "document")]
pub mod document;
pub mod engine;
pub mod error;
pub mod joints;
pub mod measure;
pub mod method;
pub mod number;
mod numeric;
#[cfg(feature = "serde")]
pub mod page;
pub mod path;
mod path_data;
pub mod picture;
mod place;
pub mod power;
pub mod radial_error;
pub mod shape;
pub mod sphere;
pub mod spline;
pub mod write;

pub use kurbo;

pub use angle::Angle;
pub use approximate::{Drawing, Options, approximate};
pub use curve::Curve;
pub use error::{Error, Result};
pub use joints::{Cut, Tolerance};
pub use method::{Method, Rule};
pub use radial_error::RadialError;
pub use shape::{Arc, Circle, Ellipse, Shape};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
