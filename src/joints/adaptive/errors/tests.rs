//! Errors by the distance itself.

use kurbo::Vec2;

use super::*;
use crate::numeric::foot::foot;

fn errors(method: Method, short: f64) -> Errors {
    Errors::new(Rule::Method(method), method.card().law.unwrap(), short)
}

#[test]
fn the_error_is_the_largest_distance_of_many_places() {
    let methods = [
        Method::Minimax,
        Method::Curvature,
        Method::QuadraticMinimax,
        Method::MinimaxG0,
    ];
    for method in methods {
        for (short, sizes) in [
            (0.9, [80.0, 30.0]),
            (0.5, [40.0, 20.0]),
            (0.1, [12.0, 7.0]),
            (0.01, [60.0, 30.0]),
        ] {
            // Of the others the first order is enough to begin with.
            if short < 0.05 && method != Method::MinimaxG0 {
                continue;
            }
            let errors = errors(method, short);
            for from in [-100.0, -20.0, 0.0, 33.0, 84.0, 140.0] {
                for size in sizes {
                    let piece = errors.rule.piece(&Span::from_degrees(size)).unwrap();
                    let ends = [from, from + size].map(|d| Angle::from_degrees(d).direction());
                    let segment = piece.between(ends);
                    let strays = |t: f64| {
                        let p = segment.eval(t);
                        foot(Vec2::new(short, 1.0), Vec2::new(short * p.x, p.y))
                            .distance
                            .abs()
                    };
                    let most = (0..=500)
                        .map(|i| strays(f64::from(i) / 500.0))
                        .fold(0.0, f64::max);
                    let found = errors.of(from, size);
                    let off = (found / most - 1.0).abs();
                    let most = if short < 0.05 { 0.12 } else { 0.07 };
                    assert!(off < most, "{method:?} {short} {from} {size}: {off}");
                }
            }
        }
    }
}

#[test]
fn the_formula_tells_errors_that_drown_in_samples() {
    // Along so short a segment the weight hardly varies: it is that of its middle.
    for short in [0.8, 0.3] {
        for from in [0.0, 20.0, 70.0, 90.0, 130.0] {
            let errors = errors(Method::Minimax, short);
            let size = 3.0;
            let radial = errors.on_circle(size);
            assert!(radial < NOISE);
            let angle = f64::to_radians(from + size / 2.0);
            let weight = 1.0 / (libm::cos(angle) / short).hypot(libm::sin(angle));
            let off = errors.of(from, size) / (radial * weight) - 1.0;
            assert!(off.abs() < 0.1, "{short} {from}: {off}");
            // The best of both lobes and the middle.
            let lobes = LOBES.map(|part| errors.weight(from + part * size));
            let most = lobes.into_iter().fold(0.0, f64::max);
            // The error itself is told between those of two lengths nearby.
            let off = errors.of(from, size) / (radial * most) - 1.0;
            assert!(off.abs() < 1e-6, "{off}");
        }
    }
    let errors = errors(Method::Minimax, 0.25);
    assert!((errors.weight(0.0) - 0.25).abs() < 1e-15);
    assert!((errors.weight(90.0) - 1.0).abs() < 1e-15);
    assert!((errors.weight(45.0) - 1.0 / 8.5_f64.sqrt()).abs() < 1e-15);
}

#[test]
fn a_point_beside_the_ellipse_strays_by_its_distance() {
    for short in [0.9, 0.4] {
        let errors = errors(Method::Minimax, short);
        for angle in [0.0, 0.3, 1.1, 1.57, 2.5, 4.0] {
            for excess in [1e-5, -1e-5] {
                let p = Vec2::new(libm::cos(angle), libm::sin(angle)) * (1.0 + excess);
                let distance = foot(Vec2::new(short, 1.0), Vec2::new(short * p.x, p.y)).distance;
                let off = errors.strays(p.to_point()) / distance.abs() - 1.0;
                assert!(off.abs() < 1e-4, "{short} {angle}: {off}");
            }
        }
    }
}

#[test]
fn on_an_axis_any_point_strays_by_its_distance() {
    let errors = errors(Method::Minimax, 0.25);
    for (x, y, distance) in [(3.0, 0.0, 0.5), (-0.5, 0.0, 0.125), (0.0, 1.5, 0.5)] {
        assert!((errors.strays(Point::new(x, y)) - distance).abs() < 1e-15);
    }
}

#[test]
fn rough_and_sharp_are_told_by_their_edges() {
    for (short, is_sharp) in [(0.029, true), (0.031, false)] {
        assert_eq!(errors(Method::Minimax, short).is_sharp(), is_sharp);
        for (part, is_rough) in [(0.99, false), (1.01, true)] {
            let error = part * 1e-4 * short * short;
            assert_eq!(
                errors(Method::Minimax, short).is_worth_a_look(error),
                is_rough
            );
            assert!(!errors(Method::MinimaxG0, short).is_worth_a_look(error));
        }
    }
}

#[test]
fn the_peak_of_samples_is_that_of_a_parabola() {
    assert_eq!(peak(&[]), 0.0);
    assert_eq!(peak(&[3.0, 1.0]), 3.0);
    assert_eq!(peak(&[1.0, 3.0]), 3.0);
    // 5 - (t - 1.25)² at 0, 1, 2 and 3.
    assert_eq!(peak(&[3.4375, 4.9375, 4.4375, 1.9375]), 5.0);
}

#[test]
fn a_sharp_end_between_samples_is_looked_at() {
    // There the distance has a peak that is far narrower than samples are apart.
    for short in [0.02, 0.005] {
        let errors = errors(Method::QuadraticMinimax, short);
        for (from, size) in [(-100.0, 24.0), (60.0, 50.0)] {
            let piece = errors.rule.piece(&Span::from_degrees(size)).unwrap();
            let ends = [from, from + size].map(|d| Angle::from_degrees(d).direction());
            let segment = piece.between(ends);
            let strays = |i: u32| errors.strays(segment.eval(f64::from(i) / 20_000.0));
            let most = (0..=20_000).map(strays).fold(0.0, f64::max);
            let found = errors.of(from, size);
            assert!(
                (found / most - 1.0).abs() < 0.06,
                "{short} {from}: {found} {most}"
            );
        }
    }
}

#[test]
fn what_a_method_does_not_serve_is_beyond_any_error() {
    // The tangents at both ends of a whole turn lie on one line.
    for method in [Method::QuadraticMinimax, Method::Minimax, Method::MinimaxG0] {
        let errors = errors(method, 0.5);
        assert_eq!(errors.of(10.0, 360.0), f64::INFINITY, "{method:?}");
        assert!(errors.of(10.0, 100.0).is_finite(), "{method:?}");
    }
}
