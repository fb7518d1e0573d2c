//! A conic in numbers of 106 bits, and on which side of it a cubic lies.
//!
//! With U = P0 - P1, V = P2 - P1 and q a point about P1 let A = q×V, C = U×q and B = U×V - A - C. On the conic F = B² - 4w²AC is 0. The
//! region that its branch bounds is convex: F is negative there, and A and C have the sign of U×V. Everywhere else F is positive, or A or C
//! has the other sign.

use kurbo::{Affine, PathSeg, Point, Vec2};

use super::Conic;
use super::frame::ConicFrame;
use crate::measure::unit_for;
use crate::number::as_decimal;
use crate::numeric::double::{Double, Twice, cross};
use crate::numeric::foot::Foot;
use crate::shape::decimals;

/// What numbers of 106 bits leave of a distance, as a part of the size, and of a coefficient, as a part of the sizes that it is the sum of.
const NOISE: f64 = 1.0 / (1_u128 << 90) as f64;
const ROUNDING: f64 = 1.0 / (1_u128 << 98) as f64;

/// How far beyond the nearest point a point of the region is looked for, as a part of the distance.
const NEAR: f64 = 1e-11;

/// From how many of its radii on a bend is a tip, which a line along the normal may miss by the digits of `f64`.
const SHARP: f64 = 8.0;

/// How far within the branch points beside it are, as a part of their distance from P1.
const BESIDE: f64 = 1.0 / (1_u128 << 98) as f64;

/// The binomials of a cubic's Bernstein form.
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
    weight: Double,
    /// How far points beside the branch are moved along the line through P1, as a part of their distance from it: so far that those of a thin
    /// region leave it.
    beside: f64,
}

/// A point of a curve, and the normal at the branch's nearest point, towards P1.
#[derive(Clone, Copy)]
pub(super) struct BranchPlace {
    pub(super) normal: Vec2,
    /// How far the branch lies against the normal.
    pub(super) distance: f64,
    /// How far it lies a second time: between the two is the region.
    pub(super) again: f64,
    /// A point of the region, the nearest one but for a few digits where the point lies outside; `None` where there is no such room.
    pub(super) inside: Option<Twice>,
    /// The square roots of the parts of the nearest point along U and V.
    shares: [f64; 2],
}

/// From one point to another, in the digits of `f64`.
pub(super) fn arm(to: &Twice, from: &Twice) -> Vec2 {
    Vec2::new(to[0].minus(from[0]).value(), to[1].minus(from[1]).value())
}

impl Branch {
    /// The image of a conic.
    pub(super) fn new(conic: &Conic, map: Affine) -> Self {
        let [a, b, c, d, e, f] = map.as_coeffs();
        let turned = |[x, y]: Twice| [x.scaled(a).plus(y.scaled(c)), x.scaled(b).plus(y.scaled(d))];
        let control = decimals(conic.control);
        let arm = |p: Point| {
            let p = decimals(p);
            turned([0, 1].map(|i| p[i].minus(control[i])))
        };
        let [x, y] = turned(control);
        let arms = [arm(conic.from), arm(conic.to)];
        let reach = arms.iter().flatten().map(|x| x.value().abs());
        let unit = unit_for(reach.fold(f64::MIN_POSITIVE, f64::max));
        let arms = arms.map(|arm| arm.map(|x| x.scaled(1.0 / unit)));
        let area = cross(arms[0], arms[1]);
        let weight = as_decimal(conic.weight);
        let lengths = arms.map(|[x, y]| Vec2::new(x.value(), y.value()).hypot());
        Self {
            unit,
            origin: [x.plus(Double::of(e)), y.plus(Double::of(f))],
            area,
            arms,
            weight,
            beside: BESIDE * (lengths[0] * lengths[1] / area.value()).abs(),
            square: weight.times(weight).scaled(4.0),
        }
    }

    /// The frame of the image of a conic, U and V rounded once.
    pub(super) fn frame(&self, image: &Conic) -> ConicFrame {
        let arm = |[x, y]: Twice| self.unit * Vec2::new(x.value(), y.value());
        ConicFrame::new(image).with_arms(self.arms.map(arm))
    }

    /// A point of the plane about P1.
    pub(super) fn about(&self, p: Point) -> Twice {
        let [x, y] = self.origin;
        let p = decimals(p);
        [p[0].minus(x), p[1].minus(y)].map(|x| x.scaled(1.0 / self.unit))
    }

    /// What numbers of 106 bits leave of a distance: of a thin triangle cross products leave as much less as it is thinner.
    pub(super) fn noise(&self) -> f64 {
        let [x, y] = self.origin.map(|x| x.value().abs() / self.unit);
        NOISE * (1.0 + x + y) + (16.0 * self.beside).min(f64::EPSILON / 4.0)
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
        let (a, c) = (cross(*q, *v), cross(*u, *q));
        [a, self.area.minus(a).minus(c), c]
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
    fn holds(&self, q: &Twice) -> bool {
        let [a, b, c] = self.coordinates(q);
        let side = 1.0_f64.copysign(self.area.value());
        let (squares, products) = (b.times(b), a.times(c).times(self.square));
        let sizes = squares.value().abs() + products.value().abs();
        side * a.value() >= 0.0
            && side * c.value() >= 0.0
            && products.minus(squares).value() >= ROUNDING * sizes
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
                sum = sum.plus(squares.minus(products).scaled(weight));
                sizes += weight * (squares.value().abs() + products.value().abs());
            }
            sign * sum.value() >= ROUNDING * sizes
        })
    }

    /// A point of a curve about P1: its distance along the normal is the root of a quadratic.
    pub(super) fn place(&self, frame: &ConicFrame, q: &Twice) -> BranchPlace {
        let place = self.sought(frame, q);
        let far = |end: &Twice| arm(q, end).hypot();
        let [from, to] = self.arms.each_ref().map(far);
        if place.distance.abs() <= 1.01 * from.min(to) {
            return place;
        }
        // No nearest point lies farther away than the ends: nothing was found.
        BranchPlace {
            distance: 0.0,
            inside: Some(self.arms[usize::from(to < from)]),
            ..place
        }
    }

    fn sought(&self, frame: &ConicFrame, q: &Twice) -> BranchPlace {
        let offset = self.unit * Vec2::new(q[0].value(), q[1].value());
        let nearest = frame.nearest(offset);
        let foot = frame.seen_from(offset, nearest);
        let (n, roughly) = (foot.outward, foot.distance / self.unit);
        let shares = frame.shares(nearest);
        let roots = self.roots(q, n);
        let is_near = |x: &&f64| (**x - roughly).abs() <= 1e-3 * roughly.abs() + 1e-9;
        let beside = || self.beside(q, shares, &foot);
        let off = |x: &f64| (x - roughly).abs();
        let first = roots.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let Some(&distance) = first.filter(is_near) else {
            return beside();
        };
        let is_sharp = frame.curvature(nearest) * foot.distance.abs() > SHARP;
        if is_sharp {
            let place = beside();
            if place.distance.abs() < distance.abs() {
                return place;
            }
        }
        let farther = roots.into_iter().filter(|x| *x > distance);
        let again = farther.fold(f64::INFINITY, f64::min);
        let inside = self.inside(q, n, distance, again);
        BranchPlace {
            normal: n,
            distance,
            again,
            inside: inside.or_else(|| self.beyond(shares, true)),
            shares,
        }
    }

    /// The same by a point of the branch where the normal, in the digits of `f64`, misses a tip.
    fn beside(&self, q: &Twice, shares: [f64; 2], foot: &Foot) -> BranchPlace {
        let near = self.beyond(shares, true);
        let arm = near.map_or(Vec2::ZERO, |p| arm(q, &p));
        let length = arm.hypot().copysign(foot.distance);
        BranchPlace {
            normal: if length == 0.0 {
                foot.outward
            } else {
                arm / length
            },
            distance: length,
            again: f64::INFINITY,
            inside: near,
            shares,
        }
    }

    /// How far the branch lies against a normal.
    fn roots(&self, q: &Twice, n: Vec2) -> Vec<f64> {
        let normal = [n.x, n.y].map(Double::of);
        let [a, b, c] = self.coordinates(q);
        let [u, v] = &self.arms;
        let (da, dc) = (cross(normal, *v), cross(*u, normal));
        let db = da.plus(dc).scaled(-1.0);
        let times = |x: Double, y: Double| self.square.times(x).times(y);
        let excess = b.times(b).minus(times(a, c));
        let slope = b
            .times(db)
            .scaled(2.0)
            .minus(times(a, dc).plus(times(c, da)));
        let bend = db.times(db).minus(times(da, dc));
        // A line that grazes a tip leaves few digits of this.
        let square = slope.times(slope).minus(excess.times(bend).scaled(4.0));
        if square.value() < 0.0 {
            return Vec::new();
        }
        let root = square.sqrt().value();
        let (excess, slope, bend) = (excess.value(), slope.value(), bend.value());
        let sum = slope + root.copysign(slope);
        // The other branch may be met first, where both A and C have the other sign.
        let side = 1.0_f64.copysign(self.area.value());
        let is_met = |x: &f64| side * a.plus(c).minus(da.plus(dc).scaled(*x)).value() >= 0.0;
        let both = [2.0 * excess / sum, sum / (2.0 * bend)];
        both.into_iter().filter(is_met).collect()
    }

    /// A point of the region against the normal of one.
    fn inside(&self, q: &Twice, n: Vec2, distance: f64, again: f64) -> Option<Twice> {
        let depth = if distance > 0.0 {
            distance + (NEAR * distance).min((again - distance) / 2.0)
        } else if again < 0.0 {
            // Of a tip as thin as rounding the other side is nearer.
            f64::midpoint(distance, again)
        } else {
            0.0
        };
        let step = Double::of(depth);
        let to = |x: Double, n: f64| x.minus(step.times(Double::of(n)));
        let inside = [to(q[0], n.x), to(q[1], n.y)];
        self.holds(&inside).then_some(inside)
    }

    /// A point out of the region beside the one that is nearest to a place.
    pub(super) fn outside(&self, place: &BranchPlace) -> Option<Twice> {
        self.beyond(place.shares, false)
    }

    /// A point beside one of the branch, within the region or out of it: one of the branch of a weight that is another by a few digits.
    fn beyond(&self, [s, t]: [f64; 2], within: bool) -> Option<Twice> {
        let square = |x: f64| Double::of(x).times(Double::of(x));
        let (from, to) = (square(s), square(t));
        let twice = self
            .weight
            .scaled(2.0)
            .times(Double::of(s).times(Double::of(t)));
        // By so much that the digits of B show it, which are few beside the ends.
        let part = twice.value() / from.plus(to).plus(twice).value();
        let other = (self.beside / part.abs()).min(0.5);
        let twice = twice.plus(twice.scaled(if within { -other } else { other }));
        let whole = from.plus(to).plus(twice);
        let [u, v] = &self.arms;
        let point = [0, 1].map(|i| {
            let sum = u[i].times(from).plus(v[i].times(to));
            sum.divided(whole)
        });
        let is_there = if within {
            self.holds(&point)
        } else {
            self.lies(&[point; 4], false)
        };
        is_there.then_some(point)
    }
}
