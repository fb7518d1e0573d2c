//! The library's errors: each says what was asked and why it cannot be, and many what can in its place, a [`Remedy`].

mod picture;
mod plain;
mod refused;
mod remedy;
mod shape;
mod text;
mod unmeasurable;

// The program of this package asks it too.
#[cfg(feature = "serde")]
#[doc(hidden)]
pub mod json;

use core::fmt::Display;

use thiserror::Error;

use plain::{plain, short, told};

pub use picture::PictureError;
pub use refused::{FormatError, MethodError, ReachError, RuleName};
pub use remedy::Remedy;
pub use shape::{JointsError, ShapeError};
pub use text::TextError;
pub use unmeasurable::UnmeasurableError;

/// A specialised result.
pub type Result<T, E = Error> = core::result::Result<T, E>;

/// Why a request cannot be met.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A length that has to be positive and finite is not.
    #[error("the {what} must be a positive, finite number, but it is {}", told(*value))]
    NotPositive {
        /// The name of the length.
        what: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// A number that has to be finite is not.
    #[error("the {what} must be a finite number, but it is {}", told(*value))]
    NotFinite {
        /// The name of the number.
        what: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// The coordinates leave the range in which `f64` geometry stays finite.
    #[error("the {what} {:e} is too large: coordinates must stay below 1e150", short(*value))]
    TooLarge {
        /// The name of the number.
        what: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// A length so small that its square vanishes in `f64`.
    #[error("the {what} {value:e} is too small: lengths must be at least 1e-100")]
    TooSmall {
        /// The name of the length.
        what: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// No method of that name.
    #[error("unknown method '{name}'")]
    UnknownMethod {
        /// The name that was asked for.
        name: String,
        /// The nearest ids of the catalogue, best first.
        nearest: Vec<&'static str>,
    },
    /// The method cannot do what was asked of it.
    #[error("{method} cannot do this: {why}")]
    Impossible {
        /// The method, or the literal handle.
        method: RuleName,
        /// The reason.
        why: MethodError,
        /// What can be done instead.
        remedy: Remedy,
    },
    /// No number of segments meets the tolerance.
    #[error("no number of segments brings {method} within {} of the true shape: {why}", plain(*tolerance))]
    ToleranceOutOfReach {
        /// The method, or the literal handle.
        method: RuleName,
        /// The tolerance in user units.
        tolerance: f64,
        /// The reason.
        why: ReachError,
        /// What can be done instead.
        remedy: Remedy,
    },
    /// Rounding takes what was drawn farther from what was given than was asked for.
    #[error("so few decimals take it {} away, farther than the tolerance {}", plain(*distance), plain(*tolerance))]
    Rounding {
        /// How far it would be, in user units.
        distance: f64,
        /// The tolerance in user units.
        tolerance: f64,
    },
    /// Rounding alone moves points as far as the tolerance.
    #[error(
        "rounding alone moves a point by up to {}, which is no less than the tolerance {}: give more decimals or a larger tolerance",
        plain(*rounding),
        plain(*tolerance)
    )]
    RoundingAlone {
        /// How far it moves a point at most.
        rounding: f64,
        /// The tolerance in user units.
        tolerance: f64,
    },
    /// A tolerance below the noise of double precision.
    #[error("the tolerance {} is finer than the digits of a double-precision coordinate", plain(*tolerance))]
    TooFine {
        /// The tolerance in user units.
        tolerance: f64,
        /// One that serves at this size, in user units.
        finest: f64,
    },
    /// With the decimals that were asked for, the arcs of a path stray too far.
    #[error(
        "with so few decimals the result strays farther than the tolerance {}: give more decimals or a larger tolerance",
        plain(*tolerance)
    )]
    TooCoarse {
        /// The tolerance in user units.
        tolerance: f64,
    },
    /// A path that becomes more lines or arcs than are served.
    #[error("within {} the path becomes more than {most} segments", plain(*tolerance))]
    TooManySegments {
        /// The tolerance in user units.
        tolerance: f64,
        /// The most that are served.
        most: usize,
        /// A tolerance with which it becomes fewer, about.
        enough: f64,
    },
    /// A segment of a path that cannot be drawn as it is placed.
    #[error("segment {segment} of subpath {subpath}: {why}")]
    Segment {
        /// The number of the subpath, from 1.
        subpath: usize,
        /// The number of the segment in it, from 1.
        segment: usize,
        /// The reason.
        why: Box<Self>,
    },
    /// A text that does not parse.
    #[error("cannot read {what} '{text}': {why}, at column {column}")]
    Syntax {
        /// What the text should have been.
        what: &'static str,
        /// The text.
        text: String,
        /// Counted in characters, from 1.
        column: usize,
        /// What is wrong there.
        why: String,
    },
    /// Rounding leaves nothing of a closed shape.
    #[error("rounded to {decimals} decimals, the shape is no more than a point or a line")]
    Collapsed {
        /// The decimals that were asked for.
        decimals: u8,
    },
    /// A number of segments that nothing is cut into.
    #[error("the number of segments must be from 1 to {most}, but it is {count}")]
    Count {
        /// The number that was given.
        count: usize,
        /// The largest that is served.
        most: usize,
    },
    /// The joints that were asked for cannot be used.
    #[error("the joints cannot be used: {0}")]
    Joints(JointsError),
    /// A curve through fewer points than it takes.
    #[error(
        "a curve with {} ends runs through at least {least} points, but there {} {count}",
        if *cyclic { "cyclic" } else { "free or fixed" },
        if *count == 1 { "is" } else { "are" }
    )]
    TooFewPoints {
        /// The number of points that were given.
        count: usize,
        /// The fewest that are served.
        least: usize,
        /// Whether the ends are cyclic.
        cyclic: bool,
    },
    /// Two points that a curve runs through one after the other are the same.
    #[error("point {} is the same as point {}", second + 1, first + 1)]
    RepeatedPoint {
        /// The index of the one before, from 0.
        first: usize,
        /// The index of the one after, from 0: the first point of all where a closed curve's last one repeats it.
        second: usize,
    },
    /// The arc lengths of a spline do not settle.
    #[error("the arc lengths did not settle in {rounds} rounds")]
    Unsettled {
        /// How many rounds were tried.
        rounds: usize,
    },
    /// No shape is defined by what was given.
    #[error("{0}")]
    Shape(ShapeError),
    /// Path data, a transform, a document or a PostScript drawing that cannot be read.
    #[error("{0}")]
    Text(TextError),
    /// There is nothing of that kind to measure in what was given.
    #[error("{0}")]
    Unmeasurable(UnmeasurableError),
    /// The picture that was asked for cannot be made.
    #[error("{0}")]
    Picture(PictureError),
    /// A format cannot hold what was drawn.
    #[error("{format} cannot hold this: {why}")]
    Format {
        /// The name of the format.
        format: &'static str,
        /// The reason.
        why: FormatError,
        /// What can be done instead.
        remedy: Remedy,
    },
    /// What was to be written cannot be JSON.
    #[error("this cannot be written as JSON: {0}")]
    Json(String),
}

/// The one of some values that is displayed by this name; `what` they are called, one and all.
pub(crate) fn one_of<T: Copy + Display>(
    all: &[T],
    name: &str,
    what: [&'static str; 2],
) -> Result<T> {
    let found = all.iter().find(|value| value.to_string() == name);
    found.copied().ok_or_else(|| {
        let names: Vec<String> = all.iter().map(T::to_string).collect();
        Error::Syntax {
            what: what[0],
            text: name.to_owned(),
            column: 1,
            why: format!("{} are {}", what[1], names.join(", ")),
        }
    })
}

/// `value` if it is positive and finite, and neither it nor its square leaves the range of `f64`.
#[inline]
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64> {
    if (SMALLEST..LARGEST).contains(&value) {
        Ok(value)
    } else {
        Err(not_positive(what, value))
    }
}

/// `value` if it is finite and small enough that its square is finite.
#[inline]
pub(crate) fn finite(what: &'static str, value: f64) -> Result<f64> {
    if value.abs() < LARGEST {
        Ok(value)
    } else {
        Err(not_finite(what, value))
    }
}

/// The largest coordinate that the geometry takes: squares and cubes of ratios stay finite below it.
const LARGEST: f64 = 1e150;

/// The smallest length that the geometry takes, for the same reason.
const SMALLEST: f64 = 1e-100;

#[cold]
fn not_positive(what: &'static str, value: f64) -> Error {
    if !value.is_finite() || value <= 0.0 {
        Error::NotPositive { what, value }
    } else if value < SMALLEST {
        Error::TooSmall { what, value }
    } else {
        Error::TooLarge { what, value }
    }
}

#[cold]
fn not_finite(what: &'static str, value: f64) -> Error {
    if value.is_finite() {
        Error::TooLarge { what, value }
    } else {
        Error::NotFinite { what, value }
    }
}
