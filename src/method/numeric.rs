//! The searches and sums that formulas without a closed form need: bracketed roots, Gauss-Legendre quadrature.

use kurbo::common::GAUSS_LEGENDRE_COEFFS_24;

/// The most steps of a root search; bisection alone would be done in 60.
const MOST_STEPS: usize = 100;

/// The root of `f` in `[low, high]`, where its signs differ, to the last bit that f can resolve.
///
/// Bisection and false position in turn (the Illinois rule), so that it converges always, and fast where f is smooth.
pub(crate) fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let (mut f_low, mut f_high) = (f(low), f(high));
    if f_low == 0.0 {
        return low;
    }
    if f_high == 0.0 || (f_low > 0.0) == (f_high > 0.0) {
        return high;
    }
    let mut last_side = 0;
    for step in 0..MOST_STEPS {
        let secant = (low * f_high - high * f_low) / (f_high - f_low);
        let middle = f64::midpoint(low, high);
        let x = if step % 4 == 3 || !(secant > low && secant < high) {
            middle
        } else {
            secant
        };
        let value = f(x);
        if value == 0.0 || high - low <= f64::EPSILON * x.abs() || x == low || x == high {
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

/// The root of `f` near `guess`, bracketed by steps that double from `step` and stay within `[least, most]`.
pub(crate) fn root_near(
    f: impl Fn(f64) -> f64,
    guess: f64,
    step: f64,
    least: f64,
    most: f64,
) -> f64 {
    let mut reach = step;
    loop {
        let (low, high) = ((guess - reach).max(least), (guess + reach).min(most));
        if (f(low) > 0.0) != (f(high) > 0.0) || (low == least && high == most) {
            return root(f, low, high);
        }
        reach *= 2.0;
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

/// a - sin a without cancellation.
pub(crate) fn angle_minus_sine(a: f64) -> f64 {
    if a.abs() > 1.0 {
        return a - a.sin();
    }
    // a³/3! - a⁵/5! + ...: twelve terms reach past the last bit for |a| <= 1.
    let square = a * a;
    let sum = (1..12).rev().fold(0.0, |sum, i| {
        let n = f64::from(2 * i + 2);
        1.0 - sum * square / (n * (n + 1.0))
    });
    a * square / 6.0 * sum
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
    fn quadrature_is_exact_for_polynomials() {
        assert!((integral(|x| x.powi(20), 0.0, 1.0) - 1.0 / 21.0).abs() < 1e-16);
    }
}
