//! JSON, with the one formatter of numbers.

mod equation;
#[cfg(feature = "batch")]
mod line;

use std::io::{self, Write};

use kurbo::{Affine, PathSeg, Point};
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use crate::approximate::Drawing;
use crate::continuity::Continuity;
use crate::curve::control_points;
use crate::error::{Error, Result};
use crate::method::Quadrature;
use crate::number::push_shortest;
use crate::path;
use crate::radial_error::RadialError;
use crate::shape::Shape;

use equation::{Term, equation_of};
#[cfg(feature = "batch")]
pub(crate) use line::push_drawing;

/// The JSON of a drawing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawingDocument {
    /// The version of this form.
    pub version: u32,
    /// What was asked for.
    pub shape: ShapeDocument,
    /// The id of the method, or `handle`.
    pub method: String,
    /// The literal handle, with the method `handle`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub handle: Option<f64>,
    /// How arc length was integrated, where it was Chen's two-point Gauss quadrature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quadrature: Option<String>,
    /// In how many rounds the arc lengths of `chen-2` settled on a circle or its arc; left out beyond a thousand segments.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounds: Option<usize>,
    /// These lengths round by round, the first with the chords; a number for each segment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lengths: Option<Vec<Vec<f64>>>,
    /// Whether the path is closed.
    pub closed: bool,
    /// The segments in their order.
    pub segments: Vec<SegmentDocument>,
    /// The error of the points as printed.
    pub error: ErrorDocument,
    /// The largest corner at a joint, in degrees, where the method's pieces do not share tangents.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<f64>,
    /// SVG path data.
    pub path: String,
}

/// The shape of a drawing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum ShapeDocument {
    /// A whole circle.
    Circle(RoundDocument),
    /// A whole ellipse.
    Ellipse(RoundDocument),
    /// An arc.
    Arc(RoundDocument),
    /// A straight line.
    Line {
        /// Its first point.
        from: [f64; 2],
        /// Its last point.
        to: [f64; 2],
    },
    /// Nothing.
    Empty,
}

/// A circle, an ellipse or an arc; angles in degrees.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RoundDocument {
    /// The centre.
    pub center: [f64; 2],
    /// The radii along the shape's own axes.
    pub radii: [f64; 2],
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: f64,
    /// The parametric angle of the first point.
    pub start: f64,
    /// How far it runs.
    pub sweep: f64,
    /// The affine map applied to it, as SVG's matrix(a b c d e f), where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transform: Option<[f64; 6]>,
}

/// One segment.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SegmentDocument {
    /// Its control points: two of a line, three of a quadratic, four of a cubic.
    pub points: Vec<[f64; 2]>,
    /// The parametric angles of its ends, in degrees, where the shape has angles.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angles: Option<[f64; 2]>,
    /// Lancaster's equation space.
    pub power: PowerDocument,
    /// The derivatives at its ends by its parameter from 0 to 1, which are with its end points Chen's form (1) of a cubic.
    pub derivatives: [[f64; 2]; 2],
}

/// Lancaster's equation-space coefficients: x = At³+Bt²+Ct+D and y = Et³+Ft²+Gt+H.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PowerDocument {
    /// [A, B, C, D].
    pub x: [f64; 4],
    /// [E, F, G, H].
    pub y: [f64; 4],
}

/// The largest distances from the true shape, in user units, both at least 0.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ErrorDocument {
    /// Outside the true shape.
    pub outward: f64,
    /// Inside the true shape.
    pub inward: f64,
    /// The larger of the two.
    pub peak: f64,
    /// The larger of the two over the larger radius.
    pub relative_peak: f64,
}

impl ErrorDocument {
    pub(super) fn new(error: RadialError, relative_peak: f64) -> Self {
        Self {
            outward: error.outward,
            inward: error.inward,
            peak: error.peak(),
            relative_peak,
        }
    }
}

impl From<&Drawing> for DrawingDocument {
    fn from(drawing: &Drawing) -> Self {
        let segments = drawing
            .curve
            .segments
            .iter()
            .enumerate()
            .map(|(i, segment)| {
                let angles = drawing.angles.get(i..).and_then(<[f64]>::first_chunk);
                segment_document(segment, angles.copied())
            });
        let (iteration, lengths) = (drawing.rule.iteration(), drawing.lengths());
        Self {
            version: 1,
            shape: shape_document(&drawing.shape, drawing.transform),
            method: drawing.rule.id().to_owned(),
            handle: drawing.rule.handle(),
            quadrature: iteration
                .is_some_and(|iteration| iteration.quadrature == Quadrature::Gauss2)
                .then(|| "gauss2".to_owned()),
            rounds: lengths
                .as_ref()
                .map(|lengths| lengths.len().saturating_sub(1)),
            lengths,
            closed: drawing.curve.closed,
            segments: segments.collect(),
            error: ErrorDocument::new(drawing.error, drawing.relative_peak()),
            corner: corner(drawing),
            path: path::data([&drawing.curve], false),
        }
    }
}

/// The largest corner, where a method may make some.
fn corner(drawing: &Drawing) -> Option<f64> {
    let method = drawing.rule.method()?;
    let corners = method.card().continuity_equal == Continuity::G0;
    corners.then(|| drawing.largest_corner())
}

fn pair(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

/// The JSON of a shape under a transform.
#[must_use]
pub fn shape_document(shape: &Shape, transform: Affine) -> ShapeDocument {
    let round = |outline: Option<crate::shape::Outline>, rotation: f64| {
        let (unit, truth) = outline.map_or_else(Default::default, |o| {
            (
                (o.unit.start.degrees(), o.unit.sweep.degrees()),
                (pair(o.truth.center), [o.truth.radii.x, o.truth.radii.y]),
            )
        });
        RoundDocument {
            center: truth.0,
            radii: truth.1,
            rotation,
            start: unit.0,
            sweep: unit.1,
            transform: (transform != Affine::IDENTITY).then(|| transform.as_coeffs()),
        }
    };
    match shape {
        Shape::Circle(_) => ShapeDocument::Circle(round(shape.outline(), 0.0)),
        Shape::Ellipse(e) => ShapeDocument::Ellipse(round(shape.outline(), e.rotation.degrees())),
        Shape::Arc(a) => ShapeDocument::Arc(round(shape.outline(), a.rotation.degrees())),
        Shape::Line(l) => ShapeDocument::Line {
            from: pair(l.from),
            to: pair(l.to),
        },
        Shape::Empty => ShapeDocument::Empty,
    }
}

/// The JSON of one segment.
#[must_use]
pub fn segment_document(segment: &PathSeg, angles: Option<[f64; 2]>) -> SegmentDocument {
    let points = control_points(segment);
    let [x, y] = [equation_of(&points, |p| p.x), equation_of(&points, |p| p.y)];
    SegmentDocument {
        power: PowerDocument {
            x: x.power.map(Term::value),
            y: y.power.map(Term::value),
        },
        derivatives: [0, 1].map(|end| [x.slopes[end].value(), y.slopes[end].value()]),
        points: points.into_iter().map(pair).collect(),
        angles,
    }
}

/// Any value as JSON for people and programs: the outermost object a line a key, the objects of an array a line each.
///
/// # Errors
///
/// Where the value cannot be JSON ([`Error::Json`]).
pub fn to_string(value: &impl Serialize) -> Result<String> {
    text(|out| serialize(out, value, Layout::default()))
}

/// Any value as one line of JSON.
///
/// # Errors
///
/// Where the value cannot be JSON ([`Error::Json`]).
pub fn to_line(value: &impl Serialize) -> Result<String> {
    text(|out| push_line(out, value))
}

fn text(push: impl FnOnce(&mut Vec<u8>) -> Result<()>) -> Result<String> {
    let mut out = Vec::new();
    push(&mut out)?;
    // A serializer writes UTF-8, so that this cannot fail and need not copy.
    Ok(String::from_utf8(out).unwrap_or_default())
}

/// Appends any value as one line of JSON, without the newline.
pub(crate) fn push_line(out: &mut Vec<u8>, value: &impl Serialize) -> Result<()> {
    let layout = Layout {
        one_line: true,
        ..Layout::default()
    };
    serialize(out, value, layout)
}

fn serialize(out: &mut Vec<u8>, value: &impl Serialize, layout: Layout) -> Result<()> {
    value
        .serialize(&mut Serializer::with_formatter(out, layout))
        .map_err(|error| Error::Json(error.to_string()))
}

/// The layout of our JSON, and our numbers in it.
#[derive(Default)]
struct Layout {
    one_line: bool,
    objects: usize,
    arrays: usize,
    holds_objects: bool,
    /// The digits of a number, so that memory is asked for once.
    digits: Vec<u8>,
}

impl Layout {
    /// Whether the innermost object is the outermost one and gets a line for each key.
    fn is_outermost(&self) -> bool {
        self.objects == 1 && !self.one_line
    }
}

impl Formatter for Layout {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        self.digits.clear();
        push_shortest(&mut self.digits, value);
        writer.write_all(&self.digits)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        if self.arrays == 1 && self.is_outermost() {
            self.holds_objects = true;
            writer.write_all(b"\n    ")?;
        }
        self.objects += 1;
        writer.write_all(b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        if self.is_outermost() {
            writer.write_all(b"\n")?;
        }
        self.objects -= 1;
        writer.write_all(b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        writer.write_all(match (self.is_outermost(), first) {
            (true, true) => b"\n  ",
            (true, false) => b",\n  ",
            (false, true) => b"",
            (false, false) if self.one_line => b",",
            (false, false) => b", ",
        })
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(if self.one_line { b":" } else { b": " })
    }

    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.arrays += 1;
        writer.write_all(b"[")
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.arrays -= 1;
        if self.arrays == 0 && self.is_outermost() && core::mem::take(&mut self.holds_objects) {
            writer.write_all(b"\n  ")?;
        }
        writer.write_all(b"]")
    }
}
