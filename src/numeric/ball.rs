//! Numbers that are known within bounds.

use core::ops::{Add, Mul, Sub};

/// A number within `radius` of `middle`. Sums and products hold every result of numbers within theirs, rounding included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ball {
    pub(crate) middle: f64,
    pub(crate) radius: f64,
}

/// A little more than the roundings of an operation and of its radius.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What formulas need that serve plain numbers and balls alike.
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// A number that is known.
    fn exact(x: f64) -> Self;
    fn scaled(self, factor: f64) -> Self;
    fn reciprocal(self) -> Self;
}

impl Number for f64 {
    fn exact(x: f64) -> Self {
        x
    }

    fn scaled(self, factor: f64) -> Self {
        self * factor
    }

    fn reciprocal(self) -> Self {
        1.0 / self
    }
}

impl Number for Ball {
    fn exact(x: f64) -> Self {
        Self::new(x, 0.0)
    }

    fn scaled(self, factor: f64) -> Self {
        Self::rounded(self.middle * factor, self.radius * factor.abs())
    }

    /// Of numbers that may be 0, all numbers.
    fn reciprocal(self) -> Self {
        let size = self.middle.abs();
        if size <= self.radius {
            return Self::new(0.0, f64::INFINITY);
        }
        Self::rounded(
            1.0 / self.middle,
            self.radius / (size * (size - self.radius)),
        )
    }
}

impl Ball {
    pub(crate) const fn new(middle: f64, radius: f64) -> Self {
        Self { middle, radius }
    }

    fn rounded(middle: f64, radius: f64) -> Self {
        Self {
            middle,
            radius: radius + ROUNDING * (radius + middle.abs()),
        }
    }

    /// The largest size.
    pub(crate) fn size(self) -> f64 {
        self.middle.abs() + self.radius
    }
}

impl Add for Ball {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.middle + other.middle, self.radius + other.radius)
    }
}

impl Sub for Ball {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::rounded(self.middle - other.middle, self.radius + other.radius)
    }
}

impl Mul for Ball {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let radius = self.size() * other.radius + other.middle.abs() * self.radius;
        Self::rounded(self.middle * other.middle, radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_hold_those_of_all_numbers_within() {
        let (a, b) = (Ball::new(0.3, 0.1), Ball::new(-1.7, 0.25));
        let holds = |ball: Ball, x: f64| (x - ball.middle).abs() <= ball.radius;
        for i in -10..=10 {
            for j in -10..=10 {
                let x = a.middle + a.radius * f64::from(i) / 10.0;
                let y = b.middle + b.radius * f64::from(j) / 10.0;
                assert!(holds(a + b, x + y) && holds(a - b, x - y) && holds(a * b, x * y));
                assert!(holds(b.reciprocal(), 1.0 / y) && holds(a.scaled(-3.0), -3.0 * x));
            }
        }
        assert!((b.reciprocal().size() - 1.0 / 1.45).abs() < 1e-12);
    }
}
