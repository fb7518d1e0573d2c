//! The ellipse nearest to points: the conic A x² + B xy + C y² + D x + E y = 1 of least squares to begin with, which is linear, then
//! the least sum of squared distances by Gauss-Newton.
//!
//! With d the distance of a point, n the outward normal at its foot and p the foot, d changes by -n · ∂p when a parameter does:
//! the step solves Σ g gᵀ δ = Σ g d with g = n · ∂p for the centre, both radii and the rotation.

use kurbo::{Point, Vec2};

use super::super::radial::nearest;
use crate::numeric::functions::unit_vector;
use crate::numeric::linear;
use crate::shape::Truth;

/// The most steps; from the conic a handful do.
const MOST_STEPS: usize = 50;

/// What is added to the diagonal of the equations, in parts of their trace: a circle's rotation is not determined.
const DAMPING: f64 = 1e-14;

/// The ellipse nearest to these points; `None` where five of them do not determine one.
pub(super) fn nearest_ellipse(points: &[Point]) -> Option<Truth> {
    let count = points.len() as f64;
    let mean = points.iter().map(|p| p.to_vec2()).sum::<Vec2>() / count;
    let offsets = points.iter().map(|p| p.to_vec2() - mean);
    let size = offsets.clone().map(Vec2::hypot).fold(0.0, f64::max);
    if points.len() < 5 {
        return None;
    }
    // No conic is found where the size is 0 or no number.
    let points: Vec<Point> = offsets.map(|v| (v / size).to_point()).collect();
    let mut found = of_conic(&points)?;
    let mut cost = squares(&points, &found);
    for _ in 0..MOST_STEPS {
        let Some(next) = gauss_newton(&points, &found) else {
            break;
        };
        let lower = squares(&points, &next);
        if lower.is_nan() || lower >= cost {
            break;
        }
        (found, cost) = (next, lower);
    }
    let center = (mean + found.center.to_vec2() * size).to_point();
    let radii = found.radii * size;
    // An axis has two directions; that to the right, or upwards but for rounding, is told. That of the conic points upwards.
    let axis = found.axis;
    let is_back = axis.x < -1e-14;
    let axis = if is_back { -axis } else { axis };
    (center.is_finite() && radii.is_finite()).then(|| Truth::new(center, radii, axis))
}

/// The sum of the squared distances of points.
pub(super) fn squares(points: &[Point], truth: &Truth) -> f64 {
    let distances = points.iter().map(|&p| nearest(truth, p).distance);
    distances.map(|d| d * d).sum()
}

/// The ellipse of the conic of least squares; `None` where it is none.
fn of_conic(points: &[Point]) -> Option<Truth> {
    let terms = |p: &Point| [p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y];
    let [a, b, c, d, e] = least_squares(points.iter().map(|p| (terms(p), 1.0)), 0.0)?;
    let determinant = a * c - b * b / 4.0;
    let center = Vec2::new(b * e / 4.0 - c * d / 2.0, b * d / 4.0 - a * e / 2.0) / determinant;
    // About its centre the conic is N(v, v) = 1.
    let level = 1.0 - f64::midpoint(d * center.x, e * center.y);
    let [a, b, c] = [a, b, c].map(|term| term / level);
    let (mid, apart) = (f64::midpoint(a, c), libm::hypot((a - c) / 2.0, b / 2.0));
    let radii = Vec2::new(1.0 / (mid - apart).sqrt(), 1.0 / (mid + apart).sqrt());
    let across = unit_vector(libm::atan2(b, a - c) / 2.0);
    let is_ellipse = radii.is_finite() && radii.y > 0.0 && center.is_finite();
    is_ellipse.then(|| Truth::new(center.to_point(), radii, Vec2::new(-across.y, across.x)))
}

fn gauss_newton(points: &[Point], truth: &Truth) -> Option<Truth> {
    let (e, f) = (truth.axis, Vec2::new(-truth.axis.y, truth.axis.x));
    let row = |&p: &Point| {
        let foot = nearest(truth, p);
        let n = foot.outward;
        let v = p - n * foot.distance - truth.center;
        let (cos, sin) = (v.dot(e) / truth.radii.x, v.dot(f) / truth.radii.y);
        let turned = Vec2::new(-v.y, v.x);
        let row = [n.x, n.y, n.dot(e) * cos, n.dot(f) * sin, n.dot(turned)];
        (row, foot.distance)
    };
    let [x, y, along, across, turn] = least_squares(points.iter().map(row), DAMPING)?;
    let radii = truth.radii + Vec2::new(along, across);
    let by = unit_vector(turn);
    let axis = e * by.x + f * by.y;
    let is_ellipse = radii.x > 0.0 && radii.y > 0.0 && axis.is_finite();
    is_ellipse.then(|| Truth::new(truth.center + Vec2::new(x, y), radii, axis))
}

/// The five unknowns with the least sum of (row · unknowns - right)².
fn least_squares(rows: impl Iterator<Item = ([f64; 5], f64)>, damping: f64) -> Option<[f64; 5]> {
    let (mut equations, mut sums) = ([[0.0; 5]; 5], [0.0; 5]);
    for (row, right) in rows {
        for (i, factor) in row.into_iter().enumerate() {
            for (sum, term) in equations[i].iter_mut().zip(row) {
                *sum += factor * term;
            }
            sums[i] += factor * right;
        }
    }
    let trace: f64 = equations.iter().enumerate().map(|(i, row)| row[i]).sum();
    for (i, equation) in equations.iter_mut().enumerate() {
        equation[i] += damping * trace;
    }
    linear::solve(equations, sums)
}

#[cfg(test)]
mod tests {
    use kurbo::Affine;

    use super::*;

    fn on_ellipse(truth: &Truth, angles: impl Iterator<Item = f64>) -> Vec<Point> {
        angles
            .map(|a| truth.placement() * unit_vector(a).to_point())
            .collect()
    }

    #[test]
    fn points_of_an_ellipse_give_it_back() {
        let truth = Truth::new(
            Point::new(-3.0, 700.0),
            Vec2::new(120.0, 50.0),
            unit_vector(0.4),
        );
        for sweep in [6.2, 3.0, 1.5] {
            let points = on_ellipse(&truth, (0..40).map(|i| f64::from(i) / 40.0 * sweep));
            let found = nearest_ellipse(&points).unwrap();
            assert!(
                (found.radii - truth.radii).hypot() < 1e-6,
                "{sweep}: {found:?}"
            );
            assert!(
                found.center.distance(truth.center) < 1e-6,
                "{sweep}: {found:?}"
            );
            assert!(
                found.axis.cross(truth.axis).abs() < 1e-8,
                "{sweep}: {found:?}"
            );
        }
    }

    #[test]
    fn the_fit_is_where_the_sum_of_squares_is_least() {
        for rotation in [0.0, 0.7, 2.0] {
            let axis = unit_vector(rotation);
            let truth = Truth::new(Point::new(1.0, -2.0), Vec2::new(2.0, 1.0), axis);
            let mut points = on_ellipse(&truth, (0..9).map(f64::from));
            points.push(truth.placement() * Point::new(0.95, 0.8));
            let found = nearest_ellipse(&points).unwrap();
            let least = squares(&points, &found);
            for step in [1e-4, -1e-4, 1e-6, -1e-6] {
                let moved = |map: Affine| Truth::of(found.placement() * map).unwrap();
                for map in [
                    Affine::translate((step, 0.0)),
                    Affine::translate((0.0, step)),
                    Affine::scale_non_uniform(1.0 + step, 1.0),
                    Affine::scale_non_uniform(1.0, 1.0 + step),
                ] {
                    assert!(squares(&points, &moved(map)) > least, "{rotation} {map:?}");
                }
                let turned = found.axis + found.axis.turn_90() * step;
                let turned = Truth::new(found.center, found.radii, turned.normalize());
                assert!(squares(&points, &turned) > least, "{rotation} {step}");
            }
        }
    }

    #[test]
    fn the_axis_points_to_the_right_or_upwards() {
        for degrees in (0..360).step_by(15) {
            let axis = unit_vector(f64::from(degrees).to_radians());
            let truth = Truth::new(Point::new(1.0, 2.0), Vec2::new(3.0, 2.0), axis);
            let points = on_ellipse(&truth, (0..20).map(f64::from));
            let found = nearest_ellipse(&points).unwrap().axis;
            assert!(found.cross(axis).abs() < 1e-9, "{degrees}: {found:?}");
            let is_upright = degrees % 180 == 90;
            assert!(
                if is_upright {
                    found.y > 0.0
                } else {
                    found.x > 0.0
                },
                "{degrees}: {found:?}"
            );
        }
    }

    #[test]
    fn five_points_are_enough() {
        let truth = Truth::new(Point::new(1.0, 2.0), Vec2::new(3.0, 2.0), unit_vector(0.5));
        let points = on_ellipse(&truth, (0..5).map(f64::from));
        let found = nearest_ellipse(&points).unwrap();
        assert!((found.radii - truth.radii).hypot() < 1e-9, "{found:?}");
        assert_eq!(nearest_ellipse(&points[..4]), None);
        assert_eq!(nearest_ellipse(&[Point::new(1.0, 2.0); 9]), None);
        assert_eq!(nearest_ellipse(&[Point::new(f64::INFINITY, 2.0); 9]), None);
    }

    #[test]
    fn a_circle_is_an_ellipse_and_a_line_and_a_hyperbola_are_none() {
        let circle = Truth::circle(Point::new(5.0, 5.0), 3.0);
        let found = nearest_ellipse(&on_ellipse(&circle, (0..12).map(f64::from))).unwrap();
        assert!((found.radii - circle.radii).hypot() < 1e-9, "{found:?}");
        let line: Vec<Point> = (0..9).map(|i| Point::new(f64::from(i), 0.5)).collect();
        assert_eq!(nearest_ellipse(&line), None);
        let hyperbola = (1..9).map(f64::from).map(|x| Point::new(x, 1.0 / x));
        assert_eq!(nearest_ellipse(&hyperbola.collect::<Vec<_>>()), None);
    }
}
