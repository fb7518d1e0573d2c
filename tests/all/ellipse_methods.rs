//! `minimax-ellipse` and `minimax-ellipse-free`: the reference values, and that no handles nearby do better.

use curveto::measure::radial;
use curveto::number::Precision;
use curveto::{Angle, Arc, Cut, Drawing, Ellipse, Method, Options, Shape, approximate};
use kurbo::{CubicBez, PathSeg, Vec2};
use proptest::prelude::*;
use serde_json::Value;

use crate::judges::program::{printed, refused, words};

fn options(method: Method, cut: Cut) -> Options {
    Options {
        rule: method.into(),
        cut,
        precision: Some(Precision::Full),
        ..Options::default()
    }
}

/// One segment of the ellipse with the semi-axes 1 and `b`.
fn arc(b: f64, start: f64, sweep: f64, method: Method) -> Drawing {
    let angle = Angle::from_degrees;
    let arc = Arc::new(
        (0.0, 0.0),
        (1.0, b),
        Angle::ZERO,
        angle(start),
        angle(sweep),
    )
    .unwrap();
    approximate(&Shape::Arc(arc), &options(method, Cut::Count(1))).unwrap()
}

fn whole(b: f64, method: Method) -> Drawing {
    let ellipse = Ellipse::new((0.0, 0.0), (1.0, b), Angle::ZERO).unwrap();
    approximate(&Shape::Ellipse(ellipse), &options(method, Cut::Count(4))).unwrap()
}

fn first_cubic(drawing: &Drawing) -> CubicBez {
    match drawing.curve.segments[0] {
        PathSeg::Cubic(cubic) => cubic,
        _ => panic!("no cubic"),
    }
}

#[test]
fn handles_and_peaks_are_those_of_the_reference() {
    let text = include_str!("../../fixtures/reference/ellipse.json");
    let reference: Value = serde_json::from_str(text).unwrap();
    let number = |value: &Value| value.as_str().unwrap().parse::<f64>().unwrap();
    for value in reference["values"].as_array().unwrap() {
        let (b, start, sweep) = (
            number(&value["b"]),
            number(&value["start"]),
            number(&value["sweep"]),
        );
        let method: Method = value["method"].as_str().unwrap().parse().unwrap();
        let drawing = match method {
            Method::MinimaxEllipse => arc(b, start, sweep, method),
            _ => whole(b, method),
        };
        let cubic = first_cubic(&drawing);
        for (i, p) in [cubic.p0, cubic.p1, cubic.p2, cubic.p3]
            .into_iter()
            .enumerate()
        {
            let known = &value["control_points"][i];
            let off = Vec2::new(p.x - number(&known[0]), p.y - number(&known[1]));
            assert!(off.hypot() < 1e-12, "{b} {start} {method}: {off:?}");
        }
        let peak = number(&value["peak"]);
        assert!(
            (drawing.error.peak() - peak).abs() < 1e-12,
            "{b} {start} {method}"
        );
    }
}

#[test]
fn on_circles_they_are_the_circle_s_methods() {
    for count in [3, 4, 5, 8] {
        let circle = Shape::Circle(curveto::Circle::new((1.0, 2.0), 3.0).unwrap());
        let draw = |method| {
            approximate(&circle, &options(method, Cut::Count(count)))
                .unwrap()
                .curve
        };
        assert_eq!(draw(Method::MinimaxEllipse), draw(Method::Minimax));
        assert_eq!(draw(Method::MinimaxEllipseFree), draw(Method::MinimaxFree));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn no_handles_nearby_have_a_smaller_peak(
        b in 0.05..1.0_f64,
        start in -180.0..180.0_f64,
        sweep in 20.0..120.0_f64,
        turn in 0.0..0.7_f64,
        reach in -6.0..-2.0_f64,
    ) {
        let drawing = arc(b, start, sweep, Method::MinimaxEllipse);
        let truth = drawing.outline.unwrap().truth;
        let cubic = first_cubic(&drawing);
        // All round the pair of handles.
        for eighth in 0..8_i32 {
            let turn = turn + f64::from(eighth) * std::f64::consts::FRAC_PI_4;
            let by = Vec2::new(turn.cos(), turn.sin()) * 10_f64.powf(reach);
            let other = CubicBez::new(
                cubic.p0,
                cubic.p0 + (cubic.p1 - cubic.p0) * (1.0 + by.x),
                cubic.p3 + (cubic.p2 - cubic.p3) * (1.0 + by.y),
                cubic.p3,
            );
            let peak = radial::error([&PathSeg::Cubic(other)], &truth).peak();
            prop_assert!(peak >= drawing.error.peak() - 1e-14, "{peak:e} {:e}", drawing.error.peak());
        }
        prop_assert!((drawing.error.outward - drawing.error.inward).abs() < 1e-11);
    }

    #[test]
    fn they_never_need_more_segments_than_the_affine_image(b in 0.05..0.9_f64, exponent in -8.0..-3.0_f64) {
        let ellipse = Shape::Ellipse(Ellipse::new((0.0, 0.0), (1.0, b), Angle::ZERO).unwrap());
        let tolerance = Cut::Tolerance(curveto::Tolerance::Absolute(10_f64.powf(exponent)));
        let count = |method| approximate(&ellipse, &options(method, tolerance.clone())).unwrap().curve.segments.len();
        prop_assert!(count(Method::MinimaxEllipse) <= count(Method::Minimax));
    }
}

/// The number of segments of an ellipse within a tolerance.
fn fewest(radii: [&str; 2], tolerance: &str, method: &str) -> usize {
    let words = ["ellipse", radii[0], radii[1], "-t", tolerance, "-m", method];
    let drawing = crate::judges::program::json(&words);
    assert!(drawing["error"]["peak"].as_f64().unwrap() <= tolerance.parse().unwrap());
    drawing["segments"].as_array().unwrap().len()
}

#[test]
fn they_need_fewer_segments_where_that_is_possible() {
    for (radii, tolerance, [affine, best]) in [
        (["100", "20"], "0.01", [5, 4]),
        (["100", "50"], "0.014", [5, 4]),
        (["100", "10"], "0.001", [6, 5]),
        (["100", "5"], "0.0001", [8, 7]),
    ] {
        assert_eq!(fewest(radii, tolerance, "minimax"), affine);
        assert_eq!(fewest(radii, tolerance, "minimax-ellipse"), best);
    }
    // With the ends off the ellipse too, in quarters.
    assert_eq!(fewest(["100", "50"], "0.01", "minimax-ellipse"), 5);
    assert_eq!(fewest(["100", "50"], "0.01", "minimax-ellipse-free"), 4);
}

#[test]
fn the_gain_stands_in_a_comparison() {
    let table = printed(&words(
        "compare -m minimax,minimax-ellipse,minimax-ellipse-free --ellipse 0.5 -n 4",
    ));
    for figure in ["1.76171e-4", "1.31415e-4", "9.18689e-5"] {
        assert!(table.contains(figure), "{table}");
    }
}

/// The searches that are hardest: the tip of a flat ellipse within a long segment.
#[test]
fn the_flattest_ellipses_and_longest_segments_are_served() {
    for (ratio, sweeps) in [(0.02, [20.0, 90.0, 100.0]), (0.05, [120.0, 150.0, 170.0])] {
        for sweep in sweeps {
            for start in (0..180).step_by(3).map(f64::from) {
                let best = arc(ratio, start, sweep, Method::MinimaxEllipse);
                let usual = arc(ratio, start, sweep, Method::Minimax);
                assert!(
                    best.error.peak() <= usual.error.peak(),
                    "{ratio} from {start} by {sweep}"
                );
            }
        }
    }
}

#[test]
fn what_they_do_not_serve_is_refused_with_what_does() {
    for arguments in [
        &["ellipse", "3", "1", "-n", "5", "-m", "minimax-ellipse-free"][..],
        &[
            "ellipse",
            "3",
            "1",
            "--start",
            "10",
            "-m",
            "minimax-ellipse-free",
        ],
        &[
            "arc",
            "3",
            "1",
            "--start",
            "0",
            "--sweep",
            "90",
            "-m",
            "minimax-ellipse-free",
        ],
        &["ellipse", "300", "1", "-m", "minimax-ellipse"],
        &["ellipse", "3", "1", "-n", "2", "-m", "minimax-ellipse"],
        &[
            "arc",
            "30",
            "1",
            "--sweep",
            "101",
            "-n",
            "1",
            "-m",
            "minimax-ellipse",
        ],
    ] {
        let message = refused(arguments);
        assert!(
            message.contains("hint: ") && message.contains("minimax"),
            "{message}"
        );
    }
}
