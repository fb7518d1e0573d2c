//! Where the search for a count begins and ends, and what decides about a curve, by known answers and by trial.

use super::*;
use kurbo::{ParamCurve, Point};

use crate::angle::Angle;
use crate::approximate::approximate_between;
use crate::approximate::within::by_formula;
use crate::curve::Curve;
use crate::joints::Cut;
use crate::{Arc, Circle, Ellipse};

fn circle(radius: f64) -> Shape {
    Shape::Circle(Circle::new((0.0, 0.0), radius).unwrap())
}

fn ellipse(radii: (f64, f64)) -> Shape {
    Shape::Ellipse(Ellipse::new((0.0, 0.0), radii, Angle::ZERO).unwrap())
}

fn arc(radii: (f64, f64), start: f64, sweep: f64) -> Shape {
    let [start, sweep] = [start, sweep].map(Angle::from_degrees);
    Shape::Arc(Arc::new((0.0, 0.0), radii, Angle::ZERO, start, sweep).unwrap())
}

/// An arc between these ends, to the last digit.
fn between(radius: f64, from: (f64, f64), to: (f64, f64)) -> Shape {
    let text = format!(
        "M{} {}A{radius} {radius} 0 0 1 {} {}",
        from.0, from.1, to.0, to.1
    );
    let arc = crate::shape::endpoint::parse_svg_arc(&text).unwrap();
    arc.shape().unwrap()
}

fn options(rule: impl Into<Rule>, precision: Option<Precision>) -> Options {
    Options {
        rule: rule.into(),
        precision,
        ..Options::default()
    }
}

fn request<'a>(shape: &'a Shape, options: &'a Options) -> Request<'a> {
    Request::new(shape, options).unwrap().unwrap()
}

#[test]
fn the_least_count_of_a_circle_is_that_by_trial() {
    let shape = circle(100.0);
    for method in Method::ALL {
        if method.card().law.is_none() {
            continue;
        }
        let options = options(method, None);
        let request = request(&shape, &options);
        for exponent in 0..12 {
            let tolerance = 3.0 * libm::pow(10.0, -f64::from(exponent));
            let is_within = |count: usize| {
                let span = Span::from_degrees(360.0 / count as f64);
                let error = options.rule.radial_error(&span);
                error.is_ok_and(|error| error.peak() <= 1.1 * tolerance / 100.0)
            };
            let count = request.least_count(tolerance);
            if count > MOST_SEGMENTS {
                assert!(!is_within(MOST_SEGMENTS), "{method:?} {tolerance}");
                continue;
            }
            assert!(is_within(count), "{method:?} {tolerance}: {count}");
            let is_least = count == 1 || !is_within(count - 1);
            assert!(is_least, "{method:?} {tolerance}: {count}");
            // The leading term alone says as many, or one more or less.
            let about = request.count_by_order(1.1 * tolerance / 100.0);
            assert!(about.abs_diff(count) <= 1, "{about} {count}");
        }
    }
}

#[test]
fn what_rounding_may_bring_nearer_is_its_last_decimal_or_a_tenth() {
    assert_eq!(rounding(Some(Precision::Fixed(3)), 0.5), 1e-3);
    assert_eq!(rounding(Some(Precision::Full), 0.5), 0.05);
    assert_eq!(rounding(None, 0.5), 0.05);
    let shape = circle(100.0);
    let fixed = |decimals| options(Rule::default(), Some(Precision::Fixed(decimals)));
    for (tolerance, expected) in [(0.009, Some(2)), (0.011, None)] {
        let options = fixed(2);
        let found = request(&shape, &options).too_few_decimals(tolerance);
        assert_eq!(found, expected);
    }
    // A quarter errs 0.0196 % of the radius, a third 0.11 %.
    let full = options(Rule::default(), Some(Precision::Full));
    assert_eq!(least_count(&shape, &full, 0.0197), Some(4));
}

#[test]
fn tolerances_that_no_curve_meets_are_refused_by_what_they_are() {
    let shape = circle(100.0);
    let options = options(Rule::default(), None);
    let request = request(&shape, &options);
    for tolerance in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let refused = request.fewest(Tolerance::Absolute(tolerance)).err();
        assert!(matches!(refused, Some(Error::NotPositive { .. })));
    }
    let refused = request.check_tolerance(1e-14);
    assert!(matches!(refused, Err(Error::ToleranceOutOfReach { .. })));
    assert!(request.check_tolerance(1e-12).is_ok());
}

#[test]
fn methods_without_an_order_are_counted_from_one_on() {
    let shape = circle(100.0);
    for (method, tolerances) in [
        (Method::LancasterBest, &[10.0, 1.0, 0.1, 0.01][..]),
        (Method::LancasterDrawellipse, &[10.0, 1.0, 0.1]),
    ] {
        assert_eq!(method.card().law, None);
        let options = options(method, None);
        for &tolerance in tolerances {
            let is_within = |count: &usize| {
                let span = Span::from_degrees(360.0 / *count as f64);
                let error = options.rule.radial_error(&span);
                error.is_ok_and(|error| error.peak() <= 1.1 * tolerance / 100.0)
            };
            let count = request(&shape, &options).least_count(tolerance);
            assert_eq!(Some(count), (1..10).find(is_within), "{tolerance}");
        }
    }
}

#[test]
fn the_least_count_ends_with_the_most_segments() {
    let shape = circle(1.0);
    // A method of second order needs as many for 1e-12 or so; what serves none is said to need more.
    let method = Method::ALL
        .into_iter()
        .find(|method| method.card().law.is_some_and(|law| law.order == 2));
    let options = options(method.unwrap(), Some(Precision::Full));
    let request = request(&shape, &options);
    let error = |count: usize| {
        let span = Span::from_degrees(360.0 / count as f64);
        options.rule.radial_error(&span).unwrap().peak()
    };
    let exact = |tolerance: f64| tolerance / (1.0 + ROUNDING_SHARE);
    let last = error(MOST_SEGMENTS);
    assert!(last > 1e-14);
    let nearly = request.least_count(exact(1.001 * last));
    assert!(
        nearly > MOST_SEGMENTS - 502 && nearly < MOST_SEGMENTS - 498,
        "{nearly}"
    );
    assert_eq!(
        request.least_count(exact((1.0 + 1e-7) * last)),
        MOST_SEGMENTS
    );
    assert_eq!(request.least_count(exact(0.999 * last)), MOST_SEGMENTS + 1);
    let counts = request.counts(exact(0.999 * last));
    assert!(counts.is_empty());
}

#[test]
fn counts_begin_where_a_rule_may_serve() {
    let (closed, open) = (circle(10.0), arc((10.0, 10.0), 0.0, 200.0));
    for tolerance in [1e-3, 1e-6] {
        let options = options(Method::Chen1, None);
        // On an open arc ends have the circle's derivatives, and half as many may do.
        for (shape, parts) in [(&closed, 1), (&open, 2)] {
            let request = request(shape, &options);
            let least = request.least_count(tolerance);
            assert_eq!(*request.counts(tolerance).start(), least / parts);
        }
    }
    let flat = ellipse((10.0, 5.0));
    for (method, shape, first, last) in [
        (Method::LancasterBest, &closed, 1, 8),
        (Method::LancasterDrawellipse, &closed, 4, 4),
        (Method::MinimaxEllipseFree, &flat, 4, 4),
    ] {
        let counts = request(shape, &options(method, None)).counts(1e-3);
        assert_eq!(counts, first..=last, "{method:?}");
    }
    // On a circle it is as any other, which tries twice as many as the estimate and a few.
    let counts = request(&closed, &options(Method::MinimaxEllipseFree, None)).counts(1e-3);
    assert!(*counts.start() > 4 && *counts.end() == 2 * counts.start() + MOST_BEYOND_TWICE);
    // A handle of 0.5523 is a quarter's: a few more than 4 segments.
    for (k, last) in [
        (4.0 / 3.0 * (f64::sqrt(2.0) - 1.0), 7),
        (0.265_216_489_839_54, 11),
    ] {
        let options = options(Rule::Handle(k + 1e-12), None);
        let counts = request(&closed, &options).counts(1e-3);
        assert_eq!((*counts.start(), *counts.end()), (1, last - 1), "{k}");
    }
}

#[test]
fn joints_that_rounding_moves_too_far_are_not_drawn() {
    let has_joint_beyond = |shape: &Shape, count: usize, tolerance: f64| {
        let options = options(Rule::default(), Some(Precision::Fixed(0)));
        let request = request(shape, &options);
        let joints = Joints::equal(&request.outline.unit, count).unwrap();
        request.has_joint_beyond(&joints, tolerance)
    };
    // A quarter of this circle ends 0.3 from the grid, eight joints lie 0.4 from it or less.
    assert!(has_joint_beyond(&circle(10.3), 4, 0.29));
    assert!(!has_joint_beyond(&circle(10.3), 4, 0.31));
    assert!(!has_joint_beyond(&circle(10.0), 4, 1e-9));
    assert!(!has_joint_beyond(&circle(10.0), 4, 1e-15));
    assert!(has_joint_beyond(&circle(10.0), 1000, 0.2));
    // The first joint of a closed shape is looked at, the ends of an arc are not.
    assert!(has_joint_beyond(&circle(10.3), 1, 0.2));
    assert!(!has_joint_beyond(&arc((10.3, 10.3), 0.0, 180.0), 1, 0.2));
    assert!(has_joint_beyond(&arc((10.3, 10.3), 0.0, 180.0), 2, 0.2));
}

#[test]
fn marched_joints_are_asked_for_by_their_count() {
    for radii in [(100.0, 40.0), (100.0, 2.0)] {
        let options = options(Rule::default(), None);
        let shape = ellipse(radii);
        let request = request(&shape, &options);
        let balance = Balance::new(&request.outline, options.rule).unwrap();
        let marched = Marched::new(&balance, 1e-5);
        let least = marched.least_count().unwrap();
        let mut found = 0;
        for count in least..least + 4 {
            for joints in marched.of_count(count) {
                assert_eq!(joints.count(), count);
                found += 1;
            }
        }
        assert!(found > 2, "{radii:?}: {found}");
    }
}

#[test]
fn a_formula_tells_the_peak_of_equal_pieces_of_a_circle() {
    let peak = |shape: &Shape, rule: Rule, angles: Option<&[f64]>| {
        let options = options(rule, None);
        let request = request(shape, &options);
        let unit = &request.outline.unit;
        let joints = match angles {
            None => Joints::equal(unit, 5),
            Some(angles) => {
                let angles: Vec<_> = angles.iter().map(|&x| Angle::from_degrees(x)).collect();
                Joints::at(unit, &angles)
            }
        };
        request.peak_by_formula(&joints.unwrap())
    };
    let minimax = Rule::default();
    let span = Span::from_degrees(72.0);
    let expected = 3.0 * minimax.radial_error(&span).unwrap().peak();
    assert_eq!(peak(&circle(3.0), minimax, None), Some(expected));
    assert_eq!(peak(&ellipse((3.0, 2.0)), minimax, None), None);
    assert_eq!(
        peak(&circle(3.0), minimax, Some(&[0.0, 100.0, 200.0])),
        None
    );
    // Its lengths depend on the neighbours.
    assert_eq!(peak(&circle(3.0), Method::Chen1.into(), None), None);
}

#[test]
fn ends_stay_where_a_path_goes_on() {
    let shape = between(5.0, (0.4, 0.3), (3.3, 4.6));
    let options = options(Rule::default(), Some(Precision::Fixed(0)));
    let ends = |drawing: &crate::Drawing| {
        let segments = &drawing.curve.segments;
        [segments[0].start(), segments[segments.len() - 1].end()]
    };
    let kept = approximate_between(&shape, &options).unwrap();
    assert_eq!(ends(&kept), [Point::new(0.4, 0.3), Point::new(3.3, 4.6)]);
    let rounded = crate::approximate(&shape, &options).unwrap();
    assert_eq!(ends(&rounded), [Point::new(0.0, 0.0), Point::new(3.0, 5.0)]);
}

#[test]
fn rounding_moves_ends_as_far_as_it_says() {
    let moved = |shape: &Shape, decimals: u8, keeps_ends: bool| {
        let options = options(Rule::default(), Some(Precision::Fixed(decimals)));
        Request {
            keeps_ends,
            ..request(shape, &options)
        }
        .ends_moved()
    };
    let given = between(5.0, (0.4, 0.3), (3.1, 4.0));
    assert!((moved(&given, 0, false) - 0.5).abs() < 1e-12);
    assert_eq!(moved(&given, 0, true), 0.0);
    // The start of this arc lies on the grid, and its end at (5, 8.66...).
    let open = arc((10.0, 10.0), 0.0, 60.0);
    for keeps_ends in [false, true] {
        let expected = 9.0 - 10.0 * libm::sin(core::f64::consts::FRAC_PI_3);
        assert!((moved(&open, 0, keeps_ends) - expected).abs() < 1e-12);
    }
    let open = arc((10.0, 10.0), 30.0, 60.0);
    assert!((moved(&open, 0, false) - 0.339_745_962_155_613_6).abs() < 1e-12);
    assert_eq!(moved(&circle(0.4), 0, false), 0.0);
}

#[test]
fn a_long_arc_that_rounds_to_a_point_is_refused() {
    for (radius, sweep, decimals, is_refused) in [
        (0.001, 300.0, 0, true),
        (0.3, 300.0, 0, true),
        (0.6, 300.0, 0, false),
        (0.004, 200.0, 2, true),
        (0.006, 200.0, 2, false),
    ] {
        let precision = Some(Precision::Fixed(decimals));
        let drawn = crate::approximate(
            &arc((radius, radius), 0.0, sweep),
            &options(Rule::default(), precision),
        );
        let refused = matches!(drawn, Err(Error::Collapsed { .. }));
        assert_eq!(refused, is_refused, "{radius} {sweep}");
    }
}

#[test]
fn bounds_decide_where_they_can() {
    let options = Options {
        cut: Cut::Count(8),
        precision: Some(Precision::Full),
        ..Options::default()
    };
    let told = |shape: &Shape, part: f64| {
        let request = request(shape, &options);
        let mut sketch = request.sketch().unwrap();
        let curve = sketch.rounded();
        let peak = radial::error(&curve.segments, &request.outline.truth).peak();
        let certain = request.is_within_for_certain(&mut sketch, &curve, part * peak);
        (request.by_bounds(&curve.segments, part * peak), certain)
    };
    let shape = ellipse((100.0, 60.0));
    for (part, expected) in [
        (0.5, Some(false)),
        (0.95, Some(false)),
        (1.0, None),
        (1.07, Some(true)),
        (2.0, Some(true)),
    ] {
        let (by_bounds, certain) = told(&shape, part);
        assert_eq!(by_bounds, expected, "{part}");
        assert_eq!(certain, part > 1.0, "{part}");
    }
    // What is stated afterwards must not be beyond.
    assert!(!told(&shape, 1.0 + 0.5e-9).1 && told(&shape, 1.0 + 3e-9).1);
}

#[test]
fn a_tolerance_of_a_few_roundings_is_decided_by_the_error_itself() {
    let shape = ellipse((1e6, 6e5));
    let options = options(Rule::default(), Some(Precision::Full));
    let request = request(&shape, &options);
    let joints = Joints::equal(&request.outline.unit, 120).unwrap();
    let mut sketch = request.cut(joints, None, None).unwrap();
    let curve = sketch.rounded();
    let peak = radial::error(&curve.segments, &request.outline.truth).peak();
    assert!(peak < 1000.0 * 8.0 * f64::EPSILON * request.reach());
    let mut decided = |part: f64| request.is_within_for_certain(&mut sketch, &curve, part * peak);
    assert!(decided(1.0) && !decided(0.999));
}

#[test]
fn bounds_know_a_centre_that_follows_from_ends_to_half_the_digits() {
    let options = options(Rule::default(), Some(Precision::Full));
    let shape = between(5.0, (0.0, 0.0), (3.0, 4.0));
    let request = request(&shape, &options);
    let curve = request.sketch().unwrap().rounded();
    let reach = request.reach();
    for (part, expected) in [(0.5e-6, None), (2e-6, Some(true))] {
        let curve = Curve {
            // Exact but for rounding: an arc of this circle in 64 pieces.
            segments: request.equal(64, None).unwrap().rounded().segments,
            ..curve.clone()
        };
        assert_eq!(
            request.by_bounds(&curve.segments, part * reach),
            expected,
            "{part}"
        );
    }
}

#[test]
fn a_formula_decides_but_for_what_rounding_moves() {
    let fixed = Precision::Fixed(3);
    let decides = |peak: f64, reach: f64, tolerance: f64| by_formula(peak, fixed, reach, tolerance);
    // Rounding to 3 decimals moves a point by 0.000707, and coordinates of 1e12 are rounded by 0.00178 before that.
    for (reach, moved) in [(1.0, 0.000_707_2), (1e12, 0.002_484)] {
        assert_eq!(decides(0.1, reach, 0.1 + 1.001 * moved), Some(true));
        assert_eq!(decides(0.1, reach, 0.1 + 0.999 * moved), None);
        assert_eq!(decides(0.1, reach, 0.1 - 0.999 * moved), None);
        assert_eq!(decides(0.1, reach, 0.1 - 1.001 * moved), Some(false));
    }
    assert_eq!(by_formula(0.1, Precision::Full, 1.0, 1.0), None);
}
