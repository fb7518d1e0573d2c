//! Every method of the catalogue by its id alone, as a script would take it from `curveto methods -f json`: the ids draw in every
//! format, and what a method cannot do is refused with a hint that holds.

use serde_json::Value;

use crate::judges::program::{drawn as drawn_by, printed, run};

fn catalogue() -> Vec<Value> {
    let catalogue: Value = serde_json::from_str(&printed(&["methods", "-f", "json"])).unwrap();
    catalogue["methods"].as_array().unwrap().clone()
}

fn id(entry: &Value) -> &str {
    entry["id"].as_str().unwrap()
}

/// The numbers in a line of PostScript.
fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace()
        .filter_map(|word| word.parse().ok())
        .collect()
}

#[test]
fn every_method_draws_a_circle_in_every_format() {
    let mut drawn = 0;
    for entry in catalogue() {
        if entry["closed"] != true {
            continue;
        }
        let id = id(&entry);
        let quadratic = entry["degree"] == 2;
        let letter = if quadratic { 'Q' } else { 'C' };
        for format in ["path", "svg", "ps", "eps", "json", "png"] {
            let drawing = drawn_by(&format!("circle 40 -m {id} -f {format} -p 6"));
            let words = String::from_utf8_lossy(&drawing);
            match format {
                "path" => {
                    assert!(words.starts_with('M') && words.ends_with("Z\n"), "{id}");
                    assert_eq!(words.matches(letter).count(), 4, "{id}: {words}");
                }
                "svg" => {
                    let at = words.find(" d=\"M").unwrap();
                    assert!(words[at..].contains(letter), "{id}: {words}");
                }
                "ps" | "eps" => {
                    let curves = |line: &&str| line.ends_with(" curveto") && !line.starts_with('%');
                    assert_eq!(words.lines().filter(curves).count(), 4, "{id}: {words}");
                    assert!(words.contains("closepath"), "{id}");
                }
                "json" => {
                    let drawing: Value = serde_json::from_str(&words).unwrap();
                    assert_eq!(drawing["method"], id);
                    let points = drawing["segments"][0]["points"].as_array().unwrap().len();
                    assert_eq!(points, if quadratic { 3 } else { 4 });
                }
                _ => assert!(drawing.starts_with(b"\x89PNG"), "{id}"),
            }
            drawn += 1;
        }
    }
    assert_eq!(drawn, 28 * 6);
}

#[test]
fn postscript_raises_quadratics_to_the_same_curve() {
    for entry in catalogue() {
        if entry["degree"] != 2 {
            continue;
        }
        let shape = ["circle", "40", "--start", "0", "-m", id(&entry)];
        let json = printed(&[&shape[..], &["--reverse", "-f", "json"]].concat());
        let json: Value = serde_json::from_str(&json).unwrap();
        let ps = printed(&[&shape[..], &["-f", "ps", "-p", "15"]].concat());
        let lines = ps.lines().filter(|line| line.ends_with("curveto"));
        for (segment, line) in json["segments"].as_array().unwrap().iter().zip(lines) {
            let point = |i: usize, axis: usize| segment["points"][i][axis].as_f64().unwrap();
            let raised: Vec<f64> = [(0, 1), (2, 1)]
                .iter()
                .flat_map(|&(end, inner)| {
                    [0, 1].map(|axis| (point(end, axis) + 2.0 * point(inner, axis)) / 3.0)
                })
                .chain([point(2, 0), point(2, 1)])
                .collect();
            for (ours, theirs) in numbers(line).iter().zip(&raised) {
                assert!((ours - theirs).abs() < 2e-14, "{line} against {raised:?}");
            }
            assert_eq!(numbers(line).len(), 6);
        }
    }
}

/// The corner that a drawing and the catalogue state is that of the reference values.
#[test]
fn corners_are_stated_in_degrees_where_there_are_any() {
    let reference = include_str!("../../fixtures/reference/methods.json");
    let reference: Value = serde_json::from_str(reference).unwrap();
    let counts = [
        ("pi", "2"),
        ("2pi/3", "3"),
        ("pi/2", "4"),
        ("pi/3", "6"),
        ("pi/4", "8"),
    ];
    let mut corners = 0;
    for entry in catalogue() {
        let id = id(&entry);
        let known = reference["methods"].as_array().unwrap();
        let Some(known) = known.iter().find(|known| known["id"] == id) else {
            assert_eq!(entry["quarter"]["corner"], 0);
            continue;
        };
        for (angle, count) in counts {
            let values = &known["values"][angle];
            if values.is_null() {
                continue;
            }
            let corner = values["joint_corner_deg"].as_str().unwrap();
            let corner = corner.parse::<f64>().unwrap().abs();
            let drawing = printed(&["circle", "1", "-m", id, "-n", count, "-f", "json"]);
            let drawing: Value = serde_json::from_str(&drawing).unwrap();
            let near = |stated: &Value| (stated.as_f64().unwrap() - corner).abs() < 1e-9;
            if entry["continuity"]["equal"] == "G0" {
                assert!(near(&drawing["corner"]), "{id} -n {count}: {drawing}");
                corners += 1;
            } else {
                assert!(drawing["corner"].is_null() && corner < 1e-12, "{id}");
            }
            if angle == "pi/2" {
                assert!(near(&entry["quarter"]["corner"]), "{id}: {entry}");
            }
        }
    }
    assert!(corners >= 25, "only {corners} compared");
}

/// A request, and the methods that cannot meet it.
type Request = (&'static str, &'static [&'static str]);

const FREE: &[&str] = &[
    "minimax-free",
    "minimax-ellipse-free",
    "apprich-scaled",
    "curvature-scaled",
    "minimax-g0-free",
    "quadratic-minimax-free",
];

const REQUESTS: [Request; 9] = [
    ("circle 5 -n 4", &[]),
    ("circle 5 -t 0.1", &[]),
    (
        "circle 5 -n 2",
        &[
            "apprich",
            "apprich-plus",
            "apprich-scaled",
            "chen-1",
            "lancaster-drawellipse",
            "quadratic-tangent",
        ],
    ),
    (
        "circle 5 -n 7",
        &["lancaster-best", "lancaster-drawellipse"],
    ),
    ("circle 5 -n 3", &["lancaster-drawellipse"]),
    ("arc 5 --end 90", FREE),
    (
        "arc 5 --end 180 -n 1",
        &[
            "chen-1",
            "apprich",
            "apprich-plus",
            "apprich-scaled",
            "curvature-scaled",
            "lancaster-drawellipse",
            "minimax-free",
            "minimax-ellipse-free",
            "minimax-g0-free",
            "quadratic-minimax-free",
            "quadratic-tangent",
        ],
    ),
    (
        "circle 5 --joints 0,50,120,180,300",
        &[
            "minimax-free",
            "minimax-ellipse-free",
            "apprich-scaled",
            "curvature-scaled",
            "minimax-g0-free",
            "quadratic-minimax-free",
            "lancaster-best",
            "lancaster-drawellipse",
        ],
    ),
    (
        "arc 5 --end 60 -n 1",
        &[
            "minimax-free",
            "minimax-ellipse-free",
            "apprich-scaled",
            "curvature-scaled",
            "minimax-g0-free",
            "quadratic-minimax-free",
            "lancaster-drawellipse",
        ],
    ),
];

#[test]
fn what_a_method_cannot_do_is_refused_with_a_hint_that_holds() {
    let mut refused = 0;
    for entry in catalogue() {
        let id = id(&entry);
        for (request, cannot) in REQUESTS {
            let words: Vec<&str> = request.split(' ').collect();
            let ask = |method: &str| run(&[&words[..], &["-m", method]].concat());
            let output = ask(id);
            let complaint = String::from_utf8(output.stderr).unwrap();
            if !cannot.contains(&id) {
                assert!(output.status.success(), "{request} -m {id}: {complaint}");
                assert!(complaint.is_empty(), "{complaint}");
                continue;
            }
            refused += 1;
            assert_eq!(output.status.code(), Some(2), "{request} -m {id}");
            assert!(output.stdout.is_empty());
            let opening = format!("error: {id} cannot do this: ");
            assert!(complaint.starts_with(&opening), "{complaint}");
            assert!(!complaint.contains("000000"), "{complaint}");
            let (_, hint) = complaint.split_once("\nhint: ").unwrap();
            let Some((_, named)) = hint.split_once("-m ") else {
                panic!("{complaint} names no method");
            };
            let named: Vec<&str> = named
                .split([',', ' ', '\n'])
                .filter(|word| catalogue_has(word))
                .collect();
            assert!(!named.is_empty(), "{complaint}");
            for other in named {
                assert!(
                    ask(other).status.success(),
                    "{request} -m {id}: the hint names {other}, which cannot do it either: {complaint}"
                );
            }
        }
    }
    assert_eq!(
        refused,
        REQUESTS
            .iter()
            .map(|(_, cannot)| cannot.len())
            .sum::<usize>()
    );
}

fn catalogue_has(name: &str) -> bool {
    name.parse::<curveto::Method>().is_ok()
}

#[test]
fn chens_printed_error_comes_out_with_his_quadrature() {
    let error = |arguments: &[&str]| -> f64 {
        let shape = ["circle", "1", "-n", "4", "-m", "chen-2", "-f", "json"];
        let json = printed(&[&shape[..], arguments].concat());
        let json: Value = serde_json::from_str(&json).unwrap();
        json["error"]["peak"].as_f64().unwrap()
    };
    assert!((error(&["--quadrature", "gauss2"]) - 0.019_031_9).abs() < 5e-8);
    assert!((error(&[]) - 0.017_695_683_7).abs() < 5e-11);
    let output = run(&["circle", "1", "-m", "chen-3", "--quadrature", "gauss2"]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_catalogue_is_told_in_three_forms() {
    let entries = catalogue();
    let table = printed(&["methods"]);
    let csv = printed(&["methods", "-f", "csv"]);
    assert_eq!(csv.lines().count(), 29);
    for (entry, line) in entries.iter().zip(csv.lines().skip(1)) {
        let id = id(entry);
        assert!(line.starts_with(&format!("{id},")), "{line}");
        // Fields in quotes hold their commas; 24 columns are left.
        let outside: String = line.split('"').step_by(2).collect();
        assert_eq!(outside.matches(',').count(), 23, "{line}");
        let starts_a_line = |name: &str| {
            let mut lines = table.lines();
            lines.any(|line| line.trim_start().split(' ').next() == Some(name))
        };
        assert!(starts_a_line(id), "{id} is not in the table");
        for alias in entry["aliases"].as_array().unwrap() {
            let alias = alias.as_str().unwrap();
            assert!(starts_a_line(alias), "{alias} is not in the table");
            assert_eq!(printed(&["methods", alias]), printed(&["methods", id]));
        }
        let card = printed(&["methods", id]);
        assert!(card.starts_with(id), "{card}");
        assert!(
            card.lines()
                .chain(table.lines())
                .all(|l| l.chars().count() <= 100)
        );
        let own: Value = serde_json::from_str(&printed(&["methods", id, "-f", "json"])).unwrap();
        assert_eq!(&own, entry);
    }
    assert!(printed(&["methods", "chen-2"]).contains("0.0190319"));
}

#[test]
fn an_unknown_method_is_told_with_its_neighbours() {
    let output = run(&["methods", "minmax"]);
    assert_eq!(output.status.code(), Some(2));
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(complaint.contains("unknown method 'minmax'\nhint: did you mean minimax, "));
}

/// The peak error of a request, or nothing where it is refused; and its number of segments.
fn peak(words: &str, id: &str, option: &[&str]) -> Option<(f64, usize)> {
    let words: Vec<&str> = words.split(' ').collect();
    let output = run(&[&words[..], &["-m", id, "-f", "json"], option].concat());
    if output.status.code() == Some(2) {
        return None;
    }
    let drawing: Value = serde_json::from_slice(&output.stdout).unwrap();
    let count = drawing["segments"].as_array().unwrap().len();
    Some((drawing["error"]["peak"].as_f64().unwrap(), count))
}

#[test]
fn a_tolerance_gives_the_fewest_segments_of_every_method() {
    let mut met = 0;
    for entry in catalogue() {
        let id = id(&entry);
        for shape in ["circle 1", "arc 1 --end 90"] {
            for tolerance in [0.05, 0.02, 0.001, 0.000_28] {
                let option = ["-t", &tolerance.to_string()];
                let Some((error, count)) = peak(shape, id, &option) else {
                    let out_of_reach = id.starts_with("lancaster") || entry["open"] == false;
                    assert!(out_of_reach, "{shape} -m {id} -t {tolerance} is refused");
                    continue;
                };
                assert!(
                    error <= tolerance,
                    "{shape} -m {id} -t {tolerance}: {error}"
                );
                for fewer in 1..count {
                    if let Some((error, _)) = peak(shape, id, &["-n", &fewer.to_string()]) {
                        assert!(
                            error > tolerance,
                            "{shape} -m {id} -t {tolerance} has {count} segments where {fewer} do"
                        );
                    }
                }
                met += 1;
            }
        }
    }
    assert!(met > 170, "only {met} met");
}
