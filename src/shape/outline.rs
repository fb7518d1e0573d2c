//! A piece of the unit circle, where it lies in user space, and the ellipse that it becomes there.

use kurbo::{Affine, Point, Vec2};

use crate::angle::Angle;
use crate::error::{Error, Result, finite, positive};
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
    /// The chord that it was given by; distances are then taken from there, and the centre is only near enough to be drawn.
    pub pencil: Option<Pencil>,
    /// How far the ellipse of these numbers may lie from the one that is meant, because they were computed and not given.
    pub rounding: f64,
}

/// The ellipse through two points, described without its centre.
///
/// In the frame where the ellipse is the unit circle, the circles through A and B are the pencil
/// (p - A)·(p - B) + κ (p - A)×(B - A) = 0, and the left side is |p|² - 1 about the centre of each. Nothing of it grows with the
/// radius: an arc of a radius of 10^10 chords keeps all its digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pencil {
    /// A.
    pub from: Point,
    /// B.
    pub to: Point,
    /// κ, the cotangent of half the signed sweep from A to B in the unit circle's frame.
    pub cotangent: f64,
}

impl Pencil {
    /// The sweep in degrees up to which a chord tells more than the centre: towards a whole turn it shrinks to nothing.
    const WIDEST: f64 = 270.0;

    /// The pencil of an arc with these ends; `None` where its sweep in degrees is too wide.
    pub(crate) fn new([from, to]: [Point; 2], sweep: f64) -> Option<Self> {
        (sweep.abs() <= Self::WIDEST && from != to).then(|| Self {
            from,
            to,
            cotangent: if sweep.abs() == 180.0 {
                0.0
            } else {
                1.0 / libm::tan((sweep / 2.0).to_radians())
            },
        })
    }
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
            pencil: None,
            rounding: 0.0,
        }
    }

    /// The same ellipse, described by the chord of an arc of it that runs this many degrees between these ends.
    #[must_use]
    pub(crate) fn through(self, ends: [Point; 2], sweep: f64) -> Self {
        self.through_about(ends, sweep, 0.0)
    }

    /// The same where the ends may be off so far.
    fn through_about(self, ends: [Point; 2], sweep: f64, off: f64) -> Self {
        let pencil = Pencil::new(ends, sweep);
        let size = |p: Point| p.x.abs().max(p.y.abs());
        let rounding = match pencil {
            None => self.rounding + f64::EPSILON * (size(self.center) + self.larger_radius()),
            // Radii that are computed move nothing but what lies between the ends, and those by their own rounding.
            Some(_) => 2.0 * off,
        };
        Self {
            pencil,
            rounding,
            ..self
        }
    }

    /// The same ellipse with all lengths multiplied by a power of two, which is exact.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let point = |p: Point| (p.to_vec2() * factor).to_point();
        Self {
            center: point(self.center),
            radii: self.radii * factor,
            axis: self.axis,
            pencil: self.pencil.map(|pencil| Pencil {
                from: point(pencil.from),
                to: point(pencil.to),
                ..pencil
            }),
            rounding: self.rounding * factor,
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
        let (x, y) = (v.x * self.radii.x, v.y * self.radii.y);
        Vec2::new(
            self.axis.x * x - self.axis.y * y,
            self.axis.y * x + self.axis.x * y,
        )
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
            let message = "the transform flattens the shape to a line: nothing is left to draw";
            return Err(Error::Shape(message.to_owned()));
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
        let angle = |cos: f64, sin: f64| match (cos == 0.0, sin == 0.0) {
            // Exact where the axes are level.
            (_, true) => 0.0,
            (true, false) => 90.0,
            _ => libm::atan2(sin, cos).to_degrees(),
        };
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
        let (center, off) = mapped(map, self.truth.center);
        let placement = (map * self.placement).with_translation(center.to_vec2());
        let ends = self.ends.map(|ends| ends.map(|end| mapped(map, end)));
        let truth = Truth::of(placement)?;
        // Each product of the maps is rounded, which counts where they cancel.
        let [a, b, c, d, _, _] = map.as_coeffs();
        let size = libm::hypot(libm::hypot(a, b), libm::hypot(c, d));
        let truth = Truth {
            rounding: off + f64::EPSILON * size * self.truth.larger_radius(),
            ..truth
        };
        let handed = 1.0_f64.copysign(placement.determinant());
        Ok(Self {
            placement,
            truth: ends.map_or(truth, |[(from, before), (to, after)]| {
                let sweep = self.unit.sweep.degrees() * handed;
                truth.through_about([from, to], sweep, before.max(after))
            }),
            ends: ends.map(|ends| ends.map(|(end, _)| end)),
            ..self
        })
    }
}

/// The image of a point, and how far its rounding moves it.
fn mapped(map: Affine, p: Point) -> (Point, f64) {
    let [a, b, c, d, e, f] = map.as_coeffs();
    let (x, y) = (Double::difference(p.x, 0.0), Double::difference(p.y, 0.0));
    let sum = |a: f64, c: f64, e: f64| {
        let sum = x.scaled(a).plus(y.scaled(c));
        sum.plus(Double::difference(e, 0.0))
    };
    let (x, y) = (sum(a, c, e), sum(b, d, f));
    let point = Point::new(x.value(), y.value());
    (point, libm::hypot(x.less(point.x), y.less(point.y)))
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
        let message = format!(
            "an ellipse with the radii {} and {} is too flat: one radius may be up to {FLATTEST:e} of the other",
            radii.x, radii.y
        );
        return Err(Error::Shape(message));
    }
    Ok(radii)
}
