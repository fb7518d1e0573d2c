//! The deviation of a curve from its true shape, drawn many times as large.
//!
//! With q the point of the true shape nearest to the point p of the curve, n the outward normal there and d = (p - q)·n, the
//! magnified curve is q + K d n: the true shape for K = 0, the curve itself for K = 1.

use kurbo::{CubicBez, PathSeg, Point};

use crate::curve::Curve;
use crate::measure::radial::{distance, nearest, visit_extremes};
use crate::numeric::root;
use crate::power::Equation;
use crate::shape::Truth;

/// How many cubics draw the magnified curve between two neighbours among its zeros and extremes.
const PIECES: u32 = 6;

/// The regions between the true shape and the magnified curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Regions {
    /// Where the curve is outside the true shape.
    pub(super) outward: Vec<Curve>,
    /// Where it is inside.
    pub(super) inward: Vec<Curve>,
}

impl Regions {
    /// Adds the regions of segments, their deviation drawn `factor` times as large.
    pub(super) fn add(&mut self, segments: &[PathSeg], truth: &Truth, factor: f64) {
        for segment in segments {
            let equation = Equation::from(segment);
            let magnified = |factor| Magnified {
                equation,
                truth,
                factor,
            };
            for (stations, outside) in between_zeros(segment, truth) {
                let mut region = magnified(factor).through(&stations);
                let back = magnified(0.0).through(&stations);
                region.extend(back.iter().rev().map(PathSeg::reverse));
                let lobes = if outside {
                    &mut self.outward
                } else {
                    &mut self.inward
                };
                lobes.push(Curve {
                    segments: region,
                    closed: true,
                });
            }
        }
    }
}

/// The parameters of a segment's zeros and extremes, from zero to zero (or end), and whether the curve is outside there.
fn between_zeros(segment: &PathSeg, truth: &Truth) -> Vec<(Vec<f64>, bool)> {
    let equation = Equation::from(segment);
    let mut extremes = Vec::new();
    visit_extremes(segment, truth, |t, distance| extremes.push((t, distance)));
    let mut runs = Vec::new();
    let mut run: Vec<f64> = Vec::new();
    let mut outside = None;
    for (t, d) in extremes {
        if let (Some(&before), Some(side)) = (run.last(), outside)
            && d != 0.0
            && (d > 0.0) != side
        {
            let zero = root(|t| distance(truth, equation.point(t)), before, t);
            run.push(zero);
            runs.push((core::mem::replace(&mut run, vec![zero]), side));
            outside = None;
        }
        run.push(t);
        if d != 0.0 {
            outside = outside.or(Some(d > 0.0));
        }
    }
    runs.extend(outside.map(|side| (run, side)));
    runs
}

/// A segment, its deviation drawn `factor` times as large.
struct Magnified<'a> {
    equation: Equation,
    truth: &'a Truth,
    factor: f64,
}

impl Magnified<'_> {
    fn point(&self, t: f64) -> Point {
        let p = self.equation.point(t);
        let nearest = nearest(self.truth, p);
        p + nearest.outward * ((self.factor - 1.0) * nearest.distance)
    }

    /// Cubics that meet the magnified curve, and its tangents, at and between these parameters.
    fn through(&self, stations: &[f64]) -> Vec<PathSeg> {
        let mut cubics = Vec::new();
        for pair in stations.windows(2).filter(|pair| pair[1] > pair[0]) {
            let step = (pair[1] - pair[0]) / f64::from(PIECES);
            let knot = |i| {
                let t = if i == PIECES {
                    pair[1]
                } else {
                    pair[0] + f64::from(i) * step
                };
                // Over half a step: short enough for the tangent, and long enough not to magnify rounding noise.
                let half_step = self.point(t + 0.25 * step) - self.point(t - 0.25 * step);
                (self.point(t), half_step * (2.0 / 3.0))
            };
            let mut from = knot(0);
            for i in 1..=PIECES {
                let to = knot(i);
                let cubic = CubicBez::new(from.0, from.0 + from.1, to.0 - to.1, to.0);
                cubics.push(PathSeg::Cubic(cubic));
                from = to;
            }
        }
        cubics
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{ParamCurve, Shape as _};

    use super::*;
    use crate::number::Precision;
    use crate::{Circle, Drawing, Method, Options, Rule, Shape, approximate};

    fn circle(method: Method) -> Drawing {
        let shape = Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap());
        let options = Options {
            rule: Rule::Method(method),
            precision: Some(Precision::Full),
            ..Options::default()
        };
        approximate(&shape, &options).unwrap()
    }

    fn lobes(method: Method, factor: f64) -> Regions {
        let drawing = circle(method);
        let mut lobes = Regions::default();
        lobes.add(
            &drawing.curve.segments,
            &drawing.outline.unwrap().truth,
            factor,
        );
        lobes
    }

    #[test]
    fn minimax_has_two_lobes_outside_and_one_inside_a_quarter() {
        let lobes = lobes(Method::Minimax, 500.0);
        assert_eq!((lobes.outward.len(), lobes.inward.len()), (8, 4));
    }

    #[test]
    fn midpoint_is_outside_everywhere() {
        let lobes = lobes(Method::Midpoint, 500.0);
        assert!(!lobes.outward.is_empty());
        assert!(lobes.inward.iter().all(|lobe| {
            let bounds = lobe.bounding_box().unwrap();
            bounds.area() < 1e-9
        }));
    }

    #[test]
    fn every_point_of_a_lobe_is_finite() {
        let ellipse = crate::Ellipse::new((0.0, 0.0), (30.0, 10.0), crate::Angle::ZERO).unwrap();
        let drawing = approximate(&Shape::Ellipse(ellipse), &Options::default()).unwrap();
        let mut lobes = Regions::default();
        lobes.add(
            &drawing.curve.segments,
            &drawing.outline.unwrap().truth,
            100.0,
        );
        assert!(!lobes.outward.is_empty());
        for segment in lobes
            .outward
            .iter()
            .chain(&lobes.inward)
            .flat_map(|lobe| &lobe.segments)
        {
            assert!(segment.is_finite(), "{segment:?}");
        }
    }

    #[test]
    fn lobes_reach_as_far_as_the_magnified_error() {
        let drawing = circle(Method::Minimax);
        let factor = 500.0;
        let farthest = lobes(Method::Minimax, factor)
            .outward
            .iter()
            .flat_map(|lobe| &lobe.segments)
            .map(|segment| segment.end().to_vec2().hypot() - 1.0)
            .fold(0.0, f64::max);
        let expected = factor * drawing.error.outward;
        assert!(
            (farthest - expected).abs() < 1e-9,
            "{farthest} against {expected}"
        );
    }

    #[test]
    fn the_lobes_of_factor_one_are_the_slivers_between_curve_and_circle() {
        // Area of the curve minus area of the circle = what is outside minus what is inside.
        let drawing = circle(Method::Minimax);
        let area = |curves: &[Curve]| -> f64 {
            let path =
                |curve: &Curve| kurbo::BezPath::from_path_segments(curve.segments.iter().copied());
            curves.iter().map(|curve| path(curve).area().abs()).sum()
        };
        let lobes = lobes(Method::Minimax, 1.0);
        let difference = area(&[drawing.curve]) - core::f64::consts::PI;
        let slivers = area(&lobes.outward) - area(&lobes.inward);
        assert!(
            (slivers - difference).abs() < 1e-3 * difference,
            "{slivers} against {difference}"
        );
    }
}
