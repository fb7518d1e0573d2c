//! A part of a segment, and what its derivatives are there.

use kurbo::Vec2;

use crate::numeric::ball::{Ball, Number};
use crate::numeric::bernstein::halves;
use crate::numeric::lanes::Real;

/// A part of a cubic in the frame where an ellipse is the unit circle, or several parts side by side. Derivatives are by its own parameter,
/// from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct CubicPart<S = f64> {
    pub(super) from: S,
    pub(super) width: S,
    /// The Bernstein coefficients of F = |q|² - 1, and how far each may be off.
    pub(super) excess: [S; 7],
    pub(super) rounding: S,
    /// The control points, x and y, not about the centre, and how far each may be off.
    pub(super) points: [[S; 4]; 2],
    pub(super) moved: [S; 2],
    /// The largest sizes of both.
    pub(super) largest: S,
    pub(super) reach: [S; 2],
    /// Whether no halving has added to the rounding.
    pub(super) is_fresh: bool,
}

#[cfg(test)]
thread_local! {
    /// How often a motion was asked for: what a search costs, to one who counts.
    pub(super) static MOTIONS: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

/// A place of a part, or all places: q about the centre and F, with their derivatives.
pub(super) struct Motion<T> {
    pub(super) place: [T; 2],
    pub(super) velocity: [T; 2],
    pub(super) acceleration: [T; 2],
    pub(super) excess: T,
    pub(super) rising: T,
    pub(super) bending: T,
}

/// The largest sizes along a part, rounding included.
pub(super) struct Sizes<S> {
    pub(super) place: [S; 2],
    pub(super) velocity: [S; 2],
    pub(super) acceleration: [S; 2],
    /// Bounds of F' and of F''.
    pub(super) rising: [S; 2],
    pub(super) bending: [S; 2],
}

impl<S: Number> Motion<S> {
    /// G.
    #[inline(always)]
    pub(super) fn gradient(&self, alpha: [f64; 2]) -> S {
        let [x, y] = self.place;
        (x * x).scaled(alpha[0]) + (y * y).scaled(alpha[1])
    }
}

impl<S: Real> CubicPart<S> {
    /// The least and the largest coefficient of F, rounding included.
    #[inline(always)]
    pub(super) fn certain_excess(&self) -> [S; 2] {
        widened(self.excess_range(), self.rounding)
    }

    /// How far F may be off at a place: by de Casteljau's algorithm, three roundings in each of six steps.
    #[inline(always)]
    pub(super) fn rounding(&self) -> S {
        self.rounding + self.largest.scaled(9.0 * f64::EPSILON)
    }

    /// The least and the largest coefficient of F.
    #[inline(always)]
    pub(super) fn excess_range(&self) -> [S; 2] {
        range(&self.excess)
    }

    /// The least |q|, each coordinate on its own, by the control points.
    #[inline(always)]
    pub(super) fn least_place(&self, center: Vec2) -> [S; 2] {
        let mut least = [S::exact(0.0); 2];
        for (i, center) in [center.x, center.y].into_iter().enumerate() {
            let [low, high] = range(&self.points[i]);
            let (low, high) = (low - S::exact(center), S::exact(center) - high);
            let size = self.reach[i] + S::exact(center.abs());
            let rounding = self.moved[i] + size.scaled(f64::EPSILON);
            least[i] = (low.larger(high) - rounding).larger(least[i]);
        }
        least
    }

    /// The motion at a place.
    #[inline(always)]
    pub(super) fn motion_at(&self, t: S, center: Vec2) -> Motion<S> {
        #[cfg(test)]
        MOTIONS.set(MOTIONS.get() + 1);
        let [excess, rising, bending] = derivatives(&self.excess, t);
        let [x, vx, ax] = derivatives(&self.points[0], t);
        let [y, vy, ay] = derivatives(&self.points[1], t);
        Motion {
            place: [x - S::exact(center.x), y - S::exact(center.y)],
            velocity: [vx, vy],
            acceleration: [ax, ay],
            excess,
            rising,
            bending,
        }
    }

    /// The largest sizes for all places, from the motion at the middle as in [`CubicPart::spread`].
    #[inline(always)]
    pub(super) fn sizes(&self, middle: &Motion<S>) -> Sizes<S> {
        let [mut place, mut velocity, mut acceleration] = [[S::exact(0.0); 2]; 3];
        for i in 0..2 {
            let [a, b, c, d] = self.points[i];
            let third = ((d - a) - (c - b).scaled(3.0)).abs().scaled(3.0);
            let (moved, size) = (self.moved[i], self.reach[i].scaled(f64::EPSILON));
            let off = moved.scaled(24.0) + size.scaled(128.0);
            acceleration[i] = middle.acceleration[i].abs() + third + off;
            let off = moved.scaled(6.0) + size.scaled(32.0);
            velocity[i] = middle.velocity[i].abs() + acceleration[i].scaled(0.5) + off;
            let off = moved + size.scaled(4.5);
            place[i] =
                middle.place[i].abs().scaled(1.0 + f64::EPSILON) + velocity[i].scaled(0.5) + off;
        }
        let size = self.largest.scaled(f64::EPSILON);
        let mut first = [S::exact(0.0); 6];
        for (first, pair) in first.iter_mut().zip(self.excess.windows(2)) {
            *first = (pair[1] - pair[0]).scaled(6.0);
        }
        let mut second = [S::exact(0.0); 5];
        for (second, pair) in second.iter_mut().zip(first.windows(2)) {
            *second = (pair[1] - pair[0]).scaled(5.0);
        }
        let off = self.rounding.scaled(12.0) + size.scaled(128.0);
        let rising = widened(range(&first), off);
        let off = self.rounding.scaled(120.0) + size.scaled(1024.0);
        let bending = widened(range(&second), off);
        Sizes {
            place,
            velocity,
            acceleration,
            rising,
            bending,
        }
    }
}

impl CubicPart {
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

    /// How far q may be off at a place, its size there left out.
    pub(super) fn moved(&self) -> [f64; 2] {
        let moved = |i: usize| self.moved[i] + 4.5 * f64::EPSILON * self.reach[i];
        [moved(0), moved(1)]
    }

    /// The parameter of the cubic.
    pub(super) fn parameter(&self, t: f64) -> f64 {
        self.from + self.width * t
    }

    /// Its halves, with one more rounding in each step.
    pub(super) fn halves(&self) -> [Self; 2] {
        let place = self.from + self.width / 2.0;
        let rounding = self.rounding + 3.0 * f64::EPSILON * self.largest;
        let moved = |i: usize| self.moved[i] + 1.5 * f64::EPSILON * self.reach[i];
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
            (halves(self.excess), halves(*x), halves(*y));
        [
            part([self.from, place], before, [x, y]),
            part([place, self.from + self.width], after, [x_after, y_after]),
        ]
    }

    /// The control points about a centre.
    pub(super) fn polygon(&self, center: Vec2) -> [Vec2; 4] {
        let [x, y] = self.points;
        core::array::from_fn(|i| Vec2::new(x[i], y[i]) - center)
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
            excess: Ball::new(motion.excess, self.rounding()),
            rising: Ball::new(motion.rising, 12.0 * self.rounding + 128.0 * size),
            bending: Ball::new(motion.bending, 120.0 * self.rounding + 1024.0 * size),
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
        let rising = widened(middle.rising, bending.size() / 2.0);
        Motion {
            place,
            velocity,
            acceleration,
            excess: widened(middle.excess, rising.size() / 2.0),
            rising,
            bending,
        }
    }
}

/// The least and the largest of these numbers.
#[inline(always)]
fn range<const N: usize, S: Real>(numbers: &[S; N]) -> [S; 2] {
    let [mut low, mut high] = [numbers[0]; 2];
    for &x in &numbers[1..] {
        low = x.smaller(low);
        high = x.larger(high);
    }
    [low, high]
}

#[inline(always)]
fn widened<S: Real>([low, high]: [S; 2], by: S) -> [S; 2] {
    [low - by, high + by]
}

/// The largest size of these numbers.
#[inline(always)]
pub(super) fn largest<const N: usize, S: Real>(numbers: &[S; N]) -> S {
    let larger = |most: S, x: &S| x.abs().larger(most);
    numbers.iter().fold(S::exact(0.0), larger)
}

/// The value and the first two derivatives at t.
#[inline(always)]
fn derivatives<const N: usize, S: Number>(coefficients: &[S; N], t: S) -> [S; 3] {
    let (mut c, rest, degree) = (*coefficients, S::exact(1.0) - t, (N - 1) as f64);
    for last in (3..N).rev() {
        for i in 0..last {
            c[i] = rest * c[i] + t * c[i + 1];
        }
    }
    let (first, second) = (c[1] - c[0], c[2] - c[1]);
    let (before, after) = (rest * c[0] + t * c[1], rest * c[1] + t * c[2]);
    [
        rest * before + t * after,
        (rest * first + t * second).scaled(degree),
        (second - first).scaled(degree * (degree - 1.0)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_spread_holds_every_place_of_a_part() {
        let part = CubicPart::new(
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
                assert!(low <= one.excess.middle && one.excess.middle <= high);
                assert!(holds(&all.excess, &one.excess));
            }
        }
    }
}
