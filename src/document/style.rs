//! What applies to elements from elsewhere: style sheets, style attributes, animations, markers.

pub(super) mod css;
pub(super) mod facts;
mod motion;
pub(super) mod own;
pub(super) mod property;
pub(super) mod rules;
pub(super) mod selector;
