//! A picture as a short list of strokes, fills and dots: what SVG, PNG and EPS have in common.

use kurbo::{Circle, Rect};

use super::style::Paint;
use crate::curve::Curve;
use crate::error::Result;
use crate::joints::Joints;
use crate::method::Rule;
use crate::number::Precision;
use crate::place::place;
use crate::shape::Outline;

/// The largest angle, in degrees, that one cubic of a true shape spans: it strays by less than 1e-9 of the radius.
const TRUE_SPAN: f64 = 11.25;

/// What is drawn, in user space; no axis is flipped.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The smallest tidy rectangle around everything that is drawn, and the margin.
    pub view: Rect,
    /// Width and height of the picture, where they were asked for.
    pub size: Option<[f64; 2]>,
    /// What lies beneath everything, where that was asked for.
    pub background: Option<Paint>,
    /// How many decimals a coordinate needs that a picture can show.
    pub decimals: u8,
    /// What is drawn, those beneath first.
    pub groups: Vec<Group>,
}

/// Marks that are drawn alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// What they are.
    pub class: Option<&'static str>,
    /// How they are drawn.
    pub pen: Pen,
    /// The marks.
    pub marks: Vec<Mark>,
}

/// How marks are drawn: filled, then stroked with round joins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// The colour of the stroke.
    pub stroke: Paint,
    /// The width of the stroke.
    pub width: f64,
    /// The length of dashes and of the gaps between them.
    pub dash: Option<f64>,
    /// The colour of the inside.
    pub fill: Paint,
}

/// Something that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A curve.
    Curve(Curve),
    /// A true shape.
    Truth(Outline),
    /// A dot.
    Dot(Circle),
}

impl Pen {
    pub(super) const fn filled(fill: Paint) -> Self {
        Self {
            stroke: Paint::None,
            width: 0.0,
            dash: None,
            fill,
        }
    }

    pub(super) const fn stroked(stroke: Paint, width: f64) -> Self {
        Self {
            stroke,
            width,
            dash: None,
            fill: Paint::None,
        }
    }

    /// The colour and the width of the stroke, where there is one.
    #[must_use]
    pub fn visible_stroke(&self) -> Option<(svgtypes::Color, f64)> {
        self.stroke
            .visible()
            .map(|color| (color, self.width))
            .filter(|(_, width)| *width > 0.0)
    }
}

impl Mark {
    /// The mark as Béziers, true shapes and dots within 1e-9 of their radius.
    fn to_curve(&self) -> Result<Curve> {
        match self {
            Self::Curve(curve) => Ok(curve.clone()),
            Self::Truth(outline) => finely(outline),
            Self::Dot(dot) => {
                let circle = crate::shape::Circle::new(dot.center, dot.radius)?;
                crate::Shape::Circle(circle)
                    .outline()
                    .map_or_else(|| Ok(Curve::default()), |outline| finely(&outline))
            }
        }
    }

    pub(super) fn bounding_box(&self) -> Result<Option<Rect>> {
        Ok(match self {
            Self::Dot(dot) => Some(kurbo::Shape::bounding_box(dot)),
            _ => self.to_curve()?.bounding_box(),
        })
    }
}

/// The outline in so many cubics that nobody can tell it from the true shape.
fn finely(outline: &Outline) -> Result<Curve> {
    let count = (outline.unit.sweep.degrees().abs() / TRUE_SPAN).ceil() as usize;
    let joints = Joints::equal(&outline.unit, count.max(1))?;
    let pieces = Rule::default().pieces(&joints.spans, joints.closed)?;
    Ok(place(outline, &joints, &pieces))
}

impl Scene {
    /// The mark as Béziers; the points of what is shown beside the curve with as many decimals as a picture can show.
    ///
    /// # Errors
    ///
    /// Where a true shape is such that a curve along it could not be drawn either.
    pub fn curve(&self, mark: &Mark) -> Result<Curve> {
        match mark {
            Mark::Curve(curve) => Ok(curve.clone()),
            Mark::Truth(_) | Mark::Dot(_) => Ok(mark
                .to_curve()?
                .rounded(Precision::Fixed(self.decimals), &[])),
        }
    }

    /// The view, widened to the proportions of the picture; the view lies in its middle.
    #[must_use]
    pub fn canvas(&self) -> Rect {
        let Some([width, height]) = self.size else {
            return self.view;
        };
        let scale = (width / self.view.width()).min(height / self.view.height());
        Rect::from_center_size(self.view.center(), (width / scale, height / scale))
    }
}
