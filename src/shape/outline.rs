//! A piece of the unit circle, where it lies in user space, and the ellipse that it becomes there.

use kurbo::{Affine, Point, Vec2};

use super::Given;
use super::frame::Frame;
use crate::angle::Angle;
use crate::error::{Error, Result, ShapeError, finite, positive};
use crate::numeric::double::Double;
use crate::numeric::functions::unit_vector;

/// A piece of the unit circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitArc {
    /// Where it starts.
    pub start: Angle,
    /// How far it runs.
    pub sweep: Angle,
    /// Whether its end is its start.
    pub closed: bool,
}

/// A piece of the unit circle and where it lies in user space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outline {
    /// The piece.
    pub unit: UnitArc,
    /// The map from the unit circle to user space.
    pub placement: Affine,
    /// The ellipse that the unit circle becomes.
    pub truth: Truth,
    /// End points to be kept to the last digit.
    pub ends: Option<[Point; 2]>,
}

/// The true ellipse that a curve is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    /// Its centre.
    pub center: Point,
    /// Its radii along its own axes.
    pub radii: Vec2,
    /// (cosine, sine) of the angle from the x axis to the axis of the first radius.
    pub axis: Vec2,
    /// What was given of it, exactly: distances are taken there.
    pub(crate) frame: Frame,
}

impl Truth {
    /// A circle.
    #[must_use]
    pub const fn circle(center: Point, radius: f64) -> Self {
        Self::new(center, Vec2::new(radius, radius), Vec2::new(1.0, 0.0))
    }

    /// An ellipse whose numbers are exact.
    #[must_use]
    #[inline]
    pub const fn new(center: Point, radii: Vec2, axis: Vec2) -> Self {
        Self {
            center,
            radii,
            axis,
            frame: Frame::new(center, radii, axis),
        }
    }

    /// The same ellipse, the direction of its first radius given by this angle.
    pub(crate) const fn turned(self, rotation: Angle) -> Self {
        Self {
            frame: self.frame.turned(rotation),
            ..self
        }
    }

    /// The same ellipse by an arc of it between these ends.
    pub(crate) fn through(self, ends: [Point; 2], sweep: Angle, given: Given) -> Self {
        let mut truth = Self {
            frame: self.frame.through(ends, sweep, given),
            ..self
        };
        if matches!(given, Given::Conic { .. }) && !truth.is_circle() {
            truth.know_area();
        }
        truth
    }

    /// Takes the smaller radius, the second, from the exact frame.
    fn know_area(&mut self) {
        let exact = self.frame.exact(self.radii);
        self.radii.y = exact.area() / (exact.grown * exact.grown * self.radii.x);
    }

    /// The same ellipse with all lengths multiplied by a power of two, which is exact.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            center: (self.center.to_vec2() * factor).to_point(),
            radii: self.radii * factor,
            axis: self.axis,
            frame: self.frame.scaled(factor),
        }
    }

    /// The larger radius.
    #[must_use]
    #[inline]
    pub fn larger_radius(&self) -> f64 {
        self.radii.x.max(self.radii.y)
    }

    /// The smallest radius of curvature.
    pub(crate) fn sharpest_radius(&self) -> f64 {
        let smaller = self.radii.x.min(self.radii.y);
        smaller * (smaller / self.larger_radius())
    }

    /// Whether both radii are the same.
    #[must_use]
    pub fn is_circle(&self) -> bool {
        self.radii.x == self.radii.y
    }

    /// The image of a vector of the unit circle's plane, the centre left out.
    #[inline(always)]
    #[must_use]
    pub(crate) fn image(&self, v: Vec2) -> Vec2 {
        Vec2::new(v.x * self.radii.x, v.y * self.radii.y).rotate_scale(self.axis)
    }

    /// The map from the unit circle.
    #[must_use]
    pub fn placement(&self) -> Affine {
        let (u, v) = (
            self.axis * self.radii.x,
            Vec2::new(-self.axis.y, self.axis.x) * self.radii.y,
        );
        Affine::new([u.x, u.y, v.x, v.y, self.center.x, self.center.y])
    }

    /// The ellipse that an affine map makes of the unit circle.
    pub(crate) fn of(placement: Affine) -> Result<Self> {
        let [a, b, c, d, e, f] = placement.as_coeffs();
        for (what, value) in [
            ("x coordinate of the transform", e),
            ("y coordinate of the transform", f),
        ] {
            finite(what, value)?;
        }
        if flattens(placement) {
            return Err(Error::Shape(ShapeError::Flattened));
        }
        let center = Point::new(e, f);
        if (a == d && b == -c) || (a == -d && b == c) {
            let radius = positive("transformed radius", libm::hypot(a, b))?;
            return Ok(Self::circle(center, radius));
        }
        let radii = kurbo::Ellipse::from_affine(placement).radii();
        let larger = positive("transformed radius", radii.x.max(radii.y))?;
        // By the area, because the singular values' own formula cancels for flat ellipses.
        let smaller = placement.determinant().abs() / larger;
        let radii = positive_radii(Vec2::new(larger, smaller))?;
        // The larger singular value's direction; kurbo has the same formula, but asks the platform.
        let axis =
            unit_vector(libm::atan2(2.0 * (a * b + c * d), a * a - b * b + c * c - d * d) / 2.0);
        Ok(Self::new(center, radii, axis))
    }
}

/// The axes of an ellipse, as its unit circle sees them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    /// The smaller radius over the larger one.
    pub(crate) short: f64,
    /// The parametric angle of an end of the short axis, in degrees.
    pub(crate) angle: f64,
}

impl Axes {
    /// Those of an ellipse whose unit circle lies along them.
    pub(crate) fn of(radii: Vec2) -> Self {
        let (x, y) = (radii.x, radii.y);
        Self {
            short: x.min(y) / x.max(y),
            angle: if x < y { 0.0 } else { 90.0 },
        }
    }
}

impl Outline {
    /// The axes; those of a circle lie anywhere.
    ///
    /// With M the placement and u(θ) = (cos θ, sin θ), |M u|² = |first|² cos² θ + |second|² sin² θ + 2 first·second sin θ cos θ.
    pub(crate) fn axes(&self) -> Axes {
        let scale = self.truth.larger_radius();
        let [a, b, c, d, _, _] = self.placement.as_coeffs().map(|x| x / scale);
        let (even, odd) = (
            f64::midpoint(c * c + d * d, -(a * a + b * b)),
            -(a * c + b * d),
        );
        Axes {
            short: (a * d - b * c).abs(),
            // A placement by radii and a rotation has its axes at 0 and 90 degrees; rounding must not turn them.
            angle: if odd.abs() > 1e-14 * even.abs() {
                libm::atan2(odd, even).to_degrees() / 2.0
            } else if even < 0.0 {
                90.0
            } else {
                0.0
            },
        }
    }

    /// The parametric angles, within one turn, at which the ellipse is farthest to the right, to the left, up and down, in this
    /// order of pairs: x = a cos θ + c sin θ is extreme where tan θ = c/a, and y = b cos θ + d sin θ where tan θ = d/b.
    #[must_use]
    pub fn extremes(&self) -> [Angle; 4] {
        let [a, b, c, d, _, _] = self.placement.as_coeffs();
        let angle = |cos: f64, sin: f64| libm::atan2(sin, cos).to_degrees();
        let (x, y) = (angle(a, c), angle(b, d));
        [x, x + 180.0, y, y + 180.0].map(Angle::from_degrees)
    }

    /// The outline under a further affine map of user space.
    ///
    /// # Errors
    ///
    /// Where the map is not finite or flattens the plane.
    pub fn transformed(self, map: Affine) -> Result<Self> {
        if map == Affine::IDENTITY {
            return Ok(self);
        }
        let center = mapped(map, self.truth.center);
        let placement = (map * self.placement).with_translation(center.to_vec2());
        let mut truth = Truth {
            frame: self.truth.frame.mapped(map),
            ..Truth::of(placement)?
        };
        if cancels(placement) && !truth.is_circle() {
            truth.know_area();
        }
        Ok(Self {
            placement,
            truth,
            ends: self.ends.map(|ends| ends.map(|end| mapped(map, end))),
            ..self
        })
    }
}

/// Whether so much cancels in the determinant of a map that nearly flattens the plane that its digits do not suffice.
fn cancels(map: Affine) -> bool {
    let [a, b, c, d, ..] = map.as_coeffs();
    map.determinant().abs() < 0.5 * ((a * d).abs() + (b * c).abs())
}

/// The image of a point.
fn mapped(map: Affine, p: Point) -> Point {
    let [a, b, c, d, e, f] = map.as_coeffs();
    let sum = |a: f64, c: f64, e: f64| {
        let sum = Double::of(p.x).scaled(a).plus(Double::of(p.y).scaled(c));
        sum.plus(Double::of(e)).value()
    };
    Point::new(sum(a, c, e), sum(b, d, f))
}

/// How many times one radius may be the other: beyond, an ellipse in double precision is a line.
const FLATTEST: f64 = 1e12;

/// Whether nothing but a line or a point is left of the plane under a map, to double precision: it has no inverse there, and SVG
/// renders nothing.
#[must_use]
pub fn flattens(map: Affine) -> bool {
    let [a, b, c, d, ..] = map.as_coeffs();
    // Neither squares nor the determinant leave the range of `f64` then.
    let size = [b, c, d].iter().fold(a.abs(), |size, x| size.max(x.abs()));
    let [a, b, c, d] = [a, b, c, d].map(|x| x / size);
    size == 0.0 || FLATTEST * (a * d - b * c).abs() < a * a + b * b + c * c + d * d
}

#[inline]
pub(crate) fn positive_radii(radii: Vec2) -> Result<Vec2> {
    let what = if radii.x == radii.y {
        "radius"
    } else {
        "radii"
    };
    let radii = Vec2::new(positive(what, radii.x)?, positive(what, radii.y)?);
    check_flatness(radii)?;
    Ok(radii)
}

/// Refuses radii of which one is too small beside the other.
#[inline]
pub(crate) fn check_flatness(radii: Vec2) -> Result<()> {
    let (small, large) = (radii.x.min(radii.y), radii.x.max(radii.y));
    if large > FLATTEST * small {
        let (radii, most) = ([radii.x, radii.y], FLATTEST);
        return Err(Error::Shape(ShapeError::TooFlat { radii, most }));
    }
    Ok(())
}

#[cfg(test)]
mod tests;
