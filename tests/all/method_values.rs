//! Every method against the reference values of fixtures/reference/methods.json, computed elsewhere with 60 digits.

use curveto::method::{Degree, Span};
use curveto::{Method, Rule};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_str().unwrap().parse().unwrap()
}

fn degrees(name: &str) -> f64 {
    match name {
        "pi" => 180.0,
        "2pi/3" => 120.0,
        "pi/2" => 90.0,
        "pi/3" => 60.0,
        "pi/4" => 45.0,
        "pi/6" => 30.0,
        "1deg" => 1.0,
        _ => panic!("unknown angle {name}"),
    }
}

#[test]
fn every_method_gives_its_reference_values() {
    let text = include_str!("../../fixtures/reference/methods.json");
    let reference: Value = serde_json::from_str(text).unwrap();
    let mut compared = 0;
    for entry in reference["methods"].as_array().unwrap() {
        let id = entry["id"].as_str().unwrap();
        let method: Method = id.parse().unwrap();
        for (angle, values) in entry["values"].as_object().unwrap() {
            let span = Span::from_degrees(degrees(angle));
            if values.is_null() {
                continue;
            }
            let piece = method.piece(&span).unwrap();
            let error = method.radial_error(&span).unwrap();
            let close = |ours: f64, theirs: f64, what: &str| {
                let off = (ours - theirs).abs();
                assert!(
                    off <= 2e-15 * theirs.abs(),
                    "{id} at {angle}: {what} {ours} against {theirs}"
                );
            };
            let first = &values["control_points"][1];
            close(piece.handle.x, number(&first[0]), "P1.x");
            close(piece.handle.y, number(&first[1]), "P1.y");
            close(
                piece.end_radius,
                number(&values["end_radius"]),
                "end radius",
            );
            let near = |ours: f64, theirs: f64, what: &str| {
                let off = (ours - theirs).abs();
                assert!(
                    off <= 1e-12 || off <= 1e-9 * theirs.abs(),
                    "{id} at {angle}: {what} {ours:e} against {theirs:e}"
                );
            };
            near(error.peak(), number(&values["max_abs"]), "peak");
            near(
                error.outward,
                number(&values["max_out"]).max(0.0),
                "outward",
            );
            near(error.inward, -number(&values["max_in"]).min(0.0), "inward");
            compared += 1;
        }
    }
    assert!(compared > 150, "only {compared} compared");
}

/// What the cards advise.
#[test]
fn the_advice_holds_where_it_compares() {
    let peak = |id: &str, degrees: f64| {
        let method: Method = id.parse().unwrap();
        let span = Span::from_degrees(degrees);
        method.radial_error(&span).unwrap().peak()
    };
    for count in [2.0, 3.0, 4.0, 5.0, 6.0, 8.0] {
        let degrees = 360.0 / count;
        assert!(peak("minimax", degrees) < peak("lancaster-best", degrees));
    }
    for degrees in [1.0, 45.0, 90.0] {
        let share = |id, of| peak(id, degrees) / peak(of, degrees);
        assert!((share("minimax-g0", "minimax") - 0.35).abs() < 0.02);
        assert!((share("minimax-free", "minimax") - 0.7).abs() < 0.01);
        assert!((share("curvature-scaled", "curvature") - 0.5).abs() < 0.001);
        assert!((0.12..0.18).contains(&share("quadratic-minimax", "quadratic-tangent")));
    }
    assert!(peak("goldapp", 90.0) < 1.0002 * peak("minimax", 90.0));
}

/// Where an arc is straight but for what no digit shows, cubics have handles of a third of it, and quadratics of a half; `apprich-plus` has its
/// own. What they err by is the law of the catalogue.
#[test]
fn tiny_arcs_have_the_handles_and_errors_of_their_limit() {
    let powers = (-323..=-6).map(|exponent| format!("1e{exponent}").parse().unwrap());
    let gauss = Rule::CHEN_2_GAUSS_2;
    let rules = Method::ALL.into_iter().map(Rule::from).chain([gauss]);
    let rules: Vec<Rule> = rules.collect();
    for degrees in powers.chain([0.0, 5e-324, 1.5e-320]) {
        let span = Span::from_degrees(degrees);
        for (rule, method) in rules.iter().filter_map(|rule| Some((rule, rule.method()?))) {
            let Some(law) = method.card().law else {
                assert!(rule.piece(&span).is_err(), "{method}");
                continue;
            };
            let part = match method.card().degree {
                Degree::Quadratic => 0.5,
                _ if method == Method::ApprichPlus => 0.6,
                Degree::Cubic => 1.0 / 3.0,
            };
            let piece = rule.piece(&span).unwrap();
            assert_eq!((piece.end_radius, piece.handle.x), (1.0, 1.0), "{method}");
            let off = (piece.handle.y - part * span.a).abs();
            assert!(
                off <= 1e-15 * span.a + 1e-323,
                "{method} {degrees}: {off:e}"
            );
            let right = law.constant * span.a.powi(law.order.into());
            let peak = rule.radial_error(&span).unwrap().peak();
            let off = (peak - right).abs();
            assert!(off <= 1e-9 * right + 1e-323, "{method} {degrees}: {peak:e}");
        }
    }
}
