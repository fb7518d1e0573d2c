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
//! [`cubics_of_arcs`] and [`cubics_of_svg_arcs`] take many arcs at once and give the same in a fraction of the time.
//!
//! What is called for every arc is compiled into the caller, so that a processor works at the next arc before it is done with one.

mod columns;
mod lanes;
mod steps;

use core::iter::FusedIterator;

use kurbo::{CubicBez, Point, Vec2};

use crate::angle::Angle;
use crate::curve::with_handles;
use crate::error::Result;
use crate::method::Rule;
use crate::shape::endpoint::{Chord, SvgArc};
use crate::shape::{Arc, Truth};

use steps::{Steps, nearest, relative};

pub use lanes::{Instructions, ManyCubics, cubics_of_arcs, cubics_of_svg_arcs};

/// The cubics of an arc, in order; each starts where the one before it ends.
#[derive(Debug, Clone)]
pub struct Cubics {
    /// The first point of the arc, and how far the current one has come from it.
    start: Point,
    offset: Vec2,
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
            self.offset += step;
            (self.start + self.offset, turned)
        };
        (self.point, self.tangent) = (p3, t3);
        let handles = [t0 * self.handle, t3 * self.handle];
        Some(with_handles([p0, p3], handles))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

impl ExactSizeIterator for Cubics {}
impl FusedIterator for Cubics {}

/// A point of an ellipse with its radius vector and the derivative by the parametric angle.
#[derive(Debug, Clone, Copy)]
struct EllipsePoint {
    point: Point,
    radius: Vec2,
    tangent: Vec2,
}

impl EllipsePoint {
    /// At this direction on the unit circle. Without a branch.
    #[inline(always)]
    fn at(truth: &Truth, direction: Vec2) -> Self {
        let radius = truth.image(direction);
        Self {
            point: truth.center + radius,
            radius,
            tangent: truth.image(Vec2::new(-direction.y, direction.x)),
        }
    }
}

/// How an arc runs: all that the steps start from.
struct ArcRun {
    start: EllipsePoint,
    /// Where it is known without a sum.
    end: Option<EllipsePoint>,
}

impl ArcRun {
    #[inline(always)]
    fn of_arc(arc: &Arc) -> Self {
        let truth = arc.truth();
        let start = EllipsePoint::at(&truth, arc.start.direction());
        let end = match ArcEnd::of(arc) {
            ArcEnd::Start => Some(start),
            ArcEnd::Angle(angle) => Some(EllipsePoint::at(&truth, angle.direction())),
            ArcEnd::Unknown => None,
        };
        Self { start, end }.through(arc.ends)
    }

    #[inline(always)]
    fn of_chord(arc: &SvgArc, chord: &Chord) -> Self {
        let truth = chord.truth();
        let [start, end] = chord.directions().map(|end| EllipsePoint::at(&truth, end));
        let end = Some(end);
        Self { start, end }.through(Some([arc.from, arc.to]))
    }

    /// The course through ends that were given, to the last digit.
    #[inline(always)]
    fn through(mut self, ends: Option<[Point; 2]>) -> Self {
        if let Some([from, to]) = ends {
            self.start.point = from;
            if let Some(end) = &mut self.end {
                end.point = to;
            }
        }
        self
    }

    #[inline(always)]
    fn cubics(&self, steps: &Steps) -> Cubics {
        Cubics {
            start: self.start.point,
            offset: Vec2::ZERO,
            point: self.start.point,
            radius: self.start.radius,
            tangent: self.start.tangent,
            end: self.end.map(|end| (end.point, end.tangent)),
            sine: steps.sine,
            versine: steps.versine,
            handle: steps.handle,
            left: steps.count as u32 as usize,
        }
    }
}

/// How far an arc runs, in degrees: every field is open, and beyond a turn there is nothing more to draw.
#[inline(always)]
fn sweep_of(arc: &Arc) -> f64 {
    let sweep = arc.sweep.degrees();
    if sweep.abs() <= 360.0 {
        sweep
    } else {
        360.0_f64.copysign(sweep)
    }
}

/// Where an arc ends, as far as it is known without a sum.
enum ArcEnd {
    /// Where it starts.
    Start,
    Angle(Angle),
    Unknown,
}

impl ArcEnd {
    #[inline(always)]
    fn of(arc: &Arc) -> Self {
        let sweep = sweep_of(arc);
        let last = arc.start.degrees() + sweep;
        if sweep.abs() == 360.0 {
            Self::Start
        } else if arc.ends.is_some() || nearest(last * (1.0 / 15.0)) == last * (1.0 / 15.0) {
            // Where the last direction has a short form, as on the axes, it is met to the last digit.
            Self::Angle(Angle::from_degrees(last))
        } else {
            Self::Unknown
        }
    }
}

impl Arc {
    /// The fewest `minimax` cubics of equal parametric angle within `tolerance` of the arc. A sweep of more than a turn, or of no number,
    /// counts as a whole one.
    ///
    /// # Tolerance
    ///
    /// The largest distance from the true arc, in user units. On an ellipse the bound is the error of the unit circle times the
    /// larger radius, so that flat ellipses come out finer than asked. The count grows with its -1/6 power. A tolerance that is
    /// finer than 64 units in the last place of the larger radius, 0 or negative or no number counts as that.
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
        let tolerance = relative(tolerance, self.radii);
        ArcRun::of_arc(self).cubics(&Steps::within(sweep_of(self), tolerance))
    }

    /// `count` cubics of equal parametric angle by a rule.
    ///
    /// # Errors
    ///
    /// As [`Method::piece`](crate::method::Method::piece), where the rule's pieces are no cubics that touch the circle at both ends, and where the count is 0 or
    /// beyond [`MOST_SEGMENTS`](crate::joints::MOST_SEGMENTS).
    pub fn cubics_by(&self, rule: Rule, count: usize) -> Result<Cubics> {
        let is_circle = self.radii.x == self.radii.y;
        let steps = Steps::by(rule, count, sweep_of(self), is_circle)?;
        Ok(ArcRun::of_arc(self).cubics(&steps))
    }
}

impl SvgArc {
    /// The fewest `minimax` cubics of equal parametric angle within `tolerance` of the arc; see [`Arc::cubics`]. They begin and end
    /// on the given points, digit for digit. `None` where the arc is a line, or nothing, or not finite: [`SvgArc::shape`] tells which.
    #[inline]
    #[must_use]
    pub fn cubics(&self, tolerance: f64) -> Option<Cubics> {
        let chord = self.chord().ok().flatten()?;
        let steps = Steps::within(chord.sweep, relative(tolerance, chord.radii));
        Some(ArcRun::of_chord(self, &chord).cubics(&steps))
    }

    /// `count` cubics of equal parametric angle by a rule; `None` where the arc is a line or nothing.
    ///
    /// # Errors
    ///
    /// As [`Arc::cubics_by`] and [`SvgArc::shape`].
    pub fn cubics_by(&self, rule: Rule, count: usize) -> Result<Option<Cubics>> {
        let Some(chord) = self.chord()? else {
            return Ok(None);
        };
        let steps = Steps::by(rule, count, chord.sweep, chord.truth().is_circle())?;
        Ok(Some(ArcRun::of_chord(self, &chord).cubics(&steps)))
    }
}
