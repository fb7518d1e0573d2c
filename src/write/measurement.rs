//! The JSON and the CSV of what was measured.

use serde::Serialize;

use super::csv;
use super::json::{ShapeDocument, shape_document};
use crate::approximate::Drawing;
use crate::error::Result;
use crate::measure::samples::Sample;
use crate::measure::{Reference, Report, report};
use crate::number::{counted, text};
use crate::picture::words::describe;

/// A report with what it is about.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Measurement {
    /// The version of this form.
    pub version: u32,
    /// What was measured.
    pub subject: Subject,
    /// What was found.
    #[serde(flatten)]
    pub report: Report,
}

/// What was measured: a drawing of our own, or a curve that someone else made.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Subject {
    /// The shape that was drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shape: Option<ShapeDocument>,
    /// The id of the method that drew it, or `handle`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub method: Option<String>,
    /// The literal handle, with the method `handle`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub handle: Option<f64>,
    /// Where the curve was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// A few words.
    pub title: String,
}

impl Measurement {
    /// Measures a drawing of our own; `None` for a line and for nothing, which have no error.
    ///
    /// # Errors
    ///
    /// As [`report`](fn@report).
    pub fn of_drawing(
        drawing: &Drawing,
        coordinate_tolerance: Option<f64>,
    ) -> Result<Option<Self>> {
        let Some(outline) = &drawing.outline else {
            return Ok(None);
        };
        let report = report(
            &drawing.curve,
            &Reference::from(outline),
            coordinate_tolerance,
        )?;
        let handle = drawing.rule.handle();
        Ok(Some(Self {
            version: 1,
            subject: Subject {
                title: format!(
                    "{}, {} by {}",
                    describe(&drawing.shape),
                    counted(report.segments, "segment"),
                    drawing.rule.id()
                ),
                shape: Some(shape_document(&drawing.shape, drawing.transform)),
                method: Some(drawing.rule.id().to_owned()),
                handle,
                source: None,
            },
            report,
        }))
    }

    /// A report on a curve that was read from `source`.
    #[must_use]
    pub fn of_source(source: &str, report: Report) -> Self {
        Self {
            version: 1,
            subject: Subject {
                title: format!("{source}, {}", counted(report.segments, "segment")),
                source: Some(source.to_owned()),
                ..Subject::default()
            },
            report,
        }
    }
}

/// One line of CSV for each measurement, below a line of names; the joints are in the JSON only.
#[must_use]
pub fn csv(measurements: &[&Measurement]) -> String {
    let names = COLUMNS.map(|(name, _)| name).join(",");
    let row = |m: &&Measurement| COLUMNS.map(|(_, field)| field(m));
    csv::lines(&names, measurements.iter().map(row))
}

/// A curve point by point, with what it is about.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Samples<'a> {
    /// The version of this form.
    pub version: u32,
    /// What was sampled.
    pub subject: &'a Subject,
    /// The points, segment by segment at equal steps of t, both ends of each segment among them.
    pub samples: Vec<Sample>,
}

/// One line of CSV for each point, below a line of names.
#[must_use]
pub fn samples_csv(all: &[Samples<'_>]) -> String {
    let rows = all.iter().flat_map(
        |Samples {
             subject, samples, ..
         }| {
            samples.iter().map(|s| {
                let method = subject.method.clone().unwrap_or_default();
                let figures = [s.at.t, s.at.x, s.at.y, s.radius, s.error, s.degrees].map(text);
                let [t, x, y, radius, error, degrees] = figures;
                let segment = s.at.segment.to_string();
                [
                    subject.title.clone(),
                    method,
                    segment,
                    t,
                    x,
                    y,
                    radius,
                    error,
                    degrees,
                ]
            })
        },
    );
    csv::lines("subject,method,segment,t,x,y,radius,error,degrees", rows)
}

fn optional(value: Option<f64>) -> String {
    value.map(text).unwrap_or_default()
}

/// A field of a line.
type Field = fn(&Measurement) -> String;

/// The columns of the CSV.
const COLUMNS: [(&str, Field); 31] = [
    ("subject", |m| m.subject.title.clone()),
    ("method", |m| m.subject.method.clone().unwrap_or_default()),
    ("segments", |m| m.report.segments.to_string()),
    ("closed", |m| m.report.closed.to_string()),
    ("center_x", |m| text(m.report.reference.center[0])),
    ("center_y", |m| text(m.report.reference.center[1])),
    ("radius_x", |m| text(m.report.reference.radii[0])),
    ("radius_y", |m| text(m.report.reference.radii[1])),
    ("rotation", |m| text(m.report.reference.rotation)),
    ("fit_rms", |m| {
        optional(m.report.reference.fit.map(|fit| fit.rms))
    }),
    ("outward", |m| text(m.report.error.outward)),
    ("inward", |m| text(m.report.error.inward)),
    ("peak", |m| text(m.report.error.peak)),
    ("relative_peak", |m| text(m.report.error.relative_peak)),
    ("mean", |m| text(m.report.error.mean)),
    ("mean_angle", |m| text(m.report.error.mean_angle)),
    ("rms", |m| text(m.report.error.rms)),
    ("outward_angle", |m| {
        optional(m.report.error.outward_at.map(|at| at.angle))
    }),
    ("inward_angle", |m| {
        optional(m.report.error.inward_at.map(|at| at.angle))
    }),
    ("length", |m| text(m.report.length.curve)),
    ("true_length", |m| text(m.report.length.truth)),
    ("length_difference", |m| text(m.report.length.difference)),
    ("area", |m| text(m.report.area.curve)),
    ("true_area", |m| text(m.report.area.truth)),
    ("area_difference", |m| text(m.report.area.difference)),
    ("least_curvature", |m| {
        optional(m.report.curvature.least.and_then(|e| e.value))
    }),
    ("largest_curvature", |m| {
        optional(m.report.curvature.largest.and_then(|e| e.value))
    }),
    ("continuity", |m| {
        m.report
            .continuity
            .order
            .map_or_else(String::new, |order| order.to_string())
    }),
    ("largest_turn", |m| text(m.report.continuity.largest_turn)),
    ("angle_lag", |m| text(m.report.angle_lag.largest)),
    ("angle_lag_angle", |m| text(m.report.angle_lag.at.angle)),
];
