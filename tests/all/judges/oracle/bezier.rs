//! What is measured on a Bézier segment: extreme distances from a circle, length, area, means,
//! curvature. Every function takes the control points of a segment of any degree.

use super::real::{Point, Real, abs, cross, dot, int, max, norm, power_of_two, ratio, sign};
use super::solve::{bernstein_value, integrate, sign_changes};

/// A plane curve by the coefficients of its powers of t, lowest first.
pub struct Powers {
    x: Vec<Real>,
    y: Vec<Real>,
}

impl Powers {
    /// Coefficient j is `C(n, j)` times the j-th forward difference of the control points.
    pub fn new(points: &[Point]) -> Self {
        let axis = |i: usize| {
            let mut row: Vec<Real> = points.iter().map(|p| p[i].clone()).collect();
            let n = row.len() - 1;
            let mut coefficients = Vec::with_capacity(n + 1);
            for j in 0..=n {
                coefficients.push(&row[0] * int(binomial(n, j)));
                row = row.windows(2).map(|w| &w[1] - &w[0]).collect();
            }
            coefficients
        };
        Self {
            x: axis(0),
            y: axis(1),
        }
    }

    /// The derivative by t.
    pub fn derivative(&self) -> Self {
        Self {
            x: differentiate(&self.x),
            y: differentiate(&self.y),
        }
    }

    /// The point at t.
    pub fn at(&self, t: &Real) -> Point {
        [horner(&self.x, t), horner(&self.y, t)]
    }

    /// The polynomial `x_1 y_2 - y_1 x_2` of two curves.
    fn cross(&self, other: &Self) -> Vec<Real> {
        let (p, q) = (multiply(&self.x, &other.y), multiply(&self.y, &other.x));
        p.iter().zip(&q).map(|(p, q)| p - q).collect()
    }

    /// The polynomial `x^2 + y^2`.
    fn square(&self) -> Vec<Real> {
        let (p, q) = (multiply(&self.x, &self.x), multiply(&self.y, &self.y));
        p.iter().zip(&q).map(|(p, q)| p + q).collect()
    }
}

fn binomial(n: usize, k: usize) -> usize {
    (0..k).fold(1, |product, i| product * (n - i) / (i + 1))
}

fn horner(coefficients: &[Real], t: &Real) -> Real {
    coefficients.iter().rev().fold(int(0), |sum, c| sum * t + c)
}

fn differentiate(coefficients: &[Real]) -> Vec<Real> {
    let terms = coefficients.iter().enumerate().skip(1);
    terms.map(|(j, c)| c * int(j)).collect()
}

fn multiply(p: &[Real], q: &[Real]) -> Vec<Real> {
    let mut product = vec![int(0); (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// Bernstein coefficients of `|p - center|^2 - radius^2`, of twice the degree of the curve.
fn squared_excess(points: &[Point], center: &Point, radius: &Real) -> Vec<Real> {
    let n = points.len() - 1;
    let arms: Vec<Point> = points
        .iter()
        .map(|p| [&p[0] - &center[0], &p[1] - &center[1]])
        .collect();
    let coefficient = |k: usize| {
        let mut sum = int(0);
        for i in k.saturating_sub(n)..=k.min(n) {
            let weight = binomial(n, i) * binomial(n, k - i);
            sum += dot(&arms[i], &arms[k - i]) * int(weight);
        }
        sum / int(binomial(2 * n, k)) - radius * radius
    };
    (0..=2 * n).map(coefficient).collect()
}

/// Largest and smallest value of `|p|^2 - 1` on the segment.
pub fn squared_extremes(points: &[Point]) -> (Real, Real) {
    extremes(&squared_excess(points, &[int(0), int(0)], &int(1)))
}

/// The largest and the smallest value of a polynomial on 0..=1, from the roots of its derivative.
fn extremes(coefficients: &[Real]) -> (Real, Real) {
    let slopes: Vec<Real> = coefficients.windows(2).map(|w| &w[1] - &w[0]).collect();
    let mut values = vec![
        coefficients[0].clone(),
        coefficients[coefficients.len() - 1].clone(),
    ];
    for t in sign_changes(&slopes) {
        values.push(bernstein_value(coefficients, &t));
    }
    let (mut high, mut low) = (values[0].clone(), values[0].clone());
    for value in values {
        if value > high {
            high = value;
        } else if value < low {
            low = value;
        }
    }
    (high, low)
}

/// How far a segment leaves a circle: the largest distance outside and the largest inside, both
/// at least 0, and 0 if below 2^-240 of the radius, which is rounding.
///
/// The extremes of the distance from the center lie at the ends and where `|p|^2` is stationary,
/// that is at the roots of a polynomial of degree 5 (3 for a quadratic); then
/// `r - R = (r^2 - R^2) / (r + R)`.
pub fn radial_extremes(points: &[Point], center: Point, radius: &Real) -> (Real, Real) {
    let [x, y] = center;
    let (high, low) = extremes(&squared_excess(points, &[x, y], radius));
    let distance = |excess: Real| {
        // At the center itself rounding may leave the square of r below 0.
        let square = max(&excess + radius * radius, int(0));
        excess / (square.sqrt() + radius)
    };
    let rounding = radius * power_of_two(-240);
    let above = |d: Real| if d > rounding { d } else { int(0) };
    (above(distance(high)), above(-distance(low)))
}

/// The places where the curve crosses the unit circle, with 0 before them and 1 after them.
/// Crossings nearer than 2^-70 to the one before or to an end are left out: nothing is lost by it,
/// since the distance from the circle is all but 0 in between.
pub fn unit_circle_crossings(points: &[Point]) -> Vec<Real> {
    let near = power_of_two(-70);
    let mut places = vec![int(0)];
    for t in sign_changes(&squared_excess(points, &[int(0), int(0)], &int(1))) {
        if &t - &places[places.len() - 1] > near && int(1) - &t > near {
            places.push(t);
        }
    }
    places.push(int(1));
    places
}

/// `r - 1`.
fn radial_error(p: &Point) -> Real {
    let square = dot(p, p);
    (&square - int(1)) / (square.sqrt() + int(1))
}

/// The length of the segment.
pub fn arc_length(points: &[Point]) -> Real {
    let velocity = Powers::new(points).derivative();
    integrate(&|t| norm(&velocity.at(t)), &int(0), &int(1))
}

/// The area between the curve and the origin, half the integral of `p x p'`: exact, being that of
/// a polynomial. Counter-clockwise is positive.
pub fn sector_area(points: &[Point]) -> Real {
    let p = Powers::new(points);
    let terms = p.cross(&p.derivative());
    let parts = terms.iter().enumerate();
    parts.fold(int(0), |sum, (j, c)| sum + c / int(j + 1)) * ratio(1, 2)
}

/// The mean of `|r - 1|` over the parameter.
pub fn mean_abs_radial_error_t(points: &[Point]) -> Real {
    let p = Powers::new(points);
    sum_of_abs(points, &|t| radial_error(&p.at(t)))
}

/// The mean of `|r - 1|` over the angle at the center; the curve must turn one way about it.
pub fn mean_abs_radial_error_angle(points: &[Point]) -> Real {
    let p = Powers::new(points);
    let velocity = p.derivative();
    let turning = |t: &Real| {
        let point = p.at(t);
        cross(&point, &velocity.at(t)) / dot(&point, &point)
    };
    let total = integrate(&turning, &int(0), &int(1));
    sum_of_abs(points, &|t| radial_error(&p.at(t)) * turning(t)) / abs(&total)
}

/// The integral of `|f|` over the parameter, for an `f` that changes sign on the unit circle only.
fn sum_of_abs(points: &[Point], f: &dyn Fn(&Real) -> Real) -> Real {
    let places = unit_circle_crossings(points);
    let parts = places.windows(2);
    parts.fold(int(0), |sum, w| sum + abs(&integrate(f, &w[0], &w[1])))
}

/// The root of the mean of `(r - 1)^2` over the parameter.
pub fn rms_radial_error_t(points: &[Point]) -> Real {
    let p = Powers::new(points);
    let square = |t: &Real| {
        let error = radial_error(&p.at(t));
        &error * &error
    };
    integrate(&square, &int(0), &int(1)).sqrt()
}

/// The signed curvature and its derivatives by arc length, orders 0 to `order`, at the start or
/// the end of a segment, in the direction of travel both times.
///
/// `kappa = (p' x p'') / |p'|^3` and `d/ds = |p'|^-1 d/dt` in power series about the end. The speed
/// there must not be 0.
pub fn curvature_derivatives(points: &[Point], at_end: bool, order: usize) -> Vec<Real> {
    // Turned about, the segment starts at its end: the curvature changes its sign, and so does s.
    let mut from: Vec<Point> = points.to_vec();
    if at_end {
        from.reverse();
    }
    let velocity = Powers::new(&from).derivative();
    let squared_speed = velocity.square();
    let bending = velocity.cross(&velocity.derivative());
    let terms = order + 1;
    let per_speed = inverse_half_power(&squared_speed, 1, terms);
    let mut series = multiply(&bending, &inverse_half_power(&squared_speed, 3, terms));
    let mut values = Vec::with_capacity(terms);
    for j in 0..terms {
        let value = series.first().cloned().unwrap_or_else(|| int(0));
        let turned = at_end && j % 2 == 0;
        values.push(if turned { -value } else { value });
        series = multiply(&differentiate(&series), &per_speed);
        series.truncate(terms);
    }
    values
}

/// The first terms of `f^(-k/2)` for a series f whose first term is positive: from
/// `f g' = e f' g` for `g = f^e`, `n f_0 g_n = sum over j = 1..n of (e j - n + j) f_j g_(n-j)`.
fn inverse_half_power(f: &[Real], k: usize, terms: usize) -> Vec<Real> {
    assert!(sign(&f[0]) > 0, "the speed is 0 at the end");
    let root = f[0].sqrt();
    let mut g = vec![(0..k).fold(int(1), |product, _| product / &root)];
    for n in 1..terms {
        let mut sum = int(0);
        for j in 1..=n.min(f.len() - 1) {
            let weight = int(k * j) * ratio(-1, 2) - int(n - j);
            sum += weight * &f[j] * &g[n - j];
        }
        g.push(sum / (&f[0] * int(n)));
    }
    g
}
