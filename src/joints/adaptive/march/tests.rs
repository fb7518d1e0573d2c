//! Marching by known answers and by trial.

use super::*;
use crate::joints::adaptive::costs::balance;
use core::cell::Cell;

use crate::{Ellipse, Method, Rule, Shape};

#[test]
fn a_settled_segment_errs_as_much_as_is_allowed() {
    let ellipse = Ellipse::new((0.0, 0.0), (100.0, 40.0), Angle::ZERO).unwrap();
    let outline = Shape::Ellipse(ellipse).outline().unwrap();
    let balance = Balance::new(&outline, Rule::default()).unwrap();
    for way in [0.0, 17.0, 60.0, 89.0] {
        let allowed = 3e-7;
        let size = balance.settled(way, allowed, 30.0);
        let error = balance.error(way, size);
        assert!((error / allowed - 1.0).abs() < 1e-10, "{way}");
    }
}
#[test]
fn a_bracket_narrows_to_the_longest_within() {
    for edge in [1.01, 1.4, 1.99] {
        let tries = Cell::new(0);
        let beyond = |size: f64| {
            tries.set(tries.get() + 1);
            6.0 * libm::log(size / edge)
        };
        let bracket = Bracket {
            low: 1.0,
            high: 2.0,
            below: beyond(1.0),
            above: beyond(2.0),
        };
        let found = bracket.longest(6.0 * SETTLED, beyond);
        assert!(
            found <= edge && found > edge * (1.0 - 2.0 * SETTLED),
            "{edge}: {found}"
        );
        assert!(tries.get() <= 9, "{edge}: {}", tries.get());
    }
    // A leap: the error is nothing up to an edge, and far beyond it afterwards.
    let bracket = Bracket {
        low: 1.0,
        high: 2.0,
        below: -40.0,
        above: 40.0,
    };
    let found = bracket.longest(1e-3, |size| if size <= 1.7 { -40.0 } else { 40.0 });
    assert!(
        found <= 1.7 && found > 1.7 * (1.0 - 2.0 * SETTLED),
        "{found}"
    );
}

#[test]
fn the_circle_tells_what_is_within_an_error_anywhere_and_nowhere() {
    let flatness = 0.1;
    let balance = balance(Method::Minimax, flatness, 0.0, 360.0);
    for allowed in [1e-2, 1e-3, 1e-5, 1e-8] {
        let [safe, beyond] = balance.sizes(allowed);
        let error = balance.errors.on_circle(safe);
        assert!(
            error <= allowed && error > 0.9 * allowed,
            "{allowed}: {error}"
        );
        let part = flatness * balance.errors.on_circle(beyond) / allowed;
        assert!(beyond == 180.0 || (1.0..1.11).contains(&part), "{part}");
        for from in (0..36).map(|i| 5.0 * f64::from(i)) {
            assert!(balance.lobes.size(from, safe) <= allowed);
            assert!(beyond == 180.0 || balance.lobes.size(from, beyond) > allowed);
        }
    }
    assert_eq!(balance.sizes(1.0), [180.0; 2]);
    // The sixth root of 64 is 2.
    assert!((balance.resized(10.0, 64.0) - 20.0).abs() < 1e-12);
    assert!((balance.resized(10.0, 1.0 / 64.0) - 5.0).abs() < 1e-12);
    assert_eq!(balance.resized(10.0, 1e9), 40.0);
    assert_eq!(balance.resized(10.0, 1e-9), 2.5);
    assert_eq!(balance.resized(100.0, 64.0), 180.0);
}

#[test]
fn the_longest_segment_is_found_by_its_lobes() {
    let balance = balance(Method::Minimax, 0.3, 20.0, 300.0);
    for way in [0.0, 10.0, 77.0, 200.0] {
        for allowed in [1e-4, 1e-6, 1e-9] {
            let size = balance.longest_by_lobes(way, allowed, 5.0, 180.0).unwrap();
            let error = balance.error(way, size);
            assert!((error / allowed - 1.0).abs() < 1e-4, "{way} {allowed}");
            let least = balance.longest_by_lobes(way, allowed, 5.0, 0.5 * size);
            assert_eq!(least, Some(0.5 * size));
            let settled = balance.settled(way, allowed, 1.0);
            assert!((settled / size - 1.0).abs() < 1e-3, "{way} {allowed}");
        }
    }
}

/// The longest of many sizes, evenly by their ratio, whose error is within.
fn by_trial(balance: &Balance, way: f64, allowed: f64, most: f64) -> f64 {
    let from = balance.past_axis(way);
    (0..3000)
        .map(|i| most * libm::exp(-2e-3 * f64::from(i)))
        .find(|&size| balance.lobes.size_up_to(from, size, allowed) <= allowed)
        .unwrap_or(0.0)
}

#[test]
fn where_longer_segments_may_err_less_the_longest_is_looked_for() {
    let (mut all, mut over, mut missed, mut longer) = (0, 0, 0, 0);
    for flatness in [0.3, 0.1, 0.02] {
        let balance = balance(Method::Minimax, flatness, 0.0, 350.0);
        for exponent in 0..5 {
            let allowed = flatness * flatness * libm::pow(10.0, -0.7 * f64::from(exponent) - 0.5);
            assert!(balance.errors.is_worth_a_look(allowed));
            let sizes = balance.sizes(allowed);
            for way in (0..35).map(|i| f64::from(i) * 9.7) {
                let most = f64::min(180.0, 350.0 - way);
                let size = balance.longest(way, allowed, 30.0, most, Some(sizes));
                let from = balance.past_axis(way);
                assert!(size <= most * (1.0 + 1e-12));
                let error = balance.lobes.size(from, size);
                assert!(
                    error <= 1.2 * allowed,
                    "{flatness} {way}: {error} of {allowed}"
                );
                over += usize::from(error > 1.001 * allowed);
                let trial = by_trial(&balance, way, allowed, most);
                all += 1;
                missed += usize::from(size < 0.995 * trial);
                longer += usize::from(size > 1.005 * trial);
            }
        }
    }
    // Lobes that are not climbed say a little less, and lengths between those that are tried may serve.
    assert!(
        over <= 61 && missed == 0 && longer <= 7,
        "{over} {missed} {longer} of {all}"
    );
}

#[test]
fn a_segment_may_end_at_an_axis() {
    let (mut all, mut ends) = (0, 0);
    for flatness in [0.003, 0.006, 0.01, 0.02, 0.029] {
        let balance = balance(Method::Minimax, flatness, 0.0, 350.0);
        for way in (0..60).map(|i| f64::from(i) * 3.1) {
            let from = balance.past_axis(way);
            let quarters = (from / 90.0).floor();
            // Up to the next axes, so much is within that a segment a little shorter or longer is not.
            for (axis, part) in [
                (quarters + 1.0, 1.01),
                (quarters + 2.0, 1.01),
                (quarters + 1.0, 1.0 + 1e-9),
                (quarters + 2.0, 1.0 + 1e-9),
            ] {
                let size = 90.0 * axis - from;
                let error = balance.lobes.size(from, size);
                let allowed = part * error;
                let is_tame = balance
                    .longest_by_lobes(way, allowed, 30.0, 180.0)
                    .is_some();
                let most = 350.0 - way;
                if is_tame || size > most || !balance.errors.is_worth_a_look(allowed) {
                    continue;
                }
                let sizes = balance.sizes(allowed);
                let found = balance.longest(way, allowed, 30.0, most.min(180.0), Some(sizes));
                all += 1;
                assert!(
                    found >= size * (1.0 - 1e-12),
                    "{flatness} {way}: {found} of {size}"
                );
                ends += usize::from((found - size).abs() < 1e-9);
            }
        }
    }
    // Most are passed by a longer one.
    assert!(all > 800 && ends >= 84, "{all} {ends}");
}

#[test]
fn a_march_takes_segments_of_the_error_to_the_end() {
    for (flatness, allowed, near) in [(0.5, 1e-7, 1e-3), (0.2, 1e-4, 5e-3), (0.1, 1e-8, 1e-3)] {
        for sweep in [300.0, -300.0] {
            let balance = balance(Method::Minimax, flatness, 15.0, sweep);
            let mut joints = Vec::new();
            let taken = balance.march(300.0, allowed, 1000, &mut joints);
            assert_eq!(joints[0], 0.0);
            let part = taken - (joints.len() - 1) as f64;
            assert!(part > 0.0 && part <= 1.0, "{taken}");
            for pair in joints.windows(2) {
                let error = balance.error(pair[0], pair[1] - pair[0]);
                assert!(
                    error < allowed * (1.0 + 1e-4),
                    "{flatness} {sweep}: {error}"
                );
                assert!(
                    error > allowed * (1.0 - near),
                    "{flatness} {sweep}: {error}"
                );
            }
            // The last one is counted by its part.
            let last = joints[joints.len() - 1];
            let size = (300.0 - last) / part;
            let error = balance.error(last, size);
            let is_rough = balance.errors.is_worth_a_look(allowed);
            assert!(is_rough || (error / allowed - 1.0).abs() < 1e-3, "{error}");
            let few = balance.march(300.0, allowed, 3, &mut joints);
            assert!(joints.len() == 4 && few > 3.0, "{few}");
        }
    }
}

#[test]
fn greedy_joints_run_from_either_end() {
    let forth = balance(Method::Minimax, 0.2, 10.0, 200.0);
    let all: Vec<Joints> = forth.greedy(1e-4).collect();
    assert_eq!(all.len(), 2);
    let other = balance(Method::Minimax, 0.2, 210.0, -200.0);
    let reversed: Vec<Joints> = other.greedy(1e-4).collect();
    for (one, two) in [(&all[0], &reversed[1]), (&all[1], &reversed[0])] {
        let two: Vec<f64> = two.angles.iter().rev().copied().collect();
        assert_eq!(one.angles.len(), two.len());
        for (a, b) in one.angles.iter().zip(&two) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
    assert_ne!(all[0].angles, all[1].angles);
    let closed = balance(Method::Minimax, 0.2, 10.0, 360.0);
    assert_eq!(closed.greedy(1e-4).count(), 1);
}

#[test]
fn narrowed_joints_err_less_than_equal_ones() {
    for (flatness, pieces, part) in [(0.02, 4, 0.13), (0.04, 4, 0.2), (0.05, 3, 0.3)] {
        let balance = balance(Method::Minimax, flatness, 10.0, 180.0);
        let ways = balance
            .narrowed(180.0, pieces, balance.equal(180.0, pieces), f64::INFINITY)
            .unwrap();
        assert_eq!(ways.len(), pieces + 1);
        assert_eq!([ways[0], ways[pieces]], [0.0, 180.0]);
        let most = |ways: &[f64]| {
            let errors = ways.windows(2).map(|w| balance.error(w[0], w[1] - w[0]));
            errors.fold(0.0, f64::max)
        };
        let equal: Vec<f64> = (0..=pieces)
            .map(|i| 180.0 * i as f64 / pieces as f64)
            .collect();
        let found = most(&ways) / most(&equal);
        assert!(found < part, "{flatness} {pieces}: {found}");
    }
}

#[test]
fn what_is_missing_halves_the_worst() {
    let balance = balance(Method::Minimax, 0.9, 10.0, 180.0);
    for (mut joints, filled) in [
        (vec![0.0, 20.0, 180.0], [0.0, 20.0, 100.0, 180.0]),
        (vec![0.0, 150.0, 180.0], [0.0, 75.0, 150.0, 180.0]),
    ] {
        balance.fill(&mut joints, 3);
        assert_eq!(joints, filled);
    }
}

#[test]
fn the_marched_count_is_the_lesser_of_both_ways() {
    let (mut rough, mut fewer) = (0, 0);
    for i in 0..1500 {
        let at = |k: usize| (i * k % 1511) as f64 / 1511.0;
        let (flatness, sweep) = (0.14 * libm::pow(0.1, at(7)), 350.0 * at(11) + 10.0);
        let balance = balance(Method::Minimax, flatness, 360.0 * at(13), sweep);
        let allowed = 1e-4 * libm::pow(10.0, 2.0 * at(17));
        if balance.least(allowed).is_none() {
            let both: Vec<usize> = balance.greedy(allowed).map(|it| it.count()).collect();
            assert_eq!(balance.marched_count(allowed), both.iter().copied().min());
            rough += 1;
            fewer += usize::from(both[1] < both[0]);
        }
    }
    assert!(rough > 700 && fewer > 3, "{rough} {fewer}");
}

#[test]
fn where_newtons_steps_come_to_no_end_secants_settle() {
    let balance = balance(
        Method::Chen3,
        0.707_725_086_360_640_9,
        315.153_716_694_716_14,
        360.0,
    );
    // At this length what the lobes tell leaps by a step that is just worth its while, of a 1e-4th.
    let (way, guess, allowed) = (
        187.274_036_926_862_75,
        9.364_443_401_050_456,
        1.542_206_641_612_144_4e-6,
    );
    assert!(
        balance
            .longest_by_lobes(way, allowed, guess, 180.0)
            .is_none()
    );
    let size = balance.longest(way, allowed, guess, 180.0, None);
    let error = balance.error(way, size);
    assert!((error / allowed - 1.0).abs() < 2e-4, "{size}");
}
