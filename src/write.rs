//! The writers: the only place that knows a format.
//!
//! A writer sees a [`Figure`] or a [`Scene`], whose points are already rounded, and knows no method.

pub mod canvas;
#[cfg(feature = "serde")]
pub mod catalogue;
pub mod comparison;
pub mod conic;
mod csv;
#[cfg(feature = "serde")]
pub mod difference;
pub mod dxf;
mod format;
pub mod gcode;
pub mod glif;
#[cfg(feature = "serde")]
pub mod json;
#[cfg(feature = "serde")]
pub mod measurement;
pub mod path;
#[cfg(feature = "pdf")]
pub mod pdf;
#[cfg(feature = "png")]
pub mod png;
pub mod postscript;
pub mod sphere;
pub mod spline;
pub mod svg;
pub mod tikz;

pub use format::{Format, Image};

use core::cell::LazyCell;

use crate::approximate::Drawing;
use crate::contour::Closeness;
use crate::course::Course;
use crate::error::{Error, FormatError, PictureError, Remedy, Result};
use crate::number::Precision;
use crate::picture::figure::{Figure, Layer};
#[cfg(feature = "plot")]
use crate::picture::plot::Chart;
use crate::picture::scene::Scene;
#[cfg(feature = "plot")]
use crate::picture::size::Size;
use crate::picture::style::Style;
use crate::picture::words;
use crate::shape::Outline;
use dxf::Trace;

/// The most segments beside which joints, handles and the deviation are shown.
const MOST_SHOWN: usize = 10_000;

/// How much larger than its layout a PNG of a plot is where no size was asked for, so that it can be printed.
#[cfg(all(feature = "plot", feature = "png"))]
const SHARPNESS: f64 = 2.0;

/// What every format can hold: something drawn, of which JSON states what was asked for too.
pub trait Writable {
    /// The curves, as they are written.
    fn figure(&self) -> Figure;

    /// What was drawn and how closely, in a line.
    fn summary(&self) -> String {
        self.figure().description
    }

    /// The JSON, without a line feed at its end.
    ///
    /// # Errors
    ///
    /// Where the values cannot be JSON ([`Error::Json`]), and where there are many shapes in one picture ([`Error::Format`]).
    #[cfg(feature = "serde")]
    fn json(&self) -> Result<String>;
}

impl Writable for Drawing {
    fn figure(&self) -> Figure {
        Figure::from(self)
    }

    fn summary(&self) -> String {
        words::summary(self)
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> Result<String> {
        json::to_string(&json::DrawingDocument::from(self))
    }
}

/// How it is written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// How pictures look.
    pub style: Style,
    /// Whether path data is relative.
    pub relative: bool,
    /// Whether DXF gets circular arcs themselves in place of the Béziers.
    pub exact: bool,
    /// How G-code is rounded, and arcs themselves in DXF. With `None` G-code moves no point by more than a millionth of the size, and
    /// such arcs have all digits.
    pub precision: Option<Precision>,
    /// How fast G-code moves, in units a minute.
    pub feed: Option<f64>,
    /// What a glyph is called; `None` calls it by its kind of shape.
    pub glyph: Option<String>,
    /// How far rounding may move G-code of what is an arc itself.
    pub room: Option<f64>,
}

impl Options {
    /// The arc that DXF gets itself in place of the Béziers, and how far rounding moves it.
    #[must_use]
    pub fn arc_itself(&self, outline: &Outline) -> Option<(Course, f64)> {
        let course = self.exact.then(|| Course::of_arc(outline)).flatten()?;
        course.rounded_for_cad(self.precision.unwrap_or(Precision::Full))
    }

    /// Those of G-code.
    fn gcode(&self, figure: &Figure) -> gcode::Options {
        let exact = self.room.map(Closeness::exact);
        gcode::Options {
            precision: self.precision,
            feed: self.feed,
            closeness: figure.closeness.or(exact),
        }
    }
}

/// What was drawn, in a format.
///
/// # Errors
///
/// Where the picture cannot be made ([`Error::Picture`]), a length of its style or the feed is out of range, and where the format cannot hold what was drawn ([`Error::Format`]).
///
/// ```
/// use curveto::write::{self, Format, Image, write};
/// use curveto::{Circle, Options, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
/// let drawing = approximate(&circle, &Options::default())?;
/// let bytes = write(&drawing, Format::Image(Image::Svg), &write::Options::default())?;
/// assert!(String::from_utf8_lossy(&bytes).contains(r##"<path d="M50 0C"##));
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn write(work: &impl Writable, format: Format, options: &Options) -> Result<Vec<u8>> {
    // JSON has no use for it.
    let figure = LazyCell::new(|| work.figure());
    let text = match format {
        #[cfg(feature = "serde")]
        Format::Json => work.json()? + "\n",
        _ if !figure.courses.is_empty() => return write_courses(&figure, format, options),
        Format::Path => crate::path::data(figure.curves(), options.relative) + "\n",
        Format::Ps => postscript::operators(figure.curves()),
        Format::Tikz => named(&figure, " % ", |layer| {
            tikz::commands(&layer.curves, layer.dashed)
        })?,
        Format::Canvas => named(&figure, " // ", |layer| Ok(canvas::calls(&layer.curves)))?,
        Format::Glif => glif::glyph(&figure, options.glyph.as_deref()),
        Format::Dxf => dxf::drawing(&figure.title, &traces(&figure, options)),
        Format::Gcode => {
            let courses = courses(&figure)?;
            gcode::program(&figure.title, &courses, &options.gcode(&figure))?
        }
        Format::Image(image) => {
            check_shown(&figure, &options.style)?;
            return picture(&figure.scene(&options.style)?, image, options.relative);
        }
    };
    Ok(text.into_bytes())
}

/// The curves layer by layer, the name of each, where it has one, in a comment on its first line.
fn named(
    figure: &Figure,
    comment: &str,
    text: impl Fn(&Layer) -> Result<String>,
) -> Result<String> {
    let mut out = String::new();
    for layer in &figure.layers {
        let text = text(layer)?;
        match (&layer.id, text.split_once('\n')) {
            (Some(id), Some((first, rest))) => out.extend([first, comment, id, "\n", rest]),
            _ => out += &text,
        }
    }
    Ok(out)
}

/// Refuses to show more than anyone could see, which would take minutes.
fn check_shown(figure: &Figure, style: &Style) -> Result<()> {
    let segments = figure.curves().map(|curve| curve.segments.len());
    let steps = figure.courses.iter().map(|course| course.steps.len());
    let segments: usize = segments.chain(steps).sum();
    if style.show.is_any() && segments > MOST_SHOWN {
        let (count, most) = (segments, MOST_SHOWN);
        return Err(Error::Picture(PictureError::TooManyShown { count, most }));
    }
    Ok(())
}

/// Lines and circular arcs, in a format that has them.
fn write_courses(figure: &Figure, format: Format, options: &Options) -> Result<Vec<u8>> {
    let courses = &figure.courses;
    if matches!(format, Format::Dxf | Format::Gcode) && !courses.iter().all(Course::is_circular) {
        return Err(Error::Format {
            format: format.name(),
            why: FormatError::EllipticalArcs,
            remedy: Remedy::CircularArcs,
        });
    }
    let text = match format {
        Format::Path => crate::path::data_of_courses(courses, options.relative) + "\n",
        Format::Dxf => {
            let traces = courses.iter().cloned().map(Trace::Course);
            let traces: Vec<_> = traces.map(|trace| (None, trace)).collect();
            dxf::drawing(&figure.title, &traces)
        }
        Format::Gcode => gcode::program(&figure.title, courses, &options.gcode(figure))?,
        Format::Image(image) => {
            check_shown(figure, &options.style)?;
            let mut scene = figure.scene(&options.style)?;
            if image != Image::Svg {
                let precision = figure.precision_along_arcs(options.precision);
                let moved = precision.farthest_moved();
                scene.draw_arcs_as_curves(precision)?;
                scene.description = figure.described_with_arcs_moved(&options.style, moved);
            }
            return picture(&scene, image, options.relative);
        }
        _ => {
            return Err(Error::Format {
                format: format.name(),
                why: FormatError::Arcs,
                remedy: Remedy::FormatsOfArcs,
            });
        }
    };
    Ok(text.into_bytes())
}

/// The curves of a figure for DXF.
fn traces<'a>(figure: &'a Figure, options: &Options) -> Vec<(Option<&'a str>, Trace<'a>)> {
    let curves = figure.layers.iter().flat_map(|layer| {
        let name = layer.class.or(layer.id.as_deref());
        layer.curves.iter().map(move |curve| (name, curve))
    });
    let exact = |number: usize| options.arc_itself(figure.truth(number)?);
    let trace = |(i, (class, curve))| {
        let trace = exact(i).map_or(Trace::Curve(curve), |(course, _)| Trace::Course(course));
        (class, trace)
    };
    curves.enumerate().map(trace).collect()
}

/// The curves of a figure as lines and circular arcs.
fn courses(figure: &Figure) -> Result<Vec<Course>> {
    let drawn = figure.curves().enumerate();
    let drawn = drawn.filter(|(_, curve)| !curve.segments.is_empty());
    let course = |(i, curve)| {
        let of_arc = || figure.truth(i).and_then(Course::of_arc);
        let course = Course::of_lines(curve).or_else(of_arc);
        course.ok_or_else(|| Error::Format {
            format: Format::Gcode.name(),
            why: FormatError::Curves,
            remedy: Remedy::Arcs,
        })
    };
    drawn.map(course).collect()
}

/// A plot in the format of a picture, of this size or of one at which it reads well.
///
/// # Errors
///
/// Where a side of the picture is not positive and finite, and where it is too large to be made ([`Error::Picture`]).
#[cfg(feature = "plot")]
pub fn plot(chart: &Chart, image: Image, size: Option<Size>) -> Result<Vec<u8>> {
    size.map_or(Ok(()), Size::check)?;
    #[cfg(feature = "png")]
    if image == Image::Png {
        return pixels(chart, size);
    }
    let layout = match size {
        None => chart.default_size(),
        Some(size) if image == Image::Svg => size.pixels(),
        Some(size) => size.points(),
    };
    let mut scene = chart.scene(layout);
    scene.size = size.or(scene.size);
    picture(&scene, image, false)
}

/// A plot as pixels, whose words grow where it is large.
#[cfg(all(feature = "plot", feature = "png"))]
fn pixels(chart: &Chart, size: Option<Size>) -> Result<Vec<u8>> {
    let default = chart.default_size();
    let [width, height] = size.map_or(default.map(|side| side * SHARPNESS), Size::pixels);
    let scale = (width / default[0]).min(height / default[1]).max(1.0);
    let mut scene = chart.scene([width / scale, height / scale]);
    scene.size = Some(Size::plain([width, height]));
    png::encode(&scene)
}

fn picture(scene: &Scene, image: Image, relative: bool) -> Result<Vec<u8>> {
    Ok(match image {
        Image::Svg => svg::document(scene, relative).into_bytes(),
        Image::Eps => postscript::encapsulated(scene)?.into_bytes(),
        #[cfg(feature = "png")]
        Image::Png => png::encode(scene)?,
        #[cfg(feature = "pdf")]
        Image::Pdf => pdf::document(scene)?,
    })
}

/// A text in XML or HTML, between tags or in an attribute between double quotes.
pub(crate) fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('"', "&quot;");
    text.replace('<', "&lt;").replace('>', "&gt;")
}

/// A name as every format can hold it: none has control characters, and XML has two others not at all.
pub(crate) fn name(text: &str) -> String {
    text.replace(
        |c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'),
        "_",
    )
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;
    use crate::compare::{Comparison, Criterion};

    #[test]
    fn plots_are_well_formed_at_any_size() {
        let rules = crate::Method::ALL.map(crate::Rule::Method);
        let comparison = Comparison::new(&rules, &[2, 3, 4, 8], Criterion::Peak, None).unwrap();
        let chart = Chart::comparison(&comparison);
        for size in [None, Some([20.0, 20.0]), Some([3000.0, 700.0])] {
            let size = size.map(Size::plain);
            let svg = String::from_utf8(plot(&chart, Image::Svg, size).unwrap()).unwrap();
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
            assert_eq!(svg.matches("<text").count(), svg.matches("</text>").count());
            let png = plot(&chart, Image::Png, size).unwrap();
            assert!(png.starts_with(b"\x89PNG"));
        }
        assert!(plot(&chart, Image::Png, Some(Size::plain([1e6, 1e6]))).is_err());
    }
}
