//! What is said about something that was left.

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::Reason;

/// Something that was left as it is. A document may have as many notes as elements, so each is small.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// The name of the element.
    pub element: &'static str,
    /// Why it was left.
    pub reason: Reason,
}

/// The reason as its `code` and in words, `reason`.
impl Serialize for Note {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut note = serializer.serialize_struct("Note", 5)?;
        note.serialize_field("line", &self.line)?;
        note.serialize_field("column", &self.column)?;
        note.serialize_field("element", self.element)?;
        note.serialize_field("code", self.reason.code())?;
        note.serialize_field("reason", &ReasonText(&self.reason))?;
        note.end()
    }
}

struct ReasonText<'a>(&'a Reason);

impl Serialize for ReasonText<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self.0)
    }
}
