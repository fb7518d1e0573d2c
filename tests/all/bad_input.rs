//! A table of bad input to every command, fixtures/bad-input.txt: the exit code and the first line of the message, within bounds
//! on time and memory. `make golden` writes the messages anew, never the codes.
//!
//! Each entry is a line `$ ` with the words for a shell, and a line with the exit code and what standard error begins with.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output};

use crate::judges::program::printed;
use flate2::Compression;
use flate2::write::GzEncoder;

const TABLE: &str = "fixtures/bad-input.txt";
/// Enough of a message to know it by.
const LONGEST: usize = 200;
/// Bounds on each command, in KiB and in seconds of a processor, and on how long anything may hang.
const BOUNDS: &str = "ulimit -v 3000000; ulimit -t 20";
const SECONDS: &str = "120";
/// How many rows run at a time, each in a folder of its own.
const THREADS: usize = 4;

/// What the languages below say, which tells a user nothing.
const FOREIGN: [&str; 13] = [
    "panicked",
    "RUST_BACKTRACE",
    "memory allocation",
    "stack overflow",
    "invalid digit found in string",
    "invalid float literal",
    "invalid utf-8 sequence",
    "invalid type",
    "expected struct",
    "expected f64",
    "expected usize",
    "EOF while parsing",
    "unwrap",
];

struct Row {
    words: String,
    code: i32,
    message: String,
}

fn rows(table: &str) -> Vec<Row> {
    let lines: Vec<&str> = table
        .lines()
        .filter(|line| !line.starts_with('#') && !line.is_empty())
        .collect();
    let row = |pair: &[&str]| {
        let (code, message) = pair[1].split_once(' ').unwrap_or((pair[1], ""));
        Row {
            words: pair[0].strip_prefix("$ ").unwrap().to_owned(),
            code: code.parse().unwrap(),
            message: message.to_owned(),
        }
    };
    lines.chunks(2).map(row).collect()
}

/// A folder with the files that the table names.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).unwrap();
    let svg = br#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg>"#;
    put("a.svg", svg);
    put("b.svg", svg);
    put("a.csv", b"0,0\n1,0\n1,1\n");
    put("empty", b"");
    put("binary", &(0..=255).cycle().take(2560).collect::<Vec<u8>>());
    put("utf16.svg", b"\xff\xfe<\0s\0v\0g\0/\0>\0");
    let subset = r#"<!ENTITY a "0 0 ">
<!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">
<!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">
<!ENTITY large "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;">
<!ENTITY more "&large;&large;&large;&large;&large;&large;&large;&large;&large;">
<!ENTITY huge "&more;&more;&more;&more;&more;&more;&more;&more;&more;&more;">
<!ENTITY drawn "<path d='M0 0L1 1'/>">"#;
    for (name, drawing) in [
        ("huge.svg", "<path d='M0&huge;L1 1'/>"),
        (
            "moved.svg",
            "<g transform='&huge;'>\n<path d='M0 0L1 1'/></g>",
        ),
        ("tag.svg", "<path d='M0 0C1 2 3 4 5 6&drawn;'/>"),
        ("drawn.svg", "<path d='M0 0C1 2 3 4 5 6'/>\n&drawn;"),
    ] {
        let text = format!("<!DOCTYPE svg [{subset}]>\n<svg>{drawing}</svg>");
        put(name, text.as_bytes());
    }
    put("truncated.svg", b"<svg><circle r=\"5\"");
    put(
        "double-bom.svg",
        b"\xef\xbb\xbf\xef\xbb\xbf<svg><path d='M0 0C1 2 3 4 5 6'/></svg>",
    );
    put("long-line", "1".repeat(100_000).as_bytes());
    let cubics = "M0 0".to_owned() + &"C1 2 3 4 5 6".repeat(100_001);
    put("many-cubics", cubics.as_bytes());
    let drawing = format!("<svg><path d=\"{cubics}\"/></svg>");
    put("many-cubics.svg", drawing.as_bytes());
    let mut bomb = GzEncoder::new(Vec::new(), Compression::fast());
    let zeros = vec![0; 1 << 20];
    for _ in 0..257 {
        bomb.write_all(&zeros).unwrap();
    }
    let bomb = bomb.finish().unwrap();
    put("bomb.svgz", &bomb);
    put("broken.svgz", &bomb[..1000]);
    folder
}

fn run(words: &str, folder: &Path) -> Output {
    let script = format!("{BOUNDS}; curveto() {{ \"$CURVETO\" \"$@\"; }}; {words}");
    Command::new("timeout")
        .args(["-s", "KILL", SECONDS, "sh", "-c", &script])
        .env("CURVETO", env!("CARGO_BIN_EXE_curveto"))
        .current_dir(folder)
        .stdin(std::process::Stdio::null())
        .output()
        .unwrap()
}

/// The first line of a message, cut.
fn first_line(said: &str) -> String {
    let line: String = said
        .lines()
        .next()
        .unwrap_or("")
        .chars()
        .take(LONGEST)
        .collect();
    line.trim_end().to_owned()
}

/// What is wrong with the answer to a row; the message as it is now.
fn judge(row: &Row, folder: &Path) -> (Option<String>, String) {
    let output = run(&row.words, folder);
    let said = String::from_utf8_lossy(&output.stderr);
    let message = first_line(&said);
    let code = output.status.code();
    let wrong = if code != Some(row.code) {
        Some(format!(
            "ended with {code:?} and not {}: {message}",
            row.code
        ))
    } else if let Some(foreign) = FOREIGN.iter().find(|foreign| said.contains(*foreign)) {
        Some(format!("says {foreign:?}: {message}"))
    } else if said
        .chars()
        .any(|c| c.is_control() && c != '\n' && c != '\t')
    {
        Some("writes control characters to the terminal".to_owned())
    } else if said.lines().any(|line| line.chars().count() > 2000) {
        Some("writes lines of more than 2000 characters".to_owned())
    } else if row.code == 2 && !output.stdout.is_empty() {
        Some("writes output although the request was refused".to_owned())
    } else {
        None
    };
    (wrong, message)
}

fn table() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(TABLE)).unwrap()
}

#[test]
fn bad_input_is_refused_in_plain_words_within_bounds() {
    let table = table();
    let rows = rows(&table);
    let part = rows.len().div_ceil(THREADS);
    let answers: Vec<(Option<String>, String)> = std::thread::scope(|scope| {
        let threads: Vec<_> = rows
            .chunks(part)
            .map(|rows| {
                scope.spawn(move || {
                    let folder = folder();
                    let answer = |row| judge(row, folder.path());
                    rows.iter().map(answer).collect::<Vec<_>>()
                })
            })
            .collect();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap())
            .collect()
    });
    if std::env::var_os("CURVETO_GOLDEN").is_some() {
        let mut new = answers.iter().zip(&rows);
        let line = |line: &str| {
            if !line.starts_with(|c: char| c.is_ascii_digit()) {
                return format!("{line}\n");
            }
            let ((_, message), row) = new.next().unwrap();
            format!("{} {message}", row.code).trim_end().to_owned() + "\n"
        };
        let text: String = table.lines().map(line).collect();
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join(TABLE), text).unwrap();
        return;
    }
    let mut wrong = Vec::new();
    for (row, (fault, message)) in rows.iter().zip(&answers) {
        if let Some(fault) = fault {
            wrong.push(format!("{}: {fault}", row.words));
        } else if *message != row.message {
            wrong.push(format!(
                "{}:\n  {message}\n  and not\n  {}",
                row.words, row.message
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_table_of_bad_input_names_every_command() {
    let table = table();
    let rows = rows(&table);
    assert!(rows.len() >= 200, "{} rows", rows.len());
    let help = printed(&["--help"]);
    let commands = help.lines().filter_map(|line| {
        let word = line.strip_prefix("  ")?.split_whitespace().next()?;
        let is_command = line.len() > 2
            && !line.starts_with("   ")
            && word.chars().all(|c| c.is_ascii_lowercase());
        (is_command && word != "help" && word != "curveto").then_some(word)
    });
    let mut count = 0;
    for command in commands {
        let begin = format!("curveto {command}");
        let of_it = rows.iter().filter(|row| row.words.contains(&begin)).count();
        assert!(of_it >= 3, "{command}: {of_it} rows");
        count += 1;
    }
    assert!(count >= 10, "{count} commands found in the help");
}
