//! What an element says about itself: its markers, its style attribute.

use super::attributes::Attribute;
use super::css;
use super::doctype::Doctype;
use super::property::{Kind, Markers, Properties, is_none};
use super::value;

/// The markers in effect on an element, from what its parent passes on and what it says itself.
pub(super) fn markers(
    inherited: Markers,
    attributes: &[Attribute<'_>],
    doctype: &Doctype<'_>,
) -> Markers {
    let mut markers = inherited;
    for attribute in attributes {
        match attribute.name {
            "marker-start" | "marker-mid" | "marker-end" | "marker" => {
                let on = value::text(attribute.value, doctype).is_none_or(|value| !is_none(&value));
                let middle = Properties::named(attribute.name).markers().middle;
                // A single `none` may leave other markers on.
                markers.any |= on;
                markers.middle = if middle { on } else { markers.middle };
            }
            "style" if may_say_marker(attribute.value) => {
                let text =
                    value::text(attribute.value, doctype).unwrap_or_else(|| attribute.value.into());
                let set = css::declarations(&text).markers();
                if set.any {
                    markers = Markers {
                        any: true,
                        middle: markers.middle || set.middle,
                    };
                } else if switched_off(&text) {
                    markers = Markers::default();
                }
            }
            _ => {}
        }
    }
    markers
}

/// Whether a style attribute may say `marker`: most do not, and need not be read.
fn may_say_marker(style: &str) -> bool {
    style.contains(['\\', '&'])
        || style
            .as_bytes()
            .windows(6)
            .any(|word| word.eq_ignore_ascii_case(b"marker"))
}

/// Whether a style attribute says `marker: none`.
fn switched_off(text: &str) -> bool {
    text.split(';')
        .filter_map(|declaration| declaration.split_once(':'))
        .any(|(name, value)| name.trim().eq_ignore_ascii_case("marker") && is_none(value))
}

/// The properties of a style attribute that forbid to replace this kind.
pub(super) fn style(kind: Kind, attributes: &[Attribute<'_>], doctype: &Doctype<'_>) -> Properties {
    let Some(style) = attributes
        .iter()
        .find(|attribute| attribute.name == "style")
    else {
        return Properties::NONE;
    };
    let text = value::text(style.value, doctype).unwrap_or_else(|| "\\:".into());
    css::declarations(&text).and(kind.sensitive())
}
