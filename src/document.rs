//! SVG documents: arcs become Béziers, every other byte stays.

mod arcs;
mod attributes;
mod bezier;
mod characters;
mod collapse;
mod css;
mod curve_text;
mod decimal;
mod decimals;
mod doctype;
mod element;
mod end;
mod facts;
mod fault;
mod length;
mod memo;
mod namespace;
mod note;
mod number;
mod output;
mod own;
mod path_data;
mod paths;
mod pen;
mod place;
mod position;
mod property;
mod reason;
mod rewrite;
mod rules;
mod scan;
mod scratch;
mod segments;
mod selector;
mod splice;
mod value;

use std::borrow::Cow;

use serde::Serialize;
use thiserror::Error;

use crate::joints::Cut;
use crate::method::{Ends, Rule, Span};

pub use note::Note;
pub use paths::{SvgPath, svg_paths};
pub use property::Kind;
pub use reason::Reason;

use facts::Facts;
use fault::{Fault, FaultKind};
use place::Places;
use rewrite::Pass;

/// The kinds of elements to replace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Only([bool; 4]);

impl Only {
    /// Every kind.
    pub const ALL: Self = Self([true; 4]);

    /// The kinds given.
    #[must_use]
    pub fn of(kinds: &[Kind]) -> Self {
        Self(Kind::ALL.map(|kind| kinds.contains(&kind)))
    }

    /// Whether this kind is to be replaced.
    #[must_use]
    pub const fn contains(&self, kind: Kind) -> bool {
        self.0[kind as usize]
    }
}

impl Default for Only {
    fn default() -> Self {
        Self::ALL
    }
}

/// What to replace, and how closely.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// What gives the control points.
    pub rule: Rule,
    /// Where each arc is cut; tolerances are in the user units of the element.
    pub cut: Cut,
    /// How many decimals generated numbers have; `None` for the fewest that add no more than a tenth of the curve's error.
    pub precision: Option<u8>,
    /// What to replace.
    pub only: Only,
}

impl Options {
    /// Refuses what no document could meet, before any is read.
    ///
    /// # Errors
    ///
    /// Where arcs are to be replaced by a method that serves closed shapes only.
    pub fn check(&self) -> crate::Result<()> {
        let open = self.only.contains(Kind::Path) || self.only.contains(Kind::Rect);
        if open
            && self
                .rule
                .method()
                .is_some_and(|method| method.card().ends == Ends::OffCircle)
        {
            let quarter = Span::from_degrees(90.0);
            self.rule.pieces(&[quarter], false)?;
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
    /// Smooth commands behind an arc that had to be spelled out as `C`.
    pub smooth: usize,
}

impl Counts {
    fn count(&mut self, kind: Kind, count: usize) {
        *match kind {
            Kind::Circle => &mut self.circle,
            Kind::Ellipse => &mut self.ellipse,
            Kind::Rect => &mut self.rect,
            Kind::Path => &mut self.path,
        } += count;
    }

    /// The replacements of one kind; arc commands for paths.
    #[must_use]
    pub const fn of(&self, kind: Kind) -> usize {
        match kind {
            Kind::Circle => self.circle,
            Kind::Ellipse => self.ellipse,
            Kind::Rect => self.rect,
            Kind::Path => self.path,
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
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Converted<'a> {
    /// The new text; where nothing was replaced the old one, byte for byte and borrowed.
    #[serde(skip)]
    pub text: Cow<'a, str>,
    /// What was replaced.
    pub replaced: Counts,
    /// What was left, and why.
    pub notes: Vec<Note>,
}

/// Why a document cannot be converted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// The document is not well-formed XML.
    #[error("{line}:{column}: not well-formed XML: {why}")]
    Malformed {
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// What is wrong.
        why: String,
    },
    /// The document declares or uses an encoding other than UTF-8.
    #[error(
        "{line}:{column}: the encoding is {encoding}: only UTF-8 is read, convert the file to it first"
    )]
    Encoding {
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// The encoding as declared or found.
        encoding: String,
    },
}

impl Error {
    fn new(source: &str, fault: Fault) -> Self {
        let (line, column) = Places::new(source).locate(fault.at);
        match fault.kind {
            FaultKind::Malformed(why) => Self::Malformed { line, column, why },
            FaultKind::Encoding(encoding) => Self::Encoding {
                line,
                column,
                encoding,
            },
        }
    }
}

/// Replaces circles, ellipses, rounded rectangles and path arcs of an SVG document by cubic Béziers.
///
/// # Errors
///
/// A document that is not well-formed XML, or that declares an encoding other than UTF-8.
pub fn convert<'a>(text: &'a str, options: &Options) -> Result<Converted<'a>, Error> {
    let fail = |fault| Error::new(text, fault);
    let pass = scratch::with_scratch(options, |scratch| {
        match rewrite::run(text, options, None, scratch)? {
            Pass::NeedsFacts => rewrite::run(text, options, Some(&Facts::read(text)?), scratch),
            done @ Pass::Done(..) => Ok(done),
        }
    });
    let pass = pass.map_err(fail)?;
    let (new, replaced, notes) = match pass {
        Pass::Done(new, replaced, notes) => (new, replaced, notes),
        Pass::NeedsFacts => (None, Counts::default(), Vec::new()),
    };
    Ok(Converted {
        text: new.map_or(Cow::Borrowed(text), Cow::Owned),
        replaced,
        notes,
    })
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
            let mut scanner = scan::Scanner::new(&good[..end + 2]).ok()?;
            scanner.next().err()
        });
        match declared {
            Some(
                fault @ Fault {
                    kind: FaultKind::Encoding(_),
                    ..
                },
            ) => Error::new(&good, fault),
            _ => Error::new(&good, Fault::new(good.len(), "a byte that is not UTF-8")),
        }
    })
}
