//! Several numbers side by side, of which the compiler makes vectors.

use core::ops::{Add, Div, Mul, Sub};

use super::ball::Number;

/// Numbers that are computed alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lanes<const N: usize>(pub(crate) [f64; N]);

/// What formulas need that serve one number and several alike.
pub(crate) trait Real: Number + Div<Output = Self> {
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    /// The larger of both; the second where one of them is not a number.
    fn larger(self, other: Self) -> Self;
    fn smaller(self, other: Self) -> Self;
    /// The first of both where this is negative, else the second.
    fn choose(self, first: Self, second: Self) -> Self;
    /// What is computed anew, one number after the other by its place, where a size is more than a limit.
    fn renewed(self, size: Self, limit: f64, new: impl Fn(usize) -> f64) -> Self;
    /// The number at a place, which is the same where there is one only.
    fn lane(self, place: usize) -> f64;
}

impl Real for f64 {
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn choose(self, first: Self, second: Self) -> Self {
        if self < 0.0 { first } else { second }
    }

    #[inline(always)]
    fn renewed(self, size: Self, limit: Self, new: impl Fn(usize) -> Self) -> Self {
        if size > limit { new(0) } else { self }
    }

    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }
}

macro_rules! operator {
    ($count:literal, $trait:ident, $name:ident, $one:expr) => {
        impl $trait for Lanes<$count> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                self.with(other, $one)
            }
        }
    };
}

/// What computes these many numbers, one by one: without optimisation a loop over them takes ten times as long.
macro_rules! lanes {
    ($count:literal: $($i:literal)*) => {
        impl Lanes<$count> {
            #[inline(always)]
            fn each(self, f: impl Fn(f64) -> f64) -> Self {
                Self([$(f(self.0[$i])),*])
            }

            #[inline(always)]
            fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
                Self([$(f(self.0[$i], other.0[$i])),*])
            }
        }

        impl Real for Lanes<$count> {
            #[inline(always)]
            fn abs(self) -> Self {
                self.each(f64::abs)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.each(f64::sqrt)
            }

            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                self.with(other, Real::larger)
            }

            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                self.with(other, Real::smaller)
            }

            #[inline(always)]
            fn choose(self, first: Self, second: Self) -> Self {
                Self([$(self.0[$i].choose(first.0[$i], second.0[$i])),*])
            }

            #[inline(always)]
            fn renewed(self, size: Self, limit: f64, new: impl Fn(usize) -> f64) -> Self {
                if size.0.iter().all(|&size| size <= limit) {
                    return self;
                }
                Self([$(self.0[$i].renewed(size.0[$i], limit, |_| new($i))),*])
            }

            #[inline(always)]
            fn lane(self, place: usize) -> f64 {
                self.0[place]
            }
        }

        impl Number for Lanes<$count> {
            #[inline(always)]
            fn exact(x: f64) -> Self {
                Self([x; $count])
            }

            #[inline(always)]
            fn scaled(self, factor: f64) -> Self {
                Self([$(self.0[$i] * factor),*])
            }

            #[inline(always)]
            fn reciprocal(self) -> Self {
                Self([$(1.0 / self.0[$i]),*])
            }
        }

        operator!($count, Add, add, |a, b| a + b);
        operator!($count, Sub, sub, |a, b| a - b);
        operator!($count, Mul, mul, |a, b| a * b);
        operator!($count, Div, div, |a, b| a / b);
    };
}

lanes!(4: 0 1 2 3);
lanes!(8: 0 1 2 3 4 5 6 7);
