//! The columns of a block of arcs, and the loops down them.

#![expect(
    clippy::needless_range_loop,
    reason = "several columns of one length are read at once"
)]

use kurbo::Vec2;

use super::EllipsePoint;
use super::steps::{Steps, relative};
use crate::angle::{direction_within, first_direction};
use crate::joints::Tolerance;
use crate::shape::Truth;

/// How many arcs a block holds.
pub(super) const LANES: usize = 32;

pub(super) type Column = [f64; LANES];
pub(super) const COLUMN: Column = [1.0; LANES];

/// Vectors or points by their coordinates.
pub(super) type Pairs = [Column; 2];

#[inline(always)]
pub(super) fn pair([x, y]: &Pairs, i: usize) -> Vec2 {
    Vec2::new(x[i], y[i])
}

#[inline(always)]
pub(super) fn set([x, y]: &mut Pairs, i: usize, v: Vec2) {
    x[i] = v.x;
    y[i] = v.y;
}

/// The courses of the arcs of a block.
#[derive(Debug, Clone)]
pub struct Courses {
    /// Whether there is anything to draw.
    pub(super) is_drawn: [bool; LANES],
    pub(super) start: Frames,
    pub(super) end: Frames,
    count: Column,
    sine: Column,
    versine: Column,
    handle: Column,
    square: Column,
}

#[derive(Debug, Clone)]
pub(super) struct Frames {
    point: Pairs,
    radius: Pairs,
    tangent: Pairs,
}

impl Frames {
    pub(super) const NEW: Self = Self {
        point: [COLUMN; 2],
        radius: [COLUMN; 2],
        tangent: [COLUMN; 2],
    };

    #[inline(always)]
    pub(super) fn set(&mut self, i: usize, frame: &EllipsePoint) {
        set(&mut self.point, i, frame.point.to_vec2());
        set(&mut self.radius, i, frame.radius);
        set(&mut self.tangent, i, frame.tangent);
    }

    #[inline(always)]
    pub(super) fn at(&self, i: usize) -> EllipsePoint {
        EllipsePoint {
            point: pair(&self.point, i).to_point(),
            radius: pair(&self.radius, i),
            tangent: pair(&self.tangent, i),
        }
    }
}

impl Courses {
    pub(super) const NEW: Self = Self {
        is_drawn: [true; LANES],
        start: Frames::NEW,
        end: Frames::NEW,
        count: COLUMN,
        sine: COLUMN,
        versine: COLUMN,
        handle: COLUMN,
        square: COLUMN,
    };

    #[inline(always)]
    pub(super) fn count_steps(&mut self, sweep: &Column, radii: &Pairs, tolerance: Tolerance) {
        let mut relative = COLUMN;
        relative_tolerances(tolerance, radii, &mut relative);
        let tolerance = &relative;
        // Short loops, of which a processor works at several rounds at once.
        let mut quarters = [COLUMN; 2];
        for i in 0..LANES {
            self.count[i] = Steps::least(sweep[i], tolerance[i]);
        }
        for i in 0..LANES {
            let degrees = Steps::quarter(sweep[i], self.count[i]);
            set(&mut quarters, i, first_direction(degrees));
        }
        for i in 0..LANES {
            let steps = Steps::by_quarter(sweep[i], self.count[i], pair(&quarters, i));
            self.set_steps(i, &steps);
        }
        for i in 0..LANES {
            let steps = self.steps(i);
            if !steps.serve(tolerance[i]) {
                self.set_steps(i, &steps.refined(sweep[i], tolerance[i]));
            }
        }
    }

    #[inline(always)]
    fn set_steps(&mut self, i: usize, steps: &Steps) {
        self.count[i] = steps.count;
        self.sine[i] = steps.sine;
        self.versine[i] = steps.versine;
        self.handle[i] = steps.handle;
        self.square[i] = steps.square;
    }

    #[inline(always)]
    pub(super) fn steps(&self, i: usize) -> Steps {
        Steps {
            count: self.count[i],
            sine: self.sine[i],
            versine: self.versine[i],
            handle: self.handle[i],
            square: self.square[i],
        }
    }
}

/// The tolerance of every arc as a part of its larger radius.
#[inline(always)]
fn relative_tolerances(tolerance: Tolerance, radii: &Pairs, out: &mut Column) {
    for i in 0..LANES {
        let radii = pair(radii, i);
        let larger = radii.x.max(radii.y);
        out[i] = relative(tolerance.for_radius(larger), radii);
    }
}

#[inline(always)]
pub(super) fn directions(degrees: &Column, out: &mut Pairs) {
    for i in 0..LANES {
        set(out, i, direction_within(degrees[i]));
    }
}

#[inline(always)]
pub(super) fn frames([center, radii, axis, direction]: [&Pairs; 4], out: &mut Frames) {
    for i in 0..LANES {
        let truth = Truth::new(pair(center, i).to_point(), pair(radii, i), pair(axis, i));
        out.set(i, &EllipsePoint::at(&truth, pair(direction, i)));
    }
}
