//! Samples, and what they tell, by known answers.

use kurbo::Affine;

use super::*;
use crate::angle::Angle;
use crate::measure::radial;
use crate::method::{Method, Span};

fn level(center: (f64, f64), radii: (f64, f64)) -> Truth {
    Truth::new(center.into(), radii.into(), Vec2::new(1.0, 0.0))
}

fn close(found: f64, expected: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= 1e-13 * expected.abs(),
        "{found:e} is not {expected:e}"
    );
}

#[test]
fn weights_are_bernsteins_at_even_angles() {
    let quarters = |i: usize| [0, 1, 2, 3].map(|k| MANY_WEIGHTS[k][i]);
    // At θ = 0, 60, 90 and 180 degrees t is 0, 1/4, 1/2 and 1.
    for (i, expected) in [
        (0, [64.0, 0.0, 0.0, 0.0]),
        (32, [27.0, 27.0, 9.0, 1.0]),
        (48, [8.0, 24.0, 24.0, 8.0]),
        (96, [0.0, 0.0, 0.0, 64.0]),
    ] {
        for (found, expected) in quarters(i).into_iter().zip(expected) {
            assert!((found - expected / 64.0).abs() < 1e-15, "{i}: {found}");
        }
    }
}

#[test]
fn samples_know_their_excess_and_the_slope_of_it() {
    // Half of each radius along both axes: |q|² is 1/2, and Q is 1/4 of the sum of 1/a² and 1/b².
    let axis = Vec2::new(0.6, 0.8);
    for (radii, q) in [((4.0, 2.0), 0.078_125), ((2.0, 4.0), 0.078_125)] {
        let truth = Truth::new(Point::new(3.0, -5.0), radii.into(), axis);
        let arm = Vec2::new(radii.0, -radii.1) * 0.5;
        let p = truth.center + arm.rotate_scale(axis);
        let mut frame = EllipseFrame::new(&truth);
        assert_eq!(frame.reach, 9.0);
        close(frame.rounding(), 32.0 * f64::EPSILON * 9.0 * 2.0);
        let samples = frame.samples(&CubicBez::new(p, p, p, p), &FEW_WEIGHTS);
        // The short axis is that along which the sample vanishes on the long one.
        let long = if radii.0 > radii.1 { -0.5 } else { 0.5 };
        for i in 0..FEW {
            close(samples.excess[i], -0.5);
            close(samples.steepness[i], 1.0 / q);
            close(samples.long[i], long);
        }
        let far = [(0.0, 0.0), (20.0, 0.0), (0.0, -30.0), (0.0, 10.0)].map(Point::from);
        let [a, b, c, d] = far;
        frame.samples(&CubicBez::new(a, b, c, d), &FEW_WEIGHTS);
        assert_eq!(frame.reach, 30.0);
    }
}

#[test]
fn points_that_turn_one_after_the_other_are_told() {
    let quarter = [[1.0, 0.0], [1.0, 0.55], [0.55, 1.0], [0.0, 1.0]];
    assert!(turns(&quarter));
    let mirrored = quarter.map(|[x, y]| [x, -y]);
    assert!(turns(&mirrored));
    // Each pair of neighbours, and each two of three, in the wrong order or at one place.
    for [i, j] in [[0, 1], [1, 2], [2, 3], [0, 3]] {
        let mut swapped = quarter;
        swapped.swap(i, j);
        assert!(!turns(&swapped) || [i, j] == [0, 3], "{i} {j}");
        let mut equal = quarter;
        equal[i] = equal[j];
        assert!(!turns(&equal), "{i} {j}");
    }
    let beyond = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.1], [-1.0, -0.1]];
    assert!(!turns(&beyond));
    let straight = [[1.0, 1.0], [2.0, 2.0], [3.0, 3.0], [4.0, 4.0]];
    assert!(!turns(&straight));
    // A line through (5, 7): products of coordinates are not those of a turn.
    assert!(turns(&[[5.0, 7.0], [4.0, 7.0], [3.0, 7.0], [2.0, 7.0]]));
}

fn samples(excess: f64, steepness: f64, long: [f64; 2]) -> SegmentSamples<FEW> {
    let mut samples = SegmentSamples {
        excess: [excess; FEW],
        steepness: [steepness; FEW],
        long: [long[0]; FEW],
        turns: true,
    };
    samples.long[FEW - 1] = long[1];
    samples
}

#[test]
fn the_highest_sample_is_found_with_its_parabola() {
    let mut some = samples(0.0, 4.0, [1.0; 2]);
    for (i, excess) in [(7, 0.01), (8, -0.03), (9, 0.02), (20, 0.03)] {
        some.excess[i] = excess;
    }
    // √(F² · 4)/2 is |F|; the vertex of the parabola through (0.01, 0.03, 0.02) is (25/24)·0.03.
    let (sample, top) = some.peak();
    assert_eq!(some.farthest(), 8);
    close(sample, 0.03);
    close(top, 0.03 + 0.01 / 24.0);
    for end in [0, FEW - 1] {
        some.excess[end] = 0.5;
        assert_eq!(some.peak(), (0.5, 0.5));
        some.excess[end] = 0.0;
    }
}

/// F, 1/Q, the coordinate that vanishes on the long axis, there and in the last sample, and the bound.
const BOUNDS: [(f64, f64, [f64; 2], f64); 7] = [
    (0.001, 0.5, [1.0, 1.0], 0.000_383_668_144_622_789_05),
    (-0.001, 0.5, [1.0, 1.0], 0.000_383_284_251_719_897_3),
    (0.02, 0.75, [-1.0, -1.0], 0.009_748_743_651_726_231),
    (0.001, 0.5, [1.0, -1.0], 0.000_542_612_215_559_775_4),
    (-0.002, 0.5, [-1.0, 1.0], 0.001_086_999_574_259_776),
    (0.001, 0.5, [1.0, 0.0], 0.000_542_612_215_559_775_4),
    (0.125, 0.25, [2.0, 3.0], 0.040_489_361_519_809_41),
];

#[test]
fn the_bound_is_that_of_the_proof() {
    let frame = EllipseFrame::new(&level((0.0, 0.0), (1.0, 0.5)));
    // By Python's mpmath from the formulas above, with 24 steps.
    for (excess, steepness, long, expected) in BOUNDS {
        let some = samples(excess, steepness, long);
        close(some.bound(&frame), expected);
        let wide = EllipseFrame::new(&level((0.0, 0.0), (0.5, 1.0)));
        close(some.bound(&wide), expected);
    }
    let unknown = [
        samples(0.48, 1.0, [1.0; 2]),
        samples(-0.2, 4.0, [1.0; 2]),
        SegmentSamples {
            turns: false,
            ..samples(0.001, 0.5, [1.0; 2])
        },
    ];
    for some in unknown {
        assert_eq!(some.bound(&frame), f64::INFINITY);
    }
    // One sample, and a step on either side of it.
    for place in [0, 11, FEW - 1] {
        let mut one = samples(0.0, 0.5, [1.0; 2]);
        one.excess[place] = 0.001;
        assert!(one.bound(&frame) > 0.000_35, "{place}");
    }
}

#[test]
fn what_samples_cannot_tell_they_do_not() {
    let quarter = |center: (f64, f64), radii: (f64, f64), size: f64| {
        let at = |x: f64, y: f64| Point::new(center.0 + radii.0 * x, center.1 + radii.1 * y);
        let k = 0.5523 * size;
        CubicBez::new(at(size, 0.0), at(size, k), at(k, size), at(0.0, size))
    };
    let told = |center, radii, size| {
        let (truth, curve) = (level(center, radii), quarter(center, radii, size));
        let segments = || [PathSeg::Cubic(curve)];
        let peak = radial::error(&segments(), &truth).peak();
        let [few, many] = [nearly(segments(), &truth), closely(segments(), &truth)];
        for [low, high] in [few, many].into_iter().flatten() {
            assert!(low <= peak && peak <= high, "{center:?} {radii:?} {size}");
        }
        if let Some([low, high]) = few {
            assert!(
                low > 0.95 * peak && high < 1.08 * peak,
                "{low} {peak} {high}"
            );
        }
        if let Some([low, high]) = many {
            // Flat ellipses leave more between a sample and the next.
            let loose = if radii.1 < 0.2 { 1.08 } else { 1.03 };
            assert!(
                low > 0.999 * peak && high < loose * peak,
                "{low} {peak} {high}"
            );
        }
        [few.is_some(), many.is_some()]
    };
    let origin = (0.0, 0.0);
    for radii in [(1.0, 0.5), (0.5, 1.0), (64.0, 32.0)] {
        assert_eq!(told(origin, radii, 1.0), [true; 2]);
    }
    // An error of 2.6e-4: near the ends of what coordinates leave of it.
    assert!(told((3e7, 0.0), (1.0, 0.5), 1.0)[0]);
    assert!(!told((0.0, 3e9), (1.0, 0.5), 1.0)[0]);
    assert!(told((0.0, 50.0), (1.0, 0.5), 1.0)[1]);
    assert!(!told((1e3, 0.0), (1.0, 0.5), 1.0)[1]);
    // Flat, or far.
    let flat = |a: f64, b: f64| {
        let piece = |i: u32| {
            let ends = [i, i + 1].map(|i| Angle::from_degrees(22.5 * f64::from(i)).direction());
            let piece = Method::Minimax.piece(&Span::from_degrees(22.5)).unwrap();
            Affine::scale_non_uniform(a, b) * piece.between(ends)
        };
        nearly((0..16).map(piece), &level(origin, (a, b))).is_some()
    };
    assert!(flat(1.0, 0.101) && flat(0.101, 1.0));
    assert!(!flat(1.0, 0.099) && !flat(0.099, 1.0));
    assert!(told(origin, (1.0, 0.5), 1.0005)[0]);
    assert!(!told(origin, (1.0, 0.5), 1.004)[0]);
}

#[test]
fn what_is_told_decides_and_else_more_samples() {
    let truth = level((0.0, 0.0), (1.0, 0.5));
    let at = |x: f64, y: f64| Point::new(x, 0.5 * y);
    let k = 0.5523;
    let curve = CubicBez::new(at(1.0, 0.0), at(1.0, k), at(k, 1.0), at(0.0, 1.0));
    let segments = || [PathSeg::Cubic(curve)];
    let peak = radial::error(&segments(), &truth).peak();
    let above = |edge: f64| move |x: f64| x > edge;
    assert_eq!(
        decided(Some([3.0, 4.0]), segments, &truth, above(2.0)),
        Some(true)
    );
    assert_eq!(
        decided(Some([3.0, 4.0]), segments, &truth, above(5.0)),
        Some(false)
    );
    // Few samples leave 1 % open, many only their bound.
    for (part, expected) in [(0.98, true), (0.997, true), (1.03, false), (1.08, false)] {
        let edge = above(part * peak);
        assert_eq!(
            decided(None, segments, &truth, edge),
            Some(expected),
            "{part}"
        );
        let loose = Some([0.5 * peak, 2.0 * peak]);
        assert_eq!(
            decided(loose, segments, &truth, edge),
            Some(expected),
            "{part}"
        );
    }
    assert_eq!(decided(None, segments, &truth, above(1.002 * peak)), None);
}

#[test]
fn a_peak_that_is_a_sample_is_no_less_than_what_samples_tell() {
    // Nearer than the ellipse all along, most in the middle, above the end of the short axis, where one of the samples lies.
    let truth = level((1.0, -2.0), (3.0, 2.0));
    let [from, to] = [60.0_f64, 120.0].map(|angle| Vec2::from_angle(angle.to_radians()));
    let handle = 0.9 * 4.0 / 3.0 * libm::tan(core::f64::consts::FRAC_PI_6 / 2.0);
    let unit = CubicBez::new(
        from.to_point(),
        (from + from.turn_90() * handle).to_point(),
        (to - to.turn_90() * handle).to_point(),
        to.to_point(),
    );
    let segment = PathSeg::Cubic(truth.placement() * unit);
    let peak = radial::error([&segment], &truth).peak();
    let [low, high] = closely([segment], &truth).unwrap();
    assert!(low <= peak && low > peak * (1.0 - 1e-9), "{low} {peak}");
    assert!(high >= peak && high < 1.02 * peak, "{high} {peak}");
}

#[test]
fn bounds_hold_where_coordinates_are_rounded() {
    let truth = level((1e6, -2e6), (1.0, 0.5));
    for size in [1.0, 3.0, 7.0] {
        let piece = Method::Minimax.piece(&Span::from_degrees(size)).unwrap();
        for from in [0.0_f64, 40.0, 88.0, 200.0] {
            let ends = [from, from + size].map(|angle| Vec2::from_angle(angle.to_radians()));
            let segment = truth.placement() * piece.between(ends);
            let peak = radial::error([&segment], &truth).peak();
            for found in [bound([segment], &truth), closer_bound([segment], &truth)] {
                assert!(found >= peak, "{size} {from}: {found} {peak}");
            }
        }
    }
}

#[test]
fn bounds_hold_where_the_end_beside_a_tip_is_the_farthest() {
    // From ten degrees before a tip to 1/1000 beside it, where the distance of as large an excess grows by a third from the last sample but one.
    let truth = level((0.0, 0.0), (1.0, 0.001));
    let piece = Method::Minimax.piece(&Span::from_degrees(10.0)).unwrap();
    let ends = [10.06_f64, 0.06].map(|angle| Vec2::from_angle(angle.to_radians()));
    let mirrored = Affine::FLIP_Y * piece.between(ends.map(|v| Vec2::new(v.x, -v.y)));
    let PathSeg::Cubic(mut cubic) = mirrored else {
        panic!("{mirrored:?}")
    };
    cubic.p3 = (cubic.p3.to_vec2() * (1.0 + 1e-7)).to_point();
    for cubic in [cubic, CubicBez::new(cubic.p3, cubic.p2, cubic.p1, cubic.p0)] {
        let segment = PathSeg::Cubic(truth.placement() * cubic);
        let peak = radial::error([&segment], &truth).peak();
        let found = bound([segment], &truth);
        assert!(found >= peak && found < 1.3 * peak, "{found} {peak}");
    }
}

#[test]
fn bounds_hold_far_from_the_ellipse() {
    let mut told = 0;
    for radii in [(1.0, 0.8), (0.5, 1.0), (1.0, 0.25)] {
        let truth = level((0.0, 0.0), radii);
        for i in 0..400 {
            let at = |k: usize| (i * k % 401) as f64 / 401.0;
            let (from, size) = (6.2 * at(7), 0.3 + 2.0 * at(11));
            let [a, b] = [from, from + size].map(Vec2::from_angle);
            let reach = 4.0 / 3.0 * libm::tan(size / 4.0);
            let [near, far] = [0.45 + 0.7 * at(17), 0.45 + 0.7 * at(23)];
            let [out, into] = [0.2 + 1.6 * at(29), 0.2 + 1.6 * at(31)].map(|part| part * reach);
            let points = [
                a * near,
                (a + a.turn_90() * out) * near,
                (b - b.turn_90() * into) * far,
                b * far,
            ];
            let [p0, p1, p2, p3] = points.map(Vec2::to_point);
            let segment = PathSeg::Cubic(truth.placement() * CubicBez::new(p0, p1, p2, p3));
            let peak = radial::error([&segment], &truth).peak();
            for found in [bound([segment], &truth), closer_bound([segment], &truth)] {
                assert!(found >= peak, "{radii:?} {i}: {found} {peak}");
                // Where |F| is beyond a half no walk is sure to meet the ellipse.
                assert!(near.min(far) > 0.7 || found == f64::INFINITY);
                told += usize::from(found.is_finite());
            }
        }
    }
    assert!(told > 200, "{told}");
}
