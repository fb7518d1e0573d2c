//! The searches and sums that formulas without a closed form need: bracketed roots, Gauss-Legendre quadrature.

pub(crate) mod ball;
pub(crate) mod bernstein;
pub(crate) mod double;
pub(crate) mod foot;
pub(crate) mod functions;
pub(crate) mod instructions;
pub(crate) mod lanes;
pub(crate) mod linear;
#[cfg(test)]
pub(crate) mod random;
pub(crate) mod ranked;
pub(crate) mod tridiagonal;

use std::collections::BinaryHeap;

use kurbo::common::GAUSS_LEGENDRE_COEFFS_24;

use ranked::Ranked;

/// The most steps of a root search; bisection alone would be done in 60.
const MOST_STEPS: usize = 400;

/// How many halvings an integral may take in all: a kink or a pole takes about 50, and an integrand that is rounding noise would
/// take any number.
const MOST_HALVINGS: u32 = 300;

/// The root of `f` in `[low, high]`, where its signs differ, to the last bit that f can resolve.
///
/// Bisection and false position in turn (the Illinois rule), so that it converges always, and fast where f is smooth.
pub(crate) fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let mut last_side = 0;
    let (mut f_low, mut f_high) = (f(low), f(high));
    if f_low == 0.0 {
        return low;
    }
    if f_high == 0.0 || (f_low > 0.0) == (f_high > 0.0) {
        return high;
    }
    for step in 0..MOST_STEPS {
        let secant = (low * f_high - high * f_low) / (f_high - f_low);
        let middle = f64::midpoint(low, high);
        let x = if step % 4 == 3 || !(secant > low && secant < high) {
            middle
        } else {
            secant
        };
        let value = f(x);
        let is_done = high - low <= f64::EPSILON * x.abs();
        if value == 0.0 || is_done || x == low || x == high {
            return x;
        }
        if (value > 0.0) == (f_low > 0.0) {
            (low, f_low) = (x, value);
            f_high *= if last_side == -1 { 0.5 } else { 1.0 };
            last_side = -1;
        } else {
            (high, f_high) = (x, value);
            f_low *= if last_side == 1 { 0.5 } else { 1.0 };
            last_side = 1;
        }
    }
    f64::midpoint(low, high)
}

/// The root of `f` near `guess`, bracketed by steps that double from `step`, which is not 0, and stay within `[0, most]`.
pub(crate) fn root_near(f: impl Fn(f64) -> f64, guess: f64, step: f64, most: f64) -> f64 {
    debug_assert!(step > 0.0, "a step of 0 never grows");
    let mut reach = step;
    loop {
        let (low, high) = ((guess - reach).max(0.0), (guess + reach).min(most));
        if (f(low) > 0.0) != (f(high) > 0.0) || (low == 0.0 && high == most) {
            return root(f, low, high);
        }
        reach *= 2.0;
    }
}

/// The top of the parabola through three evenly spaced values, of which the middle one is the largest; that one where there is none.
pub(crate) fn top([before, middle, after]: [f64; 3]) -> f64 {
    let (slope, bend) = ((after - before) / 2.0, before - 2.0 * middle + after);
    if bend < 0.0 {
        middle - slope * slope / (2.0 * bend)
    } else {
        middle
    }
}

/// The integral of `f` over `[from, to]` by 24 Gauss-Legendre points.
pub(crate) fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let half = (to - from) / 2.0;
    let middle = f64::midpoint(from, to);
    half * GAUSS_LEGENDRE_COEFFS_24
        .iter()
        .map(|&(weight, x)| weight * f(middle + half * x))
        .sum::<f64>()
}

/// The integral of `f` over `[from, to]`: the part where the halves agree least with the whole is halved, until they agree everywhere to a
/// few units in the last place of the sum, or to `noise`, the size below which the differences of `f` say nothing.
pub(crate) fn adaptive_integral(f: &impl Fn(f64) -> f64, from: f64, to: f64, noise: f64) -> f64 {
    let first = Interval::new(f, [from, to], integral(f, from, to));
    let (mut sum, mut parts) = (first.of.value(), BinaryHeap::from([first]));
    for _ in 0..MOST_HALVINGS {
        let Some(&Ranked {
            rank: off,
            of: worst,
        }) = parts.peek()
        else {
            break;
        };
        let close = 4.0 * f64::EPSILON * sum.abs() + noise;
        let [from, to] = worst.range;
        let middle = f64::midpoint(from, to);
        let is_indivisible = middle <= from || middle >= to;
        if off <= close || is_indivisible || !sum.is_finite() {
            break;
        }
        parts.pop();
        let halves = [[from, middle], [middle, to]];
        for (range, whole) in halves.into_iter().zip(worst.halves) {
            parts.push(Interval::new(f, range, whole));
        }
        sum = parts.iter().map(|part| part.of.value()).sum();
    }
    sum
}

/// A part of an integral.
#[derive(Clone, Copy)]
struct Interval {
    range: [f64; 2],
    /// The integrals over its halves.
    halves: [f64; 2],
}

impl Interval {
    /// Ranked by how far the sum of its halves is from the integral over the whole.
    fn new(f: &impl Fn(f64) -> f64, range: [f64; 2], whole: f64) -> Ranked<Self> {
        let [from, to] = range;
        let middle = f64::midpoint(from, to);
        let halves = [integral(f, from, middle), integral(f, middle, to)];
        Ranked {
            rank: (halves[0] + halves[1] - whole).abs(),
            of: Self { range, halves },
        }
    }

    fn value(&self) -> f64 {
        self.halves[0] + self.halves[1]
    }
}

/// a - sin a without cancellation.
pub(crate) fn angle_minus_sine(a: f64) -> f64 {
    if a > 1.0 {
        return a - libm::sin(a);
    }
    odd_series(a, 1, |_| 1.0)
}

/// sin h - h cos h without cancellation.
pub(crate) fn sine_minus_angle_cosine(h: f64) -> f64 {
    if h > 1.0 {
        return libm::sin(h) - h * libm::cos(h);
    }
    odd_series(h, 1, |n| n - 1.0)
}

/// 3a + sin a - 8 sin(a/2) without cancellation.
pub(crate) fn area_excess(a: f64) -> f64 {
    if a > 1.5 {
        return 3.0 * a + libm::sin(a) - 8.0 * libm::sin(a / 2.0);
    }
    odd_series(a, 2, |n| 1.0 - 8.0 / libm::exp2(n))
}

/// How many terms of a series reach past the last bit up to an angle of 1.5.
const TERMS: i32 = 12;

/// The Taylor series of the sine with its terms weighted by their power n = 2i + 1, begun at the term i = `first` and with the sign that
/// makes that one positive. The smallest terms are added first.
fn odd_series(x: f64, first: i32, weight: impl Fn(f64) -> f64) -> f64 {
    let mut term = (2..=2 * first + 1).fold(x, |term, n| term * x / f64::from(n));
    let terms = (first..first + TERMS).map(|i| {
        let n = f64::from(2 * i + 1);
        let weighted = term * weight(n);
        term *= -x * x / ((n + 1.0) * (n + 2.0));
        weighted
    });
    let terms: Vec<f64> = terms.collect();
    terms.iter().rev().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_to_the_last_bits() {
        assert!((root(|x| x * x - 2.0, 0.0, 2.0) - core::f64::consts::SQRT_2).abs() < 3e-16);
        assert!((root(|x| x.exp() - 1e-3, -50.0, 50.0) - 1e-3_f64.ln()).abs() < 1e-14);
        assert!(root(|x| x.powi(9), -1.0, 2.0).abs() < 1e-2);
    }

    #[test]
    fn the_sine_defect_is_smooth_across_its_seam() {
        assert!((angle_minus_sine(1.0) - (1.0 - 1.0_f64.sin())).abs() < 1e-16);
        assert!((angle_minus_sine(1e-5) / (1e-15 / 6.0) - 1.0).abs() < 1e-10);
    }

    #[test]
    fn the_other_series_are_smooth_across_their_seams() {
        let h = 1.0_f64;
        assert!((sine_minus_angle_cosine(h) - (h.sin() - h * h.cos())).abs() < 2e-16);
        assert!((sine_minus_angle_cosine(1e-5) / (1e-15 / 3.0) - 1.0).abs() < 1e-10);
        let a = 1.5_f64;
        assert!((area_excess(a) - (3.0 * a + a.sin() - 8.0 * (a / 2.0).sin())).abs() < 2e-15);
        assert!((area_excess(1e-5) / (1e-25 / 160.0) - 1.0).abs() < 1e-10);
    }

    #[test]
    fn kinks_and_spikes_are_integrated_too() {
        let kink = |x: f64| (x - 0.3).abs();
        assert!((adaptive_integral(&kink, 0.0, 1.0, 0.0) - 0.29).abs() < 1e-14);
        let spike = |x: f64| 1.0 / (x * x + 1e-8);
        let exact = 2e4 * 1e4_f64.atan();
        assert!((adaptive_integral(&spike, -1.0, 1.0, 0.0) / exact - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_worst_place_is_looked_at_first() {
        // Two corners as sharp as those of a hairpin, of which the first must not use up all halvings.
        let speed = |t: f64| libm::hypot((t - 0.2) * (t - 0.7), 1e-5);
        let exact = 0.065_000_004_304_552_08;
        let found = adaptive_integral(&speed, 0.0, 1.0, 0.0);
        assert!((found - exact).abs() < 1e-16, "{found}");
    }

    #[test]
    fn quadrature_is_exact_for_polynomials() {
        assert!((integral(|x| x.powi(20), 0.0, 1.0) - 1.0 / 21.0).abs() < 1e-16);
    }

    #[test]
    fn the_top_of_a_parabola_is_above_its_samples() {
        // 5 - (t - 0.25)² at -1, 0 and 1.
        assert_eq!(top([3.4375, 4.9375, 4.4375]), 5.0);
        assert_eq!(top([2.0, 2.0, 2.0]), 2.0);
    }
}
