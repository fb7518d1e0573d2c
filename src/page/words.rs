//! A shape as words of the command line.

use kurbo::Point;

use crate::angle::Angle;
use crate::number::text;
use crate::shape::Shape;

/// The words that ask for a shape; nothing for a line and for nothing.
pub(super) fn words(shape: &Shape, open: bool) -> Option<String> {
    asked(shape, open, |start, reverse| CourseWords {
        start: start != Angle::ZERO,
        reverse,
    })
}

/// The same where the format is PostScript, whose writer starts whole shapes at 180 degrees and runs the other way round.
pub(super) fn words_ps(shape: &Shape, open: bool) -> Option<String> {
    asked(shape, open, |_, reverse| CourseWords {
        start: true,
        reverse: !reverse,
    })
}

/// Which words for the course of a whole shape are needed.
struct CourseWords {
    start: bool,
    reverse: bool,
}

fn asked(shape: &Shape, open: bool, course: impl Fn(Angle, bool) -> CourseWords) -> Option<String> {
    let mut words = Vec::new();
    let place = |center: Point, rotation: Angle, words: &mut Vec<String>| {
        if rotation != Angle::ZERO {
            words.extend(["--rotation".to_owned(), text(rotation.degrees())]);
        }
        if center != Point::ORIGIN {
            let center = format!("{},{}", text(center.x), text(center.y));
            words.extend(["--center".to_owned(), center]);
        }
    };
    let run = |start: Angle, reverse: bool, words: &mut Vec<String>| {
        let course = course(start, reverse);
        if course.start {
            words.extend(["--start".to_owned(), text(start.degrees())]);
        }
        if course.reverse {
            words.push("--reverse".to_owned());
        }
    };
    match *shape {
        Shape::Circle(c) => {
            words.extend(["circle".to_owned(), text(c.radius)]);
            place(c.center, Angle::ZERO, &mut words);
            run(c.start, c.reverse, &mut words);
        }
        Shape::Ellipse(e) => {
            words.extend(["ellipse".to_owned(), text(e.radii.x), text(e.radii.y)]);
            place(e.center, e.rotation, &mut words);
            run(e.start, e.reverse, &mut words);
        }
        Shape::Arc(a) => {
            words.extend(["arc".to_owned(), text(a.radii.x)]);
            if a.radii.x != a.radii.y {
                words.push(text(a.radii.y));
            }
            words.extend(["--start".to_owned(), text(a.start.degrees())]);
            words.extend(["--sweep".to_owned(), text(a.sweep.degrees())]);
            place(a.center, a.rotation, &mut words);
        }
        Shape::Line(_) | Shape::Empty => return None,
    }
    if open {
        words.push("--open".to_owned());
    }
    Some(words.join(" "))
}
