//! Conics by control point and weight: what they are, how far they are said to stray, and the fewest segments.

use curveto::conic::{Conic, ConicDrawing};
use curveto::kurbo::{ParamCurve, Point};
use curveto::{Cut, Method, Options, Rule, Tolerance};
use serde_json::Value;

use crate::judges::program::{self, json, printed, refused, words};

const SHAPES: [[(f64, f64); 3]; 3] = [
    [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
    [(0.0, 0.0), (1.0, 2.0), (3.0, 0.0)],
    [(-40.0, 7.0), (10.0, 60.0), (12.0, -3.0)],
];

fn conic(shape: [(f64, f64); 3], weight: f64) -> Conic {
    let [from, control, to] = shape.map(Point::from);
    Conic::new(from, control, to, weight).unwrap()
}

/// Points of the rational quadratic, by its own definition.
fn rational(conic: &Conic, count: usize) -> Vec<Point> {
    let [p, q, r] = [conic.from, conic.control, conic.to].map(Point::to_vec2);
    (0..=count)
        .map(|i| {
            // Closer together where the weight draws the parameter to the middle.
            let s = i as f64 / count as f64;
            let t = s / (s + conic.weight.sqrt() * (1.0 - s));
            let t = if conic.weight > 4.0 { 0.5 * (t + s) } else { s };
            let (a, b, c) = (
                (1.0 - t) * (1.0 - t),
                2.0 * conic.weight * t * (1.0 - t),
                t * t,
            );
            ((p * a + q * b + r * c) / (a + b + c)).to_point()
        })
        .collect()
}

fn points(drawing: &ConicDrawing, count: usize) -> Vec<Point> {
    let segments = &drawing.curve.segments;
    segments
        .iter()
        .flat_map(|segment| (0..=count).map(|i| segment.eval(i as f64 / count as f64)))
        .collect()
}

/// The largest distance of these points from the polyline through those.
fn farthest(points: &[Point], line: &[Point]) -> f64 {
    let distance = |p: Point, a: Point, b: Point| {
        let (ab, ap) = (b - a, p - a);
        let t = (ap.dot(ab) / ab.hypot2().max(1e-300)).clamp(0.0, 1.0);
        (ap - ab * t).hypot()
    };
    points
        .iter()
        .map(|&p| {
            line.windows(2)
                .map(|pair| distance(p, pair[0], pair[1]))
                .fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

fn drawn(conic: &Conic, cut: Cut) -> ConicDrawing {
    conic
        .draw(&Options {
            cut,
            ..Options::default()
        })
        .unwrap()
}

#[test]
fn the_stated_error_is_the_distance_both_ways() {
    for shape in SHAPES {
        let size = 2.0
            * shape
                .iter()
                .fold(0.0_f64, |m, p| m.max(p.0.abs()).max(p.1.abs()));
        for (weight, count) in [(1.2, 1), (2.5, 1), (6.0, 2), (0.99995, 1), (40.0, 4)] {
            let conic = conic(shape, weight);
            let cut = Cut::Count(count);
            let drawing = drawn(&conic, cut);
            let (truth, curve) = (rational(&conic, 4000), points(&drawing, 500));
            let there = farthest(&curve, &truth);
            let back = farthest(
                &truth,
                &points(&drawing, 4000 / count)
                    .into_iter()
                    .step_by(1)
                    .collect::<Vec<_>>()[..],
            );
            // The polylines lie inside by up to a few times 1e-7 of the size.
            let slack = 1e-6 * size;
            let stated = drawing.error.peak();
            assert!(
                there.max(back) <= stated + slack,
                "{weight} {count}: {there} {back} {stated}"
            );
            assert!(
                there.max(back) >= 0.99 * stated - slack,
                "{weight} {count}: {there} {back} {stated}"
            );
        }
    }
}

#[test]
fn where_the_conic_is_sharper_than_the_error_it_is_the_distance_too() {
    let needle = [(0.55, -6.64), (-4.54, 4.23), (-0.91, -3.56)];
    for (shape, weight, count) in [
        (SHAPES[1], 100.0, 1),
        (needle, 26.3837, 1),
        (needle, 90.0, 2),
    ] {
        let conic = conic(shape, weight);
        let drawing = drawn(&conic, Cut::Count(count));
        let (truth, curve) = (rational(&conic, 1000), points(&drawing, 1000 / count));
        let both = farthest(&curve, &truth).max(farthest(&truth, &curve));
        let ratio = both / drawing.error.peak();
        // The polylines lie inside by some 1e-5 of the size.
        assert!((0.99..1.01).contains(&ratio), "{weight} {count}: {ratio}");
    }
}

#[test]
fn a_sharp_conic_is_met_within_a_tolerance_that_is_larger_than_its_tip() {
    for (weight, tolerance, count) in [("2.5", "0.5", 1), ("2.5", "0.05", 2), ("26", "0.05", 1)] {
        let needle = "conic --from=7.96,3.36 --control=-9.33,-4.05 --to=7.24,2.73 -f json";
        let document = json(&words(&format!(
            "{needle} --weight {weight} -t {tolerance}"
        )));
        let peak = document["error"]["peak"].as_f64().unwrap();
        assert!(
            peak <= tolerance.parse().unwrap(),
            "{weight} {tolerance}: {peak}"
        );
        assert_eq!(document["segments"].as_array().unwrap().len(), count);
    }
}

#[test]
fn the_weight_says_what_it_is() {
    let form = |weight: &str| {
        let shape = "conic --from 1,0 --control 1,1 --to 0,1 --weight";
        json(&[&words(shape)[..], &[weight]].concat())
    };
    // cos 45 degrees: a quarter of the unit circle.
    let quarter = form("0.7071067811865476");
    assert_eq!(quarter["shape"]["kind"], "arc");
    for i in 0..2 {
        assert!((quarter["shape"]["radii"][i].as_f64().unwrap() - 1.0).abs() < 1e-12);
        assert!(quarter["shape"]["center"][i].as_f64().unwrap().abs() < 1e-12);
    }
    assert!((quarter["shape"]["sweep"].as_f64().unwrap() - 90.0).abs() < 1e-9);
    assert!((quarter["error"]["peak"].as_f64().unwrap() - 1.960_764_7e-4).abs() < 1e-10);
    let parabola = form("1");
    assert_eq!(parabola["shape"]["form"], "parabola");
    assert_eq!(parabola["path"], "M1 0Q1 1 0 1");
    assert_eq!(parabola["error"]["peak"], 0);
    assert_eq!(form("3")["shape"]["form"], "hyperbola");
}

#[test]
fn an_ellipse_runs_along_the_rational_quadratic() {
    for shape in SHAPES {
        for weight in [0.05, 0.4, 0.9, 0.999] {
            let conic = conic(shape, weight);
            let arc = conic.arc().unwrap().unwrap();
            let truth = arc.outline().unwrap().truth;
            for p in rational(&conic, 64) {
                let distance = curveto::measure::radial::distance(&truth, p);
                assert!(
                    distance.abs() < 1e-10 * truth.larger_radius(),
                    "{weight}: {distance}"
                );
            }
            let cut = Cut::Tolerance(Tolerance::Relative(1e-6));
            let drawing = curveto::approximate(
                &arc,
                &Options {
                    cut,
                    ..Options::default()
                },
            )
            .unwrap();
            assert_eq!(drawing.curve.segments[0].start(), conic.from);
            assert_eq!(drawing.curve.segments.last().unwrap().end(), conic.to);
            let curve: Vec<Point> = drawing
                .curve
                .segments
                .iter()
                .flat_map(|s| (0..=400).map(|i| s.eval(f64::from(i) / 400.0)))
                .collect();
            assert!(farthest(&rational(&conic, 500), &curve) < 1e-5 * truth.larger_radius());
        }
    }
}

#[test]
fn a_parabola_stays_exact_when_it_is_cut() {
    let conic = conic(SHAPES[2], 1.0);
    let drawing = drawn(&conic, Cut::Count(5));
    assert_eq!(drawing.curve.segments.len(), 5);
    assert!(drawing.error.peak() < 1e-12, "{:?}", drawing.error);
    for (i, segment) in drawing.curve.segments.iter().enumerate() {
        let t = i as f64 / 5.0;
        let [p, q, r] = [conic.from, conic.control, conic.to].map(Point::to_vec2);
        let expected = p * (1.0 - t) * (1.0 - t) + q * (2.0 * t * (1.0 - t)) + r * t * t;
        assert!((segment.start().to_vec2() - expected).hypot() < 1e-12);
    }
    let words = &measure("1")[1..];
    assert_eq!(printed(words), "M0 0Q1 2 3 0\n");
    assert_eq!(
        printed(&[words, &["-t", "1e-9"]].concat()),
        "M0 0Q1 2 3 0\n"
    );
    assert!(printed(&[words, &["-f", "ps"]].concat()).contains("curveto"));
}

#[test]
fn a_tolerance_is_kept_by_the_fewest_segments() {
    for weight in [1.0001, 2.0, 30.0] {
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let conic = conic(SHAPES[1], weight);
            let draw = |cut| drawn(&conic, cut);
            let drawing = draw(Cut::Tolerance(Tolerance::Absolute(tolerance)));
            let count = drawing.curve.segments.len();
            assert!(drawing.error.peak() <= tolerance, "{weight} {tolerance}");
            if count > 1 {
                // Equal pieces need as many, or more.
                let equal = draw(Cut::Count(count - 1));
                assert!(
                    equal.error.peak() > tolerance,
                    "{weight} {tolerance}: {count}"
                );
            }
        }
    }
}

#[test]
fn hyperbolas_are_of_order_six_and_joined_smoothly() {
    let words = |n: &str| -> Value { json(&[&measure("2.5")[..], &["-n", n]].concat()) };
    let peak = |n: &str| words(n)["error"]["peak"].as_f64().unwrap();
    let order = (peak("8") / peak("16")).log2();
    assert!((order - 6.0).abs() < 0.1, "{order}");
    let found = words("8");
    assert_eq!(found["continuity"], "G2");
    let length = |key: &str| found["length"][key].as_f64().unwrap();
    assert!((length("curve") - length("true")).abs() < 1e-6);
    // The true length, by a polyline.
    let line = rational(&conic(SHAPES[1], 2.5), 100_000);
    let sum: f64 = line.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    assert!((length("true") - sum).abs() < 1e-8, "{sum}");
}

#[test]
fn what_no_conic_can_do_is_refused() {
    let shape = words("conic --from 0,0 --control 1,2 --to 3,0 --weight");
    let with = |words: &[&'static str]| refused(&[&shape[..], words].concat());
    for weight in ["0", "-1", "nan", "1e12"] {
        assert!(refused(&[&shape[..], &[weight]].concat()).contains("weight"));
    }
    assert!(with(&["2", "-m", "chen-3"]).contains("hint: take -m minimax"));
    assert!(with(&["2", "--joints", "10,20"]).contains("-n and -t"));
    assert!(with(&["2", "--extremes"]).contains("hint:"));
    assert!(with(&["2", "--handle", "0.5"]).contains("handle"));
    let line = words("conic --from 0,0 --control 1,1 --to 2,2 --weight 2");
    assert!(refused(&line).contains("on a line"));
    for method in Method::ALL {
        let drawn = conic(SHAPES[0], 2.0).draw(&Options {
            rule: Rule::Method(method),
            ..Options::default()
        });
        let serves = ["midpoint", "minimax", "goldapp", "curvature"].contains(&method.id());
        assert_eq!(drawn.is_ok(), serves, "{method}");
    }
}

#[test]
fn every_format_holds_a_conic() {
    for format in [
        "path", "svg", "ps", "eps", "json", "pdf", "tikz", "canvas", "glif", "dxf",
    ] {
        for weight in ["0.5", "1", "2"] {
            let conic = "conic --from 0,0 --control 100,200 --to 300,0 --weight";
            let drawn = program::drawn(&format!("{conic} {weight} -f {format}"));
            assert!(!drawn.is_empty(), "{format} {weight}");
        }
    }
    let moved = printed(&words(
        "conic --from 0,0 --control 1,2 --to 3,0 --weight 1 --transform scale(2)",
    ));
    assert_eq!(moved, "M0 0Q2 4 6 0\n");
}

/// What measures the conic of this weight over (0,0), (1,2), (3,0).
fn measure(weight: &str) -> Vec<&str> {
    let shape = words("measure conic --from 0,0 --control 1,2 --to 3,0 --weight");
    [&shape[..], &[weight]].concat()
}

fn measured(words: &[&str]) -> String {
    printed(&[&measure("2")[..], words].concat())
}

#[test]
fn samples_of_a_conic_are_points_of_the_curve_and_their_distance() {
    for shape in SHAPES {
        for weight in [1.0, 1.2, 3.0] {
            let conic = conic(shape, weight);
            let drawing = drawn(&conic, Cut::Count(3));
            let line = rational(&conic, 5_000);
            let samples = drawing.samples(9).unwrap();
            assert_eq!(samples.len(), 9 * drawing.curve.segments.len());
            assert_eq!(samples[0].place, 0.0);
            let last = samples[samples.len() - 1];
            assert!((last.place - 1.0).abs() < 1e-12, "{}", last.place);
            assert!(samples.is_sorted_by(|a, b| a.place <= b.place + 1e-12));
            let mut largest = 0.0_f64;
            for sample in &samples {
                let segment = drawing.curve.segments[sample.at.segment - 1];
                let p = Point::new(sample.at.x, sample.at.y);
                assert!((p - segment.eval(sample.at.t)).hypot() < 1e-13);
                let distance = farthest(&[p], &line);
                let size = (conic.to - conic.from).hypot();
                assert!(
                    (distance - sample.error.abs()).abs() < 1e-6 * size,
                    "{distance:e} {sample:?}"
                );
                largest = largest.max(sample.error.abs());
            }
            let peak = drawing.error.peak();
            // Samples have the digits of coordinates.
            assert!(
                largest <= peak + 1e-14 && largest >= 0.8 * peak - 1e-12,
                "{largest:e} {peak:e}"
            );
        }
    }
}

#[test]
fn joints_of_a_hyperbola_lie_at_equal_steps_of_its_angle() {
    let csv = measured(&["-n", "4", "--samples", "2", "-f", "csv"]);
    assert!(csv.starts_with("form,weight,method,segment,t,x,y,error,place\n"));
    let places: Vec<f64> = csv
        .lines()
        .skip(1)
        .map(|line| line.rsplit(',').next().unwrap().parse().unwrap())
        .collect();
    for (place, known) in places
        .iter()
        .zip([0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0])
    {
        assert!((place - known).abs() < 1e-12, "{places:?}");
    }
    let table = measured(&["-n", "4", "-m", "minimax,midpoint", "--samples", "3"]);
    assert_eq!(table.matches("of 12 points: peak").count(), 2, "{table}");
    assert!(refused(&[&measure("2")[..], &["--samples", "1"]].concat()).contains("from 2"));
}

#[test]
fn an_arc_of_an_ellipse_by_its_weight_is_sampled_as_any_arc() {
    let csv = printed(&[&measure("0.5")[..], &["--samples", "2", "-f", "csv"]].concat());
    assert!(
        csv.starts_with("subject,method,segment,t,x,y,radius,error,degrees\n"),
        "{csv}"
    );
}

#[test]
fn a_conic_is_plotted_over_its_length() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plot.svg");
    let file = file.to_str().unwrap();
    measured(&[
        "-n",
        "1,2",
        "-m",
        "minimax,midpoint",
        "--plot",
        file,
        "--quantity",
        "error,curvature",
    ]);
    let plot = std::fs::read_to_string(file).unwrap();
    // A panel for each quantity and each number of segments.
    assert_eq!(plot.matches("place along the conic").count(), 4);
    for words in ["minimax", "midpoint", "Curvature: Hyperbola"] {
        assert!(plot.contains(words), "{words}");
    }
    let lag = [
        &measure("2")[..],
        &["--plot", file, "--quantity", "angle-lag"],
    ]
    .concat();
    assert!(refused(&lag).contains("hint: take --quantity error"));
    let drawing = drawn(&conic(SHAPES[1], 2.0), Cut::Count(2));
    assert!(
        drawing
            .along(curveto::measure::Quantity::AngleLag, 10)
            .is_err()
    );
    // Where the conic is a parabola the curvature is its own: 2 |U x V| / |p'|^3 with p' = 2 (P1 - P0) at the start.
    let parabola = drawn(&conic(SHAPES[1], 1.0), Cut::Count(1));
    let curvature = parabola
        .along(curveto::measure::Quantity::Curvature, 10)
        .unwrap()[0][0]
        .1;
    let [p, q, r] = SHAPES[1].map(Point::from);
    let known = 0.5 * (q - p).cross(r - q).abs() / (q - p).hypot().powi(3);
    assert!((curvature - known).abs() < 1e-12, "{curvature} {known}");
}
