//! What is drawn and how closely, in words; figures are bounds, rounded up.

use crate::approximate::Drawing;
use crate::conic;
use crate::contour::{Maker, PathDrawing};
use crate::number::{compact, counted, rounded_up, significant, text};
use crate::shape::Shape;
use crate::sphere::SphereView;
use crate::spline::{Spline, SplineEnds};

pub(super) fn conic_title(conic: &conic::Conic) -> String {
    let [from, to] = [conic.from, conic.to].map(|p| text(p.x) + "," + &text(p.y));
    format!("{} from {from} to {to}", conic.kind().name())
}

/// A parabola or a hyperbola and how closely it was drawn, in a line; the figure is rounded up.
pub(crate) fn conic_summary(drawing: &conic::ConicDrawing) -> String {
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
    format!("{title}: {}{closeness}", counted(count, "segment"))
}

/// A path and how closely it was drawn, in a line; the figures are rounded up.
pub(crate) fn path_summary(drawing: &PathDrawing) -> String {
    let count = drawing.subpaths.len();
    let segments = drawing.curves().map(|curve| curve.segments.len());
    let steps = drawing.courses().map(|course| course.steps.len());
    let segments: usize = segments.chain(steps).sum();
    let has_arcs = drawing.subpaths.iter().any(|path| !path.truths.is_empty());
    let peak = drawing.error().peak();
    let closeness = match drawing.maker {
        Maker::Rule(rule) if has_arcs && peak > 0.0 => {
            format!("arcs by {}, {}", rule.id(), within(peak))
        }
        Maker::Rule(_) | Maker::Lines | Maker::Arcs => within(peak),
    };
    format!(
        "path of {}: {}, {closeness}",
        counted(count, "subpath"),
        counted(segments, "segment")
    )
}

/// How closely a path was drawn, the figure rounded up.
#[must_use]
pub fn within(error: f64) -> String {
    if error == 0.0 {
        "exact".to_owned()
    } else {
        format!("within {}", significant(rounded_up(error, 3), 3))
    }
}

/// With a capital first letter.
pub(crate) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

/// What was drawn and how closely, in a line; the figures are rounded up.
pub(crate) fn summary(drawing: &Drawing) -> String {
    let title = title(drawing);
    let mut letters = title.chars();
    let first = letters
        .next()
        .map_or_else(String::new, |c| c.to_lowercase().to_string());
    let title = first + letters.as_str();
    if drawing.outline.is_none() {
        return format!("{title}: {}", within(drawing.error.peak()));
    }
    let count = drawing.curve.segments.len();
    format!(
        "{title}: {} by {}, within {} ({} of the larger radius)",
        counted(count, "segment"),
        drawing.rule.id(),
        significant(rounded_up(drawing.error.peak(), 3), 3),
        compact(rounded_up(drawing.relative_peak(), 3), 3),
    )
}

/// A shape in a word.
pub(super) const fn name(shape: &Shape) -> &'static str {
    match shape {
        Shape::Circle(_) => "circle",
        Shape::Ellipse(_) => "ellipse",
        Shape::Arc(_) => "arc",
        Shape::Line(_) => "line",
        Shape::Empty => "empty",
    }
}

/// What was drawn in a few words, with a mark where the figures of its error are those of another size or form.
pub(super) fn title(drawing: &Drawing) -> String {
    let transformed = if drawing.transform == kurbo::Affine::IDENTITY {
        ""
    } else {
        ", transformed"
    };
    describe(&drawing.shape) + transformed
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

pub(super) fn describe_sphere(picture: &SphereView, title: &str) -> String {
    format!(
        "{title} seen from longitude {longitude}, latitude {latitude} degrees; {meridians} meridians and {parallels} parallels by {method}; within {peak} of the true circles as they are seen ({relative} of the radius)",
        longitude = text(picture.view.longitude.degrees()),
        latitude = text(picture.view.latitude.degrees()),
        meridians = picture.sphere.meridians,
        parallels = picture.sphere.parallels,
        method = picture.options.rule.id(),
        peak = significant(rounded_up(picture.error.peak(), 3), 3),
        relative = significant(rounded_up(picture.relative_peak(), 3), 3),
    )
}

/// How the curve runs through its points.
pub(super) fn describe_spline(spline: &Spline) -> String {
    let settled = match spline.rounds {
        0 => String::new(),
        rounds => format!(", settled in {rounds} rounds"),
    };
    let ends = match spline.options.ends {
        SplineEnds::Cyclic => "cyclic",
        SplineEnds::Free => "free",
        SplineEnds::Natural => "natural",
        SplineEnds::Fixed(_) => "fixed",
    };
    let unit = spline.options.unit_tangents.then_some(", unit tangents");
    let tangents = unit.unwrap_or_default();
    let parametrization = spline.options.parametrization.name();
    format!("{parametrization} parametrization{settled}, {ends} ends{tangents}")
}
