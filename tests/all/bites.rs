//! Right answers at the edges that a small slip in the source would move: each test fails under a change that others did not notice.

use curveto::document::{Options, convert};
use curveto::joints::{Joints, MOST_SEGMENTS};
use curveto::shape::UnitArc;
use curveto::shape::endpoint::{from_bulge, parse_svg_arc, through};
use curveto::{Angle, Circle, Shape};
use kurbo::Point;

use crate::judges::program::run;

fn code(arguments: &[&str]) -> Option<i32> {
    run(arguments).status.code()
}

#[test]
fn the_largest_count_is_served_and_one_more_is_not() {
    let shape = Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap());
    let arc = shape.outline().unwrap().unit;
    assert!(Joints::equal(&arc, MOST_SEGMENTS).is_ok());
    assert!(Joints::equal(&arc, MOST_SEGMENTS + 1).is_err());
}

#[test]
fn a_closed_shape_ends_at_the_very_point_where_it_starts() {
    let shape = Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap());
    let arc = shape.outline().unwrap().unit;
    for start in (0..1000).map(|i| f64::from(i) * 0.37) {
        let angles = [start, start + 100.3, start + 222.2].map(Angle::from_degrees);
        let turned = UnitArc {
            start: angles[0],
            ..arc
        };
        for joints in [Joints::at(&arc, &angles), Joints::equal(&turned, 3)] {
            let joints = joints.unwrap();
            assert_eq!(joints.directions.first(), joints.directions.last());
        }
    }
}

#[test]
fn joints_closer_than_a_billionth_of_a_degree_are_one() {
    assert_eq!(
        code(&["circle", "5", "--joints", "0,90,90.0000000001,180,270"]),
        Some(2)
    );
    assert_eq!(
        code(&["circle", "5", "--joints", "0,90,90.0001,180,270"]),
        Some(0)
    );
}

#[test]
fn a_chord_beyond_the_diameter_is_half_a_turn() {
    let arc = parse_svg_arc("M0 0A1 1 0 0 1 10 0").unwrap();
    let sweep = arc.shape().unwrap().outline().unwrap().unit.sweep.degrees();
    assert_eq!(sweep.abs(), 180.0);
}

#[test]
fn the_centre_of_a_chord_that_is_nearly_the_diameter_keeps_its_digits() {
    // The half chord is 1 - 2^-40 radii, so that the centre lies sqrt(2^-39 - 2^-80) off the chord.
    let half = 1.0 - f64::powi(2.0, -40);
    let arc = parse_svg_arc(&format!("M0 0A1 1 0 0 1 {} 0", 2.0 * half)).unwrap();
    let center = arc.shape().unwrap().outline().unwrap().truth.center;
    let true_distance = (f64::powi(2.0, -40) * (1.0 + half)).sqrt();
    assert!(
        (center.y.abs() / true_distance - 1.0).abs() < 1e-14,
        "{center:?}"
    );
}

#[test]
fn three_points_on_a_line_but_for_their_rounding_are_a_line() {
    let points = [(0.0, 0.0), (0.1, 0.3), (0.3, 0.9)].map(Point::from);
    let shape = through(points[0], points[1], points[2]).unwrap();
    assert!(matches!(shape, Shape::Line(_)), "{shape:?}");
    assert!(through(points[0], points[2], points[1]).is_err());
}

#[test]
fn a_bulge_too_small_for_a_radius_is_a_line() {
    let shape = from_bulge(Point::ORIGIN, Point::new(10.0, 0.0), 1e-310).unwrap();
    assert!(matches!(shape, Shape::Line(_)), "{shape:?}");
}

#[test]
fn entities_may_stand_in_entities() {
    let text =
        "<!DOCTYPE svg [<!ENTITY a '<g/>'><!ENTITY b '&a;&a;'><!ENTITY c '&b;'>]><svg>&c;</svg>";
    assert_eq!(convert(text, &Options::default()).unwrap().text, text);
}

#[test]
fn a_doctype_or_cdata_outside_the_root_is_refused() {
    for text in [
        "<svg/><!DOCTYPE svg>",
        "<svg><!DOCTYPE svg></svg>",
        "<svg/><![CDATA[x]]>",
        "<![CDATA[x]]><svg/>",
    ] {
        assert!(convert(text, &Options::default()).is_err(), "{text}");
    }
}

#[test]
fn a_length_that_is_infinite_is_left() {
    for text in [
        "<svg><circle r='1e999'/></svg>",
        "<svg><circle r='5' cx='1e999'/></svg>",
    ] {
        let converted = convert(text, &Options::default()).unwrap();
        assert_eq!(converted.text, text);
        assert_eq!(converted.notes.len(), 1, "{text}");
    }
}
