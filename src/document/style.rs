//! What applies to elements from elsewhere: style sheets, style attributes, animations, markers.

mod animation;
pub(super) mod css;
pub(super) mod facts;
mod motion;
pub(super) mod own;
pub(super) mod property;
pub(super) mod rules;
mod script;
pub(super) mod selector;
