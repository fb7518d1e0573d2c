//! Arcs as cubics, one after the other and without an allocation: for programs that turn millions of arcs into curves.
//!
//! [`Arc::cubics`] and [`SvgArc::cubics`] give the fewest equal `minimax` segments within a tolerance; [`Arc::cubics_by`] and
//! [`SvgArc::cubics_by`] any number of them by any rule whose handles lie along the tangents. What they give are points in full;
//! rounding, adaptive joints on flat ellipses and the error of the result are [`crate::approximate()`]'s.
//!
//! Sines and cosines are taken once an arc. With R the radius vector of a joint, T the derivative by the parametric angle there and
//! δ the step, the next joint lies at
//!
//! ```text
//! D = T sin δ - R (1 - cos δ),   p' = p + D,   R' = R + D,   T' = T - R sin δ - T (1 - cos δ)
//! ```
//!
//! and 1 - cos δ = 2 sin²(δ/2) has no cancellation, so that a step errs by the rounding of small differences only. The centre
//! itself is never added, so that arcs of huge radius keep their digits. The last point is no sum where it was given, where the arc closes,
//! and at every multiple of 15 degrees: there it is the end itself.
//!
//! What is called for every arc is compiled into the caller, so that a processor works at the next arc before it is done with one.
//!
//! The count is found from below: the peak error of `minimax` is at least 1.29263358e-5 a⁶ at every angle a up to half a turn, and
//! its exact value decides whether one segment more is needed.

#![expect(
    clippy::inline_always,
    reason = "a tenth of the time of an arc, by `make bench`"
)]

use core::iter::FusedIterator;

use kurbo::{CubicBez, Point, Vec2};

use crate::angle::Angle;
use crate::error::{Error, Result};
use crate::joints::MOST_SEGMENTS;
use crate::method::{Method, Rule, Span};
use crate::number::digits::ROUNDING;
use crate::shape::endpoint::{Chord, SvgArc};
use crate::shape::{Arc, Truth};

/// (180/π)⁶ over 1.29263358e-5, the leading constant of `minimax`: its peak error falls to that times a⁶ as the angle a does.
const DEGREES_6: f64 = 2_736_909_018_401_684.5;

/// Half turns to a degree, less a trace that keeps rounding from adding a segment.
const HALF_TURNS: f64 = (1.0 - 1e-12) / 180.0;

/// The finest relative tolerance that is told from none at all.
const FINEST: f64 = 64.0 * f64::EPSILON;

/// The cubics of an arc, in order; each starts where the one before it ends.
#[derive(Debug, Clone)]
pub struct Cubics {
    /// The first point of the arc, and how far the current one has come from it.
    start: Point,
    way: Vec2,
    /// The current point, its radius vector and the derivative there.
    point: Point,
    radius: Vec2,
    tangent: Vec2,
    /// The last point and the derivative there, where they are no sum.
    end: Option<(Point, Vec2)>,
    /// sin δ, 1 - cos δ and the handle, of the sign of the sweep.
    sine: f64,
    versine: f64,
    handle: f64,
    left: usize,
}

impl Iterator for Cubics {
    type Item = CubicBez;

    #[inline]
    fn next(&mut self) -> Option<CubicBez> {
        if self.left == 0 {
            return None;
        }
        self.left -= 1;
        let (p0, t0) = (self.point, self.tangent);
        let (p3, t3) = if let (0, Some((end, tangent))) = (self.left, self.end) {
            (end, tangent)
        } else {
            let step = t0 * self.sine - self.radius * self.versine;
            let turned = t0 - (self.radius * self.sine + t0 * self.versine);
            self.radius += step;
            self.way += step;
            (self.start + self.way, turned)
        };
        (self.point, self.tangent) = (p3, t3);
        Some(CubicBez::new(
            p0,
            p0 + t0 * self.handle,
            p3 - t3 * self.handle,
            p3,
        ))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

impl ExactSizeIterator for Cubics {}
impl FusedIterator for Cubics {}

/// How an arc runs: all that the steps start from.
struct Course {
    truth: Truth,
    start: Point,
    /// The start on the unit circle.
    direction: Vec2,
    /// The end and its place on the unit circle, where they are known without a sum.
    end: Option<(Point, Vec2)>,
    /// In degrees.
    sweep: f64,
}

impl Course {
    #[inline(always)]
    fn of_arc(arc: &Arc) -> Self {
        let truth = arc.truth();
        let sweep = arc.sweep.degrees();
        let first = arc.start.direction();
        let last = arc.start.degrees() + sweep;
        // Where the last direction has a short form, as on the axes, it is met to the last digit.
        let last = if sweep.abs() == 360.0 {
            Some(first)
        } else if arc.ends.is_some() || nearest(last * (1.0 / 15.0)) == last * (1.0 / 15.0) {
            Some(Angle::from_degrees(last).direction())
        } else {
            None
        };
        let point = |d: Vec2| arc.center + truth.image(d);
        let [start, end] = arc
            .ends
            .map_or([None, None], |[start, end]| [Some(start), Some(end)]);
        Self {
            truth,
            start: start.unwrap_or_else(|| point(first)),
            direction: first,
            end: last.map(|last| (end.unwrap_or_else(|| point(last)), last)),
            sweep,
        }
    }

    #[inline]
    fn of_chord(arc: &SvgArc, chord: &Chord) -> Self {
        let [first, last] = chord.directions();
        Self {
            truth: chord.truth(),
            start: arc.from,
            direction: first,
            end: Some((arc.to, last)),
            sweep: chord.sweep,
        }
    }

    fn by(&self, rule: Rule, count: usize) -> Result<Cubics> {
        if count == 0 || count > MOST_SEGMENTS {
            return Err(Error::Count {
                count,
                most: MOST_SEGMENTS,
            });
        }
        let sees_ellipse = rule.method().is_some_and(Method::sees_ellipse);
        let span = Span::from_degrees(self.sweep / count as f64);
        let piece = rule.piece(&span)?;
        if piece.is_tangent_cubic() && (self.truth.is_circle() || !sees_ellipse) {
            return Ok(self.cubics(&Steps {
                count,
                span,
                handle: piece.handle.y,
            }));
        }
        Err(Error::Impossible {
            method: rule.id(),
            why: "its segments are no cubics with the same handles along the tangents".to_owned(),
            remedy: "approximate() draws by every method".to_owned(),
        })
    }

    #[inline(always)]
    fn cubics(&self, steps: &Steps) -> Cubics {
        let sign = 1.0_f64.copysign(self.sweep);
        let first = self.direction;
        let across = |d: Vec2| Vec2::new(-d.y, d.x);
        Cubics {
            start: self.start,
            way: Vec2::ZERO,
            point: self.start,
            radius: self.truth.image(first),
            tangent: self.truth.image(across(first)),
            end: self
                .end
                .map(|(end, last)| (end, self.truth.image(across(last)))),
            sine: sign * steps.span.s,
            versine: steps.span.versine(),
            handle: sign * steps.handle,
            left: steps.count,
        }
    }
}

/// Equal steps along an arc.
struct Steps {
    count: usize,
    span: Span,
    handle: f64,
}

impl Steps {
    /// The fewest `minimax` segments of so many degrees within a tolerance, in user units, on an ellipse of these radii.
    #[inline(always)]
    fn within(sweep: f64, radii: Vec2, tolerance: f64) -> Self {
        let tolerance = (tolerance / larger(radii.x, radii.y)).max(FINEST);
        let sweep = sweep.abs();
        let least = larger(
            sweep * inverse_sixth_root(tolerance * DEGREES_6),
            sweep * HALF_TURNS,
        );
        // Rounded up; what is a trace above a whole number is left to the exact error.
        let mut count = nearest(least + (0.5 - 1e-9)).max(1.0);
        // r² - 1 where r - 1 is the tolerance.
        let allowed = tolerance * (2.0 + tolerance);
        loop {
            let span = Span::of_quarter(0.25 * sweep / count);
            let (handle, square) = Method::minimax_with_square(&span);
            if square > allowed {
                count += 1.0;
                continue;
            }
            return Self {
                count: count as u32 as usize,
                span,
                handle,
            };
        }
    }
}

/// The larger of two numbers, with one instruction as neither is NaN.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The nearest whole number to one below 2^51.
#[inline]
fn nearest(x: f64) -> f64 {
    (x + ROUNDING) - ROUNDING
}

/// x^(-1/6) of a positive number, up to 0.5 % too small and never too large: one step of Newton's method, which comes from below,
/// from the bits of the number, of which a sixth is a sixth of its logarithm but for some hundredths.
#[inline]
fn inverse_sixth_root(x: f64) -> f64 {
    /// 7/6 of the bits of 1, less what centres the error.
    const BIAS: u64 = (0x3ff << 52) / 6 * 7 - (30 << 43);
    let guess = f64::from_bits(BIAS - x.to_bits() / 6);
    let cube = guess * guess * guess;
    guess * (7.0 - x * (cube * cube)) * (1.0 / 6.0)
}

impl Arc {
    /// The fewest `minimax` cubics of equal parametric angle within `tolerance` of the arc.
    ///
    /// # Tolerance
    ///
    /// The largest distance from the true arc, in user units. On an ellipse the bound is the error of the unit circle times the
    /// larger radius, so that flat ellipses come out finer than asked. The count grows with its -1/6 power. A tolerance that is
    /// finer than 64 units in the last place of the larger radius counts as that.
    ///
    /// ```
    /// use curveto::{Angle, Arc};
    /// let quarter = Arc::new((0.0, 0.0), (50.0, 50.0), Angle::ZERO, Angle::ZERO, Angle::from_degrees(90.0))?;
    /// assert_eq!(quarter.cubics(0.01).count(), 1);
    /// assert_eq!(quarter.cubics(1e-4).count(), 3);
    /// assert_eq!(quarter.cubics(1e-4).last().map(|cubic| cubic.p3), Some(kurbo::Point::new(0.0, 50.0)));
    /// # Ok::<(), curveto::Error>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn cubics(&self, tolerance: f64) -> Cubics {
        let steps = Steps::within(self.sweep.degrees(), self.radii, tolerance);
        Course::of_arc(self).cubics(&steps)
    }

    /// `count` cubics of equal parametric angle by a rule.
    ///
    /// # Errors
    ///
    /// As [`Method::piece`], where the rule's pieces are no cubics that touch the circle at both ends, and where the count is 0 or
    /// beyond [`MOST_SEGMENTS`].
    pub fn cubics_by(&self, rule: Rule, count: usize) -> Result<Cubics> {
        Course::of_arc(self).by(rule, count)
    }
}

impl SvgArc {
    /// The fewest `minimax` cubics of equal parametric angle within `tolerance` of the arc; see [`Arc::cubics`]. They begin and end
    /// on the given points, digit for digit. `None` where the arc is a line, or nothing, or not finite: [`SvgArc::shape`] tells which.
    #[inline]
    #[must_use]
    pub fn cubics(&self, tolerance: f64) -> Option<Cubics> {
        let chord = self.chord().ok().flatten()?;
        let course = Course::of_chord(self, &chord);
        let steps = Steps::within(course.sweep, course.truth.radii, tolerance);
        Some(course.cubics(&steps))
    }

    /// `count` cubics of equal parametric angle by a rule; `None` where the arc is a line or nothing.
    ///
    /// # Errors
    ///
    /// As [`Arc::cubics_by`] and [`SvgArc::shape`].
    pub fn cubics_by(&self, rule: Rule, count: usize) -> Result<Option<Cubics>> {
        self.chord()?
            .map(|chord| Course::of_chord(self, &chord).by(rule, count))
            .transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sixth_root_is_a_lower_bound() {
        for i in -14_000..5_000 {
            let x = 10_f64.powf(f64::from(i) / 1000.0);
            let ratio = inverse_sixth_root(x) * x.powf(1.0 / 6.0);
            assert!((0.995..1.0 + 1e-15).contains(&ratio), "{x} {ratio}");
        }
    }
}
