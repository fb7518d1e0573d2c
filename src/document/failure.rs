//! Why a document cannot be converted.

use thiserror::Error;

use super::xml::fault::{FaultKind, XmlFault};
use super::xml::place::Places;

/// Why a document cannot be converted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// The document is not well-formed XML.
    #[error("{line}:{column}: not well-formed XML: {why}")]
    Malformed {
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// What is wrong.
        why: String,
    },
    /// The document declares or uses an encoding other than UTF-8.
    #[error(
        "{line}:{column}: the encoding is {encoding}, which is not read: convert the file to UTF-8, and have its declaration, if there is one, say encoding=\"UTF-8\""
    )]
    Encoding {
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// The encoding as declared or found.
        encoding: String,
    },
    /// The result would be larger than is served.
    #[error("{line}:{column}: from here on the result would be larger than 1 GiB")]
    TooLarge {
        /// The line, from 1, of the element with which it becomes so large.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
    },
}

impl Error {
    pub(super) fn new(source: &str, fault: XmlFault) -> Self {
        let (line, column) = Places::new(source).locate(fault.at);
        match fault.kind {
            FaultKind::Malformed(why) => Self::Malformed { line, column, why },
            FaultKind::TooLarge => Self::TooLarge { line, column },
            FaultKind::Encoding(encoding) => Self::Encoding {
                line,
                column,
                encoding,
            },
        }
    }
}
