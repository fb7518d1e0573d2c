//! Ellipses by conjugate half diameters.

use kurbo::{Affine, CubicBez, ParamCurve as _, Point, Vec2};

use super::near::{Rules, size};
use crate::Angle;
use crate::numeric::functions::angle_of;
use crate::shape::Truth;

/// The least part that one radius of an ellipse may be of the other.
const FLATTEST: f64 = 1e-3;

/// The centre of an ellipse and two conjugate half diameters e and f.
pub(super) struct Diameters {
    center: Point,
    e: Vec2,
    f: Vec2,
}

impl Diameters {
    /// Of the ellipse through two points whose tangents meet in a third one, between them, by the square of its weight.
    pub(super) fn new(from: Point, tip: Point, to: Point, square: f64) -> Self {
        let (base, weight) = (from.midpoint(to), square.sqrt());
        let (way, rest) = (tip - base, 1.0 - square);
        let center = base - way * (square / rest);
        Self {
            center,
            e: base + way * (weight / (1.0 + weight)) - center,
            f: (to - from) / (2.0 * rest.sqrt()),
        }
    }

    /// The map from the unit circle.
    pub(super) fn frame(&self) -> Affine {
        let Self { center, e, f } = self;
        Affine::new([e.x, e.y, f.x, f.y, center.x, center.y])
    }

    /// (e f) (e f)ᵀ, as the mean of its eigenvalues, half their difference, and twice the angle of the larger one's direction by its
    /// cosine and sine, times that half.
    fn squares(&self) -> (f64, f64, Vec2) {
        let (e, f) = (self.e, self.f);
        let [a, c] = [e.x * e.x + f.x * f.x, e.y * e.y + f.y * f.y];
        let twice = Vec2::new(0.5 * (a - c), e.x * e.y + f.x * f.y);
        (0.5 * (a + c), twice.hypot2().sqrt(), twice)
    }

    pub(super) fn larger(&self) -> f64 {
        let (mean, half, _) = self.squares();
        (mean + half).sqrt()
    }

    /// The ellipse, unless it is too flat, with its axis within an eighth of a turn of the x axis.
    pub(super) fn ellipse(&self) -> Option<Truth> {
        let (mean, half, twice) = self.squares();
        let radii = [(mean + half).sqrt(), (mean - half).max(0.0).sqrt()];
        (radii[1] > FLATTEST * radii[0]).then(|| {
            let rotation = 0.5 * angle_of(twice);
            let quarters = (rotation / core::f64::consts::FRAC_PI_2).round();
            let rest = rotation - quarters * core::f64::consts::FRAC_PI_2;
            let [a, b] = radii;
            let radii = if quarters % 2.0 == 0.0 {
                Vec2::new(a, b)
            } else {
                Vec2::new(b, a)
            };
            Truth::new(self.center, radii, Angle::from_radians(rest).direction())
        })
    }
}

/// The ellipse of which a cubic is an arc.
pub(super) fn ellipse_of(cubic: &CubicBez, rules: &Rules) -> Option<Truth> {
    let (u, v, chord) = (
        cubic.p1 - cubic.p0,
        cubic.p2 - cubic.p3,
        cubic.p3 - cubic.p0,
    );
    let cross = u.cross(v);
    // Where the tangents meet, in lengths of the handles: alike for the arc of an ellipse, and longer than they.
    let [along, back] = [chord.cross(v) / cross, chord.cross(u) / cross];
    if !(along > 1.0 && (along - back).abs() <= 0.1 * along) {
        return None;
    }
    let (tip, base) = (cubic.p0 + along * u, cubic.p0.midpoint(cubic.p3));
    let (way, rise) = (tip - base, cubic.eval(0.5) - base);
    let part = rise.dot(way) / way.hypot2();
    let weight = part / (1.0 - part);
    let square = weight * weight;
    if !(weight > 0.05 && 1.0 - square > 4e-3) {
        return None;
    }
    let diameters = Diameters::new(cubic.p0, tip, cubic.p3, square);
    let to_unit = diameters.frame().inverse();
    let larger = diameters.larger();
    let room = rules.room(size(&[*cubic], larger)) / larger;
    let off = |t: f64| ((to_unit * cubic.eval(t)).to_vec2().hypot2().sqrt() - 1.0).abs();
    if !(off(0.25) <= room && off(0.75) <= room) {
        return None;
    }
    diameters.ellipse()
}
