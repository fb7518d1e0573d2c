//! The icon sets of lucide-static and bootstrap-icons, converted and judged; `make test-corpora` fetches them and runs this.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod independent;

use std::path::{Path, PathBuf};

use curveto::document::{self, Counts, Options};
use rayon::prelude::*;

/// The error of the default at 94.5 degrees, the widest single cubic, and what rounding adds.
const TOLERANCE: f64 = 2.95e-4;

/// A pixel may differ by this much of 255: tiny-skia samples four rows, so one that flips is worth a quarter.
const NOISE: u8 = 64;

fn files(set: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpora")
        .join(set)
        .join("package/icons");
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}; run `make corpora` first", folder.display()))
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
        .collect();
    files.sort();
    files
}

/// Converts a set and returns the counts, the sizes before and after, and what the judges had to say.
fn judge(set: &str) -> (Counts, usize, usize, Vec<String>) {
    let results: Vec<(Counts, usize, usize, Vec<String>)> = files(set)
        .par_iter()
        .map(|path| {
            let before = std::fs::read_to_string(path).unwrap();
            let converted = document::convert(&before, &Options::default()).unwrap();
            let after = &converted.text;
            let mut words = Vec::new();
            if converted.replaced == Counts::default() && *after != before {
                words.push("nothing was replaced, but bytes changed".to_owned());
            }
            words.extend(independent::check(&before, after, TOLERANCE).err());
            let left = independent::remaining(after).unwrap();
            if left != converted.notes.len() {
                words.push(format!("{left} are left, {} noted", converted.notes.len()));
            }
            words.extend(pixels(&before, after));
            let again = document::convert(after, &Options::default()).unwrap();
            if again.text != *after {
                words.push("a second conversion changes it again".to_owned());
            }
            let named = words
                .into_iter()
                .map(|word| format!("{}: {word}", path.display()))
                .collect();
            (converted.replaced, before.len(), after.len(), named)
        })
        .collect();
    results
        .into_iter()
        .fold((Counts::default(), 0, 0, Vec::new()), |mut sum, result| {
            sum.3.extend(result.3);
            (sum.0 + result.0, sum.1 + result.1, sum.2 + result.2, sum.3)
        })
}

/// At 256 pixels, each the mean of four: a renderer's own steps of antialiasing shrink with them.
fn pixels(before: &str, after: &str) -> Option<String> {
    let render = |text| Some(independent::halved(&independent::render(text, 512)?, 512));
    let (largest, _) = independent::difference(&render(before)?, &render(after)?, 0);
    (largest > NOISE).then(|| format!("a pixel is off by {largest} of 255"))
}

fn report(set: &str, most: f64) -> Counts {
    let (counts, before, after, words) = judge(set);
    let ratio = after as f64 / before as f64;
    println!("{set}: {counts:?}, {before} bytes became {after}, {ratio:.4} times as many");
    assert!(words.is_empty(), "{}", words.join("\n"));
    assert!(ratio <= most, "{ratio} is above {most}");
    counts
}

#[test]
#[ignore = "needs `make corpora`"]
fn lucide_is_converted_whole() {
    let counts = report("lucide-static-1.62.0", 1.3);
    assert_eq!(
        (counts.circle, counts.ellipse, counts.rect, counts.path),
        (682, 17, 496, 7085)
    );
}

#[test]
#[ignore = "needs `make corpora`"]
fn bootstrap_icons_are_converted_whole() {
    let counts = report("bootstrap-icons-1.13.2", 1.55);
    assert_eq!((counts.circle, counts.rect, counts.path), (2, 2, 24872));
}
