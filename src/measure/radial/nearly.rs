//! The peak distance from an ellipse, nearly and in a fraction of the time: most decisions, as that on a number of decimals, need no more.

use core::f64::consts::PI;

use kurbo::{CubicBez, PathSeg, Point, Vec2};

use crate::numeric::functions::unit_vector;
use crate::shape::Truth;

/// The parts of a segment between samples. They lie as the zeros of Chebyshev's polynomials do, since the lobes of good curves do.
const PARTS: usize = 24;

/// Up to this product of the distance with the largest curvature the first order tells the distance to a part of 0.005.
const FIRST_ORDER: f64 = 0.005;

/// Ellipses flatter than this have peaks that fall between samples.
const FLATTEST: f64 = 10.0;

/// The least distance, as a multiple of the rounding of the coordinates, that samples can tell.
const OVER_ROUNDING: f64 = 4000.0 * f64::EPSILON;

/// What the largest sample, and the peak of the parabola through it, are off at most.
const BELOW: f64 = 0.99;
const ABOVE: f64 = 1.02;

/// Between what the peak distance of these segments from an ellipse lies; some point lies as far as the first in any case. `None`
/// where samples do not tell.
pub(crate) fn peak_between(
    segments: impl IntoIterator<Item = PathSeg>,
    truth: &Truth,
) -> Option<[f64; 2]> {
    let (larger, smaller) = (truth.larger_radius(), truth.radii.x.min(truth.radii.y));
    if larger > FLATTEST * smaller {
        return None;
    }
    let places = places();
    let frame = Frame::new(truth);
    let (mut attained, mut peak) = (0.0_f64, 0.0_f64);
    let mut reach = truth.center.x.abs().max(truth.center.y.abs()) + larger;
    for segment in segments {
        let cubic = segment.to_cubic();
        for p in [cubic.p1, cubic.p2, cubic.p3] {
            reach = reach.max(p.x.abs()).max(p.y.abs());
        }
        let (sample, top) = frame.peak(&cubic, &places);
        attained = attained.max(sample);
        peak = peak.max(top);
    }
    let is_small = peak * larger <= FIRST_ORDER * smaller * smaller;
    (attained > OVER_ROUNDING * reach && is_small).then_some([attained * BELOW, peak * ABOVE])
}

/// Where samples are taken.
fn places() -> [f64; PARTS + 1] {
    core::array::from_fn(|i| (1.0 - unit_vector(PI * i as f64 / PARTS as f64).x) / 2.0)
}

/// The frame in which the ellipse is the unit circle.
struct Frame {
    center: Point,
    /// The rows of the map there, and the radii.
    rows: [Vec2; 2],
    radii: Vec2,
}

impl Frame {
    fn new(truth: &Truth) -> Self {
        let (axis, radii) = (truth.axis, truth.radii);
        Self {
            center: truth.center,
            rows: [axis / radii.x, Vec2::new(-axis.y, axis.x) / radii.y],
            radii,
        }
    }

    /// The largest sample of Sampson's distance |F| / (2 √G), F = |q|² - 1 and G the squares of q over the radii; and the peak of the
    /// parabola through it and its neighbours.
    fn peak(&self, cubic: &CubicBez, places: &[f64; PARTS + 1]) -> (f64, f64) {
        let CubicBez { p0, p1, p2, p3 } = *cubic;
        let [q0, q1, q2, q3] = [p0, p1, p2, p3].map(|p| {
            let arm = p - self.center;
            Vec2::new(self.rows[0].dot(arm), self.rows[1].dot(arm))
        });
        let (a, b) = (self.radii.x * self.radii.x, self.radii.y * self.radii.y);
        let squares = places.map(|t| {
            let s = 1.0 - t;
            let q = q0 * (s * s * s)
                + q1 * (3.0 * s * s * t)
                + q2 * (3.0 * s * t * t)
                + q3 * (t * t * t);
            let (xx, yy) = (q.x * q.x, q.y * q.y);
            let excess = xx + yy - 1.0;
            excess * excess / (xx / a + yy / b)
        });
        let mut top = 0;
        for (i, square) in squares.iter().enumerate() {
            if *square > squares[top] {
                top = i;
            }
        }
        let distance = |i: usize| squares[i].sqrt() / 2.0;
        let sample = distance(top);
        if top == 0 || top == PARTS {
            return (sample, sample);
        }
        let (before, after) = (distance(top - 1), distance(top + 1));
        let (slope, bend) = ((after - before) / 2.0, before - 2.0 * sample + after);
        let peak = if bend < 0.0 {
            sample - slope * slope / (2.0 * bend)
        } else {
            sample
        };
        (sample, peak)
    }
}
