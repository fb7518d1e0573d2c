//! The pass that replaces: from the first byte to the last, with the facts of the document at hand.

use core::ops::Range;

use super::arcs;
use super::attributes::Attribute;
use super::element::{self, Shape};
use super::facts::{self, Facts};
use super::fault::Result;
use super::namespace::Namespace;
use super::output::{Output, Sink};
use super::own;
use super::place::Places;
use super::property::{Kind, Markers, Properties};
use super::reason::Reason;
use super::scan::{Element, Node, Scanner};
use super::scratch::Scratch;
use super::splice::Splice;
use super::value;
use super::{Counts, Note, Options};

/// What a pass came to.
pub(super) enum Pass {
    /// The new text, if anything was replaced.
    Done(Option<String>, Counts, Vec<Note>),
    /// The document has style sheets, scripts or animations: read them first.
    NeedsFacts,
}

/// What an open element passes on to its end tag and its children.
#[derive(Debug, Clone, Copy)]
struct Open {
    renamed: bool,
    markers: Markers,
}

/// Where the path data of a shape are.
enum ShapeData {
    /// In the buffer for curves.
    Drawn,
    /// Among those that were worked out before.
    Kept(usize),
    /// Nowhere: the rectangle has square corners.
    Square,
}

struct Rewriter<'a, 'f> {
    options: &'f Options,
    facts: Option<&'f Facts>,
    output: Output<'a>,
    counts: Counts,
    scratch: &'f mut Scratch,
    /// How a shape is spelled.
    key: Vec<u8>,
}

/// Rewrites a document.
pub(super) fn run(
    source: &str,
    options: &Options,
    facts: Option<&Facts>,
    scratch: &mut Scratch,
) -> Result<Pass> {
    let mut scanner = Scanner::new(source)?;
    let mut rewriter = Rewriter {
        options,
        facts,
        output: Output {
            splice: Splice::new(source),
            places: Places::new(source),
            notes: Vec::new(),
        },
        counts: Counts::default(),
        scratch,
        key: Vec::new(),
    };
    let mut open: Vec<Open> = Vec::new();
    loop {
        match scanner.next()? {
            Node::Start(element) => {
                if facts.is_none() && facts::is_sign(&element, &scanner.attributes) {
                    return Ok(Pass::NeedsFacts);
                }
                let inherited = open
                    .last()
                    .map_or_else(Markers::default, |open| open.markers);
                let markers = rewriter.markers(inherited, &element, &scanner);
                if facts.is_none() && markers.any && facts::is_use(&element) {
                    return Ok(Pass::NeedsFacts);
                }
                let renamed = rewriter.element(&element, &scanner, markers);
                if !element.empty {
                    open.push(Open { renamed, markers });
                }
            }
            Node::End { local } => rewriter.end(open.pop(), local),
            Node::Instruction(text) if facts.is_none() && text.starts_with("xml-stylesheet") => {
                return Ok(Pass::NeedsFacts);
            }
            Node::Reference(super::doctype::Resolved::Text(_, false)) => {}
            Node::Reference(_) if facts.is_none() => return Ok(Pass::NeedsFacts),
            Node::Done => break,
            _ => {}
        }
    }
    Ok(Pass::Done(
        rewriter.output.splice.finish(),
        rewriter.counts,
        rewriter.output.notes,
    ))
}

impl<'a> Rewriter<'a, '_> {
    fn markers(&self, inherited: Markers, element: &Element<'_>, scanner: &Scanner<'_>) -> Markers {
        self.facts.map_or_else(
            || own::markers(inherited, &scanner.attributes, &scanner.doctype),
            |facts| facts.markers(inherited, element, scanner),
        )
    }

    /// The end tag of an element that became a path gets the new name.
    fn end(&mut self, open: Option<Open>, local: Range<usize>) {
        if open.is_some_and(|open| open.renamed) {
            self.output.splice.replace(local, b"path");
        }
    }

    /// Replaces an element or notes why not; whether its end tag has a new name.
    fn element(&mut self, element: &Element<'_>, scanner: &Scanner<'a>, markers: Markers) -> bool {
        if element.namespace != Namespace::Svg {
            return false;
        }
        match Kind::named(element.local) {
            Some(kind) if !self.options.only.contains(kind) => false,
            Some(Kind::Path) => {
                self.path(element, scanner, markers);
                false
            }
            Some(kind) => self.shape(kind, element, scanner, markers),
            None => {
                self.elsewhere(element, scanner);
                false
            }
        }
    }

    /// Path data that are not a path's `d`.
    fn elsewhere(&mut self, element: &Element<'_>, scanner: &Scanner<'_>) {
        let known = [
            ("glyph", "d"),
            ("missing-glyph", "d"),
            ("hatchpath", "d"),
            ("hatchPath", "d"),
            ("animateMotion", "path"),
            ("textPath", "path"),
        ];
        let Some((holder, name)) = known.into_iter().find(|known| known.0 == element.local) else {
            return;
        };
        let has_arcs = |attribute: &&Attribute<'_>| {
            attribute.name == name && attribute.value.contains(['a', 'A'])
        };
        if self.options.only.contains(Kind::Path)
            && let Some(found) = scanner.attributes.iter().find(has_arcs)
        {
            self.output
                .note(holder, found.start, Reason::Elsewhere(name));
        }
    }

    /// Why the document forbids to replace the element.
    fn forbidden(
        &self,
        kind: Kind,
        element: &Element<'_>,
        scanner: &Scanner<'_>,
    ) -> Option<Reason> {
        let by_document = self.facts.and_then(|facts| {
            let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
            facts.forbid(kind, element.start, class.as_deref(), id.as_deref())
        });
        by_document
            .or_else(|| {
                let own = own::style(&scanner.attributes, &scanner.doctype);
                facts::style_reason(kind, own)
            })
            .or_else(|| {
                let prefix = element.name.strip_suffix(element.local).unwrap_or_default();
                scanner
                    .doctype
                    .has_defaults_for(element.name, &format!("{prefix}path"))
                    .then_some(Reason::AttributeDefaults)
            })
    }

    /// A circle, an ellipse or a rectangle; whether it became a path.
    fn shape(
        &mut self,
        kind: Kind,
        element: &Element<'_>,
        scanner: &Scanner<'a>,
        markers: Markers,
    ) -> bool {
        let has = |name: &str| {
            scanner
                .attributes
                .iter()
                .any(|attribute| attribute.name == name)
        };
        let rounded = kind != Kind::Rect || has("rx") || has("ry");
        if !rounded && !self.may_be_rounded(scanner) {
            return false;
        }
        let data = match self.shape_data(kind, scanner) {
            Ok(ShapeData::Square) if !self.may_be_rounded(scanner) => return false,
            Ok(ShapeData::Square) => Err(Reason::StyleGeometry("rx")),
            data => data,
        };
        let reason = self
            .forbidden(kind, element, scanner)
            .or_else(|| data.as_ref().err().cloned())
            .or_else(|| markers.any.then_some(Reason::Marker));
        if let Some(reason) = reason {
            self.output.note(kind.name(), element.start, reason);
            return false;
        }
        let Scratch { body, memo, .. } = &*self.scratch;
        let data = match data {
            Ok(ShapeData::Kept(index)) => memo.curve(index),
            _ => body.curve(),
        };
        replace(kind, element, scanner, data.text, &mut self.output.splice);
        self.counts.count(kind, 1);
        true
    }

    /// Works out the path data of a shape.
    fn shape_data(
        &mut self,
        kind: Kind,
        scanner: &Scanner<'_>,
    ) -> core::result::Result<ShapeData, Reason> {
        let key = &mut self.key;
        key.clear();
        key.extend_from_slice(kind.name().as_bytes());
        let mut spelled = true;
        for name in kind.geometry() {
            // Bytes that no text has part the values.
            let found = scanner
                .attributes
                .iter()
                .find(|attribute| attribute.name == *name);
            spelled &= found.is_none_or(|attribute| !attribute.has_references);
            key.push(if found.is_some() { 0xff } else { 0xfe });
            key.extend_from_slice(found.map_or(&[], |attribute| attribute.value.as_bytes()));
        }
        let scratch = &mut *self.scratch;
        if spelled && let Some(index) = scratch.memo.find(key) {
            return Ok(ShapeData::Kept(index));
        }
        let shape = element::read(kind, |name| scanner.attribute(name))?;
        if shape == Shape::Square {
            return Ok(ShapeData::Square);
        }
        let mut data = core::mem::take(&mut scratch.body.text);
        let drawn = element::path_data(&shape, self.options, scratch, &mut data);
        scratch.body.text = data;
        drawn?;
        scratch.body.to = None;
        if spelled {
            scratch.memo.keep(key, &scratch.body.curve());
        }
        Ok(ShapeData::Drawn)
    }

    /// Whether a style may give a rectangle round corners that its attributes do not.
    fn may_be_rounded(&self, scanner: &Scanner<'_>) -> bool {
        let by_sheet = self.facts.is_some_and(|facts| {
            let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
            facts.may_round(class.as_deref(), id.as_deref())
        });
        let radii = Properties::named("rx").with(Properties::named("ry"));
        by_sheet
            || own::style(&scanner.attributes, &scanner.doctype)
                .sets
                .meets(radii)
    }

    fn path(&mut self, element: &Element<'_>, scanner: &Scanner<'a>, markers: Markers) {
        let Some(d) = scanner
            .attributes
            .iter()
            .find(|attribute| attribute.name == "d")
        else {
            return;
        };
        if !d.has_references && memchr::memchr2(b'a', b'A', d.value.as_bytes()).is_none() {
            return;
        }
        let traced = if d.has_references {
            match value::traced(d.value, &scanner.doctype) {
                Some(traced) if !traced.text.contains(['a', 'A']) => return,
                Some(traced) if !traced.entities => Some(traced),
                _ => return self.output.note("path", d.start, Reason::Entity),
            }
        } else {
            None
        };
        if let Some(reason) = self.forbidden(Kind::Path, element, scanner) {
            return self.output.note("path", element.start, reason);
        }
        let context = arcs::Context {
            options: self.options,
            markers,
        };
        let (text, span, origin) = match &traced {
            Some(traced) => (
                traced.text.as_str(),
                0..traced.text.len(),
                Some((d.value_span.start, &traced.origin[..])),
            ),
            None => (scanner.source, d.value_span.clone(), None),
        };
        let mut sink = Sink {
            output: &mut self.output,
            origin,
        };
        let outcome = arcs::rewrite(text, span, context, self.scratch, &mut sink);
        self.counts.count(Kind::Path, outcome.arcs);
        self.counts.smooth += outcome.smooth;
    }
}

/// The tag's name becomes `path`, the first geometry attribute `d`, or a `d` that has no meaning yet gets one; the other ones go
/// with the space before them.
fn replace(
    kind: Kind,
    element: &Element<'_>,
    scanner: &Scanner<'_>,
    data: &[u8],
    splice: &mut Splice<'_>,
) {
    splice.replace(element.local_span.clone(), b"path");
    let stray = scanner.attributes.iter().any(|a| a.name == "d");
    let mut written = stray;
    for attribute in &scanner.attributes {
        if attribute.name == "d" {
            splice.replace(attribute.value_span.clone(), data);
        } else if kind.geometry().contains(&attribute.name) && written {
            splice.replace(attribute.span.clone(), b"");
        } else if kind.geometry().contains(&attribute.name) {
            splice.replace(
                attribute.start..attribute.start + attribute.name.len(),
                b"d",
            );
            splice.replace(attribute.value_span.clone(), data);
            written = true;
        }
    }
}
