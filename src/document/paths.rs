//! The paths of SVG files, with the viewports and transforms of their ancestors.

mod numbers;
mod placing;
mod shapes;
mod tag;
mod unread;
mod view_box;

use std::borrow::Cow;

use kurbo::Affine;

use self::placing::Coordinates;
use self::tag::{Tag, entity_error};
pub use self::unread::Unread;
use super::style::property::{ElementKind, Properties};
use super::style::reader::FactsReader;
use super::style::rules::SelectorSubject;
use super::xml::doctype::{MARKUP, UNDECLARED};
use super::xml::encoding::SourceText;
use super::xml::namespace::Namespace;
use super::xml::node::{Element, Node};
use super::xml::scan::Scanner;
use super::{Error, read_bytes};
use crate::contour::{Contour, Step};
use crate::error::TextError;

/// The elements in which no other one draws a path: character data, what is said of the drawing, and a `style` that is no sheet.
const CHARACTER_DATA: [&str; 6] = ["text", "title", "desc", "metadata", "style", "script"];

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

/// What an SVG file draws, as far as it is read.
#[derive(Debug, Clone, PartialEq)]
pub struct SvgDrawing {
    /// What draws, in the order of the file.
    pub paths: Vec<SvgPath>,
    /// What may change that, and is not read: each kind once, by its first example.
    pub unread: Vec<Unread>,
}

/// Every `path` element of an SVG file, with its own transform, those of its ancestors and nested viewports applied. Style
/// attributes are read; style sheets are not applied, which [`SvgDrawing::unread`] says where it matters.
///
/// # Errors
///
/// As [`super::convert_bytes`].
pub fn svg_paths(file: impl AsRef<[u8]>) -> Result<SvgDrawing, Error> {
    drawing(file.as_ref(), &["path"])
}

/// As [`svg_paths`], and every `circle`, `ellipse`, `rect`, `line`, `polyline` and `polygon`.
///
/// # Errors
///
/// As [`super::convert_bytes`].
pub fn svg_shapes(file: impl AsRef<[u8]>) -> Result<SvgDrawing, Error> {
    drawing(
        file.as_ref(),
        &[
            "path", "circle", "ellipse", "rect", "line", "polyline", "polygon",
        ],
    )
}

fn drawing(file: &[u8], names: &[&str]) -> Result<SvgDrawing, Error> {
    let read = |source: SourceText<'_>| {
        let all = || {
            let mut scanner = Scanner::new(source)?;
            let mut drawing = PartlyRead {
                facts: FactsReader::of_styles(),
                ..PartlyRead::default()
            };
            loop {
                match scanner.next()? {
                    Node::Done => return Ok(drawing.done()),
                    node => drawing.node(&node, &scanner, names),
                }
            }
        };
        all().map_err(|fault| Error::new(source.text, fault))
    };
    read_bytes(file, read).map(|(drawing, _)| drawing)
}

/// An open element.
struct Unclosed {
    place: Coordinates,
    /// Whether nothing within it draws a path.
    is_text: bool,
}

/// A drawing of which not all nodes were seen.
#[derive(Default)]
struct PartlyRead {
    found: Vec<SvgPath>,
    facts: FactsReader,
    open: Vec<Unclosed>,
    /// Of each one found whose geometry a style sheet may set: its kind, its number and its class.
    classes: Vec<(ElementKind, usize, Option<String>)>,
    entity: Option<TextError>,
    /// The byte up to which lines were counted, and how many breaks stand before it.
    counted: (usize, usize),
}

impl PartlyRead {
    fn node(&mut self, node: &Node<'_>, scanner: &Scanner<'_>, names: &[&str]) {
        match node {
            Node::Start(element) => self.element(element, scanner, names),
            Node::End { .. } => {
                self.open.pop();
            }
            Node::Reference(at, _) => self.reference(*at, scanner),
            _ => {}
        }
        self.facts.node(node, scanner);
    }

    fn element(&mut self, element: &Element<'_>, scanner: &Scanner<'_>, names: &[&str]) {
        let outer = self.open.last();
        let outer_place = outer.map_or(&Coordinates::OUTSIDE, |open| &open.place);
        let tag = Tag::new(element.local, scanner);
        let is_svg = element.namespace == Namespace::Svg;
        let place = if is_svg {
            outer_place.within(&tag)
        } else {
            outer_place.clone()
        };
        let is_text = outer.is_some_and(|open| open.is_text)
            || is_svg && CHARACTER_DATA.contains(&element.local);
        if is_svg && names.contains(&element.local) {
            let (counted, breaks) = &mut self.counted;
            *breaks += scanner.source[*counted..element.start]
                .matches('\n')
                .count();
            *counted = element.start;
            if let Some(kind) = ElementKind::named(element.local) {
                let class = scanner.attribute("class").map(Cow::into_owned);
                self.classes.push((kind, self.found.len(), class));
            }
            self.found.push(SvgPath {
                line: *breaks + 1,
                id: scanner.attribute("id").map(Cow::into_owned),
                contours: contours(&tag, &place),
            });
        }
        if !element.empty {
            self.open.push(Unclosed { place, is_text });
        }
    }

    /// Takes up a reference in the content, which may stand for elements.
    fn reference(&mut self, at: usize, scanner: &Scanner<'_>) {
        let name = scanner.source[at + 1..].split(';').next();
        let why = name.and_then(|name| Some((name, scanner.doctype.why_not(name)?)));
        let is_text = self.open.last().is_some_and(|open| open.is_text);
        // What is declared elsewhere is a character in all but rare cases, but for style sheets every character counts.
        let matters =
            |why| self.facts.is_in_sheet(scanner) || why == MARKUP || why != UNDECLARED && !is_text;
        if let Some((name, why)) = why.filter(|&(_, why)| matters(why)) {
            let error = || entity_error(scanner, at, name, why);
            self.entity.get_or_insert_with(error);
        }
    }

    fn done(self) -> SvgDrawing {
        let facts = self.facts.facts();
        let geometry = self.classes.iter().map(|(kind, i, class)| {
            let id = self.found[*i].id.as_deref();
            let subject = SelectorSubject::new(kind.name(), class.as_deref(), id);
            facts.styled_geometry(*kind, subject)
        });
        let set = geometry.fold(facts.moving(), Properties::with);
        let unread = [
            (!set.is_empty()).then(|| Unread::StyleSheet(set.first_name())),
            facts.has_external_style().then_some(Unread::ExternalStyle),
            facts.has_uses.then_some(Unread::Uses),
            self.entity.map(Unread::Entity),
        ];
        SvgDrawing {
            paths: self.found,
            unread: unread.into_iter().flatten().collect(),
        }
    }
}

fn contours(tag: &Tag<'_>, place: &Coordinates) -> crate::Result<(Vec<Contour>, Affine)> {
    let map = place.map.clone()?;
    let contours = shapes::contours(tag, place)?;
    for step in contours.iter().flat_map(|contour| &contour.steps) {
        if let Step::Arc(arc) = step {
            arc.outline().transformed(map)?;
        }
    }
    Ok((contours, map))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;
    use crate::path;
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
        let paths = svg_paths(svg).unwrap().paths;
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
        let marked = svg_paths("\u{feff}<svg>\n<!--\u{e9}--><path/></svg>")
            .unwrap()
            .paths;
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
        let paths = svg_paths(svg).unwrap().paths;
        let line = |i: usize| match curves(&paths[i])[0].segments[0] {
            PathSeg::Line(line) => [line.p0, line.p1],
            _ => panic!(),
        };
        assert_eq!(line(0), [Point::new(100.0, 60.0), Point::new(120.0, 60.0)]);
        assert_eq!(line(1), [Point::new(2.0, 2.0), Point::new(4.0, 4.0)]);
        assert!(line(2)[0].distance(Point::new(150.0, -50.0)) < 1e-12);
        assert_eq!(line(3)[1], Point::new(100.0, 100.0));
        assert!(paths[4].contours.is_err());
    }

    #[test]
    fn what_is_not_read_is_said_of_all_that_convert_minds() {
        let unread = |text: &str| svg_shapes(text).unwrap().unread;
        let sheet =
            |css: &str| unread(&format!("<svg><style>{css}</style><rect class='b'/></svg>"));
        for (css, property) in [
            (".a{transform: none}", "transform"),
            ("@media print{g{Rotate:9deg}}", "rotate"),
            ("@keyframes k{to{translate:1px}}", "translate"),
            ("a{b:c;OFFSET-path:none}", "offset-path"),
            (".b{width:9px}", "width"),
            ("*{all:unset}", "all"),
        ] {
            assert_eq!(sheet(css), [Unread::StyleSheet(property)], "{css}");
        }
        for css in [
            ".a{text-transform:none}transform{}",
            ".a{width:9px}",
            "g{fill:transform;x:0}/*a{transform:none}*/",
            "@font-face{transform:none}",
        ] {
            assert_eq!(sheet(css), [], "{css}");
        }
        let entity =
            "<!DOCTYPE svg [<!ENTITY t 'transform'>]><svg><style>a{&t;:none}</style></svg>";
        assert_eq!(unread(entity), [Unread::StyleSheet("transform")]);
        let plain = "<svg><style type='text/plain'>a{transform:none}</style></svg>";
        assert_eq!(unread(plain), []);
        for external in [
            "<svg><style>@import url(a.css);</style></svg>",
            "<?xml-stylesheet href='a.css'?><svg/>",
            "<svg><link rel='stylesheet' href='a.css'/></svg>",
        ] {
            assert_eq!(unread(external), [Unread::ExternalStyle], "{external}");
        }
        let prefixed = "<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:use/></s:svg>";
        assert_eq!(unread(prefixed), [Unread::Uses]);
        assert_eq!(unread("<svg><user/> use </svg>"), []);
    }

    #[test]
    fn entities_in_character_data_move_nothing() {
        let says = |declared: &str, inner: &str| {
            let text = format!("<!DOCTYPE svg [<!ENTITY e {declared}>]><svg>{inner}</svg>");
            !svg_paths(text).unwrap().unread.is_empty()
        };
        for text in [
            "<text>&e;</text>",
            "<text><tspan>&e;</tspan></text>",
            "<desc>&e;</desc>",
            "<style type='text/plain'>&e;</style>",
        ] {
            assert!(!says("SYSTEM 'x'", text), "{text}");
        }
        for elsewhere in ["&e;", "<g>&e;</g>", "<text/>&e;", "<style>&e;</style>"] {
            assert!(says("SYSTEM 'x'", elsewhere), "{elsewhere}");
            assert!(!says("'plain'", elsewhere), "{elsewhere}");
        }
        assert!(says("'<style/>'", "<text>&e;</text>"));
        // Declared elsewhere, if at all.
        let declared = |inner: &str| {
            let text = format!("<!DOCTYPE svg SYSTEM 'x'><svg>{inner}</svg>");
            svg_paths(text).unwrap().unread.len()
        };
        assert_eq!((declared("&e;"), declared("<style>&e;</style>")), (0, 1));
    }

    #[test]
    fn a_style_by_an_entity_applies_to_every_path() {
        let style = format!("transform:translate(7px,0px);{}", "x:y;".repeat(50));
        let path = r#"<path style="&s;" d="M0 0L1 0"/>"#.repeat(3000);
        let svg = format!("<!DOCTYPE svg [<!ENTITY s '{style}'>]><svg>{path}</svg>");
        let paths = svg_paths(svg).unwrap().paths;
        let at_7 = |path: &SvgPath| curves(path)[0].segments[0].start() == Point::new(7.0, 0.0);
        assert_eq!(paths.iter().filter(|path| at_7(path)).count(), 3000);
    }
}
