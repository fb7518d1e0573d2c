//! What animation elements change.

use super::css;
use super::property::{Effect, Properties};
use crate::document::xml::node::Element;
use crate::document::xml::scan::Scanner;

/// The attributes that hold what an animated one becomes.
pub(super) const VALUES: [&str; 4] = ["to", "from", "by", "values"];

/// Which element an animation changes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum AnimatedTarget {
    /// The element whose tag begins at this byte.
    Parent(usize),
    /// The elements with this id.
    Id(String),
}

/// The element of its link, or else its parent; browsers differ about an empty link.
pub(super) fn target(element: &Element<'_>, scanner: &Scanner<'_>) -> Option<AnimatedTarget> {
    let mut links = element.link.into_iter();
    if links.any(|link| !scanner.attributes[link].value.trim().is_empty()) {
        return scanner.linked_id(element).map(AnimatedTarget::Id);
    }
    let parent = if element.empty {
        scanner.parent()
    } else {
        scanner.grandparent()
    };
    parent.map(AnimatedTarget::Parent)
}

/// What an animation of that attribute sets, and what its values read.
pub(super) fn effect(name: &str, scanner: &Scanner<'_>) -> Effect {
    let values = VALUES.iter().filter_map(|name| scanner.attribute(name));
    Effect {
        sets: Properties::named(name),
        reads: values.fold(Properties::NONE, |all, text| all.with(css::reads(&text))),
        no_marker: false,
    }
}
