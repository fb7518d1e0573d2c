//! Curvature and its first two derivatives by arc length.
//!
//! With n = p' × p'' and w = p' · p', both polynomials in t,
//!
//! ```text
//! κ   = n w^(-3/2)
//! κ'  = (n' w - (3/2) n w') / w³
//! κ'' = (n'' w² - (7/2) n' w w' - (3/2) n w w'' + (9/2) n w'²) / w^(9/2)
//! ```
//!
//! where κ' and κ'' are by arc length and the others by t (derived from κ by d/ds = w^(-1/2) d/dt). The extremes of κ are the
//! roots of n' w - (3/2) n w', a polynomial of degree 6 in the form in which it is used here.

use kurbo::{PathSeg, Point, Vec2};

use crate::curve::control_points;
use crate::numeric::bernstein::Polynomial;

/// The curvature at a point and its derivatives by arc length, per unit of length, of its square and of its cube.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Curvature {
    /// The curvature, 1/radius.
    pub value: f64,
    /// Its derivative by arc length.
    pub d1: f64,
    /// Its second derivative by arc length.
    pub d2: f64,
}

impl Curvature {
    /// The three as an array.
    #[must_use]
    pub const fn to_array(self) -> [f64; 3] {
        [self.value, self.d1, self.d2]
    }

    pub(crate) fn map(self, f: impl Fn(f64, i32) -> f64) -> Self {
        Self {
            value: f(self.value, 1),
            d1: f(self.d1, 2),
            d2: f(self.d2, 3),
        }
    }
}

/// The curvature at t, positive where the curve turns from +x towards +y; `None` where the curve stands still there, so that it
/// has no curvature, and where the figures leave the range of `f64`.
#[must_use]
pub fn at(segment: &PathSeg, t: f64) -> Option<Curvature> {
    let [p1, p2, p3] = derivatives(&control_points(segment), t);
    let (n, n_t, n_tt) = (p1.cross(p2), p1.cross(p3), p2.cross(p3));
    let (w, w_t, w_tt) = (
        p1.dot(p1),
        2.0 * p1.dot(p2),
        2.0 * (p2.dot(p2) + p1.dot(p3)),
    );
    let found = Curvature {
        value: n / (w * w.sqrt()),
        d1: (n_t * w - 1.5 * n * w_t) / (w * w * w),
        d2: (n_tt * w * w - 3.5 * n_t * w * w_t - 1.5 * n * w * w_tt + 4.5 * n * w_t * w_t)
            / (w * w * w * w * w.sqrt()),
    };
    found
        .to_array()
        .iter()
        .all(|x| x.is_finite())
        .then_some(found)
}

/// How small a part of the second derivative the first one is where the curve stands still, by the digits of t.
const STILL: f64 = 64.0 * f64::EPSILON;

/// The sign with which the curvature grows beyond any bound towards t, if it does: where p' vanishes it is about
/// p'' × p''' / (2 |p''|³ |δ|) at t + δ (derived).
pub(crate) fn pole(segment: &PathSeg, t: f64) -> Option<f64> {
    let [p1, p2, p3] = derivatives(&control_points(segment), t);
    let turn = p2.cross(p3);
    (p1.hypot() <= STILL * p2.hypot() && turn != 0.0).then(|| turn.signum())
}

/// The first three derivatives by t, from the differences of the control points.
pub(super) fn derivatives(points: &[Point], t: f64) -> [Vec2; 3] {
    let mut differences: Vec<Vec2> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut factor = 1.0;
    [0, 1, 2].map(|_| {
        factor *= differences.len() as f64;
        let axis = |of: fn(&Vec2) -> f64| {
            let coefficients: Vec<f64> = differences.iter().map(of).collect();
            if coefficients.is_empty() {
                0.0
            } else {
                Polynomial::new(&coefficients).at(t)
            }
        };
        let value = Vec2::new(axis(|v| v.x), axis(|v| v.y)) * factor;
        differences = differences
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect();
        value
    })
}

/// Where inside the segment the curvature may be extreme: where it is stationary, and where the speed is, which vanishes in a cusp.
pub(crate) fn extremes(segment: &PathSeg) -> impl Iterator<Item = f64> {
    let points = control_points(segment);
    let axis = |of: fn(&Vec2) -> f64| {
        let differences: Vec<f64> = points
            .windows(2)
            .map(|pair| of(&(pair[1] - pair[0])))
            .collect();
        Polynomial::new(&differences)
    };
    let bends = (points.len() > 2).then(|| {
        let (x1, y1) = (axis(|v| v.x), axis(|v| v.y));
        let (x2, y2) = (x1.derivative(), y1.derivative());
        let n = x1.times(&y2).minus(&y1.times(&x2));
        let w = x1.times(&x1).minus(&y1.times(&y1).scaled(-1.0));
        let slope = n
            .derivative()
            .times(&w)
            .minus(&n.times(&w.derivative()).scaled(1.5));
        [slope.sign_changes(), w.derivative().sign_changes()]
    });
    let all = bends.into_iter().flatten();
    all.flat_map(|places| places.iter().collect::<Vec<f64>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{CubicBez, Line, QuadBez};

    #[test]
    fn the_curvature_is_extreme_there_and_nowhere_else() {
        let parabola = PathSeg::Quad(QuadBez::new((-1.0, 1.0), (0.5, -1.0), (1.0, 2.0)));
        let cubic = PathSeg::Cubic(CubicBez::new(
            (0.0, 0.0),
            (1.0, 3.0),
            (4.0, 3.5),
            (6.0, -1.0),
        ));
        let bent = PathSeg::Cubic(CubicBez::new(
            (0.0, 0.0),
            (1.0, 2.0),
            (2.0, -2.0),
            (3.0, 0.5),
        ));
        for (segment, count) in [(parabola, 1), (cubic, 1), (bent, 2)] {
            let k = |t: f64| at(&segment, t).unwrap().value;
            let turns: Vec<f64> = (1..10_000)
                .map(|i| f64::from(i) / 10_000.0)
                .filter(|&t| (k(t) - k(t - 1e-4)) * (k(t + 1e-4) - k(t)) <= 0.0)
                .collect();
            assert_eq!(turns.len(), count, "{turns:?}");
            // And where the speed is stationary, which it is nowhere else.
            let speed = |t: f64| derivatives(&control_points(&segment), t)[0].hypot();
            let found: Vec<f64> = extremes(&segment).collect();
            let (bends, slow): (Vec<f64>, Vec<f64>) = found
                .into_iter()
                .partition(|t| turns.iter().any(|near| (t - near).abs() < 3e-4));
            assert!(bends.len() >= count, "{bends:?} {turns:?}");
            for t in slow {
                assert!(
                    (speed(t + 1e-6) - speed(t - 1e-6)).abs() < 1e-9 * speed(t),
                    "{t}"
                );
            }
        }
        let line = PathSeg::Line(Line::new((0.0, 0.0), (1.0, 1.0)));
        assert_eq!(extremes(&line).count(), 0);
    }
}
