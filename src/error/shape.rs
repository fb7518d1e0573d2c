//! Why what was given defines no shape, no joints, or nothing that can be drawn so.

use thiserror::Error;

use super::plain::{plain, short};

/// Why no shape is defined by what was given.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// Two of the three points that an arc runs through, or all, are the same.
    #[error("no arc is determined: {} points are the same", if *all { "three" } else { "two of the three" })]
    SamePoints {
        /// Whether all three are.
        all: bool,
    },
    /// The three points that an arc runs through lie on a line, the second not between the others.
    #[error(
        "no arc is determined: the three points lie on a line, and the second is not between the others"
    )]
    PointsOnLine,
    /// The ends of an arc that is given by its radius are the same.
    #[error(
        "no arc is determined: the ends are the same, and a radius does not say where the centre lies"
    )]
    SameEnds,
    /// The ends of an arc are farther apart than its diameter.
    #[error(
        "no circle of radius {radius} runs through both ends: they are {} apart, more than the diameter", short(*distance)
    )]
    SmallRadius {
        /// The radius that was given.
        radius: f64,
        /// How far apart the ends are.
        distance: f64,
    },
    /// The ends of an arc lie at different distances from its centre.
    #[error(
        "no circle about the centre runs through both ends: their distances from it are {} and {}", short(*first), short(*last)
    )]
    Centre {
        /// The distance of the first end.
        first: f64,
        /// The distance of the last end.
        last: f64,
    },
    /// The sweep of an arc in degrees, more than a turn.
    #[error("the sweep of an arc is at most one turn, 360 degrees, but it is {0} degrees")]
    Sweep(f64),
    /// An ellipse of these radii, of which one is too small beside the other.
    #[error("an ellipse with the radii {} and {} is too flat: one radius may be up to {most:e} of the other", radii[0], radii[1])]
    TooFlat {
        /// The radii.
        radii: [f64; 2],
        /// How many times one may be the other.
        most: f64,
    },
    /// A transform that leaves a line or a point of the plane.
    #[error("the transform flattens everything to a line or a point: nothing is left to draw")]
    Flattened,
    /// The weight of a conic.
    #[error("the weight of a conic is above 0 and at most {most:e}, not {}: below 1 an ellipse, 1 a parabola, above 1 a hyperbola", plain(*weight))]
    Weight {
        /// The weight that was given.
        weight: f64,
        /// The largest.
        most: f64,
    },
    /// The length of a literal handle.
    #[error("a handle is a length on the unit circle, at most {most:e}, not {handle:e}")]
    Handle {
        /// The length that was given.
        handle: f64,
        /// The largest.
        most: f64,
    },
    /// The three points of a conic lie on a line.
    #[error("the three points of a conic lie on a line: nothing is left of it but the line")]
    StraightConic,
    /// A rule that knows circles and ellipses only, for a hyperbola or a parabola.
    #[error(
        "a literal handle and a quadrature are for circles and ellipses, not for a hyperbola or a parabola"
    )]
    RuleOfEllipses,
    /// The latitude in degrees from which a sphere is seen.
    #[error("a latitude lies between -90 and 90 degrees, but that of the view is {0}")]
    Latitude(f64),
    /// So many lines on a sphere.
    #[error("a sphere takes up to {most} meridians and as many parallels, not {count}")]
    TooManyLines {
        /// The number that was given.
        count: usize,
        /// The largest that is served.
        most: usize,
    },
    /// The angle of a segment to compare methods by, in degrees.
    #[error("the angle of a segment is more than 0 and at most 360 degrees, not {0}")]
    Span(f64),
}

/// Why joints cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum JointsError {
    /// None were given for a closed shape.
    #[error("a closed shape needs at least one")]
    None,
    /// One lies outside the sweep of an arc; all in degrees.
    #[error("{} degrees is not inside the sweep from {} to {} degrees", short(*joint), short(*start), short(*end))]
    Outside {
        /// The joint.
        joint: f64,
        /// Where the arc starts.
        start: f64,
        /// Where it ends.
        end: f64,
    },
    /// Two lie at this angle in degrees.
    #[error("two of them lie at {0} degrees")]
    Twice(f64),
    /// Joints at the extremes, by a cut that has joints of its own.
    #[error("they lie at the extremes, and between these a count or a tolerance cuts")]
    Extremes,
    /// The conic has no centre, and so no angles.
    #[error("a hyperbola and a parabola have no angles; a count and a tolerance cut them")]
    NoAngles,
}
