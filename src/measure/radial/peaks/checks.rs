//! What a search does with one part: which it leaves alone, which it halves, and what it states.

mod near;

use core::cell::RefCell;

use kurbo::{CubicBez, PathSeg, Point, QuadBez};

use super::*;
use crate::measure::radial::checks::{Dice, apart};
use crate::measure::radial::quick::DistanceRun;
use crate::shape::Truth;

/// What was visited.
type Visits = Vec<(f64, [f64; 2])>;

/// A curve and the ellipse of radii 1 and 1/2 that it is measured from.
fn profile(points: [(f64, f64); 4]) -> Profile {
    let [p0, p1, p2, p3] = points.map(Point::from);
    let truth = Truth::new(Point::ORIGIN, Vec2::new(1.0, 0.5), Vec2::new(1.0, 0.0));
    Profile::new(&PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)), &truth)
}

/// One that is near the ellipse's upper half, and strays by so much.
fn straying(dice: &mut Dice, stray: f64) -> Profile {
    let (from, size) = (0.7 + 0.3 * dice.next(), 0.9 + 0.3 * dice.next());
    let k = 4.0 / 3.0 * libm::tan(size / 4.0);
    let at = |angle: f64, along: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        Vec2::new(cos - along * sin, sin + along * cos)
    };
    let ends = [
        at(from, 0.0),
        at(from, k),
        at(from + size, -k),
        at(from + size, 0.0),
    ];
    profile(ends.map(|p| {
        let [x, y] = dice.some::<2>().map(|x| x * stray);
        (p.x + x, 0.5 * p.y + y)
    }))
}

/// Does something with a search that knows so much, and tells what it visited.
fn searched<R>(
    profile: &Profile,
    known: &mut Known,
    act: impl FnOnce(&mut Search<'_, &mut dyn FnMut(f64, [f64; 2])>) -> R,
) -> (R, Visits) {
    let visits = RefCell::new(vec![]);
    let mut note = |t, between| visits.borrow_mut().push((t, between));
    let result = act(&mut Search::new(profile, known, &mut note));
    (result, visits.into_inner())
}

/// Any curve: the parts that follow are made by hand.
fn any() -> Profile {
    profile([(1.0, 0.0), (1.0, 0.3), (0.6, 0.5), (0.0, 0.5)])
}

/// A part that stands still at (0, 1.1) but for F, which is 0.21 + a (t - at)² + b (t - at)³: N is F'/2 there, 0.05 the distance.
fn rising(a: f64, b: f64, at: f64) -> CubicPart {
    let [c0, c1, c2, c3] = [
        0.21 + a * at * at - b * at * at * at,
        -2.0 * a * at + 3.0 * b * at * at,
        a - 3.0 * b * at,
        b,
    ];
    let excess = core::array::from_fn(|i| {
        let i = i as f64;
        let (pairs, triples) = (i * (i - 1.0) / 30.0, i * (i - 1.0) * (i - 2.0) / 120.0);
        c0 + c1 * i / 6.0 + c2 * pairs + c3 * triples
    });
    CubicPart::new([0.0, 1.0], excess, [[0.0; 4], [1.1; 4]], false)
}

/// What a search knows of a part before it bounds it by slopes.
fn near<F: FnMut(f64, [f64; 2])>(search: &Search<'_, F>, part: &CubicPart) -> Near {
    let middle = part.motion_at(0.5, search.center);
    let rounded = part.rounded(&middle);
    let motion = part.spread(&rounded);
    let gradients = search.gradients(&motion);
    let place = search.place(part, &middle, part.rounding());
    Near {
        middle,
        rounded,
        motion,
        gradients,
        place,
    }
}

/// What it makes of a part that is open on these sides.
fn by_slopes(part: &CubicPart, open: [bool; 2]) -> (Option<[f64; 2]>, Visits) {
    searched(&any(), &mut Known::default(), |search| {
        let near = near(search, part);
        search.bound_by_slopes(part, &near, [9.0; 2], open)
    })
}

#[test]
fn gradients_are_the_least_and_the_largest_of_their_balls() {
    let mut part = CubicPart::new([0.0, 1.0], [0.0; 7], [[0.5; 4], [-0.25; 4]], false);
    let ((), _) = searched(&any(), &mut Known::default(), |search| {
        for (moved, expected) in [
            // αᵢ are 1 and 4.
            ([0.25, 0.125], [0.0625 + 0.0625, 0.5625 + 0.5625]),
            ([0.0, 0.125], [0.25 + 0.0625, 0.25 + 0.5625]),
            ([0.25, 0.0], [0.0625 + 0.25, 0.5625 + 0.25]),
            ([0.75, 0.5], [0.0, 1.5625 + 2.25]),
        ] {
            part.moved = moved;
            let middle = part.motion_at(0.5, search.center);
            let mut motion = part.rounded(&middle);
            for (ball, moved) in motion.place.iter_mut().zip(moved) {
                ball.radius = moved;
            }
            let [least, most] = search.gradients(&motion);
            let off = [expected[0] - least, most - expected[1]];
            for (off, expected) in off.into_iter().zip(expected) {
                assert!(off > 0.0 || expected == 0.0 && off == 0.0, "{off:e}");
                assert!(off <= 2e-15 * expected, "{off:e} of {expected}");
            }
        }
    });
}

#[test]
fn a_part_is_coarse_from_some_rounding_on() {
    let ((), _) = searched(&any(), &mut Known::default(), |search| {
        search.last_place = 1e-12;
        let mut part = CubicPart::new([0.0, 1.0], [0.0; 7], [[0.0; 4]; 2], false);
        let mut is_coarse = |rounding: f64, moved: [f64; 2], gradient: f64| {
            (part.rounding, part.moved) = (rounding, moved);
            search.is_coarse(&part, gradient)
        };
        // A quarter of the last place, times √G.
        for (gradient, most) in [(1.0, 0.25e-12), (4.0, 0.5e-12), (0.25, 0.125e-12)] {
            assert!(!is_coarse(0.99 * most, [0.0; 2], gradient));
            assert!(is_coarse(1.01 * most, [0.0; 2], gradient));
        }
        // A tenth of what a stated distance may be off, by the steepest normal: over the radii 1 and 1/2.
        for (moved, is_so) in [
            ([0.99e-11, 0.0], false),
            ([1.01e-11, 0.0], true),
            ([0.0, 0.49e-11], false),
            ([0.0, 0.51e-11], true),
        ] {
            assert_eq!(is_coarse(0.0, moved, 1.0), is_so, "{moved:?}");
        }
    });
    let truth = Truth::new(Point::ORIGIN, Vec2::new(0.5, 1.0), Vec2::new(1.0, 0.0));
    let upright = Profile::new(
        &PathSeg::Quad(QuadBez::new((0.5, 0.0), (0.5, 0.5), (0.0, 1.0))),
        &truth,
    );
    let ((), _) = searched(&upright, &mut Known::default(), |search| {
        let mut part = CubicPart::new([0.0, 1.0], [0.0; 7], [[0.0; 4]; 2], false);
        for (moved, is_so) in [(0.49e-11, false), (0.51e-11, true)] {
            part.moved = [moved, 0.0];
            assert_eq!(search.is_coarse(&part, 1.0), is_so, "{moved}");
        }
    });
    // Or what of the distance may be stated without a closer look.
    let mut known = Known::default();
    known.learn(0, 0.25);
    known.learn(1, 0.5);
    let ((), _) = searched(&any(), &mut known, |search| {
        search.last_place = 0.0;
        let mut part = CubicPart::new([0.0, 1.0], [0.0; 7], [[0.0; 4]; 2], false);
        part.rounding = 0.24e-11;
        assert!(!search.is_coarse(&part, 1.0));
        part.rounding = 0.26e-11;
        assert!(search.is_coarse(&part, 1.0));
    });
}

#[test]
fn an_end_that_cannot_matter_is_not_looked_at() {
    let profile = any();
    for (limit, count) in [(1e-3, 0), (1e-300, 2)] {
        let (digits, visits) = searched(&profile, &mut Known::within(limit), |search| {
            let (whole, points) = search.profile.part([0.0, 1.0], &search.turn);
            let mut end = rising(0.0, 0.0, 0.0);
            end.excess = whole.excess.map(|_| 1e-9);
            end.points = [[0.0; 4], [1.0; 4]];
            search.end(&end, 0.0, points[3]);
            search.end(&end, 1.0, points[3]);
            search.tangents.is_some()
        });
        assert_eq!(visits.len(), count, "{limit}");
        assert!(!digits, "f64 has the digits of this distance");
        for (_, [low, high]) in visits {
            let distance = 1e-9 / 4.0;
            assert!(apart(low, distance) < 1e-18, "{low:e} {high:e}");
            assert!(high - low < 1e-20, "{low:e} {high:e}");
        }
    }
}

#[test]
fn an_extreme_is_settled_where_n_vanishes() {
    let settled = |part: &CubicPart, from: f64, curving: f64, last_place: f64| {
        searched(&any(), &mut Known::default(), |search| {
            search.last_place = last_place;
            search.settle(part, from, curving)
        })
    };
    let a = 1e-7;
    // On the part, and beyond either end, where the distance is the largest at that end.
    for (at, t) in [(0.4, 0.4), (0.0, 0.0), (1.0, 1.0), (1.3, 1.0), (-0.3, 0.0)] {
        let part = rising(-a, 0.0, at);
        for from in [-2.0, 0.1, 0.9, 3.0] {
            let (done, visits) = settled(&part, from, a, 0.0);
            assert!(done && visits.len() == 1, "{at} from {from}");
            let (place, [low, high]) = visits[0];
            assert!(apart(place, t) < 1e-6, "{place} is not {t}");
            let excess = 0.21 - a * (t - at) * (t - at);
            // F alone knows where the point is.
            let distance = 0.55 * (1.0 - libm::sqrt(1.0 - excess / 1.21));
            let off = high - distance;
            assert!(off > 0.0 && off < 1e-13, "{at} from {from}: {off:e}");
            assert!(apart(distance - low, off) < 1e-15, "{low:e} {high:e}");
        }
    }
}

#[test]
fn what_a_step_leaves_is_added_where_it_is_little() {
    let part = rising(-1e-7, 0.0, 0.4);
    let settled = |curving: f64, last_place: f64| {
        searched(&any(), &mut Known::default(), |search| {
            search.last_place = last_place;
            search.settle(&part, 0.4, curving)
        })
    };
    let ((steep, margin), _) = searched(&any(), &mut Known::default(), |search| {
        let motion = part.motion_at(0.4, search.center);
        let place = search.place(&part, &motion, part.rounding());
        let slopes = part
            .rounded(&motion)
            .slopes(search.alpha, place.multiplier());
        (slopes.slope.size(), place.margin)
    });
    // √G is 2.2.
    let curving = |more: f64| 0.7 * steep * steep / (more * 2.2);
    let (done, visits) = settled(curving(1e-6), 1.0);
    let [low, high] = visits[0].1;
    assert!(done && apart((high - low) / 2.0, 1e-6 + margin) < 2e-7);
    // The same where sizes tell how N' is bent at least, the other way round too.
    for a in [-1e-7, 1e-7] {
        let part = rising(a, 0.0, 0.4);
        let less = curving(1e-6);
        let bend = if a > 0.0 { [less, 1.0] } else { [-1.0, -less] };
        for open in [9.0, 0.0] {
            let (done, visits) = searched(&any(), &mut Known::default(), |search| {
                search.last_place = if open > 0.0 { 1.0 } else { 1e-9 };
                let (steep, bounds) = (-1.0, [open; 2]);
                let course = DistanceRun { steep, bend };
                search.leads_to_extreme(&part, &course, bounds, 0.4)
            });
            assert_eq!((done, visits.len()), (true, usize::from(open > 0.0)));
            for (_, [low, high]) in visits {
                assert!(apart((high - low) / 2.0, 1e-6 + margin) < 3e-7, "{a}");
            }
        }
    }
    // Up to a share of the distance, and to the last place.
    for (last_place, allowed) in [(0.0, 5e-14), (1e-9, 1e-9 + 5e-14)] {
        assert!(settled(curving(0.8 * allowed), last_place).0);
        let (done, visits) = settled(curving(1.25 * allowed), last_place);
        assert!(!done && visits.is_empty());
    }
}

#[test]
fn slopes_tell_a_part_without_an_extreme() {
    // N is a (t - at): the distance rises or falls all along unless that vanishes on the part.
    for a in [-0.1, -1e-3, 1e-3, 0.1] {
        let side = usize::from(a > 0.0);
        for (at, is_on) in [(-0.05, false), (0.05, true), (0.95, true), (1.05, false)] {
            let open = core::array::from_fn(|i| i == side);
            let (left, visits) = by_slopes(&rising(a, 0.0, at), open);
            assert_eq!(left, None, "{a} {at}");
            assert_eq!(visits.len(), usize::from(is_on), "{a} {at}");
            // On the other side it has no extreme that counts.
            let other = open.map(|is_open| !is_open);
            let (left, visits) = by_slopes(&rising(a, 0.0, at), other);
            assert_eq!((left, visits.len()), (None, 0), "{a} {at}");
        }
    }
}

#[test]
fn slopes_count_what_rounding_may_have_done() {
    // N' is a and may be off by 60 roundings, N in the middle by 6 more than half of that.
    let a = 0.1;
    let rounding = 1e-4 * a;
    for (beyond, visits) in [(32.0, 1), (38.0, 0)] {
        let mut part = rising(-a, 0.0, -beyond * rounding / a);
        part.rounding = rounding;
        let (left, visited) = by_slopes(&part, [true, false]);
        assert!(left.is_none() || visits == 1, "{beyond}");
        assert!(visited.is_empty() || visits == 1, "{beyond}");
        assert_eq!(
            left.is_none() && visited.is_empty(),
            visits == 0,
            "{beyond}"
        );
    }
}

#[test]
fn slopes_bound_a_part_that_bends_both_ways() {
    // N is 1.5 b (t - 1/2)² and N' is 3 b (t - 1/2): with N about 0 in the middle it is at most 0.75 b.
    for b in [-1e-3, 1e-3] {
        let (left, visits) = by_slopes(&rising(0.0, b, 0.5), [true; 2]);
        let growth = 0.6 * 0.75 * 1e-3 / 2.2;
        let [outer, inner] = left.unwrap();
        assert!(apart(outer, 0.05 + growth) < 1e-12, "{outer}");
        assert!(apart(inner, growth - 0.05) < 1e-12, "{inner}");
        assert!(visits.is_empty());
    }
}

#[test]
fn what_halving_does_not_tell_is_stated_by_its_bound() {
    // A curve that stands still has an extreme nowhere, and no last place ends the search for one.
    let profile = profile([(0.0, 0.51); 4]);
    let ((), visits) = searched(&profile, &mut Known::default(), |search| {
        search.last_place = -1.0;
        let (whole, _) = search.profile.part([0.0, 1.0], &search.turn);
        search.leave(&whole, MOST_CUTS, [1.0; 2]);
        search.close();
    });
    assert_eq!(visits.len(), 1);
    let [low, high] = visits[0].1;
    assert!(low == 0.0 && high > 0.01 && high < 0.01 + 1e-14, "{high}");
}

#[test]
fn parts_of_the_largest_bounds_come_first() {
    let part = rising(0.0, 0.0, 0.0);
    let ((), _) = searched(&any(), &mut Known::default(), |search| {
        for bound in [0.1, 0.3, 0.2] {
            search.leave(&part, 1, [bound, 0.0]);
        }
        let mut last = f64::INFINITY;
        while let Some(next) = search.pending.pop() {
            assert!(next.rank < last);
            last = next.rank;
        }
    });
}
