//! What a document is made of.

use core::ops::Range;

use super::doctype::Resolved;
use super::namespace::Namespace;

/// One piece of a document.
#[derive(Debug)]
pub(in crate::document) enum Node<'a> {
    /// A start tag or an empty element; its attributes are in the scanner's `attributes`.
    Start(Element<'a>),
    /// An end tag; for an empty element there is none.
    End {
        /// The local name in the end tag.
        local: Range<usize>,
    },
    /// Character data, and where they begin.
    Text(&'a str),
    /// A reference in the content: where its `&` is, and what it stands for.
    Reference(usize, Resolved),
    /// A processing instruction without its `<?` and `?>`.
    Instruction(&'a str),
    /// Anything without a meaning here: comments, the declaration, the DOCTYPE.
    Other,
    /// The end of the document.
    Done,
}

/// A start tag.
#[derive(Debug, Clone)]
pub(in crate::document) struct Element<'a> {
    /// The byte of its `<`.
    pub(in crate::document) start: usize,
    /// The name with its prefix.
    pub(in crate::document) name: &'a str,
    /// The name without a prefix.
    pub(in crate::document) local: &'a str,
    pub(in crate::document) local_span: Range<usize>,
    pub(in crate::document) namespace: Namespace,
    /// Whether the tag ends in `/>`.
    pub(in crate::document) empty: bool,
    /// The index of the attribute that is its link, if it is one of [`Element::LINKING`].
    pub(in crate::document) link: Option<usize>,
    /// The index of its path data, or of the name of the property that it animates, if it is an element of an Android drawable.
    pub(in crate::document) android: Option<usize>,
}

impl Element<'_> {
    /// The elements that mean another one by a link.
    pub(in crate::document) const LINKING: [&'static str; 5] =
        ["use", "animate", "set", "animateColor", "mpath"];
}
