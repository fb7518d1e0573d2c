//! What is drawn: curves in layers, and the true shapes that they approximate.

use core::ops::Range;

use kurbo::Rect;

use super::paint::Paint;
use super::scene::along;
use super::style::{Style, default_stroke_width};
use super::words::{
    conic_summary, conic_title, describe_sphere, describe_spline, name, path_summary, sentence,
    title, within,
};
use crate::approximate::Drawing;
use crate::conic;
use crate::contour::{Closeness, PathDrawing};
use crate::course::Course;
use crate::curve::Curve;
use crate::number::{Precision, counted, rounded_up, significant, text};
use crate::shape::Outline;
use crate::sphere::{Part, SphereView};
use crate::spline::Spline;

/// The largest part of the size of a figure by which the points of curves along arcs that are exact may move.
const VISIBLE: f64 = 1e-6;

/// What a writer sees.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// What it is, in a word: the name of a glyph.
    pub name: &'static str,
    /// A few words.
    pub title: String,
    /// A sentence: the shape, the method, the stated error.
    pub description: String,
    /// The curves, those beneath first.
    pub layers: Vec<Layer>,
    /// The true shapes that the curves approximate.
    pub truths: Vec<Approximated>,
    /// Lines and circular arcs in place of curves.
    pub courses: Vec<Course>,
    /// How closely lines and arcs follow the Béziers in whose place they stand.
    pub closeness: Option<Closeness>,
}

/// A true shape, and what approximates it.
#[derive(Debug, Clone, PartialEq)]
pub struct Approximated {
    /// The true shape.
    pub outline: Outline,
    /// The number of the curve among all curves.
    pub curve: usize,
    /// Which of its segments; `None` where the curve is nothing else.
    pub segments: Option<Range<usize>>,
}

impl Approximated {
    /// What a drawing approximates.
    pub(crate) fn of_drawing(drawing: &Drawing) -> Option<Self> {
        let whole = |outline| Self {
            outline,
            curve: 0,
            segments: None,
        };
        drawing.outline.map(whole)
    }

    /// What a path approximates.
    pub(crate) fn of_path(drawing: &PathDrawing) -> impl Iterator<Item = Self> {
        let subpaths = drawing.subpaths.iter().enumerate();
        subpaths.flat_map(move |(i, subpath)| {
            let of_arc = move |(segments, outline): &(Range<usize>, Outline)| Self {
                outline: *outline,
                curve: i,
                segments: Some(segments.clone()),
            };
            subpath.truths.iter().map(of_arc)
        })
    }
}

/// Curves that are drawn alike.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layer {
    /// The class of its group in SVG; without one its paths stand alone.
    pub class: Option<&'static str>,
    /// Whether it is drawn dashed.
    pub dashed: bool,
    /// Whether it is lines on a shape, to be stroked more finely and never filled.
    pub fine: bool,
    /// The curves, as they are written.
    pub curves: Vec<Curve>,
    /// Whether they are one path, of which one may be a hole in another.
    pub joined: bool,
    /// What names it, where something does.
    pub id: Option<String>,
    /// How it looks where that differs from the picture's style.
    pub look: Look,
}

/// How a layer looks where that differs from the picture's style.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Look {
    /// The colour of the stroke.
    pub stroke: Option<Paint>,
    /// The width of the stroke, in user units.
    pub stroke_width: Option<f64>,
    /// The colour of the inside.
    pub fill: Option<Paint>,
}

impl Figure {
    /// All curves in the order in which they are drawn.
    pub fn curves(&self) -> impl Iterator<Item = &Curve> {
        self.layers.iter().flat_map(|layer| &layer.curves)
    }

    /// The true shape of the curve of this number, where it is nothing else.
    #[must_use]
    pub fn truth(&self, number: usize) -> Option<&Outline> {
        let mut truths = self.truths.iter();
        let found = truths.find(|truth| truth.curve == number && truth.segments.is_none());
        found.map(|truth| &truth.outline)
    }

    /// The smallest rectangle around the curves themselves, not their control points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<Rect> {
        let of_courses = self
            .courses
            .iter()
            .filter_map(|course| along(course, Precision::Full).ok());
        let boxes = of_courses.filter_map(|curve| curve.bounding_box());
        self.curves()
            .filter_map(Curve::bounding_box)
            .chain(boxes)
            .reduce(|a, b| a.union(b))
    }

    /// How the points of curves along its arcs are rounded where they are not asked for otherwise, or those move them too far: by a tenth of their
    /// error at most, and within the tolerance.
    pub(crate) fn precision_along_arcs(&self, asked: Option<Precision>) -> Precision {
        let Some(Closeness { arcs, .. }) = self.closeness else {
            return Precision::Full;
        };
        match asked {
            Some(asked) if asked.farthest_moved() <= arcs.room => asked,
            _ => {
                let bounds = self.bounding_box().unwrap_or(Rect::ZERO);
                let part = if arcs.error > 0.0 {
                    0.1 * arcs.error
                } else {
                    VISIBLE * bounds.width().max(bounds.height())
                };
                let largest = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
                let largest = largest
                    .into_iter()
                    .fold(0.0, |most: f64, x| most.max(x.abs()));
                Precision::moving_at_most(part.min(arcs.room), largest)
            }
        }
    }

    /// The description where what lies between the ends of arcs moves so far.
    pub(crate) fn described_with_arcs_moved(&self, style: &Style, moved: f64) -> String {
        let Some(Closeness { lines, arcs }) = self.closeness.filter(|_| moved > 0.0) else {
            return self.described(style);
        };
        // The description of a path ends in its closeness.
        let counts = self.description.strip_suffix(&within(lines.error));
        let error = within(lines.error.max(arcs.error + moved));
        let description = counts.map_or_else(
            || self.description.clone(),
            |counts| counts.to_owned() + &error,
        );
        self.with_key(description, style)
    }

    /// The description, and how what is shown is to be read.
    pub(crate) fn described(&self, style: &Style) -> String {
        self.with_key(self.description.clone(), style)
    }

    /// A description, and how what is shown is to be read.
    fn with_key(&self, description: String, style: &Style) -> String {
        match style.show.error {
            Some(factor) if !self.truths.is_empty() => format!(
                "{description}; deviation drawn {} times as large, orange outside and blue inside",
                text(factor)
            ),
            _ => description,
        }
    }
}

impl Figure {
    /// The width of the stroke where none is asked for: about 1 % of the larger side.
    #[must_use]
    pub fn default_stroke_width(&self) -> f64 {
        let bounds = self.bounding_box().unwrap_or(Rect::ZERO);
        default_stroke_width(bounds.width().max(bounds.height()))
    }
}

impl From<&Drawing> for Figure {
    fn from(drawing: &Drawing) -> Self {
        let title = title(drawing);
        let description = if drawing.outline.is_some() {
            format!(
                "{title}; {segments} by {method}; within {peak} of the true shape ({relative} of the larger radius)",
                segments = counted(drawing.curve.segments.len(), "segment"),
                method = drawing.rule.id(),
                peak = significant(rounded_up(drawing.error.peak(), 3), 3),
                relative = significant(rounded_up(drawing.relative_peak(), 3), 3),
            )
        } else {
            format!("{title}; {}", within(drawing.error.peak()))
        };
        Self {
            name: name(&drawing.shape),
            title,
            description,
            layers: vec![Layer {
                curves: vec![drawing.curve.clone()],
                ..Layer::default()
            }],
            truths: Approximated::of_drawing(drawing).into_iter().collect(),
            ..Self::default()
        }
    }
}

impl Figure {
    /// The subpaths of a path.
    #[must_use]
    pub fn of_path(drawing: &PathDrawing) -> Self {
        Self {
            name: "path",
            title: "Path".to_owned(),
            description: sentence(&path_summary(drawing)),
            layers: vec![Layer {
                curves: drawing.curves().cloned().collect(),
                joined: true,
                ..Layer::default()
            }],
            truths: Approximated::of_path(drawing).collect(),
            courses: drawing.courses().cloned().collect(),
            closeness: drawing.closeness(),
        }
    }
}

impl Figure {
    /// A parabola or a hyperbola.
    #[must_use]
    pub fn of_conic(drawing: &conic::ConicDrawing) -> Self {
        let title = sentence(&conic_title(&drawing.conic));
        Self {
            name: "conic",
            description: sentence(&conic_summary(drawing)),
            title,
            layers: vec![Layer {
                curves: vec![drawing.curve.clone()],
                ..Layer::default()
            }],
            ..Self::default()
        }
    }
}

/// What becomes of the hidden halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Hidden {
    /// Drawn like the others.
    Show,
    /// Drawn dashed.
    #[default]
    Dash,
    /// Left out.
    None,
}

impl Figure {
    /// A sphere as layers with the classes `outline`, `back` and `front`, those beneath first.
    #[must_use]
    pub fn of_sphere(picture: &SphereView, hidden: Hidden) -> Self {
        let lines = |class, dashed, parts: &[Part]| Layer {
            class: Some(class),
            dashed,
            fine: true,
            curves: parts.iter().map(|part| part.curve.clone()).collect(),
            ..Layer::default()
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
            name: "sphere",
            description: describe_sphere(picture, &title),
            title,
            layers,
            ..Self::default()
        }
    }
}

impl Figure {
    /// A spline's curve, as [`Spline::curve`] gives it.
    #[must_use]
    pub fn of_spline(spline: &Spline, curve: Curve) -> Self {
        let title = format!("Curve through {} points", spline.points.len());
        Self {
            name: "spline",
            description: format!(
                "Composite parametric cubic through {} points; {}",
                spline.points.len(),
                describe_spline(spline)
            ),
            title,
            layers: vec![Layer {
                curves: vec![curve],
                ..Layer::default()
            }],
            ..Self::default()
        }
    }
}
