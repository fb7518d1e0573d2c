//! How many decimals a curve needs.

use kurbo::PathSeg;

use crate::curve::largest_coordinate;
use crate::joints::adaptive;
use crate::joints::cutting::Cutting;
use crate::measure::radial::{
    self,
    nearly::{agreed, decided},
};
use crate::method::Rule;
use crate::number::Precision;
use crate::shape::{Axes, Truth};

/// The part of the peak error, or of the tolerance, that rounding for output may add.
pub(crate) const ROUNDING_SHARE: f64 = 0.1;

/// The fewest decimals for which rounding moves no point farther than a tenth of `error`.
pub(crate) fn automatic_precision<'a>(
    error: f64,
    segments: impl IntoIterator<Item = &'a PathSeg>,
) -> Precision {
    Precision::moving_at_most(ROUNDING_SHARE * error, largest_coordinate(segments))
}

/// What is known of a curve before it is measured.
pub(crate) struct KnownCurve<'a, C> {
    pub(crate) rule: Rule,
    pub(crate) truth: &'a Truth,
    pub(crate) axes: Axes,
    pub(crate) cutting: &'a C,
    /// Its peak error, where a formula tells it.
    pub(crate) peak: Option<f64>,
    /// The same over the larger radius, where the lobes of its pieces told it before.
    pub(crate) told: Option<f64>,
}

impl<C: Cutting> KnownCurve<'_, C> {
    /// The fewest decimals for a peak error of at most `most`. Mostly what the lobes of the pieces or samples tell of the peak asks for
    /// as many decimals as the exact one.
    pub(crate) fn precision<S: Iterator<Item = PathSeg>>(
        &self,
        most: f64,
        segments: impl Fn() -> S,
    ) -> Precision {
        let truth = self.truth;
        let largest = largest_coordinate(segments());
        let for_peak =
            |peak: f64| Precision::moving_at_most(ROUNDING_SHARE * peak.min(most), largest);
        if let Some(peak) = self.peak {
            return for_peak(peak);
        }
        let roughly = self.by_lobes(largest, adaptive::roughly);
        let decided = roughly
            .and_then(|between| agreed(between, for_peak))
            .or_else(|| {
                let nearly = self.by_lobes(largest, adaptive::nearly);
                decided(nearly, &segments, truth, for_peak)
            });
        decided.unwrap_or_else(|| {
            let segments: Vec<PathSeg> = segments().collect();
            let between = radial::peak_nearly(&segments, truth, most);
            agreed(between, for_peak)
                .unwrap_or_else(|| for_peak(radial::error_within(&segments, truth, most).peak()))
        })
    }

    /// A lower and an upper bound of the peak error on an ellipse by the lobes of the pieces, looked at in this way where they told nothing before.
    fn by_lobes(
        &self,
        largest: f64,
        look: impl Fn(Rule, Axes, [f64; 2], &C) -> Option<[f64; 2]>,
    ) -> Option<[f64; 2]> {
        if self.truth.is_circle() {
            return None;
        }
        let larger = self.truth.larger_radius();
        let sizes = [larger, larger + largest];
        match self.told {
            Some(peak) => adaptive::around(self.rule, sizes, peak),
            None => look(self.rule, self.axes, sizes, self.cutting),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joints::Joints;
    use crate::joints::cutting::EqualPieces;
    use crate::{Angle, Arc, Cut, Ellipse, Method, Options, Shape, approximate};

    #[test]
    fn lobes_tell_as_closely_as_coordinates_have_digits() {
        let ellipse = Ellipse::new((0.0, 0.0), (100.0, 40.0), Angle::ZERO).unwrap();
        let outline = Shape::Ellipse(ellipse).outline().unwrap();
        let cutting = EqualPieces::new(outline.unit, 12).unwrap();
        // However the pieces are kept.
        let joints = Joints::equal(&outline.unit, 12).unwrap();
        let (rule, axes) = (Rule::default(), outline.axes());
        for reach in [200.0, 1e7, 1e12] {
            let told = adaptive::nearly(rule, axes, [100.0, reach], &joints).unwrap();
            let other = adaptive::nearly(rule, axes, [100.0, reach], &cutting);
            assert_eq!(Some(told), other);
            // The peak is 1e-5 or so.
            let [low, high] = told;
            let rounding = (high - low) / 2.0 - 0.01 * f64::midpoint(low, high);
            let least = reach * f64::EPSILON;
            assert!(
                low == 0.0 || (least..100.0 * least).contains(&rounding),
                "{told:?}"
            );
            assert_eq!(low == 0.0, reach == 1e12);
        }
    }

    #[test]
    fn decimals_are_those_that_the_exact_peak_asks_for() {
        let mut seen = std::collections::BTreeSet::new();
        // Peaks over a factor of ten, so close to one another that some lie beside where one decimal more is needed.
        for i in 0..400 {
            let size = libm::pow(10.0, f64::from(i) / 400.0);
            let radii = (100.0 * size, 60.0 * size);
            let shape = Shape::Ellipse(Ellipse::new((0.0, 0.0), radii, Angle::ZERO).unwrap());
            let drawn = |precision| {
                let options = Options {
                    rule: Method::QuadraticMinimax.into(),
                    cut: Cut::Count(9),
                    precision,
                    ..Options::default()
                };
                approximate(&shape, &options).unwrap()
            };
            let exact = drawn(Some(Precision::Full));
            let segments = &exact.curve.segments;
            let expected =
                Precision::moving_at_most(0.1 * exact.error.peak(), largest_coordinate(segments));
            assert_eq!(automatic_precision(exact.error.peak(), segments), expected);
            let found = drawn(None).precision;
            assert_eq!(found, expected, "{size}");
            seen.insert(format!("{found:?}"));
        }
        assert_eq!(seen.len(), 2, "{seen:?}");
    }

    #[test]
    fn a_peak_is_not_known_to_be_larger_than_it_is() {
        let mut bounded = 0;
        for i in 0..400_usize {
            let at = |k: usize| (i * k % 1009) as f64 / 1009.0;
            let radii = (300.0, 300.0 * libm::pow(0.02, at(7)));
            let degrees = Angle::from_degrees;
            let (start, sweep) = (degrees(360.0 * at(11)), degrees(10.0 + 340.0 * at(17)));
            let arc = Arc::new(
                (300.0, -200.0),
                radii,
                degrees(180.0 * at(23)),
                start,
                sweep,
            );
            let options = Options {
                precision: Some(Precision::Full),
                ..Options::default()
            };
            let drawing = approximate(&Shape::Arc(arc.unwrap()), &options).unwrap();
            let truth = drawing.outline.unwrap().truth;
            let peak = drawing.error.peak();
            let [least, most] = radial::peak_nearly(&drawing.curve.segments, &truth, f64::INFINITY);
            assert!(least <= peak && peak <= most, "{least} {peak} {most}");
            bounded += usize::from(most > 1.000_1 * peak);
        }
        assert!(bounded > 40, "{bounded}");
    }

    #[test]
    fn the_largest_excess_and_the_least_weight_enclose_the_peak() {
        let methods = [
            Method::Midpoint,
            Method::Minimax,
            Method::Goldapp,
            Method::Area,
        ];
        let (mut told, mut widest) = (0, 0.0_f64);
        for i in 0..2000_usize {
            let at = |k: usize| (i * k % 2003) as f64 / 2003.0;
            let degrees = Angle::from_degrees;
            let radii = (300.0, 300.0 * libm::pow(0.02, at(7)));
            let sweep = 720.0 * at(17) - 360.0;
            let arc = Arc::new(
                (300.0, -200.0),
                radii,
                degrees(180.0 * at(23)),
                degrees(360.0 * at(11)),
                degrees(sweep),
            );
            let shape = Shape::Arc(arc.unwrap());
            let rule = methods[i % 4].into();
            let count = 1 + i / 4 % 12;
            let options = Options {
                rule,
                cut: Cut::Count(count),
                precision: Some(Precision::Full),
                ..Options::default()
            };
            let outline = shape.outline().unwrap();
            let cutting = EqualPieces::new(outline.unit, count).unwrap();
            let sizes = [300.0, 1000.0];
            let Some([low, high]) = adaptive::roughly(rule, outline.axes(), sizes, &cutting) else {
                continue;
            };
            let peak = approximate(&shape, &options).unwrap().error.peak();
            assert!(low <= peak && peak <= high, "{i}: {low} {peak} {high}");
            (told, widest) = (told + 1, widest.max(high / low));
        }
        assert!(told > 1200 && widest > 5.0, "{told} {widest}");
    }
}
