//! Random input, good and damaged, to everything that reads: never a panic, and what is converted keeps every promise.
//! `make test` runs a few cases, `make fuzz` as many times more as `CURVETO_FUZZ` says.

use std::path::Path;

use crate::judges::promises::{self, PROMISES, judge};
use crate::judges::random;

use curveto::document::{ElementKind, Only, Options};
use curveto::{Cut, Method, Rule, Tolerance};
use proptest::prelude::*;
use proptest::sample::Index;

fn factor() -> Option<u32> {
    std::env::var("CURVETO_FUZZ").ok()?.parse().ok()
}

/// A run of so many cases, or a long one.
fn cases(short: u32) -> ProptestConfig {
    ProptestConfig {
        cases: short.saturating_mul(factor().unwrap_or(1)),
        failure_persistence: None,
        max_global_rejects: u32::MAX,
        ..ProptestConfig::default()
    }
}

/// Ways to convert, and the largest error of a curve as a part of its radius, where the judge can tell.
fn ways() -> impl Strategy<Value = (Options, Option<f64>)> {
    // A closed shape may be cut anywhere, which the judge does not know.
    let closely = Options {
        cut: Cut::Tolerance(Tolerance::Relative(1e-5)),
        only: Only::of(&[ElementKind::Path]),
        ..Options::default()
    };
    let counted = |count| Options {
        cut: Cut::Count(count),
        ..Options::default()
    };
    let rule = |method| Options {
        rule: Rule::Method(method),
        ..Options::default()
    };
    prop_oneof![
        // The widest arc of one cubic; scaled-up radii and huge arcs cost digits.
        6 => Just((Options::default(), Some(3.2e-4))),
        1 => Just((closely, Some(1.01e-5))),
        1 => (1_usize..6).prop_map(move |count| (counted(count), None)),
        1 => (0_u8..4).prop_map(|precision| (Options { precision: Some(precision), ..Options::default() }, None)),
        1 => prop::sample::select(&[Method::QuadraticMinimax, Method::Midpoint, Method::Mean][..])
            .prop_map(move |method| (rule(method), None)),
    ]
}

fn told(input: &[u8], outcome: Result<(), String>) -> Result<(), TestCaseError> {
    outcome.map_err(|why| TestCaseError::fail(format!("{why}\n{}", String::from_utf8_lossy(input))))
}

/// Inputs of every kind that is read.
#[test]
fn seeds_keep_every_promise() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, _) in PROMISES {
        let seeds = root.join("fixtures/fuzz").join(name);
        let files = std::fs::read_dir(&seeds).unwrap();
        for file in files.map(|entry| entry.unwrap().path()) {
            promises::hold(name, &std::fs::read(file).unwrap());
        }
    }
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn any_path_is_drawn_alike(d in random::path_data(), (options, tolerance) in ways()) {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg'><path d='{d}'/></svg>");
        told(text.as_bytes(), judge(text.as_bytes(), &options, tolerance))?;
    }

    #[test]
    fn any_document_is_drawn_alike(text in random::document(), (options, tolerance) in ways()) {
        told(text.as_bytes(), judge(text.as_bytes(), &options, tolerance))?;
    }

    #[test]
    fn any_text_ends_without_a_panic(text in ".{0,200}") {
        let inside = format!("<svg><path d='{text}'/><circle r='{text}'/><style>{text}</style></svg>");
        for text in [text, inside] {
            told(text.as_bytes(), judge(text.as_bytes(), &Options::default(), None))?;
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn damaged_path_data_are_drawn_alike(
        (d, other) in (random::path_data(), random::path_data()),
        damages in random::damages(),
        (options, tolerance) in ways(),
    ) {
        let d = random::damaged(d.as_bytes(), other.as_bytes(), &damages);
        let text = [&b"<svg xmlns='http://www.w3.org/2000/svg'><path d='"[..], &d, b"'/></svg>"].concat();
        told(&text, judge(&text, &options, tolerance))?;
    }

    #[test]
    fn a_damaged_document_is_drawn_alike(
        (text, other) in (random::document(), random::document()),
        damages in random::damages(),
        (options, tolerance) in ways(),
    ) {
        let text = random::damaged(text.as_bytes(), other.as_bytes(), &damages);
        told(&text, judge(&text, &options, tolerance))?;
    }

    #[test]
    fn a_damaged_file_is_drawn_alike(
        [file, other] in any::<[Index; 2]>(),
        damages in random::damages(),
        (options, tolerance) in ways(),
    ) {
        let seeds = random::seeds(factor().is_some());
        let (file, other) = (&seeds[file.index(seeds.len())], &seeds[other.index(seeds.len())]);
        let text = random::damaged(file.as_bytes(), other.as_bytes(), &damages);
        told(&text, judge(&text, &options, tolerance))?;
    }
}

/// Lines of each form, to be damaged.
const LINES: [&str; 20] = [
    "bulge 0 0 10 0 1",
    "through 0 0 1 1 2 0.5",
    "polyline 0 0 1 10 0 -.5 10 10 0 close",
    "path M1 1l2 3A5 4 30 0 1 9 9q1 2 3 4t1 1s4 5 6 7z",
    "circle 0 0 50",
    "ellipse 1 -2 30 20 15",
    "arc .5 0 5 10 -200",
    "arc 0 0 30 20 15 1e1 90",
    "svgarc 0 0 25 25 -30 0 1 50 -25",
    r#"{"id": "a1", "circle": {"center": [0,0], "radius": 50}, "method": "minimax", "segments": 4}"#,
    r#"{"ellipse": {"center": [0,0], "radii": [30,20], "rotation": 15}, "tolerance": 0.001}"#,
    r#"{"svg_arc": {"from": [0,0], "radii": [25,25], "rotation": -30, "large_arc": false, "sweep": true, "to": [50,-25]}}"#,
    "rgb(255 0 0 / 50%)",
    "color(from hsl(0.5turn 100% 50%) xyz-d50 x calc(y * 2) 0.3 / alpha)",
    "oklch(44.027% 0.1603 303.37)",
    "25.4mmx48px",
    "M10 80a25,25-30 0150-25",
    "M0 0C1 2 3 4 5 6S7 8 9 10Q1 2 3 4T5 6z",
    "0,0 1,1 2.5,-3\n4 5\n",
    "<svg viewBox='0 0 9 9'><g transform='rotate(5)translate(1,2)'><path d='M0 0L1 1'/></g></svg>",
];

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn a_damaged_line_is_read_or_refused(
        [line, other] in any::<[Index; 2]>(),
        damages in random::damages(),
    ) {
        let (line, other) = (LINES[line.index(LINES.len())], LINES[other.index(LINES.len())]);
        let text = random::damaged(line.as_bytes(), other.as_bytes(), &damages);
        told(&text, promises::words(&text))?;
        told(&text, promises::lines(&text))?;
    }
}
