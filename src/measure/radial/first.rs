//! The first parts of a segment, looked at side by side: mostly they tell which of them holds an extreme of the distance, and all else is
//! settled.

use std::sync::LazyLock;

use kurbo::Vec2;

use super::part::{CubicPart, largest};
use super::peaks::{MOST_CUTS, NEAR, Search};
use super::quick::{DistanceRun, PartBounds};
use crate::numeric::ball::Number;
use crate::numeric::instructions::by_the_best;
use crate::numeric::lanes::{Lanes, Real};

/// How many there are, and something of each.
const LANES: usize = 8;
type PartLanes = Lanes<LANES>;

/// Where a segment is cut at first, in 64ths: of a curve near the shape the third, fifth and seventh part have one extreme each, and
/// little lies as far between them. Where the distance weighs less, towards the end, fewer parts do.
const CUTS: [f64; LANES + 1] = [0.0, 5.5, 9.5, 15.5, 27.0, 37.0, 48.5, 57.0, 64.0];

/// How far a coefficient of a part may be off, in roundings of the largest of the segment: it is a sum of seven products with weights that are
/// exact, that of a control point of four.
const ROUNDINGS: [f64; 2] = [4.0, 2.5];

/// What makes the coefficients of the parts of those of a segment: of every part's coefficient j the weight of the segment's i, at [j][i].
struct PartWeights {
    from: PartLanes,
    width: PartLanes,
    excess: [[PartLanes; 7]; 7],
    points: [[PartLanes; 4]; 4],
}

/// Of the parts by these cuts, and of those by their mirror images.
static WEIGHTS: LazyLock<[PartWeights; 2]> = LazyLock::new(|| {
    let cuts = CUTS.map(|place| place / 64.0);
    let mut mirrored = cuts.map(|place| 1.0 - place);
    mirrored.reverse();
    [cuts, mirrored].map(|cuts| PartWeights {
        from: Lanes(core::array::from_fn(|i| cuts[i])),
        width: Lanes(core::array::from_fn(|i| cuts[i + 1] - cuts[i])),
        excess: weights(&cuts),
        points: weights(&cuts),
    })
});

/// By blossoms of Bernstein's polynomials, from 128ths without a rounding error.
fn weights<const N: usize>(cuts: &[f64; LANES + 1]) -> [[PartLanes; N]; N] {
    core::array::from_fn(|j| {
        core::array::from_fn(|i| {
            Lanes(core::array::from_fn(|lane| {
                let mut row = [0.0; N];
                row[i] = 1.0;
                for last in (1..N).rev() {
                    let t = cuts[lane + usize::from(last <= j)];
                    for k in 0..last {
                        row[k] = (1.0 - t) * row[k] + t * row[k + 1];
                    }
                }
                row[0]
            }))
        })
    })
}

/// The parts, and what is known of each.
struct First {
    parts: CubicPart<PartLanes>,
    /// The distance in the middle, nearly, and what it is at least where that is near.
    middle: PartLanes,
    least: PartLanes,
    nearness: PartLanes,
    look: PartBounds<PartLanes>,
    course: DistanceRun<PartLanes>,
    /// How far from the middle its extreme lies, nearly, if there is one.
    step: PartLanes,
}

impl First {
    #[inline(always)]
    fn new<F: FnMut(f64, [f64; 2])>(search: &Search<'_, F>, whole: &CubicPart) -> Self {
        let [from, .., to] = whole.polygon(search.center);
        let steepness = |q: Vec2| search.alpha[0] * q.x * q.x + search.alpha[1] * q.y * q.y;
        let is_mirrored = steepness(to) < steepness(from);
        let parts = CubicPart::first(whole, &WEIGHTS[usize::from(is_mirrored)]);
        let look = search.look(&parts);
        let motion = parts.motion_at(PartLanes::exact(0.5), search.center);
        let gradient = motion.gradient(search.alpha);
        let nearness = search.nearness(motion.excess, gradient);
        let share = PartLanes::exact(1.0 - 1e-9) - nearness.scaled(2.0);
        let root = gradient.sqrt();
        Self {
            middle: motion.excess / root,
            least: (motion.excess.abs() * share - parts.rounding()) / root.scaled(2.0),
            nearness,
            course: search.course(&parts, &motion, &look),
            step: search.step(&motion),
            look,
            parts,
        }
    }

    /// The part that seems to lie the farthest on a side.
    fn farthest(&self, sign: f64) -> usize {
        let is_farther = |a: usize, b: usize| sign * self.middle.0[a] > sign * self.middle.0[b];
        (1..LANES).fold(
            0,
            |far, lane| if is_farther(lane, far) { lane } else { far },
        )
    }
}

impl CubicPart<PartLanes> {
    #[inline(always)]
    fn first(whole: &CubicPart, weights: &PartWeights) -> Self {
        let excess = mixed(&whole.excess, &weights.excess);
        let [x, y] = &whole.points;
        let points = [mixed(x, &weights.points), mixed(y, &weights.points)];
        let [off, moved] = ROUNDINGS.map(|roundings| roundings * f64::EPSILON);
        Self {
            from: weights.from,
            width: weights.width,
            largest: largest(&excess),
            rounding: PartLanes::exact(whole.rounding + off * whole.largest),
            excess,
            reach: [largest(&points[0]), largest(&points[1])],
            points,
            moved: [
                PartLanes::exact(whole.moved[0] + moved * whole.reach[0]),
                PartLanes::exact(whole.moved[1] + moved * whole.reach[1]),
            ],
            is_fresh: false,
        }
    }

    /// One of them.
    fn one(&self, lane: usize) -> CubicPart {
        let row = |row: [PartLanes; 4]| row.map(|lanes| lanes.0[lane]);
        CubicPart {
            from: self.from.0[lane],
            width: self.width.0[lane],
            excess: self.excess.map(|lanes| lanes.0[lane]),
            rounding: self.rounding.0[lane],
            points: self.points.map(row),
            moved: self.moved.map(|lanes| lanes.0[lane]),
            largest: self.largest.0[lane],
            reach: self.reach.map(|lanes| lanes.0[lane]),
            is_fresh: self.is_fresh,
        }
    }
}

/// The coefficients of all parts.
#[inline(always)]
fn mixed<const N: usize>(coefficients: &[f64; N], weights: &[[PartLanes; N]; N]) -> [PartLanes; N] {
    let mut parts = [PartLanes::exact(0.0); N];
    for (part, row) in parts.iter_mut().zip(weights) {
        for (weight, &coefficient) in row.iter().zip(coefficients) {
            *part = *part + weight.scaled(coefficient);
        }
    }
    parts
}

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Bounds the distance on the first parts. Those that seem the farthest come first: their extremes leave little to be found of the others.
    pub(super) fn bound_first(&mut self, whole: &CubicPart) {
        let first = by_the_best(
            #[inline(always)]
            || First::new(self, whole),
        );
        for lane in 0..LANES {
            if first.nearness.0[lane] <= NEAR {
                let side = usize::from(first.middle.0[lane] < 0.0);
                self.known.learn(side, first.least.0[lane]);
            }
        }
        let farthest = [first.farthest(1.0), first.farthest(-1.0)];
        let rest = (0..LANES).filter(|lane| !farthest.contains(lane));
        for lane in farthest.into_iter().chain(rest) {
            self.bound_one(&first, lane);
        }
    }

    fn bound_one(&mut self, first: &First, lane: usize) {
        let Some(bounds) = first.look.one(lane).bounds() else {
            self.bound(&first.parts.one(lane), MOST_CUTS);
            return;
        };
        if !self.known.is_any_open(bounds) || self.known.is_beyond() {
            return;
        }
        let course = first.course.one(lane);
        if course.is_monotone() {
            return;
        }
        let part = first.parts.one(lane);
        if !self.leads_to_extreme(&part, &course, bounds, 0.5 + first.step.0[lane]) {
            // Mostly sizes tell of the halves, which cost less than what tells more of the whole.
            for half in part.halves() {
                self.bound(&half, MOST_CUTS - 1);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{CubicBez, PathSeg, Point};

    use super::*;
    use crate::measure::radial::{Known, Profile};
    use crate::shape::Truth;

    #[test]
    fn the_first_parts_are_pieces_of_the_whole_one_after_the_other() {
        let excess = [0.5, 1.0, -2.0, 0.5, 3.0, -1.0, 0.25];
        let points = [[1.0, 2.0, -1.0, 0.5], [0.0, 0.3, 0.7, 1.5]];
        let whole = CubicPart::new([0.0, 1.0], excess, points, false);
        let center = Vec2::new(0.25, -0.5);
        for weights in &*WEIGHTS {
            let parts = CubicPart::first(&whole, weights);
            let mut end = 0.0;
            for part in (0..LANES).map(|lane| parts.one(lane)) {
                let [from, to] = part.parameters();
                assert_eq!(from, end);
                end = to;
                for t in [0.0, 0.3, 1.0] {
                    let (own, all) = (
                        part.motion_at(t, center),
                        whole.motion_at(part.parameter(t), center),
                    );
                    let (allowed, moved) = (part.rounding() + whole.rounding(), part.moved());
                    assert!((own.excess - all.excess).abs() <= allowed);
                    for (i, (moved, more)) in moved.into_iter().zip(whole.moved()).enumerate() {
                        assert!((own.place[i] - all.place[i]).abs() <= moved + more);
                    }
                    let speed = own.velocity[0] / (to - from);
                    assert!((speed - all.velocity[0]).abs() < 1e-13);
                }
            }
            assert_eq!(end, 1.0);
            // Every sum of seven products, or of four, is rounded.
            let part = parts.one(3);
            assert_eq!(part.rounding, whole.rounding + 4.0 * f64::EPSILON * 3.0);
            for (i, reach) in [2.0, 1.5].into_iter().enumerate() {
                assert_eq!(part.moved[i], whole.moved[i] + 2.5 * f64::EPSILON * reach);
            }
        }
    }

    #[test]
    fn the_middle_of_a_first_part_tells_how_far_it_lies_at_least() {
        let truth = Truth::new(Point::ORIGIN, Vec2::new(1.0, 0.5), Vec2::new(1.0, 0.0));
        // Outside, inside, and across.
        for off in [
            [0.01, 0.02, 0.01, 0.03],
            [-0.02, -0.01, -0.03, -0.01],
            [0.02, -0.02, 0.01, -0.01],
        ] {
            let k = 0.5523;
            let ideal = [(1.0, 0.0), (1.0, k), (k, 1.0), (0.0, 1.0)];
            let mut ends = [Point::ORIGIN; 4];
            for ((end, (x, y)), off) in ends.iter_mut().zip(ideal).zip(off) {
                *end = Point::new(x * (1.0 + off), 0.5 * y * (1.0 + off));
            }
            let curve = CubicBez::new(ends[0], ends[1], ends[2], ends[3]);
            let profile = Profile::new(&PathSeg::Cubic(curve), &truth);
            let mut known = Known::default();
            let mut search = Search::new(&profile, &mut known, |_, _| {});
            let (whole, _) = profile.part([0.0, 1.0], &profile.turn());
            let first = First::new(&search, &whole);
            let lanes = || 0..LANES;
            let middle = |lane: usize| first.middle.0[lane];
            let [most, least] = [1.0, -1.0].map(|sign| first.farthest(sign));
            assert!(lanes().all(|lane| middle(lane) <= middle(most)));
            assert!(lanes().all(|lane| middle(lane) >= middle(least)));
            for lane in lanes() {
                let t = first.parts.one(lane).parameter(0.5);
                let distance = profile.at(t);
                assert!(first.nearness.0[lane] < NEAR);
                assert_eq!(middle(lane) > 0.0, distance > 0.0);
                let share = first.least.0[lane] / distance.abs();
                assert!(share <= 1.0 && share > 0.75, "{share}");
            }
            search.bound_first(&whole);
            for t in [0.0, 1.0] {
                search.take(t, [profile.at(t); 2]);
            }
            let (mut outward, mut inward) = (0.0_f64, 0.0_f64);
            for i in 0..=4000 {
                let distance = profile.at(f64::from(i) / 4000.0);
                outward = outward.max(distance);
                inward = inward.max(-distance);
            }
            for (side, most) in [outward, inward].into_iter().enumerate() {
                assert!(!known.is_open(side, 0.999 * most - 1e-12) || most == 0.0);
                assert!(
                    known.is_close(side, 1.001 * most, 1.0)
                        && known.peak() < 1.001 * outward.max(inward)
                );
            }
        }
    }
}
