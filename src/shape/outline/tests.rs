//! Axes, extremes and maps by known answers.

use super::*;
use crate::{Ellipse, Shape};

#[test]
fn the_short_axis_of_a_rotated_ellipse_is_its_smaller_radius() {
    for degrees in (0..360).map(f64::from) {
        for (radii, angle) in [((100.0, 30.0), 90.0), ((30.0, 100.0), 0.0)] {
            let ellipse = Ellipse::new((7.0, 9.0), radii, Angle::from_degrees(degrees));
            let outline = Shape::Ellipse(ellipse.unwrap()).outline().unwrap();
            assert_eq!(outline.axes().angle, angle, "{degrees}");
        }
    }
}

#[test]
fn the_axes_of_a_sheared_circle_are_its_own() {
    // The columns of the map, and the angle at which |M u| is least: where its derivative vanishes and it is short.
    for columns in [
        [1.0, 0.0, 0.6, 0.8],
        [1.0, 0.0, -0.6, 0.8],
        [1.0, 0.0, 0.05, 0.5],
        [1.0, 0.0, 0.3, 0.9],
        [0.2, 0.1, 1.0, 3.0],
        [0.5, 0.05, -0.1, 1.0],
        [1.0, 1e-9, 0.0, 0.5],
    ] {
        let [a, b, c, d] = columns;
        for scale in [1.0, 1e-9, 1e9] {
            let map = Affine::new([a * scale, b * scale, c * scale, d * scale, 0.0, 0.0]);
            let circle = Shape::Circle(crate::Circle::new((0.0, 0.0), 1.0).unwrap());
            let outline = circle.outline().unwrap().transformed(map).unwrap();
            let axes = outline.axes();
            let image = |degrees: f64| {
                let u = Angle::from_degrees(degrees).direction();
                Vec2::new(a * u.x + c * u.y, b * u.x + d * u.y).hypot()
            };
            let [short, long] = [axes.angle, axes.angle + 90.0].map(image);
            let area = (a * d - b * c).abs();
            assert!((short * long - area).abs() < 1e-14, "{columns:?}: {axes:?}");
            assert!(short < long, "{columns:?}: {axes:?}");
            assert!((axes.short - short / long).abs() < 1e-14);
            assert!((outline.truth.radii.x / (scale * long) - 1.0).abs() < 1e-14);
            assert!((outline.truth.radii.y / (scale * short) - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_map_flattens_by_its_ratio_whatever_its_size() {
    let circle = Shape::Circle(crate::Circle::new((0.0, 0.0), 1.0).unwrap());
    let outline = circle.outline().unwrap();
    for scale in [1e-12, 1.0, 1e12] {
        let map = |flatness: f64| Affine::scale_non_uniform(scale, scale * flatness);
        assert!(outline.transformed(map(1e-11)).is_ok(), "{scale}");
        assert_eq!(
            outline.transformed(map(1e-16)),
            Err(Error::Shape(ShapeError::Flattened)),
            "{scale}"
        );
    }
}

#[test]
fn opposite_extremes_are_half_a_turn_apart() {
    let ellipse = Ellipse::new((7.0, 9.0), (3.0, 2.0), Angle::from_degrees(30.0)).unwrap();
    let outline = Shape::Ellipse(ellipse).outline().unwrap();
    let [right, left, upper, lower] = outline.extremes();
    assert_eq!(left.degrees(), right.degrees() + 180.0);
    assert_eq!(lower.degrees(), upper.degrees() + 180.0);
    let at = |angle: Angle| outline.placement * angle.direction().to_point();
    assert!(at(right).x > 7.0 && at(left).x < 7.0);
    assert!(at(upper).y > 9.0 && at(lower).y < 9.0);
}

#[test]
fn a_chord_tells_more_than_the_centre_up_to_three_quarters_of_a_turn() {
    let circle = Truth::circle((1.0, 2.0).into(), 5.0);
    for (sweep, is_about_start) in [(10.0, true), (-260.0, true), (280.0, false)] {
        let ends = [0.0, sweep].map(|degrees| {
            circle.center + Angle::from_degrees(degrees).direction() * circle.radii.x
        });
        let truth = circle.through(ends, Angle::from_degrees(sweep), Given::Sweep);
        let exact = truth.frame.exact(truth.radii);
        let start = exact
            .point(crate::shape::decimals(ends[0]))
            .map(Double::value);
        assert_eq!(start == [0.0; 2], is_about_start, "{sweep}");
        let [x, y] = exact.center().map(Double::value);
        let arm = Vec2::new(x - start[0], y - start[1]).hypot();
        assert!((arm - 5.0).abs() < 1e-14, "{sweep}: {arm}");
    }
}

#[test]
fn similarities_keep_a_circle_and_nothing_else_does() {
    for (columns, radius) in [
        ([0.6, 0.8, -0.8, 0.6], Some(1.0)),
        ([0.6, 0.8, 0.8, -0.6], Some(1.0)),
        ([-3.0, 0.0, 0.0, -3.0], Some(3.0)),
        ([2.0, 1.0, 1.0, 2.0], None),
        ([2.0, 1.0, -1.0, -2.0], None),
        ([2.0, 0.0, 0.0, 3.0], None),
    ] {
        let [a, b, c, d] = columns;
        let truth = Truth::of(Affine::new([a, b, c, d, 0.0, 0.0])).unwrap();
        assert_eq!(
            truth.is_circle().then_some(truth.radii.x),
            radius,
            "{columns:?}"
        );
    }
    for (x, y, short, angle) in [
        (3.0, 2.0, 2.0 / 3.0, 90.0),
        (2.0, 3.0, 2.0 / 3.0, 0.0),
        (4.0, 4.0, 1.0, 90.0),
    ] {
        assert_eq!(Axes::of(Vec2::new(x, y)), Axes { short, angle });
    }
    for (columns, is_so) in [
        ([1.0, 0.0, 0.0, 1e-9], false),
        ([1.0, 1.0, 1.0, 1.5], true),
        ([3.0, 1.0, 2.0, 3.0], false),
        ([4.0, 0.0, 0.0, 0.25], false),
        ([0.0, 4.0, 0.25, 0.0], false),
    ] {
        let [a, b, c, d] = columns;
        assert_eq!(
            cancels(Affine::new([a, b, c, d, 0.0, 0.0])),
            is_so,
            "{columns:?}"
        );
    }
    // By the ratio of the radii, whatever their size.
    for (radii, serves) in [
        ((1e13, 1e2), true),
        ((1e13, 1.0), false),
        ((1e-16, 1e-3), false),
    ] {
        assert_eq!(positive_radii(radii.into()).is_ok(), serves, "{radii:?}");
    }
    for (radii, named) in [((0.0, 0.0), "radius"), ((0.0, 1.0), "radii")] {
        let refused = positive_radii(radii.into());
        let is_named = matches!(refused, Err(Error::NotPositive { what, .. }) if what == named);
        assert!(is_named, "{radii:?}");
    }
}

#[test]
fn a_map_that_nearly_flattens_keeps_the_area_of_an_enlarged_arc() {
    // Radii of 1 are enlarged to 2, and the map divides areas by 1024.
    let map = Affine::new([1.0, 1.0, 1.0, 1.0 + 1.0 / 1024.0, 0.0, 0.0]);
    for radius in [1.0, 2.0, 2.5] {
        let text = format!("M0 0A{radius} {radius} 0 0 1 4 0");
        let arc = crate::shape::endpoint::parse_svg_arc(&text).unwrap();
        let outline = arc.shape().unwrap().outline().unwrap();
        let Vec2 { x, y } = outline.transformed(map).unwrap().truth.radii;
        let radius = f64::max(radius, 2.0);
        let off = x * y * 1024.0 / (radius * radius) - 1.0;
        assert!(off.abs() < 1e-13, "{radius}: {off}");
    }
}
