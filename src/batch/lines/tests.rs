//! What a line says, and how its answer is written.

use super::*;
use crate::batch::figure;
use crate::joints::Cut;
use crate::method::Method;
use crate::number::Precision;
use crate::shape::Circle;

fn worker(format: Format, measure: bool) -> Worker {
    Worker::new(Options {
        format,
        measure,
        precision: Some(Precision::Fixed(3)),
        on_error: OnError::Report,
        ..Options::default()
    })
}

fn answer(worker: &mut Worker, lines: &str) -> String {
    let mut answers = Answers::default();
    worker.answer(lines.as_bytes(), &mut answers);
    String::from_utf8(answers.text).unwrap()
}

#[test]
fn what_a_line_says_holds_for_it() {
    let shape = Shape::Circle(Circle::new((1.0, 2.0), 3.0).unwrap());
    for (said, method, count) in [
        ("", Method::Minimax, 4),
        (r#","method":"chen-3""#, Method::Chen3, 4),
        (r#","segments":5"#, Method::Minimax, 5),
        (r#","method":"midpoint","segments":3"#, Method::Midpoint, 3),
    ] {
        let line = format!(r#"{{"circle":{{"center":[1,2],"radius":3}}{said}}}"#);
        let options = approximate::Options {
            rule: method.into(),
            cut: Cut::Count(count),
            precision: Some(Precision::Fixed(3)),
            ..approximate::Options::default()
        };
        let drawing = approximate(&shape, &options).unwrap();
        let data = path::data([&drawing.curve], false);
        for measure in [false, true] {
            let mut worker = worker(Format::Path, measure);
            assert_eq!(answer(&mut worker, &line).trim_end(), data, "{said}");
        }
        let batch = Options {
            precision: options.precision,
            ..Options::default()
        };
        let picture = figure(line.as_bytes(), &batch, |_, _| ()).unwrap();
        assert_eq!(picture.figure.layers[0].curves[0], drawing.curve, "{said}");
    }
}

#[test]
fn what_is_measured_is_drawn_as_what_is_not() {
    let lines = "circle 0 0 5\nellipse 1 2 5 3 20\narc 0 0 5 10 70\npath M0 0A3 3 0 0 1 4 4L9 9\n";
    for format in [Format::Path, Format::Ps] {
        let text = answer(&mut worker(format, false), lines);
        assert_eq!(text.lines().count(), 4);
        assert_eq!(answer(&mut worker(format, true), lines), text);
    }
}

#[test]
fn answers_come_in_parts_once_they_are_long() {
    let lines = b"#\n#\narc 0 0 1 0 90\n#\narc 0 0 1 0 90";
    let mut worker = worker(Format::Path, false);
    let mut answers = Answers::default();
    let length = worker.answer_some(lines, usize::MAX, &mut answers);
    assert_eq!((length, answers.lines), (None, 5));
    let left = worker.answer_some(lines, 5, &mut answers);
    assert_eq!((left, answers.lines), (Some(19), 3));
    let left = worker.answer_some(&lines[19..], 5, &mut answers);
    assert_eq!((left, answers.lines), (None, 2));
}

#[test]
fn a_byte_that_is_no_text_is_pointed_at() {
    let Err(Error::Syntax { column, .. }) = text_of(b"circle 0 \xff 3") else {
        panic!("it was read");
    };
    assert_eq!(column, 10);
}

/// Lancaster's `drawellipse` starts at the left and runs clockwise.
#[test]
fn postscript_comes_in_one_line() {
    let circle = "-3 0 moveto -3 1.657 -1.657 3 0 3 curveto 1.657 3 3 1.657 3 0 curveto \
        3 -1.657 1.657 -3 0 -3 curveto -1.657 -3 -3 -1.657 -3 0 curveto closepath";
    for (line, expected) in [
        ("arc 0 0 5 10 0", ""),
        ("circle 0 0 3", circle),
        ("ellipse 0 0 3 3", circle),
        (
            "path M0 0L1 0L1 1ZM5 5L6 6",
            "0 0 moveto 1 0 lineto 1 1 lineto 0 0 lineto closepath 5 5 moveto 6 6 lineto",
        ),
    ] {
        let lines = format!("#\n{line}");
        let text = answer(&mut worker(Format::Ps, false), &lines);
        assert_eq!(
            text.replace("1.656", "1.657"),
            format!("\n{expected}\n"),
            "{line}"
        );
    }
}

#[test]
fn an_id_stands_first_in_the_json_of_a_path() {
    for line in [
        r#"{"id":[7],"path":"M0 0L1 1"}"#,
        r#"{"id":[7],"circle":{"radius":1}}"#,
    ] {
        let text = answer(&mut worker(Format::Json, false), line);
        assert!(text.starts_with(r#"{"id":[7],"#), "{text}");
        assert!(
            serde_json::from_str::<serde_json::Value>(&text).is_ok(),
            "{text}"
        );
    }
}
