//! Arcs given by their end points: the SVG form (SVG 2, appendix B.2, whose equation numbers are cited), three points, the DXF bulge.

use kurbo::{Point, Vec2};
use svgtypes::{PathParser, PathSegment};

use super::{Arc, Line, Shape, Truth, finite_point, positive_radii};
use crate::angle::{Angle, quadrant_degrees};
use crate::error::{Error, Result, finite, positive};
use crate::number::decimal_sum;
use crate::numeric::double::Double;

/// An arc as SVG path data gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SvgArc {
    /// The current point.
    pub from: Point,
    /// The radii, of any sign; zero makes it a line.
    pub radii: Vec2,
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: Angle,
    /// Whether it takes the longer way.
    pub large_arc: bool,
    /// Whether it runs in the direction of growing angles.
    pub sweep: bool,
    /// The last point.
    pub to: Point,
}

impl SvgArc {
    /// The arc of a command of path data that begins at `from`; `None` where it is another command.
    pub(crate) fn of_segment(from: Point, segment: PathSegment) -> Option<Self> {
        #[rustfmt::skip]
        let PathSegment::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } = segment else {
            return None;
        };
        let to = if abs {
            Point::new(x, y)
        } else {
            Point::new(decimal_sum(from.x, x), decimal_sum(from.y, y))
        };
        Some(Self {
            from,
            radii: Vec2::new(rx, ry),
            rotation: Angle::from_degrees(x_axis_rotation),
            large_arc,
            sweep,
            to,
        })
    }

    /// The arc in centre form, by the rules for parameters out of range: equal ends are nothing, a zero radius is a line,
    /// negative radii count as positive, radii too small are scaled up.
    ///
    /// # Errors
    ///
    /// Where a number is not finite or too large, or the ellipse too flat.
    pub fn shape(&self) -> Result<Shape> {
        let Some(chord) = self.chord()? else {
            let (from, to) = (self.from, self.to);
            return Ok(if from == to {
                Shape::Empty
            } else {
                Shape::Line(Line { from, to })
            });
        };
        let truth = chord.truth();
        let [start, _] = chord.directions();
        Ok(Shape::Arc(Arc {
            center: truth.center,
            radii: truth.radii,
            rotation: self.rotation,
            start: Angle::from_radians(libm::atan2(start.y, start.x)),
            sweep: Angle::from_degrees(chord.sweep),
            ends: Some([self.from, self.to]),
        }))
    }

    /// The arc as its chord sees it; `None` where it is a line or nothing.
    #[inline]
    pub(crate) fn chord(&self) -> Result<Option<Chord>> {
        self.check()?;
        if self.is_straight() {
            return Ok(None);
        }
        let half = Half::new(self, self.rotation.direction()).with_all_digits(self);
        let chord = half.chord(self);
        positive_radii(chord.radii)?;
        Ok(Some(chord))
    }

    /// Refuses numbers that are not finite, or too large.
    #[inline]
    pub(crate) fn check(&self) -> Result<()> {
        finite_point("start point", self.from)?;
        finite_point("end point", self.to)?;
        finite("radius", self.radii.x)?;
        finite("radius", self.radii.y)?;
        finite("rotation", self.rotation.degrees())?;
        Ok(())
    }

    /// Whether it is a line or nothing.
    #[inline]
    pub(crate) fn is_straight(&self) -> bool {
        self.from == self.to || self.radii.x == 0.0 || self.radii.y == 0.0
    }
}

/// Half the chord of an arc in the frame where its ellipse is the unit circle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Half {
    pub(crate) axis: Vec2,
    /// From the middle of the chord to the start, and its size.
    pub(crate) along: Vec2,
    pub(crate) size: f64,
    /// How far the centre is from the chord.
    pub(crate) depth: f64,
}

impl Half {
    /// Without a branch, as all that follows but [`Self::with_all_digits`].
    #[inline(always)]
    pub(crate) fn new(arc: &SvgArc, axis: Vec2) -> Self {
        // (5.1) in the frame of the ellipse's axes, (6.1) divided by the radii.
        let half = (arc.from - arc.to) / 2.0;
        let along = Vec2::new(
            (axis.x * half.x + axis.y * half.y) / arc.radii.x.abs(),
            (axis.x * half.y - axis.y * half.x) / arc.radii.y.abs(),
        );
        let size = along.hypot();
        let square = (1.0 - size) * (1.0 + size);
        Self {
            axis,
            along,
            size,
            depth: if square > 0.0 { square } else { 0.0 }.sqrt(),
        }
    }

    /// Near a semicircle, with the digits of the depth that cancelled.
    #[inline(always)]
    pub(crate) fn with_all_digits(self, arc: &SvgArc) -> Self {
        if self.lacks_digits() {
            Self {
                depth: depth_of(arc.from, arc.to, self.axis, arc.radii),
                ..self
            }
        } else {
            self
        }
    }

    #[inline(always)]
    pub(crate) fn lacks_digits(&self) -> bool {
        self.size > NEARLY_SEMICIRCLE && self.size < 1.0
    }

    #[inline(always)]
    pub(crate) fn chord(&self, arc: &SvgArc) -> Chord {
        // (6.2), (6.3): radii too small are scaled up, and the centre is the middle of the chord.
        let too_small = self.size >= 1.0;
        let (within, scale) = if too_small {
            (1.0, self.size)
        } else {
            (self.size, 1.0)
        };
        // (5.5), (5.6): twice the angle whose sine is half the chord.
        let short = 2.0 * quadrant_degrees(within, self.depth);
        let long = if too_small { 180.0 } else { 360.0 - short };
        let size = if arc.large_arc { long } else { short };
        let side = if arc.large_arc == arc.sweep {
            -1.0
        } else {
            1.0
        };
        let direction = self.along / self.size;
        Chord {
            middle: arc.from.midpoint(arc.to),
            radii: Vec2::new(arc.radii.x.abs(), arc.radii.y.abs()) * scale,
            axis: self.axis,
            along: direction * within,
            across: Vec2::new(direction.y, -direction.x) * (side * self.depth),
            sweep: if arc.sweep { size } else { -size },
        }
    }
}

/// The part of the diameter from which on 1 - size² loses digits.
const NEARLY_SEMICIRCLE: f64 = 0.99;

/// The distance of the chord from the centre on the unit circle, with the digits that cancel near a semicircle.
fn depth_of(from: Point, to: Point, axis: Vec2, radii: Vec2) -> f64 {
    let half = [(from.x, to.x), (from.y, to.y)].map(|(a, b)| Double::difference(a, b).scaled(0.5));
    let along = half[0].scaled(axis.x).plus(half[1].scaled(axis.y));
    let across = half[0].scaled(-axis.y).plus(half[1].scaled(axis.x));
    let (x, y) = (along.over(radii.x.abs()), across.over(radii.y.abs()));
    let square = x.times(x).plus(y.times(y));
    let rest = Double::difference(1.0, 0.0).plus(square.scaled(-1.0));
    rest.value().max(0.0).sqrt()
}

/// An elliptical arc by its chord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Chord {
    middle: Point,
    /// The radii, large enough.
    pub(crate) radii: Vec2,
    axis: Vec2,
    /// Half the chord on the unit circle, from its middle to the start.
    along: Vec2,
    /// From the chord's middle on the unit circle to the centre (5.2).
    across: Vec2,
    /// In degrees, with its sign.
    pub(crate) sweep: f64,
}

impl Chord {
    /// The ellipse.
    #[inline(always)]
    pub(crate) fn truth(&self) -> Truth {
        let truth = Truth::new(self.middle, self.radii, self.axis);
        Truth {
            center: self.middle + truth.image(self.across),
            ..truth
        }
    }

    /// The ends on the unit circle.
    #[inline(always)]
    pub(crate) fn directions(&self) -> [Vec2; 2] {
        [self.along - self.across, -self.along - self.across]
    }
}

/// The arc of path data `M x y A rx ry rotation large sweep x y`, in any form that the grammar of SVG allows.
///
/// # Errors
///
/// [`Error::Syntax`] with the column where it does not parse, and where it is not one moveto and one arc.
pub fn parse_svg_arc(text: &str) -> Result<SvgArc> {
    const MOVETO: &str = "a moveto 'M x y'";
    let wrong = |why: &str| unexpected(text, 1, why.to_owned());
    let mut segments = PathParser::from(text);
    let mut next = |expected: &str| {
        let segment = segments.next().transpose();
        segment.map_err(|error| misread(text, &error, expected))
    };
    let Some(PathSegment::MoveTo { x, y, .. }) = next(MOVETO)? else {
        return Err(wrong(&format!("expected {MOVETO}")));
    };
    let arc = next("an arc 'A rx ry rotation large sweep x y'")?
        .and_then(|segment| SvgArc::of_segment(Point::new(x, y), segment))
        .ok_or_else(|| {
            wrong("expected one arc 'A rx ry rotation large sweep x y' after the moveto")
        })?;
    match next("the end")? {
        None => Ok(arc),
        Some(_) => Err(wrong("expected one arc and nothing after it")),
    }
}

/// An error of the reader of path data, where something else was `expected`.
fn misread(text: &str, error: &svgtypes::Error, expected: &str) -> Error {
    let column = match *error {
        svgtypes::Error::UnexpectedEndOfStream => {
            let why = format!("it ends where {expected} should go on");
            return unexpected(text, text.chars().count() + 1, why);
        }
        svgtypes::Error::UnexpectedData(at)
        | svgtypes::Error::InvalidNumber(at)
        | svgtypes::Error::InvalidChar(_, at)
        | svgtypes::Error::InvalidString(_, at) => at,
        _ => 1,
    };
    unexpected(text, column, format!("expected {expected}"))
}

fn unexpected(text: &str, column: usize, why: String) -> Error {
    Error::Syntax {
        what: "the SVG arc",
        text: text.to_owned(),
        column,
        why,
    }
}

/// The arc from `from` through `on` to `to`; a line where the three lie on one, in that order; the whole circle on the diameter
/// from `from` to `on` where the ends are the same.
///
/// # Errors
///
/// Where `on` is one of the ends, and where they lie on a line with `on` outside.
pub fn through(from: Point, on: Point, to: Point) -> Result<Shape> {
    for p in [from, on, to] {
        finite_point("point", p)?;
    }
    if from == to && from != on {
        return full_circle(from, from.midpoint(on), false);
    }
    if from == on || on == to {
        let which = if from == on && on == to {
            "three points are the same"
        } else {
            "two of the three points are the same"
        };
        return Err(Error::Shape(format!("no arc is determined: {which}")));
    }
    let (u, v) = (from - on, to - on);
    let [cross, dot] = products_about(on, from, to);
    // What rounding alone can make of the cross product of points on a line.
    let largest = [from, on, to]
        .iter()
        .flat_map(|p| [p.x.abs(), p.y.abs()])
        .fold(0.0, f64::max);
    if cross.abs() <= 4.0 * f64::EPSILON * largest * (u.hypot() + v.hypot()) {
        if dot > 0.0 {
            return Err(Error::Shape(
                "no arc is determined: the three points lie on a line, and the second is not between the others".to_owned(),
            ));
        }
        return Ok(Shape::Line(Line { from, to }));
    }
    // The inscribed angle at `on` is half of what the arc leaves of the turn; the bulge is tan(sweep/4).
    let bulge = libm::tan(libm::atan2(cross.abs(), -dot) / 2.0);
    from_bulge(from, to, if cross > 0.0 { -bulge } else { bulge })
}

/// (from - on) × (to - on) and (from - on)·(to - on) to the last digit: they cancel for points near a line, and on a semicircle.
fn products_about(on: Point, from: Point, to: Point) -> [f64; 2] {
    let arm = |p: Point| [Double::difference(p.x, on.x), Double::difference(p.y, on.y)];
    let ([ux, uy], [vx, vy]) = (arm(from), arm(to));
    let cross = ux.times(vy).plus(uy.times(vx).scaled(-1.0));
    let dot = ux.times(vx).plus(uy.times(vy));
    [cross.value(), dot.value()]
}

/// The arc from `from` to `to` with the DXF bulge tan(sweep/4), positive in the direction of growing angles; a line where it is 0.
///
/// # Errors
///
/// Where a number is not finite or too large.
pub fn from_bulge(from: Point, to: Point, bulge: f64) -> Result<Shape> {
    let (from, to) = (
        finite_point("start point", from)?,
        finite_point("end point", to)?,
    );
    finite("bulge", bulge)?;
    if from == to {
        return Ok(Shape::Empty);
    }
    let chord = to - from;
    let square = bulge * bulge;
    let radius = chord.hypot() * (1.0 + square) / (4.0 * bulge.abs());
    if bulge == 0.0 || !radius.is_finite() {
        return Ok(Shape::Line(Line { from, to }));
    }
    let depth = (1.0 - square) / (4.0 * bulge);
    let center = from.midpoint(to) + Vec2::new(-chord.y, chord.x) * depth;
    let center = finite_point("centre", center)?;
    let start = from - center;
    Ok(Shape::Arc(Arc {
        center,
        radii: Vec2::new(finite("radius", radius)?, radius),
        rotation: Angle::ZERO,
        start: Angle::from_radians(libm::atan2(start.y, start.x)),
        sweep: Angle::from_radians(4.0 * libm::atan(bulge)),
        ends: Some([from, to]),
    }))
}

/// The whole circle from a point of it.
pub(super) fn full_circle(from: Point, center: Point, reverse: bool) -> Result<Shape> {
    let out = from - center;
    let radius = positive("radius", out.hypot())?;
    Ok(Shape::Arc(Arc {
        center,
        radii: Vec2::new(radius, radius),
        rotation: Angle::ZERO,
        start: Angle::from_radians(libm::atan2(out.y, out.x)),
        sweep: Angle::from_degrees(if reverse { -360.0 } else { 360.0 }),
        ends: Some([from, from]),
    }))
}
