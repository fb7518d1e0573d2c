//! Words of the command line and lines of `batch`.

use curveto::batch::spec::{LineContent, Spec};
use curveto::batch::{OnError, Options, run};
use curveto::contour::{BezierTarget, draw};
use curveto::write::Format;
use curveto::{Method, Tolerance};

use super::geometry::is_drawn;
use super::{Check, ensure, is_tame, is_well_formed};

fn answers(input: &[u8], format: Format) -> Result<Vec<u8>, String> {
    let options = Options {
        format,
        on_error: OnError::Blank,
        ..Options::default()
    };
    let mut out = Vec::new();
    run(
        std::io::Cursor::new(input.to_vec()),
        &mut out,
        &options,
        |_, _| (),
    )
    .map_err(|error| error.to_string())?;
    Ok(out)
}

/// Lines of `batch`: one answer each, the same as alone, and well-formed.
pub fn lines(input: &[u8]) -> Check {
    // A line may ask for a million segments, which takes its time.
    if !is_tame(&String::from_utf8_lossy(input)) {
        return Ok(());
    }
    let format = [Format::Path, Format::Json, Format::Ps][input.len() % 3];
    let all = answers(input, format)?;
    let text = String::from_utf8(all).map_err(|error| error.to_string())?;
    let lines: Vec<&[u8]> = input
        .strip_suffix(b"\n")
        .unwrap_or(input)
        .split(|byte| *byte == b'\n')
        .collect();
    let count = if input.is_empty() { 0 } else { lines.len() };
    let answered = text.matches('\n').count();
    ensure(answered == count, || {
        format!("{answered} answers to {count} lines")
    })?;
    for (i, (line, answer)) in lines.iter().zip(text.lines()).enumerate() {
        if i > 0 && i < 8 && !line.is_empty() {
            let alone = answers(line, format)?;
            ensure(alone.strip_suffix(b"\n") == Some(answer.as_bytes()), || {
                format!("line {i} has another answer alone: {answer}")
            })?;
        }
        is_answer(answer, format)?;
    }
    Ok(())
}

fn is_answer(answer: &str, format: Format) -> Check {
    if answer.is_empty() {
        return Ok(());
    }
    match format {
        Format::Path => is_well_formed(answer),
        Format::Json => {
            let value: serde_json::Value =
                serde_json::from_str(answer).map_err(|error| format!("{answer}: {error}"))?;
            let peak = value["error"]["peak"].as_f64();
            ensure(peak.is_some_and(|peak| peak >= 0.0), || answer.to_owned())?;
            is_well_formed(value["path"].as_str().unwrap_or("no path"))
        }
        _ => ensure(!answer.contains("NaN") && !answer.contains("inf"), || {
            answer.to_owned()
        }),
    }
}

/// Whatever else reads words: nothing panics, and what is drawn can be read.
pub fn words(input: &[u8]) -> Check {
    let text = &*String::from_utf8_lossy(input);
    if let Ok(spec) = Spec::parse(text)
        && is_tame(text)
    {
        let options = curveto::Options {
            cut: spec.cut.unwrap_or_default(),
            ..curveto::Options::default()
        };
        match &spec.subject {
            LineContent::Shape(shape) => {
                if let Ok(drawing) = curveto::approximate(shape, &options) {
                    is_drawn(&[&drawing.curve])?;
                }
            }
            LineContent::Path(contours) => {
                if let Ok(drawing) = draw(contours, BezierTarget::Quadratics, &options) {
                    is_drawn(&drawing.curves().collect::<Vec<_>>())?;
                }
            }
        }
    }
    let _ = curveto::document::svg_shapes(text);
    let _ = curveto::path::postscript(text);
    let _ = text.parse::<curveto::Angle>();
    let _ = text.parse::<Tolerance>();
    let _ = text.parse::<Method>();
    let _ = text.parse::<curveto::picture::paint::Paint>();
    let _ = text.parse::<curveto::picture::size::Size>();
    Ok(())
}
