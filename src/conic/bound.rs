//! A bound on the distance of a curve from a conic that none of its points exceeds.
//!
//! Where a part of a curve, moved by a vector no longer than E that changes along it, lies wholly in the region that the branch bounds, none
//! of its points is farther outside than E; where it then lies wholly out of it, none is farther inside. E times the normals at the nearest
//! points of both ends and of the middle, as a quadratic, is such a vector. What lies where is told by Bernstein coefficients, formed in
//! numbers of 106 bits, so that it does not matter how the normals were found: bad ones prove nothing.

use std::collections::VecDeque;

use kurbo::{PathSeg, Vec2};

use super::branch::{Branch, BranchPlace, Cubic, arm};
use super::frame::ConicFrame;
use crate::curve::largest_coordinate;
use crate::numeric::double::{Double, Twice};
use crate::radial_error::RadialError;

/// How far above the largest distance that is found its bound may lie, as a part of it.
pub(super) const SLACK: f64 = 0.9e-9;

/// How often a part is halved at most, and how many parts of a side are, beside some for each segment, for a statement and for a tolerance:
/// what is left is bounded roughly.
const MOST_CUTS: u32 = 56;
const MOST_PARTS: usize = 2_000;
pub(super) const MOST_FOR_TOLERANCE: usize = 200;

/// How many places of a segment are looked at first.
const FIRST: u32 = 12;

/// A part of a curve, with what is known of its ends.
struct CurvePart {
    points: Cubic,
    ends: [BranchPlace; 2],
    cuts: u32,
}

/// Bounds the largest distances of these segments outside and inside; beyond a limit it may be any that is beyond.
pub(super) fn bound(
    branch: &Branch,
    frame: &ConicFrame,
    segments: &[PathSeg],
    limit: Option<f64>,
) -> RadialError {
    let unit = branch.unit;
    let search = CurveSearch {
        branch,
        frame,
        limit: limit.map_or(f64::INFINITY, |limit| limit / unit),
        floor: floor(segments) / unit,
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

/// A unit in the last place of the largest coordinate.
pub(super) fn floor(segments: &[PathSeg]) -> f64 {
    let largest = largest_coordinate(segments);
    largest.next_up() - largest
}

struct CurveSearch<'a> {
    branch: &'a Branch,
    frame: &'a ConicFrame,
    limit: f64,
    /// Below it no distance that is one is stated.
    floor: f64,
}

impl CurveSearch<'_> {
    fn place(&self, q: &Twice) -> BranchPlace {
        self.branch.place(self.frame, q)
    }

    /// Beginning with a bound that need not hold.
    fn side(&self, cubics: &[Cubic], sign: f64, mut bound: f64) -> f64 {
        let least = self.branch.noise();
        let mut pending = VecDeque::new();
        for cubic in cubics {
            let ends = [cubic[0], cubic[3]].map(|q| self.place(&q));
            if self.limit.is_infinite() {
                let distance = self.farthest(cubic, sign);
                if distance > least {
                    bound = bound.max(self.floor).max(distance);
                }
            }
            pending.push_back(CurvePart {
                points: *cubic,
                ends,
                cuts: MOST_CUTS,
            });
        }
        let most = if self.limit.is_finite() {
            MOST_FOR_TOLERANCE
        } else {
            MOST_PARTS
        };
        let mut left = most + 64 * cubics.len();
        while let Some(part) = pending.pop_front() {
            let [first, second] = halves(&part.points);
            let middle = self.place(&second[0]);
            let [from, to] = part.ends;
            let places = [from, middle, to];
            for place in places {
                let distance = sign * place.distance;
                if distance > least {
                    bound = bound.max(self.floor).max(distance * (1.0 + SLACK));
                }
            }
            if bound > self.limit {
                return bound;
            }
            if self.is_within(&part.points, &places, sign, bound) {
                continue;
            }
            if part.cuts == 0 || left == 0 {
                bound = bound.max(self.roughly(&part.points, &places, sign));
                continue;
            }
            left -= 1;
            let cuts = part.cuts - 1;
            let half = |points, ends| CurvePart { points, ends, cuts };
            pending.push_back(half(first, [from, middle]));
            pending.push_back(half(second, [middle, to]));
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
    fn is_within(&self, points: &Cubic, places: &[BranchPlace; 3], sign: f64, most: f64) -> bool {
        if sign > 0.0 && reached(points, places) <= most {
            return true;
        }
        let [from, middle, to] = places.map(|place| place.normal);
        if self.lets(points, [from, middle, to], sign, most) {
            return true;
        }
        if from.dot(to) < 0.5 && self.lets(points, [middle; 3], sign, most) {
            return true;
        }
        // Not farther than is needed, nor than the middle of the region.
        let length = longest(points);
        let steps = places.map(|place| {
            let near = (sign * place.distance).max(0.0);
            let mut depth = near + (most - near).max(0.0).min(2.0 * length) / 2.0;
            if sign > 0.0 {
                depth = depth.min(f64::midpoint(place.distance, place.again).max(0.0));
            }
            place.normal * (depth / most)
        });
        self.lets(points, steps, sign, most)
            || (sign < 0.0 && self.roughly(points, places, sign) <= most)
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
    fn roughly(&self, points: &Cubic, places: &[BranchPlace; 3], sign: f64) -> f64 {
        let from = |p: Twice| {
            points
                .iter()
                .map(|q| arm(&p, q).hypot())
                .fold(0.0, f64::max)
        };
        let rough = if sign > 0.0 {
            reached(points, places)
        } else {
            let rim = places.iter().filter_map(|place| self.branch.outside(place));
            rim.map(from).fold(f64::INFINITY, f64::min)
        };
        // An end of the arc lies in the region, and on its rim.
        rough.min(from(self.branch.arms[0])) * (1.0 + 16.0 * f64::EPSILON)
    }
}

/// How far the points of a part are from the region at most, by points of it: those between two of them are in it as well.
fn reached(points: &Cubic, places: &[BranchPlace; 3]) -> f64 {
    let inside = places.map(|place| place.inside);
    let far = |q: &Twice| {
        let [from, middle, to] = inside.map(|p| p.map(|p| arm(&p, q)));
        let between = |p: Option<Vec2>, q: Option<Vec2>| match (p, q) {
            (Some(p), Some(q)) => {
                let way = q - p;
                let part = (-p.dot(way) / way.hypot2()).clamp(0.0, 1.0);
                let rounding = 8.0 * f64::EPSILON * (p.hypot() + q.hypot());
                p.lerp(q, if part.is_nan() { 0.0 } else { part }).hypot() + rounding
            }
            (Some(p), None) | (None, Some(p)) => p.hypot(),
            (None, None) => f64::INFINITY,
        };
        between(from, middle)
            .min(between(middle, to))
            .min(between(from, to))
    };
    let farthest = points.iter().map(far).fold(0.0, f64::max);
    farthest * (1.0 + 16.0 * f64::EPSILON)
}

/// How far the control points lie from the first.
fn longest(points: &Cubic) -> f64 {
    let [start, rest @ ..] = points;
    rest.iter()
        .map(|q| arm(q, start).hypot())
        .fold(0.0, f64::max)
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
pub(super) fn at(points: &Cubic, t: f64) -> Twice {
    blossom(points, [t, t, t])
}

/// The part from one parameter to another, by blossoms.
pub(super) fn piece(points: &Cubic, [from, to]: [f64; 2]) -> Cubic {
    if from == to {
        return [at(points, from); 4];
    }
    [
        [from, from, from],
        [from, from, to],
        [from, to, to],
        [to, to, to],
    ]
    .map(|times| blossom(points, times))
}

fn blossom([a, b, c, d]: &Cubic, [r, s, t]: [f64; 3]) -> Twice {
    let step = |u: &Twice, v: &Twice, t: f64| -> Twice {
        let rest = Double::difference(1.0, t);
        [0, 1].map(|i| u[i].times(rest).plus(v[i].scaled(t)))
    };
    let (ab, bc, cd) = (step(a, b, r), step(b, c, r), step(c, d, r));
    let (abc, bcd) = (step(&ab, &bc, s), step(&bc, &cd, s));
    step(&abc, &bcd, t)
}
