//! Requests that once took forever, drew too much or strayed too far, by their right answers; those about stated errors alone are in
//! `stated_errors` and `truth`.

use std::time::{Duration, Instant};

use serde_json::Value;

use crate::judges::oracle::{self, Point, int, real, to_f64};
use crate::judges::program::{json, printed, refused, run};

fn segments(document: &Value) -> &Vec<Value> {
    document["segments"].as_array().unwrap()
}

#[test]
fn a_tolerance_near_the_digits_is_kept_by_the_decimals_that_are_printed() {
    let (radius, tolerance) = (2669.3, 9.237e-12);
    let words = ["circle", "2669.3", "-t", "9.237e-12"];
    assert!(json(&words)["error"]["peak"].as_f64().unwrap() <= tolerance);
    // Numbers are read by the standard library, which serde_json and kurbo round otherwise.
    let path = printed(&words).replace('-', " -");
    let numbers: Vec<f64> = path
        .split(|c: char| c.is_whitespace() || c.is_ascii_alphabetic())
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect();
    let points: Vec<Point> = numbers
        .chunks(2)
        .map(|p| [real(p[0]), real(p[1])])
        .collect();
    assert_eq!(points.len() % 3, 1);
    for first in (0..points.len() - 1).step_by(3 * 7) {
        let (outward, inward) =
            oracle::radial_extremes(&points[first..first + 4], [int(0), int(0)], &real(radius));
        let peak = to_f64(&outward).max(to_f64(&inward));
        assert!(peak <= tolerance, "{peak:e}");
    }
}

#[test]
fn odd_counts_and_joints_off_the_axes_are_tried() {
    let of = |words: &str| {
        let words: Vec<&str> = words.split(' ').collect();
        segments(&json(&words)).len()
    };
    assert_eq!(of("ellipse 100 9.149 -t 0.005"), 5);
    assert_eq!(of("arc 100 0.6193 --start 0 --sweep 284 -t 0.0399"), 2);
}

#[test]
fn a_hundred_thousand_segments_are_found_in_time() {
    let start = Instant::now();
    let path = printed(&["circle", "11668.77", "-m", "apprich-plus", "-t", "4.76e-06"]);
    assert!((90_000..110_000).contains(&path.matches('C').count()));
    // Within a second by the optimised program on an idle machine; it took minutes.
    assert!(start.elapsed() < Duration::from_secs(60));
}

#[test]
fn convert_rounds_a_circle_off_the_grid_as_the_single_command_does() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("circle.svg");
    let svg =
        r#"<svg xmlns="http://www.w3.org/2000/svg"><circle cx="10.5" cy="10.5" r="3.5"/></svg>"#;
    std::fs::write(&file, svg).unwrap();
    let converted = printed(&["convert", "-t", "0.6", "-p", "0", file.to_str().unwrap()]);
    let single = [
        "circle",
        "3.5",
        "--center",
        "10.5,10.5",
        "-t",
        "0.6",
        "-p",
        "0",
    ];
    let path = |data: &str| kurbo::BezPath::from_svg(data).unwrap();
    let data = converted.split(" d=\"").nth(1).unwrap();
    let data = data.split('"').next().unwrap();
    assert_eq!(path(data), path(printed(&single).trim()));
    let peak = json(&single)["error"]["peak"].as_f64().unwrap();
    assert!((0.25..0.250_001).contains(&peak), "{peak}");
}

#[test]
fn elliptical_arcs_that_rounding_spoils_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arcs.svg");
    let arcs = r#"<path d="M1 2a7 4 30 0 1 3 2"/>"#.repeat(10);
    let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{arcs}</svg>"#);
    std::fs::write(&file, &svg).unwrap();
    let start = Instant::now();
    let output = run(&["convert", "-t", "0.001", "-p", "2", file.to_str().unwrap()]);
    // Each took 30 ms by the optimised program, which now takes 0.15.
    assert!(start.elapsed() < Duration::from_secs(5));
    assert_eq!(String::from_utf8(output.stdout).unwrap().trim(), svg);
    let notes = String::from_utf8(output.stderr).unwrap();
    assert_eq!(
        notes.matches("rounding to 2 decimals").count(),
        10,
        "{notes}"
    );
}

#[test]
fn handles_and_angles_beyond_what_is_said_are_refused() {
    for (words, said) in [
        ("circle 5 --handle 1e153 -n 4", "at most 1e9"),
        ("circle 5 --handle 1e308 -t 1e-6", "at most 1e9"),
        (
            "arc 10 --start 0 --sweep 121 -m chen-1 -n 1",
            "beyond its largest, 120 degrees",
        ),
    ] {
        let words: Vec<&str> = words.split(' ').collect();
        let message = refused(&words);
        assert!(
            message.contains(said) && message.contains("error: "),
            "{message}"
        );
    }
}
