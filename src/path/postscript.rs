//! PostScript path operators as contours.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use crate::angle::Angle;
use crate::contour::{Contour, ContourPen};
use crate::error::{Error, Result, TextError, finite};
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Truth};

/// Operators of drawings that have no say in where a path lies.
const HARMLESS: [&str; 18] = [
    "newpath",
    "stroke",
    "fill",
    "eofill",
    "showpage",
    "setlinewidth",
    "setlinejoin",
    "setlinecap",
    "setmiterlimit",
    "setdash",
    "setgray",
    "setrgbcolor",
    "setcmykcolor",
    "setflat",
    "clip",
    "save",
    "restore",
    "pop",
];

/// The contours of PostScript path operators, one for each subpath that draws something, with `translate`, `scale`, `rotate`,
/// `concat`, `gsave` and `grestore` obeyed.
///
/// # Errors
///
/// Where an operator lacks its numbers, a number is not finite or beyond 1e150, a sweep is more than a turn, or a word is none of a plain
/// drawing: procedures are not executed.
///
/// ```
/// let contours = curveto::path::postscript("50 0 moveto 50 27.6 27.6 50 0 50 curveto closepath")?;
/// assert_eq!(contours[0].steps.len(), 2);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn postscript(text: &str) -> Result<Vec<Contour>> {
    let mut machine = Machine::default();
    for (i, line) in text.lines().enumerate() {
        let code = line.split('%').next().unwrap_or_default();
        let spaced = code.replace('[', " [ ").replace(']', " ] ");
        for word in spaced.split_ascii_whitespace() {
            machine.take(word).map_err(|error| {
                let why = Box::new(error);
                Error::Text(TextError::PostScript { line: i + 1, why })
            })?;
        }
    }
    Ok(machine.pen.contours())
}

#[derive(Default)]
struct Machine {
    pen: ContourPen,
    /// Whether there is a current point.
    has_point: bool,
    numbers: Vec<f64>,
    map: Affine,
    saved: Vec<Affine>,
}

impl Machine {
    fn take(&mut self, word: &str) -> Result<()> {
        if let Ok(number) = word.parse::<f64>() {
            self.numbers.push(finite("number", number)?);
            return Ok(());
        }
        // The brackets of a matrix or of a dash.
        if word == "[" || word == "]" {
            return Ok(());
        }
        match word {
            "moveto" => self.move_to(word, false)?,
            "rmoveto" => self.move_to(word, true)?,
            "lineto" | "rlineto" => {
                let [to] = self.points(word, word == "rlineto")?;
                self.pen.line(to);
            }
            "curveto" | "rcurveto" => {
                let [a, b, to] = self.points(word, word == "rcurveto")?;
                let cubic = CubicBez::new(self.pen.here(), a, b, to);
                self.pen.segment(PathSeg::Cubic(cubic));
            }
            "arc" | "arcn" => self.arc(word)?,
            "closepath" => self.pen.close(),
            "gsave" => self.saved.push(self.map),
            "grestore" => self.map = self.saved.pop().unwrap_or(self.map),
            "translate" => {
                let [x, y] = self.last(word)?;
                self.map *= Affine::translate(Vec2::new(x, y));
            }
            "scale" => {
                let [x, y] = self.last(word)?;
                self.map *= Affine::scale_non_uniform(x, y);
            }
            "rotate" => {
                let [degrees] = self.last(word)?;
                let v = crate::Angle::from_degrees(degrees).direction();
                self.map *= Affine::new([v.x, v.y, -v.y, v.x, 0.0, 0.0]);
            }
            "concat" => self.map *= Affine::new(self.last(word)?),
            _ if HARMLESS.contains(&word) => {}
            _ => {
                return Err(Error::Text(TextError::Operator(word.to_owned())));
            }
        }
        self.numbers.clear();
        Ok(())
    }

    /// The last numbers on the stack.
    fn last<const N: usize>(&self, word: &str) -> Result<[f64; N]> {
        let numbers = self.numbers.last_chunk().copied();
        numbers.ok_or_else(|| self.too_few(word, N))
    }

    fn too_few(&self, operator: &str, takes: usize) -> Error {
        Error::Text(TextError::Operands {
            operator: operator.to_owned(),
            takes,
            count: self.numbers.len(),
        })
    }

    fn points<const N: usize>(&self, word: &str, relative: bool) -> Result<[Point; N]> {
        let numbers = self.numbers.as_slice();
        let Some(at) = numbers.len().checked_sub(2 * N) else {
            return Err(self.too_few(word, 2 * N));
        };
        let [a, b, c, d, _, _] = self.map.as_coeffs();
        let mut points = [Point::ZERO; N];
        for (point, pair) in points.iter_mut().zip(numbers[at..].as_chunks::<2>().0) {
            let given = Point::new(pair[0], pair[1]);
            *point = if relative {
                let v = given.to_vec2();
                self.pen.here() + Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y)
            } else {
                self.map * given
            };
        }
        Ok(points)
    }

    fn move_to(&mut self, word: &str, relative: bool) -> Result<()> {
        let [to] = self.points(word, relative)?;
        self.pen.move_to(to);
        self.has_point = true;
        Ok(())
    }

    /// An arc, after a line to its start where there is a current point: in thirds, which their ends and radii determine.
    fn arc(&mut self, word: &str) -> Result<()> {
        let [x, y, radius, start, end] = self.last(word)?;
        let [start, end] = [start, end].map(Angle::from_degrees);
        let sweep = start.sweep_to(end, word == "arcn");
        let arc = Arc::new((x, y), (radius, radius), Angle::ZERO, start, sweep)?;
        let map = self.map * Affine::translate(arc.center.to_vec2()) * Affine::scale(radius);
        let truth = Truth::of(map)?;
        let at = |third: u8| {
            let angle = start.degrees() + arc.sweep.degrees() * f64::from(third) / 3.0;
            map * Angle::from_degrees(angle).direction().to_point()
        };
        if !self.has_point {
            self.pen.move_to(at(0));
            self.has_point = true;
        } else if self.pen.here() != at(0) {
            self.pen.line(at(0));
        }
        for third in 1..=3 {
            self.pen.arc(&SvgArc {
                from: self.pen.here(),
                radii: truth.radii,
                rotation: Angle::of(truth.axis),
                large_arc: false,
                sweep: (sweep.degrees() > 0.0) == (self.map.determinant() > 0.0),
                to: at(third),
            })?;
        }
        Ok(())
    }
}
