//! The peaks of the distance from an ellipse by branch and bound, so that none is missed: docs/methods.md has the proof.

use core::cell::OnceCell;
use std::collections::BinaryHeap;

use kurbo::Vec2;

use super::Profile;
use super::known::Known;
use super::part::{CubicPart, Motion};
use super::place::{EXACT, NearestPoint};
use super::slopes::{multipliers, narrowed};
use super::tangents::Tangents;
use crate::numeric::ball::Ball;
use crate::numeric::double::{Double, Twice};
use crate::numeric::foot::foot_in_unit;
use crate::numeric::ranked::Ranked;

/// The largest x = |F| / (2 G b²), G = Σ αᵢ qᵢ² and b the smaller radius, for which a part passes for near. There s is F / (2 G) but for
/// a factor between 1 - 3x and 1 + 3x, and d is F / (2 √G) but for one between 1 - 2x and 1 + 1.3x.
pub(super) const NEAR: f64 = 0.1;

/// How often it is halved at most, and how many parts are halved: what is left then is stated by its bound.
pub(super) const MOST_CUTS: u32 = 48;
const MOST_HALVED: u32 = 5_000;

/// The search for the largest distance on either side: 0 is outside, 1 inside. The larger radius is the unit of length.
pub(super) struct Search<'a, F> {
    pub(super) profile: &'a Profile,
    pub(super) tangents: Option<Tangents>,
    pub(super) turn: [Vec2; 2],
    visit: F,
    pub(super) radii: Vec2,
    pub(super) center: Vec2,
    pub(super) alpha: [f64; 2],
    pub(super) known: &'a mut Known,
    /// The parts that have to be halved, by how far their bounds lie above what is known.
    pending: BinaryHeap<Ranked<Pending>>,
    /// Half a unit in the last place of the largest coordinate or so, or of the larger radius where that is less: no bound needs to be closer.
    pub(super) last_place: f64,
}

/// A part, how often it may be halved, and its bounds on either side.
struct Pending {
    part: CubicPart,
    cuts: u32,
    bounds: [f64; 2],
}

/// Visits places of a segment as (t, what the distance there lies between). What all of them lie between, and what was known before,
/// holds for the whole segment.
pub(super) fn visit(profile: &Profile, known: &mut Known, visit: impl FnMut(f64, [f64; 2])) {
    let mut search = Search::new(profile, known, visit);
    let (whole, points) = profile.part([0.0, 1.0], &search.turn);
    search.bound_first(&whole);
    search.end(&whole, 0.0, points[0]);
    search.end(&whole, 1.0, points[3]);
    search.close();
}

impl<'a, F: FnMut(f64, [f64; 2])> Search<'a, F> {
    pub(super) fn new(profile: &'a Profile, known: &'a mut Known, visit: F) -> Self {
        let unit = profile.larger_radius();
        // By quotients: the larger one is 1 to the last digit.
        let radii = Vec2::new(profile.radii.x / unit, profile.radii.y / unit);
        let turn = profile.turn();
        let center = profile.exact.center().map(Double::value);
        Self {
            profile,
            tangents: None,
            turn,
            visit,
            radii,
            center: vector(turn.map(|row| row.dot(vector(center)))),
            alpha: [radii.x, radii.y].map(|r| 1.0 / (r * r)),
            known,
            pending: BinaryHeap::new(),
            last_place: 0.5 * f64::EPSILON * (profile.largest_coordinate / unit).min(1.0),
        }
    }
}

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Halves the parts that are left, those of the largest bounds first.
    fn close(&mut self) {
        let mut halved = 0;
        while !self.known.is_beyond()
            && let Some(Ranked { of: pending, .. }) = self.pending.pop()
        {
            let Pending { part, cuts, bounds } = pending;
            if self.open(&part, bounds, self.last_place) == [false; 2] {
                continue;
            }
            if cuts > 0 && halved < MOST_HALVED {
                halved += 1;
                for half in part.halves() {
                    self.bound(&half, cuts - 1);
                }
                continue;
            }
            for (side, bound) in bounds.into_iter().enumerate() {
                if self.known.is_open(side, bound) {
                    self.state(&part, side, bound);
                }
            }
        }
    }

    /// The same part by points and coefficients that are rounded once.
    pub(super) fn refreshed(&self, part: &CubicPart) -> (CubicPart, [Twice; 4]) {
        self.profile.part(part.parameters(), &self.turn)
    }

    /// Visits an end of the segment, where F is one coefficient and the point is known in twice the digits.
    fn end(&mut self, whole: &CubicPart, t: f64, point: Twice) {
        let motion = whole.motion_at(t, self.center);
        let excess = [-1.0, 1.0].map(|side| motion.excess * (1.0 + side * f64::EPSILON));
        let gradient = motion.gradient(self.alpha) * (1.0 - 1e-9);
        if self.is_settled(excess, gradient) {
            return;
        }
        let place = self.place(whole, &motion, f64::EPSILON * motion.excess.abs());
        if place.is_exact(self.last_place) {
            self.take(t, place.between(0.0));
        } else {
            let point = self.profile.about_center(point);
            let between = self.distance_exactly(vector(motion.place), point).1;
            self.take(t, between);
        }
    }

    /// Bounds the distance on a part, which has to be halved until none of it can lie above what is known, or its one extreme is found.
    pub(super) fn bound(&mut self, part: &CubicPart, cuts: u32) {
        if self.known.is_beyond() {
            return;
        }
        let look = self.look(part);
        let near = look.bounds();
        if near.is_some_and(|bounds| !self.known.is_any_open(bounds)) {
            return;
        }
        let middle = part.motion_at(0.5, self.center);
        if let Some(bounds) = near {
            let course = self.course(part, &middle, &look);
            if course.is_monotone() {
                return;
            }
            let start = 0.5 + self.step(&middle);
            if self.leads_to_extreme(part, &course, bounds, start) {
                return;
            }
        }
        let excess = part.certain_excess();
        let rounded = part.rounded(&middle);
        let motion = part.spread(&rounded);
        let gradients = self.gradients(&motion);
        let Some(bounds) = self.bounds(excess, gradients[0]) else {
            self.bound_far(part, &middle, cuts);
            return;
        };
        let open = self.open(part, bounds, self.last_place);
        if open == [false; 2] {
            return;
        }
        let place = self.place(part, &middle, part.rounding());
        if !place.foot.is_exact {
            self.bound_far(part, &middle, cuts);
            return;
        }
        let near = Near {
            middle,
            rounded,
            motion,
            gradients,
            place,
        };
        let Some(bounds) = self.bound_by_slopes(part, &near, bounds, open) else {
            return;
        };
        if self.open(part, bounds, self.last_place) == [false; 2] {
            return;
        }
        if !part.is_fresh && self.is_coarse(part, gradients[0]) {
            let part = self.refreshed(part).0;
            self.bound(&part, cuts);
        } else {
            self.leave(part, cuts, bounds);
        }
    }

    /// Bounds the distance on a near part by N and N'; `None` where nothing of it is left to be bounded.
    fn bound_by_slopes(
        &mut self,
        part: &CubicPart,
        near: &Near,
        mut bounds: [f64; 2],
        open: [bool; 2],
    ) -> Option<[f64; 2]> {
        let Near {
            middle,
            rounded,
            motion,
            gradients,
            place,
        } = near;
        let excess = part.certain_excess();
        let x = self.nearness(excess[0].abs().max(excess[1].abs()), gradients[0]);
        let at = middle.slopes(self.alpha, place.foot.multiplier);
        let mut s = multipliers(excess, *gradients, x, place.multiplier());
        let (alpha, certain) = (self.alpha, OnceCell::new());
        let certain = || *certain.get_or_init(|| rounded.slopes(alpha, place.multiplier()).slope);
        for _ in 0..2 {
            let all = motion.slopes(self.alpha, s);
            let half = all.bend.size() / 2.0;
            // Either the distance rises or falls all along, or N does.
            if at.slope.abs() > half && at.slope.abs() > half + certain().radius {
                return None;
            }
            let curving = all.bend.middle.abs() - all.bend.radius;
            let side = usize::from(all.bend.middle > 0.0);
            if curving > 0.0
                && (!open[side] || self.settle(part, 0.5 - at.slope / at.bend, curving))
            {
                return None;
            }
            // What s is at the middle and how fast it changes says more than F and G do where the part is short.
            s = narrowed(s, place.multiplier(), all.rate.size());
            let steepest = certain().size() + half;
            let growth = place.margin + 0.6 * steepest / gradients[0].sqrt();
            let distance = place.foot.foot.distance;
            bounds[0] = bounds[0].min(distance + growth);
            bounds[1] = bounds[1].min(growth - distance);
        }
        Some(bounds)
    }

    /// Whether the rounding of a part's coefficients and points alone keeps the distance from being stated.
    fn is_coarse(&self, part: &CubicPart, gradient: f64) -> bool {
        let [x, y] = part.moved();
        let share = f64::max(x * self.alpha[0].sqrt(), y * self.alpha[1].sqrt());
        let allowed = 0.25 * self.last_place + self.known.close_by();
        part.rounding() > allowed * gradient.sqrt() || share > 0.1 * EXACT
    }

    /// Whether what F and G say of the distance leaves nothing open.
    fn is_settled(&self, excess: [f64; 2], gradient: f64) -> bool {
        let bounds = self.bounds(excess, gradient);
        bounds.is_some_and(|bounds| !self.known.is_any_open(bounds))
    }

    /// What F and G say of the distance on both sides; `None` where a part is not near.
    fn bounds(&self, excess: [f64; 2], gradient: f64) -> Option<[f64; 2]> {
        self.look_by(excess, gradient).bounds()
    }

    /// Leaves a part to be halved.
    pub(super) fn leave(&mut self, part: &CubicPart, cuts: u32, bounds: [f64; 2]) {
        let rank = self.known.most_above(bounds);
        let part = *part;
        let of = Pending { part, cuts, bounds };
        self.pending.push(Ranked { rank, of });
    }

    /// On which sides a part may lie farther than what is known. A bound that is hardly above it, for its own rounding, is stated.
    pub(super) fn open(&mut self, part: &CubicPart, bounds: [f64; 2], rounding: f64) -> [bool; 2] {
        [0, 1].map(|side| {
            let bound = bounds[side];
            let is_open = self.known.is_open(side, bound);
            let is_close = self.known.is_close(side, bound, rounding);
            if is_open && is_close {
                self.state(part, side, bound);
            }
            is_open && !is_close
        })
    }

    fn state(&mut self, part: &CubicPart, side: usize, bound: f64) {
        self.known.state(side, bound);
        // No distance there is known to be as large.
        let between = [[0.0, bound], [-bound, 0.0]][side];
        let larger = self.profile.larger_radius();
        (self.visit)(part.parameter(0.5), between.map(|bound| bound * larger));
    }

    /// Takes what the signed distance at a place lies between.
    pub(super) fn take(&mut self, t: f64, [low, high]: [f64; 2]) {
        for (side, [least, most]) in [[low, high], [-high, -low]].into_iter().enumerate() {
            self.known.learn(side, least);
            self.known.state(side, most);
        }
        (self.visit)(t, [low, high].map(|d| d * self.profile.larger_radius()));
    }

    /// The nearest point at a place where F is off so far at most.
    fn place(&self, part: &CubicPart, motion: &Motion<f64>, rounding: f64) -> NearestPoint {
        let point = self.image(vector(motion.place));
        let foot = foot_in_unit(self.radii, self.alpha, point, motion.excess);
        NearestPoint::new(self.alpha, part, motion, foot, rounding)
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

    pub(super) fn image(&self, q: Vec2) -> Vec2 {
        Vec2::new(q.x * self.radii.x, q.y * self.radii.y)
    }
}

/// A near part: what its derivatives are at its middle, known as plain numbers and within bounds, and on all of it.
struct Near {
    middle: Motion<f64>,
    rounded: Motion<Ball>,
    motion: Motion<Ball>,
    gradients: [f64; 2],
    place: NearestPoint,
}

pub(super) fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

#[cfg(test)]
mod checks;
