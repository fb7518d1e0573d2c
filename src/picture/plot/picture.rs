//! A picture as a list of lines, dots and words, and its two forms: SVG and PNG.

use core::fmt::{self, Write};

use kurbo::{Affine, BezPath, PathEl, Point, Vec2};
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use super::text::Font;
use crate::error::{Error, Result};
use crate::number::{Precision, text};
use crate::path;
use crate::{Circle, Options, Shape, approximate};

/// A colour, red, green and blue.
pub(super) type Colour = [u8; 3];

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    pub(super) width: f64,
    /// Lengths of strokes and gaps; empty for a solid line.
    pub(super) dashes: &'static [f64],
}

/// Which point of a text stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Item {
    Line {
        points: Vec<Point>,
        pen: Pen,
    },
    Dot {
        at: Point,
        radius: f64,
        colour: Colour,
    },
    Text(Text),
}

/// A line of words.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Text {
    pub(super) at: Point,
    pub(super) words: String,
    pub(super) size: f64,
    pub(super) anchor: Anchor,
    pub(super) colour: Colour,
    /// Whether it runs upwards.
    pub(super) upwards: bool,
}

/// A picture on white.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Picture {
    pub(super) title: String,
    pub(super) size: Vec2,
    pub(super) items: Vec<Item>,
}

impl Picture {
    pub(super) fn svg(&self) -> String {
        let (w, h) = (text(self.size.x), text(self.size.y));
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n<title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n",
            escape(&self.title)
        );
        for item in &self.items {
            item.push_svg(&mut out);
        }
        out + "</svg>\n"
    }

    /// The picture in pixels, `scale` of them for each unit.
    pub(super) fn png(&self, scale: f64) -> Result<Vec<u8>> {
        let pixels = self.size * scale;
        let too_large = || {
            Error::Picture(format!(
                "a picture of {} by {} pixels is too large",
                pixels.x.round(),
                pixels.y.round()
            ))
        };
        if pixels.x * pixels.y > 1e8 {
            return Err(too_large());
        }
        let mut pixmap =
            Pixmap::new(pixels.x.round() as u32, pixels.y.round() as u32).ok_or_else(too_large)?;
        pixmap.fill(tiny_skia::Color::WHITE);
        let font = Font::new();
        for item in &self.items {
            item.paint(&mut pixmap, scale, &font);
        }
        pixmap
            .encode_png()
            .map_err(|error| Error::Picture(format!("the picture cannot be made: {error}")))
    }
}

/// A coordinate of a picture: hundredths of a pixel are enough.
fn coordinate(x: f64) -> String {
    text(Precision::Fixed(2).round(x))
}

fn hex([r, g, b]: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn escape(words: &str) -> String {
    words
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// A dot: a circle drawn by what this package is for.
fn dot(at: Point, radius: f64) -> Option<crate::Curve> {
    let circle = Shape::Circle(Circle::new(at, radius).ok()?);
    let options = Options {
        precision: Some(Precision::Fixed(2)),
        ..Options::default()
    };
    approximate(&circle, &options)
        .ok()
        .map(|drawing| drawing.curve)
}

impl Item {
    fn push_svg(&self, out: &mut String) {
        // Writing to a string cannot fail.
        let _ = match self {
            Self::Line { points, pen } => {
                let mut data = String::new();
                for (i, p) in points.iter().enumerate() {
                    let letter = if i == 0 { 'M' } else { 'L' };
                    let _ = write!(data, "{letter}{} {}", coordinate(p.x), coordinate(p.y));
                }
                let dashes: Vec<String> = pen.dashes.iter().map(|&d| text(d)).collect();
                let dashed = if dashes.is_empty() {
                    String::new()
                } else {
                    format!(" stroke-dasharray=\"{}\"", dashes.join(" "))
                };
                writeln!(
                    out,
                    "<path d=\"{data}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashed}/>",
                    hex(pen.colour),
                    text(pen.width)
                )
            }
            Self::Dot { at, radius, colour } => match dot(*at, *radius) {
                Some(curve) => writeln!(
                    out,
                    "<path d=\"{}\" fill=\"{}\"/>",
                    path::data([&curve], false),
                    hex(*colour)
                ),
                None => Ok(()),
            },
            Self::Text(line) => line.push_svg(out),
        };
    }

    fn paint(&self, pixmap: &mut Pixmap, scale: f64, font: &Font) {
        let to_pixels = Transform::from_scale(scale as f32, scale as f32);
        match self {
            Self::Line { points, pen } => {
                let mut builder = PathBuilder::new();
                for (i, p) in points.iter().enumerate() {
                    let (x, y) = (p.x as f32, p.y as f32);
                    if i == 0 {
                        builder.move_to(x, y);
                    } else {
                        builder.line_to(x, y);
                    }
                }
                let Some(path) = builder.finish() else { return };
                let stroke = Stroke {
                    width: pen.width as f32,
                    line_cap: LineCap::Butt,
                    line_join: LineJoin::Round,
                    dash: StrokeDash::new(pen.dashes.iter().map(|&d| d as f32).collect(), 0.0),
                    ..Stroke::default()
                };
                pixmap.stroke_path(&path, &paint(pen.colour), &stroke, to_pixels, None);
            }
            Self::Dot { at, radius, colour } => {
                let Some(curve) = dot(*at, *radius) else {
                    return;
                };
                let path = BezPath::from_path_segments(curve.segments.into_iter());
                fill(pixmap, &path, *colour, to_pixels);
            }
            Self::Text(line) => fill(pixmap, &line.outline(font), line.colour, to_pixels),
        }
    }
}

impl Text {
    fn push_svg(&self, out: &mut String) -> fmt::Result {
        let anchor = match self.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (coordinate(self.at.x), coordinate(self.at.y));
        let turn = if self.upwards {
            format!(" transform=\"rotate(-90 {x} {y})\"")
        } else {
            String::new()
        };
        writeln!(
            out,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"{anchor}{turn}>{}</text>",
            text(self.size),
            hex(self.colour),
            escape(&self.words)
        )
    }

    /// The outlines of its letters in their place.
    fn outline(&self, font: &Font) -> BezPath {
        let shift = font.width(&self.words, self.size)
            * match self.anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => 0.5,
                Anchor::End => 1.0,
            };
        let turn = if self.upwards {
            -core::f64::consts::FRAC_PI_2
        } else {
            0.0
        };
        let place = Affine::translate(self.at.to_vec2())
            * Affine::rotate(turn)
            * Affine::translate((-shift, 0.0));
        place * font.outline(&self.words, self.size)
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    let [r, g, b] = colour;
    paint.set_color_rgba8(r, g, b, 255);
    paint.anti_alias = true;
    paint
}

fn fill(pixmap: &mut Pixmap, path: &BezPath, colour: Colour, map: Transform) {
    let mut builder = PathBuilder::new();
    for element in path.elements() {
        match *element {
            PathEl::MoveTo(p) => builder.move_to(p.x as f32, p.y as f32),
            PathEl::LineTo(p) => builder.line_to(p.x as f32, p.y as f32),
            PathEl::QuadTo(a, p) => builder.quad_to(a.x as f32, a.y as f32, p.x as f32, p.y as f32),
            PathEl::CurveTo(a, b, p) => builder.cubic_to(
                a.x as f32, a.y as f32, b.x as f32, b.y as f32, p.x as f32, p.y as f32,
            ),
            PathEl::ClosePath => builder.close(),
        }
    }
    if let Some(path) = builder.finish() {
        pixmap.fill_path(&path, &paint(colour), FillRule::Winding, map, None);
    }
}
