//! G-code: rapid moves (G0), lines (G1), arcs with growing (G3) and falling (G2) angles, their centres relative to where they start (I J).

use core::f64::consts::PI;
use core::fmt::Write as _;

use kurbo::{Point, Vec2};

use crate::contour::Closeness;
use crate::course::{CircularArc, Course, CourseStep};
use crate::error::{Error, FormatError, Remedy, Result, positive};
use crate::number::{Precision, compact, counted, rounded_up, significant, text};
use crate::numeric::functions::power;

/// The part of the size of a course by which rounding may move it where no decimals were asked for.
const ROUNDING_PART: f64 = 1e-6;

/// The most decimals before all digits are written.
const MOST_DECIMALS: u8 = 12;

/// The most chords in place of an arc whose centre is too far away.
const MOST_CHORDS: usize = 1_000_000;

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
/// Where the feed is not positive and finite, and where the precision that is asked for moves lines or the ends of arcs farther than [`Options::closeness`] lets it.
pub fn program(title: &str, courses: &[Course], options: &Options) -> Result<String> {
    options
        .feed
        .map_or(Ok(0.0), |feed| positive("feed", feed))?;
    let Program {
        courses,
        precision,
        moved,
    } = Program::new(courses, options)?;
    let told = told(precision, moved, options.closeness);
    let mut out = format!("({}, {told})\nG17 G90\n", comment(title));
    let mut feed = options.feed.map(|feed| format!(" F{}", text(feed)));
    for course in &courses {
        let course = course.rounded(precision);
        // Writing to a string cannot fail.
        let _ = writeln!(out, "G0 {}", at(course.start));
        let mut from = course.start;
        for step in &moving(&course) {
            let _ = match step {
                CourseStep::Line(_) | CourseStep::Elliptical(_) => {
                    write!(out, "G1 {}", at(step.to()))
                }
                CourseStep::Arc(arc) => {
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

/// The steps without the lines of which rounding left no length; one of them stays where there is nothing else.
fn moving(course: &Course) -> Vec<CourseStep> {
    let mut from = course.start;
    let moves = |step: &&CourseStep| {
        let before = core::mem::replace(&mut from, step.to());
        matches!(step, CourseStep::Arc(_)) || from != before
    };
    let mut steps: Vec<CourseStep> = course.steps.iter().filter(moves).copied().collect();
    if steps.is_empty() {
        steps.extend(course.steps.first());
    }
    steps
}

/// Courses as they are drawn.
struct Program {
    courses: Vec<Course>,
    precision: Precision,
    /// How far lines and arcs are moved.
    moved: [f64; 2],
}

impl Program {
    /// With the fewest decimals that keep within the tolerance. Arcs whose centres would need more become lines where a chord is near
    /// enough, and several lines where no decimals are enough, or those that were asked for.
    fn new(courses: &[Course], options: &Options) -> Result<Self> {
        let first = options.precision.unwrap_or_else(|| automatic(courses));
        let precisions = match first {
            Precision::Fixed(decimals) if options.precision.is_none() => {
                let fixed = (decimals..=MOST_DECIMALS.max(decimals)).map(Precision::Fixed);
                fixed.chain([Precision::Full]).collect()
            }
            _ => vec![first],
        };
        let rooms = options.closeness.map_or([f64::INFINITY; 2], |closeness| {
            [closeness.lines.room, closeness.arcs.room]
        });
        let drawn = |most| {
            let mut precisions = precisions.iter();
            precisions.find_map(|precision| Self::within(courses, *precision, rooms, most))
        };
        drawn(1)
            .or_else(|| drawn(MOST_CHORDS))
            .ok_or(Error::Format {
                format: "gcode",
                why: FormatError::Decimals,
                remedy: Remedy::MoreDecimalsOrTolerance,
            })
    }

    /// With this precision, and so many chords in place of an arc at most, unless lines or arcs move farther than they may.
    fn within(
        courses: &[Course],
        precision: Precision,
        rooms: [f64; 2],
        most: usize,
    ) -> Option<Self> {
        let mut moved = [0.0_f64; 2];
        let mut drawn = Vec::with_capacity(courses.len());
        for course in courses {
            let mut steps = Vec::with_capacity(course.steps.len());
            let rounded = course.rounded(precision);
            let (mut old_from, mut from) = (course.start, rounded.start);
            for (old, new) in course.steps.iter().zip(&rounded.steps) {
                let ends = [(old_from, from), (old.to(), new.to())];
                let shift = ends
                    .map(|(old, new)| old.distance(new))
                    .into_iter()
                    .fold(0.0, f64::max);
                let (mut kind, mut off) = (0, shift);
                if let (CourseStep::Arc(old), CourseStep::Arc(arc)) = (old, new) {
                    (kind, off) = (1, old.strayed(arc, from, shift));
                    if off > rooms[1] || off == f64::INFINITY {
                        let room = rooms[1] - shift;
                        off = shift + chords(old, old_from, precision, room, most, &mut steps)?;
                    } else {
                        steps.push(*new);
                    }
                } else {
                    steps.push(*new);
                }
                if off > rooms[kind] {
                    return None;
                }
                moved[kind] = moved[kind].max(off);
                (old_from, from) = (old.to(), new.to());
            }
            drawn.push(Course { steps, ..rounded });
        }
        Some(Self {
            courses: drawn,
            precision,
            moved,
        })
    }
}

/// Appends the fewest chords that lie within this distance of an arc, their inner ends rounded, and gives how far they do; `None` where they
/// are more than `most`.
fn chords(
    arc: &CircularArc,
    from: Point,
    precision: Precision,
    room: f64,
    most: usize,
    steps: &mut Vec<CourseStep>,
) -> Option<f64> {
    let (sweep, chord) = (arc.sweep.radians(), arc.to - from);
    if chord == Vec2::ZERO {
        return None;
    }
    let rounding = precision.farthest_moved();
    let sagitta = |count: usize| {
        let sine = libm::sin(sweep / (4.0 * count as f64));
        2.0 * arc.radius * sine * sine
    };
    let off = |count| sagitta(count) + if count > 1 { rounding } else { 0.0 };
    let least = libm::sqrt(sweep * sweep * arc.radius / (8.0 * (room - rounding).max(0.0))).ceil();
    let count = if off(1) <= room && sweep.abs() < PI {
        1
    } else {
        (least as usize).max(2)
    };
    if count > most || off(count) > room {
        return None;
    }
    // In the frame of the chord, so that a centre far away takes no digits.
    let radius = 0.5 * chord.hypot2().sqrt() / libm::sin(0.5 * sweep);
    let across = Vec2::new(chord.y, -chord.x) / chord.hypot2().sqrt();
    for i in 1..count {
        let at = sweep * (i as f64 / count as f64);
        let [sine, other] = [at, sweep - at].map(|angle| libm::sin(0.5 * angle));
        let along = 2.0 * radius * sine * libm::cos(0.5 * (sweep - at)) / chord.hypot2().sqrt();
        let p = from + chord * along + across * (2.0 * radius * sine * other);
        steps.push(CourseStep::Line(precision.round_point(p)));
    }
    steps.push(CourseStep::Line(precision.round_point(arc.to)));
    Some(off(count))
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
                CourseStep::Line(_) | CourseStep::Elliptical(_) => {
                    (step.to() - from).hypot2().sqrt()
                }
                CourseStep::Arc(arc) => arc.radius,
            });
            from = step.to();
            largest = largest.max(from.x.abs()).max(from.y.abs());
        }
    }
    Precision::moving_at_most(ROUNDING_PART * size, largest)
}

/// How closely the program follows what was given.
fn told(precision: Precision, moved: [f64; 2], closeness: Option<Closeness>) -> String {
    let [lines, arcs] = closeness.map_or([0.0; 2], |near| [near.lines.error, near.arcs.error]);
    if lines.max(arcs) > 0.0 {
        let error = (lines + moved[0]).max(arcs + moved[1]);
        return format!("within {}", significant(rounded_up(error, 3), 3));
    }
    let moved = moved[0].max(moved[1]);
    let Precision::Fixed(decimals) = precision else {
        return "exact".to_owned();
    };
    let rounding = format!(
        "exact but for rounding to {}",
        counted(decimals.into(), "decimal")
    );
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
mod tests;
