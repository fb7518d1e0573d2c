//! The peak distance of a segment from an ellipse, where cubics touch it at both ends: from the extremes of their excess, without a search.
//!
//! On the ellipse of half axes b and 1 a place where the excess is F (see [`TouchingCubic`]) has the distance, with Q = (x/b)² + y² along the axes
//! and K = ((x/b²)² + y²)/Q the bend of F along the normal,
//!
//! ```text
//! D = F/(2√Q) (1 + F K/(4Q)),   (log D)' ≈ F'/F - Q'/(2Q)
//! ```
//!
//! and its extremes lie a step or two of Newton's method from the lobes, or from the sharp end of a flat ellipse (derived). The peak that is
//! told is attained, so that it is not more than the true one by more than the terms of third order.

use kurbo::Vec2;

use super::touching::TouchingCubic;
use crate::angle::Angle;
use crate::method::Rule;
use crate::numeric::foot::foot;
use crate::numeric::instructions::by_the_best;
use crate::numeric::lanes::{Lanes, Real};

/// The largest size of a segment, in units of the sharp end's size (as an angle, the ratio of the radii) or of the way to it: the weight
/// then varies so little along it that a longer segment errs more.
const LARGEST: f64 = 14.0;

/// The least size of a segment, in degrees: of a shorter one, whose error is below the digits of a coordinate, H and G lose theirs.
pub(super) const SHORTEST: f64 = 1.0;

/// The largest product of the distance with the curvature of the ellipse beside it, for the same reason.
const ROUGHEST: f64 = 0.1;

/// Beyond this product the nearest point is taken.
const ROUGH: f64 = 0.01;

/// Lobes that may turn out the highest, by what is known of them before the first step.
const RIVAL: f64 = 0.9;

/// The most places that may be the farthest: three lobes and a sharp end.
const MOST_LOBES: usize = 4;

/// The most steps, the largest of them, and what a step must promise, as a part of the distance.
const MOST_STEPS: usize = 4;
const STEP: f64 = 0.2;
const GAIN: f64 = 1e-4;

/// The peak of a segment.
#[derive(Clone, Copy)]
pub(super) struct Peak {
    /// The distance, over the larger radius.
    pub(super) size: f64,
    /// How its logarithm changes with the start and the end of the segment, by degree and nearly.
    pub(super) slopes: [f64; 2],
}

/// What gives the peaks.
#[derive(Clone, Copy)]
pub(super) struct Lobes {
    rule: Rule,
    order: f64,
    /// The smaller radius over the larger one, and the square of its reciprocal.
    pub(super) short: f64,
    flat: f64,
}

impl Lobes {
    /// Of a rule whose every piece is a cubic along the tangents with a handle in closed form.
    pub(super) fn new(rule: Rule, order: f64, short: f64) -> Self {
        Self {
            rule,
            order,
            short,
            flat: 1.0 / (short * short),
        }
    }

    /// The peak of the segment of `size` degrees that begins `from` degrees after the short axis; `None` where it is so long that a longer
    /// one may err less.
    pub(super) fn of(&self, from: f64, size: f64) -> Option<Peak> {
        self.is_tame(from, size)
            .then(|| self.of_any(from, size))
            .flatten()
    }

    /// The same of a segment of any length; `None` where it is too short or strays too far.
    pub(super) fn of_any(&self, from: f64, size: f64) -> Option<Peak> {
        if size < SHORTEST {
            return None;
        }
        let segment = LobeSegment::new(self, from, size)?;
        let lobe = segment.peak();
        if lobe.roughness.is_nan() || lobe.roughness > ROUGHEST {
            return None;
        }
        let (length, turn) = (self.order / size.to_radians(), lobe.turn / 2.0);
        let slopes = [
            turn * (1.0 - lobe.v) - length,
            turn * (1.0 + lobe.v) + length,
        ];
        Some(Peak {
            size: lobe.distance,
            slopes: slopes.map(f64::to_radians),
        })
    }

    /// Whether errors of this size are beyond what lobes tell well, beside the sharp ends at least.
    pub(super) fn is_rough(&self, error: f64) -> bool {
        error * self.flat > ROUGHEST
    }

    /// The largest distance of such a segment, however long it is.
    pub(super) fn size(&self, from: f64, size: f64) -> f64 {
        let segment = LobeSegment::new(self, from, size);
        segment.map_or(f64::INFINITY, |segment| segment.peak().distance)
    }

    /// The same up to an error: beyond it, that of the first lobe found there.
    pub(super) fn size_up_to(&self, from: f64, size: f64, allowed: f64) -> f64 {
        let Some(segment) = LobeSegment::new(self, from, size) else {
            return f64::INFINITY;
        };
        let (starts, count) = segment.starts();
        let mut most = 0.0_f64;
        for &v in &starts[..count] {
            let lobe = segment.at(v);
            // Most segments that are too long are already so before a step.
            let reached = if lobe.distance > allowed || lobe.top() <= allowed {
                lobe.distance
            } else {
                segment.climbed(lobe).distance
            };
            // What cannot be told is not within.
            most = if reached.is_nan() {
                f64::INFINITY
            } else {
                most.max(reached)
            };
            if most > allowed {
                break;
            }
        }
        most
    }

    /// The sizes of the segments from here on that cross the ellipse at its next sharp end, ascending.
    pub(super) fn crossing_sharp_end(&self, from: f64) -> impl Iterator<Item = f64> {
        let way = 180.0 - after_sharp_end(from);
        // F vanishes at v² = 1 + 4H/G, which hardly varies with the size.
        let segment = LobeSegment::new(self, from, 45.0);
        let excess = segment.map(|segment| segment.cubic.excess);
        let place = excess.map(|[h, g]| 1.0 + 4.0 * h / g);
        let place = place.filter(|&square| square > 0.0).map(f64::sqrt);
        let sizes = place.map(|v| [1.0, -1.0].map(|side| 2.0 * way / (1.0 + side * v)));
        sizes.into_iter().flatten()
    }

    /// Joints that lie as dense as the sixth root of the weight asks for, nearly, both ends included; `root` is that of the least weight.
    pub(super) fn spread(root: f64, from: f64, whole: f64, pieces: usize) -> Vec<f64> {
        let wave = 0.5 * (1.0 - root) / (1.0 + root);
        let lead = |degrees: f64| {
            let Vec2 { x, y } = Angle::from_degrees(from + degrees).direction();
            (2.0 * wave * x * y).to_degrees()
        };
        let (first, last) = (lead(0.0), lead(whole));
        let joint = |i: usize| {
            let part = i as f64 / pieces as f64;
            let evenly = whole * part - (first + (last - first) * part);
            evenly + lead(evenly + lead(evenly))
        };
        let mut ways = vec![0.0; pieces + 1];
        for (i, way) in ways.iter_mut().enumerate().skip(1) {
            *way = joint(i);
        }
        ways[pieces] = whole;
        ways
    }

    /// Whether a segment is short beside what it passes.
    fn is_tame(&self, from: f64, size: f64) -> bool {
        let after = after_sharp_end(from);
        let way = after.min(180.0 - after - size).max(0.0).to_radians();
        let size = size.to_radians();
        size * size <= LARGEST * LARGEST * (self.short * self.short + way * way)
    }
}

/// How many degrees after a sharp end this angle lies, the last one before it.
pub(super) fn after_sharp_end(from: f64) -> f64 {
    // Beside the first turn nothing is rounded either way.
    match from - 90.0 {
        after @ 0.0..180.0 => after,
        after @ -180.0..0.0 => after + 180.0,
        after => after.rem_euclid(180.0),
    }
}

/// A segment, seen from the middle of its angle.
struct LobeSegment {
    cubic: TouchingCubic,
    /// The direction of the middle from the short axis, and where the sharp end lies that it passes.
    middle: Vec2,
    sharp: Option<f64>,
    short: f64,
    flat: f64,
}

impl LobeSegment {
    fn new(lobes: &Lobes, from: f64, size: f64) -> Option<Self> {
        let sharp = 2.0 * (180.0 - after_sharp_end(from)) / size - 1.0;
        Some(Self {
            cubic: TouchingCubic::new(lobes.rule, size)?,
            middle: Angle::from_degrees(from + size / 2.0).direction(),
            sharp: Some(sharp).filter(|&sharp| sharp < 1.0),
            short: lobes.short,
            flat: lobes.flat,
        })
    }

    /// The extremes of the excess, and the sharp end; and how many they are.
    fn starts(&self) -> ([f64; MOST_LOBES], usize) {
        let (mut starts, mut count) = ([0.0; MOST_LOBES], 1);
        if let Some(outer) = self.cubic.outer() {
            (starts, count) = ([-outer, 0.0, outer, 0.0], 3);
        }
        if let Some(sharp) = self.sharp {
            starts[count] = sharp;
            count += 1;
        }
        (starts, count)
    }

    /// The largest distance.
    fn peak(&self) -> Lobe<f64> {
        let lobes = by_the_best(
            #[inline(always)]
            || self.climbed(self.at(Lanes(self.starts().0))),
        );
        let highest = (1..MOST_LOBES).fold(0, |highest, i| {
            let is_higher = lobes.distance.0[i] > lobes.distance.0[highest];
            if is_higher { i } else { highest }
        });
        Lobe {
            v: lobes.v.0[highest],
            distance: lobes.distance.0[highest],
            roughness: lobes.roughness.0[highest],
            gain: lobes.gain.0[highest],
            step: lobes.step.0[highest],
            turn: lobes.turn.0[highest],
        }
    }

    /// The extremes of the distance beside lobes, those of them at least that may turn out the highest.
    #[inline(always)]
    fn climbed<S: Real>(&self, mut lobes: Lobe<S>) -> Lobe<S> {
        let one = S::exact(1.0);
        for _ in 0..MOST_STEPS {
            let tops = lobes.top();
            let highest = (0..MOST_LOBES).fold(0.0, |highest, i| tops.lane(i).larger(highest));
            let promises = |i| lobes.gain.lane(i) >= GAIN && tops.lane(i) >= RIVAL * highest;
            if !(0..MOST_LOBES).any(promises) {
                break;
            }
            let next = (lobes.v + lobes.step).larger(one.scaled(-1.0));
            lobes = lobes.or_higher(self.at(next.smaller(one)));
        }
        lobes
    }

    /// The distances at places v, and what is known of them there.
    #[inline(always)]
    fn at<S: Real>(&self, v: S) -> Lobe<S> {
        #[cfg(test)]
        super::errors::LOOKS.set(super::errors::LOOKS.get() + 1);
        let TouchingCubic {
            sin, bulge, lean, ..
        } = self.cubic;
        let ([h, g], middle) = (self.cubic.excess, self.middle);
        let [none, one, half] = [0.0, 1.0, 0.5].map(S::exact);
        let turned = |x: S, y: S| {
            [
                x.scaled(middle.x) - y.scaled(middle.y),
                x.scaled(middle.y) + y.scaled(middle.x),
            ]
        };
        let square = v * v;
        let u = TouchingCubic::u(v);
        let [x, y] = self.cubic.point(v, u);
        let [x, y] = turned(x, y);
        let rising = S::exact(sin) + (u - square.scaled(0.5)).scaled(lean);
        let along = turned(v.scaled(-1.5 * bulge), rising);
        let steep = x.scaled(self.flat);
        let weight = steep * x + y * y;
        let excess = self.cubic.excess(u);
        // Two quotients for all: they cost most here.
        let (once, part) = (weight.reciprocal(), excess.reciprocal());
        let (root, twice) = (weight.sqrt() * once, once * once);
        let second = excess.scaled(0.25) * (steep * steep + y * y) * twice;
        let distance = (excess.scaled(0.5) * root * (one + second)).abs();
        let roughness = (distance * root * once).scaled(self.flat);
        let distance = distance.renewed(roughness, ROUGH, |i| {
            let radii = Vec2::new(self.short, 1.0);
            let place = Vec2::new(self.short * x.lane(i), y.lane(i));
            foot(radii, place).distance.abs()
        });
        let slant = half * u * (S::exact(2.0 * h) + u.scaled(3.0 * g));
        let rise = v * slant * part;
        let bend = (slant - half * square * (S::exact(h) + u.scaled(3.0 * g))) * part;
        let swing = self.flat - 1.0;
        let turn = (x * y * once).scaled(swing);
        // The second derivative of the weight's logarithm by the angle.
        let swung = ((x * x - y * y) * once).scaled(swing) + (turn * turn).scaled(2.0);
        // The derivatives of the distance's logarithm by v, the second nearly, and a step of Newton's method.
        let slope = rise - (steep * along[0] + y * along[1]) * once;
        let bend = bend - rise * rise + swung * (along[0] * along[0] + along[1] * along[1]);
        let newton = none - slope / bend;
        let [least, most] = [-STEP, STEP].map(S::exact);
        let step = bend.choose(
            newton.larger(least).smaller(most),
            slope.choose(least, most),
        );
        let gain = bend.choose(half * slope * newton, slope.abs().scaled(STEP));
        Lobe {
            v,
            distance,
            roughness,
            gain,
            step,
            turn,
        }
    }
}

/// A place on a segment beside an extreme of its distance.
#[derive(Clone, Copy)]
struct Lobe<S> {
    v: S,
    /// Its distance, and the product of that with the curvature of the ellipse there.
    distance: S,
    roughness: S,
    /// What the extreme promises more, as a part of the distance, and the way there.
    gain: S,
    step: S,
    /// The derivative of the weight's logarithm by the angle.
    turn: S,
}

impl<S: Real> Lobe<S> {
    /// The extreme, by what is known here.
    #[inline(always)]
    fn top(&self) -> S {
        let one = S::exact(1.0);
        self.distance * (one + self.gain.smaller(one))
    }

    /// Another place where it lies higher; else this one, which then has nothing more to gain.
    #[inline(always)]
    fn or_higher(self, other: Self) -> Self {
        let less = self.distance - other.distance;
        Self {
            v: less.choose(other.v, self.v),
            distance: less.choose(other.distance, self.distance),
            roughness: less.choose(other.roughness, self.roughness),
            gain: less.choose(other.gain, S::exact(0.0)),
            step: less.choose(other.step, S::exact(0.0)),
            turn: less.choose(other.turn, self.turn),
        }
    }
}

#[cfg(test)]
mod tests;
