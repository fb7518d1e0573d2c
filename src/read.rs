//! Curves that others made: SVG path data, and the paths of SVG files with the transforms of their ancestors.

use kurbo::{Affine, CubicBez, Line, PathSeg, Point, QuadBez, Vec2};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use svgtypes::{PathParser, PathSegment};

use crate::curve::Curve;
use crate::error::{Error, Result, finite};
use crate::measure::bench::{CLOSING_GAP, gap, size};

/// The curves of path data, one for each subpath. A closing line that is next to nothing, as rounding leaves one, is no segment.
///
/// # Errors
///
/// Where the data does not parse, a coordinate is not finite or beyond 1e150, or an elliptical arc is among the segments: that
/// one is no Bézier, and exact.
pub fn path_data(data: &str) -> Result<Vec<Curve>> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        let segment = segment.map_err(|error| syntax(data, &error.to_string()))?;
        pen.take(segment)?;
    }
    pen.end();
    Ok(pen.curves)
}

fn syntax(data: &str, why: &str) -> Error {
    Error::Shape(format!(
        "cannot read the path data '{}': {why}",
        shortened(data)
    ))
}

/// The first words of a text that may be long.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// The current subpath.
#[derive(Default)]
struct Pen {
    curves: Vec<Curve>,
    segments: Vec<PathSeg>,
    start: Point,
    here: Point,
    /// The last control point of the segment before, where the shorthands T and S reflect it.
    control: Control,
}

#[derive(Default, Clone, Copy)]
enum Control {
    #[default]
    None,
    Quadratic(Point),
    Cubic(Point),
}

impl Pen {
    fn take(&mut self, segment: PathSegment) -> Result<()> {
        let here = self.here.to_vec2();
        let origin = |abs: bool| if abs { Vec2::ZERO } else { here };
        let at = |abs: bool, x: f64, y: f64| -> Result<Point> {
            let p = Point::new(x, y) + origin(abs);
            Ok(Point::new(
                finite("coordinate", p.x)?,
                finite("coordinate", p.y)?,
            ))
        };
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                let p = at(abs, x, y)?;
                self.end();
                (self.start, self.here) = (p, p);
            }
            PathSegment::LineTo { abs, x, y } => self.line(at(abs, x, y)?),
            PathSegment::HorizontalLineTo { abs, x } => {
                let p = at(abs, x, 0.0)?;
                self.line(Point::new(p.x, self.here.y));
            }
            PathSegment::VerticalLineTo { abs, y } => {
                let p = at(abs, 0.0, y)?;
                self.line(Point::new(self.here.x, p.y));
            }
            PathSegment::CurveTo {
                abs,
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => {
                self.cubic(at(abs, x1, y1)?, at(abs, x2, y2)?, at(abs, x, y)?);
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                let first = match self.control {
                    Control::Cubic(p) => self.here + (self.here - p),
                    _ => self.here,
                };
                self.cubic(first, at(abs, x2, y2)?, at(abs, x, y)?);
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                self.quadratic(at(abs, x1, y1)?, at(abs, x, y)?);
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                let control = match self.control {
                    Control::Quadratic(p) => self.here + (self.here - p),
                    _ => self.here,
                };
                self.quadratic(control, at(abs, x, y)?);
            }
            PathSegment::EllipticalArc { .. } => {
                return Err(Error::Shape(format!(
                    "segment {} of the path is an elliptical arc (A): that one is exact and no Bézier, so that there is no error to measure",
                    self.segments.len() + 1
                )));
            }
            PathSegment::ClosePath { .. } => self.close(),
        }
        Ok(())
    }

    fn push(&mut self, segment: PathSeg, end: Point, control: Control) {
        self.segments.push(segment);
        self.here = end;
        self.control = control;
    }

    fn line(&mut self, end: Point) {
        self.push(PathSeg::Line(Line::new(self.here, end)), end, Control::None);
    }

    fn cubic(&mut self, p1: Point, p2: Point, end: Point) {
        let cubic = CubicBez::new(self.here, p1, p2, end);
        self.push(PathSeg::Cubic(cubic), end, Control::Cubic(p2));
    }

    fn quadratic(&mut self, p1: Point, end: Point) {
        let quad = QuadBez::new(self.here, p1, end);
        self.push(PathSeg::Quad(quad), end, Control::Quadratic(p1));
    }

    fn close(&mut self) {
        let mut curve = Curve {
            segments: core::mem::take(&mut self.segments),
            closed: true,
        };
        if gap(&curve) > CLOSING_GAP * size(&curve) {
            curve
                .segments
                .push(PathSeg::Line(Line::new(self.here, self.start)));
        }
        self.here = self.start;
        self.control = Control::None;
        self.keep(curve);
    }

    /// Ends a subpath that was not closed.
    fn end(&mut self) {
        let curve = Curve {
            segments: core::mem::take(&mut self.segments),
            closed: false,
        };
        self.control = Control::None;
        self.keep(curve);
    }

    fn keep(&mut self, curve: Curve) {
        if !curve.segments.is_empty() {
            self.curves.push(curve);
        }
    }
}

/// A `path` element of an SVG file.
#[derive(Debug, Clone, PartialEq)]
pub struct SvgPath {
    /// The line on which it starts, from 1.
    pub line: usize,
    /// Its id.
    pub id: Option<String>,
    /// Its curves in the coordinates of the outermost element, or why they cannot be had.
    pub curves: Result<Vec<Curve>>,
}

/// Every `path` element of an SVG file, with its own transform and those of its ancestors applied.
///
/// # Errors
///
/// Where the text is not well-formed XML.
pub fn svg_paths(text: &str) -> Result<Vec<SvgPath>> {
    // The reader leaves a byte order mark out of its positions.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::from_str(text);
    let mut found = Vec::new();
    let mut maps = vec![Ok(Affine::IDENTITY)];
    let (mut counted, mut line) = (0, 1);
    loop {
        let position = (reader.buffer_position() as usize).min(text.len());
        line += text[counted..position].matches('\n').count();
        counted = position;
        let event = reader
            .read_event()
            .map_err(|error| Error::Shape(format!("line {line}: not well-formed XML: {error}")))?;
        let (element, is_open) = match &event {
            Event::Start(element) => (element, true),
            Event::Empty(element) => (element, false),
            Event::End(_) => {
                if maps.len() > 1 {
                    maps.pop();
                }
                continue;
            }
            Event::Eof => break,
            _ => continue,
        };
        let map = map_within(maps.last(), element);
        if element.local_name().as_ref() == "path" {
            found.push(svg_path(element, &map, line));
        }
        if is_open {
            maps.push(map);
        }
    }
    Ok(found)
}

fn svg_path(element: &BytesStart, map: &Result<Affine>, line: usize) -> SvgPath {
    let curves = map.clone().and_then(|map| {
        let curves = path_data(&attribute(element, "d").unwrap_or_default())?;
        Ok(curves.iter().map(|curve| curve.transformed(map)).collect())
    });
    SvgPath {
        line,
        id: attribute(element, "id"),
        curves,
    }
}

/// The map of an element: its own transform behind that of its parent.
fn map_within(parent: Option<&Result<Affine>>, element: &BytesStart) -> Result<Affine> {
    let parent = parent.cloned().unwrap_or(Ok(Affine::IDENTITY))?;
    let Some(text) = attribute(element, "transform") else {
        return Ok(parent);
    };
    let own: svgtypes::Transform = text.parse().map_err(|error| {
        Error::Shape(format!(
            "cannot read the transform '{}': {error}",
            shortened(&text)
        ))
    })?;
    let map = parent * Affine::new([own.a, own.b, own.c, own.d, own.e, own.f]);
    for number in map.as_coeffs() {
        finite("number in the transform", number)?;
    }
    Ok(map)
}

fn attribute(element: &BytesStart, name: &str) -> Option<String> {
    let attribute = element.try_get_attribute(name).ok().flatten()?;
    match quick_xml::escape::unescape(&attribute.value) {
        Ok(plain) => Some(plain.into_owned()),
        Err(_) => Some(attribute.value.into_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shorthands_reflect_and_relative_ones_add_up() {
        let full =
            path_data("M10 10C20 0 30 0 40 10C50 20 60 20 70 10Q80 0 90 10Q100 20 110 10").unwrap();
        let short = path_data("m10 10c10-10 20-10 30 0s20 10 30 0q10-10 20 0t20 0").unwrap();
        assert_eq!(full, short);
        assert_eq!(full[0].segments.len(), 4);
    }

    #[test]
    fn a_closing_line_is_a_segment_unless_it_is_rounding() {
        let open = path_data("M0 0L10 0L10 10Z").unwrap();
        assert_eq!(open[0].segments.len(), 3);
        let met = path_data("M0 0L10 0L10 10L0 0.0001Z").unwrap();
        assert_eq!(met[0].segments.len(), 3);
        assert!(met[0].closed);
    }

    #[test]
    fn subpaths_are_curves_of_their_own() {
        let curves = path_data("M0 0L1 0m5 5L1 1z M7 7").unwrap();
        assert_eq!(curves.len(), 2);
        assert_eq!(path_data("").unwrap(), []);
        assert_eq!(path_data("M1 1").unwrap(), []);
    }

    #[test]
    fn arcs_and_nonsense_are_refused() {
        let arc = path_data("M0 0A1 1 0 0 1 2 0").unwrap_err().to_string();
        assert!(arc.contains("arc (A)"), "{arc}");
        for bad in ["NaN", "M0 0C1", "M1e300 0L1 1", "M1e149 0l1e150 0", "L1 1"] {
            assert!(path_data(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn transforms_of_all_ancestors_apply() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg">
<g transform="translate(10 0)"><g transform="scale(2)">
<path id="a&amp;b" transform="rotate(90)" d="M1 0L2 0"/></g></g>
<path d="M1 0A1 1 0 0 1 2 0"/></svg>"#;
        let paths = svg_paths(svg).unwrap();
        assert_eq!((paths[0].line, paths[0].id.as_deref()), (3, Some("a&b")));
        let curves = paths[0].curves.as_ref().unwrap();
        let PathSeg::Line(line) = curves[0].segments[0] else {
            panic!()
        };
        assert!(line.p0.distance(Point::new(10.0, 2.0)) < 1e-12);
        assert!(paths[1].curves.is_err());
        assert!(svg_paths("<svg><path").is_err());
        let marked = svg_paths("\u{feff}<svg>\n<!--\u{e9}--><path/></svg>").unwrap();
        assert_eq!(marked[0].line, 2);
        assert!(svg_paths("\u{feff}c0").is_ok());
    }
}
