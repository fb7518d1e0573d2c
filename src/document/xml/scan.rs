//! A document as nodes with exact byte spans, and what makes it well-formed.
//!
//! Icons are short and full of tags, so that tags, text and comments are read here in one pass each; quick-xml finds the ends of
//! everything else that begins with `<!` or `<?`.

use std::borrow::Cow;

use quick_xml::Reader;
use quick_xml::events::Event;

use super::attributes::{self, Attribute, after_space, named};
use super::characters::{self, BYTE_ORDER_MARK, first_forbidden};
use super::doctype::{Doctype, Resolved};
use super::encoding::{SourceText, folded};
use super::fault::{XmlFault, XmlResult};
use super::namespace::Namespaces;
use super::node::{Element, Node};
use super::value;

/// A start tag whose end tag has not come.
#[derive(Debug, Clone, Copy)]
struct OpenTag<'a> {
    /// The byte of its `<`.
    start: usize,
    /// The name with its prefix.
    name: &'a str,
}

/// Reads the nodes of a document in order.
pub(in crate::document) struct Scanner<'a> {
    /// The whole document, with its byte order mark.
    pub(in crate::document) source: &'a str,
    /// Whether it stands for bytes in the encoding that it declares.
    pub(in crate::document) is_widened: bool,
    /// The attributes of the last start tag.
    pub(in crate::document) attributes: Vec<Attribute<'a>>,
    pub(in crate::document) doctype: Doctype,
    /// The byte where the next node begins.
    at: usize,
    namespaces: Namespaces<'a>,
    open: Vec<OpenTag<'a>>,
    seen_root: bool,
}

impl<'a> Scanner<'a> {
    /// A scanner at the start of `source`.
    pub(in crate::document) fn new(source: SourceText<'a>) -> XmlResult<Self> {
        let SourceText {
            text: source,
            is_widened,
        } = source;
        if let Some(at) = first_forbidden(source) {
            return Err(XmlFault::new(at, "a character that XML does not allow"));
        }
        Ok(Self {
            source,
            is_widened,
            attributes: Vec::with_capacity(16),
            doctype: Doctype::default(),
            at: if source.starts_with(BYTE_ORDER_MARK) {
                BYTE_ORDER_MARK.len_utf8()
            } else {
                0
            },
            namespaces: Namespaces::default(),
            open: Vec::with_capacity(16),
            seen_root: false,
        })
    }

    /// How many elements are open.
    pub(in crate::document) fn depth(&self) -> usize {
        self.open.len()
    }

    /// The start of the innermost open tag.
    pub(in crate::document) fn parent(&self) -> Option<usize> {
        self.open.last().map(|open| open.start)
    }

    /// The start of the tag around the innermost open one.
    pub(in crate::document) fn grandparent(&self) -> Option<usize> {
        self.open.iter().rev().nth(1).map(|open| open.start)
    }

    /// The resolved value of an attribute of the last start tag, as names are compared; a value with an unknown entity reads as the
    /// entity.
    pub(in crate::document) fn attribute(&self, name: &str) -> Option<Cow<'a, str>> {
        let found = named(&self.attributes, name)?;
        let text = value::text(found.value, &self.doctype).unwrap_or(Cow::Borrowed(found.value));
        Some(self.comparable(text))
    }

    /// A name as names are compared in this document.
    pub(in crate::document) fn comparable<'t>(&self, name: Cow<'t, str>) -> Cow<'t, str> {
        if self.is_widened && !name.is_ascii() {
            return folded(&name).into();
        }
        name
    }

    /// The id to which the link of the last start tag refers; `None` where it has no link, or one without a fragment.
    pub(in crate::document) fn linked_id(&self, element: &Element<'_>) -> Option<String> {
        let attribute = self.attributes.get(element.link?)?;
        let text = value::text(attribute.value, &self.doctype)?;
        self.id_of(&text)
    }

    /// The id in the fragment of a URL. Which document it means is not known here, so that each may mean this one.
    pub(in crate::document) fn id_of(&self, url: &str) -> Option<String> {
        let (_, fragment) = url.trim().split_once('#')?;
        let id = characters::percent_decoded(fragment);
        Some(self.comparable(id.into()).into_owned())
    }

    /// The next node.
    pub(in crate::document) fn next(&mut self) -> XmlResult<Node<'a>> {
        let start = self.at;
        match self.source.as_bytes().get(start..).unwrap_or_default() {
            [] => self.finish(),
            [b'<', b'/', ..] => self.end(start),
            [b'<', b'!', b'-', b'-', ..] => self.comment(start),
            [b'<', b'!' | b'?', ..] => self.markup(start),
            [b'<', ..] => self.start(start),
            [b'&', ..] => self.reference(start),
            _ => self.text(start),
        }
    }

    fn start(&mut self, start: usize) -> XmlResult<Node<'a>> {
        if self.open.is_empty() && self.seen_root {
            return Err(XmlFault::new(start, "a second root element"));
        }
        self.seen_root = true;
        let name = attributes::name(self.source, start + 1).ok_or_else(|| {
            let rest = &self.source[start + 1..];
            let end = rest.find(|c: char| c.is_ascii_whitespace() || matches!(c, '/' | '>'));
            let name = &rest[..end.unwrap_or(rest.len())];
            XmlFault::new(start, format!("`<{name}` is not the name of an element"))
        })?;
        let end = attributes::read(self.source, start + 1 + name.len(), &mut self.attributes)?;
        let empty = match self.source.as_bytes().get(end..) {
            Some([b'>', ..]) => false,
            Some([b'/', b'>', ..]) => true,
            Some([_, ..]) => return Err(XmlFault::new(end, "this is not an attribute")),
            _ => {
                return Err(XmlFault::new(
                    start,
                    format!("the tag `<{name}` has no end"),
                ));
            }
        };
        self.at = end + if empty { 2 } else { 1 };
        self.check_references()?;
        let root = self.open.is_empty();
        self.namespaces
            .enter(self.open.len(), &self.attributes, &self.doctype);
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        let namespace = self.namespaces.of_element(prefix, local, root);
        let link = Element::LINKING
            .contains(&local)
            .then(|| self.namespaces.link(&self.attributes))
            .flatten();
        let android = self.namespaces.android(&self.attributes);
        if empty {
            self.namespaces.leave(self.open.len());
        } else {
            self.open.push(OpenTag { start, name });
        }
        let name_end = start + 1 + name.len();
        Ok(Node::Start(Element {
            start,
            name,
            local,
            local_span: name_end - local.len()..name_end,
            namespace,
            empty,
            link,
            android,
        }))
    }

    /// Refuses bare ampersands and references that are not declared.
    fn check_references(&self) -> XmlResult<()> {
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
                    return Err(XmlFault::new(at, "`&` without a `;`"));
                };
                if let Some(why) = self.doctype.refuses(name) {
                    return Err(XmlFault::new(at, refused(name, why)));
                }
                at += 1;
            }
        }
        Ok(())
    }

    fn end(&mut self, start: usize) -> XmlResult<Node<'a>> {
        let bytes = self.source.as_bytes();
        let rest = &self.source[start + 2..];
        let open = self.open.pop();
        let close = open
            .filter(|open| rest.starts_with(open.name))
            .map(|open| after_space(bytes, start + 2 + open.name.len()))
            .filter(|close| bytes.get(*close) == Some(&b'>'));
        let (Some(open), Some(close)) = (open, close) else {
            let name = &rest[..rest.find('>').unwrap_or(rest.len())];
            let why = match open {
                Some(open) => format!("`</{name}>` where `</{}>` should stand", open.name),
                None => format!("`</{name}>` closes nothing"),
            };
            return Err(XmlFault::new(start, why));
        };
        self.namespaces.leave(self.open.len());
        self.at = close + 1;
        let skip = open.name.find(':').map_or(0, |colon| colon + 1);
        let name = start + 2;
        Ok(Node::End {
            local: name + skip..name + open.name.len(),
        })
    }

    fn text(&mut self, start: usize) -> XmlResult<Node<'a>> {
        // Mostly white space alone stands between tags.
        let blank = after_space(self.source.as_bytes(), start);
        if let None | Some(b'<') = self.source.as_bytes().get(blank) {
            self.at = blank;
            return Ok(Node::Text(&self.source[start..blank]));
        }
        if self.open.is_empty() {
            return Err(XmlFault::new(blank, "text outside the root element"));
        }
        let rest = &self.source[start..];
        let length = memchr::memchr2(b'<', b'&', rest.as_bytes()).unwrap_or(rest.len());
        let text = &rest[..length];
        if let Some(at) = text.find("]]>") {
            return Err(XmlFault::new(start + at, "`]]>` in text"));
        }
        self.at = start + length;
        Ok(Node::Text(text))
    }

    fn comment(&mut self, start: usize) -> XmlResult<Node<'a>> {
        let inner = start + "<!--".len();
        let Some(length) = self.source[inner..].find("--") else {
            return Err(XmlFault::new(start, "a comment without an end"));
        };
        let end = inner + length + "--".len();
        if self.source.as_bytes().get(end) != Some(&b'>') {
            return Err(XmlFault::new(inner + length, "`--` in a comment"));
        }
        self.at = end + 1;
        Ok(Node::Other)
    }

    /// What else begins with `<!` or `<?`.
    fn markup(&mut self, start: usize) -> XmlResult<Node<'a>> {
        let mut reader = Reader::from_str(&self.source[start..]);
        let event = reader.read_event();
        let event = event.map_err(|error| XmlFault::new(start, error.to_string()))?;
        let end = start + reader.buffer_position() as usize;
        self.at = end;
        let span = self.source.get(start..end).unwrap_or_default();
        match event {
            Event::CData(_) if self.open.is_empty() => {
                Err(XmlFault::new(start, "text outside the root element"))
            }
            Event::CData(_) => Ok(Node::Text(
                span.strip_prefix("<![CDATA[")
                    .and_then(|s| s.strip_suffix("]]>"))
                    .unwrap_or_default(),
            )),
            Event::PI(_) => Self::instruction(start, span),
            Event::Decl(_) => self.declaration(start, span),
            Event::DocType(_) => self.document_type(start, span),
            _ => Err(XmlFault::new(start, "this is no markup of XML")),
        }
    }

    fn reference(&mut self, start: usize) -> XmlResult<Node<'a>> {
        let rest = &self.source[start + 1..];
        let Some(name) = rest.find([';', '<', '&']).map(|end| &rest[..end]) else {
            return Err(XmlFault::new(start, "`&` without a `;`"));
        };
        if rest.as_bytes().get(name.len()) != Some(&b';') {
            return Err(XmlFault::new(start, "`&` without a `;`"));
        }
        self.at = start + 1 + name.len() + 1;
        match self.doctype.resolve(name) {
            Resolved::Malformed => {
                let why = self.doctype.refuses(name).unwrap_or_default();
                Err(XmlFault::new(start, refused(name, why)))
            }
            _ if self.open.is_empty() => Err(XmlFault::new(start, "text outside the root element")),
            resolved => Ok(Node::Reference(start, resolved)),
        }
    }

    fn instruction(start: usize, span: &'a str) -> XmlResult<Node<'a>> {
        let inner = span
            .strip_prefix("<?")
            .and_then(|s| s.strip_suffix("?>"))
            .unwrap_or_default();
        let target = inner
            .split(|c: char| c.is_ascii_whitespace())
            .next()
            .unwrap_or_default();
        if attributes::name(target, 0) != Some(target) || target.eq_ignore_ascii_case("xml") {
            return Err(XmlFault::new(
                start,
                format!("`<?{target}` is not a processing instruction"),
            ));
        }
        Ok(Node::Instruction(inner))
    }

    fn declaration(&mut self, start: usize, span: &'a str) -> XmlResult<Node<'a>> {
        if !matches!(&self.source[..start], "" | "\u{feff}") {
            return Err(XmlFault::new(
                start,
                "the XML declaration does not stand at the very start",
            ));
        }
        let end = attributes::read(self.source, start + "<?xml".len(), &mut self.attributes)?;
        if end + "?>".len() != start + span.len() {
            return Err(XmlFault::new(end, "this is not an attribute"));
        }
        if self
            .attributes
            .first()
            .is_none_or(|attribute| attribute.name != "version")
        {
            return Err(XmlFault::new(
                start,
                "the XML declaration does not begin with a version",
            ));
        }
        if !self.is_widened
            && let Some(encoding) = named(&self.attributes, "encoding")
            && !["utf-8", "utf8", "us-ascii", "ascii"]
                .iter()
                .any(|known| known.eq_ignore_ascii_case(encoding.value))
        {
            return Err(XmlFault::encoding(
                encoding.value_span.start,
                encoding.value,
            ));
        }
        Ok(Node::Other)
    }

    fn document_type(&mut self, start: usize, span: &'a str) -> XmlResult<Node<'a>> {
        if self.seen_root {
            return Err(XmlFault::new(
                start,
                "a DOCTYPE after the root element's start",
            ));
        }
        let inner = span
            .get("<!DOCTYPE".len()..span.len().saturating_sub(1))
            .unwrap_or_default();
        self.doctype = Doctype::read(inner, self.source.len());
        Ok(Node::Other)
    }

    fn finish(&self) -> XmlResult<Node<'a>> {
        if let Some(open) = self.open.last() {
            let why = format!("`<{}>` is never closed", open.name);
            return Err(XmlFault::new(open.start, why));
        }
        if !self.seen_root {
            return Err(XmlFault::new(self.source.len(), "no element"));
        }
        Ok(Node::Done)
    }
}

/// Why a reference is refused.
fn refused(name: &str, why: &str) -> String {
    format!("the reference `&{name};` {why}")
}
