//! Conversions: well-formed, every byte elsewhere the same, done after one pass, within the tolerance, and what is left is named.

use curveto::document::{self, ElementKind, Note, Only, Options, Target};
use curveto::{Cut, Method, Rule, Tolerance};

use super::{Check, ensure, is_tame};
use crate::judges::independent;
use crate::judges::way_back::{apart, outlines, skeleton};

/// Converts bytes as the program would and checks all that was promised; `tolerance` is a part of the radius.
pub fn judge(bytes: &[u8], options: &Options, tolerance: Option<f64>) -> Check {
    let Ok(out) = document::convert_bytes(bytes, options) else {
        return Ok(());
    };
    let again = document::convert_bytes(&out.bytes, options)
        .map_err(|error| format!("the result is refused: {error}"))?;
    ensure(
        again.bytes == out.bytes && again.replaced.total() == 0,
        || "a second conversion changes it again".to_owned(),
    )?;
    ensure(out.replaced.total() > 0 || *out.bytes == *bytes, || {
        "nothing was replaced, but bytes changed".to_owned()
    })?;
    let Ok(before) = document::decode(bytes) else {
        return Ok(());
    };
    let after = document::decode(&out.bytes).map_err(|error| error.to_string())?;
    // What the judge cannot read itself it cannot judge; in path data it takes `3.` for a number, which is an error.
    let lax = |pair: &[u8]| pair[0] == b'.' && !pair[1].is_ascii_digit();
    if independent::remaining(before).is_err() || bytes.windows(2).any(lax) {
        return Ok(());
    }
    independent::remaining(after)?;
    if options.only == Only::ALL {
        are_noted(before, after, &out.notes)?;
    }
    tolerance.map_or(Ok(()), |tolerance| {
        independent::check(before, after, tolerance)
    })
}

/// Checks that there is a note for whatever was left.
fn are_noted(before: &str, after: &str, notes: &[Note]) -> Check {
    let place = |at: usize| {
        let text = &before[..at];
        let line = text.rfind('\n').map_or(0, |end| end + 1);
        let column = text[line..].chars().filter(|c| *c != '\u{feff}').count() + 1;
        (text.matches('\n').count() + 1, column)
    };
    for tag in independent::left(before, after)? {
        let (start, end) = (place(tag.start), place(tag.end));
        let is_noted = notes
            .iter()
            .any(|note| (start..end).contains(&(note.line, note.column)));
        ensure(is_noted, || {
            format!("{} is left without a note", &before[tag])
        })?;
    }
    Ok(())
}

/// A document, or path data alone, whose length picks how it is converted.
pub fn documents(input: &[u8]) -> Check {
    let cut = |cut| Options {
        cut,
        ..Options::default()
    };
    let (options, tolerance) = match input.len() % 6 {
        0 => (cut(Cut::Count(2)), None),
        1 => {
            // A closed shape may be cut anywhere, which the judge does not know.
            let mut options = cut(Cut::Tolerance(Tolerance::Relative(1e-5)));
            options.only = Only::of(&[ElementKind::Path]);
            (options, Some(1.01e-5))
        }
        2 => {
            let precision = Some((input.len() / 6 % 4) as u8);
            let options = Options {
                precision,
                ..Options::default()
            };
            (options, None)
        }
        3 => {
            let rule = Rule::Method(Method::QuadraticMinimax);
            let options = Options {
                rule,
                ..Options::default()
            };
            (options, None)
        }
        // The widest arc of one cubic; scaled-up radii and huge arcs cost digits.
        _ => (Options::default(), Some(3.2e-4)),
    };
    let is_tame = std::str::from_utf8(input).is_ok_and(is_tame);
    judge(input, &options, tolerance.filter(|_| is_tame))
}

/// A document on the way back: nothing grows, nothing else changes, and no outline moves farther than stated.
pub fn to_arcs(input: &[u8]) -> Check {
    let Ok(before) = document::decode(input) else {
        return Ok(());
    };
    let tolerance = [None, Some(Tolerance::Absolute(0.01))][input.len() / 2 % 2];
    let shapes = input.len().is_multiple_of(2);
    let options = Options {
        to: Target::Arcs { tolerance, shapes },
        ..Options::default()
    };
    let Ok(out) = document::convert(before, &options) else {
        return Ok(());
    };
    document::convert(&out.text, &options)
        .map_err(|error| format!("the result is refused: {error}"))?;
    ensure(out.text.len() <= before.len(), || "it grew".to_owned())?;
    ensure(out.replaced.total() > 0 || out.text == before, || {
        "nothing was replaced, but bytes changed".to_owned()
    })?;
    if out.replaced.total() == 0 || independent::remaining(before).is_err() {
        return Ok(());
    }
    ensure(skeleton(before)? == skeleton(&out.text)?, || {
        "bytes elsewhere changed".to_owned()
    })?;
    if !is_tame(before) {
        return Ok(());
    }
    for (a, b) in outlines(before, &out.text)? {
        // The points of the judge stand on chords of the curves; numbers have fewer than six digits.
        let off = apart(&a, &b)?;
        let size = independent::largest(&a).max(independent::largest(&b));
        ensure(off <= out.strayed + 2e-4 * size, || {
            format!("an outline moved by {off}, stated {}", out.strayed)
        })?;
    }
    Ok(())
}
