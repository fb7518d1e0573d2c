//! What applies to elements from elsewhere: style sheets, style attributes, animations, markers.

mod animation;
pub(super) mod css;
mod motion;
pub(super) mod of_document;
pub(super) mod on_element;
pub(super) mod property;
pub(super) mod reader;
pub(super) mod rules;
mod script;
pub(super) mod selector;
