//! A document as nodes with exact byte spans. quick-xml finds the tokens; names, attributes, namespaces and what it does not check
//! about well-formedness are read here.

use core::ops::Range;
use std::borrow::Cow;

use quick_xml::Reader;
use quick_xml::events::Event;

use super::attributes::{self, Attribute};
use super::doctype::{Doctype, Resolved};
use super::fault::{Fault, Result};
use super::namespace::{Namespace, Namespaces};
use super::value;

/// One piece of a document.
#[derive(Debug)]
pub(super) enum Node<'a> {
    /// A start tag or an empty element; its attributes are in [`Scanner::attributes`].
    Start(Element<'a>),
    /// An end tag; for an empty element there is none.
    End {
        /// The local name in the end tag.
        local: Range<usize>,
    },
    /// Character data, and where they begin.
    Text(&'a str),
    /// A reference in the content: what it stands for.
    Reference(Resolved),
    /// A processing instruction without its `<?` and `?>`.
    Instruction(&'a str),
    /// Anything without a meaning here: comments, the declaration, the DOCTYPE.
    Other,
    /// The end of the document.
    Done,
}

/// A start tag.
#[derive(Debug, Clone)]
pub(super) struct Element<'a> {
    /// The byte of its `<`.
    pub(super) start: usize,
    /// The name with its prefix.
    pub(super) name: &'a str,
    /// The name without a prefix.
    pub(super) local: &'a str,
    pub(super) local_span: Range<usize>,
    pub(super) namespace: Namespace,
    /// Whether the tag ends in `/>`.
    pub(super) empty: bool,
}

/// Reads the nodes of a document in order.
pub(super) struct Scanner<'a> {
    /// The whole document, with its byte order mark.
    pub(super) source: &'a str,
    /// The attributes of the last start tag.
    pub(super) attributes: Vec<Attribute<'a>>,
    pub(super) doctype: Doctype<'a>,
    reader: Reader<&'a [u8]>,
    /// The length of the byte order mark.
    base: usize,
    namespaces: Namespaces<'a>,
    /// The start of every open tag.
    open: Vec<usize>,
    seen_root: bool,
}

impl<'a> Scanner<'a> {
    /// A scanner at the start of `source`.
    pub(super) fn new(source: &'a str) -> Result<Self> {
        let body = source.strip_prefix('\u{feff}').unwrap_or(source);
        let base = source.len() - body.len();
        if let Some(at) = forbidden_character(body) {
            return Err(Fault::new(base + at, "a character that XML does not allow"));
        }
        let mut reader = Reader::from_str(body);
        reader.config_mut().check_comments = true;
        Ok(Self {
            source,
            attributes: Vec::with_capacity(16),
            doctype: Doctype::default(),
            reader,
            base,
            namespaces: Namespaces::default(),
            open: Vec::with_capacity(16),
            seen_root: false,
        })
    }

    /// How many elements are open.
    pub(super) fn depth(&self) -> usize {
        self.open.len()
    }

    /// The start of the innermost open tag.
    pub(super) fn parent(&self) -> Option<usize> {
        self.open.last().copied()
    }

    /// The start of the tag around the innermost open one.
    pub(super) fn grandparent(&self) -> Option<usize> {
        self.open.iter().rev().nth(1).copied()
    }

    /// The resolved value of an attribute of the last start tag; a value with an unknown entity reads as the entity.
    pub(super) fn attribute(&self, name: &str) -> Option<Cow<'a, str>> {
        let found = self
            .attributes
            .iter()
            .find(|attribute| attribute.name == name)?;
        Some(value::text(found.value, &self.doctype).unwrap_or(Cow::Borrowed(found.value)))
    }

    /// The next node.
    pub(super) fn next(&mut self) -> Result<Node<'a>> {
        let start = self.base + self.reader.buffer_position() as usize;
        let event = self.reader.read_event().map_err(|error| {
            let at = self.base + self.reader.error_position() as usize;
            Fault::new(at, error.to_string())
        })?;
        let end = self.base + self.reader.buffer_position() as usize;
        let span = self.source.get(start..end).unwrap_or_default();
        match event {
            Event::Start(_) => self.start(start, span, false),
            Event::Empty(_) => self.start(start, span, true),
            Event::End(_) => Ok(self.end(start, span)),
            Event::Text(_) => self.text(start, span),
            Event::CData(_) if self.open.is_empty() => {
                Err(Fault::new(start, "text outside the root element"))
            }
            Event::CData(_) => Ok(Node::Text(
                span.strip_prefix("<![CDATA[")
                    .and_then(|s| s.strip_suffix("]]>"))
                    .unwrap_or_default(),
            )),
            Event::GeneralRef(_) => self.reference(start, span),
            Event::PI(_) => Self::instruction(start, span),
            Event::Decl(_) => self.declaration(start, span),
            Event::DocType(_) => self.document_type(start, span),
            Event::Comment(_) => Ok(Node::Other),
            Event::Eof => self.finish(),
        }
    }

    fn start(&mut self, start: usize, span: &'a str, empty: bool) -> Result<Node<'a>> {
        if self.open.is_empty() && self.seen_root {
            return Err(Fault::new(start, "a second root element"));
        }
        self.seen_root = true;
        let inner = &span[1..span.len() - if empty { 2 } else { 1 }];
        let length = inner
            .bytes()
            .position(|b| b.is_ascii_whitespace())
            .unwrap_or(inner.len());
        let name = &inner[..length];
        if !attributes::is_name(name) {
            return Err(Fault::new(
                start,
                format!("`<{name}` is not the name of an element"),
            ));
        }
        attributes::read(&inner[length..], start + 1 + length, &mut self.attributes)?;
        self.check_references()?;
        let root = self.open.is_empty();
        self.namespaces
            .enter(self.open.len(), &self.attributes, &self.doctype);
        let prefix = name.find(':').unwrap_or(0);
        let skip = if prefix == 0 { 0 } else { prefix + 1 };
        let local = &name[skip..];
        let namespace = self.namespaces.of_element(&name[..prefix], local, root);
        if empty {
            self.namespaces.leave(self.open.len());
        } else {
            self.open.push(start);
        }
        let local_start = start + 1 + skip;
        Ok(Node::Start(Element {
            start,
            name,
            local,
            local_span: local_start..local_start + local.len(),
            namespace,
            empty,
        }))
    }

    /// Refuses bare ampersands and references that are not declared.
    fn check_references(&self) -> Result<()> {
        for attribute in self
            .attributes
            .iter()
            .filter(|attribute| attribute.has_references)
        {
            let mut at = attribute.value_span.start;
            let mut rest = attribute.value;
            while let Some(ampersand) = rest.find('&') {
                at += ampersand;
                rest = &rest[ampersand + 1..];
                let Some(name) = rest.find(';').map(|end| &rest[..end]) else {
                    return Err(Fault::new(at, "`&` without a `;`"));
                };
                if !self.doctype.declares(name) {
                    return Err(Fault::new(
                        at,
                        format!("the reference `&{name};` is not declared"),
                    ));
                }
                at += 1;
            }
        }
        Ok(())
    }

    fn end(&mut self, start: usize, span: &'a str) -> Node<'a> {
        self.open.pop();
        self.namespaces.leave(self.open.len());
        let name = span
            .trim_start_matches("</")
            .trim_end_matches('>')
            .trim_end();
        let skip = name.find(':').map_or(0, |colon| colon + 1);
        Node::End {
            local: start + 2 + skip..start + 2 + name.len(),
        }
    }

    fn text(&self, start: usize, span: &'a str) -> Result<Node<'a>> {
        let blank = |text: &str| {
            text.bytes()
                .all(|b| matches!(b, b' ' | b'\t' | b'\n' | b'\r'))
        };
        if self.open.is_empty() && !blank(span) {
            return Err(Fault::new(
                start + (span.len() - span.trim_start().len()),
                "text outside the root element",
            ));
        }
        if memchr::memchr(b']', span.as_bytes()).is_some()
            && let Some(at) = span.find("]]>")
        {
            return Err(Fault::new(start + at, "`]]>` in text"));
        }
        Ok(Node::Text(span))
    }

    fn reference(&self, start: usize, span: &'a str) -> Result<Node<'a>> {
        let name = span.trim_start_matches('&').trim_end_matches(';');
        match self.doctype.resolve(name) {
            Resolved::Malformed => Err(Fault::new(
                start,
                format!("the reference `&{name};` is not declared"),
            )),
            _ if self.open.is_empty() => Err(Fault::new(start, "text outside the root element")),
            resolved => Ok(Node::Reference(resolved)),
        }
    }

    fn instruction(start: usize, span: &'a str) -> Result<Node<'a>> {
        let inner = span
            .strip_prefix("<?")
            .and_then(|s| s.strip_suffix("?>"))
            .unwrap_or_default();
        let target = inner
            .split(|c: char| c.is_ascii_whitespace())
            .next()
            .unwrap_or_default();
        if !attributes::is_name(target) || target.eq_ignore_ascii_case("xml") {
            return Err(Fault::new(
                start,
                format!("`<?{target}` is not a processing instruction"),
            ));
        }
        Ok(Node::Instruction(inner))
    }

    fn declaration(&mut self, start: usize, span: &'a str) -> Result<Node<'a>> {
        if start != self.base {
            return Err(Fault::new(
                start,
                "the XML declaration does not stand at the very start",
            ));
        }
        let inner = span
            .strip_prefix("<?xml")
            .and_then(|s| s.strip_suffix("?>"))
            .unwrap_or_default();
        attributes::read(inner, start + 5, &mut self.attributes)?;
        if self
            .attributes
            .first()
            .is_none_or(|attribute| attribute.name != "version")
        {
            return Err(Fault::new(
                start,
                "the XML declaration does not begin with a version",
            ));
        }
        if let Some(encoding) = self
            .attributes
            .iter()
            .find(|attribute| attribute.name == "encoding")
            && !["utf-8", "utf8", "us-ascii", "ascii"]
                .iter()
                .any(|known| known.eq_ignore_ascii_case(encoding.value))
        {
            return Err(Fault::encoding(encoding.value_span.start, encoding.value));
        }
        Ok(Node::Other)
    }

    fn document_type(&mut self, start: usize, span: &'a str) -> Result<Node<'a>> {
        if self.seen_root {
            return Err(Fault::new(
                start,
                "a DOCTYPE behind the root element's start",
            ));
        }
        let inner = span
            .get("<!DOCTYPE".len()..span.len().saturating_sub(1))
            .unwrap_or_default();
        self.doctype = Doctype::read(inner, self.source.len());
        Ok(Node::Other)
    }

    fn finish(&self) -> Result<Node<'a>> {
        if let Some(&start) = self.open.last() {
            let name: String = self.source[start + 1..]
                .chars()
                .take_while(|c| !c.is_whitespace() && !matches!(c, '/' | '>'))
                .collect();
            return Err(Fault::new(start, format!("`<{name}>` is never closed")));
        }
        if !self.seen_root {
            return Err(Fault::new(self.source.len(), "no element"));
        }
        Ok(Node::Done)
    }
}

/// The first character that XML 1.0 forbids.
fn forbidden_character(text: &str) -> Option<usize> {
    // One branch-free pass; the place is looked for only where there is one.
    let control = |b: u8| b < 0x20 && b != b'\t' && b != b'\n' && b != b'\r';
    let some = text
        .as_bytes()
        .iter()
        .fold(false, |some, &b| some | control(b));
    if some {
        return text.bytes().position(control);
    }
    memchr::memmem::find(text.as_bytes(), b"\xef\xbf\xbe")
        .or_else(|| memchr::memmem::find(text.as_bytes(), b"\xef\xbf\xbf"))
}
