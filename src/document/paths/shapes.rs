//! Shapes as the paths that SVG 2 gives them.

use super::placing::Coordinates;
use super::tag::Tag;
use crate::document::reason::Reason;
use crate::document::shape::element::{UsedShape, shape};
use crate::document::shape::length::Length;
use crate::document::style::property::ElementKind;
use crate::error::TextError;

/// The path data of an element, as SVG 2 gives those of shapes.
pub(super) fn data(tag: &Tag<'_>, place: &Coordinates) -> crate::Result<String> {
    let points = || Ok(tag.attribute("points")?.unwrap_or_default());
    let given = |name| place.length(tag, name, Some(0.0));
    Ok(match tag.name {
        "line" => {
            let [x1, y1, x2, y2] = [given("x1")?, given("y1")?, given("x2")?, given("y2")?];
            format!("M{x1} {y1}L{x2} {y2}")
        }
        "polyline" | "polygon" if points()?.trim().is_empty() => String::new(),
        "polyline" => format!("M{}", points()?),
        "polygon" => format!("M{}Z", points()?),
        name => match ElementKind::named(name).filter(|kind| *kind != ElementKind::Path) {
            Some(kind) => round(kind, tag, place)?,
            None => tag.property("d")?.unwrap_or_default(),
        },
    })
}

/// The path data of a circle, an ellipse or a rectangle.
fn round(kind: ElementKind, tag: &Tag<'_>, place: &Coordinates) -> crate::Result<String> {
    let given = |name| place.length(tag, name, Some(0.0));
    let values = |lengths: [Length; 2]| lengths.map(|length| length.value);
    let get = |name| Ok(place.optional_length(tag, name)?.map(Length::computed));
    Ok(match shape(kind, get) {
        Ok(UsedShape::Ellipse(center, radii)) => ellipse(values(center), values(radii)),
        Ok(UsedShape::Rect(corner, size, radii)) => {
            round_rect(values(corner), values(size), values(radii))
        }
        Ok(UsedShape::Square) => square(
            [given("x")?, given("y")?],
            [given("width")?, given("height")?],
        ),
        Err(Reason::NotDrawn(_)) => String::new(),
        Err(why) => return Err(crate::Error::Text(TextError::Element(why.to_string()))),
    })
}

fn ellipse([x, y]: [f64; 2], [rx, ry]: [f64; 2]) -> String {
    let [left, right] = [x - rx, x + rx];
    format!("M{right} {y}A{rx} {ry} 0 0 1 {left} {y}A{rx} {ry} 0 0 1 {right} {y}Z")
}

fn square([x, y]: [f64; 2], [w, h]: [f64; 2]) -> String {
    if w > 0.0 && h > 0.0 {
        format!("M{x} {y}H{}V{}H{x}Z", x + w, y + h)
    } else {
        String::new()
    }
}

fn round_rect([x, y]: [f64; 2], [w, h]: [f64; 2], [rx, ry]: [f64; 2]) -> String {
    let (right, bottom) = (x + w, y + h);
    let corner = |x: f64, y: f64| format!("A{rx} {ry} 0 0 1 {x} {y}");
    [
        format!("M{} {y}H{}", x + rx, right - rx),
        corner(right, y + ry),
        format!("V{}", bottom - ry),
        corner(right - rx, bottom),
        format!("H{}", x + rx),
        corner(x, bottom - ry),
        format!("V{}", y + ry),
        corner(x + rx, y),
        "Z".to_owned(),
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::svg_shapes;

    #[test]
    fn shapes_are_the_paths_that_svg_2_gives_them() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/><ellipse rx="3"/><rect width="9" height="4" rx="1"/>
<rect width="9" height="4"/><line x2="4"/><polygon points="0,0 4,0 4,4"/><polyline points="0 0 4 4"/><circle r="10%"/></svg>"#;
        let shapes = svg_shapes(svg).unwrap().paths;
        let steps = shapes
            .iter()
            .filter_map(|shape| Some(shape.contours.as_ref().ok()?.0[0].steps.len()));
        assert_eq!(steps.collect::<Vec<_>>(), [2, 2, 8, 4, 1, 3, 1]);
        assert!(shapes[7].contours.is_err());
    }

    #[test]
    fn shapes_are_spelled_with_all_their_numbers() {
        assert_eq!(
            ellipse([1.0, 2.0], [3.0, 4.0]),
            "M4 2A3 4 0 0 1 -2 2A3 4 0 0 1 4 2Z"
        );
        assert_eq!(square([1.0, 2.0], [3.0, 5.0]), "M1 2H4V7H1Z");
        assert_eq!(square([1.0, 2.0], [0.0, 5.0]), "");
        assert_eq!(square([1.0, 2.0], [3.0, 0.0]), "");
        assert_eq!(
            round_rect([1.0, 2.0], [10.0, 20.0], [3.0, 4.0]),
            "M4 2H8A3 4 0 0 1 11 6V18A3 4 0 0 1 8 22H4A3 4 0 0 1 1 18V6A3 4 0 0 1 4 2Z"
        );
        for nothing in ["<polyline points=' '/>", "<polygon/>"] {
            let shapes = svg_shapes(format!("<svg>{nothing}</svg>")).unwrap().paths;
            assert!(
                shapes[0].contours.as_ref().unwrap().0.is_empty(),
                "{nothing}"
            );
        }
    }
}
