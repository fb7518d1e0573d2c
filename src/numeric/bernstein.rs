//! Polynomials on [0, 1] in Bernstein form: what the extremes of distance, curvature and angle are the roots of.

/// The most coefficients: those of the square of a cubic.
const MOST: usize = 7;

/// How often a part is cut in two at most; roots that are closer than that pass for one.
const MOST_CUTS: u32 = 48;

/// What a value has to be for its sign to be certain a little outside [0, 1], as a part of the largest coefficient.
const CERTAIN: f64 = 1e-12;

/// The most steps to a root; halving alone would be done in 60.
const MOST_STEPS: usize = 100;

/// n over k for n up to 6: [n][k].
const BINOMIALS: [[f64; MOST]; MOST] = {
    let mut rows = [[0.0; MOST]; MOST];
    let mut n = 0;
    while n < MOST {
        rows[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    rows
};

/// A polynomial of up to degree 6 on [0, 1] in Bernstein form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Polynomial {
    coefficients: [f64; MOST],
    degree: usize,
}

impl Polynomial {
    /// The polynomial with these coefficients, at most as many as there is room for.
    pub(crate) fn new(coefficients: &[f64]) -> Self {
        let mut padded = [0.0; MOST];
        padded[..coefficients.len()].copy_from_slice(coefficients);
        Self {
            coefficients: padded,
            degree: coefficients.len() - 1,
        }
    }

    fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The value, by de Casteljau's algorithm; exactly the last coefficient at 1. The weights are products with 1 - t and t, so that
    /// the value keeps its digits beside both ends: a + t (b - a) would lose them beside the second.
    pub(crate) fn at(&self, t: f64) -> f64 {
        if t == 1.0 {
            return self.coefficients[self.degree];
        }
        let [before, after] = self.last_two(t);
        (1.0 - t) * before + t * after
    }

    /// The last two numbers of de Casteljau's algorithm: the value lies between them, the slope is a multiple of their difference.
    fn last_two(&self, t: f64) -> [f64; 2] {
        // The squares of cubics and their slopes, by loops whose length the compiler knows.
        match self.degree {
            5 => casteljau(self.coefficients, 5, t),
            6 => casteljau(self.coefficients, 6, t),
            degree => casteljau(self.coefficients, degree, t),
        }
    }

    /// The root where the coefficients change their sign once, or where the ends have different signs: by Newton's method from where
    /// the control polygon crosses 0, halving where that does not converge.
    fn root(&self) -> f64 {
        let own = self.coefficients();
        let rises = own[self.degree] > 0.0;
        let degree = self.degree as f64;
        let crossed = own.windows(2).position(|pair| (pair[1] > 0.0) == rises);
        let crossed = crossed.unwrap_or(0);
        let (before, after) = (own[crossed], own[crossed + 1]);
        let t = (crossed as f64 + before / (before - after)) / degree;
        self.root_between([0.0, 1.0], rises, t.clamp(0.0, 1.0))
    }

    /// The root between two places where it has different signs, by steps from t on.
    fn root_between(&self, [mut low, mut high]: [f64; 2], rises: bool, mut t: f64) -> f64 {
        let degree = self.degree as f64;
        // No step comes before the first, and nothing compares with it.
        let mut last = f64::NAN;
        for _ in 0..MOST_STEPS {
            let [before, after] = self.last_two(t);
            let value = (1.0 - t) * before + t * after;
            if value == 0.0 {
                return t;
            }
            if (value > 0.0) == rises {
                high = t;
            } else {
                low = t;
            }
            let newton = t - value / (degree * (after - before));
            let step = (newton - t).abs();
            let is_slow = step > 0.5 * last;
            // The next step would be shorter by as much again as this one, squared; a slow one is rounding.
            let is_last = step * step * step <= f64::EPSILON * t * last * last;
            if is_last || (is_slow && step <= 1e-12 * t) {
                return newton.clamp(low, high);
            }
            let next = if newton > low && newton < high && !is_slow {
                newton
            } else {
                f64::midpoint(low, high)
            };
            if next == low || next == high {
                return next;
            }
            (last, t) = ((next - t).abs(), next);
        }
        t
    }

    /// The largest size of a coefficient, which no value exceeds.
    pub(crate) fn largest(&self) -> f64 {
        self.coefficients()
            .iter()
            .fold(0.0, |largest, c| largest.max(c.abs()))
    }

    /// The coefficients of the square of a cubic.
    pub(crate) const fn coefficients_of_square(&self) -> &[f64; MOST] {
        &self.coefficients
    }

    /// The polynomial of the sizes of the coefficients.
    pub(crate) fn sizes(mut self) -> Self {
        self.coefficients.iter_mut().for_each(|c| *c = c.abs());
        self
    }

    /// The differences of the coefficients: the derivative over the degree.
    pub(crate) fn differences(&self) -> Self {
        let mut slope = [0.0; MOST];
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

    /// The product; there must be room for it.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let degree = self.degree + other.degree;
        let mut product = [0.0; MOST];
        let (own, others) = (&BINOMIALS[self.degree], &BINOMIALS[other.degree]);
        for (i, a) in self.coefficients().iter().enumerate() {
            let a = a * own[i];
            for (j, b) in other.coefficients().iter().enumerate() {
                product[i + j] += a * (b * others[j]);
            }
        }
        for (coefficient, binomial) in product.iter_mut().zip(BINOMIALS[degree]) {
            *coefficient /= if binomial > 0.0 { binomial } else { 1.0 };
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
        let ones = [1.0; MOST];
        self.times(&Self::new(&ones[..=degree - self.degree]))
    }

    /// Where it changes its sign in (0, 1), ascending.
    ///
    /// A polynomial has as many roots as its Bernstein coefficients have changes of sign, or fewer by an even number (Descartes):
    /// it is cut in two until every part has at most one.
    pub(crate) fn sign_changes(&self) -> ParameterList {
        let mut found = ParameterList::default();
        self.isolate([0.0, 1.0], MOST_CUTS, &mut found);
        found
    }

    /// The same where between these places, ascending and on both sides of [0, 1], it changes its sign as often as it can: then once between
    /// two of them or not at all. `None` where it does not. A root at 0 or 1 counts as beyond.
    pub(crate) fn sign_changes_between<const N: usize>(
        &self,
        places: &[f64; N],
    ) -> Option<ParameterList> {
        let mut values = places.map(|place| self.at(place));
        let certain = CERTAIN * self.largest();
        for i in 0..N {
            // At the ends it is a coefficient.
            values[i] = match places[i] {
                0.0 if values[i] == 0.0 => values[i + 1],
                1.0 if values[i] == 0.0 => values[i - 1],
                0.0 | 1.0 => values[i],
                _ if values[i].abs() > certain => values[i],
                _ => return None,
            };
        }
        let changes = |i: &usize| (values[*i] > 0.0) != (values[i + 1] > 0.0);
        if (0..N - 1).filter(changes).count() != self.degree {
            return None;
        }
        let mut found = ParameterList::default();
        for i in (0..N - 1).filter(changes) {
            let (from, to, before, after) = (places[i], places[i + 1], values[i], values[i + 1]);
            if from >= 0.0 && to <= 1.0 {
                let crossed = from + (to - from) * (before / (before - after));
                found.push(self.root_between([from, to], after > 0.0, crossed));
            }
        }
        Some(found)
    }

    /// Finds the changes of sign of a part of a polynomial, whose parameters lie between these.
    fn isolate(&self, [from, to]: [f64; 2], cuts: u32, found: &mut ParameterList) {
        let changes = self.coefficient_changes();
        if changes == 0 {
            return;
        }
        let (first, last) = (self.coefficients[0], self.coefficients[self.degree]);
        let differ = (first > 0.0 && last < 0.0) || (first < 0.0 && last > 0.0);
        if (changes == 1 || cuts == 0) && differ {
            found.push(from + (to - from) * self.root());
        } else if cuts > 0 {
            let (place, [left, right]) = self.cut();
            let middle = from + (to - from) * place;
            left.isolate([from, middle], cuts - 1, found);
            right.isolate([middle, to], cuts - 1, found);
        }
    }

    /// How often the sign changes along the coefficients, zeros left out.
    fn coefficient_changes(&self) -> usize {
        let (mut changes, mut last) = (0, 0.0);
        for &c in self.coefficients().iter().filter(|&&c| c != 0.0) {
            changes += usize::from(last != 0.0 && (c > 0.0) != (last > 0.0));
            last = c;
        }
        changes
    }

    /// The parts before and after a parameter near the middle that is no root.
    fn cut(&self) -> (f64, [Self; 2]) {
        // Symmetric polynomials have a root in the middle.
        let places = (0..MOST).map(|i| 0.4375 - i as f64 / 64.0);
        let mut cut = (0.0, [*self; 2]);
        for place in places {
            cut = (place, self.cut_at(place));
            if cut.1[1].coefficients[0] != 0.0 {
                break;
            }
        }
        cut
    }

    /// The parts before and after t, by de Casteljau's algorithm.
    fn cut_at(&self, t: f64) -> [Self; 2] {
        let own = self.coefficients;
        let parts = match self.degree {
            5 => cut(own, 5, t),
            6 => cut(own, 6, t),
            degree => cut(own, degree, t),
        };
        parts.map(|coefficients| Self {
            coefficients,
            ..*self
        })
    }
}

/// The coefficients of both halves, by de Casteljau's algorithm.
#[inline]
pub(crate) fn halves<const N: usize>(mut after: [f64; N]) -> [[f64; N]; 2] {
    let mut before = after;
    for (k, last) in before.iter_mut().enumerate().skip(1) {
        for i in 0..N - k {
            after[i] = 0.5 * (after[i] + after[i + 1]);
        }
        *last = after[0];
    }
    [before, after]
}

/// De Casteljau's algorithm but for its last step.
#[inline(always)]
fn casteljau(mut work: [f64; MOST], degree: usize, t: f64) -> [f64; 2] {
    for last in (2..=degree).rev() {
        for i in 0..last {
            work[i] = (1.0 - t) * work[i] + t * work[i + 1];
        }
    }
    // A constant has one coefficient.
    [work[0], work[degree.min(1)]]
}

/// The coefficients before and after t, by de Casteljau's algorithm.
#[inline(always)]
fn cut(own: [f64; MOST], degree: usize, t: f64) -> [[f64; MOST]; 2] {
    let (mut left, mut right) = (own, own);
    for last in (0..degree).rev() {
        for i in 0..=last {
            let [a, b] = [right[i], right[i + 1]];
            right[i] = a + t * (b - a);
        }
        left[degree - last] = right[0];
    }
    [left, right]
}

/// A handful of parameters in ascending order.
#[derive(Debug, Default)]
pub(crate) struct ParameterList {
    values: [f64; MOST],
    count: usize,
}

impl ParameterList {
    /// Appends one; beyond the largest degree they are rounding.
    fn push(&mut self, t: f64) {
        if let Some(value) = self.values.get_mut(self.count) {
            *value = t;
            self.count += 1;
        }
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
mod tests;
