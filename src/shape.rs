//! What is asked for: a circle, an ellipse or an arc, each a piece of the unit circle under an affine map.

pub mod endpoint;
mod frame;
pub mod machine;
mod outline;
mod svg_arc;

pub(crate) use frame::{Exact, conic_placement, decimals};
pub(crate) use outline::Axes;
pub use outline::{Outline, Truth, UnitArc, flattens};

use kurbo::{Point, Vec2};

use crate::angle::Angle;
use crate::error::{Error, Result, ShapeError, finite, positive};
pub(crate) use outline::{check_flatness, positive_radii};

/// A shape that can be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A whole circle.
    Circle(Circle),
    /// A whole ellipse.
    Ellipse(Ellipse),
    /// A part of a circle's or an ellipse's outline.
    Arc(Arc),
    /// What an arc becomes that has no radius, or that runs through points on a line.
    Line(Line),
    /// Nothing: an arc whose ends coincide, or without a sweep.
    Empty,
}

/// A whole circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub center: Point,
    /// Its radius, positive.
    pub radius: f64,
    /// Where it starts and ends.
    pub start: Angle,
    /// Whether it runs from +y towards +x.
    pub reverse: bool,
}

/// A whole ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    /// Its centre.
    pub center: Point,
    /// Its radii along its own axes, positive.
    pub radii: Vec2,
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: Angle,
    /// Where it starts and ends, a parametric angle: the point at angle A is (rx cos A, ry sin A), then rotated.
    pub start: Angle,
    /// Whether it runs against growing angles.
    pub reverse: bool,
}

/// A part of an ellipse's outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// The centre of the ellipse.
    pub center: Point,
    /// Its radii along its own axes, positive.
    pub radii: Vec2,
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: Angle,
    /// The parametric angle of the first point.
    pub start: Angle,
    /// How far it runs, at most one turn; negative against growing angles.
    pub sweep: Angle,
    /// The end points, where they are what was given: they are kept to the last digit.
    pub ends: Option<[Point; 2]>,
    /// What it was given by where it has ends.
    pub(crate) given: Given,
}

/// What gives an arc between two ends: its sweep in degrees is rounded in most cases.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Given {
    /// Its sweep.
    #[default]
    Sweep,
    /// Its radii; whether it takes the longer way.
    Radii { large: bool },
    /// These radii, which are too small: in truth they are as large as half a turn needs.
    Enlarged(Vec2),
    /// The tangent of a quarter of its sweep.
    Bulge(f64),
    /// A point between the ends, on a circle.
    Through(Point),
    /// A centre, which moves to the bisector of the chord.
    Center(Point),
    /// The point where the tangents at the ends meet, and its weight.
    Conic { control: Point, weight: f64 },
}

/// A straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Its first point.
    pub from: Point,
    /// Its last point.
    pub to: Point,
}

impl Circle {
    /// A circle that starts at angle 0 and runs in the positive direction.
    ///
    /// # Errors
    ///
    /// Where a number is not finite or the radius is not positive.
    pub fn new(center: impl Into<Point>, radius: f64) -> Result<Self> {
        let circle = Self {
            center: center.into(),
            radius,
            start: Angle::ZERO,
            reverse: false,
        };
        circle.check()?;
        Ok(circle)
    }

    fn check(&self) -> Result<()> {
        finite_point("centre", self.center)?;
        positive("radius", self.radius)?;
        finite("start angle", self.start.degrees())?;
        Ok(())
    }
}

/// Refuses the numbers of which no ellipse is drawn.
#[inline]
fn check_ellipse(center: Point, radii: Vec2, rotation: Angle, start: Angle) -> Result<()> {
    finite_point("centre", center)?;
    positive_radii(radii)?;
    finite("rotation", rotation.degrees())?;
    finite("start angle", start.degrees())?;
    Ok(())
}

impl Ellipse {
    /// An ellipse that starts at angle 0 and runs in the positive direction.
    ///
    /// # Errors
    ///
    /// Where a number is not finite or a radius is not positive.
    pub fn new(center: impl Into<Point>, radii: impl Into<Vec2>, rotation: Angle) -> Result<Self> {
        let ellipse = Self {
            center: center.into(),
            radii: radii.into(),
            rotation,
            start: Angle::ZERO,
            reverse: false,
        };
        ellipse.check()?;
        Ok(ellipse)
    }

    fn check(&self) -> Result<()> {
        check_ellipse(self.center, self.radii, self.rotation, self.start)
    }
}

impl Arc {
    /// The arc in centre form. A sweep within [`WHOLE_TURN`] of a whole turn is one, and the arc is closed.
    ///
    /// # Errors
    ///
    /// Where a number is not finite, a radius is not positive, or the sweep is more than a turn.
    pub fn new(
        center: impl Into<Point>,
        radii: impl Into<Vec2>,
        rotation: Angle,
        start: Angle,
        sweep: Angle,
    ) -> Result<Self> {
        let arc = Self {
            center: center.into(),
            radii: radii.into(),
            rotation,
            start,
            sweep: whole_turn(sweep),
            ends: None,
            given: Given::Sweep,
        };
        arc.check()?;
        Ok(arc)
    }

    /// Refuses what [`Arc::new`] does: every field is open.
    pub(crate) fn check(&self) -> Result<()> {
        check_ellipse(self.center, self.radii, self.rotation, self.start)?;
        let sweep = finite("sweep", self.sweep.degrees())?;
        if sweep.abs() > 360.0 {
            return Err(Error::Shape(ShapeError::Sweep(sweep)));
        }
        for end in self.ends.into_iter().flatten() {
            finite_point("end", end)?;
        }
        Ok(())
    }

    /// Its ellipse, by its centre.
    #[inline]
    pub(crate) fn truth(&self) -> Truth {
        Truth::new(self.center, self.radii, self.rotation.direction()).turned(self.rotation)
    }

    /// The piece of the unit circle and where it lies.
    #[must_use]
    pub fn outline(&self) -> Outline {
        let unit = UnitArc {
            start: within_reach(self.start),
            sweep: self.sweep,
            closed: self.is_closed(),
        };
        let truth = self.truth();
        let through = |ends| truth.through(ends, unit.sweep, self.given);
        let truth = self.ends.map_or(truth, through);
        Outline {
            unit,
            placement: truth.placement(),
            truth,
            ends: self.ends,
        }
    }

    /// Whether it ends where it starts.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.sweep.degrees().abs() == 360.0 && self.ends.is_none_or(|[from, to]| from == to)
    }

    /// The arc, or nothing where it has no sweep.
    #[must_use]
    pub fn shape(self) -> Shape {
        if self.sweep == Angle::ZERO {
            Shape::Empty
        } else {
            Shape::Arc(self)
        }
    }
}

/// By what part of a turn a sweep may differ from it and still mean it: angles come from sums of floats.
pub const WHOLE_TURN: f64 = 1e-7;

/// The sweep, or the whole turn that it means.
fn whole_turn(sweep: Angle) -> Angle {
    let turn = 360.0_f64.copysign(sweep.degrees());
    if (sweep.degrees() - turn).abs() <= WHOLE_TURN * 360.0 {
        Angle::from_degrees(turn)
    } else {
        sweep
    }
}

/// An angle to which others can be added without a loss that shows: whole turns are taken from one so large that its degrees have no digits
/// left for a millionth, which is exact.
fn within_reach(start: Angle) -> Angle {
    const FAR: f64 = 1e9;
    let degrees = start.degrees();
    if degrees.abs() < FAR {
        start
    } else {
        Angle::from_degrees(degrees % 360.0)
    }
}

impl Shape {
    /// Refuses the numbers that the constructors refuse: fields are open.
    pub(crate) fn check(&self) -> Result<()> {
        match self {
            Self::Circle(circle) => circle.check(),
            Self::Ellipse(ellipse) => ellipse.check(),
            Self::Arc(arc) => arc.check(),
            Self::Line(line) => [line.from, line.to]
                .into_iter()
                .try_for_each(|end| finite_point("end", end).map(drop)),
            Self::Empty => Ok(()),
        }
    }

    /// The piece of the unit circle and where it lies; `None` for a line and for nothing.
    #[must_use]
    pub fn outline(&self) -> Option<Outline> {
        let whole = |start, reverse, truth: Truth| {
            let degrees = if reverse { -360.0 } else { 360.0 };
            Some(Outline {
                unit: UnitArc {
                    start: within_reach(start),
                    sweep: Angle::from_degrees(degrees),
                    closed: true,
                },
                placement: truth.placement(),
                truth,
                ends: None,
            })
        };
        let truth = |center, radii, rotation: Angle| {
            Truth::new(center, radii, rotation.direction()).turned(rotation)
        };
        match *self {
            Self::Circle(c) => {
                let radii = Vec2::new(c.radius, c.radius);
                whole(c.start, c.reverse, truth(c.center, radii, Angle::ZERO))
            }
            Self::Ellipse(e) => whole(e.start, e.reverse, truth(e.center, e.radii, e.rotation)),
            Self::Arc(arc) => Some(arc.outline()),
            Self::Line(_) | Self::Empty => None,
        }
    }
}

#[inline]
fn finite_point(what: &'static str, p: Point) -> Result<Point> {
    Ok(Point::new(finite(what, p.x)?, finite(what, p.y)?))
}
