//! SVG path data: no redundant separator, no exponent, the last point of a closed shape digit for digit the first.

use kurbo::{PathSeg, Point, Vec2};

use crate::course::{Course, Step};
use crate::curve::Curve;
use crate::number::{EightDigits, Precision, decimals_of, push_fixed, push_shortest, round};

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

/// Appends the path data of a curve; a relative one must start a path or follow a closed or finished one.
pub fn push_curve(out: &mut Vec<u8>, curve: &Curve, relative: bool) {
    let Some(start) = curve.start() else { return };
    out.push(b'M');
    push_numbers(out, &[start.x, start.y]);
    let mut current = start;
    for segment in without_closing_line(curve) {
        let (letter, points): (u8, &[Point]) = match segment {
            PathSeg::Line(l) => (b'L', &[l.p1]),
            PathSeg::Quad(q) => (b'Q', &[q.p1, q.p2]),
            PathSeg::Cubic(c) => (b'C', &[c.p1, c.p2, c.p3]),
        };
        push_letter(out, letter, relative);
        let mut numbers = [0.0; 6];
        for (pair, &p) in numbers.chunks_exact_mut(2).zip(points) {
            let v = counted(p, current, relative);
            (pair[0], pair[1]) = (v.x, v.y);
        }
        push_numbers(out, &numbers[..2 * points.len()]);
        current = points[points.len() - 1];
    }
    if curve.closed {
        push_letter(out, b'Z', relative);
    }
}

/// Appends a command's letter, small where it is relative.
fn push_letter(out: &mut Vec<u8>, letter: u8, relative: bool) {
    out.push(if relative {
        letter.to_ascii_lowercase()
    } else {
        letter
    });
}

/// The numbers for a point: itself, or as a relative command counts it from the current one.
fn counted(p: Point, current: Point, relative: bool) -> Vec2 {
    if relative {
        decimal_difference(p, current)
    } else {
        p.to_vec2()
    }
}

/// The path data of courses: lines and circular arcs.
#[must_use]
pub fn data_of_courses<'a>(
    courses: impl IntoIterator<Item = &'a Course>,
    relative: bool,
) -> String {
    let mut out = Vec::new();
    for course in courses {
        push_course(&mut out, course, relative);
    }
    String::from_utf8(out).unwrap_or_default()
}

fn push_course(out: &mut Vec<u8>, course: &Course, relative: bool) {
    out.push(b'M');
    push_numbers(out, &[course.start.x, course.start.y]);
    let mut from = course.start;
    let steps = match course.steps.as_slice() {
        [rest @ .., Step::Line(to)] if course.closed && !rest.is_empty() && *to == course.start => {
            rest
        }
        all => all,
    };
    for step in steps {
        let to = step.to();
        let end = counted(to, from, relative);
        match step {
            Step::Line(_) => {
                push_letter(out, b'L', relative);
                push_numbers(out, &[end.x, end.y]);
            }
            Step::Arc(arc) => {
                let sweep = arc.sweep.degrees();
                let flags = [sweep.abs() > 180.0, sweep > 0.0];
                push_arc(out, [arc.radius, arc.radius, 0.0], flags, end, relative);
            }
            Step::Elliptical(arc) => {
                let numbers = [arc.radii.x, arc.radii.y, arc.rotation.degrees()];
                push_arc(out, numbers, [arc.large_arc, arc.sweep], end, relative);
            }
        }
        from = to;
    }
    if course.closed {
        push_letter(out, b'Z', relative);
    }
}

fn push_arc(
    out: &mut Vec<u8>,
    [rx, ry, turn]: [f64; 3],
    flags: [bool; 2],
    to: Vec2,
    relative: bool,
) {
    push_letter(out, b'A', relative);
    let [large, sweep] = flags.map(|flag| f64::from(u8::from(flag)));
    push_numbers(out, &[rx, ry, turn, large, sweep, to.x, to.y]);
}

/// The segments that are written: a closing operator draws the line to the start by itself.
fn without_closing_line(curve: &Curve) -> &[PathSeg] {
    match curve.segments.as_slice() {
        [rest @ .., PathSeg::Line(last)]
            if curve.closed && !rest.is_empty() && Some(last.p1) == curve.start() =>
        {
            rest
        }
        all => all,
    }
}

/// Appends the absolute path data of a curve, rounding as it writes: the digits are those of [`push_curve`] of the rounded curve.
///
/// Nothing is appended, and the answer is no, where that does not hold: for more than 15 significant digits, for numbers in full,
/// and where some points are `kept` from rounding.
pub(crate) fn push_rounding(
    out: &mut Vec<u8>,
    curve: &Curve,
    precision: Precision,
    kept: bool,
) -> bool {
    let Precision::Fixed(decimals @ 0..=14) = precision else {
        return false;
    };
    if kept {
        return false;
    }
    if let Some(writer) = EightDigits::new(decimals)
        && push_short(out, curve, writer).is_some()
    {
        return true;
    }
    let largest = LARGEST_WHOLE[usize::from(decimals)];
    let cubic = |segment: &PathSeg| match *segment {
        PathSeg::Cubic(c) => Some([c.p1, c.p2, c.p3]),
        _ => None,
    };
    let small = |p: Point| p.x.abs() < largest && p.y.abs() < largest;
    let fits = curve
        .segments
        .iter()
        .all(|segment| cubic(segment).is_some_and(|points| points.into_iter().all(small)));
    let Some(start) = curve.start().filter(|&start| fits && small(start)) else {
        return false;
    };
    let unit = largest / 1e15;
    let push = |out: &mut Vec<u8>, p: Point, first: bool| {
        for (x, separated) in [(p.x, !first), (p.y, true)] {
            // A sign separates as well as a space does; close to zero the digits decide whether one is printed.
            let at = out.len();
            if separated && x > -unit {
                out.push(b' ');
                push_fixed(out, x, decimals);
                if x < 0.0 && out[at + 1] == b'-' {
                    out.remove(at);
                }
            } else {
                push_fixed(out, x, decimals);
            }
        }
    };
    out.reserve(LONGEST_SEGMENT * (curve.segments.len() + 1));
    out.push(b'M');
    push(out, start, true);
    for points in curve.segments.iter().filter_map(cubic) {
        out.push(b'C');
        for (i, p) in points.into_iter().enumerate() {
            push(out, p, i == 0);
        }
    }
    if curve.closed {
        out.push(b'Z');
    }
    true
}

/// As [`push_rounding`] for curves of cubics all of whose numbers have at most eight digits; nothing is appended to `out` otherwise.
fn push_short(out: &mut Vec<u8>, curve: &Curve, writer: EightDigits) -> Option<()> {
    let before = out.len();
    out.resize(before + LONGEST_SEGMENT * (curve.segments.len() + 1), 0);
    let written = write_short(&mut out[before..], curve, writer);
    out.truncate(before + written.unwrap_or(0));
    written.map(drop)
}

/// Writes to the beginning of `text`, which has room for it, and tells where it ends.
fn write_short(text: &mut [u8], curve: &Curve, writer: EightDigits) -> Option<usize> {
    let start = curve.start()?;
    let mut at = 0;
    let mut command = |letter: u8, numbers: &[f64]| {
        text[at] = letter;
        at += 1;
        for (i, &x) in numbers.iter().enumerate() {
            at = writer.write(text, at, x, i > 0)?;
        }
        Some(at)
    };
    let mut end = command(b'M', &[start.x, start.y])?;
    for segment in &curve.segments {
        let PathSeg::Cubic(c) = segment else {
            return None;
        };
        end = command(b'C', &[c.p1.x, c.p1.y, c.p2.x, c.p2.y, c.p3.x, c.p3.y])?;
    }
    if curve.closed {
        end = command(b'Z', &[])?;
    }
    Some(end)
}

/// Room for the text of a segment: six numbers of at most 15 digits with their signs, points and spaces.
const LONGEST_SEGMENT: usize = 120;

/// Below these, numbers with so many decimals have at most 15 significant digits.
const LARGEST_WHOLE: [f64; 15] = [
    1e15, 1e14, 1e13, 1e12, 1e11, 1e10, 1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1,
];

/// Numbers with a space between two only where the second has no sign.
fn push_numbers(out: &mut Vec<u8>, numbers: &[f64]) {
    for (i, &number) in numbers.iter().enumerate() {
        let at = out.len();
        push_shortest(out, number);
        if i > 0 && out[at] != b'-' {
            out.insert(at, b' ');
        }
    }
}

/// The difference of two points as the decimals that they are written as, so that relative coordinates add up to the absolute ones.
fn decimal_difference(p: Point, q: Point) -> Vec2 {
    let difference = |a: f64, b: f64| {
        let decimals = decimals_of(a).max(decimals_of(b));
        if decimals <= 15 {
            round(a - b, decimals)
        } else {
            a - b
        }
    };
    Vec2::new(difference(p.x, q.x), difference(p.y, q.y))
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
