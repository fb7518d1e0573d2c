//! Right answers where a request meets its limits, and laws that every size obeys.

use std::fmt::Display;

use curveto::approximate::approximate_at_extremes;
use curveto::curve::control_points;
use curveto::joints::Joints;
use curveto::measure::radial::{distance, error};
use curveto::measure::{Reference, report};
use curveto::method::Span;
use curveto::number::Precision;
use curveto::shape::Truth;
use curveto::shape::endpoint::{from_bulge, parse_svg_arc, through};
use curveto::shape::machine::{about_center, from_radius};
use curveto::{
    Angle, Arc, Circle, Cut, Drawing, Ellipse, Error, Method, Options, Rule, Shape, Tolerance,
    approximate,
};
use kurbo::{Affine, CubicBez, ParamCurve, PathSeg, Point, Vec2};

use crate::judges::program::{run, words};
use crate::judges::random::uniform;

fn degrees(degrees: f64) -> Angle {
    Angle::from_degrees(degrees)
}

fn drawn(shape: &Shape, rule: impl Into<Rule>, cut: Cut, precision: Option<Precision>) -> Drawing {
    let options = Options {
        rule: rule.into(),
        cut,
        precision,
        transform: Affine::IDENTITY,
    };
    approximate(shape, &options).unwrap()
}

fn circle(radius: f64) -> Shape {
    Shape::Circle(Circle::new((0.0, 0.0), radius).unwrap())
}

/// An arc of the ellipse whose radii are 100 and a part of that.
fn flat_arc(part: f64, start: f64, sweep: f64) -> Arc {
    let radii = (100.0, 100.0 * part);
    let [none, start, sweep] = [0.0, start, sweep].map(degrees);
    Arc::new((0.0, 0.0), radii, none, start, sweep).unwrap()
}

fn within(tolerance: f64) -> Cut {
    Cut::Tolerance(Tolerance::Absolute(tolerance))
}

/// What the program says, errors too, in one line.
fn said(arguments: &str) -> String {
    let output = run(&words(arguments));
    let both = [output.stdout, output.stderr].concat();
    String::from_utf8(both).unwrap().replace('\n', " ")
}

#[test]
fn the_joints_of_a_hint_are_the_given_ones_and_even_ones_between() {
    for (request, joints) in [
        ("circle 5 --joints 10,200.5", "--joints 10,105.25,200.5"),
        (
            "circle 5 --joints 0,300 -m apprich",
            "--joints 0,100,200,300",
        ),
        ("arc 5 --start 0 --sweep 250 --joints 30", "--joints 30,140"),
        (
            "arc 5 --start 0 --sweep -250 --joints -30",
            "--joints -30,-140",
        ),
    ] {
        let hint = said(request);
        assert!(hint.trim_end().ends_with(joints), "{hint}");
        let (before, _) = request.split_once("--joints").unwrap();
        let rest = request.split_once("-m").map_or("", |(_, rest)| rest);
        let method = if rest.is_empty() {
            String::new()
        } else {
            format!("-m {rest}")
        };
        let followed = format!("{before} {} {method}", joints.replace(' ', "="));
        assert!(said(&followed).starts_with('M'), "{followed}");
    }
}

#[test]
fn a_joint_outside_the_sweep_is_told_the_sweep() {
    for joint in ["100", "10", "90"] {
        let said = said(&format!("arc 5 --start 10 --sweep 80 --joints {joint}"));
        let expected = format!("{joint} degrees is not inside the sweep from 10 to 90 degrees");
        assert!(said.contains(&expected), "{said}");
    }
}

#[test]
fn an_extreme_beside_an_end_is_no_joint() {
    let count = |start: f64, sweep: f64| {
        let arc = Arc::new(
            (0.0, 0.0),
            (5.0, 5.0),
            Angle::ZERO,
            degrees(start),
            degrees(sweep),
        );
        let shape = Shape::Arc(arc.unwrap());
        let options = Options::default();
        let drawing = approximate_at_extremes(&shape, false, &options).unwrap();
        drawing.curve.segments.len()
    };
    for off in [1e-7, -1e-7] {
        assert_eq!(count(10.0, 80.0 + off), 1);
        assert_eq!(count(off, 80.0), 1);
        assert_eq!(count(10.0, 80.0 + 100.0 * off.abs()), 2);
        assert_eq!(count(-100.0 * off.abs(), 80.0), 2);
    }
}

#[test]
fn pieces_between_extremes_stay_alike_where_their_ends_lie_off_the_circle() {
    for place in (1..20).map(f64::from) {
        let center = (0.137 * place, 0.291 * place);
        let shape = Shape::Circle(Circle::new(center, 10.0).unwrap());
        let mut options = Options {
            rule: Method::MinimaxFree.into(),
            precision: Some(Precision::Fixed(2)),
            ..Options::default()
        };
        let one = approximate_at_extremes(&shape, false, &options).unwrap();
        // Rounding leaves some of the quarters within, and the farthest is beyond.
        let tolerance = 0.9999 * one.error.peak();
        options.cut = within(tolerance);
        let drawing = approximate_at_extremes(&shape, false, &options).unwrap();
        let count = drawing.curve.segments.len();
        assert!(count > 4 && count.is_multiple_of(4), "{count}");
        assert!(drawing.error.peak() <= tolerance);
    }
}

#[test]
fn equal_angles_are_equal_but_for_rounding() {
    for method in [
        Method::MinimaxFree,
        Method::MinimaxG0Free,
        Method::QuadraticMinimaxFree,
    ] {
        for count in 1..40 {
            let options = Options {
                rule: method.into(),
                cut: Cut::Count(count),
                precision: Some(Precision::Full),
                ..Options::default()
            };
            let drawing = approximate_at_extremes(&circle(10.0), false, &options).unwrap();
            let segments = &drawing.curve.segments;
            assert_eq!(segments.len(), 4 * count);
            let equal = drawn(
                &circle(10.0),
                method,
                Cut::Count(4 * count),
                options.precision,
            );
            assert!(
                (drawing.error.peak() - equal.error.peak()).abs() < 1e-12,
                "{count}"
            );
            for (before, after) in segments.iter().zip(segments.iter().cycle().skip(1)) {
                assert_eq!(before.end(), after.start(), "{method:?} {count}");
            }
        }
        let uneven = [0.0, 90.0, 180.0, 270.0 + 1e-8].map(degrees).to_vec();
        let options = Options {
            rule: method.into(),
            cut: Cut::At(uneven),
            ..Options::default()
        };
        assert!(approximate(&circle(10.0), &options).is_err());
    }
}

#[test]
fn every_method_cuts_an_ellipse_where_it_can() {
    let ellipse = Ellipse::new((0.0, 0.0), (50.0, 20.0), Angle::ZERO).unwrap();
    for method in Method::ALL {
        let served = |cut| {
            let options = Options {
                rule: method.into(),
                cut,
                ..Options::default()
            };
            let drawing = approximate(&Shape::Ellipse(ellipse), &options);
            drawing.map(|drawing| (drawing.curve.segments.len(), drawing.error.peak()))
        };
        let (equal, adaptive) = (served(Cut::Count(6)), served(Cut::Adaptive(6)));
        assert_eq!(equal.is_ok(), adaptive.is_ok(), "{method:?}");
        if let (Ok((_, equal)), Ok((count, adaptive))) = (equal, adaptive) {
            assert!(
                count == 6 && adaptive <= equal,
                "{method:?}: {adaptive} {equal}"
            );
        }
    }
}

#[test]
fn tolerances_are_positive_and_finite() {
    for text in ["inf", "-1", "0", "-0", "nan", "-inf%", "0%", "%", ""] {
        assert!(text.parse::<Tolerance>().is_err(), "{text}");
    }
    assert_eq!("0.5 %".parse(), Ok(Tolerance::Relative(0.005)));
    assert_eq!("1e-3".parse(), Ok(Tolerance::Absolute(1e-3)));
}

#[test]
fn a_start_is_kept_up_to_a_billion_degrees() {
    for start in [370.0, -725.5, 999_999_999.0, -999_999_999.0] {
        let shape = Shape::Circle(Circle {
            start: degrees(start),
            ..Circle::new((0.0, 0.0), 1.0).unwrap()
        });
        assert_eq!(
            drawn(&shape, Method::Minimax, Cut::Quarters, None).angles[0],
            start
        );
    }
}

#[test]
fn an_arc_of_one_segment_has_no_corner() {
    let quarter = Arc::new(
        (0.0, 0.0),
        (5.0, 5.0),
        Angle::ZERO,
        degrees(0.0),
        degrees(90.0),
    );
    let quarter = Shape::Arc(quarter.unwrap());
    let corner =
        |shape: &Shape| drawn(shape, Method::Minimax, Cut::Count(1), None).largest_corner();
    assert_eq!(corner(&quarter), 0.0);
    assert_eq!(corner(&Shape::Empty), 0.0);
    // Three pieces without tangents in common turn alike at each of three joints, the first point too.
    let three = drawn(
        &circle(5.0),
        Method::QuadraticMinimax,
        Cut::Count(3),
        Some(Precision::Full),
    );
    let all = three.largest_corner();
    let open = Drawing {
        outline: None,
        ..three
    };
    assert!(all > 1.0 && (all - open.largest_corner()).abs() < 1e-9);
}

#[test]
fn a_tolerance_beyond_the_radius_takes_what_the_method_serves() {
    for method in [Method::Minimax, Method::QuadraticMinimax, Method::Midpoint] {
        let drawing = drawn(&circle(1.0), method, within(5.0), None);
        assert_eq!(drawing.curve.segments.len(), 2, "{method:?}");
    }
    let drawing = drawn(&circle(1.0), Method::Apprich, within(5.0), None);
    assert_eq!(drawing.curve.segments.len(), 3);
}

#[test]
fn no_other_method_alone_is_the_remedy_beyond_half_a_turn() {
    for (request, method) in [
        (
            "circle 544 --joints 0,50 -m lancaster-drawellipse",
            "midpoint or minimax",
        ),
        (
            "circle 544 --joints 0,50 -m lancaster-best",
            "midpoint or minimax",
        ),
        (
            "arc 5 --sweep 270 -n 1 -m minimax-free",
            "minimax or midpoint",
        ),
        (
            "circle 5 --joints 0,50 -m quadratic-minimax-free",
            "quadratic-minimax or quadratic-tangent",
        ),
    ] {
        let remedy = format!("hint: take more segments or nearer joints, by -m {method}");
        let told = said(request);
        assert!(told.contains(&remedy), "{request}: {told}");
    }
}

#[test]
fn the_finest_tolerance_that_is_named_serves_when_it_is_typed() {
    let named = |shape: &str| {
        let refusal = said(&format!("{shape} -t 1e-30"));
        let (_, hint) = refusal.split_once(" hint: ").unwrap();
        let finest = hint.strip_prefix("the finest tolerance at this size is about ");
        finest.map(|finest| finest.trim().to_owned())
    };
    for radius in [12.0, 25.0, 64.0, 80846.4, 0.0137, 242.0, 7.77e5] {
        for shape in [
            format!("circle {radius}"),
            format!("circle {radius} --center 900,9 -m minimax-g0"),
            format!("ellipse {radius} {}", radius / 1.5),
            format!("arc {radius} --start 20 --sweep 100"),
        ] {
            let finest = named(&shape).unwrap();
            let drawn = said(&format!("{shape} -t {finest}"));
            assert!(drawn.starts_with('M'), "{shape}: {finest}: {drawn}");
        }
    }
    // Where the method or the decimals stay above it, none is promised.
    for shape in [
        "circle 242 -m lancaster-best",
        "circle 242 -m apprich-plus",
        "ellipse 242 100 -m minimax-ellipse-free",
        "circle 242 --handle 0.55",
        "circle 242 -p 3",
    ] {
        assert_eq!(named(shape), None, "{shape}");
    }
}

#[test]
fn a_tolerance_is_as_fine_as_the_digits_of_the_largest_coordinate() {
    let said_at =
        |x: &str, tolerance: &str| said(&format!("circle 1 --center {x},0 -t {tolerance}"));
    // Eight roundings of a million and one.
    assert!(said_at("1e6", "1.7e-9").contains("finest tolerance at this size is about 1.8e-9"));
    assert!(said_at("1e6", "1.8e-9").starts_with('M'));
    assert!(said_at("0", "1.7e-15").contains("finest"));
    assert!(said_at("0", "1.8e-15").starts_with('M'));
    // Of an arc by its ends they and the way along it are what counts.
    assert!(said("arc --svg M1e6,0A1,1,0,0,1,1000001,1 -t 1e-9").contains("finest"));
    assert!(said("arc --svg M0,0A1e9,1e9,0,0,1,1,1 -t 1e-9").starts_with('M'));
}

#[test]
fn a_fixed_precision_asks_for_no_more_segments_than_all_digits() {
    for (method, tolerance) in [(Method::QuadraticMinimax, 3e-5), (Method::Curvature, 1e-5)] {
        let count = |precision| {
            drawn(&circle(1000.0), method, within(tolerance), precision)
                .curve
                .segments
                .len()
        };
        let least = count(Some(Precision::Full));
        assert!(least > 70 || method == Method::Curvature, "{least}");
        for decimals in [8, 9, 12] {
            assert_eq!(count(Some(Precision::Fixed(decimals))), least, "{decimals}");
        }
    }
}

#[test]
fn a_literal_handle_takes_the_fewest_segments_that_serve() {
    for angle in [90.0, 60.0, 45.0, 20.0, 7.2_f64] {
        let rule = Rule::Handle(4.0 / 3.0 * (angle.to_radians() / 4.0).tan());
        let error = rule
            .radial_error(&Span::from_degrees(angle))
            .unwrap()
            .peak();
        let tolerance = 1.2 * error;
        let full = Some(Precision::Full);
        let drawing = drawn(&circle(1.0), rule, within(tolerance), full);
        let serves = |count: &usize| {
            let options = Options {
                rule,
                cut: Cut::Count(*count),
                precision: full,
                ..Options::default()
            };
            approximate(&circle(1.0), &options).is_ok_and(|d| d.error.peak() <= tolerance)
        };
        let fewest = (1..400).find(serves);
        assert_eq!(Some(drawing.curve.segments.len()), fewest, "{angle}");
    }
}

#[test]
fn a_line_that_rounding_moves_farther_than_the_tolerance_is_refused() {
    let said_of = |tolerance: &str| {
        said(&format!(
            "arc --svg M0,0A0,0,0,0,1,1.4,0 --precision 0 -t {tolerance}"
        ))
    };
    assert!(said_of("0.1").contains("so few decimals take it 0.4 away"));
    assert!(said_of("0.5").starts_with("M0 0L1 0"));
    let moved = said("arc 10 --start 10 --sweep 80 -t 0.01 --precision 0");
    assert!(
        moved.contains("so few decimals take it 0.305 away"),
        "{moved}"
    );
}

#[test]
fn a_small_arc_may_become_level_and_a_shape_may_not() {
    assert!(said("arc --from 0,0 --to 1,0 --bulge 0.1 --precision 0").starts_with('M'));
    assert!(
        said("arc --from 0,0 --to 0.3,0 --bulge 0.1 --precision 0")
            .contains("no more than a point")
    );
    assert!(said("ellipse 3 0.2 --precision 0").contains("no more than a point"));
    assert!(said("ellipse 0.2 3 --precision 0").contains("no more than a point"));
    assert!(said("ellipse 3 0.6 --precision 0").starts_with('M'));
    assert!(said("circle 0.3 --precision 0 -t 0.5").contains("no more than a point"));
    for lost in [
        "spline --points 0,0;.1,.1;.2,0 -p 0",
        "spline --points 0,0;.1,.1;.2,0 -f glif",
        "spline --points 0,0;3,.1;6,0 --ends cyclic -p 0",
        "sphere .1 -p 0",
        "conic --from 0,0 --control .1,.2 --to .3,0 --weight .9 -p 0",
        "conic --from 0,0 --control .1,.2 --to .3,0 --weight 1 -p 0",
        "conic --from 0,0 --control .1,.2 --to .3,0 --weight 3 -p 0",
    ] {
        assert!(said(lost).contains("no more than a point"), "{lost}");
    }
}

#[test]
fn a_line_has_no_extremes_and_is_one_segment() {
    let line = from_bulge(Point::new(1.0, 2.0), Point::new(5.0, 4.0), 0.0).unwrap();
    let options = Options {
        transform: Affine::scale(2.0),
        ..Options::default()
    };
    let drawing = approximate_at_extremes(&line, false, &options).unwrap();
    let [PathSeg::Line(drawn)] = drawing.curve.segments[..] else {
        panic!("{:?}", drawing.curve)
    };
    assert_eq!(
        [drawn.p0, drawn.p1],
        [Point::new(2.0, 4.0), Point::new(10.0, 8.0)]
    );
    assert_eq!(drawing.error.peak(), 0.0);
}

#[test]
fn a_tolerance_that_is_no_distance_is_refused() {
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = Options {
            cut: within(tolerance),
            ..Options::default()
        };
        for drawn in [
            approximate(&circle(5.0), &options),
            approximate_at_extremes(&circle(5.0), false, &options),
        ] {
            let is_refused = matches!(
                drawn,
                Err(Error::NotPositive {
                    what: "tolerance",
                    ..
                })
            );
            assert!(is_refused, "{tolerance}");
        }
    }
}

#[test]
fn the_fewest_of_a_quadrature_that_are_rounded_are_those_by_trial() {
    for (rule, tolerance) in [(Rule::CHEN_2_GAUSS_2, 0.05), (Method::Chen2.into(), 0.02)] {
        let rounded = Some(Precision::Fixed(2));
        let drawing = drawn(&circle(50.0), rule, within(tolerance), rounded);
        let peak = |count| {
            drawn(&circle(50.0), rule, Cut::Count(count), rounded)
                .error
                .peak()
        };
        let fewest = (2..50).find(|&count| peak(count) <= tolerance);
        assert_eq!(Some(drawing.curve.segments.len()), fewest, "{tolerance}");
    }
}

#[test]
fn rounds_of_chords_are_those_of_each_angle() {
    let joints = [0.0, 30.0, 90.0, 150.0, 270.0].map(degrees).to_vec();
    let drawing = drawn(&circle(10.0), Rule::CHEN_2_GAUSS_2, Cut::At(joints), None);
    let rounds = drawing.lengths().unwrap();
    let chord = |angle: f64| 20.0 * (angle.to_radians() / 2.0).sin();
    let arc = |angle: f64| 10.0 * angle.to_radians();
    let sizes = [30.0, 60.0, 60.0, 120.0, 90.0];
    for (i, size) in sizes.into_iter().enumerate() {
        assert!((rounds[0][i] - chord(size)).abs() < 1e-12, "{size}");
        // The last one nearly that of the arc, and longer than the chord.
        let last = rounds[rounds.len() - 1][i];
        assert!((last / arc(size) - 1.0).abs() < 0.05, "{size}: {last}");
    }
    assert!(rounds.iter().all(|row| row.len() == 5 && row[1] == row[2]));
    let other = drawn(&circle(10.0), Method::Minimax, Cut::Quarters, None);
    assert_eq!(other.lengths(), None);
    let many = drawn(&circle(10.0), Rule::CHEN_2_GAUSS_2, Cut::Count(1001), None);
    assert_eq!(many.lengths(), None);
    let most = drawn(&circle(10.0), Rule::CHEN_2_GAUSS_2, Cut::Count(1000), None);
    let rounds = most.lengths().unwrap();
    assert!(
        rounds
            .iter()
            .all(|row| row.iter().all(|&length| length == row[0]))
    );
}

/// The start and the sweep of a circular arc.
fn course(shape: &Shape) -> [f64; 2] {
    let Shape::Arc(arc) = shape else {
        panic!("{shape:?}");
    };
    [arc.start.degrees(), arc.sweep.degrees()]
}

#[test]
fn machines_arcs_run_as_they_are_told() {
    let (origin, right) = (Point::ORIGIN, Point::new(10.0, 0.0));
    for (to, sweep) in [
        ((0.0, 10.0), 90.0),
        ((-10.0, 0.0), 180.0),
        ((0.0, -10.0), 270.0),
    ] {
        for (reverse, expected) in [(false, sweep), (true, sweep - 360.0)] {
            let [start, found] = course(&about_center(right, to.into(), origin, reverse).unwrap());
            assert!(
                start.abs() < 1e-12 && (found - expected).abs() < 1e-12,
                "{to:?} {found}"
            );
        }
    }
    for (reverse, expected) in [(false, 360.0), (true, -360.0)] {
        for (from, start) in [(right, 0.0), (Point::new(0.0, -10.0), -90.0)] {
            let found = course(&about_center(from, from, origin, reverse).unwrap());
            assert_eq!(found, [start, expected]);
        }
    }
    // Half a chord of 6 is a radius of 6 and of what rounding makes of it, and no less.
    let (from, to) = (Point::new(-6.0, 0.0), Point::new(6.0, 0.0));
    for radius in [6.0, 5.9995, 5.9941] {
        for large in [false, true] {
            let [_, sweep] = course(&from_radius(from, to, radius, large, false).unwrap());
            assert!((sweep - 180.0).abs() < 1e-6, "{radius}");
        }
    }
    assert!(from_radius(from, to, 5.993, false, false).is_err());
    // A thousandth of large radii, 0.0015 of small ones, and a tenth of the least.
    let radii = |half: f64, radius: f64| {
        from_radius(
            Point::new(-half, 0.0),
            Point::new(half, 0.0),
            radius,
            false,
            false,
        )
        .is_ok()
    };
    for (half, served, refused) in [
        (1000.0, 999.01, 998.9),
        (1.0, 0.9986, 0.9984),
        (0.01, 0.0091, 0.0089),
    ] {
        assert!(radii(half, served) && !radii(half, refused), "{half}");
    }
}

#[test]
fn refusals_name_what_was_given() {
    for (request, why) in [
        ("--from -6,0 --to 6,0 --radius 5", "they are 12 apart"),
        (
            "--through 1,1 1,1 2,2",
            "two of the three points are the same",
        ),
        (
            "--through 2,2 1,1 1,1",
            "two of the three points are the same",
        ),
        ("--through 1,1 1,1 1,1", "three points are the same"),
    ] {
        let said = said(&format!("arc {request}"));
        assert!(said.contains(why), "{said}");
    }
    assert!(!said("arc --through 1,1 1,1 2,2").contains(": three"));
}

#[test]
fn the_ends_of_an_arc_go_through_a_map_as_they_are() {
    let arc = parse_svg_arc("M0.1 0.2A5 5 0 0 1 3.3 4.4")
        .unwrap()
        .shape()
        .unwrap();
    let options = Options {
        transform: Affine::new([2.0, 0.0, 1.0, 3.0, 7.0, 9.0]),
        ..Options::default()
    };
    let curve = approximate(&arc, &options).unwrap().curve;
    let end = curve.segments.last().unwrap().end();
    for (found, expected) in [(curve.start().unwrap(), (7.4, 9.6)), (end, (18.0, 22.2))] {
        assert!(found.distance(expected.into()) < 1e-14, "{found}");
    }
}

#[test]
fn three_points_on_a_circle_give_it() {
    for (start, on, end) in [
        (10.0, 50.0, 120.0),
        (10.0, 200.0, 350.0),
        (80.0, 20.0, -130.0),
    ] {
        let at = |angle: f64| {
            let (sin, cos) = f64::to_radians(angle).sin_cos();
            Point::new(1000.0 + 7.0 * cos, -50.0 + 7.0 * sin)
        };
        let shape = through(at(start), at(on), at(end)).unwrap();
        let truth = shape.outline().unwrap().truth;
        let [from, sweep] = course(&shape);
        assert!((truth.radii.x - 7.0).abs() < 1e-9, "{truth:?}");
        assert!(truth.center.distance(Point::new(1000.0, -50.0)) < 1e-9);
        assert!(
            (from - start).abs() < 1e-9 && (sweep - (end - start)).abs() < 1e-9,
            "{sweep}"
        );
    }
    let found = course(&through((3.0, 1.0).into(), (1.0, 1.0).into(), (3.0, 1.0).into()).unwrap());
    assert_eq!(found, [0.0, 360.0]);
}

/// Shapes whose lengths are multiplied by a factor.
fn shapes(factor: f64) -> Vec<Shape> {
    let p = |x: f64, y: f64| Point::new(factor * x, factor * y);
    let svg = |text: &str| {
        let mut arc = parse_svg_arc(text).unwrap();
        (arc.from, arc.to, arc.radii) = (
            p(arc.from.x, arc.from.y),
            p(arc.to.x, arc.to.y),
            arc.radii * factor,
        );
        arc.shape().unwrap()
    };
    let radii = (50.0 * factor, 20.0 * factor);
    let arc = Arc::new(
        p(-7.0, 9.0),
        radii,
        degrees(30.0),
        degrees(40.0),
        degrees(-170.0),
    );
    vec![
        Shape::Circle(Circle::new(p(3.0, 4.0), 50.0 * factor).unwrap()),
        Shape::Ellipse(Ellipse::new(p(0.0, 0.0), radii, degrees(0.0)).unwrap()),
        Shape::Ellipse(Ellipse::new(p(3.0, 4.0), (factor, 30.0 * factor), degrees(25.0)).unwrap()),
        Shape::Arc(arc.unwrap()),
        svg("M10 20A30 30 0 0 1 50 60"),
        svg("M10 20A30 30 0 1 0 50 60"),
        svg("M10 20A5 5 0 0 1 50 60"),
        svg("M10 20A90 40 20 1 1 50 60"),
        through(p(1.0, 2.0), p(5.0, 7.0), p(11.0, 3.0)).unwrap(),
        from_bulge(p(1.0, 2.0), p(5.0, 7.0), 0.3).unwrap(),
        about_center(p(10.0, 0.0), p(10.0, 0.0), p(3.0, 0.0), false).unwrap(),
    ]
}

#[test]
fn lengths_multiplied_by_a_power_of_two_are_multiplied_to_the_last_bit() {
    let near = Affine::new([1.001, 0.002, -0.003, 0.999, 0.01, -0.02]);
    for factor in [f64::powi(2.0, 20), f64::powi(2.0, -20)] {
        for (shape, scaled) in shapes(1.0).iter().zip(&shapes(factor)) {
            for (method, cut) in [
                (Method::Minimax, 4),
                (Method::Curvature, 3),
                (Method::QuadraticMinimax, 7),
            ] {
                let full = Some(Precision::Full);
                let one = drawn(shape, method, Cut::Count(cut), full);
                let other = drawn(scaled, method, Cut::Count(cut), full);
                let what = format!("{shape:?} {method:?} {factor}");
                for (a, b) in one.curve.segments.iter().zip(&other.curve.segments) {
                    for (p, q) in control_points(a).iter().zip(control_points(b)) {
                        assert_eq!([p.x * factor, p.y * factor], [q.x, q.y], "{what}");
                    }
                }
                let tolerance = |factor| within(factor * 1.3 * one.error.peak());
                let cut = [
                    drawn(shape, method, tolerance(1.0), full),
                    drawn(scaled, method, tolerance(factor), full),
                ];
                assert_eq!(cut[0].angles, cut[1].angles, "{what}");
                // As it was drawn, and as others draw.
                for map in [
                    Affine::IDENTITY,
                    near,
                    Affine::scale(1.5),
                    Affine::scale(0.01),
                ] {
                    let [a, b] = [(&one, 1.0), (&other, factor)].map(|(drawing, factor)| {
                        let map = Affine::scale(factor) * map * Affine::scale(1.0 / factor);
                        let segments: Vec<PathSeg> =
                            drawing.curve.segments.iter().map(|s| map * *s).collect();
                        error(&segments, &drawing.outline.unwrap().truth)
                    });
                    // But for what the decimals of coordinates up to 128 leave.
                    let near =
                        |a: f64, b: f64| (a - b / factor).abs() < 128.0 * f64::EPSILON + 1e-14 * a;
                    assert!(
                        near(a.outward, b.outward) && near(a.inward, b.inward),
                        "{what} {map:?}: {a:?} {b:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_quadratic_is_measured_as_the_cubic_that_it_is() {
    let truth = shapes(1.0)[1].outline().unwrap().truth;
    let whole = drawn(
        &shapes(1.0)[1],
        Method::QuadraticMinimax,
        Cut::Count(6),
        Some(Precision::Full),
    );
    for segment in &whole.curve.segments {
        let line = PathSeg::Line(kurbo::Line::new(segment.start(), segment.end()));
        for segment in [*segment, line] {
            let [a, b] = [segment, PathSeg::Cubic(segment.to_cubic())].map(|s| error(&[s], &truth));
            assert!((a.peak() / b.peak() - 1.0).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
}

#[test]
fn joints_that_are_given_are_those_of_the_drawing() {
    let arc = shapes(1.0)[3].outline().unwrap().unit;
    let joints = Joints::at(&arc, &[degrees(0.0), degrees(-100.0)]).unwrap();
    assert_eq!(joints.angles, [40.0, 0.0, -100.0, -130.0]);
    assert_eq!(joints.sign, -1.0);
    let closed = shapes(1.0)[0].outline().unwrap().unit;
    let joints = Joints::at(&closed, &[degrees(30.0), degrees(200.0), degrees(10.0)]).unwrap();
    assert_eq!(joints.angles, [30.0, 200.0, 370.0, 390.0]);
}

#[test]
fn no_cut_that_can_be_asked_for_has_fewer_segments() {
    for method in [Method::MinimaxG0, Method::Minimax, Method::Curvature] {
        for (flat, start, sweep) in [
            (0.3, 20.0, 200.0),
            (0.05, 70.0, 140.0),
            (0.01, -50.0, 300.0),
            (0.7, 5.0, 80.0),
        ] {
            let shape = Shape::Arc(flat_arc(flat, start, sweep));
            for exponent in 0..8 {
                let tolerance = 7.7 * libm::pow(10.0, -0.6 * f64::from(exponent));
                let ours = drawn(&shape, method, within(tolerance), None);
                let count = ours.curve.segments.len();
                assert!(ours.error.peak() <= tolerance);
                for cut in [Cut::Adaptive(count - 1), Cut::Count(count - 1)] {
                    let options = Options {
                        rule: method.into(),
                        cut,
                        ..Options::default()
                    };
                    let fewer = approximate(&shape, &options);
                    let is_within = fewer.is_ok_and(|fewer| fewer.error.peak() <= tolerance);
                    assert!(!is_within, "{method:?} {flat} {start} {tolerance} {count}");
                }
            }
        }
    }
}

#[test]
fn errors_are_alike_wherever_a_shape_starts() {
    for (flat, start, sweep, counts) in [
        (0.5, 0.0, 360.0, [8, 9]),
        (0.5, 20.0, 360.0, [8, 9]),
        (0.5, 90.0, 360.0, [7, 12]),
        (0.3, 45.0, 360.0, [12, 16]),
        (0.3, 10.0, 200.0, [6, 9]),
        (0.4, -60.0, 120.0, [4, 5]),
        (0.4, 60.0, -120.0, [4, 5]),
    ] {
        let arc = flat_arc(flat, start, sweep);
        for count in counts {
            let shape = Shape::Arc(arc);
            let full = Some(Precision::Full);
            let drawing = drawn(&shape, Method::Minimax, Cut::Adaptive(count), full);
            let truth = drawing.outline.unwrap().truth;
            let peaks = drawing
                .curve
                .segments
                .iter()
                .map(|s| error([s], &truth).peak());
            let (least, most) = peaks.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
            assert!(
                most < 1.01 * least,
                "{flat} {start} {count}: {}",
                most / least
            );
        }
    }
}

#[test]
fn what_is_stated_does_not_hang_on_how_a_shape_is_given() {
    for factor in [1.0, f64::powi(2.0, 30)] {
        for shape in shapes(factor) {
            let outline = shape.outline().unwrap();
            let maps = [
                Affine::IDENTITY,
                Affine::FLIP_X,
                Affine::rotate(0.7),
                Affine::new([0.8, 0.3, 0.9, -0.4, 5.0, 6.0]),
                Affine::new([-0.2, 1.1, 0.6, 0.5, 1.0, -3.0]),
            ];
            for map in maps {
                let options = Options {
                    cut: Cut::Count(2),
                    precision: Some(Precision::Full),
                    transform: map,
                    ..Options::default()
                };
                let drawing = approximate(&shape, &options).unwrap();
                let what = format!("{shape:?} {map:?}");
                let outline = drawing.outline.unwrap();
                // The same ellipse by its centre, radii and axis alone.
                let Truth {
                    center,
                    radii,
                    axis,
                    ..
                } = outline.truth;
                let plain = error(&drawing.curve.segments, &Truth::new(center, radii, axis));
                let measured = report(&drawing.curve, &Reference::from(&outline), None).unwrap();
                let mut alone = outline;
                alone.truth = Truth::new(center, radii, axis);
                let mean = report(&drawing.curve, &Reference::from(&alone), None)
                    .unwrap()
                    .error
                    .mean;
                assert!(
                    (measured.error.mean / mean - 1.0).abs() < 1e-6,
                    "{what}: {mean}"
                );
                let tiny = 1e-11 * factor;
                let stated = [drawing.error.outward, drawing.error.inward];
                assert!(drawing.error.peak() > 1e-9 * radii.x, "{what}");
                for other in [
                    [plain.outward, plain.inward],
                    [measured.error.outward, measured.error.inward],
                ] {
                    for (a, b) in stated.into_iter().zip(other) {
                        assert!((a - b).abs() < tiny, "{what}: {a} {b}");
                    }
                }
            }
            // On a circle it is what the formula says.
            if outline.truth.is_circle() {
                let drawing = drawn(
                    &shape,
                    Method::Minimax,
                    Cut::Count(4),
                    Some(Precision::Full),
                );
                let span = Span::from_degrees(outline.unit.sweep.degrees().abs() / 4.0);
                let formula = Method::Minimax.radial_error(&span).unwrap().peak();
                let relative = drawing.error.peak() / outline.truth.radii.x;
                assert!(
                    (relative - formula).abs() < 1e-12,
                    "{shape:?}: {relative} {formula}"
                );
            }
        }
    }
}

#[test]
fn a_sheared_circle_is_cut_by_its_own_axes() {
    for map in [
        Affine::new([0.8, 0.3, 0.9, -0.4, 5.0, 6.0]),
        Affine::new([0.8, 0.3, -0.9, 0.9, 5.0, 6.0]),
        Affine::new([0.3, 1.0, 0.4, 0.5, 0.0, 0.0]),
    ] {
        for count in [9, 14] {
            let options = Options {
                cut: Cut::Adaptive(count),
                precision: Some(Precision::Full),
                transform: map,
                ..Options::default()
            };
            let drawing = approximate(&circle(10.0), &options).unwrap();
            let truth = drawing.outline.unwrap().truth;
            let peaks = drawing
                .curve
                .segments
                .iter()
                .map(|s| error([s], &truth).peak());
            let (least, most) = peaks.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
            assert!(most < 1.01 * least, "{map:?} {count}: {}", most / least);
        }
    }
}

#[test]
fn a_small_distance_has_its_digits_where_a_curve_goes_far() {
    // A chord so near a tangent that it lies hardly within the circle, of which all that goes far is outside.
    for exponent in [5, 7, 9, 12] {
        let x = 1.0 - f64::powi(10.0, -exponent);
        let depth = f64::powi(10.0, -exponent);
        let at = |y: f64| Point::new(x, y);
        for [a, b, c, d] in [
            [-1.0, -0.5, 0.25, 1.0],
            [-0.7, 0.9, 1.0, 1.3],
            [-3.0, -1.0, 1.0, 3.0],
        ] {
            for segment in [
                PathSeg::Line(kurbo::Line::new(at(a), at(d))),
                PathSeg::Quad(kurbo::QuadBez::new(at(a), at(b), at(d))),
                PathSeg::Cubic(CubicBez::new(at(a), at(b), at(c), at(d))),
            ] {
                let truth = Truth::circle(Point::ORIGIN, 1.0);
                let inward = error([&segment], &truth).inward;
                let off = inward / depth - 1.0;
                assert!(
                    (0.0..1e-11).contains(&off),
                    "{exponent} {segment:?}: {off:e}"
                );
            }
        }
    }
}

#[test]
fn a_quarter_by_four_digits_errs_as_mpmath_says() {
    let [p0, p1, p2, p3] = [(1.0, 0.0), (1.0, 0.5519), (0.5519, 1.0), (0.0, 1.0)].map(Point::from);
    let quarter = [PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3))];
    let stated = error(&quarter, &Truth::circle(Point::ORIGIN, 1.0));
    for (stated, expected) in [
        (stated.outward, 0.000_193_329_468_972_379_37),
        (stated.inward, 0.000_204_044_410_810_791_57),
    ] {
        let off = stated / expected - 1.0;
        assert!((0.0..1e-13).contains(&off), "{stated}: {off:e}");
    }
}

#[test]
fn three_points_are_a_line_for_the_digits_of_their_coordinates_only() {
    let arc = |x: f64, size: f64, height: f64| {
        let points = [(x, 0.0), (x + 0.5 * size, height), (x + size, 0.0)].map(Point::from);
        matches!(through(points[0], points[1], points[2]), Ok(Shape::Arc(_)))
    };
    assert!(arc(1e6, 1e-3, 1e-4) && arc(1e6, 1e-3, 1e-8));
    assert!(arc(0.0, 1e-3, 1e-18) && arc(0.0, 1e3, 1e-11));
    assert!(!arc(1e6, 1e-3, 1e-10) && !arc(0.0, 1e-3, 1e-19) && !arc(0.0, 1e3, 1e-13));
}

#[test]
fn an_open_arc_by_chens_first_method_takes_the_fewest() {
    for (sweep, tolerance) in [(300.0, 1e-3), (90.0, 1e-5), (200.0, 0.3), (40.0, 1e-7)] {
        let arc = Arc::new(
            (0.0, 0.0),
            (10.0, 10.0),
            degrees(0.0),
            degrees(5.0),
            degrees(sweep),
        );
        let shape = Shape::Arc(arc.unwrap());
        let full = Some(Precision::Full);
        let ours = drawn(&shape, Method::Chen1, within(tolerance), full);
        let serves = |count: &usize| {
            let options = Options {
                rule: Method::Chen1.into(),
                cut: Cut::Count(*count),
                precision: full,
                ..Options::default()
            };
            approximate(&shape, &options).is_ok_and(|d| d.error.peak() <= tolerance)
        };
        let fewest = (1..300).find(serves);
        assert_eq!(
            Some(ours.curve.segments.len()),
            fewest,
            "{sweep} {tolerance}"
        );
    }
}

#[test]
fn decimals_are_the_fewest_that_add_no_more_than_a_tenth() {
    for method in Method::ALL {
        for radius in [0.7, 13.0, 2100.0] {
            let shape = circle(radius);
            let exact = drawn(&shape, method, Cut::Count(4), Some(Precision::Full));
            let written = drawn(&shape, method, Cut::Count(4), None);
            let Precision::Fixed(decimals) = written.precision else {
                panic!("{method:?} {radius}");
            };
            let moved = libm::pow(10.0, -f64::from(decimals)) / f64::sqrt(2.0);
            let allowed = 0.1 * exact.error.peak();
            assert!(
                moved <= allowed * (1.0 + 1e-9),
                "{method:?} {radius}: {decimals}"
            );
            assert!(
                decimals == 0 || 10.0 * moved > allowed,
                "{method:?} {radius}: {decimals}"
            );
        }
    }
}

/// The largest f between 0 and 1: of many places, the neighbourhood of each that is higher than the next ones by halving.
fn largest(f: impl Fn(f64) -> f64) -> f64 {
    let count = 96;
    let values: Vec<f64> = (0..=count).map(|i| f(i as f64 / count as f64)).collect();
    let before = |i: usize| i.checked_sub(1).map_or(f64::MIN, |i| values[i]);
    let after = |i: usize| values.get(i + 1).copied().unwrap_or(f64::MIN);
    let climb = |i: usize| {
        let (mut best, mut top) = (i as f64 / count as f64, values[i]);
        let mut step = 0.5 / count as f64;
        while step > 1e-13 {
            let around = [best - step, best + step].map(|t: f64| t.clamp(0.0, 1.0));
            match around.into_iter().find(|&t| f(t) > top) {
                Some(t) => (best, top) = (t, f(t)),
                None => step /= 2.0,
            }
        }
        top
    };
    let tops = (0..=count).filter(|&i| values[i] >= before(i) && values[i] >= after(i));
    tops.map(climb).fold(f64::MIN, f64::max)
}

/// What is stated on either side is the largest of many places, but for what those may be off: below it, above it by a part of itself, and more.
fn assert_stated(
    round: impl Display,
    curve: CubicBez,
    truth: &Truth,
    [below, part, more]: [f64; 3],
) {
    let at = |t: f64| distance(truth, curve.eval(t));
    let (outward, inward) = (largest(at), largest(|t| -at(t)));
    let stated = error(&[PathSeg::Cubic(curve)], truth);
    for (stated, true_one) in [(stated.outward, outward), (stated.inward, inward)] {
        let true_one = true_one.max(0.0);
        let what = format!("{round}: {stated:e} for {true_one:e}");
        assert!(stated >= true_one - below, "{what}");
        assert!(stated <= true_one * (1.0 + part) + more, "{what}");
    }
}

#[test]
fn what_is_stated_is_the_largest_of_many_places() {
    let mut seed = 4;
    let mut next = || 2.0 * uniform(&mut seed) - 1.0;
    for round in 0..3000 {
        let radii = Vec2::new(1.0, 0.55 + 0.4 * next());
        // From curves that hardly stray to some that a tenth of the smaller radius parts from the ellipse, and beyond.
        let stray = radii.y * libm::exp(-0.5 * f64::from(round % 12));
        let (from, size) = (3.0 * next(), 0.6 + 0.5 * next());
        let k = 4.0 / 3.0 * libm::tan(size / 4.0);
        let at = |angle: f64, along: f64| {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            Vec2::new(cos - along * sin, sin + along * cos)
        };
        let to = from + size;
        let ideal = [at(from, 0.0), at(from, k), at(to, -k), at(to, 0.0)];
        let [p0, p1, p2, p3] = ideal.map(|p| {
            let moved = Vec2::new(next(), next()) * stray * 0.3;
            (Vec2::new(p.x * radii.x, p.y * radii.y) + moved).to_point()
        });
        let curve = CubicBez::new(p0, p1, p2, p3);
        let truth = Truth::new(Point::ORIGIN, radii, Vec2::new(1.0, 0.0));
        assert_stated(round, curve, &truth, [1e-15, 1e-9, 1e-15]);
    }
}

#[test]
fn what_is_stated_of_far_curves_is_the_largest_of_many_places() {
    let mut seed = 8;
    let mut next = || 2.0 * uniform(&mut seed) - 1.0;
    for round in 0..400 {
        // Through the centre, along and across the long axis, round the tips; half of them turned, off the origin.
        let radii = Vec2::new(1.0, [0.9, 0.5, 0.2, 0.05][round % 4]);
        let (turn, shift) = if round % 8 < 4 {
            (0.0, 0.0)
        } else {
            (3.0 * next(), 5.0 * next())
        };
        let axis = Vec2::new(libm::cos(turn), libm::sin(turn));
        let center = Point::new(shift, -shift);
        let reach = [0.3, 1.0, 3.0][round % 3];
        let [p0, p1, p2, p3] = [(); 4].map(|()| {
            let p = Vec2::new(next(), next() * if round % 5 == 0 { 0.1 } else { 1.0 }) * reach;
            center + p.rotate_scale(axis)
        });
        let curve = CubicBez::new(p0, p1, p2, p3);
        let truth = Truth::new(center, radii, axis);
        assert_stated(round, curve, &truth, [1e-14, 1e-8, 1e-13]);
    }
}

#[test]
fn joints_for_a_count_err_no_more_than_equal_ones() {
    let mut fewer = 0;
    for (part, count) in [0.9, 0.3, 0.1, 0.03, 0.01]
        .into_iter()
        .flat_map(|p| (2..10).map(move |n| (p, n)))
    {
        for (start, sweep) in [(0.0, 360.0), (20.0, 200.0)] {
            let shape = Shape::Arc(flat_arc(part, start, sweep));
            let peak = |cut| {
                drawn(&shape, Method::Minimax, cut, Some(Precision::Full))
                    .error
                    .peak()
            };
            let (equal, adaptive) = (peak(Cut::Count(count)), peak(Cut::Adaptive(count)));
            assert!(
                adaptive <= equal,
                "{part} {count} {start}: {adaptive} {equal}"
            );
            fewer += usize::from(adaptive < 0.9 * equal);
        }
    }
    assert!(fewer > 20, "{fewer}");
}

#[test]
fn a_joint_that_is_given_twice_is_told() {
    for sign in [1.0, -1.0] {
        let outline = Shape::Arc(flat_arc(0.5, 10.0, sign * 200.0))
            .outline()
            .unwrap();
        let joints = [40.0, 90.0, 90.0].map(|way| degrees(10.0 + sign * way));
        let refusal = Joints::at(&outline.unit, &joints).unwrap_err().to_string();
        let at = 10.0 + sign * 90.0;
        assert!(refusal.contains(&format!("{at}")), "{refusal}");
    }
}

#[test]
fn dxf_says_exact_of_arcs_that_it_writes_as_such() {
    for (more, is_exact) in [("", true), (" -n 3", false)] {
        let arguments = format!("arc --svg M0,0A5,5,0,0,1,10,0 -f dxf --verbose{more}");
        let output = run(&words(&arguments));
        let stated = String::from_utf8(output.stderr).unwrap();
        assert_eq!(stated.contains("exact"), is_exact, "{stated}");
        assert_eq!(stated.contains("3 segments"), !is_exact, "{stated}");
    }
}
