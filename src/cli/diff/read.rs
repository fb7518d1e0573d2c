//! A drawing in any of the forms that can be compared.

use std::ffi::OsStr;

use curveto::contour::Contour;
use curveto::diff::Track;
use curveto::error::json;
use curveto::path;
use kurbo::Affine;
use serde_json::{Deserializer, Value};

use super::super::args::QuietArgs;
use super::super::failure::Failure;
use super::super::input::{self, InputKind};

/// The subpaths of a drawing: of path data, or of a file with it, with SVG, JSON or PostScript.
pub(super) fn drawing(words: &OsStr, notes: QuietArgs) -> Result<Vec<Track>, Failure> {
    let (bytes, name) = input::drawing(words)?;
    let kind = InputKind::of(words, &bytes);
    let mut found = Vec::new();
    if kind == InputKind::Svg {
        for shape in input::shapes(&bytes, &name, notes)? {
            found.extend(tracks(&shape.place, &shape.contours, shape.map)?);
        }
        return some(found, &name);
    }
    let text = input::in_utf8(bytes, &name)?;
    let as_it_is = |contours: &[Contour]| tracks(&name, contours, Affine::IDENTITY);
    let found = match kind {
        InputKind::Json => of_json(&text, &name)?,
        InputKind::PostScript => {
            as_it_is(&path::postscript(&text).map_err(|error| at(&name, &error))?)?
        }
        _ => as_it_is(&path::contours(&text).map_err(|error| {
            Failure::request_with_hint(
                format!("{name}: {error}"),
                "a drawing is SVG path data, SVG, our JSON or PostScript path operators",
            )
        })?)?,
    };
    some(found, &name)
}

/// Refuses a drawing of nothing.
fn some(tracks: Vec<Track>, name: &str) -> Result<Vec<Track>, Failure> {
    if tracks.is_empty() {
        return Err(Failure::request(format!(
            "{name} draws nothing that could be compared"
        )));
    }
    Ok(tracks)
}

fn at(place: &str, error: &curveto::Error) -> Failure {
    Failure::request(format!("{place}: {error}"))
}

/// The tracks of contours that messages call so.
fn tracks(place: &str, contours: &[Contour], map: Affine) -> Result<Vec<Track>, Failure> {
    let tracks = contours.iter().map(|contour| Track::new(contour, map));
    let tracks = tracks.collect::<curveto::Result<_>>();
    tracks.map_err(|error| input::named(place, error))
}

/// The path data of our documents: one, an array of them, or one a line.
fn of_json(text: &str, name: &str) -> Result<Vec<Track>, Failure> {
    let mut found = Vec::new();
    for value in Deserializer::from_str(text).into_iter::<Value>() {
        let value = value.map_err(|error| no_json(text, name, &error))?;
        let documents = match value {
            Value::Array(documents) => documents,
            one => vec![one],
        };
        for document in &documents {
            let Some(data) = document.get("path").and_then(Value::as_str) else {
                return Err(Failure::request_with_hint(
                    format!("{name}: a document has no path data under the key path"),
                    "JSON of curveto's drawings, paths and batches can be compared",
                ));
            };
            let contours = path::contours(data).map_err(|error| at(name, &error))?;
            found.extend(tracks(name, &contours, Affine::IDENTITY)?);
        }
    }
    Ok(found)
}

fn no_json(text: &str, name: &str, error: &serde_json::Error) -> Failure {
    let (line, column) = (error.line(), json::column(text, error));
    let why = json::in_plain_words(error);
    Failure::request(format!("{name}:{line}:{column}: {why}"))
}
