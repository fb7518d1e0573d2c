//! Cubics that join smoothly, as one curve of a parameter of which each takes one.

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, Vec2};

use super::near::LARGEST_TURN;
use crate::curve::{first_direction, turn};

/// The largest turn at a joint, in degrees, over which an arc may run, where rounding explains no larger one.
const SMOOTH_TURN: f64 = 1.0;

/// How many points of each of several cubics are looked at, at least.
const POINTS_OF_SEVERAL: usize = 4;

#[derive(Debug, Clone, Copy)]
pub(super) struct Chain<'a> {
    cubics: &'a [CubicBez],
}

impl<'a> Chain<'a> {
    pub(super) const fn new(cubics: &'a [CubicBez]) -> Self {
        Self { cubics }
    }

    /// The parameter of its end.
    pub(super) const fn end(&self) -> f64 {
        self.cubics.len() as f64
    }

    /// The longest stretch that one arc may take: half of a chain that ends where it begins, so that it does not become one point.
    pub(super) fn reach(&self) -> f64 {
        let ends = self.cubics.first().zip(self.cubics.last());
        if ends.is_some_and(|(first, last)| first.p0 == last.p3) {
            0.5 * self.end()
        } else {
            self.end()
        }
    }

    pub(super) fn point(&self, at: f64) -> Point {
        let i = (at as usize).min(self.cubics.len().saturating_sub(1));
        let Some(cubic) = self.cubics.get(i) else {
            return Point::ORIGIN;
        };
        let t = at - i as f64;
        if t == 0.0 {
            cubic.p0
        } else if t == 1.0 {
            cubic.p3
        } else {
            cubic.eval(t)
        }
    }

    /// A point, and the direction in which the chain leaves it.
    pub(super) fn leaving(&self, at: f64) -> (Point, Vec2) {
        let rest = self.between(at, (at + 1.0).floor());
        let direction = |cubic: &CubicBez| first_direction(&PathSeg::Cubic(*cubic));
        (
            self.point(at),
            rest.first().map(direction).unwrap_or_default(),
        )
    }

    /// A point, and the direction in which the chain arrives there.
    pub(super) fn arriving(&self, at: f64) -> (Point, Vec2) {
        let rest = self.between((at - 1.0).ceil(), at);
        let direction = |cubic: &CubicBez| -first_direction(&PathSeg::Cubic(*cubic).reverse());
        (
            self.point(at),
            rest.last().map(direction).unwrap_or_default(),
        )
    }

    /// Points between two parameters, at least so many, ends left out.
    pub(super) fn visit(&self, (from, to): (f64, f64), count: usize, mut visit: impl FnMut(Point)) {
        let (first, last) = (from as usize, (to.ceil() as usize).min(self.cubics.len()));
        let count = count.div_ceil(last - first).max(POINTS_OF_SEVERAL);
        for i in first..last {
            let start = i as f64;
            let (a, b) = ((from - start).max(0.0), (to - start).min(1.0));
            if i > first {
                visit(self.cubics[i].p0);
            }
            for k in 1..=count {
                let part = k as f64 / (count + 1) as f64;
                visit(self.cubics[i].eval(a + part * (b - a)));
            }
        }
    }

    /// The cubics between two parameters.
    pub(super) fn between(&self, from: f64, to: f64) -> Vec<CubicBez> {
        let (first, last) = (from as usize, (to.ceil() as usize).min(self.cubics.len()));
        let part = |i: usize| {
            let (cubic, start) = (self.cubics[i], i as f64);
            let (a, b) = ((from - start).max(0.0), (to - start).min(1.0));
            let cut = if a == 0.0 && b == 1.0 {
                cubic
            } else {
                cubic.subsegment(a..b)
            };
            CubicBez {
                p0: if a == 0.0 { cubic.p0 } else { cut.p0 },
                p3: if b == 1.0 { cubic.p3 } else { cut.p3 },
                ..cut
            }
        };
        (first..last).map(part).collect()
    }
}

/// Whether two cubics join so smoothly that an arc may run over the joint: within a degree, or what rounding of their handles by
/// so much explains.
pub(super) fn runs_on(a: &CubicBez, b: &CubicBez, moved: f64) -> bool {
    let handle = |v: kurbo::Vec2| 2.0 * moved / v.hypot2().sqrt();
    let explained = (handle(a.p3 - a.p2) + handle(b.p1 - b.p0)).to_degrees();
    let most = explained.clamp(SMOOTH_TURN, LARGEST_TURN);
    turn(&PathSeg::Cubic(*a), &PathSeg::Cubic(*b)).abs() <= most
}
