//! The way back for a whole path: where it becomes a shape, and why not.

use crate::document::output::NewText;
use crate::document::reason::Reason;
use crate::document::shape::tag;
use crate::document::shape::whole::{self, Whole};
use crate::document::style::property::ElementKind;
use crate::document::xml::attributes::{Attribute, named};
use crate::document::xml::node::Element;
use crate::joints::Tolerance;

/// A path that may be a shape.
pub(in crate::document) struct Candidate<'r, 'a> {
    pub(in crate::document) element: &'r Element<'r>,
    pub(in crate::document) attributes: &'r [Attribute<'a>],
    pub(in crate::document) d: &'r Attribute<'a>,
    pub(in crate::document) whole: Whole,
}

impl<'r, 'a> Candidate<'r, 'a> {
    /// The path, where its data are a shape of no more bytes.
    pub(in crate::document) fn new(
        element: &'r Element<'r>,
        attributes: &'r [Attribute<'a>],
        d: &'r Attribute<'a>,
        tolerance: Option<Tolerance>,
    ) -> Option<Self> {
        let whole = whole::find(d.value, 0..d.value.len(), tolerance)?;
        let tags = if element.empty { 1 } else { 2 };
        let names = tags * (whole.kind.name().len() - ElementKind::Path.name().len());
        let grown = whole.attributes(b'"').len() + names;
        (grown <= d.value_span.end - d.start).then_some(Self {
            element,
            attributes,
            d,
            whole,
        })
    }

    /// Why it stays a path, as far as it says itself. `lower` is the text of the document as [`super::xml::value::words`].
    pub(in crate::document) fn stays(&self, lower: &str) -> Option<Reason> {
        let has = |name: &str| named(self.attributes, name).is_some();
        let stays = if has("pathLength") {
            "renderers of SVG 1.1 know pathLength on paths only"
        } else if self.whole.kind.geometry().iter().any(|name| has(name)) {
            "it has an attribute that the shape would read"
        } else if has("id") && lower.contains("textpath") {
            "text may run along it, which renderers of SVG 1.1 draw on paths only"
        } else if !self.whole.starts_alike && lower.contains(['\\']) | lower.contains("dash") {
            "dashes would begin elsewhere"
        } else {
            return None;
        };
        Some(Reason::StaysPath(stays))
    }

    /// Makes it the shape.
    pub(in crate::document) fn replace(&self, source: &str, output: &mut NewText<'_>) {
        let quote = source.as_bytes().get(self.d.value_span.start - 1);
        let attributes = self.whole.attributes(quote.copied().unwrap_or(b'"'));
        tag::become_shape(
            self.whole.kind,
            self.element,
            self.d,
            &attributes,
            &mut output.splice,
        );
    }
}
