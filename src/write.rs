//! The writers: the only place that knows a format.
//!
//! A writer sees a [`Figure`] or a [`Scene`](crate::picture::scene::Scene), whose points are already rounded, and knows no method.

pub mod catalogue;
pub mod comparison;
pub mod json;
pub mod measurement;
pub mod png;
pub mod postscript;
pub mod sphere;
pub mod spline;
pub mod svg;

use core::fmt;
use core::str::FromStr;

use crate::error::{Error, Result};
use crate::path;
use crate::picture::figure::Figure;
use crate::picture::style::Style;

/// An output format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Format {
    /// SVG path data, one line.
    #[default]
    Path,
    /// An SVG document.
    Svg,
    /// PostScript path operators, one a line.
    Ps,
    /// An Encapsulated PostScript file.
    Eps,
    /// JSON.
    Json,
    /// A raster preview.
    Png,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 6] = [
        Self::Path,
        Self::Svg,
        Self::Ps,
        Self::Eps,
        Self::Json,
        Self::Png,
    ];

    /// The name, which is also the file extension.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Path => "path",
            Self::Svg => "svg",
            Self::Ps => "ps",
            Self::Eps => "eps",
            Self::Json => "json",
            Self::Png => "png",
        }
    }

    /// Whether it is a picture, which has colours and widths, rather than data.
    #[must_use]
    pub const fn is_picture(self) -> bool {
        matches!(self, Self::Svg | Self::Eps | Self::Png)
    }

    /// Whether +y is up: on a PostScript page it is, on an SVG canvas it is down.
    #[must_use]
    pub const fn has_y_up(self) -> bool {
        matches!(self, Self::Ps | Self::Eps)
    }

    /// Whether closed shapes start at 180 degrees and run in the negative direction, as Lancaster's `drawellipse` does.
    #[must_use]
    pub const fn runs_as_drawellipse(self) -> bool {
        matches!(self, Self::Ps | Self::Eps)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Format {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|format| format.name() == name)
            .ok_or_else(|| Error::Syntax {
                what: "the format",
                text: name.to_owned(),
                column: 1,
                why: format!("the formats are {}", Self::ALL.map(Self::name).join(", ")),
            })
    }
}

/// The figure in a format; the style tells how pictures look.
///
/// # Errors
///
/// Where the picture cannot be made ([`Error::Picture`]), and for JSON, which tells what was asked and not only what was drawn:
/// [`json`] forms it from a [`Drawing`].
///
/// ```
/// use curveto::picture::{figure::Figure, style::Style};
/// use curveto::write::{Format, write};
/// use curveto::{Circle, Options, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
/// let figure = Figure::from(&approximate(&circle, &Options::default())?);
/// let svg = String::from_utf8_lossy(&write(&figure, Format::Svg, &Style::default())?).into_owned();
/// assert!(svg.contains(r##"<path d="M50 0C"##));
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn write(figure: &Figure, format: Format, style: &Style) -> Result<Vec<u8>> {
    let scene = || figure.scene(style);
    let text = match format {
        Format::Path => path::data(figure.curves(), style.relative) + "\n",
        Format::Ps => postscript::operators(figure.curves()),
        Format::Svg => svg::document(
            &scene()?,
            &figure.title,
            &figure.told(style),
            style.relative,
        ),
        Format::Eps => postscript::encapsulated(&scene()?, &figure.title, &figure.told(style))?,
        Format::Png => return png::encode(&scene()?),
        Format::Json => {
            return Err(Error::Picture("a figure alone has no JSON form".to_owned()));
        }
    };
    Ok(text.into_bytes())
}
