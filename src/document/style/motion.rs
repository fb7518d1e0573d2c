//! Paths along which CSS moves something.

use crate::document::xml::attributes::Attribute;
use crate::document::xml::characters::percent_decoded;

/// The property by which CSS moves an element along a path.
const OFFSET_PATH: &str = "offset-path";

/// Whether an attribute does.
pub(super) fn moves_along(attribute: &Attribute<'_>) -> bool {
    attribute.name == OFFSET_PATH
        || attribute.name == "style" && attribute.value.contains(OFFSET_PATH)
}

/// The ids that a document with such a property has in `url(#id)` anywhere: whichever of them it follows.
pub(super) fn followed(text: &str) -> impl Iterator<Item = String> {
    let text = if text.contains(OFFSET_PATH) { text } else { "" };
    text.split("url(").skip(1).filter_map(|rest| {
        let quotes = ["\"", "'", "&quot;", "&apos;", "&#34;", "&#39;"];
        let rest = rest.trim_start();
        let bare = quotes.iter().find_map(|quote| rest.strip_prefix(quote));
        let id = bare.unwrap_or(rest).trim_start().strip_prefix('#')?;
        let end = id.find(|c: char| "\"'&) \t\r\n".contains(c))?;
        Some(percent_decoded(&id[..end]))
    })
}
