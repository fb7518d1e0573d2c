//! The peak error by the lobes, before it is measured.

use kurbo::Vec2;

use super::lobes::{Lobes, SHORTEST, after_sharp_end};
use super::touching::TouchingCubic;
use crate::angle::Angle;
use crate::joints::cutting::Cutting;
use crate::method::{Method, Rule, in_frame};
use crate::shape::Axes;

/// How far the peak of a lobe may be off, as a part of it, and of any segment where the ellipse is flat.
const LOBES_OFF: f64 = 0.01;
const LONG_LOBES_OFF: f64 = 0.05;

/// How far rounding may move a point, as a part of the largest coordinate.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Up to this largest product of the excess with the square of the ratio of the radii the first order tells the distance to a hundredth.
const FIRST_ORDER: f64 = 0.01;

/// As [`nearly`], less closely and at a fraction of the cost, for pieces of one size: with F and Q as in [`super::lobes`] the peak distance is
/// F/(2√Q) at least at every lobe, and at most that of the largest F and the least Q of the arc, to first order.
pub(crate) fn roughly(
    rule: Rule,
    axes: Axes,
    sizes: [f64; 2],
    cutting: &impl Cutting,
) -> Option<[f64; 2]> {
    let (count, size) = (cutting.count(), cutting.size(0));
    if !has_three_lobes(rule) || size < SHORTEST || !is_even(cutting) {
        return None;
    }
    let cubic = TouchingCubic::new(rule, size)?;
    let outer = cubic.outer()?;
    let lobes = [-outer, 0.0, outer].map(|v| {
        let u = TouchingCubic::u(v);
        (cubic.point(v, u), cubic.excess(u))
    });
    let flat = 1.0 / (axes.short * axes.short);
    let largest = lobes.map(|(_, excess)| excess.abs());
    let largest = largest.into_iter().fold(0.0, f64::max);
    if largest * flat > FIRST_ORDER {
        return None;
    }
    let weight = |at: Vec2| flat * at.x * at.x + at.y * at.y;
    let from = cutting.sign() * (cutting.angle(0) - axes.angle);
    let turned = |degrees: f64| Angle::from_degrees(from + degrees).direction();
    let (mut middle, step) = (turned(size / 2.0), Angle::from_degrees(size).direction());
    // Squares: one root at the end serves all.
    let mut attained = 0.0_f64;
    for _ in 0..unlike(cutting) {
        for ([x, y], excess) in lobes {
            attained = attained.max(excess * excess / weight(in_frame(middle, x, y)));
        }
        middle = in_frame(middle, step.x, step.y);
    }
    let whole = count as f64 * size;
    let least = if after_sharp_end(from) + whole >= 180.0 {
        1.0
    } else {
        weight(turned(0.0)).min(weight(turned(whole)))
    };
    let squares = [attained, largest * largest / least];
    let [low, high] = squares.map(|square| square.sqrt() / 2.0);
    let [[low, _], [_, high]] = [low, high].map(|peak| between(sizes, peak, LOBES_OFF));
    Some([low, high])
}

/// A lower and an upper bound of the peak error of pieces of an ellipse of this larger radius, the largest coordinate being about as large as the other
/// of these sizes. `None` where the lobes do not tell.
pub(crate) fn nearly(
    rule: Rule,
    axes: Axes,
    sizes: [f64; 2],
    cutting: &impl Cutting,
) -> Option<[f64; 2]> {
    if !has_three_lobes(rule) {
        return None;
    }
    let order = rule.method()?.card().law?.order;
    let lobes = Lobes::new(rule, f64::from(order), axes.short);
    let (mut peak, mut off) = (0.0_f64, LOBES_OFF);
    for i in 0..unlike(cutting) {
        let from = cutting.sign() * (cutting.angle(i) - axes.angle);
        let size = cutting.size(i);
        let lobe = lobes.of(from, size).or_else(|| {
            off = LONG_LOBES_OFF;
            lobes.of_any(from, size)
        });
        peak = peak.max(lobe?.size);
    }
    Some(between(sizes, peak, off))
}

/// How many pieces are to be looked at, from the first on: of a whole turn in an even number of equal ones the second half is the first,
/// turned by half a turn.
fn unlike(cutting: &impl Cutting) -> usize {
    let (count, size) = (cutting.count(), cutting.size(0));
    let is_turn = count as f64 * size == 360.0 && count.is_multiple_of(2);
    if is_turn && is_even(cutting) {
        count / 2
    } else {
        count
    }
}

/// Whether all pieces have one size.
fn is_even(cutting: &impl Cutting) -> bool {
    (1..cutting.count()).all(|i| cutting.size(i) == cutting.size(0))
}

/// The same by what the lobes told of the pieces, over the larger radius.
pub(crate) fn around(rule: Rule, sizes: [f64; 2], peak: f64) -> Option<[f64; 2]> {
    has_three_lobes(rule).then(|| between(sizes, peak, LOBES_OFF))
}

/// Whether its curves stray to both sides: those that stay on one have one lobe, which lies far from its place.
const fn has_three_lobes(rule: Rule) -> bool {
    matches!(
        rule,
        Rule::Method(Method::Midpoint | Method::Minimax | Method::Goldapp | Method::Area)
    )
}

fn between([larger, reach]: [f64; 2], peak: f64, off: f64) -> [f64; 2] {
    let (peak, rounding) = (larger * peak, ROUNDING * reach);
    let low = (1.0 - off) * peak - rounding;
    [low.max(0.0), (1.0 + off) * peak + rounding]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::angle::Angle;
    use crate::joints::Joints;
    use crate::shape::UnitArc;

    #[test]
    fn a_peak_is_told_to_a_hundredth() {
        let told = around(Rule::default(), [100.0, 150.0], 1e-3).unwrap();
        for (found, expected) in told.into_iter().zip([0.099, 0.101]) {
            assert!((found - expected).abs() < 2e-12, "{told:?}");
        }
        // Beside coordinates of 150, no closer than 32 times their last digit.
        let [low, high] = around(Rule::default(), [100.0, 150.0], 1e-15).unwrap();
        assert!(low == 0.0 && (1.0e-12..1.2e-12).contains(&high), "{high}");
    }

    #[test]
    fn joints_count_from_the_axis() {
        let told = |axis: f64, start: f64| {
            let axes = Axes {
                short: 0.3,
                angle: axis,
            };
            let arc = UnitArc {
                start: Angle::from_degrees(start),
                sweep: Angle::from_degrees(70.0),
                closed: false,
            };
            let joints = Joints::equal(&arc, 3).unwrap();
            nearly(Rule::default(), axes, [100.0, 100.0], &joints).unwrap()
        };
        let [along, turned] = [told(0.0, 10.0), told(25.0, 35.0)];
        assert!((along[0] / turned[0] - 1.0).abs() < 1e-9);
        assert!((along[0] / told(-25.0, 35.0)[0] - 1.0).abs() > 0.1);
    }
}
