//! What is measured, held against arbitrary precision and against what is known of the methods.

use crate::judges::oracle;

use curveto::continuity::Continuity;
use curveto::curve::{Curve, control_points};
use curveto::measure::{Quantity, Reference, Report, curvature, fit, profile, report, samples};
use curveto::number::Precision;
use curveto::path;
use curveto::picture::plot::Chart;
use curveto::shape::Truth;
use curveto::write::{self, Image};
use curveto::{
    Angle, Arc, Circle, Cut, Drawing, Ellipse, Method, Options, Rule, Shape, approximate,
};
use kurbo::{Affine, CubicBez, ParamCurve, PathSeg, Point, QuadBez, Vec2};
use oracle::{Real, int, real, to_f64};
use proptest::prelude::*;

fn exact(segment: &PathSeg) -> Vec<[Real; 2]> {
    control_points(segment)
        .iter()
        .map(|p| [real(p.x), real(p.y)])
        .collect()
}

fn close(found: f64, expected: &Real, allowed: f64, what: &str) {
    let expected = to_f64(expected);
    assert!(
        (found - expected).abs() <= allowed,
        "{what}: {found} is not {expected}, by {:e}",
        found - expected
    );
}

fn drawn(shape: Shape, rule: impl Into<Rule>, cut: Cut, transform: Affine) -> Drawing {
    let options = Options {
        rule: rule.into(),
        cut,
        precision: Some(Precision::Full),
        transform,
    };
    approximate(&shape, &options).unwrap()
}

fn measured(drawing: &Drawing) -> Report {
    let outline = drawing.outline.unwrap();
    report(&drawing.curve, &Reference::from(&outline), None).unwrap()
}

fn unit_circle() -> Shape {
    Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap())
}

/// A cubic or a quadratic that somewhat follows the unit circle.
fn about_the_circle() -> impl Strategy<Value = PathSeg> {
    let near = |angle: f64| {
        (-0.2..0.2, -0.2..0.2).prop_map(move |(x, y)| {
            let on = Vec2::from_angle(angle);
            Point::new(on.x + x, on.y + y)
        })
    };
    let cubic = (near(0.0), near(0.5), near(1.0), near(1.5))
        .prop_map(|(a, b, c, d)| PathSeg::Cubic(CubicBez::new(a, b, c, d)));
    let quad = (near(0.0), near(0.6), near(1.2))
        .prop_map(|(a, b, c)| PathSeg::Quad(QuadBez::new(a, b, c)));
    prop_oneof![2 => cubic, 1 => quad]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn error_length_area_and_curvature_are_right_to_a_billionth_of_a_thousandth(segment in about_the_circle()) {
        let curve = Curve { segments: vec![segment], closed: false };
        let found = report(&curve, &Reference::from(Truth::circle(Point::ORIGIN, 1.0)), None).unwrap();
        let points = exact(&segment);
        let (outward, inward) = oracle::radial_extremes(&points, [int(0), int(0)], &int(1));
        close(found.error.outward, &outward, 1e-12, "outward");
        close(found.error.inward, &inward, 1e-12, "inward");
        close(found.error.mean, &oracle::mean_abs_radial_error_t(&points), 1e-12, "mean");
        close(found.error.rms, &oracle::rms_radial_error_t(&points), 1e-12, "rms");
        close(found.length.curve, &oracle::arc_length(&points), 1e-12, "length");
        let sense = found.reference.sweep.signum();
        close(found.area.curve * sense, &oracle::sector_area(&points), 1e-12, "area");
        for (t, at_end) in [(0.0, false), (1.0, true)] {
            let expected = oracle::curvature_derivatives(&points, at_end, 2);
            let here = curvature::at(&segment, t).unwrap().to_array();
            for (order, (value, expected)) in here.iter().zip(&expected).enumerate() {
                let size = to_f64(expected).abs().max(1.0);
                close(*value, expected, 1e-9 * size, &format!("derivative {order} of curvature at {t}"));
            }
        }
    }

    #[test]
    fn the_mean_over_the_angle_is_right_for_what_methods_draw(
        degrees in 5.0..170.0_f64,
        part in 0.97..1.03_f64,
    ) {
        let k = part * 4.0 / 3.0 * (degrees / 4.0).to_radians().tan();
        let arc = Arc::new((0.0, 0.0), (1.0, 1.0), Angle::ZERO, Angle::ZERO, Angle::from_degrees(degrees)).unwrap();
        let drawing = drawn(Shape::Arc(arc), Rule::Handle(k), Cut::Count(1), Affine::IDENTITY);
        let found = measured(&drawing);
        let expected = oracle::mean_abs_radial_error_angle(&exact(&drawing.curve.segments[0]));
        close(found.error.mean_angle, &expected, 1e-13, "mean over the angle");
    }

    #[test]
    fn distances_from_an_ellipse_are_right_to_a_billionth_of_a_thousandth(
        ratio in 0.05..1.0_f64,
        rotation in -90.0..90.0_f64,
        count in 1_usize..6,
        k in 0.9..1.1_f64,
    ) {
        let ellipse = Ellipse::new((3.0, -2.0), (1.0, ratio), Angle::from_degrees(rotation)).unwrap();
        let span = 360.0 / (count + 1) as f64;
        let handle = k * 4.0 / 3.0 * (span / 4.0).to_radians().tan();
        let drawing = drawn(Shape::Ellipse(ellipse), Rule::Handle(handle), Cut::Count(count + 1), Affine::IDENTITY);
        let found = measured(&drawing);
        let (mut outward, mut inward) = (0.0_f64, 0.0_f64);
        for segment in &drawing.curve.segments {
            let (out, inside) = oracle::ellipse_distance_extremes(
                &exact(segment),
                [real(3.0), real(-2.0)],
                [real(1.0), real(ratio)],
                &real(rotation),
            );
            (outward, inward) = (outward.max(to_f64(&out)), inward.max(to_f64(&inside)));
        }
        prop_assert!((found.error.outward - outward).abs() < 1e-12, "{} {outward}", found.error.outward);
        prop_assert!((found.error.inward - inward).abs() < 1e-12, "{} {inward}", found.error.inward);
    }

    #[test]
    fn measures_follow_the_shape_through_place_size_and_turn(
        log_scale in -30.0..30.0_f64,
        turn in 0.0..360.0_f64,
        count in 2_usize..9,
    ) {
        let scale = log_scale.exp();
        let map = Affine::rotate(turn.to_radians()) * Affine::scale(scale);
        let small = measured(&drawn(unit_circle(), Method::Minimax, Cut::Count(count), Affine::IDENTITY));
        let large = measured(&drawn(unit_circle(), Method::Minimax, Cut::Count(count), map));
        let same = |a: f64, b: f64| (a - b).abs() < 1e-14;
        prop_assert!(same(large.error.peak / scale, small.error.peak));
        prop_assert!(same(large.error.mean / scale, small.error.mean));
        prop_assert!((large.length.relative.unwrap() - small.length.relative.unwrap()).abs() < 1e-14);
        prop_assert!((large.area.relative.unwrap() - small.area.relative.unwrap()).abs() < 1e-14);
        prop_assert_eq!(large.continuity.order, small.continuity.order);
    }
}

#[test]
fn joints_have_the_continuity_that_the_catalogue_states() {
    let places = [
        Affine::IDENTITY,
        Affine::rotate(0.3),
        Affine::translate((10.0, -3.0)) * Affine::rotate(1.1),
        Affine::scale(1e-6),
        Affine::scale(1e9),
    ];
    let counts = [3, 4, 5, 8];
    let mut judged = 0;
    for method in Method::ALL {
        for (count, place) in counts
            .iter()
            .flat_map(|n| places.iter().map(move |p| (*n, *p)))
        {
            let options = Options {
                rule: method.into(),
                cut: Cut::Count(count),
                precision: Some(Precision::Full),
                transform: place,
            };
            let Ok(drawing) = approximate(&unit_circle(), &options) else {
                continue;
            };
            let found = measured(&drawing).continuity;
            let stated = method.card().continuity_equal;
            assert_eq!(found.order, Some(stated), "{method} {count} {place:?}");
            judged += 1;
        }
    }
    // Some methods do not serve a third of a turn.
    let all = Method::ALL.len() * counts.len() * places.len();
    assert!(judged > all / 10 * 9, "{judged} of {all}");
}

#[test]
fn uneven_joints_have_the_continuity_that_the_catalogue_states() {
    let joints = [0.0, 50.0, 120.0, 200.0, 300.0].map(Angle::from_degrees);
    for method in Method::ALL {
        let options = Options {
            rule: method.into(),
            cut: Cut::At(joints.to_vec()),
            precision: Some(Precision::Full),
            transform: Affine::IDENTITY,
        };
        let Ok(drawing) = approximate(&unit_circle(), &options) else {
            continue;
        };
        let found = measured(&drawing).continuity.order;
        let stated = method.card().continuity_uneven;
        assert_eq!(found, Some(stated), "{method}");
    }
}

#[test]
fn a_jump_beyond_rounding_lowers_the_order() {
    let drawing = drawn(
        unit_circle(),
        Method::Apprich,
        Cut::Count(4),
        Affine::IDENTITY,
    );
    let order = |shift: f64, point: usize, axis: usize| {
        let mut curve = drawing.curve.clone();
        let mut points = control_points(&curve.segments[1]);
        let p = &mut points[point];
        *(if axis == 0 { &mut p.x } else { &mut p.y }) += shift;
        curve.segments[1] =
            PathSeg::Cubic(CubicBez::new(points[0], points[1], points[2], points[3]));
        let outline = drawing.outline.unwrap();
        report(&curve, &Reference::from(&outline), None)
            .unwrap()
            .continuity
            .order
            .unwrap()
    };
    assert_eq!(order(0.0, 0, 0), Continuity::G4);
    // The second segment starts at (0, 1) with its handle along -x.
    assert_eq!(order(1e-9, 0, 1), Continuity::Apart);
    assert_eq!(order(1e-9, 1, 1), Continuity::G0);
    assert_eq!(order(1e-9, 1, 0), Continuity::G1);
    // What is no larger than the rounding of the coordinates is no jump.
    assert_eq!(order(1e-16, 1, 0), Continuity::G4);
}

#[test]
fn a_stated_coordinate_tolerance_forgives_the_rounding_of_a_printed_path() {
    let options = Options {
        cut: Cut::Count(5),
        precision: Some(Precision::Fixed(3)),
        ..Options::default()
    };
    let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0).unwrap());
    let drawing = approximate(&circle, &options).unwrap();
    let reference = Reference::from(&drawing.outline.unwrap());
    let order = |tolerance| {
        let found = report(&drawing.curve, &reference, tolerance).unwrap();
        found.continuity.order.unwrap()
    };
    assert_eq!(order(None), Continuity::G0);
    assert_eq!(order(Some(0.0005)), Continuity::G2);
}

#[test]
fn the_extremes_of_curvature_are_the_largest_and_least_of_many_samples() {
    // The free method of ellipses has none on a slanted one.
    let methods = Method::ALL.into_iter();
    for method in methods.filter(|&method| method != Method::MinimaxEllipseFree) {
        let options = Options {
            rule: method.into(),
            cut: Cut::Count(4),
            precision: Some(Precision::Full),
            transform: Affine::new([2.0, 0.3, -0.4, 1.0, 5.0, 5.0]),
        };
        let drawing = approximate(&unit_circle(), &options).unwrap();
        let found = measured(&drawing).curvature;
        let (least, largest) = (
            found.least.unwrap().value.unwrap(),
            found.largest.unwrap().value.unwrap(),
        );
        let mut samples = (f64::INFINITY, f64::NEG_INFINITY);
        for segment in &drawing.curve.segments {
            for i in 0..=4000 {
                let k = curvature::at(segment, f64::from(i) / 4000.0).unwrap().value;
                samples = (samples.0.min(k), samples.1.max(k));
            }
        }
        let size = samples.1.abs();
        assert!(
            least <= samples.0 + 1e-12 * size && samples.0 - least < 1e-5 * size,
            "{method}"
        );
        assert!(
            largest >= samples.1 - 1e-12 * size && largest - samples.1 < 1e-5 * size,
            "{method}"
        );
    }
}

#[test]
fn apprich_figures_are_continuous_across_the_joints_and_others_are_not() {
    let jump = |method: Method, quantity| {
        let drawing = drawn(unit_circle(), method, Cut::Count(4), Affine::IDENTITY);
        let reference = Reference::from(&drawing.outline.unwrap());
        let parts = profile::along(&drawing.curve, &reference, quantity, 64);
        parts
            .windows(2)
            .map(|pair| (pair[0].last().unwrap().1 - pair[1][0].1).abs())
            .fold(0.0, f64::max)
    };
    for quantity in [
        Quantity::Curvature,
        Quantity::CurvatureD1,
        Quantity::CurvatureD2,
    ] {
        assert!(jump(Method::Apprich, quantity) < 1e-12, "{quantity}");
    }
    assert!(jump(Method::Minimax, Quantity::CurvatureD1) > 0.1);
}

#[test]
fn area_and_length_methods_keep_what_they_are_named_for() {
    for count in [2, 3, 4, 8] {
        let area = measured(&drawn(
            unit_circle(),
            Method::Area,
            Cut::Count(count),
            Affine::IDENTITY,
        ));
        let length = measured(&drawn(
            unit_circle(),
            Method::Length,
            Cut::Count(count),
            Affine::IDENTITY,
        ));
        assert!(area.area.relative.unwrap().abs() < 4e-16, "{count}");
        assert!(length.length.relative.unwrap().abs() < 1e-15, "{count}");
    }
}

#[test]
fn lancasters_angle_follows_t_within_half_a_degree() {
    let quarter = measured(&drawn(
        unit_circle(),
        Method::Midpoint,
        Cut::Count(4),
        Affine::IDENTITY,
    ));
    // At t = 0.1976764476380797, computed elsewhere with 30 digits.
    let lag = quarter.angle_lag;
    assert!(
        (lag.largest.abs() - 0.420_729_663_319_763_64).abs() < 1e-13,
        "{lag:?}"
    );
    assert!(
        (0.5 - (lag.at.t - 0.5).abs() - 0.197_676_447_638_079_7).abs() < 1e-9,
        "{lag:?}"
    );
    assert!(quarter.angle_lag.largest.abs() < 0.5);
}

#[test]
fn means_over_an_ellipse_are_those_of_the_true_distance() {
    let (rx, ry) = (3.0, 1.25);
    let ellipse = Ellipse::new((0.0, 0.0), (rx, ry), Angle::ZERO).unwrap();
    let drawing = drawn(
        Shape::Ellipse(ellipse),
        Method::Minimax,
        Cut::Count(5),
        Affine::IDENTITY,
    );
    let found = measured(&drawing);
    let (mut mean, mut square) = (int(0), int(0));
    for segment in &drawing.curve.segments {
        let points = exact(segment);
        // The distance changes its sign where the segment crosses the unit circle in the ellipse's own measure.
        let framed: Vec<[Real; 2]> = points
            .iter()
            .map(|[x, y]| [x / real(rx), y / real(ry)])
            .collect();
        let curve = oracle::bezier::Powers::new(&points);
        let distance =
            |t: &Real| oracle::ellipse::signed_distance(&curve.at(t), &[real(rx), real(ry)]);
        let places = oracle::bezier::unit_circle_crossings(&framed);
        for pair in places.windows(2) {
            let part = oracle::solve::integrate(&distance, &pair[0], &pair[1]);
            mean += oracle::real::abs(&part);
            let of_square = |t: &Real| {
                let d = distance(t);
                &d * &d
            };
            square += oracle::solve::integrate(&of_square, &pair[0], &pair[1]);
        }
    }
    close(found.error.mean, &(mean / int(5)), 1e-12, "mean");
    close(found.error.rms, &(square / int(5)).sqrt(), 1e-12, "rms");
}

#[test]
fn a_mirrored_or_reversed_shape_measures_alike() {
    let arc = |sweep: f64| {
        let sweep = Angle::from_degrees(sweep);
        let start = Angle::from_degrees(20.0);
        Shape::Arc(
            Arc::new(
                (1.0, 2.0),
                (3.0, 2.0),
                Angle::from_degrees(30.0),
                start,
                sweep,
            )
            .unwrap(),
        )
    };
    let mirror = Affine::new([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    let plain = measured(&drawn(
        arc(200.0),
        Method::Chen3,
        Cut::Count(3),
        Affine::IDENTITY,
    ));
    let mirrored = measured(&drawn(arc(200.0), Method::Chen3, Cut::Count(3), mirror));
    let same = |a: f64, b: f64| assert!((a - b).abs() < 1e-13 * a.abs().max(1.0), "{a} {b}");
    same(plain.error.peak, mirrored.error.peak);
    same(plain.length.truth, mirrored.length.truth);
    same(plain.area.curve, mirrored.area.curve);
    same(plain.area.truth, mirrored.area.truth);
    same(
        plain.curvature.true_largest,
        mirrored.curvature.true_largest,
    );
    same(
        plain.curvature.largest.unwrap().value.unwrap(),
        mirrored.curvature.largest.unwrap().value.unwrap(),
    );
    same(plain.angle_lag.largest, mirrored.angle_lag.largest);
    assert!(plain.curvature.least.unwrap().value.unwrap() > 0.0);
    let backward = measured(&drawn(
        arc(-160.0),
        Method::Chen3,
        Cut::Count(3),
        Affine::IDENTITY,
    ));
    assert!(backward.curvature.least.unwrap().value.unwrap() > 0.0 && backward.area.curve > 0.0);
    same(
        plain.length.truth + backward.length.truth,
        15.865_439_589_290_59,
    );
}

#[test]
fn huge_tiny_and_distant_curves_are_measured_and_never_not_a_number() {
    for (radius, x) in [
        (1e140, 0.0),
        (1e-70, 0.0),
        (1.0, 1e12),
        (1e-3, 1e9),
        (1e140, 1e149),
    ] {
        let circle = Shape::Circle(Circle::new((x, 0.0), radius).unwrap());
        let found = measured(&drawn(
            circle,
            Method::Minimax,
            Cut::Quarters,
            Affine::IDENTITY,
        ));
        let text = format!("{found:?}");
        assert!(
            !text.contains("NaN") && !text.contains("inf"),
            "{radius} {x}: {text}"
        );
        if x == 0.0 {
            assert!(
                (found.error.relative_peak - 1.960_764_7e-4).abs() < 1e-10,
                "{radius}"
            );
        }
    }
}

/// Numbers that break what is not careful.
fn nasty() -> impl Strategy<Value = f64> {
    let numbers = [
        0.0, 1.0, -1.0, 3.5, 1e-20, -1e-20, 1e-160, 1e-300, 5e-324, 1e75, -1e75, 9e149, -9e149,
        50.0,
    ];
    prop::sample::select(numbers.to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig { max_shrink_iters: 100, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn whatever_the_numbers_nothing_panics_and_nothing_is_not_a_number(
        numbers in prop::collection::vec(nasty(), 14),
        closed: bool,
        kind in 0..3,
        radius in prop::sample::select(vec![1.0, 1e-140, 1e140, 50.0]),
    ) {
        let p = |i: usize| Point::new(numbers[2 * i], numbers[2 * i + 1]);
        let second = match kind {
            0 => PathSeg::Line(kurbo::Line::new(p(3), p(4))),
            1 => PathSeg::Quad(QuadBez::new(p(3), p(4), p(5))),
            _ => PathSeg::Cubic(CubicBez::new(p(3), p(4), p(5), p(6))),
        };
        let first = PathSeg::Cubic(CubicBez::new(p(0), p(1), p(2), p(3)));
        let curve = Curve { segments: vec![first, second], closed };
        let mut truths = vec![Truth::circle(Point::new(1.0, 2.0), radius)];
        truths.push(Truth::new(Point::new(1.0, 2.0), Vec2::new(radius, radius / 7.0), Vec2::new(1.0, 0.0)));
        truths.extend(fit::circle(&curve, None).ok().map(|(truth, _)| truth));
        for truth in truths {
            let reference = Reference::from(truth);
            let Ok(found) = report(&curve, &reference, None) else {
                // A true shape that the rounding of the coordinates swallows.
                continue;
            };
            let text = format!("{found:?}");
            prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{truth:?}: {text}");
            for quantity in Quantity::ALL {
                let chart = Chart::along("", quantity, &[("curve", &curve, &reference)]);
                let svg = write::plot(&chart, Image::Svg, None).unwrap();
                let svg = String::from_utf8(svg).unwrap();
                prop_assert!(!svg.contains("NaN") && !svg.contains("inf"), "{quantity}");
            }
        }
    }
}

#[test]
fn degenerate_segments_have_no_curvature_and_still_a_report() {
    let p = Point::new(1.0, 0.0);
    let q = Point::new(0.0, 1.0);
    let still = PathSeg::Cubic(CubicBez::new(p, p, q, q));
    let point = PathSeg::Cubic(CubicBez::new(p, p, p, p));
    let truth = Truth::circle(Point::ORIGIN, 1.0);
    for segments in [vec![still], vec![point], vec![still, point]] {
        let curve = Curve {
            segments,
            closed: true,
        };
        let found = report(&curve, &Reference::from(truth), None).unwrap();
        let text = format!("{found:?}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
    assert_eq!(curvature::at(&still, 0.0), None);
    let nothing = Curve::default();
    assert!(report(&nothing, &Reference::from(truth), None).is_err());
}

#[test]
fn a_curve_that_turns_back_at_the_centre_is_as_near_as_it_is() {
    // There the derivative of the distance has a triple root, whose place is known to a few digits.
    for k in 1..60 {
        let radius = 2.5 + f64::from(k) * 0.037;
        let turn = Point::new(1.0 + f64::from(k) / 7.0, f64::from(k % 9) / 11.0);
        let end = Point::new(2.0 * turn.x, 2.0 * turn.y);
        let off = 1e-13 * 10.0_f64.powi(k % 6);
        let center = Point::new(turn.x, turn.y - off);
        let curve = Curve {
            segments: vec![PathSeg::Quad(QuadBez::new(end, Point::ORIGIN, end))],
            closed: false,
        };
        let truth = Truth::circle(center, radius);
        let found = report(&curve, &Reference::from(truth), None)
            .unwrap()
            .error
            .inward;
        // (1/2)² · end + (1/2)² · end is the turning point to the last bit.
        let least = radius - turn.distance(center);
        assert!(
            found >= least && found <= least * (1.0 + 1e-9),
            "{k}: {found} {least}"
        );
    }
}

/// Every figure that names an angle or the true shape, against many samples of the true arc and of the curve.
#[test]
fn figures_of_arcs_of_an_ellipse_are_those_of_many_samples() {
    let transforms = [
        Affine::IDENTITY,
        Affine::new([-1.0, 0.0, 0.0, 1.0, 5.0, 0.0]),
        Affine::new([1.0, 0.25, -0.5, 2.0, 0.0, 3.0]),
    ];
    for transform in transforms {
        for (start, sweep) in [
            (10.0, 60.0),
            (20.0, 150.0),
            (100.0, -130.0),
            (700.0, -300.0),
        ] {
            let [rotation, from, by] = [25.0, start, sweep].map(Angle::from_degrees);
            let arc = Arc::new((1.0, 2.0), (3.0, 2.0), rotation, from, by).unwrap();
            let drawing = drawn(Shape::Arc(arc), Method::Chen3, Cut::Count(4), transform);
            let what = format!("{transform:?} {start} {sweep}");
            the_true_arc_is_that_of_samples(&drawing, &what);
            places_have_the_angle_of_their_point(&drawing, &what);
            extremes_are_those_of_samples(&drawing, &what);
        }
    }
}

fn near(found: f64, right: f64, allowed: f64, what: &str) {
    assert!(
        (found - right).abs() <= allowed * right.abs().max(1.0),
        "{what}: {found} {right}"
    );
}

fn the_true_arc_is_that_of_samples(drawing: &Drawing, what: &str) {
    const STEPS: i32 = 2000;
    let found = measured(drawing);
    let (start, sweep) = (found.reference.start, found.reference.sweep);
    // The true arc is M u(θ) + c.
    let [a, b, c, d, ..] = drawing.outline.unwrap().placement.as_coeffs();
    let determinant = (a * d - b * c).abs();
    let speed = |step: f64| {
        let degrees = start + sweep * step / f64::from(STEPS);
        let (sin, cos) = degrees.to_radians().sin_cos();
        (c * cos - a * sin).hypot(d * cos - b * sin)
    };
    let midway: f64 = (0..STEPS).map(|step| speed(f64::from(step) + 0.5)).sum();
    let turned = sweep.abs().to_radians();
    let length = midway * turned / f64::from(STEPS);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for step in 0..=STEPS {
        let curvature = determinant / speed(f64::from(step)).powi(3);
        (least, most) = (least.min(curvature), most.max(curvature));
    }
    near(found.length.truth, length, 1e-6, what);
    near(found.area.truth, determinant * turned / 2.0, 1e-13, what);
    near(found.area.curve, found.area.truth, 0.02, what);
    near(found.curvature.true_least, least, 1e-5, what);
    near(found.curvature.true_largest, most, 1e-5, what);
}

fn places_have_the_angle_of_their_point(drawing: &Drawing, what: &str) {
    let found = measured(drawing);
    let (start, sweep) = (found.reference.start, found.reference.sweep);
    let segments = &drawing.curve.segments;
    let inverse = drawing.outline.unwrap().placement.inverse();
    let angle_is_of = |p: Point, degrees: f64| {
        let angle = (inverse * p).to_vec2().atan2().to_degrees();
        let turns = (degrees - angle) / 360.0;
        near(turns - turns.round(), 0.0, 1e-11, what);
        let part = (degrees - start) / sweep;
        assert!((-1e-9..1.0 + 1e-9).contains(&part), "{what}: {degrees}");
    };
    let curvature = found.curvature;
    for at in [
        found.error.inward_at.or(found.error.outward_at).unwrap(),
        found.angle_lag.at,
        curvature.least.unwrap().at,
        curvature.largest.unwrap().at,
    ] {
        angle_is_of(segments[at.segment - 1].eval(at.t), at.angle);
    }
    let same = |found: Option<curvature::Curvature>, segment: &PathSeg, t: f64| {
        let found = found.unwrap();
        assert!(found.value > 0.0, "{what}");
        let right = curvature::at(segment, t).unwrap().to_array();
        for (found, right) in found.to_array().into_iter().zip(right) {
            near(found.abs(), right.abs(), 1e-9, what);
        }
    };
    assert_eq!(found.continuity.joints.len(), segments.len() - 1);
    for (i, joint) in found.continuity.joints.iter().enumerate() {
        same(joint.before, &segments[i], 1.0);
        same(joint.after, &segments[i + 1], 0.0);
        angle_is_of(Point::new(joint.point[0], joint.point[1]), joint.angle);
    }
}

fn extremes_are_those_of_samples(drawing: &Drawing, what: &str) {
    let found = measured(drawing);
    let parts = (0..=1000).map(|i| f64::from(i) / 1000.0);
    let sampled = drawing.curve.segments.iter().flat_map(|segment| {
        let curvature = |t| curvature::at(segment, t).unwrap().value.abs();
        parts.clone().map(curvature)
    });
    let (least, most) = sampled.fold((f64::INFINITY, 0.0_f64), |(a, b), k| (a.min(k), b.max(k)));
    near(
        found.curvature.least.unwrap().value.unwrap(),
        least,
        1e-3,
        what,
    );
    near(
        found.curvature.largest.unwrap().value.unwrap(),
        most,
        1e-3,
        what,
    );
    let reference = Reference::from(&drawing.outline.unwrap());
    let lags = profile::along(&drawing.curve, &reference, Quantity::AngleLag, 100);
    let lags = lags.concat().into_iter().map(|(_, lag)| lag.abs());
    let farthest = lags.fold(0.0, f64::max);
    near(found.angle_lag.largest.abs(), farthest, 1e-3, what);
}

#[test]
fn a_circle_has_the_curvature_of_its_radius() {
    let circle = Shape::Circle(Circle::new((1.0, 2.0), 5.0).unwrap());
    let found = measured(&drawn(
        circle,
        Method::Minimax,
        Cut::Count(4),
        Affine::IDENTITY,
    ))
    .curvature;
    assert_eq!((found.true_least, found.true_largest), (0.2, 0.2));
}

/// Straight out of the centre and back: no angle to take a mean over, so that it is taken over t.
#[test]
fn a_curve_that_does_not_turn_has_the_mean_over_t() {
    let line = |from: f64, to: f64| PathSeg::Line(kurbo::Line::new((from, 0.0), (to, 0.0)));
    let curve = Curve {
        segments: vec![line(0.5, 1.5), line(1.5, 0.5)],
        closed: false,
    };
    let error = report(
        &curve,
        &Reference::from(Truth::circle(Point::ORIGIN, 1.0)),
        None,
    )
    .unwrap()
    .error;
    assert_eq!((error.mean, error.mean_angle), (0.25, 0.25));
}

#[test]
fn hairpins_are_as_long_as_they_are() {
    use curveto::measure::extent::length;
    // By 800 panels of mpmath's quadrature, the third in closed form.
    for (data, exact) in [
        ("M0 0Q400 0.000002 0.5 -0.000002", 399.750_156_347_716),
        (
            "M3.031565 0.000391C4.493228 -0.000117 0.526064 0.008306 1.336419 0.000477",
            2.568_950_237_479_907,
        ),
        (
            "M-2.892056 0.000216C-4.623440 0.001062 4.374955 -0.028568 2.047820 0.000244",
            6.160_077_830_876_906,
        ),
    ] {
        let curve = curveto::path::curves(data).unwrap().remove(0);
        let found = length(&curve.segments[0]);
        assert!(
            (found / exact - 1.0).abs() < 1e-14,
            "{found} and not {exact}"
        );
    }
}

/// Path data beside a circle about the origin.
fn beside_a_circle(data: &str, radius: f64) -> (Curve, Reference) {
    let curve = path::curves(data).unwrap().remove(0);
    let truth = Truth::circle(Point::ORIGIN, radius);
    (curve, Reference::from(truth))
}

#[test]
fn curvature_beyond_any_bound_has_no_value() {
    for (data, [has_least, has_largest]) in [
        // Handles of no length: beside them the curvature is about (a × b)/(12 |a|³ t), a and b the next differences.
        ("M10 0C10 0 5 10 0 10", [true, false]),
        ("M10 0C10 5 0 10 0 10", [true, false]),
        ("M0 10C5 10 10 0 10 0", [true, false]),
        // A cusp, and a loop as narrow as can be seen.
        ("M0 0C10 10 0 10 10 0", [false, true]),
        ("M0 0C10.001 10 0 10 10 0", [true, true]),
        // Straight, so that it is 0 where the curve stands still too.
        ("M10 0C10 0 5 0 0 0", [true, true]),
    ] {
        let (curve, reference) = beside_a_circle(data, 10.0);
        let found = report(&curve, &reference, None).unwrap().curvature;
        let (least, largest) = (found.least.unwrap(), found.largest.unwrap());
        let has = [least.value.is_some(), largest.value.is_some()];
        assert_eq!(has, [has_least, has_largest], "{data} {found:?}");
    }
}

#[test]
fn angles_count_from_where_a_curve_leaves_the_centre() {
    for (data, degrees) in [
        ("M0 0L0 50C-27.6 50-50 27.6-50 0", [90.0, 90.0, 90.0, 180.0]),
        ("M0 0L4 4", [45.0, 45.0, f64::NAN, f64::NAN]),
        ("M0 0C0 0 0 3 4 4", [90.0, 45.0, f64::NAN, f64::NAN]),
        ("M50 0L0 0L0 50", [0.0, 0.0, 90.0, 90.0]),
    ] {
        let (curve, reference) = beside_a_circle(data, 50.0);
        let found = samples::samples(&curve, &reference, 2).unwrap();
        for (sample, degrees) in found.iter().zip(degrees) {
            assert!((sample.degrees - degrees).abs() < 1e-9, "{data} {sample:?}");
        }
    }
}
