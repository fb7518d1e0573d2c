//! Where the path data of a shape come from: they are worked out, or were before.

use crate::document::Options;
use crate::document::path::scratch::Scratch;
use crate::document::reason::Reason;
use crate::document::shape::element;
use crate::document::shape::used::UsedShape;
use crate::document::style::property::ElementKind;
use crate::document::xml::attributes::named;
use crate::document::xml::scan::Scanner;

/// Where the path data of a shape are.
pub(in crate::document) enum ShapeData {
    /// In the buffer for curves.
    Drawn,
    /// Among those that were worked out before.
    Kept(usize),
    /// Nowhere: the rectangle has square corners.
    Square,
}

/// Works out the path data of a shape. `key` is a buffer for how it is spelled.
pub(in crate::document) fn find(
    kind: ElementKind,
    scanner: &Scanner<'_>,
    options: &Options,
    scratch: &mut Scratch,
    key: &mut Vec<u8>,
) -> Result<ShapeData, Reason> {
    key.clear();
    key.extend_from_slice(kind.name().as_bytes());
    let mut spelled = true;
    for name in kind.geometry() {
        // Bytes that no text has part the values.
        let found = named(&scanner.attributes, name);
        spelled &= found.is_none_or(|attribute| !attribute.has_references);
        key.push(if found.is_some() { 0xff } else { 0xfe });
        key.extend_from_slice(found.map_or(&[], |attribute| attribute.value.as_bytes()));
    }
    if spelled && let Some(index) = scratch.memo.find(key) {
        return Ok(ShapeData::Kept(index));
    }
    let shape = element::read(kind, |name| scanner.attribute(name))?;
    if shape == UsedShape::Square {
        return Ok(ShapeData::Square);
    }
    let mut data = core::mem::take(&mut scratch.body.text);
    let drawn = element::path_data(&shape, options, scratch, &mut data);
    scratch.body.text = data;
    scratch.body.facts.strayed = drawn?;
    scratch.body.facts.to = None;
    if spelled {
        scratch.memo.keep(key, &scratch.body.curve());
    }
    Ok(ShapeData::Drawn)
}
