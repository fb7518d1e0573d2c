//! A judge of conversions that shares no code with the converter: roxmltree reads the XML, svgtypes the path data, and arcs are
//! put into centre form by the formulas of SVG 2, appendix B.2.4, as they stand.

#![allow(clippy::needless_pass_by_value, clippy::struct_field_names)]

use resvg::usvg::roxmltree::{Document, Node, NodeType, ParsingOptions};
use svgtypes::{PathParser, PathSegment};

pub(crate) const GEOMETRY: [(&str, &[&str]); 3] = [
    ("circle", &["cx", "cy", "r"]),
    ("ellipse", &["cx", "cy", "rx", "ry"]),
    ("rect", &["x", "y", "width", "height", "rx", "ry"]),
];

type Check = Result<(), String>;

pub(crate) fn parse(text: &str) -> Result<Document<'_>, String> {
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| error.to_string())
}

/// How many arcs, circles, ellipses and round rectangles a document has.
pub(crate) fn remaining(text: &str) -> Result<usize, String> {
    let document = parse(text)?;
    let mut count = 0;
    for node in document
        .descendants()
        .filter(|node| node.tag_name().namespace() == Some("http://www.w3.org/2000/svg"))
    {
        count += match node.tag_name().name() {
            "circle" | "ellipse" => 1,
            "rect" => usize::from(
                ["rx", "ry"]
                    .iter()
                    .any(|name| node.attribute(*name).is_some_and(|v| v != "0")),
            ),
            "path" => segments(node.attribute("d").unwrap_or_default())
                .iter()
                .filter(|segment| matches!(segment, Segment::Arc(..)))
                .count(),
            _ => 0,
        };
    }
    Ok(count)
}

/// The start tags in `before` of what is still a circle, an ellipse, a round rectangle or a path with arcs in `after`. Elements
/// that come out of entities have no place of their own and are not looked at.
pub(crate) fn left(before: &str, after: &str) -> Result<Vec<core::ops::Range<usize>>, String> {
    let (old, new) = (parse(before)?, parse(after)?);
    if before.contains("<!ENTITY") {
        return Ok(Vec::new());
    }
    let svg =
        |node: &Node<'_, '_>| node.tag_name().namespace() == Some("http://www.w3.org/2000/svg");
    let is_left = |node: Node<'_, '_>| {
        let positive = |name: &str| length(node.attribute(name)).is_some_and(|x| x > 0.0);
        match node.tag_name().name() {
            "circle" | "ellipse" => true,
            "rect" => ["rx", "ry", "width", "height"].into_iter().all(positive),
            "path" => segments(node.attribute("d").unwrap_or_default())
                .iter()
                .any(|segment| matches!(segment, Segment::Arc(..))),
            _ => false,
        }
    };
    Ok(old
        .descendants()
        .zip(new.descendants())
        .filter(|(_, node)| svg(node) && is_left(*node))
        .map(|(node, _)| {
            let range = node.range();
            range.start
                ..node
                    .first_child()
                    .map_or(range.end, |child| child.range().start)
        })
        .collect())
}

/// A length in user units.
pub(crate) fn length(text: Option<&str>) -> Option<f64> {
    let length: svgtypes::Length = text?.trim().parse().ok()?;
    let unit = match length.unit {
        svgtypes::LengthUnit::None | svgtypes::LengthUnit::Px => 1.0,
        svgtypes::LengthUnit::In => 96.0,
        svgtypes::LengthUnit::Cm => 96.0 / 2.54,
        svgtypes::LengthUnit::Mm => 96.0 / 25.4,
        svgtypes::LengthUnit::Pt => 96.0 / 72.0,
        svgtypes::LengthUnit::Pc => 16.0,
        _ => return None,
    };
    Some(length.number * unit)
}

/// Checks that `after` is `before` with its shapes and arcs replaced, all other bytes the same, each curve within `tolerance` of
/// the true arc (as a part of its larger radius).
pub(crate) fn check(before: &str, after: &str, tolerance: f64) -> Check {
    let (old, new) = (parse(before)?, parse(after)?);
    let (mut cuts_before, mut cuts_after) = (Vec::new(), Vec::new());
    let (mut left, mut right) = (old.descendants(), new.descendants());
    loop {
        match (left.next(), right.next()) {
            (None, None) => break,
            (Some(a), Some(b)) if a.node_type() == b.node_type() => {
                if a.node_type() == NodeType::Element {
                    element(
                        a,
                        b,
                        (before, &mut cuts_before),
                        (after, &mut cuts_after),
                        tolerance,
                    )?;
                }
            }
            (a, b) => return Err(format!("the trees differ: {a:?} {b:?}")),
        }
    }
    let (skeleton_before, skeleton_after) = (cut(before, cuts_before), cut(after, cuts_after));
    if skeleton_before == skeleton_after {
        return Ok(());
    }
    let at = skeleton_before
        .bytes()
        .zip(skeleton_after.bytes())
        .take_while(|(a, b)| a == b)
        .count();
    Err(format!(
        "bytes outside of what was replaced differ near {:?}",
        skeleton_before.get(at.saturating_sub(30)..at + 10)
    ))
}

type Cuts<'a> = (&'a str, &'a mut Vec<core::ops::Range<usize>>);

fn element(
    a: Node<'_, '_>,
    b: Node<'_, '_>,
    before: Cuts<'_>,
    after: Cuts<'_>,
    tolerance: f64,
) -> Check {
    let (name_a, name_b) = (a.tag_name().name(), b.tag_name().name());
    let place = format!("<{name_a}> at byte {}", a.range().start);
    if a.tag_name().namespace() != b.tag_name().namespace() {
        return Err(format!("{place}: another namespace"));
    }
    if name_a == name_b {
        if name_a == "path" && a.attribute("d") != b.attribute("d") {
            let (d_a, d_b) = (
                a.attribute_node("d").unwrap(),
                b.attribute_node("d").unwrap(),
            );
            other_bytes(d_a.value(), d_b.value()).map_err(|why| format!("{place}: {why}"))?;
            same_curve(&segments(d_a.value()), &segments(d_b.value()), tolerance)
                .map_err(|why| format!("{place}: {why}\n{}\n{}", d_a.value(), d_b.value()))?;
            before.1.push(d_a.range_value());
            after.1.push(d_b.range_value());
        }
        return Ok(());
    }
    let geometry = GEOMETRY
        .iter()
        .find(|(name, _)| *name == name_a)
        .ok_or_else(|| format!("{place} became <{name_b}>"))?
        .1;
    if name_b != "path" {
        return Err(format!("{place} became <{name_b}>"));
    }
    let expected = equivalent_path(name_a, |name| {
        length(a.attribute(name)).filter(|x| *x >= 0.0 || !name.starts_with('r'))
    });
    let d = b
        .attribute("d")
        .ok_or_else(|| format!("{place} became a path without data"))?;
    same_curve(&expected, &segments(d), tolerance).map_err(|why| format!("{place}: {why}: {d}"))?;
    names(a, before.0, before.1);
    names(b, after.0, after.1);
    for attribute in a
        .attributes()
        .filter(|attribute| attribute.namespace().is_none() && geometry.contains(&attribute.name()))
    {
        before.1.push(with_space(before.0, attribute.range()));
    }
    after
        .1
        .push(with_space(after.0, b.attribute_node("d").unwrap().range()));
    Ok(())
}

/// The places of an element's local name: in the start tag and in the end tag.
fn names(node: Node<'_, '_>, text: &str, cuts: &mut Vec<core::ops::Range<usize>>) {
    let name = node.tag_name().name();
    let range = node.range();
    let start = range.start + text[range.clone()].find(name).unwrap();
    cuts.push(start..start + name.len());
    let last_tag = text[range.clone()].rfind('<').unwrap();
    if text[range.start + last_tag..].starts_with("</") {
        let start = range.start + last_tag + text[range.start + last_tag..].find(name).unwrap();
        cuts.push(start..start + name.len());
    }
}

fn with_space(text: &str, range: core::ops::Range<usize>) -> core::ops::Range<usize> {
    text[..range.start].trim_end().len()..range.end
}

fn cut(text: &str, mut ranges: Vec<core::ops::Range<usize>>) -> String {
    ranges.sort_by_key(|range| range.start);
    let mut out = String::new();
    let mut at = 0;
    for range in ranges {
        out.push_str(&text[at..range.start]);
        at = range.end;
    }
    out + &text[at..]
}

/// Checks that every command that is not an arc stands in the new data as it stood in the old, in the same order, and that
/// nothing else but curves and lines came in.
fn other_bytes(before: &str, after: &str) -> Check {
    let split = |text: &str| -> Vec<String> {
        let mut chunks = vec![String::new()];
        for c in text.chars() {
            if c.is_ascii_alphabetic() && c != 'e' && c != 'E' {
                chunks.push(String::new());
            }
            chunks.last_mut().unwrap().push(c);
        }
        chunks
    };
    let (old, new) = (split(before), split(after));
    let mut new = new.iter();
    let mut behind_arc = false;
    for chunk in old {
        if chunk.starts_with(['a', 'A']) {
            behind_arc = true;
            continue;
        }
        // A smooth command behind an arc is spelled out.
        if behind_arc && chunk.starts_with(['s', 'S']) {
            behind_arc = false;
            continue;
        }
        behind_arc = false;
        loop {
            match new.next() {
                Some(other) if *other == chunk => break,
                // White space before the next command belongs to the arc's chunk.
                Some(other) if other.starts_with(['c', 'C', 'l', 'L', 'a', 'A', 's', 'S']) => {}
                other => return Err(format!("{chunk:?} became {other:?}")),
            }
        }
    }
    match new.find(|chunk| !chunk.starts_with(['c', 'C', 'l', 'L', 'a', 'A', 's', 'S'])) {
        None => Ok(()),
        Some(extra) => Err(format!("{extra:?} came in")),
    }
}

pub(crate) type P = [f64; 2];

/// A segment in absolute coordinates, smooth commands spelled out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Segment {
    Move(P),
    Line(P),
    Quad(P, P),
    Cubic(P, P, P),
    /// Radii, rotation in degrees, large, sweep, end.
    Arc(P, f64, bool, bool, P),
    Close,
}

impl Segment {
    /// Where it ends; a closing segment does where its subpath starts, which it does not know.
    pub(crate) const fn end(&self) -> Option<P> {
        match *self {
            Self::Move(p)
            | Self::Line(p)
            | Self::Quad(_, p)
            | Self::Cubic(.., p)
            | Self::Arc(.., p) => Some(p),
            Self::Close => None,
        }
    }
}

/// The path data up to their first error.
pub(crate) fn segments(d: &str) -> Vec<Segment> {
    let mut out = Vec::new();
    let (mut at, mut start): (P, P) = ([0.0; 2], [0.0; 2]);
    // The last control point, for S and for T.
    let (mut cubic, mut quad): (Option<P>, Option<P>) = (None, None);
    for segment in PathParser::from(d).map_while(Result::ok) {
        let base = |abs: bool| if abs { [0.0; 2] } else { at };
        let p = |abs: bool, x: f64, y: f64| [base(abs)[0] + x, base(abs)[1] + y];
        let mirror =
            |control: Option<P>| control.map_or(at, |c| [2.0 * at[0] - c[0], 2.0 * at[1] - c[1]]);
        let (next, next_cubic, next_quad, segment) = match segment {
            PathSegment::MoveTo { abs, x, y } => {
                start = p(abs, x, y);
                (start, None, None, Segment::Move(start))
            }
            PathSegment::LineTo { abs, x, y } => {
                (p(abs, x, y), None, None, Segment::Line(p(abs, x, y)))
            }
            PathSegment::HorizontalLineTo { abs, x } => {
                let end = [base(abs)[0] + x, at[1]];
                (end, None, None, Segment::Line(end))
            }
            PathSegment::VerticalLineTo { abs, y } => {
                let end = [at[0], base(abs)[1] + y];
                (end, None, None, Segment::Line(end))
            }
            PathSegment::CurveTo {
                abs,
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => {
                let (c2, end) = (p(abs, x2, y2), p(abs, x, y));
                (end, Some(c2), None, Segment::Cubic(p(abs, x1, y1), c2, end))
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                let (c2, end) = (p(abs, x2, y2), p(abs, x, y));
                (end, Some(c2), None, Segment::Cubic(mirror(cubic), c2, end))
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                let (c, end) = (p(abs, x1, y1), p(abs, x, y));
                (end, None, Some(c), Segment::Quad(c, end))
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                let (c, end) = (mirror(quad), p(abs, x, y));
                (end, None, Some(c), Segment::Quad(c, end))
            }
            PathSegment::EllipticalArc {
                abs,
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
            } => {
                let end = p(abs, x, y);
                (
                    end,
                    None,
                    None,
                    Segment::Arc([rx.abs(), ry.abs()], x_axis_rotation, large_arc, sweep, end),
                )
            }
            PathSegment::ClosePath { .. } => (start, None, None, Segment::Close),
        };
        (at, cubic, quad) = (next, next_cubic, next_quad);
        out.push(segment);
    }
    out
}

/// The equivalent path of SVG 2 for a shape.
pub(crate) fn equivalent_path(name: &str, get: impl Fn(&str) -> Option<f64>) -> Vec<Segment> {
    let zero = |name: &str| get(name).unwrap_or(0.0);
    let arc = |r: P, end: P| Segment::Arc(r, 0.0, false, true, end);
    if name == "rect" {
        let (x, y, w, h) = (zero("x"), zero("y"), zero("width"), zero("height"));
        let rx = get("rx").or(get("ry")).unwrap().min(w / 2.0);
        let ry = get("ry").or(get("rx")).unwrap().min(h / 2.0);
        let r = [rx, ry];
        let mut path = vec![Segment::Move([x + rx, y])];
        let mut side = |line: bool, from: P, to: P| {
            if line {
                path.push(Segment::Line(from));
            }
            path.push(arc(r, to));
        };
        side(w > 2.0 * rx, [x + w - rx, y], [x + w, y + ry]);
        side(h > 2.0 * ry, [x + w, y + h - ry], [x + w - rx, y + h]);
        side(w > 2.0 * rx, [x + rx, y + h], [x, y + h - ry]);
        side(h > 2.0 * ry, [x, y + ry], [x + rx, y]);
        path.push(Segment::Close);
        return path;
    }
    let (cx, cy) = (zero("cx"), zero("cy"));
    let r = if name == "circle" {
        [get("r").unwrap(); 2]
    } else {
        [
            get("rx").or(get("ry")).unwrap(),
            get("ry").or(get("rx")).unwrap(),
        ]
    };
    let [rx, ry] = r;
    vec![
        Segment::Move([cx + rx, cy]),
        arc(r, [cx, cy + ry]),
        arc(r, [cx - rx, cy]),
        arc(r, [cx, cy - ry]),
        arc(r, [cx + rx, cy]),
        Segment::Close,
    ]
}

/// Checks that each arc became cubics within the tolerance and that all else is where it was.
pub(crate) fn same_curve(old: &[Segment], new: &[Segment], tolerance: f64) -> Check {
    let size = old
        .iter()
        .flat_map(points)
        .flatten()
        .fold(1e-9_f64, |m, x| m.max(x.abs()));
    let near =
        |a: P, b: P| (a[0] - b[0]).hypot(a[1] - b[1]) <= 1e-11 * size * (old.len() as f64 + 10.0);
    let mut new = new.iter().copied().peekable();
    let (mut at, mut start): (P, P) = ([0.0; 2], [0.0; 2]);
    for (index, segment) in old.iter().enumerate() {
        match *segment {
            Segment::Arc(r, rotation, large, sweep, end)
                if matches!(new.peek(), Some(Segment::Arc(r2, rotation2, large2, sweep2, end2))
                    if (r, rotation, large, sweep) == (*r2, *rotation2, *large2, *sweep2) && near(end, *end2)) =>
            {
                new.next();
            }
            Segment::Arc(.., end) if near(end, at) => continue,
            Segment::Arc([rx, ry], .., end) if rx == 0.0 || ry == 0.0 => match new.next() {
                Some(Segment::Line(other)) if near(end, other) => {}
                other => {
                    return Err(format!(
                        "segment {index}: an arc without a radius became {other:?}"
                    ));
                }
            },
            Segment::Arc(r, rotation, large, sweep, end) => {
                let arc = Center::new(at, r, rotation, large, sweep, end);
                let mut from = at;
                let mut turned = 0.0;
                while !(near(from, end) && turned > 0.0) {
                    let Some(Segment::Cubic(p1, p2, p3)) = new.next() else {
                        return Err(format!("segment {index}: the arc is not drawn to its end"));
                    };
                    turned += arc
                        .follow([from, p1, p2, p3], tolerance)
                        .map_err(|why| format!("segment {index}: {why}"))?;
                    from = p3;
                    if turned > arc.sweep.abs() + 0.01 {
                        return Err(format!("segment {index}: the arc turns too far"));
                    }
                }
                if (turned - arc.sweep.abs()).abs() > 1e-3 {
                    return Err(format!(
                        "segment {index}: it turns by {turned}, not by {}",
                        arc.sweep
                    ));
                }
            }
            other => {
                let drawn = new.next();
                let same = drawn.is_some_and(|drawn| {
                    core::mem::discriminant(&drawn) == core::mem::discriminant(&other)
                        && points(&drawn)
                            .iter()
                            .zip(points(&other))
                            .all(|(a, b)| near(*a, b))
                });
                if !same {
                    return Err(format!("segment {index}: {other:?} became {drawn:?}"));
                }
            }
        }
        match *segment {
            Segment::Move(p) => (at, start) = (p, p),
            Segment::Close => at = start,
            other => at = *points(&other).last().unwrap(),
        }
    }
    new.next()
        .map_or(Ok(()), |extra| Err(format!("{extra:?} came in")))
}

/// The largest coordinate of an outline, without its sign.
pub(crate) fn largest(outline: &[Segment]) -> f64 {
    let numbers = outline.iter().flat_map(points).flatten();
    numbers.fold(0.0, |largest, x| largest.max(x.abs()))
}

fn points(segment: &Segment) -> Vec<P> {
    match *segment {
        Segment::Move(p) | Segment::Line(p) | Segment::Arc(.., p) => vec![p],
        Segment::Quad(a, b) => vec![a, b],
        Segment::Cubic(a, b, c) => vec![a, b, c],
        Segment::Close => Vec::new(),
    }
}

/// An arc in centre form.
pub(crate) struct Center {
    center: P,
    pub(crate) radii: P,
    rotation: (f64, f64),
    start: f64,
    pub(crate) sweep: f64,
}

impl Center {
    /// How far a point is from its ellipse: the distance where that is the unit circle, times the larger radius.
    pub(crate) fn off(&self, p: P) -> f64 {
        let (d, (sin, cos)) = (
            [p[0] - self.center[0], p[1] - self.center[1]],
            self.rotation,
        );
        let x = (cos * d[0] + sin * d[1]) / self.radii[0];
        let y = (cos * d[1] - sin * d[0]) / self.radii[1];
        (x.hypot(y) - 1.0).abs() * self.radii[0].max(self.radii[1])
    }

    /// SVG 2, B.2.4 and B.2.5.
    pub(crate) fn new(from: P, r: P, rotation: f64, large: bool, positive: bool, to: P) -> Self {
        let (sin, cos) = rotation.to_radians().sin_cos();
        let d = [(from[0] - to[0]) / 2.0, (from[1] - to[1]) / 2.0];
        let (x1, y1) = (cos * d[0] + sin * d[1], -sin * d[0] + cos * d[1]);
        let [mut rx, mut ry] = r;
        let lambda = (x1 / rx).powi(2) + (y1 / ry).powi(2);
        if lambda > 1.0 {
            rx *= lambda.sqrt();
            ry *= lambda.sqrt();
        }
        let sign = if large == positive { -1.0 } else { 1.0 };
        let root = (((rx * ry).powi(2) - (rx * y1).powi(2) - (ry * x1).powi(2))
            / ((rx * y1).powi(2) + (ry * x1).powi(2)))
        .max(0.0)
        .sqrt();
        let (cx, cy) = (sign * root * rx * y1 / ry, -sign * root * ry * x1 / rx);
        let center = [
            cos * cx - sin * cy + f64::midpoint(from[0], to[0]),
            sin * cx + cos * cy + f64::midpoint(from[1], to[1]),
        ];
        let angle = |x: f64, y: f64| (y / ry).atan2(x / rx);
        let start = angle(x1 - cx, y1 - cy);
        let mut sweep = angle(-x1 - cx, -y1 - cy) - start;
        if positive && sweep < 0.0 {
            sweep += core::f64::consts::TAU;
        } else if !positive && sweep > 0.0 {
            sweep -= core::f64::consts::TAU;
        }
        Self {
            center,
            radii: [rx, ry],
            rotation: (sin, cos),
            start,
            sweep,
        }
    }

    /// The point at a part of the sweep.
    pub(crate) fn point(&self, part: f64) -> P {
        let (sin, cos) = self.rotation;
        let angle = self.start + part * self.sweep;
        let (x, y) = (self.radii[0] * angle.cos(), self.radii[1] * angle.sin());
        [
            self.center[0] + cos * x - sin * y,
            self.center[1] + sin * x + cos * y,
        ]
    }

    fn unit(&self, p: P) -> P {
        let (sin, cos) = self.rotation;
        let d = [p[0] - self.center[0], p[1] - self.center[1]];
        [
            (cos * d[0] + sin * d[1]) / self.radii[0],
            (cos * d[1] - sin * d[0]) / self.radii[1],
        ]
    }

    /// Follows a cubic along the arc: how far it turns in the arc's sense.
    fn follow(&self, [a, b, c, d]: [P; 4], tolerance: f64) -> Result<f64, String> {
        let mut before: Option<P> = None;
        let mut turned = 0.0;
        for i in 0..=32 {
            let t = f64::from(i) / 32.0;
            let s = 1.0 - t;
            let at = |k: usize| {
                s * s * s * a[k]
                    + 3.0 * s * s * t * b[k]
                    + 3.0 * s * t * t * c[k]
                    + t * t * t * d[k]
            };
            let u = self.unit([at(0), at(1)]);
            // The distance along the normal, to first order, as a part of the larger radius.
            let (length, [rx, ry]) = (u[0].hypot(u[1]), self.radii);
            let error = (length - 1.0).abs() * length / (u[0] / rx).hypot(u[1] / ry) / rx.max(ry);
            if error > tolerance {
                return Err(format!("at t = {t} it is {error:e} of the radius off"));
            }
            if let Some(v) = before {
                let step = (v[0] * u[1] - v[1] * u[0]).atan2(v[0] * u[0] + v[1] * u[1])
                    * self.sweep.signum();
                if step < -1e-6 {
                    return Err(format!("at t = {t} it runs backwards"));
                }
                turned += step;
            }
            before = Some(u);
        }
        Ok(turned)
    }
}

/// Renders a document at `size` pixels a side; `None` where resvg refuses it.
pub(crate) fn render(text: &str, size: u32) -> Option<Vec<u8>> {
    let tree = resvg::usvg::Tree::from_str(text, &resvg::usvg::Options::default()).ok()?;
    let mut pixels = resvg::tiny_skia::Pixmap::new(size, size)?;
    let own = tree.size();
    let scale = size as f32 / own.width().max(own.height());
    resvg::render(
        &tree,
        resvg::tiny_skia::Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    Some(pixels.take())
}

/// The largest difference of a channel between two renderings of `size` pixels a side, each pixel the mean of `block` by `block`
/// rendered ones.
pub(crate) fn difference(a: &[u8], b: &[u8], size: usize, block: usize) -> u8 {
    let mut largest = 0;
    for (x, y) in (0..size / block).flat_map(|y| (0..size / block).map(move |x| (x, y))) {
        let mut sums = [0_i32; 4];
        for row in y * block..(y + 1) * block {
            let start = 4 * (row * size + x * block);
            let (a, b) = (&a[start..start + 4 * block], &b[start..start + 4 * block]);
            if a == b {
                continue;
            }
            for (i, (a, b)) in a.iter().zip(b).enumerate() {
                sums[i % 4] += i32::from(*a) - i32::from(*b);
            }
        }
        let most = sums.iter().map(|sum| sum.unsigned_abs()).max().unwrap();
        largest = largest.max(most.div_ceil((block * block) as u32));
    }
    largest as u8
}
