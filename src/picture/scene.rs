//! A picture as a short list of strokes, fills, dots and words: what SVG, PNG, EPS and PDF have in common.

use core::iter::repeat;
use std::borrow::Cow;

use kurbo::{Circle, Line, PathSeg, Rect};

use super::paint::{Color, Paint};
use super::size::Size;
#[cfg(feature = "plot")]
use super::text::Text;
use crate::course::Course;
use crate::curve::Curve;
use crate::error::Result;
use crate::joints::cutting::{Cutting as _, EqualPieces};
use crate::method::{Rule, Span};
use crate::number::Precision;
use crate::place::Placed;
use crate::shape::Outline;

/// The largest angle, in degrees, that one cubic of a true shape spans: it strays by less than 1e-9 of the radius.
const TRUE_SPAN: f64 = 11.25;

/// What is drawn, in user space.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// A few words.
    pub title: String,
    /// A sentence, or nothing.
    pub description: String,
    /// The smallest tidy rectangle around everything that is drawn, and the margin.
    pub view: Rect,
    /// Width and height of the picture, where they were asked for.
    pub size: Option<Size>,
    /// What lies beneath everything, where that was asked for.
    pub background: Option<Paint>,
    /// How many decimals a coordinate needs that a picture can show.
    pub decimals: u8,
    /// Whether +y is down whatever the format, as a plot with its words wants it. Else it is the format's own: no axis is flipped.
    pub upright: bool,
    /// What is drawn, those beneath first.
    pub groups: Vec<Group>,
}

/// Marks that are drawn alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// What they are.
    pub class: Option<&'static str>,
    /// What names them, where something does.
    pub id: Option<String>,
    /// How they are drawn.
    pub pen: Pen,
    /// The marks.
    pub marks: Vec<Mark>,
}

/// How marks are drawn: filled, then stroked with round joins.
#[derive(Debug, Clone, PartialEq)]
pub struct Pen {
    /// The colour of the stroke.
    pub stroke: Paint,
    /// The width of the stroke.
    pub width: f64,
    /// The lengths of dashes and gaps in turn, over and over; empty for a solid line.
    pub dash: Vec<f64>,
    /// The colour of the inside.
    pub fill: Paint,
}

/// Something that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A curve.
    Curve(Curve),
    /// Curves that are one path, of which one may be a hole in another.
    Path(Vec<Curve>),
    /// Lines and arcs that are one path.
    Arcs(Vec<Course>),
    /// A true shape.
    Truth(Box<Outline>),
    /// A dot.
    Dot(Circle),
    /// A line of words.
    #[cfg(feature = "plot")]
    Text(Text),
}

impl Pen {
    pub(crate) const fn filled(fill: Paint) -> Self {
        Self {
            stroke: Paint::None,
            width: 0.0,
            dash: Vec::new(),
            fill,
        }
    }

    pub(super) const fn stroked(stroke: Paint, width: f64) -> Self {
        Self {
            stroke,
            width,
            dash: Vec::new(),
            fill: Paint::None,
        }
    }

    /// The colour and the width of the stroke, where there is one.
    #[must_use]
    pub fn visible_stroke(&self) -> Option<(Color, f64)> {
        self.stroke
            .visible()
            .map(|color| (color, self.width))
            .filter(|(_, width)| *width > 0.0)
    }
}

impl Mark {
    /// The mark as Béziers, arcs, true shapes and dots within 1e-9 of their radius. Those of words belong together: one is a hole in another.
    fn to_curves(&self) -> Result<Cow<'_, [Curve]>> {
        Ok(match self {
            Self::Curve(curve) => Cow::Borrowed(std::slice::from_ref(curve)),
            Self::Path(curves) => Cow::Borrowed(curves),
            Self::Arcs(courses) => {
                let along = |course| along(course, Precision::Full);
                Cow::Owned(courses.iter().map(along).collect::<Result<_>>()?)
            }
            Self::Truth(outline) => Cow::Owned(vec![finely(outline)?]),
            Self::Dot(dot) => {
                let circle = crate::shape::Circle::new(dot.center, dot.radius)?;
                let outline = crate::Shape::Circle(circle).outline();
                Cow::Owned(outline.iter().map(finely).collect::<Result<_>>()?)
            }
            #[cfg(feature = "plot")]
            Self::Text(text) => Cow::Owned(text.outlines()),
        })
    }

    pub(super) fn bounding_box(&self) -> Result<Option<Rect>> {
        Ok(match self {
            Self::Dot(dot) => Some(kurbo::Shape::bounding_box(dot)),
            _ => self
                .to_curves()?
                .iter()
                .filter_map(Curve::bounding_box)
                .reduce(|a, b| a.union(b)),
        })
    }
}

/// Lines and arcs as a curve, its arcs as [`finely`] has them, what lies between their ends rounded.
pub(super) fn along(course: &Course, precision: Precision) -> Result<Curve> {
    let mut segments = Vec::new();
    let mut from = course.start;
    for step in &course.steps {
        match step.outline(from) {
            Some(outline) => {
                let curve = finely(&outline)?.rounded(precision, &[from, step.to()]);
                segments.extend(curve.segments);
            }
            None => segments.push(PathSeg::Line(Line::new(from, step.to()))),
        }
        from = step.to();
    }
    Ok(Curve {
        segments,
        closed: course.closed,
    })
}

/// The outline in so many cubics that nobody can tell it from the true shape.
fn finely(outline: &Outline) -> Result<Curve> {
    let count = (outline.unit.sweep.degrees().abs() / TRUE_SPAN).ceil() as usize;
    let pieces = EqualPieces::new(outline.unit, count.max(1))?;
    let piece = Rule::default().piece(&Span::from_degrees(pieces.size(0)))?;
    let placed = Placed::new(outline, &pieces);
    Ok(placed.curve(repeat([piece; 2]), outline.unit.closed))
}

impl Scene {
    /// Makes Béziers of all arcs, within 1e-9 of their radii before their points are rounded.
    ///
    /// # Errors
    ///
    /// Where an arc is such that a curve along it could not be drawn either.
    pub(crate) fn draw_arcs_as_curves(&mut self, precision: Precision) -> Result<()> {
        for mark in self.groups.iter_mut().flat_map(|group| &mut group.marks) {
            if let Mark::Arcs(courses) = mark {
                let along = |course: &Course| along(course, precision);
                *mark = Mark::Path(courses.iter().map(along).collect::<Result<_>>()?);
            }
        }
        Ok(())
    }

    /// The mark as Béziers; the points of what is shown beside the curve with as many decimals as a picture can show.
    ///
    /// # Errors
    ///
    /// Where a true shape is such that a curve along it could not be drawn either.
    pub fn curves<'a>(&self, mark: &'a Mark) -> Result<Cow<'a, [Curve]>> {
        let curves = mark.to_curves()?;
        if matches!(mark, Mark::Curve(_) | Mark::Path(_) | Mark::Arcs(_)) {
            return Ok(curves);
        }
        let precision = Precision::Fixed(self.decimals);
        let rounded = curves.iter().map(|curve| curve.rounded(precision, &[]));
        Ok(rounded.collect())
    }

    /// The view, widened to the proportions of the picture; the view lies in its middle.
    #[must_use]
    pub fn canvas(&self) -> Rect {
        let Some([width, height]) = self.size.map(Size::pixels) else {
            return self.view;
        };
        let scale = (width / self.view.width()).min(height / self.view.height());
        Rect::from_center_size(self.view.center(), (width / scale, height / scale))
    }
}
