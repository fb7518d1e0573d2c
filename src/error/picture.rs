//! Why a picture cannot be made.

use thiserror::Error;

/// Why the picture that was asked for cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// A text that is no colour.
    #[error(
        "'{0}' is not a colour: a colour is none, currentColor, a CSS name like tomato, or like #d50, #dd5500, rgb(221 85 0)"
    )]
    Color(String),
    /// A colour of CSS in a form that is not read.
    #[error(
        "'{color}' is not supported: {kind} cannot be drawn here, but rgb(), lab(), oklch() and color(srgb 1 0 0) can"
    )]
    UnsupportedColor {
        /// The text.
        color: String,
        /// What kind of colour it is.
        kind: &'static str,
    },
    /// An `id` of two shapes of one SVG file.
    #[error("the id '{id}' is that of line {line} already: ids in an SVG file are unique")]
    SameId {
        /// The id.
        id: String,
        /// The line that has it first.
        line: u64,
    },
    /// A text that is no size.
    #[error("'{0}' is not a width and a height, like 640x480 or 80x60mm")]
    Size(String),
    /// A size with a side that is not positive and finite.
    #[error("the sides of a picture are positive and finite, and '{0}' has one that is not")]
    Side(String),
    /// A negative width of the stroke or margin.
    #[error("the {what} is at least 0, but it is {value}")]
    Length {
        /// The name of the length.
        what: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// A text that names nothing to be shown beside a curve.
    #[error("'{0}' cannot be shown: what can is joints, handles, truth, error=K")]
    Shown(String),
    /// The deviation without how many times as large it is drawn.
    #[error(
        "error needs its factor, like error=500: the deviation is drawn this many times as large"
    )]
    NoFactor,
    /// A factor of the deviation that is no positive, finite number.
    #[error("the factor of error=K is a positive, finite number, not '{0}'")]
    Factor(String),
    /// The true shape is not known.
    #[error("there is no true shape to show: it is known of circles, ellipses and arcs")]
    NoTruth,
    /// More segments than what is shown beside a curve is shown of.
    #[error("what is shown beside a curve is shown of up to {most} segments, not of {count}")]
    TooManyShown {
        /// How many there are.
        count: usize,
        /// The largest number that is served.
        most: usize,
    },
    /// More segments than are painted.
    #[error(
        "a picture in pixels takes up to {most} segments, not {count}: svg, eps and pdf take any number"
    )]
    TooManySegments {
        /// How many there are.
        count: usize,
        /// The largest number that is served.
        most: usize,
    },
    /// A stroke too wide for the number of segments.
    #[error(
        "the stroke is too wide for a picture in pixels with {count} segments: fewer segments or a thinner stroke do, and svg, eps and pdf take any"
    )]
    StrokeTooWide {
        /// How many segments there are.
        count: usize,
    },
    /// More pixels than are painted.
    #[error(
        "a picture of {width}x{height} pixels is too large: the most is 100 million pixels, such as 10000x10000, and {longest} on a side"
    )]
    TooManyPixels {
        /// The width.
        width: f64,
        /// The height.
        height: f64,
        /// The longest side.
        longest: f64,
    },
    /// A page larger than PDF has, by the most points on a side.
    #[error("the page is too large: a side has at most {0} points, which are 200 inches")]
    LargePage(f64),
    /// A translucent colour in PostScript.
    #[error("PostScript has no translucent colours: an eps file takes opaque ones")]
    Translucent,
    /// The encoder of pixels failed.
    #[error("the picture cannot be encoded: {0}")]
    Encoder(String),
    /// A page to look at a shape that is exact.
    #[error(
        "there is nothing to look at: the shape is a straight line or nothing, and that is exact"
    )]
    Exact,
    /// A page without a method or without a count.
    #[error("no method and no count was named")]
    Nothing,
}
