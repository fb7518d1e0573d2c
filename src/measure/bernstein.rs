//! Polynomials on [0, 1] in Bernstein form, up to degree 6: what the extremes of distance, curvature and angle are the roots of.

use crate::method::numeric::root;

/// The largest degree: the square of a cubic.
const MOST: usize = 6;

/// A polynomial on [0, 1] in Bernstein form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Polynomial {
    coefficients: [f64; MOST + 1],
    degree: usize,
}

impl Polynomial {
    /// The polynomial with these coefficients, at most seven.
    pub(crate) fn new(coefficients: &[f64]) -> Self {
        let mut padded = [0.0; MOST + 1];
        padded[..coefficients.len()].copy_from_slice(coefficients);
        Self {
            coefficients: padded,
            degree: coefficients.len() - 1,
        }
    }

    fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The value, by de Casteljau's algorithm; exactly the last coefficient at 1.
    pub(crate) fn at(&self, t: f64) -> f64 {
        if t == 1.0 {
            return self.coefficients[self.degree];
        }
        let mut work = self.coefficients;
        for last in (1..=self.degree).rev() {
            for i in 0..last {
                work[i] += t * (work[i + 1] - work[i]);
            }
        }
        work[0]
    }

    /// The differences of the coefficients: the derivative over the degree.
    pub(crate) fn differences(&self) -> Self {
        let mut slope = [0.0; MOST + 1];
        for (slope, pair) in slope.iter_mut().zip(self.coefficients().windows(2)) {
            *slope = pair[1] - pair[0];
        }
        Self {
            coefficients: slope,
            degree: self.degree.saturating_sub(1),
        }
    }

    /// The derivative.
    pub(crate) fn derivative(&self) -> Self {
        self.differences().scaled(self.degree as f64)
    }

    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        self.coefficients.iter_mut().for_each(|c| *c *= factor);
        self
    }

    /// The product; the degrees must add up to at most 6.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let degree = self.degree + other.degree;
        let mut product = [0.0; MOST + 1];
        for (k, coefficient) in product.iter_mut().enumerate().take(degree + 1) {
            let sum: f64 = (k.saturating_sub(other.degree)..=k.min(self.degree))
                .map(|i| {
                    let weight = binomial(self.degree, i) * binomial(other.degree, k - i);
                    weight * self.coefficients[i] * other.coefficients[k - i]
                })
                .sum();
            *coefficient = sum / binomial(degree, k);
        }
        Self {
            coefficients: product,
            degree,
        }
    }

    /// The difference of two polynomials; the one of lower degree is raised.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        let degree = self.degree.max(other.degree);
        let (mut a, b) = (self.raised(degree), other.raised(degree));
        for (a, b) in a.coefficients.iter_mut().zip(b.coefficients) {
            *a -= b;
        }
        a
    }

    fn raised(&self, degree: usize) -> Self {
        let ones = [1.0; MOST + 1];
        self.times(&Self::new(&ones[..=degree - self.degree]))
    }

    /// Where it changes its sign in (0, 1), ascending: between the roots of its derivative it is monotone.
    pub(crate) fn sign_changes(&self) -> Parameters {
        let mut found = Parameters::default();
        let coefficients = self.coefficients();
        let same_sign =
            coefficients.iter().all(|&c| c >= 0.0) || coefficients.iter().all(|&c| c <= 0.0);
        if self.degree < 1 || same_sign {
            return found;
        }
        let turning = self.differences().sign_changes();
        let mut from = 0.0;
        for to in turning.iter().chain(core::iter::once(1.0)) {
            let (low, high) = (self.at(from), self.at(to));
            if (low > 0.0 && high < 0.0) || (low < 0.0 && high > 0.0) {
                found.push(root(|t| self.at(t), from, to));
            }
            from = to;
        }
        found
    }
}

/// n over k for n up to 6.
pub(crate) fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// A handful of parameters in ascending order.
#[derive(Debug, Default)]
pub(crate) struct Parameters {
    values: [f64; MOST],
    count: usize,
}

impl Parameters {
    fn push(&mut self, t: f64) {
        self.values[self.count] = t;
        self.count += 1;
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        self.values[..self.count].iter().copied()
    }

    /// The pieces of [0, 1] between them, as (from, to).
    pub(crate) fn pieces(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let starts = core::iter::once(0.0).chain(self.iter());
        starts.zip(self.iter().chain(core::iter::once(1.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_differences_are_those_of_the_values() {
        let (p, q) = (
            Polynomial::new(&[1.0, -2.0, 3.0, 0.5]),
            Polynomial::new(&[0.5, 4.0]),
        );
        for i in 0..=10 {
            let t = f64::from(i) / 10.0;
            assert!((p.times(&q).at(t) - p.at(t) * q.at(t)).abs() < 1e-14);
            assert!((p.minus(&q).at(t) - (p.at(t) - q.at(t))).abs() < 1e-14);
        }
    }

    #[test]
    fn all_six_roots_are_found() {
        // T6(2t - 1), whose roots are known.
        let chebyshev = Polynomial::new(&[1.0, -11.0, 33.0, -231.0 / 5.0, 33.0, -11.0, 1.0]);
        let found: Vec<f64> = chebyshev.sign_changes().iter().collect();
        assert_eq!(found.len(), 6);
        for (k, t) in found.iter().rev().enumerate() {
            let angle = core::f64::consts::PI * (2.0 * k as f64 + 1.0) / 12.0;
            assert!((2.0 * t - 1.0 - angle.cos()).abs() < 1e-14);
        }
    }
}
