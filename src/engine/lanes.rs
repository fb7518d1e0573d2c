//! Many arcs at once.
//!
//! A block of arcs has a column of numbers for each quantity. Loops run down the columns through the functions that a single arc
//! runs through, which take no branch, so that the compiler makes them loops over vectors. Nothing is fused or reordered in them: the
//! cubics have the bits of the single form on every processor.

#![expect(
    clippy::needless_range_loop,
    reason = "several columns of one length are read at once"
)]

use core::iter::FusedIterator;

#[cfg(all(feature = "simd", target_arch = "x86_64"))]
use fearless_simd::{Level, Simd as _};

use super::columns::{COLUMN, Column, Courses, LANES, directions, frames, pair, set};
use super::{ArcEnd, ArcRun, Cubics, EllipsePoint, sweep_of};
use crate::angle::Angle;
use crate::joints::Tolerance;
use crate::shape::endpoint::{Half, SvgArc};
use crate::shape::{Arc, positive_radii};

/// The columns of a block of arcs in centre form.
#[inline(always)]
fn fill_arcs(courses: &mut Courses, arcs: &[Arc], tolerance: Tolerance) {
    let [mut rotation, mut first, mut last, mut sweep] = [COLUMN; 4];
    let [mut center, mut radii, mut axis, mut direction] = [[COLUMN; 2]; 4];
    let mut ends_known = false;
    for (i, arc) in arcs.iter().take(LANES).enumerate() {
        set(&mut center, i, arc.center.to_vec2());
        set(&mut radii, i, arc.radii);
        rotation[i] = arc.rotation.within_turn();
        first[i] = arc.start.within_turn();
        sweep[i] = sweep_of(arc);
        let end = match ArcEnd::of(arc) {
            ArcEnd::Start => Some(arc.start),
            ArcEnd::Angle(end) => Some(end),
            ArcEnd::Unknown => None,
        };
        if let Some(end) = end {
            last[i] = end.within_turn();
            ends_known = true;
        }
    }
    directions(&rotation, &mut axis);
    directions(&first, &mut direction);
    frames([&center, &radii, &axis, &direction], &mut courses.start);
    if ends_known {
        directions(&last, &mut direction);
        frames([&center, &radii, &axis, &direction], &mut courses.end);
    }
    courses.count_steps(&sweep, &radii, tolerance);
}

/// The columns of a block of arcs by their end points.
#[inline(always)]
fn fill_svg_arcs(courses: &mut Courses, arcs: &[SvgArc], tolerance: Tolerance) {
    let [mut rotation, mut large, mut positive] = [COLUMN; 3];
    let [mut size, mut depth, mut sweep] = [COLUMN; 3];
    let [mut from, mut to, mut given, mut axis, mut along, mut radii] = [[COLUMN; 2]; 6];
    for (i, arc) in arcs.iter().take(LANES).enumerate() {
        courses.is_drawn[i] = arc.check().is_ok() && !arc.is_straight();
        if !courses.is_drawn[i] {
            continue;
        }
        set(&mut from, i, arc.from.to_vec2());
        set(&mut to, i, arc.to.to_vec2());
        set(&mut given, i, arc.near_chord().radii);
        rotation[i] = arc.rotation.within_turn();
        large[i] = f64::from(arc.large_arc);
        positive[i] = f64::from(arc.sweep);
    }
    directions(&rotation, &mut axis);
    let arc = |i: usize| SvgArc {
        from: pair(&from, i).to_point(),
        radii: pair(&given, i),
        rotation: Angle::from_degrees(rotation[i]),
        large_arc: large[i] != 0.0,
        sweep: positive[i] != 0.0,
        to: pair(&to, i).to_point(),
    };
    for i in 0..LANES {
        let half = Half::new(&arc(i), pair(&axis, i));
        set(&mut along, i, half.along);
        size[i] = half.size;
        depth[i] = half.depth;
    }
    let half = |i: usize, depth: &Column| Half {
        axis: pair(&axis, i),
        along: pair(&along, i),
        size: size[i],
        depth: depth[i],
    };
    for i in 0..LANES {
        if half(i, &depth).lacks_digits() {
            depth[i] = half(i, &depth).with_all_digits(&arc(i)).depth;
        }
    }
    for i in 0..LANES {
        let chord = half(i, &depth).chord(&arc(i));
        let truth = chord.truth();
        let [start, end] = chord.directions();
        courses.start.set(i, &EllipsePoint::at(&truth, start));
        courses.end.set(i, &EllipsePoint::at(&truth, end));
        sweep[i] = chord.sweep;
        set(&mut radii, i, chord.radii);
    }
    for (i, is_drawn) in courses.is_drawn.iter_mut().enumerate() {
        *is_drawn &= positive_radii(pair(&radii, i)).is_ok() && size[i] > 0.0;
    }
    courses.count_steps(&sweep, &radii, tolerance);
}

/// An arc in either form.
pub trait Lane: Sized {
    /// Its cubics, with `None` where there may be nothing to draw.
    type Cubics;
    /// The courses of a block's arcs; there may be more arcs than belong to it.
    fn fill(courses: &mut Courses, arcs: &[Self], tolerance: Tolerance);
    /// The cubics of the arc in this lane.
    fn cubics(&self, courses: &Courses, lane: usize) -> Self::Cubics;
}

impl Lane for Arc {
    type Cubics = Cubics;

    #[inline(always)]
    fn fill(courses: &mut Courses, arcs: &[Self], tolerance: Tolerance) {
        fill_arcs(courses, arcs, tolerance);
    }

    #[inline(always)]
    fn cubics(&self, courses: &Courses, lane: usize) -> Cubics {
        let end = match ArcEnd::of(self) {
            ArcEnd::Unknown => None,
            ArcEnd::Start | ArcEnd::Angle(_) => Some(courses.end.at(lane)),
        };
        let start = courses.start.at(lane);
        let course = ArcRun { start, end }.through(self.ends);
        course.cubics(&courses.steps(lane))
    }
}

impl Lane for SvgArc {
    type Cubics = Option<Cubics>;

    #[inline(always)]
    fn fill(courses: &mut Courses, arcs: &[Self], tolerance: Tolerance) {
        fill_svg_arcs(courses, arcs, tolerance);
    }

    #[inline(always)]
    fn cubics(&self, courses: &Courses, lane: usize) -> Option<Cubics> {
        if !courses.is_drawn[lane] {
            return None;
        }
        let course = ArcRun {
            start: courses.start.at(lane),
            end: Some(courses.end.at(lane)),
        };
        let course = course.through(Some([self.from, self.to]));
        Some(course.cubics(&courses.steps(lane)))
    }
}

/// What the loops are compiled for. Without the feature `simd`, and elsewhere than on x86-64, the target alone decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Instructions {
    /// What every processor of the target has.
    Target,
    /// AVX2.
    Avx2,
    /// AVX-512.
    Avx512,
}

/// The cubics of many arcs, arc by arc; see [`cubics_of_arcs`] and [`cubics_of_svg_arcs`].
#[derive(Debug, Clone)]
pub struct ManyCubics<'a, A> {
    arcs: &'a [A],
    next: usize,
    tolerance: Tolerance,
    courses: Courses,
    instructions: Instructions,
}

/// As [`Arc::cubics`] for each of many arcs, in their order and bit for bit, in a fraction of the time.
///
/// ```
/// use curveto::engine::cubics_of_arcs;
/// use curveto::{Angle, Arc, Tolerance};
/// let quarter = Arc::new((0.0, 0.0), (50.0, 50.0), Angle::ZERO, Angle::ZERO, Angle::from_degrees(90.0))?;
/// for cubics in cubics_of_arcs(&[quarter; 10], Tolerance::Absolute(0.01)) {
///     for cubic in cubics {
///         println!("{} {} {} {}", cubic.p0, cubic.p1, cubic.p2, cubic.p3);
///     }
/// }
/// # Ok::<(), curveto::Error>(())
/// ```
#[must_use]
pub fn cubics_of_arcs(arcs: &[Arc], tolerance: Tolerance) -> ManyCubics<'_, Arc> {
    ManyCubics::new(arcs, tolerance)
}

/// As [`SvgArc::cubics`] for each of many arcs, in their order and bit for bit, in a fraction of the time.
#[must_use]
pub fn cubics_of_svg_arcs(arcs: &[SvgArc], tolerance: Tolerance) -> ManyCubics<'_, SvgArc> {
    ManyCubics::new(arcs, tolerance)
}

impl<'a, A: Lane> ManyCubics<'a, A> {
    const fn new(arcs: &'a [A], tolerance: Tolerance) -> Self {
        Self {
            arcs,
            next: 0,
            tolerance,
            courses: Courses::NEW,
            instructions: Instructions::Avx512,
        }
    }

    /// By these instructions at most, where the default is what the processor has. The cubics are the same; measurements and tests
    /// have a use for it.
    #[must_use]
    pub const fn at_most(mut self, instructions: Instructions) -> Self {
        self.instructions = instructions;
        self
    }

    #[cfg(all(feature = "simd", target_arch = "x86_64"))]
    #[inline(never)]
    fn fill(&mut self) {
        let (courses, arcs, tolerance) =
            (&mut self.courses, &self.arcs[self.next..], self.tolerance);
        let level = Level::new();
        if self.instructions >= Instructions::Avx512
            && let Some(level) = level.as_avx512()
        {
            return level.vectorize(
                #[inline(always)]
                || A::fill(courses, arcs, tolerance),
            );
        }
        if self.instructions >= Instructions::Avx2
            && let Some(level) = level.as_avx2()
        {
            return level.vectorize(
                #[inline(always)]
                || A::fill(courses, arcs, tolerance),
            );
        }
        A::fill(courses, arcs, tolerance);
    }

    #[cfg(not(all(feature = "simd", target_arch = "x86_64")))]
    #[inline(never)]
    fn fill(&mut self) {
        A::fill(&mut self.courses, &self.arcs[self.next..], self.tolerance);
    }
}

impl<A: Lane> Iterator for ManyCubics<'_, A> {
    type Item = A::Cubics;

    #[inline(always)]
    fn next(&mut self) -> Option<A::Cubics> {
        let arc = self.arcs.get(self.next)?;
        let lane = self.next % LANES;
        if lane == 0 {
            self.fill();
        }
        self.next += 1;
        Some(arc.cubics(&self.courses, lane))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.arcs.len() - self.next;
        (left, Some(left))
    }
}

impl<A: Lane> ExactSizeIterator for ManyCubics<'_, A> {}
impl<A: Lane> FusedIterator for ManyCubics<'_, A> {}
