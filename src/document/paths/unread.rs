//! What is not read of an SVG file.

use core::fmt;

use crate::error::TextError;

/// What is not read of an SVG file, and may change what its paths draw or where.
#[derive(Debug, Clone, PartialEq)]
pub enum Unread {
    /// A style sheet in it sets this property.
    StyleSheet(&'static str),
    /// A style sheet lies elsewhere, or imports one that does.
    ExternalStyle,
    /// It draws elements again by `use`: they are read where they are defined.
    Uses,
    /// An entity in its content, which may hold elements.
    Entity(TextError),
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StyleSheet(property) => {
                write!(
                    f,
                    "a style sheet sets {property}; style sheets are not applied"
                )
            }
            Self::ExternalStyle => {
                f.write_str("a style sheet lies in another file; style sheets are not applied")
            }
            Self::Uses => {
                f.write_str("<use> is not followed; what it draws is read where it is defined")
            }
            Self::Entity(why) => write!(f, "{why}: what it holds is not read"),
        }
    }
}
