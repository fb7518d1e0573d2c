//! What the bounds on distances lean on: counts of roundings, derivatives, samples and sizes, by known answers.

mod far;
mod margins;
mod places;
mod scales;

use kurbo::Vec2;

use super::part::{CubicPart, Motion};
use super::slopes::{multipliers, narrowed};
use crate::numeric::ball::Ball;
use crate::numeric::foot::{foot, foot_in_unit};

const EPSILON: f64 = f64::EPSILON;

/// Numbers between -1 and 1 that look random.
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / f64::from(2_u32).powi(52) - 1.0
    }

    pub(super) fn some<const N: usize>(&mut self) -> [f64; N] {
        core::array::from_fn(|_| self.next())
    }
}

pub(super) fn apart(a: f64, b: f64) -> f64 {
    (a - b).abs()
}

/// The value and the first two derivatives of a polynomial by Bernstein's own sum.
fn by_bernstein(coefficients: &[f64], t: f64) -> [f64; 3] {
    let sum = |coefficients: &[f64]| -> f64 {
        let n = coefficients.len() - 1;
        let choose = |k: usize| (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
        let raised = |x: f64, k: usize| (0..k).fold(1.0, |power, _| power * x);
        let term = |k: usize| choose(k) * raised(t, k) * raised(1.0 - t, n - k);
        (0..=n).map(|k| coefficients[k] * term(k)).sum()
    };
    let differences = |c: &[f64]| -> Vec<f64> {
        let n = (c.len() - 1) as f64;
        c.windows(2).map(|pair| n * (pair[1] - pair[0])).collect()
    };
    let first = differences(coefficients);
    let second = differences(&first);
    [sum(coefficients), sum(&first), sum(&second)]
}

#[test]
fn a_part_is_a_piece_of_the_whole() {
    let mut dice = Dice(1);
    for _ in 0..50 {
        let (excess, points) = (dice.some::<7>(), [dice.some::<4>(), dice.some::<4>()]);
        let whole = CubicPart::new([0.0, 1.0], excess, points, false);
        let [before, after] = whole.halves();
        let [third, last] = after.halves();
        let center = Vec2::new(0.25, -0.5);
        assert_eq!(third.parameters(), [0.5, 0.75]);
        for part in [whole, before, after, third, last] {
            let [from, to] = part.parameters();
            assert_eq!([part.parameter(0.0), part.parameter(1.0)], [from, to]);
            for t in [0.0, 0.2, 0.5, 1.0] {
                let (place, width) = (part.parameter(t), to - from);
                let motion = part.motion_at(t, center);
                let expect = |found: [f64; 3], coefficients: &[f64], less: f64| {
                    let [value, first, second] = by_bernstein(coefficients, place);
                    let true_values = [value - less, width * first, width * width * second];
                    for (found, expected) in found.iter().zip(true_values) {
                        assert!(apart(*found, expected) < 1e-13, "{found} is not {expected}");
                    }
                };
                let Motion {
                    place,
                    velocity,
                    acceleration,
                    ..
                } = &motion;
                expect([motion.excess, motion.rising, motion.bending], &excess, 0.0);
                expect(
                    [place[0], velocity[0], acceleration[0]],
                    &points[0],
                    center.x,
                );
                expect(
                    [place[1], velocity[1], acceleration[1]],
                    &points[1],
                    center.y,
                );
            }
        }
    }
}

/// A part that stands still, so that nothing is left of its derivatives but what rounding may have done.
fn still(place: [f64; 2], excess: f64, turned: bool) -> CubicPart {
    CubicPart::new([0.0, 1.0], [excess; 7], place.map(|x| [x; 4]), turned)
}

fn close(found: f64, units: f64, size: f64) {
    let expected = units * EPSILON * size;
    assert!(
        apart(found, expected) <= 1e-9 * expected,
        "{found:e} is not {units} of {size}"
    );
}

/// Parts that stand still, and how often they were halved: each time six steps of half a rounding more for F and three for points.
fn stills(place: [f64; 2], excess: f64, turned: bool) -> [(CubicPart, f64); 3] {
    let whole = still(place, excess, turned);
    let half = whole.halves()[1];
    [(whole, 0.0), (half, 1.0), (half.halves()[0], 2.0)]
}

#[test]
fn every_rounding_of_the_excess_is_counted() {
    for (part, steps) in stills([3.0, -0.125], -0.5, false) {
        let once = 1.0 + 3.0 * steps;
        close(part.rounding(), once + 9.0, 0.5);
        let [low, high] = part.certain_excess();
        close(-0.5 - low, once, 0.5);
        close(high + 0.5, once, 0.5);
        let middle = part.motion_at(0.5, Vec2::ZERO);
        let rounded = part.rounded(&middle);
        let (spread, sizes) = (part.spread(&rounded), part.sizes(&middle));
        let (rising, bending) = (12.0 * once + 128.0, 120.0 * once + 1024.0);
        close(rounded.rising.radius, rising, 0.5);
        close(rounded.bending.radius, bending, 0.5);
        close(sizes.rising[1], rising, 0.5);
        close(-sizes.rising[0], rising, 0.5);
        close(sizes.bending[1], bending, 0.5);
        close(-sizes.bending[0], bending, 0.5);
        close(spread.bending.radius, bending, 0.5);
        close(spread.rising.radius, rising + bending / 2.0, 0.5);
    }
}

#[test]
fn every_rounding_of_a_point_is_counted() {
    let place = [3.0, -0.125];
    for turned in [false, true] {
        for (part, steps) in stills(place, -0.5, turned) {
            let middle = part.motion_at(0.5, Vec2::ZERO);
            let rounded = part.rounded(&middle);
            let (spread, sizes) = (part.spread(&rounded), part.sizes(&middle));
            for (i, place) in place.into_iter().enumerate() {
                // In units of this size; a direction that turned is rounded too.
                let size = f64::abs(place);
                let given = if turned {
                    4.0 * (1.0 + 3.0 + 0.125) / size
                } else {
                    2.0
                };
                let moved = given + 1.5 * steps;
                close(part.moved()[i], moved + 4.5, size);
                let (velocity, acceleration) = (6.0 * moved + 32.0, 24.0 * moved + 128.0);
                close(rounded.place[i].radius, moved + 4.5 + 1.0, size);
                close(rounded.velocity[i].radius, velocity, size);
                close(rounded.acceleration[i].radius, acceleration, size);
                for found in [sizes.acceleration[i], spread.acceleration[i].radius] {
                    close(found, acceleration, size);
                }
                let velocity = velocity + acceleration / 2.0;
                for found in [sizes.velocity[i], spread.velocity[i].radius] {
                    close(found, velocity, size);
                }
                let units = moved + 5.5 + velocity / 2.0;
                close(spread.place[i].radius, units, size);
                let off = sizes.place[i] - size - units * EPSILON * size;
                assert!(off.abs() <= 1.01 * EPSILON * size, "{off:e}");
            }
        }
    }
}

#[test]
fn sizes_along_a_part_are_those_of_its_places_and_attained() {
    let mut dice = Dice(2);
    let center = Vec2::new(0.25, -0.5);
    for round in 0..100 {
        // F of degree 3 and points of degree 2 and 3: where the next derivative is constant the bound is attained.
        let [a, b, c, d] = dice.some::<4>();
        let value = |t: f64| a + t * (b + t * (c + t * d));
        let cubic = [a, a + b / 3.0, a + (2.0 * b + c) / 3.0, a + b + c + d];
        let raise = |from: Vec<f64>| -> Vec<f64> {
            let n = from.len();
            let at = |i: usize| from.get(i).copied().unwrap_or_default();
            let mixed = |i: usize| {
                let part = i as f64 / n as f64;
                part * if i == 0 { 0.0 } else { at(i - 1) } + (1.0 - part) * at(i)
            };
            (0..=n).map(mixed).collect()
        };
        let raised = (0..3).fold(cubic.to_vec(), |row, _| raise(row));
        let excess: [f64; 7] = core::array::from_fn(|i| raised[i]);
        assert!(apart(by_bernstein(&excess, 0.3)[0], value(0.3)) < 1e-14);
        let [p, q, r, s] = dice.some::<4>();
        let points = [[p, q, r, s], [r, r + s / 3.0, r + 2.0 * s / 3.0, r + s]];
        let part = CubicPart::new([0.0, 1.0], excess, points, false).halves()[round % 2];
        let middle = part.motion_at(0.5, center);
        let sizes = part.sizes(&middle);
        let spread = part.spread(&part.rounded(&middle));
        let places: Vec<_> = (0..=64)
            .map(|i| part.motion_at(f64::from(i) / 64.0, center))
            .collect();
        let most =
            |of: &dyn Fn(&Motion<f64>) -> f64| places.iter().map(of).fold(f64::MIN, f64::max);
        let tiny = 1e-11;
        // F'' runs evenly from end to end.
        let [low, high] = sizes.bending;
        assert!(apart(high, most(&|m| m.bending)) < tiny);
        assert!(apart(-low, most(&|m| -m.bending)) < tiny);
        assert!(apart(spread.bending.size(), most(&|m| m.bending.abs())) < tiny);
        let [low, high] = sizes.rising;
        assert!(high > most(&|m| m.rising) - tiny && -low > most(&|m| -m.rising) - tiny);
        let excess = middle.excess.abs() + spread.rising.size() / 2.0;
        assert!(apart(spread.excess.size(), excess) < tiny);
        for i in 0..2 {
            let acceleration = most(&|m| m.acceleration[i].abs());
            assert!(apart(sizes.acceleration[i], acceleration) < tiny);
            assert!(apart(spread.acceleration[i].size(), acceleration) < tiny);
            let velocity = middle.velocity[i].abs() + acceleration / 2.0;
            assert!(apart(sizes.velocity[i], velocity) < tiny);
            assert!(apart(spread.velocity[i].size(), velocity) < tiny);
            let place = middle.place[i].abs() + velocity / 2.0;
            assert!(apart(sizes.place[i], place) < tiny);
            assert!(apart(spread.place[i].size(), place) < tiny);
            assert!(velocity > most(&|m| m.velocity[i].abs()) - tiny);
            assert!(place > most(&|m| m.place[i].abs()) - tiny);
        }
    }
}

#[test]
fn the_least_place_is_that_of_the_control_points() {
    let part = |x: [f64; 4]| CubicPart::new([0.0, 1.0], [0.0; 7], [x, [0.0; 4]], false);
    for (x, center, expected) in [
        ([2.0, 3.0, 4.0, 5.0], 1.0, 1.0),
        ([5.0, 4.0, 3.0, 2.0], 1.0, 1.0),
        ([3.0, 2.0, 5.0, 4.0], 0.5, 1.5),
        ([5.0, 4.0, 2.0, 3.0], 0.5, 1.5),
        ([-5.0, -4.0, -3.0, -2.0], 1.0, 3.0),
        ([-2.0, -4.0, -3.0, -5.0], 1.0, 3.0),
        ([-1.0, 2.0, 3.0, 4.0], 0.0, 0.0),
        ([4.0, 3.0, 2.0, -1.0], 0.0, 0.0),
    ] {
        let [least, none] = part(x).least_place(Vec2::new(center, 0.0));
        assert!(
            least <= expected && expected - least <= 20.0 * EPSILON,
            "{x:?}: {least}"
        );
        assert_eq!(none, 0.0);
    }
    // Three roundings of the largest coordinate, and one of the centre.
    let [least, _] = part([8.0, 8.0, 8.0, 16.0]).least_place(Vec2::new(4.0, 0.0));
    assert_eq!(4.0 - least, (2.0 * 16.0 + 16.0 + 4.0) * EPSILON);
}

#[test]
fn slopes_are_the_derivatives_of_the_distance() {
    let mut dice = Dice(3);
    for _ in 0..50 {
        let radii = Vec2::new(1.0, 0.6 + 0.3 * dice.next());
        let alpha = [1.0, 1.0 / (radii.y * radii.y)];
        // About the unit circle, in the frame where the ellipse is one.
        let far = |x: f64| x * 0.05;
        let [a, b, c, d] = dice.some::<4>().map(far);
        let points = [
            [1.0 + a, 1.0 + b, 0.55 + c, d],
            [a, 0.55 + b, 1.0 + c, 1.0 + d],
        ];
        let part = CubicPart::new([0.0, 1.0], [0.0; 7], points, false);
        let motion = |t: f64| {
            let mut motion = part.motion_at(t, Vec2::ZERO);
            let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
            let Motion {
                place,
                velocity,
                acceleration,
                ..
            } = motion;
            motion.excess = dot(place, place) - 1.0;
            motion.rising = 2.0 * dot(place, velocity);
            motion.bending = 2.0 * (dot(velocity, velocity) + dot(place, acceleration));
            motion
        };
        let image = |m: &Motion<f64>| Vec2::new(m.place[0] * radii.x, m.place[1] * radii.y);
        let multiplier =
            |m: &Motion<f64>| foot_in_unit(radii, alpha, image(m), m.excess).multiplier;
        let slopes = |t: f64| {
            let m = motion(t);
            m.slopes(alpha, multiplier(&m))
        };
        let step = 1e-5;
        let rate = |f: &dyn Fn(f64) -> f64, t: f64| (f(t + step) - f(t - step)) / (2.0 * step);
        for t in [0.1, 0.37, 0.5, 0.8] {
            let (at, m) = (slopes(t), motion(t));
            let s = multiplier(&m);
            let g: f64 = (0..2)
                .map(|i| alpha[i] * (m.place[i] / (1.0 + s * alpha[i])).powi(2))
                .sum();
            let distance = |t: f64| foot(radii, image(&motion(t))).distance;
            assert!(apart(distance(t), s * g.sqrt()) < 1e-14);
            assert!(apart(at.slope / g.sqrt(), rate(&distance, t)) < 1e-8);
            assert!(apart(at.bend, rate(&|t| slopes(t).slope, t)) < 1e-8);
            assert!(apart(at.rate, rate(&|t| multiplier(&motion(t)), t)) < 1e-8);
        }
    }
}

#[test]
fn the_multiplier_lies_between_the_quotients() {
    let cases = [
        // F, G, x, its value in the middle, and between what it lies.
        ([0.01, 0.02], [1.0, 2.0], 0.0, 0.005, [0.0025, 0.01]),
        ([0.01, 0.02], [1.0, 2.0], 0.1, 0.005, [0.00175, 0.013]),
        ([-0.02, -0.01], [1.0, 2.0], 0.1, -0.005, [-0.013, -0.00175]),
        ([-0.03, 0.01], [1.0, 2.0], 0.1, 0.0, [-0.0195, 0.0065]),
        ([-0.01, 0.03], [1.0, 2.0], 0.1, 0.0, [-0.0065, 0.0195]),
        ([0.0, 0.03], [1.0, 2.0], 0.1, 0.0195, [0.0, 0.0195]),
        ([0.01, 0.02], [1.0, 2.0], 0.1, 0.012, [0.00175, 0.013]),
        ([-0.02, -0.01], [1.0, 2.0], 0.1, -0.012, [-0.013, -0.00175]),
        ([0.01, 0.02], [1.0, 2.0], 0.1, 0.001, [0.00175, 0.013]),
        ([-0.03, 0.0], [1.0, 2.0], 0.1, -0.0195, [-0.0195, 0.0]),
    ];
    for (excess, gradients, x, middle, [low, high]) in cases {
        let ball = multipliers(excess, gradients, x, Ball::new(middle, 1e-5));
        let radius = f64::max(high - middle, middle - low) + 1e-5;
        assert_eq!(ball.middle, middle);
        assert!(
            apart(ball.radius, radius) < 1e-15,
            "{excess:?}: {}",
            ball.radius
        );
    }
    // What is known in the middle cannot be less than nothing.
    let beyond = multipliers([0.01, 0.01], [1.0, 1.0], 0.0, Ball::new(0.005, 0.25));
    assert_eq!(beyond.radius, 0.25);
}

#[test]
fn a_multiplier_is_narrowed_by_how_fast_it_changes() {
    let (s, middle) = (Ball::new(0.25, 0.125), Ball::new(0.25, 0.015_625));
    // Half of the part lies on either side of its middle.
    for (rate, radius) in [(0.0, 0.015_625), (0.062_5, 0.046_875), (0.5, 0.125)] {
        let found = narrowed(s, middle, rate);
        assert_eq!((found.middle, found.radius), (0.25, radius));
    }
}
