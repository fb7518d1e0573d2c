//! The peaks of the distance from an ellipse by branch and bound, so that none is missed: docs/methods.md has the proof.

use kurbo::Vec2;

use super::Profile;
use super::part::{Motion, Part};
use super::slopes::{Slopes, multipliers};
use crate::numeric::ball::Ball;
use crate::numeric::foot::{Foot, FootByExcess, foot, foot_by_excess};

/// The largest x = |F| / (2 G b²), G = Σ αᵢ qᵢ² and b the smaller radius, for which a part passes for near. There s is F / (2 G) but for
/// a factor between 1 - 3x and 1 + 3x, and d is F / (2 √G) but for one between 1 - 2x and 1 + 1.3x.
const NEAR: f64 = 0.1;

/// A bound that is above a known distance by so little is stated, as a share of the distance.
const CLOSE: f64 = 1e-11;

/// What Newton's method may leave of the distance, as a share of it.
const LEFT: f64 = 1e-12;

/// How many steps of Newton's method are taken at most.
const MOST_STEPS: usize = 8;

/// How often a segment is halved at first: its parts then mostly have one extreme at most.
const FIRST_CUTS: u32 = 3;

/// How often it is halved at most, and how many parts are halved: what is left then is stated by its bound.
const MOST_CUTS: u32 = 48;
const MOST_HALVED: u32 = 20_000;

/// The search for the largest distance on either side: 0 is outside, 1 inside.
struct Search<'a, F> {
    profile: &'a Profile,
    visit: F,
    /// The radii and the centre in the search's unit, and α.
    radii: Vec2,
    center: Vec2,
    alpha: [f64; 2],
    /// What rounding may have done to F.
    rounding: f64,
    /// What the largest distance is at least.
    least: [f64; 2],
    /// The largest that was stated.
    stated: [f64; 2],
    halved: u32,
    /// Half a unit in the last place of the largest coordinate or so: no bound needs to be closer.
    last_place: f64,
}

/// The nearest point at a place, and how far the distance may be off.
struct Place {
    foot: FootByExcess,
    margin: f64,
}

/// Visits places of a segment as (t, what the distance there lies between). What all of them lie between holds for the whole segment.
pub(super) fn visit(profile: &Profile, visit: impl FnMut(f64, [f64; 2])) {
    let own = &profile.radii;
    let unit = profile.larger_radius();
    let radii = *own / unit;
    let whole = profile.part();
    let mut search = Search {
        profile,
        visit,
        radii,
        center: Vec2::new(profile.center.x / own.x, profile.center.y / own.y),
        alpha: [radii.x, radii.y].map(|r| 1.0 / (r * r)),
        rounding: 9.0 * f64::EPSILON * profile.excess.largest(),
        least: [0.0; 2],
        stated: [0.0; 2],
        halved: 0,
        last_place: 0.5
            * f64::EPSILON
            * f64::max(whole.size().x * radii.x, whole.size().y * radii.y),
    };
    search.end(&whole, 0.0);
    let mut parts = Vec::with_capacity(1 << FIRST_CUTS);
    search.cut(whole, FIRST_CUTS, &mut parts);
    for part in &parts {
        search.bound(part, MOST_CUTS);
    }
    search.end(&whole, 1.0);
}

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Cuts a part, and learns from the middle of each piece what the largest distances are at least.
    fn cut(&mut self, part: Part, cuts: u32, parts: &mut Vec<Part>) {
        if cuts > 0 {
            for half in part.halves() {
                self.cut(half, cuts - 1, parts);
            }
            return;
        }
        let (q, excess) = part.middle(self.center);
        let gradient = self.alpha[0] * q.x * q.x + self.alpha[1] * q.y * q.y;
        let x = self.nearness(excess, gradient);
        if x <= NEAR {
            let least = excess.abs() * (1.0 - 2.0 * x - 1e-9) - self.rounding;
            let side = usize::from(excess < 0.0);
            self.least[side] = self.least[side].max(least / (2.0 * gradient.sqrt()));
        }
        parts.push(part);
    }

    /// Visits an end of the segment, where F is one coefficient.
    fn end(&mut self, whole: &Part, t: f64) {
        let place = self.place(whole, &whole.motion_at(t, self.center), 0.0);
        self.take(t, &place, 0.0);
    }

    /// Bounds the distance on a part, which is halved until none of it can lie above what is known, or its one extreme is found.
    fn bound(&mut self, part: &Part, cuts: u32) {
        let [low, high] = part.excess_range();
        let most = high.max(-low);
        let rounding = self.rounding_of(part);
        // First by the control points, which cost little.
        let [p, q] = part.least_place(self.center);
        let gradient = (self.alpha[0] * p * p + self.alpha[1] * q * q) * (1.0 - 1e-14);
        if let Some(bounds) = self.bounds([low, high], gradient, rounding)
            && [0, 1].iter().all(|&side| !self.is_open(side, bounds[side]))
        {
            return;
        }
        let middle = part.motion_at(0.5, self.center);
        let rounded = part.rounded(&middle);
        let motion = part.spread(&rounded);
        let gradients = self.gradients(&motion);
        let Some(mut bounds) = self.bounds([low, high], gradients[0], rounding) else {
            self.bound_far(part, &middle, cuts);
            return;
        };
        let open = self.open(part, bounds, self.last_place);
        if open == [false; 2] {
            return;
        }
        let x = self.nearness(most, gradients[0]);
        let place = self.place(part, &middle, rounding);
        let at = middle.slopes(self.alpha, place.foot.multiplier);
        let mut s = multipliers([low, high], gradients, x, place.multiplier());
        for _ in 0..2 {
            let all = motion.slopes(self.alpha, s);
            let alpha = self.alpha;
            let certain = || rounded.slopes(alpha, place.multiplier()).slope;
            let half = all.bend.size() / 2.0;
            // Either the distance rises or falls all along, or N does.
            if at.slope.abs() > half && at.slope.abs() > half + certain().radius {
                return;
            }
            let curving = all.bend.middle.abs() - all.bend.radius;
            let side = usize::from(all.bend.middle > 0.0);
            if curving > 0.0 && (!open[side] || self.settle(part, &at, curving, rounding)) {
                return;
            }
            // What s is at the middle and how fast it changes says more than F and G do where the part is short.
            s.radius = s
                .radius
                .min(place.multiplier().radius + all.rate.size() / 2.0);
            let steepest = certain().size() + half;
            let growth = place.margin + 0.6 * steepest / gradients[0].sqrt();
            let distance = place.foot.foot.distance;
            bounds[0] = bounds[0].min(distance + growth);
            bounds[1] = bounds[1].min(growth - distance);
        }
        if self.open(part, bounds, self.last_place) != [false; 2] {
            self.halve(part, cuts, bounds);
        }
    }

    /// What F and G say of the distance on both sides; `None` where a part is not near.
    fn bounds(&self, [low, high]: [f64; 2], gradient: f64, rounding: f64) -> Option<[f64; 2]> {
        let x = self.nearness(high.max(-low), gradient);
        let weight = (1.0 + 1.3 * x + 1e-14) / (2.0 * gradient.sqrt());
        (x <= NEAR).then_some([(high + rounding) * weight, (rounding - low) * weight])
    }

    /// The same where the bounds of F say little. The signed distance from a convex shape is a convex function of the point: it is at
    /// most the largest of the control points, and at least that from the tangent at any point of the shape.
    fn bound_far(&mut self, part: &Part, middle: &Motion<f64>, cuts: u32) {
        let rounding = self.rounding_of(part);
        let place = self.place(part, middle, rounding);
        self.take(part.parameter(0.5), &place, 0.0);
        let [low, high] = part.excess_range();
        let Foot { distance, outward } = place.foot.foot;
        let point = self.image(Vec2::new(middle.place[0], middle.place[1]));
        let size = rounding_along(self.image(part.size()), outward);
        let arms = part.arms().map(|q| self.image(q));
        let reach = arms
            .iter()
            .fold(0.0, |most, arm| f64::max(most, arm.hypot()));
        let deepest = arms
            .iter()
            .fold(0.0, |least, arm| f64::min(least, arm.dot(outward)));
        let slack = place.margin + 3.0 * size + 2.0 * f64::EPSILON * reach;
        let mut bounds = [distance + reach, -distance - deepest].map(|bound| bound + slack);
        for (bound, none) in bounds.iter_mut().zip([high <= 0.0, low >= 0.0]) {
            if none {
                *bound = 0.0;
            }
        }
        if self.is_open(0, bounds[0]) {
            let polygon = part.polygon(self.center).map(|q| self.image(q));
            let largest = polygon.iter().map(|&p| {
                let Foot { distance, outward } = foot(self.radii, p);
                distance + 2.0 * rounding_along(p, outward) + self.coordinate_rounding(p)
            });
            bounds[0] = bounds[0].min(largest.fold(0.0, f64::max));
        }
        // The largest of a convex function on a straight part is at one of its ends.
        for t in [0.0, 1.0] {
            let place = self.place(part, &part.motion_at(t, self.center), rounding);
            self.take(part.parameter(t), &place, 0.0);
        }
        let rounding = 1.5 * slack + self.coordinate_rounding(point);
        if self.open(part, bounds, rounding) != [false; 2] {
            self.halve(part, cuts, bounds);
        }
    }

    fn halve(&mut self, part: &Part, cuts: u32, bounds: [f64; 2]) {
        if cuts > 0 && self.halved < MOST_HALVED {
            self.halved += 1;
            for half in part.halves() {
                self.bound(&half, cuts - 1);
            }
            return;
        }
        for (side, bound) in bounds.into_iter().enumerate() {
            if self.is_open(side, bound) {
                self.state(part, side, bound);
            }
        }
    }

    /// On which sides a part may lie farther than what is known. A bound that is hardly above it, for its own rounding, is stated.
    fn open(&mut self, part: &Part, bounds: [f64; 2], rounding: f64) -> [bool; 2] {
        [0, 1].map(|side| {
            let bound = bounds[side];
            let is_open = self.is_open(side, bound);
            let is_close = bound <= self.least[side] * (1.0 + CLOSE) + rounding;
            if is_open && is_close {
                self.state(part, side, bound);
            }
            is_open && !is_close
        })
    }

    fn is_open(&self, side: usize, bound: f64) -> bool {
        bound > self.stated[side] && bound >= self.least[side]
    }

    fn state(&mut self, part: &Part, side: usize, bound: f64) {
        self.stated[side] = bound;
        let signed = [bound, -bound][side] * self.profile.larger_radius();
        (self.visit)(part.parameter(0.5), [signed; 2]);
    }

    /// Takes the distance at a place, and as much more as there may be beside it.
    fn take(&mut self, t: f64, place: &Place, more: f64) {
        let distance = place.foot.foot.distance;
        let sides = [distance, -distance];
        for (side, distance) in sides.into_iter().enumerate() {
            self.least[side] = self.least[side].max(distance - place.margin);
            self.stated[side] = self.stated[side].max(distance + place.margin + more);
        }
        let [most, least] = sides.map(|distance| distance + place.margin + more);
        (self.visit)(t, [-least, most].map(|d| d * self.profile.larger_radius()));
    }

    /// Finds the extreme of a part on which |N'| is at least `curving`, from what they are at its middle; whether it did. From a place on, the
    /// distance grows by N² / (2 √g curving) at most.
    fn settle(&mut self, part: &Part, at: &Slopes<f64>, curving: f64, rounding: f64) -> bool {
        let mut t = 0.5 - at.slope / at.bend;
        for steps in 0..MOST_STEPS {
            t = t.clamp(0.0, 1.0);
            let motion = part.motion_at(t, self.center);
            let point = self.image(Vec2::new(motion.place[0], motion.place[1]));
            let foot = foot_by_excess(self.radii, point, motion.excess);
            let Slopes { slope, bend, .. } = motion.slopes(self.alpha, foot.multiplier);
            let step = -slope / bend;
            if step.abs() > 1e-6 && (t + step).clamp(0.0, 1.0) != t && steps + 1 < MOST_STEPS {
                t += step;
                continue;
            }
            let place = self.place_at(part, &motion, foot, rounding);
            let at = part.rounded(&motion).slopes(self.alpha, place.multiplier());
            let steep = at.slope.size();
            // g is at least 0.6 G where a part is near.
            let gradient: f64 = (0..2)
                .map(|i| self.alpha[i] * motion.place[i] * motion.place[i])
                .sum();
            let more = 0.7 * steep * steep / (curving * gradient.sqrt());
            let is_beyond = (t == 0.0 && step < 0.0) || (t == 1.0 && step > 0.0);
            if is_beyond || more <= LEFT * place.foot.foot.distance.abs() + place.margin {
                self.take(
                    part.parameter(t),
                    &place,
                    if is_beyond { 0.0 } else { more },
                );
                return true;
            }
            t += step;
        }
        false
    }

    /// The least and the largest G.
    fn gradients(&self, motion: &Motion<Ball>) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (ball, alpha) in motion.place.into_iter().zip(self.alpha) {
            let least = (ball.middle.abs() - ball.radius).max(0.0);
            sum[0] += alpha * least * least;
            sum[1] += alpha * ball.size() * ball.size();
        }
        [sum[0] * (1.0 - 1e-15), sum[1] * (1.0 + 1e-15)]
    }

    /// x.
    fn nearness(&self, excess: f64, gradient: f64) -> f64 {
        excess.abs() / (2.0 * gradient) * self.alpha[0].max(self.alpha[1])
    }

    fn image(&self, q: Vec2) -> Vec2 {
        Vec2::new(q.x * self.radii.x, q.y * self.radii.y)
    }

    /// The nearest point at a place where F is off so far at most.
    fn place(&self, part: &Part, motion: &Motion<f64>, rounding: f64) -> Place {
        let [x, y] = motion.place;
        let point = self.image(Vec2::new(x, y));
        let foot = foot_by_excess(self.radii, point, motion.excess);
        self.place_at(part, motion, foot, rounding)
    }

    /// The same where the nearest point is known.
    fn place_at(
        &self,
        part: &Part,
        motion: &Motion<f64>,
        foot: FootByExcess,
        rounding: f64,
    ) -> Place {
        let q = motion.place;
        let point = self.image(Vec2::new(q[0], q[1]));
        let size = part.size();
        let off = [
            f64::EPSILON * (8.0 * size.x + q[0].abs()),
            f64::EPSILON * (8.0 * size.y + q[1].abs()),
        ];
        let distance = foot.foot.distance.abs();
        if !foot.is_exact {
            let along = rounding_along(point, foot.foot.outward);
            let margin = along + self.coordinate_rounding(point) + 4.0 * f64::EPSILON * distance;
            return Place { foot, margin };
        }
        // How s, and with it the distance, follows from F and from q.
        let s = foot.multiplier;
        let (mut moved, mut strayed, mut d, mut g) = (0.0, 0.0, 0.0, 0.0);
        for (i, alpha) in self.alpha.into_iter().enumerate() {
            let m = 1.0 / (1.0 + s * alpha);
            let off = off[i] + self.profile.coordinates * alpha.sqrt();
            let along = alpha * m * q[i].abs() * off;
            moved += along * (1.0 + m);
            strayed += along * m;
            d += alpha * m * m * m * q[i] * q[i];
            g += alpha * m * m * q[i] * q[i];
        }
        let share = moved / d + strayed / g + 16.0 * f64::EPSILON;
        let margin = distance * share + rounding * 0.6 * g.sqrt() / d;
        Place { foot, margin }
    }

    /// What else may be off of a distance that comes from coordinates: the nearest point, and the map that made them.
    fn coordinate_rounding(&self, point: Vec2) -> f64 {
        let smaller = self.radii.x.min(self.radii.y);
        3.0 * f64::EPSILON * smaller + self.profile.coordinates * point.hypot().max(1.0)
    }

    /// What rounding may have done to F on a part: on all of them, where that is little.
    fn rounding_of(&self, part: &Part) -> f64 {
        if self.rounding <= 1e-11 * self.least[0].max(self.least[1]) {
            return self.rounding;
        }
        let [from, to] = [0.0, 1.0].map(|t| part.parameter(t));
        9.0 * f64::EPSILON * self.profile.excess.sizes().largest_between(from, to)
    }
}

impl Place {
    fn multiplier(&self) -> Ball {
        let s = self.foot.multiplier;
        Ball::new(s, 8.0 * f64::EPSILON * s.abs())
    }
}

/// What the rounding of a point's coordinates does along a normal.
fn rounding_along(point: Vec2, normal: Vec2) -> f64 {
    f64::EPSILON * ((point.x * normal.x).abs() + (point.y * normal.y).abs())
}
