//! Documents as XML: nodes and attributes with byte spans, namespaces, the DTD, encodings.

pub(super) mod attributes;
pub(super) mod characters;
pub(super) mod doctype;
pub(super) mod encoding;
pub(super) mod fault;
pub(super) mod namespace;
pub(super) mod node;
pub(super) mod place;
pub(super) mod scan;
pub(super) mod value;
