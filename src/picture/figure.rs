//! What is drawn: curves in layers, and the true shapes that they approximate.

use kurbo::Rect;

use super::paint::Paint;
use super::style::{Style, default_stroke_width};
use crate::approximate::Drawing;
use crate::conic;
use crate::contour::{Closeness, Maker, PathDrawing};
use crate::course::Course;
use crate::curve::Curve;
use crate::number::{compact, rounded_up, significant, text};
use crate::shape::{Outline, Shape};
use crate::sphere::{Part, Picture};
use crate::spline::{Ends, Spline};

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
    pub truths: Vec<Outline>,
    /// Lines and circular arcs in place of curves.
    pub courses: Vec<Course>,
    /// How closely lines and arcs follow the Béziers in whose place they stand.
    pub closeness: Option<Closeness>,
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

    /// The true shape of the curve of this number: there is one for all curves, or one for each.
    #[must_use]
    pub fn truth(&self, number: usize) -> Option<&Outline> {
        match self.truths.as_slice() {
            [only] => Some(only),
            several => several.get(number),
        }
    }

    /// The smallest rectangle around the curves themselves, not their control points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<Rect> {
        self.curves()
            .filter_map(Curve::bounding_box)
            .reduce(|a, b| a.union(b))
    }

    /// The description, and how what is shown is to be read.
    pub(crate) fn described(&self, style: &Style) -> String {
        match style.show.error {
            Some(factor) if !self.truths.is_empty() => format!(
                "{}; deviation drawn {} times as large, orange outside and blue inside",
                self.description,
                text(factor)
            ),
            _ => self.description.clone(),
        }
    }
}

impl Figure {
    /// The width of the stroke where none is asked for; see [`default_stroke_width`].
    #[must_use]
    pub fn default_stroke_width(&self) -> f64 {
        let bounds = self.bounding_box().unwrap_or(Rect::ZERO);
        default_stroke_width(bounds.width().max(bounds.height()))
    }
}

impl From<&Drawing> for Figure {
    fn from(drawing: &Drawing) -> Self {
        let title = describe(&drawing.shape);
        let description = if drawing.outline.is_some() {
            format!(
                "{title}; {count} segment{s} by {method}; within {peak} of the true shape ({relative} of the larger radius)",
                count = drawing.curve.segments.len(),
                s = if drawing.curve.segments.len() == 1 {
                    ""
                } else {
                    "s"
                },
                method = drawing.rule.id(),
                peak = significant(rounded_up(drawing.error.peak(), 3), 3),
                relative = significant(rounded_up(drawing.relative_peak(), 3), 3),
            )
        } else {
            format!("{title}; exact")
        };
        Self {
            name: name(&drawing.shape),
            title,
            description,
            layers: vec![Layer {
                curves: vec![drawing.curve.clone()],
                ..Layer::default()
            }],
            truths: drawing.outline.into_iter().collect(),
            courses: Vec::new(),
            closeness: None,
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
            truths: Vec::new(),
            courses: drawing.courses().cloned().collect(),
            closeness: drawing.closeness(),
        }
    }
}

impl Figure {
    /// A parabola or a hyperbola.
    #[must_use]
    pub fn of_conic(drawing: &conic::Drawing) -> Self {
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

fn conic_title(conic: &conic::Conic) -> String {
    let [from, to] = [conic.from, conic.to].map(|p| text(p.x) + "," + &text(p.y));
    format!("{} from {from} to {to}", conic.kind().name())
}

/// A parabola or a hyperbola and how closely it was drawn, in a line; the figure is rounded up.
pub(crate) fn conic_summary(drawing: &conic::Drawing) -> String {
    let count = drawing.curve.segments.len();
    let closeness = match (drawing.error.peak(), drawing.method) {
        (0.0, None) => ", exact".to_owned(),
        (peak, method) => format!(
            "{}, within {}",
            method.map_or_else(String::new, |method| format!(" by {method}")),
            significant(rounded_up(peak, 3), 3)
        ),
    };
    let title = conic_title(&drawing.conic);
    format!("{title}: {count} segment{}{closeness}", plural(count))
}

/// A path and how closely it was drawn, in a line; the figures are rounded up.
pub(crate) fn path_summary(drawing: &PathDrawing) -> String {
    let count = drawing.subpaths.len();
    let segments = drawing.curves().map(|curve| curve.segments.len());
    let steps = drawing.courses().map(|course| course.steps.len());
    let segments: usize = segments.chain(steps).sum();
    let closeness = match drawing.error().peak() {
        0.0 => "exact".to_owned(),
        peak => format!(
            "{}within {}",
            match drawing.maker {
                Maker::Rule(rule) => format!("arcs by {}, ", rule.id()),
                Maker::Lines | Maker::Arcs => String::new(),
            },
            significant(rounded_up(peak, 3), 3)
        ),
    };
    format!(
        "path of {count} subpath{}: {segments} segment{}, {closeness}",
        plural(count),
        plural(segments)
    )
}

const fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// With a capital first letter.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

/// What was drawn and how closely, in a line; the figures are rounded up.
pub(crate) fn summary(drawing: &Drawing) -> String {
    let title = describe(&drawing.shape);
    let mut letters = title.chars();
    let first = letters
        .next()
        .map_or_else(String::new, |c| c.to_lowercase().to_string());
    let title = first + letters.as_str();
    if drawing.outline.is_none() {
        return format!("{title}: exact");
    }
    let count = drawing.curve.segments.len();
    format!(
        "{title}: {count} segment{} by {}, within {} ({} of the larger radius)",
        plural(count),
        drawing.rule.id(),
        significant(rounded_up(drawing.error.peak(), 3), 3),
        compact(rounded_up(drawing.relative_peak(), 3), 3),
    )
}

/// A shape in a word.
const fn name(shape: &Shape) -> &'static str {
    match shape {
        Shape::Circle(_) => "circle",
        Shape::Ellipse(_) => "ellipse",
        Shape::Arc(_) => "arc",
        Shape::Line(_) => "line",
        Shape::Empty => "empty",
    }
}

/// A shape in a few words.
#[must_use]
pub fn describe(shape: &Shape) -> String {
    let n = |x| significant(x, 9);
    match shape {
        Shape::Circle(c) => format!("Circle of radius {}", n(c.radius)),
        Shape::Ellipse(e) => format!("Ellipse with radii {} and {}", n(e.radii.x), n(e.radii.y)),
        Shape::Arc(a) if a.radii.x == a.radii.y => {
            format!(
                "Arc of radius {} over {} degrees",
                n(a.radii.x),
                n(a.sweep.degrees())
            )
        }
        Shape::Arc(a) => {
            format!(
                "Arc with radii {} and {} over {} degrees",
                n(a.radii.x),
                n(a.radii.y),
                n(a.sweep.degrees())
            )
        }
        Shape::Line(_) => "Line".to_owned(),
        Shape::Empty => "Empty path".to_owned(),
    }
}

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
            truths: Vec::new(),
            courses: Vec::new(),
            closeness: None,
        }
    }
}

fn describe_sphere(picture: &Picture, title: &str) -> String {
    format!(
        "{title} seen from longitude {longitude}, latitude {latitude} degrees; {meridians} meridians and {parallels} parallels by {method}; in space within {peak} of the true circles ({relative} of the radius)",
        longitude = text(picture.view.longitude.degrees()),
        latitude = text(picture.view.latitude.degrees()),
        meridians = picture.sphere.meridians,
        parallels = picture.sphere.parallels,
        method = picture.options.rule.id(),
        peak = significant(rounded_up(picture.error.peak(), 3), 3),
        relative = significant(
            rounded_up(picture.error.peak() / picture.sphere.radius, 3),
            3
        ),
    )
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
            truths: Vec::new(),
            courses: Vec::new(),
            closeness: None,
        }
    }
}

/// How the curve runs through its points.
fn describe_spline(spline: &Spline) -> String {
    let settled = match spline.rounds {
        0 => String::new(),
        rounds => format!(", settled in {rounds} rounds"),
    };
    let ends = match spline.options.ends {
        Ends::Cyclic => "cyclic",
        Ends::Free => "free",
        Ends::Natural => "natural",
        Ends::Fixed(_) => "fixed",
    };
    let unit = spline.options.unit_tangents.then_some(", unit tangents");
    let tangents = unit.unwrap_or_default();
    let parametrization = spline.options.parametrization.name();
    format!("{parametrization} parametrization{settled}, {ends} ends{tangents}")
}
