//! Path data for a shape: exact vertices, rounded control points, and of the absolute and the relative form the shorter.

use kurbo::Point;

use crate::curve::{control_points, segment_of};
use crate::document::path::beziers::{Beziers, arguments};
use crate::document::shape::length::Length;
use crate::measure::radial;
use crate::number::decimal::{BelowOne, Decimal};
use crate::path::PathText;
use crate::shape::Truth;

/// A point by its digits.
type ExactPoint = [Decimal; 2];

/// Writes the path data of one shape.
pub(in crate::document) struct ShapeText<'a> {
    out: &'a mut Vec<u8>,
    text: PathText,
    /// The decimals of control points.
    pub(in crate::document) decimals: u32,
    /// The precision asked for: then every number is rounded to it.
    asked: Option<u32>,
    /// What offsets are counted from.
    pub(in crate::document) base: [Length; 2],
    /// Offsets whose digits are known: a point there is written exactly.
    pub(in crate::document) known: [Length; 2],
    /// Where curves end, where that is known otherwise: lines end there too.
    pub(in crate::document) end: Option<ExactPoint>,
    current: ExactPoint,
    /// What curves are measured against, and how far they lie from it at most.
    pub(in crate::document) truth: Option<Truth>,
    strayed: f64,
}

/// Writes points, counted from the origin where there is one.
fn push_points(
    text: &mut PathText,
    out: &mut Vec<u8>,
    points: &[ExactPoint],
    origin: Option<ExactPoint>,
) {
    for point in points {
        for (axis, number) in point.iter().enumerate() {
            text.push(
                out,
                origin.map_or(*number, |origin| number.minus(origin[axis])),
            );
        }
    }
}

impl<'a> ShapeText<'a> {
    /// One that rounds control points to `decimals`, or everything to the precision that was asked for.
    pub(in crate::document) fn new(asked: Option<u8>, decimals: u32, out: &'a mut Vec<u8>) -> Self {
        Self {
            out,
            text: PathText::new(BelowOne::Short),
            decimals,
            asked: asked.map(u32::from),
            base: [Length::zero(); 2],
            known: [Length::zero(); 2],
            end: None,
            current: [Length::zero().exact; 2],
            truth: None,
            strayed: 0.0,
        }
    }

    fn rounded(&self, place: ExactPoint) -> ExactPoint {
        place.map(|number| match self.asked {
            Some(decimals) if number.decimals > decimals => {
                Decimal::round(number.value(), decimals)
            }
            _ => number,
        })
    }

    /// The place at an offset from the base.
    pub(in crate::document) fn place(&self, offset: Point) -> ExactPoint {
        let axis = |value: f64, base: &Length, known: &Length| {
            let rounded = if value == known.value {
                known.exact
            } else if value == -known.value {
                known.exact.negated()
            } else if let Some(decimals) = self.asked {
                return Decimal::round(value + base.value, decimals);
            } else {
                Decimal::round(value, self.decimals)
            };
            base.exact.plus(rounded)
        };
        self.rounded([
            axis(offset.x, &self.base[0], &self.known[0]),
            axis(offset.y, &self.base[1], &self.known[1]),
        ])
    }

    /// Whether all control points are alike along an axis where they are written.
    pub(in crate::document) fn is_flat(&self, drawn: &Beziers) -> bool {
        let points = drawn.segments.iter().flat_map(control_points);
        let mut places = points.map(|point| self.place(point).map(Decimal::value));
        places.next().is_some_and(|[x, y]| {
            let apart = places.fold([false; 2], |[by_x, by_y], at| {
                [by_x || at[0] != x, by_y || at[1] != y]
            });
            apart.contains(&false)
        })
    }

    /// Begins the path.
    pub(in crate::document) fn move_to(&mut self, place: ExactPoint) {
        self.current = self.rounded(place);
        self.text.letter(self.out, b'M');
        push_points(&mut self.text, self.out, &[self.current], None);
    }

    /// A line along an axis.
    pub(in crate::document) fn line_to(&mut self, letter: u8, place: ExactPoint) {
        self.current = self.rounded(place);
        self.text.letter(self.out, letter);
        self.text
            .push(self.out, self.current[usize::from(letter == b'V')]);
    }

    /// Curves; where they close the path the last one is absolute, so that it ends on the first point digit for digit.
    pub(in crate::document) fn curves(&mut self, drawn: &Beziers, closes: bool) {
        let letter = if drawn.is_quadratic() { b'q' } else { b'c' };
        let (mut absolute, mut relative) = (Vec::new(), Vec::new());
        let mut before = Point::ZERO;
        for (i, segment) in (1..).zip(&drawn.segments) {
            let (points, count) = arguments(segment);
            let mut places = points.map(|point| self.place(point));
            if let Some(end) = self.end {
                if i == drawn.segments.len() {
                    places[count - 1] = self.rounded(end);
                }
                // A handle along a side lies on its line, wherever rounding by itself would bring it.
                let ends = [
                    (0, before, self.current),
                    (count - 2, points[count - 1], places[count - 1]),
                ];
                for (handle, end, place) in ends {
                    let along = self.shared(points[handle], end);
                    for axis in [0, 1].into_iter().filter(|&axis| along[axis]) {
                        places[handle][axis] = place[axis];
                    }
                }
                before = points[count - 1];
            }
            let places = &places[..count];
            self.measure(places);
            let (mut text_absolute, mut text_relative) = (self.text, self.text);
            absolute.clear();
            text_absolute.letter(&mut absolute, letter.to_ascii_uppercase());
            push_points(&mut text_absolute, &mut absolute, places, None);
            relative.clear();
            text_relative.letter(&mut relative, letter);
            push_points(
                &mut text_relative,
                &mut relative,
                places,
                Some(self.current),
            );
            let last = closes && i == drawn.segments.len();
            let (chosen, text) = if last || absolute.len() <= relative.len() {
                (&absolute, text_absolute)
            } else {
                (&relative, text_relative)
            };
            self.out.extend_from_slice(chosen);
            self.text = text;
            self.current = places.last().copied().unwrap_or(self.current);
        }
    }

    /// Which coordinates two offsets share, but for the rounding of sums.
    fn shared(&self, a: Point, b: Point) -> [bool; 2] {
        let sizes = [0, 1].map(|axis| self.base[axis].value.abs() + self.known[axis].value);
        let is_shared = |apart: f64, size: f64| apart.abs() <= 16.0 * f64::EPSILON * size;
        [
            is_shared(a.x - b.x, sizes[0]),
            is_shared(a.y - b.y, sizes[1]),
        ]
    }

    /// Measures a segment from the current point, where there is something to measure it against.
    fn measure(&mut self, places: &[ExactPoint]) {
        let Some(truth) = &self.truth else { return };
        let point = |place: &ExactPoint| Point::new(place[0].value(), place[1].value());
        let points: Vec<Point> = [&self.current]
            .into_iter()
            .chain(places)
            .map(point)
            .collect();
        let segment = segment_of(&points);
        self.strayed = self.strayed.max(radial::error([&segment], truth).peak());
    }

    /// Closes the path and tells how far its curves lie from what they were measured against.
    pub(in crate::document) fn close(self) -> f64 {
        self.out.push(b'Z');
        self.strayed
    }
}
