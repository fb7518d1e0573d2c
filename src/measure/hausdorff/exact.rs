//! Distances, places and nearest points that are known to the last digit.

use super::*;

#[test]
fn what_rounding_adds_to_a_distance_is_left_out() {
    let at = |y: f64| [PathSeg::Line(Line::new((0.0, y), (1.0, y)))];
    for i in 1..100 {
        let away = 0.1 * f64::from(i);
        let found = hausdorff([&at(0.0), &at(away)], away, 1e-4);
        assert_eq!(found.at_most, away);
        // Of places that are as far away it is the first.
        assert_eq!(found.place, Some((Point::ORIGIN, 0)));
        assert!(!found.on_second);
    }
}

#[test]
fn the_place_is_the_farthest_one() {
    let line = |from: Point, to: Point| [PathSeg::Line(Line::new(from, to))];
    let (a, b) = (Point::new(0.0, 1.0), Point::new(20.0, 0.0));
    for (from, to) in [(a, b), (b, a)] {
        let old = line(Point::ORIGIN, Point::new(10.0, 0.0));
        let found = hausdorff([&old, &line(from, to)], 0.0, 1e-4);
        assert_eq!((found.place, found.on_second), (Some((b, 0)), true));
    }
}

#[test]
fn the_sign_of_0_makes_no_segment_another() {
    let key = |x: f64, y: f64| key(&PathSeg::Line(Line::new((x, y), (1.0, 2.0))));
    assert_eq!(key(-0.0, -0.0), key(0.0, 0.0));
}

#[test]
fn the_nearest_point_of_a_line_is_exact() {
    for (x, y) in [(1.0, 0.0), (0.5, 0.75), (-0.25, 1.0)] {
        let chain = Chain::new(&[PathSeg::Line(Line::new((0.0, 0.0), (x, y)))], 1.0);
        for k in 0..=64 {
            let u = f64::from(k) / 64.0;
            let foot = chain.foot(0, Point::new(u * x - y, u * y + x));
            assert_eq!(foot.u, u);
        }
    }
}
