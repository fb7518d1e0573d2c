//! The JSON of a path.

use kurbo::{Line, PathSeg};
use serde::Serialize;

use crate::contour::{PathDrawing, Subpath};
use crate::course::{Course, CourseStep};
use crate::path;
use crate::write::json::{ErrorDocument, SegmentDocument, segment_document};

/// The JSON of a path.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PathDocument {
    /// The version of this form.
    pub version: u32,
    /// The id of the method that arcs were drawn by, or `handle`; `lines` and `arcs` where all became these.
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
    pub segments: Vec<PathSegmentDocument>,
    /// The error of the points as printed; relative to the largest radius of its arcs, or without arcs to half the larger side of
    /// its box.
    pub error: ErrorDocument,
}

/// A segment of a path.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum PathSegmentDocument {
    /// A line or a Bézier.
    Points(SegmentDocument),
    /// An arc from where the segment before it ends.
    Arc {
        /// The arc, as SVG has it.
        arc: ArcDocument,
    },
}

/// An arc as SVG has it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ArcDocument {
    /// Its radii.
    pub radii: [f64; 2],
    /// The angle of its first axis, in degrees.
    pub rotation: f64,
    /// Whether it takes the longer way.
    pub large_arc: bool,
    /// Whether it runs in the direction of growing angles.
    pub sweep: bool,
    /// Where it ends.
    pub to: [f64; 2],
}

fn course_segments(course: &Course) -> Vec<PathSegmentDocument> {
    let mut from = course.start;
    let segment = |step: &CourseStep| {
        let line = PathSeg::Line(Line::new(from, step.to()));
        from = step.to();
        match step {
            CourseStep::Line(_) => PathSegmentDocument::Points(segment_document(&line, None)),
            CourseStep::Arc(arc) => PathSegmentDocument::Arc {
                arc: ArcDocument {
                    radii: [arc.radius; 2],
                    rotation: 0.0,
                    large_arc: arc.sweep.degrees().abs() > 180.0,
                    sweep: arc.sweep.degrees() > 0.0,
                    to: [arc.to.x, arc.to.y],
                },
            },
            CourseStep::Elliptical(arc) => PathSegmentDocument::Arc {
                arc: ArcDocument {
                    radii: [arc.radii.x, arc.radii.y],
                    rotation: arc.rotation.degrees(),
                    large_arc: arc.large_arc,
                    sweep: arc.sweep,
                    to: [arc.to.x, arc.to.y],
                },
            },
        }
    };
    course.steps.iter().map(segment).collect()
}

impl From<&PathDrawing> for PathDocument {
    fn from(drawing: &PathDrawing) -> Self {
        Self {
            version: 1,
            method: drawing.maker.id().to_owned(),
            subpaths: drawing.subpaths.iter().map(Into::into).collect(),
            error: ErrorDocument::new(drawing.error(), drawing.relative_peak()),
            path: path::data(drawing.curves(), false)
                + &path::data_of_courses(drawing.courses(), false),
        }
    }
}

impl From<&Subpath> for SubpathDocument {
    fn from(subpath: &Subpath) -> Self {
        let segments = subpath.curve.segments.iter();
        Self {
            closed: subpath.curve.closed,
            segments: subpath.course.as_ref().map_or_else(
                || {
                    let document = |segment| segment_document(segment, None);
                    segments
                        .map(document)
                        .map(PathSegmentDocument::Points)
                        .collect()
                },
                course_segments,
            ),
            error: ErrorDocument::new(subpath.error, subpath.relative_peak()),
        }
    }
}
