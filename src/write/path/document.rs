//! The JSON of a path.

use serde::Serialize;

use crate::contour::{PathDrawing, Subpath};
use crate::path;
use crate::radial_error::RadialError;
use crate::write::json::{ErrorDocument, SegmentDocument, segment_document};

/// The JSON of a path.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PathDocument {
    /// The version of this form.
    pub version: u32,
    /// The id of the method that arcs were drawn by, or `handle`; `lines` where all became lines.
    pub method: String,
    /// The subpaths in their order.
    pub subpaths: Vec<SubpathDocument>,
    /// The error of the points as printed, the largest of all subpaths.
    pub error: ErrorDocument,
    /// SVG path data of all of them.
    pub path: String,
}

/// One subpath.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SubpathDocument {
    /// Whether it is closed.
    pub closed: bool,
    /// The segments in their order.
    pub segments: Vec<SegmentDocument>,
    /// The error of the points as printed; relative to the largest radius of its arcs, or without arcs to half the larger side of
    /// its box.
    pub error: ErrorDocument,
}

impl From<&PathDrawing> for PathDocument {
    fn from(drawing: &PathDrawing) -> Self {
        Self {
            version: 1,
            method: drawing.maker.id().to_owned(),
            subpaths: drawing.subpaths.iter().map(Into::into).collect(),
            error: error_document(drawing.error(), drawing.relative_peak()),
            path: path::data(drawing.curves(), false),
        }
    }
}

impl From<&Subpath> for SubpathDocument {
    fn from(subpath: &Subpath) -> Self {
        let segments = subpath.curve.segments.iter();
        Self {
            closed: subpath.curve.closed,
            segments: segments
                .map(|segment| segment_document(segment, None))
                .collect(),
            error: error_document(subpath.error, subpath.relative_peak()),
        }
    }
}

fn error_document(error: RadialError, relative_peak: f64) -> ErrorDocument {
    ErrorDocument {
        outward: error.outward,
        inward: error.inward,
        peak: error.peak(),
        relative_peak,
    }
}
