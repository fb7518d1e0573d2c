//! `batch`: the same answers as the drawing commands give, in order, from streams of any kind.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::Stdio;
use std::sync::mpsc::channel;
use std::time::Duration;

use curveto::batch::spec::{LineContent, Spec};
use curveto::batch::{OnError, Options, run};
use curveto::number::{Precision, text};
use curveto::path;
use curveto::write::{Format, json};
use curveto::{Cut, Method, Rule, Tolerance, approximate};
use proptest::prelude::*;

use crate::judges::program::{self, program};

fn answers(input: &str, options: &Options) -> Vec<String> {
    let mut out = Vec::new();
    let input = std::io::Cursor::new(input.to_owned());
    run(input, &mut out, options, |_, _| ()).unwrap();
    let text = String::from_utf8(out).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Standard output, standard error and exit code of a command with this input.
fn piped(args: &[&str], input: &str) -> (String, String, i32) {
    let output = program::piped(args, input.as_bytes());
    (
        String::from_utf8(output.stdout).unwrap(),
        String::from_utf8(output.stderr).unwrap(),
        output.status.code().unwrap(),
    )
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e4..1e4_f64,
        (-2000..2000_i32).prop_map(|n| f64::from(n) / 8.0),
        Just(0.0)
    ]
}

fn length() -> impl Strategy<Value = f64> {
    prop_oneof![
        (1e-3_f64.ln()..1e5_f64.ln()).prop_map(f64::exp),
        (1..4000_u32).prop_map(|n| f64::from(n) / 16.0)
    ]
}

fn angle() -> impl Strategy<Value = f64> {
    prop_oneof![
        -360.0..360.0_f64,
        (-24..24_i32).prop_map(|n| f64::from(n) * 15.0)
    ]
}

fn line() -> impl Strategy<Value = String> {
    let words = |name: &'static str, numbers: Vec<f64>| {
        let numbers: Vec<String> = numbers.into_iter().map(text).collect();
        format!("{name} {}", numbers.join(" "))
    };
    prop_oneof![
        (coordinate(), coordinate(), length())
            .prop_map(move |(x, y, r)| words("circle", vec![x, y, r])),
        (coordinate(), coordinate(), length(), angle(), angle())
            .prop_map(move |(x, y, r, start, sweep)| words("arc", vec![x, y, r, start, sweep])),
        (coordinate(), coordinate(), length(), length(), angle()).prop_map(
            move |(x, y, rx, ry, rotation)| words("ellipse", vec![x, y, rx, ry, rotation])
        ),
        (
            coordinate(),
            coordinate(),
            length(),
            coordinate(),
            coordinate(),
            any::<[bool; 2]>()
        )
            .prop_map(move |(x, y, r, u, v, [large, sweep])| {
                let flag = |on| f64::from(u8::from(on));
                words(
                    "svgarc",
                    vec![x, y, r, r / 2.0, 10.0, flag(large), flag(sweep), u, v],
                )
            }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn answers_are_what_a_drawing_prints(
        line in line(),
        decimals in prop::option::of(0_u8..18),
        cut in prop_oneof![
            Just(Cut::Quarters),
            (4_usize..12).prop_map(Cut::Count),
            (1e-9_f64.ln()..1e-1_f64.ln()).prop_map(|t| Cut::Tolerance(Tolerance::Relative(t.exp())))
        ],
    ) {
        let precision = decimals.map(Precision::Fixed);
        let options = Options { cut: cut.clone(), precision, on_error: OnError::Blank, ..Options::default() };
        let LineContent::Shape(shape) = Spec::parse(&line).unwrap().subject else {
            panic!("{line} is a path");
        };
        let drawing = approximate(&shape, &curveto::Options { cut, precision, ..curveto::Options::default() });
        let expected = drawing.map_or_else(|_| String::new(), |drawing| path::data([&drawing.curve], false));
        prop_assert_eq!(answers(&(line + "\n"), &options).concat(), expected);
    }
}

#[test]
fn the_commands_print_the_same() {
    for (args, line) in [
        (vec!["circle", "50"], "circle 0 0 50"),
        (
            vec!["circle", "0.3", "--center", "-1,2.5"],
            "circle -1 2.5 0.3",
        ),
        (
            vec!["ellipse", "30", "20", "--rotation", "15"],
            "ellipse 0 0 30 20 15",
        ),
        (
            vec!["arc", "5", "--start", "10", "--sweep", "-200"],
            "arc 0 0 5 10 -200",
        ),
        (
            vec!["arc", "--svg", "M0 0A25 25-30 0150-25"],
            "svgarc 0 0 25 25 -30 0 1 50 -25",
        ),
    ] {
        for more in [
            &["-t", "0.001"][..],
            &["-n", "5"],
            &["-p", "2"],
            &["-m", "standard"],
            &[],
        ] {
            let drawn = program(&[&args[..], more].concat())
                .output()
                .unwrap()
                .stdout;
            let batch = [&["batch"][..], more].concat();
            let (answered, _, code) = piped(&batch, line);
            assert_eq!(answered.as_bytes(), drawn, "{args:?} {more:?}");
            assert_eq!(code, 0);
        }
    }
    let (json, _, _) = piped(&["batch", "-f", "json"], "circle 0 0 50\n");
    let drawn = program(&["circle", "50", "-f", "json"])
        .output()
        .unwrap()
        .stdout;
    let value = |bytes: &[u8]| serde_json::from_slice::<serde_json::Value>(bytes).unwrap();
    assert_eq!(value(json.as_bytes()), value(&drawn));
    let (ps, _, _) = piped(&["batch", "-f", "ps"], "circle 0 0 50\n");
    let drawn = program(&["circle", "50", "-f", "ps"])
        .output()
        .unwrap()
        .stdout;
    assert_eq!(
        ps,
        String::from_utf8(drawn)
            .unwrap()
            .replace('\n', " ")
            .trim_end()
            .to_owned()
            + "\n"
    );
}

#[test]
fn order_is_kept_and_threads_change_nothing() {
    let lines = (0..40_000).map(|i| match i % 5 {
        0 => "# a comment\n".to_owned(),
        1 => format!("circle {i} 0 {}\n", i + 1),
        2 => format!(
            "{{\"id\": {i}, \"arc\": {{\"radius\": 3, \"sweep\": {}}}}}\r\n",
            1 + i % 300
        ),
        3 => "\n".to_owned(),
        _ => format!("arc 0 {i} 7 {i} 90\n"),
    });
    let input: String = lines.collect();
    for format in [Format::Path, Format::Json] {
        let options = |jobs| Options {
            format,
            jobs,
            ..Options::default()
        };
        let one = answers(&input, &options(1));
        assert_eq!(one.len(), 40_000);
        assert!(one[0].is_empty() && one[3].is_empty());
        assert_eq!(answers(&input, &options(2)), one);
        assert_eq!(answers(&input, &options(5)), one);
    }
}

#[test]
fn ids_pass_through() {
    let input = r#"{"id": "a1", "circle": {"center": [0,0], "radius": 50}, "method": "minimax", "segments": 4}"#;
    let options = Options {
        format: Format::Json,
        precision: Some(Precision::Full),
        ..Options::default()
    };
    let answer = answers(input, &options).concat();
    assert!(answer.starts_with(r#"{"id":"a1","version":1,"#), "{answer}");
    let document: serde_json::Value = serde_json::from_str(&answer).unwrap();
    assert_eq!(document["segments"].as_array().unwrap().len(), 4);
    let LineContent::Shape(shape) = Spec::parse("circle 0 0 50").unwrap().subject else {
        panic!("a circle is a shape");
    };
    let full = curveto::Options {
        precision: Some(Precision::Full),
        ..curveto::Options::default()
    };
    let drawing = approximate(&shape, &full).unwrap();
    let own = json::to_line(&json::DrawingDocument::from(&drawing)).unwrap();
    assert_eq!(answer, own.replacen('{', r#"{"id":"a1","#, 1));
}

#[test]
fn bad_lines_stop_or_are_passed_over() {
    let input = "circle 0 0 1\n\ncircle 0 0 -1\ncircle 0 0 2\nsquare\n";
    let (out, err, code) = piped(&["batch"], input);
    assert_eq!((out.lines().count(), code), (2, 1), "{out}");
    assert!(
        err.starts_with("error: <stdin>:3: the radius must be"),
        "{err}"
    );
    for jobs in ["1", "3"] {
        let (out, err, code) = piped(&["batch", "--on-error", "skip", "-j", jobs], input);
        assert_eq!((out.lines().count(), code), (3, 1));
        assert!(
            err.contains("<stdin>:3: ")
                && err.contains("<stdin>:5: cannot read the shape 'square'"),
            "{err}"
        );
        let (out, _, code) = piped(&["batch", "--on-error", "blank", "-j", jobs], input);
        assert_eq!((out.lines().count(), code), (5, 1));
    }
    let (out, err, code) = piped(&["batch", "/no/such/file"], "");
    assert_eq!((out.as_str(), code), ("", 1));
    assert!(err.starts_with("error: cannot read /no/such/file"), "{err}");
    assert_eq!(piped(&["batch", "-m", "nonsense"], "").2, 2);
    assert_eq!(piped(&["batch", "-n", "4", "-t", "1"], "").2, 2);
}

#[test]
fn methods_that_need_whole_circles_say_so_line_by_line() {
    let options = Options {
        rule: Rule::Method(Method::MinimaxFree),
        on_error: OnError::Blank,
        ..Options::default()
    };
    let answers = answers("circle 0 0 1\narc 0 0 1 0 90\n", &options);
    assert!(answers[0].starts_with('M') && answers[1].is_empty());
}

#[test]
fn a_coprocess_gets_its_answer_before_it_asks_again() {
    for jobs in ["1", "2"] {
        let mut child = program(&["batch", "-j", jobs])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut stdin = child.stdin.take().unwrap();
        let stdout = BufReader::new(child.stdout.take().unwrap());
        let (sender, answers) = channel();
        let reader = std::thread::spawn(move || {
            for line in stdout.lines() {
                sender.send(line.unwrap()).unwrap();
            }
        });
        for radius in 1..20 {
            writeln!(stdin, "circle 0 0 {radius}").unwrap();
            stdin.flush().unwrap();
            let answer = answers.recv_timeout(Duration::from_secs(20)).unwrap();
            assert!(answer.starts_with(&format!("M{radius} 0C")), "{answer}");
        }
        drop(stdin);
        reader.join().unwrap();
        assert!(child.wait().unwrap().success());
    }
}

#[test]
fn a_stop_does_not_wait_for_more_input() {
    let mut child = program(&["batch", "-j", "2"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(b"circle 0 0 1\nnonsense\n").unwrap();
    let mut out = String::new();
    child
        .stdout
        .take()
        .unwrap()
        .read_to_string(&mut out)
        .unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1));
    assert_eq!(out.lines().count(), 1);
    drop(stdin);
}

#[test]
fn json_lines_have_the_digits_of_lines_of_text() {
    // Of a number in twelve serde_json reads another one, a unit in the last place off, unless it is told not to.
    let (mut json, mut text) = (Vec::new(), Vec::new());
    for i in 1..400 {
        let x = f64::from(i) * 1.226_976_813_768_1 + 0.1 / f64::from(i);
        let shape = format!("{{\"center\":[{x},-{x}],\"radii\":[{x},0.5],\"rotation\":{x}}}");
        json.push(format!("{{\"ellipse\":{shape}}}\n"));
        text.push(format!("ellipse {x} -{x} {x} 0.5 {x}\n"));
    }
    let [json, text] = [json, text].map(|lines| piped(&["batch", "-f", "json"], &lines.concat()));
    assert_eq!(json.0.lines().count(), 399);
    for (from_json, from_text) in json.0.lines().zip(text.0.lines()) {
        assert_eq!(from_json, from_text);
    }
}

#[test]
fn commas_between_words_are_named() {
    let output = crate::judges::program::piped(&["batch"], b"circle,0,0,5\n");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("<stdin>:1: "), "{message}");
    assert!(
        message.contains("blanks stand between the words of a line, not commas"),
        "{message}"
    );
}
