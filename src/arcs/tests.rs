//! What is decided in less time is what a closer look decides.

use kurbo::{CubicBez, Point, Vec2};

use super::bound::{is_within, roughly_from_arc};
use super::from_chord::from_chord;
use super::glance::{Glance, glance, strays_from};
use super::recognize::{Rules, closer, run};
use crate::number::{Precision, round};
use crate::numeric::random::uniform;

/// A part of a circle or an ellipse as one cubic or two, spelled with few decimals, and often bent a bit.
fn drawn(state: &mut u64, decimals: u8) -> Vec<CubicBez> {
    let radius = libm::exp(6.0 * uniform(state) - 2.0);
    let radius = round(radius, (3.0 * uniform(state)) as u8).max(0.1);
    let flat = if uniform(state) < 0.5 {
        1.0
    } else {
        0.3 + uniform(state)
    };
    let step = 0.05 + 1.7 * uniform(state);
    let handle = 4.0 / 3.0 * libm::tan(step / 4.0) * (1.0 + 0.02 * (uniform(state) - 0.5));
    let (bend, start) = (0.02 * uniform(state) * uniform(state), 6.0 * uniform(state));
    let on = |angle: f64, along: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let p = Vec2::new(cos - along * sin, flat * (sin + along * cos)) * radius;
        Point::new(round(p.x + 3.0, decimals), round(p.y, decimals))
    };
    let mut cubic = |from: f64| {
        let bent = 1.0 + bend * (uniform(state) - 0.5);
        let [p0, p1] = [0.0, handle * bent].map(|along| on(from, along));
        let [p2, p3] = [-handle, 0.0].map(|along| on(from + step, along));
        CubicBez { p0, p1, p2, p3 }
    };
    vec![cubic(start), cubic(start + step)]
}

#[test]
fn a_first_look_lets_nothing_go_that_a_closer_one_finds() {
    let (mut state, mut gone, mut found) = (7, 0, 0);
    for round in 0..20_000 {
        let decimals = (round % 5) as u8;
        let cubics = drawn(&mut state, decimals);
        let moved = Precision::Fixed(decimals).farthest_moved();
        let rules = Rules {
            part: 1e-3,
            absolute: if round % 7 == 0 { 0.0 } else { moved },
            decimals,
            elliptic: round % 3 > 0,
            drawn_only: round % 11 > 0,
            longest: if round % 2 == 0 { 16 } else { usize::MAX },
        };
        for cubics in [&cubics[..1], &cubics] {
            gone += usize::from(matches!(glance(cubics, &rules), Glance::Nothing));
            let (quick, close) = (run(cubics, &rules), closer(cubics, &rules));
            assert_eq!(quick, close, "{cubics:?} {rules:?}");
            found += usize::from(close.is_some());
        }
    }
    assert!(gone > 5_000 && found > 2_000, "{gone} {found}");
}

#[test]
fn the_sizes_of_coefficients_tell_what_the_bound_tells() {
    let (mut state, mut within) = (3, [0; 2]);
    for round in 0..20_000 {
        let decimals = (round % 5) as u8;
        let cubics = drawn(&mut state, decimals);
        let rules = Rules {
            part: 0.02,
            absolute: 0.0,
            decimals,
            elliptic: true,
            drawn_only: false,
            longest: usize::MAX,
        };
        for cubics in [&cubics[..1], &cubics] {
            let found = closer(cubics, &rules);
            let Some(found) = found.filter(|found| found.count == cubics.len()) else {
                continue;
            };
            let bound = roughly_from_arc(cubics, &found.arc);
            for (limit, fits) in [
                (0.999 * bound, false),
                (1.001 * bound, true),
                (2.0 * bound, true),
            ] {
                assert_eq!(is_within(cubics, &found.arc, limit), fits, "{cubics:?}");
                let known = found.strayed(cubics, limit);
                assert_eq!(known, bound.max(limit), "{cubics:?}");
            }
            assert!(strays_from(&cubics[0], &found.given) <= bound, "{cubics:?}");
            within[cubics.len() - 1] += 1;
        }
    }
    assert!(within[0] > 5_000 && within[1] > 1_000, "{within:?}");
}

#[test]
fn a_chain_that_comes_back_to_its_start_has_no_chord() {
    let bow = |[a, b, c, d]: [(f64, f64); 4]| CubicBez::new(a, b, c, d);
    let there = bow([(0.0, 0.0), (0.0, 1.0), (2.0, 1.0), (2.0, 0.0)]);
    let back = bow([(2.0, 0.0), (2.0, -1.0), (0.0, -1.0), (0.0, 0.0)]);
    // The highest point of a bow is 3/4 of its control points high.
    assert!((from_chord(&[there]) - 0.75).abs() < 1e-14);
    assert_eq!(from_chord(&[there, back]), f64::INFINITY);
    assert_eq!(from_chord(&[]), f64::INFINITY);
}
