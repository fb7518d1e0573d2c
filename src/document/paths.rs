//! The paths of SVG files, with the viewports and transforms of their ancestors.

mod placing;
mod tag;

use std::borrow::Cow;

use kurbo::Affine;

use self::placing::Coordinates;
use self::tag::{Tag, entity_error};
use super::shape::element::{UsedShape, shape};
use super::shape::length::Length;
use super::style::css;
use super::style::property::ElementKind;
use super::xml::doctype::UNDECLARED;
use super::xml::namespace::Namespace;
use super::xml::node::{Element, Node};
use super::xml::scan::Scanner;
use super::{Error, Reason, read_bytes};
use crate::contour::Contour;
use crate::error::TextError;
use crate::path;

/// A `path` element of an SVG file, or another that draws.
#[derive(Debug, Clone, PartialEq)]
pub struct SvgPath {
    /// The line on which it starts, from 1.
    pub line: usize,
    /// Its id.
    pub id: Option<String>,
    /// Its contours and the map to the coordinates of the outermost element, or why they cannot be had.
    pub contours: crate::Result<(Vec<Contour>, Affine)>,
}

/// Every `path` element of an SVG file, with its own transform, those of its ancestors and nested viewports applied. Style
/// attributes are read; see [`has_transforms_elsewhere`] for style sheets.
///
/// # Errors
///
/// As [`super::convert_bytes`].
pub fn svg_paths(file: impl AsRef<[u8]>) -> Result<Vec<SvgPath>, Error> {
    elements(file.as_ref(), &["path"])
}

/// As [`svg_paths`], and every `circle`, `ellipse`, `rect`, `line`, `polyline` and `polygon`.
///
/// # Errors
///
/// As [`super::convert_bytes`].
pub fn svg_shapes(file: impl AsRef<[u8]>) -> Result<Vec<SvgPath>, Error> {
    elements(
        file.as_ref(),
        &[
            "path", "circle", "ellipse", "rect", "line", "polyline", "polygon",
        ],
    )
}

/// Whether a style sheet of the file sets transforms, which [`svg_paths`] does not apply.
#[must_use]
pub fn has_transforms_elsewhere(file: impl AsRef<[u8]>) -> bool {
    let (mut sheet, mut sheets) = (None, String::new());
    let seen = nodes(file.as_ref(), |node, scanner| match node {
        Node::Start(element) if !element.empty && is_named(element, "style") => {
            sheet = Some(scanner.depth());
        }
        Node::Text(text) if sheet.is_some() => sheets.push_str(text),
        Node::End { .. } if sheet > Some(scanner.depth()) => sheet = None,
        _ => {}
    });
    seen.is_ok() && css::declares(&sheets, "transform")
}

/// Whether the file draws elements again by `use`, which [`svg_paths`] does not follow: what they draw is found where it is defined.
#[must_use]
pub fn has_uses(file: impl AsRef<[u8]>) -> bool {
    let mut found = false;
    let seen = nodes(file.as_ref(), |node, _| {
        found |= matches!(node, Node::Start(element) if is_named(element, "use"));
    });
    seen.is_ok() && found
}

/// The first entity in the content whose text is not read, although it may hold elements.
#[must_use]
pub fn unread_entity(file: impl AsRef<[u8]>) -> Option<TextError> {
    let mut found = None;
    let seen = nodes(file.as_ref(), |node, scanner| {
        let Node::Reference(at, _) = *node else {
            return;
        };
        let name = scanner.source[at + 1..].split(';').next();
        let why = name.and_then(|name| Some((name, scanner.doctype.why_not(name)?)));
        // What is declared elsewhere is a character in all but rare cases.
        if let Some((name, why)) = why.filter(|&(_, why)| why != UNDECLARED) {
            found.get_or_insert_with(|| entity_error(scanner, at, name, why));
        }
    });
    seen.ok().and(found)
}

fn is_named(element: &Element<'_>, name: &str) -> bool {
    element.namespace == Namespace::Svg && element.local == name
}

/// Visits the nodes of a file.
fn nodes(file: &[u8], mut visit: impl FnMut(&Node<'_>, &Scanner<'_>)) -> Result<(), Error> {
    read_bytes(file, |source| {
        let mut all = || {
            let mut scanner = Scanner::new(source)?;
            loop {
                match scanner.next()? {
                    Node::Done => return Ok(()),
                    node => visit(&node, &scanner),
                }
            }
        };
        all().map_err(|fault| Error::new(source.text, fault))
    })
    .map(|(done, _)| done)
}

fn elements(file: &[u8], names: &[&str]) -> Result<Vec<SvgPath>, Error> {
    let (mut found, mut places) = (Vec::new(), vec![Coordinates::OUTSIDE]);
    let (mut counted, mut line) = (0, 1);
    nodes(file, |node, scanner| {
        let element = match node {
            Node::Start(element) => element,
            Node::End { .. } => {
                places.pop();
                return;
            }
            _ => return,
        };
        let outer = places.last().unwrap_or(&Coordinates::OUTSIDE);
        let tag = Tag::new(element.local, scanner);
        let place = if element.namespace == Namespace::Svg {
            outer.within(&tag)
        } else {
            outer.clone()
        };
        if element.namespace == Namespace::Svg && names.contains(&element.local) {
            let before = &scanner.source[counted..element.start];
            line += before.matches('\n').count();
            counted = element.start;
            found.push(SvgPath {
                line,
                id: scanner.attribute("id").map(Cow::into_owned),
                contours: contours(&tag, &place),
            });
        }
        if !element.empty {
            places.push(place);
        }
    })?;
    Ok(found)
}

fn contours(tag: &Tag<'_>, place: &Coordinates) -> crate::Result<(Vec<Contour>, Affine)> {
    let map = place.map.clone()?;
    Ok((path::contours(&data(tag, place)?)?, map))
}

/// The path data of an element, as SVG 2 gives those of shapes.
fn data(tag: &Tag<'_>, place: &Coordinates) -> crate::Result<String> {
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
    use crate::curve::Curve;
    use kurbo::{ParamCurve as _, PathSeg, Point};

    fn curves(path: &SvgPath) -> Vec<Curve> {
        let (contours, map) = path.contours.as_ref().unwrap();
        let curves = contours.iter().filter_map(path::curve);
        curves
            .map(|curve| curve.unwrap().transformed(*map))
            .collect()
    }

    #[test]
    fn transforms_of_all_ancestors_apply() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg">
<g transform="translate(10 0)"><g transform="scale(2)">
<path id="a&amp;b" transform="rotate(90)" d="M1 0L2 0"/></g></g>
<path d="M1 0A1 1 0 0 1 2 0"/></svg>"#;
        let paths = svg_paths(svg).unwrap();
        assert_eq!((paths[0].line, paths[0].id.as_deref()), (3, Some("a&b")));
        let curves = curves(&paths[0]);
        let PathSeg::Line(line) = curves[0].segments[0] else {
            panic!()
        };
        assert!(line.p0.distance(Point::new(10.0, 2.0)) < 1e-12);
        assert!(
            path::curve(&paths[1].contours.as_ref().unwrap().0[0])
                .unwrap()
                .is_err()
        );
        assert!(svg_paths("<svg><path").is_err());
        let marked = svg_paths("\u{feff}<svg>\n<!--\u{e9}--><path/></svg>").unwrap();
        assert_eq!(marked[0].line, 2);
        assert!(svg_paths("\u{feff}c0").is_err());
    }

    #[test]
    fn viewports_and_styles_apply() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100">
<svg x="100" y="50" viewBox="0 0 10 10" width="20" height="40"><path d="M0 0L10 0"/></svg>
<path style="transform: scale(2)" transform="scale(9)" d="M1 1L2 2"/>
<path transform="rotate(90)" transform-origin="center" d="M0 0L2 2"/>
<svg width="50%" viewBox="0 0 1 1" preserveAspectRatio="none"><path d="M0 0L1 1"/></svg>
<path style="transform:rotate(1rad)" d="M0 0L1 1"/></svg>"#;
        let paths = svg_paths(svg).unwrap();
        let line = |i: usize| match curves(&paths[i])[0].segments[0] {
            PathSeg::Line(line) => [line.p0, line.p1],
            _ => panic!(),
        };
        assert_eq!(line(0), [Point::new(100.0, 60.0), Point::new(120.0, 60.0)]);
        assert_eq!(line(1), [Point::new(2.0, 2.0), Point::new(4.0, 4.0)]);
        assert!(line(2)[0].distance(Point::new(150.0, -50.0)) < 1e-12);
        assert_eq!(line(3)[1], Point::new(100.0, 100.0));
        assert!(paths[4].contours.is_err());
        assert!(
            has_uses("<svg><use href='#a'/></svg>")
                && has_uses("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:use/></s:svg>")
        );
        assert!(!has_uses("<svg><user/> use </svg>"));
        assert!(has_transforms_elsewhere(
            "<svg><style>.a{transform: none}</style></svg>"
        ));
        assert!(!has_transforms_elsewhere(
            "<svg><style>.a{text-transform:none}transform{}</style></svg>"
        ));
    }

    #[test]
    fn shapes_are_the_paths_that_svg_2_gives_them() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/><ellipse rx="3"/><rect width="9" height="4" rx="1"/>
<rect width="9" height="4"/><line x2="4"/><polygon points="0,0 4,0 4,4"/><polyline points="0 0 4 4"/><circle r="10%"/></svg>"#;
        let shapes = svg_shapes(svg).unwrap();
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
            let shapes = svg_shapes(format!("<svg>{nothing}</svg>")).unwrap();
            assert!(
                shapes[0].contours.as_ref().unwrap().0.is_empty(),
                "{nothing}"
            );
        }
    }

    #[test]
    fn a_style_by_an_entity_applies_to_every_path() {
        let style = format!("transform:translate(7px,0px);{}", "x:y;".repeat(50));
        let path = r#"<path style="&s;" d="M0 0L1 0"/>"#.repeat(3000);
        let svg = format!("<!DOCTYPE svg [<!ENTITY s '{style}'>]><svg>{path}</svg>");
        let paths = svg_paths(svg).unwrap();
        let at_7 = |path: &SvgPath| curves(path)[0].segments[0].start() == Point::new(7.0, 0.0);
        assert_eq!(paths.iter().filter(|path| at_7(path)).count(), 3000);
    }
}
