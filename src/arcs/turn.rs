//! Cubics that turn about the centre of an upright ellipse.

use kurbo::{CubicBez, Point, Vec2};

use super::bound::roughly_from_arc;
use super::near::{
    MORE_DECIMALS, Rules, is_drawn_like, joins_smoothly, larger, size, strays, swept,
};
use super::recognize::{Found, HALF_TURN, near_enough};
use crate::Angle;
use crate::number::round;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Truth};

/// An upright ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct UprightEllipse {
    pub(crate) center: Point,
    pub(crate) radii: Vec2,
}

impl UprightEllipse {
    /// How far a point lies from it, in lengths of the larger radius where it is the unit circle.
    pub(crate) fn off(&self, p: Point) -> f64 {
        let Vec2 { x, y } = p - self.center;
        let out = Vec2::new(x / self.radii.x, y / self.radii.y);
        (out.hypot2().sqrt() - 1.0).abs() * self.radii.x.max(self.radii.y)
    }

    /// The arc of it on which cubics lie that begin and end near it: its ends are those of the cubics, brought there.
    pub(super) fn arc(&self, cubics: &[CubicBez]) -> Option<Arc> {
        let truth = Truth::new(self.center, self.radii, Vec2::new(1.0, 0.0));
        let mut arc = swept(cubics, &truth)?;
        let brought = |p: Point| {
            let out = (truth.placement().inverse() * p).to_vec2();
            truth.placement() * (out / out.hypot2().sqrt()).to_point()
        };
        arc.ends = arc.ends.map(|ends| ends.map(brought));
        Some(arc)
    }

    /// The arc of its radii between the ends of cubics, and how far they turn.
    pub(super) fn between(&self, cubics: &[CubicBez]) -> Option<(SvgArc, Angle)> {
        let swept = self.arc(cubics)?.sweep;
        let given = SvgArc {
            from: cubics.first()?.p0,
            radii: self.radii,
            rotation: Angle::ZERO,
            large_arc: swept.degrees().abs() > HALF_TURN,
            sweep: swept.degrees() > 0.0,
            to: cubics.last()?.p3,
        };
        Some((given, swept))
    }
}

/// How far cubics turn about the centre of an ellipse, in degrees, and a bound, both ways, of their distance from what they turn
/// over there; `None` where they are not drawn like an arc of it.
pub(crate) fn turned(
    cubics: &[CubicBez],
    turn: &UprightEllipse,
    rules: &Rules,
) -> Option<(f64, f64)> {
    let arc = turn.arc(cubics)?;
    let fits = cubics.windows(2).all(joins_smoothly)
        && is_drawn_like(cubics, &arc, rules)
        && strays(cubics, &arc) <= rules.room(size(cubics, larger(&arc)));
    fits.then(|| (arc.sweep.degrees(), roughly_from_arc(cubics, &arc)))
}

/// A whole turn of a circle or an upright ellipse as its halves, with the radii of the fewest decimals that its extents round to: one
/// cubic may say too little of its radii where all of them together say enough.
pub(super) fn whole(cubics: &[CubicBez], rules: &Rules) -> Option<[Found; 2]> {
    let (first, last) = (cubics.first()?, cubics.last()?);
    if first.p0 != last.p3 || cubics.len() < 2 {
        return None;
    }
    let boxes = cubics.iter().map(kurbo::Shape::bounding_box);
    let bounds = boxes.reduce(|a, b| a.union(b))?;
    let most = rules.decimals.saturating_add(MORE_DECIMALS);
    (0..=most).find_map(|decimals| {
        let [x, y] = [bounds.width(), bounds.height()].map(|side| round(side / 2.0, decimals));
        let turn = UprightEllipse {
            center: bounds.center(),
            radii: Vec2::new(x, y),
        };
        let is_served = x > 0.0 && y > 0.0 && (x == y || rules.elliptic);
        let (swept, _) = is_served.then(|| turned(cubics, &turn, rules)).flatten()?;
        if (swept.abs() - 360.0).abs() > 1.0 {
            return None;
        }
        let half = |cubics: &[CubicBez]| near_enough(cubics, turn.between(cubics)?.0, rules, None);
        let (first, second) = cubics.split_at(cubics.len() / 2);
        Some([half(first)?, half(second)?])
    })
}
