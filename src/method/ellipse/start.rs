//! Where the search for the best handles begins: the same problem to first order, on the circle.
//!
//! The affine image of the segment on the unit circle is c(t), with s = 1 - t and the angle φ between its ends. Its excess |c|² - 1 is
//! s²t² q(t), and q is a quadratic:
//!
//! ```text
//! q = c0 s² + c1 st + c2 t²,   c0 = 9 k0² + 6 k1 sin φ - 6 (1 - cos φ),   c2 likewise with k0 and k1 exchanged,
//!                              c1 = 18 (k0 + k1) sin φ - 18 k0 k1 cos φ - 20 (1 - cos φ)
//! ```
//!
//! The distance from the ellipse is to first order s²t² q / (2G), G = |(x/a, y)| at c (Sampson). The exchange of Remez makes its
//! three extremes level: the handles for given places, then the extremes for given handles, each between the zeros of q around it.
//! This needs no nearest point, and on flat ellipses it comes so close that two or three steps of the true search are left.

use kurbo::{CubicBez, Vec2};

use super::{EllipseSegment, FittedHandles, SIGNS};
use crate::numeric::linear;

/// Where the extremes of a circle's segment lie, about.
const TIMES: [f64; 3] = [0.182, 0.5, 0.818];

/// Two or three rounds do for nearly all; on ellipses flatter than 1:20 a few in a thousand go round in circles.
const MOST_ROUNDS: usize = 20;

/// What an extreme moves by in the last round: its distance is off by the square.
const IN_PLACE: f64 = 3e-3;

/// The excess of a segment of the unit circle.
struct Excess {
    /// 2 (1 - cos φ), the square of the chord.
    chord: f64,
    cosine: f64,
    sine: f64,
}

impl Excess {
    fn new([u0, u1]: [Vec2; 2]) -> Self {
        Self {
            chord: (u1 - u0).hypot2(),
            cosine: u0.dot(u1),
            sine: u0.cross(u1),
        }
    }

    /// c0, c1 and c2.
    fn coefficients(&self, [k0, k1]: [f64; 2]) -> [f64; 3] {
        let end =
            |near: f64, far: f64| 9.0 * near * near + 6.0 * self.sine * far - 3.0 * self.chord;
        let middle =
            18.0 * self.sine * (k0 + k1) - 18.0 * self.cosine * k0 * k1 - 10.0 * self.chord;
        [end(k0, k1), middle, end(k1, k0)]
    }

    /// The derivatives of q by k0 and k1.
    fn by_handles(&self, [k0, k1]: [f64; 2], t: f64) -> [f64; 2] {
        let s = 1.0 - t;
        let by = |near: f64, far: f64, s: f64, t: f64| {
            18.0 * s * (s * near - t * self.cosine * far) + 6.0 * self.sine * t * (3.0 * s + t)
        };
        [by(k0, k1, s, t), by(k1, k0, t, s)]
    }
}

/// q and its derivatives.
fn quotient([c0, c1, c2]: [f64; 3], t: f64) -> [f64; 3] {
    let s = 1.0 - t;
    [
        c0 * s * s + c1 * s * t + c2 * t * t,
        2.0 * (c2 * t - c0 * s) + c1 * (s - t),
        2.0 * (c0 + c2 - c1),
    ]
}

/// What parts the three extremes: the zeros of q, or the middles where it has none between them.
fn between([c0, c1, c2]: [f64; 3], [first, middle, last]: [f64; 3]) -> [f64; 2] {
    // In t/s it is c0 + c1 (t/s) + c2 (t/s)².
    let w = -0.5 * (c1 + (c1 * c1 - 4.0 * c0 * c2).sqrt().copysign(c1));
    let [y, z] = [w / c2, c0 / w].map(|ratio| ratio / (1.0 + ratio));
    let (y, z) = (y.min(z), y.max(z));
    if first < y && y < middle && middle < z && z < last {
        [y, z]
    } else {
        [first.midpoint(middle), middle.midpoint(last)]
    }
}

impl EllipseSegment {
    /// The handles and the peak that are best to first order, from these handles, and where the extremes are; `None` where the
    /// exchange does not settle.
    pub(super) fn start(&self, mut handles: [f64; 2]) -> Option<(FittedHandles, [f64; 3])> {
        let excess = Excess::new(self.ends);
        let mut times = TIMES;
        for _ in 0..MOST_ROUNDS {
            let peak = self.leveled(&excess, &mut handles, times)?;
            let fit = FittedHandles { handles, peak };
            if self.exchanged(&excess, &fit, &mut times) < IN_PLACE {
                return Some((fit, times));
            }
        }
        None
    }

    /// The segment of the unit circle whose affine image this is.
    fn on_circle(&self, handles: [f64; 2]) -> CubicBez {
        let circle = Self {
            radii: Vec2::new(1.0, 1.0),
            is_free: false,
            ..*self
        };
        circle.cubic(&FittedHandles { handles, peak: 0.0 })
    }

    /// One step of Newton's method for the handles with which the distance is as large, and of these signs, at these times; the
    /// peak comes back.
    fn leveled(&self, excess: &Excess, handles: &mut [f64; 2], times: [f64; 3]) -> Option<f64> {
        let coefficients = excess.coefficients(*handles);
        let cubic = self.on_circle(*handles);
        let mut rows = [[0.0; 3]; 3];
        let mut misses = [0.0; 3];
        for (i, t) in times.into_iter().enumerate() {
            let [c, ..] = super::derivatives(&cubic, t);
            let st = t * (1.0 - t);
            let weight = st * st / (2.0 * Vec2::new(c.x / self.radii.x, c.y).hypot());
            let [by_k0, by_k1] = excess.by_handles(*handles, t);
            let [q, ..] = quotient(coefficients, t);
            rows[i] = [weight * by_k0, weight * by_k1, -SIGNS[i]];
            misses[i] = -weight * q;
        }
        let [k0, k1, peak] = linear::solve(rows, misses)?;
        *handles = [handles[0] + k0, handles[1] + k1];
        Some(peak)
    }

    /// Moves the times towards the extremes, by one step of Newton's method each, and tells how far the farthest went.
    fn exchanged(&self, excess: &Excess, fit: &FittedHandles, times: &mut [f64; 3]) -> f64 {
        let coefficients = excess.coefficients(fit.handles);
        let cubic = self.on_circle(fit.handles);
        let [y, z] = between(coefficients, *times);
        let bounds = [0.0, y, z, 1.0];
        let alpha = 1.0 / (self.radii.x * self.radii.x);
        let product = |v: Vec2, w: Vec2| v.x * w.x * alpha + v.y * w.y;
        let mut farthest = 0.0_f64;
        for (i, time) in times.iter_mut().enumerate() {
            let t = *time;
            let (s, turn) = (1.0 - t, 1.0 - 2.0 * t);
            let [q, q1, q2] = quotient(coefficients, t);
            let [c, v, a] = super::derivatives(&cubic, t);
            // G'/G and its derivative.
            let over = 1.0 / product(c, c);
            let g = product(c, v) * over;
            let g1 = (product(v, v) + product(c, a)) * over - 2.0 * g * g;
            // The derivative of s²t² q/G, over st/G, and its own.
            let slope = 2.0 * turn * q + s * t * (q1 - q * g);
            let bends = turn * (3.0 * q1 - q * g) - 4.0 * q + s * t * (q2 - q1 * g - q * g1);
            let sign = SIGNS[i] * fit.peak;
            let goes_up = slope * sign > 0.0;
            let newton = t - slope / bends;
            let halfway = t.midpoint(bounds[if goes_up { i + 1 } else { i }]);
            let is_near = bends * sign < 0.0 && (newton < halfway) == goes_up;
            *time = if is_near { newton } else { halfway };
            farthest = farthest.max((*time - t).abs());
        }
        farthest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::{Span, minimax};
    use kurbo::ParamCurve;

    /// The rounds of the exchange from the circle's handles, and what it ends with.
    fn exchange(segment: &EllipseSegment, size: f64) -> (usize, FittedHandles, [f64; 3]) {
        let excess = Excess::new(segment.ends);
        let mut handles = [minimax::handle(&Span::from_degrees(size)); 2];
        let mut times = TIMES;
        for round in 1.. {
            let peak = segment.leveled(&excess, &mut handles, times).unwrap();
            let fit = FittedHandles { handles, peak };
            if segment.exchanged(&excess, &fit, &mut times) < IN_PLACE {
                return (round, fit, times);
            }
            assert!(round < 100, "the exchange does not settle");
        }
        unreachable!()
    }

    /// Sampson's distance: the excess over twice the length of its half gradient, of the affine image of the circle's segment.
    fn sampson(segment: &EllipseSegment, fit: &FittedHandles, t: f64) -> f64 {
        let point = segment.on_circle(fit.handles).eval(t).to_vec2();
        let gradient = Vec2::new(point.x / segment.radii.x, point.y);
        (point.hypot2() - 1.0) / (2.0 * gradient.hypot())
    }

    #[test]
    fn the_exchange_levels_the_extremes_in_two_or_three_rounds() {
        let (mut taken, mut searches) = (0, 0);
        for short in [0.9, 0.5, 0.2, 0.1] {
            for size in [30.0, 60.0, 90.0, 120.0] {
                for from in (0..180).step_by(10).map(f64::from) {
                    let segment = EllipseSegment::new(short, from, size, false);
                    let (rounds, fit, times) = exchange(&segment, size);
                    (taken, searches) = (taken + rounds, searches + 1);
                    let what = format!("{short} {size} {from}");
                    for (t, sign) in times.into_iter().zip(SIGNS) {
                        let near = |by: f64| sign * sampson(&segment, &fit, t + by);
                        assert!((near(0.0) / fit.peak - 1.0).abs() < 0.02, "{what}");
                        assert!(near(0.02) < near(0.0) && near(-0.02) < near(0.0), "{what}");
                    }
                }
            }
        }
        assert!(taken <= 660, "{taken} of {searches}");
    }
}
