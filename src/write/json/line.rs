//! The JSON line of a drawing, which `batch` writes by the million: byte for byte that of its document, in a fraction of the time.

use kurbo::PathSeg;

use super::equation::{Term, equation_of};
use super::{DrawingDocument, RoundDocument, ShapeDocument, push_line, shape_document};
use crate::approximate::Drawing;
use crate::curve::{Curve, points_of};
use crate::error::Result;
use crate::method::Rule;
use crate::number::decimal::{After, BelowOne};
use crate::number::memo::Memo;
use crate::path;

/// Appends the line of a drawing, without the newline. The `id` is JSON already.
pub(crate) fn push_drawing(
    out: &mut Vec<u8>,
    id: Option<&str>,
    drawing: &Drawing,
    memo: &mut Memo,
) -> Result<()> {
    out.push(b'{');
    if let Some(id) = id {
        out.extend_from_slice(b"\"id\":");
        out.extend_from_slice(id.as_bytes());
        out.push(b',');
    }
    let shape = shape_document(&drawing.shape, drawing.transform);
    let known = match &shape {
        ShapeDocument::Circle(round) => Some(("circle", round)),
        ShapeDocument::Ellipse(round) => Some(("ellipse", round)),
        ShapeDocument::Arc(round) => Some(("arc", round)),
        ShapeDocument::Line { .. } | ShapeDocument::Empty => None,
    };
    let is_plain = matches!(drawing.rule, Rule::Method(_)) && drawing.rule.iteration().is_none();
    let known = known.filter(|(_, round)| round.transform.is_none() && is_plain);
    let Some((kind, round)) = known else {
        let start = out.len();
        push_line(out, &DrawingDocument::from(drawing))?;
        out.remove(start);
        return Ok(());
    };
    let mut line = LineWriter { out, memo };
    line.head(kind, round, drawing.rule);
    line.segments(&drawing.curve, &drawing.angles);
    line.error(drawing);
    if let Some(corner) = super::corner(drawing) {
        line.text(",\"corner\":");
        line.number(corner);
    }
    line.text(",\"path\":\"");
    path::push_kept(line.out, &drawing.curve, line.memo);
    line.text("\"}");
    Ok(())
}

/// A line that is being written.
struct LineWriter<'a> {
    out: &'a mut Vec<u8>,
    memo: &'a mut Memo,
}

impl LineWriter<'_> {
    fn text(&mut self, text: &str) {
        self.out.extend_from_slice(text.as_bytes());
    }

    fn number(&mut self, x: f64) {
        if x.is_finite() {
            self.memo.push(self.out, x);
        } else {
            self.text("null");
        }
    }

    fn numbers(&mut self, numbers: &[f64]) {
        self.list(numbers, |line, &x| line.number(x));
    }

    fn terms(&mut self, terms: &[Term]) {
        self.list(terms, |line, term| match *term {
            Term::Decimal(decimal) => {
                decimal.write(line.out, After::Letter, BelowOne::Plain);
            }
            Term::Float(x) => line.number(x),
        });
    }

    fn list<T>(&mut self, items: &[T], write: impl Fn(&mut Self, &T)) {
        for (i, item) in items.iter().enumerate() {
            self.out.push(if i == 0 { b'[' } else { b',' });
            write(self, item);
        }
        self.out.push(b']');
    }

    /// What stands before the segments.
    fn head(&mut self, kind: &str, round: &RoundDocument, rule: Rule) {
        self.text("\"version\":1,\"shape\":{\"kind\":\"");
        self.text(kind);
        self.text("\",\"center\":");
        self.numbers(&round.center);
        self.text(",\"radii\":");
        self.numbers(&round.radii);
        let angles = [
            (",\"rotation\":", round.rotation),
            (",\"start\":", round.start),
            (",\"sweep\":", round.sweep),
        ];
        for (key, angle) in angles {
            self.text(key);
            self.number(angle);
        }
        self.text("},\"method\":\"");
        self.text(rule.id());
    }

    fn segments(&mut self, curve: &Curve, angles: &[f64]) {
        self.text(if curve.closed {
            "\",\"closed\":true,\"segments\":["
        } else {
            "\",\"closed\":false,\"segments\":["
        });
        for (i, segment) in curve.segments.iter().enumerate() {
            if i > 0 {
                self.out.push(b',');
            }
            self.segment(segment, angles.get(i..i + 2));
        }
    }

    fn segment(&mut self, segment: &PathSeg, angles: Option<&[f64]>) {
        let (points, count) = points_of(segment);
        let points = &points[..count];
        self.text("{\"points\":");
        self.list(points, |line, p| line.numbers(&[p.x, p.y]));
        if let Some(angles) = angles {
            self.text(",\"angles\":");
            self.numbers(angles);
        }
        let [x, y] = [equation_of(points, |p| p.x), equation_of(points, |p| p.y)];
        self.text(",\"power\":{\"x\":");
        self.terms(&x.power);
        self.text(",\"y\":");
        self.terms(&y.power);
        self.text("},\"derivatives\":[");
        self.terms(&[x.slopes[0], y.slopes[0]]);
        self.out.push(b',');
        self.terms(&[x.slopes[1], y.slopes[1]]);
        self.text("]}");
    }

    fn error(&mut self, drawing: &Drawing) {
        let error = drawing.error;
        let errors = [
            ("],\"error\":{\"outward\":", error.outward),
            (",\"inward\":", error.inward),
            (",\"peak\":", error.peak()),
            (",\"relative_peak\":", drawing.relative_peak()),
        ];
        for (key, error) in errors {
            self.text(key);
            self.number(error);
        }
        self.out.push(b'}');
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{Affine, Point};

    use super::*;
    use crate::number::Precision;
    use crate::{Angle, Arc, Circle, Ellipse, Method, Options, Shape, approximate};

    fn shapes() -> Vec<Shape> {
        let degrees = Angle::from_degrees;
        let arc = |start, sweep| {
            let (start, sweep) = (degrees(start), degrees(sweep));
            Shape::Arc(Arc::new((1.5, -2.0), (3.0, 2.0), degrees(33.0), start, sweep).unwrap())
        };
        let ellipse = Ellipse::new((-7.0, 0.25), (30.0, 11.0), degrees(-20.0)).unwrap();
        let line = crate::shape::Line {
            from: Point::new(1.0, 2.0),
            to: Point::new(3.0, 0.1),
        };
        vec![
            Shape::Circle(Circle::new((-35.23, -69.83), 65.44).unwrap()),
            Shape::Ellipse(ellipse),
            arc(10.0, 200.0),
            arc(-400.0, -0.001),
            Shape::Line(line),
            Shape::Empty,
        ]
    }

    #[test]
    fn a_line_is_that_of_the_document_after_its_id() {
        let mut memo = Memo::default();
        let mut drawings = Vec::new();
        for shape in shapes() {
            for method in Method::ALL {
                for precision in [None, Some(Precision::Full), Some(Precision::Fixed(3))] {
                    for transform in [Affine::IDENTITY, Affine::rotate(0.3)] {
                        let options = Options {
                            rule: Rule::Method(method),
                            precision,
                            transform,
                            ..Options::default()
                        };
                        drawings.extend(approximate(&shape, &options).ok());
                    }
                }
            }
        }
        assert!(drawings.len() > 300, "{}", drawings.len());
        for drawing in &drawings {
            let [mut line, mut with_id, mut document] = [const { Vec::new() }; 3];
            push_drawing(&mut line, None, drawing, &mut memo).unwrap();
            push_drawing(&mut with_id, Some("[7]"), drawing, &mut memo).unwrap();
            push_line(&mut document, &DrawingDocument::from(drawing)).unwrap();
            let text = |line: Vec<u8>| String::from_utf8(line).unwrap();
            let document = text(document);
            assert_eq!(text(line), document);
            assert_eq!(text(with_id), document.replacen('{', "{\"id\":[7],", 1));
        }
    }
}
