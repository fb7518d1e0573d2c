//! Right answers at the edges that a small slip in the source would move: each test fails under a change that others did not notice.

use curveto::document::{Options, convert};
use curveto::joints::{Joints, MOST_SEGMENTS};
use curveto::measure::radial::distance;
use curveto::measure::{self, Reference};
use curveto::number::Precision;
use curveto::shape::UnitArc;
use curveto::shape::endpoint::{from_bulge, parse_svg_arc, through};
use curveto::{Angle, Arc, Circle, Cut, Drawing, Ellipse, Method, Shape, Tolerance, approximate};
use kurbo::{ParamCurve, Point};

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
fn the_centre_of_a_chord_that_is_long_keeps_its_digits() {
    for i in 0..1000_u32 {
        let half = 0.9 + 0.09 * f64::from(i) / 1000.0;
        let arc = parse_svg_arc(&format!("M0 0A1 1 0 0 1 {} 0", 2.0 * half)).unwrap();
        let center = arc.shape().unwrap().outline().unwrap().truth.center;
        // 1 - half², rounded once.
        let true_distance = (-half.mul_add(half, -1.0)).sqrt();
        let off = center.y.abs() / true_distance - 1.0;
        assert!(off.abs() < 6e-16, "{half}: {off:e}");
    }
}

#[test]
fn a_centre_that_is_too_far_is_refused() {
    let (from, to) = (Point::new(9e149, 0.0), Point::new(9e149, 1e149));
    // Radii of 2.5e149, and the centre at 6.5e149 or beyond 1e150.
    assert!(from_bulge(from, to, 0.1).is_ok());
    assert!(from_bulge(from, to, -0.1).is_err());
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
    let text = "<!DOCTYPE svg [<!ENTITY a '5'><!ENTITY b '&a;'><!ENTITY c '&b;'>]><svg><circle r='&c;'/></svg>";
    let converted = convert(text, &Options::default()).unwrap();
    assert!(converted.text.contains("d='M5 0C5 "), "{}", converted.text);
}

#[test]
fn both_ends_of_an_axis_keep_the_digits_of_the_radius() {
    let text = "<svg><ellipse rx='12.3456789' ry='3.123456789'/></svg>";
    let converted = convert(text, &Options::default()).unwrap().text;
    for end in [
        "12.3456789 0",
        "-12.3456789 0",
        "0 3.123456789",
        "0-3.123456789",
    ] {
        assert!(converted.contains(end), "{end}: {converted}");
    }
}

#[test]
fn coordinates_are_not_given_more_decimals_than_they_have() {
    assert_eq!(Precision::moving_at_most(1e-9, 1e12), Precision::Full);
    assert_eq!(Precision::moving_at_most(1e-3, 1e12), Precision::Fixed(3));
}

/// The drawing of this cut, by a method.
fn drawn(shape: &Shape, method: Method, cut: Cut) -> Drawing {
    let options = curveto::Options {
        rule: method.into(),
        cut,
        ..curveto::Options::default()
    };
    approximate(shape, &options).unwrap()
}

#[test]
fn a_count_that_only_rounding_brings_within_is_found() {
    for radius in (1..60).map(|i| 7.3 * f64::from(i)) {
        let shape = Shape::Circle(Circle::new((0.0, 0.0), radius).unwrap());
        for (method, count) in [
            (Method::Midpoint, 4),
            (Method::Midpoint, 6),
            (Method::Curvature, 5),
        ] {
            let written = drawn(&shape, method, Cut::Count(count));
            let tolerance = Tolerance::Absolute(written.error.peak());
            let ours = drawn(&shape, method, Cut::Tolerance(tolerance));
            assert!(ours.curve.segments.len() <= count, "{method:?} {radius}");
        }
    }
}

#[test]
fn the_mean_error_has_its_digits_where_a_tip_lies_between_joints() {
    let (start, sweep) = (Angle::from_degrees(20.0), Angle::from_degrees(180.0));
    let arc = Arc::new((0.0, 0.0), (1.0, 0.001), Angle::ZERO, start, sweep);
    let drawing = drawn(&Shape::Arc(arc.unwrap()), Method::Minimax, Cut::Count(4));
    let outline = drawing.outline.unwrap();
    let found = measure::report(&drawing.curve, &Reference::from(&outline), None).unwrap();
    let count = 50_000;
    let sum: f64 = (drawing.curve.segments.iter())
        .flat_map(|segment| {
            let middles = (0..count).map(move |i| (f64::from(i) + 0.5) / f64::from(count));
            middles.map(|t| distance(&outline.truth, segment.eval(t)).abs())
        })
        .sum();
    let mean = sum / (4.0 * f64::from(count));
    assert!((found.error.mean / mean - 1.0).abs() < 1e-4, "{mean}");
}

#[test]
fn a_flat_ellipse_by_chens_equal_pieces_takes_the_fewest() {
    for (flat, tolerance) in [(0.1, 1.0), (0.1, 0.1), (0.5, 1e-2), (0.02, 0.5)] {
        let radii = (100.0, 100.0 * flat);
        let shape = Shape::Ellipse(Ellipse::new((0.0, 0.0), radii, Angle::ZERO).unwrap());
        let ours = drawn(
            &shape,
            Method::Chen1,
            Cut::Tolerance(Tolerance::Absolute(tolerance)),
        );
        let within = |count: &usize| {
            drawn(&shape, Method::Chen1, Cut::Count(*count))
                .error
                .peak()
                <= tolerance
        };
        assert_eq!(
            Some(ours.curve.segments.len()),
            (3..400).find(within),
            "{flat} {tolerance}"
        );
    }
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
        let notes = converted.notes.iter().map(|note| note.reason.to_string());
        let said: Vec<String> = notes.collect();
        assert!(said.len() == 1, "{said:?}");
        assert!(said[0].contains("coordinates are too large"), "{said:?}");
    }
}

#[test]
fn an_entity_that_expands_too_far_is_called_so() {
    let doubled = |i: usize| format!("<!ENTITY a{i} '&a{};&a{};'>", i - 1, i - 1);
    let entities: String = (1..40).map(doubled).collect();
    let text = format!(
        "<!DOCTYPE svg [<!ENTITY a0 'a'>{entities}]><svg><circle r='1' class='&a39;'/></svg>"
    );
    let converted = convert(&text, &Options::default()).unwrap();
    assert_eq!(converted.text, text);
    let said = converted.notes[0].reason.to_string();
    assert!(said.contains("expands too far to be read"), "{said}");
    assert_eq!(converted.notes[0].reason.code(), "script");
}
