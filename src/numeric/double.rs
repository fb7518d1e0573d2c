//! Twice the digits of `f64`, for what cancels: |p|² - r² of points that lie almost on the circle, frames of true shapes, conics.

/// A vector in twice the digits.
pub(crate) type Twice = [Double; 2];

/// u×v.
#[inline(always)]
pub(crate) fn cross(u: Twice, v: Twice) -> Double {
    u[0].times(v[1]).minus(u[1].times(v[0]))
}

/// An unevaluated sum of two `f64`, the second at most half a unit in the last place of the first.
///
/// The sums and products without rounding error are Knuth's and Dekker's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// A number of `f64`.
    pub(crate) const fn of(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// A sum of two numbers, the second no more than the rounding of the first.
    pub(crate) const fn of_parts(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    /// Both parts.
    pub(crate) const fn parts(self) -> [f64; 2] {
        [self.high, self.low]
    }

    /// a - b without rounding error.
    #[inline(always)]
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        let high = a - b;
        let virtual_b = a - high;
        Self {
            high,
            low: (a - (high + virtual_b)) + (virtual_b - b),
        }
    }

    #[inline(always)]
    fn sum(a: f64, b: f64) -> Self {
        Self::difference(a, -b)
    }

    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::sum(high.high, high.low + low.high);
        Self::sum(first.high, first.low + low.low)
    }

    /// As [`Self::plus`] in half the time, off by a few parts in 2^105 of the larger term where the sum cancels.
    #[inline(always)]
    pub(crate) fn near(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        let low = sum.low + (self.low + other.low);
        let high = sum.high + low;
        Self {
            high,
            low: low - (high - sum.high),
        }
    }

    /// u·v, off by as little as [`Self::near`].
    #[inline(always)]
    pub(crate) fn dot(u: Twice, v: Twice) -> Self {
        let ([a, b], [c, d]) = (u, v);
        let (along, across) = (a.high * c.high, b.high * d.high);
        let sum = Self::sum(along, across);
        let rest = a.high.mul_add(c.high, -along) + b.high.mul_add(d.high, -across);
        let low = (a.high * c.low + a.low * c.high) + (b.high * d.low + b.low * d.high);
        let low = sum.low + (rest + low);
        let high = sum.high + low;
        Self {
            high,
            low: low - (high - sum.high),
        }
    }

    #[inline(always)]
    pub(crate) fn times(self, other: Self) -> Self {
        let product = self.high * other.high;
        let error = self.high.mul_add(other.high, -product);
        Self::sum(
            product,
            error + (self.high * other.low + self.low * other.high),
        )
    }

    /// The product with a number of `f64`.
    #[inline(always)]
    pub(crate) fn scaled(self, factor: f64) -> Self {
        self.times(Self::of(factor))
    }

    #[inline(always)]
    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self {
            high: -other.high,
            low: -other.low,
        })
    }

    /// The quotient by a number that is not 0.
    #[inline(always)]
    pub(crate) fn over(self, divisor: f64) -> Self {
        let quotient = self.high / divisor;
        let rest = (-quotient).mul_add(divisor, self.high) + self.low;
        Self::sum(quotient, rest / divisor)
    }

    /// The quotient by a number that `f64` nearly holds, off by a few parts in 2^105.
    #[inline(always)]
    pub(crate) fn by(self, divisor: Self) -> Self {
        let quotient = self.over(divisor.high);
        if divisor.low == 0.0 {
            return quotient;
        }
        quotient.near(quotient.scaled(-divisor.low / divisor.high))
    }

    /// The quotient, by long division in three steps.
    pub(crate) fn divided(self, divisor: Self) -> Self {
        let mut rest = self;
        let mut digit = || {
            let digit = rest.high / divisor.high;
            rest = rest.plus(divisor.scaled(-digit));
            digit
        };
        let (first, second, third) = (digit(), digit(), digit());
        Self::sum(first, second).plus(Self::of(third))
    }

    /// The square root of a number that is not negative, by one step of Newton's method from that of `f64`.
    pub(crate) fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::of(0.0);
        }
        let rest = self.plus(Self::of(-root).times(Self::of(root)));
        Self::sum(root, rest.value() / (2.0 * root))
    }

    /// The nearest `f64`.
    #[inline(always)]
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_of_squares_keep_their_digits() {
        // (1 + e)² - 1 = 2e + e²
        let e = 2.0_f64.powi(-40);
        let x = Double::difference(1.0, -e);
        let square = x.times(x).plus(Double::difference(0.0, 1.0));
        assert_eq!(square.value(), 2.0 * e + e * e);
    }

    #[test]
    fn the_root_of_nothing_is_nothing() {
        assert_eq!(Double::of(0.0).sqrt().value(), 0.0);
    }
}
