//! Lobes by known answers: the curve itself, its true distance, and derivatives by differences.

use kurbo::ParamCurve;

use super::*;
use crate::method::Method;
use crate::method::Span;
use crate::numeric::foot::foot;

const METHODS: [Method; 5] = [
    Method::Midpoint,
    Method::Minimax,
    Method::Goldapp,
    Method::Curvature,
    Method::Chen3,
];

fn lobes(method: Method, short: f64) -> Lobes {
    Lobes::new(Rule::Method(method), 6.0, short)
}

/// Angles from the short axis and sizes of segments, in degrees, on ellipses of several flatnesses.
fn places() -> impl Iterator<Item = (Method, f64, f64, f64)> {
    let froms = [-170.0, -95.0, -20.0, 0.0, 33.0, 88.0, 140.0, 269.0];
    METHODS.into_iter().flat_map(move |method| {
        [(0.9, 60.0), (0.5, 30.0), (0.2, 12.0)]
            .into_iter()
            .flat_map(move |(short, size)| froms.map(|from| (method, short, from, size)))
    })
}

/// The point of the piece at v, and its true distance from the ellipse.
fn truth(lobes: &Lobes, from: f64, size: f64, v: f64) -> (Vec2, f64) {
    let ends = [from, from + size].map(|degrees| Angle::from_degrees(degrees).direction());
    let piece = lobes.rule.piece(&Span::from_degrees(size)).unwrap();
    let p = piece.between(ends).eval(f64::midpoint(v, 1.0)).to_vec2();
    let radii = Vec2::new(lobes.short, 1.0);
    (p, foot(radii, Vec2::new(lobes.short * p.x, p.y)).distance)
}

#[test]
fn a_lobe_knows_the_true_distance_and_how_it_changes() {
    for (method, short, from, size) in places() {
        let lobes = lobes(method, short);
        let segment = LobeSegment::new(&lobes, from, size).unwrap();
        for i in -9..=9 {
            let v = f64::from(i) * 0.097;
            let (p, distance) = truth(&lobes, from, size, v);
            if distance.abs() < 1e-11 {
                continue;
            }
            let what = format!("{method:?} {short} {from} {size} {v}");
            let lobe = segment.at(v);
            let off = (lobe.distance / distance.abs() - 1.0).abs();
            // The digits of the coordinates, and the third order.
            assert!(off < 1e-5 + 1e-15 / distance.abs(), "{what}: {off:e}");
            let around = (lobes.short * p.y).hypot(p.x) / p.hypot();
            let curvature = short / (around * around * around);
            let rough = lobe.roughness / (distance.abs() * curvature) - 1.0;
            assert!(rough.abs() < 0.02, "{what}: {rough}");
            let angle = libm::atan2(p.y, p.x);
            let weight =
                |angle: f64| -libm::log((libm::cos(angle) / short).hypot(libm::sin(angle)));
            let turn = (weight(angle + 1e-5) - weight(angle - 1e-5)) / 2e-5;
            assert!(
                (lobe.turn - turn).abs() < 1e-4 * (1.0 + turn.abs()),
                "{what}: {turn}"
            );
            slopes_hold(&segment, v, &what);
        }
    }
}

/// Whether the step and the gain at v follow from the first two derivatives of the distance's logarithm, by differences.
fn slopes_hold(segment: &LobeSegment, v: f64, what: &str) {
    let step = 1e-3;
    let [before, lobe, after] = [v - step, v, v + step].map(|v| segment.at(v));
    let log = |lobe: &Lobe<f64>| libm::log(lobe.distance);
    let slope = (log(&after) - log(&before)) / (2.0 * step);
    let bend = (log(&after) - 2.0 * log(&lobe) + log(&before)) / (step * step);
    if slope.abs() > 20.0 || lobe.distance < 1e-9 {
        return;
    }
    // The bend is told nearly, so that its sign may not be where it is next to nothing.
    let newton = -slope / bend;
    let (step, gain) = if bend < -1.0 {
        (newton.clamp(-STEP, STEP), 0.5 * slope * newton)
    } else if bend > 1.0 {
        (STEP.copysign(slope), STEP * slope.abs())
    } else {
        return;
    };
    let tiny = 2e-3 + 0.05 * step.abs();
    assert!(
        (lobe.step - step).abs() < tiny,
        "{what}: {} is not {step}",
        lobe.step
    );
    let tiny = 2e-3 + 0.05 * gain.abs();
    assert!(
        (lobe.gain - gain).abs() < tiny,
        "{what}: {} is not {gain}",
        lobe.gain
    );
}

#[test]
fn the_largest_distance_is_that_of_many_places() {
    for (method, short, from, size) in places() {
        let lobes = lobes(method, short);
        for size in [size, 0.5 * size, 1.7 * size] {
            let most = (-400..=400)
                .map(|i| truth(&lobes, from, size, f64::from(i) / 400.0).1.abs())
                .fold(0.0, f64::max);
            let what = format!("{method:?} {short} {from} {size}: {most:e}");
            let found = lobes.size(from, size);
            assert!((found / most - 1.0).abs() < 1e-3, "{what} {found:e}");
            for part in [0.3, 0.99, 1.01, 3.0] {
                let allowed = part * found;
                let reached = lobes.size_up_to(from, size, allowed);
                assert_eq!(reached <= allowed, found <= allowed, "{what} {part}");
            }
        }
    }
}

#[test]
fn slopes_tell_how_the_peak_changes_with_both_ends() {
    for (method, short, from, size) in places() {
        let order = match method {
            Method::Chen3 => 4.0,
            _ => 6.0,
        };
        let lobes = Lobes::new(Rule::Method(method), order, short);
        let peak = |from: f64, to: f64| libm::log(lobes.of(from, to - from).unwrap().size);
        let Some(found) = lobes.of(from, size) else {
            continue;
        };
        let step = 1e-3 * size;
        let to = from + size;
        let differences = [
            peak(from + step, to) - peak(from - step, to),
            peak(from, to + step) - peak(from, to - step),
        ];
        for (found, difference) in found.slopes.into_iter().zip(differences) {
            // In units of the order over the size.
            let off = (found - difference / (2.0 * step)) * size / order;
            assert!(off.abs() < 0.1, "{method:?} {short} {from} {size}: {off}");
        }
    }
}

#[test]
fn angles_after_a_sharp_end_are_within_half_a_turn() {
    for (from, after) in [
        (90.0, 0.0),
        (95.0, 5.0),
        (269.0, 179.0),
        (270.0, 0.0),
        (0.0, 90.0),
        (-89.0, 1.0),
        (-90.0, 0.0),
        (-95.0, 175.0),
        (-270.0, 0.0),
        (-271.0, 179.0),
        (451.0, 1.0),
    ] {
        assert_eq!(after_sharp_end(from), after, "{from}");
    }
}

#[test]
fn short_segments_are_tame() {
    let lobes = lobes(Method::Minimax, 0.01);
    // Fourteen times the sharp end's size, or the way to it: in degrees 8.02, and 14 √(0.01² + way²).
    let reach = |way: f64| 14.0 * way.to_radians().hypot(0.01).to_degrees();
    assert!((reach(0.0) - 8.021).abs() < 1e-3);
    for part in [0.999, 1.001] {
        let is_tame = part < 1.0;
        // From the sharp end on, across it, up to it, and some way behind and before it.
        let size = part * reach(0.0);
        for from in [90.0, 88.0, 90.0 - size, 270.0, -92.0] {
            assert_eq!(lobes.is_tame(from, size), is_tame, "{from} {part}");
        }
        let size = part * reach(1.0);
        for from in [91.0, 271.0, 89.0 - size, -91.0 - size] {
            assert_eq!(lobes.is_tame(from, size), is_tame, "{from} {part}");
        }
    }
    assert!(lobes.of(91.0, 0.99).is_none() && lobes.of(91.0, 1.0).is_some());
    assert!(lobes.of(90.0, 9.0).is_none());
}

#[test]
fn a_crossing_lies_on_the_sharp_end() {
    for short in [0.01, 0.03] {
        let lobes = lobes(Method::Minimax, short);
        for from in [60.0, 85.0, 250.0, -130.0] {
            let sizes: Vec<f64> = lobes.crossing_sharp_end(from).collect();
            assert_eq!(sizes.len(), 2, "{from}");
            assert!(sizes[0] < sizes[1], "{sizes:?}");
            let way = 180.0 - after_sharp_end(from);
            for size in sizes {
                // v where the curve passes the sharp end, and how large F is beside its largest.
                let v = 2.0 * way / size - 1.0;
                let segment = LobeSegment::new(&lobes, from, size).unwrap();
                let [h, g] = segment.cubic.excess;
                let excess = |v: f64| {
                    let u = (1.0 - v * v) / 4.0;
                    (u * u * (h + g * u)).abs()
                };
                assert!(excess(v) < 0.02 * excess(0.0), "{short} {from} {size}");
            }
        }
    }
}

#[test]
fn spread_joints_err_nearly_alike() {
    for (short, worst) in [(0.8, 1.1), (0.5, 1.4), (0.3, 2.2)] {
        let lobes = lobes(Method::Minimax, short);
        let root = libm::pow(short, 1.0 / 6.0);
        for (from, whole, pieces) in [(0.0, 360.0, 16), (-40.0, 200.0, 9), (70.0, 33.0, 2)] {
            let ways = Lobes::spread(root, from, whole, pieces);
            assert_eq!(ways.len(), pieces + 1);
            assert_eq!([ways[0], ways[pieces]], [0.0, whole]);
            let sizes = ways
                .windows(2)
                .map(|w| lobes.size(from + w[0], w[1] - w[0]));
            let (least, most) = sizes.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
            assert!(
                most < worst * least,
                "{short} {from} {whole}: {}",
                most / least
            );
        }
    }
}

#[test]
fn sharp_ends_are_passed_where_they_lie() {
    let lobes = lobes(Method::Minimax, 0.5);
    for (from, size, sharp) in [
        (90.0, 30.0, None),
        (75.0, 30.0, Some(0.0)),
        (60.0, 40.0, Some(0.5)),
        (-100.0, 20.0, Some(0.0)),
        (59.0, 30.0, None),
        (150.0, 150.0, Some(0.6)),
    ] {
        let found = LobeSegment::new(&lobes, from, size).unwrap().sharp;
        let is_same = match (found, sharp) {
            (Some(found), Some(sharp)) => f64::abs(found - sharp) < 1e-12,
            (found, sharp) => found == sharp,
        };
        assert!(is_same, "{from} {size}: {found:?}");
    }
}

#[test]
fn a_segment_that_no_handle_serves_is_beyond_any_error() {
    // The tangents at both ends of a whole turn lie on one line.
    for method in METHODS {
        let lobes = lobes(method, 0.5);
        assert_eq!(lobes.size_up_to(10.0, 360.0, 1e9), f64::INFINITY);
        assert!(lobes.size_up_to(10.0, 100.0, 1e9).is_finite());
    }
}
