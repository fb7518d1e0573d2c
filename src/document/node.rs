//! What a document is made of.

use core::ops::Range;

use super::doctype::Resolved;
use super::namespace::Namespace;

/// One piece of a document.
#[derive(Debug)]
pub(super) enum Node<'a> {
    /// A start tag or an empty element; its attributes are in the scanner's `attributes`.
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
    /// The index of the attribute that is its link, if it is one of [`Element::LINKING`].
    pub(super) link: Option<usize>,
    /// The index of its path data, or of the name of the property that it animates, if it is an element of an Android drawable.
    pub(super) android: Option<usize>,
}

impl Element<'_> {
    /// The elements that mean another one by a link.
    pub(super) const LINKING: [&'static str; 5] =
        ["use", "animate", "set", "animateColor", "mpath"];
}
