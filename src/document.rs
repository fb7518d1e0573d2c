//! SVG documents: arcs and shapes become Béziers, or Béziers become arcs and shapes; every other byte stays.

mod doubt;
mod failure;
mod note;
mod output;
mod path;
mod paths;
mod reason;
mod rewrite;
mod shape;
mod splice;
mod style;
mod xml;

use std::borrow::Cow;

use serde::Serialize;

use crate::joints::{Cut, Tolerance};
use crate::method::Rule;

pub use doubt::{Doubt, Trust};
pub use failure::Error;
pub use note::Note;
pub use paths::{SvgDrawing, SvgPath, Unread, svg_paths, svg_shapes};
pub use reason::Reason;
pub use style::property::ElementKind;

use rewrite::{Pass, Rewritten};
use style::of_document::Facts;
use xml::encoding::SourceText;
use xml::fault::{FaultKind, XmlFault};

/// The kinds of elements to replace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Only([bool; 4]);

impl Only {
    /// Every kind.
    pub const ALL: Self = Self([true; 4]);

    /// The kinds given.
    #[must_use]
    pub fn of(kinds: &[ElementKind]) -> Self {
        Self(ElementKind::ALL.map(|kind| kinds.contains(&kind)))
    }

    /// Whether this kind is to be replaced.
    #[must_use]
    pub const fn contains(&self, kind: ElementKind) -> bool {
        self.0[kind as usize]
    }
}

impl Default for Only {
    fn default() -> Self {
        Self::ALL
    }
}

/// What becomes of a document.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Target {
    /// Arcs become Béziers.
    #[default]
    Beziers,
    /// Béziers that are arcs become arcs.
    Arcs {
        /// How far an arc may lie from its Béziers; a part is one of its larger radius. Without it, a thousandth of that and what
        /// rounding to the decimals of the path data moves a point.
        tolerance: Option<Tolerance>,
        /// Whether paths that are a whole circle, ellipse or round rectangle become one.
        shapes: bool,
    },
}

impl Target {
    /// Whether path data have a command that it is about.
    fn concerns(self, data: &str) -> bool {
        match self {
            Self::Beziers => memchr::memchr2(b'a', b'A', data.as_bytes()).is_some(),
            Self::Arcs { .. } => data
                .bytes()
                .any(|byte| path::run_text::family(byte | 0x20) != 0),
        }
    }
}

/// What to replace, and how closely.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// What it becomes. For arcs, the rule, the cut and the precision have no say, and only shapes of a kind in `only` are made.
    pub to: Target,
    /// What gives the control points.
    pub rule: Rule,
    /// Where each arc is cut; tolerances are in the user units of the element.
    pub cut: Cut,
    /// How many decimals generated numbers have; `None` for the fewest that add no more than a tenth of the curve's error.
    pub precision: Option<u8>,
    /// What to replace.
    pub only: Only,
    /// The doubts that are set aside.
    pub trust: Trust,
    /// Whether the error of the Béziers is measured, for [`Converted::strayed`]: it takes several times as long as drawing them.
    pub measure: bool,
}

impl Options {
    /// Refuses what no document could meet, before any is read.
    ///
    /// # Errors
    ///
    /// Where a tolerance is not positive, or a literal handle is no number or beyond 1e9. What the method cannot do is left with a note: whether a document has such shapes, only it tells.
    pub fn check(&self) -> crate::Result<()> {
        self.rule.check()?;
        if let Target::Arcs { tolerance, .. } = self.to
            && let Some(tolerance) = tolerance
        {
            tolerance.checked(1.0)?;
        }
        Ok(())
    }
}

/// How many elements and arcs were replaced.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// `<circle>` elements.
    pub circle: usize,
    /// `<ellipse>` elements.
    pub ellipse: usize,
    /// Rounded `<rect>` elements.
    pub rect: usize,
    /// Arc commands in path data.
    pub path: usize,
    /// Smooth commands after an arc that had to be spelled out as `C`.
    pub smooth: usize,
}

impl Counts {
    fn count(&mut self, kind: ElementKind, count: usize) {
        *match kind {
            ElementKind::Circle => &mut self.circle,
            ElementKind::Ellipse => &mut self.ellipse,
            ElementKind::Rect => &mut self.rect,
            ElementKind::Path => &mut self.path,
        } += count;
    }

    /// The replacements of one kind; arc commands for paths.
    #[must_use]
    pub const fn of(&self, kind: ElementKind) -> usize {
        match kind {
            ElementKind::Circle => self.circle,
            ElementKind::Ellipse => self.ellipse,
            ElementKind::Rect => self.rect,
            ElementKind::Path => self.path,
        }
    }

    /// All replacements.
    #[must_use]
    pub const fn total(&self) -> usize {
        self.circle + self.ellipse + self.rect + self.path
    }
}

impl core::ops::Add for Counts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            circle: self.circle + other.circle,
            ellipse: self.ellipse + other.ellipse,
            rect: self.rect + other.rect,
            path: self.path + other.path,
            smooth: self.smooth + other.smooth,
        }
    }
}

/// A converted document.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Converted<'a> {
    /// The new text; where nothing was replaced the old one, byte for byte and borrowed.
    #[serde(skip)]
    pub text: Cow<'a, str>,
    /// What was replaced.
    pub replaced: Counts,
    /// What was left, and why.
    pub notes: Vec<Note>,
    /// A bound of how far, in the user units of each element, what was made lies from what stood there: of new arcs and shapes both ways
    /// from the Béziers before them, of Béziers as printed from the true arcs, where [`Options::measure`] asks for it, else 0.
    pub strayed: f64,
}

/// That of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The most bytes of a result.
const MOST_BYTES: usize = 1 << 30;

/// A converted file.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvertedFile<'a> {
    /// The new bytes in the encoding of the old ones; where nothing was replaced the old ones, borrowed.
    pub bytes: Cow<'a, [u8]>,
    /// What was replaced.
    pub replaced: Counts,
    /// What was left, and why.
    pub notes: Vec<Note>,
    /// A bound of how far, in the user units of each element, what was made lies from what stood there: of new arcs and shapes both ways
    /// from the Béziers before them, of Béziers as printed from the true arcs, where [`Options::measure`] asks for it, else 0.
    pub strayed: f64,
}

/// Replaces circles, ellipses, rounded rectangles and path arcs of an SVG document, and path arcs of an Android `VectorDrawable`, by
/// Béziers; or, on the way back, Béziers by arcs and shapes.
///
/// # Errors
///
/// A document that is not well-formed XML, that declares an encoding other than UTF-8, or that would become larger than a gibibyte.
pub fn convert<'a>(text: &'a str, options: &Options) -> Result<Converted<'a>, Error> {
    let done = pass(text.into(), options)?;
    Ok(Converted {
        text: done.text.map_or(Cow::Borrowed(text), Cow::Owned),
        replaced: done.counts,
        notes: done.notes,
        strayed: done.strayed,
    })
}

/// [`convert`] for the bytes of a file, which may also be in an encoding that holds ASCII as it is, such as ISO 8859-1: every byte
/// outside of what is replaced stays.
///
/// # Errors
///
/// Those of [`convert`] and [`decode`].
pub fn convert_bytes<'a>(bytes: &'a [u8], options: &Options) -> Result<ConvertedFile<'a>, Error> {
    let (mut done, is_widened) = read_bytes(bytes, |source| pass(source, options))?;
    let new = done.text.take().map(|text| {
        if is_widened {
            xml::encoding::narrow(&text)
        } else {
            text.into_bytes().into()
        }
    });
    Ok(ConvertedFile {
        bytes: new.unwrap_or(Cow::Borrowed(bytes)),
        replaced: done.counts,
        notes: done.notes,
        strayed: done.strayed,
    })
}

/// Reads the bytes of a file as UTF-8 or, byte for byte, in an encoding that holds ASCII as it is; and tells whether they stand so for theirs.
fn read_bytes<T>(
    bytes: &[u8],
    mut read: impl FnMut(SourceText<'_>) -> Result<T, Error>,
) -> Result<(T, bool), Error> {
    match decode(bytes).and_then(|text| read(text.into())) {
        Err(Error::Encoding {
            line,
            column,
            encoding,
        }) if bytes.starts_with(BYTE_ORDER_MARK) => {
            let why = format!(
                "the byte order mark says UTF-8, and the declaration {encoding}: correct it"
            );
            Err(Error::Malformed { line, column, why })
        }
        Err(Error::Encoding { encoding, .. }) if xml::encoding::keeps_ascii(&encoding) => {
            let text = xml::encoding::widen(bytes);
            let source = SourceText {
                text: &text,
                is_widened: true,
            };
            Ok((read(source)?, true))
        }
        outcome => Ok((outcome?, false)),
    }
}

/// The new text, if anything was replaced, with what was and what was not.
fn pass(source: SourceText<'_>, options: &Options) -> Result<Rewritten, Error> {
    let pass = path::scratch::with_scratch(options, |scratch| {
        match rewrite::run(source, options, None, scratch, MOST_BYTES)? {
            Pass::NeedsFacts => {
                let facts = Facts::read(source)?;
                rewrite::run(source, options, Some(&facts), scratch, MOST_BYTES)
            }
            done @ Pass::Done(..) => Ok(done),
        }
    });
    match pass.map_err(|fault| Error::new(source.text, fault))? {
        Pass::Done(done) => Ok(done),
        Pass::NeedsFacts => Ok(Rewritten::default()),
    }
}

/// The text of a file: UTF-8, with or without a byte order mark.
///
/// # Errors
///
/// [`Error::Encoding`] for UTF-16 and UTF-32 and for a declared legacy encoding, [`Error::Malformed`] for bytes that are not UTF-8.
pub fn decode(bytes: &[u8]) -> Result<&str, Error> {
    let wide = match bytes {
        [0, 0, 0xfe, 0xff, ..]
        | [0xff, 0xfe, 0, 0, ..]
        | [0, 0, 0, b'<', ..]
        | [b'<', 0, 0, 0, ..] => Some("UTF-32"),
        [0xfe, 0xff, ..] | [0xff, 0xfe, ..] | [0, b'<', ..] | [b'<', 0, ..] => Some("UTF-16"),
        _ => None,
    };
    if let Some(encoding) = wide {
        return Err(Error::Encoding {
            line: 1,
            column: 1,
            encoding: encoding.to_owned(),
        });
    }
    core::str::from_utf8(bytes).map_err(|error| {
        let (good, _) = bytes.split_at(error.valid_up_to());
        let good = String::from_utf8_lossy(good);
        // What the declaration says, if it got so far.
        let declared = good.find("?>").and_then(|end| {
            let mut scanner = xml::scan::Scanner::new(good[..end + 2].into()).ok()?;
            scanner.next().err()
        });
        match declared {
            Some(
                fault @ XmlFault {
                    kind: FaultKind::Encoding(_),
                    ..
                },
            ) => Error::new(&good, fault),
            _ => Error::new(&good, XmlFault::new(good.len(), "a byte that is not UTF-8")),
        }
    })
}
