//! Golden files: what the program prints for each shape, method and format, kept in fixtures/golden.
//!
//! `make golden` writes them anew; read the difference before committing it.

use std::path::Path;

use curveto::Method;

use crate::judges::program::{is_golden, printed};

const FORMATS: [&str; 5] = ["path", "svg", "ps", "eps", "json"];

/// Shapes and their options beside the circle, which is drawn by every method.
const SHAPES: [(&str, &[&str]); 18] = [
    (
        "circle-diameter-7-segments",
        &[
            "circle",
            "--diameter",
            "80",
            "-n",
            "7",
            "--center",
            "-12.5,3",
        ],
    ),
    ("circle-tolerance", &["circle", "1000", "-t", "0.0001%"]),
    (
        "circle-uneven-chen-1",
        &[
            "circle",
            "10",
            "-m",
            "chen-1",
            "--joints",
            "0,30,90,120,180,210,270,300",
        ],
    ),
    (
        "circle-reverse-start",
        &["circle", "25", "--start", "45", "--reverse"],
    ),
    ("circle-handle", &["circle", "1", "--handle", "0.55228475"]),
    (
        "ellipse-rotated",
        &[
            "ellipse",
            "30",
            "20",
            "--rotation",
            "15",
            "--center",
            "100,50",
        ],
    ),
    (
        "ellipse-lancaster",
        &[
            "ellipse",
            "--diameters",
            "300,200",
            "-m",
            "lancaster-drawellipse",
            "--open",
        ],
    ),
    (
        "ellipse-transformed",
        &[
            "ellipse",
            "3",
            "2",
            "--transform",
            "translate(10 5) rotate(30) scale(2 -1)",
        ],
    ),
    (
        "arc-quarter-and-a-bit",
        &["arc", "10", "--start", "0", "--end", "90.05"],
    ),
    (
        "arc-elliptic",
        &[
            "arc",
            "40",
            "10",
            "--start",
            "-0.25turn",
            "--sweep",
            "250",
            "--rotation",
            "0.5rad",
        ],
    ),
    (
        "arc-svg",
        &["arc", "--svg", "M10 80a25,25-30 0150-25", "-n", "3"],
    ),
    ("arc-through", &["arc", "--through", "0,0", "1,1", "2,0"]),
    (
        "arc-bulge",
        &["arc", "--from", "0,0", "--to", "10,0", "--bulge", "-0.4"],
    ),
    (
        "arc-line",
        &["arc", "--from", "0,0", "--to", "10,5", "--bulge", "0"],
    ),
    ("spline-free", &["spline", "--points", "0,0 1,2 3,1 4,4"]),
    (
        "spline-cyclic-arc-length",
        &[
            "spline",
            "--points",
            "0,0 10,0 12,5 3,8",
            "--ends",
            "cyclic",
            "--parametrization",
            "arc-length",
            "--unit-tangents",
        ],
    ),
    ("sphere", &["sphere", "100"]),
    (
        "sphere-odd-meridians-no-hidden",
        &[
            "sphere",
            "50",
            "--meridians",
            "3",
            "--parallels",
            "2",
            "--view",
            "-20,-60",
            "--hidden",
            "none",
            "-n",
            "6",
            "-m",
            "chen-3",
        ],
    ),
];

fn compare(name: &str, arguments: &[&str], format: &str) -> Option<String> {
    let printed = printed(&[arguments, &["-f", format]].concat());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/golden");
    let path = folder.join(format!("{name}.{format}"));
    let wrong = || format!("{}\n{printed}", path.display());
    (!is_golden(&path, printed.as_bytes())).then(wrong)
}

/// The circle by every method, and the shapes: a name and the words.
fn cases() -> Vec<(String, Vec<&'static str>)> {
    let circles = Method::ALL.iter().map(|method| {
        let words = vec!["circle", "50", "-m", method.id()];
        (format!("circle-{method}"), words)
    });
    let shapes = SHAPES.map(|(name, words)| (name.to_owned(), words.to_vec()));
    circles.chain(shapes).collect()
}

/// The words of every golden file.
pub(crate) fn commands() -> Vec<Vec<String>> {
    let with = |format: &str| {
        let words = cases().into_iter().map(|(_, words)| words);
        let format = ["-f".to_owned(), format.to_owned()];
        words
            .map(|words| {
                words
                    .into_iter()
                    .map(str::to_owned)
                    .chain(format.clone())
                    .collect()
            })
            .collect::<Vec<_>>()
    };
    FORMATS.iter().flat_map(|format| with(format)).collect()
}

#[test]
fn every_shape_method_and_format_prints_its_golden_file() {
    let cases = cases();
    let wrong: Vec<String> = cases
        .iter()
        .flat_map(|(name, arguments)| {
            FORMATS
                .iter()
                .filter_map(|format| compare(name, arguments, format))
        })
        .collect();
    assert!(
        wrong.is_empty(),
        "{} golden files differ; 'make golden' writes them anew\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
