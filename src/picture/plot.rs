//! Plots: a quantity along curves, and the error of methods by the number of segments.

mod lines;
mod scale;
mod sheet;
mod spread;

use core::iter;

use kurbo::{PathSeg, Rect, Vec2};

use super::paint::Paint;
use super::scene::{Group, Pen, Scene};
use super::size::Size;

use crate::compare::Comparison;
use crate::conic;
use crate::curve::{self, Curve};
use crate::error::Result;
use crate::measure::{Quantity, Reference, profile};
use scale::ScaleKind;
use sheet::{DECIMALS, LABEL_STEP};

/// The size at which a plot is laid out where none was asked for.
const LAYOUT: [f64; 2] = [800.0, 500.0];

/// The height of each of several charts.
const PANEL: f64 = 280.0;

/// The smallest size at which the words of one have room.
const LEAST: [f64; 2] = [360.0, 220.0];

/// More joints than this are not marked.
const MOST_MARKED_JOINTS: usize = 36;

/// A line of a chart.
#[derive(Debug, Clone, PartialEq)]
struct Series {
    name: String,
    pen: Pen,
    /// Its parts, between which it is not joined.
    parts: Vec<Vec<(f64, f64)>>,
    /// Whether each of its points is marked.
    dots: bool,
}

/// A named line and its parts.
type NamedLine = (String, Vec<Vec<(f64, f64)>>);

/// In how many steps a segment of a curve is drawn.
fn steps(curve: &Curve) -> u32 {
    (3000 / curve.segments.len().max(1)).clamp(8, 160) as u32
}

/// The control points of each segment.
fn control_points<'a>(curves: impl Iterator<Item = &'a Curve>) -> Vec<Vec<(f64, f64)>> {
    let of_segment = |segment: &PathSeg| {
        let points = curve::control_points(segment).into_iter();
        points.map(|point| (point.x, point.y)).collect()
    };
    let segments = curves.flat_map(|curve| &curve.segments);
    segments.map(of_segment).collect()
}

impl Series {
    fn points(&self) -> impl Iterator<Item = &(f64, f64)> {
        self.parts.iter().flatten()
    }
}

/// Where the names of the lines stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Names {
    /// Above the plot.
    Legend,
    /// At the right end of each line.
    AtEnds,
}

/// A chart, ready to be drawn at any size.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    title: String,
    x_title: String,
    y_title: String,
    x_kind: ScaleKind,
    y_kind: ScaleKind,
    series: Vec<Series>,
    /// Marked x values: the joints.
    marks: Vec<f64>,
    /// The control points of each segment, in a drawing: both axes then have one scale.
    control_points: Vec<Vec<(f64, f64)>>,
    names: Names,
    /// What stands below it, each as high.
    below: Vec<Self>,
}

impl Chart {
    /// This chart, and the other below it and what stands there.
    #[must_use]
    pub fn above(mut self, other: Self) -> Self {
        self.below.push(other);
        self
    }

    /// The quantity along curves, each named, over the angle about the centre.
    #[must_use]
    pub fn along(title: &str, quantity: Quantity, curves: &[(&str, &Curve, &Reference)]) -> Self {
        let line = |(name, curve, reference): &(&str, &Curve, &Reference)| {
            let parts = profile::along(curve, reference, quantity, steps(curve));
            ((*name).to_owned(), parts)
        };
        let x = ("angle about the centre (degrees)", ScaleKind::Degrees);
        let drawn = curves.iter().map(|&(_, curve, _)| curve);
        Self::of_lines(title, quantity, x, curves.iter().map(line), drawn)
    }

    /// The quantity along drawn parabolas and hyperbolas, each named, over the place along the conic.
    ///
    /// # Errors
    ///
    /// As [`conic::ConicDrawing::along`].
    pub fn along_conics(
        title: &str,
        quantity: Quantity,
        drawings: &[(&str, &conic::ConicDrawing)],
    ) -> Result<Self> {
        let line = |(name, drawing): &(&str, &conic::ConicDrawing)| {
            let parts = drawing.along(quantity, steps(&drawing.curve))?;
            Ok(((*name).to_owned(), parts))
        };
        let lines: Vec<NamedLine> = drawings.iter().map(line).collect::<Result<_>>()?;
        let x = (
            "place along the conic (0 its start, 1 its end)",
            ScaleKind::Linear,
        );
        let drawn = drawings.iter().map(|&(_, drawing)| &drawing.curve);
        Ok(Self::of_lines(title, quantity, x, lines.into_iter(), drawn))
    }

    /// Named lines over an axis with its words, the ends of their parts marked; of a drawing its control points, over x.
    fn of_lines<'a>(
        title: &str,
        quantity: Quantity,
        (x_title, x_kind): (&str, ScaleKind),
        lines: impl Iterator<Item = NamedLine>,
        drawn: impl Iterator<Item = &'a Curve>,
    ) -> Self {
        let (x_title, x_kind, control_points) = if quantity == Quantity::Drawing {
            ("x (user units)", ScaleKind::Linear, control_points(drawn))
        } else {
            (x_title, x_kind, Vec::new())
        };
        let mut marks: Vec<f64> = Vec::new();
        let series = lines.enumerate().map(|(i, (name, parts))| {
            for part in &parts {
                let ends = [part.first(), part.last()].into_iter().flatten();
                marks.extend(ends.map(|&(x, _)| x));
            }
            Series {
                name,
                pen: lines::line(i),
                parts,
                dots: false,
            }
        });
        let series = series.collect();
        marks.sort_by(f64::total_cmp);
        marks.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        if marks.len() > MOST_MARKED_JOINTS || !control_points.is_empty() {
            marks.clear();
        }
        Self {
            title: title.to_owned(),
            x_title: x_title.to_owned(),
            y_title: quantity.label().to_owned(),
            x_kind,
            y_kind: ScaleKind::Linear,
            series,
            marks,
            control_points,
            names: Names::Legend,
            below: Vec::new(),
        }
    }

    /// The error of methods by the number of segments, or by the angle of one, both axes logarithmic. Errors of 0 are not shown.
    #[must_use]
    pub fn comparison(comparison: &Comparison) -> Self {
        let columns: Vec<f64> = comparison.columns().into_iter().map(|(_, x)| x).collect();
        let series = comparison.rows.iter().map(|row| {
            let points = columns.iter().zip(&row.values);
            let points = points.filter_map(|(&x, value)| Some((x, (*value)?)));
            Series {
                name: row.rule.id().to_owned(),
                pen: lines::family_line(row.rule.method().unwrap_or_default()),
                parts: vec![points.filter(|&(_, value)| value > 0.0).collect()],
                dots: true,
            }
        });
        let (whole, by, x_title) = if comparison.spans.is_empty() {
            ("A full circle", "the number of segments", "segments")
        } else {
            ("A segment of a circle", "its angle", "angle (degrees)")
        };
        Self {
            title: format!("{whole} of radius 1: {} by {by}", comparison.by.title()),
            x_title: x_title.to_owned(),
            y_title: comparison.by.label().to_owned(),
            x_kind: ScaleKind::Given(columns.clone()),
            y_kind: ScaleKind::Log,
            series: series.filter(|s| s.points().count() > 0).collect(),
            marks: Vec::new(),
            control_points: Vec::new(),
            names: Names::AtEnds,
            below: Vec::new(),
        }
    }

    /// The chart laid out on a white sheet of this size, in pixels or points: its words keep their size, but on one that is too small
    /// for them.
    #[must_use]
    pub fn scene(&self, size: [f64; 2]) -> Scene {
        let least = [LEAST[0], LEAST[1] * (1 + self.below.len()) as f64];
        let short = least.iter().zip(size).map(|(least, side)| least / side);
        let scale = short.fold(1.0, f64::max);
        let [width, height] = size.map(|side| side * scale);
        Scene {
            title: self.title.clone(),
            description: String::new(),
            view: Rect::new(0.0, 0.0, width, height),
            size: Some(Size::plain(size)),
            background: Some(Paint::WHITE),
            decimals: DECIMALS,
            upright: true,
            groups: self.groups(width, height),
        }
    }

    /// What it and those below it show.
    fn groups(&self, width: f64, height: f64) -> Vec<Group> {
        let each = (height / (1 + self.below.len()) as f64).floor();
        let charts = iter::once(self).chain(&self.below).enumerate();
        charts
            .flat_map(|(i, chart)| {
                let top = each * i as f64;
                let groups = sheet::groups(chart, Vec2::new(width, each));
                groups
                    .into_iter()
                    .map(move |group| sheet::lowered(group, top))
            })
            .collect()
    }

    /// The size of a sheet on which it reads well.
    #[must_use]
    pub fn default_size(&self) -> [f64; 2] {
        let [width, height] = LAYOUT;
        match self.names {
            Names::Legend if !self.below.is_empty() => {
                [width, PANEL * (1 + self.below.len()) as f64]
            }
            Names::Legend => LAYOUT,
            // Room for a line of words for each series.
            Names::AtEnds => [
                width,
                height.max(120.0 + 1.25 * LABEL_STEP * self.series.len() as f64),
            ],
        }
    }
}
