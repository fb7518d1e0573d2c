//! Whole circles: each is the same drawing of the unit circle, placed.

use crate::approximate::{self, automatic_precision};
use crate::joints::{Cut, Joints, quarters};
use crate::method::{Method, Piece, Rule};
use crate::number::Precision;
use crate::numeric::functions::power;
use crate::path;
use crate::place::Placed;
use crate::shape::{Circle, Shape, UnitArc};

/// A drawing of the unit circle by equal pieces, each taken on its own.
#[derive(Debug)]
pub(super) struct Turn {
    unit: UnitArc,
    rule: Rule,
    joints: Joints,
    pieces: Vec<[Piece; 2]>,
    /// The peak error before rounding.
    peak: f64,
}

impl Turn {
    /// `None` where the error depends on more than one piece, and where the rule cannot do it.
    fn new(unit: UnitArc, rule: Rule, count: usize) -> Option<Self> {
        if rule.method() == Some(Method::Chen1) {
            return None;
        }
        let joints = Joints::equal(&unit, count).ok()?;
        let pieces = rule.pieces(&joints.spans, joints.closed).ok()?;
        let peak = rule.radial_error(joints.spans.first()?).ok()?.peak();
        Some(Self {
            unit,
            rule,
            joints,
            pieces,
            peak,
        })
    }

    /// Appends the path data of a circle that is cut into a known number of equal segments, as [`approximate::sketch`] draws it, by
    /// the last such drawing where that serves; `None` where the circle has to go the way of every shape.
    pub(super) fn push(
        last: &mut Option<Self>,
        out: &mut Vec<u8>,
        circle: &Circle,
        options: &approximate::Options,
    ) -> Option<()> {
        let outline = Shape::Circle(*circle).outline()?;
        let (unit, rule) = (outline.unit, options.rule);
        let count = match options.cut {
            Cut::Quarters => quarters(unit.sweep),
            Cut::Count(count) => count,
            _ => return None,
        };
        let serves =
            |turn: &Self| turn.unit == unit && turn.rule == rule && turn.joints.count() == count;
        if !last.as_ref().is_some_and(serves) {
            *last = Some(Self::new(unit, rule, count)?);
        }
        let turn = last.as_ref()?;
        let precision = options.precision;
        if let Some(Precision::Fixed(decimals)) = precision
            && circle.radius * power(10.0, i32::from(decimals)) < 1.0
        {
            // It may vanish.
            return None;
        }
        let placed = Placed::new(&outline, &turn.joints);
        let curve = placed.curve(turn.pieces.iter().copied(), unit.closed);
        let precision = precision
            .unwrap_or_else(|| automatic_precision(turn.peak * circle.radius, &curve.segments));
        path::push_rounded(out, &curve, precision);
        Some(())
    }
}
