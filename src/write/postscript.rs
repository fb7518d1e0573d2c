//! PostScript: path operators, Encapsulated PostScript, and Lancaster's procedures.

use kurbo::{PathSeg, Point, Rect};

use super::Figure;
use super::number::{push_shortest, significant};
use crate::curve::Curve;
use crate::error::Result;
use crate::method::{Method, Rule, Span};

/// The operators of one or more curves, one a line; quadratics are raised to cubics exactly.
#[must_use]
pub fn operators<'a>(curves: impl IntoIterator<Item = &'a Curve>) -> String {
    let mut out = Vec::new();
    for curve in curves {
        push_operators(&mut out, curve);
    }
    String::from_utf8_lossy(&out).into_owned()
}

/// Appends the operators of a curve, one a line.
pub fn push_operators(out: &mut Vec<u8>, curve: &Curve) {
    let Some(start) = curve.start() else { return };
    push_line(out, &[start], "moveto");
    for segment in &curve.segments {
        match *segment {
            PathSeg::Line(l) => push_line(out, &[l.p1], "lineto"),
            PathSeg::Quad(q) => {
                let c = q.raise();
                push_line(out, &[c.p1, c.p2, c.p3], "curveto");
            }
            PathSeg::Cubic(c) => push_line(out, &[c.p1, c.p2, c.p3], "curveto"),
        }
    }
    if curve.closed {
        push_line(out, &[], "closepath");
    }
}

fn push_line(out: &mut Vec<u8>, points: &[Point], operator: &str) {
    for number in points.iter().flat_map(|p| [p.x, p.y]) {
        push_shortest(out, number);
        out.push(b' ');
    }
    out.extend_from_slice(operator.as_bytes());
    out.push(b'\n');
}

/// A whole EPSF-3.0 file that strokes the figure with a line of this width.
#[must_use]
pub fn encapsulated(figure: &Figure, stroke_width: f64) -> String {
    let own = figure.bounding_box(false).unwrap_or(Rect::ZERO);
    let bounds = own.inflate(stroke_width / 2.0, stroke_width / 2.0);
    let corners = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
    let whole = [
        bounds.x0.floor(),
        bounds.y0.floor(),
        bounds.x1.ceil(),
        bounds.y1.ceil(),
    ];
    let list = |numbers: [f64; 4]| numbers.map(|n| significant(n, 9)).join(" ");
    let mut text = format!(
        "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: {}\n%%HiResBoundingBox: {}\n%%Title: {}\n%%Creator: curveto\n%%Pages: 1\n%%EndComments\n%%Page: 1 1\ngsave\n% {}\n{} setlinewidth\n",
        list(whole),
        list(corners),
        ascii(&figure.title),
        ascii(&figure.description),
        significant(stroke_width, 9),
    );
    for layer in &figure.layers {
        if layer.dashed {
            let dash = significant(3.0 * stroke_width, 9);
            text += &["gsave [", &dash, " ", &dash, "] 0 setdash\n"].concat();
        }
        text += "newpath\n";
        text += &operators(&layer.curves);
        text += "stroke\n";
        if layer.dashed {
            text += "grestore\n";
        }
    }
    text + "grestore\nshowpage\n%%EOF\n"
}

/// The text with everything that a DSC comment cannot hold replaced.
fn ascii(text: &str) -> String {
    text.chars()
        .map(|c| {
            if c.is_ascii_graphic() || c == ' ' {
                c
            } else {
                '?'
            }
        })
        .collect()
}

/// PostScript procedures `drawellipse` and `drawcircle` with the rule's quarter-circle handle, after Lancaster.
///
/// # Errors
///
/// Where the rule has no quarter, or its quarter is no cubic that one number describes.
pub fn procset(rule: Rule) -> Result<String> {
    let piece = rule.piece(&Span::from_degrees(90.0))?;
    let one_number = piece.end_radius == 1.0
        && piece.handle.x == 1.0
        && piece.degree == crate::method::Degree::Cubic;
    if !one_number {
        let method = rule.method().unwrap_or(Method::Minimax);
        return Err(method.refuse(
            "the procedures have one magic number, for cubics that touch the circle at the quadrants".to_owned(),
            "take -m minimax, midpoint or lancaster-drawellipse".to_owned(),
        ));
    }
    let error = rule.radial_error(&Span::from_degrees(90.0))?;
    Ok(PROCSET
        .replace("@METHOD@", rule.id())
        .replace("@MAGIC@", &super::number::text(piece.handle.y))
        .replace("@PEAK@", &significant(error.peak(), 4)))
}

const PROCSET: &str = "\
%!PS
% Ellipses and circles of four Bezier curves each, after Don Lancaster's procedures (2005).
%   WIDTH HEIGHT drawellipse   appends an ellipse about the origin to the current path
%   DIAMETER drawcircle        appends a circle
% Quarter-circle handle of method @METHOD@; the curves stray from the true shape by @PEAK@ of the larger radius at most.
/magic @MAGIC@ def
/drawellipse {
  10 dict begin
  2 div /yrad exch def
  2 div /xrad exch def
  /xmag xrad magic mul def
  /ymag yrad magic mul def
  xrad neg 0 moveto
  xrad neg ymag xmag neg yrad 0 yrad curveto
  xmag yrad xrad ymag xrad 0 curveto
  xrad ymag neg xmag yrad neg 0 yrad neg curveto
  xmag neg yrad neg xrad neg ymag neg xrad neg 0 curveto
  end
} bind def
/drawcircle { dup drawellipse } bind def
";
