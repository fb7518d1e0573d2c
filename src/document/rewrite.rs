//! The pass that replaces: from the first byte to the last, with the facts of the document at hand.

use core::ops::Range;

use super::arcs;
use super::doubt::Doubt;
use super::element::{self, Shape};
use super::output::{Output, Sink};
use super::reason::Reason;
use super::scratch::Scratch;
use super::splice::Splice;
use super::style::facts::{self, Facts};
use super::style::own;
use super::style::property::{Kind, Markers, Properties};
use super::tag;
use super::xml::attributes::Attribute;
use super::xml::encoding::Source;
use super::xml::fault::Result;
use super::xml::namespace::Namespace;
use super::xml::node::{Element, Node};
use super::xml::place::Places;
use super::xml::scan::Scanner;
use super::xml::value;
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
    source: Source<'_>,
    options: &Options,
    facts: Option<&Facts>,
    scratch: &mut Scratch,
) -> Result<Pass> {
    let mut scanner = Scanner::new(source)?;
    let mut rewriter = Rewriter {
        options,
        facts,
        output: Output {
            splice: Splice::new(source.text),
            places: Places::new(source.text),
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
            Node::Reference(super::xml::doctype::Resolved::Text(_, false)) => {}
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
            self.android(element, scanner);
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
        let trust = self.options.trust;
        let by_document = self.facts.and_then(|facts| {
            let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
            let (class, id) = (class.as_deref(), id.as_deref());
            facts.forbid(kind, element.start, class, id, trust)
        });
        by_document
            .or_else(|| {
                let own = own::style(&scanner.attributes, &scanner.doctype);
                facts::style_reason(kind, own).filter(|reason| reason.counts(trust))
            })
            .or_else(|| {
                let prefix = element.name.strip_suffix(element.local).unwrap_or_default();
                scanner
                    .doctype
                    .has_defaults_for(element.name, &format!("{prefix}path"))
                    .then_some(Reason::AttributeDefaults)
                    .filter(|reason| reason.counts(trust))
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
            .or_else(|| {
                let shows = markers.any && Reason::Marker.counts(self.options.trust);
                shows.then_some(Reason::Marker)
            });
        if let Some(reason) = reason {
            self.output.note(kind.name(), element.start, reason);
            return false;
        }
        let Scratch { body, memo, .. } = &*self.scratch;
        let data = match data {
            Ok(ShapeData::Kept(index)) => memo.curve(index),
            _ => body.curve(),
        };
        tag::replace(
            kind,
            element,
            &scanner.attributes,
            data.text,
            &mut self.output.splice,
        );
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
        if self.options.trust.contains(Doubt::StyleGeometry) {
            return false;
        }
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
        let mut attributes = scanner.attributes.iter();
        let Some(d) = attributes.find(|attribute| attribute.name == "d") else {
            return;
        };
        let forbidden = |this: &Self| this.forbidden(Kind::Path, element, scanner);
        self.path_data("path", element.start, d, scanner, markers, forbidden);
    }

    /// The path data of an Android `VectorDrawable`.
    fn android(&mut self, element: &Element<'_>, scanner: &Scanner<'a>) {
        let found = element.android.and_then(|i| scanner.attributes.get(i));
        let name = match element.name {
            "path" => "path",
            "clip-path" => "clip-path",
            _ => return,
        };
        let is_data = |data: &&Attribute<'_>| {
            data.name.ends_with("Data") && self.options.only.contains(Kind::Path)
        };
        if let Some(data) = found.filter(is_data) {
            let trust = self.options.trust;
            let forbidden = |this: &Self| {
                // The text is a resource of another file.
                if data.value.starts_with(['@', '?']) {
                    return Some(Reason::Entity);
                }
                this.facts.and_then(|facts| facts.forbid_android(trust))
            };
            let markers = Markers::default();
            self.path_data(name, element.start, data, scanner, markers, forbidden);
        }
    }

    /// The arcs of an attribute that holds path data.
    fn path_data(
        &mut self,
        name: &'static str,
        start: usize,
        d: &Attribute<'a>,
        scanner: &Scanner<'a>,
        markers: Markers,
        forbidden: impl Fn(&Self) -> Option<Reason>,
    ) {
        if !d.has_references && memchr::memchr2(b'a', b'A', d.value.as_bytes()).is_none() {
            return;
        }
        let traced = if d.has_references {
            match value::traced(d.value, &scanner.doctype) {
                Some(traced) if !traced.text.contains(['a', 'A']) => return,
                Some(traced) if !traced.entities => Some(traced),
                _ => return self.output.note(name, d.start, Reason::Entity),
            }
        } else {
            None
        };
        if let Some(reason) = forbidden(self) {
            return self.output.note(name, start, reason);
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
            element: name,
            origin,
        };
        let outcome = arcs::rewrite(text, span, context, self.scratch, &mut sink);
        self.counts.count(Kind::Path, outcome.arcs);
        self.counts.smooth += outcome.smooth;
    }
}
