//! What can be drawn along a curve, over the angle about the centre.

use core::fmt;
use core::str::FromStr;

use kurbo::{Affine, ParamCurve as _, PathSeg};

use super::bench::Bench;
use super::curvature;
use super::radial::Profile;
use super::reference::Reference;
use super::{largest_coordinate, unit_for};
use crate::curve::Curve;
use crate::error::{Error, Result, one_of};
use crate::numeric::functions::power;

/// A quantity along a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Quantity {
    /// The signed distance from the true shape, positive outside.
    #[default]
    Error,
    /// The curvature.
    Curvature,
    /// Its derivative by arc length.
    CurvatureD1,
    /// Its second derivative by arc length.
    CurvatureD2,
    /// How far the angle is ahead of one linear in t, in degrees.
    AngleLag,
    /// The curve itself with its control points: y over x.
    Drawing,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Error,
        Self::Curvature,
        Self::CurvatureD1,
        Self::CurvatureD2,
        Self::AngleLag,
        Self::Drawing,
    ];

    /// The name by which it is asked for.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Curvature => "curvature",
            Self::CurvatureD1 => "curvature-d1",
            Self::CurvatureD2 => "curvature-d2",
            Self::AngleLag => "angle-lag",
            Self::Drawing => "drawing",
        }
    }

    /// What an axis says, with the unit.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Error => "distance (user units, + outside)",
            Self::Curvature => "curvature κ (1/unit)",
            Self::CurvatureD1 => "κ′ = dκ/ds (1/unit²)",
            Self::CurvatureD2 => "κ″ = d²κ/ds² (1/unit³)",
            Self::AngleLag => "angle ahead of linear in t (degrees)",
            Self::Drawing => "y (user units)",
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Quantity {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        one_of(&Self::ALL, name, ["the quantity", "the quantities"])
    }
}

/// The parameter after so many of equal steps; 0 where there are none.
fn part(step: u32, steps: u32) -> f64 {
    f64::from(step) / f64::from(steps.max(1))
}

/// The points (x, y) of each segment at `steps` + 1 equal steps of t.
pub(crate) fn points(curve: &Curve, steps: u32) -> Vec<Vec<(f64, f64)>> {
    let at = |segment: &PathSeg, step| {
        let point = segment.eval(part(step, steps));
        (point.x, point.y)
    };
    let segments = curve.segments.iter();
    segments
        .map(|segment| (0..=steps).map(|step| at(segment, step)).collect())
        .collect()
}

/// The quantity along each segment, as (angle in degrees, value) at `steps` + 1 equal steps of t; a segment has fewer points
/// where the quantity is not defined, and the start alone at 0 steps. [`Quantity::Drawing`] has x in place of the angle.
#[must_use]
pub fn along(
    curve: &Curve,
    reference: &Reference,
    quantity: Quantity,
    steps: u32,
) -> Vec<Vec<(f64, f64)>> {
    if quantity == Quantity::Drawing {
        return points(curve, steps);
    }
    let unit = largest_coordinate(curve, reference).map_or(1.0, unit_for);
    let curve = curve.transformed(Affine::scale(1.0 / unit));
    let bench = Bench::new(&curve, &reference.scaled(1.0 / unit));
    let sense = bench.sense();
    bench
        .segments()
        .map(|(i, segment)| {
            let framed = bench.reference().framed(segment);
            let distance = Profile::new(segment, &bench.reference().truth);
            let value = |t: f64| match quantity {
                Quantity::Error => Some(distance.at(t) * unit),
                Quantity::AngleLag => {
                    Some((framed.lag(t) * sense * bench.reference().handedness()).to_degrees())
                }
                _ => curvature(segment, quantity, t, unit).map(|k| k * sense),
            };
            let angle = |t: f64| bench.angle(i) + framed.turned(t).to_degrees();
            profile(steps, angle, value)
        })
        .collect()
}

/// A value along a segment beside where it lies, at equal steps of t; left out where it is not finite.
pub(crate) fn profile(
    steps: u32,
    place: impl Fn(f64) -> f64,
    value: impl Fn(f64) -> Option<f64>,
) -> Vec<(f64, f64)> {
    let times = (0..=steps).map(|step| part(step, steps));
    let at = |t: f64| Some((place(t), value(t).filter(|v| v.is_finite())?));
    times.filter_map(at).collect()
}

/// The curvature at t or its derivative by arc length, of a segment in this unit; `None` of any other quantity.
pub(crate) fn curvature(segment: &PathSeg, quantity: Quantity, t: f64, unit: f64) -> Option<f64> {
    let k = curvature::at(segment, t)?;
    match quantity {
        Quantity::Curvature => Some(k.value / unit),
        Quantity::CurvatureD1 => Some(k.d1 / power(unit, 2)),
        Quantity::CurvatureD2 => Some(k.d2 / power(unit, 3)),
        Quantity::Error | Quantity::AngleLag | Quantity::Drawing => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Truth;
    use kurbo::{CubicBez, Point};

    /// About a quarter of the circle of radius 8 about the origin, and the same backwards.
    fn quarters() -> [PathSeg; 2] {
        let quarter = CubicBez::new((8.0, 0.0), (8.0, 4.3), (4.5, 8.0), (0.0, 8.0));
        [PathSeg::Cubic(quarter), PathSeg::Cubic(quarter).reverse()]
    }

    fn drawn(segment: PathSeg, quantity: Quantity) -> Vec<(f64, f64)> {
        let curve = Curve {
            segments: vec![segment],
            closed: false,
        };
        let reference = Reference::from(Truth::circle(Point::ORIGIN, 8.0));
        along(&curve, &reference, quantity, 10).concat()
    }

    #[test]
    fn what_is_drawn_is_what_is_measured() {
        for (segment, sense) in quarters().into_iter().zip([1.0, -1.0]) {
            let point = |t: f64| segment.eval(t).to_vec2();
            let turn = |t: f64| (point(t).atan2() - point(0.0).atan2()).to_degrees();
            let k = |t: f64| curvature::at(&segment, t).unwrap().map(|x, _| x * sense);
            let right = |quantity: Quantity, t: f64| match quantity {
                Quantity::Error => point(t).hypot() - 8.0,
                Quantity::Curvature => k(t).value,
                Quantity::CurvatureD1 => k(t).d1,
                Quantity::CurvatureD2 => k(t).d2,
                Quantity::AngleLag => sense * (turn(t) - t * turn(1.0)),
                Quantity::Drawing => point(t).y,
            };
            for quantity in Quantity::ALL {
                let drawn = drawn(segment, quantity);
                assert_eq!(drawn.len(), 11, "{quantity}");
                for (i, (x, value)) in drawn.into_iter().enumerate() {
                    let t = i as f64 / 10.0;
                    let at = if quantity == Quantity::Drawing {
                        point(t).x
                    } else {
                        point(t).atan2().to_degrees()
                    };
                    assert!((x - at).abs() < 1e-12, "{quantity} {t}: {x} {at}");
                    let right = right(quantity, t);
                    assert!(
                        (value - right).abs() < 1e-13,
                        "{quantity} {t}: {value} {right}"
                    );
                }
            }
        }
    }

    #[test]
    fn quantities_are_asked_for_by_their_names() {
        for quantity in Quantity::ALL {
            assert_eq!(quantity.to_string(), quantity.name());
            assert_eq!(quantity.name().parse::<Quantity>().unwrap(), quantity);
        }
        assert!("error ".parse::<Quantity>().is_err());
    }
}
