//! Shapes as path data, and path data that are shapes.

pub(super) mod back;
pub(super) mod element;
pub(super) mod length;
pub(super) mod shape_data;
pub(super) mod tag;
mod text;
pub(super) mod used;
mod whole;
