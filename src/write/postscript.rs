//! PostScript: path operators, Encapsulated PostScript, and Lancaster's procedures.

use kurbo::{CubicBez, PathSeg, Point, QuadBez, Rect};

use crate::curve::Curve;
use crate::error::{Error, MethodError, PictureError, Remedy, Result};
use crate::method::{Method, Rule, Span};
use crate::number::{
    Precision, decimal_sum, decimal_third, push_shortest, rounded_up, significant, text,
};
use crate::picture::paint::{Color, Paint};
use crate::picture::scene::{Group, Scene};
use crate::picture::size::Size;

/// The names of the operators that make a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct PathOperators {
    pub(super) move_to: &'static str,
    pub(super) line_to: &'static str,
    pub(super) curve_to: &'static str,
    pub(super) close: &'static str,
}

const POSTSCRIPT: PathOperators = PathOperators {
    move_to: "moveto",
    line_to: "lineto",
    curve_to: "curveto",
    close: "closepath",
};

/// Lines of a file that keeps DSC have 255 characters at most.
const LONGEST_COMMENT: usize = 250;

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
    push_path(out, curve, &POSTSCRIPT);
}

/// Appends the operators of a curve by these names, one a line.
pub(super) fn push_path(out: &mut Vec<u8>, curve: &Curve, names: &PathOperators) {
    let Some(start) = curve.start() else { return };
    push_line(out, &[start], names.move_to);
    for segment in &curve.segments {
        match *segment {
            PathSeg::Line(l) => push_line(out, &[l.p1], names.line_to),
            PathSeg::Quad(q) => {
                let c = raised(q);
                push_line(out, &[c.p1, c.p2, c.p3], names.curve_to);
            }
            PathSeg::Cubic(c) => push_line(out, &[c.p1, c.p2, c.p3], names.curve_to),
        }
    }
    if curve.closed {
        push_line(out, &[], names.close);
    }
}

/// A quadratic as a cubic, in the decimals that its points have: two thirds of 4.122 are 2.748, and not 2.7479999999999998.
pub(super) fn raised(q: QuadBez) -> CubicBez {
    let third = |a: f64, b: f64| decimal_third(decimal_sum(a, decimal_sum(b, b)));
    let [p1, p2] = [q.p0, q.p2].map(|end| Point::new(third(end.x, q.p1.x), third(end.y, q.p1.y)));
    CubicBez::new(q.p0, p1, p2, q.p2)
}

fn push_line(out: &mut Vec<u8>, points: &[Point], operator: &str) {
    for number in points.iter().flat_map(|p| [p.x, p.y]) {
        push_shortest(out, number);
        out.push(b' ');
    }
    out.extend_from_slice(operator.as_bytes());
    out.push(b'\n');
}

/// A whole EPSF-3.0 file. Where a size was asked for, it is in points; else the file is as large as its coordinates.
///
/// # Errors
///
/// Where a colour is translucent, which PostScript cannot paint.
pub fn encapsulated(scene: &Scene) -> Result<String> {
    let canvas = scene.canvas();
    let mut text = String::new();
    let bounds = match scene.size.map(Size::points) {
        None if !scene.upright => canvas,
        size => {
            let [width, height] = size.unwrap_or([canvas.width(), canvas.height()]);
            let scale = width / canvas.width();
            text += &frame(scene, scale);
            Rect::new(0.0, 0.0, width, height)
        }
    };
    if let Some(color) = scene.background.and_then(Paint::visible) {
        let area = Curve {
            segments: kurbo::Shape::path_segments(&canvas, 0.0).collect(),
            closed: true,
        };
        text += &operators([&area]);
        text += &(set_color(color)? + "fill\n");
    }
    for group in &scene.groups {
        text += &paint_group(group, scene)?;
    }
    Ok(header(bounds, scene) + &text + "grestore\nshowpage\n%%EOF\n")
}

/// Moves the canvas to the corner of a page and scales it; what has a right way up is turned over, since +y of a page is up.
fn frame(scene: &Scene, scale: f64) -> String {
    let canvas = scene.canvas();
    let far = if scene.upright { canvas.y1 } else { -canvas.y0 };
    let [x, y, scale] = [-canvas.x0 * scale, far * scale, scale].map(number);
    let scaling = if scene.upright {
        "dup neg scale"
    } else {
        "dup scale"
    };
    [&x, &y, "translate", &scale, scaling].join(" ") + "\n"
}

fn header(bounds: Rect, scene: &Scene) -> String {
    let Rect { x0, y0, x1, y1 } = bounds;
    let list = |corners: [f64; 4]| corners.map(number).join(" ");
    let description = comment(&scene.description);
    format!(
        "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: {}\n%%HiResBoundingBox: {}\n%%Title: {}\n%%Creator: curveto\n%%Pages: 1\n\
         %%EndComments\n%%Page: 1 1\n{description}gsave\n1 setlinejoin\n",
        list([x0.floor(), y0.floor(), x1.ceil(), y1.ceil()]),
        list([x0, y0, x1, y1]),
        ascii(&scene.title),
    )
}

fn paint_group(group: &Group, scene: &Scene) -> Result<String> {
    let mut text = comment(group.id.as_deref().unwrap_or_default()) + "gsave\n";
    let mut paint = String::new();
    if let Some(color) = group.pen.fill.visible() {
        paint = set_color(color)? + "fill\n";
    }
    if let Some((color, width)) = group.pen.visible_stroke() {
        if !paint.is_empty() {
            paint = ["gsave\n", &paint, "grestore\n"].concat();
        }
        paint += &(set_color(color)? + "stroke\n");
        text += &(number(width) + " setlinewidth\n");
    }
    if !group.pen.dash.is_empty() {
        let lengths: Vec<String> = group.pen.dash.iter().copied().map(number).collect();
        text += &["[", &lengths.join(" "), "] 0 setdash\n"].concat();
    }
    // Painting starts a new path; where nothing is painted, that has to be said.
    if paint.is_empty() {
        paint += "newpath\n";
    }
    for mark in &group.marks {
        text += &operators(scene.curves(mark)?.iter());
        text += &paint;
    }
    Ok(text + "grestore\n")
}

fn set_color(color: Color) -> Result<String> {
    if color.alpha < 255 {
        return Err(Error::Picture(PictureError::Translucent));
    }
    let [red, green, blue] = shares(color);
    Ok(if red == green && green == blue {
        red + " setgray\n"
    } else {
        [&red, &green, &blue, "setrgbcolor\n"].join(" ")
    })
}

/// Red, green and blue from 0 to 1.
pub(super) fn shares(color: Color) -> [String; 3] {
    [color.red, color.green, color.blue]
        .map(|byte| text(Precision::Fixed(4).round(f64::from(byte) / 255.0)))
}

/// A number of the frame around the curves.
pub(super) fn number(x: f64) -> String {
    significant(x, 12)
}

/// The text as a comment on a line of its own, as far as one may be; nothing for none.
fn comment(text: &str) -> String {
    let text: String = ascii(text).chars().take(LONGEST_COMMENT).collect();
    if text.is_empty() {
        text
    } else {
        format!("% {text}\n")
    }
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

/// More of Lancaster's procedures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Procedures {
    /// reportpath prints the current path, each point as x before y.
    Reporter,
    /// acos, asin, trig.acos and trig.asin, in degrees.
    Trig,
}

impl Procedures {
    const fn text(self) -> &'static str {
        match self {
            Self::Reporter => REPORTER,
            Self::Trig => TRIG,
        }
    }
}

/// PostScript procedures `drawellipse` and `drawcircle` with the rule's quarter-circle handle, after Lancaster, and these others.
///
/// # Errors
///
/// Where the rule has no quarter, or its quarter is no cubic that one number describes.
pub fn procset(rule: Rule, with: &[Procedures]) -> Result<String> {
    let piece = rule.piece(&Span::from_degrees(90.0))?;
    let one_number = piece.end_radius == 1.0
        && piece.handle.x == 1.0
        && piece.degree == crate::method::Degree::Cubic;
    if !one_number {
        let method = rule.method().unwrap_or(Method::Minimax);
        return Err(method.refuse(
            MethodError::MagicNumber,
            Remedy::Methods(&["minimax", "midpoint", "lancaster-drawellipse"]),
        ));
    }
    let error = rule.radial_error(&Span::from_degrees(90.0))?;
    let others: String = with.iter().map(|procedures| procedures.text()).collect();
    let ellipses = PROCSET
        .replace("@METHOD@", rule.id())
        .replace("@MAGIC@", &text(piece.handle.y))
        .replace("@PEAK@", &significant(rounded_up(error.peak(), 4), 4));
    Ok(ellipses + &others)
}

const PROCSET: &str = "\
%!PS
%%BeginResource: procset curveto-ellipse 1 0
% Ellipses and circles of four Bezier curves each, after Don Lancaster's procedures (2005).
%   WIDTH HEIGHT drawellipse   appends an ellipse about the origin to the current path
%   DIAMETER drawcircle        appends a circle
% Quarter-circle handle of method @METHOD@; the curves stray from the true shape by @PEAK@ of the larger radius at most.
/drawellipse {
  5 dict begin
  /magic @MAGIC@ def
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
%%EndResource
";

/// `pathforall` leaves each point with y on top: what takes from the top of the stack prints y before x, as Lancaster's does.
const REPORTER: &str = "\
%%BeginResource: procset curveto-reporter 1 0
% The current path in user space, after Don Lancaster's reporter (2005), each point as x before y.
%   reportpath   prints one operator a line: x y moveto, x y lineto, x1 y1 x2 y2 x3 y3 curveto, closepath
/reportpath {
  1 dict begin
  /say { 32 string cvs print ( ) print } def
  { exch say say (moveto\\n) print }
  { exch say say (lineto\\n) print }
  { 6 -1 1 { -1 roll say } for (curveto\\n) print }
  { (closepath\\n) print }
  pathforall flush
  end
} bind def
%%EndResource
";

/// The third side is sqrt((h-x)(h+x)), which keeps its digits where x is nearly h; his is sqrt(h^2-x^2).
const TRIG: &str = "\
%%BeginResource: procset curveto-trig 1 0
% Inverse trigonometry in degrees, after Don Lancaster (2005); his asin gives 330 for -0.5, since atan runs from 0 to 360.
%   XSIDE HYPOTENUSE acos   from 0 to 180
%   YSIDE HYPOTENUSE asin   from -90 to 90
%   COSINE trig.acos        from 0 to 180
%   SINE trig.asin          from -90 to 90
/acos { exch dup 3 1 roll 2 copy sub 3 1 roll add mul abs sqrt exch atan } bind def
/asin {
  exch dup 3 1 roll 2 copy sub 3 1 roll add mul abs sqrt atan
  dup 180 gt { 360 sub } if
} bind def
/trig.acos { 1 acos } bind def
/trig.asin { 1 asin } bind def
%%EndResource
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn raised_points_have_the_decimals_of_a_person() {
        let quadratic = QuadBez::new((0.0, 0.1), (4.122, 0.2), (0.003, 0.1));
        let cubic = raised(quadratic);
        assert_eq!([cubic.p1.x, cubic.p2.x], [2.748, 2.749]);
        assert_eq!(cubic.p1.y, 0.5 / 3.0);
        assert_eq!((cubic.p0, cubic.p3), (quadratic.p0, quadratic.p2));
        assert_ne!(quadratic.raise().p1.x, cubic.p1.x);
    }
}
