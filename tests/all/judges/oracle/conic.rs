//! True distances of a Bézier segment from the branch of a conic, and both ways.

use super::along::Search;
use super::bezier::Powers;
use super::real::{Point, Real, cross, int, max, norm, power_of_two, ratio, sign, to_f64};
use super::solve::sign_changes;

/// A rational quadratic from P0 over P1 of weight w to P2. With U = P0 - P1 and V = P2 - P1 the point at r, from 0 to infinity, lies at
/// (U + r² V)/(1 + 2 w r + r²) from P1.
pub struct Branch {
    origin: Point,
    arms: [Point; 2],
    weight: Real,
    rough: [Rough; 2],
    fineness: u32,
}

/// A branch in `f64`.
struct Rough {
    arms: [[f64; 2]; 2],
    weight: f64,
}

impl Rough {
    fn point(&self, r: f64) -> [f64; 2] {
        let whole = 1.0 + 2.0 * self.weight * r + r * r;
        [0, 1].map(|i| (self.arms[0][i] + r * r * self.arms[1][i]) / whole)
    }
}

impl Branch {
    /// The branch; both sides of a sharp tip are told apart by a fineness of 10.
    pub fn new([from, control, to]: [Point; 3], weight: Real, fineness: u32) -> Self {
        let arm = |p: &Point| [&p[0] - &control[0], &p[1] - &control[1]];
        let arms = [arm(&from), arm(&to)];
        let plain = |p: &Point| [to_f64(&p[0]), to_f64(&p[1])];
        let rough = [0, 1].map(|end| {
            let arms = [plain(&arms[end]), plain(&arms[1 - end])];
            let weight = to_f64(&weight);
            Rough { arms, weight }
        });
        Self {
            arms,
            origin: control,
            weight,
            rough,
            fineness,
        }
    }

    /// The point at r from one of the ends, 0 the first, about P1.
    fn point(&self, end: usize, r: &Real) -> Point {
        let [u, v] = [&self.arms[end], &self.arms[1 - end]];
        let whole = int(1) + int(2) * &self.weight * r + r * r;
        [0, 1].map(|i| (&u[i] + r * r * &v[i]) / &whole)
    }

    /// The normal at r to P1's side: square to -w U + r (V - U) + w r² V, and turned to where it leads to P1 at r = 1.
    fn normal(&self, end: usize, r: &Real) -> Point {
        let [u, v] = [&self.arms[end], &self.arms[1 - end]];
        let w = &self.weight;
        let [x, y] = [0, 1].map(|i| r * (&v[i] - &u[i]) + w * (r * r * &v[i] - &u[i]));
        if sign(&cross(u, v)) > 0 {
            [-y, x]
        } else {
            [y, -x]
        }
    }

    /// The signed distance of a point, positive on the control point's side, and the normal towards there at the nearest point.
    fn nearest(&self, p: &Point) -> (Real, Point) {
        let q = less(p, &self.origin);
        let feet = [0, 1].into_iter().flat_map(|end| {
            let feet = self.feet(end, &q).into_iter();
            feet.map(move |r| (end, r))
        });
        let far = |(end, r): (usize, Real)| (norm(&less(&q, &self.point(end, &r))), end, r);
        let nearest = feet.map(far).reduce(|a, b| if b.0 < a.0 { b } else { a });
        let (size, end, r) = nearest.unwrap();
        let signed = if self.is_inside(&q) { -size } else { size };
        (signed, self.normal(end, &r))
    }

    /// Where the distance of a point from the branch can be least, from one of the ends to the middle, and before it as far as the
    /// branch goes: the two bounds, and where ((q - U) + 2 w r q + r² (q - V)) · (-w U + r (V - U) + w r² V) = 0.
    fn feet(&self, end: usize, q: &Point) -> Vec<Real> {
        let [u, v] = [&self.arms[end], &self.arms[1 - end]];
        let w = &self.weight;
        let one = int(1);
        // To where the branch goes to infinity, or half around.
        let before = if *w > one {
            -&one / (w + (w * w - &one).sqrt())
        } else {
            -one.clone()
        };
        // Short of infinity.
        let before = before * (&one - power_of_two(-60));
        let (first, last, across) = (less(q, u), less(q, v), less(v, u));
        let to_foot = [0, 1].map(|i| quadratic([&first[i], &(w * &q[i]), &last[i]], &before));
        let speed = [0, 1].map(|i| {
            let half = &across[i] * ratio(1, 2);
            quadratic([&(-w * &u[i]), &half, &(w * &v[i])], &before)
        });
        let [x, y] = [0, 1].map(|i| product(&to_foot[i], &speed[i]));
        let stationary: Vec<Real> = x.into_iter().zip(y).map(|(x, y)| x + y).collect();
        let within = |s: Real| &before + s * (&one - &before);
        let mut feet: Vec<Real> = sign_changes(&stationary).into_iter().map(within).collect();
        feet.extend([before.clone(), one.clone()]);
        feet
    }

    fn is_inside(&self, q: &Point) -> bool {
        let [u, v] = &self.arms;
        let area = cross(u, v);
        let (a, c) = (cross(q, v) / &area, cross(u, q) / &area);
        let b = int(1) - &a - &c;
        let more = &b * &b - int(4) * &self.weight * &self.weight * &a * &c;
        sign(&a) > 0 && sign(&c) > 0 && sign(&more) < 0
    }

    /// The largest distances of a segment outside and inside the whole branch.
    pub fn extremes(&self, points: &[Point]) -> [Real; 2] {
        let near = |p: &Point| self.nearest(p);
        let distances = Search::new(&Powers::new(points), &near).distances(Vec::new());
        let largest = |of: &dyn Fn(&Real) -> Real| distances.iter().map(of).fold(int(0), max);
        [largest(&Real::clone), largest(&|d| -d)]
    }

    /// How far the arc lies from these segments at most, by the digits of `f64`; without their ends, how far those of its points do that are nearest to
    /// none of these.
    pub fn back(&self, segments: &[Vec<Point>], with_ends: bool) -> f64 {
        let about = |p: &Point| [0, 1].map(|i| to_f64(&(&p[i] - &self.origin[i])));
        let cubics: Vec<[[f64; 2]; 4]> = segments
            .iter()
            .map(|points| raised(points).each_ref().map(about))
            .collect();
        let last = cubics.len() - 1;
        let square = |side: &Rough, s: f64| {
            let least = 1e-6 / (1.0 + side.weight);
            let q = side.point(least * (1.0 / least).powf(s) * f64::from(s > 0.0));
            let each = cubics.iter().enumerate().map(|(i, cubic)| {
                let (t, square) = nearest(cubic, q, 32 * self.fineness.pow(2));
                (square, i == 0 && t == 0.0 || i == last && t == 1.0)
            });
            let nearest = each.reduce(|a, b| if b.0 < a.0 { b } else { a });
            let (square, is_end) = nearest.unwrap();
            if is_end && !with_ends { 0.0 } else { square }
        };
        let peaks = self.rough.iter().map(|side| peak(&|s| square(side, s)));
        peaks.fold(0.0, f64::max).sqrt()
    }
}

fn less(a: &Point, b: &Point) -> Point {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

/// The Bernstein coefficients of a + 2 b r + c r² from a place to 1: its polar form at both, at each and at the other.
fn quadratic([a, b, c]: [&Real; 3], from: &Real) -> [Real; 3] {
    let polar = |r: &Real, s: &Real| a + b * (r + s) + c * (r * s);
    let to = int(1);
    [polar(from, from), polar(from, &to), polar(&to, &to)]
}

/// The Bernstein coefficients of the product of two quadratics.
fn product(p: &[Real; 3], q: &[Real; 3]) -> [Real; 5] {
    [
        &p[0] * &q[0],
        (&p[0] * &q[1] + &p[1] * &q[0]) * ratio(1, 2),
        (&p[0] * &q[2] + int(4) * &p[1] * &q[1] + &p[2] * &q[0]) * ratio(1, 6),
        (&p[1] * &q[2] + &p[2] * &q[1]) * ratio(1, 2),
        &p[2] * &q[2],
    ]
}

/// A cubic's control points, or those of a quadratic as a cubic.
fn raised(points: &[Point]) -> [Point; 4] {
    let third = |a: &Point, b: &Point| [0, 1].map(|i| (&a[i] + int(2) * &b[i]) * ratio(1, 3));
    match points {
        [a, b, c] => [a.clone(), third(a, b), third(c, b), c.clone()],
        _ => std::array::from_fn(|i| points[i].clone()),
    }
}

fn eval(cubic: &[[f64; 2]; 4], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    [0, 1].map(|i| (0..4).map(|k| weights[k] * cubic[k][i]).sum())
}

/// Where a cubic is nearest to a point, and the square of how far it lies from there.
fn nearest(cubic: &[[f64; 2]; 4], q: [f64; 2], steps: u32) -> (f64, f64) {
    let at = |t: f64| {
        let p = eval(cubic, t);
        (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
    };
    valley(&at, steps)
}

/// Where a function on [0, 1] is least, and its value there: every valley of its samples is looked into.
fn valley(at: &dyn Fn(f64) -> f64, steps: u32) -> (f64, f64) {
    let places = (0..=steps).map(|i| f64::from(i) / f64::from(steps));
    let samples: Vec<f64> = places.map(at).collect();
    let step = 1.0 / (samples.len() - 1) as f64;
    let is_low = |i: &usize| {
        let beside = [i.checked_sub(1), Some(i + 1)];
        let mut beside = beside.into_iter().filter_map(|j| samples.get(j?));
        beside.all(|other| *other >= samples[*i])
    };
    let mut found = (0.0, samples[0]);
    for i in (0..samples.len()).filter(is_low) {
        let best = i as f64 * step;
        let (mut low, mut high) = ((best - step).max(0.0), (best + step).min(1.0));
        let mut take = |t: f64| {
            let value = at(t);
            if value < found.1 {
                found = (t, value);
            }
            value
        };
        take(best);
        for _ in 0..60 {
            let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if take(a) < take(b) {
                high = b;
            } else {
                low = a;
            }
        }
    }
    found
}

/// The largest value on [0, 1].
fn peak(at: &dyn Fn(f64) -> f64) -> f64 {
    -valley(&|t| -at(t), 400).1
}
