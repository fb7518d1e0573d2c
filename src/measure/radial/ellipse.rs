//! The distance from an ellipse along a segment.

use kurbo::{CubicBez, Vec2};

use super::Profile;
use super::part::CubicPart;
use super::search::visit_between;
use crate::numeric::bernstein::Polynomial;
use crate::numeric::double::Twice;
use crate::numeric::foot::{Foot, foot_by_excess};

impl Profile {
    /// The nearest point of the ellipse at t.
    pub(super) fn foot(&self, t: f64) -> Foot {
        foot_by_excess(self.radii, self.arm(t), self.excess.at(t)).foot
    }

    /// The map from the exact frame to that where the ellipse is the unit circle and its axes lie along the coordinates', by rows: a turn,
    /// and a reflection where the shape is mirrored. The longer axis, which is the first of a shape under a map, is turned to, and the
    /// shorter one follows.
    pub(super) fn turn(&self) -> [Vec2; 2] {
        let unit = self.exact.unit.sqrt();
        if !self.exact.is_mapped() {
            return [Vec2::new(unit, 0.0), Vec2::new(0.0, unit)];
        }
        let [a, b] = self
            .exact
            .columns()
            .map(|[x, y]| Vec2::new(x.value(), y.value()));
        let row = |axis: Vec2| {
            let row = Vec2::new(a.dot(axis), b.dot(axis));
            row * (unit / row.hypot())
        };
        let side = 1.0_f64.copysign(a.cross(b));
        let first = row(self.axis);
        [first, Vec2::new(-first.y, first.x) * side]
    }

    /// The part of the segment between two parameters in that frame, and its control points in the exact one.
    pub(super) fn part(&self, [from, to]: [f64; 2], turn: &[Vec2; 2]) -> (CubicPart, [Twice; 4]) {
        let is_whole = from == 0.0 && to == 1.0;
        let (framed, excess) = if is_whole {
            (self.framed, self.excess)
        } else {
            let framed = self.framed.between(from, to);
            (framed, framed.excess().scaled(self.exact.unit))
        };
        let points = framed.points();
        let mut turned = [[0.0; 4]; 2];
        for (turned, row) in turned.iter_mut().zip(turn) {
            for (turned, [x, y]) in turned.iter_mut().zip(points) {
                *turned = row.x * x.value() + row.y * y.value();
            }
        }
        let part = CubicPart::new(
            [from, to],
            *excess.coefficients_of_square(),
            turned,
            self.exact.is_mapped(),
        );
        (part, *points)
    }

    /// A point of the exact frame about its centre.
    pub(super) fn about_center(&self, [x, y]: Twice) -> Twice {
        let [a, b] = self.exact.center();
        [x.plus(a.scaled(-1.0)), y.plus(b.scaled(-1.0))]
    }

    /// Visits the ends and the extremes that a search finds, with which pictures are drawn.
    pub(super) fn visit_by_search(&self, mut visit: impl FnMut(f64, f64)) {
        let [x, y] = self.coordinates();
        let across = if self.radii.x >= self.radii.y { y } else { x };
        // Where the curve crosses the long axis, the nearest point jumps to the other side, and the distance has a peak without a slope.
        let axis = across.sign_changes();
        for t in axis.iter() {
            visit(t, self.at(t));
        }
        let cuts: Vec<f64> = self.crossings().iter().chain(axis.iter()).collect();
        visit_between(&self.own, &cuts, |t| self.foot(t), &mut visit);
    }

    /// x and y about the centre as polynomials.
    pub(super) fn coordinates(&self) -> [Polynomial; 2] {
        let CubicBez { p0, p1, p2, p3 } = self.own.to_cubic();
        let points = [p0, p1, p2, p3].map(|p| p.to_vec2() - self.center);
        [
            Polynomial::new(&points.map(|p| p.x)),
            Polynomial::new(&points.map(|p| p.y)),
        ]
    }
}
