//! Who cannot do what was asked, and why; why a tolerance or a format is out of reach.

use core::fmt;

use thiserror::Error;

/// By what segments would have been drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RuleName {
    /// A method of the catalogue, by its id.
    Method(&'static str),
    /// A literal handle.
    Handle,
}

impl fmt::Display for RuleName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Method(id) => id,
            Self::Handle => "a literal handle",
        })
    }
}

/// Why a method cannot do what was asked of it. Angles are in degrees.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MethodError {
    /// A segment longer than the method serves.
    #[error("a segment of {} is beyond its largest, {largest} degrees", Degrees(*degrees))]
    Largest {
        /// The angle of the segment.
        degrees: f64,
        /// The largest that is served.
        largest: f64,
    },
    /// A segment longer than the method serves on an ellipse that is so flat.
    #[error("a segment of {} is beyond its largest on this ellipse, {largest} degrees", Degrees(*degrees))]
    LargestOnEllipse {
        /// The angle of the segment.
        degrees: f64,
        /// The largest that is served.
        largest: f64,
    },
    /// A segment of this angle, which no single curve draws.
    #[error("a segment of {} is more than half a turn", Degrees(*.0))]
    HalfTurn(f64),
    /// A segment of this angle, by a number that is for quarters.
    #[error("its one number serves quarters only, not segments of {}", Degrees(*.0))]
    OnlyQuarters(f64),
    /// A segment that a printed table leaves out.
    #[error(
        "his table has no number for segments of {}, only for {} segments to the circle",
        Degrees(*degrees),
        counts.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
    )]
    Table {
        /// The angle of the segment.
        degrees: f64,
        /// The numbers of segments to the circle that it has.
        counts: Vec<usize>,
    },
    /// Uneven joints, by a method whose segments end off the circle.
    #[error("its segments end off the circle, and with uneven joints its segments do not meet")]
    UnevenOffCircle,
    /// An open arc, by a method whose segments end off the circle.
    #[error("its segments end off the circle, and the ends of an open arc would miss it")]
    OpenOffCircle,
    /// One or two points, through which a cyclic spline has no derivatives.
    #[error(
        "his cyclic system (11) through {} gives handles of length 0",
        if *.0 == 1 { "one point" } else { "two points" }
    )]
    CyclicPoints(usize),
    /// A segment of this angle, for which a search found no handles.
    #[error("its search ends without handles for {}", Degrees(*.0))]
    NoHandles(f64),
    /// An ellipse flatter than the method serves.
    #[error("it serves ellipses up to 1:50")]
    TooFlat,
    /// An ellipse that is not whole, or not cut into quarters on its axes.
    #[error("on an ellipse it serves whole ones in quarters from axis to axis")]
    OnlyQuartersOfEllipses,
    /// A conic that is no ellipse.
    #[error("it draws circles and ellipses, but this conic is a hyperbola or next to a parabola")]
    Conic,
    /// Segments that one handle for all does not describe.
    #[error("its segments are no cubics with the same handles along the tangents")]
    Handles,
    /// Procedures with one number for a method that has none.
    #[error(
        "the procedures have one magic number, for cubics that touch the circle at the quadrants"
    )]
    MagicNumber,
}

/// An angle in a message: two decimals tell enough.
struct Degrees(f64);

impl fmt::Display for Degrees {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} degrees", (self.0 * 100.0).round() / 100.0)
    }
}

/// Why no number of segments meets a tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReachError {
    /// Coordinates have no digits for it.
    #[error("it is finer than the digits of a double-precision coordinate")]
    Digits,
    /// Points are rounded to too few decimals.
    #[error("rounding to {0} decimals moves points farther than that")]
    Decimals(u8),
    /// Points are rounded too coarsely.
    #[error("rounding moves points farther than that")]
    Rounding,
    /// The error of the method stops falling before.
    #[error("its error does not fall that far")]
    Order,
    /// More segments than are served, or a tolerance finer than coordinates are.
    #[error("it takes more than {0} segments, or is finer than coordinates are")]
    Segments(usize),
}

/// Why a format cannot hold what was drawn.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum FormatError {
    /// Elliptical arcs in a format of circular ones.
    #[error("its arcs are those of circles")]
    EllipticalArcs,
    /// Arcs in a format of curves.
    #[error("it has no circular arcs here")]
    Arcs,
    /// Curves in a format of lines and arcs.
    #[error("it has straight lines and circular arcs only")]
    Curves,
    /// With the decimals that were asked for, lines and arcs stray too far.
    #[error("with so few decimals it strays farther than the tolerance")]
    Decimals,
    /// A number larger than the format takes.
    #[error("TeX takes no number beyond {most}, and there is {found:e}")]
    Number {
        /// The largest that it takes.
        most: f64,
        /// The one that is farthest from 0.
        found: f64,
    },
    /// A page with more bytes than are served.
    #[error("the page would have more than {} kB", most / 1000)]
    Bytes {
        /// The most that are served.
        most: usize,
    },
    /// Many shapes in one picture, of which JSON says nothing.
    #[error("a picture has none, one answer a line has")]
    Picture,
}
