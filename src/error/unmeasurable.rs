//! Why there is nothing to measure.

use thiserror::Error;

/// Why there is nothing of that kind to measure in what was given.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum UnmeasurableError {
    /// A path without segments.
    #[error("there is nothing to measure: the path is empty")]
    Empty,
    /// A true shape that is smaller than what the coordinates can tell.
    #[error(
        "a true shape of radius {radius:e} is lost in the rounding of coordinates of {coordinate:e}"
    )]
    Lost {
        /// The smaller radius.
        radius: f64,
        /// The largest coordinate.
        coordinate: f64,
    },
    /// An elliptical arc among the segments.
    #[error(
        "segment {segment} of the path is an elliptical arc (A): that one is exact and no Bézier, so that there is no error to measure"
    )]
    Arc {
        /// Which one, from 1.
        segment: usize,
    },
    /// A number of samples that is not served.
    #[error(
        "the samples of a segment number from 2, its ends, to {most}, but {count} were asked for"
    )]
    Samples {
        /// How many were asked for.
        count: usize,
        /// The largest number that is served.
        most: usize,
    },
    /// Points that no circle fits.
    #[error("no circle fits: the points lie on a line, or are one point")]
    NoCircle,
    /// Points that no ellipse fits.
    #[error(
        "no ellipse fits: fewer than five points determine none, nor do points of another curve"
    )]
    NoEllipse,
    /// The angle lag of a conic that has no centre.
    #[error("a parabola and a hyperbola have no angle about a centre, and so no angle-lag")]
    NoAngleLag,
    /// Two drawings whose distance would take too long to find.
    #[error(
        "the curves of the two drawings lie close together in so many places that their distance would take too long to find"
    )]
    Entangled,
}
