//! Equal errors by known answers, and the least count by trial.

use super::*;
use crate::joints::adaptive::costs::balance;
use crate::{Angle, Method, Rule, Shape};

/// Pieces whose errors are the sixth power of their lengths.
fn sixth_powers(ways: &[f64]) -> Vec<Peak> {
    let peak = |way: &[f64]| {
        let length = way[1] - way[0];
        Peak {
            size: libm::pow(length, 6.0),
            slopes: [-6.0 / length, 6.0 / length],
        }
    };
    ways.windows(2).map(peak).collect()
}

#[test]
fn a_step_solves_what_it_is_derived_from() {
    // Two pieces: e + 6 δ/l = L for the first and e - 6 δ/l = L for the second.
    let mut ways = vec![0.0, 1.05, 2.0];
    let peaks = sixth_powers(&ways);
    let LevelStep { change, level } = step(&mut ways, &peaks).unwrap();
    let [a, b] = [1.05, 0.95].map(|l| 6.0 * libm::log(l));
    let moved = (b - a) / (6.0 / 1.05 + 6.0 / 0.95);
    assert!((ways[1] - (1.05 + moved)).abs() < 1e-15);
    assert!((level - (a + 6.0 * moved / 1.05)).abs() < 1e-14);
    assert!((change + moved / 0.95).abs() < 1e-15);
    assert_eq!([ways[0], ways[2]], [0.0, 2.0]);
    // Four pieces become alike but for the square of the change.
    let mut ways = vec![0.0, 1.04, 1.97, 3.01, 4.0];
    let peaks = sixth_powers(&ways);
    let found = step(&mut ways, &peaks).unwrap();
    assert!(
        ways.windows(2).all(|w| (w[1] - w[0] - 1.0).abs() < 5e-3),
        "{ways:?}"
    );
    assert!(found.level.abs() < 2e-2 && found.change > 0.03 && found.change < 0.08);
    // A far step stops where a piece has changed by 0.6 of itself.
    let mut ways = vec![0.0, 3.5, 4.0];
    let peaks = sixth_powers(&ways);
    let found = step(&mut ways, &peaks).unwrap();
    assert!(found.change > 1.0);
    assert!((ways[1] - (3.5 - 0.6 * 0.5)).abs() < 1e-12, "{ways:?}");
}

#[test]
fn a_few_steps_make_the_errors_alike() {
    for method in [
        Method::Midpoint,
        Method::Minimax,
        Method::Goldapp,
        Method::Area,
    ] {
        for (flatness, pieces, most) in [
            (0.8, 8, 3),
            (0.5, 8, 4),
            (0.5, 30, 3),
            (0.2, 20, 6),
            (0.1, 40, 6),
        ] {
            let balance = balance(method, flatness, 25.0, 310.0);
            let level = balance.level(310.0, pieces, f64::INFINITY).unwrap();
            let what = format!("{method:?} {flatness} {pieces}");
            assert!(level.steps <= most, "{what}: {}", level.steps);
            assert_eq!(level.ways.len(), pieces + 1);
            let errors = level
                .ways
                .windows(2)
                .map(|w| balance.error(w[0], w[1] - w[0]));
            let (least, largest) =
                errors.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
            assert!(largest / least < 1.005, "{what}: {}", largest / least);
            assert!(
                (level.most / largest - 1.0).abs() < 3e-3 && level.least <= level.most,
                "{what}"
            );
        }
    }
}

#[test]
fn no_step_is_taken_that_decides_nothing() {
    let searched = balance(Method::MinimaxG0, 0.3, 0.0, 360.0);
    assert!(searched.level(360.0, 12, 1.0).is_none());
    let balance = balance(Method::Minimax, 0.3, 0.0, 360.0);
    let from = balance.past_axis(0.0);
    let begun = || Level::new(&balance, 360.0, 12).unwrap();
    let (least, most) = (begun().least, begun().most);
    assert!(most > 1.1 * least);
    for (edge, is_decided) in [
        (0.9 * least, true),
        (1.1 * most, true),
        (0.5 * (least + most), false),
    ] {
        let mut level = begun();
        level.refine(&balance.lobes, from, edge).unwrap();
        assert_eq!(level.steps == 1, is_decided, "{edge}");
        let is_alike = level.most <= ALIKE * level.least;
        assert!(is_decided || level.least > edge || level.most < edge || is_alike);
    }
    let begun = balance.levelled(360.0, 12, Some(begun())).unwrap();
    assert!(begun.most <= ALIKE * begun.least);
}

#[test]
fn the_least_count_is_the_least_by_trial() {
    let mut told = 0;
    for method in [
        Method::Minimax,
        Method::Midpoint,
        Method::Curvature,
        Method::Chen3,
    ] {
        for flatness in [0.9, 0.5, 0.2] {
            for (start, sweep) in [(0.0, 360.0), (35.0, 250.0), (80.0, -40.0)] {
                let balance = balance(method, flatness, start, sweep);
                let whole = f64::abs(sweep);
                let error = |count: usize| Some(balance.level(whole, count, f64::INFINITY)?.most);
                for exponent in 0..7 {
                    let allowed = 3.7 * libm::pow(10.0, f64::from(-exponent) - 3.0);
                    let Some(least) = balance.least(allowed) else {
                        continue;
                    };
                    told += 1;
                    let what = format!("{method:?} {flatness} {start} {sweep} {allowed:e}");
                    // Errors are alike to a thousandth only.
                    let reached = error(least.count).unwrap();
                    assert!(
                        reached <= allowed * (1.0 + 2.0 * LOBES_OFF),
                        "{what}: {reached:e}"
                    );
                    assert_eq!(least.level.ways.len(), least.count + 1);
                    let fewer = error(least.count - 1).unwrap_or(f64::INFINITY);
                    assert!(
                        least.count == 1 || fewer > allowed,
                        "{what}: {}",
                        least.count
                    );
                }
            }
        }
    }
    assert!(told > 240, "{told}");
}

#[test]
fn no_more_segments_are_taken_than_were_asked_for() {
    let arc = crate::Arc::new(
        (0.0, 0.0),
        (4.835, 0.000_379),
        Angle::ZERO,
        Angle::from_degrees(166.0),
        Angle::from_degrees(-358.9),
    );
    let outline = Shape::Arc(arc.unwrap()).outline().unwrap();
    let balance = Balance::new(&outline, Rule::Method(Method::Apprich)).unwrap();
    let joints = |count| balance.joints_from(count, None, f64::INFINITY);
    assert_eq!(balance.least_by_angle(), 3);
    // Two of them would be longer than the method serves.
    assert!(joints(2).is_none());
    assert_eq!(joints(3).unwrap().0.count(), 3);
}
