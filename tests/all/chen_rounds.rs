//! Chen's Formulation II round by round: his Figure 8.

use curveto::kurbo::{CubicBez, ParamCurveArclen};
use serde_json::Value;

use crate::judges::program::{json, refused};

/// The lengths of a segment of the unit circle, from the chord on: (16) with the circle's tangents, until one changes by less than
/// `stop` of itself.
fn rounds(degrees: f64, stop: f64) -> Vec<f64> {
    let (s, c) = degrees.to_radians().sin_cos();
    let mut lengths = vec![(2.0 - 2.0 * c).sqrt()];
    loop {
        let t = lengths[lengths.len() - 1];
        let k = t / 3.0;
        let cubic = CubicBez::new((1.0, 0.0), (1.0, k), (c + k * s, s - k * c), (c, s));
        let next = cubic.arclen(1e-14);
        lengths.push(next);
        if (next - t).abs() < stop * next {
            return lengths;
        }
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    let values = value.as_array().unwrap().iter();
    values.map(|value| value.as_f64().unwrap()).collect()
}

#[test]
fn the_rounds_of_formulation_2_are_those_of_figure_8() {
    let uneven: &[&str] = &["arc", "2", "--sweep", "100", "--joints", "30"];
    for (words, spans) in [
        (&["circle", "2"][..], &[90.0; 4][..]),
        (uneven, &[30.0, 70.0]),
    ] {
        for stop in ["1e-2", "1e-6"] {
            let drawing = json(&[words, &["-m", "chen-2", "--stop", stop]].concat());
            let lengths: Vec<Vec<f64>> = drawing["lengths"]
                .as_array()
                .unwrap()
                .iter()
                .map(numbers)
                .collect();
            let known: Vec<Vec<f64>> = spans
                .iter()
                .map(|&degrees| rounds(degrees, stop.parse().unwrap()))
                .collect();
            let most = known.iter().map(Vec::len).max().unwrap();
            assert_eq!(lengths.len(), most, "{words:?} {stop}");
            assert_eq!(drawing["rounds"], most - 1);
            for (i, row) in lengths.iter().enumerate() {
                assert_eq!(row.len(), spans.len());
                for (length, column) in row.iter().zip(&known) {
                    // What has settled stays.
                    let known = 2.0 * column[i.min(column.len() - 1)];
                    assert!(
                        (length - known).abs() < 1e-12,
                        "{words:?} {stop}: {length} {known}"
                    );
                }
            }
            // The last lengths are the nodal derivatives that are drawn.
            for (segment, t) in drawing["segments"]
                .as_array()
                .unwrap()
                .iter()
                .zip(&lengths[most - 1])
            {
                let d = numbers(&segment["derivatives"][0]);
                assert!((d[0].hypot(d[1]) - t).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn formulation_2_lists_no_lengths_where_it_has_none_of_its_own() {
    assert!(json(&["circle", "1", "-m", "chen-3"])["lengths"].is_null());
    assert!(json(&["ellipse", "2", "1", "-m", "chen-2"])["lengths"].is_null());
    let many = json(&["circle", "1", "-m", "chen-2", "-n", "1001"]);
    assert!(many["rounds"].is_null() && many["lengths"].is_null());
    let gauss = json(&["circle", "1", "-m", "chen-2", "--quadrature", "gauss2"]);
    let last = gauss["lengths"].as_array().unwrap().last().unwrap();
    assert!((numbers(last)[0] - 2.4_f64.sqrt()).abs() < 1e-12);
}

#[test]
fn a_criterion_for_what_iterates_nothing_is_refused() {
    for words in [
        &["circle", "1"][..],
        &["arc", "1", "--sweep", "90", "-m", "chen-3"],
    ] {
        let message = refused(&[words, &["--stop", "1e-3"]].concat());
        assert!(
            message.contains("hint: --stop goes with -m chen-2"),
            "{message}"
        );
    }
    assert!(refused(&["circle", "1", "-m", "chen-2", "--stop", "0"]).contains("positive"));
}
