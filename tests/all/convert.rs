//! The promises of `document::convert`: what is replaced is drawn alike, what is not replaced keeps its bytes, and what cannot be
//! replaced safely is left with a note.

#![allow(clippy::too_many_lines, clippy::format_collect)]

use crate::judges::independent;
use crate::judges::program::is_golden;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use curveto::document::{self, Converted, ElementKind, Error, Only, Options};
use curveto::{Cut, Method, Rule, Tolerance};
use kurbo::ParamCurve as _;

/// The error of the default at 94.5 degrees, the widest single cubic, and what rounding adds.
const ERROR: f64 = 2.95e-4;

fn convert(text: &str) -> Converted<'_> {
    document::convert(text, &Options::default()).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn svg(inner: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">{inner}</svg>"#)
}

/// The new path data of one path.
fn path(d: &str) -> String {
    path_with(d, &Options::default())
}

fn path_with(d: &str, options: &Options) -> String {
    let text = format!("<svg><path d=\"{d}\"/></svg>");
    let converted = document::convert(&text, options).unwrap().text;
    converted
        .strip_prefix("<svg><path d=\"")
        .unwrap()
        .strip_suffix("\"/></svg>")
        .unwrap()
        .to_owned()
}

fn codes(text: &str) -> Vec<String> {
    convert(text)
        .notes
        .into_iter()
        .map(|note| note.reason.code().to_owned())
        .collect()
}

// ---- fixtures

fn fixtures() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/documents");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
        .filter(|path| !path.to_string_lossy().ends_with(".out.svg"))
        .collect();
    files.sort();
    files
}

#[test]
fn fixtures_become_their_golden_files() {
    for file in fixtures() {
        let text = std::fs::read_to_string(&file).unwrap();
        let converted = convert(&text);
        let mut notes = String::new();
        for note in &converted.notes {
            writeln!(
                notes,
                "{}:{}: <{}> {}: {}",
                note.line,
                note.column,
                note.element,
                note.reason.code(),
                note.reason
            )
            .unwrap();
        }
        for (extension, content) in [("out.svg", &*converted.text), ("notes", &notes)] {
            let golden = file.with_extension(extension);
            let is_kept = is_golden(&golden, content.as_bytes());
            assert!(is_kept, "{}, make golden:\n{content}", golden.display());
        }
    }
}

#[test]
fn fixtures_keep_every_other_byte_and_are_drawn_alike() {
    let mut drawn = 0;
    for file in fixtures() {
        let before = std::fs::read_to_string(&file).unwrap();
        let after = convert(&before).text;
        let name = file.display();
        if let Err(why) = independent::check(&before, &after, ERROR) {
            panic!("{name}: {why}");
        }
        if let (Some(a), Some(b)) = (
            independent::render(&before, 256),
            independent::render(&after, 256),
        ) {
            let off = independent::difference(&a, &b, 256, 1);
            assert!(off <= 64, "{name} is drawn otherwise: by {off} of 255");
            drawn += 1;
        }
    }
    assert!(2 * drawn > fixtures().len(), "{drawn}");
}

#[test]
fn a_second_conversion_finds_nothing() {
    for file in fixtures() {
        let text = std::fs::read_to_string(&file).unwrap();
        let once = convert(&text);
        let twice = convert(&once.text);
        assert_eq!(twice.replaced.total(), 0, "{}", file.display());
        assert_eq!(twice.text, once.text);
    }
}

// ---- path data

#[test]
fn the_end_point_keeps_its_own_text() {
    assert_eq!(
        path("M0 0a5 5 0 0 1 +5.0,5e0z"),
        "M0 0c2.7596 0 5 2.2404+5.0,5e0z"
    );
    assert!(path("M1 1A5 5 0 0 1 6.00,06 L2 2").ends_with(" 6.00,06 L2 2"));
}

#[test]
fn separators_and_leading_zeros_are_left_out_where_the_grammar_allows() {
    let out = path("M0 0a.5.5 0 00.5.5");
    assert_eq!(out, "M0 0c0 .27596.22404.5.5.5");
}

#[test]
fn a_repeated_arc_repeats_its_curve() {
    let out = path("M0 0a1 1 0 0 1 1 1 1 1 0 0 0 1 1");
    assert_eq!(out.matches('c').count(), 1, "{out}");
    let mixed = path("M0 0a1 1 0 0 1 1 1 0 1 0 0 1 3 3 1 1 0 0 1 1 1");
    let letters: String = mixed.chars().filter(char::is_ascii_alphabetic).collect();
    assert_eq!(letters, "Mclc", "{mixed}");
}

#[test]
fn a_smooth_curve_behind_an_arc_keeps_its_meaning() {
    assert!(path("M0 0a5 5 0 0 1 5 5s1 2 3 4").ends_with("c0 0 1 2 3 4"));
    assert!(path("M0 0A5 5 0 0 1 5 5S1 2 3 4").ends_with("C5 5 1 2 3 4"));
    assert!(path("M1 2a5 5 0 0 1 5 5S1 2 3 4").ends_with("C6 7 1 2 3 4"));
    assert!(path("M0 0a5 5 0 0 1 5 5s.1.2.3.4.5.6.7.8").ends_with("c0 0 .1.2.3.4s.5.6.7.8"));
    assert!(path("M1 2A5 5 0 0 1 5 5s1 2 3 4").ends_with("5 5c0 0 1 2 3 4"));
    // A current point that was summed has the digits of its numbers.
    assert!(path("M100.1 100.2a5 5 0 0 1 1.7 1.3S1 2 3 4").ends_with("C101.8 101.5 1 2 3 4"));
    // T reflects quadratics only.
    assert!(path("M0 0a5 5 0 0 1 5 5t1 2").ends_with("t1 2"));
    let quadratic = Options {
        rule: Rule::Method(Method::QuadraticMinimax),
        ..Options::default()
    };
    assert!(path_with("M0 0a5 5 0 0 1 5 5t1 2", &quadratic).ends_with("q0 0 1 2"));
    assert!(path_with("M0 0a5 5 0 0 1 5 5s1 2 3 4", &quadratic).ends_with("s1 2 3 4"));
}

#[test]
fn degenerate_arcs_follow_the_rules() {
    // users.md 6.
    assert_eq!(path("M0 0a0 5 0 0 1 5 5"), "M0 0l5 5");
    assert_eq!(path("M0 0A5 0 0 0 1 5 5"), "M0 0L5 5");
    assert_eq!(path("M0 0L9 9a5 5 0 1 1 0 0L1 1"), "M0 0L9 9L1 1");
    assert_eq!(path("M0 0L9 9A5 5 0 1 1 9 9z"), "M0 0L9 9z");
    assert_eq!(path("M5 5a5 5 0 1 1 0 0a5 5 0 1 1 0 0L1 1"), "M5 5L1 1");
    assert_eq!(path("M5 5A5 5 0 1 1 5 5A5 5 0 1 1 5 5L1 1"), "M5 5L1 1");
    // Negative radii count as positive, small ones are scaled up.
    assert_eq!(path("M0 0a-5 5 0 0 1 5 5"), path("M0 0a5 5 0 0 1 5 5"));
    assert_eq!(path("M0 0a1 1 0 0 1 10 0"), path("M0 0a5 5 0 0 1 10 0"));
}

#[test]
fn an_empty_arc_that_may_show_is_left() {
    for d in [
        "M5 5a5 5 0 1 1 0 0",
        "M0 0L1 1C1 2 3 4 5 5a5 5 0 1 1 0 0s1 2 3 4",
    ] {
        let text = svg(&format!(r#"<path d="{d}"/>"#));
        assert_eq!(convert(&text).text, text);
        assert!(codes(&text).iter().all(|code| code == "empty-arc"));
    }
    // Of several in a row, the first decides.
    for (before, after) in [
        ("M5 5a5 5 0 1 1 0 0a5 5 0 1 1 0 0z", "M5 5a5 5 0 1 1 0 0z"),
        ("M5 5A5 5 0 1 1 5 5A5 5 0 1 1 5 5z", "M5 5A5 5 0 1 1 5 5z"),
        ("M5 5a5 5 0 1 1 0 0A5 5 0 1 1 5 5", "M5 5a5 5 0 1 1 0 0"),
    ] {
        assert_eq!(path(before), after);
    }
    assert!(path("M5 5a5 5 0 1 1 0 0a5 5 0 0 1 5 5z").starts_with("M5 5c"));
}

#[test]
fn numbers_that_are_no_whole_arc_do_not_become_a_whole_curve() {
    assert!(path("M0 0a0 5 0 0 1 5 5 7 7x").ends_with("l5 5 a7 7x"));
    assert!(path("M0 0A5 5 0 0 1 5 5 5 5 0 0 1 9").ends_with(" 5 5 A5 5 0 0 1 9"));
    assert!(path("M0 0a5 5 0 0 1 5 5,1 1 2 2 3 3").ends_with(" 5a,1 1 2 2 3 3"));
    assert_eq!(path("M0 0L9 9A5 5 0 1 1 9 9 7 7"), "M0 0L9 9 A7 7");
}

#[test]
fn path_data_are_replaced_up_to_their_error() {
    let out = path("M0 0a5 5 0 0 1 5 5 L1 x a5 5 0 0 1 5 5");
    assert!(
        out.starts_with("M0 0c") && out.ends_with(" L1 x a5 5 0 0 1 5 5"),
        "{out}"
    );
    assert_eq!(
        codes(&svg(r#"<path d="M0 0 L1 x a5 5 0 0 1 5 5"/>"#)),
        ["path-error"]
    );
    // What comes after the last arc is no matter of ours.
    for rest in ["L1 x", "X"] {
        let d = format!("M0 0a5 5 0 0 1 5 5{rest}");
        assert!(path(&d).starts_with("M0 0c") && path(&d).ends_with(rest));
        assert!(codes(&svg(&format!(r#"<path d="{d}"/>"#))).is_empty());
    }
    for d in [
        "a5 5 0 0 1 5 5",
        "M0 0a5 5 0 2 1 5 5",
        "M0 0a5 5 0 0 1 5",
        "M0,,0a5 5 0 0 1 5 5",
    ] {
        assert_eq!(path(d), d);
    }
}

#[test]
fn what_is_too_large_is_left() {
    for d in [
        "M0 0A1e16 1e16 0 0 1 2e16 0",
        "M0 0A1e16 1e16 0 0 1 0 2e16",
        "M0 0a1e16 1e16 0 0 1 2e16 0",
        "M0 0a1e16 1e16 0 0 1 0 2e16",
        "M0 0a1e400 1 0 0 1 5 5",
        "M2e15 0A1 1 0 0 1 2e15 1",
    ] {
        assert_eq!(
            codes(&svg(&format!(r#"<path d="{d}"/>"#))),
            ["too-large"],
            "{d}"
        );
        assert_eq!(path(d), d);
    }
}

/// In single precision a point of such a shape lies a hundredth of its size off, and of a path each on its own.
#[test]
fn what_lies_too_far_away_for_its_size_is_left() {
    for (shape, left) in [
        (r#"<circle cx="100000050" cy="50" r="30"/>"#, true),
        (
            r#"<ellipse cx="3500010" cy="5000010" rx="3" ry="8"/>"#,
            true,
        ),
        (
            r#"<rect x="-900000" y="5" width="3" height="2" rx="1"/>"#,
            true,
        ),
        (r#"<circle cx="100000" cy="-200000" r="1"/>"#, false),
        (r#"<ellipse rx="10000" ry="0.01"/>"#, false),
        (
            r#"<rect x="20" y="20" width="1000" height="500" rx="0.001"/>"#,
            false,
        ),
    ] {
        let found = codes(&svg(shape));
        let expected: &[&str] = if left { &["too-large"] } else { &[] };
        assert_eq!(found, expected, "{shape}");
    }
}

/// Where renderers place the point after a number beyond numbers nobody knows.
#[test]
fn what_follows_a_number_beyond_numbers_is_left() {
    for d in [
        "M1e400 0A1 1 0 0 1 5 5",
        "M1e400 0H5A1 1 0 0 1 6 6",
        "M0 1e400V5A1 1 0 0 1 6 6",
    ] {
        assert_eq!(path(d), d);
    }
}

#[test]
fn ends_of_many_digits_are_where_they_were() {
    for (d, largest) in [
        ("M0 0a9 9 0 1 1 5.00000000000000000000000001 1", 18.0),
        (
            "M0 0a1e10 1e10 0 1 1 12345678901.00000000000000000000000001 1",
            2e10,
        ),
    ] {
        let out = path(d);
        let [old, new] = [d, &out].map(independent::segments);
        independent::same_curve(&old, &new, ERROR).unwrap();
        let curve = kurbo::BezPath::from_svg(&out).unwrap();
        let end = kurbo::ParamCurve::end(&curve.segments().last().unwrap());
        let text = d.rsplit(' ').nth(1).unwrap();
        let x: f64 = text.parse().unwrap();
        assert!(
            (end.x - x).abs() < 1e-15 * largest && (end.y - 1.0).abs() < 1e-15 * largest,
            "{out}"
        );
    }
}

/// An arc whose ends coincide at one place only is not taken from what was kept at the other.
#[test]
fn whether_ends_coincide_is_asked_at_each_place() {
    let [near, far] =
        ["M0 0", "M1000 1000"].map(|at| format!(r#"<path d="{at}a50 50 0 1 1 .00001 0"/>"#));
    let text = svg(&format!("{near}{far}{near}"));
    let converted = convert(&text);
    assert_eq!(converted.replaced.path, 2);
    assert_eq!(codes(&text), ["nearly-whole"]);
    assert!(converted.text.contains(&far));
    let large = svg(r#"<path d="M100000 0a1000 1000 0 1 1 .001 0"/>"#);
    assert_eq!(codes(&large), ["nearly-whole"]);
}

/// The control points of every method are those of the shape drawn by itself.
#[test]
fn every_method_draws_as_by_itself() {
    use curveto::number::Precision;
    use curveto::{Angle, Arc, Circle, Shape, approximate};
    let arc = |start: f64, sweep: f64| {
        let [start, sweep] = [start, sweep].map(Angle::from_degrees);
        Shape::Arc(Arc::new((5.0, 5.0), (10.0, 10.0), Angle::ZERO, start, sweep).unwrap())
    };
    let shapes = [
        (r#"<path d="M15 5A10 10 0 0 1 5 15"/>"#, arc(0.0, 90.0)),
        (r#"<path d="M15 5A10 10 0 0 1-5 5"/>"#, arc(0.0, 180.0)),
        (
            r#"<circle cx="5" cy="5" r="10"/>"#,
            Shape::Circle(Circle::new((5.0, 5.0), 10.0).unwrap()),
        ),
    ];
    for method in Method::ALL {
        for cut in [Cut::Quarters, Cut::Count(3)] {
            for (element, shape) in &shapes {
                let options = curveto::Options {
                    rule: method.into(),
                    cut: cut.clone(),
                    precision: Some(Precision::Fixed(9)),
                    ..curveto::Options::default()
                };
                let how = Options {
                    rule: method.into(),
                    cut: cut.clone(),
                    precision: Some(9),
                    ..Options::default()
                };
                let text = svg(element);
                let converted = document::convert(&text, &how).unwrap();
                let Ok(drawing) = approximate(shape, &options) else {
                    assert_eq!(converted.replaced.total(), 0, "{method} {cut:?} {element}");
                    continue;
                };
                let d = converted
                    .text
                    .split(" d=\"")
                    .nth(1)
                    .unwrap()
                    .split('"')
                    .next()
                    .unwrap();
                let drawn = kurbo::BezPath::from_svg(d).unwrap();
                let points = |segments: Vec<kurbo::PathSeg>| -> Vec<kurbo::Point> {
                    segments
                        .iter()
                        .flat_map(curveto::curve::control_points)
                        .collect()
                };
                let (found, right) = (
                    points(drawn.segments().collect()),
                    points(drawing.curve.segments),
                );
                assert_eq!(found.len(), right.len(), "{method} {cut:?} {element}");
                for (a, b) in found.iter().zip(&right) {
                    assert!(a.distance(*b) < 3e-9, "{method} {cut:?} {element}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn rectangles_of_half_circles_have_no_straight_sides_there() {
    let letters = |attributes: &str| -> String {
        let text = svg(&format!("<rect {attributes} rx='10'/>"));
        let out = convert(&text).text.into_owned();
        let d = out.split(" d=").nth(1).unwrap().to_owned();
        d[..d.find('/').unwrap()]
            .chars()
            .filter(char::is_ascii_alphabetic)
            .collect()
    };
    assert_eq!(letters("width='30' height='40'"), "MHcVcHCVCZ");
    assert_eq!(letters("width='30' height='20'"), "MHcHCZ");
    assert_eq!(letters("width='20' height='30'"), "McVcCVCZ");
    assert_eq!(letters("width='20' height='20'"), "McCZ");
}

/// Half of a side has a digit more than the side.
#[test]
fn a_clamped_radius_is_exactly_half_of_the_side() {
    let text = svg(r#"<rect width="1.23456789012345" height="9" rx="5" ry="1"/>"#);
    let out = convert(&text).text.into_owned();
    assert!(out.contains(r#" d="M.617283945061725 0c"#), "{out}");
}

/// Radii that are too small grow to half of the chord, so that nothing collapses.
#[test]
fn small_radii_collapse_only_with_their_chord() {
    let options = Options {
        precision: Some(1),
        ..Options::default()
    };
    for d in [
        "M0 0A.01 .01 0 0 1 10 0A.01 .01 0 0 1 0 0Z",
        "M0 0a.01 .01 0 0 1 10 0z",
        "M50 50a.01 .01 0 0 1 10 0A.01 .01 0 0 1 50 50z",
        "M0 0A9 .01 0 0 1 10 0Z",
        "M0 0A5 5 0 0 1 .01 0Z",
    ] {
        let new = path_with(d, &options);
        assert!(!new.contains(['a', 'A']), "{d} {new}");
    }
    for d in [
        "M50 50a.01 .01 0 0 1 .01 0A.01 .01 0 0 1 50 50z",
        "M50 50A.01 .01 0 0 1 50.01 50z",
        "M0 0a.01 .01 0 0 1 .01 0a.01 .01 0 0 1-.01 0z",
    ] {
        assert_eq!(path_with(d, &options), d);
    }
}

#[test]
fn every_number_of_a_shape_has_the_precision() {
    let options = Options {
        precision: Some(2),
        ..Options::default()
    };
    let text = svg(r#"<rect x="1.23456" y="2" width="20.98765" height="30.5" rx="3.14159"/>"#);
    let out = document::convert(&text, &options)
        .unwrap()
        .text
        .into_owned();
    let d = out
        .split(" d=\"")
        .nth(1)
        .unwrap()
        .split('"')
        .next()
        .unwrap();
    assert!(d.starts_with("M4.38 2H19.08"), "{d}");
    for part in d.split('.').skip(1) {
        let decimals = part.bytes().take_while(u8::is_ascii_digit).count();
        assert!(decimals <= 2, "{d}");
    }
}

#[test]
fn auto_is_the_other_radius_and_no_size() {
    for (attributes, expected) in [
        ("width='20' height='20' rx='auto' ry='0'", &[][..]),
        ("width='20' height='20' rx='0' ry='auto'", &[]),
        ("width='20' height='20' rx='auto' ry='5'", &["length"]),
        ("width='auto' height='20' rx='5'", &["not-drawn"]),
        ("width='20' height='auto' rx='5'", &["not-drawn"]),
    ] {
        assert_eq!(
            codes(&svg(&format!("<rect {attributes}/>"))),
            expected,
            "{attributes}"
        );
    }
}

#[test]
fn counts_add_up_kind_by_kind() {
    let counts = |circle, ellipse, rect, path, smooth| document::Counts {
        circle,
        ellipse,
        rect,
        path,
        smooth,
    };
    let sum = counts(1, 20, 300, 4000, 50_000) + counts(2, 30, 400, 5000, 60_000);
    assert_eq!(sum, counts(3, 50, 700, 9000, 110_000));
    assert_eq!(sum.total(), 9753);
}

#[test]
fn near_quarters_are_one_cubic() {
    // users.md 3: the excess of a rounded quarter adds no piece.
    let out = path("M0 0a5 5 0 0 1 5.001 5.001");
    assert_eq!(independent::segments(&out).len(), 2, "{out}");
}

#[test]
fn tolerance_and_count_are_obeyed() {
    let close = Options {
        cut: Cut::Tolerance(Tolerance::Absolute(1e-6)),
        ..Options::default()
    };
    let d = "M10 10a50 30 20 1 1 7 9";
    let old = independent::segments(d);
    independent::same_curve(
        &old,
        &independent::segments(&path_with(d, &close)),
        1e-6 / 30.0,
    )
    .unwrap();
    let seven = Options {
        cut: Cut::Count(7),
        ..Options::default()
    };
    assert_eq!(independent::segments(&path_with(d, &seven)).len(), 8);
    let rough = Options {
        precision: Some(1),
        ..Options::default()
    };
    let out = path_with("M0 0a5 5 0 0 1 5 5", &rough);
    assert_eq!(out, "M0 0c2.8 0 5 2.2 5 5");
}

#[test]
fn a_vertex_does_not_move_however_many_arcs_precede_it() {
    // users.md 7: relative rounding does not accumulate.
    let d = format!("M.1.1{}", "a.7 1.3 17 1 1 .013 .7".repeat(500));
    let (old, new) = (independent::segments(&d), independent::segments(&path(&d)));
    independent::same_curve(&old, &new, ERROR).unwrap();
}

#[test]
fn references_in_path_data_stay_where_they_are_outside_of_arcs() {
    let text = r#"<svg><path d="M0&#32;0a5 5 0 0 1&#x20;5 5&#10;L1&#32;1"/></svg>"#;
    let out = convert(text).text;
    assert!(
        out.starts_with(r#"<svg><path d="M0&#32;0c"#)
            && out.ends_with(r#"5 5&#10;L1&#32;1"/></svg>"#),
        "{out}"
    );
}

// ---- elements

#[test]
fn attributes_keep_their_order_their_quotes_and_their_space() {
    let text = "<svg>\r\n<circle\tid='a'  cx = '1'\r\n cy='2' fill=\"red\" r='3'\t><title>x</title></circle\n></svg>";
    let out = convert(text).text;
    let d = out
        .split("d = '")
        .nth(1)
        .unwrap()
        .split('\'')
        .next()
        .unwrap();
    assert_eq!(
        out,
        format!("<svg>\r\n<path\tid='a'  d = '{d}' fill=\"red\"\t><title>x</title></path\n></svg>")
    );
}

#[test]
fn prefixes_and_namespaces_decide_what_is_svg() {
    let text = r#"<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:o="urn:o"><s:circle r="5"></s:circle><circle r="5"/><o:circle r="5"/><g xmlns="http://www.w3.org/2000/svg"><circle r="1"/><o xmlns="urn:o"><circle r="2"/></o><circle r="3"/></g><circle r="4"/></s:svg>"#;
    let out = convert(text);
    assert_eq!(out.replaced.circle, 3);
    assert!(
        out.text.contains("<s:path d=")
            && out.text.contains("</s:path>")
            && out.text.contains(r#"<circle r="5"/><o:circle r="5"/>"#)
    );
    assert!(out.text.contains(r#"<circle r="2"/>"#) && out.text.contains(r#"<circle r="4"/>"#));
}

#[test]
fn what_is_not_an_element_is_not_touched() {
    let text = "\u{feff}<?xml version='1.0' encoding='utf-8'?><!DOCTYPE svg [<!ENTITY e '<circle r=\"1\"/>'>]><!-- <circle r='1'/> --><svg xmlns='http://www.w3.org/2000/svg'><?php <circle r='1'/> ?><desc><![CDATA[<circle r='1'/>]]></desc></svg>\n<!-- end -->";
    assert_eq!(convert(text).text, text);
    let with = text.replace("<desc>", "<circle r='9'/><desc>");
    let out = convert(&with);
    assert_eq!(
        (
            out.replaced.circle,
            out.text.matches("<circle r='1'/>").count()
        ),
        (1, 3)
    );
    independent::check(&with, &out.text, ERROR).unwrap();
}

#[test]
fn entities_resolve_in_names_of_namespaces_and_in_lengths() {
    let text = r#"<!DOCTYPE svg [<!ENTITY ns "http://www.w3.org/2000/svg"><!ENTITY r "5">]><svg xmlns="&ns;"><circle r="&r;" cx="1&#48;"/></svg>"#;
    assert!(convert(text).text.contains(r#"<path d="M15 0"#));
    let path = r#"<!DOCTYPE svg [<!ENTITY a "a5 5 0 0 1 5 5">]><svg><path d="M0 0&a;"/></svg>"#;
    assert_eq!(codes(path), ["entity"]);
}

#[test]
fn only_what_is_asked_for_is_replaced() {
    let text = svg(
        r#"<circle r="1"/><ellipse rx="1" ry="2"/><rect width="5" height="5" rx="1"/><path d="M0 0a1 1 0 0 1 1 1"/>"#,
    );
    for kind in ElementKind::ALL {
        let options = Options {
            only: Only::of(&[kind]),
            ..Options::default()
        };
        let out = document::convert(&text, &options).unwrap();
        assert_eq!((out.replaced.total(), out.replaced.of(kind)), (1, 1));
        assert!(out.notes.is_empty());
    }
}

// ---- what is left

#[test]
fn elements_that_depend_on_something_else_are_left_with_the_reason() {
    let cases = [
        (
            "style-selector",
            r#"<style>circle { fill: red }</style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<circle r="5"/><style>path { fill: red }</style>"#,
        ),
        (
            "style-selector",
            r#"<style>:first-of-type { fill: red }</style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<style>[r="5"] { fill: red }</style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<style>g > circle + text { fill: red }</style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<style><![CDATA[ svg :not(circle) { fill: red } ]]></style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<style>@media print { .a circle { fill: red } }</style><circle r="5"/>"#,
        ),
        (
            "style-selector",
            r#"<style>path[d^="M0"] { fill: red }</style><path d="M0 0a1 1 0 0 1 1 1"/>"#,
        ),
        (
            "style-geometry",
            r#"<style>.a { r: 5px }</style><circle class="b a" r="5"/>"#,
        ),
        (
            "style-geometry",
            r#"<style>#x { d: path("M0 0") }</style><circle id="x" r="5"/>"#,
        ),
        ("style-geometry", r#"<circle style="r: 5px" r="5"/>"#),
        (
            "style-geometry",
            r#"<circle style="fill:red;all:unset" r="5"/>"#,
        ),
        (
            "style-geometry",
            r#"<rect style="rx: 2px" width="5" height="5"/>"#,
        ),
        (
            "style-geometry",
            r#"<style>.r { rx: 2px }</style><rect class="r" width="5" height="5"/>"#,
        ),
        (
            "external-style",
            r#"<style>@import "a.css";</style><circle r="5"/>"#,
        ),
        ("script", r#"<circle r="5"/><script>1</script>"#),
        ("script", r#"<a href="JavaScript:go()"><circle r="5"/></a>"#),
        ("script", r#"<circle r="5" onclick="go()"/>"#),
        (
            "animation",
            r#"<circle r="5"><animate attributeName="r" values="1;2"/></circle>"#,
        ),
        (
            "animation",
            r##"<circle id="c" r="5"/><set href="#c" attributeName="cx" to="2"/>"##,
        ),
        (
            "animation",
            r#"<style>@keyframes k { to { r: 9px } }</style><circle r="5"/>"#,
        ),
        (
            "animation",
            r#"<path d="M0 0a1 1 0 0 1 1 1"><animate attributeName="d" values="M0 0;M1 1"/></path>"#,
        ),
        ("marker", r#"<g marker-end="url(#m)"><circle r="5"/></g>"#),
        (
            "marker",
            r#"<g style="marker: url(#m)"><rect width="5" height="5" rx="1"/></g>"#,
        ),
        (
            "marker-mid",
            r#"<path marker-mid="url(#m)" d="M0 0a5 5 0 0 1 10 0"/>"#,
        ),
        (
            "marker-mid",
            r#"<style>.a { marker: url(#m) }</style><g class="a"><path d="M0 0a5 5 0 0 1 10 0"/></g>"#,
        ),
        (
            "motion-path",
            r##"<animateMotion><mpath href="#p"/></animateMotion><circle id="p" r="5"/>"##,
        ),
        ("length", r#"<circle r="50%"/>"#),
        ("length", r#"<circle r="5" cx="2em"/>"#),
        ("length", r#"<circle r="calc(1px + 2px)"/>"#),
        ("not-drawn", r#"<circle r="0"/>"#),
        ("not-drawn", r#"<circle r="-5"/>"#),
        ("not-drawn", r#"<ellipse rx="-5" ry="-1"/>"#),
        ("not-drawn", r#"<rect rx="5"/>"#),
        ("elsewhere", r#"<glyph d="M0 0a5 5 0 0 1 10 0"/>"#),
    ];
    for (code, inner) in cases {
        let text = svg(inner);
        let out = convert(&text);
        assert_eq!(out.text, text, "{inner}");
        assert_eq!(
            out.notes
                .iter()
                .map(|note| note.reason.code())
                .collect::<Vec<_>>(),
            [code],
            "{inner}"
        );
    }
    let sheet = format!(
        "<?xml-stylesheet href='a.css'?>{}",
        svg(r#"<circle r="5"/>"#)
    );
    assert_eq!(codes(&sheet), ["external-style"]);
    let defaults =
        r#"<!DOCTYPE svg [<!ATTLIST circle r CDATA "5">]><svg><circle cx="5" r="1"/></svg>"#;
    assert_eq!(codes(defaults), ["attribute-defaults"]);
    let content = r#"<!DOCTYPE svg [<!ENTITY e "<style>circle{r:1px}</style>">]><svg>&e;<circle r="1"/></svg>"#;
    assert_eq!(codes(content), ["entity-content"]);
}

#[test]
fn what_does_not_matter_does_not_stop_a_replacement() {
    let cases = [
        r#"<style>.a { fill: red } rect.b { r: 1px } text { r: 2px } svg > .c { stroke: red }</style><circle class="a" r="5"/>"#,
        r#"<style>circle.other { r: 1px } g:first-of-type { fill: red } /* circle { } */</style><circle class="a" r="5"/>"#,
        r#"<style type="text/plain">circle { r: 1px }</style><circle r="5"/>"#,
        r#"<circle r="5"><animate attributeName="fill" values="red;blue"/><animateTransform attributeName="transform"/></circle>"#,
        r##"<circle id="c" r="5"/><animate href="#other" attributeName="r" values="1;2"/>"##,
        r#"<g marker-end="url(#m)"><circle style="marker: none" r="5"/></g>"#,
        r#"<path marker-mid="url(#m)" d="M0 0a5 5 0 0 1 5 5"/>"#,
        r#"<path marker-end="url(#m)" d="M0 0a5 5 0 0 1 10 0"/>"#,
        r#"<circle r="5mm" cx="1in" cy="72pt"/>"#,
        r#"<circle r="5" pathLength="10" stroke-dasharray="1"/>"#,
        r#"<foreignObject><svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg></foreignObject>"#,
    ];
    for inner in cases {
        let text = svg(inner);
        let out = convert(&text);
        assert_eq!(
            (out.replaced.total(), out.notes.len()),
            (1, 0),
            "{inner}: {:?}",
            out.notes
        );
    }
}

#[test]
fn notes_tell_line_and_column() {
    let out = convert("<svg>\r\n  <g/>é<circle\n r='0'/></svg>");
    assert_eq!((out.notes[0].line, out.notes[0].column), (2, 8));
}

// ---- what is refused

#[test]
fn malformed_documents_are_refused_with_their_place() {
    let cases = [
        ("", 1, 1),
        ("<svg>", 1, 1),
        ("<svg>\n</g></svg>", 2, 1),
        ("<svg>\n <a b=1/></svg>", 2, 7),
        ("<svg><a b='1' b='2'/></svg>", 1, 15),
        ("<svg a='<'/>", 1, 9),
        ("<svg>&nbsp;</svg>", 1, 6),
        ("<svg a='&x;'/>", 1, 9),
        ("<svg>&</svg>", 1, 6),
        ("<svg/><svg/>", 1, 7),
        ("<svg/>x", 1, 7),
        ("x<svg/>", 1, 1),
        (" <?xml version='1.0'?><svg/>", 1, 2),
        ("<svg>\u{1}</svg>", 1, 6),
        ("<svg><!-- a -- b --></svg>", 1, 13),
        ("<svg>ab]]></svg>", 1, 8),
        ("<svg a='&amp;&x;'/>", 1, 14),
        ("<svg a='&amp; &y'/>", 1, 15),
        ("<svg/>&amp;", 1, 7),
        ("<svg><?1?></svg>", 1, 6),
        ("<svg><?XML x?></svg>", 1, 6),
        ("<svg><![CDATA[x</svg>", 1, 6),
        ("<svg>\n <!x></svg>", 2, 2),
        ("<svg>]]></svg>", 1, 6),
        ("<svg><1/></svg>", 1, 6),
        ("\u{feff}<svg><a></svg>", 1, 9),
    ];
    for (text, line, column) in cases {
        match document::convert(text, &Options::default()) {
            Err(Error::Malformed {
                line: l,
                column: c,
                why,
            }) => assert_eq!((l, c), (line, column), "{text:?}: {why}"),
            other => panic!("{text:?}: {other:?}"),
        }
    }
}

#[test]
fn what_is_malformed_is_said() {
    for (text, said) in [
        (
            "<svg><1a b='2'/></svg>",
            "`<1a` is not the name of an element",
        ),
        ("<svg><1a/></svg>", "`<1a` is not the name of an element"),
        ("<svg><é></svg>", "`</svg>` where `</é>` should stand"),
        ("<svg =''></svg>", "this is not an attribute"),
        ("<svg a='1'b='2'></svg>", "this is not an attribute"),
        ("<svg a='1' / b='2'></svg>", "this is not an attribute"),
        ("<svg ?></svg>", "this is not an attribute"),
        ("<svg><a ", "the tag `<a` has no end"),
        ("<svg></svg></g>", "`</g>` closes nothing"),
    ] {
        match document::convert(text, &Options::default()) {
            Err(Error::Malformed { why, .. }) => assert_eq!(why, said, "{text}"),
            other => panic!("{text:?}: {other:?}"),
        }
    }
}

#[test]
fn other_encodings_are_refused_by_name() {
    for (bytes, name) in [
        (&b"\xff\xfe<\0s\0"[..], "UTF-16"),
        (b"\0<\0s", "UTF-16"),
        (b"\xff\xfe\0\0<\0\0\0", "UTF-32"),
        (
            b"<?xml version='1.0' encoding='ISO-8859-1'?><svg>\xe9</svg>",
            "ISO-8859-1",
        ),
    ] {
        match document::decode(bytes) {
            Err(Error::Encoding { encoding, .. }) => assert_eq!(encoding, name),
            other => panic!("{other:?}"),
        }
    }
    assert!(matches!(
        document::decode(b"<svg>\n\xe9</svg>"),
        Err(Error::Malformed {
            line: 2,
            column: 1,
            ..
        })
    ));
    let declared = "<?xml version='1.0' encoding=\"latin1\"?><svg/>";
    assert!(matches!(
        document::convert(declared, &Options::default()),
        Err(Error::Encoding {
            line: 1,
            column: 31,
            ..
        })
    ));
}

// ---- size and time

#[test]
fn bombs_end_quickly() {
    let start = Instant::now();
    let deep = format!(
        "{}<circle r='1'/>{}",
        "<g>".repeat(200_000),
        "</g>".repeat(200_000)
    );
    assert_eq!(convert(&deep).replaced.circle, 1);
    let mut bomb = String::from("<!DOCTYPE svg [<!ENTITY a0 'aaaaaaaaaa'>");
    for i in 1..30 {
        write!(
            bomb,
            "<!ENTITY a{i} '{}'>",
            format!("&a{};", i - 1).repeat(10)
        )
        .unwrap();
    }
    bomb += "]><svg>";
    bomb += &"<circle r='&a29;' class='&a29;'/><path d='M0 0&a29;'/>".repeat(2000);
    assert_eq!(convert(&(bomb + "&a29;</svg>")).replaced.total(), 0);
    let rules: String = (0..20_000)
        .map(|i| format!("circle.c{i}{{r:1px}}"))
        .collect();
    let many = format!(
        "<svg><style>{rules}</style>{}</svg>",
        "<circle r='1' class='a b c'/>".repeat(20_000)
    );
    assert_eq!(convert(&many).replaced.circle, 20_000);
    let wide: String = (0..20_000).map(|i| format!(" a{i}=''")).collect();
    convert(&format!("<svg{wide}/>"));
    let line = format!("<svg>{}</svg>", "<circle r='0'/>".repeat(50_000));
    assert_eq!(convert(&line).notes.len(), 50_000);
    let arcs = format!(
        "<svg><path d='M0 0{}'/></svg>",
        "a1 1 0 0 1 1 1S1 1 2 2".repeat(20_000)
    );
    assert_eq!(convert(&arcs).replaced.smooth, 20_000);
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn the_error_of_every_kind_is_measured_again_where_it_was_met_before() {
    let measure = Options {
        measure: true,
        ..Options::default()
    };
    let strayed =
        |inner: &str, options: &Options| document::convert(&svg(inner), options).unwrap().strayed;
    let quarter = strayed(r#"<path d="M0 0a9 9 0 0 1 9 9"/>"#, &measure);
    assert!(
        quarter > 1.9e-4 * 9.0 && quarter < 2.2e-4 * 9.0,
        "{quarter}"
    );
    for inner in [
        r#"<path d="M0 0a9 9 0 0 1 9 9"/>"#,
        r#"<path d="M0 0a9 9 0 0 1 9 9a9 9 0 0 1 9 9"/>"#,
        r#"<path d="M0 0A9 9 0 0 1 9 9"/>"#,
        r#"<rect x="3" y="4" width="50" height="60" rx="9"/>"#,
        r#"<circle cx="7" r="9"/>"#,
    ] {
        let found = strayed(inner, &measure);
        assert!((found - quarter).abs() < 2e-6, "{inner}: {found} {quarter}");
        assert_eq!(strayed(inner, &Options::default()), 0.0);
    }
}

#[test]
fn far_round_rectangles_state_what_the_digits_of_millimetres_leave_out() {
    let text =
        svg(r#"<rect x="300000.123mm" y="-200000.77mm" width="20" height="10.3" rx="3.1"/>"#);
    let [x, y] = [300_000.123, -200_000.77].map(|mm: f64| mm * 480.0 / 127.0);
    // A unit in the last place of these coordinates.
    let unit = 2.0_f64.powi(-32);
    for tolerance in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
        let options = Options {
            cut: Cut::Tolerance(Tolerance::Absolute(tolerance)),
            measure: true,
            ..Options::default()
        };
        let converted = document::convert(&text, &options).unwrap();
        let (_, data) = converted.text.split_once(" d=\"").unwrap();
        let contours = curveto::path::contours(data.split('"').next().unwrap()).unwrap();
        let mut farthest = 0.0_f64;
        for segment in contours[0].steps.iter().filter_map(cubic) {
            let [middle_x, middle_y] = [x + 10.0, y + 5.15];
            let center = segment.eval(0.5);
            let center = [
                if center.x < middle_x {
                    x + 3.1
                } else {
                    x + 16.9
                },
                if center.y < middle_y {
                    y + 3.1
                } else {
                    y + 7.2
                },
            ];
            for i in 0..=500 {
                let p = segment.eval(f64::from(i) / 500.0);
                let distance = (p.x - center[0]).hypot(p.y - center[1]) - 3.1;
                farthest = farthest.max(distance.abs());
            }
        }
        let told = converted.strayed;
        assert!(
            farthest <= told + 8.0 * unit,
            "{tolerance}: {farthest} {told}"
        );
        assert!(told <= tolerance + 4.0 * unit, "{tolerance}: {told}");
    }
}

fn cubic(step: &curveto::contour::Step) -> Option<kurbo::CubicBez> {
    match step {
        curveto::contour::Step::Given(kurbo::PathSeg::Cubic(cubic)) => Some(*cubic),
        _ => None,
    }
}
