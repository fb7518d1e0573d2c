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
mod text;

use kurbo::{Point, Vec2};

use crate::angle::Angle;
use crate::contour::{Contour, Step};
use crate::error::Result;
use crate::joints::Cut;
use crate::method::Method;
use crate::picture::figure::Look;
use crate::shape::endpoint::from_bulge;
use crate::shape::{Arc, Ellipse, Shape};

/// What a line asks for: a shape, and with JSON what else it says about it.
#[derive(Debug, Clone)]
pub struct Spec<'a> {
    /// What is to be drawn.
    pub subject: LineContent,
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
pub enum LineContent {
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
    /// [`crate::Error::Syntax`] with the column where the line does not parse, and what the shape itself refuses.
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
            subject: text::from_text(line)?,
            id: None,
            method: None,
            cut: None,
            look: Look::default(),
        })
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::joints::Tolerance;
    use crate::number::parse as number;

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
        let line = r#"{"circle": {"radius": 1}, "tolerance": 0.25}"#;
        let cut = Spec::parse(line).unwrap().cut;
        assert_eq!(cut, Some(Cut::Tolerance(Tolerance::Absolute(0.25))));
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
                "no key 'colour'",
            ),
            (r#"{"circle": {"radius": 5}"#, 24, "ends within"),
            ("{}", 1, "one of circle, ellipse"),
            (
                r#"{"circle": {"radius": 5}, "path": "M0 0L1 1"}"#,
                1,
                "one of circle, ellipse",
            ),
            ("circle 0 0 5mm", 12, "'5mm' is not a number: lengths are"),
            ("circle 0 0 5,5", 12, "'5,5' is not a number: blanks stand"),
        ] {
            let Err(Error::Syntax {
                column: at, why, ..
            }) = Spec::parse(line)
            else {
                panic!("{line} was read");
            };
            assert!(why.contains(part), "{line}: {why}");
            assert_eq!(at, column, "{line}: {why}");
            assert_eq!(why.contains("lengths are"), line.contains("mm"), "{why}");
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
