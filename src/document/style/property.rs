//! The properties and attributes on which the replacement of a shape depends.

/// A set of properties.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in crate::document) struct Properties(u32);

/// The names, each a bit of [`Properties`].
const NAMES: [&str; 23] = [
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "x",
    "y",
    "width",
    "height",
    "d",
    "all",
    "transform",
    "transform-origin",
    "transform-box",
    "translate",
    "rotate",
    "scale",
    "offset",
    "offset-path",
    "marker",
    "marker-start",
    "marker-mid",
    "marker-end",
];

/// The names of sizes along and across the text, old ones of engines included.
const LOGICAL_SIZES: [&str; 6] = [
    "inline-size",
    "block-size",
    "-webkit-logical-width",
    "-webkit-logical-height",
    "-webkit-inline-size",
    "-webkit-block-size",
];

/// Which markers are in effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in crate::document) struct Markers {
    /// Some marker.
    pub(in crate::document) any: bool,
    /// A marker on inner vertices.
    pub(in crate::document) middle: bool,
}

impl Markers {
    pub(in crate::document) const ALL: Self = Self {
        any: true,
        middle: true,
    };

    pub(in crate::document) const fn with(self, other: Self) -> Self {
        Self {
            any: self.any || other.any,
            middle: self.middle || other.middle,
        }
    }
}

impl Properties {
    pub(in crate::document) const NONE: Self = Self(0);
    pub(in crate::document) const D: Self = Self(1 << 9);
    const ALL: Self = Self(1 << 10);
    /// What moves an element, wherever its geometry says it lies.
    pub(in crate::document) const MOVING: Self = Self(0xff << 11);
    const MARKER: u32 = 19;
    const MARKER_MID: u32 = 21;
    /// Every property that is known here: for rules that cannot be read.
    pub(in crate::document) const ANY: Self = Self((1 << NAMES.len()) - 1);

    /// The property of that name (ASCII case does not matter in CSS). Sizes along and across the text are width and height, which
    /// one being a matter of the writing mode.
    pub(in crate::document) fn named(name: &str) -> Self {
        let is = |known: &&str| known.eq_ignore_ascii_case(name);
        if LOGICAL_SIZES.iter().any(is) {
            return Self(1 << 7 | 1 << 8);
        }
        NAMES
            .iter()
            .position(is)
            .map_or(Self::NONE, |bit| Self(1 << bit))
    }

    /// The attribute of that name, whose case matters.
    pub(in crate::document) fn attribute(name: &str) -> Self {
        NAMES
            .iter()
            .position(|known| *known == name)
            .map_or(Self::NONE, |bit| Self(1 << bit))
    }

    pub(in crate::document) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    pub(in crate::document) const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    pub(in crate::document) const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The properties in both sets.
    pub(in crate::document) const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Whether they are markers by name.
    pub(in crate::document) const fn are_markers(self) -> bool {
        self.0 >> Self::MARKER != 0
    }

    /// The markers among the properties; `all` may be any, as `inherit`.
    pub(in crate::document) const fn markers(self) -> Markers {
        let all = self.meets(Self::ALL);
        Markers {
            any: all || self.are_markers(),
            middle: all || self.0 & (1 << Self::MARKER | 1 << Self::MARKER_MID) != 0,
        }
    }

    /// The name of the first property of the set.
    pub(in crate::document) fn first_name(self) -> &'static str {
        NAMES
            .get(self.0.trailing_zeros() as usize)
            .copied()
            .unwrap_or("all")
    }
}

/// What a list of declarations says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in crate::document) struct Effect {
    /// The properties that it sets.
    pub(in crate::document) sets: Properties,
    /// The attributes that it reads with `attr()`.
    pub(in crate::document) reads: Properties,
    /// Whether the last `marker` in it is `none`.
    pub(in crate::document) no_marker: bool,
}

impl Effect {
    pub(in crate::document) const fn with(self, other: Self) -> Self {
        Self {
            sets: self.sets.with(other.sets),
            reads: self.reads.with(other.reads),
            no_marker: self.no_marker || other.no_marker,
        }
    }

    pub(in crate::document) const fn is_empty(self) -> bool {
        self.sets.is_empty() && self.reads.is_empty()
    }
}

/// The kinds of elements that are replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum ElementKind {
    /// `<circle>`
    #[cfg_attr(feature = "cli", value(help = "<circle>"))]
    Circle,
    /// `<ellipse>`
    #[cfg_attr(feature = "cli", value(help = "<ellipse>"))]
    Ellipse,
    /// `<rect>` with round corners
    #[cfg_attr(feature = "cli", value(help = "<rect> with round corners"))]
    Rect,
    /// The arc commands of `<path>`
    #[cfg_attr(feature = "cli", value(help = "Arc commands of <path>"))]
    Path,
}

impl ElementKind {
    /// All kinds, in the order in which they are reported.
    pub const ALL: [Self; 4] = [Self::Circle, Self::Ellipse, Self::Rect, Self::Path];

    /// The name of the element.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Circle => "circle",
            Self::Ellipse => "ellipse",
            Self::Rect => "rect",
            Self::Path => "path",
        }
    }

    /// The kind of the element of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The attributes that hold the geometry.
    pub(in crate::document) const fn geometry(self) -> &'static [&'static str] {
        match self {
            Self::Circle => &["cx", "cy", "r"],
            Self::Ellipse => &["cx", "cy", "rx", "ry"],
            Self::Rect => &["x", "y", "width", "height", "rx", "ry"],
            Self::Path => &["d"],
        }
    }

    /// The attributes that a replacement changes.
    pub(in crate::document) fn attributes(self) -> Properties {
        self.geometry().iter().fold(Properties::D, |set, name| {
            set.with(Properties::attribute(name))
        })
    }

    /// The properties that, set by a style or an animation, forbid a replacement.
    pub(in crate::document) fn sensitive(self) -> Properties {
        self.attributes().with(Properties::ALL)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markers_are_known_by_their_names() {
        assert!(!Properties::named("marker-end").markers().middle);
        assert!(Properties::named("MARKER").markers().middle);
        assert!(!Properties::named("height").markers().any);
        let all = Properties::named("all");
        assert!(all.markers().middle && !all.are_markers());
    }

    #[test]
    fn what_moves_an_element_is_known_by_its_name() {
        for name in ["transform", "Transform-Box", "translate", "offset-path"] {
            let property = Properties::named(name);
            assert!(property.meets(Properties::MOVING) && !property.are_markers());
        }
        for name in ["all", "d", "marker", "text-transform"] {
            assert!(!Properties::named(name).meets(Properties::MOVING), "{name}");
        }
    }

    #[test]
    fn each_kind_minds_its_own_geometry() {
        assert!(
            ElementKind::Circle
                .sensitive()
                .meets(Properties::named("r"))
        );
        assert!(
            !ElementKind::Circle
                .sensitive()
                .meets(Properties::named("rx"))
        );
        assert!(
            ElementKind::Path
                .sensitive()
                .meets(Properties::named("all"))
        );
        assert_eq!(
            ElementKind::Rect
                .sensitive()
                .and(Properties::named("rx"))
                .first_name(),
            "rx"
        );
    }

    #[test]
    fn a_logical_size_is_either_size() {
        let both = Properties::named("width").with(Properties::named("height"));
        assert_eq!(Properties::named("Inline-Size"), both);
        assert_eq!(Properties::named("block-size"), both);
        assert!(Properties::named("size").is_empty());
    }
}
