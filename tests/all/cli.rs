//! The contract of the command line: what it prints, where it writes, how it ends.

use crate::judges::program;

use std::fs;

use program::{json, printed, refused, run, unread};
use serde_json::Value;

fn segments(arguments: &[&str]) -> usize {
    json(arguments)["segments"].as_array().unwrap().len()
}

#[test]
fn the_default_circle() {
    assert_eq!(
        printed(&["circle", "50"]),
        "M50 0C50 27.596 27.596 50 0 50C-27.596 50-50 27.596-50 0C-50-27.596-27.596-50 0-50C27.596-50 50-27.596 50 0Z\n"
    );
    let peak = json(&["circle", "1"])["error"]["relative_peak"]
        .as_f64()
        .unwrap();
    assert!((peak - 1.960_764_7e-4).abs() < 1e-9 * 1.960_764_7e-4 + 5e-12);
}

#[test]
fn the_standard_handle_to_fifteen_decimals() {
    assert!(
        printed(&["circle", "1", "-m", "midpoint", "-p", "15"])
            .contains("C1 0.552284749830793 0.552284749830793 1 0 1")
    );
    assert_eq!(
        printed(&["circle", "1", "-m", "standard"]),
        printed(&["circle", "1", "-m", "lancaster-normal"])
    );
}

#[test]
fn lancasters_ellipse_in_postscript() {
    let arguments = [
        "ellipse",
        "--diameters",
        "300,200",
        "-m",
        "lancaster-drawellipse",
        "-f",
        "ps",
        "-p",
        "7",
        "--open",
    ];
    assert_eq!(
        printed(&arguments),
        "-150 0 moveto\n\
         -150 55.183475 -82.7752125 100 0 100 curveto\n\
         82.7752125 100 150 55.183475 150 0 curveto\n\
         150 -55.183475 82.7752125 -100 0 -100 curveto\n\
         -82.7752125 -100 -150 -55.183475 -150 0 curveto\n"
    );
}

#[test]
fn the_counts_that_tolerances_ask_for() {
    assert_eq!(segments(&["circle", "1", "-t", "1e-6"]), 10);
    assert_eq!(segments(&["circle", "1", "-t", "1e-3"]), 4);
    assert_eq!(segments(&["circle", "1", "-t", "1e-2"]), 3);
    assert_eq!(segments(&["circle", "1000", "-t", "0.0001%"]), 10);
}

#[test]
fn the_default_count_forgives_a_twentieth_of_a_quarter() {
    for (end, count) in [
        ("90", 1),
        ("90.05", 1),
        ("94", 1),
        ("94.5", 1),
        ("94.6", 2),
        ("184.5", 2),
        ("185", 3),
        ("1e-9", 1),
    ] {
        assert_eq!(
            segments(&["arc", "10", "--start", "0", "--end", end]),
            count,
            "{end}"
        );
    }
    assert_eq!(segments(&["circle", "10"]), 4);
}

#[test]
fn given_end_points_come_back_digit_for_digit() {
    let path = printed(&["arc", "--svg", "M10 80a25,25-30 0150-25", "-n", "3"]);
    assert!(
        path.starts_with("M10 80C") && path.ends_with(" 60 55\n"),
        "{path}"
    );
    let path = printed(&["arc", "--svg", "M.1 .123456789A2 3 10 0 1 7.3000001-.7"]);
    assert!(
        path.starts_with("M0.1 0.123456789C") && path.ends_with(" 7.3000001-0.7\n"),
        "{path}"
    );
    let path = printed(&["arc", "--svg", "M.1.1a1 1 0 0 1 .2.2"]);
    assert!(path.ends_with(" 0.3 0.3\n"), "{path}");
    let path = printed(&["arc", "--through", "0.1,0.2", "1.7,1.3", "2.3,-0.4"]);
    assert!(
        path.starts_with("M0.1 0.2C") && path.ends_with(" 2.3-0.4\n"),
        "{path}"
    );
}

#[test]
fn the_rules_of_svg_for_arcs_out_of_range() {
    // A zero radius is a line, equal end points are nothing, negative radii count as positive, small ones are scaled up.
    assert_eq!(
        printed(&["arc", "--svg", "M0 0A0 5 0 0 1 10 5"]),
        "M0 0L10 5\n"
    );
    assert_eq!(printed(&["arc", "--svg", "M3 4A5 5 0 0 1 3 4", "-q"]), "\n");
    assert_eq!(
        printed(&["arc", "--svg", "M0 0A-5 5 0 0 1 5 5"]),
        printed(&["arc", "--svg", "M0 0A5-5 0 0 1 5 5"])
    );
    let scaled = json(&["arc", "--svg", "M0 0A1 1 0 0 1 10 0"]);
    assert_eq!(
        scaled["shape"]["radii"],
        serde_json::json!([5, 5])
            .to_string()
            .parse::<Value>()
            .unwrap()
    );
    assert_eq!(scaled["shape"]["sweep"].as_f64(), Some(180.0));
    // All four pairs of flags give different arcs between the same points.
    let arcs: Vec<String> = ["00", "01", "10", "11"]
        .iter()
        .map(|flags| printed(&["arc", "--svg", &format!("M0 0a5 7 20 {flags}5 5")]))
        .collect();
    assert!(
        arcs.iter()
            .enumerate()
            .all(|(i, arc)| !arcs[i + 1..].contains(arc))
    );
}

#[test]
fn lines_and_what_is_no_arc() {
    assert_eq!(
        printed(&["arc", "--through", "0.1,0.1", "0.2,0.2", "0.3,0.3"]),
        "M0.1 0.1L0.3 0.3\n"
    );
    assert_eq!(
        printed(&["arc", "--from", "0,0", "--to", "3,4", "--bulge", "0"]),
        "M0 0L3 4\n"
    );
    refused(&["arc", "--through", "1,1", "1,1", "1,1"]);
    refused(&["arc", "--through", "1,1", "1,1", "2,2"]);
}

#[test]
fn closed_shapes_start_and_run_as_the_format_wants_unless_asked() {
    assert!(printed(&["circle", "1"]).starts_with("M1 0C1 0.55"));
    assert!(printed(&["circle", "1", "-f", "ps"]).starts_with("-1 0 moveto\n-1 0.55"));
    assert!(
        printed(&["circle", "1", "-f", "ps", "--reverse"]).starts_with("-1 0 moveto\n-1 -0.55")
    );
    assert!(printed(&["circle", "1", "-f", "ps", "--start", "90"]).starts_with("0 1 moveto\n0.55"));
    assert!(printed(&["circle", "1", "--reverse"]).starts_with("M1 0C1-0.55"));
    assert!(printed(&["circle", "1", "--start", "-90"]).starts_with("M0-1C0.55"));
    assert!(!printed(&["circle", "1", "--open"]).contains('Z'));
    assert!(printed(&["arc", "5", "--sweep", "-270"]).starts_with("M5 0C5-2.7"));
}

#[test]
fn impossible_requests_say_why_and_what_would_do() {
    let message = refused(&["circle", "50", "-m", "lancaster-best", "-n", "7"]);
    for count in ["2", "3", "4", "5", "6", "8"] {
        assert!(message.contains(count), "{message}");
    }
    assert!(refused(&["circle", "50", "-m", "minmax"]).contains("minimax"));
    for (arguments, word) in [
        (&["circle", "-5"][..], "positive"),
        (&["circle", "nan"], "positive"),
        (&["circle", "inf"], "positive"),
        (&["circle", "0"], "positive"),
        (&["ellipse", "3", "-2"], "positive"),
        (&["circle", "1e200"], "large"),
        (&["circle", "1e-200"], "small"),
        (&["circle", "five"], "number"),
        (&["circle", "5", "-n", "0"], "segments"),
        (
            &["circle", "5", "--handle", "0.5", "--joints", "0,90,300"],
            "--handle cannot do this",
        ),
        (&["sphere", "5", "-f", "gcode"], "'curveto path --to arcs'"),
        (&["circle", "5", "-n", "1"], "180"),
        (&["circle", "5", "-t", "-1"], "tolerance"),
        (&["circle", "5", "-t", "1e-30"], "finest"),
        (
            &["circle", "5", "-n", "4", "-t", "1"],
            "cannot be used with",
        ),
        (
            &["circle", "5", "-n", "4", "--joints", "0,120,240"],
            "cannot be used with",
        ),
        (
            &["circle", "5", "-m", "minimax", "--handle", "0.5"],
            "cannot be used with",
        ),
        (&["circle", "5", "--joints", "0,120,120,240"], "120"),
        (
            &[
                "circle",
                "5",
                "-m",
                "minimax-free",
                "--joints",
                "0,100,200,300",
            ],
            "uneven",
        ),
        (
            &["arc", "5", "--end", "90", "-m", "minimax-free"],
            "open arc",
        ),
        (&["circle", "5", "-m", "chen-1", "-n", "2"], "three"),
        (&["circle", "5", "-m", "apprich", "-n", "2"], "120"),
        (
            &["circle", "5", "-m", "lancaster-drawellipse", "-n", "5"],
            "quarters",
        ),
        (&["arc", "5", "--sweep", "400"], "360"),
        (&["arc", "5"], "--end or --sweep"),
        (
            &["circle", "5", "--transform", "scale(0)"],
            "a line or a point: nothing is left to draw",
        ),
        (&["circle", "5", "--transform", "scale(1 0)"], "flattens"),
        (&["circle", "5", "--transform", "turn(5)"], "transform"),
        (&["circle", "5", "-p", "0", "-t", "0.01"], "rounding"),
        (&["circle", "5", "-f", "tiff"], "possible values: path, svg"),
        (&["circle", "5", "-o", "x.jpg"], "jpg"),
        (&["circle", "5", "--quadrature", "gauss2"], "chen-2"),
        (&["procset", "-m", "minimax-g0"], "magic"),
    ] {
        let message = refused(arguments);
        assert!(message.contains(word), "{arguments:?}: {message}");
    }
}

#[test]
fn an_svg_arc_that_does_not_parse_is_told_with_its_column() {
    for (text, column) in [
        ("M10 80a25,25-30 015x-25", 20),
        ("M10 80a25,25-30 0 2 50-25", 19),
        ("M10 80a25,25-30 0", 18),
        ("hello", 1),
        ("", 1),
        ("M0 0L5 5", 5),
        ("M0 0 5 5", 6),
        ("L5 5", 1),
        ("M0 0A1 1 0 0 1 5 5 Z", 20),
        ("M0 0A1 1 0 0 1 5 5A1 1 0 0 1 9 9", 19),
        ("M0 0A1 1 0 0 1 5 5 1 1 0 0 1 9 9", 20),
    ] {
        let message = refused(&["arc", "--svg", text]);
        assert!(
            message.contains(&format!("at column {column}\n")),
            "{text}: {message}"
        );
    }
}

#[test]
fn an_error_in_a_file_of_path_data_is_told_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.path");
    fs::write(&file, "M0 0\nL5 X\n").unwrap();
    let name = file.to_str().unwrap();
    for words in [&["path", name][..], &["measure", "--path", name]] {
        let message = refused(words);
        assert!(
            message.starts_with(&format!(
                "error: {name}: cannot read the path data 'M0 0 L5 X'"
            )) && message.contains("is expected in line 2 at character 4"),
            "{message}"
        );
    }
}

#[test]
fn an_arc_of_no_length_is_noted() {
    for (arguments, is_noted) in [
        (&["arc", "5", "--start", "0", "--end", "0"][..], true),
        (&["arc", "--svg", "M1 1A5 5 0 0 1 1 1"], true),
        (&["arc", "5", "--start", "0", "--end", "0", "-q"], false),
        (&["arc", "5", "--start", "0", "--end", "1"], false),
    ] {
        let output = run(arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{said}");
        let noted = said == "note: the arc has no length, so that nothing is drawn\n";
        assert!(noted == is_noted && (noted || said.is_empty()), "{said}");
    }
}

#[test]
fn output_files_are_whole_or_untouched() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("circle.svg.path");
    let name = file.to_str().unwrap();
    assert!(printed(&["circle", "50", "-o", name]).is_empty());
    assert_eq!(
        fs::read_to_string(&file).unwrap(),
        printed(&["circle", "50"])
    );
    refused(&["circle", "-5", "-o", name]);
    assert_eq!(
        fs::read_to_string(&file).unwrap(),
        printed(&["circle", "50"])
    );
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    let output = run(&[
        "circle",
        "50",
        "-o",
        folder.path().join("none/c.ps").to_str().unwrap(),
    ]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        String::from_utf8(output.stderr)
            .unwrap()
            .starts_with("error: cannot write ")
    );
}

#[test]
fn the_format_follows_the_extension() {
    let folder = tempfile::tempdir().unwrap();
    for format in ["path", "ps", "eps", "json"] {
        let file = folder.path().join(format!("circle.{format}"));
        printed(&["circle", "50", "-o", file.to_str().unwrap()]);
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            printed(&["circle", "50", "-f", format])
        );
    }
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_mode_and_a_link_its_target() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("a.path"), folder.path().join("b.path"));
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    printed(&["circle", "50", "-o", link.to_str().unwrap()]);
    assert_eq!(
        fs::metadata(&file).unwrap().permissions().mode() & 0o777,
        0o640
    );
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&file).unwrap().starts_with("M50 0C"));
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_is_told_in_the_words_of_the_system() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("a.svg");
    fs::write(&drawing, "<svg><circle r='5'/></svg>").unwrap();
    let drawing = drawing.to_str().unwrap();
    let folder = folder.path().to_str().unwrap();
    for (file, why) in [
        ("/proc/a.svg", "No such file or directory"),
        (folder, "Is a directory"),
        ("/dev/full", "No space left on device"),
    ] {
        for arguments in [
            &["circle", "50", "-f", "svg", "-o", file][..],
            &["spline", "--points", "0,0 1,1", "-f", "svg", "-o", file],
            &["sphere", "50", "-f", "svg", "-o", file],
            &["procset", "-o", file],
            &["convert", drawing, "-o", file],
        ] {
            let output = run(arguments);
            let message = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(
                message.contains(&format!("cannot write {file}: {why}")),
                "{arguments:?}: {message}"
            );
            assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        }
    }
}

#[test]
fn a_closed_pipe_ends_quietly_with_0() {
    let output = unread(&["circle", "50", "-n", "50000"], b"");
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
}

#[test]
fn json_states_the_shape_the_segments_and_the_error() {
    let drawing = json(&[
        "ellipse",
        "150",
        "100",
        "-m",
        "lancaster-drawellipse",
        "--start",
        "180",
        "--reverse",
        "-p",
        "2",
    ]);
    assert_eq!(drawing["version"], 1);
    assert_eq!(drawing["shape"]["kind"], "ellipse");
    assert_eq!(drawing["shape"]["start"].as_f64(), Some(180.0));
    assert_eq!(drawing["shape"]["sweep"].as_f64(), Some(-360.0));
    assert_eq!(drawing["method"], "lancaster-drawellipse");
    assert_eq!(drawing["closed"], true);
    let first = &drawing["segments"][0];
    assert_eq!(
        first["points"].to_string(),
        "[[-150,0],[-150,55.18],[-82.78,100],[0,100]]"
    );
    assert_eq!(first["angles"].to_string(), "[180,90]");
    assert_eq!(first["power"]["x"].to_string(), "[-51.66,201.66,0,-150]");
    assert!(
        drawing["path"]
            .as_str()
            .unwrap()
            .starts_with("M-150 0C-150 55.18-82.78 100 0 100C")
    );
}

#[test]
#[cfg(unix)]
fn bash_completes_the_word_after_each_comma_of_a_list() {
    let completed = |words: &[&str]| {
        let [.., before, last] = words else {
            return String::new();
        };
        let script = printed(&["completions", "bash"]);
        let ask = format!(
            "{script}\nCOMP_WORDS=({}); COMP_CWORD={}; _curveto_list curveto '{last}' '{before}'; echo \"${{COMPREPLY[@]}}\"",
            words.join(" "),
            words.len() - 1
        );
        let output = std::process::Command::new("bash")
            .args(["-c", &ask])
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    let compare = ["curveto", "compare", "-m"];
    assert_eq!(completed(&[&compare[..], &["mid"]].concat()), "midpoint");
    assert_eq!(
        completed(&[&compare[..], &["c4,mid"]].concat()),
        "c4,midpoint"
    );
    assert_eq!(
        completed(&["curveto", "circle", "--show", "joints,error=5,tr"]),
        "joints,error=5,truth"
    );
    assert_eq!(
        completed(&["curveto", "procset", "--with", "reporter,"]),
        "reporter,reporter reporter,trig"
    );
    // A point is no list of words.
    assert_eq!(completed(&["curveto", "circle", "--center", "1,"]), "");
    // The value of --flag=value, which bash gives as three words where = breaks words.
    let circle = ["curveto", "circle", "5"];
    let after = |words: &[&'static str]| completed(&[&circle[..], words].concat());
    assert_eq!(after(&["--format", "=", "sv"]), "svg");
    assert_eq!(after(&["--method", "=", "midp"]), "midpoint");
    assert_eq!(after(&["--show", "=", "joints,tr"]), "joints,truth");
    assert_eq!(after(&["--format=sv"]), "--format=svg");
    assert_eq!(
        completed(&["curveto", "sphere", "5", "-f", "g"]),
        "glif",
        "a sphere is never G-code"
    );
    // Files are bash's own answer, where there is no other.
    for words in ["diff", "diff old.svg", "convert", "batch -f json", "path"] {
        let words = format!("curveto {words}");
        let mut words = program::words(&words);
        words.push("");
        assert_eq!(completed(&words), "", "{words:?}");
    }
    for words in [["circle", ""], ["diff", "-"]] {
        assert!(completed(&["curveto", words[0], words[1]]).contains("--version"));
    }
    assert!(printed(&["completions", "bash"]).ends_with("-o default curveto\n"));
}

#[test]
fn completions_and_manual_pages() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(printed(&["completions", shell]).contains("curveto"));
    }
    for shell in ["bash", "zsh", "fish"] {
        let script = printed(&["completions", shell]);
        // Methods by alias, wherever one is asked for: fifteen commands and shapes, `methods ID` and `compare -m` among them.
        assert!(script.matches("lancaster-normal").count() >= 15, "{shell}");
        assert!(script.contains("error=500"), "{shell}: --show");
    }
    // In a list the word after each comma is completed.
    assert!(
        printed(&["completions", "zsh"])
            .contains(r#":ID,ID|all:_values -s , ID "all[every method]""#)
    );
    let fish = printed(&["completions", "fish"]);
    assert!(fish.contains("-l only -d 'Replace only these' -r -f -a \"(__fish_append , circle"));
    assert!(
        fish.contains("-l with -d 'More of his procedures' -r -f -a \"(__fish_append , reporter")
    );
    // What stands without a flag.
    for (command, word) in [("methods", "minimax\\t'"), ("completions", "zsh\n")] {
        let line = format!("_subcommand {command}\" -f -a \"");
        let (_, words) = fish.split_once(&line).unwrap();
        let (words, _) = words.split_once('"').unwrap();
        assert!(format!("{words}\n").contains(word), "{command}: {words}");
    }
    assert!(printed(&["man"]).contains(".TH curveto 1"));
    let folder = tempfile::tempdir().unwrap();
    printed(&["man", "--out-dir", folder.path().to_str().unwrap()]);
    assert!(
        fs::read_to_string(folder.path().join("curveto-circle.1"))
            .unwrap()
            .contains("curveto\\-circle")
    );
}
