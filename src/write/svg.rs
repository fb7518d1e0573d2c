//! SVG documents.

use kurbo::Rect;
use svg::node::element::{Circle, Description, Element, Path, Rectangle, Title};
use svg::node::{Node, Text};
use svgtypes::Color;

use crate::angle::Angle;
use crate::number::{Precision, text};
use crate::path;
use crate::picture::scene::{Group, Mark, Pen, Scene};
use crate::picture::style::Paint;
use crate::shape::Outline;

/// The largest angle of an arc command, in degrees. An arc of half a turn is found from its ends alone, so that their rounding
/// would move its centre far.
const LARGEST_ARC: f64 = 120.0;

/// A whole document: a fitting `viewBox`, `<title>` and `<desc>`, one `<path>` for each curve.
#[must_use]
pub fn document(scene: &Scene, title: &str, description: &str, relative: bool) -> String {
    let view = scene.view;
    let corner_and_size = [view.x0, view.y0, view.width(), view.height()];
    let mut document = svg::Document::new()
        .set("viewBox", corner_and_size.map(|x| scene.text(x)).join(" "))
        .add(Title::new(title))
        .add(Description::new().add(Text::new(description)));
    if let Some([width, height]) = scene.size {
        document = document
            .set("width", text(width))
            .set("height", text(height));
    }
    if let Some(color) = scene.background.and_then(Paint::visible) {
        document.append(background(scene, color));
    }
    for group in &scene.groups {
        add_group(&mut document, group, scene, relative);
    }
    document.to_string() + "\n"
}

impl Scene {
    /// The text of a coordinate with as many decimals as a picture can show.
    fn text(&self, x: f64) -> String {
        text(Precision::Fixed(self.decimals).round(x))
    }
}

fn background(scene: &Scene, color: Color) -> Element {
    let area: Rect = scene.canvas();
    let mut element: Element = Rectangle::new()
        .set("x", scene.text(area.x0))
        .set("y", scene.text(area.y0))
        .set("width", scene.text(area.width()))
        .set("height", scene.text(area.height()))
        .into();
    set_color(&mut element, "fill", Paint::Color(color));
    element
}

/// A group with a class becomes a `<g>`; the marks of one without stand alone.
fn add_group(document: &mut svg::Document, group: &Group, scene: &Scene, relative: bool) {
    let marks = group
        .marks
        .iter()
        .map(|mark| element(mark, scene, relative));
    if let Some(class) = group.class {
        let mut parent = Element::new("g");
        parent.assign("class", class);
        set_pen(&mut parent, &group.pen);
        marks.for_each(|mark| parent.append(mark));
        document.append(parent);
    } else {
        for mut mark in marks {
            set_pen(&mut mark, &group.pen);
            document.append(mark);
        }
    }
}

fn element(mark: &Mark, scene: &Scene, relative: bool) -> Element {
    match mark {
        Mark::Curve(curve) => Path::new().set("d", path::data([curve], relative)).into(),
        Mark::Truth(outline) => Path::new().set("d", arcs(outline, scene)).into(),
        Mark::Dot(dot) => Circle::new()
            .set("cx", text(dot.center.x))
            .set("cy", text(dot.center.y))
            .set("r", text(dot.radius))
            .into(),
    }
}

/// The true shape itself, in arc commands.
fn arcs(outline: &Outline, scene: &Scene) -> String {
    let sweep = outline.unit.sweep.degrees();
    let count = (sweep.abs() / LARGEST_ARC).ceil().max(1.0);
    let point = |part: f64| {
        let angle = outline.unit.start.degrees() + sweep * (part / count);
        let p = outline.placement * Angle::from_degrees(angle).direction().to_point();
        [scene.text(p.x), scene.text(p.y)].join(" ")
    };
    let truth = &outline.truth;
    let ellipse = [
        text(truth.radii.x),
        text(truth.radii.y),
        text(truth.axis.atan2().to_degrees()),
    ];
    let positive = (sweep > 0.0) == (outline.placement.determinant() > 0.0);
    let command = format!("A{} 0 {} ", ellipse.join(" "), u8::from(positive));
    let mut data = format!("M{}", point(0.0));
    for i in 1..=count as u32 {
        data += &command;
        data += &point(f64::from(i));
    }
    if outline.unit.closed {
        data.push('Z');
    }
    data
}

fn set_pen(element: &mut Element, pen: &Pen) {
    set_color(element, "fill", pen.fill);
    let Some((_, width)) = pen.visible_stroke() else {
        return;
    };
    set_color(element, "stroke", pen.stroke);
    element.assign("stroke-width", text(width));
    element.assign("stroke-linejoin", "round");
    if let Some(dash) = pen.dash {
        element.assign("stroke-dasharray", text(dash));
    }
}

/// Sets `fill` or `stroke`, and its opacity where it is not opaque.
fn set_color(element: &mut Element, name: &str, paint: Paint) {
    let Paint::Color(Color {
        red,
        green,
        blue,
        alpha,
    }) = paint
    else {
        element.assign(name, "none");
        return;
    };
    let short = [red, green, blue].iter().all(|byte| byte / 16 == byte % 16);
    let hexadecimal = if short {
        format!("#{:x}{:x}{:x}", red % 16, green % 16, blue % 16)
    } else {
        format!("#{red:02x}{green:02x}{blue:02x}")
    };
    element.assign(name, hexadecimal);
    if alpha < 255 {
        let opacity = Precision::Fixed(3).round(f64::from(alpha) / 255.0);
        element.assign(format!("{name}-opacity"), text(opacity));
    }
}
