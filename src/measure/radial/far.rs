//! Bounds on the distance from an ellipse where a curve runs far from it, or where the nearest point jumps.

use kurbo::Vec2;

use super::part::{Motion, Part};
use super::peaks::{Search, vector};
use super::tangents::{Tangent, Tangents};
use crate::numeric::double::Twice;
use crate::numeric::foot::foot;

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Bounds the distance on a part by its control points. The signed distance from a convex shape is a convex function of the point: it
    /// is at most the largest of the control points, and at least that from the tangent at any point of the shape.
    pub(super) fn bound_far(&mut self, part: &Part, middle: &Motion<f64>, cuts: u32) {
        if !self.may_be_open(part, middle) {
            return;
        }
        let (part, points) = self.refreshed(part);
        let points = points.map(|p| self.profile.about_center(p));
        let places = part.polygon(self.center);
        let found: [_; 4] = core::array::from_fn(|i| self.distance_exactly(places[i], points[i]));
        let [from, to] = part.parameters();
        self.take(from, found[0].1);
        self.take(to, found[3].1);
        let inner = [0, 1].map(|axis| {
            let [a, b, c, d] = points.map(|p| p[axis]);
            a.plus(d).plus(b.plus(c).scaled(3.0)).scaled(0.125)
        });
        let (tangent, between) = self.distance_exactly(vector(middle.place), inner);
        self.take(part.parameter(0.5), between);
        let deepest = [&found[0].0, &tangent, &found[3].0].map(|tangent| {
            let depths = points.map(|p| -self.beyond(tangent, p));
            depths.into_iter().fold(0.0, f64::max)
        });
        let mut bounds = [
            found.iter().map(|(_, [_, high])| *high).fold(0.0, f64::max),
            deepest.into_iter().fold(f64::INFINITY, f64::min),
        ];
        // The coefficients of F have the right signs.
        let [low, high] = part.excess_range();
        for (bound, none) in bounds.iter_mut().zip([high <= 0.0, low >= 0.0]) {
            if none {
                *bound = 0.0;
            }
        }
        if self.open(&part, bounds, self.last_place) != [false; 2] {
            self.leave(&part, cuts, bounds);
        }
    }

    /// Whether a part may lie farther than what is known, by its length and the distance of its middle, all of which is a few roundings off.
    fn may_be_open(&self, part: &Part, middle: &Motion<f64>) -> bool {
        let distance = foot(self.radii, self.image(vector(middle.place))).distance;
        let reach = part.arms().map(|arm| self.image(arm).hypot());
        let reach = reach.into_iter().fold(0.0, f64::max);
        let [x, y] = part.moved();
        let slack = self.image(Vec2::new(x, y)).hypot() * 4.0 + 8.0 * f64::EPSILON * (1.0 + reach);
        let [low, high] = part.certain_excess();
        let bounds = [distance, -distance].map(|d| d + reach + slack);
        (high > 0.0 && self.is_open(0, bounds[0])) || (low < 0.0 && self.is_open(1, bounds[1]))
    }

    /// The tangent at the nearest point, and between what the signed distance lies, of a point that is nearly so in the frame, and exactly
    /// so about the centre of the exact one.
    pub(super) fn distance_exactly(&mut self, q: Vec2, exactly: Twice) -> (Tangent, [f64; 2]) {
        let unit = self.profile.larger_radius();
        let normal = foot(self.radii, self.image(q)).outward;
        let normal = normal.rotate_scale(self.profile.axis);
        let exact = &self.profile.exact;
        let tangents = self.tangents.get_or_insert_with(|| Tangents::new(exact));
        let tangent = tangents.tangent(normal);
        let between = tangents.distance(&tangent, exactly);
        (tangent, between.map(|d| d / unit))
    }

    /// At least how far a point lies beyond a tangent.
    fn beyond(&self, tangent: &Tangent, exactly: Twice) -> f64 {
        let tangents = self.tangents.as_ref();
        let least = tangents.map_or(f64::NEG_INFINITY, |all| all.beyond(tangent, exactly)[0]);
        least / self.profile.larger_radius()
    }
}
