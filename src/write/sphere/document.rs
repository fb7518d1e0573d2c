//! The JSON of a sphere.

use kurbo::Affine;
use serde::Serialize;

use crate::path;
use crate::picture::figure::{Figure, Hidden};
use crate::sphere::{Part, SphereLine, SphereView};
use crate::write::json::{ErrorDocument, SegmentDocument, segment_document};

/// The JSON of a sphere.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SphereDocument {
    /// The version of this form.
    pub version: u32,
    /// What was asked for.
    pub shape: SphereShapeDocument,
    /// From where it is seen.
    pub view: ViewDocument,
    /// The id of the method.
    pub method: String,
    /// What lies before the limb.
    pub front: Vec<PartDocument>,
    /// What lies behind it; empty where it was to be left out.
    pub back: Vec<PartDocument>,
    /// The outline.
    pub outline: PartDocument,
    /// Bounds of the distances of the points as printed from the true circles as they are seen; relative to the radius as it is seen.
    pub error: ErrorDocument,
    /// SVG path data of everything, in the order in which it is drawn.
    pub path: String,
}

/// A sphere.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SphereShapeDocument {
    /// `sphere`.
    pub kind: &'static str,
    /// Where its centre is seen.
    pub center: [f64; 2],
    /// Its radius.
    pub radius: f64,
    /// The number of meridians, each from pole to pole.
    pub meridians: usize,
    /// The number of parallels.
    pub parallels: usize,
    /// The affine map applied to what is seen, as SVG's matrix(a b c d e f), where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transform: Option<[f64; 6]>,
}

/// The point of the sphere in the middle, in degrees.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ViewDocument {
    /// Its longitude.
    pub longitude: f64,
    /// Its latitude.
    pub latitude: f64,
}

/// A part of a line on the sphere, between points at which it meets the limb, or the whole of it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PartDocument {
    /// `parallel`, `meridian` or `outline`.
    pub line: &'static str,
    /// The latitude of a parallel, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub latitude: Option<f64>,
    /// The longitude of a meridian, in degrees; where meridians come in opposite pairs the line is both.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub longitude: Option<f64>,
    /// Whether it is a whole circle.
    pub closed: bool,
    /// The segments in their order.
    pub segments: Vec<SegmentDocument>,
}

impl SphereDocument {
    /// The document of a picture.
    #[must_use]
    pub fn new(picture: &SphereView, hidden: Hidden) -> Self {
        let parts = |parts: &[Part]| parts.iter().map(part_document).collect();
        let (sphere, transform) = (&picture.sphere, picture.options.transform);
        Self {
            version: 1,
            shape: SphereShapeDocument {
                kind: "sphere",
                center: [sphere.center.x, sphere.center.y],
                radius: sphere.radius,
                meridians: sphere.meridians,
                parallels: sphere.parallels,
                transform: (transform != Affine::IDENTITY).then(|| transform.as_coeffs()),
            },
            view: ViewDocument {
                longitude: picture.view.longitude.degrees(),
                latitude: picture.view.latitude.degrees(),
            },
            method: picture.options.rule.id().to_owned(),
            front: parts(&picture.front),
            back: if hidden == Hidden::None {
                Vec::new()
            } else {
                parts(&picture.back)
            },
            outline: part_document(&picture.outline),
            error: ErrorDocument::new(picture.error, picture.relative_peak()),
            path: path::data(Figure::of_sphere(picture, hidden).curves(), false),
        }
    }
}

fn part_document(part: &Part) -> PartDocument {
    let (line, latitude, longitude) = match part.line {
        SphereLine::Parallel(latitude) => ("parallel", Some(latitude.degrees()), None),
        SphereLine::Meridian(longitude) => ("meridian", None, Some(longitude.degrees())),
        SphereLine::Outline => ("outline", None, None),
    };
    PartDocument {
        line,
        latitude,
        longitude,
        closed: part.curve.closed,
        segments: part
            .curve
            .segments
            .iter()
            .map(|segment| segment_document(segment, None))
            .collect(),
    }
}
