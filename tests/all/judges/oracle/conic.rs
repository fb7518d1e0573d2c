//! True distances of a Bézier segment from the branch of a conic, and both ways.

use super::bezier::Powers;
use super::real::{
    Point, Real, abs, cross, dot, int, norm, power_of_two, ratio, real, sign, to_f64,
};

/// Places at which a nearest point is looked for, and those of which the distance is.
const GRID: u32 = 400;
const PLACES: u32 = 64;

/// A rational quadratic from P0 over P1 of weight w to P2. With U = P0 - P1 and V = P2 - P1 the point at r, from 0 to infinity, lies at
/// (U + r² V)/(1 + 2 w r + r²) from P1.
pub struct Branch {
    origin: Point,
    arms: [Point; 2],
    weight: Real,
}

/// What a search for a nearest point begins with, in `f64`.
struct Rough {
    arms: [[f64; 2]; 2],
    weight: f64,
}

impl Rough {
    fn point(&self, r: f64) -> [f64; 2] {
        let whole = 1.0 + 2.0 * self.weight * r + r * r;
        [0, 1].map(|i| (self.arms[0][i] + r * r * self.arms[1][i]) / whole)
    }

    fn square(&self, q: [f64; 2], r: f64) -> f64 {
        let p = self.point(r);
        (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
    }

    /// The r up to 1 that is nearest, and the square of its distance.
    fn nearest(&self, q: [f64; 2]) -> (f64, f64) {
        let least = 1e-4 / (1.0 + self.weight);
        let place = |s: f64| least * (1.0 / least).powf(s);
        let at = |s: f64| self.square(q, place(s));
        let step = 1.0 / f64::from(GRID);
        let best = (0..=GRID)
            .map(|i| f64::from(i) * step)
            .min_by(|a, b| at(*a).total_cmp(&at(*b)))
            .unwrap();
        let fine = (0..=200).map(|i| best + step * (f64::from(i) / 100.0 - 1.0));
        let best = fine.min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap();
        let (mut low, mut high) = (best - step / 100.0, (best + step / 100.0).min(1.0));
        for _ in 0..60 {
            let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if at(a) < at(b) {
                high = b;
            } else {
                low = a;
            }
        }
        let found = (place(low), at(low));
        let start = (0.0, self.square(q, 0.0));
        if start.1 < found.1 { start } else { found }
    }
}

impl Branch {
    pub fn new([from, control, to]: [Point; 3], weight: Real) -> Self {
        let arm = |p: &Point| [&p[0] - &control[0], &p[1] - &control[1]];
        Self {
            arms: [arm(&from), arm(&to)],
            origin: control,
            weight,
        }
    }

    /// The point at r from one of the ends, 0 the first.
    fn point(&self, end: usize, r: &Real) -> Point {
        let [u, v] = [&self.arms[end], &self.arms[1 - end]];
        let whole = int(1) + int(2) * &self.weight * r + r * r;
        [0, 1].map(|i| &self.origin[i] + (&u[i] + r * r * &v[i]) / &whole)
    }

    /// The signed distance of a point, positive on the control point's side.
    pub fn distance(&self, p: &Point) -> Real {
        let q = [&p[0] - &self.origin[0], &p[1] - &self.origin[1]];
        let plain = |p: &Point| [to_f64(&p[0]), to_f64(&p[1])];
        let rough = [0, 1].map(|end| {
            let arms = [plain(&self.arms[end]), plain(&self.arms[1 - end])];
            let weight = to_f64(&self.weight);
            Rough { arms, weight }.nearest(plain(&q))
        });
        let end = usize::from(rough[1].1 < rough[0].1);
        let [u, v] = [&self.arms[end], &self.arms[1 - end]];
        let w = &self.weight;
        let mut r = real(rough[end].0);
        let less = |a: &Point, b: &Point| [&a[0] - &b[0], &a[1] - &b[1]];
        let (first, last, across) = (less(&q, u), less(&q, v), less(v, u));
        // ((q - U) + 2 w r q + r² (q - V)) · (-w U + r (V - U) + w r² V)
        let value = |r: &Real| {
            let a = |i: usize| &first[i] + int(2) * w * r * &q[i] + r * r * &last[i];
            let b = |i: usize| r * &across[i] + w * r * r * &v[i] - w * &u[i];
            let da = |i: usize| int(2) * w * &q[i] + int(2) * r * &last[i];
            let db = |i: usize| &across[i] + int(2) * w * r * &v[i];
            let (a, b, da, db) = ([a(0), a(1)], [b(0), b(1)], [da(0), da(1)], [db(0), db(1)]);
            (dot(&a, &b), dot(&da, &b) + dot(&a, &db))
        };
        for _ in 0..12 {
            let (value, slope) = value(&r);
            if sign(&slope) == 0 {
                break;
            }
            let step = value / slope;
            if abs(&step) > abs(&r) * ratio(1, 2) + real(0.2) / (int(1) + w) {
                break;
            }
            let is_last = abs(&step) <= power_of_two(-140) * abs(&r);
            r -= step;
            if is_last {
                break;
            }
        }
        let far = |r: &Real| norm(&less(p, &self.point(end, r)));
        // The steps may lead to another place where the distance is stationary.
        let (size, start) = (far(&r), far(&real(rough[end].0)));
        let size = if size < start { size } else { start };
        if self.is_inside(&q) { -size } else { size }
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
        let curve = Powers::new(points);
        let at = |t: f64| self.distance(&curve.at(&real(t)));
        let inner = largest(&at);
        let outer = largest(&|t| -at(t));
        [inner, outer].map(|d| if sign(&d) > 0 { d } else { int(0) })
    }

    /// How far the arc lies from these segments at most, by the digits of `f64`.
    pub fn back(&self, segments: &[Vec<Point>]) -> f64 {
        let about = |p: &Point| [0, 1].map(|i| to_f64(&(&p[i] - &self.origin[i])));
        let cubics: Vec<[[f64; 2]; 4]> = segments
            .iter()
            .map(|points| std::array::from_fn(|i| about(&points[i])))
            .collect();
        let plain = |p: &Point| [to_f64(&p[0]), to_f64(&p[1])];
        let sides = [0, 1].map(|end| Rough {
            arms: [plain(&self.arms[end]), plain(&self.arms[1 - end])],
            weight: to_f64(&self.weight),
        });
        let mut most = 0.0_f64;
        for side in &sides {
            let least = 1e-6 / (1.0 + side.weight);
            most = most.max(peak(&|s| {
                let q = side.point(least * (1.0 / least).powf(s) * f64::from(s > 0.0));
                let each = cubics.iter().map(|cubic| nearest(cubic, q));
                each.fold(f64::INFINITY, f64::min)
            }));
        }
        most.sqrt()
    }
}

fn eval(cubic: &[[f64; 2]; 4], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    [0, 1].map(|i| (0..4).map(|k| weights[k] * cubic[k][i]).sum())
}

/// The square of how far a point lies from a cubic.
fn nearest(cubic: &[[f64; 2]; 4], q: [f64; 2]) -> f64 {
    let at = |t: f64| {
        let p = eval(cubic, t);
        (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
    };
    least(&at, 32)
}

/// The least value on [0, 1] of one with few valleys.
fn least(at: &dyn Fn(f64) -> f64, steps: u32) -> f64 {
    let step = 1.0 / f64::from(steps);
    let (value, best) = (0..=steps)
        .map(|i| (at(f64::from(i) * step), f64::from(i) * step))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap();
    let (mut low, mut high) = ((best - step).max(0.0), (best + step).min(1.0));
    let mut found = value;
    for _ in 0..40 {
        let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
        let (at_a, at_b) = (at(a), at(b));
        found = found.min(at_a).min(at_b);
        if at_a < at_b {
            high = b;
        } else {
            low = a;
        }
    }
    found
}

/// The largest value on [0, 1].
fn peak(at: &dyn Fn(f64) -> f64) -> f64 {
    -least(&|t| -at(t), 400)
}

/// The largest value on [0, 1], from samples on, which crowd at the ends.
fn largest(of: &dyn Fn(f64) -> Real) -> Real {
    let place = |i: u32| {
        let s = f64::from(i) / f64::from(PLACES);
        s * s * (3.0 - 2.0 * s)
    };
    let samples: Vec<Real> = (0..=PLACES).map(|i| of(place(i))).collect();
    let mut order: Vec<usize> = (0..samples.len()).collect();
    order.sort_by(|&i, &j| samples[j].partial_cmp(&samples[i]).unwrap());
    let mut most = samples[order[0]].clone();
    for &top in &order[..3] {
        let near = |i: usize| place(i as u32);
        let (mut low, mut high) = (
            near(top.saturating_sub(1)),
            near((top + 1).min(PLACES as usize)),
        );
        for _ in 0..28 {
            let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            let (at_a, at_b) = (of(a), of(b));
            let larger = if at_a > at_b { &at_a } else { &at_b };
            if *larger > most {
                most.clone_from(larger);
            }
            if at_a > at_b {
                high = b;
            } else {
                low = a;
            }
        }
    }
    most
}
