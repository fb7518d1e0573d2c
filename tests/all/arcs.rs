//! `path --to lines`: the tolerance holds both ways, by points sampled densely, and the chords are few.

use curveto::arcs::{Options, lines};
use curveto::contour::{Contour, PathDrawing, Step};
use curveto::kurbo::{ParamCurve, PathSeg, Point};
use curveto::{Tolerance, path};
use proptest::prelude::*;

use crate::judges::program::{printed, run};

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

/// The largest distance of the sampled points of each from the other.
fn apart(a: &[PathSeg], b: &[PathSeg]) -> f64 {
    let (a, b) = (sampled(a), sampled(b));
    let one_way =
        |from: &[Point], to: &[Point]| from.iter().map(|&p| from_chords(p, to)).fold(0.0, f64::max);
    one_way(&a, &b).max(one_way(&b, &a))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn lines_stay_within_the_tolerance_both_ways(
        numbers in prop::collection::vec(-100.0..100.0_f64, 8),
        tolerance in 0.05..5.0_f64,
    ) {
        let [x, y, rest @ ..] = &numbers[..] else { unreachable!() };
        let rest: Vec<String> = rest.iter().map(f64::to_string).collect();
        let data = format!("M{x} {y}C{}", rest.join(" "));
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
    ] {
        let piece = given(&path::contours(data).unwrap()[0])[0];
        for tolerance in [5.0, 1.0, 0.2] {
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
