//! The attributes of a tag with their byte spans.

use core::ops::Range;
use std::collections::HashSet;

use super::fault::{Fault, Result};

/// One attribute.
#[derive(Debug, Clone)]
pub(super) struct Attribute<'a> {
    /// The name with its prefix.
    pub(super) name: &'a str,
    /// The value as written, references and all.
    pub(super) value: &'a str,
    /// Whether there is a reference in it.
    pub(super) has_references: bool,
    /// From the white space before the name to behind the closing quote.
    pub(super) span: Range<usize>,
    /// Where the name begins.
    pub(super) start: usize,
    /// The value without its quotes.
    pub(super) value_span: Range<usize>,
}

impl<'a> Attribute<'a> {
    /// The name without a prefix.
    pub(super) fn local(&self) -> &'a str {
        self.name.rsplit(':').next().unwrap_or(self.name)
    }
}

/// Up to this many attributes are compared pair by pair.
const FEW: usize = 12;

/// Reads what stands between the name of a tag and its end; `base` is the text's place in the document.
pub(super) fn read<'a>(text: &'a str, base: usize, out: &mut Vec<Attribute<'a>>) -> Result<()> {
    out.clear();
    let bytes = text.as_bytes();
    let space = |mut at: usize| {
        while let Some(b' ' | b'\t' | b'\n' | b'\r') = bytes.get(at) {
            at += 1;
        }
        at
    };
    let mut behind = 0;
    loop {
        let start = space(behind);
        if start == bytes.len() {
            return unique(out);
        }
        let mut at = start;
        while bytes.get(at).is_some_and(|b| NAME[usize::from(*b)]) {
            at += 1;
        }
        let name = &text[start..at];
        if start == behind || !begins_name(bytes[start]) {
            return Err(Fault::new(base + start, "this is not an attribute"));
        }
        at = space(at);
        if bytes.get(at) != Some(&b'=') {
            return Err(Fault::new(
                base + start,
                format!("the attribute `{name}` has no value"),
            ));
        }
        at = space(at + 1);
        let Some(quote @ (b'"' | b'\'')) = bytes.get(at).copied() else {
            return Err(Fault::new(
                base + at,
                format!("the value of `{name}` has no quotes"),
            ));
        };
        let value_start = at + 1;
        let (mut length, mut has_references) = (0, false);
        loop {
            let Some(found) = memchr::memchr3(quote, b'<', b'&', &bytes[value_start + length..])
            else {
                return Err(Fault::new(
                    base + at,
                    format!("the value of `{name}` has no closing quote"),
                ));
            };
            length += found;
            match bytes[value_start + length] {
                b'<' => {
                    return Err(Fault::new(
                        base + value_start + length,
                        "`<` in the value of an attribute",
                    ));
                }
                b'&' => {
                    has_references = true;
                    length += 1;
                }
                _ => break,
            }
        }
        let value = &text[value_start..value_start + length];
        let end = value_start + length + 1;
        out.push(Attribute {
            name,
            value,
            has_references,
            span: base + behind..base + end,
            start: base + start,
            value_span: base + value_start..base + value_start + length,
        });
        behind = end;
    }
}

fn unique(attributes: &[Attribute<'_>]) -> Result<()> {
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
        Err(Fault::new(
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

/// Whether a text may name an element or an attribute.
pub(super) fn is_name(name: &str) -> bool {
    name.bytes().next().is_some_and(begins_name) && name.bytes().all(|byte| NAME[usize::from(byte)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_exact() {
        let text = " a = 'x\"y'\n b:c=\"\" ";
        let mut out = Vec::new();
        read(text, 10, &mut out).unwrap();
        let spans: Vec<_> = out
            .iter()
            .map(|a| (a.name, a.value, &text[a.span.start - 10..a.span.end - 10]))
            .collect();
        assert_eq!(
            spans,
            [("a", "x\"y", " a = 'x\"y'"), ("b:c", "", "\n b:c=\"\"")]
        );
        assert_eq!(out[1].local(), "c");
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
