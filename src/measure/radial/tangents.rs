//! Distances from an ellipse to twice the digits of `f64`, by the tangents at points of it.
//!
//! An ellipse is convex: the signed distance of a point from it is the largest of those from its tangents, positive outside, and
//! outside it is the least of the distances from points of it. So any tangent bounds it from below, any point of the ellipse from
//! above, and with the nearest point, found to the digits of `f64`, both are off by the square of what that is off.
//!
//! With M the matrix of the frame where the ellipse is a circle of radius R about the origin, the tangent at the image of R w/|w|
//! lies (w·y - R |w|) |det M| / |adj(M)ᵀ w| from the image of y. Only the first factor cancels.

use kurbo::Vec2;

use crate::numeric::double::{Double, Twice, cross};
use crate::shape::Exact;

/// A little more than the roundings of what is formed of the differences.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// An ellipse as the image of a circle.
pub(super) struct Tangents {
    /// The columns of M.
    columns: [Twice; 2],
    /// Its determinant's size.
    area: f64,
    radius: Double,
}

/// The tangent at the image of a point of the circle.
pub(super) struct Tangent {
    w: Vec2,
    /// |w|, and what w·y - R |w| is multiplied by.
    length: Double,
    factor: f64,
}

impl Tangents {
    pub(super) fn new(exact: &Exact) -> Self {
        let columns = exact.columns();
        Self {
            columns,
            area: cross(columns[0], columns[1]).value().abs(),
            radius: exact.radius(),
        }
    }

    /// The tangent at the image of R w/|w|.
    pub(super) fn tangent(&self, w: Vec2) -> Tangent {
        let [u, v] = [w.x, w.y].map(Double::of);
        let [a, b] = self.columns;
        let across = |i: usize| u.times(b[i]).plus(v.times(a[i]).scaled(-1.0)).value();
        Tangent {
            w,
            length: u.times(u).plus(v.times(v)).sqrt(),
            factor: self.area / Vec2::new(across(0), across(1)).hypot(),
        }
    }

    /// At least how far the image of y lies beyond a tangent, and at most.
    pub(super) fn beyond(&self, tangent: &Tangent, y: Twice) -> [f64; 2] {
        let along = y[0].scaled(tangent.w.x).plus(y[1].scaled(tangent.w.y));
        let cut = self.radius.times(tangent.length).scaled(-1.0);
        let distance = along.plus(cut).value() * tangent.factor;
        let rounding = ROUNDING * distance.abs();
        [distance - rounding, distance + rounding]
    }

    /// Bounds of the signed distance of the image of y, by the tangent at the point that is nearly the nearest. Inside, the
    /// second is what it would be if that was the nearest.
    pub(super) fn distance(&self, tangent: &Tangent, y: Twice) -> [f64; 2] {
        let [low, high] = self.beyond(tangent, y);
        let square = y[0].times(y[0]).plus(y[1].times(y[1]));
        let is_outside = square
            .plus(self.radius.times(self.radius).scaled(-1.0))
            .value()
            > 0.0;
        if !is_outside {
            return [low, high.min(0.0)];
        }
        let stretch = self.radius.divided(tangent.length).scaled(-1.0);
        let x = y[0].plus(stretch.scaled(tangent.w.x));
        let y = y[1].plus(stretch.scaled(tangent.w.y));
        let [a, b] = self.columns;
        let apart = |i: usize| a[i].times(x).plus(b[i].times(y)).value();
        [
            low,
            Vec2::new(apart(0), apart(1)).hypot() * (1.0 + ROUNDING),
        ]
    }
}
