//! Courses and mixed curves, which no command draws by itself.

use kurbo::{CubicBez, Line};

use super::*;
use crate::angle::Angle;

/// The tags of the entities, a code and a value each.
fn entities(trace: Trace<'_>) -> Vec<(u16, String)> {
    let text = drawing("Test", &[(None, trace)]);
    let lines: Vec<&str> = text.lines().collect();
    let tags = lines.chunks(2);
    let tags = tags.map(|tag| (tag[0].trim().parse().unwrap(), tag[1].to_owned()));
    tags.skip_while(|tag| tag.1 != "ENTITIES")
        .take_while(|tag| tag.1 != "ENDSEC")
        .collect()
}

fn values(tags: &[(u16, String)], code: u16) -> Vec<f64> {
    let found = tags.iter().filter(|tag| tag.0 == code);
    found.map(|tag| tag.1.parse().unwrap()).collect()
}

fn arc(to: (f64, f64), center: (f64, f64), start: f64, sweep: f64) -> CourseStep {
    CourseStep::Arc(CircularArc {
        to: to.into(),
        center: center.into(),
        radius: 1.0,
        start: Angle::from_degrees(start),
        sweep: Angle::from_degrees(sweep),
        ends_given: true,
    })
}

#[test]
fn a_closed_course_shares_its_first_vertex_and_keeps_its_last_bulge() {
    // A half disc.
    let course = Course {
        start: Point::new(-1.0, 0.0),
        steps: vec![
            CourseStep::Line(Point::new(1.0, 0.0)),
            arc((-1.0, 0.0), (0.0, 0.0), 0.0, 180.0),
        ],
        closed: true,
    };
    let tags = entities(Trace::Course(course));
    assert!(tags.contains(&(0, "LWPOLYLINE".to_owned())));
    assert_eq!(
        (values(&tags, 90), values(&tags, 70)),
        (vec![2.0], vec![1.0])
    );
    assert_eq!(values(&tags, 10), [-1.0, 1.0]);
    assert_eq!(values(&tags, 42), [1.0]);
}

#[test]
fn a_whole_turn_within_a_course_is_two_halves() {
    let course = Course {
        start: Point::new(0.0, 0.0),
        steps: vec![
            CourseStep::Line(Point::new(1.0, 0.0)),
            arc((1.0, 0.0), (0.0, 0.0), 0.0, -360.0),
        ],
        closed: false,
    };
    let tags = entities(Trace::Course(course));
    assert_eq!(values(&tags, 10), [0.0, 1.0, -1.0, 1.0]);
    assert_eq!(values(&tags, 42), [-1.0, -1.0]);
}

#[test]
fn runs_of_one_degree_are_an_entity_each() {
    let corner = |x: f64| Point::new(x, 0.0);
    let above = |x: f64| Point::new(x, 1.0);
    let cubic = |a, b| PathSeg::Cubic(CubicBez::new(corner(a), above(a), above(b), corner(b)));
    let curve = Curve {
        segments: vec![
            PathSeg::Line(Line::new(corner(0.0), corner(1.0))),
            cubic(1.0, 2.0),
            cubic(2.0, 3.0),
            PathSeg::Line(Line::new(corner(3.0), corner(0.0))),
        ],
        closed: true,
    };
    let tags = entities(Trace::Curve(&curve));
    let names: Vec<&str> = tags
        .iter()
        .filter(|tag| tag.0 == 0)
        .map(|tag| tag.1.as_str())
        .collect();
    assert_eq!(names, ["LINE", "SPLINE", "LINE"]);
    assert_eq!(values(&tags, 73), [7.0]);
}

#[test]
fn the_extents_of_an_arc_are_not_those_of_its_circle() {
    let course = Course {
        start: Point::new(1.0, 0.0),
        steps: vec![
            arc((0.0, 1.0), (0.0, 0.0), 0.0, 90.0),
            arc((0.6, 0.8), (0.0, 0.0), 90.0, -36.9),
        ],
        closed: false,
    };
    let bounds = extent(&Trace::Course(course)).unwrap();
    assert_eq!(bounds, Rect::new(0.0, 0.0, 1.0, 1.0));
}
