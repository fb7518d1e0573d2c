//! Roots and integrals: bracketed search, isolation by the variation of Bernstein coefficients,
//! adaptive Gauss-Legendre quadrature.

use super::real::{Real, abs, int, is_zero, parse, power_of_two, ratio, real, sign};
use std::sync::OnceLock;

/// The root of `f` in the bracket `lo..hi`, at the ends of which `f` differs in sign, to 57 digits.
///
/// T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a
/// nonlinear function without using derivatives, Advances in Engineering Software 28 (1997):
/// inverse quadratic interpolation wherever it is safe, else bisection.
pub fn root(mut f: impl FnMut(&Real) -> Real, lo: &Real, hi: &Real) -> Real {
    let (mut a, mut b) = (hi.clone(), lo.clone());
    let (mut fa, mut fb) = (f(&a), f(&b));
    if is_zero(&fa) {
        return a;
    }
    if is_zero(&fb) {
        return b;
    }
    assert!(
        sign(&fa) != sign(&fb),
        "the bracket holds no change of sign"
    );
    let half = ratio(1, 2);
    let one = int(1);
    let (relative, absolute) = (power_of_two(-190), power_of_two(-600));
    let mut t = half.clone();
    loop {
        let x = &a + &t * (&b - &a);
        let fx = f(&x);
        let (c, fc);
        if sign(&fx) == sign(&fa) {
            (c, fc) = (a, fa);
        } else {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let best = if abs(&fa) < abs(&fb) { &a } else { &b };
        let least = (abs(best) * &relative + &absolute) / abs(&(&b - &a));
        if is_zero(&fa) || least > half {
            return best.clone();
        }
        let xi = (&a - &b) / (&c - &b);
        let phi = (&fa - &fb) / (&fc - &fb);
        t = if &phi * &phi < xi && (&one - &phi) * (&one - &phi) < &one - &xi {
            &fa / (&fb - &fa) * (&fc / (&fb - &fc))
                + (&c - &a) / (&b - &a) * (&fa / (&fc - &fa)) * (&fb / (&fc - &fb))
        } else {
            half.clone()
        };
        if t < least {
            t = least;
        } else if t > &one - &least {
            t = &one - least;
        }
    }
}

/// The value of a polynomial given by its Bernstein coefficients on 0..1, by de Casteljau.
pub fn bernstein_value(coefficients: &[Real], t: &Real) -> Real {
    let mut c = coefficients.to_vec();
    let s = int(1) - t;
    for level in (1..c.len()).rev() {
        for i in 0..level {
            c[i] = &s * &c[i] + t * &c[i + 1];
        }
    }
    c.swap_remove(0)
}

/// All places in 0..=1 at which a polynomial, given by Bernstein coefficients, changes sign,
/// ascending.
///
/// The number of roots is at most the number of sign changes of the coefficients and of the same
/// parity (Descartes' rule in Bernstein form): halving goes on until there is one change or none.
/// A cluster tighter than 2^-120 is given as one place, whether or not the sign changes there.
pub fn sign_changes(coefficients: &[Real]) -> Vec<Real> {
    let mut found = Vec::new();
    isolate(coefficients, &int(0), &int(1), 120, &mut found);
    found
}

fn isolate(c: &[Real], lo: &Real, width: &Real, depth: usize, found: &mut Vec<Real>) {
    let signs: Vec<i32> = c.iter().map(sign).filter(|s| *s != 0).collect();
    let changes = signs.windows(2).filter(|w| w[0] != w[1]).count();
    let ends_differ = sign(&c[0]) * sign(&c[c.len() - 1]) < 0;
    if changes == 0 {
        return;
    }
    if changes == 1 && ends_differ {
        let x = root(|t| bernstein_value(c, t), &int(0), &int(1));
        found.push(lo + width * x);
        return;
    }
    let half = width * ratio(1, 2);
    let middle = lo + &half;
    if depth == 0 {
        found.push(middle);
        return;
    }
    let (left, right) = halves(c);
    isolate(&left, lo, &half, depth - 1, found);
    if is_zero(&right[0]) {
        found.push(middle.clone());
    }
    isolate(&right, &middle, &half, depth - 1, found);
}

/// Bernstein coefficients on 0..1/2 and on 1/2..1.
fn halves(c: &[Real]) -> (Vec<Real>, Vec<Real>) {
    let half = ratio(1, 2);
    let mut row = c.to_vec();
    let mut left = vec![row[0].clone()];
    let mut right = vec![row[row.len() - 1].clone()];
    while row.len() > 1 {
        row = row.windows(2).map(|w| (&w[0] + &w[1]) * &half).collect();
        left.push(row[0].clone());
        right.push(row[row.len() - 1].clone());
    }
    right.reverse();
    (left, right)
}

/// Number of nodes of the quadrature rule.
const NODES: usize = 40;

/// Nodes and weights of the Gauss-Legendre rule on 0..1.
fn gauss_legendre() -> &'static [(Real, Real)] {
    static RULE: OnceLock<Vec<(Real, Real)>> = OnceLock::new();
    RULE.get_or_init(|| (1..=NODES).map(gauss_node).collect())
}

/// The i-th root z of the Legendre polynomial by Newton's method from Tricomi's guess, mapped to
/// 0..1, and its weight `1 / ((1 - z^2) P'(z)^2)`.
fn gauss_node(i: usize) -> (Real, Real) {
    let guess = std::f64::consts::PI * (i as f64 - 0.25) / (NODES as f64 + 0.5);
    let mut z = real(guess.cos());
    for _ in 0..6 {
        let (value, slope) = legendre(&z);
        z -= value / slope;
    }
    let (_, slope) = legendre(&z);
    let weight = int(1) / ((int(1) - &z * &z) * &slope * &slope);
    ((int(1) + z) * ratio(1, 2), weight)
}

/// The Legendre polynomial of degree [`NODES`] and its derivative, by the three-term recurrence.
fn legendre(z: &Real) -> (Real, Real) {
    let (mut before, mut p) = (int(1), z.clone());
    for n in 2..=NODES {
        let next = (z * &p * int(2 * n - 1) - before * int(n - 1)) / int(n);
        (before, p) = (p, next);
    }
    let slope = (before - z * &p) * int(NODES) / (int(1) - z * z);
    (p, slope)
}

/// The integral of a smooth `f` over `lo..hi`, to about 42 digits of the integral of `|f|`.
///
/// A panel is halved until its rule and the sum of the rules of its halves agree.
pub fn integrate(f: &dyn Fn(&Real) -> Real, lo: &Real, hi: &Real) -> Real {
    refine(f, lo, hi, &panel(f, lo, hi), 30)
}

/// The rule on one panel: the integrals of `f` and of `|f|`.
fn panel(f: &dyn Fn(&Real) -> Real, lo: &Real, hi: &Real) -> (Real, Real) {
    let width = hi - lo;
    let (mut sum, mut scale) = (int(0), int(0));
    for (x, weight) in gauss_legendre() {
        let term = weight * f(&(lo + &width * x));
        scale += abs(&term);
        sum += term;
    }
    (sum * &width, scale * &width)
}

fn refine(
    f: &dyn Fn(&Real) -> Real,
    lo: &Real,
    hi: &Real,
    whole: &(Real, Real),
    depth: usize,
) -> Real {
    let middle = (lo + hi) * ratio(1, 2);
    let (left, right) = (panel(f, lo, &middle), panel(f, &middle, hi));
    let sum = &left.0 + &right.0;
    if depth == 0 || abs(&(&sum - &whole.0)) <= abs(&whole.1) * parse("1e-42") {
        return sum;
    }
    refine(f, lo, &middle, &left, depth - 1) + refine(f, &middle, hi, &right, depth - 1)
}
