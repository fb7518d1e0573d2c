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
    rough: [Rough; 2],
    fineness: u32,
}

/// What a search for a nearest point begins with, in `f64`.
struct Rough {
    arms: [[f64; 2]; 2],
    weight: f64,
    /// The points at the places.
    grid: Vec<[f64; 2]>,
}

impl Rough {
    fn new(arms: [[f64; 2]; 2], weight: f64, fineness: u32) -> Self {
        let mut rough = Self {
            arms,
            weight,
            grid: Vec::new(),
        };
        let steps = GRID * fineness;
        let places = (0..=steps).map(|i| rough.place(f64::from(i) / f64::from(steps)));
        rough.grid = places.map(|r| rough.point(r)).collect();
        rough
    }

    /// From the first place on, by ratios.
    fn place(&self, s: f64) -> f64 {
        let first = self.first();
        first * (1.0 / first).powf(s)
    }

    fn first(&self) -> f64 {
        1e-4 / (1.0 + self.weight)
    }

    fn point(&self, r: f64) -> [f64; 2] {
        let whole = 1.0 + 2.0 * self.weight * r + r * r;
        [0, 1].map(|i| (self.arms[0][i] + r * r * self.arms[1][i]) / whole)
    }

    fn square(&self, q: [f64; 2], r: f64) -> f64 {
        square(self.point(r), q)
    }

    /// The r up to 1 that is nearest, before the start too, and the square of its distance.
    fn nearest(&self, q: [f64; 2]) -> (f64, f64) {
        let (w, first) = (self.weight, self.first());
        // Before the start up to where the branch goes to infinity or half around; evenly up to the first place; then by ratios.
        let before = if w > 1.0 {
            1.0 / (w + (w * w - 1.0).sqrt())
        } else {
            1.0
        };
        let before = |s: f64| -0.9 * before * s * s;
        let near = |s: f64| s * first;
        let far = |s: f64| self.place(s);
        let on_grid: Vec<f64> = self.grid.iter().map(|p| square(*p, q)).collect();
        let found = [
            at(&before, valley(&|s| self.square(q, before(s)), 40)),
            at(&near, valley(&|s| self.square(q, near(s)), 8)),
            at(&far, valley_of(&|s| self.square(q, far(s)), &on_grid)),
        ];
        found
            .into_iter()
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap()
    }
}

fn at(place: &dyn Fn(f64) -> f64, (s, value): (f64, f64)) -> (f64, f64) {
    (place(s), value)
}

fn square(p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
}

impl Branch {
    /// The branch; both sides of a sharp tip are told apart by a fineness of 10.
    pub fn new([from, control, to]: [Point; 3], weight: Real, fineness: u32) -> Self {
        let arm = |p: &Point| [&p[0] - &control[0], &p[1] - &control[1]];
        let arms = [arm(&from), arm(&to)];
        let plain = |p: &Point| [to_f64(&p[0]), to_f64(&p[1])];
        let rough = [0, 1].map(|end| {
            let arms = [plain(&arms[end]), plain(&arms[1 - end])];
            Rough::new(arms, to_f64(&weight), fineness)
        });
        Self {
            arms,
            origin: control,
            weight,
            rough,
            fineness,
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
        let rough = [0, 1].map(|end: usize| self.rough[end].nearest(plain(&q)));
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
        let mut most = 0.0_f64;
        for side in &self.rough {
            let least = 1e-6 / (1.0 + side.weight);
            most = most.max(peak(&|s| {
                let q = side.point(least * (1.0 / least).powf(s) * f64::from(s > 0.0));
                let each = cubics
                    .iter()
                    .map(|cubic| nearest(cubic, q, 32 * self.fineness.pow(2)));
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
fn nearest(cubic: &[[f64; 2]; 4], q: [f64; 2], steps: u32) -> f64 {
    let at = |t: f64| {
        let p = eval(cubic, t);
        (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
    };
    valley(&at, steps).1
}

/// Where a function on [0, 1] is least, and its value there: every valley of its samples is looked into.
fn valley(at: &dyn Fn(f64) -> f64, steps: u32) -> (f64, f64) {
    let places = (0..=steps).map(|i| f64::from(i) / f64::from(steps));
    valley_of(at, &places.map(at).collect::<Vec<_>>())
}

fn valley_of(at: &dyn Fn(f64) -> f64, samples: &[f64]) -> (f64, f64) {
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
