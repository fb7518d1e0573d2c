//! The tag of a shape becomes that of a path.

use super::splice::Splice;
use super::style::property::Kind;
use super::xml::attributes::Attribute;
use super::xml::node::Element;

/// The tag's name becomes `path`, the first geometry attribute `d`, or a `d` that has no meaning yet gets one; the other ones go
/// with the space before them.
pub(super) fn replace(
    kind: Kind,
    element: &Element<'_>,
    attributes: &[Attribute<'_>],
    data: &[u8],
    splice: &mut Splice<'_>,
) {
    splice.replace(element.local_span.clone(), b"path");
    let stray = attributes.iter().any(|a| a.name == "d");
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
