//! What may run a script, which may then look for any element.

use crate::document::reason::Reason;
use crate::document::xml::attributes::Attribute;
use crate::document::xml::doctype::Doctype;
use crate::document::xml::namespace::Namespace;
use crate::document::xml::node::Element;
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;

/// Why an element or one of its attributes may, if so.
pub(super) fn may_run(element: &Element<'_>, scanner: &Scanner<'_>) -> Option<Reason> {
    let attributes = &scanner.attributes;
    let itself = match element.local {
        "script" | "handler" => true,
        // A page in the page, whose scripts reach the one around it.
        "iframe" | "frame" | "object" | "embed" | "portal" | "fencedframe" => attributes
            .iter()
            .any(|attribute| matches!(attribute.name, "src" | "srcdoc" | "data")),
        _ => false,
    };
    if itself && element.namespace != Namespace::Other {
        return Some(Reason::Script);
    }
    let found = attributes.iter().filter_map(|attribute| {
        if is_handler(attribute) {
            return Some(Reason::Script);
        }
        of_url(attribute, &scanner.doctype)
    });
    // What is known for certain comes first.
    found.min_by_key(|reason| *reason != Reason::Script)
}

/// Event attributes in a namespace (`a:onclick`) are none.
fn is_handler(attribute: &Attribute<'_>) -> bool {
    attribute.name.len() > 2
        && attribute.name.starts_with("on")
        && !attribute.value.trim().is_empty()
}

/// [`Reason::Script`] where an attribute of any name is a `javascript:` URL, or a list of values for one; another where its text cannot be read.
fn of_url(attribute: &Attribute<'_>, doctype: &Doctype) -> Option<Reason> {
    let is_list = attribute.name == "values";
    let first = attribute.value.bytes().find(|byte| *byte > b' ');
    if !is_list && !matches!(first, Some(b'j' | b'J' | b'&')) {
        return None;
    }
    let Some(text) = value::text(attribute.value, doctype) else {
        return Some(Reason::UnreadEntity);
    };
    let is_script = if is_list {
        text.split(';').any(is_script_url)
    } else {
        is_script_url(&text)
    };
    is_script.then_some(Reason::Script)
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
