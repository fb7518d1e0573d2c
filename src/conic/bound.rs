//! A bound on the distance of a curve from a conic that none of its points exceeds.
//!
//! Where a part of a curve, moved by a vector no longer than E that changes along it, lies wholly in the region that the branch bounds, none
//! of its points is farther outside than E; where it then lies wholly out of it, none is farther inside. E times the normals at the nearest
//! points of both ends and of the middle, as a quadratic, is such a vector. What lies where is told by Bernstein coefficients, formed in
//! numbers of 106 bits, so that it does not matter how the normals were found: bad ones prove nothing.

use kurbo::{PathSeg, Vec2};

use super::branch::{Branch, BranchPlace, Cubic, arm};
use super::frame::ConicFrame;
use super::halving::{Bounds, Halving};
use crate::curve::largest_coordinate;
use crate::numeric::double::{Double, Twice};
use crate::radial_error::RadialError;

/// How often a part is halved at most, and how many parts of a side are, beside some for each segment.
const MOST_CUTS: u32 = 56;
const MOST_PARTS: usize = 2_000;

/// How many places of a segment are looked at first.
const FIRST: u32 = 12;

/// A part of a curve, with what is known of its ends.
struct CurvePart {
    points: Cubic,
    ends: [BranchPlace; 2],
}

/// Bounds the largest distances of these segments outside and inside; beyond a limit it may be any that is beyond.
pub(super) fn bound(
    branch: &Branch,
    frame: &ConicFrame,
    segments: &[PathSeg],
    limit: Option<f64>,
) -> RadialError {
    let unit = branch.unit;
    let cubics: Vec<Cubic> = segments.iter().map(|s| branch.cubic(s)).collect();
    let least = branch.noise();
    let bounds = Bounds {
        least,
        floor: floor(segments) / unit,
        limit: limit.map_or(f64::INFINITY, |limit| limit / unit),
        most_cuts: MOST_CUTS,
        most_parts: MOST_PARTS,
    };
    let side = |sign: f64| {
        let search = CurveSearch {
            branch,
            frame,
            sign,
        };
        let mut start = limit.map_or(0.0, |limit| limit / unit - least).max(least);
        if bounds.limit.is_infinite() {
            let farthest = cubics.iter().map(|cubic| search.farthest(cubic));
            for distance in farthest.filter(|&distance| distance > least) {
                start = start.max(bounds.floor).max(distance);
            }
        }
        let parts = cubics.iter().map(|cubic| CurvePart {
            points: *cubic,
            ends: [cubic[0], cubic[3]].map(|q| search.place(&q)),
        });
        let bound = bounds.bound(&search, parts, cubics.len(), start);
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

/// The distances on one side: 1 is outside, -1 inside.
struct CurveSearch<'a> {
    branch: &'a Branch,
    frame: &'a ConicFrame,
    sign: f64,
}

impl CurveSearch<'_> {
    fn place(&self, q: &Twice) -> BranchPlace {
        self.branch.place(self.frame, q)
    }

    /// The farthest of some places.
    fn farthest(&self, cubic: &Cubic) -> f64 {
        let distance = |i: u32| {
            let q = at(cubic, f64::from(i) / f64::from(FIRST));
            self.distance(&self.place(&q))
        };
        (1..FIRST).map(distance).fold(0.0, f64::max)
    }

    /// The same by a quadratic vector with these values at the ends and in the middle, each 1 where it is the longest that it may be.
    fn lets(&self, points: &Cubic, [from, middle, to]: [Vec2; 3], most: f64) -> bool {
        let inner = 2.0 * middle - (from + to) / 2.0;
        let squares = [
            from.hypot2(),
            from.dot(inner),
            (from.dot(to) + 2.0 * inner.hypot2()) / 3.0,
            inner.dot(to),
            to.hypot2(),
        ];
        let largest = squares.into_iter().fold(1.0, f64::max).sqrt();
        let scale = -self.sign * most / largest * (1.0 - 16.0 * f64::EPSILON);
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
        self.branch.lies(&moved, self.sign > 0.0)
    }
}

impl Halving for CurveSearch<'_> {
    type Part = CurvePart;
    type Place = BranchPlace;

    fn halves(&self, part: &CurvePart) -> ([CurvePart; 2], [BranchPlace; 3]) {
        let [first, second] = halves(&part.points);
        let middle = self.place(&second[0]);
        let [from, to] = part.ends;
        let half = |points, ends| CurvePart { points, ends };
        (
            [half(first, [from, middle]), half(second, [middle, to])],
            [from, middle, to],
        )
    }

    fn distance(&self, place: &BranchPlace) -> f64 {
        self.sign * place.distance
    }

    /// Whether no point of a part is farther than that on the side, as far as a few vectors tell.
    fn is_within(&self, part: &CurvePart, places: &[BranchPlace; 3], most: f64) -> bool {
        let (points, sign) = (&part.points, self.sign);
        if sign > 0.0 && reached(points, places) <= most {
            return true;
        }
        let [from, middle, to] = places.map(|place| place.normal);
        if self.lets(points, [from, middle, to], most) {
            return true;
        }
        if from.dot(to) < 0.5 && self.lets(points, [middle; 3], most) {
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
        self.lets(points, steps, most) || (sign < 0.0 && self.roughly(part, places) <= most)
    }

    /// A bound that is larger by as little as a part is long, or so.
    fn roughly(&self, part: &CurvePart, places: &[BranchPlace; 3]) -> f64 {
        let points = &part.points;
        let from = |p: Twice| {
            points
                .iter()
                .map(|q| arm(&p, q).hypot())
                .fold(0.0, f64::max)
        };
        let rough = if self.sign > 0.0 {
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
