//! The names of formats, and the extensions of files that tell them.

use core::fmt;

use crate::number::Precision;

/// An output format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Format {
    /// SVG path data, one line.
    #[default]
    Path,
    /// JSON.
    #[cfg(feature = "serde")]
    Json,
    /// PostScript path operators, one a line.
    Ps,
    /// TikZ commands.
    Tikz,
    /// Calls of the HTML canvas, one a line.
    Canvas,
    /// A glyph of the Unified Font Object.
    Glif,
    /// A DXF file of AutoCAD 2000.
    Dxf,
    /// G-code.
    Gcode,
    /// A picture, which has colours and widths.
    Image(Image),
}

/// The format of a picture: of a drawing as of a plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Image {
    /// An SVG document.
    Svg,
    /// An Encapsulated PostScript file.
    Eps,
    /// Pixels.
    #[cfg(feature = "png")]
    Png,
    /// A PDF file of one page.
    #[cfg(feature = "pdf")]
    Pdf,
}

impl Image {
    /// All of them.
    pub const ALL: &[Self] = &[
        Self::Svg,
        Self::Eps,
        #[cfg(feature = "png")]
        Self::Png,
        #[cfg(feature = "pdf")]
        Self::Pdf,
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Eps => "eps",
            #[cfg(feature = "png")]
            Self::Png => "png",
            #[cfg(feature = "pdf")]
            Self::Pdf => "pdf",
        }
    }

    /// The extensions of its files, in lower case.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Svg => &["svg"],
            Self::Eps => &["eps"],
            #[cfg(feature = "png")]
            Self::Png => &["png"],
            #[cfg(feature = "pdf")]
            Self::Pdf => &["pdf"],
        }
    }

    /// What it is, in a few words.
    #[cfg(feature = "cli")]
    const fn about(self) -> &'static str {
        match self {
            Self::Svg => "An SVG document",
            Self::Eps => "Encapsulated PostScript",
            #[cfg(feature = "png")]
            Self::Png => "Pixels",
            #[cfg(feature = "pdf")]
            Self::Pdf => "A PDF file of one page",
        }
    }
}

impl Format {
    /// All formats.
    pub const ALL: &[Self] = &[
        Self::Path,
        Self::Image(Image::Svg),
        Self::Ps,
        Self::Image(Image::Eps),
        #[cfg(feature = "serde")]
        Self::Json,
        #[cfg(feature = "png")]
        Self::Image(Image::Png),
        #[cfg(feature = "pdf")]
        Self::Image(Image::Pdf),
        Self::Tikz,
        Self::Canvas,
        Self::Glif,
        Self::Dxf,
        Self::Gcode,
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Path => "path",
            #[cfg(feature = "serde")]
            Self::Json => "json",
            Self::Ps => "ps",
            Self::Tikz => "tikz",
            Self::Canvas => "canvas",
            Self::Glif => "glif",
            Self::Dxf => "dxf",
            Self::Gcode => "gcode",
            Self::Image(image) => image.name(),
        }
    }

    /// The extensions of its files, in lower case.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Path => &["path", "txt"],
            #[cfg(feature = "serde")]
            Self::Json => &["json"],
            Self::Ps => &["ps"],
            Self::Tikz => &["tikz", "tex"],
            Self::Canvas => &["canvas", "js"],
            Self::Glif => &["glif"],
            Self::Dxf => &["dxf"],
            Self::Gcode => &["gcode", "nc", "ngc"],
            Self::Image(image) => image.extensions(),
        }
    }

    /// Whether +y is up: on a page and in CAD it is, on an SVG canvas it is down.
    #[must_use]
    pub const fn has_y_up(self) -> bool {
        match self {
            Self::Path | Self::Canvas | Self::Image(Image::Svg) => false,
            #[cfg(feature = "serde")]
            Self::Json => false,
            #[cfg(feature = "png")]
            Self::Image(Image::Png) => false,
            #[cfg(feature = "pdf")]
            Self::Image(Image::Pdf) => true,
            Self::Ps
            | Self::Tikz
            | Self::Glif
            | Self::Dxf
            | Self::Gcode
            | Self::Image(Image::Eps) => true,
        }
    }

    /// Whether closed shapes start at 180 degrees and run in the negative direction, as Lancaster's `drawellipse` does.
    #[must_use]
    pub const fn runs_as_drawellipse(self) -> bool {
        matches!(self, Self::Ps | Self::Image(Image::Eps))
    }

    /// Whether it has the path commands of SVG, which can be relative.
    #[must_use]
    pub const fn has_path_commands(self) -> bool {
        matches!(self, Self::Path | Self::Image(Image::Svg))
    }

    /// How control points are rounded where nothing was asked for; `None` for the precision that the error of the drawing needs.
    #[must_use]
    pub const fn precision(self) -> Option<Precision> {
        match self {
            #[cfg(feature = "serde")]
            Self::Json => Some(Precision::Full),
            // The grid of an em square.
            Self::Glif => Some(Precision::Fixed(0)),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(feature = "cli")]
mod cli {
    use clap::ValueEnum;
    use clap::builder::PossibleValue;

    use super::{Format, Image};

    impl ValueEnum for Format {
        fn value_variants<'a>() -> &'a [Self] {
            Self::ALL
        }

        fn to_possible_value(&self) -> Option<PossibleValue> {
            let about = match self {
                Self::Path => "SVG path data, one line",
                #[cfg(feature = "serde")]
                Self::Json => "The shape, the segments and the error; docs/schema describes it",
                Self::Ps => "PostScript path operators, one a line",
                Self::Tikz => "\\draw commands for a tikzpicture",
                Self::Canvas => "Calls of the HTML canvas, one a line",
                Self::Glif => {
                    "A UFO glyph (format 2), on the integer grid unless -p says otherwise"
                }
                Self::Dxf => {
                    "R2000: SPLINE with the very control points; lines, and circular arcs that nothing asks to approximate, as such"
                }
                Self::Gcode => "G0 G1 G2 G3: circles, circular arcs and lines themselves",
                Self::Image(image) => return image.to_possible_value(),
            };
            Some(PossibleValue::new(self.name()).help(about))
        }
    }

    impl ValueEnum for Image {
        fn value_variants<'a>() -> &'a [Self] {
            Self::ALL
        }

        fn to_possible_value(&self) -> Option<PossibleValue> {
            Some(PossibleValue::new(self.name()).help(self.about()))
        }
    }
}
