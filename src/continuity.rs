//! How smoothly two curves join.

use core::fmt;

/// How two pieces join.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Continuity {
    /// They do not meet, or there is no such pair.
    #[cfg_attr(feature = "serde", serde(rename = "none"))]
    Apart,
    /// They meet at an angle.
    G0,
    /// They share a tangent.
    G1,
    /// They share the curvature too.
    G2,
    /// They share the curvature's first derivative by arc length too.
    G3,
    /// They share the curvature's first two derivatives by arc length too.
    G4,
}

impl fmt::Display for Continuity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Apart => "none",
            Self::G0 => "G0",
            Self::G1 => "G1",
            Self::G2 => "G2",
            Self::G3 => "G3",
            Self::G4 => "G4",
        })
    }
}
