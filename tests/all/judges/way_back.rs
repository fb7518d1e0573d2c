//! A judge of the way back that shares no code with it: both documents are read by roxmltree and svgtypes, every outline becomes a
//! chain of points by the formulas of the SVG specification, and the chains are held against each other, both ways.

use resvg::usvg::roxmltree::Node;

use super::independent::{Center, GEOMETRY, P, Segment, equivalent_path, length, parse, segments};

/// How many points stand for a segment.
const POINTS: usize = 96;

/// How many chords around the last nearest one are looked at first.
const WINDOW: usize = 40;

/// The outline of an element, smooth commands spelled out; `None` where it draws none.
pub(crate) fn outline(node: Node<'_, '_>) -> Option<Vec<Segment>> {
    let name = node.tag_name().name();
    let value =
        |name: &str| length(node.attribute(name)).filter(|x| *x >= 0.0 || !name.starts_with('r'));
    match name {
        "path" => Some(segments(node.attribute("d").unwrap_or_default())),
        "rect" if value("rx").or(value("ry")).is_none_or(|r| r == 0.0) => None,
        "circle" | "ellipse" | "rect" => Some(equivalent_path(name, value)),
        _ => None,
    }
}

/// The subpaths of an outline as chains of points.
pub(crate) fn chains(outline: &[Segment]) -> Vec<Vec<P>> {
    let mut chains: Vec<Vec<P>> = Vec::new();
    let (mut at, mut start): (P, P) = ([0.0; 2], [0.0; 2]);
    let part = |i: usize| i as f64 / POINTS as f64;
    for segment in outline {
        if let Segment::Move(p) = *segment {
            (at, start) = (p, p);
            chains.push(vec![p]);
            continue;
        }
        let blend = |points: &[P], t: f64| {
            let mut points = points.to_vec();
            while points.len() > 1 {
                points = points
                    .windows(2)
                    .map(|pair| [0, 1].map(|k| pair[0][k] + t * (pair[1][k] - pair[0][k])))
                    .collect();
            }
            points[0]
        };
        let (to, points): (P, Vec<P>) = match *segment {
            Segment::Line(p) | Segment::Move(p) => (p, vec![p]),
            Segment::Close => (start, vec![start]),
            Segment::Quad(a, b) => (
                b,
                (1..=POINTS).map(|i| blend(&[at, a, b], part(i))).collect(),
            ),
            Segment::Cubic(a, b, c) => (
                c,
                (1..=POINTS)
                    .map(|i| blend(&[at, a, b, c], part(i)))
                    .collect(),
            ),
            Segment::Arc([rx, ry], .., end) if rx == 0.0 || ry == 0.0 || end == at => {
                (end, vec![end])
            }
            Segment::Arc(r, rotation, large, sweep, end) => {
                let arc = Center::new(at, r, rotation, large, sweep, end);
                // An arc may take the place of many cubics.
                let count = 3 * POINTS;
                let on = |i: usize| arc.point(i as f64 / count as f64);
                (end, (1..=count).map(on).chain([end]).collect())
            }
        };
        if chains.is_empty() || matches!(segment, Segment::Close) && to == at {
            at = to;
            continue;
        }
        chains.last_mut().unwrap().extend(points);
        at = to;
    }
    chains
}

fn from_chord(p: P, [a, b]: [P; 2]) -> f64 {
    let (u, v) = ([p[0] - a[0], p[1] - a[1]], [b[0] - a[0], b[1] - a[1]]);
    let square = v[0] * v[0] + v[1] * v[1];
    let t = if square > 0.0 {
        ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (u[0] - t * v[0]).hypot(u[1] - t * v[1])
}

/// The largest distance of the points of one chain from another chain.
fn one_way(a: &[P], b: &[P]) -> f64 {
    let (mut farthest, mut near) = (0.0_f64, 0_usize);
    for &p in a {
        let nearest = |range: core::ops::Range<usize>| {
            range
                .map(|i| (from_chord(p, [b[i], b[i + 1]]), i))
                .min_by(|x, y| x.0.total_cmp(&y.0))
        };
        let last = b.len().saturating_sub(1);
        let window = near.saturating_sub(WINDOW)..(near + WINDOW).min(last);
        let mut found = nearest(window).unwrap_or((f64::INFINITY, 0));
        if found.0 > farthest {
            found = nearest(0..last).unwrap_or(((p[0] - b[0][0]).hypot(p[1] - b[0][1]), 0));
        }
        farthest = farthest.max(found.0);
        near = found.1;
    }
    farthest
}

/// The largest distance, both ways, of two outlines, subpath by subpath; none may be lost.
pub(crate) fn apart(a: &[Segment], b: &[Segment]) -> Result<f64, String> {
    let (a, b) = (chains(a), chains(b));
    if a.len() != b.len() {
        return Err(format!("{} subpaths became {}", a.len(), b.len()));
    }
    let pairs = a.iter().zip(&b).filter(|(a, b)| a != b);
    Ok(pairs
        .map(|(a, b)| one_way(a, b).max(one_way(b, a)))
        .fold(0.0, f64::max))
}

/// The outline of an element before and after.
type Pair = (Vec<Segment>, Vec<Segment>);

/// The outlines of both documents, element by element, where they draw one: every element is still there.
pub(crate) fn outlines(before: &str, after: &str) -> Result<Vec<Pair>, String> {
    let (old, new) = (parse(before)?, parse(after)?);
    if old.descendants().count() != new.descendants().count() {
        return Err("an element is lost".to_owned());
    }
    let pairs = old.descendants().zip(new.descendants());
    Ok(pairs
        .filter_map(|(a, b)| Some((outline(a)?, outline(b)?)))
        .collect())
}

/// The document without the path data, the geometry and the names of shapes: what no conversion may touch.
pub(crate) fn skeleton(text: &str) -> Result<String, String> {
    let document = parse(text)?;
    let mut cuts = Vec::new();
    for node in document.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        let geometry: &[&str] = match GEOMETRY.iter().find(|(known, _)| *known == name) {
            Some((_, names)) => names,
            None if name == "path" => &["d"],
            None => continue,
        };
        let range = node.range();
        for tag in [
            range.start,
            range.start + text[range.clone()].rfind('<').unwrap(),
        ] {
            let start = tag + text[tag..].find(name).unwrap();
            cuts.push(start..start + name.len());
        }
        for attribute in node.attributes() {
            if attribute.namespace().is_none() && geometry.contains(&attribute.name()) {
                let range = attribute.range();
                cuts.push(text[..range.start].trim_end().len()..range.end);
            }
        }
    }
    cuts.sort_by_key(|cut| cut.start);
    cuts.dedup();
    let (mut out, mut at) = (String::new(), 0);
    for cut in cuts {
        out.push_str(&text[at..cut.start]);
        at = cut.end;
    }
    Ok(out + &text[at..])
}
