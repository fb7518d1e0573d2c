//! A sphere as a figure and as JSON.

use kurbo::Affine;
use schemars::JsonSchema;
use serde::Serialize;

use super::json::{ErrorDocument, SegmentDocument, segment_document};
use super::{Figure, Layer};
use crate::number::{significant, text};
use crate::path;
use crate::sphere::{Line, Part, Picture};

/// What becomes of the hidden halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hidden {
    /// They are drawn like the others.
    Show,
    /// They are drawn dashed.
    #[default]
    Dash,
    /// They are left out.
    None,
}

impl Figure {
    /// A sphere as layers with the classes `outline`, `back` and `front`, those beneath first.
    #[must_use]
    pub fn of_sphere(picture: &Picture, hidden: Hidden) -> Self {
        let lines = |class, dashed, parts: &[Part]| Layer {
            class: Some(class),
            dashed,
            fine: true,
            curves: parts.iter().map(|part| part.curve.clone()).collect(),
        };
        let mut layers = vec![Layer {
            class: Some("outline"),
            curves: vec![picture.outline.curve.clone()],
            ..Layer::default()
        }];
        if hidden != Hidden::None {
            layers.push(lines("back", hidden == Hidden::Dash, &picture.back));
        }
        layers.push(lines("front", false, &picture.front));
        layers.retain(|layer| !layer.curves.is_empty());
        let title = format!("Sphere of radius {}", text(picture.sphere.radius));
        Self {
            description: describe(picture, &title),
            title,
            layers,
            truths: Vec::new(),
        }
    }
}

fn describe(picture: &Picture, title: &str) -> String {
    format!(
        "{title} seen from longitude {longitude}, latitude {latitude} degrees; {meridians} meridians and {parallels} parallels by {method}; in space within {peak} of the true circles ({relative} of the radius)",
        longitude = text(picture.view.longitude.degrees()),
        latitude = text(picture.view.latitude.degrees()),
        meridians = picture.sphere.meridians,
        parallels = picture.sphere.parallels,
        method = picture.options.rule.id(),
        peak = significant(picture.error.peak(), 3),
        relative = significant(picture.error.peak() / picture.sphere.radius, 3),
    )
}

/// The JSON of a sphere.
#[derive(Debug, Serialize, JsonSchema)]
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
    /// The largest distances of the curves from their true circles, in space and before control points are rounded or mapped.
    pub error: ErrorDocument,
    /// SVG path data of everything, in the order in which it is drawn.
    pub path: String,
}

/// A sphere.
#[derive(Debug, Serialize, JsonSchema)]
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
#[derive(Debug, Serialize, JsonSchema)]
pub struct ViewDocument {
    /// Its longitude.
    pub longitude: f64,
    /// Its latitude.
    pub latitude: f64,
}

/// A part of a line on the sphere, between points at which it meets the limb, or the whole of it.
#[derive(Debug, Serialize, JsonSchema)]
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
    pub fn new(picture: &Picture, hidden: Hidden) -> Self {
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
            error: ErrorDocument {
                outward: picture.error.outward,
                inward: picture.error.inward,
                peak: picture.error.peak(),
                relative_peak: picture.error.peak() / sphere.radius,
            },
            path: path::data(Figure::of_sphere(picture, hidden).curves(), false),
        }
    }
}

fn part_document(part: &Part) -> PartDocument {
    let (line, latitude, longitude) = match part.line {
        Line::Parallel(latitude) => ("parallel", Some(latitude.degrees()), None),
        Line::Meridian(longitude) => ("meridian", None, Some(longitude.degrees())),
        Line::Outline => ("outline", None, None),
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
