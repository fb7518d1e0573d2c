//! The peak distance from an ellipse, nearly and in a fraction of the time: most decisions, as that on a number of decimals, need no more.
//!
//! In the frame where the ellipse is the unit circle F = |q|² - 1 is sampled at t = (1 - cos θ)/2 for θ evenly spread. It is a trigonometric
//! polynomial of degree 6 in θ: with N steps its largest size is at most 1/cos(6π/(2N)) times its largest sample (Ehlich, Zeller), its
//! second derivative at most 36 times that (Bernstein), and between two samples it is not larger than both by more than δ²/8 of it, δ = π/N.
//! Where the control points turn about the centre one after the other, so does the curve, and 1/G, with G = ((x/a)² + (y/b)²)/|q|², is not
//! larger than at both ends of a step, but where that passes the long axis. With Q = G |q|² the nearest point is then no farther than
//!
//! ```text
//! |F| / (√Q (1 + √(1 - |F|/(b² Q)))),   b the smaller radius
//! ```
//!
//! where a walk along the gradient of F meets the ellipse (derived): a bound on the distance.

mod circle;

pub(crate) use circle::circle_decided;

use core::f64::consts::PI;
use std::sync::LazyLock;

use kurbo::{CubicBez, PathSeg, Point, Vec2};

use super::distance;
use crate::numeric;
use crate::numeric::functions::{larger, unit_vector};
use crate::numeric::instructions::by_the_best;
use crate::shape::Truth;

/// The samples: one more than there are steps between them, few and many.
const FEW: usize = 25;
const MANY: usize = 97;

/// The degree of F.
const DEGREE: f64 = 6.0;

/// Up to this product of the distance with the largest curvature the first order tells the distance to a part of 0.005.
const FIRST_ORDER: f64 = 0.005;

/// Ellipses flatter than this have peaks that fall between samples.
const FLATTEST: f64 = 10.0;

/// The least distance, as a multiple of the rounding of the coordinates, that samples can tell.
const OVER_ROUNDING: f64 = 4000.0 * f64::EPSILON;

/// The same where bounds decide.
const WELL_OVER_ROUNDING: f64 = 1e-6;

/// The rounding of a sample, in those of the coordinates.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// What the largest sample, and the peak of the parabola through it, are off at most.
const BELOW: f64 = 0.99;
const ABOVE: f64 = 1.05;

/// Bounds of the peak distance of these segments from an ellipse, where samples tell them.
pub(crate) fn nearly(
    segments: impl IntoIterator<Item = PathSeg>,
    truth: &Truth,
) -> Option<[f64; 2]> {
    let (larger, smaller) = (truth.larger_radius(), truth.radii.x.min(truth.radii.y));
    let mut frame = EllipseFrame::new(truth);
    let (mut attained, mut peak) = (0.0_f64, 0.0_f64);
    for segment in segments {
        let samples = frame.samples(&segment.to_cubic(), &FEW_WEIGHTS);
        let (sample, top) = samples.peak();
        attained = attained.max(sample);
        peak = peak.max(top);
    }
    let is_small = peak * larger <= FIRST_ORDER * smaller * smaller;
    let tells = larger <= FLATTEST * smaller && is_small && attained > OVER_ROUNDING * frame.reach;
    tells.then_some([attained * BELOW, peak * ABOVE])
}

/// What is decided alike by both of these.
pub(crate) fn agreed<T: PartialEq>(between: [f64; 2], decide: impl Fn(f64) -> T) -> Option<T> {
    let [low, high] = between.map(decide);
    (low == high).then_some(low)
}

/// What is decided by the peak distance of these segments from an ellipse, where it is the same for all that the peak may be: by what
/// is told of it, or by few samples, and then by many. `None` where only the peak itself decides.
pub(crate) fn decided<T: PartialEq, S: IntoIterator<Item = PathSeg>>(
    told: Option<[f64; 2]>,
    segments: impl Fn() -> S,
    truth: &Truth,
    decide: impl Fn(f64) -> T,
) -> Option<T> {
    let same = |between| agreed(between, &decide);
    let between = told.or_else(|| nearly(segments(), truth));
    between
        .and_then(same)
        .or_else(|| closely(segments(), truth).and_then(same))
}

/// Bounds of the peak distance, by the distance of the farthest of many samples and their bound; `None` where rounding counts
/// beside it, or that of a centre that follows from given ends.
fn closely(segments: impl IntoIterator<Item = PathSeg>, truth: &Truth) -> Option<[f64; 2]> {
    let mut frame = EllipseFrame::new(truth);
    let [mut low, mut high] = [0.0_f64; 2];
    for segment in segments {
        let cubic = segment.to_cubic();
        let samples = frame.samples(&cubic, &MANY_WEIGHTS);
        let top = samples.farthest();
        let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(Point::to_vec2);
        let weighted = (0..4).map(|k| points[k] * MANY_WEIGHTS[k][top]);
        let place = weighted.fold(Vec2::ZERO, |sum, p| sum + p).to_point();
        low = low.max(distance(truth, place).abs());
        high = high.max(samples.bound(&frame));
    }
    let tells = low > WELL_OVER_ROUNDING * frame.reach && high.is_finite();
    tells.then(|| [low - frame.rounding(), high + frame.rounding()])
}

/// What the peak distance is not larger than, for certain, by few samples.
pub(crate) fn bound(segments: impl IntoIterator<Item = PathSeg>, truth: &Truth) -> f64 {
    bound_by(&FEW_WEIGHTS, segments, truth)
}

/// The same, nearer to the peak, by more samples.
pub(crate) fn closer_bound(segments: impl IntoIterator<Item = PathSeg>, truth: &Truth) -> f64 {
    bound_by(&MANY_WEIGHTS, segments, truth)
}

fn bound_by<const N: usize>(
    weights: &SampleWeights<N>,
    segments: impl IntoIterator<Item = PathSeg>,
    truth: &Truth,
) -> f64 {
    let mut frame = EllipseFrame::new(truth);
    let mut most = 0.0_f64;
    for segment in segments {
        let cubic = segment.to_cubic();
        let bound = by_the_best(
            #[inline(always)]
            || frame.samples(&cubic, weights).bound(&frame),
        );
        most = most.max(bound);
    }
    most + frame.rounding()
}

/// Bernstein's polynomials at the samples.
type SampleWeights<const N: usize> = [[f64; N]; 4];

static FEW_WEIGHTS: LazyLock<SampleWeights<FEW>> = LazyLock::new(weights);
static MANY_WEIGHTS: LazyLock<SampleWeights<MANY>> = LazyLock::new(weights);

fn weights<const N: usize>() -> SampleWeights<N> {
    let t: [f64; N] =
        core::array::from_fn(|i| (1.0 - unit_vector(PI * i as f64 / (N - 1) as f64).x) / 2.0);
    [
        t.map(|t| (1.0 - t) * (1.0 - t) * (1.0 - t)),
        t.map(|t| 3.0 * (1.0 - t) * (1.0 - t) * t),
        t.map(|t| 3.0 * (1.0 - t) * t * t),
        t.map(|t| t * t * t),
    ]
}

/// The frame in which the ellipse is the unit circle.
struct EllipseFrame {
    center: Point,
    /// The rows of the map there, and the squares of the radii.
    rows: [Vec2; 2],
    squares: [f64; 2],
    /// The largest coordinate so far.
    reach: f64,
}

impl EllipseFrame {
    fn new(truth: &Truth) -> Self {
        let (axis, radii) = (truth.axis, truth.radii);
        Self {
            center: truth.center,
            rows: [axis / radii.x, Vec2::new(-axis.y, axis.x) / radii.y],
            squares: [radii.x * radii.x, radii.y * radii.y],
            reach: truth.center.x.abs().max(truth.center.y.abs()) + truth.larger_radius(),
        }
    }

    /// How far the rounding of coordinates may move a distance.
    fn rounding(&self) -> f64 {
        let [a, b] = self.squares;
        ROUNDING * self.reach * (a.max(b) / a.min(b)).sqrt()
    }

    /// The control points there.
    #[inline(always)]
    fn framed(&mut self, cubic: &CubicBez) -> [[f64; 2]; 4] {
        let CubicBez { p0, p1, p2, p3 } = *cubic;
        for p in [p1, p2, p3] {
            self.reach = self.reach.max(p.x.abs()).max(p.y.abs());
        }
        [p0, p1, p2, p3].map(|p| {
            let arm = p - self.center;
            [self.rows[0].dot(arm), self.rows[1].dot(arm)]
        })
    }

    #[inline(always)]
    fn samples<const N: usize>(
        &mut self,
        cubic: &CubicBez,
        weights: &SampleWeights<N>,
    ) -> SegmentSamples<N> {
        let points = self.framed(cubic);
        let (x, y) = (along(&points, 0, weights), along(&points, 1, weights));
        let [a, b] = self.squares.map(f64::recip);
        let mut samples = SegmentSamples {
            excess: [0.0; N],
            steepness: [0.0; N],
            long: if a < b { y } else { x },
            turns: turns(&points),
        };
        for i in 0..N {
            let (xx, yy) = (x[i] * x[i], y[i] * y[i]);
            samples.excess[i] = xx + yy - 1.0;
            samples.steepness[i] = 1.0 / (xx * a + yy * b);
        }
        samples
    }
}

/// A coordinate at the samples. This loop and those below run over places, not over iterators of them: the compiler makes vectors of such.
#[inline(always)]
fn along<const N: usize>(
    points: &[[f64; 2]; 4],
    axis: usize,
    weights: &SampleWeights<N>,
) -> [f64; N] {
    let [a, b, c, d] = points.map(|p| p[axis]);
    let mut along = [0.0; N];
    for i in 0..N {
        let sum = a * weights[0][i] + b * weights[1][i];
        along[i] = sum + c * weights[2][i] + d * weights[3][i];
    }
    along
}

/// Whether points turn about the origin one after the other, by less than half a turn.
#[inline(always)]
fn turns(points: &[[f64; 2]; 4]) -> bool {
    let cross = |i: usize, j: usize| points[i][0] * points[j][1] - points[i][1] * points[j][0];
    let sense = cross(0, 3);
    let pairs = [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3)];
    // Quadratics, raised, and cubics have pairs of their own, and none may be so short that rounding decides.
    sense != 0.0 && pairs.iter().all(|&(i, j)| cross(i, j) * sense > 0.0)
}

/// A segment's samples.
struct SegmentSamples<const N: usize> {
    /// F, and 1/Q.
    excess: [f64; N],
    steepness: [f64; N],
    /// The coordinate that vanishes on the long axis.
    long: [f64; N],
    turns: bool,
}

impl<const N: usize> SegmentSamples<N> {
    /// The squares of twice Sampson's distance |F|/(2√Q).
    #[inline]
    fn squares(&self) -> [f64; N] {
        let mut squares = [0.0; N];
        let samples = self.excess.iter().zip(&self.steepness);
        for (square, (excess, steepness)) in squares.iter_mut().zip(samples) {
            *square = excess * excess * steepness;
        }
        squares
    }

    /// Which sample is the farthest by that.
    fn farthest(&self) -> usize {
        farthest(&self.squares())
    }

    /// The largest sample of Sampson's distance, and the peak of the parabola through it and its neighbours.
    fn peak(&self) -> (f64, f64) {
        let squares = self.squares();
        let top = farthest(&squares);
        let distance = |i: usize| squares[i].sqrt() / 2.0;
        let sample = distance(top);
        if top == 0 || top == N - 1 {
            return (sample, sample);
        }
        let three = [distance(top - 1), sample, distance(top + 1)];
        (sample, numeric::top(three))
    }

    /// A bound on the distance.
    #[inline(always)]
    fn bound(&self, frame: &EllipseFrame) -> f64 {
        let step = PI / (N - 1) as f64;
        let sizes = self.excess.map(f64::abs);
        let most = largest(&sizes);
        let bound = most / unit_vector(DEGREE * step / 2.0).x;
        if !self.turns {
            return f64::INFINITY;
        }
        let between = bound * (DEGREE * DEGREE * step * step / 8.0);
        let [a, b] = frame.squares;
        let flat = a.max(b);
        // 1/G.
        let slack: [f64; N] = core::array::from_fn(|i| (1.0 + self.excess[i]) * self.steepness[i]);
        let [mut parts, mut squares] = [[0.0; N]; 2];
        for i in 0..N - 1 {
            let excess = larger(sizes[i], sizes[i + 1]) + between;
            let aside = larger(slack[i], slack[i + 1]);
            let is_aside = self.long[i] * self.long[i + 1] > 0.0;
            parts[i] = excess * if is_aside { aside } else { flat };
            squares[i] = parts[i] * excess;
        }
        let (ratio, square) = (largest(&parts), largest(&squares));
        let inner = 1.0 - bound;
        let root = (1.0 - ratio / (a.min(b) * inner)).sqrt();
        let most = (square / inner).sqrt() / (1.0 + root);
        // Not where |F| may be beyond a half: no walk is sure to meet the ellipse from there.
        if most.is_finite() {
            most
        } else {
            f64::INFINITY
        }
    }
}

/// The largest of these numbers, none of which is negative, in lanes.
#[inline(always)]
fn largest<const N: usize>(numbers: &[f64; N]) -> f64 {
    let mut lanes = [0.0; 4];
    for some in numbers.chunks(4) {
        for (lane, &x) in lanes.iter_mut().zip(some) {
            *lane = larger(x, *lane);
        }
    }
    let [a, b, c, d] = lanes;
    larger(larger(a, b), larger(c, d))
}

/// Where the largest of these numbers stands, the first of them.
fn farthest<const N: usize>(squares: &[f64; N]) -> usize {
    (1..N).fold(0, |top, i| if squares[i] > squares[top] { i } else { top })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::radial;
    use crate::number::Precision;
    use crate::{Angle, Arc, Cut, Options, Shape, approximate};

    #[test]
    fn the_peak_lies_where_samples_say() {
        let mut told = 0;
        for i in 0..3000 {
            let at = |k: usize| (i * k % 1009) as f64 / 1009.0;
            let radii = (100.0, 100.0 * libm::pow(0.03, at(7)));
            let degrees = Angle::from_degrees;
            let (start, sweep) = (degrees(360.0 * at(11)), degrees(10.0 + 340.0 * at(17)));
            let arc =
                Arc::new((30.0, -20.0), radii, degrees(180.0 * at(23)), start, sweep).unwrap();
            let options = Options {
                cut: Cut::Count(3 + i % 5),
                precision: Some(Precision::Fixed(1 + (i % 7) as u8)),
                ..Options::default()
            };
            let drawing = approximate(&Shape::Arc(arc), &options).unwrap();
            let truth = drawing.outline.unwrap().truth;
            for segment in &drawing.curve.segments {
                let peak = radial::error([segment], &truth).peak();
                let near = nearly([*segment], &truth);
                let most = bound([*segment], &truth);
                assert!(most >= peak, "{most} bounds {peak}");
                let finer = closer_bound([*segment], &truth);
                assert!(finer >= peak, "{finer} bounds {peak}");
                if let Some([low, high]) = closely([*segment], &truth) {
                    assert!(low <= peak && peak <= high, "{low} {peak} {high}");
                }
                let Some([low, high]) = near else {
                    continue;
                };
                told += 1;
                assert!(low <= peak && peak <= high, "{low} {peak} {high}");
                let is_tight = most <= 1.25 * peak + 1e-9;
                assert!(is_tight || radii.1 < 30.0, "{most} bounds {peak}");
            }
        }
        assert!(told > 5000, "{told}");
    }
}

#[cfg(test)]
mod checks;
