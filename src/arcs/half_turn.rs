//! Half a turn as it is printed: radii that are larger than its ends need by 10^-16 move the centre by 10^-8 of them.

use crate::numeric::double::Double;
use crate::numeric::functions::{power, unit_vector};
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Given, Outline, Shape};

/// Half a turn, with radii that are no larger than it needs: whoever reads it makes them as large.
pub(super) fn half_turn(arc: &SvgArc) -> SvgArc {
    /// By how much radii are made smaller, one try after the other: by a last digit, and then by twice as much each time, to what the last
    /// digits of ends are that lie far away.
    const ROUNDINGS: i32 = 8;
    const TRIES: i32 = 48;
    let mut half = *arc;
    let mut tries = (0..TRIES).map(|i| {
        half.radii *= 1.0 - f64::EPSILON / 2.0 * power(2.0, (i - ROUNDINGS).max(0));
        half
    });
    if is_half_turn(arc) {
        return *arc;
    }
    tries.find(is_half_turn).unwrap_or(*arc)
}

/// Whether radii are surely no larger than half a turn needs, in the decimals of its numbers too, which are no binary ones: half of a last
/// digit of each coordinate moves an end by no more than the last digit of the largest one.
fn is_half_turn(arc: &SvgArc) -> bool {
    let numbers = [arc.from.x, arc.from.y, arc.to.x, arc.to.y];
    let largest = numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let others = [arc.radii.x, arc.radii.y, arc.rotation.degrees()];
    let is_as_printed = numbers.into_iter().chain(others).all(is_decimal);
    if arc.radii.x == arc.radii.y {
        let square = |a: f64, b: f64| Double::difference(a, b).times(Double::difference(a, b));
        let (x, y) = (square(arc.to.x, arc.from.x), square(arc.to.y, arc.from.y));
        let diameter = square(2.0 * arc.radii.x, 0.0).scaled(-1.0);
        let more = x.plus(y).plus(diameter).value();
        let chord = arc.from.distance(arc.to);
        return more > 4.0 * f64::EPSILON * chord * chord.max(largest)
            || more == 0.0 && is_as_printed;
    }
    let (long, short) = (arc.radii.x.max(arc.radii.y), arc.radii.x.min(arc.radii.y));
    let more = 1.0 + 4.0 * f64::EPSILON * long.max(largest) / short;
    let is_larger = |whole: &Arc| is_as_printed || whole.radii.x > more * arc.radii.x;
    matches!(arc.shape(), Ok(Shape::Arc(whole)) if matches!(whole.given, Given::Enlarged(_)) && is_larger(&whole))
}

/// Whether a number is printed as it is: of 15 digits no two decimals are one float.
fn is_decimal(x: f64) -> bool {
    (0..=15).any(|places| {
        let scaled = x * power(2.0, places);
        scaled == scaled.trunc() && x.abs() * power(10.0, places) < 1e15
    })
}

/// How far an arc as it is printed lies from the true one, at most. Where it is about half a turn or nearly a whole one, its ends and
/// radii tell it badly: with u what a last digit of the coordinates is on the unit circle, and h half the turn, the centre moves there by
/// sqrt(cos² h + 2u) - |cos h| square to the chord, unless radii are too small and so tell nothing, and by u/sin h along it. What is no
/// more than the noise of coordinates is 0.
pub(super) fn from_truth(arc: &Arc, outline: &Outline) -> f64 {
    /// Below it, in degrees, what moves the ends moves nothing farther.
    const SMALL: f64 = 90.0;
    /// What maps and square roots leave of a coordinate.
    const NOISE: f64 = 16.0 * f64::EPSILON;
    let truth = &outline.truth;
    if outline.unit.sweep.degrees().abs() < SMALL {
        return 0.0;
    }
    let size = truth.center.to_vec2().hypot() + truth.larger_radius();
    let last_digit = f64::EPSILON * size / truth.radii.x.min(truth.radii.y);
    let half = unit_vector(0.5 * arc.sweep.degrees().to_radians());
    let (cos, sin) = (half.x.abs(), half.y.abs());
    let across = match arc.given {
        Given::Enlarged(_) => 0.0,
        _ => (cos * cos + 2.0 * last_digit).sqrt() - cos,
    };
    let told = truth.larger_radius() * (across + last_digit / sin);
    let off = arc.center.distance(truth.center) + told;
    if off > NOISE * size { off } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Angle;
    use kurbo::{Point, Vec2};

    #[test]
    fn half_a_turn_far_away_is_one_in_its_decimals_too() {
        let half = |from: (f64, f64), to: (f64, f64), radius| {
            half_turn(&SvgArc {
                from: from.into(),
                radii: Vec2::splat(radius),
                rotation: Angle::ZERO,
                large_arc: false,
                sweep: true,
                to: to.into(),
            })
        };
        // 3 and 1 in decimals.
        let right = 10.0_f64.sqrt() / 2.0;
        let far = half(
            (1e6 + 0.1, 1e6 + 0.3),
            (1e6 + 3.1, 1e6 + 1.3),
            right + 1e-10,
        );
        assert!(far.radii.x < right && far.radii.x > right - 2e-9, "{far:?}");
        let Ok(Shape::Arc(arc)) = far.shape() else {
            panic!("{far:?}")
        };
        assert!(arc.center.distance(Point::new(1e6 + 1.6, 1e6 + 0.8)) < 1e-9);
        // Whole numbers are what they are.
        assert_eq!(half((1e6, 0.0), (1e6 + 10.0, 0.0), 5.0).radii.x, 5.0);
        assert_eq!(half((0.0, 0.5), (0.0, 3.0), 1.25).radii.x, 1.25);
    }
}
