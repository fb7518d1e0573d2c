//! One line's answer.

use kurbo::Affine;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use super::turn::Turns;
use super::{Answers, OnError, Options, worsen};
use crate::angle::Angle;
use crate::approximate::{self, approximate, sketch};
use crate::batch::spec::{LineContent, Spec};
use crate::contour::{BezierTarget, Contour, draw};
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::method::Rule;
use crate::number::memo::Memo;
use crate::path;
use crate::shape::Shape;
use crate::write::path::PathDocument;
use crate::write::{Format, json, postscript};

/// What an answer is.
#[derive(Debug, Clone, Copy)]
struct AnswerForm {
    format: Format,
    /// Whether its error is measured where the format does not state it.
    measures: bool,
}

/// Answers lines, one at a time.
#[derive(Debug)]
pub struct Worker {
    form: AnswerForm,
    on_error: OnError,
    /// What holds where a line does not say otherwise.
    options: approximate::Options,
    /// What circles are drawn by.
    turns: Turns,
    /// The last numbers of JSON.
    memo: Memo,
}

impl Worker {
    /// A worker with these options.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self {
            form: AnswerForm {
                format: options.format,
                measures: options.measure,
            },
            on_error: options.on_error,
            options: approximate::Options {
                rule: options.rule,
                cut: options.cut,
                precision: options.precision,
                transform: Affine::IDENTITY,
            },
            turns: Turns::default(),
            memo: Memo::default(),
        }
    }

    /// Answers whole lines; with [`OnError::Stop`] those up to the first that cannot be drawn.
    pub fn answer(&mut self, chunk: &[u8], answers: &mut Answers) {
        self.answer_some(without_last_end(chunk), usize::MAX, answers);
    }

    /// As [`Self::answer`] until the answers are longer than `most`; where lines are left then, where they begin. The last line
    /// has no newline.
    pub(super) fn answer_some(
        &mut self,
        lines: &[u8],
        most: usize,
        answers: &mut Answers,
    ) -> Option<usize> {
        answers.text.clear();
        answers.failures.clear();
        answers.worst = None;
        answers.lines = 0;
        // Most answers are some times as long as their line.
        answers.text.reserve((4 * lines.len()).min(most));
        let mut begin = 0;
        loop {
            let end = memchr::memchr(b'\n', &lines[begin..]).map(|length| begin + length);
            let line = &lines[begin..end.unwrap_or(lines.len())];
            answers.lines += 1;
            let start = answers.text.len();
            match self.push_answer(line, &mut answers.text) {
                Ok(peak) => {
                    if let Some(peak) = peak {
                        worsen(&mut answers.worst, answers.lines, peak);
                    }
                    answers.text.push(b'\n');
                }
                Err(error) => {
                    answers.text.truncate(start);
                    answers.failures.push((answers.lines, error));
                    match self.on_error {
                        OnError::Stop => return None,
                        OnError::Skip => {}
                        OnError::Blank => answers.text.push(b'\n'),
                        OnError::Report => push_report(answers, line),
                    }
                }
            }
            begin = end? + 1;
            if answers.text.len() > most {
                return Some(begin);
            }
        }
    }

    /// Appends the answer to one line, without the newline, and tells its peak error where that is stated or measured.
    fn push_answer(&mut self, line: &[u8], out: &mut Vec<u8>) -> Result<Option<f64>> {
        let Some(line) = text_of(line)? else {
            return Ok(None);
        };
        let spec = Spec::parse(line)?;
        if spec.method.is_none() && spec.cut.is_none() {
            if let (LineContent::Shape(Shape::Circle(circle)), Format::Path, false) =
                (&spec.subject, self.form.format, self.form.measures)
                && self.turns.push(out, circle, &self.options).is_some()
            {
                return Ok(None);
            }
            return push_spec(out, &spec, self.form, &self.options, &mut self.memo);
        }
        let options = approximate::Options {
            rule: spec.method.map_or(self.options.rule, Rule::Method),
            cut: spec.cut.clone().unwrap_or_else(|| self.options.cut.clone()),
            ..self.options
        };
        push_spec(out, &spec, self.form, &options, &mut self.memo)
    }
}

/// The text of a line; `None` where it is blank or a comment.
pub(super) fn text_of(line: &[u8]) -> Result<Option<&str>> {
    let line = line.trim_ascii();
    if line.is_empty() || line[0] == b'#' {
        return Ok(None);
    }
    let text = str::from_utf8(line).map_err(|error| Error::Syntax {
        what: "the shape",
        text: String::from_utf8_lossy(line).into_owned(),
        column: error.valid_up_to() + 1,
        why: "the line is not UTF-8".to_owned(),
    })?;
    Ok(Some(text))
}

/// Lines without the newline of the last.
pub(super) fn without_last_end(chunk: &[u8]) -> &[u8] {
    chunk.strip_suffix(b"\n").unwrap_or(chunk)
}

fn push_spec(
    out: &mut Vec<u8>,
    spec: &Spec,
    form: AnswerForm,
    options: &approximate::Options,
    memo: &mut Memo,
) -> Result<Option<f64>> {
    match &spec.subject {
        LineContent::Shape(shape) => push_shape(out, shape, spec.id, form, options, memo),
        LineContent::Path(contours) => {
            push_path(out, contours, spec.id, form.format, options).map(Some)
        }
    }
}

fn push_shape(
    out: &mut Vec<u8>,
    shape: &Shape,
    id: Option<&str>,
    form: AnswerForm,
    options: &approximate::Options,
    memo: &mut Memo,
) -> Result<Option<f64>> {
    let as_lancaster = (form.format == Format::Ps).then(|| as_drawellipse(*shape));
    let shape = as_lancaster.as_ref().unwrap_or(shape);
    if form.format == Format::Json || form.measures {
        let drawing = approximate(shape, options)?;
        match form.format {
            Format::Json => json::push_drawing(out, id, &drawing, memo)?,
            Format::Ps => push_operators(out, &drawing.curve),
            _ => path::push_curve(out, &drawing.curve, false),
        }
        return Ok(Some(drawing.error.peak()));
    }
    let sketch = sketch(shape, options)?;
    if form.format == Format::Ps {
        push_operators(out, &sketch.rounded());
    } else if sketch.kept.is_some() {
        path::push_curve(out, &sketch.rounded(), false);
    } else {
        path::push_rounded(out, &sketch.curve, sketch.precision);
    }
    Ok(None)
}

fn push_path(
    out: &mut Vec<u8>,
    contours: &[Contour],
    id: Option<&str>,
    format: Format,
    options: &approximate::Options,
) -> Result<f64> {
    let drawing = draw(contours, BezierTarget::Beziers, options)?;
    match format {
        Format::Json => push_json(out, id, &PathDocument::from(&drawing))?,
        Format::Ps => {
            for (i, curve) in drawing.curves().enumerate() {
                if i > 0 {
                    out.push(b' ');
                }
                push_operators(out, curve);
            }
        }
        _ => {
            for curve in drawing.curves() {
                path::push_curve(out, curve, false);
            }
        }
    }
    Ok(drawing.error().peak())
}

/// Appends PostScript in one line: it takes any white space between its words.
fn push_operators(out: &mut Vec<u8>, curve: &Curve) {
    let start = out.len();
    postscript::push_operators(out, curve);
    for byte in &mut out[start..] {
        if *byte == b'\n' {
            *byte = b' ';
        }
    }
    if out.len() > start {
        out.pop();
    }
}

/// The answer to a line that cannot be drawn.
#[derive(Serialize)]
struct LineFailure<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a RawValue>,
    line: u64,
    error: String,
}

/// What a bad line may still say of itself.
#[derive(Deserialize)]
struct Id<'a> {
    #[serde(borrow)]
    id: Option<&'a RawValue>,
}

/// Answers the last line, which failed.
fn push_report(answers: &mut Answers, line: &[u8]) {
    let Some((number, error)) = answers.failures.last() else {
        return;
    };
    let report = LineFailure {
        id: serde_json::from_slice(line).ok().and_then(|Id { id }| id),
        line: answers.before + number,
        error: error.to_string(),
    };
    // Texts and numbers can always be JSON.
    let _ = json::push_line(&mut answers.text, &report);
    answers.text.push(b'\n');
}

/// Closed shapes start and run as Lancaster's `drawellipse` does, as everywhere in PostScript.
fn as_drawellipse(mut shape: Shape) -> Shape {
    let half = Angle::from_degrees(180.0);
    match &mut shape {
        Shape::Circle(circle) => (circle.start, circle.reverse) = (half, true),
        Shape::Ellipse(ellipse) => (ellipse.start, ellipse.reverse) = (half, true),
        _ => {}
    }
    shape
}

fn push_json(out: &mut Vec<u8>, id: Option<&str>, document: &impl Serialize) -> Result<()> {
    let first_key = out.len() + 1;
    json::push_line(out, document)?;
    if let Some(id) = id {
        let key = format!("\"id\":{id},");
        out.splice(first_key..first_key, key.into_bytes());
    }
    Ok(())
}

#[cfg(test)]
mod tests;
