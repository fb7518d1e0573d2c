//! The pass that replaces: from the first byte to the last, with the facts of the document at hand.

mod permission;

use core::ops::Range;

use super::output::{EditSink, NewText};
use super::path::arcs;
use super::path::runs;
use super::path::scratch::Scratch;
use super::reason::Reason;
use super::shape::back;
use super::shape::shape_data::{self, ShapeData};
use super::shape::tag;
use super::splice::Splice;
use super::style::of_document::{self, Facts};
use super::style::on_element;
use super::style::property::{ElementKind, Markers};
use super::xml::attributes::{Attribute, named};
use super::xml::encoding::SourceText;
use super::xml::fault::{XmlFault, XmlResult};
use super::xml::namespace::Namespace;
use super::xml::node::{Element, Node};
use super::xml::place::Places;
use super::xml::scan::Scanner;
use super::xml::value;
use super::{Counts, Note, Options, Target};
use crate::joints::Tolerance;

/// What a pass came to.
pub(super) enum Pass {
    /// It is done.
    Done(Rewritten),
    /// The document has style sheets, scripts or animations: read them first.
    NeedsFacts,
}

/// What became of a document.
#[derive(Debug, Default)]
pub(super) struct Rewritten {
    /// The new text, if anything was replaced.
    pub(super) text: Option<String>,
    pub(super) counts: Counts,
    pub(super) notes: Vec<Note>,
    /// How far new arcs and shapes lie from what was there at most.
    pub(super) strayed: f64,
}

/// What an open element passes on to its end tag and its children.
#[derive(Debug, Clone, Copy)]
struct OpenElement {
    /// Its new name, if it has one.
    renamed: Option<ElementKind>,
    markers: Markers,
}

struct Rewriter<'a, 'f> {
    options: &'f Options,
    facts: Option<&'f Facts>,
    output: NewText<'a>,
    counts: Counts,
    scratch: &'f mut Scratch,
    /// How a shape is spelled.
    key: Vec<u8>,
    /// How far new arcs and shapes lie from what was there at most.
    strayed: f64,
    /// The text as [`value::words`], once it was asked for.
    lower: Option<String>,
}

/// Rewrites a document, whose new text may have so many bytes.
pub(super) fn run(
    source: SourceText<'_>,
    options: &Options,
    facts: Option<&Facts>,
    scratch: &mut Scratch,
    most: usize,
) -> XmlResult<Pass> {
    let mut scanner = Scanner::new(source)?;
    let output = NewText {
        splice: Splice::new(source.text, most),
        places: Places::new(source.text),
        notes: Vec::new(),
    };
    let mut rewriter = Rewriter {
        options,
        facts,
        output,
        counts: Counts::default(),
        scratch,
        key: Vec::new(),
        strayed: 0.0,
        lower: None,
    };
    let mut open: Vec<OpenElement> = Vec::new();
    loop {
        match scanner.next()? {
            Node::Start(element) => {
                if facts.is_none() && of_document::is_sign(&element, &scanner) {
                    return Ok(Pass::NeedsFacts);
                }
                let inherited = open.last().map(|open| open.markers).unwrap_or_default();
                let markers = rewriter.markers(inherited, &element, &scanner);
                if facts.is_none() && markers.any && of_document::is_use(&element) {
                    return Ok(Pass::NeedsFacts);
                }
                let renamed = rewriter.element(&element, &scanner, markers);
                if rewriter.output.splice.is_full() {
                    return Err(XmlFault::too_large(element.start));
                }
                if !element.empty {
                    open.push(OpenElement { renamed, markers });
                }
            }
            Node::End { local } => rewriter.end(open.pop(), local),
            Node::Instruction(text) if facts.is_none() && text.starts_with("xml-stylesheet") => {
                return Ok(Pass::NeedsFacts);
            }
            Node::Reference(_, super::xml::doctype::Resolved::Text(_, false)) => {}
            Node::Reference(..) if facts.is_none() => return Ok(Pass::NeedsFacts),
            Node::Done => break,
            _ => {}
        }
    }
    Ok(Pass::Done(Rewritten {
        text: rewriter.output.splice.finish(),
        counts: rewriter.counts,
        notes: rewriter.output.notes,
        strayed: rewriter.strayed,
    }))
}

impl<'a> Rewriter<'a, '_> {
    fn markers(&self, inherited: Markers, element: &Element<'_>, scanner: &Scanner<'_>) -> Markers {
        self.facts.map_or_else(
            || on_element::markers(inherited, &scanner.attributes, &scanner.doctype),
            |facts| facts.markers(inherited, element, scanner),
        )
    }

    /// The end tag of an element that became another one gets the new name.
    fn end(&mut self, open: Option<OpenElement>, local: Range<usize>) {
        if let Some(kind) = open.and_then(|open| open.renamed) {
            self.output.splice.replace(local, kind.name().as_bytes());
        }
    }

    /// Replaces an element or notes why not; its new name, which its end tag gets too.
    fn element(
        &mut self,
        element: &Element<'_>,
        scanner: &Scanner<'a>,
        markers: Markers,
    ) -> Option<ElementKind> {
        if element.namespace != Namespace::Svg {
            self.android(element, scanner);
            return None;
        }
        let kind = ElementKind::named(element.local);
        match (kind, self.options.to) {
            (Some(ElementKind::Path), Target::Arcs { tolerance, shapes }) => {
                let made = shapes.then(|| self.whole(element, scanner, markers, tolerance));
                made.flatten().or_else(|| {
                    if self.options.only.contains(ElementKind::Path) {
                        self.path(element, scanner, markers);
                    }
                    None
                })
            }
            (_, Target::Arcs { .. }) => None,
            (Some(kind), _) if !self.options.only.contains(kind) => None,
            (Some(ElementKind::Path), _) => {
                self.path(element, scanner, markers);
                None
            }
            (Some(kind), _) => {
                let replaced = self.shape(kind, element, scanner, markers);
                replaced.then_some(ElementKind::Path)
            }
            (None, _) => {
                if self.options.only.contains(ElementKind::Path)
                    && let Some((holder, name, at)) = tag::arcs_elsewhere(element, scanner)
                {
                    self.output.note(holder, at, Reason::Elsewhere(name));
                }
                None
            }
        }
    }

    /// A path that becomes a shape, whose kind this gives.
    fn whole(
        &mut self,
        element: &Element<'_>,
        scanner: &Scanner<'a>,
        markers: Markers,
        tolerance: Option<Tolerance>,
    ) -> Option<ElementKind> {
        let d = named(&scanner.attributes, "d")?;
        let path = back::Candidate::new(element, &scanner.attributes, d, tolerance)?;
        let kind = path.whole.kind;
        if !self.options.only.contains(kind) {
            return None;
        }
        let source = scanner.source;
        let lower = self
            .lower
            .get_or_insert_with(|| value::words(source, &scanner.doctype));
        let stays = path.stays(lower);
        let marked = markers.any && Reason::Marker.counts(self.options.trust);
        let reason = self
            .forbidden(kind, element, scanner)
            .or(stays)
            .or_else(|| marked.then_some(Reason::Marker));
        if let Some(reason) = reason {
            self.output.note("path", element.start, reason);
            return None;
        }
        path.replace(source, &mut self.output);
        self.counts.count(kind, 1);
        self.strayed = self.strayed.max(path.whole.strayed);
        Some(kind)
    }

    /// A circle, an ellipse or a rectangle; whether it became a path.
    fn shape(
        &mut self,
        kind: ElementKind,
        element: &Element<'_>,
        scanner: &Scanner<'a>,
        markers: Markers,
    ) -> bool {
        let has = |name: &str| named(&scanner.attributes, name).is_some();
        let rounded = kind != ElementKind::Rect || has("rx") || has("ry");
        if !rounded && !self.may_be_rounded(scanner) {
            return false;
        }
        let data = match shape_data::find(kind, scanner, self.options, self.scratch, &mut self.key)
        {
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
        self.strayed = self.strayed.max(data.facts.strayed);
        self.counts.count(kind, 1);
        true
    }

    fn path(&mut self, element: &Element<'_>, scanner: &Scanner<'a>, markers: Markers) {
        let Some(d) = named(&scanner.attributes, "d") else {
            return;
        };
        let forbidden = |this: &Self| this.forbidden(ElementKind::Path, element, scanner);
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
            data.name.ends_with("Data") && self.options.only.contains(ElementKind::Path)
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

    /// The runs of path data that become arcs, on the way back.
    fn runs(&self, text: &str, span: Range<usize>, markers: Markers) -> Option<runs::RunsOutcome> {
        let Target::Arcs { tolerance, .. } = self.options.to else {
            return None;
        };
        let keeps_vertices = markers.middle && Reason::MarkerOnRun.counts(self.options.trust);
        let known = self.strayed;
        Some(runs::find(text, span, tolerance, keeps_vertices, known))
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
        if !d.has_references && !self.options.to.concerns(d.value) {
            return;
        }
        let traced = if d.has_references {
            match value::traced(d.value, &scanner.doctype) {
                Some(traced) if !self.options.to.concerns(&traced.text) => return,
                Some(traced) if !traced.entities => Some(traced),
                _ => return self.output.note(name, d.start, Reason::Entity),
            }
        } else {
            None
        };
        let (text, span, origin) = match &traced {
            Some(traced) => (
                traced.text.as_str(),
                0..traced.text.len(),
                Some((d.value_span.start, &traced.origin[..])),
            ),
            None => (scanner.source, d.value_span.clone(), None),
        };
        let found = self.runs(text, span.clone(), markers);
        if found.as_ref().is_none_or(|found| !found.is_empty())
            && let Some(reason) = forbidden(self)
        {
            return self.output.note(name, start, reason);
        }
        let mut sink = EditSink {
            output: &mut self.output,
            element: name,
            origin,
        };
        if let Some(found) = found {
            self.counts.count(ElementKind::Path, found.arcs);
            self.strayed = self.strayed.max(found.strayed);
            return found.write(&mut sink);
        }
        let options = self.options;
        let context = arcs::Context { options, markers };
        let outcome = arcs::rewrite(text, span, context, self.scratch, &mut sink);
        self.counts.count(ElementKind::Path, outcome.arcs);
        self.counts.smooth += outcome.smooth;
        self.strayed = self.strayed.max(outcome.strayed);
    }
}

#[cfg(test)]
mod tests;
