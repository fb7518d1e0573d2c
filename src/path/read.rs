//! SVG path data as contours and curves.

use kurbo::{CubicBez, PathSeg, Point, QuadBez};

use super::refusal::place;
use crate::contour::{Contour, ContourPen, Step};
use crate::curve::{CLOSING_GAP, Curve, size};
use crate::error::{Error, Result, TextError, UnmeasurableError, finite};
use crate::number::decimal_sum;
use crate::path_data::{PathFault, Segment, Segments};
use crate::shape::endpoint::SvgArc;

/// The contours of path data, one for each subpath that draws something. A closing line is a step of its own.
///
/// # Errors
///
/// Where the data does not parse, or a number is not finite or beyond 1e150.
pub fn contours(data: &str) -> Result<Vec<Contour>> {
    let mut subpaths = Subpaths::default();
    let mut segments = Segments::new(data, 0..data.len());
    for segment in &mut segments {
        subpaths.take(&segment, data).map_err(|error| {
            let fault = PathFault::too_large(data, &segment);
            fault.map_or(error, |fault| syntax(data, fault))
        })?;
    }
    match segments.fault() {
        Some(fault) => Err(syntax(data, fault)),
        None => Ok(subpaths.pen.contours()),
    }
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

fn syntax(data: &str, fault: PathFault) -> Error {
    let at = |at: usize| place(data, data[..at].chars().count() + 1);
    Error::Text(TextError::PathData {
        data: shortened(data),
        why: match fault {
            PathFault::Ends => "it ends where a command or a number should follow".to_owned(),
            PathFault::Comma(byte) => format!("a number is expected after the comma {}", at(byte)),
            PathFault::Unexpected(byte) => {
                format!("a command or a number is expected {}", at(byte))
            }
            PathFault::TooLarge(byte) => format!("the number is too large {}", at(byte)),
        },
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
    fn take(&mut self, segment: &Segment, data: &str) -> Result<()> {
        let here = self.pen.here();
        // The control point before, mirrored at the current point.
        let mirrored = |p: Point| here + (here - p);
        let control = core::mem::take(&mut self.control);
        match segment.kind() {
            b'z' => self.pen.close(),
            b'm' => {
                let [to] = self.points(segment, data)?;
                self.pen.move_to(to);
            }
            b'l' => {
                let [to] = self.points(segment, data)?;
                self.pen.line(to);
            }
            b'h' | b'v' => {
                let [value] = segment.values(data);
                let to = if segment.kind() == b'h' {
                    Point::new(sum(self.base(segment).x, value)?, here.y)
                } else {
                    Point::new(here.x, sum(self.base(segment).y, value)?)
                };
                self.pen.line(to);
            }
            b'c' => {
                let [p1, p2, to] = self.points(segment, data)?;
                self.cubic(p1, p2, to);
            }
            b's' => {
                let [p2, to] = self.points(segment, data)?;
                let p1 = match control {
                    Control::Cubic(p) => mirrored(p),
                    _ => here,
                };
                self.cubic(p1, p2, to);
            }
            b'q' => {
                let [p1, to] = self.points(segment, data)?;
                self.quadratic(p1, to);
            }
            b't' => {
                let [to] = self.points(segment, data)?;
                let p1 = match control {
                    Control::Quadratic(p) => mirrored(p),
                    _ => here,
                };
                self.quadratic(p1, to);
            }
            _ => {
                if let Some(arc) = SvgArc::of_segment(here, segment, data) {
                    finite("coordinate", arc.to.x)?;
                    finite("coordinate", arc.to.y)?;
                    self.pen.arc(&arc)?;
                }
            }
        }
        Ok(())
    }

    /// What coordinates count from.
    const fn base(&self, segment: &Segment) -> Point {
        if segment.is_relative() {
            self.pen.here()
        } else {
            Point::ZERO
        }
    }

    /// The points of a segment.
    fn points<const N: usize>(&self, segment: &Segment, data: &str) -> Result<[Point; N]> {
        let base = self.base(segment);
        let values: [f64; 6] = segment.values(data);
        let mut points = [Point::ZERO; N];
        for (point, [x, y]) in points.iter_mut().zip(values.as_chunks().0) {
            *point = Point::new(sum(base.x, *x)?, sum(base.y, *y)?);
        }
        Ok(points)
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

fn sum(from: f64, x: f64) -> Result<f64> {
    finite("coordinate", decimal_sum(from, finite("coordinate", x)?))
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
