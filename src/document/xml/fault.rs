//! An error at a byte, before it is told as line and column.

/// The result of reading.
pub(in crate::document) type XmlResult<T> = core::result::Result<T, XmlFault>;

/// Why reading stopped, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::document) struct XmlFault {
    pub(in crate::document) at: usize,
    pub(in crate::document) kind: FaultKind,
}

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::document) enum FaultKind {
    /// Not well-formed.
    Malformed(String),
    /// An encoding other than UTF-8.
    Encoding(String),
    /// The new text became too large.
    TooLarge,
}

impl XmlFault {
    pub(in crate::document) fn new(at: usize, why: impl Into<String>) -> Self {
        Self {
            at,
            kind: FaultKind::Malformed(why.into()),
        }
    }

    pub(in crate::document) const fn too_large(at: usize) -> Self {
        Self {
            at,
            kind: FaultKind::TooLarge,
        }
    }

    pub(in crate::document) fn encoding(at: usize, name: &str) -> Self {
        Self {
            at,
            kind: FaultKind::Encoding(name.to_owned()),
        }
    }
}
