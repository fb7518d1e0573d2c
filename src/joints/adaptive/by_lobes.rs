//! The peak error by the lobes, before it is measured.

use super::lobes::Lobes;
use crate::joints::cutting::Cutting;
use crate::method::{Method, Rule};
use crate::shape::Axes;

/// How far the peak of a lobe may be off, as a part of it, of any segment where the ellipse is flat, and how large it has to be beside the
/// coordinates.
const LOBES_OFF: f64 = 0.01;
const LONG_LOBES_OFF: f64 = 0.05;
const OVER_ROUNDING: f64 = 4000.0 * f64::EPSILON;

/// Between what the peak error of pieces of an ellipse of this larger radius lies; the largest coordinate is about `reach`. `None` where
/// the lobes do not tell, or rounding counts beside them.
pub(crate) fn nearly(
    rule: Rule,
    axes: Axes,
    sizes: [f64; 2],
    cutting: &impl Cutting,
) -> Option<[f64; 2]> {
    let order = rule.method()?.card().law?.order;
    let lobes = Lobes::new(rule, f64::from(order), axes.short);
    let (mut peak, mut off) = (0.0_f64, LOBES_OFF);
    for i in 0..cutting.count() {
        let from = cutting.sign() * (cutting.angle(i) - axes.angle);
        let size = cutting.size(i);
        let lobe = lobes.of(from, size).or_else(|| {
            off = LONG_LOBES_OFF;
            lobes.of_any(from, size)
        });
        peak = peak.max(lobe?.size);
    }
    between(rule, sizes, peak, off)
}

/// The same by what the lobes told of the pieces, over the larger radius.
pub(crate) fn around(rule: Rule, sizes: [f64; 2], peak: f64) -> Option<[f64; 2]> {
    between(rule, sizes, peak, LOBES_OFF)
}

fn between(rule: Rule, [larger, reach]: [f64; 2], peak: f64, off: f64) -> Option<[f64; 2]> {
    // Curves that stay on one side have one lobe, which strays far from its place.
    let has_three = matches!(
        rule,
        Rule::Method(Method::Midpoint | Method::Minimax | Method::Goldapp | Method::Area)
    );
    if !has_three {
        return None;
    }
    let peak = larger * peak;
    (peak > OVER_ROUNDING * reach).then_some([1.0 - off, 1.0 + off].map(|part| part * peak))
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
            assert!((found - expected).abs() < 1e-12, "{told:?}");
        }
        // Beside coordinates of 150, not less than 4000 times their last digit.
        assert!(around(Rule::default(), [100.0, 150.0], 1.3e-12).is_none());
        assert!(around(Rule::default(), [100.0, 150.0], 1.4e-12).is_some());
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
