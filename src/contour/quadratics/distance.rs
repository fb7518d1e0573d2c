//! How far quadratics lie from the cubic in whose place they stand, both ways (Hausdorff), as a bound.
//!
//! There are three, each nearer and dearer than the one before: of points of the same parameter, of points near one another, and the
//! distance of the house by branch and bound.

use kurbo::{Affine, CubicBez, ParamCurve as _, ParamCurveDeriv as _, PathSeg, Point, Vec2};

use super::{hull, third_difference};
use crate::measure::hausdorff::{Aim, Effort, along, away, hausdorff, nearest_on};

/// Cut into so many parts the control points of a cubic lie within about a hundredth of its size from it.
const PARTS: u32 = 16;

/// For how many parts of each quadratic near points are sought to decide on a limit.
const NEAR_PARTS: u32 = 4;

/// What rounding may take from a distance between points of about its size.
const ROUNDING: f64 = 1e-12;

/// What rounding may take from a distance of points, as a part of the size of the cubic.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// How far the stated distance may lie above the true one, as a part of it.
const GOAL: f64 = 1e-9;

/// A cubic and the quadratics in its place, of equal parameter length.
pub(in crate::contour) struct Replaced<'a> {
    pub(in crate::contour) cubic: &'a CubicBez,
    pub(in crate::contour) quadratics: &'a [PathSeg],
}

impl Replaced<'_> {
    /// The parts of the cubic and the quadratics, raised.
    fn pieces(&self) -> impl Iterator<Item = (CubicBez, CubicBez)> {
        let count = self.quadratics.len() as f64;
        let numbered = self.quadratics.iter().enumerate();
        numbered.map(move |(i, quadratic)| {
            let part = i as f64 / count..(i + 1) as f64 / count;
            (self.cubic.subsegment(part), quadratic.to_cubic())
        })
    }

    /// That of points of the same parameter: their difference is a cubic, within its control points after it was cut into [`PARTS`].
    pub(in crate::contour) fn at_parameters(&self) -> f64 {
        let squares = self.pieces().map(|(piece, raised)| {
            let control = |p: Point, q: Point| (p - q).to_point();
            let difference = CubicBez::new(
                control(piece.p0, raised.p0),
                control(piece.p1, raised.p1),
                control(piece.p2, raised.p2),
                control(piece.p3, raised.p3),
            );
            let hulls = parts(PARTS).map(|[from, to]| difference.subsegment(from..to));
            let points = hulls.flat_map(|hull| [hull.p0, hull.p1, hull.p2, hull.p3]);
            points.map(|p| p.to_vec2().hypot2()).fold(0.0, f64::max)
        });
        squares.fold(0.0, f64::max).sqrt() * (1.0 + ROUNDING)
    }

    /// That of near points: both run from end to end, so that it holds both ways.
    fn at_near_points(&self, count: u32) -> f64 {
        let distances = self.pieces().map(|(piece, raised)| {
            let mut at = 0.0;
            let distances = parts(count).map(|[from, to]| {
                let next = if to < 1.0 {
                    near(&raised, piece.eval(to), to).max(at)
                } else {
                    1.0
                };
                let ends = [core::mem::replace(&mut at, next), next];
                along(&piece.subsegment(from..to), &raised, ends)
            });
            distances.fold(0.0, f64::max)
        });
        distances.fold(0.0, f64::max) * (1.0 + ROUNDING)
    }

    /// Whether the distance is within a limit.
    pub(super) fn is_within(&self, limit: f64) -> bool {
        let aim = Aim {
            tolerance: limit,
            goal: f64::INFINITY,
            found: 0.0,
        };
        !self.is_beyond(limit)
            && (self.at_near_points(NEAR_PARTS) <= limit
                || self.searched(aim, &mut Effort(MOST_STEPS)) <= limit)
    }

    /// Whether a point of the cubic says that it is not: the one where it surely lies far off, of those where the difference by parameter is
    /// the largest.
    fn is_beyond(&self, limit: f64) -> bool {
        let p = self
            .cubic
            .eval(across(self.cubic, self.quadratics.len())[1]);
        let limit = limit * (1.0 + GOAL);
        let is_near = |quadratic: &PathSeg| {
            let cubic = quadratic.to_cubic();
            away(&hull(&cubic), p) <= limit && nearest_on(&cubic, p).1 <= limit
        };
        !self.quadratics.iter().any(is_near)
    }

    /// The distance, which is known to be no more than so much, or a bound of it that is no more than one that was found elsewhere.
    pub(in crate::contour) fn distance(&self, known: f64, found: f64, steps: &mut Effort) -> f64 {
        let near = known.min(self.at_near_points(PARTS));
        if near <= found {
            return near;
        }
        let aim = Aim {
            tolerance: 0.0,
            goal: GOAL,
            found,
        };
        near.min(self.searched(aim, steps))
    }

    /// By branch and bound, from the start of the cubic, so that a place far away takes no digits.
    fn searched(&self, aim: Aim, steps: &mut Effort) -> f64 {
        let map = Affine::translate(-self.cubic.p0.to_vec2());
        let moved: Vec<PathSeg> = self.quadratics.iter().map(|&q| map * q).collect();
        let cubic = map * *self.cubic;
        let size = [cubic.p1, cubic.p2, cubic.p3].map(|p| p.to_vec2().hypot2());
        let size = size.into_iter().fold(0.0, f64::max).sqrt();
        let apart = hausdorff(steps, [&[PathSeg::Cubic(cubic)], &moved], aim);
        apart.at_most + NOISE * size
    }
}

/// The largest part of the third difference of a cubic across it, of those at the peaks of so many equal parts, and its parameter.
pub(super) fn across(cubic: &CubicBez, count: usize) -> [f64; 2] {
    let (third, slopes) = (third_difference(cubic), cubic.deriv());
    let peaks = (0..count).flat_map(|i| PEAKS.map(|peak| (i as f64 + peak) / count as f64));
    peaks.fold([0.0, 0.5], |[most, at], t| {
        let slope = slopes.eval(t).to_vec2();
        let far = third.cross(slope).abs() / slope.hypot2().sqrt();
        if far > most { [far, t] } else { [most, at] }
    })
}

/// How much is done to decide on one count.
const MOST_STEPS: u64 = 100_000;

/// Where the difference by parameter is the largest: (1 ± 1/sqrt(3))/2.
const PEAKS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// Equal parts of 0 to 1.
fn parts(count: u32) -> impl Iterator<Item = [f64; 2]> {
    let at = move |k: u32| f64::from(k) / f64::from(count);
    (0..count).map(move |k| [at(k), at(k + 1)])
}

/// The parameter of a point near another one, by a step from t.
fn near(cubic: &CubicBez, p: Point, t: f64) -> f64 {
    let slope = cubic.deriv().eval(t).to_vec2();
    let off: Vec2 = p - cubic.eval(t);
    let step = off.dot(slope) / slope.hypot2();
    let moved = t + step;
    if moved.is_finite() {
        moved.clamp(0.0, 1.0)
    } else {
        t
    }
}
