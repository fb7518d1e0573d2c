//! Help: short help fits a screen, long help and the manual pages end in worked examples and the exit codes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const COMMANDS: [&str; 17] = [
    "circle",
    "ellipse",
    "arc",
    "conic",
    "path",
    "batch",
    "spline",
    "sphere",
    "procset",
    "methods",
    "measure",
    "compare",
    "diff",
    "explore",
    "convert",
    "completions",
    "man",
];

/// The lines that short help may fill.
const SCREEN: usize = 50;

fn program() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_curveto"))
}

fn help(words: &[&str]) -> String {
    let mut command = Command::new(program());
    if words.contains(&"--help") {
        // A terminal of 80 columns: no example is broken into two lines, so that each can be copied.
        command.env("COLUMNS", "80");
    }
    let output = command.args(words).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty());
    String::from_utf8(output.stdout).unwrap()
}

/// The commands below the last line that says `Examples:`.
fn examples(help: &str) -> Vec<String> {
    let (_, last) = help.rsplit_once("\nExamples:\n").expect(help);
    let (commands, rest) = last.split_once("\n\n").expect(help);
    assert!(rest.starts_with("Exit codes: 0 "), "{help}");
    let signals = rest
        .replace('\n', " ")
        .contains("130, 143 ended by SIGINT, SIGTERM.");
    assert!(signals || rest.contains("2 trouble"), "{help}");
    commands
        .lines()
        .map(|line| line.trim().to_owned())
        .collect()
}

/// Runs a line of the shell, with our program first in PATH.
fn shell(line: &str, folder: &Path) -> Output {
    let path = std::env::join_paths(
        std::iter::once(program().parent().unwrap().to_owned())
            .chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
    );
    Command::new("sh")
        .args(["-euc", line])
        .current_dir(folder)
        .env("PATH", path.unwrap())
        .output()
        .unwrap()
}

/// A folder with the files that the examples name.
fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_owned();
    let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg>"#;
    fs::create_dir(path.join("icons")).unwrap();
    for name in ["logo.svg", "golden.svg", "new.svg", "icons/dot.svg"] {
        fs::write(path.join(name), drawing).unwrap();
    }
    for name in ["a.ps", "b.ps"] {
        fs::write(path.join(name), "0 0 moveto 5 5 lineto\n").unwrap();
    }
    (folder, path)
}

#[test]
fn long_help_ends_in_three_examples_that_run_and_the_exit_codes() {
    let (_held, folder) = folder();
    let mut pages = vec![(String::new(), help(&["--help"]))];
    pages.extend(COMMANDS.map(|name| (name.to_owned(), help(&[name, "--help"]))));
    for (name, page) in &pages {
        let found = examples(page);
        assert_eq!(found.len(), 3, "{name}: {found:?}");
        for line in found {
            assert!(line.contains(&format!("curveto {name}")), "{name}: {line}");
            let output = shell(&line, &folder);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{line}: {said}");
            assert!(!said.contains("error:"), "{line}: {said}");
        }
    }
    for shape in ["circle", "ellipse", "arc", "conic"] {
        for command in ["measure", "explore"] {
            assert_eq!(examples(&help(&[command, shape, "--help"])).len(), 3);
        }
    }
}

#[test]
fn short_help_fits_a_screen() {
    for name in COMMANDS {
        let lines = help(&[name, "-h"]).lines().count();
        assert!(lines <= SCREEN, "{name}: {lines} lines");
    }
}

#[test]
fn manual_pages_end_in_the_examples_and_the_exit_codes() {
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("man");
    let output = shell("curveto man --out-dir man", folder.path());
    assert!(output.status.success());
    for name in COMMANDS {
        let page = fs::read_to_string(pages.join(format!("curveto-{name}.1"))).unwrap();
        let (_, last) = page.rsplit_once(".SH ").unwrap();
        assert!(last.starts_with("EXAMPLES"), "{name}: {last}");
        assert!(last.contains("Examples:"), "{name}");
        assert!(last.contains("Exit codes: 0 "), "{name}");
    }
    let batch = fs::read_to_string(pages.join("curveto-batch.1")).unwrap();
    assert!(batch.contains("svgarc X1 Y1 RX RY ROTATION LARGE SWEEP X2 Y2"));
}
