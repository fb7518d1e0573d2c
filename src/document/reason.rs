//! Why an element or an arc is left as it is.

use core::fmt;

use super::doubt::{Doubt, Trust};

/// Why something is left; [`Reason::code`] is the short form for programs.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// An external or imported style sheet may select it by name or set its geometry.
    ExternalStyle,
    /// A script or an event handler may address it.
    Script,
    /// The text of an entity is in another file or expands too far, and may be that of a script.
    UnreadEntity,
    /// An entity in the content may hold markup or style that is not in the text itself.
    EntityContent,
    /// A style rule may select by element name, by type or by a geometry attribute.
    SelectedByName(String),
    /// A style may set this property.
    StyleGeometry(&'static str),
    /// A style may read this attribute with `attr()`.
    StyleReads(&'static str),
    /// An animation changes this attribute.
    Animated(&'static str),
    /// A marker is in effect, which a path may draw where this shape did not.
    Marker,
    /// An object moves along it and counts its vertices.
    MotionPath,
    /// The DTD declares default attributes for this element or for `path`.
    AttributeDefaults,
    /// The attribute is not a length in user units.
    Length {
        /// The attribute.
        attribute: &'static str,
        /// Its value.
        value: String,
    },
    /// Nothing is drawn.
    NotDrawn(String),
    /// The value depends on an entity.
    Entity,
    /// A marker stands on every vertex: no vertex may be added.
    MarkerOnVertices,
    /// A marker stands on every vertex: no vertex may go.
    MarkerOnRun,
    /// The arc ends where it starts, and caps, markers or the next command may show it.
    EmptyArc,
    /// The arc's ends are one point in single precision, and some renderers draw nothing where others draw all of it.
    NearlyWhole,
    /// The path data have an error; renderers stop there.
    PathError,
    /// The path data have an error between this arc and a smooth command.
    PathErrorAfterArc,
    /// The coordinates are too large for arithmetic to stay exact.
    TooLarge,
    /// The precision asked for would collapse it.
    Collapses,
    /// The method refuses it.
    Refused(String),
    /// Path data with arcs in an attribute that is not a path's `d`.
    Elsewhere(&'static str),
    /// A whole shape that stays a path.
    StaysPath(&'static str),
}

impl Reason {
    /// The doubt that it stands for, if it is one that may be set aside.
    #[must_use]
    pub const fn doubt(&self) -> Option<Doubt> {
        Some(match self {
            Self::ExternalStyle => Doubt::ExternalStyle,
            Self::Script | Self::UnreadEntity => Doubt::Script,
            Self::EntityContent => Doubt::EntityContent,
            Self::SelectedByName(_) => Doubt::StyleSelector,
            Self::StyleGeometry(_) | Self::StyleReads(_) => Doubt::StyleGeometry,
            Self::Animated(_) => Doubt::Animation,
            Self::Marker => Doubt::Marker,
            Self::MotionPath => Doubt::MotionPath,
            Self::AttributeDefaults => Doubt::AttributeDefaults,
            Self::MarkerOnVertices | Self::MarkerOnRun => Doubt::MarkerMid,
            Self::EmptyArc => Doubt::EmptyArc,
            Self::NearlyWhole => Doubt::NearlyWhole,
            _ => return None,
        })
    }

    /// Whether it counts, given what is trusted.
    pub(super) const fn counts(&self, trust: Trust) -> bool {
        match self.doubt() {
            Some(doubt) => !trust.contains(doubt),
            None => true,
        }
    }

    /// Itself as an error, where it counts.
    pub(super) fn stop(self, trust: Trust) -> Result<(), Self> {
        if self.counts(trust) {
            Err(self)
        } else {
            Ok(())
        }
    }

    /// A short, stable name.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        if let Some(doubt) = self.doubt() {
            return doubt.code();
        }
        match self {
            Self::Length { .. } => "length",
            Self::NotDrawn(_) => "not-drawn",
            Self::Entity => "entity",
            Self::PathError | Self::PathErrorAfterArc => "path-error",
            Self::TooLarge => "too-large",
            Self::Collapses => "precision",
            Self::Refused(_) => "method",
            Self::StaysPath(_) => "stays-path",
            _ => "elsewhere",
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SelectedByName(selector) => write!(
                f,
                "the style selector `{selector}` may depend on its name or its attributes"
            ),
            Self::StyleGeometry(property) => write!(f, "a style may set `{property}`"),
            Self::StyleReads(attribute) => write!(f, "a style reads `attr({attribute})`"),
            Self::Animated(attribute) => write!(f, "an animation changes `{attribute}`"),
            Self::Length { attribute, value } => write!(
                f,
                "`{attribute}=\"{value}\"` is not a number or an absolute length"
            ),
            Self::NotDrawn(why) => write!(f, "nothing is drawn: {why}"),
            Self::StaysPath(why) => write!(f, "it stays a path: {why}"),
            Self::Refused(why) => f.write_str(why),
            Self::Elsewhere(attribute) => {
                write!(
                    f,
                    "only `d` of a <path> is converted, no `{attribute}` elsewhere"
                )
            }
            _ => f.write_str(self.words()),
        }
    }
}

impl Reason {
    /// What it says where it names nothing of the document.
    const fn words(&self) -> &'static str {
        match self {
            Self::ExternalStyle => {
                "an external style sheet may select it by name or set its geometry"
            }
            Self::Script => "a script or an event handler of the document may address it",
            Self::UnreadEntity => {
                "an entity in an attribute is in another file or expands too far to be read, and may bring a script"
            }
            Self::EntityContent => {
                "an entity in the content may hold styles or elements that change it"
            }
            Self::Marker => {
                "a marker is in effect, which renderers draw on paths but not on this element"
            }
            Self::MotionPath => "an animated motion follows it and may count its vertices",
            Self::AttributeDefaults => {
                "the DTD declares attribute defaults that depend on element names"
            }
            Self::Entity => "its value depends on an entity or on another resource",
            Self::MarkerOnVertices => {
                "a marker may stand on every vertex, and this arc needs new ones"
            }
            Self::MarkerOnRun => {
                "a marker may stand on every vertex, and an arc would take some away"
            }
            Self::EmptyArc => {
                "the arc ends where it starts, and a cap, a marker or the next command may show it"
            }
            Self::NearlyWhole => {
                "its ends are one point in single precision, so that some renderers draw nothing and others all of it"
            }
            Self::PathError => "the path data have an error here; nothing after it is drawn",
            Self::PathErrorAfterArc => {
                "the path data have an error between this arc and a smooth curve"
            }
            Self::TooLarge => "its coordinates are too large",
            Self::Collapses => "it would collapse at this precision",
            _ => "",
        }
    }
}
