//! G-code: rapid moves (G0), lines (G1), arcs with growing (G3) and falling (G2) angles, their centres relative to where they start (I J).

use core::fmt::Write as _;

use kurbo::Point;

use crate::contour::Closeness;
use crate::course::{Course, Step};
use crate::error::{Error, Remedy, Result};
use crate::number::{Precision, compact, rounded_up, significant, text};
use crate::numeric::functions::power;

/// The part of the size of a course by which rounding may move it where no decimals were asked for.
const ROUNDING_PART: f64 = 1e-6;

/// The most decimals before all digits are written.
const MOST_DECIMALS: u8 = 12;

/// How a program is written.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// How coordinates and centres are rounded. Without it they have as many decimals as move a point by a millionth of the largest
    /// radius or line, and more where [`Options::closeness`] leaves less.
    pub precision: Option<Precision>,
    /// How fast it moves, in units a minute; without it the machine's own speed holds.
    pub feed: Option<f64>,
    /// How closely the courses follow what was given; without it they are what was given.
    pub closeness: Option<Closeness>,
}

/// A program in absolute coordinates of the plane XY, in the units that the machine is set to. Arcs of ellipses are no part of it: in
/// their place stand lines. Its first comment states how far it may stray from what was given.
///
/// # Errors
///
/// Where the precision that is asked for moves it farther than [`Closeness::room`].
pub fn program(title: &str, courses: &[Course], options: &Options) -> Result<String> {
    let (precision, moved) = precision(courses, options)?;
    let told = told(precision, moved, options.closeness);
    let mut out = format!("({}, {told})\nG17 G90\n", comment(title));
    let mut feed = options.feed.map(|feed| format!(" F{}", text(feed)));
    for course in courses {
        let course = course.rounded(precision);
        // Writing to a string cannot fail.
        let _ = writeln!(out, "G0 {}", at(course.start));
        let mut from = course.start;
        for step in &course.steps {
            let _ = match step {
                Step::Line(_) | Step::Elliptical(_) => write!(out, "G1 {}", at(step.to())),
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
    Ok(out + "M2\n")
}

/// The precision, and how far it moves the courses.
fn precision(courses: &[Course], options: &Options) -> Result<(Precision, f64)> {
    let room = options.closeness.map(|closeness| closeness.room);
    let mut precision = options.precision.unwrap_or_else(|| automatic(courses));
    loop {
        let moved = moved(courses, precision);
        if room.is_none_or(|room| moved <= room) {
            return Ok((precision, moved));
        }
        precision = match precision {
            Precision::Fixed(decimals) if options.precision.is_none() => {
                if decimals < MOST_DECIMALS {
                    Precision::Fixed(decimals + 1)
                } else {
                    Precision::Full
                }
            }
            _ => {
                return Err(Error::Format {
                    format: "gcode",
                    why: "with so few decimals it strays farther than the tolerance".to_owned(),
                    remedy: Remedy::MoreDecimalsOrTolerance,
                });
            }
        };
    }
}

/// A bound of how far rounding moves courses. The radius of an arc is that from the rounded centre to its start, and a machine makes up
/// for another one at its end.
fn moved(courses: &[Course], precision: Precision) -> f64 {
    let mut most = 0.0_f64;
    for course in courses {
        let rounded = course.rounded(precision);
        let (mut from, mut shift) = (rounded.start, course.start.distance(rounded.start));
        for (old, new) in course.steps.iter().zip(&rounded.steps) {
            let end = old.to().distance(new.to());
            let bend = match (old, new) {
                (Step::Arc(old), Step::Arc(new)) => {
                    let radius = from.distance(new.center);
                    old.center.distance(new.center)
                        + (radius - old.radius).abs()
                        + (new.to.distance(new.center) - radius).abs()
                }
                _ => 0.0,
            };
            most = most.max(shift.max(end) + bend);
            (from, shift) = (new.to(), end);
        }
    }
    most
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
                Step::Line(_) | Step::Elliptical(_) => (step.to() - from).hypot2().sqrt(),
                Step::Arc(arc) => arc.radius,
            });
            from = step.to();
            largest = largest.max(from.x.abs()).max(from.y.abs());
        }
    }
    Precision::moving_at_most(ROUNDING_PART * size, largest)
}

/// How closely the program follows what was given.
fn told(precision: Precision, moved: f64, closeness: Option<Closeness>) -> String {
    let error = closeness.map_or(0.0, |closeness| closeness.error);
    if error > 0.0 {
        return format!("within {}", significant(rounded_up(error + moved, 3), 3));
    }
    let Precision::Fixed(decimals) = precision else {
        return "exact".to_owned();
    };
    let s = if decimals == 1 { "" } else { "s" };
    let rounding = format!("exact but for rounding to {decimals} decimal{s}");
    // What is far below the last decimal is noise of the arithmetic that found it.
    if moved * power(10.0, i32::from(decimals)) < 1e-3 {
        return rounding;
    }
    let within = compact(rounded_up(moved, 3), 3);
    format!("{rounding}, which moves it by up to {within}")
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
            &Options {
                precision: Some(Precision::Fixed(2)),
                feed: Some(90.0),
                closeness: None,
            },
        )
        .unwrap();
        assert_eq!(
            program,
            "(A [sliver], exact but for rounding to 2 decimals)\nG17 G90\nG0 X0 Y0\nG1 X1 Y0 F90\n\
             G3 X2 Y1 I0 J1\nG1 X0 Y0\nM2\n"
        );
    }
}
