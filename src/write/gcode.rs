//! G-code: rapid moves (G0), lines (G1), arcs with growing (G3) and falling (G2) angles, their centres relative to where they start (I J).

use core::fmt::Write as _;

use kurbo::Point;

use crate::course::{Course, Step};
use crate::number::{Precision, text};

/// The part of the size of a course by which rounding may move it where no decimals were asked for.
const ROUNDING_PART: f64 = 1e-6;

/// A program in absolute coordinates of the plane XY, in the units that the machine is set to. `feed` is in those units a minute;
/// without it the machine's own holds. Without a precision coordinates have as many decimals as move a point by a millionth of the
/// largest radius or line.
#[must_use]
pub fn program(
    title: &str,
    courses: &[Course],
    precision: Option<Precision>,
    feed: Option<f64>,
) -> String {
    let precision = precision.unwrap_or_else(|| automatic(courses));
    let mut out = format!("({}, {})\nG17 G90\n", comment(title), exactness(precision));
    let mut feed = feed.map(|feed| format!(" F{}", text(feed)));
    for course in courses {
        let course = course.rounded(precision);
        // Writing to a string cannot fail.
        let _ = writeln!(out, "G0 {}", at(course.start));
        let mut from = course.start;
        for step in &course.steps {
            let _ = match step {
                Step::Line(to) => write!(out, "G1 {}", at(*to)),
                Step::Arc(arc) => {
                    let code = if arc.sweep.degrees() < 0.0 {
                        "G2"
                    } else {
                        "G3"
                    };
                    let [i, j] = [arc.center.x - from.x, arc.center.y - from.y]
                        .map(|x| text(precision.round(x)));
                    write!(out, "{code} {} I{i} J{j}", at(arc.to))
                }
            };
            out.push_str(&feed.take().unwrap_or_default());
            out.push('\n');
            from = step.to();
        }
    }
    out + "M2\n"
}

fn at(p: Point) -> String {
    format!("X{} Y{}", text(p.x), text(p.y))
}

/// The fewest decimals that move no point by more than a millionth of the largest radius or line.
fn automatic(courses: &[Course]) -> Precision {
    let (mut size, mut largest) = (0.0_f64, 0.0_f64);
    for course in courses {
        let mut from = course.start;
        for step in &course.steps {
            size = size.max(match step {
                Step::Line(to) => (*to - from).hypot2().sqrt(),
                Step::Arc(arc) => arc.radius,
            });
            from = step.to();
            largest = largest.max(from.x.abs()).max(from.y.abs());
        }
    }
    Precision::moving_at_most(ROUNDING_PART * size, largest)
}

fn exactness(precision: Precision) -> String {
    match precision {
        Precision::Full => "exact".to_owned(),
        Precision::Fixed(1) => "exact but for rounding to 1 decimal".to_owned(),
        Precision::Fixed(decimals) => format!("exact but for rounding to {decimals} decimals"),
    }
}

/// A comment stands in parentheses, which must not nest.
fn comment(text: &str) -> String {
    text.replace('(', "[").replace(')', "]")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::angle::Angle;
    use crate::course::CircularArc;

    #[test]
    fn a_course_of_several_steps_is_one_run() {
        let turn = CircularArc {
            to: Point::new(2.0, 1.0),
            center: Point::new(1.0, 1.0),
            radius: 1.0,
            start: Angle::from_degrees(270.0),
            sweep: Angle::from_degrees(90.0),
            ends_given: true,
        };
        let course = Course {
            start: Point::ZERO,
            steps: vec![
                Step::Line(Point::new(1.0, 0.0)),
                Step::Arc(turn),
                Step::Line(Point::ZERO),
            ],
            closed: true,
        };
        let program = program(
            "A (sliver)",
            &[course],
            Some(Precision::Fixed(2)),
            Some(90.0),
        );
        assert_eq!(
            program,
            "(A [sliver], exact but for rounding to 2 decimals)\nG17 G90\nG0 X0 Y0\nG1 X1 Y0 F90\n\
             G3 X2 Y1 I0 J1\nG1 X0 Y0\nM2\n"
        );
    }
}
