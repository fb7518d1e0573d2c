//! Programs by known answers.

use super::*;
use crate::angle::Angle;

#[test]
fn an_arc_whose_centre_rounding_moves_too_far_becomes_the_fewest_chords() {
    // A lower half circle whose centre lies halfway between points of the grid.
    let (radius, center) = (5.5, Point::new(5.5, 0.0));
    let half = CircularArc {
        to: Point::new(11.0, 0.0),
        center,
        radius,
        start: Angle::from_degrees(180.0),
        sweep: Angle::from_degrees(180.0),
        ends_given: true,
    };
    let course = Course {
        start: Point::ZERO,
        steps: vec![CourseStep::Arc(half)],
        closed: false,
    };
    let room = 1.0;
    let options = Options {
        precision: Some(Precision::Fixed(0)),
        feed: None,
        closeness: Some(Closeness::exact(room)),
    };
    let text = program("A", &[course], &options).unwrap();
    let place = |line: &str| {
        let (x, y) = line.split_once('X')?.1.split_once(" Y")?;
        Some(Point::new(x.parse().ok()?, y.parse().ok()?))
    };
    let points: Vec<Point> = text.lines().filter_map(place).collect();
    // The sagitta of four is 0.42, of five 0.27, and rounding adds 0.71; the arc would lie up to 1.01 off.
    assert_eq!(text.matches("G1 ").count(), 5, "{text}");
    assert_eq!((points[0], points[5]), (Point::ZERO, half.to));
    for pair in points.windows(2) {
        for i in 0..=50 {
            let off = pair[0].lerp(pair[1], f64::from(i) / 50.0).distance(center) - radius;
            assert!(off.abs() <= room, "{text}");
        }
    }
    let stated = text
        .split_once("up to ")
        .and_then(|(_, rest)| rest.split_once(')'));
    let stated: f64 = stated.unwrap().0.parse().unwrap();
    assert!(stated > 0.97 && stated <= room, "{text}");
}

#[test]
fn a_flat_arc_whose_centre_rounding_moves_too_far_becomes_one_chord() {
    // The centre (1.5, -3) rounds to (2, -3), which is 0.44 nearer to the end than to the start; the sagitta is 0.354.
    let center = Point::new(1.5, -3.0);
    let radius = libm::sqrt(11.25);
    let half = libm::asin(1.5 / radius).to_degrees();
    let arc = CircularArc {
        to: Point::new(3.0, 0.0),
        center,
        radius,
        start: Angle::from_degrees(90.0 + half),
        sweep: Angle::from_degrees(-2.0 * half),
        ends_given: true,
    };
    let course = Course {
        start: Point::ZERO,
        steps: vec![CourseStep::Arc(arc)],
        closed: false,
    };
    let lines = |room: f64| {
        let options = Options {
            precision: Some(Precision::Fixed(0)),
            feed: None,
            closeness: Some(Closeness::exact(room)),
        };
        program("A", core::slice::from_ref(&course), &options).map(|text| {
            let moves = text.lines().filter(|line| line.starts_with('G'));
            moves.skip(2).map(str::to_owned).collect::<Vec<_>>()
        })
    };
    assert_eq!(lines(0.36).unwrap(), ["G1 X3 Y0"]);
    assert_eq!(lines(2.0).unwrap(), ["G2 X3 Y0 I2 J-3"]);
    assert!(lines(0.35).is_err());
}

#[test]
fn where_no_decimals_are_enough_all_digits_are_written() {
    let third = 1.0 / 3.0;
    let course = Course {
        start: Point::ZERO,
        steps: vec![CourseStep::Line(Point::new(third, 0.0))],
        closed: false,
    };
    let options = Options {
        closeness: Some(Closeness::exact(0.0)),
        ..Options::default()
    };
    let text = program("A", &[course], &options).unwrap();
    assert_eq!(
        text,
        format!("(A, exact)\nG17 G90\nG0 X0 Y0\nG1 X{third} Y0\nM2\n")
    );
}

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
            CourseStep::Line(Point::new(1.0, 0.0)),
            CourseStep::Arc(turn),
            CourseStep::Line(Point::ZERO),
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

#[test]
fn a_short_arc_whose_ends_become_one_point_is_no_whole_circle() {
    let degrees = Angle::from_degrees;
    let arc = CircularArc {
        to: (degrees(0.01).direction() * 10.0).to_point(),
        center: Point::ZERO,
        radius: 10.0,
        start: Angle::ZERO,
        sweep: degrees(0.01),
        ends_given: false,
    };
    let course = Course {
        start: Point::new(10.0, 0.0),
        steps: vec![CourseStep::Arc(arc), CourseStep::Line(Point::ZERO)],
        closed: false,
    };
    let options = Options {
        precision: Some(Precision::Fixed(1)),
        ..Options::default()
    };
    let text = program("A", &[course], &options).unwrap();
    assert!(!text.contains("G3"), "{text}");
}
