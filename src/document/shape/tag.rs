//! The tag of a shape becomes that of a path.

use crate::document::splice::Splice;
use crate::document::style::property::ElementKind;
use crate::document::xml::attributes::{Attribute, named};
use crate::document::xml::node::Element;
use crate::document::xml::scan::Scanner;

/// The element and the attribute that is not a path's `d` and holds path data with arcs, and where it begins.
pub(in crate::document) fn arcs_elsewhere(
    element: &Element<'_>,
    scanner: &Scanner<'_>,
) -> Option<(&'static str, &'static str, usize)> {
    let known = [
        ("glyph", "d"),
        ("missing-glyph", "d"),
        ("hatchpath", "d"),
        ("hatchPath", "d"),
        ("animateMotion", "path"),
        ("textPath", "path"),
    ];
    let (holder, name) = known.into_iter().find(|known| known.0 == element.local)?;
    let mut attributes = scanner.attributes.iter();
    let found = attributes.find(|a| a.name == name && a.value.contains(['a', 'A']))?;
    Some((holder, name, found.start))
}

/// The tag's name becomes `path`, the first geometry attribute `d`, or a `d` that has no meaning yet gets one; the other ones go
/// with the space before them.
pub(in crate::document) fn replace(
    kind: ElementKind,
    element: &Element<'_>,
    attributes: &[Attribute<'_>],
    data: &[u8],
    splice: &mut Splice<'_>,
) {
    splice.replace(element.local_span.clone(), b"path");
    let stray = named(attributes, "d").is_some();
    let mut written = stray;
    for attribute in attributes {
        if attribute.name == "d" {
            splice.replace(attribute.value_span.clone(), data);
        } else if kind.geometry().contains(&attribute.name) && written {
            splice.replace(attribute.span.clone(), b"");
        } else if kind.geometry().contains(&attribute.name) {
            splice.replace(
                attribute.start..attribute.start + attribute.name.len(),
                b"d",
            );
            splice.replace(attribute.value_span.clone(), data);
            written = true;
        }
    }
}

/// The tag of a path becomes that of a shape, whose attributes stand in place of `d`, up to its closing quote.
pub(in crate::document) fn become_shape(
    kind: ElementKind,
    element: &Element<'_>,
    d: &Attribute<'_>,
    attributes: &[u8],
    splice: &mut Splice<'_>,
) {
    splice.replace(element.local_span.clone(), kind.name().as_bytes());
    splice.replace(d.start..d.value_span.end, attributes);
}
