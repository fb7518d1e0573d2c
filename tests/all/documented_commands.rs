//! Every command that the README and the documentation show is run here, and has to print what they show.
//!
//! A `console` block holds commands behind `$ ` and what they print, standard error included; a line `...` stands for any lines.
//! The commands of a document run in one folder that is made for them, in their order. With `CURVETO_GOLDEN=1` the documents are
//! rewritten with what the commands print.

use std::fs;
use std::path::{Path, PathBuf};

use crate::judges::program::shell;

/// A command and what the document shows below it.
struct Example {
    command: String,
    shown: Vec<String>,
    /// The lines of the document that `shown` takes up.
    lines: core::ops::Range<usize>,
}

fn examples(document: &str) -> Vec<Example> {
    let mut examples: Vec<Example> = Vec::new();
    let mut inside = false;
    for (i, line) in document.lines().enumerate() {
        match line {
            "```console" => inside = true,
            "```" => inside = false,
            _ if !inside => {}
            _ => match (line.strip_prefix("$ "), examples.last_mut()) {
                (Some(command), _) => {
                    let example = Example {
                        command: command.to_owned(),
                        shown: Vec::new(),
                        lines: i + 1..i + 1,
                    };
                    examples.push(example);
                }
                (None, Some(last)) if last.command.ends_with('\\') && last.shown.is_empty() => {
                    last.command = format!("{}\n{line}", last.command);
                    last.lines = i + 1..i + 1;
                }
                (None, Some(last)) => {
                    last.shown.push(line.to_owned());
                    last.lines.end = i + 1;
                }
                (None, None) => panic!("line {}: output before any command", i + 1),
            },
        }
    }
    examples
}

/// Whether the printed lines are those shown, where `...` stands for any lines.
fn agree(shown: &[String], printed: &[&str]) -> bool {
    match shown.split_first() {
        None => printed.is_empty(),
        Some((first, rest)) if first == "..." => {
            (0..=printed.len()).any(|skip| agree(rest, &printed[skip..]))
        }
        Some((first, rest)) => printed.split_first().is_some_and(|(line, others)| {
            line.trim_end() == first.trim_end() && agree(rest, others)
        }),
    }
}

fn run(command: &str, folder: &Path) -> String {
    let mut shell = shell(folder, &format!("exec 2>&1\n{command}"));
    let output = shell.env("COLUMNS", "100").output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

fn check(document: &Path) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    for shared in [
        "fixtures",
        "Cargo.toml",
        "Cargo.lock",
        "src",
        "benches",
        "README.md",
        "docs",
    ] {
        let _ = std::os::unix::fs::symlink(root.join(shared), folder.path().join(shared));
    }
    let text = fs::read_to_string(document).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut wrong = Vec::new();
    // From the last to the first only for rewriting: the commands themselves run in their order.
    let printed: Vec<(Example, String)> = examples(&text)
        .into_iter()
        .map(|example| {
            let printed = run(&example.command, folder.path());
            (example, printed)
        })
        .collect();
    for (example, printed) in printed.into_iter().rev() {
        let printed: Vec<&str> = printed.lines().collect();
        if agree(&example.shown, &printed) {
            continue;
        }
        wrong.push(format!(
            "{}: $ {}\n{}",
            document.display(),
            example.command,
            printed.join("\n")
        ));
        lines.splice(example.lines, printed.into_iter().map(str::to_owned));
    }
    if !wrong.is_empty() && std::env::var_os("CURVETO_GOLDEN").is_some() {
        fs::write(document, lines.join("\n") + "\n").unwrap();
        return Vec::new();
    }
    wrong
}

#[test]
fn the_documents_show_what_the_commands_print() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut documents = vec![root.join("README.md")];
    for folder in ["docs", "docs/guide"] {
        let entries = fs::read_dir(root.join(folder)).unwrap();
        documents.extend(entries.map(|entry| entry.unwrap().path()));
    }
    documents.retain(|path: &PathBuf| path.extension().is_some_and(|extension| extension == "md"));
    documents.sort();
    let wrong: Vec<String> = documents
        .iter()
        .flat_map(|document| check(document))
        .collect();
    assert!(
        wrong.is_empty(),
        "these commands print something else than shown:\n\n{}",
        wrong.join("\n\n")
    );
}
