//! Bounds on the distance from an ellipse where a curve runs far from it, or where the nearest point jumps.

use kurbo::Vec2;

use super::part::{Motion, Part};
use super::peaks::{Search, vector};
use super::tangents::{Tangent, Tangents};
use crate::numeric::double::Twice;
use crate::numeric::foot::{Foot, foot};

/// How far above what is known, in roundings, a bound by the digits of `f64` tells as much as a closer one.
const ROUGH: f64 = 1e3;

/// What the digits of `f64` tell of a part.
struct Roughly {
    bounds: [f64; 2],
    /// How far the bounds may be off.
    slack: f64,
}

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Bounds the distance on a part by its control points. The signed distance from a convex shape is a convex function of the point: it
    /// is at most the largest of the control points, and at least that from the tangent at any point of the shape.
    pub(super) fn bound_far(&mut self, part: &Part, middle: &Motion<f64>, cuts: u32) {
        let Some(Roughly { bounds, slack }) = self.bounds_roughly(part, middle) else {
            return;
        };
        if cuts > 0 && self.known.most_above(bounds) > ROUGH * slack {
            self.leave(part, cuts, bounds);
            return;
        }
        let (part, points) = self.refreshed(part);
        let points = points.map(|p| self.profile.about_center(p));
        let places = part.polygon(self.center);
        let found: [_; 4] = core::array::from_fn(|i| self.distance_exactly(places[i], points[i]));
        let [from, to] = part.parameters();
        self.take(from, found[0].1);
        self.take(to, found[3].1);
        let inner = [0, 1].map(|axis| {
            let [a, b, c, d] = points.map(|p| p[axis]);
            a.plus(d).plus(b.plus(c).scaled(3.0)).scaled(0.125)
        });
        let (tangent, between) = self.distance_exactly(vector(middle.place), inner);
        self.take(part.parameter(0.5), between);
        let deepest = [&found[0].0, &tangent, &found[3].0].map(|tangent| {
            let depths = points.map(|p| -self.beyond(tangent, p));
            depths.into_iter().fold(0.0, f64::max)
        });
        let bounds = [
            found.iter().map(|(_, [_, high])| *high).fold(0.0, f64::max),
            deepest.into_iter().fold(f64::INFINITY, f64::min),
        ];
        // The coefficients of F have the right signs.
        let bounds = on_sides(part.excess_range(), bounds);
        if self.open(&part, bounds, self.last_place) != [false; 2] {
            self.leave(&part, cuts, bounds);
        }
    }

    /// The same by the digits of `f64`, and first by the length of the part and the distance of its middle. `None` where it does not lie farther
    /// than what is known.
    fn bounds_roughly(&mut self, part: &Part, middle: &Motion<f64>) -> Option<Roughly> {
        let excess = part.certain_excess();
        let points = part.polygon(self.center).map(|q| self.image(q));
        let size = points.iter().map(|p| p.hypot()).fold(0.0, f64::max);
        let slack = {
            let [x, y] = part.moved();
            4.0 * self.image(Vec2::new(x, y)).hypot() + 16.0 * f64::EPSILON * (1.0 + size)
        };
        let place = self.image(vector(middle.place));
        let inner = self.foot_roughly(place, slack);
        let reach = points.iter().map(|&p| (p - place).hypot());
        let reach = reach.fold(0.0, f64::max) + slack;
        let by_length = on_sides(excess, [inner.distance + reach, reach - inner.distance]);
        if !self.known.is_any_open(by_length) {
            return None;
        }
        let [from, to] = [points[0], points[3]].map(|p| self.foot_roughly(p, slack));
        let outer = points[1..3].iter().map(|&p| foot(self.radii, p).distance);
        let farthest = outer.fold(from.distance.max(to.distance), f64::max);
        let deepest = [&from, &inner, &to].map(|foot| {
            let n = foot.outward;
            let support = self.image(n).hypot();
            let depths = points.map(|p| support - n.dot(p));
            let is_known = depths.iter().all(|depth| depth.is_finite());
            let most = depths.into_iter().fold(0.0, f64::max);
            if is_known { most } else { f64::INFINITY }
        });
        let deepest = deepest.into_iter().fold(f64::INFINITY, f64::min);
        let by_points = on_sides(excess, [farthest + slack, deepest + slack]);
        let bounds = [0, 1].map(|side| f64::min(by_length[side], by_points[side]));
        self.known
            .is_any_open(bounds)
            .then_some(Roughly { bounds, slack })
    }

    /// The nearest point to a place of the segment, from which it is learnt what the largest distances are at least.
    fn foot_roughly(&mut self, place: Vec2, slack: f64) -> Foot {
        let foot = foot(self.radii, place);
        let side = usize::from(foot.distance < 0.0);
        self.known.learn(side, foot.distance.abs() - slack);
        foot
    }

    /// The tangent at the nearest point, and between what the signed distance lies, of a point that is nearly so in the frame, and exactly
    /// so about the centre of the exact one.
    pub(super) fn distance_exactly(&mut self, q: Vec2, exactly: Twice) -> (Tangent, [f64; 2]) {
        let unit = self.profile.larger_radius();
        let normal = foot(self.radii, self.image(q)).outward;
        let normal = normal.rotate_scale(self.profile.axis);
        let exact = &self.profile.exact;
        let tangents = self.tangents.get_or_insert_with(|| Tangents::new(exact));
        let tangent = tangents.tangent(normal);
        let between = tangents.distance(&tangent, exactly);
        (tangent, between.map(|d| d / unit))
    }

    /// At least how far a point lies beyond a tangent.
    fn beyond(&self, tangent: &Tangent, exactly: Twice) -> f64 {
        let tangents = self.tangents.as_ref();
        let least = tangents.map_or(f64::NEG_INFINITY, |all| all.beyond(tangent, exactly)[0]);
        least / self.profile.larger_radius()
    }
}

/// Bounds on both sides, none where F has the other sign all along.
fn on_sides([low, high]: [f64; 2], [outer, inner]: [f64; 2]) -> [f64; 2] {
    let unless = |none: bool, bound: f64| if none { 0.0 } else { bound };
    [unless(high <= 0.0, outer), unless(low >= 0.0, inner)]
}
