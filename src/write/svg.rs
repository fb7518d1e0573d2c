//! SVG documents.

use kurbo::Rect;
use svg::node::element::{Circle, Description, Element, Path, Rectangle, Title};
use svg::node::{self, Node};

use crate::angle::Angle;
use crate::course::{Course, CourseStep};
use crate::number::{Precision, text as digits};
use crate::numeric::functions::angle_of;
use crate::path;
use crate::picture::paint::{Color, Paint};
use crate::picture::scene::{Group, Mark, Pen, Scene};
#[cfg(feature = "plot")]
use crate::picture::text::{Anchor, FAMILY, Text};
use crate::shape::Outline;
use crate::shape::endpoint::SvgArc;

/// The largest angle of an arc command, in degrees. An arc of half a turn is found from its ends alone, so that their rounding
/// would move its centre far.
const LARGEST_ARC: f64 = 120.0;

/// A whole document: a fitting `viewBox`, `<title>` and `<desc>`, one `<path>` for each curve, its data relative where that is asked
/// for.
#[must_use]
pub fn document(scene: &Scene, relative: bool) -> String {
    let view = scene.view;
    let corner_and_size = [view.x0, view.y0, view.width(), view.height()];
    let mut document = svg::Document::new()
        .set("viewBox", corner_and_size.map(|x| scene.text(x)).join(" "))
        .add(Title::new(scene.title.as_str()));
    if !scene.description.is_empty() {
        let words = node::Text::new(scene.description.as_str());
        document.append(Description::new().add(words));
    }
    if let Some(size) = scene.size {
        document.assign("width", size.width.to_string());
        document.assign("height", size.height.to_string());
    }
    if let Some(paint) = scene.background.filter(|paint| paint.visible().is_some()) {
        document.append(background(scene, paint));
    }
    for group in &scene.groups {
        add_group(&mut document, group, scene, relative);
    }
    document.to_string() + "\n"
}

impl Scene {
    /// The text of a coordinate with as many decimals as a picture can show.
    fn text(&self, x: f64) -> String {
        digits(Precision::Fixed(self.decimals).round(x))
    }
}

fn background(scene: &Scene, paint: Paint) -> Element {
    let area: Rect = scene.canvas();
    let mut element: Element = Rectangle::new()
        .set("x", scene.text(area.x0))
        .set("y", scene.text(area.y0))
        .set("width", scene.text(area.width()))
        .set("height", scene.text(area.height()))
        .into();
    set_paint(&mut element, "fill", paint);
    element
}

/// A group with a class becomes a `<g>`; the marks of one without stand alone.
fn add_group(document: &mut svg::Document, group: &Group, scene: &Scene, relative: bool) {
    let marks = group.marks.iter().map(|mark| shape(mark, scene, relative));
    if let Some(class) = group.class {
        let mut parent = Element::new("g");
        parent.assign("class", class);
        set_pen(&mut parent, &group.pen);
        #[cfg(feature = "plot")]
        if group.marks.iter().any(|mark| matches!(mark, Mark::Text(_))) {
            parent.assign("font-family", FAMILY);
        }
        marks.for_each(|mark| parent.append(mark));
        document.append(parent);
    } else {
        for mut mark in marks {
            if let Some(id) = &group.id {
                mark.assign("id", id.as_str());
            }
            set_pen(&mut mark, &group.pen);
            document.append(mark);
        }
    }
}

fn shape(mark: &Mark, scene: &Scene, relative: bool) -> Element {
    match mark {
        Mark::Curve(curve) => Path::new().set("d", path::data([curve], relative)).into(),
        Mark::Path(curves) => Path::new().set("d", path::data(curves, relative)).into(),
        Mark::Arcs(courses) => Path::new()
            .set("d", path::data_of_courses(courses, relative))
            .into(),
        Mark::Truth(outline) => Path::new()
            .set(
                "d",
                path::data_of_courses([&arcs(outline, scene)], relative),
            )
            .into(),
        Mark::Dot(dot) => Circle::new()
            .set("cx", digits(dot.center.x))
            .set("cy", digits(dot.center.y))
            .set("r", digits(dot.radius))
            .into(),
        #[cfg(feature = "plot")]
        Mark::Text(text) => words(text, scene),
    }
}

#[cfg(feature = "plot")]
fn words(text: &Text, scene: &Scene) -> Element {
    let [x, y] = [text.at.x, text.at.y].map(|x| scene.text(x));
    let mut element: Element = svg::node::element::Text::new(text.words.as_str())
        .set("font-size", digits(text.size))
        .into();
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => element.assign("text-anchor", "middle"),
        Anchor::End => element.assign("text-anchor", "end"),
    }
    if text.upwards {
        element.assign("transform", ["rotate(-90 ", &x, " ", &y, ")"].concat());
    }
    element.assign("x", x);
    element.assign("y", y);
    element
}

/// The true shape itself, in arcs.
fn arcs(outline: &Outline, scene: &Scene) -> Course {
    let sweep = outline.unit.sweep.degrees();
    let count = (sweep.abs() / LARGEST_ARC).ceil().max(1.0);
    let point = |joint: u32| {
        let angle = outline.unit.start.degrees() + sweep * (f64::from(joint) / count);
        outline.placement * Angle::from_degrees(angle).direction().to_point()
    };
    // The axis is a vector, whose angle has idle digits; as far as this nobody sees it turn.
    let rotation = Precision::Fixed(9).round(angle_of(outline.truth.axis).to_degrees());
    let arc = |joint: u32| SvgArc {
        from: point(joint - 1),
        radii: outline.truth.radii,
        rotation: Angle::from_degrees(rotation),
        large_arc: false,
        sweep: (sweep > 0.0) == (outline.placement.determinant() > 0.0),
        to: point(joint),
    };
    let course = Course {
        start: point(0),
        steps: (1..=count as u32)
            .map(arc)
            .map(CourseStep::Elliptical)
            .collect(),
        closed: outline.unit.closed,
    };
    course.rounded(Precision::Fixed(scene.decimals))
}

fn set_pen(element: &mut Element, pen: &Pen) {
    set_paint(element, "fill", pen.fill);
    let Some((_, width)) = pen.visible_stroke() else {
        return;
    };
    set_paint(element, "stroke", pen.stroke);
    element.assign("stroke-width", digits(width));
    element.assign("stroke-linejoin", "round");
    if !pen.dash.is_empty() {
        let lengths: Vec<String> = pen.dash.iter().map(|&length| digits(length)).collect();
        element.assign("stroke-dasharray", lengths.join(" "));
    }
}

/// Sets `fill` or `stroke`, and its opacity where it is not opaque.
fn set_paint(element: &mut Element, name: &str, paint: Paint) {
    match paint {
        Paint::None => element.assign(name, "none"),
        Paint::Current => element.assign(name, "currentColor"),
        Paint::Color(color) => {
            element.assign(name, hexadecimal(color));
            if color.alpha < 255 {
                element.assign(format!("{name}-opacity"), opacity(color.alpha));
            }
        }
    }
}

fn hexadecimal(color: Color) -> String {
    let Color {
        red, green, blue, ..
    } = color;
    if [red, green, blue].iter().all(|byte| byte / 16 == byte % 16) {
        format!("#{:x}{:x}{:x}", red % 16, green % 16, blue % 16)
    } else {
        format!("#{red:02x}{green:02x}{blue:02x}")
    }
}

/// The shorter of two or three decimals that is read as the same byte, as CSS Color 4 writes it.
fn opacity(alpha: u8) -> String {
    let exact = f64::from(alpha) / 255.0;
    let short = Precision::Fixed(2).round(exact);
    let same = (short * 255.0).round() == f64::from(alpha);
    digits(if same {
        short
    } else {
        Precision::Fixed(3).round(exact)
    })
}
