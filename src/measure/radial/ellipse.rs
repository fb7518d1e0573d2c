//! The distance from an ellipse along a segment.

use kurbo::CubicBez;

use super::Profile;
use super::part::Part;
use super::search::visit_between;
use crate::numeric::bernstein::Polynomial;
use crate::numeric::foot::{Foot, foot_by_excess};

/// From this ratio of the radii on, the tips of an ellipse are looked for on their own.
const FLAT: f64 = 10.0;

impl Profile {
    /// The nearest point of the ellipse at t.
    pub(super) fn foot(&self, t: f64) -> Foot {
        foot_by_excess(self.radii, self.arm(t), self.excess.at(t)).foot
    }

    /// The whole segment in the frame where the ellipse is the unit circle.
    pub(super) fn part(&self) -> Part {
        let CubicBez { p0, p1, p2, p3 } = self.own.to_cubic();
        let points = [p0, p1, p2, p3];
        let of = |i: usize| self.excess.coefficient(i);
        Part::whole(
            core::array::from_fn(of),
            [
                points.map(|p| p.x / self.radii.x),
                points.map(|p| p.y / self.radii.y),
            ],
        )
    }

    /// Visits the ends and the extremes that a search finds, with which pictures are drawn.
    pub(super) fn visit_by_search(&self, mut visit: impl FnMut(f64, f64)) {
        let [x, y] = self.coordinates();
        let is_wide = self.radii.x >= self.radii.y;
        let (along, across) = if is_wide { (x, y) } else { (y, x) };
        // Where the curve crosses the long axis, the nearest point jumps to the other side, and the distance has a peak without a slope.
        let axis = across.sign_changes();
        for t in axis.iter() {
            visit(t, self.at(t));
        }
        let mut cuts: Vec<f64> = self.crossings().iter().chain(axis.iter()).collect();
        let larger = self.larger_radius();
        let flatness = larger / self.radii.x.min(self.radii.y);
        if flatness > FLAT {
            // Between the centre of curvature of a tip and the tip the normal makes half a turn.
            let center = larger * (1.0 - 1.0 / (flatness * flatness));
            for level in [larger, center, -center, -larger] {
                let from_level = along.minus(&Polynomial::new(&[level]));
                cuts.extend(from_level.sign_changes().iter());
            }
        }
        visit_between(&self.own, &cuts, |t| self.foot(t), &mut visit);
    }

    /// x and y about the centre as polynomials.
    fn coordinates(&self) -> [Polynomial; 2] {
        let CubicBez { p0, p1, p2, p3 } = self.own.to_cubic();
        let points = [p0, p1, p2, p3].map(|p| p.to_vec2() - self.center);
        [
            Polynomial::new(&points.map(|p| p.x)),
            Polynomial::new(&points.map(|p| p.y)),
        ]
    }
}
