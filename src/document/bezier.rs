//! The one door to the engine: an arc or an ellipse as Béziers about its own origin, and the decimals that they need.
//!
//! Icon sets hold tens of thousands of arcs, so what every file asks for, equal segments of a rule whose ends lie on the circle,
//! is placed here without an allocation; a test holds it against [`approximate`], which serves everything else.

use kurbo::{PathSeg, Point, Vec2};

use super::decimals::{Pieces, decimals, most};
use super::memo::Memo;
use super::segments::{Beziers, Joint};
use super::{Options, Reason};
use crate::Angle;
use crate::approximate::{self, Drawing, approximate, approximate_between};
use crate::curve::control_points;
use crate::joints::{Cut, MOST_SEGMENTS, quarters};
use crate::method::{Degree, Ends, Method, Rule};
use crate::number::Precision;
use crate::numeric::functions::angle_of;
use crate::shape::endpoint::{Chord, SvgArc};
use crate::shape::{Axes, Ellipse, Outline, Shape, Truth};

/// From this many decimals on the last digits of every sum show, and they are to be those of the engine.
const LAST_DIGITS: u32 = 12;

/// What draws that which cannot be placed here.
type Engine = fn(&Shape, &approximate::Options) -> crate::Result<Drawing>;

/// Fills `out` with an arc of a path, whose ends stay as they are. It is drawn from `arc.from`, and the points are offsets from there.
pub(super) fn arc(
    arc: &SvgArc,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<(), Reason> {
    arc_by(approximate_between, arc, options, memo, out)
}

/// As [`arc`] for the corner of a rectangle, whose ends are rounded as all others where a precision is asked for.
pub(super) fn corner(
    arc: &SvgArc,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<(), Reason> {
    arc_by(approximate, arc, options, memo, out)
}

fn arc_by(
    engine: Engine,
    arc: &SvgArc,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let chord = arc.chord().map_err(|error| refused(&error))?;
    let chord = chord.ok_or(Reason::TooLarge)?;
    let count = count(options, Angle::from_degrees(chord.sweep));
    if count == Some(1) {
        single(arc, &chord, options, memo, out)?;
        if out.decimals < LAST_DIGITS {
            return Ok(());
        }
    }
    let shape = arc.shape().map_err(|error| refused(&error))?;
    let Some(outline) = shape.outline() else {
        return Err(Reason::TooLarge);
    };
    match count {
        Some(count) => equal(&outline, arc, count, options, memo, out),
        None => by_engine(engine, &shape, arc.from, options, out).map(|_| ()),
    }
}

/// Fills `out` with an ellipse that starts at `center` + (`radii.x`, 0) and runs towards +y, as offsets from its centre; returns the
/// first of them.
pub(super) fn ellipse(
    center: Point,
    radii: Vec2,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<Vec2, Reason> {
    // Where a precision is asked for, sums with the centre are rounded; else the centre keeps its digits and offsets are.
    let center = options.precision.map_or(Point::ZERO, |_| center);
    let shape =
        Shape::Ellipse(Ellipse::new(center, radii, Angle::ZERO).map_err(|error| refused(&error))?);
    let Some(count) = count(options, Angle::TURN) else {
        return by_engine(approximate, &shape, center, options, out);
    };
    let truth = Truth::new(Point::ZERO, radii, Vec2::new(1.0, 0.0));
    let size = 360.0 / count as f64;
    let (piece, error) = memo
        .piece(options.rule, size)
        .map_err(|error| refused(&error))?;
    out.begin(piece.degree);
    let place = |v: Vec2| Vec2::new(radii.x * v.x, radii.y * v.y);
    let joint = |i: usize| Joint {
        radius: Angle::ZERO.direction_in_turn(1.0, i % count, count),
        offset: Vec2::ZERO,
    };
    let start = place(joint(0).radius);
    for i in 0..count {
        let (before, after) = (joint(i), joint(i + 1));
        let inner = [before.control(&piece, 1.0), after.control(&piece, -1.0)];
        out.segment(inner[0], inner[1], after.radius, place);
    }
    let pieces = Pieces {
        error,
        axes: Axes::of(radii),
        count,
        size,
        from: |i| i as f64 * size,
    };
    out.decimals = decimals(&truth, start, Point::ZERO, &pieces, options, out);
    Ok(start)
}

fn refused(error: &crate::Error) -> Reason {
    Reason::Refused(error.to_string())
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
        Cut::Count(count @ 1..=MOST_SEGMENTS) if serves => Some(count),
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
) -> Result<Vec2, Reason> {
    let asked = approximate::Options {
        rule: options.rule,
        cut: options.cut.clone(),
        precision: options.precision.map(Precision::Fixed),
        ..approximate::Options::default()
    };
    let drawing = engine(shape, &asked).map_err(|error| refused(&error))?;
    let quadratic = matches!(drawing.curve.segments.first(), Some(PathSeg::Quad(_)));
    out.begin(if quadratic {
        Degree::Quadratic
    } else {
        Degree::Cubic
    });
    for segment in &drawing.curve.segments {
        out.points.extend(
            control_points(segment)[1..]
                .iter()
                .map(|point| *point - from),
        );
    }
    out.decimals = most(drawing.precision);
    Ok(drawing.curve.start().unwrap_or_default() - from)
}

/// One segment, as most arcs are: its ends on the unit circle are known from the chord, without an angle.
fn single(
    arc: &SvgArc,
    chord: &Chord,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let (piece, error) = memo
        .piece(options.rule, chord.sweep.abs())
        .map_err(|error| refused(&error))?;
    out.begin(piece.degree);
    let truth = chord.truth_of(arc);
    let sign = 1.0_f64.copysign(chord.sweep);
    let [first, last] = chord.directions();
    let joint = |radius, offset| Joint { radius, offset };
    let ends = [joint(first, Vec2::ZERO), joint(last, arc.to - arc.from)];
    out.between(ends, &piece, sign, |way| truth.image(way));
    let pieces = Pieces {
        error,
        axes: Axes::of(truth.radii),
        count: 1,
        size: chord.sweep,
        from: |_| angle_of(first).to_degrees(),
    };
    out.decimals = decimals(&truth, Vec2::ZERO, arc.from, &pieces, options, out);
    Ok(())
}

/// Equal segments, each point reached from the nearer end of the arc.
fn equal(
    outline: &Outline,
    arc: &SvgArc,
    count: usize,
    options: &Options,
    memo: &mut Memo,
    out: &mut Beziers,
) -> Result<(), Reason> {
    let (start, sweep) = (outline.unit.start.degrees(), outline.unit.sweep.degrees());
    let (piece, error) = memo
        .piece(options.rule, (sweep / count as f64).abs())
        .map_err(|error| refused(&error))?;
    out.begin(piece.degree);
    let [a, b, c, d, _, _] = outline.placement.as_coeffs();
    let place = |v: Vec2| Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y);
    let to = arc.to - arc.from;
    let sign = 1.0_f64.copysign(sweep);
    let first = Joint {
        radius: outline.unit.start.direction(),
        offset: Vec2::ZERO,
    };
    let end = start + sweep;
    let last = Joint {
        radius: Angle::from_degrees(end).direction(),
        offset: to,
    };
    let joint = |i: usize| {
        if i == count {
            return last;
        }
        // Counted from the nearer end, as the engine does.
        let (base, from, angle) = if 2 * i <= count {
            (Vec2::ZERO, start, start + sweep * (i as f64 / count as f64))
        } else {
            (to, end, end - sweep * ((count - i) as f64 / count as f64))
        };
        Joint {
            radius: Angle::from_degrees(angle).direction(),
            offset: base + place(chord(from, angle)),
        }
    };
    let mut before = first;
    for i in 1..=count {
        let after = joint(i);
        out.between([before, after], &piece, sign, place);
        before = after;
    }
    let pieces = Pieces {
        error,
        axes: outline.axes(),
        count,
        size: sweep / count as f64,
        from: |i| start + sweep * (i as f64 / count as f64),
    };
    out.decimals = decimals(&outline.truth, Vec2::ZERO, arc.from, &pieces, options, out);
    Ok(())
}

/// From one angle of the unit circle to another: 2 sin(δ/2) across the direction halfway.
fn chord(from: f64, to: f64) -> Vec2 {
    let halfway = Angle::from_degrees(f64::midpoint(from, to)).direction();
    Vec2::new(-halfway.y, halfway.x) * (2.0 * libm::sin(((to - from) / 2.0).to_radians()))
}

#[cfg(test)]
mod tests {
    use super::*;

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
            .flat_map(|segment| control_points(segment)[1..].to_vec())
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
        assert_eq!(drawn.points().len(), engine.0.len());
        for (own, other) in drawn.points().iter().zip(&engine.0) {
            assert!(
                (base + *own - *other).hypot() <= 4e-15 * size,
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
            let mut memo = Memo::default();
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
                super::arc(&arc, &options, &mut memo, &mut drawn).unwrap();
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
            let mut memo = Memo::default();
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
        let (mut drawn, mut memo) = (Beziers::default(), Memo::default());
        let free = Options {
            rule: Rule::Method(Method::MinimaxFree),
            ..Options::default()
        };
        let start = ellipse(
            Point::ZERO,
            Vec2::new(1.0, 1.0),
            &free,
            &mut memo,
            &mut drawn,
        )
        .unwrap();
        assert!(start.x < 1.0 && drawn.points().last() == Some(&start));
        let arc = SvgArc {
            from: Point::ZERO,
            radii: Vec2::new(1.0, 1.0),
            rotation: Angle::ZERO,
            large_arc: false,
            sweep: true,
            to: Point::new(1.0, 1.0),
        };
        assert_eq!(
            super::arc(&arc, &free, &mut memo, &mut drawn)
                .unwrap_err()
                .code(),
            "method"
        );
        let close = Options {
            cut: Cut::Tolerance(crate::Tolerance::Absolute(1e-7)),
            ..Options::default()
        };
        super::arc(&arc, &close, &mut memo, &mut drawn).unwrap();
        assert!(drawn.segments().len() > 1);
    }
}
