//! What a figure becomes in a style: groups of marks, and the rectangle around them.

use kurbo::{Circle, Line, ParamCurveArea as _, PathSeg, Point, Rect};

use super::deviation::Regions;
use super::figure::{Approximated, Figure, Layer};
use super::paint::Paint;
use super::palette::{GREEN, ORANGE, SKY_BLUE};
use super::scene::{Group, Mark, Pen, Scene};
use super::style::Style;
use crate::course::CourseStep;
use crate::curve::{Curve, control_points};
use crate::error::{Error, PictureError, Result};
use crate::number::{Precision, decimals_of, round, round_one_two_five};
use crate::numeric::functions::power;

/// The true shape, a broad band beneath the curve.
const TRUTH: Paint = Paint::rgb(0xc4, 0xc9, 0xd0);
/// Deviation outside and inside.
const OUTWARD: Paint = ORANGE;
const INWARD: Paint = SKY_BLUE;
const HANDLES: Paint = GREEN;

// Sizes of fine lines and of what is shown, in widths of the curve's stroke.
const FINE_WIDTH: f64 = 0.5;
const DASH: f64 = 3.0;
const TRUTH_WIDTH: f64 = 3.0;
const HANDLE_WIDTH: f64 = 0.5;
const HANDLE_RADIUS: f64 = 1.1;
const JOINT_RADIUS: f64 = 1.5;
const JOINT_RIM: f64 = 0.6;

/// The margin of a picture that shows more than the curve, in default strokes.
const SHOW_MARGIN: f64 = 2.0;

/// What rounding may add to a count of steps.
const NOISE: f64 = 1e-6;

impl Figure {
    /// The figure in this style.
    ///
    /// # Errors
    ///
    /// Where the size of the style is not positive, a length of it is negative, or one of them is not finite or beyond all bounds;
    /// and where the true shape or the deviation from it is to be shown and the figure has none.
    pub fn scene(&self, style: &Style) -> Result<Scene> {
        style.check()?;
        let painter = Painter::new(self, style);
        let groups = painter.groups()?;
        Ok(Scene {
            title: self.title.clone(),
            description: self.described(style),
            view: painter.view(&groups)?,
            size: style.size,
            background: style.background,
            decimals: painter.decimals(),
            upright: false,
            groups,
        })
    }
}

/// Paints a figure.
pub(super) struct Painter<'a> {
    figure: &'a Figure,
    style: &'a Style,
    /// The default width of strokes.
    unit: f64,
    /// The width of the curves' strokes.
    width: f64,
    /// The width that the sizes of what is shown go by, which is there even where curves are not stroked.
    mark: f64,
}

impl<'a> Painter<'a> {
    pub(super) fn new(figure: &'a Figure, style: &'a Style) -> Self {
        let unit = figure.default_stroke_width();
        let width = style.stroke_width.unwrap_or(unit);
        let mark = if width > 0.0 { width } else { unit };
        Self {
            figure,
            style,
            unit,
            width,
            mark,
        }
    }

    pub(super) fn groups(&self) -> Result<Vec<Group>> {
        let show = &self.style.show;
        let mut groups = Vec::new();
        // What is shown beneath the curve is not to vanish beneath its fill.
        let fill_first = show.is_any()
            && self
                .figure
                .layers
                .iter()
                .any(|l| self.fill(l) != Paint::None);
        if fill_first {
            let filled = self.figure.layers.iter().filter(|layer| !layer.fine);
            groups.extend(filled.map(|layer| Group {
                class: Some("fill"),
                id: None,
                pen: Pen::filled(self.fill(layer)),
                marks: self.marks(layer),
            }));
        }
        if let Some(factor) = show.error {
            groups.extend(self.deviation(factor)?);
        }
        if show.truth {
            groups.extend(self.truth()?);
        }
        groups.extend(
            self.figure
                .layers
                .iter()
                .map(|layer| self.layer(layer, fill_first)),
        );
        if show.handles {
            groups.extend(self.handles());
        }
        if show.joints {
            groups.push(self.joints());
        }
        groups.retain(|group| !group.marks.is_empty());
        Ok(groups)
    }

    fn layer(&self, layer: &Layer, filled_before: bool) -> Group {
        let fill = if filled_before {
            Paint::None
        } else {
            self.fill(layer)
        };
        let part = if layer.fine { FINE_WIDTH } else { 1.0 };
        let width = layer.look.stroke_width.unwrap_or(self.width);
        let dash = layer.dashed.then_some(DASH * part * self.mark);
        Group {
            class: layer.class,
            id: layer.id.clone(),
            pen: Pen {
                stroke: layer.look.stroke.unwrap_or(self.style.stroke),
                width: part * width,
                dash: dash.into_iter().collect(),
                fill,
            },
            marks: self.marks(layer),
        }
    }

    fn marks(&self, layer: &Layer) -> Vec<Mark> {
        if !self.figure.courses.is_empty() {
            return vec![Mark::Arcs(self.figure.courses.clone())];
        }
        if layer.joined && !layer.curves.is_empty() {
            return vec![Mark::Path(layer.curves.clone())];
        }
        layer.curves.iter().cloned().map(Mark::Curve).collect()
    }

    fn fill(&self, layer: &Layer) -> Paint {
        if layer.fine {
            Paint::None
        } else {
            layer.look.fill.unwrap_or(self.style.fill)
        }
    }

    /// The true shapes; a figure of straight lines is its own true shape.
    fn truths(&self) -> Result<&'a [Approximated]> {
        let is_line = |segment: &PathSeg| matches!(segment, PathSeg::Line(_));
        let mut segments = self.figure.curves().flat_map(|curve| &curve.segments);
        let exact = self.figure.closeness.is_none() && segments.all(is_line);
        if self.figure.truths.is_empty() && !exact {
            return Err(Error::Picture(PictureError::NoTruth));
        }
        Ok(&self.figure.truths)
    }

    fn truth(&self) -> Result<Option<Group>> {
        let truths = self.truths()?;
        Ok((!truths.is_empty()).then(|| Group {
            class: Some("truth"),
            id: None,
            pen: Pen::stroked(TRUTH, TRUTH_WIDTH * self.mark),
            marks: truths
                .iter()
                .map(|truth| Mark::Truth(Box::new(truth.outline)))
                .collect(),
        }))
    }

    fn deviation(&self, factor: f64) -> Result<[Group; 2]> {
        let mut lobes = Regions::default();
        let curves: Vec<&Curve> = self.figure.curves().collect();
        for truth in self.truths()? {
            let segments = curves.get(truth.curve).map(|curve| &curve.segments[..]);
            let segments = segments.and_then(|segments| match &truth.segments {
                Some(range) => segments.get(range.clone()),
                None => Some(segments),
            });
            lobes.add(segments.unwrap_or_default(), &truth.outline.truth, factor);
        }
        // Where the curve touches the true shape, rounding noise makes regions that nobody sees.
        let least = power(self.unit / 1000.0, 2);
        let group = |class, paint, curves: Vec<Curve>| Group {
            class: Some(class),
            id: None,
            pen: Pen::filled(paint),
            marks: curves
                .iter()
                .filter(|curve| area(curve) > least)
                .map(|curve| Mark::Curve(self.tidy(curve)))
                .collect(),
        };
        Ok([
            group("outward", OUTWARD, lobes.outward),
            group("inward", INWARD, lobes.inward),
        ])
    }

    fn handles(&self) -> [Group; 2] {
        let mut lines = Vec::new();
        let mut ends: Vec<Point> = Vec::new();
        for segment in self.figure.curves().flat_map(|curve| &curve.segments) {
            let points = control_points(segment);
            let pairs = match points.len() {
                0..=2 => vec![],
                3 => vec![(0, 1), (2, 1)],
                _ => vec![(0, 1), (3, 2)],
            };
            for (joint, end) in pairs {
                lines.push(Line::new(points[joint], points[end]));
                if ends.last() != Some(&points[end]) {
                    ends.push(points[end]);
                }
            }
        }
        let line = |line| {
            Mark::Curve(Curve {
                segments: vec![PathSeg::Line(line)],
                closed: false,
            })
        };
        [
            Group {
                class: Some("handles"),
                id: None,
                pen: Pen::stroked(HANDLES, HANDLE_WIDTH * self.mark),
                marks: lines.into_iter().map(line).collect(),
            },
            self.dots("handle-ends", HANDLES, HANDLE_RADIUS, ends),
        ]
    }

    fn joints(&self) -> Group {
        let mut joints = Vec::new();
        for course in &self.figure.courses {
            joints.push(course.start);
            joints.extend(course.steps.iter().map(CourseStep::to));
            if course.steps.last().map(CourseStep::to) == Some(course.start) {
                joints.pop();
            }
        }
        for curve in self.figure.curves() {
            joints.extend(curve.start());
            joints.extend(curve.segments.iter().map(|segment| match *segment {
                PathSeg::Line(l) => l.p1,
                PathSeg::Quad(q) => q.p2,
                PathSeg::Cubic(c) => c.p3,
            }));
            if joints.len() > 1 && joints.last() == curve.start().as_ref() {
                joints.pop();
            }
        }
        let paint = if self.style.stroke.visible().is_some() {
            self.style.stroke
        } else {
            Paint::BLACK
        };
        self.dots("joints", paint, JOINT_RADIUS, joints)
    }

    /// Dots with a white rim, which sets them apart from what they lie on.
    fn dots(&self, class: &'static str, fill: Paint, radius: f64, centers: Vec<Point>) -> Group {
        Group {
            class: Some(class),
            id: None,
            pen: Pen {
                fill,
                ..Pen::stroked(Paint::WHITE, JOINT_RIM * self.mark)
            },
            marks: centers
                .into_iter()
                .map(|center| Mark::Dot(Circle::new(center, radius * self.mark)))
                .collect(),
        }
    }

    /// The curve with as many decimals as a picture can show.
    fn tidy(&self, curve: &Curve) -> Curve {
        curve.rounded(Precision::Fixed(self.decimals()), &[])
    }

    pub(super) fn decimals(&self) -> u8 {
        decimals_of(round_one_two_five(self.unit / 1000.0))
    }

    /// What is shown beside the curve gets some air around it; a curve alone is cut out tightly, as icons and figures in a text are.
    fn default_margin(&self) -> f64 {
        if self.style.show.is_any() {
            SHOW_MARGIN * self.unit
        } else {
            0.0
        }
    }

    /// The rectangle around the ink and the margin, its sides moved outwards to multiples of a tenth of the default stroke.
    pub(super) fn view(&self, groups: &[Group]) -> Result<Rect> {
        let mut ink: Option<Rect> = None;
        for group in groups {
            let reach = group.pen.visible_stroke().map_or(0.0, |(_, width)| width) / 2.0;
            for mark in &group.marks {
                if let Some(bounds) = mark.bounding_box()? {
                    let bounds = bounds.inflate(reach, reach);
                    ink = Some(ink.map_or(bounds, |ink| ink.union(bounds)));
                }
            }
        }
        let Some(ink) = ink else {
            return Ok(Rect::new(0.0, 0.0, 1.0, 1.0));
        };
        let margin = self.style.margin.unwrap_or_else(|| self.default_margin());
        let framed = ink.inflate(margin, margin);
        // A straight line that is not stroked has no height; a picture has.
        let framed = if framed.width() > 0.0 && framed.height() > 0.0 {
            framed
        } else {
            framed.inflate(self.unit, self.unit)
        };
        let step = round_one_two_five(self.unit / 10.0);
        let decimals = decimals_of(step);
        // A side that rounding noise has moved off a multiple stays there.
        let down = |x: f64| round((x / step + NOISE).floor() * step, decimals);
        let up = |x: f64| round((x / step - NOISE).ceil() * step, decimals);
        Ok(Rect::new(
            down(framed.x0),
            down(framed.y0),
            up(framed.x1),
            up(framed.y1),
        ))
    }
}

/// The area inside a closed curve.
fn area(curve: &Curve) -> f64 {
    let signed: f64 = curve.segments.iter().map(PathSeg::signed_area).sum();
    signed.abs()
}
