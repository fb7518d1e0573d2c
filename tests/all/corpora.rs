//! The icon sets of lucide-static and bootstrap-icons, converted and judged; `make test-corpora` fetches them and runs this.

use crate::judges::independent;

use std::path::{Path, PathBuf};

use curveto::document::{self, Counts, Options};
use curveto::{Cut, Tolerance};
use rayon::prelude::*;

/// The error of the default at 94.5 degrees, the widest single cubic, and what rounding adds.
const TOLERANCE: f64 = 2.95e-4;

/// What antialiasing may do to a pixel at 256 pixels a side, of 255. tiny-skia samples a pixel in four rows; where an edge runs along
/// a row, a hair's breadth flips all of it, and an edge that is nearly level can meet two of them. resvg does so by itself: it draws
/// the arcs of the file by cubics of its own and flattens those, and the same arcs cut into finer pieces differ by as much.
const TWO_ROWS: u8 = 128;

/// The same with sixteen rows a pixel: rendered at 1024 pixels a side, each pixel the mean of sixteen.
const TWO_FINE_ROWS: u8 = 32;

/// One file as the judges saw it.
struct Verdict {
    counts: Counts,
    before: usize,
    after: usize,
    /// How far a pixel is off at 256 pixels a side: as rendered, as the mean of sixteen, and what resvg makes of finer pieces.
    pixels: [(u8, String); 3],
    complaints: Vec<String>,
}

pub(crate) fn files(set: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpora")
        .join(set)
        .join("package");
    let folder = ["icons", "svg"].map(|name| folder.join(name));
    let folder = folder
        .iter()
        .find(|folder| folder.is_dir())
        .unwrap_or(&folder[0]);
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}; run `make corpora` first", folder.display()))
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
        .collect();
    files.sort();
    files
}

fn judge(path: &Path) -> Verdict {
    let before = std::fs::read_to_string(path).unwrap();
    let converted = document::convert(&before, &Options::default()).unwrap();
    let after = &converted.text;
    let mut complaints = Vec::new();
    if converted.replaced == Counts::default() && *after != before {
        complaints.push("nothing was replaced, but bytes changed".to_owned());
    }
    complaints.extend(independent::check(&before, after, TOLERANCE).err());
    let left = independent::remaining(after).unwrap();
    if left != converted.notes.len() {
        complaints.push(format!("{left} are left, {} noted", converted.notes.len()));
    }
    let again = document::convert(after, &Options::default()).unwrap();
    if again.text != *after {
        complaints.push("a second conversion changes it again".to_owned());
    }
    let off = pixels(&before, after);
    if off[0] > TWO_ROWS || off[1] > TWO_FINE_ROWS {
        complaints.push(format!("it is drawn otherwise: {off:?} of 255"));
    }
    let name = path.file_stem().unwrap().to_string_lossy();
    Verdict {
        counts: converted.replaced,
        before: before.len(),
        after: after.len(),
        pixels: off.map(|off| (off, name.to_string())),
        complaints: complaints
            .into_iter()
            .map(|word| format!("{}: {word}", path.display()))
            .collect(),
    }
}

/// How far the largest pixel is off, as [`Verdict::pixels`] has it.
fn pixels(before: &str, after: &str) -> [u8; 3] {
    let finer = Options {
        cut: Cut::Tolerance(Tolerance::Relative(1e-7)),
        ..Options::default()
    };
    let finer = document::convert(before, &finer).unwrap().text;
    [(after, 256, 1), (after, 1024, 4), (&finer, 256, 1)].map(|(other, size, block)| {
        let render = |text| independent::render(text, size).unwrap();
        independent::difference(&render(before), &render(other), size as usize, block)
    })
}

fn report(set: &str, most: f64) -> Counts {
    let verdicts: Vec<Verdict> = files(set).par_iter().map(|path| judge(path)).collect();
    let sum = |of: fn(&Verdict) -> usize| verdicts.iter().map(of).sum::<usize>();
    let (before, after) = (sum(|verdict| verdict.before), sum(|verdict| verdict.after));
    let counts = verdicts
        .iter()
        .fold(Counts::default(), |sum, verdict| sum + verdict.counts);
    let ratio = after as f64 / before as f64;
    println!("{set}: {counts:?}, {before} bytes became {after}, {ratio:.4} times as many");
    let words = [
        "at 256 pixels",
        "there, as the mean of 16",
        "arcs in finer pieces at 256 pixels",
    ];
    for (i, word) in words.iter().enumerate() {
        let (worst, name) = verdicts
            .iter()
            .map(|verdict| &verdict.pixels[i])
            .max()
            .unwrap();
        let above = verdicts
            .iter()
            .filter(|verdict| verdict.pixels[i].0 > 64)
            .count();
        println!(
            "{set}: {word} the largest difference is {worst} of 255 ({name}), {above} files are above 64"
        );
    }
    let complaints: Vec<&str> = verdicts
        .iter()
        .flat_map(|verdict| &verdict.complaints)
        .map(String::as_str)
        .collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
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
