//! Lancaster's two spaces of a cubic: graph space, its control points, and equation space, its power coefficients.
//!
//! Don Lancaster, "Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines" (2005): x = At³ + Bt² + Ct + D with
//!
//! ```text
//! A = x3 - 3x2 + 3x1 - x0     x0 = D
//! B = 3x2 - 6x1 + 3x0         x1 = D + C/3
//! C = 3x1 - 3x0               x2 = D + 2C/3 + B/3
//! D = x0                      x3 = D + C + B + A
//! ```
//!
//! and the same for y with E, F, G, H. [`value`] is his faster "cube-free" form, ((At + B)t + C)t + D.
//!
//! The way there and back ends within one unit in the last place of the largest coefficient: sums are formed in twice the digits
//! of `f64` and rounded once, and A is taken against B, C and D as they are after rounding, so that the four still add up to x3.
//!
//! ```
//! use curveto::power::{coefficients, control_points, value};
//! // A quarter of the unit circle, its x: 1, 1, k, 0.
//! let graph = [1.0, 1.0, 0.5522847498307936, 0.0];
//! let equation = coefficients(&graph);
//! assert!((value(equation, 0.5) - 0.5_f64.sqrt()).abs() < 1e-15);
//! assert_eq!(control_points(equation), graph);
//! ```

use kurbo::{PathSeg, Point, Vec2};

use crate::curve::control_points as points_of;
use crate::numeric::double::Double;

/// A segment of a plane curve in equation space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equation {
    /// [A, B, C, D] of x.
    pub x: [f64; 4],
    /// [E, F, G, H] of y.
    pub y: [f64; 4],
}

impl Equation {
    /// The point at t, cube-free.
    #[must_use]
    pub fn point(&self, t: f64) -> Point {
        Point::new(value(self.x, t), value(self.y, t))
    }

    /// The derivative at t, cube-free.
    #[must_use]
    pub fn derivative(&self, t: f64) -> Vec2 {
        Vec2::new(slope(self.x, t), slope(self.y, t))
    }
}

impl From<&PathSeg> for Equation {
    fn from(segment: &PathSeg) -> Self {
        let points = points_of(segment);
        let of = |coordinate: fn(&Point) -> f64| {
            coefficients(&points.iter().map(coordinate).collect::<Vec<f64>>())
        };
        Self {
            x: of(|p| p.x),
            y: of(|p| p.y),
        }
    }
}

/// The equation-space coefficients [A, B, C, D] of one coordinate of the control points: two of a line, three of a quadratic,
/// four of a cubic. What a curve of lower degree lacks is 0.
#[must_use]
pub fn coefficients(points: &[f64]) -> [f64; 4] {
    let difference = Double::difference;
    match *points {
        [] => [0.0; 4],
        [x0] => [0.0, 0.0, 0.0, x0],
        [x0, x1] => [0.0, 0.0, x1 - x0, x0],
        [x0, x1, x2] => {
            let c = 2.0 * (x1 - x0);
            let b = difference(x2, x0).plus(difference(0.0, c));
            [0.0, b.value(), c, x0]
        }
        [x0, x1, x2, x3, ..] => {
            let c = difference(x1, x0).scaled(3.0).value();
            let bend = difference(x2, x1).plus(difference(x0, x1));
            let b = bend.scaled(3.0).value();
            let a = difference(x3, x0).plus(difference(-b, c));
            [a.value(), b, c, x0]
        }
    }
}

/// The graph-space coordinates [x0, x1, x2, x3] of the cubic with these equation-space coefficients.
#[must_use]
pub fn control_points([a, b, c, d]: [f64; 4]) -> [f64; 4] {
    let c_and_d = Double::difference(c, -d);
    let third = |sum: Double| sum.over(3.0).plus(Double::difference(d, 0.0)).value();
    [
        d,
        third(Double::difference(c, 0.0)),
        third(Double::difference(2.0 * c, -b)),
        c_and_d.plus(Double::difference(b, -a)).value(),
    ]
}

/// The polynomial's value at t, by Horner's rule: Lancaster's "cube-free" form.
#[must_use]
pub fn value([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    ((a * t + b) * t + c) * t + d
}

/// The polynomial's derivative at t, cube-free.
#[must_use]
pub fn slope([a, b, c, _]: [f64; 4], t: f64) -> f64 {
    (3.0 * a * t + 2.0 * b) * t + c
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The distance from |x| to the next larger float.
    fn ulp(x: f64) -> f64 {
        x.abs().next_up() - x.abs()
    }

    #[test]
    fn the_standard_quarter_is_as_lancaster_writes_it() {
        // x = (3x1 - 2) t³ + (3 - 6x1) t² + 3x1 t for the points 0, x1, 1, 1.
        let x1 = 0.5;
        assert_eq!(
            coefficients(&[0.0, x1, 1.0, 1.0]),
            [3.0 * x1 - 2.0, 3.0 - 6.0 * x1, 3.0 * x1, 0.0]
        );
    }

    #[test]
    fn whole_numbers_go_there_and_back_exactly() {
        let equation = [4.0, -3.0, 6.0, 2.0];
        assert_eq!(control_points(equation), [2.0, 4.0, 5.0, 9.0]);
        assert_eq!(coefficients(&[2.0, 4.0, 5.0, 9.0]), equation);
    }

    #[test]
    fn lower_degrees_are_raised_on_the_way_back() {
        assert_eq!(
            control_points(coefficients(&[3.0, 9.0])),
            [3.0, 5.0, 7.0, 9.0]
        );
        assert_eq!(
            control_points(coefficients(&[0.0, 3.0, 0.0])),
            [0.0, 2.0, 2.0, 0.0]
        );
    }

    #[test]
    fn segments_of_every_degree_are_traced() {
        use kurbo::{CubicBez, Line, ParamCurve, QuadBez};
        let line = PathSeg::Line(Line::new((1.0, 2.0), (3.0, -1.0)));
        let quad = PathSeg::Quad(QuadBez::new((1.0, 2.0), (3.0, -1.0), (0.5, 4.0)));
        let cubic = PathSeg::Cubic(CubicBez::new(
            (1.0, 2.0),
            (3.0, -1.0),
            (0.5, 4.0),
            (0.0, 7.0),
        ));
        for segment in [line, quad, cubic] {
            let equation = Equation::from(&segment);
            for i in 0..=16 {
                let t = f64::from(i) / 16.0;
                assert!(equation.point(t).distance(segment.eval(t)) < 4e-15);
                let [before, after] = [t - 0.5f64.powi(20), t + 0.5f64.powi(20)];
                let secant = (segment.eval(after) - segment.eval(before)) * 2.0_f64.powi(19);
                assert!((equation.derivative(t) - secant).hypot() < 1e-8);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn the_round_trip_ends_within_one_unit_of_the_largest_coefficient(
            mantissas in prop::array::uniform4(-1.0..1.0_f64),
            exponents in prop::array::uniform4(-6..6_i32),
        ) {
            let points: [f64; 4] = core::array::from_fn(|i| mantissas[i] * 2.0_f64.powi(exponents[i]));
            let there = coefficients(&points);
            let largest = there.iter().fold(0.0_f64, |a, c| a.max(c.abs()));
            for (given, back) in points.into_iter().zip(control_points(there)) {
                prop_assert!((given - back).abs() <= ulp(largest), "{points:?}: {given} became {back}");
            }
        }

        #[test]
        fn cube_free_evaluation_agrees_with_de_casteljau(
            points in prop::array::uniform4(-1.0..1.0_f64),
            t in 0.0..=1.0_f64,
        ) {
            let mut work = points;
            for last in (1..4).rev() {
                for i in 0..last {
                    work[i] += t * (work[i + 1] - work[i]);
                }
            }
            prop_assert!((value(coefficients(&points), t) - work[0]).abs() < 4e-15);
        }
    }

    #[test]
    fn no_point_has_no_coefficients_and_one_is_constant() {
        assert_eq!(coefficients(&[]), [0.0; 4]);
        assert_eq!(coefficients(&[7.0]), [0.0, 0.0, 0.0, 7.0]);
    }
}
