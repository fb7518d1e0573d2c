//! Wherever a curve runs, no place of it lies beyond what is stated.

use kurbo::{CubicBez, ParamCurve, PathSeg, Point, Vec2};

use super::Dice;
use crate::measure::radial::{distance, error};
use crate::shape::Truth;

#[test]
fn no_place_lies_beyond_what_is_stated() {
    let mut dice = Dice(5);
    for i in 0..3000 {
        let radii = [(1.0, 1.0), (1.0, 0.5), (0.3, 1.0), (1.0, 0.05)][i % 4];
        let axis = Vec2::from_angle(3.0 * dice.next());
        let truth = Truth::new(Point::new(0.25, -0.5), radii.into(), axis);
        // Some have one control point far away.
        let near = if i % 3 == 0 { 3.0 } else { 1.2 };
        let far = if i % 5 < 2 { 4.0 } else { near };
        let mut points = [(); 4].map(|()| {
            let [x, y] = dice.some::<2>();
            truth.center + Vec2::new(x, y) * near
        });
        let [x, y] = dice.some::<2>();
        points[i % 4] = truth.center + Vec2::new(x, y) * far;
        let [a, b, c, d] = points;
        let segment = PathSeg::Cubic(CubicBez::new(a, b, c, d));
        let stated = error([&segment], &truth);
        for k in 0..=100 {
            let off = distance(&truth, segment.eval(f64::from(k) / 100.0));
            assert!(
                off <= stated.outward + 1e-12 && -off <= stated.inward + 1e-12,
                "{i} {k}: {off} {stated:?}"
            );
        }
    }
}
