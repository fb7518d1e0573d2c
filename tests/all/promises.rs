//! What a drawing promises, held against arbitrary precision and against the text that is written.

use crate::judges::oracle;

use curveto::number::Precision;
use curveto::path;
use curveto::shape::endpoint::SvgArc;
use curveto::{
    Angle, Arc, Circle, Cut, Drawing, Ellipse, Error, Method, Options, Rule, Shape, Tolerance,
    approximate,
};
use kurbo::{Affine, BezPath, PathSeg, Point, Vec2};
use oracle::{Real, int, radial_extremes, real, to_f64};
use proptest::prelude::*;

/// The largest distance from a circle of the curve that the path data holds, by the oracle.
fn judged(drawing: &Drawing, center: Point, radius: f64) -> f64 {
    let written = BezPath::from_svg(&path::data([&drawing.curve], false)).unwrap();
    let mut peak = int(0);
    for segment in written
        .segments()
        .filter(|segment| !matches!(segment, PathSeg::Line(_)))
    {
        let points: Vec<[Real; 2]> = curveto::curve::control_points(&segment)
            .iter()
            .map(|p| [real(p.x), real(p.y)])
            .collect();
        let (outward, inward) =
            radial_extremes(&points, [real(center.x), real(center.y)], &real(radius));
        peak = [peak, outward, inward]
            .into_iter()
            .reduce(|a, b| if a > b { a } else { b })
            .unwrap();
    }
    to_f64(&peak)
}

fn method() -> impl Strategy<Value = Method> {
    let falling: Vec<Method> = Method::ALL
        .into_iter()
        .filter(|method| method.card().law.is_some_and(|law| law.order >= 4))
        .collect();
    prop::sample::select(falling)
}

fn logarithmic(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from.ln()..to.ln()).prop_map(f64::exp)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_tolerance_holds_for_what_is_written_and_no_smaller_count_would_do(
        method in method(),
        radius in logarithmic(1e-3, 1e4),
        x in -10.0..10.0,
        tolerance in logarithmic(1e-7, 3e-2),
        decimals in prop::option::of(3_u8..9),
    ) {
        let center = Point::new(x * radius, 0.0);
        let shape = Shape::Circle(Circle::new(center, radius).unwrap());
        let precision = decimals.map(Precision::Fixed);
        let absolute = tolerance * radius;
        let options = |cut| Options { rule: Rule::Method(method), cut, precision, transform: Affine::IDENTITY };
        match approximate(&shape, &options(Cut::Tolerance(Tolerance::Absolute(absolute)))) {
            Ok(drawing) => {
                let peak = judged(&drawing, center, radius);
                prop_assert!(peak <= absolute * (1.0 + 1e-12), "{method}: {peak:e} beyond {absolute:e}");
                let off = (peak - drawing.error.peak()).abs();
                prop_assert!(off <= 1e-12 * radius, "{method}: {peak:e} stated as {:e}", drawing.error.peak());
                let fewer = drawing.curve.segments.len() - 1;
                // With fewer segments the error is beyond the tolerance, so that -p auto takes its decimals from that.
                let finest = (0..18).find(|&d| 10_f64.powi(-d) / 2_f64.sqrt() <= absolute / 10.0).unwrap();
                let precision = precision.unwrap_or(Precision::Fixed(finest as u8));
                if fewer > 0 {
                    let exact = Options { precision: Some(precision), ..options(Cut::Count(fewer)) };
                    let Ok(fewer) = approximate(&shape, &exact) else { return Ok(()) };
                    prop_assert!(fewer.error.peak() > absolute, "{method}: {} segments would do", fewer.curve.segments.len());
                }
            }
            Err(Error::ToleranceOutOfReach { .. }) => {
                let finest = 10_f64.powi(-i32::from(decimals.unwrap_or(17)));
                prop_assert!(finest > absolute / 4.0, "{method} refused {absolute:e} at {finest:e}");
            }
            Err(other) => panic!("{method}: {other}"),
        }
    }

    #[test]
    fn whole_circles_mirror_to_the_last_digit(method in method(), count in 3_usize..40, radius in logarithmic(1e-3, 1e6), fixed in 0_u8..12) {
        for precision in [Precision::Full, Precision::Fixed(fixed)] {
            let shape = Shape::Circle(Circle::new((0.0, 0.0), radius).unwrap());
            let options =
                Options { rule: Rule::Method(method), cut: Cut::Count(count), precision: Some(precision), transform: Affine::IDENTITY };
            let Ok(drawing) = approximate(&shape, &options) else { return Ok(()) };
            let mirrors = |flip: fn(Point) -> Point| {
                let mut points: Vec<_> = drawing.curve.segments.iter().flat_map(curveto::curve::control_points).collect();
                let mut flipped: Vec<_> = points.iter().map(|&p| flip(p)).collect();
                let order = |a: &Point, b: &Point| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
                points.sort_by(order);
                flipped.sort_by(order);
                points == flipped
            };
            prop_assert!(mirrors(|p| Point::new(p.x, 0.0 - p.y)), "{method} in {count} about the x axis");
            if count % 2 == 0 {
                prop_assert!(mirrors(|p| Point::new(0.0 - p.x, p.y)), "{method} in {count} about the y axis");
            }
            if count % 4 == 0 {
                prop_assert!(mirrors(|p| Point::new(p.y, p.x)), "{method} in {count} about the diagonal");
            }
        }
    }

    #[test]
    fn svg_arcs_keep_their_ends_and_lie_where_they_should(
        from in (-100.0..100.0_f64, -100.0..100.0_f64),
        to in (-100.0..100.0_f64, -100.0..100.0_f64),
        radii in (1.0..200.0_f64, 1.0..200.0_f64),
        rotation in -400.0..400.0_f64,
        large_arc: bool,
        sweep: bool,
    ) {
        let arc = SvgArc { from: from.into(), radii: radii.into(), rotation: Angle::from_degrees(rotation), large_arc, sweep, to: to.into() };
        let shape = arc.shape().unwrap();
        let drawing = approximate(&shape, &Options::default()).unwrap();
        let segments = &drawing.curve.segments;
        prop_assert_eq!(curveto::curve::control_points(&segments[0])[0], arc.from);
        prop_assert_eq!(*curveto::curve::control_points(&segments[segments.len() - 1]).last().unwrap(), arc.to);
        prop_assert!(drawing.relative_peak() < 5e-4, "{}", drawing.relative_peak());
        // kurbo's reading of the same arc.
        let theirs = kurbo::Arc::from_svg_arc(&kurbo::SvgArc {
            from: arc.from, to: arc.to, radii: arc.radii, x_rotation: rotation.to_radians(), large_arc, sweep,
        }).unwrap();
        let Shape::Arc(ours) = shape else { panic!("{shape:?}") };
        let size = ours.radii.hypot();
        prop_assert!((ours.center - theirs.center).hypot() < 1e-6 * size);
        prop_assert!((ours.sweep.radians() - theirs.sweep_angle).abs() < 1e-6);
    }

    #[test]
    fn text_never_holds_an_exponent_a_negative_zero_or_what_is_no_number(
        numbers in prop::collection::vec(any::<f64>(), 6),
        small in prop::collection::vec(-1e3..1e3_f64, 6),
        choose in prop::collection::vec(any::<bool>(), 6),
        relative: bool,
    ) {
        let n: Vec<f64> = (0..6).map(|i| if choose[i] { numbers[i] } else { small[i] }).collect();
        let angle = Angle::from_degrees;
        let shapes = [
            Circle::new((n[0], n[1]), n[2]).map(Shape::Circle),
            Ellipse::new((n[0], n[1]), (n[2], n[3]), angle(n[4])).map(Shape::Ellipse),
            Arc::new((n[0], n[1]), (n[2], n[2]), angle(n[3]), angle(n[4]), angle(n[5])).map(Shape::Arc),
            SvgArc {
                from: Point::new(n[0], n[1]), radii: Vec2::new(n[2], n[3]), rotation: angle(n[4]),
                large_arc: choose[0], sweep: choose[1], to: Point::new(n[5], n[1]),
            }.shape(),
        ];
        for shape in shapes.into_iter().flatten() {
            for cut in [Cut::Quarters, Cut::Tolerance(Tolerance::Relative(1e-4))] {
                if let Ok(drawing) = approximate(&shape, &Options { cut, ..Options::default() }) {
                    let text = path::data([&drawing.curve], relative);
                    prop_assert!(text.bytes().all(|b| b"MLQCZlqcz0123456789 .-".contains(&b)), "{text}");
                    prop_assert!(!text.contains("-0 ") && !text.contains("-0-"), "{text}");
                    prop_assert!(drawing.error.peak().is_finite());
                }
            }
        }
    }

    #[test]
    fn relative_data_describes_the_same_points(radius in logarithmic(1e-2, 1e3), x in -1e3..1e3_f64, count in 2_usize..30) {
        let shape = Shape::Circle(Circle::new((x, 1.0), radius).unwrap());
        let drawing = approximate(&shape, &Options { cut: Cut::Count(count), ..Options::default() }).unwrap();
        let read = |relative| BezPath::from_svg(&path::data([&drawing.curve], relative)).unwrap();
        let (absolute, relative) = (read(false), read(true));
        for (a, b) in absolute.segments().zip(relative.segments()) {
            let (a, b) = (curveto::curve::control_points(&a), curveto::curve::control_points(&b));
            for (a, b) in a.iter().zip(b) {
                prop_assert!((*a - b).hypot() <= 1e-15 * (count as f64) * (x.abs() + radius));
            }
        }
    }
}

#[test]
fn the_error_of_flat_ellipses_is_the_true_distance() {
    for (rx, ry, rotation) in [
        (30.0, 20.0, 15.0),
        (100.0, 3.0, 0.0),
        (2.0, 50.0, -70.0),
        (1000.0, 1.0, 33.0),
    ] {
        let shape = Shape::Ellipse(
            Ellipse::new((7.0, -3.0), (rx, ry), Angle::from_degrees(rotation)).unwrap(),
        );
        for cut in [
            Cut::Quarters,
            Cut::Count(7),
            Cut::Tolerance(Tolerance::Relative(1e-5)),
        ] {
            let drawing = approximate(
                &shape,
                &Options {
                    cut,
                    ..Options::default()
                },
            )
            .unwrap();
            let mut peak = 0.0_f64;
            for segment in &drawing.curve.segments {
                let points: Vec<[Real; 2]> = curveto::curve::control_points(segment)
                    .iter()
                    .map(|p| [real(p.x), real(p.y)])
                    .collect();
                let (outward, inward) = oracle::ellipse_distance_extremes(
                    &points,
                    [real(7.0), real(-3.0)],
                    [real(rx), real(ry)],
                    &real(rotation),
                );
                peak = peak.max(to_f64(&outward)).max(to_f64(&inward));
            }
            let off = (peak - drawing.error.peak()).abs();
            assert!(
                off <= 1e-12 * rx.max(ry),
                "{rx} {ry}: {peak:e} stated as {:e}",
                drawing.error.peak()
            );
        }
    }
}
