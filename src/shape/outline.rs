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
        Self {
            frame: self.frame.through(ends, sweep, given),
            ..self
        }
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
        let center = Point::new(e, f);
        if (a == d && b == -c) || (a == -d && b == c) {
            let radius = positive("scale of the transform", libm::hypot(a, b))?;
            return Ok(Self::circle(center, radius));
        }
        let radii = kurbo::Ellipse::from_affine(placement).radii();
        let larger = positive("scale of the transform", radii.x.max(radii.y))?;
        // By the area, because the singular values' own formula cancels for flat ellipses.
        let smaller = placement.determinant().abs() / larger;
        if smaller <= f64::EPSILON * larger {
            return Err(Error::Shape(ShapeError::Flattened));
        }
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
            truth.radii.y = truth.frame.exact(truth.radii).area() / truth.radii.x;
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

#[inline]
pub(crate) fn positive_radii(radii: Vec2) -> Result<Vec2> {
    let what = if radii.x == radii.y {
        "radius"
    } else {
        "radii"
    };
    let radii = Vec2::new(positive(what, radii.x)?, positive(what, radii.y)?);
    let (small, large) = (radii.x.min(radii.y), radii.x.max(radii.y));
    if large > FLATTEST * small {
        let (radii, most) = ([radii.x, radii.y], FLATTEST);
        return Err(Error::Shape(ShapeError::TooFlat { radii, most }));
    }
    Ok(radii)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ellipse, Shape};

    #[test]
    fn the_short_axis_of_a_rotated_ellipse_is_its_smaller_radius() {
        for degrees in (0..360).map(f64::from) {
            for (radii, angle) in [((100.0, 30.0), 90.0), ((30.0, 100.0), 0.0)] {
                let ellipse = Ellipse::new((7.0, 9.0), radii, Angle::from_degrees(degrees));
                let outline = Shape::Ellipse(ellipse.unwrap()).outline().unwrap();
                assert_eq!(outline.axes().angle, angle, "{degrees}");
            }
        }
    }

    #[test]
    fn the_axes_of_a_sheared_circle_are_its_own() {
        // The columns of the map, and the angle at which |M u| is least: where its derivative vanishes and it is short.
        for columns in [
            [1.0, 0.0, 0.6, 0.8],
            [1.0, 0.0, -0.6, 0.8],
            [1.0, 0.0, 0.05, 0.5],
            [1.0, 0.0, 0.3, 0.9],
            [0.2, 0.1, 1.0, 3.0],
            [0.5, 0.05, -0.1, 1.0],
            [1.0, 1e-9, 0.0, 0.5],
        ] {
            let [a, b, c, d] = columns;
            for scale in [1.0, 1e-9, 1e9] {
                let map = Affine::new([a * scale, b * scale, c * scale, d * scale, 0.0, 0.0]);
                let circle = Shape::Circle(crate::Circle::new((0.0, 0.0), 1.0).unwrap());
                let outline = circle.outline().unwrap().transformed(map).unwrap();
                let axes = outline.axes();
                let image = |degrees: f64| {
                    let u = Angle::from_degrees(degrees).direction();
                    Vec2::new(a * u.x + c * u.y, b * u.x + d * u.y).hypot()
                };
                let [short, long] = [axes.angle, axes.angle + 90.0].map(image);
                let area = (a * d - b * c).abs();
                assert!((short * long - area).abs() < 1e-14, "{columns:?}: {axes:?}");
                assert!(short < long, "{columns:?}: {axes:?}");
                assert!((axes.short - short / long).abs() < 1e-14);
                assert!((outline.truth.radii.x / (scale * long) - 1.0).abs() < 1e-14);
                assert!((outline.truth.radii.y / (scale * short) - 1.0).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_map_flattens_by_its_ratio_whatever_its_size() {
        let circle = Shape::Circle(crate::Circle::new((0.0, 0.0), 1.0).unwrap());
        let outline = circle.outline().unwrap();
        for scale in [1e-12, 1.0, 1e12] {
            let map = |flatness: f64| Affine::scale_non_uniform(scale, scale * flatness);
            assert!(outline.transformed(map(1e-11)).is_ok(), "{scale}");
            assert_eq!(
                outline.transformed(map(1e-16)),
                Err(Error::Shape(ShapeError::Flattened)),
                "{scale}"
            );
        }
    }

    #[test]
    fn opposite_extremes_are_half_a_turn_apart() {
        let ellipse = Ellipse::new((7.0, 9.0), (3.0, 2.0), Angle::from_degrees(30.0)).unwrap();
        let outline = Shape::Ellipse(ellipse).outline().unwrap();
        let [right, left, upper, lower] = outline.extremes();
        assert_eq!(left.degrees(), right.degrees() + 180.0);
        assert_eq!(lower.degrees(), upper.degrees() + 180.0);
        let at = |angle: Angle| outline.placement * angle.direction().to_point();
        assert!(at(right).x > 7.0 && at(left).x < 7.0);
        assert!(at(upper).y > 9.0 && at(lower).y < 9.0);
    }

    #[test]
    fn a_chord_tells_more_than_the_centre_up_to_three_quarters_of_a_turn() {
        let circle = Truth::circle((1.0, 2.0).into(), 5.0);
        for (sweep, is_about_start) in [(10.0, true), (-260.0, true), (280.0, false)] {
            let ends = [0.0, sweep].map(|degrees| {
                circle.center + Angle::from_degrees(degrees).direction() * circle.radii.x
            });
            let truth = circle.through(ends, Angle::from_degrees(sweep), Given::Sweep);
            let exact = truth.frame.exact(truth.radii);
            let start = exact.point(ends[0]).map(Double::value);
            assert_eq!(start == [0.0; 2], is_about_start, "{sweep}");
            let [x, y] = exact.center().map(Double::value);
            let arm = Vec2::new(x - start[0], y - start[1]).hypot();
            assert!((arm - 5.0).abs() < 1e-14, "{sweep}: {arm}");
        }
    }

    #[test]
    fn similarities_keep_a_circle_and_nothing_else_does() {
        for (columns, radius) in [
            ([0.6, 0.8, -0.8, 0.6], Some(1.0)),
            ([0.6, 0.8, 0.8, -0.6], Some(1.0)),
            ([-3.0, 0.0, 0.0, -3.0], Some(3.0)),
            ([2.0, 1.0, 1.0, 2.0], None),
            ([2.0, 1.0, -1.0, -2.0], None),
            ([2.0, 0.0, 0.0, 3.0], None),
        ] {
            let [a, b, c, d] = columns;
            let truth = Truth::of(Affine::new([a, b, c, d, 0.0, 0.0])).unwrap();
            assert_eq!(
                truth.is_circle().then_some(truth.radii.x),
                radius,
                "{columns:?}"
            );
        }
        assert_eq!(Axes::of(Vec2::new(2.0, 1.0)).angle, 90.0);
        assert_eq!(Axes::of(Vec2::new(1.0, 2.0)).angle, 0.0);
        // By the ratio of the radii, whatever their size.
        for (radii, serves) in [
            ((1e13, 1e2), true),
            ((1e13, 1.0), false),
            ((1e-16, 1e-3), false),
        ] {
            assert_eq!(positive_radii(radii.into()).is_ok(), serves, "{radii:?}");
        }
    }
}
