//! A segment in the frame of a true shape, in twice the digits of `f64`.

use kurbo::{CubicBez, Line, PathSeg, QuadBez, Vec2};

use crate::curve::points_of;
use crate::numeric::bernstein::Polynomial;
use crate::numeric::double::{Double, Twice};
use crate::numeric::instructions::by_the_best;
use crate::shape::{Exact, Truth, decimals};

/// The control points of a segment as their decimals tell them, the last one repeated, and how many there are.
pub(super) type SegmentDecimals = ([Twice; 4], usize);

/// Those of this segment.
pub(super) fn decimals_of(segment: &PathSeg) -> SegmentDecimals {
    let (points, count) = points_of(segment);
    (points.map(decimals), count)
}

/// A segment's points in the frame of a true shape: about its centre, or about an end of its chord.
#[derive(Debug, Clone, Copy)]
pub(super) struct FramedPoints {
    points: [Twice; 4],
    /// What is added to the dot products: minus the square of the radius, or the pencil's linear part at each point.
    levels: [Double; 4],
    count: usize,
}

impl FramedPoints {
    /// A segment about a circle, or as a cubic about an ellipse.
    pub(super) fn of_truth(points: &SegmentDecimals, truth: &Truth, exact: &Exact) -> Self {
        by_the_best(
            #[inline(always)]
            || {
                let framed = Self::of(points.0.map(|p| exact.point(p)), points.1, exact);
                if truth.is_circle() && !exact.is_conic {
                    framed
                } else {
                    framed.raised(exact)
                }
            },
        )
    }

    /// The same as a cubic.
    #[inline(always)]
    fn raised(self, exact: &Exact) -> Self {
        let [a, b, c, _] = self.points;
        // (u + n v) / (n + 1)
        let between = |u: Twice, v: Twice, n: f64| {
            let part = |i: usize| u[i].plus(v[i].scaled(n)).over(n + 1.0);
            [part(0), part(1)]
        };
        let points = match self.count {
            2 => [a, between(b, a, 2.0), between(a, b, 2.0), b],
            3 => [a, between(a, b, 2.0), between(c, b, 2.0), c],
            _ => return self,
        };
        Self::of(points, 4, exact)
    }

    #[inline(always)]
    fn of(points: [Twice; 4], count: usize, exact: &Exact) -> Self {
        let [a, b, c, d] = &points;
        let levels = [
            exact.level(*a),
            exact.level(*b),
            exact.level(*c),
            exact.level(*d),
        ];
        Self {
            points,
            levels,
            count,
        }
    }

    /// The points of a cubic.
    pub(super) const fn points(&self) -> &[Twice; 4] {
        &self.points
    }

    /// |p(t)|² - radius² about the centre; each coefficient is rounded once.
    #[inline(always)]
    pub(super) fn excess(&self) -> Polynomial {
        let term = |i: usize, j: usize| {
            let level = self.levels[i].near(self.levels[j]);
            Double::dot(self.points[i], self.points[j]).near(level.scaled(0.5))
        };
        let mean = |one: Double, a: f64, other: Double, b: f64| {
            one.scaled(a).near(other.scaled(b)).over(a + b).value()
        };
        match self.count {
            2 => Polynomial::new(&[[0, 0], [0, 1], [1, 1]].map(|[i, j]| term(i, j).value())),
            3 => Polynomial::new(&[
                term(0, 0).value(),
                term(0, 1).value(),
                mean(term(0, 2), 1.0, term(1, 1), 2.0),
                term(1, 2).value(),
                term(2, 2).value(),
            ]),
            _ => Polynomial::new(&[
                term(0, 0).value(),
                term(0, 1).value(),
                mean(term(0, 2), 2.0, term(1, 1), 3.0),
                mean(term(0, 3), 1.0, term(1, 2), 9.0),
                mean(term(1, 3), 2.0, term(2, 2), 3.0),
                term(2, 3).value(),
                term(3, 3).value(),
            ]),
        }
    }

    /// The part of a cubic between two parameters, by blossoms.
    pub(super) fn between(&self, from: f64, to: f64) -> Self {
        let blossom = |row: [Double; 4]| {
            let step = |a: Double, b: Double, t: f64| between(a, b, t);
            let pairs = |t: f64| [0, 1, 2].map(|i| step(row[i], row[i + 1], t));
            let next = |[a, b, c]: [Double; 3], t: f64| [step(a, b, t), step(b, c, t)];
            let [first, second] = [pairs(from), pairs(to)];
            let [[a, b], [c, d], [e, f]] = [next(first, from), next(first, to), next(second, to)];
            [
                step(a, b, from),
                step(a, b, to),
                step(c, d, to),
                step(e, f, to),
            ]
        };
        let [x, y] = [0, 1].map(|axis| blossom(self.points.map(|p| p[axis])));
        Self {
            points: core::array::from_fn(|i| [x[i], y[i]]),
            levels: blossom(self.levels),
            count: self.count,
        }
    }

    /// |p|² - radius² at t, and its derivative.
    pub(super) fn excess_at(&self, t: f64) -> [f64; 2] {
        let degree = self.count - 1;
        let casteljau = |mut row: [Double; 4]| {
            for last in (2..=degree).rev() {
                for i in 0..last {
                    row[i] = between(row[i], row[i + 1], t);
                }
            }
            let rate = row[1].plus(row[0].scaled(-1.0)).scaled(degree as f64);
            [between(row[0], row[1], t), rate]
        };
        let [x, y] = [0, 1].map(|axis| casteljau(self.points.map(|p| p[axis])));
        let level = casteljau(self.levels);
        let product = |i: usize| x[0].times(x[i]).plus(y[0].times(y[i]));
        [
            product(0).plus(level[0]).value(),
            product(1).scaled(2.0).plus(level[1]).value(),
        ]
    }

    /// The segment about the origin of the frame, in the user's unit and along the axes `turned` to those of the true shape.
    pub(super) fn segment(&self, exact: &Exact, turned: impl Fn(Vec2) -> Vec2) -> PathSeg {
        let image = |i: usize| {
            let [x, y] = self.points[i];
            turned(exact.image(Vec2::new(x.value(), y.value()))).to_point()
        };
        let [p0, p1, p2, p3] = [image(0), image(1), image(2), image(3)];
        match self.count {
            2 => PathSeg::Line(Line::new(p0, p1)),
            3 => PathSeg::Quad(QuadBez::new(p0, p1, p2)),
            _ => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
        }
    }
}

/// a + t (b - a), where 1 - t is exact or its rounding does not count.
fn between(a: Double, b: Double, t: f64) -> Double {
    a.times(Double::difference(1.0, t)).plus(b.scaled(t))
}
