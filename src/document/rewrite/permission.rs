//! What the document says about an element that would be replaced.

use super::Rewriter;
use crate::document::doubt::Doubt;
use crate::document::reason::Reason;
use crate::document::style::property::{ElementKind, Properties};
use crate::document::style::rules::SelectorSubject;
use crate::document::style::{of_document, on_element};
use crate::document::xml::node::Element;
use crate::document::xml::scan::Scanner;

impl Rewriter<'_, '_> {
    /// Why the document forbids to replace the element.
    pub(super) fn forbidden(
        &self,
        kind: ElementKind,
        element: &Element<'_>,
        scanner: &Scanner<'_>,
    ) -> Option<Reason> {
        let trust = self.options.trust;
        let by_document = self.facts.and_then(|facts| {
            let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
            let subject = SelectorSubject::new(kind.name(), class.as_deref(), id.as_deref());
            facts.forbid(kind, element.start, subject, trust)
        });
        by_document
            .or_else(|| {
                let own = on_element::style(&scanner.attributes, &scanner.doctype);
                of_document::style_reason(kind, own).filter(|reason| reason.counts(trust))
            })
            .or_else(|| {
                let prefix = element.name.strip_suffix(element.local).unwrap_or_default();
                let named = |kind: ElementKind| format!("{prefix}{}", kind.name());
                scanner
                    .doctype
                    .has_defaults_for(&named(kind), &named(ElementKind::Path))
                    .then_some(Reason::AttributeDefaults)
                    .filter(|reason| reason.counts(trust))
            })
    }

    /// Whether a style may give a rectangle round corners that its attributes do not.
    pub(super) fn may_be_rounded(&self, scanner: &Scanner<'_>) -> bool {
        if self.options.trust.contains(Doubt::StyleGeometry) {
            return false;
        }
        let by_sheet = self.facts.is_some_and(|facts| {
            let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
            facts.may_round(SelectorSubject::new(
                "rect",
                class.as_deref(),
                id.as_deref(),
            ))
        });
        let radii = Properties::named("rx").with(Properties::named("ry"));
        by_sheet
            || on_element::style(&scanner.attributes, &scanner.doctype)
                .sets
                .meets(radii)
    }
}
