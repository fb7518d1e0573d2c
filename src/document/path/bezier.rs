//! Draws an arc or an ellipse as Béziers about its own origin, with the decimals that they need.
//!
//! Icon sets hold tens of thousands of arcs, so what every file asks for, equal segments of a rule whose ends lie on the circle,
//! is placed into a buffer; a test holds it against [`approximate`], which serves everything else.

use core::iter::repeat;

use kurbo::{Point, Vec2};

use crate::Angle;
use crate::approximate::{self, Drawing, KnownCurve, approximate};
use crate::curve::map_points;
use crate::document::path::beziers::Beziers;
use crate::document::path::known::ArcTables;
use crate::document::{Options, Reason};
use crate::joints::cutting::{Cutting, EqualPieces};
use crate::joints::{Cut, quarters};
use crate::method::{Ends, Method, Rule};
use crate::number::Precision;
use crate::number::decimal::MAX_DECIMALS;
use crate::place::Placed;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Axes, Ellipse, Shape, Truth};

/// From this many decimals on the last digits of every sum show, and they are to be those of the engine.
const LAST_DIGITS: u32 = 12;

/// What draws that which cannot be placed here.
pub(in crate::document) type Engine = fn(&Shape, &approximate::Options) -> crate::Result<Drawing>;

/// Fills `out` with an arc, its points counted from `arc.from`. Where it cannot be placed here `engine` draws it: of a path, whose ends stay as they
/// are, [`approximate_between`](crate::approximate::approximate_between); of the corner of a rectangle, whose ends are rounded as all others where a precision is asked for,
/// [`approximate()`].
pub(in crate::document) fn arc(
    engine: Engine,
    arc: &SvgArc,
    options: &Options,
    memo: &mut ArcTables,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let chord = arc.chord()?.ok_or(Reason::TooLarge)?;
    let count = count(options, Angle::from_degrees(chord.sweep));
    let ends = Some([Point::ZERO, (arc.to - arc.from).to_point()]);
    if count == Some(1) {
        let truth = chord.truth_of(arc);
        let placed = Placed {
            cutting: &chord,
            placement: truth.placement(),
            ends,
        };
        let axes = Axes::of(truth.radii);
        fill(out, &placed, (&truth, axes), arc.from, options, memo)?;
        if out.decimals < LAST_DIGITS {
            return Ok(());
        }
    }
    let shape = arc.shape()?;
    let outline = shape.outline().ok_or(Reason::TooLarge)?;
    let Some(count) = count else {
        return by_engine(engine, &shape, arc.from, options, out);
    };
    let placed = Placed {
        cutting: &EqualPieces::new(outline.unit, count)?,
        placement: outline.placement,
        ends,
    };
    let truth = (&outline.truth, outline.axes());
    fill(out, &placed, truth, arc.from, options, memo)
}

/// Fills `out` with an ellipse that starts at `center` + (`radii.x`, 0) and runs towards +y, its points counted from its centre.
pub(in crate::document) fn ellipse(
    center: Point,
    radii: Vec2,
    options: &Options,
    memo: &mut ArcTables,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let about = |center| Ellipse::new(center, radii, Angle::ZERO).map(Shape::Ellipse);
    let shape = about(Point::ZERO)?;
    let outline = shape.outline().ok_or(Reason::TooLarge)?;
    let Some(count) = count(options, Angle::TURN) else {
        // Where a precision is asked for, sums with the centre are rounded; else the centre keeps its digits and offsets are.
        let center = options.precision.map_or(Point::ZERO, |_| center);
        return by_engine(approximate, &about(center)?, center, options, out);
    };
    let pieces = EqualPieces::new(outline.unit, count)?;
    let placed = Placed::new(&outline, &pieces);
    let truth = (&outline.truth, outline.axes());
    fill(out, &placed, truth, Point::ZERO, options, memo)
}

impl From<crate::Error> for Reason {
    fn from(error: crate::Error) -> Self {
        Self::Refused(error.to_string())
    }
}

/// The number of segments, where the arc can be placed here.
fn count(options: &Options, sweep: Angle) -> Option<usize> {
    let serves = match options.rule {
        Rule::Method(Method::Chen1) => false,
        Rule::Method(method) => method.card().ends == Ends::OnCircle && !method.sees_ellipse(),
        _ => true,
    };
    match options.cut {
        Cut::Quarters if serves => Some(quarters(sweep)),
        Cut::Count(count) if serves => Some(count),
        _ => None,
    }
}

/// Anything, as the engine draws it.
fn by_engine(
    engine: Engine,
    shape: &Shape,
    from: Point,
    options: &Options,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let asked = approximate::Options {
        rule: options.rule,
        cut: options.cut.clone(),
        precision: options.precision.map(Precision::Fixed),
        ..approximate::Options::default()
    };
    let drawing = engine(shape, &asked)?;
    let segments = drawing.curve.segments.iter();
    out.segments.clear();
    out.segments
        .extend(segments.map(|segment| map_points(segment, |p| (p - from).to_point())));
    out.decimals = decimals(drawing.precision);
    Ok(())
}

/// Equal pieces of a true shape, their points counted from `base`.
fn fill<C: Cutting>(
    out: &mut Beziers,
    placed: &Placed<'_, C>,
    (truth, axes): (&Truth, Axes),
    base: Point,
    options: &Options,
    memo: &mut ArcTables,
) -> Result<(), Reason> {
    let cutting = placed.cutting;
    let (piece, peak) = memo.piece(options.rule, cutting.size(0))?;
    out.segments.clear();
    out.segments.extend(placed.segments(repeat([piece; 2])));
    let known = KnownCurve {
        rule: options.rule,
        truth,
        axes,
        cutting,
        peak: truth.is_circle().then_some(peak * truth.radii.x),
        told: None,
    };
    let in_place = || out.placed(|p| base + p.to_vec2());
    let automatic = || known.precision(f64::INFINITY, in_place);
    out.decimals = decimals(options.precision.map_or_else(automatic, Precision::Fixed));
    Ok(())
}

/// The decimals of a precision, as many as a number is given.
fn decimals(precision: Precision) -> u32 {
    match precision {
        Precision::Fixed(decimals) => u32::from(decimals).min(MAX_DECIMALS),
        Precision::Full => MAX_DECIMALS,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::approximate::approximate_between;
    use crate::curve::control_points;
    use kurbo::ParamCurve as _;

    /// What the engine draws, unrounded.
    fn engine(shape: &Shape, options: &Options) -> (Vec<Point>, Precision) {
        let asked = |precision| approximate::Options {
            rule: options.rule,
            cut: options.cut.clone(),
            precision,
            ..approximate::Options::default()
        };
        let exact = approximate(shape, &asked(Some(Precision::Full))).unwrap();
        let points = exact
            .curve
            .segments
            .iter()
            .flat_map(control_points)
            .collect();
        (points, approximate(shape, &asked(None)).unwrap().precision)
    }

    fn options() -> Vec<Options> {
        let rules = [
            Method::Minimax,
            Method::Midpoint,
            Method::MinimaxG0,
            Method::QuadraticMinimax,
            Method::Chen3,
        ];
        let cuts = [Cut::Quarters, Cut::Count(7)];
        rules
            .into_iter()
            .flat_map(|method| {
                cuts.clone().map(|cut| Options {
                    rule: Rule::Method(method),
                    cut,
                    ..Options::default()
                })
            })
            .collect()
    }

    fn assert_agree(drawn: &Beziers, base: Point, engine: &(Vec<Point>, Precision), size: f64) {
        let points: Vec<Point> = drawn.segments.iter().flat_map(control_points).collect();
        assert_eq!(points.len(), engine.0.len());
        for (own, other) in points.iter().zip(&engine.0) {
            assert!(
                (base + own.to_vec2() - *other).hypot() <= 4e-15 * size,
                "{own:?} {other:?}"
            );
        }
        // Beyond a dozen decimals the engine measures the noise of its own points.
        if let Precision::Fixed(decimals @ ..12) = engine.1 {
            assert_eq!(drawn.decimals, u32::from(decimals));
        }
    }

    #[test]
    fn arcs_are_those_of_the_engine() {
        let mut drawn = Beziers::default();
        for options in options() {
            let mut memo = ArcTables::default();
            for i in 0..200 {
                let n = f64::from(i);
                let arc = SvgArc {
                    from: Point::new(n.sin() * 10.0, 3.0),
                    radii: Vec2::new(1.0 + n / 7.0, if i % 3 == 0 { 1.0 + n / 7.0 } else { 5.0 }),
                    rotation: Angle::from_degrees(n * 13.0),
                    large_arc: i % 2 == 0,
                    sweep: i % 5 < 2,
                    to: Point::new(n.cos() * 8.0, n / 50.0),
                };
                super::arc(approximate_between, &arc, &options, &mut memo, &mut drawn).unwrap();
                assert_agree(
                    &drawn,
                    arc.from,
                    &engine(&arc.shape().unwrap(), &options),
                    60.0,
                );
            }
        }
    }

    #[test]
    fn ellipses_are_those_of_the_engine() {
        let mut drawn = Beziers::default();
        for options in options() {
            let mut memo = ArcTables::default();
            for radii in [
                Vec2::new(10.0, 10.0),
                Vec2::new(3.0, 0.7),
                Vec2::new(1e-3, 1.0),
            ] {
                ellipse(Point::ZERO, radii, &options, &mut memo, &mut drawn).unwrap();
                let shape = Shape::Ellipse(Ellipse::new(Point::ZERO, radii, Angle::ZERO).unwrap());
                assert_agree(&drawn, Point::ZERO, &engine(&shape, &options), 10.0);
            }
        }
    }

    #[test]
    fn other_requests_go_to_the_engine() {
        let (mut drawn, mut memo) = (Beziers::default(), ArcTables::default());
        let free = Options {
            rule: Rule::Method(Method::MinimaxFree),
            ..Options::default()
        };
        ellipse(
            Point::ZERO,
            Vec2::new(1.0, 1.0),
            &free,
            &mut memo,
            &mut drawn,
        )
        .unwrap();
        let [start, end] = [drawn.segments[0].start(), drawn.segments[3].end()];
        assert!(start.x < 1.0 && end == start);
        let arc = SvgArc {
            from: Point::ZERO,
            radii: Vec2::new(1.0, 1.0),
            rotation: Angle::ZERO,
            large_arc: false,
            sweep: true,
            to: Point::new(1.0, 1.0),
        };
        assert_eq!(
            super::arc(approximate_between, &arc, &free, &mut memo, &mut drawn)
                .unwrap_err()
                .code(),
            "method"
        );
        let close = Options {
            cut: Cut::Tolerance(crate::Tolerance::Absolute(1e-7)),
            ..Options::default()
        };
        super::arc(approximate_between, &arc, &close, &mut memo, &mut drawn).unwrap();
        assert!(drawn.segments.len() > 1);
    }
}
