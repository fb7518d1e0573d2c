//! `path --to lines` and `--to arcs`: the tolerance holds both ways, by points sampled densely, and the pieces are few.

use curveto::arcs::{Options, arcs, lines};
use curveto::contour::{Contour, PathDrawing, Step};
use curveto::kurbo::{ParamCurve, PathSeg, Point};
use curveto::{Angle, Arc, Tolerance, path};
use proptest::prelude::*;

use crate::judges::program::{printed, run, words};
use crate::judges::random::uniform;

const SAMPLES: usize = 120;

fn drawn(data: &str, tolerance: f64) -> PathDrawing {
    let options = Options {
        tolerance: Some(Tolerance::Absolute(tolerance)),
        ..Options::default()
    };
    lines(&path::contours(data).unwrap(), &options).unwrap()
}

fn count(drawing: &PathDrawing) -> usize {
    drawing.curves().map(|curve| curve.segments.len()).sum()
}

fn given(contour: &Contour) -> Vec<PathSeg> {
    let given = |step: &Step| match step {
        Step::Given(segment) => *segment,
        Step::Arc(_) => panic!("no arcs here"),
    };
    contour.steps.iter().map(given).collect()
}

fn sampled(segments: &[PathSeg]) -> Vec<Point> {
    let point = |segment: &PathSeg, i: usize| segment.eval(i as f64 / SAMPLES as f64);
    let points = |segment| (0..=SAMPLES).map(move |i| point(segment, i));
    segments.iter().flat_map(points).collect()
}

fn from_chords(p: Point, points: &[Point]) -> f64 {
    let distance = |pair: &[Point]| {
        let (a, chord) = (pair[0], pair[1] - pair[0]);
        let part = (p - a).dot(chord) / chord.hypot2();
        let part = if part.is_finite() {
            part.clamp(0.0, 1.0)
        } else {
            0.0
        };
        p.distance(a + part * chord)
    };
    points
        .windows(2)
        .map(distance)
        .fold(f64::INFINITY, f64::min)
}

/// The data of one cubic.
fn cubic(numbers: &[f64]) -> String {
    let texts: Vec<String> = numbers.iter().map(f64::to_string).collect();
    format!("M{}C{}", texts[..2].join(" "), texts[2..].join(" "))
}

/// The largest distance of the points of each, some of them left out, from the other.
fn points_apart(a: &[Point], b: &[Point], stride: usize) -> f64 {
    let one_way = |from: &[Point], to: &[Point]| {
        let near = from.iter().step_by(stride).map(|&p| from_chords(p, to));
        near.fold(0.0, f64::max)
    };
    one_way(a, b).max(one_way(b, a))
}

/// The largest distance of the sampled points of each from the other.
fn apart(a: &[PathSeg], b: &[PathSeg]) -> f64 {
    points_apart(&sampled(a), &sampled(b), 1)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn lines_stay_within_the_tolerance_both_ways(
        numbers in prop::collection::vec(-100.0..100.0_f64, 8),
        tolerance in 0.05..5.0_f64,
    ) {
        let data = cubic(&numbers);
        let contours = path::contours(&data).unwrap();
        let drawing = drawn(&data, tolerance);
        let stated = drawing.error().peak();
        let found = apart(&given(&contours[0]), &drawing.subpaths[0].curve.segments);
        prop_assert!(stated <= tolerance, "{data}: {stated}");
        // The samples lie on chords of the curve themselves.
        prop_assert!(found <= stated + 0.05, "{data}: {found} beyond {stated}");
    }
}

/// Halving of the parameter, as the plainest flattener does.
fn halved(piece: PathSeg, tolerance: f64) -> usize {
    let line = PathSeg::Line(curveto::kurbo::Line::new(piece.start(), piece.end()));
    if apart(&[piece], &[line]) <= tolerance {
        return 1;
    }
    let (a, b) = piece.subdivide();
    halved(a, tolerance) + halved(b, tolerance)
}

#[test]
fn chords_are_no_more_than_by_halving() {
    for data in [
        "M0 0C30 100 70-100 100 0",
        "M0 0C150 80-50 80 100 0",
        "M0 0Q50 100 100 0",
        "M0 0C0 55 45 100 100 100",
        "M2 4.75C-4 6.25-1.5 4.5 6.5 9",
        "M6.5 9C14.5 13.5 9.25 12.75 13.75 11.25",
    ] {
        let piece = given(&path::contours(data).unwrap()[0])[0];
        for tolerance in [5.0, 1.0, 0.2, 0.1, 0.05] {
            // Rounding takes a fiftieth.
            let (ours, theirs) = (
                count(&drawn(data, tolerance)),
                halved(piece, 0.98 * tolerance),
            );
            assert!(ours <= theirs, "{data} {tolerance}: {ours}, {theirs}");
        }
    }
}

#[test]
fn folded_curves_take_no_more_chords_than_by_halving() {
    let mut state = 11;
    for _ in 0..60 {
        // Forth, back and forth again, nearly on a line.
        let mut x = |most: f64| (10.0 * most * (2.0 * uniform(&mut state) - 1.0)).round() / 10.0;
        let [a, b, c, d] = [175.0, 1.0, 175.0, 1.0].map(&mut x);
        let data = format!("M0 0C{a} {b} {c} {d} {} 0", 50.0 + x(45.0));
        let piece = given(&path::contours(&data).unwrap()[0])[0];
        for tolerance in [0.05, 0.25, 1.0] {
            let drawing = drawn(&data, tolerance);
            // The samples say a bit less than the distance is.
            let halved = halved(piece, 0.9999 * tolerance);
            assert!(count(&drawing) <= halved, "{data} {tolerance}: {halved}");
            let stated = drawing.error().peak();
            let found = apart(&[piece], &drawing.subpaths[0].curve.segments);
            assert!(found <= stated + 1e-9, "{data}: {found}, {stated}");
        }
    }
    // By two million samples.
    for (data, tolerance, distance) in [
        (
            "M0 0C97.7 0.08 6.9 -0.1 85.9 0",
            0.0484,
            0.031_134_443_359_687,
        ),
        (
            "M0 0C98.5 0.32 -45.4 0.51 42.1 0",
            0.4944,
            0.315_226_567_819,
        ),
    ] {
        let drawing = drawn(data, tolerance);
        assert_eq!(count(&drawing), 1);
        assert!((drawing.error().peak() - distance).abs() < 1e-12);
    }
}

#[test]
fn rounding_costs_no_chord_that_halving_saves() {
    for (data, tolerance, expected) in [
        // Two halves lie sqrt(78.125) away, a hundred and twenty millionths below the tolerance.
        ("M0 0Q50 100 100 0", "8.84", 2),
        ("M0 0C22.7 -0.36 29.4 0.07 48.6 0", "0.1459", 1),
    ] {
        let printed = printed(&["path", data, "--to", "lines", "-t", tolerance]);
        assert_eq!(printed.matches('L').count(), expected, "{printed}");
    }
}

#[test]
fn chords_reach_over_inflections_and_folds() {
    // By dynamic programming over 200 ends each.
    for (data, expected) in [
        (
            "M44.7092 11.9574C16.8391 10.4159 4.63005 23.2765 23.1003 5.86059",
            2,
        ),
        (
            "M118.463 90.2637C36.9041 78.6131 102.352 112.593 17.3113 22.2887",
            3,
        ),
        ("M0 0C14.7991-4.98878 31.383 2.68579 56.0006 0", 2),
        ("M0 0C18.6639 18.9036 9.09409 2.88103 16.9931 0", 2),
    ] {
        assert_eq!(count(&drawn(data, 1.0)), expected, "{data}");
    }
}

#[test]
fn a_circle_takes_as_many_chords_as_its_sagitta_says() {
    let circle = "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z";
    for tolerance in [1.0, 0.1, 0.01, 1e-4] {
        let half = (1.0_f64 - tolerance / 50.0).acos();
        let optimum = 2.0 * (std::f64::consts::PI / (2.0 * half)).ceil();
        let found = count(&drawn(circle, tolerance)) as f64;
        assert!(
            found <= 1.05 * optimum + 1.0 && found >= optimum,
            "{found}, {optimum}"
        );
        assert!(drawn(circle, tolerance).error().peak() <= tolerance);
    }
}

#[test]
fn ends_and_lines_stay_digit_for_digit_and_nothing_vanishes() {
    let data = "M0.123456789 0L7.000000001 1C7.000000001 1 7.000000001 1 7.000000001 1Z";
    let drawing = drawn(data, 1.0);
    assert_eq!(
        path::data(drawing.curves(), false),
        "M0.123456789 0L7.000000001 1L7.000000001 1Z"
    );
    assert_eq!(drawing.error().peak(), 0.0);
}

#[test]
fn a_loop_that_is_smaller_than_the_tolerance_stays_one() {
    for tolerance in [0.1, 1.0, 2.3, 3.0, 4.0, 5.0, 10.0, 100.0] {
        let drawing = drawn("M0 0C3 3-3 3 0 0", tolerance);
        let ends = drawing
            .curves()
            .flat_map(|curve| &curve.segments)
            .map(PathSeg::end);
        let ends: Vec<Point> = ends.collect();
        let area = ends
            .windows(2)
            .map(|pair| pair[0].to_vec2().cross(pair[1].to_vec2()))
            .sum::<f64>();
        assert!(area > 1.0, "{tolerance}: {ends:?}");
        assert!(drawing.error().peak() <= tolerance);
    }
}

#[test]
fn a_whole_circle_and_an_arc_of_no_length_may_be_steps() {
    let degrees = Angle::from_degrees;
    let circle = Arc::new(
        (1.0, 2.0),
        (5.0, 5.0),
        Angle::ZERO,
        degrees(30.0),
        degrees(360.0),
    )
    .unwrap();
    let nothing = Arc::new(
        (1.0, 2.0),
        (5.0, 5.0),
        Angle::ZERO,
        degrees(30.0),
        Angle::ZERO,
    )
    .unwrap();
    let start = Point::new(1.0 + 5.0 * 0.75_f64.sqrt(), 4.5);
    let contour = Contour {
        steps: vec![Step::Arc(circle), Step::Arc(nothing)],
        closed: true,
    };
    let options = Options {
        tolerance: Some(Tolerance::Absolute(0.01)),
        ..Options::default()
    };
    let drawing = arcs(&[contour], &options).unwrap();
    let course = drawing.subpaths[0].course.as_ref().unwrap();
    assert!(course.start.distance(start) < 0.01);
    let mut turned = 0.0;
    for step in &course.steps {
        if let curveto::course::CourseStep::Arc(arc) = step {
            assert!(
                (arc.radius - 5.0).abs() < 0.01 && arc.center.distance(Point::new(1.0, 2.0)) < 0.02
            );
            turned += arc.sweep.degrees();
        }
    }
    assert!((turned - 360.0).abs() < 0.2, "{course:?}");
    assert!(drawing.error().peak() <= 0.01);
}

#[test]
fn more_than_a_million_segments_are_refused_with_a_tolerance_that_serves() {
    let wide = "M0 0C1e5 4e5 7e5 9e5 1e6 0";
    let refused = run(&["path", wide, "--to", "lines", "-t", "1e-7"]);
    assert_eq!(refused.status.code(), Some(2));
    // With the tolerance of the hint there are 887,112.
    assert_eq!(
        String::from_utf8(refused.stderr).unwrap(),
        "error: within 1e-7 the path becomes more than 1000000 segments\nhint: take a larger tolerance, as -t 0.0000006\n"
    );
}

#[test]
fn fine_chords_stay_within_the_tolerance_far_from_the_origin() {
    let printed = printed(&[
        "path",
        "M0 0C1e5 4e5 7e5 9e5 1e6 0",
        "--to",
        "lines",
        "-t",
        "1e-5",
    ]);
    // The integral of sqrt(curvature / 8t) over the curve is 215,364.3.
    assert_eq!(printed.matches('L').count(), 216_169);
}

#[test]
fn arcs_that_are_drawn_as_curves_have_few_decimals() {
    let stated = |text: &str| -> f64 {
        let (_, rest) = text.split_once(", within ").unwrap();
        rest.lines().next().unwrap().parse().unwrap()
    };
    let curve = "M0 0C0 30 40 60 80 10";
    for (tolerance, precision, most) in [
        ("1", None, 2),
        ("0.01", None, 4),
        ("1", Some("3"), 3),
        ("0.01", Some("1"), 4),
    ] {
        let mut words = vec!["path", curve, "--to", "arcs", "-t", tolerance, "-f", "eps"];
        words.extend(
            precision
                .filter(|_| tolerance == "1")
                .map_or(vec![], |p| vec!["-p", p]),
        );
        let eps = printed(&words);
        let points = eps.lines().filter(|line| line.ends_with(" curveto"));
        let numbers =
            points.flat_map(|line| line.split(' ').filter_map(|word| word.parse::<f64>().ok()));
        let decimals = numbers.map(curveto::number::decimals_of).max().unwrap();
        assert!((1..=most).contains(&decimals), "{words:?} {eps}");
        let within = stated(&eps);
        assert!(within <= tolerance.parse().unwrap(), "{words:?} {within}");
        let mut words = words.clone();
        words[7] = "json";
        let json = printed(&words);
        assert!(json.contains("\"arc\""), "{json}");
    }
}

#[test]
fn a_part_of_a_box_is_one_of_the_box_of_the_arc_and_not_of_its_circle() {
    // A thousandth of half of 100 and not of the radius.
    let arc = "M0 0A1e4 1e4 0 0 1 100 0";
    let subpath = &lines(&path::contours(arc).unwrap(), &Options::default())
        .unwrap()
        .subpaths[0];
    assert!((subpath.radius - 50.0).abs() < 1e-9, "{}", subpath.radius);
    assert_eq!(subpath.curve.segments.len(), 2);
    // Where it turns back.
    let half = "M0 0A50 50 0 0 1 100 0L100 10";
    let drawing = lines(&path::contours(half).unwrap(), &Options::default()).unwrap();
    assert!((drawing.subpaths[0].radius - 50.0).abs() < 1e-9);
}

#[test]
fn arcs_that_are_nearly_lines_are_cut_without_a_loss_of_digits() {
    for radius in [1e9, 1.234_567e12, 1.234_567_890_1e16] {
        let arc = format!("M0 0A{radius} {radius} 0 0 1 1000.5 20.3L20 20");
        for to in ["lines", "arcs"] {
            let printed = printed(&["path", &arc, "--to", to, "-t", "1e-3"]);
            assert!(
                printed.starts_with("M0 0") && printed.contains("1000.5 20.3L20 20"),
                "{printed}"
            );
        }
        let program = printed(&["path", &arc, "--to", "arcs", "-t", "1e-3", "-f", "gcode"]);
        assert!(
            program.contains("X1000.5 Y20.3") && program.contains("G1 X20 Y20"),
            "{program}"
        );
    }
}

#[test]
fn the_program_draws_lines_for_machines() {
    let lines = printed(&[
        "path",
        "M0 0Q50 100 100 0",
        "--to",
        "lines",
        "-t",
        "5",
        "-f",
        "gcode",
    ]);
    assert_eq!(lines.matches("G1 ").count(), 3, "{lines}");
    let json = printed(&[
        "path",
        "M0 0Q50 100 100 0",
        "--to",
        "lines",
        "-t",
        "5",
        "-f",
        "json",
    ]);
    assert!(json.contains("\"method\": \"lines\""), "{json}");
    let refused = run(&["path", "M0 0Q50 100 100 0", "--to", "lines", "-n", "5"]);
    assert_eq!(refused.status.code(), Some(2));
    let coarse = run(&[
        "path",
        "M0 0Q50 100 100 0",
        "--to",
        "lines",
        "-t",
        "0.1",
        "-p",
        "0",
    ]);
    assert_eq!(coarse.status.code(), Some(2));
}

fn bowed(data: &str, tolerance: Option<f64>) -> PathDrawing {
    let options = Options {
        tolerance: tolerance.map(Tolerance::Absolute),
        ..Options::default()
    };
    arcs(&path::contours(data).unwrap(), &options).unwrap()
}

fn bowed_data(data: &str, tolerance: Option<f64>) -> String {
    path::data_of_courses(bowed(data, tolerance).courses(), false)
}

/// Path data of lines and circular arcs as chords so short that they count as the curve itself, by SVG's formulas for end points.
fn chords(data: &str) -> Vec<PathSeg> {
    let mut points = Vec::new();
    for contour in path::contours(data).unwrap() {
        for step in contour.steps {
            match step {
                Step::Given(segment) => points.extend([segment.start(), segment.end()]),
                Step::Arc(arc) => points.extend((0..=2000).map(|i| {
                    let angle = arc.start.radians() + arc.sweep.radians() * f64::from(i) / 2000.0;
                    let (sin, cos) = angle.sin_cos();
                    arc.center + arc.radii.x * curveto::kurbo::Vec2::new(cos, sin)
                })),
            }
        }
    }
    let line = |pair: &[Point]| PathSeg::Line(curveto::kurbo::Line::new(pair[0], pair[1]));
    points.windows(2).map(line).collect()
}

fn ends(segments: &[PathSeg]) -> Vec<Point> {
    let start = segments.iter().map(PathSeg::start);
    start.chain(segments.last().map(PathSeg::end)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn arcs_stay_within_the_tolerance_both_ways(
        numbers in prop::collection::vec(-100.0..100.0_f64, 8),
        tolerance in 0.02..5.0_f64,
    ) {
        let data = cubic(&numbers);
        let contours = path::contours(&data).unwrap();
        let drawing = bowed(&data, Some(tolerance));
        let stated = drawing.error().peak();
        prop_assert!(stated <= tolerance, "{data}: {stated}");
        let printed = path::data_of_courses(drawing.courses(), false);
        let found = points_apart(&sampled(&given(&contours[0])), &ends(&chords(&printed)), 7);
        // The samples lie on chords of the curve themselves.
        prop_assert!(found <= stated + 0.05, "{data}: {found} beyond {stated}");
    }
}

#[test]
fn arcs_reach_the_tips_of_flat_ellipses() {
    for (short, tolerance) in [
        (0.1, 1.0),
        (0.1, 2.0),
        (0.3, 5.0),
        (1.0, 1.0),
        (1e-3, 3.0),
        (20.0, 9.0),
    ] {
        let given = format!("M0 -{short}A100 {short} 0 0 1 0 {short}");
        let drawing = bowed(&given, Some(tolerance));
        let stated = drawing.error().peak();
        assert!(stated <= tolerance, "{given}: {stated}");
        let printed = path::data_of_courses(drawing.courses(), false);
        let ellipse: Vec<Point> = (-500..=500)
            .map(|i| {
                let (sin, cos) = (f64::from(i) / 1000.0 * std::f64::consts::PI).sin_cos();
                Point::new(100.0 * cos, short * sin)
            })
            .collect();
        let found = points_apart(&ellipse, &ends(&chords(&printed)), 1);
        assert!(found <= stated + 1e-3, "{given}: {found} beyond {stated}");
    }
}

#[test]
fn circles_of_others_become_the_circles_that_were_meant() {
    for (data, radius) in [
        (
            "M22 12c0 5.5192-4.4808 10-10 10C6.4808 22 2 17.5192 2 12 2 6.4808 6.4808 2 12 2 17.5192 2 22 6.4808 22 12Z",
            "10",
        ),
        (
            "M22 12c0 5.523-4.477 10-10 10S2 17.523 2 12 6.477 2 12 2s10 4.477 10 10z",
            "10",
        ),
        (
            "M7.5 0C7.5 4.1 4.1 7.5 0 7.5S-7.5 4.1-7.5 0-4.1-7.5 0-7.5 7.5-4.1 7.5 0Z",
            "7.5",
        ),
    ] {
        let found = bowed_data(data, None);
        let arc = format!("A{radius} {radius} 0 ");
        assert_eq!(found.matches(&arc).count(), 2, "{found}");
        assert_eq!(found.matches('A').count(), 2, "{found}");
        assert!(found.ends_with('Z'));
    }
}

#[test]
fn a_rounded_rectangle_keeps_its_lines_and_its_corners() {
    let data = "M4 0H20C22.209 0 24 1.791 24 4V24H0V4C0 1.791 1.791 0 4 0Z";
    assert_eq!(
        bowed_data(data, None),
        "M4 0L20 0A4 4 0 0 1 24 4L24 24L0 24L0 4A4 4 0 0 1 4 0Z"
    );
}

#[test]
fn a_quarter_of_an_ellipse_takes_at_most_twelve_arcs() {
    let drawing = bowed("M1 0A1 0.5 0 0 1 0 0.5", Some(1e-4));
    let steps = drawing
        .courses()
        .map(|course| course.steps.len())
        .sum::<usize>();
    assert!(steps <= 12, "{steps}");
    assert!(drawing.error().peak() <= 1e-4);
}

#[test]
fn corners_and_cusps_and_dots_stay() {
    let corner = "M0 0C10 0 10 0 10 10C10 0 10 0 20 0";
    let found = bowed_data(corner, Some(0.01));
    assert!(found.contains(" 10 10A"), "{found}");
    let cusp = bowed("M0 0C100 100 0 100 100 0", Some(0.01));
    assert!(cusp.error().peak() <= 0.01);
    assert_eq!(bowed_data("M5 5C5 5 5 5 5 5Z", None), "M5 5L5 5Z");
}

#[test]
fn the_program_draws_arcs_for_machines() {
    let circle = "M10 0C10 5.523 5.523 10 0 10S-10 5.523-10 0-5.523-10 0-10 10-5.523 10 0Z";
    let gcode = printed(&["path", circle, "--to", "arcs", "-f", "gcode"]);
    assert_eq!(gcode.matches("G3 ").count(), 2, "{gcode}");
    assert!(gcode.contains("X-10 Y0 I-10 J0"), "{gcode}");
    let dxf = printed(&["path", circle, "--to", "arcs", "-f", "dxf"]);
    assert!(dxf.contains("LWPOLYLINE"), "{dxf}");
    let json = printed(&["path", circle, "--to", "arcs", "-f", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let arc = &json["subpaths"][0]["segments"][0]["arc"];
    assert_eq!(arc["radii"][0].as_f64(), Some(10.0));
    assert_eq!(arc["to"][0].as_f64(), Some(-10.0));
    // A picture holds the arcs themselves, or draws them.
    let svg = printed(&["path", circle, "--to", "arcs", "-f", "svg"]);
    let data = r#"<path d="M10 0A10 10 0 0 1-10 0A10 10 0 0 1 10 0Z""#;
    assert!(
        svg.contains(data) && svg.contains(r#"viewBox="-10.1 "#),
        "{svg}"
    );
    let shown = printed(&[
        "path", circle, "--to", "arcs", "-f", "svg", "--show", "joints",
    ]);
    assert_eq!(shown.matches("<circle").count(), 2, "{shown}");
    let eps = printed(&["path", circle, "--to", "arcs", "-f", "eps"]);
    let cubics = eps
        .lines()
        .filter(|line| line.ends_with(" curveto") && !line.starts_with('%'));
    assert_eq!(cubics.count(), 32, "{eps}");
    let png = run(&["path", circle, "--to", "arcs", "-f", "png"]);
    assert!(png.stdout.starts_with(b"\x89PNG"));
    let refused = run(&["path", circle, "--to", "arcs", "-f", "ps"]);
    assert_eq!(refused.status.code(), Some(2));
    let relative = printed(&["path", circle, "--to", "arcs", "--relative"]);
    assert_eq!(relative, "M10 0a10 10 0 0 1-20 0a10 10 0 0 1 20 0z\n");
}

#[test]
fn a_machine_gets_no_moves_of_no_length() {
    for (data, moves) in [
        ("M0 0L.1 .1L.2 .3L10 10", "G0 X0 Y0\nG1 X10 Y10\n"),
        (
            "M9.8 5A5 5 0 0 1 5 9.8L5.2 10.1L5 20",
            "G0 X10 Y5\nG3 X5 Y10 I-5 J0\nG1 X5 Y20\n",
        ),
        // A dot stays one.
        ("M5 5L5.1 5L5 5", "G0 X5 Y5\nG1 X5 Y5\n"),
    ] {
        for to in ["arcs", "lines"] {
            if to == "lines" && data.contains('A') {
                continue;
            }
            let program = printed(&[
                "path", data, "--to", to, "-t", "2", "-p", "0", "-f", "gcode",
            ]);
            let (_, body) = program.split_once("G90\n").unwrap();
            assert_eq!(body.strip_suffix("M2\n"), Some(moves), "{data}");
        }
    }
}

#[test]
fn a_cubic_of_no_length_is_a_line_of_none() {
    for (data, expected) in [
        ("M1 1C1 1 1 1 1 1", "M1 1L1 1"),
        (
            "M0 0C0 0 10 0 10 0C10 0 10 0 10 0C10 0 10 0 0 -10",
            "M0 0L10 0L10 0L0-10",
        ),
    ] {
        for to in ["lines", "arcs"] {
            let found = printed(&["path", data, "--to", to, "-t", "0.01"]);
            assert_eq!(found.trim_end(), expected, "{data} to {to}");
        }
    }
    assert_eq!(
        printed(&["path", "M1 1C1 1 1 1 1 1M0 0L9 9", "--to", "lines"]).trim_end(),
        "M1 1L1 1M0 0L9 9"
    );
    // These went on for ever.
    for data in [
        "M0 0C0 0 0 0 0 0C1 -2 1 -2 0 0",
        "M0 0Q0 0 0 0C1 -1 1 0 1 -1",
        "M5 5L0 0C0 0 0 0 0 0C-10 -20 0 -10 0 -10",
        "M0 0Q0 0 0 0Q-1 -2 0 -1C1 -2 1 -2 0 -1",
    ] {
        for options in [&["-t", "0.016"][..], &["--elliptic", "-t", "0.001"], &[]] {
            let words = [&["path", data, "--to", "arcs"], options].concat();
            assert!(printed(&words).starts_with('M'), "{data}");
        }
    }
}

#[test]
fn whole_ellipses_are_found_by_all_of_their_cubics() {
    for (ellipse, expected) in [
        ("8 4 -p 1", "M8 0A8 4 0 0 1-8 0A8 4 0 0 1 8 0Z"),
        (
            "12.25 10 -p 3",
            "M12.25 0A12.25 10 0 0 1-12.25 0A12.25 10 0 0 1 12.25 0Z",
        ),
        (
            "24 12.25 -n 8 -p 3 --start 200",
            "M-22.553-4.19A24 12.25 0 0 1 22.553 4.19A24 12.25 0 0 1-22.553-4.19Z",
        ),
    ] {
        let drawn = printed(&words(&format!("ellipse {ellipse}")));
        let found = printed(&["path", drawn.trim_end(), "--to", "arcs", "--elliptic"]);
        assert_eq!(found.trim_end(), expected);
    }
}

/// The digits of a decimal number, as an integer of so many decimals.
fn scaled(text: &str, decimals: usize) -> u128 {
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    format!("{whole}{part:0<decimals$}").parse().unwrap()
}

#[test]
fn half_a_turn_is_drawn_with_no_radius_larger_than_its_own() {
    // One larger by 10^-16 moves the middle by 10^-8 of it.
    for (x, y) in [
        ("15.531", "18.4015314"),
        ("19.7", "18.5049047"),
        ("0.154", "16.452"),
        ("17.37", "11.7859429"),
        ("10", "0"),
        ("7.0710679", "7.0710679"),
    ] {
        for transform in ["scale(1)", "scale(1,-1)"] {
            let path = format!("M0 0A1 1 0 0 1 {x} {y}");
            let text = printed(&["path", &path, "--to", "arcs", "--transform", transform]);
            let (_, radius) = text.split_once('A').unwrap();
            let radius = radius.split(' ').next().unwrap();
            let [x, y, twice] = [scaled(x, 16), scaled(y, 16), 2 * scaled(radius, 16)];
            assert!(twice * twice <= x * x + y * y, "{text}");
            assert!(
                (twice + twice / 1_000_000_000_000).pow(2) > x * x + y * y,
                "{text}"
            );
        }
    }
    let ten = printed(&["path", "M0 0A1 1 0 0 1 10 0", "--to", "arcs"]);
    assert_eq!(ten.trim_end(), "M0 0A5 5 0 0 1 10 0");
    let given = "M50 0A50 20 0 0 1-50 0A50 20 0 0 1 50 0Z";
    let kept = printed(&["path", given, "--to", "arcs", "--elliptic"]);
    assert_eq!(kept.trim_end(), given);
}

#[test]
fn few_decimals_are_refused_only_where_they_move_something() {
    let circle = "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z";
    let coarse = ["--to", "arcs", "-t", "0.01", "-p", "0"];
    let path = |data| [&["path", data], &coarse[..]].concat();
    assert_eq!(printed(&path(circle)).trim_end(), circle);
    for moved in [
        "M50.3 0A50 50 0 0 1-50 0A50 50 0 0 1 50.3 0Z",
        "M50 0A50 20 0 0 1-50 0A50 20 0 0 1 50 0Z",
        "M50 0C50 27.6 27.6 50 0 50",
    ] {
        let refused = run(&path(moved));
        assert_eq!(refused.status.code(), Some(2), "{moved}");
        let said = String::from_utf8(refused.stderr).unwrap();
        assert!(
            said.starts_with("error: rounding alone moves a point by up to 0.707"),
            "{said}"
        );
    }
}

#[test]
fn a_tolerance_finer_than_digits_is_refused_with_one_that_serves() {
    let path = ["path", "M5 0C5 2.76 2.76 5 0 5", "--to", "arcs", "-t"];
    let refused = run(&[&path[..], &["1e-18"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    let serves = "0.0000000000002";
    assert_eq!(
        String::from_utf8(refused.stderr).unwrap(),
        format!(
            "error: the tolerance 1e-18 is finer than the digits of a double-precision coordinate\n\
             hint: take a larger tolerance, as -t {serves}\n"
        )
    );
    assert!(printed(&[&path[..], &[serves]].concat()).starts_with("M5 0A"));
}

#[test]
fn rounding_explains_no_more_than_a_hundredth_of_a_circle() {
    // A handle of 4 in place of 4.42: 0.22 off.
    let squircle = "M4 12C4 8 8 4 12 4C16 4 20 8 20 12C20 16 16 20 12 20C8 20 4 16 4 12Z";
    // 28 in place of 27.6: 0.2 off, of 50.
    let circle = "M0 50C0 22 22 0 50 0C78 0 100 22 100 50C100 78 78 100 50 100C22 100 0 78 0 50Z";
    let drawn = |data| {
        let drawing = arcs(&path::contours(data).unwrap(), &Options::default()).unwrap();
        (drawing.subpaths[0].count(), drawing.error().peak())
    };
    let (count, error) = drawn(squircle);
    assert!(count > 2 && error < 0.09, "{count} {error}");
    let (count, error) = drawn(circle);
    assert!(count == 2 && error < 0.21, "{count} {error}");
}

#[test]
fn the_tolerance_that_is_named_for_many_curves_is_no_wider_than_it_has_to_be() {
    let many = format!("M0 0{}", "a1 1 0 0 1 2 0".repeat(4000));
    let contours = path::contours(&many).unwrap();
    let within = |tolerance| {
        let tolerance = Some(Tolerance::Absolute(tolerance));
        curveto::arcs::lines(
            &contours,
            &Options {
                tolerance,
                ..Default::default()
            },
        )
    };
    let Err(curveto::Error::TooManySegments { enough, .. }) = within(1e-9) else {
        panic!("not refused");
    };
    assert!(within(enough).is_ok(), "{enough}");
    assert!(within(enough / 4.0).is_err(), "{enough}");
}
