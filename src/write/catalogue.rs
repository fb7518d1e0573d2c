//! The catalogue of methods as JSON and CSV.

use serde::Serialize;

use crate::approximate::{Options, approximate};
use crate::continuity::Continuity;
use crate::curve::control_points;
use crate::method::{Degree, Ends, Method, Span};
use crate::number::{Precision, text};
use crate::write::csv;
use crate::{Circle, Cut, RadialError, Result, Shape};

/// The whole catalogue.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CatalogueDocument {
    /// The version of this form.
    pub version: u32,
    /// Its methods.
    pub methods: Vec<MethodDocument>,
}

/// A method, with its figures at a quarter of the unit circle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MethodDocument {
    /// The name that `-m` takes.
    pub id: &'static str,
    /// Other names that `-m` takes.
    pub aliases: &'static [&'static str],
    /// What it does, in a few words.
    pub title: &'static str,
    /// 2 or 3.
    pub degree: u8,
    /// Where the ends of each piece lie.
    pub ends: Ends,
    /// Whether it draws closed shapes: all do.
    pub closed: bool,
    /// Whether it draws open arcs and uneven joints.
    pub open: bool,
    /// How segments join.
    pub continuity: JoiningDocument,
    /// The power of the angle with which the error falls; nothing where it follows none.
    pub order: Option<u8>,
    /// The factor before that power, the angle in radians and the radius 1.
    pub leading_constant: Option<f64>,
    /// The same as a formula.
    pub leading: &'static str,
    /// Its figures at a quarter.
    pub quarter: QuarterDocument,
    /// The largest angle of a segment, in degrees.
    pub largest_angle: f64,
    /// What singles it out.
    pub criterion: &'static str,
    /// Where it comes from, in two or three words.
    pub origin: &'static str,
    /// Where it comes from: author, title, year; "derived" where it was built from its criterion alone.
    pub source: &'static str,
    /// How its control points are found, in the notation of docs/methods.md.
    pub formula: &'static str,
    /// When to use it.
    pub advice: &'static str,
}

/// How segments join.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JoiningDocument {
    /// Where all have the same angle.
    pub equal: Continuity,
    /// Where they have not.
    pub uneven: Continuity,
}

/// The segment from (1, 0) to (0, 1), one of four of a circle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct QuarterDocument {
    /// Its control points.
    pub points: Vec<[f64; 2]>,
    /// The length of its handles.
    pub handle: f64,
    /// The distance of its ends from the centre.
    pub end_radius: f64,
    /// Its error.
    pub error: QuarterErrorDocument,
    /// How far the tangent turns at a joint, in degrees.
    pub corner: f64,
}

/// The largest distances from the unit circle, both at least 0.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct QuarterErrorDocument {
    /// Outside the circle.
    pub outward: f64,
    /// Inside the circle.
    pub inward: f64,
    /// The larger of the two.
    pub peak: f64,
}

impl From<RadialError> for QuarterErrorDocument {
    fn from(error: RadialError) -> Self {
        Self {
            outward: error.outward,
            inward: error.inward,
            peak: error.peak(),
        }
    }
}

impl MethodDocument {
    /// What there is to tell of a method.
    ///
    /// # Errors
    ///
    /// Where the method cannot draw a quarter of a circle; all can.
    pub fn new(method: Method) -> Result<Self> {
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
            continuity: JoiningDocument {
                equal: card.continuity_equal,
                uneven: card.continuity_uneven,
            },
            order: card.law.map(|law| law.order),
            leading_constant: card.law.map(|law| law.constant),
            leading: card.leading,
            quarter: QuarterDocument::new(method)?,
            largest_angle: card.largest_angle,
            criterion: card.criterion,
            origin: card.origin,
            source: card.source,
            formula: card.formula,
            advice: card.advice,
        })
    }
}

impl QuarterDocument {
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
///
/// # Errors
///
/// Where the method refuses the angle.
pub fn corner(method: Method, span: &Span) -> Result<f64> {
    let card = method.card();
    Ok(if card.continuity_equal == Continuity::G0 {
        // The piece before the joint leaves the circle's tangent as far to the other side.
        2.0 * method.piece(span)?.tangent_lift().abs()
    } else {
        0.0
    })
}

/// A line a method, after RFC 4180.
#[must_use]
pub fn csv(entries: &[MethodDocument]) -> String {
    const HEADER: &str = "id,aliases,title,degree,ends,closed,open,continuity_equal,continuity_uneven,order,leading_constant,leading,\
        quarter_handle,quarter_end_radius,quarter_outward,quarter_inward,quarter_error,quarter_corner,\
        largest_angle,criterion,origin,source,formula,advice";
    csv::lines(HEADER, entries.iter().map(fields))
}

fn fields(entry: &MethodDocument) -> [String; 24] {
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
