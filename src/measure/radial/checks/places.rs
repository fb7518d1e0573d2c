//! One place: the distance from a tangent, and what rounding does to one.

use kurbo::Vec2;

use super::{EPSILON, apart};
use crate::measure::radial::part::CubicPart;
use crate::measure::radial::place::NearestPoint;
use crate::measure::radial::tangents::Tangents;
use crate::numeric::double::Double;
use crate::numeric::foot::foot_in_unit;
use crate::shape::Truth;

#[test]
fn a_tangent_bounds_from_below_and_its_point_from_above() {
    let truth = Truth::new((5.0, 7.0).into(), (2.0, 1.0).into(), Vec2::new(1.0, 0.0));
    let tangents = Tangents::new(&truth.frame.exact(truth.radii));
    let between = |normal: (f64, f64), p: (f64, f64)| {
        // Where the normal is so the circle's is that under the transposed matrix.
        let tangent = tangents.tangent(Vec2::new(2.0 * normal.0, normal.1));
        let p = [p.0 / 2.0, p.1].map(Double::of);
        (tangents.beyond(&tangent, p), tangents.distance(&tangent, p))
    };
    let off = 16.0 * EPSILON;
    // At the tips, outside and inside, and in the centre.
    for (normal, p, distance) in [
        ((1.0, 0.0), (3.0, 0.0), 1.0),
        ((0.0, -1.0), (0.0, -1.5), 0.5),
        ((0.0, 1.0), (0.0, 0.5), -0.5),
        ((0.0, 1.0), (0.0, 0.0), -1.0),
    ] {
        let (beyond, [low, high]) = between(normal, p);
        let size = f64::abs(distance) * off;
        assert_eq!(beyond, [distance - size, distance + size], "{p:?}");
        assert_eq!(low, distance - size);
        assert!(apart(high, distance + size) <= EPSILON, "{p:?}: {high}");
    }
    // By the normal of another point both are farther from the distance: 0.28 beyond the tangent, 1.2 from where that touches.
    let (beyond, [low, high]) = between((0.6, 0.8), (3.0, 0.0));
    let size = 1.44_f64.hypot(0.0).sqrt().hypot(0.8);
    let touch = Vec2::new(4.0 * 0.6 / size, 0.8 / size);
    assert!(apart(low, 1.8 - size) < 1e-14 && low == beyond[0], "{low}");
    assert!(
        apart(high, Vec2::new(3.0 - touch.x, touch.y).hypot()) < 1e-14,
        "{high}"
    );
}

#[test]
fn a_place_knows_what_rounding_does_to_its_distance() {
    // On the long axis at 1.1, where the distance is 0.1 and s too.
    let (radii, alpha) = (Vec2::new(1.0, 0.5), [1.0, 4.0]);
    let part = CubicPart::new([0.0, 1.0], [0.21; 7], [[1.1; 4], [0.0; 4]], false);
    let motion = part.motion_at(0.5, Vec2::ZERO);
    let foot = foot_in_unit(radii, alpha, Vec2::new(1.1, 0.0), motion.excess);
    let rounding = 1e-13;
    let place = NearestPoint::new(alpha, &part, &motion, foot, rounding);
    let (m, off) = (1.0 / 1.1, part.moved()[0] + EPSILON * 1.1);
    let along = m * 1.1 * off;
    let d = m * m * m * 1.21;
    let share = along * (1.0 + m) / d + along * m + 16.0 * EPSILON;
    let margin = 0.1 * share + rounding * 0.6 / d;
    assert!(
        apart(place.margin, margin) < 1e-9 * margin,
        "{}",
        place.margin
    );
    let s = place.multiplier();
    let radius = 0.1 * (along * (1.0 + m) / d + 8.0 * EPSILON) + rounding * 0.6 / d;
    assert!(apart(s.middle, 0.1) < 1e-15 && apart(s.radius, radius) < 1e-9 * radius);
    let [low, high] = place.between(0.25);
    assert!(apart(low, -0.15) < 1e-12 && apart(high, 0.35) < 1e-12);
    // As far as 1e-10 of it, or the last place.
    assert!(place.is_exact(0.0) && place.is_exact(1e-30));
    let rough = |rounding: f64, last_place: f64| {
        let foot = foot_in_unit(radii, alpha, Vec2::new(1.1, 0.0), motion.excess);
        NearestPoint::new(alpha, &part, &motion, foot, rounding).is_exact(last_place)
    };
    assert!(rough(1e-11, 0.0) && !rough(2e-11, 0.0));
    assert!(rough(2e-11, 1e-11) && !rough(1e-10, 1e-11));
}
