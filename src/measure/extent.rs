//! Arc length and area, of a curve and of the true shape.

use kurbo::{ParamCurve, ParamCurveArea, ParamCurveDeriv, PathSeg, Point, Vec2};

use crate::curve::control_points;
use crate::numeric::adaptive_integral;
use crate::numeric::bernstein::Polynomial;

/// The arc length of a segment, to a few units in the last place.
#[must_use]
pub fn length(segment: &PathSeg) -> f64 {
    let points = control_points(segment);
    let rates: Vec<Vec2> = points.windows(2).map(|p| p[1] - p[0]).collect();
    let speed = |t: f64| match segment {
        PathSeg::Line(line) => (line.p1 - line.p0).hypot(),
        PathSeg::Quad(quad) => quad.deriv().eval(t).to_vec2().hypot(),
        PathSeg::Cubic(cubic) => cubic.deriv().eval(t).to_vec2().hypot(),
    };
    // Where a hairpin turns the speed has a corner, nearly, which quadrature may overlook unless it is an end.
    let turns = slowest(&rates).sign_changes();
    let pieces = turns.pieces();
    pieces.fold(0.0, |sum, (from, to)| {
        sum + adaptive_integral(&speed, from, to, 0.0)
    })
}

/// The derivative of the square of a speed but for a factor: its roots are where the speed is least or most.
fn slowest(rates: &[Vec2]) -> Polynomial {
    match *rates {
        [a, b] => Polynomial::new(&[a.dot(b - a), b.dot(b - a)]),
        [a, b, c] => {
            let (u, v) = (b - a, c - b);
            // (a, b, c) by (u, v), of degrees 2 and 1.
            Polynomial::new(&[
                a.dot(u),
                (a.dot(v) + 2.0 * b.dot(u)) / 3.0,
                (2.0 * b.dot(v) + c.dot(u)) / 3.0,
                c.dot(v),
            ])
        }
        _ => Polynomial::new(&[1.0]),
    }
}

/// The area that the segment and the radii to its ends enclose, positive where the segment runs from +x towards +y about the centre.
#[must_use]
pub fn sector_area(segment: &PathSeg, center: Point) -> f64 {
    (kurbo::Affine::translate(-center.to_vec2()) * *segment).signed_area()
}

/// The arc length of an ellipse between two parametric angles in radians: the integral of sqrt(a² sin² + b² cos²), quarter by
/// quarter, since its steepest places lie at the axes.
#[must_use]
pub fn ellipse_length(radii: Vec2, from: f64, to: f64) -> f64 {
    let sign = 1.0_f64.copysign(to - from);
    let (from, to) = (from.min(to), from.max(to));
    if radii.x == radii.y {
        return sign * radii.x * (to - from);
    }
    let speed = |angle: f64| libm::hypot(radii.x * libm::sin(angle), radii.y * libm::cos(angle));
    let quarter = core::f64::consts::FRAC_PI_2;
    let (first, last) = ((from / quarter).floor(), (to / quarter).ceil());
    let count = last - first;
    let length = |[from, to]: [f64; 2]| adaptive_integral(&speed, from, to, 0.0);
    if count > MOST_QUARTERS {
        let ends = [
            [from, (first + 1.0) * quarter],
            [(last - 1.0) * quarter, to],
        ];
        // Whole quarters are alike.
        return sign
            * (ends.map(length).iter().sum::<f64>() + (count - 2.0) * length([0.0, quarter]));
    }
    let axis = |i: usize| ((first + i as f64) * quarter).clamp(from, to);
    let pieces = (0..count as usize).map(|i| length([axis(i), axis(i + 1)]));
    sign * pieces.fold(0.0, |sum, piece| sum + piece)
}

/// The quarters of a turn that lie anywhere, each of which is integrated by itself.
const MOST_QUARTERS: f64 = 5.0;

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    /// The perimeter by the arithmetic-geometric mean (Gauss; Abramowitz & Stegun 17.6).
    fn perimeter(a: f64, b: f64) -> f64 {
        let (mut x, mut y) = (a, b);
        let (mut sum, mut power) = (a * a - (a * a - b * b) / 2.0, 1.0);
        while (x - y).abs() > 1e-15 * x {
            let c = (x - y) / 2.0;
            (x, y) = (f64::midpoint(x, y), (x * y).sqrt());
            sum -= power * c * c;
            power *= 2.0;
        }
        2.0 * PI * sum / x
    }

    #[test]
    fn the_perimeter_is_that_of_the_arithmetic_geometric_mean() {
        for (a, b) in [(3.0, 2.0), (150.0, 100.0), (1.0, 0.01), (1.0, 1e-5)] {
            let found = ellipse_length(Vec2::new(a, b), 0.3, 0.3 + 2.0 * PI);
            let exact = perimeter(a, b);
            assert!(
                (found / exact - 1.0).abs() < 1e-14,
                "{a} {b}: {found} {exact}"
            );
        }
    }

    #[test]
    fn arcs_of_a_circle_are_radius_times_angle() {
        let radii = Vec2::new(2.0, 2.0);
        for (from, to) in [(1.0, -2.0), (-2.0, 1.0), (1.0, 3.0), (-1.0, -3.0)] {
            assert_eq!(ellipse_length(radii, from, to), 2.0 * (to - from));
        }
    }

    #[test]
    fn a_sector_is_about_its_centre() {
        let line = PathSeg::Line(kurbo::Line::new((3.0, 1.0), (5.0, 3.0)));
        assert_eq!(sector_area(&line, Point::new(3.0, -1.0)), -2.0);
        assert_eq!(sector_area(&line, Point::new(3.0, 3.0)), 2.0);
    }

    #[test]
    fn arcs_are_as_long_a_turn_farther_and_mirrored() {
        let radii = Vec2::new(3.0, 0.7);
        for (from, to) in [(0.3, 1.0), (1.4, 1.7), (-5.0, -1.0), (-0.2, 4.0)] {
            let length = ellipse_length(radii, from, to);
            let near = |other: f64| (other / length - 1.0).abs() < 1e-13;
            for turns in [-3.0, -1.0, 2.0] {
                let by = 2.0 * PI * turns;
                assert!(
                    near(ellipse_length(radii, from + by, to + by)),
                    "{from} {turns}"
                );
            }
            assert!(near(ellipse_length(radii, -to, -from)), "{from}");
            assert!(near(-ellipse_length(radii, to, from)), "{from}");
            // The sum of many chords.
            let at = |i: u32| from + (to - from) * f64::from(i) / 20_000.0;
            let point =
                |angle: f64| Vec2::new(radii.x * libm::cos(angle), radii.y * libm::sin(angle));
            let chords: f64 = (0..20_000)
                .map(|i| (point(at(i + 1)) - point(at(i))).hypot())
                .sum();
            assert!(
                (chords / length - 1.0).abs() < 1e-6,
                "{from}: {chords} {length}"
            );
        }
    }

    #[test]
    fn many_turns_are_as_long_as_each_of_them() {
        let radii = Vec2::new(1.0, 2.0);
        let turn = perimeter(2.0, 1.0);
        for turns in [2.0, 1.5e8] {
            let length = ellipse_length(radii, -0.3, 2.0 * PI * turns - 0.3);
            assert!((length / (turns * turn) - 1.0).abs() < 1e-13, "{turns}");
        }
        let length = ellipse_length(radii, 1e300, 0.0);
        assert!((length / (-1e300 / (2.0 * PI) * turn) - 1.0).abs() < 1e-13);
    }
}
