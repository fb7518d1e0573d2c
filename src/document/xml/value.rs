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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_byte_knows_its_origin() {
        let traced = traced("M0&#32;0&amp;x", &Doctype::default()).unwrap();
        assert_eq!(traced.text, "M0 0&x");
        assert_eq!(traced.origin, [0, 1, 2, 7, 8, 13, 14]);
        assert!(!traced.entities);
        assert_eq!(text("a&b;", &Doctype::default()), None);
    }
}
