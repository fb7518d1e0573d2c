//! A bound on the distance of a curve from a conic that none of its points exceeds.
//!
//! Where a part of a curve, moved by a vector no longer than E that changes along it, lies wholly in the region that the branch bounds, none
//! of its points is farther outside than E; where it then lies wholly out of it, none is farther inside. E times the normals at the nearest
//! points of both ends and of the middle, as a quadratic, is such a vector. What lies where is told by Bernstein coefficients, formed in
//! numbers of 106 bits, so that it does not matter how the normals were found: bad ones prove nothing.

use kurbo::{PathSeg, Vec2};

use super::branch::{Branch, Cubic, Place, less};
use super::frame::Frame;
use crate::numeric::double::{Double, Twice};
use crate::radial_error::RadialError;

/// How far above the largest distance that is found its bound may lie, as a part of it.
pub(super) const SLACK: f64 = 0.9e-9;

/// How often a part is halved at most, and how many parts of a side are: what is left is bounded roughly.
const MOST_CUTS: u32 = 56;
const MOST_PARTS: usize = 20_000;

/// How many places of a segment are looked at first.
const FIRST: u32 = 12;

/// How far into the region a point beside it is moved, as a part of its distance from P1.
const BESIDE: f64 = 512.0 * f64::EPSILON;

/// A part of a curve, with what is known of its ends.
struct Part {
    points: Cubic,
    ends: [Place; 2],
    cuts: u32,
}

/// Bounds the largest distances of these segments outside and inside; beyond a limit it may be any that is beyond.
pub(super) fn bound(
    branch: &Branch,
    frame: &Frame,
    segments: &[PathSeg],
    limit: Option<f64>,
) -> RadialError {
    let unit = branch.unit;
    let search = Search {
        branch,
        frame,
        bend: frame.largest_curvature(),
        limit: limit.map_or(f64::INFINITY, |limit| limit / unit),
    };
    let cubics: Vec<Cubic> = segments.iter().map(|s| branch.cubic(s)).collect();
    let least = branch.noise();
    let side = |sign: f64| {
        let bound = search.side(
            &cubics,
            sign,
            limit.map_or(0.0, |limit| limit / unit - least).max(least),
        );
        if bound > least {
            (bound + least) * unit
        } else {
            0.0
        }
    };
    RadialError {
        outward: side(1.0),
        inward: side(-1.0),
    }
}

struct Search<'a> {
    branch: &'a Branch,
    frame: &'a Frame,
    /// The largest curvature of the arc.
    bend: f64,
    limit: f64,
}

impl Search<'_> {
    fn place(&self, q: &Twice) -> Place {
        self.branch.place(self.frame, q, self.bend)
    }

    /// Beginning with a bound that need not hold.
    fn side(&self, cubics: &[Cubic], sign: f64, mut bound: f64) -> f64 {
        let mut pending = Vec::new();
        for cubic in cubics {
            let ends = [cubic[0], cubic[3]].map(|q| self.place(&q));
            if self.limit.is_infinite() {
                bound = bound.max(self.farthest(cubic, sign));
            }
            pending.push(Part {
                points: *cubic,
                ends,
                cuts: MOST_CUTS,
            });
        }
        let mut left = MOST_PARTS + 64 * cubics.len();
        while let Some(part) = pending.pop() {
            let [first, second] = halves(&part.points);
            let middle = self.place(&second[0]);
            let [from, to] = part.ends;
            let places = [from, middle, to];
            for place in places {
                bound = bound.max(sign * place.distance * (1.0 + SLACK));
            }
            if bound > self.limit {
                return bound;
            }
            if self.is_within(&part.points, places, sign, bound) {
                continue;
            }
            if part.cuts == 0 || left == 0 {
                bound = self.roughly(&part.points, middle, sign, bound);
                continue;
            }
            left -= 1;
            let cuts = part.cuts - 1;
            let half = |points, ends| Part { points, ends, cuts };
            pending.push(half(first, [from, middle]));
            pending.push(half(second, [middle, to]));
        }
        bound
    }

    /// The farthest of some places.
    fn farthest(&self, cubic: &Cubic, sign: f64) -> f64 {
        let distance = |i: u32| {
            let q = at(cubic, f64::from(i) / f64::from(FIRST));
            sign * self.place(&q).distance
        };
        (1..FIRST).map(distance).fold(0.0, f64::max)
    }

    /// Whether no point of a part is farther than that on a side, as far as a few vectors tell.
    fn is_within(&self, points: &Cubic, places: [Place; 3], sign: f64, most: f64) -> bool {
        let [from, middle, to] = places.map(|place| place.normal);
        if self.lets(points, [from, middle, to], sign, most) {
            return true;
        }
        if from.dot(to) < 0.5 && self.lets(points, [middle; 3], sign, most) {
            return true;
        }
        // Not farther than is needed, since a region may be thin.
        let length = longest(points);
        let steps = places.map(
            |Place {
                 normal, distance, ..
             }| {
                let near = (sign * distance).max(0.0);
                normal * ((near + (most - near).max(0.0).min(2.0 * length) / 2.0) / most)
            },
        );
        self.lets(points, steps, sign, most) || (sign > 0.0 && self.reaches(points, places, most))
    }

    /// The same outside, by points of the region: those between two of them are as well.
    fn reaches(&self, points: &Cubic, [from, _, to]: [Place; 3], most: f64) -> bool {
        let [u, v] = self
            .branch
            .arms
            .map(|[x, y]| Vec2::new(x.value(), y.value()));
        let inward = |near: Vec2| ((u + v) / 2.0 - near).normalize();
        let [start, end] =
            [from, to].map(|Place { near, .. }| near + BESIDE * near.hypot() * inward(near));
        if !(self.branch.holds(start) && self.branch.holds(end)) {
            return false;
        }
        let arms: [Vec2; 4] = core::array::from_fn(|i| {
            let near = start.lerp(end, i as f64 / 3.0);
            let q = points[i];
            Vec2::new(
                less(q[0], Double::of(near.x)).value(),
                less(q[1], Double::of(near.y)).value(),
            )
        });
        let allowed = most * (1.0 - 16.0 * f64::EPSILON);
        arms.iter().all(|arm| arm.hypot() <= allowed)
    }

    /// The same by a quadratic vector with these values at the ends and in the middle, each 1 where it is the longest that it may be.
    fn lets(&self, points: &Cubic, [from, middle, to]: [Vec2; 3], sign: f64, most: f64) -> bool {
        let inner = 2.0 * middle - (from + to) / 2.0;
        let squares = [
            from.hypot2(),
            from.dot(inner),
            (from.dot(to) + 2.0 * inner.hypot2()) / 3.0,
            inner.dot(to),
            to.hypot2(),
        ];
        let largest = squares.into_iter().fold(1.0, f64::max).sqrt();
        let scale = -sign * most / largest * (1.0 - 16.0 * f64::EPSILON);
        let steps = [
            from,
            (from + 2.0 * inner) / 3.0,
            (2.0 * inner + to) / 3.0,
            to,
        ];
        let mut moved = *points;
        for (q, step) in moved.iter_mut().zip(steps) {
            let step = step * scale;
            *q = [q[0].plus(Double::of(step.x)), q[1].plus(Double::of(step.y))];
        }
        self.branch.lies(&moved, sign > 0.0)
    }

    /// A bound that is larger by as little as a part is long, or so.
    fn roughly(&self, points: &Cubic, middle: Place, sign: f64, mut bound: f64) -> f64 {
        let mut step = longest(points).max(SLACK * bound);
        while bound.is_finite() && !self.is_within(points, [middle; 3], sign, bound) {
            bound += step;
            step *= 2.0;
        }
        bound
    }
}

/// How far the control points lie from the first.
fn longest(points: &Cubic) -> f64 {
    let [start, rest @ ..] = points;
    let arm = |q: &Twice| Vec2::new(less(q[0], start[0]).value(), less(q[1], start[1]).value());
    rest.iter().map(|q| arm(q).hypot()).fold(0.0, f64::max)
}

/// De Casteljau's algorithm at 1/2.
fn halves(points: &Cubic) -> [Cubic; 2] {
    let middle = |u: Twice, v: Twice| [0, 1].map(|i| u[i].plus(v[i]).scaled(0.5));
    let [a, b, c, d] = *points;
    let (ab, bc, cd) = (middle(a, b), middle(b, c), middle(c, d));
    let (abc, bcd) = (middle(ab, bc), middle(bc, cd));
    let all = middle(abc, bcd);
    [[a, ab, abc, all], [all, bcd, cd, d]]
}

/// The point at t.
fn at(points: &Cubic, t: f64) -> Twice {
    piece(points, [t, t])[0]
}

/// The part from one parameter to another, by blossoms.
pub(super) fn piece(points: &Cubic, [from, to]: [f64; 2]) -> Cubic {
    let step = |u: &Twice, v: &Twice, t: f64| -> Twice {
        let rest = Double::difference(1.0, t);
        [0, 1].map(|i| u[i].times(rest).plus(v[i].scaled(t)))
    };
    let [a, b, c, d] = points;
    let blossom = |r: f64, s: f64, t: f64| {
        let (ab, bc, cd) = (step(a, b, r), step(b, c, r), step(c, d, r));
        let (abc, bcd) = (step(&ab, &bc, s), step(&bc, &cd, s));
        step(&abc, &bcd, t)
    };
    [
        blossom(from, from, from),
        blossom(from, from, to),
        blossom(from, to, to),
        blossom(to, to, to),
    ]
}
