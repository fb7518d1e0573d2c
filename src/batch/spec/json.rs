//! A line of JSON.

use kurbo::Vec2;
use serde::Deserialize;
use serde_json::value::RawValue;

use super::{LineContent, Spec, arc, ellipse, point, polyline};
use crate::angle::Angle;
use crate::error::json::{column, in_plain_words};
use crate::error::{Error, Result};
use crate::joints::{Cut, Tolerance};
use crate::path::contours;
use crate::picture::figure::Look;
use crate::picture::paint::Paint;
use crate::shape::endpoint::{SvgArc, from_bulge, through};
use crate::shape::{Circle, Shape};

/// The keys of a line of JSON.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JsonLine<'a> {
    #[serde(borrow)]
    id: Option<&'a RawValue>,
    circle: Option<CircleKeys>,
    ellipse: Option<EllipseKeys>,
    arc: Option<ArcKeys>,
    svg_arc: Option<SvgArcKeys>,
    bulge: Option<BulgeKeys>,
    through: Option<[[f64; 2]; 3]>,
    polyline: Option<PolylineKeys>,
    #[serde(borrow)]
    path: Option<std::borrow::Cow<'a, str>>,
    #[serde(borrow)]
    method: Option<std::borrow::Cow<'a, str>>,
    segments: Option<usize>,
    #[serde(borrow)]
    stroke: Option<std::borrow::Cow<'a, str>>,
    #[serde(borrow)]
    fill: Option<std::borrow::Cow<'a, str>>,
    stroke_width: Option<f64>,
    tolerance: Option<ToleranceValue<'a>>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum ToleranceValue<'a> {
    Number(f64),
    #[serde(borrow)]
    Text(std::borrow::Cow<'a, str>),
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"center": [0,0], "radius": 50}"#
)]
struct CircleKeys {
    #[serde(default)]
    center: [f64; 2],
    radius: f64,
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"center": [0,0], "radii": [30,20]}"#
)]
struct EllipseKeys {
    #[serde(default)]
    center: [f64; 2],
    radii: [f64; 2],
    #[serde(default)]
    rotation: f64,
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"radius": 50, "start": 0, "sweep": 90}"#
)]
struct ArcKeys {
    #[serde(default)]
    center: [f64; 2],
    radius: Option<f64>,
    radii: Option<[f64; 2]>,
    #[serde(default)]
    rotation: f64,
    #[serde(default)]
    start: f64,
    sweep: f64,
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"from": [0,0], "radii": [25,25], "large_arc": false, "sweep": true, "to": [50,0]}"#
)]
struct SvgArcKeys {
    from: [f64; 2],
    radii: [f64; 2],
    #[serde(default)]
    rotation: f64,
    large_arc: bool,
    sweep: bool,
    to: [f64; 2],
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"from": [0,0], "to": [10,0], "bulge": 1}"#
)]
struct BulgeKeys {
    from: [f64; 2],
    to: [f64; 2],
    bulge: f64,
}

#[derive(Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = r#"an object such as {"vertices": [[0,0,1], [10,0,0]]}"#
)]
struct PolylineKeys {
    /// [x, y, bulge to the next].
    vertices: Vec<[f64; 3]>,
    #[serde(default)]
    closed: bool,
}

impl JsonLine<'_> {
    /// How many subjects the line names.
    fn subjects(&self) -> usize {
        [
            self.circle.is_some(),
            self.ellipse.is_some(),
            self.arc.is_some(),
            self.svg_arc.is_some(),
            self.bulge.is_some(),
            self.through.is_some(),
            self.polyline.is_some(),
            self.path.is_some(),
        ]
        .into_iter()
        .map(usize::from)
        .sum()
    }

    /// What is to be drawn; `None` where nothing is named.
    fn subject(&self, syntax: impl Fn(usize, String) -> Error) -> Result<Option<LineContent>> {
        let shape = if let Some(c) = &self.circle {
            Shape::Circle(Circle::new(point(c.center), c.radius)?)
        } else if let Some(e) = &self.ellipse {
            ellipse(e.center, e.radii, e.rotation)?
        } else if let Some(a) = &self.arc {
            let radii = match (a.radius, a.radii) {
                (Some(radius), None) => [radius, radius],
                (None, Some(radii)) => radii,
                _ => return Err(syntax(1, "an arc has a radius or radii".to_owned())),
            };
            arc(a.center, radii, a.rotation, a.start, a.sweep)?
        } else if let Some(s) = &self.svg_arc {
            SvgArc {
                from: point(s.from),
                radii: Vec2::new(s.radii[0], s.radii[1]),
                rotation: Angle::from_degrees(s.rotation),
                large_arc: s.large_arc,
                sweep: s.sweep,
                to: point(s.to),
            }
            .shape()?
        } else if let Some(b) = &self.bulge {
            from_bulge(point(b.from), point(b.to), b.bulge)?
        } else if let Some([from, on, to]) = self.through {
            through(point(from), point(on), point(to))?
        } else if let Some(p) = &self.polyline {
            return Ok(Some(LineContent::Path(polyline(&p.vertices, p.closed)?)));
        } else if let Some(data) = &self.path {
            return Ok(Some(LineContent::Path(contours(data)?)));
        } else {
            return Ok(None);
        };
        Ok(Some(LineContent::Shape(shape)))
    }
}

pub(super) fn from_json(line: &str) -> Result<Spec<'_>> {
    let line = line.trim();
    let syntax = |column: usize, why: String| Error::Syntax {
        what: "the shape",
        text: line.to_owned(),
        column,
        why,
    };
    let keys: JsonLine<'_> = serde_json::from_str(line)
        .map_err(|error| syntax(column(line, &error), in_plain_words(&error)))?;
    let (1, Some(subject)) = (keys.subjects(), keys.subject(syntax)?) else {
        let why =
            "one of circle, ellipse, arc, svg_arc, bulge, through, polyline and path is expected";
        return Err(syntax(1, why.to_owned()));
    };
    let cut = match (keys.segments, keys.tolerance) {
        (None, None) => None,
        (Some(count), None) => Some(Cut::Count(count)),
        (None, Some(ToleranceValue::Number(distance))) => {
            Some(Cut::Tolerance(Tolerance::Absolute(distance)))
        }
        (None, Some(ToleranceValue::Text(text))) => Some(Cut::Tolerance(text.parse()?)),
        _ => {
            return Err(syntax(
                1,
                "segments and tolerance exclude each other".to_owned(),
            ));
        }
    };
    let paint = |text: &Option<std::borrow::Cow<'_, str>>| {
        let paint = text.as_ref().map(|text| text.parse::<Paint>());
        paint.transpose()
    };
    let look = Look {
        stroke: paint(&keys.stroke)?,
        fill: paint(&keys.fill)?,
        stroke_width: keys.stroke_width,
    };
    if let Some(width) = look
        .stroke_width
        .filter(|&width| !(0.0..1e150).contains(&width))
    {
        let why = format!("a stroke_width is a number of at least 0, not {width}");
        return Err(syntax(1, why));
    }
    Ok(Spec {
        look,
        subject,
        id: keys.id.map(RawValue::get),
        method: keys.method.map(|name| name.parse()).transpose()?,
        cut,
    })
}
