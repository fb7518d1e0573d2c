//! SVG path data as contours and curves.

use std::borrow::Cow;

use kurbo::{CubicBez, PathSeg, Point, QuadBez};
use svgtypes::{PathParser, PathSegment};

use super::refusal::{place, refusal};
use crate::contour::{Contour, ContourPen, Step};
use crate::curve::{CLOSING_GAP, Curve, size};
use crate::error::{Error, Result, TextError, UnmeasurableError, finite};
use crate::number::decimal_sum;
use crate::shape::endpoint::SvgArc;

/// The contours of path data, one for each subpath that draws something. A closing line is a step of its own.
///
/// # Errors
///
/// Where the data does not parse, or a number is not finite or beyond 1e150.
pub fn contours(data: &str) -> Result<Vec<Contour>> {
    if let Some(at) = stray_comma(data) {
        let why = format!("a number is expected after the comma {}", place(data, at));
        return Err(syntax(data, why));
    }
    let mut subpaths = Subpaths::default();
    for segment in PathParser::from(&*commas_first(data)) {
        let segment = segment
            .map_err(|error| syntax(data, refusal(&error, data, "a command or a number")))?;
        subpaths.take(segment)?;
    }
    Ok(subpaths.pen.contours())
}

/// The curves of path data, one for each subpath. A closing line that is next to nothing, as rounding leaves one, is no segment.
///
/// # Errors
///
/// Where the data does not parse, a coordinate is not finite or beyond 1e150, or an elliptical arc is among the segments: that
/// one is no Bézier, and exact.
pub fn curves(data: &str) -> Result<Vec<Curve>> {
    contours(data)?.iter().filter_map(curve).collect()
}

/// A contour as a curve; `None` where it has no length.
///
/// # Errors
///
/// In `Some`, where an elliptical arc is among its steps.
#[must_use]
pub fn curve(contour: &Contour) -> Option<Result<Curve>> {
    let mut segments = Vec::with_capacity(contour.steps.len());
    for (i, step) in contour.steps.iter().enumerate() {
        match step {
            Step::Given(segment) => segments.push(*segment),
            Step::Arc(_) => {
                return Some(Err(Error::Unmeasurable(UnmeasurableError::Arc {
                    segment: i + 1,
                })));
            }
        }
    }
    let mut curve = Curve {
        segments,
        closed: contour.closed,
    };
    if let (true, Some(PathSeg::Line(line))) = (curve.closed, curve.segments.last()) {
        // A closing line that is next to nothing is what rounding leaves, and a point alone has no length.
        if line.p0.distance(line.p1) <= CLOSING_GAP * size(&curve) {
            curve.segments.pop();
        }
    }
    (!curve.segments.is_empty()).then_some(Ok(curve))
}

/// The same data with each comma before the white space around it: after the flag of an arc svgtypes reads none behind.
fn commas_first(data: &str) -> Cow<'_, str> {
    let is_space = |c: char| matches!(c, ' ' | '\t' | '\n' | '\r' | '\x0c');
    if !data.contains(['a', 'A']) || !data.contains(',') {
        return Cow::Borrowed(data);
    }
    let mut out = String::with_capacity(data.len());
    for c in data.chars() {
        let end = out.trim_end_matches(is_space).len();
        if c == ',' && end < out.len() && !out[..end].ends_with(',') {
            out.insert(end, c);
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

/// The character, from 1, of a comma that no number follows, which svgtypes overlooks.
fn stray_comma(data: &str) -> Option<usize> {
    let mut comma = None;
    for (i, c) in data.chars().enumerate() {
        match c {
            ',' => comma = Some(i + 1),
            ' ' | '\t' | '\n' | '\r' | '\x0c' => {}
            _ if c.is_ascii_alphabetic() && comma.is_some() => return comma,
            _ => comma = None,
        }
    }
    comma
}

fn syntax(data: &str, why: String) -> Error {
    Error::Text(TextError::PathData {
        data: shortened(data),
        why,
    })
}

/// The first words of a text that may be long, in one line.
#[must_use]
pub fn shortened(text: &str) -> String {
    let in_line = |c: char| if matches!(c, '\n' | '\r') { ' ' } else { c };
    let mut characters = text.trim_end().chars().map(in_line);
    let first: String = characters.by_ref().take(40).collect();
    let more = if characters.next().is_some() {
        "..."
    } else {
        ""
    };
    first + more
}

/// The current subpath.
#[derive(Default)]
struct Subpaths {
    pen: ContourPen,
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

impl Subpaths {
    fn take(&mut self, segment: PathSegment) -> Result<()> {
        let here = self.pen.here();
        // The control point before, mirrored at the current point.
        let mirrored = |p: Point| here + (here - p);
        let control = core::mem::take(&mut self.control);
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                let to = self.at(abs, x, y)?;
                self.pen.move_to(to);
            }
            PathSegment::LineTo { abs, x, y } => self.pen.line(self.at(abs, x, y)?),
            PathSegment::HorizontalLineTo { abs, x } => {
                let p = self.at(abs, x, 0.0)?;
                self.pen.line(Point::new(p.x, here.y));
            }
            PathSegment::VerticalLineTo { abs, y } => {
                let p = self.at(abs, 0.0, y)?;
                self.pen.line(Point::new(here.x, p.y));
            }
            PathSegment::ClosePath { .. } => self.pen.close(),
            #[rustfmt::skip]
            PathSegment::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                self.cubic(self.at(abs, x1, y1)?, self.at(abs, x2, y2)?, self.at(abs, x, y)?);
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                let first = match control {
                    Control::Cubic(p) => mirrored(p),
                    _ => here,
                };
                self.cubic(first, self.at(abs, x2, y2)?, self.at(abs, x, y)?);
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                self.quadratic(self.at(abs, x1, y1)?, self.at(abs, x, y)?);
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                let control = match control {
                    Control::Quadratic(p) => mirrored(p),
                    _ => here,
                };
                self.quadratic(control, self.at(abs, x, y)?);
            }
            arc @ PathSegment::EllipticalArc { .. } => {
                if let Some(arc) = SvgArc::of_segment(here, arc) {
                    finite("coordinate", arc.to.x)?;
                    finite("coordinate", arc.to.y)?;
                    self.pen.arc(&arc)?;
                }
            }
        }
        Ok(())
    }

    /// A point of a command, absolute or counted from the current one.
    fn at(&self, abs: bool, x: f64, y: f64) -> Result<Point> {
        let (x, y) = (finite("coordinate", x)?, finite("coordinate", y)?);
        let from = if abs { Point::ZERO } else { self.pen.here() };
        Ok(Point::new(
            finite("coordinate", decimal_sum(from.x, x))?,
            finite("coordinate", decimal_sum(from.y, y))?,
        ))
    }

    fn cubic(&mut self, p1: Point, p2: Point, end: Point) {
        let cubic = CubicBez::new(self.pen.here(), p1, p2, end);
        self.pen.segment(PathSeg::Cubic(cubic));
        self.control = Control::Cubic(p2);
    }

    fn quadratic(&mut self, p1: Point, end: Point) {
        let quad = QuadBez::new(self.pen.here(), p1, end);
        self.pen.segment(PathSeg::Quad(quad));
        self.control = Control::Quadratic(p1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shorthands_reflect_and_relative_ones_add_up() {
        let full =
            curves("M10 10C20 0 30 0 40 10C50 20 60 20 70 10Q80 0 90 10Q100 20 110 10").unwrap();
        let short = curves("m10 10c10-10 20-10 30 0s20 10 30 0q10-10 20 0t20 0").unwrap();
        assert_eq!(full, short);
        assert_eq!(full[0].segments.len(), 4);
    }

    #[test]
    fn a_closing_line_is_a_segment_unless_it_is_rounding() {
        let open = curves("M0 0L10 0L10 10Z").unwrap();
        assert_eq!(open[0].segments.len(), 3);
        let met = curves("M0 0L10 0L10 10L0 0.0001Z").unwrap();
        assert_eq!(met[0].segments.len(), 3);
        assert!(met[0].closed);
    }

    #[test]
    fn subpaths_are_curves_of_their_own() {
        let found = curves("M0 0L1 0m5 5L1 1z M7 7").unwrap();
        assert_eq!(found.len(), 2);
        assert_eq!(curves("").unwrap(), []);
        assert_eq!(curves("M1 1").unwrap(), []);
    }

    #[test]
    fn arcs_and_nonsense_are_refused() {
        let arc = curves("M0 0A1 1 0 0 1 2 0").unwrap_err().to_string();
        assert!(arc.contains("arc (A)"), "{arc}");
        assert!(
            curves("M0 0,L1 1")
                .unwrap_err()
                .to_string()
                .ends_with("after the comma at character 5")
        );
        assert_eq!(
            contours("M0 0a5 5 0 0 1 , 9 0"),
            contours("M0 0a5 5 0 0 1 9 0")
        );
        for bad in ["NaN", "M0 0C1", "M1e300 0L1 1", "M1e149 0l1e150 0", "L1 1"] {
            assert!(curves(bad).is_err(), "{bad}");
        }
    }
}
