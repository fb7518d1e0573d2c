//! An error at a byte, before it is told as line and column.

/// The result of reading.
pub(super) type Result<T> = core::result::Result<T, Fault>;

/// Why reading stopped, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) at: usize,
    pub(super) kind: FaultKind,
}

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum FaultKind {
    /// Not well-formed.
    Malformed(String),
    /// An encoding other than UTF-8.
    Encoding(String),
}

impl Fault {
    pub(super) fn new(at: usize, why: impl Into<String>) -> Self {
        Self {
            at,
            kind: FaultKind::Malformed(why.into()),
        }
    }

    pub(super) fn encoding(at: usize, name: &str) -> Self {
        Self {
            at,
            kind: FaultKind::Encoding(name.to_owned()),
        }
    }
}
