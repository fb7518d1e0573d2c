//! A conic in numbers of 106 bits, and on which side of it a cubic lies.
//!
//! With U = P0 - P1, V = P2 - P1 and q a point about P1 let A = q×V, C = U×q and B = U×V - A - C. On the conic F = B² - 4w²AC is 0. The
//! region that its branch bounds is convex: F is negative there, and A and C have the sign of U×V. Everywhere else F is positive, or A or C
//! has the other sign.

use kurbo::{Affine, PathSeg, Point, Vec2};

use super::Conic;
use super::frame::Frame;
use crate::measure::unit_for;
use crate::numeric::double::{Double, Twice};

/// What numbers of 106 bits leave of a distance, as a part of the size, and of a coefficient, as a part of the sizes that it is the sum of.
const NOISE: f64 = 1.0 / (1_u128 << 90) as f64;
const ROUNDING: f64 = 1.0 / (1_u128 << 98) as f64;

/// The products of two cubics: which coefficients make which, and how many times.
const WEIGHTS: [f64; 4] = [1.0, 3.0, 3.0, 1.0];

/// The control points of a cubic about P1.
pub(super) type Cubic = [Twice; 4];

/// A conic in numbers of 106 bits, its lengths in a unit that is a power of two, so that no product overflows.
pub(super) struct Branch {
    pub(super) unit: f64,
    origin: Twice,
    /// U and V.
    pub(super) arms: [Twice; 2],
    /// U×V, and 4w².
    area: Double,
    square: Double,
}

/// The normal at the nearest point, towards P1, and the distance along it.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) normal: Vec2,
    pub(super) distance: f64,
    /// A point beside the nearest one.
    pub(super) near: Vec2,
}

pub(super) fn less(a: Double, b: Double) -> Double {
    a.plus(b.scaled(-1.0))
}

fn cross(u: &Twice, v: &Twice) -> Double {
    less(u[0].times(v[1]), u[1].times(v[0]))
}

impl Branch {
    /// The image of a conic.
    pub(super) fn new(conic: &Conic, map: Affine) -> Self {
        let [a, b, c, d, e, f] = map.as_coeffs();
        let turned = |[x, y]: Twice| [x.scaled(a).plus(y.scaled(c)), x.scaled(b).plus(y.scaled(d))];
        let control = conic.control;
        let arm = |p: Point| {
            turned([
                Double::difference(p.x, control.x),
                Double::difference(p.y, control.y),
            ])
        };
        let [x, y] = turned([control.x, control.y].map(Double::of));
        let arms = [arm(conic.from), arm(conic.to)];
        let reach = arms.iter().flatten().map(|x| x.value().abs());
        let unit = unit_for(reach.fold(f64::MIN_POSITIVE, f64::max));
        let arms = arms.map(|arm| arm.map(|x| x.scaled(1.0 / unit)));
        Self {
            unit,
            origin: [x.plus(Double::of(e)), y.plus(Double::of(f))],
            area: cross(&arms[0], &arms[1]),
            arms,
            square: Double::of(2.0 * conic.weight).times(Double::of(2.0 * conic.weight)),
        }
    }

    /// The frame of the image of a conic, U and V rounded once.
    pub(super) fn frame(&self, image: &Conic) -> Frame {
        let arm = |[x, y]: Twice| self.unit * Vec2::new(x.value(), y.value());
        Frame::new(image).with_arms(self.arms.map(arm))
    }

    /// A point of the plane about P1.
    pub(super) fn about(&self, p: Point) -> Twice {
        let [x, y] = self.origin;
        [less(Double::of(p.x), x), less(Double::of(p.y), y)].map(|x| x.scaled(1.0 / self.unit))
    }

    /// What numbers of 106 bits leave of a distance.
    pub(super) fn noise(&self) -> f64 {
        let [x, y] = self.origin.map(|x| x.value().abs() / self.unit);
        NOISE * (1.0 + x + y)
    }

    /// A segment about P1 as a cubic.
    pub(super) fn cubic(&self, segment: &PathSeg) -> Cubic {
        let [a, b, c, d] = match *segment {
            PathSeg::Line(l) => [l.p0, l.p0, l.p1, l.p1],
            PathSeg::Quad(q) => [q.p0, q.p1, q.p1, q.p2],
            PathSeg::Cubic(c) => [c.p0, c.p1, c.p2, c.p3],
        }
        .map(|p| self.about(p));
        // (u + 2 v) / 3
        let third = |u: Twice, v: Twice| [0, 1].map(|i| u[i].plus(v[i].scaled(2.0)).over(3.0));
        match segment {
            PathSeg::Line(_) => [a, third(d, a), third(a, d), d],
            PathSeg::Quad(_) => [a, third(a, b), third(d, b), d],
            PathSeg::Cubic(_) => [a, b, c, d],
        }
    }

    /// A, B and C.
    fn coordinates(&self, q: &Twice) -> [Double; 3] {
        let [u, v] = &self.arms;
        let (a, c) = (cross(q, v), cross(u, q));
        [a, less(less(self.area, a), c), c]
    }

    /// Whether a cubic lies wholly in the region, or wholly out of it.
    pub(super) fn lies(&self, points: &Cubic, within: bool) -> bool {
        let all = points.map(|q| self.coordinates(&q));
        let side = 1.0_f64.copysign(self.area.value());
        if within {
            let is_between = all
                .iter()
                .all(|[a, _, c]| side * a.value() >= 0.0 && side * c.value() >= 0.0);
            return is_between && self.excess_is(&all, -1.0);
        }
        let beyond = |axis: usize| all.iter().all(|all| side * all[axis].value() <= 0.0);
        self.excess_is(&all, 1.0) || beyond(0) || beyond(2)
    }

    /// Whether a point lies in the region.
    pub(super) fn holds(&self, p: Vec2) -> bool {
        self.lies(&[[p.x, p.y].map(Double::of); 4], true)
    }

    /// Whether all of F's coefficients have this sign for certain.
    fn excess_is(&self, all: &[[Double; 3]; 4], sign: f64) -> bool {
        (0..7_usize).all(|k| {
            let (mut sum, mut sizes) = (Double::of(0.0), 0.0);
            for i in k.saturating_sub(3)..=k.min(3) {
                let ([_, b, _], [_, other, _]) = (all[i], all[k - i]);
                let (a, c) = (all[i][0], all[k - i][2]);
                let (squares, products) = (b.times(other), a.times(c).times(self.square));
                let weight = WEIGHTS[i] * WEIGHTS[k - i];
                sum = sum.plus(less(squares, products).scaled(weight));
                sizes += weight * (squares.value().abs() + products.value().abs());
            }
            sign * sum.value() >= ROUNDING * sizes
        })
    }

    /// The nearest point to one of a curve, about P1: the distance along the normal there is the root of a quadratic.
    pub(super) fn place(&self, frame: &Frame, q: &Twice, bend: f64) -> Place {
        let offset = self.unit * Vec2::new(q[0].value(), q[1].value());
        let (foot, near) = frame.nearest_about(offset, bend);
        let (n, roughly) = (foot.outward, foot.distance / self.unit);
        let normal = [Double::of(n.x), Double::of(n.y)];
        let [a, b, c] = self.coordinates(q);
        let [u, v] = &self.arms;
        let (da, dc) = (cross(&normal, v), cross(u, &normal));
        let db = da.plus(dc).scaled(-1.0);
        let times = |x: Double, y: Double| self.square.times(x).times(y);
        let excess = less(b.times(b), times(a, c)).value();
        let slope = less(b.times(db).scaled(2.0), times(a, dc).plus(times(c, da))).value();
        let bend = less(db.times(db), times(da, dc)).value();
        let root = (slope * slope - 4.0 * excess * bend).sqrt();
        let sum = slope + root.copysign(slope);
        // The other branch may be met first.
        let side = 1.0_f64.copysign(self.area.value());
        let is_met = |distance: &f64| {
            let on = |x: Double, dx: Double| side * less(x, dx.scaled(*distance)).value() >= -1e-12;
            let off = (distance - roughly).abs();
            off <= 1e-3 * roughly.abs() + 1e-9 && on(a, da) && on(c, dc)
        };
        let distance = [2.0 * excess / sum, sum / (2.0 * bend)];
        let distance = distance.into_iter().find(is_met).unwrap_or(roughly);
        Place {
            normal: n,
            near: near / self.unit,
            distance,
        }
    }
}
