//! Whole circles: those of one count are the same drawing of the unit circle, placed.

use crate::approximate::{self, automatic_precision, fewest, within};
use crate::curve::Curve;
use crate::joints::{Cut, Joints, quarters};
use crate::method::{Method, Piece, Rule, Span};
use crate::number::Precision;
use crate::numeric::functions::power;
use crate::path;
use crate::place::Placed;
use crate::shape::{Circle, Outline, Shape, UnitArc};

/// The most drawings that are kept, and the segments of those of which more than one is.
const MOST: usize = 64;
const FEW_SEGMENTS: usize = 1000;

/// How many counts are tried for a tolerance.
const MOST_TRIES: usize = 3;

/// A drawing of the unit circle by equal pieces, each taken on its own.
#[derive(Debug)]
struct UnitDrawing {
    unit: UnitArc,
    rule: Rule,
    joints: Joints,
    pieces: Vec<[Piece; 2]>,
    /// The peak error before rounding, and that of one piece less.
    peak: f64,
    peak_of_fewer: f64,
}

impl UnitDrawing {
    /// `None` where the rule cannot do it.
    fn new(unit: UnitArc, rule: Rule, count: usize) -> Option<Self> {
        let joints = Joints::equal(&unit, count).ok()?;
        let pieces = rule.pieces(&joints.spans, joints.closed).ok()?;
        let peak = |span: &Span| rule.radial_error(span).ok().map(|error| error.peak());
        let fewer = (count > 1).then(|| Span::from_degrees(360.0 / (count - 1) as f64));
        Some(Self {
            peak: peak(joints.spans.first()?)?,
            peak_of_fewer: fewer.and_then(|span| peak(&span)).unwrap_or(f64::INFINITY),
            unit,
            rule,
            joints,
            pieces,
        })
    }

    fn placed(&self, outline: &Outline) -> Curve {
        let placed = Placed::new(outline, &self.joints);
        placed.curve(self.pieces.iter().copied(), self.joints.closed)
    }
}

/// The drawings of the unit circle that were met.
#[derive(Debug, Default)]
pub(super) struct Turns {
    kept: Vec<UnitDrawing>,
}

impl Turns {
    /// The drawing for which this holds, or else the one of so many segments.
    fn find(
        &mut self,
        unit: UnitArc,
        rule: Rule,
        serves: impl Fn(&UnitDrawing) -> bool,
        count: impl FnOnce() -> Option<usize>,
    ) -> Option<&UnitDrawing> {
        let serves = |turn: &UnitDrawing| serves(turn) && turn.unit == unit && turn.rule == rule;
        if let Some(place) = self.kept.iter().position(serves) {
            return self.kept.get(place);
        }
        let turn = UnitDrawing::new(unit, rule, count()?)?;
        if self.kept.len() == MOST || turn.joints.count() > FEW_SEGMENTS {
            self.kept.clear();
        }
        self.kept.push(turn);
        self.kept.last()
    }

    /// Appends the path data of a circle, as [`approximate::sketch`] draws it; `None` where it has to go the way of every shape: where
    /// its error depends on more than one piece, and where rounding decides on its count.
    pub(super) fn push(
        &mut self,
        out: &mut Vec<u8>,
        circle: &Circle,
        options: &approximate::Options,
    ) -> Option<()> {
        let shape = Shape::Circle(*circle);
        let outline = shape.outline()?;
        let (unit, rule, radius) = (outline.unit, options.rule, circle.radius);
        if rule.method() == Some(Method::Chen1) {
            return None;
        }
        if let Some(Precision::Fixed(decimals)) = options.precision
            && radius * power(10.0, i32::from(decimals)) < 1.0
        {
            // It may vanish.
            return None;
        }
        let count = match options.cut {
            Cut::Quarters => quarters(unit.sweep),
            Cut::Count(count) => count,
            Cut::Tolerance(tolerance) => {
                let tolerance = tolerance.checked(radius).ok()?;
                return self.push_within(out, &shape, &outline, options, tolerance);
            }
            _ => return None,
        };
        let serves = |turn: &UnitDrawing| turn.joints.count() == count;
        let turn = self.find(unit, rule, serves, || Some(count))?;
        let curve = turn.placed(&outline);
        let precision = options
            .precision
            .unwrap_or_else(|| automatic_precision(turn.peak * radius, &curve.segments));
        path::push_rounded(out, &curve, precision);
        Some(())
    }

    /// The same for a tolerance, which the least count that may be within it meets mostly, or the next.
    fn push_within(
        &mut self,
        out: &mut Vec<u8>,
        circle: &Shape,
        outline: &Outline,
        options: &approximate::Options,
        tolerance: f64,
    ) -> Option<()> {
        // The error of a method falls with the count; a literal handle's and those of a table do not.
        if let Method::LancasterBest | Method::LancasterDrawellipse = options.rule.method()? {
            return None;
        }
        let truth = &outline.truth;
        let radius = truth.larger_radius();
        let allowed = (tolerance + fewest::rounding(options.precision, tolerance)) / radius;
        let reach = truth.center.to_vec2().hypot() + radius;
        let mut least = None;
        for more in 0..MOST_TRIES {
            let serves = |turn: &UnitDrawing| match least {
                Some(least) => turn.joints.count() == least + more,
                None => turn.peak <= allowed && turn.peak_of_fewer > allowed,
            };
            let count = || match least {
                Some(least) => Some(least + more),
                None => fewest::least_count(circle, options, tolerance),
            };
            let turn = self.find(outline.unit, options.rule, serves, count)?;
            let first = *least.get_or_insert(turn.joints.count());
            let peak = turn.peak * radius;
            let curve = turn.placed(outline);
            let precision = options
                .precision
                .unwrap_or_else(|| automatic_precision(peak.min(tolerance), &curve.segments));
            let by_formula = within::by_formula(peak, precision, reach, tolerance);
            // Given decimals may be refused before any is tried, and so are tolerances below the digits of coordinates.
            let is_plain = options.precision.is_none() && tolerance >= fewest::finest(reach);
            if by_formula.is_none() && (!is_plain || first > FEW_SEGMENTS) {
                return None;
            }
            let is_within = by_formula.unwrap_or_else(|| {
                let rounded = curve.rounded(precision, &[]);
                within::of_circle(&rounded.segments, truth, tolerance)
            });
            if is_within {
                path::push_rounded(out, &curve, precision);
                return Some(());
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joints::Tolerance;

    #[test]
    fn circles_are_those_that_every_shape_goes_the_way_of() {
        let mut turns = Turns::default();
        let mut kept = 0;
        for i in 0..4000_usize {
            let at = |k: usize| (i * k % 1009) as f64 / 1009.0;
            let center = (200.0 * at(11) - 100.0, 30.0 * at(17));
            let circle = Circle::new(center, 0.1 + 100.0 * at(7)).unwrap();
            let methods = [Method::Minimax, Method::Chen3, Method::MinimaxG0];
            let tolerance = libm::pow(10.0, -5.0 * at(23));
            let precision = [None, Some(Precision::Fixed(2)), Some(Precision::Full)][i % 3];
            let options = approximate::Options {
                rule: Rule::Method(methods[i % 7 % 3]),
                cut: Cut::Tolerance(Tolerance::Absolute(tolerance)),
                precision,
                ..approximate::Options::default()
            };
            let [mut own, mut way] = [const { Vec::new() }; 2];
            if turns.push(&mut own, &circle, &options).is_some() {
                kept += 1;
                let sketch = approximate::sketch(&Shape::Circle(circle), &options).unwrap();
                path::push_rounded(&mut way, &sketch.curve, sketch.precision);
                assert_eq!(String::from_utf8(own), String::from_utf8(way), "{i}");
            }
        }
        assert!(kept > 1000, "{kept}");
    }

    #[test]
    fn what_may_vanish_goes_the_way_of_every_shape() {
        let mut turns = Turns::default();
        let options = approximate::Options {
            precision: Some(Precision::Fixed(2)),
            ..approximate::Options::default()
        };
        let mut serves = |radius: f64| {
            let circle = Circle::new((0.0, 0.0), radius).unwrap();
            turns.push(&mut Vec::new(), &circle, &options).is_some()
        };
        assert!(serves(5.0) && serves(0.011));
        assert!(!serves(0.009) && !serves(0.0004));
    }

    #[test]
    fn what_may_be_refused_goes_the_way_of_every_shape() {
        let mut turns = Turns::default();
        let circle = Circle::new((0.0, 7000.0), 0.0085).unwrap();
        let mut serves = |tolerance: f64, precision| {
            let options = approximate::Options {
                cut: Cut::Tolerance(Tolerance::Absolute(tolerance)),
                precision,
                ..approximate::Options::default()
            };
            turns.push(&mut Vec::new(), &circle, &options).is_some()
        };
        // Coordinates of 7000 have digits down to 2 ε of that, and 8 of them are asked for.
        let finest = fewest::finest(7000.0085);
        assert!(!serves(0.99 * finest, None));
        assert!(serves(1e-4, None) && serves(1e-4, Some(Precision::Fixed(7))));
        assert!(!serves(1e-4, Some(Precision::Fixed(4))));
    }
}
