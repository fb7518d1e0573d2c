//! Figures of the cards that no formula of a method gives, in degrees and on the unit circle.

use super::{Method, Span};
use crate::error::Result;
use crate::numeric::root;

pub use super::tangent::GOLDAPP_ZERO;

/// The angle in degrees at which a quarter with the handle k first crosses the circle: with u = t(1-t), where H + G u = 0.
#[must_use]
pub fn crossing(k: f64) -> f64 {
    let (h, g) = (6.0 - 6.0 * k - 9.0 * k * k, 8.0 - 24.0 * k + 18.0 * k * k);
    let t = (1.0 - (1.0 + 4.0 * h / g).sqrt()) / 2.0;
    let along = |t: f64| t * t * (3.0 - 2.0 * t) + 3.0 * k * t * (1.0 - t) * (1.0 - t);
    libm::atan2(along(t), along(1.0 - t)).to_degrees()
}

/// The handle of a quarter that crosses the circle at 30 degrees; the higher the handle, the later it does.
#[must_use]
pub fn handle_crossing_at_30() -> f64 {
    root(|k| crossing(k) - 30.0, 0.551_8, 0.552)
}

/// The curvature at the ends, (2/3) times the distance of the second inner control point from the tangent over k².
///
/// # Errors
///
/// As [`Method::piece`].
pub fn end_curvature(method: Method, degrees: f64) -> Result<f64> {
    let span = Span::from_degrees(degrees);
    let k = method.piece(&span)?.handle_length();
    Ok(2.0 * (1.0 - span.c - k * span.s) / (3.0 * k * k))
}

/// The peak and the mean of |r - 1| of one of n splines with the handle k, as PostScript's single precision has them: at 91 points by
/// Lancaster's equation space, x = ((At + B)t + C)t + D.
#[must_use]
pub fn in_single_precision(n: u8, k: f32) -> [f32; 2] {
    const STEPS: u8 = 90;
    let span = Span::from_degrees(360.0 / f64::from(n));
    let (s, c) = (span.s as f32, span.c as f32);
    let equation = |p: [f32; 4]| {
        let a = p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0];
        let b = 3.0 * p[2] - 6.0 * p[1] + 3.0 * p[0];
        [a, b, 3.0 * p[1] - 3.0 * p[0], p[0]]
    };
    let value = |[a, b, c, d]: [f32; 4], t: f32| ((a * t + b) * t + c) * t + d;
    let (x, y) = (
        equation([1.0, 1.0, c + k * s, c]),
        equation([0.0, k, s - k * c, s]),
    );
    let (mut peak, mut sum) = (0.0_f32, 0.0_f32);
    for i in 0..=STEPS {
        let t = f32::from(i) / f32::from(STEPS);
        let (x, y) = (value(x, t), value(y, t));
        let error = ((x * x + y * y).sqrt() - 1.0).abs();
        peak = peak.max(error);
        sum += error;
    }
    [peak, sum / (f32::from(STEPS) + 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{CubicBez, ParamCurve, ParamCurveCurvature};

    #[test]
    fn a_quarter_crosses_the_circle_where_the_figure_says() {
        for k in [0.551_85, 0.551_915, 0.552, 0.552_2] {
            let quarter = CubicBez::new((1.0, 0.0), (1.0, k), (k, 1.0), (0.0, 1.0));
            // Outside at first, inside in the middle.
            let (mut outside, mut inside) = (1e-3, 0.5);
            for _ in 0..60 {
                let t = f64::midpoint(outside, inside);
                if quarter.eval(t).to_vec2().hypot() > 1.0 {
                    outside = t;
                } else {
                    inside = t;
                }
            }
            let degrees = quarter.eval(outside).to_vec2().atan2().to_degrees();
            assert!((crossing(k) - degrees).abs() < 1e-8, "{k}: {degrees}");
        }
        assert!((crossing(handle_crossing_at_30()) - 30.0).abs() < 1e-9);
    }

    /// What Lancaster's table prints for four and for five splines with 0.55178 and 0.43307, in units of 2^-24.
    #[test]
    fn single_precision_gives_whole_units() {
        const UNIT: f32 = 16_777_216.0;
        for (n, k) in [(4, 0.551_784), (5, 0.433_072)] {
            let [peak, mean] = in_single_precision(n, k);
            assert_eq!((peak * UNIT).fract(), 0.0);
            assert!(0.0 < mean && mean < peak, "{n}: {mean}");
            let exact = crate::Rule::Handle(f64::from(k));
            let span = Span::from_degrees(360.0 / f64::from(n));
            let exact = exact.radial_error(&span).unwrap().peak();
            assert!((f64::from(peak) - exact).abs() < 4e-7, "{n}: {exact}");
        }
    }

    #[test]
    fn the_curvature_at_the_ends_is_the_curve_s() {
        for method in [Method::Curvature, Method::Midpoint, Method::Chen3] {
            for degrees in [30.0, 60.0, 90.0, 120.0] {
                let span = Span::from_degrees(degrees);
                let [first, last] = [0.0, degrees].map(crate::Angle::from_degrees);
                let ends = [first, last].map(crate::Angle::direction);
                let piece = method.piece(&span).unwrap().between(ends);
                let kurbo::PathSeg::Cubic(cubic) = piece else {
                    panic!("{method} is no cubic");
                };
                let curvature = end_curvature(method, degrees).unwrap();
                let right = cubic.curvature(0.0).abs();
                assert!(
                    (curvature - right).abs() < 1e-12,
                    "{method} {degrees}: {right}"
                );
            }
        }
    }
}
