//! A part of a segment, and what its derivatives are there.

use kurbo::Vec2;

use crate::numeric::ball::Ball;

/// A part of a cubic in the frame where an ellipse is the unit circle. Derivatives are by its own parameter, from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    from: f64,
    width: f64,
    /// The Bernstein coefficients of F = |q|² - 1, and how far each may be off.
    excess: [f64; 7],
    rounding: f64,
    /// The control points, x and y, not about the centre, and how far each may be off.
    points: [[f64; 4]; 2],
    moved: [f64; 2],
    /// The largest sizes of both.
    largest: f64,
    reach: [f64; 2],
    /// Whether no halving has added to the rounding.
    pub(super) is_fresh: bool,
}

/// A place of a part, or all places: q about the centre and F, with their derivatives.
pub(super) struct Motion<T> {
    pub(super) place: [T; 2],
    pub(super) velocity: [T; 2],
    pub(super) acceleration: [T; 2],
    pub(super) excess: f64,
    pub(super) rising: T,
    pub(super) bending: T,
}

/// The largest sizes along a part, rounding included.
pub(super) struct Sizes {
    pub(super) place: [f64; 2],
    pub(super) velocity: [f64; 2],
    pub(super) acceleration: [f64; 2],
    /// Between what F'' lies, the largest |F'|, and how far F' may be off in the middle.
    pub(super) bending: [f64; 2],
    pub(super) rising: f64,
    pub(super) rising_off: f64,
}

impl Part {
    /// The part between two parameters, all of it rounded once. Where the points were `turned`, the direction was rounded too.
    pub(super) fn new(
        [from, to]: [f64; 2],
        excess: [f64; 7],
        points: [[f64; 4]; 2],
        turned: bool,
    ) -> Self {
        let reach = [largest(&points[0]), largest(&points[1])];
        let moved = if turned {
            [4.0 * (1.0 + reach[0] + reach[1]); 2]
        } else {
            [2.0 * reach[0], 2.0 * reach[1]]
        };
        let largest = largest(&excess);
        Self {
            from,
            width: to - from,
            excess,
            rounding: f64::EPSILON * largest,
            points,
            moved: [f64::EPSILON * moved[0], f64::EPSILON * moved[1]],
            largest,
            reach,
            is_fresh: true,
        }
    }

    /// The parameters between which it lies.
    pub(super) fn parameters(&self) -> [f64; 2] {
        [self.from, self.from + self.width]
    }

    /// Between what the coefficients of F lie, rounding included.
    pub(super) fn certain_excess(&self) -> [f64; 2] {
        let [low, high] = self.excess_range();
        [low - self.rounding, high + self.rounding]
    }

    /// How far F may be off at a place: by de Casteljau's algorithm, three roundings in each of six steps.
    pub(super) fn rounding(&self) -> f64 {
        self.rounding + 9.0 * f64::EPSILON * self.largest
    }

    /// How far q may be off at a place, its size there left out.
    pub(super) fn moved(&self) -> [f64; 2] {
        let moved = |i: usize| self.moved[i] + 4.5 * f64::EPSILON * self.reach[i];
        [moved(0), moved(1)]
    }

    /// The parameter of the cubic.
    pub(super) fn parameter(&self, t: f64) -> f64 {
        self.from + self.width * t
    }

    /// Between what the coefficients of F lie.
    pub(super) fn excess_range(&self) -> [f64; 2] {
        let [mut low, mut high] = [self.excess[0]; 2];
        for &x in &self.excess[1..] {
            low = if x < low { x } else { low };
            high = if x > high { x } else { high };
        }
        [low, high]
    }

    pub(super) fn halves(&self) -> [Self; 2] {
        self.cut(self.from + self.width / 2.0)
    }

    /// The parts before and after a parameter.
    pub(super) fn cut(&self, place: f64) -> [Self; 2] {
        let t = (place - self.from) / self.width;
        // One rounding in each step to the middle, three elsewhere.
        let steps = if t == 0.5 { 1.0 } else { 3.0 };
        let rounding = self.rounding + steps * 3.0 * f64::EPSILON * self.largest;
        let moved = |i: usize| self.moved[i] + steps * 1.5 * f64::EPSILON * self.reach[i];
        let part = |[from, to]: [f64; 2], excess: [f64; 7], points: [[f64; 4]; 2]| Self {
            from,
            width: to - from,
            largest: largest(&excess),
            excess,
            rounding,
            reach: [largest(&points[0]), largest(&points[1])],
            points,
            moved: [moved(0), moved(1)],
            is_fresh: false,
        };
        let [x, y] = &self.points;
        let ([before, after], [x, x_after], [y, y_after]) =
            (cut(self.excess, t), cut(*x, t), cut(*y, t));
        [
            part([self.from, place], before, [x, y]),
            part([place, self.from + self.width], after, [x_after, y_after]),
        ]
    }

    /// The least |q|, each coordinate on its own, by the control points.
    pub(super) fn least_place(&self, center: Vec2) -> [f64; 2] {
        let least = |i: usize, center: f64| {
            let [a, b, c, d] = self.points[i];
            let low = a.min(b).min(c.min(d)) - center;
            let high = a.max(b).max(c.max(d)) - center;
            let rounding = self.moved[i] + f64::EPSILON * (a.abs().max(d.abs()) + center.abs());
            (low.max(-high) - rounding).max(0.0)
        };
        [least(0, center.x), least(1, center.y)]
    }

    /// The control points about a centre.
    pub(super) fn polygon(&self, center: Vec2) -> [Vec2; 4] {
        let [x, y] = self.points;
        core::array::from_fn(|i| Vec2::new(x[i], y[i]) - center)
    }

    /// q about a centre and F in the middle, alone.
    pub(super) fn middle(&self, center: Vec2) -> (Vec2, f64) {
        let [x, y] = &self.points;
        let q = Vec2::new(derivatives(x, 0.5)[0], derivatives(y, 0.5)[0]);
        (q - center, derivatives(&self.excess, 0.5)[0])
    }

    /// The motion at a place.
    pub(super) fn motion_at(&self, t: f64, center: Vec2) -> Motion<f64> {
        let [excess, rising, bending] = derivatives(&self.excess, t);
        let [x, vx, ax] = derivatives(&self.points[0], t);
        let [y, vy, ay] = derivatives(&self.points[1], t);
        Motion {
            place: [x - center.x, y - center.y],
            velocity: [vx, vy],
            acceleration: [ax, ay],
            excess,
            rising,
            bending,
        }
    }

    /// The same with what rounding may have done.
    pub(super) fn rounded(&self, motion: &Motion<f64>) -> Motion<Ball> {
        let size = f64::EPSILON * self.largest;
        let rounded = |values: [f64; 2], moved: f64, factor: f64| {
            let ball = |i: usize| {
                let size = f64::EPSILON * self.reach[i];
                Ball::new(values[i], moved * self.moved[i] + factor * size)
            };
            [ball(0), ball(1)]
        };
        let [mut x, mut y] = rounded(motion.place, 1.0, 4.5);
        x.radius += f64::EPSILON * x.middle.abs();
        y.radius += f64::EPSILON * y.middle.abs();
        Motion {
            place: [x, y],
            velocity: rounded(motion.velocity, 6.0, 32.0),
            acceleration: rounded(motion.acceleration, 24.0, 128.0),
            excess: motion.excess,
            rising: Ball::new(motion.rising, 12.0 * self.rounding + 128.0 * size),
            bending: Ball::new(motion.bending, 120.0 * self.rounding + 1024.0 * size),
        }
    }

    /// The largest sizes for all places, from the motion at the middle as in [`Self::spread`].
    pub(super) fn sizes(&self, middle: &Motion<f64>) -> Sizes {
        let [mut place, mut velocity, mut acceleration] = [[0.0; 2]; 3];
        for i in 0..2 {
            let [a, b, c, d] = self.points[i];
            let third = 3.0 * ((d - a) - 3.0 * (c - b)).abs();
            let size = f64::EPSILON * self.reach[i];
            acceleration[i] =
                middle.acceleration[i].abs() + third + 24.0 * self.moved[i] + 128.0 * size;
            velocity[i] = middle.velocity[i].abs()
                + acceleration[i] / 2.0
                + 6.0 * self.moved[i]
                + 32.0 * size;
            place[i] = middle.place[i].abs() * (1.0 + f64::EPSILON)
                + velocity[i] / 2.0
                + self.moved[i]
                + 4.5 * size;
        }
        let e = &self.excess;
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for i in 0..5 {
            let second = 30.0 * ((e[i] - e[i + 1]) - (e[i + 1] - e[i + 2]));
            low = if second < low { second } else { low };
            high = if second > high { second } else { high };
        }
        let size = f64::EPSILON * self.largest;
        let off = 120.0 * self.rounding + 1024.0 * size;
        let bending = [low - off, high + off];
        let rising_off = 12.0 * self.rounding + 128.0 * size;
        let rising = middle.rising.abs() + rising_off + bending[1].max(-bending[0]) / 2.0;
        Sizes {
            place,
            velocity,
            acceleration,
            bending,
            rising,
            rising_off,
        }
    }

    /// The same for all places, the middles of the balls being those at the middle of the part: each derivative differs from there by
    /// half the largest of the next.
    pub(super) fn spread(&self, middle: &Motion<Ball>) -> Motion<Ball> {
        let third = |&[a, b, c, d]: &[f64; 4]| 3.0 * ((d - a) - 3.0 * (c - b)).abs();
        let third = [third(&self.points[0]), third(&self.points[1])];
        let widened = |ball: Ball, by: f64| Ball::new(ball.middle, ball.radius + by);
        let along =
            |balls: [Ball; 2], by: [f64; 2]| [widened(balls[0], by[0]), widened(balls[1], by[1])];
        let acceleration = along(middle.acceleration, third);
        let velocity = along(middle.velocity, acceleration.map(|ball| ball.size() / 2.0));
        let place = along(middle.place, velocity.map(|ball| ball.size() / 2.0));
        let e = &self.excess;
        let off = |i: usize| {
            let second = 30.0 * ((e[i] - e[i + 1]) - (e[i + 1] - e[i + 2]));
            (second - middle.bending.middle).abs()
        };
        let bending = widened(middle.bending, (0..5).map(off).fold(0.0, f64::max));
        Motion {
            place,
            velocity,
            acceleration,
            excess: middle.excess,
            rising: widened(middle.rising, bending.size() / 2.0),
            bending,
        }
    }
}

/// The largest size of these numbers.
#[inline]
fn largest<const N: usize>(numbers: &[f64; N]) -> f64 {
    let larger = |most: f64, x: &f64| if x.abs() > most { x.abs() } else { most };
    numbers.iter().fold(0.0, larger)
}

/// The coefficients before and after t, by de Casteljau's algorithm.
#[inline]
fn cut<const N: usize>(mut after: [f64; N], t: f64) -> [[f64; N]; 2] {
    let (mut before, rest) = (after, 1.0 - t);
    for (k, last) in before.iter_mut().enumerate().skip(1) {
        for i in 0..N - k {
            after[i] = rest * after[i] + t * after[i + 1];
        }
        *last = after[0];
    }
    [before, after]
}

/// The value and the first two derivatives at t.
#[inline]
fn derivatives<const N: usize>(coefficients: &[f64; N], t: f64) -> [f64; 3] {
    let (mut c, rest, degree) = (*coefficients, 1.0 - t, (N - 1) as f64);
    for last in (3..N).rev() {
        for i in 0..last {
            c[i] = rest * c[i] + t * c[i + 1];
        }
    }
    let (first, second) = (c[1] - c[0], c[2] - c[1]);
    [
        rest * (rest * c[0] + t * c[1]) + t * (rest * c[1] + t * c[2]),
        degree * (rest * first + t * second),
        degree * (degree - 1.0) * (second - first),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_spread_holds_every_place_of_a_part() {
        let part = Part::new(
            [0.0, 1.0],
            [0.0, 1.0, -2.0, 0.5, 3.0, -1.0, 0.25],
            [[1.0, 2.0, -1.0, 0.5], [0.0, 0.3, 0.7, 1.5]],
            false,
        );
        let center = Vec2::new(0.25, -0.5);
        for part in part.halves() {
            let all = part.spread(&part.rounded(&part.motion_at(0.5, center)));
            let [low, high] = part.excess_range();
            for i in 0..=40 {
                let one = part.rounded(&part.motion_at(f64::from(i) / 40.0, center));
                let holds =
                    |all: &Ball, one: &Ball| (all.middle - one.middle).abs() <= all.radius + 1e-15;
                for axis in 0..2 {
                    assert!(holds(&all.place[axis], &one.place[axis]));
                    assert!(holds(&all.velocity[axis], &one.velocity[axis]));
                    assert!(holds(&all.acceleration[axis], &one.acceleration[axis]));
                }
                assert!(holds(&all.rising, &one.rising) && holds(&all.bending, &one.bending));
                assert!(low <= one.excess && one.excess <= high);
            }
        }
    }
}
