//! What the three documents say beyond the methods: their tables, procedures and figures, each by a command.

use serde_json::Value;

use crate::judges::program::{json, printed, refused};

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn samples_are_the_points_of_the_curve_beside_the_circle() {
    let k = 0.551_784;
    let found = json(&[
        "measure",
        "arc",
        "1",
        "--start",
        "0",
        "--end",
        "90",
        "-m",
        "lancaster-best",
        "--samples",
        "91",
    ]);
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 91);
    for (i, sample) in samples.iter().enumerate() {
        let t = i as f64 / 90.0;
        let u = 1.0 - t;
        let x = u * u * u + 3.0 * u * u * t + 3.0 * u * t * t * k;
        let y = 3.0 * u * u * t * k + 3.0 * u * t * t + t * t * t;
        let expected = [
            ("t", t),
            ("x", x),
            ("y", y),
            ("radius", x.hypot(y)),
            ("error", x.hypot(y) - 1.0),
            ("degrees", y.atan2(x).to_degrees()),
        ];
        for (key, value) in expected {
            assert!((number(&sample[key]) - value).abs() < 1e-13, "{key} at {t}");
        }
    }
}

#[test]
fn samples_of_an_ellipse_err_along_its_normal() {
    let found = json(&["measure", "ellipse", "3", "1", "-n", "5", "--samples", "33"]);
    let peak = number(&json(&["measure", "ellipse", "3", "1", "-n", "5"])["error"]["peak"]);
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 5 * 33);
    let largest = samples
        .iter()
        .map(|s| number(&s["error"]).abs())
        .fold(0.0, f64::max);
    assert!(largest <= peak && largest > 0.9 * peak, "{largest} {peak}");
    // The distance from the centre is another figure.
    assert!((number(&samples[16]["radius"]) - number(&samples[16]["error"]) - 1.0).abs() > 0.1);
}

#[test]
fn samples_as_a_table_and_csv_say_the_same() {
    let words = [
        "measure",
        "circle",
        "50",
        "-m",
        "midpoint,minimax",
        "--samples",
        "3",
    ];
    let csv = printed(&[&words[..], &["-f", "csv"]].concat());
    assert_eq!(csv.lines().count(), 1 + 2 * 4 * 3);
    assert!(csv.starts_with("subject,method,segment,t,x,y,radius,error,degrees\n"));
    let table = printed(&words);
    assert_eq!(table.matches("of 12 points: peak").count(), 2, "{table}");
    assert!(refused(&["measure", "circle", "1", "--samples", "1"]).contains("from 2"));
    assert!(refused(&["measure", "circle", "1", "--samples", "99999999"]).contains("2500000"));
}
