//! No digit of a text format comes from the platform's mathematical library: the program prints the same where that library is
//! wrong in the last bits. Nor does a format hold a date or the program's version.
//!
//! `fixtures/perturbed.c` is such a library. It is compiled here and preloaded, which takes Linux, a C compiler and a program that
//! is linked dynamically.

use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use crate::{format_goldens, golden};

const HELPER: &str = "determinism::the_platforms_functions_are_printed_for_the_test_below";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The perturbed library, or nothing where no C compiler is.
fn library(folder: &Path) -> Option<PathBuf> {
    let library = folder.join("perturbed.so");
    let compiled = Command::new("cc")
        .args(["-O1", "-fno-builtin", "-shared", "-fPIC", "-o"])
        .arg(&library)
        .arg(root().join("fixtures/perturbed.c"))
        .arg("-ldl")
        .output();
    match compiled {
        Err(error) => {
            eprintln!("skipped: there is no C compiler (cc): {error}");
            None
        }
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{said}");
            Some(library)
        }
    }
}

type Function = fn(f64) -> f64;

/// What each function that the library replaces answers here, as bits.
fn answers() -> String {
    let x = black_box(0.7_f64);
    let two = [
        ("atan2", x.atan2(0.3)),
        ("powf", x.powf(1.3)),
        ("hypot", x.hypot(0.3)),
    ];
    let one: [(&str, Function); 20] = [
        ("sin", f64::sin),
        ("cos", f64::cos),
        ("tan", f64::tan),
        ("asin", f64::asin),
        ("acos", f64::acos),
        ("atan", f64::atan),
        ("sinh", f64::sinh),
        ("cosh", f64::cosh),
        ("tanh", f64::tanh),
        ("asinh", f64::asinh),
        ("atanh", f64::atanh),
        ("exp", f64::exp),
        ("exp2", f64::exp2),
        ("exp_m1", f64::exp_m1),
        ("ln", f64::ln),
        ("log2", f64::log2),
        ("log10", f64::log10),
        ("ln_1p", f64::ln_1p),
        ("cbrt", f64::cbrt),
        ("acosh", |x| (x + 1.0).acosh()),
    ];
    let mut text = String::new();
    for (name, value) in two
        .into_iter()
        .chain(one.map(|(name, f)| (name, black_box(f)(x))))
    {
        writeln!(text, "answer {name} {:016x}", value.to_bits()).unwrap();
    }
    text
}

#[test]
#[ignore = "a helper of the test below, which calls it with the library preloaded"]
fn the_platforms_functions_are_printed_for_the_test_below() {
    print!("{}", answers());
}

/// The functions whose answers the library does not change in a program that is built as ours is.
fn unchanged(library: &Path) -> Vec<String> {
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", HELPER, "--ignored", "--nocapture"])
        .env("LD_PRELOAD", library)
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let here = answers();
    let there: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("answer "))
        .collect();
    assert_eq!(there.len(), here.lines().count(), "{text}");
    here.lines()
        .zip(there)
        .filter(|(here, there)| here == there)
        .map(|(here, _)| here.split(' ').nth(1).unwrap().to_owned())
        .collect()
}

/// Lines of a batch: circles, ellipses, arcs and SVG arcs of many sizes.
fn lines() -> String {
    let mut text = String::new();
    for i in 0..300_u32 {
        let (a, b) = (
            f64::from(i * 37 % 101) / 7.0 + 0.3,
            f64::from(i * 53 % 89) / 3.0 + 0.1,
        );
        let angle = f64::from(i * 29 % 360) + 0.5;
        match i % 4 {
            0 => writeln!(text, "circle {a} {b} {b}"),
            1 => writeln!(text, "ellipse {a} {b} {a} {b} {angle}"),
            2 => writeln!(text, "arc {a} {b} {b} {angle} {}", 2.0 * angle - 200.0),
            _ => writeln!(
                text,
                "M{a} {b}A{b} {a} {angle} {} {} {} {b}",
                i / 4 % 2,
                i / 8 % 2,
                a + b
            ),
        }
        .unwrap();
    }
    text
}

/// Commands beside those of the golden files and the documents.
fn commands() -> Vec<Vec<String>> {
    let mut list: Vec<Vec<String>> = [
        "batch",
        "batch -f json",
        "batch -f ps",
        "batch -t 0.001",
        "batch -t 1e-9 -p 12",
        "batch -m midpoint -n 7 -p 15",
        "measure --path M50_0C50_27.596_27.596_50_0_50",
        "measure ellipse 30 20 --rotation 15 -f json",
        "measure arc --svg M10_80a25,25-30_0150-25 -f csv",
        "measure ellipse 30 20 -t 0.001 --plot plot.svg",
        "measure circle 9 --plot plot.pdf --quantity angle-lag",
        "measure ellipse 3 2 --plot plot.eps --quantity curvature-d1",
        "compare",
        "compare -f json",
        "compare -f csv",
        "compare -f svg",
        "compare -f eps",
        "compare -f pdf",
        "ellipse 300 7 -t 1e-6 --rotation 33",
        "ellipse 300 7 -n 12 --adaptive -p 15",
        "circle 50 -m minimax-free -n 3 -p 15 -f svg --show joints,handles,truth,error=50",
        "methods -f json",
        "procset",
        "path M10_80a25,25-30_0150-25c3_4_5_6_7_8A30_20_33_1_0_90_10z",
        "path M10_80a25,25-30_0150-25A30_20_33_1_0_90_10z -f json",
        "path M10_80a25,25-30_0150-25A30_20_33_1_0_90_10z -t 1e-7 -p 12 -f dxf",
        "path M10_80a25,25-30_0150-25c3_4_5_6_7_8 --to quadratics -t 0.001 -p 12",
        "path M10_80a25,25-30_0150-25A30_20_33_1_0_90_10z --to lines -p 12",
        "path M50_0C50_27.596_27.596_50_0_50C-17.3_50_-33.1_41_-43_26C-20_-3_40_-20_57_31 --to arcs -t 0.01 -f json",
        "path M0_0C10_30_90_-40_100_0S120_77_33_42 --to arcs -t 1e-4 -p 12",
        "path M50_0C50_27.596_27.596_50_0_50 --to lines -t 0.001 -f gcode",
        "diff M50_0C50_27.596_27.596_50_0_50 M50_0A50_50_0_0_1_0_50 -t 1e-6 -f json",
        "diff M10_80a25,25-30_0150-25z M10_80C14_53_70_11_60_55z -t 0.1",
        "compare -f html",
        "explore ellipse 50 31.7 --rotation 15 -m minimax,apprich -n 4,6",
        "explore arc 50 --sweep 77 -m chen-3 -n 2 -f json",
        "sphere 100 --view 33,21 -p 15 -f json",
        "conic --from 0,0 --control 1,2 --to 3,0 --weight 2.5 -t 1e-7 -p 15 -f json",
        "measure conic --from 0,0 --control 1,2 --to 3,0 --weight 0.3 -f json",
        "compare --spans 33,77 --by square -f csv",
        "circle 5 -f svg --fill lab(52.2345%_40.1645_59.9971) --stroke lch(52%_72_56.2)",
        "circle 5 -f eps --fill oklch(59.7%_0.156_49.7) --stroke color(xyz_0.2_0.3_0.4)",
    ]
    .into_iter()
    .map(|words| {
        words
            .split(' ')
            .map(|word| word.replace('_', " "))
            .collect()
    })
    .collect();
    let mut documents: Vec<PathBuf> = fs::read_dir(root().join("fixtures/documents"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
        .collect();
    documents.sort();
    let options: [&[&str]; 5] = [
        &[],
        &["-t", "1e-6"],
        &["-p", "10", "-n", "5"],
        &["--to", "arcs", "--shapes"],
        &["--to", "arcs", "-t", "0.1%"],
    ];
    for options in options {
        list.extend(documents.iter().map(|document| {
            let mut words = vec!["convert".to_owned(), document.display().to_string()];
            words.extend(options.iter().map(ToString::to_string));
            words
        }));
    }
    list
}

/// What the program prints, and what it writes into a folder made for it.
fn run(words: &[String], preloaded: Option<&Path>, input: &Path) -> (Output, Vec<Vec<u8>>) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_curveto"));
    command.args(words).current_dir(folder.path());
    command.stdin(Stdio::from(fs::File::open(input).unwrap()));
    if let Some(library) = preloaded {
        command.env("LD_PRELOAD", library);
    }
    let output = command.output().unwrap();
    let written = fs::read_dir(folder.path()).unwrap();
    (
        output,
        written
            .map(|entry| fs::read(entry.unwrap().path()).unwrap())
            .collect(),
    )
}

#[test]
fn nothing_printed_depends_on_the_platforms_mathematical_library() {
    let folder = tempfile::tempdir().unwrap();
    let Some(library) = library(folder.path()) else {
        return;
    };
    // Rust 1.90 and later bring their own cbrt; whatever else they brought would be no test any more.
    let unchanged = unchanged(&library);
    assert!(
        unchanged.iter().all(|name| name == "cbrt"),
        "{unchanged:?} answer as before"
    );
    let input = folder.path().join("lines");
    fs::write(&input, lines()).unwrap();
    let commands: Vec<Vec<String>> = golden::commands()
        .into_iter()
        .chain(format_goldens::commands())
        .chain(commands())
        .collect();
    let mut wrong = Vec::new();
    for words in &commands {
        let here = run(words, None, &input);
        let there = run(words, Some(&library), &input);
        let said = String::from_utf8_lossy(&here.0.stderr);
        assert!(!here.0.stdout.is_empty(), "{words:?}: {said}");
        let text = String::from_utf8_lossy(&here.0.stdout);
        for fleeting in [env!("CARGO_PKG_VERSION"), "CreationDate", "ModDate"] {
            assert!(!text.contains(fleeting), "{words:?} print {fleeting}");
        }
        if here != there {
            wrong.push(words.join(" "));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {}: {wrong:#?}",
        wrong.len(),
        commands.len()
    );
}
