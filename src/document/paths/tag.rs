//! A start tag whose attributes are read, or why they cannot be.

use std::borrow::Cow;

use crate::document::style::css;
use crate::document::xml::attributes::Attribute;
use crate::document::xml::place::Places;
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;
use crate::error::{Error, Result, TextError};

/// A start tag of SVG that was just read.
pub(in crate::document) struct Tag<'t> {
    /// Its name without a prefix.
    pub(in crate::document) name: &'t str,
    scanner: &'t Scanner<'t>,
    /// The values in which references stand, by the names of their attributes; resolved once, as what entities may grow to is limited.
    resolved: Vec<(&'t str, Result<String>)>,
}

impl<'t> Tag<'t> {
    pub(in crate::document) fn new(name: &'t str, scanner: &'t Scanner<'t>) -> Self {
        let attributes = scanner.attributes.iter();
        let resolved = attributes
            .filter(|attribute| attribute.has_references)
            .map(|attribute| (attribute.name, resolved(attribute, scanner)))
            .collect();
        Self {
            name,
            scanner,
            resolved,
        }
    }

    pub(in crate::document) fn attribute(&self, name: &str) -> Result<Option<String>> {
        match self.resolved.iter().find(|(known, _)| *known == name) {
            Some((_, value)) => value.clone().map(Some),
            None => Ok(self.scanner.attribute(name).map(Cow::into_owned)),
        }
    }

    /// A property, of the style attribute or as an attribute.
    pub(in crate::document) fn property(&self, name: &str) -> Result<Option<String>> {
        match self.styled(name)? {
            None => self.attribute(name),
            styled => Ok(styled),
        }
    }

    /// The declaration of the style attribute that counts.
    pub(in crate::document) fn styled(&self, name: &str) -> Result<Option<String>> {
        let style = self.attribute("style")?;
        Ok(style.and_then(|style| css::declared(&style, name)))
    }
}

/// The value of an attribute with its references resolved.
fn resolved(attribute: &Attribute<'_>, scanner: &Scanner<'_>) -> Result<String> {
    let text = value::text(attribute.value, &scanner.doctype);
    if text.as_ref().is_none_or(|text| text.contains('<'))
        && let Some((at, entity, why)) = value::unreadable(attribute.value, &scanner.doctype)
    {
        let at = attribute.value_span.start + at;
        return Err(Error::Text(entity_error(scanner, at, entity, why)));
    }
    let text = text.unwrap_or(Cow::Borrowed(attribute.value));
    Ok(scanner.comparable(text).into_owned())
}

/// What is said of the entity of a reference at a byte.
pub(in crate::document) fn entity_error(
    scanner: &Scanner<'_>,
    at: usize,
    entity: &str,
    why: &'static str,
) -> TextError {
    let (line, column) = Places::new(scanner.source).locate(at);
    TextError::Entity {
        entity: entity.to_owned(),
        line,
        column,
        why,
    }
}
