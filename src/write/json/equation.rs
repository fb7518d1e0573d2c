//! Lancaster's equation space of a segment, with as many digits as its points have.

use kurbo::Point;

use crate::number::decimal::Decimal;
use crate::number::{decimals_of, round};
use crate::power;

/// A number as it is written.
#[derive(Clone, Copy)]
pub(super) enum Term {
    /// A decimal whose digits are those of its nearest float.
    Decimal(Decimal),
    Float(f64),
}

impl Term {
    pub(super) fn value(self) -> f64 {
        match self {
            Self::Decimal(decimal) => decimal.value(),
            Self::Float(x) => x,
        }
    }
}

/// The power coefficients of one coordinate, and its derivatives at both ends.
pub(super) struct CoordinateEquation {
    pub(super) power: [Term; 4],
    pub(super) slopes: [Term; 2],
}

/// That of one coordinate of the control points.
#[inline]
pub(super) fn equation_of(
    points: &[Point],
    coordinate: impl Fn(&Point) -> f64,
) -> CoordinateEquation {
    let mut coordinates = [0.0; 4];
    let coordinates = &mut coordinates[..points.len()];
    for (own, point) in coordinates.iter_mut().zip(points) {
        *own = coordinate(point);
    }
    equation_in_units(coordinates).unwrap_or_else(|| equation(coordinates))
}

/// The equation of a cubic whose coordinates have few digits, in whole units of the last of them.
fn equation_in_units(coordinates: &[f64]) -> Option<CoordinateEquation> {
    /// Up to here no two decimals have one float.
    const MOST: i64 = 1_000_000_000_000_000;
    let &[a, b, c, d] = coordinates else {
        return None;
    };
    let mut decimals = 0;
    for &x in coordinates {
        decimals = Decimal::of_few_digits(x)?.decimals_written().max(decimals);
    }
    let units = |x| Decimal::nearest(x, decimals as u8).map(|own| own.units);
    let [a, b, c, d] = [units(a)?, units(b)?, units(c)?, units(d)?];
    let (first, last) = (3 * (b - a), 3 * (d - c));
    let power = [d - a - 3 * (c - b), 3 * (c - b) - first, first, a];
    let slopes = [first, last];
    let is_short = |units: &i64| units.abs() < MOST;
    let term = |units| Term::Decimal(Decimal { units, decimals });
    let all = power.iter().chain(&slopes).all(is_short);
    all.then(|| CoordinateEquation {
        power: power.map(term),
        slopes: slopes.map(term),
    })
}

/// The equation of any coordinates.
fn equation(coordinates: &[f64]) -> CoordinateEquation {
    /// With more decimals than this noise in the last digits is no concern.
    const MOST_DECIMALS: u8 = 12;
    // Whole multiples of decimals are decimals: no noise in the last digits.
    let decimals = coordinates.iter().try_fold(0, |most: u8, &x| {
        let decimals = (round(x, MOST_DECIMALS) == x).then(|| decimals_of(x));
        decimals
            .filter(|&own| own <= MOST_DECIMALS)
            .map(|own| most.max(own))
    });
    let tidy = |c| decimals.map_or(c, |decimals| round(c, decimals));
    let degree = coordinates.len().saturating_sub(1);
    let slope = |i: usize| tidy(degree as f64 * (coordinates[i + 1] - coordinates[i]));
    let slopes = if degree == 0 {
        [0.0; 2]
    } else {
        [slope(0), slope(degree - 1)]
    };
    CoordinateEquation {
        power: power::coefficients(coordinates).map(|c| Term::Float(tidy(c))),
        slopes: slopes.map(Term::Float),
    }
}
