//! TikZ: a `\draw` for each curve, to stand in a `tikzpicture`. Quadratics are raised to cubics exactly.

use core::fmt::{self, Write as _};

use kurbo::{CubicBez, PathSeg, Point};

use super::postscript::raised;
use crate::curve::{Curve, control_points};
use crate::error::{Error, FormatError, Remedy, Result};
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
    let curves: Vec<&Curve> = curves.into_iter().collect();
    check_size(&curves)?;
    let mut out = String::new();
    for curve in curves {
        push_curve(&mut out, draw, curve);
    }
    Ok(out)
}

/// Refuses numbers that TeX does not take, with a factor that makes them small enough, those of the other half of a sphere too.
fn check_size(curves: &[&Curve]) -> Result<()> {
    let points = curves.iter().flat_map(|curve| &curve.segments);
    let numbers = points.flat_map(control_points).flat_map(|p| [p.x, p.y]);
    let far = numbers.fold(0.0_f64, |far, x| if x.abs() > far.abs() { x } else { far });
    if far.abs() <= LARGEST {
        return Ok(());
    }
    let exponent = libm::log10(LARGEST / 2.0 / far.abs()).floor();
    Err(Error::Format {
        format: "tikz",
        why: FormatError::Number {
            most: LARGEST,
            found: far,
        },
        remedy: Remedy::Scale(format!("1e{exponent}").parse().unwrap_or(1.0)),
    })
}

fn push_curve(out: &mut String, draw: &str, curve: &Curve) {
    let Some(start) = curve.start() else {
        return;
    };
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
            PathSeg::Quad(q) => push_cubic(out, raised(q)),
            PathSeg::Cubic(c) => push_cubic(out, c),
        };
    }
    out.push_str(if curve.closed { " -- cycle;\n" } else { ";\n" });
}

fn push_cubic(out: &mut String, c: CubicBez) -> fmt::Result {
    let [from, to, end] = [c.p1, c.p2, c.p3].map(pair);
    write!(out, ".. controls {from} and {to} .. {end}")
}

fn pair(p: Point) -> String {
    format!("({},{})", text(p.x), text(p.y))
}
