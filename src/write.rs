//! The writers: the only place that knows a format.
//!
//! A writer sees a [`Figure`], whose points are already rounded, and knows no method.

pub mod catalogue;
pub mod comparison;
mod deviation;
pub mod json;
pub mod measurement;
pub mod plot;
pub mod png;
pub mod postscript;
pub mod scene;
pub mod sphere;
pub mod spline;
pub mod style;
pub mod svg;

use core::fmt;
use core::str::FromStr;

use kurbo::Rect;

use crate::approximate::Drawing;
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::number;
use crate::path;
use crate::shape::{Outline, Shape};
use scene::Scene;
use style::Style;

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

/// What a writer sees.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// A few words.
    pub title: String,
    /// A sentence: the shape, the method, the stated error.
    pub description: String,
    /// The curves, those beneath first.
    pub layers: Vec<Layer>,
    /// The true shapes that the curves approximate.
    pub truths: Vec<Outline>,
}

/// Curves that are drawn alike.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layer {
    /// The class of its group in SVG; without one its paths stand alone.
    pub class: Option<&'static str>,
    /// Whether it is drawn dashed.
    pub dashed: bool,
    /// Whether it is lines on a shape, to be stroked more finely and never filled.
    pub fine: bool,
    /// The curves, as they are written.
    pub curves: Vec<Curve>,
}

impl Figure {
    /// All curves in the order in which they are drawn.
    pub fn curves(&self) -> impl Iterator<Item = &Curve> {
        self.layers.iter().flat_map(|layer| &layer.curves)
    }

    /// The smallest rectangle around the curves themselves, not their control points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<Rect> {
        self.curves()
            .filter_map(Curve::bounding_box)
            .reduce(|a, b| a.union(b))
    }

    /// The description, and how what is shown is to be read.
    fn told(&self, style: &Style) -> String {
        match style.show.error {
            Some(factor) if !self.truths.is_empty() => format!(
                "{}; deviation drawn {} times as large",
                self.description,
                number::text(factor)
            ),
            _ => self.description.clone(),
        }
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
/// use curveto::write::{Figure, Format, style::Style, write};
/// use curveto::{Circle, Options, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
/// let figure = Figure::from(&approximate(&circle, &Options::default())?);
/// let svg = String::from_utf8_lossy(&write(&figure, Format::Svg, &Style::default())?).into_owned();
/// assert!(svg.contains(r##"<path d="M50 0C"##));
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn write(figure: &Figure, format: Format, style: &Style) -> Result<Vec<u8>> {
    let scene = || Scene::new(figure, style);
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

impl From<&Drawing> for Figure {
    fn from(drawing: &Drawing) -> Self {
        let title = describe(&drawing.shape);
        let description = if drawing.outline.is_some() {
            format!(
                "{title}; {count} segment{s} by {method}; within {peak} of the true shape ({relative} of the larger radius)",
                count = drawing.curve.segments.len(),
                s = if drawing.curve.segments.len() == 1 {
                    ""
                } else {
                    "s"
                },
                method = drawing.rule.id(),
                peak = number::significant(drawing.error.peak(), 3),
                relative = number::significant(drawing.relative_peak(), 3),
            )
        } else {
            format!("{title}; exact")
        };
        Self {
            title,
            description,
            layers: vec![Layer {
                curves: vec![drawing.curve.clone()],
                ..Layer::default()
            }],
            truths: drawing.outline.into_iter().collect(),
        }
    }
}

/// A shape in a few words.
#[must_use]
pub fn describe(shape: &Shape) -> String {
    let n = |x| number::significant(x, 9);
    match shape {
        Shape::Circle(c) => format!("Circle of radius {}", n(c.radius)),
        Shape::Ellipse(e) => format!("Ellipse with radii {} and {}", n(e.radii.x), n(e.radii.y)),
        Shape::Arc(a) if a.radii.x == a.radii.y => {
            format!(
                "Arc of radius {} over {} degrees",
                n(a.radii.x),
                n(a.sweep.degrees())
            )
        }
        Shape::Arc(a) => {
            format!(
                "Arc with radii {} and {} over {} degrees",
                n(a.radii.x),
                n(a.radii.y),
                n(a.sweep.degrees())
            )
        }
        Shape::Line(_) => "Line".to_owned(),
        Shape::Empty => "Empty path".to_owned(),
    }
}
