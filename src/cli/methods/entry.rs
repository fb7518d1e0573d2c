//! What programs get of each method.

use curveto::approximate::{Options, approximate};
use curveto::curve::control_points;
use curveto::method::{Continuity, Degree, Ends, Span};
use curveto::write::number::{Precision, text};
use curveto::{Circle, Cut, Method, RadialError, Result, Shape};
use serde::Serialize;

/// The whole catalogue.
#[derive(Debug, Serialize)]
pub(super) struct Catalogue {
    pub(super) version: u32,
    pub(super) methods: Vec<Entry>,
}

/// A method, with its figures at a quarter of the unit circle.
#[derive(Debug, Serialize)]
pub(super) struct Entry {
    pub(super) id: &'static str,
    pub(super) aliases: &'static [&'static str],
    pub(super) title: &'static str,
    /// 2 or 3.
    pub(super) degree: u8,
    pub(super) ends: Ends,
    /// Whether it draws closed shapes: all do.
    pub(super) closed: bool,
    /// Whether it draws open arcs and uneven joints.
    pub(super) open: bool,
    pub(super) continuity: Joining,
    /// Nothing where the error follows no power of the angle.
    pub(super) order: Option<u8>,
    pub(super) leading_constant: Option<f64>,
    /// The same as a formula.
    pub(super) leading: &'static str,
    pub(super) quarter: Quarter,
    pub(super) largest_angle: f64,
    pub(super) criterion: &'static str,
    pub(super) origin: &'static str,
    pub(super) source: &'static str,
    pub(super) formula: &'static str,
    pub(super) advice: &'static str,
}

/// How segments join.
#[derive(Debug, Serialize)]
pub(super) struct Joining {
    pub(super) equal: Continuity,
    pub(super) uneven: Continuity,
}

/// The segment from (1, 0) to (0, 1), one of four of a circle.
#[derive(Debug, Serialize)]
pub(super) struct Quarter {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) handle: f64,
    pub(super) end_radius: f64,
    pub(super) error: ErrorEntry,
    /// How far the tangent turns at a joint, in degrees.
    pub(super) corner: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct ErrorEntry {
    pub(super) outward: f64,
    pub(super) inward: f64,
    pub(super) peak: f64,
}

impl From<RadialError> for ErrorEntry {
    fn from(error: RadialError) -> Self {
        Self {
            outward: error.outward,
            inward: error.inward,
            peak: error.peak(),
        }
    }
}

impl Entry {
    pub(super) fn new(method: Method) -> Result<Self> {
        let card = method.card();
        Ok(Self {
            id: card.id,
            aliases: card.aliases,
            title: card.title,
            degree: match card.degree {
                Degree::Quadratic => 2,
                Degree::Cubic => 3,
            },
            ends: card.ends,
            closed: true,
            open: card.ends == Ends::OnCircle,
            continuity: Joining {
                equal: card.continuity_equal,
                uneven: card.continuity_uneven,
            },
            order: (card.order > 0).then_some(card.order),
            leading_constant: (card.order > 0).then_some(card.leading_constant),
            leading: card.leading,
            quarter: Quarter::new(method)?,
            largest_angle: card.largest_angle,
            criterion: card.criterion,
            origin: card.origin,
            source: card.source,
            formula: card.formula,
            advice: card.advice,
        })
    }
}

impl Quarter {
    fn new(method: Method) -> Result<Self> {
        let options = Options {
            rule: method.into(),
            cut: Cut::Count(4),
            precision: Some(Precision::Full),
            ..Options::default()
        };
        let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0)?);
        let drawing = approximate(&circle, &options)?;
        let first = drawing.curve.segments.first().map(control_points);
        let span = Span::from_degrees(90.0);
        let piece = method.piece(&span)?;
        Ok(Self {
            points: first.iter().flatten().map(|p| [p.x, p.y]).collect(),
            handle: piece.handle_length(),
            end_radius: piece.end_radius,
            error: method.radial_error(&span)?.into(),
            corner: corner(method, &span)?,
        })
    }
}

/// How far the tangent turns at a joint of equal segments, in degrees; 0 where the joints are smooth.
pub(super) fn corner(method: Method, span: &Span) -> Result<f64> {
    let card = method.card();
    Ok(if card.continuity_equal == Continuity::G0 {
        // The piece before the joint leaves the circle's tangent as far to the other side.
        2.0 * method.piece(span)?.tangent_lift().abs()
    } else {
        0.0
    })
}

/// A line a method, after RFC 4180.
pub(super) fn csv(entries: &[Entry]) -> String {
    const HEADER: &str = "id,aliases,title,degree,ends,closed,open,continuity_equal,continuity_uneven,order,leading_constant,leading,\
        quarter_handle,quarter_end_radius,quarter_outward,quarter_inward,quarter_error,quarter_corner,\
        largest_angle,criterion,origin,source,formula,advice";
    let mut out = format!("{HEADER}\n");
    for entry in entries {
        out += &fields(entry).map(|field| quoted(&field)).join(",");
        out.push('\n');
    }
    out
}

fn fields(entry: &Entry) -> [String; 24] {
    let ends = match entry.ends {
        Ends::OnCircle => "on-circle",
        Ends::OffCircle => "off-circle",
    };
    let quarter = &entry.quarter;
    [
        entry.id.to_owned(),
        entry.aliases.join(" "),
        entry.title.to_owned(),
        entry.degree.to_string(),
        ends.to_owned(),
        entry.closed.to_string(),
        entry.open.to_string(),
        entry.continuity.equal.to_string(),
        entry.continuity.uneven.to_string(),
        entry.order.map_or_else(String::new, |o| o.to_string()),
        entry.leading_constant.map_or_else(String::new, text),
        entry.leading.to_owned(),
        text(quarter.handle),
        text(quarter.end_radius),
        text(quarter.error.outward),
        text(quarter.error.inward),
        text(quarter.error.peak),
        text(quarter.corner),
        text(entry.largest_angle),
        entry.criterion.to_owned(),
        entry.origin.to_owned(),
        entry.source.to_owned(),
        entry.formula.to_owned(),
        entry.advice.to_owned(),
    ]
}

/// A field of CSV, in quotes where it has to be.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
