//! The attributes of a tag with their byte spans.

use core::ops::Range;
use std::collections::HashSet;

use super::fault::{XmlFault, XmlResult};

/// One attribute.
#[derive(Debug, Clone)]
pub(in crate::document) struct Attribute<'a> {
    /// The name with its prefix.
    pub(in crate::document) name: &'a str,
    /// The value as written, references and all.
    pub(in crate::document) value: &'a str,
    /// Whether there is a reference in it.
    pub(in crate::document) has_references: bool,
    /// From the white space before the name to after the closing quote.
    pub(in crate::document) span: Range<usize>,
    /// Where the name begins.
    pub(in crate::document) start: usize,
    /// The value without its quotes.
    pub(in crate::document) value_span: Range<usize>,
}

/// The attribute of this name.
pub(in crate::document) fn named<'s, 'a>(
    attributes: &'s [Attribute<'a>],
    name: &str,
) -> Option<&'s Attribute<'a>> {
    attributes.iter().find(|attribute| attribute.name == name)
}

/// Up to this many attributes are compared pair by pair.
const FEW: usize = 12;

/// The index after the white space at `bytes[at..]`.
#[inline]
pub(in crate::document) fn after_space(bytes: &[u8], mut at: usize) -> usize {
    while let Some(b' ' | b'\t' | b'\n' | b'\r') = bytes.get(at) {
        at += 1;
    }
    at
}

/// Reads the attributes after the name of a tag, from `source[at..]` on; gives the index of what stands after the last one and
/// white space: mostly the end of the tag.
pub(in crate::document) fn read<'a>(
    source: &'a str,
    at: usize,
    out: &mut Vec<Attribute<'a>>,
) -> XmlResult<usize> {
    out.clear();
    let bytes = source.as_bytes();
    let mut after = at;
    loop {
        let start = after_space(bytes, after);
        if let None | Some(b'>' | b'/' | b'?') = bytes.get(start) {
            return unique(out).map(|()| start);
        }
        let name = name(source, start)
            .filter(|_| start > after)
            .ok_or_else(|| XmlFault::new(start, "this is not an attribute"))?;
        let equals = after_space(bytes, start + name.len());
        if bytes.get(equals) != Some(&b'=') {
            return Err(XmlFault::new(
                start,
                format!("the attribute `{name}` has no value"),
            ));
        }
        let opening = after_space(bytes, equals + 1);
        let (value, has_references) = value(source, opening, name)?;
        let value_span = opening + 1..opening + 1 + value.len();
        let end = value_span.end + 1;
        out.push(Attribute {
            name,
            value,
            has_references,
            span: after..end,
            start,
            value_span,
        });
        after = end;
    }
}

/// The value of the attribute `name` whose quote stands at `opening`, and whether there is a reference in it.
fn value<'a>(source: &'a str, opening: usize, name: &str) -> XmlResult<(&'a str, bool)> {
    let bytes = source.as_bytes();
    let Some(quote @ (b'"' | b'\'')) = bytes.get(opening).copied() else {
        return Err(XmlFault::new(
            opening,
            format!("the value of `{name}` has no quotes"),
        ));
    };
    let start = opening + 1;
    let (mut at, mut has_references) = (start, false);
    loop {
        let Some(found) = memchr::memchr3(quote, b'<', b'&', &bytes[at..]) else {
            return Err(XmlFault::new(
                opening,
                format!("the value of `{name}` has no closing quote"),
            ));
        };
        at += found;
        match bytes[at] {
            b'<' => return Err(XmlFault::new(at, "`<` in the value of an attribute")),
            b'&' => {
                has_references = true;
                at += 1;
            }
            _ => return Ok((&source[start..at], has_references)),
        }
    }
}

fn unique(attributes: &[Attribute<'_>]) -> XmlResult<()> {
    let twice = if attributes.len() <= FEW {
        let seen = |(i, attribute): (usize, &Attribute<'_>)| {
            attributes[..i]
                .iter()
                .any(|other| other.name == attribute.name)
        };
        attributes
            .iter()
            .enumerate()
            .find(|&entry| seen(entry))
            .map(|(_, attribute)| attribute)
    } else {
        let mut names = HashSet::new();
        attributes
            .iter()
            .find(|attribute| !names.insert(attribute.name))
    };
    twice.map_or(Ok(()), |attribute| {
        Err(XmlFault::new(
            attribute.start,
            format!("the attribute `{}` stands twice in one tag", attribute.name),
        ))
    })
}

/// The bytes of names; characters beyond ASCII are not told apart.
const NAME: [bool; 256] = {
    let mut name = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        name[byte] = byte >= 0x80
            || (byte as u8).is_ascii_alphanumeric()
            || matches!(byte as u8, b'_' | b':' | b'-' | b'.');
        byte += 1;
    }
    name
};

const fn begins_name(byte: u8) -> bool {
    byte >= 0x80 || byte.is_ascii_alphabetic() || matches!(byte, b'_' | b':')
}

/// The name of an element or an attribute that begins at `source[at..]`, if one does.
pub(in crate::document) fn name(source: &str, at: usize) -> Option<&str> {
    let rest = source.as_bytes().get(at..)?;
    let length = rest.iter().take_while(|b| NAME[usize::from(**b)]).count();
    rest.first()
        .is_some_and(|first| begins_name(*first))
        .then(|| source.get(at..at + length))
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_exact() {
        let text = "<x a = 'x\"y'\n b:c=\"\" />";
        let mut out = Vec::new();
        assert_eq!(read(text, 2, &mut out), Ok(text.len() - 2));
        let spans: Vec<_> = out
            .iter()
            .map(|a| (a.name, a.value, &text[a.span.clone()]))
            .collect();
        assert_eq!(
            spans,
            [("a", "x\"y", " a = 'x\"y'"), ("b:c", "", "\n b:c=\"\"")]
        );
    }

    #[test]
    fn what_is_not_well_formed_is_refused() {
        let wide: String = (0..40)
            .map(|i| format!(" a{i}=''"))
            .chain([" a7=''".to_owned()])
            .collect();
        for text in [
            " a",
            " a=b",
            " a='1'b='2'",
            " a='<'",
            " a='1' a='2'",
            " 1='2'",
            " a='",
            " ='2'",
            wide.as_str(),
        ] {
            assert!(read(text, 0, &mut Vec::new()).is_err(), "{text}");
        }
    }
}
