//! The arguments of the curve commands that an arc becomes.

use kurbo::{ParamCurve, PathSeg, Point, Vec2};

use crate::document::path::beziers::{Beziers, arguments};
use crate::document::{Options, Reason};
use crate::measure::radial;
use crate::number::decimal::{After, BelowOne, Decimal};
use crate::number::{decimals_for, read as number};
use crate::path_data::Segment;
use crate::path_data::grammar::after_separator;
use crate::shape::endpoint::SvgArc;

/// Coordinates beyond this are left alone.
const FARTHEST: f64 = 1e15;

/// What is known of the arguments of the curve commands for one arc.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::document) struct CurveFacts {
    /// What they end with.
    pub(in crate::document) after: After,
    pub(in crate::document) quadratic: bool,
    pub(in crate::document) segments: usize,
    /// The end point of an arc, as its numbers give it.
    pub(in crate::document) to: Option<[f64; 2]>,
    /// Their peak error, where it was measured.
    pub(in crate::document) strayed: f64,
}

impl CurveFacts {
    pub(in crate::document) fn new(
        arc: &SvgArc,
        options: &Options,
        drawn: &Beziers,
        after: After,
    ) -> Self {
        Self {
            after,
            quadratic: drawn.is_quadratic(),
            segments: drawn.segments.len(),
            to: Some([arc.to.x, arc.to.y]),
            strayed: strayed(arc, options, drawn),
        }
    }
}

/// The arguments of the curve commands for one arc, before they are joined to what stands before them.
#[derive(Debug, Default)]
pub(in crate::document) struct Body {
    pub(in crate::document) text: Vec<u8>,
    pub(in crate::document) facts: CurveFacts,
}

/// The arguments of curves, wherever they are kept.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::document) struct CurveArguments<'a> {
    pub(in crate::document) text: &'a [u8],
    pub(in crate::document) facts: CurveFacts,
}

impl Body {
    pub(in crate::document) fn curve(&self) -> CurveArguments<'_> {
        CurveArguments {
            text: &self.text,
            facts: self.facts,
        }
    }
}

/// The arguments of absolute curves; returns what they end with.
pub(in crate::document) fn absolute(
    data: &str,
    segment: &Segment,
    from: Vec2,
    drawn: &Beziers,
    out: &mut Vec<u8>,
) -> Result<After, Reason> {
    let mut after = After::Letter;
    for (segment, is_last) in with_last(&drawn.segments) {
        let (points, count) = arguments(segment);
        for point in &points[..count - usize::from(is_last)] {
            let at = *point + from;
            check_size(at)?;
            after.push(out, Decimal::round(at.x, drawn.decimals), BelowOne::Short);
            after.push(out, Decimal::round(at.y, drawn.decimals), BelowOne::Short);
        }
    }
    after.push_text(out, &data.as_bytes()[segment.tail..segment.end]);
    Ok(after)
}

/// The arguments of relative curves, on a grid that begins at the arc's start: each number is a difference of two rounded ones.
pub(in crate::document) fn relative(
    data: &str,
    segment: &Segment,
    drawn: &Beziers,
    out: &mut Vec<u8>,
) -> Result<After, Reason> {
    let grid = |p: Point| {
        [
            Decimal::round(p.x, drawn.decimals),
            Decimal::round(p.y, drawn.decimals),
        ]
    };
    let mut joint = [Decimal::ZERO; 2];
    let mut after = After::Letter;
    for (segment, is_last) in with_last(&drawn.segments) {
        let (points, count) = arguments(segment);
        let mut at = joint;
        for point in &points[..count - usize::from(is_last)] {
            check_size(*point)?;
            at = grid(*point);
            after.push(out, at[0].minus(joint[0]), BelowOne::Short);
            after.push(out, at[1].minus(joint[1]), BelowOne::Short);
        }
        if !is_last {
            joint = at;
        }
    }
    if drawn.segments.len() == 1 {
        after.push_text(out, &data.as_bytes()[segment.tail..segment.end]);
    } else {
        // The end point as spelled, counted from the last joint: exactly where the file put it.
        let [x, y] = end_point(data, segment);
        after.push(out, x.minus(joint[0]), BelowOne::Short);
        after.push(out, y.minus(joint[1]), BelowOne::Short);
    }
    Ok(after)
}

/// The segments, and whether each is the last.
fn with_last(segments: &[PathSeg]) -> impl Iterator<Item = (&PathSeg, bool)> {
    let count = segments.len();
    (1..)
        .zip(segments)
        .map(move |(i, segment)| (segment, i == count))
}

/// Refuses what lies too far away, and what is not a number.
fn check_size(p: Point) -> Result<(), Reason> {
    if p.x.abs() < FARTHEST && p.y.abs() < FARTHEST {
        Ok(())
    } else {
        Err(Reason::TooLarge)
    }
}

/// The peak error of the curve of an arc as it is printed, whose end is the arc's own, where it is to be measured.
fn strayed(arc: &SvgArc, options: &Options, drawn: &Beziers) -> f64 {
    if !options.measure {
        return 0.0;
    }
    let rounded = |x: f64| Decimal::round(x, drawn.decimals).value();
    let end = drawn.segments.last().map(ParamCurve::end);
    let segments: Vec<PathSeg> = drawn
        .placed(|offset| {
            if offset == Point::ZERO {
                return arc.from;
            }
            if Some(offset) == end {
                return arc.to;
            }
            let at = arc.from + offset.to_vec2();
            Point::new(rounded(at.x), rounded(at.y))
        })
        .collect();
    let outline = arc.shape().ok().and_then(|shape| shape.outline());
    outline.map_or(0.0, |outline| {
        radial::error(&segments, &outline.truth).peak()
    })
}

/// The two numbers of an arc's end point, as exactly as they can be held.
fn end_point(data: &str, segment: &Segment) -> [Decimal; 2] {
    let bytes = data.as_bytes();
    let middle = number::skip(bytes, segment.tail).unwrap_or(segment.tail);
    let second = after_separator(bytes, middle);
    let read = |text: &str| {
        Decimal::read(text).unwrap_or_else(|| {
            let value: f64 = text.parse().unwrap_or_default();
            Decimal::round(value, decimals_for(value, 15))
        })
    };
    [
        read(&data[segment.tail..middle]),
        read(&data[second..segment.end]),
    ]
}
