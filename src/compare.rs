//! Methods compared on the full circle of radius 1, or an ellipse, by the number of segments; or on one segment by its angle.

use core::fmt;
use core::str::FromStr;

use crate::angle::Angle;
use crate::approximate::{Options, approximate};
use crate::curve::Curve;
use crate::error::{Error, Result, ShapeError, one_of};
use crate::joints::Cut;
use crate::joints::cutting::EqualPieces;
use crate::measure::extent;
use crate::measure::radial::{self, Profile};
use crate::method::{Rule, Span};
use crate::number::{Precision, text};
use crate::place::Placed;
use crate::radial_error::RadialError;
use crate::shape::{Arc, Ellipse, Outline, Shape};

/// What methods are compared by. All are relative to the true circle of radius 1, or ellipse of larger radius 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Criterion {
    /// The largest distance from the circle.
    #[default]
    Peak,
    /// The largest of |r² - 1|, r the distance from the centre, on an ellipse 1 and the distance: Apprich's E, Goldapp's criterion.
    Square,
    /// The mean distance over t.
    Mean,
    /// The root mean square of the distance over t.
    Rms,
    /// The error of the enclosed area over the true one.
    Area,
    /// The error of the arc length over the true one.
    Length,
}

impl Criterion {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Peak,
        Self::Square,
        Self::Mean,
        Self::Rms,
        Self::Area,
        Self::Length,
    ];

    /// The name by which it is asked for.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Peak => "peak",
            Self::Square => "square",
            Self::Mean => "mean",
            Self::Rms => "rms",
            Self::Area => "area",
            Self::Length => "length",
        }
    }

    /// What a title says.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Peak => "peak error",
            Self::Square => "peak of |r² − 1|",
            Self::Mean => "mean error",
            Self::Rms => "root mean square error",
            Self::Area => "error of the area",
            Self::Length => "error of the arc length",
        }
    }

    /// What an axis says, with the unit.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Peak => "peak error (radii)",
            Self::Square => "peak of |r² − 1| (square radii)",
            Self::Mean => "mean of |r − 1| over t (radii)",
            Self::Rms => "root mean square of r − 1 over t (radii)",
            Self::Area => "error of the area over the true area",
            Self::Length => "error of the arc length over the true length",
        }
    }

    /// The figure of a curve about a shape of larger radius 1.
    pub(crate) fn of(self, curve: &Curve, outline: &Outline) -> f64 {
        let (segments, truth) = (&curve.segments, &outline.truth);
        let count = segments.len() as f64;
        let turn = outline.unit.sweep.degrees().to_radians();
        // All segments of equal angles are one segment turned: measuring one of them would do, measuring all shows it.
        match self {
            Self::Peak => radial::error(segments, truth).peak(),
            Self::Square => square(radial::error(segments, truth)),
            Self::Mean => {
                segments
                    .iter()
                    .map(|s| Profile::new(s, truth).integral(|_, d| d))
                    .sum::<f64>()
                    / count
            }
            Self::Rms => {
                let square: f64 = segments
                    .iter()
                    .map(|s| Profile::new(s, truth).integral(|_, d| d * d))
                    .sum();
                (square / count).sqrt()
            }
            Self::Area => {
                let area: f64 = segments
                    .iter()
                    .map(|s| extent::sector_area(s, truth.center))
                    .sum();
                (area / (turn / 2.0 * truth.radii.x * truth.radii.y) - 1.0).abs()
            }
            Self::Length => {
                let length: f64 = segments.iter().map(extent::length).sum();
                (length / extent::ellipse_length(truth.radii, 0.0, turn) - 1.0).abs()
            }
        }
    }
}

/// The largest of |r² - 1| from those of r - 1.
pub(crate) fn square(error: RadialError) -> f64 {
    f64::max(
        error.outward * (2.0 + error.outward),
        error.inward * (2.0 - error.inward),
    )
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Criterion {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        one_of(&Self::ALL, name, ["the criterion", "the criteria"])
    }
}

/// Errors below this are the rounding of double precision.
pub const NOISE: f64 = 2e-15;

/// Methods by numbers of segments, or by the angle of one.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Comparison {
    /// The version of this form.
    pub version: u32,
    /// What is compared.
    pub by: Criterion,
    /// The smaller radius of the ellipse whose larger one is 1; without it, the circle.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub ellipse: Option<f64>,
    /// The numbers of segments of the full circle; none where spans are compared.
    #[cfg_attr(
        feature = "serde",
        serde(skip_serializing_if = "Vec::is_empty", default)
    )]
    pub counts: Vec<usize>,
    /// The angles of one segment in degrees; none where numbers of segments are compared.
    #[cfg_attr(
        feature = "serde",
        serde(skip_serializing_if = "Vec::is_empty", default)
    )]
    pub spans: Vec<f64>,
    /// A row for each method.
    #[cfg_attr(feature = "serde", serde(rename = "methods"))]
    pub rows: Vec<Row>,
}

/// One method.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Row {
    /// Its id.
    #[cfg_attr(feature = "serde", serde(rename = "method", serialize_with = "id"))]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub rule: Rule,
    /// Its figure at each number of segments, or each angle; `null` where it cannot draw that.
    pub values: Vec<Option<f64>>,
    /// The power of 1/segments, or of the angle, with which its figure falls, between the last two numbers of segments, or the two
    /// least angles, that have one above the rounding of double precision; `null` where there are not two.
    pub order: Option<f64>,
}

#[cfg(feature = "serde")]
fn id<S: serde::Serializer>(rule: &Rule, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(rule.id())
}

impl Comparison {
    /// Compares methods, or rules beyond the catalogue, on the circle or on the ellipse with the semi-axes 1 and `ellipse`.
    ///
    /// # Errors
    ///
    /// Where `ellipse` is no radius, a count is 0 or beyond [`crate::joints::MOST_SEGMENTS`], or no method can draw the circle with any of the counts.
    pub fn new(
        rules: &[Rule],
        counts: &[usize],
        by: Criterion,
        ellipse: Option<f64>,
    ) -> Result<Self> {
        let shape = Shape::Ellipse(Ellipse::new(
            (0.0, 0.0),
            (1.0, ellipse.unwrap_or(1.0)),
            Angle::ZERO,
        )?);
        let figure = |rule: Rule, &count: &usize| {
            let options = Options {
                rule,
                cut: Cut::Count(count),
                precision: Some(Precision::Full),
                ..Options::default()
            };
            let drawing = approximate(&shape, &options)?;
            Ok(drawing
                .outline
                .map_or(0.0, |outline| by.of(&drawing.curve, &outline)))
        };
        let sizes: Vec<f64> = counts.iter().map(|&n| n as f64).collect();
        Ok(Self {
            version: 1,
            by,
            ellipse,
            counts: counts.to_vec(),
            spans: Vec::new(),
            rows: rows(rules, counts, &sizes, figure)?,
        })
    }

    /// Compares methods by the angle of one segment in degrees, each a piece of a circle of radius 1 that need not close.
    ///
    /// # Errors
    ///
    /// Where an angle is not above 0 and at most 360.
    pub fn by_span(rules: &[Rule], spans: &[f64], by: Criterion) -> Result<Self> {
        if let Some(wrong) = spans.iter().find(|&&span| !(span > 0.0 && span <= 360.0)) {
            return Err(Error::Shape(ShapeError::Span(*wrong)));
        }
        let figure = |rule: Rule, &span: &f64| {
            let piece = rule.piece(&Span::from_degrees(span))?;
            let sweep = Angle::from_degrees(span);
            let arc = Arc::new((0.0, 0.0), (1.0, 1.0), Angle::ZERO, Angle::ZERO, sweep)?;
            let outline = arc.outline();
            let whole = EqualPieces::new(outline.unit, 1)?;
            let curve = Placed::new(&outline, &whole).curve([[piece; 2]], false);
            Ok(by.of(&curve, &outline))
        };
        // As many segments as there are of the angle in a turn.
        let sizes: Vec<f64> = spans.iter().map(|span| 360.0 / span).collect();
        Ok(Self {
            version: 1,
            by,
            ellipse: None,
            counts: Vec::new(),
            spans: spans.to_vec(),
            rows: rows(rules, spans, &sizes, figure)?,
        })
    }

    /// The name of each column and its number: of segments, or the angle in degrees.
    #[must_use]
    pub fn columns(&self) -> Vec<(String, f64)> {
        let counts = self.counts.iter().map(|&n| (format!("n={n}"), n as f64));
        let spans = self.spans.iter().map(|&a| (text(a) + "°", a));
        counts.chain(spans).collect()
    }
}

/// A row for each rule, with its figure in each column; a method that cannot do what a column asks has none there.
fn rows<C>(
    rules: &[Rule],
    columns: &[C],
    sizes: &[f64],
    figure: impl Fn(Rule, &C) -> Result<f64>,
) -> Result<Vec<Row>> {
    let value = |rule, column| match figure(rule, column) {
        Ok(figure) => Ok(Some(figure)),
        Err(Error::Impossible { .. }) => Ok(None),
        Err(other) => Err(other),
    };
    let row = |&rule: &Rule| {
        let values = columns.iter().map(|column| value(rule, column));
        let values = values.collect::<Result<Vec<_>>>()?;
        let order = order(sizes, &values);
        Ok(Row {
            rule,
            values,
            order,
        })
    };
    rules.iter().map(row).collect()
}

/// The order between the two largest sizes that have a figure above the noise.
fn order(sizes: &[f64], values: &[Option<f64>]) -> Option<f64> {
    let mut known: Vec<(f64, f64)> = sizes
        .iter()
        .zip(values)
        .filter_map(|(&n, value)| Some((n, value.filter(|&v| v > NOISE)?)))
        .collect();
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    known.dedup_by(|a, b| a.0 == b.0);
    match known.as_slice() {
        [.., (n, e), (m, f)] => Some(libm::log(e / f) / libm::log(m / n)),
        _ => None,
    }
}
