//! What may be set aside by someone who knows the document.

/// A doubt that holds elements back: what the document says elsewhere may depend on them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Doubt {
    /// A style sheet that is not in the file.
    ExternalStyle,
    /// A script or an event handler.
    Script,
    /// An entity in the content that holds markup.
    EntityContent,
    /// A rule that may select by name, type or a geometry attribute.
    StyleSelector,
    /// A style that may set or read the geometry.
    StyleGeometry,
    /// An animation of the geometry.
    Animation,
    /// A marker on a shape that is no path.
    Marker,
    /// A motion along it.
    MotionPath,
    /// Attributes that the DTD declares.
    AttributeDefaults,
    /// A marker on inner vertices.
    MarkerMid,
    /// An arc without extent that a cap or a marker may show.
    EmptyArc,
    /// A large arc whose ends are one point in single precision.
    NearlyWhole,
}

impl Doubt {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::ExternalStyle,
        Self::Script,
        Self::EntityContent,
        Self::StyleSelector,
        Self::StyleGeometry,
        Self::Animation,
        Self::Marker,
        Self::MotionPath,
        Self::AttributeDefaults,
        Self::MarkerMid,
        Self::EmptyArc,
        Self::NearlyWhole,
    ];

    /// The code of the reasons for which it stands.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::ExternalStyle => "external-style",
            Self::Script => "script",
            Self::EntityContent => "entity-content",
            Self::StyleSelector => "style-selector",
            Self::StyleGeometry => "style-geometry",
            Self::Animation => "animation",
            Self::Marker => "marker",
            Self::MotionPath => "motion-path",
            Self::AttributeDefaults => "attribute-defaults",
            Self::MarkerMid => "marker-mid",
            Self::EmptyArc => "empty-arc",
            Self::NearlyWhole => "nearly-whole",
        }
    }

    /// The doubt of that code.
    #[must_use]
    pub fn coded(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|doubt| doubt.code() == code)
    }
}

/// The doubts that are set aside: none by default.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Trust([bool; Doubt::ALL.len()]);

impl Trust {
    /// The doubts given.
    #[must_use]
    pub fn of(doubts: &[Doubt]) -> Self {
        Self(Doubt::ALL.map(|doubt| doubts.contains(&doubt)))
    }

    /// Whether this doubt is set aside.
    #[must_use]
    pub const fn contains(&self, doubt: Doubt) -> bool {
        self.0[doubt as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_lead_back() {
        for doubt in Doubt::ALL {
            assert_eq!(Doubt::coded(doubt.code()), Some(doubt));
            assert!(Trust::of(&[doubt]).contains(doubt) && !Trust::default().contains(doubt));
        }
        assert_eq!(Doubt::coded("length"), None);
    }
}
