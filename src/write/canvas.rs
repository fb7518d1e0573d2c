//! Calls of the HTML canvas, one a line: methods of a `CanvasRenderingContext2D` or a `Path2D`.

use core::fmt::Write as _;

use kurbo::{PathSeg, Point};

use crate::curve::Curve;
use crate::number::text;

/// The calls that draw the curves.
#[must_use]
pub fn calls<'a>(curves: impl IntoIterator<Item = &'a Curve>) -> String {
    let mut out = String::new();
    for curve in curves {
        push_curve(&mut out, curve);
    }
    out
}

fn push_curve(out: &mut String, curve: &Curve) {
    let Some(start) = curve.start() else { return };
    push_call(out, "moveTo", &[start]);
    for segment in &curve.segments {
        match *segment {
            PathSeg::Line(l) => push_call(out, "lineTo", &[l.p1]),
            PathSeg::Quad(q) => push_call(out, "quadraticCurveTo", &[q.p1, q.p2]),
            PathSeg::Cubic(c) => push_call(out, "bezierCurveTo", &[c.p1, c.p2, c.p3]),
        }
    }
    if curve.closed {
        push_call(out, "closePath", &[]);
    }
}

fn push_call(out: &mut String, name: &str, points: &[Point]) {
    let numbers: Vec<String> = points.iter().flat_map(|p| [text(p.x), text(p.y)]).collect();
    // Writing to a string cannot fail.
    let _ = writeln!(out, "{name}({})", numbers.join(", "));
}
