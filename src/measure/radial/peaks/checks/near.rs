//! What a search makes of curves that are near the ellipse, as those are that a method draws.

use super::*;
use crate::measure::radial::part::MOTIONS;
use crate::numeric::foot::foot;

/// The places of [0, 1] where N vanishes along a profile.
fn extremes<F: FnMut(f64, [f64; 2])>(search: &Search<'_, F>) -> Vec<f64> {
    let (whole, _) = search.profile.part([0.0, 1.0], &search.turn);
    let slope = |t: f64| {
        let motion = whole.motion_at(t, search.center);
        let place = search.place(&whole, &motion, 0.0);
        motion.slopes(search.alpha, place.foot.multiplier).slope
    };
    let places = (0..64).map(|i| (f64::from(i) / 64.0, f64::from(i + 1) / 64.0));
    let turns = places.filter(|&(a, b)| (slope(a) > 0.0) != (slope(b) > 0.0));
    turns
        .map(|(mut low, mut high)| {
            let rises = slope(high) > 0.0;
            for _ in 0..50 {
                let middle = f64::midpoint(low, high);
                if (slope(middle) > 0.0) == rises {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            low
        })
        .collect()
}

#[test]
fn extremes_are_found_however_far_a_near_curve_strays() {
    let mut dice = Dice(13);
    let mut found = 0;
    for round in 0..200 {
        let stray = 0.03 * libm::exp(-0.5 * f64::from(round % 10));
        let profile = straying(&mut dice, stray);
        let ((), _) = searched(&profile, &mut Known::default(), |search| {
            for t in extremes(search) {
                let ends = [t - 0.02, t + 0.03].map(|t: f64| t.clamp(0.0, 1.0));
                let (part, _) = search.profile.part(ends, &search.turn);
                let bend = near(search, &part).motion.bending.size();
                let image = |t: f64| {
                    let (whole, _) = search.profile.part([0.0, 1.0], &search.turn);
                    search.image(vector(whole.motion_at(t, search.center).place))
                };
                let distance = foot(search.radii, image(t)).distance;
                let before = search.known.peak();
                let place = (t - ends[0]) / (ends[1] - ends[0]);
                if search.settle(&part, place + 0.2, 0.1 * bend) {
                    found += 1;
                    let least = search.known.peak();
                    let so_far = before.max(distance.abs());
                    assert!(apart(least, so_far) <= 1e-10 * so_far + 1e-15, "{round}");
                } else {
                    assert!(stray > 0.02, "{round}");
                }
            }
        });
    }
    assert!(found > 150, "{found}");
}

#[test]
fn sizes_hold_what_every_place_of_a_near_part_says() {
    let mut dice = Dice(14);
    let (mut steep, mut near, mut all) = (0, 0, 0);
    for round in 0..100 {
        let profile = straying(&mut dice, 0.05 * libm::exp(-0.5 * f64::from(round % 10)));
        let ((), _) = searched(&profile, &mut Known::default(), |search| {
            for i in 0..8 {
                let ends = [f64::from(i) / 8.0, f64::from(i + 1) / 8.0];
                let (part, _) = search.profile.part(ends, &search.turn);
                let middle = part.motion_at(0.5, search.center);
                let look = search.look(&part);
                let course = search.course(&part, &middle, &look);
                all += 1;
                let Some(bounds) = look.bounds() else {
                    continue;
                };
                near += 1;
                steep += usize::from(course.is_monotone());
                let (mut least, mut signs) = (f64::INFINITY, [false; 2]);
                for i in 0..=32 {
                    let motion = part.motion_at(f64::from(i) / 32.0, search.center);
                    let place = search.place(&part, &motion, 0.0);
                    let slopes = motion.slopes(search.alpha, place.foot.multiplier);
                    let distance = place.foot.foot.distance;
                    // A side on which it does not lie has a bound of nothing, or less.
                    let [outer, inner] = bounds.map(|bound| bound.max(0.0));
                    assert!(
                        distance <= outer && -distance <= inner,
                        "{round}: {distance:e}"
                    );
                    signs[usize::from(slopes.slope > 0.0)] = true;
                    least = least.min(slopes.slope.abs());
                }
                assert!(course.steep <= least);
                assert!(!course.is_monotone() || signs != [true; 2]);
            }
        });
    }
    // Most parts are near, and most of them hold no extreme.
    assert!(
        10 * near > 9 * all && 2 * steep > near,
        "{steep} {near} {all}"
    );
}

#[test]
fn the_first_parts_find_the_peak_and_leave_little() {
    let mut dice = Dice(15);
    let (mut waiting, mut visited, mut turning) = (0, 0, 0);
    for round in 0..240 {
        let stray = 0.05 * libm::exp(-0.5 * f64::from(round % 24));
        let profile = straying(&mut dice, stray);
        let ((), visits) = searched(&profile, &mut Known::default(), |search| {
            let (whole, points) = search.profile.part([0.0, 1.0], &search.turn);
            turning += extremes(search).len();
            search.bound_first(&whole);
            waiting += search.pending.len();
            search.end(&whole, 0.0, points[0]);
            search.end(&whole, 1.0, points[3]);
            let so_far = search.known.peak();
            search.close();
            let peak = search.known.peak();
            assert!(so_far > 0.98 * peak, "{round}: {so_far} of {peak}");
        });
        visited += visits.len();
    }
    // Hardly more is visited than where the distance turns, and next to nothing has to be halved.
    assert!(waiting <= 6 && turning > 500, "{waiting} {turning}");
    assert!(visited <= turning + 40, "{visited} {turning}");
}

#[test]
fn a_part_that_halving_made_coarse_is_made_anew() {
    let mut dice = Dice(11);
    for _ in 0..20 {
        let profile = straying(&mut dice, 3e-3);
        let waiting = |is_coarse: bool| {
            let left = searched(&profile, &mut Known::default(), |search| {
                for i in 0..8 {
                    let ends = [f64::from(i) / 8.0, f64::from(i + 1) / 8.0];
                    let (mut part, _) = search.profile.part(ends, &search.turn);
                    if is_coarse {
                        (part.rounding, part.is_fresh) = (1e-4, false);
                    }
                    search.bound(&part, 48);
                }
                search.pending.len()
            });
            left.0
        };
        assert_eq!(waiting(true), waiting(false));
    }
}

#[test]
fn what_slopes_say_holds_every_place_of_a_part() {
    let mut dice = Dice(16);
    let (mut told, mut left) = (0, 0);
    for round in 0..120 {
        let stray = 0.12 * libm::exp(-0.4 * f64::from(round % 12));
        let profile = straying(&mut dice, stray);
        for (i, parts) in [5, 16]
            .into_iter()
            .flat_map(|n| (0..n).map(move |i| (i, n)))
        {
            let ends = [i, i + 1].map(|i| f64::from(i) / f64::from(parts));
            let ((), _) = searched(&profile, &mut Known::default(), |search| {
                let (part, _) = search.profile.part(ends, &search.turn);
                let near = near(search, &part);
                let excess = part.certain_excess();
                if search.bounds(excess, near.gradients[0]).is_none() || !near.place.foot.is_exact {
                    return;
                }
                let distances: Vec<f64> = (0..=32)
                    .map(|i| {
                        let motion = part.motion_at(f64::from(i) / 32.0, search.center);
                        search.place(&part, &motion, 0.0).foot.foot.distance
                    })
                    .collect();
                let bounds = search.bound_by_slopes(&part, &near, [9.0; 2], [true; 2]);
                told += usize::from(bounds.is_none());
                left += usize::from(bounds.is_some());
                // Without bounds an end, or a place that was visited, lies the farthest on either side.
                for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
                    let most = distances.iter().fold(0.0_f64, |most, d| most.max(sign * d));
                    let ends = f64::max(sign * distances[0], sign * distances[32]);
                    let known = match bounds {
                        Some(bounds) => bounds[side].max(0.0),
                        None if search.known.is_open(side, most) => ends,
                        None => most,
                    };
                    assert!(most <= known + 1e-15, "{round} {i}: {most} beyond {known}");
                }
            });
        }
    }
    assert!(told > 2000 && left > 5, "{told} {left}");
}

/// How many motions a search asks for.
fn motions(profile: &Profile, known: &mut Known) -> usize {
    let before = MOTIONS.get();
    visit(profile, known, |_, _| {});
    MOTIONS.get() - before
}

#[test]
fn a_search_costs_little() {
    let mut dice = Dice(17);
    // A hundred curves that stray by a tenth, a hundredth, ...: the peak, whether it is within a limit, and the peak nearly.
    let costs = [
        [1375, 310, 880],
        [715, 310, 700],
        [675, 310, 635],
        [695, 310, 655],
        [725, 310, 715],
        [850, 310, 850],
    ];
    for (decade, costs) in (1..).zip(costs) {
        let mut counts = [0; 3];
        for _ in 0..100 {
            let profile = straying(&mut dice, libm::pow(10.0, -f64::from(decade)));
            counts[0] += motions(&profile, &mut Known::default());
            counts[1] += motions(&profile, &mut Known::within(1e-2));
            counts[2] += motions(&profile, &mut Known::nearly(f64::INFINITY));
        }
        for (count, cost) in counts.into_iter().zip(costs) {
            assert!(count <= cost, "{decade}: {counts:?}");
        }
    }
    // Curves that run anywhere within so much of the centre.
    for (reach, cost) in [(0.3, 6450), (1.0, 7150), (3.0, 5400)] {
        let counts = (0..100).map(|_| {
            let [a, b, c, d, e, f, g, h] = dice.some::<8>().map(|x| reach * x);
            let profile = profile([(a, b), (c, d), (e, f), (g, h)]);
            motions(&profile, &mut Known::default())
        });
        let count: usize = counts.sum();
        assert!(count <= cost, "{reach}: {count}");
    }
}
