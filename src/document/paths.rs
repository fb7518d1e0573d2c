//! The paths of SVG files as curves, with the transforms of their ancestors.

use kurbo::Affine;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use crate::curve::Curve;
use crate::error::{Error, Result, finite};
use crate::path::{self, shortened};

/// A `path` element of an SVG file.
#[derive(Debug, Clone, PartialEq)]
pub struct SvgPath {
    /// The line on which it starts, from 1.
    pub line: usize,
    /// Its id.
    pub id: Option<String>,
    /// Its curves in the coordinates of the outermost element, or why they cannot be had.
    pub curves: Result<Vec<Curve>>,
}

/// Every `path` element of an SVG file, with its own transform and those of its ancestors applied.
///
/// # Errors
///
/// Where the text is not well-formed XML.
pub fn svg_paths(text: &str) -> Result<Vec<SvgPath>> {
    // The reader leaves a byte order mark out of its positions.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::from_str(text);
    let mut found = Vec::new();
    let mut maps = vec![Ok(Affine::IDENTITY)];
    let (mut counted, mut line) = (0, 1);
    loop {
        let position = (reader.buffer_position() as usize).min(text.len());
        line += text[counted..position].matches('\n').count();
        counted = position;
        let event = reader
            .read_event()
            .map_err(|error| Error::Shape(format!("line {line}: not well-formed XML: {error}")))?;
        let (element, is_open) = match &event {
            Event::Start(element) => (element, true),
            Event::Empty(element) => (element, false),
            Event::End(_) => {
                if maps.len() > 1 {
                    maps.pop();
                }
                continue;
            }
            Event::Eof => break,
            _ => continue,
        };
        let map = map_within(maps.last(), element);
        if element.local_name().as_ref() == "path" {
            found.push(svg_path(element, &map, line));
        }
        if is_open {
            maps.push(map);
        }
    }
    Ok(found)
}

fn svg_path(element: &BytesStart, map: &Result<Affine>, line: usize) -> SvgPath {
    let curves = map.clone().and_then(|map| {
        let curves = path::curves(&attribute(element, "d").unwrap_or_default())?;
        Ok(curves.iter().map(|curve| curve.transformed(map)).collect())
    });
    SvgPath {
        line,
        id: attribute(element, "id"),
        curves,
    }
}

/// The map of an element: its own transform behind that of its parent.
fn map_within(parent: Option<&Result<Affine>>, element: &BytesStart) -> Result<Affine> {
    let parent = parent.cloned().unwrap_or(Ok(Affine::IDENTITY))?;
    let Some(text) = attribute(element, "transform") else {
        return Ok(parent);
    };
    let own = path::transform(&text).map_err(|error| {
        Error::Shape(format!(
            "cannot read the transform '{}': {error}",
            shortened(&text)
        ))
    })?;
    let map = parent * own;
    for number in map.as_coeffs() {
        finite("number in the transform", number)?;
    }
    Ok(map)
}

fn attribute(element: &BytesStart, name: &str) -> Option<String> {
    let attribute = element.try_get_attribute(name).ok().flatten()?;
    match quick_xml::escape::unescape(&attribute.value) {
        Ok(plain) => Some(plain.into_owned()),
        Err(_) => Some(attribute.value.into_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{PathSeg, Point};

    #[test]
    fn transforms_of_all_ancestors_apply() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg">
<g transform="translate(10 0)"><g transform="scale(2)">
<path id="a&amp;b" transform="rotate(90)" d="M1 0L2 0"/></g></g>
<path d="M1 0A1 1 0 0 1 2 0"/></svg>"#;
        let paths = svg_paths(svg).unwrap();
        assert_eq!((paths[0].line, paths[0].id.as_deref()), (3, Some("a&b")));
        let curves = paths[0].curves.as_ref().unwrap();
        let PathSeg::Line(line) = curves[0].segments[0] else {
            panic!()
        };
        assert!(line.p0.distance(Point::new(10.0, 2.0)) < 1e-12);
        assert!(paths[1].curves.is_err());
        assert!(svg_paths("<svg><path").is_err());
        let marked = svg_paths("\u{feff}<svg>\n<!--\u{e9}--><path/></svg>").unwrap();
        assert_eq!(marked[0].line, 2);
        assert!(svg_paths("\u{feff}c0").is_ok());
    }
}
