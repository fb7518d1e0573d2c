//! The contract of `curveto convert`: what it reads, where it writes, what it tells, how it ends.

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::process::Output;

use serde_json::Value;
use tempfile::TempDir;

use crate::judges::program::{self, run_in, unread};

const CIRCLE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"5\"/></svg>\n";
const PATH: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M5 0C5 2.7596 2.7596 5 0 5-2.7596 5-5 2.7596-5 0-5-2.7596-2.7596-5 0-5 2.7596-5 5-2.7596 5 0Z\"/></svg>\n";
const PLAIN: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0h5\"/></svg>";
const BROKEN: &str = "<svg>\n<g></svg>";

fn curveto(folder: &Path, arguments: &[&str]) -> Output {
    run_in(folder, &[&["convert"], arguments].concat())
}

fn piped(arguments: &[&str], input: &[u8]) -> Output {
    program::piped(&[&["convert"], arguments].concat(), input)
}

fn gzip(text: &str) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(text.as_bytes()).unwrap();
    encoder.finish().unwrap()
}

fn gunzip(bytes: &[u8]) -> String {
    let mut text = String::new();
    flate2::read::GzDecoder::new(bytes)
        .read_to_string(&mut text)
        .unwrap();
    text
}

/// a.svg, sub/b.svg, sub/plain.svg, sub/deep/c.SVGZ and a text file.
fn tree() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    fs::create_dir_all(root.join("in/sub/deep")).unwrap();
    fs::write(root.join("in/a.svg"), CIRCLE).unwrap();
    fs::write(root.join("in/sub/b.svg"), CIRCLE).unwrap();
    fs::write(root.join("in/sub/plain.svg"), PLAIN).unwrap();
    fs::write(root.join("in/sub/deep/c.SVGZ"), gzip(CIRCLE)).unwrap();
    fs::write(root.join("in/readme.txt"), CIRCLE).unwrap();
    folder
}

fn read(folder: &TempDir, path: &str) -> String {
    fs::read_to_string(folder.path().join(path)).unwrap()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

#[test]
fn standard_input_goes_to_standard_output() {
    for arguments in [&[][..], &["-"], &["-", "-o", "-"]] {
        let output = piped(arguments, CIRCLE.as_bytes());
        assert_eq!(
            (
                output.status.code(),
                text(&output.stdout),
                text(&output.stderr)
            ),
            (Some(0), PATH, "")
        );
    }
    assert_eq!(gunzip(&piped(&[], &gzip(CIRCLE)).stdout), PATH);
    assert_eq!(piped(&[], PLAIN.as_bytes()).stdout, PLAIN.as_bytes());
}

#[test]
fn one_file_goes_where_it_is_told() {
    let folder = tree();
    assert_eq!(text(&curveto(folder.path(), &["in/a.svg"]).stdout), PATH);
    let output = curveto(folder.path(), &["in/a.svg", "-o", "out.svgz"]);
    assert!(output.status.success() && output.stdout.is_empty());
    assert_eq!(
        gunzip(&fs::read(folder.path().join("out.svgz")).unwrap()),
        PATH
    );
    assert!(
        curveto(folder.path(), &["in/sub/deep/c.SVGZ", "-o", "plain.svg"])
            .status
            .success()
    );
    assert_eq!(read(&folder, "plain.svg"), PATH);
}

#[test]
fn folders_are_converted_in_place_and_what_has_nothing_to_do_is_not_touched() {
    let folder = tree();
    let plain = folder.path().join("in/sub/plain.svg");
    let before = fs::metadata(&plain).unwrap().modified().unwrap();
    let output = curveto(
        folder.path(),
        &[
            "--in-place",
            "in",
            "in/a.svg",
            "-j",
            "2",
            "--report",
            "text",
        ],
    );
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(
        text(&output.stderr)
            .ends_with("3 of 4 files: 3 circles replaced, within 9.85e-4 of the true shapes\n"),
        "{}",
        text(&output.stderr)
    );
    assert_eq!(
        (
            read(&folder, "in/a.svg").as_str(),
            read(&folder, "in/sub/b.svg").as_str()
        ),
        (PATH, PATH)
    );
    assert_eq!(
        gunzip(&fs::read(folder.path().join("in/sub/deep/c.SVGZ")).unwrap()),
        PATH
    );
    assert_eq!(fs::metadata(&plain).unwrap().modified().unwrap(), before);
    assert_eq!(read(&folder, "in/readme.txt"), CIRCLE);
}

#[test]
fn a_check_says_what_would_be_replaced() {
    let folder = tree();
    let output = curveto(folder.path(), &["--check", "in/a.svg", "-v"]);
    assert_eq!(
        text(&output.stderr).lines().last(),
        Some("in/a.svg: 1 circle would be replaced, within 9.85e-4 of the true shapes")
    );
    assert_eq!(read(&folder, "in/a.svg"), CIRCLE);
}

#[cfg(unix)]
#[test]
fn in_place_keeps_the_mode() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tree();
    let path = folder.path().join("in/a.svg");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    assert!(
        curveto(folder.path(), &["--in-place", "in/a.svg"])
            .status
            .success()
    );
    assert_eq!(
        fs::metadata(&path).unwrap().permissions().mode() & 0o777,
        0o640
    );
}

#[test]
fn another_folder_gets_the_same_tree() {
    let folder = tree();
    let output = curveto(folder.path(), &["in", "--out-dir", "out"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_eq!(
        (
            read(&folder, "out/a.svg").as_str(),
            read(&folder, "out/sub/plain.svg").as_str()
        ),
        (PATH, PLAIN)
    );
    assert_eq!(
        gunzip(&fs::read(folder.path().join("out/sub/deep/c.SVGZ")).unwrap()),
        PATH
    );
    assert!(!folder.path().join("out/readme.txt").exists());
    assert_eq!(read(&folder, "in/a.svg"), CIRCLE);
}

#[test]
fn check_lists_the_files_with_work_and_writes_nothing() {
    let folder = tree();
    let output = curveto(folder.path(), &["--check", "in"]);
    assert_eq!(
        (output.status.code(), text(&output.stdout)),
        (Some(1), "in/a.svg\nin/sub/b.svg\nin/sub/deep/c.SVGZ\n")
    );
    assert_eq!(read(&folder, "in/a.svg"), CIRCLE);
    let output = curveto(folder.path(), &["--check", "in/sub/plain.svg"]);
    assert_eq!((output.status.code(), text(&output.stdout)), (Some(0), ""));
}

#[test]
fn one_bad_file_does_not_stop_the_others() {
    let folder = tree();
    fs::write(folder.path().join("in/bad.svg"), BROKEN).unwrap();
    let output = curveto(folder.path(), &["--in-place", "in", "missing.svg"]);
    assert_eq!(output.status.code(), Some(1));
    let errors = text(&output.stderr);
    assert!(
        errors.contains("error: in/bad.svg:2:4: not well-formed XML: ")
            && errors.contains("error: missing.svg: "),
        "{errors}"
    );
    assert_eq!(
        (
            read(&folder, "in/sub/b.svg").as_str(),
            read(&folder, "in/bad.svg").as_str()
        ),
        (PATH, BROKEN)
    );
    fs::write(folder.path().join("old.svg"), "old").unwrap();
    assert_eq!(
        curveto(folder.path(), &["in/bad.svg", "-o", "old.svg"])
            .status
            .code(),
        Some(1)
    );
    assert_eq!(read(&folder, "old.svg"), "old");
}

#[test]
fn the_report_is_one_json_object() {
    let folder = tree();
    fs::write(folder.path().join("in/bad.svg"), BROKEN).unwrap();
    fs::write(
        folder.path().join("in/left.svg"),
        "<svg>\n<circle r='50%'/></svg>",
    )
    .unwrap();
    let output = curveto(folder.path(), &["--check", "in", "--report", "json"]);
    let report: Value = serde_json::from_slice(&output.stderr).unwrap();
    assert_eq!(
        (
            &report["replaced"]["circle"],
            &report["failed"],
            &report["notes"]
        ),
        (&3.into(), &1.into(), &1.into())
    );
    let files = report["files"].as_array().unwrap();
    let left = files
        .iter()
        .find(|file| file["file"] == "in/left.svg")
        .unwrap();
    let note = &left["notes"][0];
    assert_eq!(
        (&note["line"], &note["column"], &note["code"]),
        (&2.into(), &1.into(), &"length".into())
    );
    assert!(files.iter().any(|file| {
        file["error"]
            .as_str()
            .is_some_and(|error| error.starts_with("in/bad.svg:2:4:"))
    }));
    // How far it strays is said of what was converted.
    for file in files {
        let strays = file["strayed"].as_f64();
        assert_eq!(strays.is_some(), file["changed"] == true, "{file}");
        assert!(strays.is_none_or(|distance| distance > 0.0), "{file}");
    }
}

#[test]
fn notes_go_to_standard_error() {
    let output = piped(&[], b"<svg><circle r='0'/></svg>");
    assert_eq!(
        text(&output.stderr),
        "note: <stdin>:1:6: <circle> is left: nothing is drawn: `r` is zero\n"
    );
    assert_eq!(
        (output.status.code(), text(&output.stdout)),
        (Some(0), "<svg><circle r='0'/></svg>")
    );
}

#[test]
fn methods_for_closed_shapes_convert_those_and_note_open_arcs() {
    let folder = tempfile::tempdir().unwrap();
    let whole = r#"<circle cx="9" cy="9" r="5"/><ellipse rx="5" ry="3"/>"#;
    let open = r#"<path d="M0 0A5 5 0 0 1 9 9"/><rect width="9" height="9" rx="2"/>"#;
    let svg = |inner: &str| format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{inner}</svg>"#);
    for method in [
        "apprich-scaled",
        "minimax-free",
        "minimax-g0-free",
        "minimax-ellipse-free",
    ] {
        fs::write(folder.path().join("a.svg"), svg(whole)).unwrap();
        let output = curveto(folder.path(), &["-m", method, "a.svg"]);
        let drawn = text(&output.stdout);
        assert!(output.status.success() && output.stderr.is_empty());
        assert_eq!(drawn.matches("<path").count(), 2, "{method}: {drawn}");
        fs::write(folder.path().join("a.svg"), svg(&(whole.to_owned() + open))).unwrap();
        let output = curveto(folder.path(), &["-m", method, "a.svg"]);
        let (drawn, notes) = (text(&output.stdout), text(&output.stderr));
        assert!(output.status.success(), "{notes}");
        assert!(drawn.contains(open) && !drawn.contains("<circle"));
        for name in ["<path>", "<rect>"] {
            let note = format!("{name} is left: {method} cannot do this: its segments end off");
            assert!(notes.contains(&note), "{notes}");
        }
    }
}

#[test]
fn wrong_requests_end_with_2() {
    let folder = tree();
    for arguments in [
        &["in"][..],
        &["in/a.svg", "in/sub/b.svg"],
        &["in", "-o", "out.svg"],
        &["-", "--in-place"],
        &["--check", "--in-place", "in"],
        &["-n", "4", "-t", "1", "in/a.svg"],
        &["-n", "0", "in/a.svg"],
        &["--only", "square", "in/a.svg"],
        &["--trust", "length", "in/a.svg"],
        &[
            "in/a.svg",
            "in/sub/../a.svg",
            "in/sub/b.svg",
            "--out-dir",
            "o",
            "-j",
            "0",
        ],
    ] {
        let output = curveto(folder.path(), arguments);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?}: {}",
            text(&output.stderr)
        );
        assert!(text(&output.stderr).starts_with("error: "), "{arguments:?}");
    }
    fs::create_dir(folder.path().join("other")).unwrap();
    fs::write(folder.path().join("other/a.svg"), CIRCLE).unwrap();
    assert_eq!(
        curveto(
            folder.path(),
            &["in/a.svg", "other/a.svg", "--out-dir", "o"]
        )
        .status
        .code(),
        Some(2)
    );
}

#[test]
fn other_encodings_are_named() {
    let output = piped(
        &[],
        b"<?xml version='1.0' encoding='Shift_JIS'?><svg>\x83\x5c</svg>",
    );
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).starts_with("error: <stdin>:1:31: the encoding is Shift_JIS"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let circles = format!("<svg>{}</svg>", "<circle r='5'/>".repeat(50_000));
    let output = unread(&["convert"], circles.as_bytes());
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), ""));
}
