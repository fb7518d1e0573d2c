//! A line of words and numbers.

use kurbo::{Point, Vec2};

use super::{LineContent, arc, ellipse, polyline};
use crate::angle::Angle;
use crate::contour::Contour;
use crate::error::{Error, Result};
use crate::number::parse as number;
use crate::path::contours;
use crate::shape::endpoint::{SvgArc, from_bulge, through};
use crate::shape::{Circle, Shape};

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

pub(super) fn from_text(line: &str) -> Result<LineContent> {
    let mut words = Words { line, at: 0 };
    let Some((start, word)) = words.next() else {
        return Err(words.wrong(0, "there is no shape"));
    };
    match word {
        "path" => Ok(LineContent::Path(contours(&line[words.at..])?)),
        "polyline" => polyline_from_text(words).map(LineContent::Path),
        _ => shape_from_text(words, start, word).map(LineContent::Shape),
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
            (_, None) => return Err(words.wrong(at, no_number(word))),
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

/// What is said of a word that is no number.
fn no_number(word: &str) -> String {
    let number = word.trim_end_matches(char::is_alphabetic);
    let why = if word.contains(',') {
        ": blanks stand between numbers, and decimals after a point"
    } else if number != word && number.parse::<f64>().is_ok() {
        ": lengths are numbers in user units, angles in degrees"
    } else {
        ""
    };
    format!("'{word}' is not a number{why}")
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

/// The numbers of a shape, each with its place.
struct ShapeNumbers {
    values: [f64; MOST_NUMBERS],
    places: [usize; MOST_NUMBERS],
    count: usize,
}

impl ShapeNumbers {
    /// Reads all that the line has left.
    fn read(words: &mut Words, form: &str) -> Result<Self> {
        let mut read = Self {
            values: [0.0; MOST_NUMBERS],
            places: [0; MOST_NUMBERS],
            count: 0,
        };
        while let Some((at, word)) = words.next() {
            let value = number(word).or_else(|| Some(word.parse::<Angle>().ok()?.degrees()));
            let Some(value) = value else {
                return Err(words.wrong(at, no_number(word)));
            };
            if read.count == MOST_NUMBERS {
                return Err(words.wrong(at, format!("too many numbers for {form}")));
            }
            (read.values[read.count], read.places[read.count]) = (value, at);
            read.count += 1;
        }
        Ok(read)
    }
}

fn shape_from_text(mut words: Words, start: usize, word: &str) -> Result<Shape> {
    let line = words.line;
    let Some((form, counts)) = form(word) else {
        let by_commas = word.split_once(',');
        let why = if by_commas.is_some_and(|(name, _)| form(name).is_some()) {
            "blanks stand between the words of a line, not commas"
        } else {
            "a line begins with circle, ellipse, arc, svgarc, bulge, through, polyline or path, or is a JSON object"
        };
        return Err(words.wrong(start, why));
    };
    let numbers = ShapeNumbers::read(&mut words, form)?;
    let count = numbers.count;
    if !counts.contains(&count) {
        return Err(words.wrong(
            line.trim_end().len(),
            format!("{count} numbers where {form} is expected"),
        ));
    }
    match (word, &numbers.values[..count]) {
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
                _ => Err(words.wrong(numbers.places[i], format!("a flag is 0 or 1, not {value}"))),
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
