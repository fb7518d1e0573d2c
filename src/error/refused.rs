//! Who cannot do what was asked, and why a tolerance or a format is out of reach.

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
