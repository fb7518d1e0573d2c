//! A glyph of the Unified Font Object, GLIF format 2: a contour for each curve, cubics or quadratics as they are.
//!
//! <https://unifiedfontobject.org/versions/ufo3/glyphs/glif/>: points on the curve have the type of the segment that they end; a closed
//! contour begins with the end of its last segment. What names a shape names the first point of each of its contours: names may come again,
//! which identifiers may not.

use core::fmt::Write as _;

use kurbo::{ParamCurve as _, PathSeg, Point};

use crate::curve::{Curve, control_points, turn};
use crate::number::text;
use crate::picture::figure::Figure;
use crate::write::{self, escaped};

/// A joint that turns by less, in degrees, is smooth: the grid turns it more than most methods do.
const SMOOTH: f64 = 1.0;

/// The figure as a glyph of this name, or else called by its kind of shape, its description as the note.
#[must_use]
pub fn glyph(figure: &Figure, name: Option<&str>) -> String {
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<glyph name=\"{}\" format=\"2\">\n  <note>{}</note>\n  <outline>\n",
        escaped(&write::name(name.unwrap_or(figure.name))),
        escaped(&figure.description)
    );
    for layer in &figure.layers {
        for curve in &layer.curves {
            push_contour(&mut out, curve, layer.id.as_deref());
        }
    }
    out + "  </outline>\n</glyph>\n"
}

/// The points of a curve, the first of this name; nothing for a curve without segments.
fn push_contour(out: &mut String, curve: &Curve, name: Option<&str>) {
    let (Some(first), Some(last)) = (curve.segments.first(), curve.segments.last()) else {
        return;
    };
    out.push_str("    <contour>\n");
    let start = first.start();
    let on = if curve.closed {
        (kind(last), is_smooth(last, first))
    } else {
        ("move", false)
    };
    push_point(out, start, Some(on), name);
    let following = curve.segments.iter().skip(1).map(Some).chain([None]);
    for (segment, next) in curve.segments.iter().zip(following) {
        if let [_, off @ .., end] = control_points(segment).as_slice() {
            for &p in off {
                push_point(out, p, None, None);
            }
            let smooth = next.is_some_and(|next| is_smooth(segment, next));
            if next.is_some() || !curve.closed {
                push_point(out, *end, Some((kind(segment), smooth)), None);
            }
        }
    }
    out.push_str("    </contour>\n");
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

/// A point; one on the curve has a type, and may be smooth.
fn push_point(out: &mut String, p: Point, on: Option<(&str, bool)>, name: Option<&str>) {
    // Writing to a string cannot fail.
    let _ = write!(out, "      <point x=\"{}\" y=\"{}\"", text(p.x), text(p.y));
    if let Some((kind, smooth)) = on {
        let smooth = if smooth { " smooth=\"yes\"" } else { "" };
        let _ = write!(out, " type=\"{kind}\"{smooth}");
    }
    if let Some(name) = name {
        let _ = write!(out, " name=\"{}\"", escaped(name));
    }
    out.push_str("/>\n");
}
