//! The JSON of a spline.

use kurbo::{Affine, PathSeg};
use serde::{Serialize, Serializer};

use super::SplineDrawing;
use crate::path;
use crate::spline::{Parametrization, Quadrature, Spline, SplineEnds};
use crate::write::json::{PowerDocument, segment_document};

/// The JSON of a spline.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SplineDocument<'a> {
    /// The version of this form.
    pub version: u32,
    /// The points that the curve runs through, as they were given.
    #[serde(serialize_with = "points")]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 2]>"))]
    pub points: &'a Spline,
    /// The derivative at each point with respect to the parameter, before any map.
    #[serde(serialize_with = "derivatives")]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 2]>"))]
    pub derivatives: &'a Spline,
    /// `uniform`, `chord`, `centripetal` or `arc-length`.
    pub parametrization: &'static str,
    /// How arc length was integrated, where it was Chen's two-point Gauss quadrature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quadrature: Option<&'static str>,
    /// In how many rounds the arc lengths settled, where they are the parameter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounds: Option<usize>,
    /// The arc lengths round by round, the first with the chords; left out beyond a million numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lengths: Option<&'a [Vec<f64>]>,
    /// Whether the nodal derivatives were made unit vectors.
    pub unit_tangents: bool,
    /// `cyclic`, `free`, `natural` or `fixed`.
    pub ends: &'static str,
    /// The derivatives at the first and the last point that fixed ends were given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_derivatives: Option<[[f64; 2]; 2]>,
    /// The affine map applied to the control points, as SVG's matrix(a b c d e f), where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transform: Option<[f64; 6]>,
    /// Whether the path is closed.
    pub closed: bool,
    /// The segments in their order.
    #[serde(serialize_with = "segments")]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<SplineSegmentDocument>"))]
    pub segments: &'a SplineDrawing<'a>,
    /// SVG path data.
    pub path: String,
}

/// One segment of a spline.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SplineSegmentDocument {
    /// Its four control points.
    pub points: Vec<[f64; 2]>,
    /// How far the parameter runs along it, before any map.
    pub parameter_length: f64,
    /// Lancaster's equation space.
    pub power: PowerDocument,
}

impl<'a> SplineDocument<'a> {
    /// The document of a spline that was drawn.
    #[must_use]
    pub fn new(drawing: &'a SplineDrawing<'a>) -> Self {
        let &SplineDrawing {
            spline,
            ref curve,
            transform,
        } = drawing;
        let options = &spline.options;
        let gauss2 = options.parametrization == Parametrization::ArcLength(Quadrature::Gauss2);
        let (ends, end_derivatives) = match options.ends {
            SplineEnds::Cyclic => ("cyclic", None),
            SplineEnds::Free => ("free", None),
            SplineEnds::Natural => ("natural", None),
            SplineEnds::Fixed(given) => ("fixed", Some(given.map(|d| [d.x, d.y]))),
        };
        Self {
            version: 1,
            points: spline,
            derivatives: spline,
            parametrization: options.parametrization.name(),
            quadrature: gauss2.then_some("gauss2"),
            rounds: (spline.rounds > 0).then_some(spline.rounds),
            lengths: (!spline.history.is_empty()).then_some(&spline.history),
            unit_tangents: options.unit_tangents,
            ends,
            end_derivatives,
            transform: (transform != Affine::IDENTITY).then(|| transform.as_coeffs()),
            closed: options.ends == SplineEnds::Cyclic,
            segments: drawing,
            path: path::data([curve], false),
        }
    }
}

// A million points are not kept a second time: these serialize as they go.

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes references to fields"
)]
fn points<S: Serializer>(spline: &&Spline, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(spline.points.iter().map(|p| [p.x, p.y]))
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes references to fields"
)]
fn derivatives<S: Serializer>(spline: &&Spline, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(spline.derivatives.iter().map(|d| [d.x, d.y]))
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes references to fields"
)]
fn segments<S: Serializer>(drawing: &&SplineDrawing, serializer: S) -> Result<S::Ok, S::Error> {
    let document = |(segment, &parameter_length): (&PathSeg, &f64)| {
        let segment = segment_document(segment, None);
        SplineSegmentDocument {
            points: segment.points,
            parameter_length,
            power: segment.power,
        }
    };
    let segments = drawing.curve.segments.iter();
    serializer.collect_seq(segments.zip(&drawing.spline.lengths).map(document))
}
