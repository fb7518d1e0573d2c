//! Where input comes from: a word on the command line, a file, or standard input.

mod kind;

pub(crate) use kind::InputKind;

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use anyhow::Context;
use curveto::contour::Contour;
use curveto::document::{self, SvgPath, Unread};
use curveto::error::{ShapeError, TextError};
use flate2::bufread::GzDecoder;
use kurbo::Affine;

use super::args::QuietArgs;
use super::failure::Failure;

/// The most that a command reads at once.
const MOST_BYTES: u64 = 1 << 28;

/// What a word on the command line names: a file, or standard input by `-`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Source<'a> {
    Stdin,
    File(&'a Path),
}

impl<'a> Source<'a> {
    pub(crate) fn of(word: &'a (impl AsRef<Path> + ?Sized)) -> Self {
        match word.as_ref() {
            path if path.as_os_str() == "-" => Self::Stdin,
            path => Self::File(path),
        }
    }

    pub(crate) fn is_stdin(self) -> bool {
        self == Self::Stdin
    }

    /// What messages call it, before the line of a fault too.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Stdin => "<stdin>".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    pub(crate) fn open(self) -> anyhow::Result<Box<dyn Read + Send>> {
        Ok(match self {
            Self::Stdin => Box::new(io::stdin()),
            Self::File(path) => {
                let file = File::open(path);
                Box::new(file.with_context(|| format!("cannot read {}", self.name()))?)
            }
        })
    }
}

/// The text of an input, and what messages call it. A byte order mark is left out.
///
/// # Errors
///
/// Where it cannot be read, is no UTF-8, or is larger than 256 MiB.
pub(crate) fn text(source: Source<'_>) -> Result<(String, String), Failure> {
    let name = source.name();
    Ok((in_utf8(bytes(source.open()?, &name)?, &name)?, name))
}

/// The bytes of an input that may be packed by gzip, and what messages call it.
///
/// # Errors
///
/// Where it cannot be read, or is larger than 256 MiB.
pub(crate) fn document(source: Source<'_>) -> Result<(Vec<u8>, String), Failure> {
    let name = source.name();
    let bytes = bytes(source.open()?, &name)?;
    let bytes = if is_packed(&bytes) {
        unpacked(&bytes, &name)?
    } else {
        bytes
    };
    Ok((bytes, name))
}

/// What gzip files begin with.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// Whether bytes are packed by gzip.
pub(crate) fn is_packed(bytes: &[u8]) -> bool {
    bytes.starts_with(&GZIP)
}

/// What was packed into bytes that messages call so.
///
/// # Errors
///
/// Where they are damaged, or all is larger than 256 MiB.
pub(crate) fn unpacked(mut packed: &[u8], name: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // Zeros after the last member fill up a block, as on a tape.
    while packed.iter().any(|byte| *byte != 0) {
        anyhow::ensure!(
            is_packed(packed),
            "cannot read {name}: other bytes follow the packed ones"
        );
        more_bytes(&mut bytes, GzDecoder::new(&mut packed), name)?;
    }
    Ok(bytes)
}

/// What messages call path data on the command line.
const THE_PATH: &str = "the path";

/// An error in an input that messages call so: those of a file or of standard input say which.
pub(crate) fn named(name: &str, error: curveto::Error) -> Failure {
    match error.into() {
        Failure::Request { message, hint } if name != THE_PATH => Failure::Request {
            message: format!("{name}: {message}"),
            hint,
        },
        failure => failure,
    }
}

/// The contours of path data that messages call so, which `words` name; `of_svg` says what reads SVG in its place.
pub(crate) fn contours(
    words: &OsStr,
    bytes: Vec<u8>,
    name: &str,
    of_svg: Option<&'static str>,
) -> Result<Vec<Contour>, Failure> {
    let hint = InputKind::of(words, &bytes).remedy(of_svg, None);
    curveto::path::contours(&in_utf8(bytes, name)?).map_err(|error| {
        let failure = named(name, error);
        match hint {
            Some(hint) => failure.with_hint(hint),
            None => failure,
        }
    })
}

/// A drawing as bytes: what stands in `words` itself where that begins with a moveto, else in the file of that name or on standard input.
pub(crate) fn drawing(words: &OsStr) -> Result<(Vec<u8>, String), Failure> {
    let text = words.to_string_lossy();
    let trimmed = text.trim_start();
    let after = trimmed.strip_prefix(['M', 'm']);
    let is_data = after.is_some_and(|rest| {
        !rest.starts_with(|c: char| c.is_alphabetic() || c == '_' || c == '/')
            && !Path::new(words).is_file()
    });
    if is_data || trimmed.is_empty() {
        return Ok((typed(words, THE_PATH)?.into_bytes(), THE_PATH.to_owned()));
    }
    document(existing(
        words,
        "path data",
        "path data begins with a moveto, such as M0 0; - reads standard input",
    )?)
}

/// A path or a basic shape of an SVG file.
pub(crate) struct SvgShape {
    /// What messages call it.
    pub(crate) place: String,
    pub(crate) contours: Vec<Contour>,
    pub(crate) map: Affine,
}

/// The paths and basic shapes of an SVG file that messages call so; notes say what of it is not read or not drawn.
pub(crate) fn shapes(svg: &[u8], name: &str, notes: QuietArgs) -> Result<Vec<SvgShape>, Failure> {
    let drawing = document::svg_shapes(svg);
    let drawing = drawing.map_err(|error| Failure::request(format!("{name}:{error}")))?;
    for unread in &drawing.unread {
        if let Unread::Entity(why) = unread {
            return Err(Failure::request(format!(
                "{name}: {why}: what it draws is not known"
            )));
        }
        notes.note(&format!("{name}: {unread}"));
    }
    let mut shapes = Vec::new();
    for shape in drawing.paths {
        let place = place(name, &shape);
        match shape.contours {
            Ok((contours, map)) => shapes.push(SvgShape {
                place,
                contours,
                map,
            }),
            Err(error) if is_left_out(&error) => {
                notes.note(&format!("{place}: left out: {error}"));
            }
            Err(error) => return Err(Failure::request(format!("{place}: {error}"))),
        }
    }
    Ok(shapes)
}

/// What messages call an element of a file that they call so.
pub(crate) fn place(name: &str, path: &SvgPath) -> String {
    let id = path.id.as_ref().map(|id| format!("#{id}"));
    format!("{name}:{}{}", path.line, id.unwrap_or_default())
}

/// Whether a shape is left out for this: SVG does not render it, or where it lies or how large it is depends on what is not known here.
fn is_left_out(error: &curveto::Error) -> bool {
    matches!(
        error,
        curveto::Error::Shape(ShapeError::Flattened)
            | curveto::Error::Text(
                TextError::NoViewport | TextError::Property { .. } | TextError::NoProperty(_)
            )
    )
}

/// What a word on the command line holds itself, which messages call so.
fn typed(word: &OsStr, name: &str) -> Result<String, Failure> {
    in_utf8(word.as_encoded_bytes().to_owned(), name).map_err(Failure::requested)
}

/// Coefficients as JSON: what stands in `words` itself where that begins like JSON, else in the file of that name or on standard
/// input.
pub(crate) fn coefficients(words: &OsStr) -> Result<String, Failure> {
    if words.to_string_lossy().trim_start().starts_with(['{', '[']) && !Path::new(words).is_file() {
        return typed(words, "the JSON");
    }
    let source = existing(
        words,
        "JSON",
        r#"coefficients are {"x": [A,B,C,D], "y": [E,F,G,H]}, or what -f json prints; - reads standard input"#,
    )?;
    Ok(text(source)?.0)
}

/// The input that words name which are none of this kind themselves.
fn existing<'a>(words: &'a OsStr, kind: &str, hint: &str) -> Result<Source<'a>, Failure> {
    let source = Source::of(words);
    if source.is_stdin() || Path::new(words).exists() {
        return Ok(source);
    }
    let words = curveto::path::shortened(&words.to_string_lossy());
    let message = format!("'{words}' is neither {kind} nor a file");
    Err(Failure::request_with_hint(message, hint))
}

/// All bytes of an input that messages call so.
///
/// # Errors
///
/// Where it cannot be read, or is larger than 256 MiB.
pub(crate) fn bytes(input: impl Read, name: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    more_bytes(&mut bytes, input, name)?;
    Ok(bytes)
}

/// Appends all bytes of an input.
///
/// # Errors
///
/// Where it cannot be read, or all is larger than 256 MiB.
pub(crate) fn more_bytes(bytes: &mut Vec<u8>, input: impl Read, name: &str) -> anyhow::Result<()> {
    bytes_up_to(MOST_BYTES, bytes, input, name)
}

fn bytes_up_to(most: u64, bytes: &mut Vec<u8>, input: impl Read, name: &str) -> anyhow::Result<()> {
    let room = (most + 1).saturating_sub(bytes.len() as u64);
    input
        .take(room)
        .read_to_end(bytes)
        .with_context(|| format!("cannot read {name}"))?;
    anyhow::ensure!(
        bytes.len() as u64 <= most,
        "{name} is larger than {} MiB",
        most >> 20
    );
    Ok(())
}

/// The text of bytes, without a byte order mark.
///
/// # Errors
///
/// Where they are no UTF-8; what has another encoding by its first bytes, as UTF-16, is called so, as in SVG.
pub(crate) fn in_utf8(bytes: Vec<u8>, name: &str) -> Result<String, Failure> {
    if let Err(error @ document::Error::Encoding { .. }) = document::decode(&bytes) {
        return Err(anyhow::anyhow!("{name}:{error}").into());
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to() + 1;
        anyhow::anyhow!("cannot read {name}: it is no text in UTF-8, from byte {byte} on")
    })?;
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_is_read_to_its_last_byte_or_refused() {
        let read = |size: usize| {
            // In two pieces.
            let (mut bytes, all) = (Vec::new(), vec![7; size]);
            let (first, second) = all.split_at(size / 2);
            bytes_up_to(1 << 20, &mut bytes, first, "it")?;
            bytes_up_to(1 << 20, &mut bytes, second, "it")?;
            anyhow::Ok(bytes)
        };
        for size in [0, 1, (1 << 20) - 1, 1 << 20] {
            assert_eq!(read(size).unwrap(), vec![7; size]);
        }
        for size in [(1 << 20) + 1, (1 << 20) + 2, 1 << 21] {
            assert_eq!(
                read(size).unwrap_err().to_string(),
                "it is larger than 1 MiB"
            );
        }
    }
}
