//! Golden files of the formats for other programs, for a few shapes; `make golden` writes them anew.

use std::path::Path;

use crate::judges::program::{drawn, is_golden};

/// A name, the words that draw it, and the formats that can hold it.
const CASES: [(&str, &str, &str); 7] = [
    (
        "circle-minimax",
        "circle 50 -m minimax",
        "pdf tikz canvas glif dxf gcode",
    ),
    (
        "circle-quadratic-minimax",
        "circle 50 -m quadratic-minimax",
        "pdf tikz canvas glif dxf",
    ),
    (
        "ellipse-rotated",
        "ellipse 30 20 --rotation 15 --center 100,50",
        "pdf tikz canvas glif dxf",
    ),
    (
        "arc-bulge",
        "arc --from 0,0 --to 10,0 --bulge -0.4",
        "pdf tikz canvas glif dxf gcode",
    ),
    (
        "arc-line",
        "arc --from 0,0 --to 10,5 --bulge 0",
        "pdf tikz canvas glif dxf gcode",
    ),
    (
        "spline-cyclic-arc-length",
        "spline --points 0,0_10,0_12,5_3,8 --ends cyclic --parametrization arc-length --unit-tangents",
        "pdf tikz canvas glif dxf",
    ),
    ("sphere", "sphere 100", "pdf tikz canvas dxf"),
];

fn words(words: &str, format: &str) -> Vec<String> {
    let shape = words.split(' ').map(|word| word.replace('_', " "));
    shape.chain(["-f".to_owned(), format.to_owned()]).collect()
}

/// The words of every golden file.
pub(crate) fn commands() -> Vec<Vec<String>> {
    let of = |(_, shape, formats): (_, &'static str, &'static str)| {
        formats.split(' ').map(move |format| words(shape, format))
    };
    CASES.into_iter().flat_map(of).collect()
}

#[test]
fn the_formats_for_other_programs_print_their_golden_files() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/golden");
    let mut wrong = Vec::new();
    for (name, words, formats) in CASES {
        for format in formats.split(' ') {
            let drawn = drawn(&format!("{words} -f {format}"));
            let golden = folder.join(format!("{name}.{format}"));
            if !is_golden(&golden, &drawn) {
                wrong.push(golden);
            }
            let text = String::from_utf8_lossy(&drawn);
            for fleeting in [env!("CARGO_PKG_VERSION"), "CreationDate", "TDCREATE", "/ID"] {
                assert!(!text.contains(fleeting), "{name}.{format} holds {fleeting}");
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
