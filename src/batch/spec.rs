//! Shapes as text: one line, either a word and numbers or a JSON object.
//!
//! ```text
//! circle CX CY R
//! ellipse CX CY RX RY [ROTATION]
//! arc CX CY R START SWEEP
//! arc CX CY RX RY ROTATION START SWEEP
//! svgarc X1 Y1 RX RY ROTATION LARGE SWEEP X2 Y2
//! bulge X1 Y1 X2 Y2 B
//! through X1 Y1 X2 Y2 X3 Y3
//! polyline X Y B X Y B ... [close]
//! path DATA
//! ```

mod json;

use kurbo::{Point, Vec2};

use crate::angle::Angle;
use crate::contour::{Contour, Step};
use crate::error::{Error, Result};
use crate::joints::Cut;
use crate::method::Method;
use crate::number::digits::EXACT_POWERS;
use crate::path::contours;
use crate::picture::figure::Look;
use crate::shape::endpoint::{SvgArc, from_bulge, through};
use crate::shape::{Arc, Circle, Ellipse, Shape};

/// What a line asks for: a shape, and with JSON what else it says about it.
#[derive(Debug, Clone)]
pub struct Spec<'a> {
    /// What is to be drawn.
    pub subject: Subject,
    /// The value of the key `id`, as it stands there.
    pub id: Option<&'a str>,
    /// The method, where the line names one.
    pub method: Option<Method>,
    /// The number of segments or the tolerance, where the line gives one.
    pub cut: Option<Cut>,
    /// Its colours and the width of its stroke, for a picture.
    pub look: Look,
}

/// What a line draws.
#[derive(Debug, Clone, PartialEq)]
pub enum Subject {
    /// A shape.
    Shape(Shape),
    /// A path: a polyline is one too.
    Path(Vec<Contour>),
}

impl<'a> Spec<'a> {
    /// Reads a line of either form.
    ///
    /// # Errors
    ///
    /// [`Error::Syntax`] with the column where the line does not parse, and what the shape itself refuses.
    ///
    /// ```
    /// use curveto::batch::spec::Spec;
    /// let text = Spec::parse("circle 0 0 50")?;
    /// let json = Spec::parse(r#"{"circle": {"center": [0,0], "radius": 50}}"#)?;
    /// assert_eq!(text.subject, json.subject);
    /// # Ok::<(), curveto::Error>(())
    /// ```
    pub fn parse(line: &'a str) -> Result<Self> {
        if line.trim_start().starts_with('{') {
            return json::from_json(line);
        }
        Ok(Self {
            subject: from_text(line)?,
            id: None,
            method: None,
            cut: None,
            look: Look::default(),
        })
    }
}

/// The most numbers that a shape has.
const MOST_NUMBERS: usize = 9;

/// The words of a line.
struct Words<'a> {
    line: &'a str,
    at: usize,
}

impl<'a> Words<'a> {
    /// The next word and where it begins.
    #[inline]
    fn next(&mut self) -> Option<(usize, &'a str)> {
        let bytes = self.line.as_bytes();
        let is_space = |byte: u8| byte == b' ' || (b'\t'..=b'\r').contains(&byte);
        while bytes.get(self.at).is_some_and(|&byte| is_space(byte)) {
            self.at += 1;
        }
        let start = self.at;
        while bytes.get(self.at).is_some_and(|&byte| !is_space(byte)) {
            self.at += 1;
        }
        (self.at > start).then(|| (start, &self.line[start..self.at]))
    }

    fn wrong(&self, at: usize, why: impl Into<String>) -> Error {
        Error::Syntax {
            what: "the shape",
            text: self.line.trim().to_owned(),
            column: self.line[..at].chars().count() + 1,
            why: why.into(),
        }
    }
}

fn from_text(line: &str) -> Result<Subject> {
    let mut words = Words { line, at: 0 };
    let Some((start, word)) = words.next() else {
        return Err(words.wrong(0, "there is no shape"));
    };
    match word {
        "path" => Ok(Subject::Path(contours(&line[words.at..])?)),
        "polyline" => polyline_from_text(words).map(Subject::Path),
        _ => shape_from_text(words, start, word).map(Subject::Shape),
    }
}

/// The words of a polyline: triples of numbers, and `close`.
fn polyline_from_text(mut words: Words) -> Result<Vec<Contour>> {
    const FORM: &str = "polyline X Y B X Y B ... [close]";
    let mut numbers = Vec::new();
    let mut closed = false;
    while let Some((at, word)) = words.next() {
        if closed {
            return Err(words.wrong(at, "nothing is expected after close"));
        }
        match (word, number(word)) {
            ("close", _) => closed = true,
            (_, Some(value)) => numbers.push(value),
            (_, None) => return Err(words.wrong(at, format!("'{word}' is not a number"))),
        }
    }
    let (vertices, rest) = numbers.as_chunks::<3>();
    if !rest.is_empty() {
        let end = words.line.trim_end().len();
        let count = numbers.len();
        return Err(words.wrong(end, format!("{count} numbers where {FORM} is expected")));
    }
    polyline(vertices, closed)
}

/// A polyline with bulges, as a DXF LWPOLYLINE: x, y and the bulge to the next vertex.
fn polyline(vertices: &[[f64; 3]], closed: bool) -> Result<Vec<Contour>> {
    let following = vertices.iter().cycle().skip(1);
    let count = vertices.len().saturating_sub(usize::from(!closed));
    let pairs = vertices.iter().zip(following).take(count);
    let steps = pairs.map(|(&[x1, y1, bulge], &[x2, y2, _])| {
        from_bulge(Point::new(x1, y1), Point::new(x2, y2), bulge)
    });
    let shapes: Vec<Shape> = steps.collect::<Result<_>>()?;
    let steps: Vec<Step> = shapes.into_iter().filter_map(Step::of_shape).collect();
    Ok(if steps.is_empty() {
        Vec::new()
    } else {
        vec![Contour { steps, closed }]
    })
}

/// The form of a line that begins with this word, and how many numbers it has.
fn form(word: &str) -> Option<(&'static str, &'static [usize])> {
    Some(match word {
        "circle" => ("circle CX CY R", &[3]),
        "ellipse" => ("ellipse CX CY RX RY [ROTATION]", &[4, 5]),
        "arc" => (
            "arc CX CY R START SWEEP or arc CX CY RX RY ROTATION START SWEEP",
            &[5, 7],
        ),
        "svgarc" => ("svgarc X1 Y1 RX RY ROTATION LARGE SWEEP X2 Y2", &[9]),
        "bulge" => ("bulge X1 Y1 X2 Y2 B", &[5]),
        "through" => ("through X1 Y1 X2 Y2 X3 Y3", &[6]),
        _ => return None,
    })
}

fn shape_from_text(mut words: Words, start: usize, word: &str) -> Result<Shape> {
    let line = words.line;
    let Some((form, counts)) = form(word) else {
        return Err(words.wrong(
            start,
            "a line begins with circle, ellipse, arc, svgarc, bulge, through, polyline or path, or is a JSON object",
        ));
    };
    let mut numbers = [0.0; MOST_NUMBERS];
    let mut places = [0; MOST_NUMBERS];
    let mut count = 0;
    while let Some((at, word)) = words.next() {
        let value = number(word).or_else(|| Some(word.parse::<Angle>().ok()?.degrees()));
        let Some(value) = value else {
            return Err(words.wrong(at, format!("'{word}' is not a number")));
        };
        if count == MOST_NUMBERS {
            return Err(words.wrong(at, format!("too many numbers for {form}")));
        }
        (numbers[count], places[count]) = (value, at);
        count += 1;
    }
    if !counts.contains(&count) {
        return Err(words.wrong(
            line.trim_end().len(),
            format!("{count} numbers where {form} is expected"),
        ));
    }
    match (word, &numbers[..count]) {
        ("circle", &[x, y, r]) => Ok(Shape::Circle(Circle::new((x, y), r)?)),
        ("ellipse", &[x, y, rx, ry]) => ellipse([x, y], [rx, ry], 0.0),
        ("ellipse", &[x, y, rx, ry, rotation]) => ellipse([x, y], [rx, ry], rotation),
        ("arc", &[x, y, r, start, sweep]) => arc([x, y], [r, r], 0.0, start, sweep),
        ("arc", &[x, y, rx, ry, rotation, start, sweep]) => {
            arc([x, y], [rx, ry], rotation, start, sweep)
        }
        ("bulge", &[x1, y1, x2, y2, bulge]) => {
            from_bulge(Point::new(x1, y1), Point::new(x2, y2), bulge)
        }
        ("through", &[x1, y1, x2, y2, x3, y3]) => {
            through(Point::new(x1, y1), Point::new(x2, y2), Point::new(x3, y3))
        }
        (_, &[x1, y1, rx, ry, rotation, large, sweep, x2, y2]) => {
            let flag = |i: usize, value: f64| match value {
                0.0 => Ok(false),
                1.0 => Ok(true),
                _ => Err(words.wrong(places[i], format!("a flag is 0 or 1, not {value}"))),
            };
            SvgArc {
                from: Point::new(x1, y1),
                radii: Vec2::new(rx, ry),
                rotation: Angle::from_degrees(rotation),
                large_arc: flag(5, large)?,
                sweep: flag(6, sweep)?,
                to: Point::new(x2, y2),
            }
            .shape()
        }
        _ => Err(words.wrong(start, format!("{form} is expected"))),
    }
}

fn point([x, y]: [f64; 2]) -> Point {
    Point::new(x, y)
}

fn ellipse(center: [f64; 2], radii: [f64; 2], rotation: f64) -> Result<Shape> {
    let rotation = Angle::from_degrees(rotation);
    let ellipse = Ellipse::new(point(center), Vec2::new(radii[0], radii[1]), rotation)?;
    Ok(Shape::Ellipse(ellipse))
}

fn arc(center: [f64; 2], radii: [f64; 2], rotation: f64, start: f64, sweep: f64) -> Result<Shape> {
    let arc = Arc::new(
        point(center),
        Vec2::new(radii[0], radii[1]),
        Angle::from_degrees(rotation),
        Angle::from_degrees(start),
        Angle::from_degrees(sweep),
    )?;
    Ok(arc.shape())
}

/// A decimal number. Up to 19 digits make a whole number and a power of ten that are both floats, whose quotient is the nearest
/// float (Clinger 1990); what is longer or has an exponent is left to the standard library.
#[inline]
fn number(word: &str) -> Option<f64> {
    let bytes = word.as_bytes();
    let negative = bytes.first() == Some(&b'-');
    let (mut whole, mut digits, mut point) = (0_u64, 0, None);
    for &byte in &bytes[usize::from(negative)..] {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            whole = whole.wrapping_mul(10).wrapping_add(u64::from(digit));
            digits += 1;
        } else if byte == b'.' && point.is_none() {
            point = Some(digits);
        } else {
            return word.parse().ok();
        }
    }
    if digits == 0 || digits > 19 || whole > 1 << 53 {
        return word.parse().ok();
    }
    let decimals = point.map_or(0, |point| digits - point);
    let value = whole as f64 / EXACT_POWERS[decimals];
    Some(if negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joints::Tolerance;

    #[test]
    fn both_forms_mean_the_same() {
        for (text, json) in [
            (
                "circle 1 2 3",
                r#"{"circle": {"center": [1,2], "radius": 3}}"#,
            ),
            ("  ellipse 0 0 3 2\r", r#"{"ellipse": {"radii": [3,2]}}"#),
            (
                "ellipse 0 0 3 2 -15",
                r#"{"ellipse": {"center": [0,0], "radii": [3,2], "rotation": -15}}"#,
            ),
            (
                "arc 1 1 5 0 0.25turn",
                r#"{"arc": {"center": [1,1], "radius": 5, "start": 0, "sweep": 90}}"#,
            ),
            (
                "arc 1 1 5 4 30 10 -90",
                r#"{"arc": {"center": [1,1], "radii": [5,4], "rotation": 30, "start": 10, "sweep": -90}}"#,
            ),
            (
                "svgarc 0 0 25 25 -30 0 1 50 -25",
                r#"{"svg_arc": {"from": [0,0], "radii": [25,25], "rotation": -30, "large_arc": false, "sweep": true, "to": [50,-25]}}"#,
            ),
            (
                "bulge 0 0 10 0 1",
                r#"{"bulge": {"from": [0,0], "to": [10,0], "bulge": 1}}"#,
            ),
            (
                "through 0 0 1 1 2 0",
                r#"{"through": [[0,0], [1,1], [2,0]]}"#,
            ),
            (
                "polyline 0 0 1 10 0 0 10 10 0 close",
                r#"{"polyline": {"vertices": [[0,0,1], [10,0,0], [10,10,0]], "closed": true}}"#,
            ),
            (
                "path M0 0L1 0A1 1 0 0 1 0 1Z",
                r#"{"path": "M0 0L1 0A1 1 0 0 1 0 1Z"}"#,
            ),
        ] {
            assert_eq!(
                Spec::parse(text).unwrap().subject,
                Spec::parse(json).unwrap().subject,
                "{text}"
            );
        }
    }

    #[test]
    fn json_lines_say_more() {
        let line = r#"{"id": {"a": [1, "x"]}, "circle": {"radius": 1}, "method": "standard", "tolerance": "0.01%"}"#;
        let spec = Spec::parse(line).unwrap();
        assert_eq!(spec.id, Some(r#"{"a": [1, "x"]}"#));
        assert_eq!(spec.method, Some(Method::Midpoint));
        assert_eq!(
            spec.cut,
            Some(Cut::Tolerance(Tolerance::Relative(0.01 / 100.0)))
        );
    }

    #[test]
    fn bad_lines_say_where_and_why() {
        for (line, column, part) in [
            ("circle 0 0", 11, "2 numbers where circle CX CY R"),
            ("circle 0 zero 5", 10, "'zero' is not a number"),
            ("square 0 0 5", 1, "begins with circle"),
            ("svgarc 0 0 1 1 0 2 0 1 1", 18, "a flag is 0 or 1"),
            (
                r#"{"circle": {"radius": 5}, "colour": 3}"#,
                34,
                "unknown field `colour`",
            ),
            (r#"{"circle": {"radius": 5}"#, 24, "ends within"),
            ("{}", 1, "one of circle, ellipse"),
        ] {
            let Err(Error::Syntax {
                column: at, why, ..
            }) = Spec::parse(line)
            else {
                panic!("{line} was read");
            };
            assert!(why.contains(part), "{line}: {why}");
            assert_eq!(at, column, "{line}: {why}");
        }
        assert!(Spec::parse("circle 0 0 -5").is_err());
        assert!(Spec::parse("circle 0 0 inf").is_err());
    }

    #[test]
    fn numbers_are_the_nearest_floats() {
        for text in [
            "0",
            "-0",
            "5",
            "-5.",
            ".5",
            "0.1",
            "123456.789",
            "9007199254740993",
            "1e3",
            "-1.5E-3",
            "0.000000000000000000000001",
            "1234567890123456789",
            "3.141592653589793238",
            "+7",
        ] {
            let expected: f64 = text.parse().unwrap();
            assert_eq!(
                number(text).map(f64::to_bits),
                Some(expected.to_bits()),
                "{text}"
            );
        }
        for text in ["", "-", ".", "1.2.3", "five", "1,5"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
