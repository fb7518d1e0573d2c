//! What may run a script, which may then look for any element.

use crate::document::xml::attributes::Attribute;
use crate::document::xml::doctype::Doctype;
use crate::document::xml::namespace::Namespace;
use crate::document::xml::node::Element;
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;

/// Whether an element or one of its attributes may.
pub(super) fn may_run(element: &Element<'_>, scanner: &Scanner<'_>) -> bool {
    let attributes = &scanner.attributes;
    let itself = match element.local {
        "script" | "handler" => true,
        // A page in the page, whose scripts reach the one around it.
        "iframe" | "frame" | "object" | "embed" | "portal" | "fencedframe" => attributes
            .iter()
            .any(|attribute| matches!(attribute.name, "src" | "srcdoc" | "data")),
        _ => false,
    };
    itself && element.namespace != Namespace::Other
        || attributes
            .iter()
            .any(|attribute| is_handler(attribute) || has_script_url(attribute, &scanner.doctype))
}

/// Event attributes in a namespace (`a:onclick`) are none.
fn is_handler(attribute: &Attribute<'_>) -> bool {
    attribute.name.len() > 2
        && attribute.name.starts_with("on")
        && !attribute.value.trim().is_empty()
}

/// Whether an attribute of any name is a `javascript:` URL, or a list of values for one.
fn has_script_url(attribute: &Attribute<'_>, doctype: &Doctype) -> bool {
    let is_list = attribute.name == "values";
    let first = attribute.value.bytes().find(|byte| *byte > b' ');
    if !is_list && !matches!(first, Some(b'j' | b'J' | b'&')) {
        return false;
    }
    let Some(text) = value::text(attribute.value, doctype) else {
        return true;
    };
    if is_list {
        text.split(';').any(is_script_url)
    } else {
        is_script_url(&text)
    }
}

fn is_script_url(text: &str) -> bool {
    // What a URL drops: control characters and space before it, tabs and line ends in it.
    let letters = text.trim_start_matches(|c: char| c <= ' ').chars();
    let letters = letters.filter(|c| !matches!(c, '\t' | '\n' | '\r'));
    let scheme = "javascript:";
    letters
        .take(scheme.len())
        .map(|c| c.to_ascii_lowercase())
        .eq(scheme.chars())
}
