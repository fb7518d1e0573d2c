//! Circles in space and their orthographic images.

use kurbo::{Affine, Vec2};

use super::{Sphere, View};
use crate::angle::Angle;
use crate::error::{Error, Result, ShapeError, finite};

/// A vector in space: x lies on the equator at the longitude of the view, y on it a quarter turn to the east, z towards the north.
type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The unit sphere as it is seen, and where it is put.
pub(super) struct Space {
    /// The longitude of the view.
    longitude: Angle,
    /// What is seen as right, as up, and as coming nearer.
    east: Vector,
    north: Vector,
    outward: Vector,
    sphere: Sphere,
    y_up: bool,
}

/// A circle in space by the maps of its own plane, in which it is the unit circle.
pub(super) struct Ring {
    /// From the plane to what is seen.
    pub(super) screen: Affine,
    /// [a, b, c]: the point (x, y) of the plane lies a x + b y + c radii before the centre of the sphere.
    pub(super) depth: [f64; 3],
}

impl Space {
    pub(super) fn new(sphere: &Sphere, view: View) -> Result<Self> {
        finite("longitude", view.longitude.degrees())?;
        let latitude = finite("latitude", view.latitude.degrees())?;
        if latitude.abs() > 90.0 {
            return Err(Error::Shape(ShapeError::Latitude(latitude)));
        }
        let Vec2 { x: cos, y: sin } = view.latitude.direction();
        Ok(Self {
            longitude: view.longitude,
            east: [0.0, 1.0, 0.0],
            north: [-sin, 0.0, cos],
            outward: [cos, 0.0, sin],
            sphere: *sphere,
            y_up: view.y_up,
        })
    }

    /// The circle of this latitude, eastward from the longitude of the view, so that both its sides mirror to the last digit.
    pub(super) fn parallel(&self, latitude: Angle) -> Ring {
        let Vec2 { x: cos, y: sin } = latitude.direction();
        self.ring([0.0, 0.0, sin], [cos, 0.0, 0.0], [0.0, cos, 0.0])
    }

    /// The circle through both poles from the north along this longitude: its first half is the meridian.
    pub(super) fn meridian(&self, longitude: Angle) -> Ring {
        let from_view = Angle::from_degrees(longitude.degrees() - self.longitude.degrees());
        let Vec2 { x: cos, y: sin } = from_view.direction();
        self.ring([0.0; 3], [0.0, 0.0, 1.0], [cos, sin, 0.0])
    }

    /// The map of the unit circle to the outline.
    pub(super) fn outline(&self) -> Affine {
        Affine::scale(self.sphere.radius).then_translate(self.sphere.center.to_vec2())
    }

    /// The circle about `center` with these radii of its plane.
    fn ring(&self, center: Vector, u: Vector, v: Vector) -> Ring {
        let up = if self.y_up { 1.0 } else { -1.0 };
        let seen = |w| Vec2::new(dot(w, self.east), up * dot(w, self.north)) * self.sphere.radius;
        let (u2, v2) = (seen(u), seen(v));
        let middle = self.sphere.center + seen(center);
        Ring {
            screen: Affine::new([u2.x, u2.y, v2.x, v2.y, middle.x, middle.y]),
            depth: [u, v, center].map(|w| dot(w, self.outward)),
        }
    }
}
