//! The JSON of a conic.

use serde::Serialize;

use crate::conic::{Conic, ConicDrawing, ConicSample, Report};
use crate::error::Result;
use crate::number::{counted, text};
use crate::path;
use crate::picture::figure::Figure;
use crate::write::csv;
use crate::write::json::{ErrorDocument, SegmentDocument, segment_document};

/// The JSON of a parabola or a hyperbola; an arc of an ellipse is written as any other arc.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConicDocument {
    /// The version of this form.
    pub version: u32,
    /// What was drawn, the transform applied.
    pub shape: ConicShapeDocument,
    /// The id of the method, or `exact` for a parabola.
    pub method: String,
    /// Whether the path is closed.
    pub closed: bool,
    /// The segments in their order.
    pub segments: Vec<SegmentDocument>,
    /// The error of the points as printed, both ways, outward being towards the control point; relative to half the longer side of
    /// the box of the three points.
    pub error: ErrorDocument,
    /// SVG path data.
    pub path: String,
}

/// A conic by its control point and weight.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConicShapeDocument {
    /// `conic`.
    pub kind: &'static str,
    /// `ellipse` (next to a parabola), `parabola` or `hyperbola`.
    pub form: &'static str,
    /// Where it starts.
    pub from: [f64; 2],
    /// Where the tangents at its ends meet.
    pub control: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// The weight of the control point.
    pub weight: f64,
}

impl From<&Conic> for ConicShapeDocument {
    fn from(conic: &Conic) -> Self {
        let [from, control, to] = [conic.from, conic.control, conic.to].map(|p| [p.x, p.y]);
        Self {
            kind: "conic",
            form: conic.kind().name(),
            from,
            control,
            to,
            weight: conic.weight,
        }
    }
}

impl From<&ConicDrawing> for ConicDocument {
    fn from(drawing: &ConicDrawing) -> Self {
        let segments = drawing.curve.segments.iter();
        Self {
            version: 1,
            shape: (&drawing.conic).into(),
            method: drawing.method_name().to_owned(),
            closed: false,
            segments: segments.map(|s| segment_document(s, None)).collect(),
            error: ErrorDocument::new(drawing.error, drawing.relative_peak()),
            path: path::data([&drawing.curve], false),
        }
    }
}

/// What is measured of a parabola or a hyperbola; an arc of an ellipse is measured as any other arc.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConicMeasurement {
    /// The version of this form.
    pub version: u32,
    /// What was drawn.
    pub shape: ConicShapeDocument,
    /// The id of the method, or `exact` for a parabola.
    pub method: String,
    /// A few words.
    pub title: String,
    /// The largest distances, both ways, as in the JSON of a drawing.
    pub error: ErrorDocument,
    /// The length and the joints.
    #[serde(flatten)]
    pub report: Report,
}

impl From<&ConicDrawing> for ConicMeasurement {
    fn from(drawing: &ConicDrawing) -> Self {
        Self {
            version: 1,
            shape: (&drawing.conic).into(),
            method: drawing.method_name().to_owned(),
            title: title(drawing),
            error: ErrorDocument::new(drawing.error, drawing.relative_peak()),
            report: drawing.report(),
        }
    }
}

fn title(drawing: &ConicDrawing) -> String {
    let count = drawing.curve.segments.len();
    let (title, method) = (Figure::of_conic(drawing).title, drawing.method_name());
    format!("{title}, {} by {method}", counted(count, "segment"))
}

/// A parabola or a hyperbola point by point; an arc of an ellipse is sampled as any other arc.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConicSamples {
    /// The version of this form.
    pub version: u32,
    /// What was drawn.
    pub shape: ConicShapeDocument,
    /// The id of the method, or `exact` for a parabola.
    pub method: String,
    /// A few words.
    pub title: String,
    /// The points, segment by segment at equal steps of t, both ends of each segment among them.
    pub samples: Vec<ConicSample>,
}

impl ConicSamples {
    /// `count` points of each segment.
    ///
    /// # Errors
    ///
    /// As [`ConicDrawing::samples`].
    pub fn new(drawing: &ConicDrawing, count: usize) -> Result<Self> {
        Ok(Self {
            version: 1,
            shape: (&drawing.conic).into(),
            method: drawing.method_name().to_owned(),
            title: title(drawing),
            samples: drawing.samples(count)?,
        })
    }
}

/// One line of CSV for each point, below a line of names.
#[must_use]
pub fn conic_samples_csv(all: &[ConicSamples]) -> String {
    let rows = all.iter().flat_map(|all| {
        all.samples.iter().map(|s| {
            let [t, x, y, error, place] = [s.at.t, s.at.x, s.at.y, s.error, s.place].map(text);
            let (form, method) = (all.shape.form.to_owned(), all.method.clone());
            let segment = s.at.segment.to_string();
            [
                form,
                text(all.shape.weight),
                method,
                segment,
                t,
                x,
                y,
                error,
                place,
            ]
        })
    });
    csv::lines("form,weight,method,segment,t,x,y,error,place", rows)
}

/// One line of CSV for each measurement, below a line of names.
#[must_use]
pub fn conic_csv(all: &[ConicMeasurement]) -> String {
    const NAMES: &str = "form,weight,method,segments,outward,inward,peak,relative_peak,length,true_length,continuity,largest_turn";
    let row = |m: &ConicMeasurement| {
        let (e, r) = (&m.error, &m.report);
        [
            m.shape.form.to_owned(),
            text(m.shape.weight),
            m.method.clone(),
            r.segments.to_string(),
            text(e.outward),
            text(e.inward),
            text(e.peak),
            text(e.relative_peak),
            text(r.length.curve),
            text(r.length.truth),
            r.continuity
                .map_or_else(String::new, |order| order.to_string()),
            text(r.largest_turn),
        ]
    };
    csv::lines(NAMES, all.iter().map(row))
}
