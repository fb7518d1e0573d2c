//! Help: short help fits a screen, long help and the manual pages end in worked examples and the exit codes.

use std::fs;
use std::path::PathBuf;

use crate::judges::program::{on_terminal, program, shell};

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
#[cfg(target_os = "linux")]
const SCREEN: usize = 45;

/// Help on a terminal: however narrow that is, no example is broken into two lines, so that each can be copied.
fn help(words: &[&str]) -> String {
    let columns = if words.contains(&"--help") { 60 } else { 80 };
    on_terminal(&words.join(" "), columns)
}

/// The commands below the last line that says `Examples:`.
fn examples(help: &str) -> Vec<String> {
    let (_, last) = help.rsplit_once("\nExamples:\n").expect(help);
    let (commands, rest) = last.split_once("\n\n").expect(help);
    assert!(rest.starts_with("Exit codes: 0 "), "{help}");
    let signals = rest
        .replace('\n', " ")
        .contains("129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM.");
    assert!(signals || rest.contains("2 trouble"), "{help}");
    commands
        .lines()
        .map(|line| line.trim().to_owned())
        .collect()
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
            let script = format!("set -eu\n{line}");
            let output = shell(&folder, &script).output().unwrap();
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
#[cfg(target_os = "linux")]
fn short_help_fits_a_screen() {
    let shapes = ["circle", "ellipse", "arc", "conic"];
    let inner = ["measure", "explore"].map(|command| shapes.map(|shape| vec![command, shape]));
    let all = COMMANDS.map(|name| vec![name]);
    for mut words in all.into_iter().chain(inner.into_iter().flatten()) {
        words.push("-h");
        let page = help(&words);
        let lines = page.lines().count();
        assert!(lines <= SCREEN, "{words:?}: {lines} lines");
        for line in page.lines() {
            assert!(line.chars().count() <= 80, "{words:?}: {line}");
        }
    }
}

#[test]
fn manual_pages_end_in_the_examples_and_the_exit_codes() {
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("man");
    let status = shell(folder.path(), "curveto man --out-dir man").status();
    assert!(status.unwrap().success());
    let inner = ["measure-circle", "measure-conic", "explore-arc"];
    for name in COMMANDS.into_iter().chain(inner) {
        let page = fs::read_to_string(pages.join(format!("curveto-{name}.1"))).unwrap();
        let (_, last) = page.rsplit_once(".SH ").unwrap();
        assert!(
            last.starts_with("EXAMPLES\n.PP\n.RS 4\n.nf\n"),
            "{name}: {last}"
        );
        assert_eq!(last.lines().count(), 9, "{name}: {last}");
        assert!(page.contains("\n.SH EXIT STATUS\n.TP\n.B 0\n"), "{name}");
        let title = format!(".TH curveto-{name} 1  curveto \n");
        assert!(page.contains(&title), "{name}: {}", &page[..400]);
        // Options that short help leaves out have their text too.
        for item in page.split("\n.TP\n").skip(1) {
            let text = item.lines().nth(1).unwrap_or_default();
            assert!(!text.is_empty() && !text.starts_with('.'), "{name}: {item}");
        }
    }
    let batch = fs::read_to_string(pages.join("curveto-batch.1")).unwrap();
    let (_, lines) = batch.split_once("\n.SH LINES\n").unwrap();
    let (_, forms) = lines.split_once("\n.nf\ncircle CX CY R\n").unwrap();
    let (forms, _) = forms.split_once("\n.fi\n").unwrap();
    assert!(forms.contains("\nsvgarc X1 Y1 RX RY ROTATION LARGE SWEEP X2 Y2\n"));
    assert!(lines.contains("\n{\"path\": \"M0 0A5 5 0 0 1 10 0Z\"}\n.fi\n"));
}

/// What a command says on standard error.
fn complaint(words: &str, variables: &[(&str, &str)]) -> (Option<i32>, String) {
    let output = program(&words.split(' ').collect::<Vec<_>>())
        .envs(variables.iter().copied())
        .stdin(std::process::Stdio::null())
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    (output.status.code(), said)
}

#[test]
fn mistakes_of_all_kinds_are_told_alike() {
    let said = |words| complaint(words, &[]);
    assert_eq!(
        said("circle 50 --epsilon 0.1").1,
        "error: unexpected argument '--epsilon' found\n\
         hint: -t sets the tolerance, how far a curve may stray\n\n\
         Usage: curveto circle [OPTIONS] [RADIUS]\n\n\
         For more information, try '--help'.\n"
    );
    assert_eq!(
        said("completions tcsh").1,
        "error: invalid value 'tcsh' for '<SHELL>'\n  \
           [possible values: bash, elvish, fish, powershell, zsh]\n\
         hint: for example: curveto completions bash\n\n\
         For more information, try '--help'.\n"
    );
    for words in [
        "circle",
        "circle 5 --stroek red",
        "circle 5mm",
        "circle 5 -n 0",
        "foo",
        "measure foo",
    ] {
        let (code, message) = said(words);
        assert_eq!(code, Some(2), "{words}");
        assert!(message.starts_with("error: "), "{words}: {message}");
        assert!(!message.contains("\n\nhint:"), "{words}: {message}");
        assert!(!message.contains("tip:"), "{words}: {message}");
    }
    let (_, usage) = said("measure circle 5 --foo");
    assert!(
        usage.contains("\nUsage: curveto measure circle [OPTIONS] [RADIUS]\n"),
        "{usage}"
    );
}

#[test]
fn messages_are_coloured_alike_where_there_are_colours() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("open.svg");
    let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="50%"/></svg>"#;
    fs::write(&file, drawing).unwrap();
    let convert = format!("convert {} -o {}", file.display(), file.display());
    for (words, coloured) in [
        ("circle 5 --epsilon 1", "\x1b[1;31merror:\x1b[0m unexpected"),
        ("circle 5 --epsilon 1", "\n\x1b[1;36mhint:\x1b[0m -t sets"),
        ("circle 5 -n 0", "\x1b[1;31merror:\x1b[0m "),
        ("arc 5 --start 0", "\n\x1b[1;36mhint:\x1b[0m "),
        (&convert, "\x1b[1;32mnote:\x1b[0m "),
    ] {
        let (_, message) = complaint(words, &[("CLICOLOR_FORCE", "1")]);
        assert!(message.contains(coloured), "{words}: {message:?}");
        for variables in [&[][..], &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]] {
            let (_, message) = complaint(words, variables);
            assert!(!message.contains('\x1b'), "{words}: {message:?}");
        }
    }
}

#[test]
fn a_format_that_is_always_refused_is_not_offered() {
    for (command, hint) in [
        ("batch", "path --to arcs"),
        ("sphere 5", "--to arcs"),
        ("spline --points 0,0,5,8,9,0", "--to arcs"),
    ] {
        let name = command.split(' ').next().unwrap();
        for flag in ["-h", "--help"] {
            let page = help(&[name, flag]);
            assert!(
                page.contains("dxf") && !page.contains("gcode:") && !page.contains("dxf, gcode"),
                "{page}"
            );
        }
        let (code, message) = complaint(&format!("{command} -f gcode"), &[]);
        assert_eq!(code, Some(2), "{message}");
        assert!(
            message.contains("hint: ") && message.contains(hint),
            "{message}"
        );
        let (_, message) = complaint(&format!("{command} -f foo"), &[]);
        assert!(message.contains("glif, dxf]"), "{message}");
    }
}

#[test]
fn quiet_silences_the_notes_of_measure() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("two.svg");
    let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L5 5"/><path d="M5 0C5 2.76 2.76 5 0 5"/></svg>"#;
    fs::write(&file, drawing).unwrap();
    let measure = format!("measure --file {}", file.display());
    let (code, message) = complaint(&measure, &[]);
    assert_eq!(code, Some(0));
    assert!(message.starts_with("note: "), "{message}");
    assert_eq!(
        complaint(&format!("{measure} -q"), &[]),
        (Some(0), String::new())
    );
    for words in ["compare -m minimax -q", "explore circle 5 --quiet"] {
        assert_eq!(complaint(words, &[]), (Some(0), String::new()));
    }
}
