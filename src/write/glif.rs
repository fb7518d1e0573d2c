//! A glyph of the Unified Font Object, GLIF format 2: a contour for each curve, cubics or quadratics as they are.
//!
//! <https://unifiedfontobject.org/versions/ufo3/glyphs/glif/>: points on the curve have the type of the segment that they end; a closed
//! contour begins with the end of its last segment.

use kurbo::{ParamCurve as _, PathSeg, Point};
use svg::node::element::Element;
use svg::node::{Node as _, Text};

use crate::curve::{Curve, control_points, turn};
use crate::number::text;
use crate::picture::figure::Figure;

/// A joint that turns by less, in degrees, is smooth: the grid turns it more than any method does.
const SMOOTH: f64 = 1.0;

/// The figure as a glyph, its description as the note.
#[must_use]
pub fn glyph(figure: &Figure) -> String {
    let mut outline = Element::new("outline");
    for contour in figure.curves().filter_map(contour) {
        outline.append(contour);
    }
    let mut note = Element::new("note");
    note.append(Text::new(figure.description.as_str()));
    let mut glyph = Element::new("glyph");
    glyph.assign("name", figure.name);
    glyph.assign("format", "2");
    glyph.append(note);
    glyph.append(outline);
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{glyph}\n")
}

/// The points of a curve; none for a curve without segments.
fn contour(curve: &Curve) -> Option<Element> {
    let (first, last) = (curve.segments.first()?, curve.segments.last()?);
    let mut contour = Element::new("contour");
    let start = first.start();
    if curve.closed {
        contour.append(on(start, kind(last), is_smooth(last, first)));
    } else {
        contour.append(on(start, "move", false));
    }
    let following = curve.segments.iter().skip(1).map(Some).chain([None]);
    for (segment, next) in curve.segments.iter().zip(following) {
        let points = control_points(segment);
        for &p in points.iter().skip(1).rev().skip(1).rev() {
            contour.append(point(p));
        }
        let smooth = next.is_some_and(|next| is_smooth(segment, next));
        if next.is_some() || !curve.closed {
            contour.append(on(segment.end(), kind(segment), smooth));
        }
    }
    Some(contour)
}

/// The type of the point that ends a segment.
const fn kind(segment: &PathSeg) -> &'static str {
    match segment {
        PathSeg::Line(_) => "line",
        PathSeg::Quad(_) => "qcurve",
        PathSeg::Cubic(_) => "curve",
    }
}

fn is_smooth(before: &PathSeg, after: &PathSeg) -> bool {
    turn(before, after).abs() < SMOOTH
}

fn on(p: Point, kind: &str, smooth: bool) -> Element {
    let mut element = point(p);
    element.assign("type", kind);
    if smooth {
        element.assign("smooth", "yes");
    }
    element
}

fn point(p: Point) -> Element {
    let mut element = Element::new("point");
    element.assign("x", text(p.x));
    element.assign("y", text(p.y));
    element
}
