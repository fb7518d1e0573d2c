//! The Hausdorff distance of two chains of Béziers by branch and bound.
//!
//! One way it is the largest distance of a point a(t) of the first chain from the second. Of a part of a cubic a, let b be the
//! cubic that the nearest points of both ends lie on, at u0 and u1, and f a cubic from u0 to u1 with the slopes that the nearest
//! point has there, u' = a'b'/(b'b' - (a - b)b''). No point of the part is farther away than |a(s) - b(f(s))|, whose square is a
//! polynomial of degree 18: its largest Bernstein coefficient is a bound, which nears the distance as the fourth power of the
//! part's length. Parts that stay below the largest distance found are done; the others are halved.

mod along;
mod chain;
#[cfg(test)]
mod exact;

use std::collections::{BinaryHeap, HashSet};

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point};

use super::unit_for;
use crate::curve::largest_coordinate;
use crate::numeric::ranked::Ranked;
pub(crate) use along::{along, product};
use chain::{ChainFoot, CubicChain, STEPS_OF_A_CUBIC};
pub(crate) use chain::{away, distance_slope, nearest_on};

/// How far where the tolerance lies between the distance found and its bound.
const CLOSE_GOAL: f64 = 1e-9;

/// How many parts are halved, beside some for each segment: where the distance is the same all along, it takes many.
const MOST_PARTS: usize = 20_000;

/// Points of a part are not looked at closely where they are so near, beside the largest distance found.
const NEAR_ENOUGH: f64 = 0.5;

/// What rounding adds to a distance, in units of the last place of the largest coordinate.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// How far two chains lie apart at most, both ways.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Apart {
    pub(crate) at_most: f64,
    /// The point found farthest away, and the segment that it lies on; none where there is no segment of its own.
    pub(crate) place: Option<(Point, usize)>,
    /// Whether it lies on the second chain.
    pub(crate) on_second: bool,
}

/// The distance of two chains that have segments, the larger of both ways, as is to be known of it. Where the steps do not suffice, it is infinite.
pub(crate) fn hausdorff(steps: &mut Effort, chains: [&[PathSeg]; 2], aim: Aim) -> Apart {
    if steps.0 == 0 {
        return Apart {
            at_most: f64::INFINITY,
            place: None,
            on_second: false,
        };
    }
    let (unit, [a, b]) = in_unit(chains);
    let aim = Aim {
        tolerance: aim.tolerance / unit,
        found: aim.found / unit,
        ..aim
    };
    let there = a.farthest_from(&b, aim, steps);
    let found = there.at_least;
    let back = b.farthest_from(&a, Aim { found, ..aim }, steps);
    let on_second = back.at_least > found || there.place.is_none();
    let place = if on_second { back.place } else { there.place };
    Apart {
        at_most: there.at_most.max(back.at_most) * unit,
        place: place.map(|(point, segment)| ((point.to_vec2() * unit).to_point(), segment)),
        on_second,
    }
}

/// Two chains in a unit that suits their coordinates.
fn in_unit(chains: [&[PathSeg]; 2]) -> (f64, [CubicChain; 2]) {
    let largest = chains.map(largest_coordinate).into_iter();
    let unit = unit_for(largest.fold(f64::MIN_POSITIVE, f64::max));
    (unit, chains.map(|chain| CubicChain::new(chain, unit)))
}

/// What is to be known of a distance.
#[derive(Clone, Copy)]
pub(crate) struct Aim {
    /// The bound decides on this one where it lies between.
    pub(crate) tolerance: f64,
    /// How far the bound lies above the distance at most, as a part of it, but in hard cases.
    pub(crate) goal: f64,
    /// A distance that was found elsewhere: smaller ones do not matter.
    pub(crate) found: f64,
}

impl Aim {
    pub(crate) const fn new(tolerance: f64, goal: f64) -> Self {
        Self {
            tolerance,
            goal,
            found: 0.0,
        }
    }
}

/// How much may still be done, in boxes that are looked at.
pub(crate) struct Effort(pub(crate) u64);

impl Effort {
    const fn take(&mut self, count: u64) {
        self.0 = self.0.saturating_sub(count);
    }
}

/// How far a chain lies from another at least and at most, and the point found farthest away, on the segment of that number.
struct Farthest {
    at_least: f64,
    at_most: f64,
    place: Option<(Point, usize)>,
}

/// A part of a segment.
struct SegmentPart {
    segment: usize,
    cubic: CubicBez,
    feet: [ChainFoot; 2],
}

impl CubicChain {
    /// One way.
    fn farthest_from(&self, other: &Self, aim: Aim, steps: &mut Effort) -> Farthest {
        let theirs: HashSet<&[u64]> = other.keys.iter().map(Vec::as_slice).collect();
        let mut search = FarthestSearch::new(other, aim.found, steps);
        for (segment, cubic) in self.cubics.iter().enumerate() {
            if !theirs.contains(self.keys[segment].as_slice()) {
                let start = search.look(cubic.p0, segment, search.last);
                let end = search.look(cubic.p3, segment, start.piece);
                search.push(segment, *cubic, [start, end]);
            }
        }
        let mut left = MOST_PARTS + 32 * (self.cubics.len() + other.cubics.len());
        while let Some(Ranked {
            rank: at_most,
            of: part,
        }) = search.parts.pop()
        {
            let undecided = search.at_least <= aim.tolerance && aim.tolerance < at_most;
            let goal = if undecided { CLOSE_GOAL } else { aim.goal };
            let enough = (search.at_least * (1.0 + goal)).max(search.at_least + NOISE);
            if at_most <= enough || left == 0 || search.steps.0 == 0 {
                // As near to the tolerance as it is known, it is within.
                let is_near = undecided && at_most <= enough && aim.tolerance > NOISE;
                search.at_most = if is_near { aim.tolerance } else { at_most };
                break;
            }
            left -= 1;
            let (a, b) = part.cubic.subdivide();
            let middle = search.look(a.p3, part.segment, part.feet[0].piece);
            search.push(part.segment, a, [part.feet[0], middle]);
            search.push(part.segment, b, [middle, part.feet[1]]);
        }
        search.farthest()
    }
}

/// What the branch and bound has found.
struct FarthestSearch<'a> {
    other: &'a CubicChain,
    steps: &'a mut Effort,
    /// By how far they lie away at most.
    parts: BinaryHeap<Ranked<SegmentPart>>,
    at_least: f64,
    at_most: f64,
    place: Option<(Point, usize)>,
    last: usize,
}

impl<'a> FarthestSearch<'a> {
    fn new(other: &'a CubicChain, at_least: f64, steps: &'a mut Effort) -> Self {
        Self {
            other,
            steps,
            parts: BinaryHeap::new(),
            at_least,
            at_most: 0.0,
            place: None,
            last: 0,
        }
    }

    /// A near point, looked for on this piece first: the nearest one, but where it is clear that others lie much farther away.
    fn look(&mut self, p: Point, segment: usize, first: usize) -> ChainFoot {
        let enough = NEAR_ENOUGH * self.at_least;
        let foot = self.other.nearest(p, first, enough, self.steps);
        self.last = foot.piece;
        if self.place.is_none() || foot.distance > self.at_least {
            self.at_least = self.at_least.max(foot.distance);
            self.place = Some((p, segment));
        }
        foot
    }

    fn push(&mut self, segment: usize, cubic: CubicBez, feet: [ChainFoot; 2]) {
        self.steps.take(STEPS_OF_A_CUBIC);
        let rank = self.other.bound(&cubic, feet);
        let of = SegmentPart {
            segment,
            cubic,
            feet,
        };
        self.parts.push(Ranked { rank, of });
    }

    fn farthest(self) -> Farthest {
        // What rounding explains is no distance.
        let at_most = if self.steps.0 == 0 {
            f64::INFINITY
        } else if self.at_most <= self.at_least + NOISE && self.at_least > NOISE {
            self.at_least
        } else {
            self.at_most.max(self.at_least)
        };
        Farthest {
            at_least: self.at_least,
            at_most,
            place: self.place,
        }
    }
}

#[cfg(test)]
mod tests {
    use kurbo::Affine;

    use super::*;
    use crate::diff::Track;
    use crate::numeric::random::uniform;
    use crate::path::contours;

    fn distance(old: &str, new: &str) -> f64 {
        let track = |data| Track::new(&contours(data).unwrap()[0], Affine::IDENTITY).unwrap();
        let (old, new) = (track(old), track(new));
        hausdorff(
            &mut Effort(u64::MAX),
            [&old.segments, &new.segments],
            Aim::new(0.0, 1e-4),
        )
        .at_most
    }

    #[test]
    fn distances_that_are_known() {
        for (old, new, expected) in [
            ("M0 0L10 0", "M0 1L10 1", 1.0),
            ("M0 0L10 0", "M3 4L13 4", 5.0),
            ("M0 0L10 0", "M10 0L0 0", 0.0),
            ("M0 0L10 0", "M0 0L20 0", 10.0),
            ("M0 0L10 0", "M5 0L5 3", 5.0),
            ("M0 0H10V10H0Z", "M10 10H0V0H10Z", 0.0),
            // The middle of the base, seen from the other two sides.
            ("M0 0L10 0", "M0 0L5 5L10 0", 5.0),
            ("M0 0L10 0", "M0 0Q5 10 10 0", 5.0),
        ] {
            let found = distance(old, new);
            assert!(
                (found - expected).abs() <= 1e-4 * expected,
                "{old} {new}: {found}"
            );
        }
        let circles = distance(
            "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z",
            "M51 0A51 51 0 0 1-51 0A51 51 0 0 1 51 0Z",
        );
        assert!((1.0..1.0001).contains(&circles), "{circles}");
    }

    #[test]
    fn a_curve_that_is_cut_elsewhere_is_the_same() {
        let whole = CubicBez::new((0.0, 0.0), (30.0, 80.0), (70.0, -40.0), (100.0, 10.0));
        let (a, b) = (whole.subsegment(0.0..0.3), whole.subsegment(0.3..1.0));
        let [whole, a, b] = [whole, a, b].map(PathSeg::Cubic);
        let found = hausdorff(
            &mut Effort(u64::MAX),
            [&[whole], &[a, b]],
            Aim::new(0.0, 1e-4),
        )
        .at_most;
        assert!(found < 1e-11, "{found}");
    }

    /// Cubics that cross one another all over a square.
    pub(super) fn tangle(count: usize, mut seed: u64) -> Vec<PathSeg> {
        let mut point = || Point::new(uniform(&mut seed), uniform(&mut seed));
        let mut cubic = || CubicBez::new(point(), point(), point(), point());
        (0..count).map(|_| PathSeg::Cubic(cubic())).collect()
    }

    #[test]
    fn tangles_take_steps_that_grow_less_than_the_square() {
        let taken = |count| {
            let [a, b] = [1, 2].map(|seed| tangle(count, seed));
            let mut steps = Effort(u64::MAX);
            let apart = hausdorff(&mut steps, [&a, &b], Aim::new(0.0, 1e-4));
            assert!(apart.at_most.is_finite());
            (u64::MAX - steps.0) as f64
        };
        let growth = taken(320) / taken(20);
        assert!(growth < 16.0 * 6.0, "{growth}");
    }
}
