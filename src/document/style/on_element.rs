//! What an element says about itself: its markers, its style attribute.

use super::css;
use super::property::{Effect, Markers, Properties};
use crate::document::xml::attributes::{Attribute, named};
use crate::document::xml::doctype::Doctype;
use crate::document::xml::value;

/// The markers in effect on an element, from what its parent passes on and what it says itself.
pub(in crate::document) fn markers(
    inherited: Markers,
    attributes: &[Attribute<'_>],
    doctype: &Doctype,
) -> Markers {
    let mut markers = inherited;
    for attribute in attributes {
        // An empty value is none, and leaves what is inherited.
        if let "marker-start" | "marker-mid" | "marker-end" | "marker" = attribute.name
            && !attribute.value.trim().is_empty()
        {
            let on =
                value::text(attribute.value, doctype).is_none_or(|value| !css::is_none(&value));
            // A single `none` may leave other markers on, and `marker` as an attribute is not known everywhere.
            markers.any |= on;
            match attribute.name {
                "marker-mid" => markers.middle = on,
                "marker" => markers.middle |= on,
                _ => {}
            }
        }
    }
    // A style wins over attributes.
    let says =
        |attribute: &&Attribute<'_>| attribute.name == "style" && may_say_marker(attribute.value);
    if let Some(style) = attributes.iter().find(says) {
        let text = value::text(style.value, doctype).unwrap_or_else(|| style.value.into());
        let effect = css::declarations(&text);
        let set = effect.sets.markers();
        if set.any {
            markers = Markers {
                any: true,
                middle: markers.middle || set.middle,
            };
        } else if effect.no_marker {
            markers = Markers::default();
        }
    }
    markers
}

/// Whether a style attribute may say `marker` or `all`: most do not, and need not be read.
fn may_say_marker(style: &str) -> bool {
    let says = |name: &[u8]| {
        let mut words = style.as_bytes().windows(name.len());
        words.any(|word| word.eq_ignore_ascii_case(name))
    };
    style.contains(['\\', '&']) || says(b"marker") || says(b"all")
}

/// What its style attribute does, and what the values of other attributes read.
pub(in crate::document) fn style(attributes: &[Attribute<'_>], doctype: &Doctype) -> Effect {
    let mut effect = declared(attributes, doctype);
    for attribute in attributes {
        if attribute.name != "style" && may_read(attribute) {
            let text = value::text(attribute.value, doctype);
            let reads = text.map_or(Properties::ANY, |text| css::reads(&text));
            effect.reads = effect.reads.with(reads);
        }
    }
    effect
}

/// Whether the value of an attribute may say `attr()`, as those of presentation attributes may.
fn may_read(attribute: &Attribute<'_>) -> bool {
    let bytes = attribute.value.as_bytes();
    attribute.has_references
        || memchr::memchr(b'(', bytes).is_some()
            && (bytes.contains(&b'\\')
                || bytes
                    .windows(5)
                    .any(|word| word.eq_ignore_ascii_case(b"attr(")))
}

/// What a style attribute does.
fn declared(attributes: &[Attribute<'_>], doctype: &Doctype) -> Effect {
    let Some(style) = named(attributes, "style") else {
        return Effect::default();
    };
    match value::text(style.value, doctype) {
        Some(text) => css::declarations(&text),
        None => Effect {
            sets: Properties::ANY,
            ..Effect::default()
        },
    }
}
