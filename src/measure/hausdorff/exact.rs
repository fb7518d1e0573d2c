//! Distances, places and nearest points that are known to the last digit.

use kurbo::Line;

use super::*;

#[test]
fn what_rounding_adds_to_a_distance_is_left_out() {
    let at = |y: f64| [PathSeg::Line(Line::new((0.0, y), (1.0, y)))];
    for i in 1..100 {
        let away = 0.1 * f64::from(i);
        let found = hausdorff(
            &mut Effort(u64::MAX),
            [&at(0.0), &at(away)],
            Aim::new(away, 1e-4),
        );
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
        let found = hausdorff(
            &mut Effort(u64::MAX),
            [&old, &line(from, to)],
            Aim::new(0.0, 1e-4),
        );
        assert_eq!((found.place, found.on_second), (Some((b, 0)), true));
    }
}
