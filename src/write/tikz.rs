//! TikZ: a `\draw` for each curve, to stand in a `tikzpicture`. Quadratics are raised to cubics exactly.

use core::fmt::Write as _;

use kurbo::{PathSeg, Point};

use crate::curve::{Curve, control_points};
use crate::error::{Error, Remedy, Result};
use crate::number::text;

/// TeX's largest dimension is just below 16384 points, and TikZ takes no larger number.
const LARGEST: f64 = 16_383.0;

/// How many segments stand on a line: TeX reads no line of any length.
const ON_A_LINE: usize = 4;

/// The commands that draw the curves, `dashed` or not, in units of TikZ's x and y (centimetres where nothing else was said).
///
/// # Errors
///
/// Where a coordinate is larger than TeX takes.
pub fn commands<'a>(curves: impl IntoIterator<Item = &'a Curve>, dashed: bool) -> Result<String> {
    let draw = if dashed { "\\draw[dashed]" } else { "\\draw" };
    let mut out = String::new();
    for curve in curves {
        push_curve(&mut out, draw, curve)?;
    }
    Ok(out)
}

fn push_curve(out: &mut String, draw: &str, curve: &Curve) -> Result<()> {
    let Some(start) = curve.start() else {
        return Ok(());
    };
    let points = curve.segments.iter().flat_map(control_points);
    if let Some(far) = points.flat_map(|p| [p.x, p.y]).find(|x| x.abs() > LARGEST) {
        return Err(Error::Format {
            format: "tikz",
            why: format!("TeX takes no number beyond {LARGEST}, and there is {far:e}"),
            remedy: Remedy::Scale,
        });
    }
    // Writing to a string cannot fail.
    let _ = write!(out, "{draw} {}", pair(start));
    for (i, segment) in curve.segments.iter().enumerate() {
        out.push_str(if i > 0 && i % ON_A_LINE == 0 {
            "\n  "
        } else {
            " "
        });
        let _ = match *segment {
            PathSeg::Line(l) => write!(out, "-- {}", pair(l.p1)),
            PathSeg::Quad(_) | PathSeg::Cubic(_) => {
                let c = segment.to_cubic();
                let [from, to, end] = [c.p1, c.p2, c.p3].map(pair);
                write!(out, ".. controls {from} and {to} .. {end}")
            }
        };
    }
    out.push_str(if curve.closed { " -- cycle;\n" } else { ";\n" });
    Ok(())
}

fn pair(p: Point) -> String {
    format!("({},{})", text(p.x), text(p.y))
}
