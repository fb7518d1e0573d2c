//! Attribute values as XML sees them: references resolved, and each byte traced back to the file.

use std::borrow::Cow;

use super::doctype::{Doctype, Resolved};

/// A value with its references resolved; `None` where one is unknown.
pub(in crate::document) fn text<'a>(raw: &'a str, doctype: &Doctype) -> Option<Cow<'a, str>> {
    if !raw.contains('&') {
        return Some(Cow::Borrowed(raw));
    }
    traced(raw, doctype).map(|traced| Cow::Owned(traced.text))
}

/// Where the first reference of a value is that stands for no plain text, its name, and why.
pub(in crate::document) fn unreadable<'a>(
    raw: &'a str,
    doctype: &Doctype,
) -> Option<(usize, &'a str, &'static str)> {
    raw.match_indices('&').find_map(|(at, _)| {
        let name = raw[at + 1..].split(';').next()?;
        Some((at, name, doctype.why_not(name)?))
    })
}

/// A resolved value and the way back.
#[derive(Debug)]
pub(in crate::document) struct Traced {
    pub(in crate::document) text: String,
    /// For each byte of `text`, and for its end, the byte of the raw value where it begins.
    pub(in crate::document) origin: Vec<usize>,
    /// Whether a declared entity takes part: then bytes share an origin and nothing can be replaced inside.
    pub(in crate::document) entities: bool,
}

/// Resolves the references of a value; `None` where one is unknown.
pub(in crate::document) fn traced(raw: &str, doctype: &Doctype) -> Option<Traced> {
    let mut traced = Traced {
        text: String::with_capacity(raw.len()),
        origin: Vec::new(),
        entities: false,
    };
    let mut at = 0;
    while let Some(ampersand) = raw[at..].find('&').map(|i| at + i) {
        traced.text.push_str(&raw[at..ampersand]);
        traced.origin.extend(at..ampersand);
        let length = raw[ampersand..].find(';')?;
        match doctype.resolve(&raw[ampersand + 1..ampersand + length]) {
            Resolved::Text(text, entity) => {
                traced.text.push_str(&text);
                traced
                    .origin
                    .extend(core::iter::repeat_n(ampersand, text.len()));
                traced.entities |= entity;
            }
            Resolved::Unknown | Resolved::Malformed => return None,
        }
        at = ampersand + length + 1;
    }
    traced.text.push_str(&raw[at..]);
    traced.origin.extend(at..=raw.len());
    Some(traced)
}

/// A whole document in small letters with its references resolved, to look for words in; what cannot be known reads as a backslash.
pub(in crate::document) fn words(source: &str, doctype: &Doctype) -> String {
    let (mut out, mut rest) = (String::with_capacity(source.len()), source);
    while let Some((before, after)) = rest.split_once('&') {
        out.push_str(before);
        let is_name = |c: char| c.is_alphanumeric() || "#:-_.".contains(c);
        let end = after.find(|c| !is_name(c)).unwrap_or(after.len());
        let (name, left) = after.split_at(end);
        rest = left;
        match doctype.resolve(name) {
            Resolved::Text(text, _) => out.push_str(&text),
            Resolved::Unknown => out.push('\\'),
            // Within a comment or CDATA.
            Resolved::Malformed => out.extend(["&", name]),
        }
        rest = rest.strip_prefix(';').unwrap_or(rest);
    }
    out.push_str(rest);
    out.make_ascii_lowercase();
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_through_references() {
        let doctype = Doctype::read(" svg [<!ENTITY d 'da'><!ENTITY e SYSTEM 'x'>]", 9);
        let words = |text: &str| words(text, &doctype);
        assert_eq!(words("STROKE-D&#97;&#x53;h &d;sh"), "stroke-dash dash");
        assert_eq!(words("a&e;b <!-- & &x; -->"), "a\\b <!-- & &x -->");
    }

    #[test]
    fn each_byte_knows_its_origin() {
        let traced = traced("M0&#32;0&amp;x", &Doctype::default()).unwrap();
        assert_eq!(traced.text, "M0 0&x");
        assert_eq!(traced.origin, [0, 1, 2, 7, 8, 13, 14]);
        assert!(!traced.entities);
        assert_eq!(text("a&b;", &Doctype::default()), None);
    }
}
