//! SVG path data: no redundant separator, no exponent, the last point of a closed shape digit for digit the first.

use kurbo::{PathSeg, Point, Vec2};

use super::text::PathText;
use crate::course::{Course, CourseStep};
use crate::curve::Curve;
use crate::number::decimal::{BelowOne, Decimal};
#[cfg(feature = "batch")]
use crate::number::memo::Memo;
use crate::number::{Precision, decimal_sum};

/// The path data of one or more curves.
#[must_use]
pub fn data<'a>(curves: impl IntoIterator<Item = &'a Curve>, relative: bool) -> String {
    let mut out = Vec::new();
    for curve in curves {
        push_curve(&mut out, curve, relative);
    }
    // The formatter writes digits, points and signs only, so that this cannot fail and need not copy.
    String::from_utf8(out).unwrap_or_default()
}

/// The path data of courses: lines and circular arcs.
#[must_use]
pub fn data_of_courses<'a>(
    courses: impl IntoIterator<Item = &'a Course>,
    relative: bool,
) -> String {
    let mut out = Vec::new();
    for course in courses {
        PathWriter::new(&mut out, Precision::Full, relative).course(course);
    }
    String::from_utf8(out).unwrap_or_default()
}

/// Appends the path data of a curve; a relative one must start a path or follow a closed or finished one.
pub fn push_curve(out: &mut Vec<u8>, curve: &Curve, relative: bool) {
    PathWriter::new(out, Precision::Full, relative).curve(curve);
}

/// Appends the absolute path data of a curve, rounding as it writes: the digits are those of [`push_curve`] of the rounded curve.
#[cfg(feature = "batch")]
pub(crate) fn push_rounded(out: &mut Vec<u8>, curve: &Curve, precision: Precision) {
    PathWriter::new(out, precision, false).curve(curve);
}

/// Appends the absolute path data of a curve by texts that are kept: the digits are those of [`push_curve`].
#[cfg(feature = "batch")]
pub(crate) fn push_kept(out: &mut Vec<u8>, curve: &Curve, memo: &mut Memo) {
    PathWriter {
        memo: Some(memo),
        ..PathWriter::new(out, Precision::Full, false)
    }
    .curve(curve);
}

/// Writes one path.
struct PathWriter<'a> {
    out: &'a mut Vec<u8>,
    #[cfg(feature = "batch")]
    memo: Option<&'a mut Memo>,
    text: PathText,
    precision: Precision,
    relative: bool,
    /// What relative coordinates are counted from.
    current: Point,
}

impl<'a> PathWriter<'a> {
    const fn new(out: &'a mut Vec<u8>, precision: Precision, relative: bool) -> Self {
        Self {
            out,
            #[cfg(feature = "batch")]
            memo: None,
            text: PathText::new(BelowOne::Plain),
            precision,
            relative,
            current: Point::ZERO,
        }
    }

    fn curve(&mut self, curve: &Curve) {
        let Some(start) = curve.start() else { return };
        self.start(start);
        for segment in without_closing_line(curve) {
            match segment {
                PathSeg::Line(l) => self.command(b'L', &[l.p1]),
                PathSeg::Quad(q) => self.command(b'Q', &[q.p1, q.p2]),
                PathSeg::Cubic(c) => self.command(b'C', &[c.p1, c.p2, c.p3]),
            }
        }
        if curve.closed {
            self.letter(b'Z');
        }
    }

    fn course(&mut self, course: &Course) {
        self.start(course.start);
        let steps = match course.steps.as_slice() {
            [rest @ .., CourseStep::Line(to)]
                if course.closed && !rest.is_empty() && *to == course.start =>
            {
                rest
            }
            all => all,
        };
        for step in steps {
            match step {
                CourseStep::Line(to) => self.command(b'L', &[*to]),
                CourseStep::Arc(arc) => {
                    let sweep = arc.sweep.degrees();
                    let flags = [sweep.abs() > 180.0, sweep > 0.0];
                    self.arc([arc.radius, arc.radius, 0.0], flags, step.to());
                }
                CourseStep::Elliptical(arc) => {
                    let numbers = [arc.radii.x, arc.radii.y, arc.rotation.degrees()];
                    self.arc(numbers, [arc.large_arc, arc.sweep], step.to());
                }
            }
        }
        if course.closed {
            self.letter(b'Z');
        }
    }

    fn arc(&mut self, [rx, ry, turn]: [f64; 3], flags: [bool; 2], to: Point) {
        self.letter(b'A');
        let [large, sweep] = flags.map(|flag| f64::from(u8::from(flag)));
        for number in [rx, ry, turn, large, sweep] {
            self.number(number);
        }
        self.points(&[to]);
    }

    fn start(&mut self, start: Point) {
        self.out.push(b'M');
        self.number(start.x);
        self.number(start.y);
        self.current = start;
    }

    fn command(&mut self, letter: u8, points: &[Point]) {
        self.letter(letter);
        self.points(points);
    }

    /// A command's letter, small where it is relative.
    fn letter(&mut self, letter: u8) {
        let small = if self.relative { 0x20 } else { 0 };
        self.text.letter(self.out, letter | small);
    }

    /// The points of a command, which ends on the last of them.
    fn points(&mut self, points: &[Point]) {
        for p in points {
            let v = if self.relative {
                decimal_difference(*p, self.current)
            } else {
                p.to_vec2()
            };
            self.number(v.x);
            self.number(v.y);
        }
        self.current = points.last().copied().unwrap_or(self.current);
    }

    #[inline]
    fn number(&mut self, x: f64) {
        /// Up to 15 digits are those of the nearest float, too.
        const MOST_UNITS: u64 = 1_000_000_000_000_000;
        #[cfg(feature = "batch")]
        if let Some(memo) = &mut self.memo {
            return self.text.after.push_kept(self.out, x, memo);
        }
        let number = match self.precision {
            Precision::Fixed(decimals) => Decimal::nearest(x, decimals),
            Precision::Full => None,
        };
        match number {
            Some(number) if number.units.unsigned_abs() < MOST_UNITS => {
                self.text.push(self.out, number);
            }
            _ => self
                .text
                .after
                .push_shortest(self.out, self.precision.round(x)),
        }
    }
}

/// The segments that are written: a closing operator draws the line to the start by itself, and lines of no length before it.
fn without_closing_line(curve: &Curve) -> &[PathSeg] {
    let mut written = curve.segments.as_slice();
    while let [rest @ .., PathSeg::Line(last)] = written
        && curve.closed
        && !rest.is_empty()
        && Some(last.p1) == curve.start()
    {
        written = rest;
        if last.p0 != last.p1 {
            break;
        }
    }
    written
}

/// The difference of two points as the decimals that they are written as, so that relative coordinates add up to the absolute ones.
fn decimal_difference(p: Point, q: Point) -> Vec2 {
    Vec2::new(decimal_sum(p.x, -q.x), decimal_sum(p.y, -q.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Options, Shape, approximate};

    fn circle(relative: bool) -> String {
        let shape = Shape::Circle(Circle::new((0.0, 0.0), 50.0).unwrap());
        data(
            [&approximate(&shape, &Options::default()).unwrap().curve],
            relative,
        )
    }

    #[test]
    fn a_circle_has_no_redundant_separator() {
        assert_eq!(
            circle(false),
            "M50 0C50 27.596 27.596 50 0 50C-27.596 50-50 27.596-50 0C-50-27.596-27.596-50 0-50C27.596-50 50-27.596 50 0Z"
        );
    }

    #[test]
    fn relative_coordinates_add_up_in_decimals() {
        assert_eq!(
            circle(true),
            "M50 0c0 27.596-22.404 50-50 50c-27.596 0-50-22.404-50-50c0-27.596 22.404-50 50-50c27.596 0 50 22.404 50 50z"
        );
    }
}
