//! Bounds on the distance from an ellipse where a curve runs far from it, or where the nearest point jumps.

use kurbo::Vec2;

use super::part::{CubicPart, Motion};
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
    pub(super) fn bound_far(&mut self, part: &CubicPart, middle: &Motion<f64>, cuts: u32) {
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
    fn bounds_roughly(&mut self, part: &CubicPart, middle: &Motion<f64>) -> Option<Roughly> {
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
        let normal = self.image(foot(self.radii, self.image(q)).outward);
        let w = self.turn[0] * normal.x + self.turn[1] * normal.y;
        let exact = &self.profile.exact;
        let tangents = self.tangents.get_or_insert_with(|| Tangents::new(exact));
        let tangent = tangents.tangent(w);
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

#[cfg(test)]
mod tests {
    use kurbo::{Line, PathSeg, Point};

    use super::*;
    use crate::measure::radial::{Known, Profile};
    use crate::shape::Truth;

    type Quiet = fn(f64, [f64; 2]);

    /// Does something with a search along a line, from the ellipse whose radii are 1 and 1/2.
    fn searched<R>(
        ends: [(f64, f64); 2],
        known: &mut Known,
        act: impl FnOnce(&mut Search<'_, Quiet>, &CubicPart) -> R,
    ) -> R {
        let truth = Truth::new(Point::ORIGIN, Vec2::new(1.0, 0.5), Vec2::new(1.0, 0.0));
        let profile = Profile::new(&PathSeg::Line(Line::new(ends[0], ends[1])), &truth);
        let quiet: Quiet = |_, _| {};
        let mut search = Search::new(&profile, known, quiet);
        let (whole, _) = profile.part([0.0, 1.0], &profile.turn());
        act(&mut search, &whole)
    }

    #[test]
    fn a_far_part_lies_no_farther_than_its_points() {
        for (ends, expected) in [
            ([(2.0, 0.0), (3.0, 0.0)], [2.0, 0.0]),
            ([(0.0, -1.5), (0.0, -2.5)], [2.0, 0.0]),
            // Within, by the tangent at the point that is nearest to an end or to the middle.
            ([(0.0, 0.1), (0.0, 0.3)], [0.0, 0.4]),
            ([(0.0, -0.1), (0.0, -0.3)], [0.0, 0.4]),
            // From the centre of the flattest place outwards.
            ([(0.0, 0.1), (0.0, 1.5)], [1.0, 0.4]),
        ] {
            let mut known = Known::default();
            searched(ends, &mut known, |search, part| {
                let middle = part.motion_at(0.5, search.center);
                let Roughly { bounds, slack } = search.bounds_roughly(part, &middle).unwrap();
                // Four times what the points may be off, and sixteen roundings of the largest size.
                let size = f64::max(ends[1].0.abs(), ends[1].1.abs());
                let [x, y] = part.moved();
                let counted =
                    4.0 * Vec2::new(x, y / 2.0).hypot() + 16.0 * f64::EPSILON * (1.0 + size);
                assert!((slack - counted).abs() < 1e-9 * counted, "{slack:e}");
                for (bound, expected) in bounds.into_iter().zip(expected) {
                    assert!(bound >= expected, "{ends:?}: {bound}");
                    let more = if expected > 0.0 { slack + 1e-15 } else { 0.0 };
                    assert!(bound <= expected + more, "{ends:?}: {bound}");
                }
            });
            // The middle and the ends are learnt from.
            let most = expected[0].max(expected[1]);
            assert!(known.peak() <= most && known.peak() > most - 1e-12);
            for (side, expected) in expected.into_iter().enumerate() {
                assert!(!known.is_open(side, 0.9 * expected - 1e-9), "{ends:?}");
                assert!(known.is_open(side, expected + 1e-9), "{ends:?}");
            }
        }
    }

    #[test]
    fn a_part_that_is_known_to_lie_within_needs_no_look() {
        let mut known = Known::within(2.1);
        let is_told = searched([(2.0, 0.0), (3.0, 0.0)], &mut known, |search, part| {
            let middle = part.motion_at(0.5, search.center);
            search.bounds_roughly(part, &middle).is_some()
        });
        assert!(!is_told);
    }

    #[test]
    fn the_digits_of_f64_decide_far_above_what_is_known() {
        for (ends, limit, is_left, digits) in [
            // Far above it the part is left to be halved; hardly above it, it is looked at exactly.
            ([(2.0, 0.3), (3.0, 0.0)], 0.0, true, false),
            ([(2.0, 0.0), (3.0, 0.0)], 2.0 - 1e-14, false, true),
        ] {
            let mut known = Known::default();
            known.learn(0, limit);
            searched(ends, &mut known, |search, part| {
                // What the ends tell is above that already: the middle of a hump is not.
                let middle = part.motion_at(0.5, search.center);
                search.last_place = 1e-15;
                search.bound_far(part, &middle, 3);
                let found = search.tangents.is_some();
                assert!(found == digits || is_left, "{ends:?}");
            });
        }
    }
}
