//! Methods compared on the full circle of radius 1, or an ellipse, by the number of segments.

use core::f64::consts::{PI, TAU};
use core::fmt;
use core::str::FromStr;

use crate::angle::Angle;
use crate::approximate::{Drawing, Options, approximate};
use crate::error::{Error, Result};
use crate::joints::Cut;
use crate::measure::extent;
use crate::measure::radial::{self, Profile};
use crate::method::Rule;
use crate::number::Precision;
use crate::shape::{Ellipse, Shape, Truth};

/// What methods are compared by. All are relative to the true circle of radius 1, or ellipse of larger radius 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Criterion {
    /// The largest distance from the circle.
    #[default]
    Peak,
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
    pub const ALL: [Self; 5] = [Self::Peak, Self::Mean, Self::Rms, Self::Area, Self::Length];

    /// The name by which it is asked for.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Peak => "peak",
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
            Self::Mean => "mean of |r − 1| over t (radii)",
            Self::Rms => "root mean square of r − 1 over t (radii)",
            Self::Area => "error of the area over the true area",
            Self::Length => "error of the arc length over the true length",
        }
    }

    /// The figure of a drawing.
    fn of(self, drawing: &Drawing, truth: &Truth) -> f64 {
        let segments = &drawing.curve.segments;
        let count = segments.len() as f64;
        // All segments of equal angles are one segment turned: measuring one of them would do, measuring all shows it.
        match self {
            Self::Peak => radial::error(segments, truth).peak(),
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
                (area / (PI * truth.radii.x * truth.radii.y) - 1.0).abs()
            }
            Self::Length => {
                let length: f64 = segments.iter().map(extent::length).sum();
                (length / extent::ellipse_length(truth.radii, 0.0, TAU) - 1.0).abs()
            }
        }
    }
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Criterion {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|c| c.name() == name)
            .ok_or_else(|| Error::Syntax {
                what: "the criterion",
                text: name.to_owned(),
                column: 1,
                why: format!("the criteria are {}", Self::ALL.map(Self::name).join(", ")),
            })
    }
}

/// Errors below this are the rounding of double precision.
pub const NOISE: f64 = 2e-15;

/// Methods by numbers of segments.
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
    /// The numbers of segments of the full circle.
    pub counts: Vec<usize>,
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
    /// Its figure at each number of segments; `null` where it cannot draw the circle with so many.
    pub values: Vec<Option<f64>>,
    /// The power of 1/segments with which its figure falls, between the last two numbers of segments that have one above the
    /// rounding of double precision; `null` where there are not two.
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
        let figure = |rule: Rule, count: usize| {
            let options = Options {
                rule,
                cut: Cut::Count(count),
                precision: Some(Precision::Full),
                ..Options::default()
            };
            match approximate(&shape, &options) {
                Ok(drawing) => Ok(drawing
                    .outline
                    .map(|outline| by.of(&drawing, &outline.truth))),
                Err(Error::Impossible { .. }) => Ok(None),
                Err(other) => Err(other),
            }
        };
        let row = |&rule: &Rule| {
            let values: Vec<Option<f64>> = counts
                .iter()
                .map(|&count| figure(rule, count))
                .collect::<Result<_>>()?;
            let order = order(counts, &values);
            Ok(Row {
                rule,
                values,
                order,
            })
        };
        Ok(Self {
            version: 1,
            by,
            ellipse,
            counts: counts.to_vec(),
            rows: rules.iter().map(row).collect::<Result<_>>()?,
        })
    }
}

/// The order between the last two counts that have a figure above the noise.
fn order(counts: &[usize], values: &[Option<f64>]) -> Option<f64> {
    let mut known: Vec<(f64, f64)> = counts
        .iter()
        .zip(values)
        .filter_map(|(&n, value)| Some((n as f64, value.filter(|&v| v > NOISE)?)))
        .collect();
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    known.dedup_by(|a, b| a.0 == b.0);
    match known.as_slice() {
        [.., (n, e), (m, f)] => Some(libm::log(e / f) / libm::log(m / n)),
        _ => None,
    }
}
