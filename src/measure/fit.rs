//! The circle or ellipse that a curve was meant to be, where nobody says. A circle by Kåsa's algebraic fit to begin with (the least sum of
//! (|p - c|² - r²)², which is linear), then the least sum of (|p - c| - r)² by Gauss-Newton.
//!
//! At every step the best radius for a centre is the mean distance, so that two unknowns are left: with the unit directions g
//! from the centre to the points, the step solves Σ (g - ḡ)(g - ḡ)ᵀ δ = Σ (g - ḡ)(|p - c| - r).

mod ellipse;

use kurbo::{Affine, ParamCurve, Point, Vec2};

use super::unit_for;
use crate::curve::{Curve, largest_coordinate};
use crate::error::{Error, Result, UnmeasurableError, finite};
use crate::numeric::functions::{angle_of, power, unit_vector};
use crate::shape::Truth;

/// How many points of each segment stand for the curve.
const POINTS: u32 = 64;

/// The most steps; from Kåsa's circle five or six do.
const MOST_STEPS: usize = 50;

/// What a circle or an ellipse is fitted to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum FitTo {
    /// The ends of the segments, which most programs place on the circle.
    Joints,
    /// Points at equal steps of t all along the curve.
    Curve,
}

/// How well a fitted circle or ellipse fits.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Fit {
    /// What it was fitted to.
    pub to: FitTo,
    /// How many points those were.
    pub points: usize,
    /// The root mean square of their distances from it.
    pub rms: f64,
    /// The same over the larger radius.
    pub relative_rms: f64,
}

/// The circle fitted to a curve: to what `to` says, or to the joints where three of them determine a circle and else to the curve.
///
/// # Errors
///
/// Where the points are one point or lie on a line, so that no circle is nearest.
pub fn circle(curve: &Curve, to: Option<FitTo>) -> Result<(Truth, Fit)> {
    fitted(curve, to, fitted_circle)
}

/// The ellipse fitted to a curve: to what `to` says, or to the joints where five of them determine an ellipse and else to the curve.
///
/// # Errors
///
/// Where no ellipse is nearest, as of points on a line.
pub fn ellipse(curve: &Curve, to: Option<FitTo>) -> Result<(Truth, Fit)> {
    fitted(curve, to, fitted_ellipse)
}

/// How many times nearer to a curve an ellipse has to be than a circle to be what was meant.
const NEARER: f64 = 4.0;

/// The ellipse where it is much nearer to the points of the curve than the circle, else the circle.
///
/// # Errors
///
/// Where neither fits.
pub fn either(curve: &Curve) -> Result<(Truth, Fit)> {
    let rms =
        |found: &Result<(Truth, Fit)>| found.as_ref().map_or(f64::INFINITY, |(_, fit)| fit.rms);
    let round = circle(curve, Some(FitTo::Curve));
    let flat = ellipse(curve, Some(FitTo::Curve));
    if NEARER * rms(&flat) < rms(&round) {
        ellipse(curve, None)
    } else {
        circle(curve, None)
    }
}

/// The ends of the segments, each once.
fn joints(curve: &Curve) -> Vec<Point> {
    let mut points: Vec<Point> = curve.segments.iter().map(ParamCurve::start).collect();
    points.extend(curve.segments.last().map(ParamCurve::end));
    let near = 1e-6
        * curve
            .bounding_box()
            .map_or(0.0, |b| libm::hypot(b.width(), b.height()));
    let mut distinct: Vec<Point> = Vec::with_capacity(points.len());
    for p in points {
        if distinct.iter().all(|q| q.distance(p) > near) {
            distinct.push(p);
        }
    }
    distinct
}

/// Points all along the curve.
fn along(curve: &Curve) -> Vec<Point> {
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(POINTS);
    curve
        .segments
        .iter()
        .flat_map(|segment| (0..POINTS).map(move |i| segment.eval(at(i))))
        .collect()
}

/// What a way to fit points makes of a curve, with the sum of the squared distances that it leaves.
fn fitted(
    curve: &Curve,
    to: Option<FitTo>,
    nearest: fn(&[Point]) -> Result<(Truth, f64)>,
) -> Result<(Truth, Fit)> {
    // In units near 1 no square leaves the range of f64.
    let largest = finite("coordinate", largest_coordinate(&curve.segments))?;
    let unit = unit_for(largest.max(f64::MIN_POSITIVE));
    let scaled = curve.transformed(Affine::scale(1.0 / unit));
    let fit = |points: &[Point], to| {
        let (truth, squares) = nearest(points)?;
        let rms = (squares / points.len() as f64).sqrt();
        let fit = Fit {
            to,
            points: points.len(),
            rms: rms * unit,
            relative_rms: rms / truth.larger_radius(),
        };
        Ok((truth.scaled(unit), fit))
    };
    let at_joints = || fit(&joints(&scaled), FitTo::Joints);
    let along_it = || fit(&along(&scaled), FitTo::Curve);
    match to {
        Some(FitTo::Joints) => at_joints(),
        Some(FitTo::Curve) => along_it(),
        None => at_joints().or_else(|_| along_it()),
    }
}

fn fitted_circle(points: &[Point]) -> Result<(Truth, f64)> {
    let (center, radius) =
        nearest_circle(points, None).ok_or(Error::Unmeasurable(UnmeasurableError::NoCircle))?;
    let squares = points.iter().map(|p| power(p.distance(center) - radius, 2));
    Ok((Truth::circle(center, radius), squares.sum()))
}

fn fitted_ellipse(points: &[Point]) -> Result<(Truth, f64)> {
    let truth = ellipse::nearest_ellipse(points)
        .ok_or(Error::Unmeasurable(UnmeasurableError::NoEllipse))?;
    let squares = ellipse::squares(points, &truth);
    Ok((truth, squares))
}

/// The centre and radius of the circle nearest to these points, of all or of those of a given radius.
pub(crate) fn nearest_circle(points: &[Point], radius: Option<f64>) -> Option<(Point, f64)> {
    if points.len() < 3 {
        return None;
    }
    let count = points.len() as f64;
    let mean = points.iter().map(|p| p.to_vec2()).sum::<Vec2>() / count;
    let offsets: Vec<Vec2> = points.iter().map(|p| p.to_vec2() - mean).collect();
    let size = offsets.iter().map(|v| v.hypot()).fold(0.0, f64::max);
    let offsets: Vec<Vec2> = offsets.iter().map(|&v| v / size).collect();
    // None too where the size is 0 or no number.
    let mut center = kasa(&offsets)?;
    for _ in 0..MOST_STEPS {
        let Some(step) = gauss_newton(&offsets, center, radius.map(|radius| radius / size)) else {
            break;
        };
        center += step;
        if step.hypot() <= f64::EPSILON * (1.0 + center.hypot()) {
            break;
        }
    }
    let mean_distance = offsets.iter().map(|&v| (v - center).hypot()).sum::<f64>() / count;
    let center = (mean + center * size).to_point();
    let radius = radius.unwrap_or(mean_distance * size);
    (center.is_finite() && radius.is_finite()).then_some((center, radius))
}

/// Kåsa's centre, of points whose mean is 0: Σ v vᵀ c = ½ Σ |v|² v.
fn kasa(offsets: &[Vec2]) -> Option<Vec2> {
    let right = offsets.iter().map(|&v| v * v.hypot2()).sum::<Vec2>() * 0.5;
    solve(offsets, right)
}

fn gauss_newton(offsets: &[Vec2], center: Vec2, given: Option<f64>) -> Option<Vec2> {
    let count = offsets.len() as f64;
    let distances: Vec<f64> = offsets.iter().map(|&v| (v - center).hypot()).collect();
    let radius = given.unwrap_or(distances.iter().sum::<f64>() / count);
    let directions: Vec<Vec2> = offsets
        .iter()
        .zip(&distances)
        .map(|(&v, &d)| {
            if d > 0.0 {
                (v - center) / d
            } else {
                Vec2::ZERO
            }
        })
        .collect();
    // Of a given radius the mean distance does not follow the centre.
    let mean = match given {
        Some(_) => Vec2::ZERO,
        None => directions.iter().copied().sum::<Vec2>() / count,
    };
    let centred: Vec<Vec2> = directions.iter().map(|&g| g - mean).collect();
    let right = centred
        .iter()
        .zip(&distances)
        .map(|(&g, &d)| g * (d - radius))
        .sum::<Vec2>();
    solve(&centred, right)
}

/// The solution of Σ v vᵀ x = `right`; `None` where the vectors lie on a line. It is found along the axes of the sum, where the products
/// do not cancel.
fn solve(vectors: &[Vec2], right: Vec2) -> Option<Vec2> {
    let sums = |vectors: &mut dyn Iterator<Item = Vec2>| {
        vectors.fold([0.0; 3], |[xx, xy, yy], v| {
            [xx + v.x * v.x, xy + v.x * v.y, yy + v.y * v.y]
        })
    };
    let [xx, xy, yy] = sums(&mut vectors.iter().copied());
    let axis = unit_vector(angle_of(Vec2::new(xx - yy, 2.0 * xy)) / 2.0);
    let turned = |v: Vec2| Vec2::new(v.dot(axis), axis.cross(v));
    let [xx, xy, yy] = sums(&mut vectors.iter().map(|&v| turned(v)));
    let (determinant, trace, right) = (xx * yy - xy * xy, xx + yy, turned(right));
    if determinant <= 1e-20 * trace * trace || !determinant.is_finite() {
        return None;
    }
    let along = (yy * right.x - xy * right.y) / determinant;
    let across = (xx * right.y - xy * right.x) / determinant;
    Some(axis * along + axis.turn_90() * across)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_circle(center: Point, radius: f64, angles: impl Iterator<Item = f64>) -> Vec<Point> {
        angles
            .map(|a: f64| center + Vec2::from_angle(a) * radius)
            .collect()
    }

    #[test]
    fn points_of_a_circle_give_it_back() {
        let center = Point::new(300.0, -7.0);
        for sweep in [6.2, 3.0, 0.5, 0.05] {
            let points = on_circle(center, 50.0, (0..40).map(|i| f64::from(i) / 40.0 * sweep));
            let (found, radius) = nearest_circle(&points, None).unwrap();
            let allowed = 1e-12 / (sweep * sweep);
            assert!((radius - 50.0).abs() < 300.0 * allowed, "{sweep}: {radius}");
            assert!(found.distance(center) < 300.0 * allowed, "{sweep}: {found}");
        }
    }

    #[test]
    fn the_fit_is_where_the_sum_of_squares_is_least() {
        let mut points = on_circle(Point::ORIGIN, 1.0, (0..7).map(f64::from));
        points.push(Point::new(1.4, 0.3));
        let (center, _) = nearest_circle(&points, None).unwrap();
        let cost = |center: Point| {
            let distances: Vec<f64> = points.iter().map(|p| p.distance(center)).collect();
            let mean = distances.iter().sum::<f64>() / 8.0;
            distances.iter().map(|d| (d - mean).powi(2)).sum::<f64>()
        };
        for step in [(1e-5, 0.0), (-1e-5, 0.0), (0.0, 1e-5), (0.0, -1e-5)] {
            assert!(cost(center + Vec2::from(step)) > cost(center));
        }
    }

    #[test]
    fn a_line_has_no_circle() {
        let points: Vec<Point> = (0..9)
            .map(|i| Point::new(f64::from(i), 0.1 * f64::from(i)))
            .collect();
        assert_eq!(nearest_circle(&points, None), None);
        assert_eq!(nearest_circle(&[Point::new(1.0, 1.0); 9], None), None);
    }
    #[test]
    fn lines_in_any_direction_have_no_circle() {
        for degree in 0..180 {
            let direction = Vec2::from_angle(f64::from(degree).to_radians());
            let points: Vec<Point> = (0..9)
                .map(|i| Point::new(3.0, 1.0) + direction * (0.1 * f64::from(i)))
                .collect();
            assert_eq!(nearest_circle(&points, None), None, "{degree}");
        }
    }

    fn curve(data: &str) -> Curve {
        Curve {
            segments: kurbo::BezPath::from_svg(data).unwrap().segments().collect(),
            closed: false,
        }
    }

    #[test]
    fn ends_that_differ_by_rounding_are_one_joint() {
        let closed = curve(
            "M1 0C1 .55 .55 1 0 1C-.55 1 -1 .55 -1 0C-1 -.55 -.55 -1 0 -1C.55 -1 1 -.55 1.0000001 0",
        );
        let (_, fit) = circle(&closed, None).unwrap();
        assert_eq!((fit.to, fit.points), (FitTo::Joints, 4));
        let large = closed.transformed(kurbo::Affine::scale(1e4));
        assert_eq!(circle(&large, None).unwrap().1.points, 4);
    }

    #[test]
    fn the_fit_says_how_well_it_fits() {
        let (truth, fit) = circle(&curve("M2.2 0L0 1.8L-2.2 0L0 -1.8Z"), None).unwrap();
        assert!(truth.center.to_vec2().hypot() < 1e-15 && (truth.radii.x - 2.0).abs() < 1e-15);
        assert!((fit.rms - 0.2).abs() < 1e-15 && (fit.relative_rms - 0.1).abs() < 1e-15);
    }

    #[test]
    fn three_points_are_enough() {
        let points = [(1.0, 1.0), (4.0, 5.0), (1.0, 5.0)].map(Point::from);
        let (center, radius) = nearest_circle(&points, None).unwrap();
        assert!(center.distance(Point::new(2.5, 3.0)) < 1e-14 && (radius - 2.5).abs() < 1e-14);
        assert_eq!(nearest_circle(&points[..2], None), None);
        assert_eq!(nearest_circle(&[], None), None);
        assert_eq!(
            nearest_circle(&[Point::new(f64::INFINITY, 1.0); 9], None),
            None
        );
    }

    /// The points along the ellipse of a circle's cubics lie four times nearer to an ellipse from a certain ratio on.
    #[test]
    fn an_ellipse_is_meant_where_it_is_much_nearer() {
        let quarter = "M1 0C1 .552 .552 1 0 1C-.552 1 -1 .552 -1 0C-1 -.552 -.552 -1 0 -1";
        for (ratio, is_flat) in [(1.0, false), (0.9995, false), (0.998, true), (0.5, true)] {
            let map = kurbo::Affine::scale_non_uniform(30.0, 30.0 * ratio);
            let (truth, _) = either(&curve(quarter).transformed(map)).unwrap();
            assert_eq!(truth.radii.x != truth.radii.y, is_flat, "{ratio}");
        }
    }

    #[test]
    fn the_points_along_a_symmetric_arc_are_symmetric() {
        let (truth, fit) = circle(&curve("M-3 0C-2 2 2 2 3 0"), Some(FitTo::Curve)).unwrap();
        assert_eq!(fit.points, 64);
        assert!(truth.center.x.abs() < 1e-12, "{:?}", truth.center);
    }

    #[test]
    fn a_point_in_the_centre_pulls_no_way() {
        // By symmetry the centre stays, and the radius is the mean distance.
        let square = [(5.0, 2.0), (4.0, 3.0), (3.0, 2.0), (4.0, 1.0), (4.0, 2.0)];
        let (center, radius) = nearest_circle(&square.map(Point::from), None).unwrap();
        assert_eq!(center, Point::new(4.0, 2.0));
        assert!((radius - 0.8).abs() < 1e-15);
    }
}
