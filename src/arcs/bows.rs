//! A contour as lines and circular arcs.

use kurbo::{CubicBez, PathSeg, Point};

use super::fit::{self, Fit, Rules};
use super::piece::{Piece, cubic_from_chord};
use super::{Options, Plan, decimals_given, pieces};
use crate::approximate::{self, approximate};
use crate::contour::{Contour, Step, Subpath};
use crate::course::{self, CircularArc, Course};
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::joints::{Cut, MOST_SEGMENTS, Tolerance};
use crate::number::Precision;
use crate::radial_error::RadialError;
use crate::shape::{Arc, Shape};

/// The part of the tolerance within which an elliptical arc becomes cubics first.
const ELLIPSE_PART: f64 = 0.02;

/// How many decimals more a radius may have than the points, where these are not enough for it.
const MORE_DECIMALS: u8 = 8;

/// What stands between two points of the result before it is rounded.
enum Span {
    /// What was given and stays: a line or a circular arc.
    Kept(Point, Option<Arc>),
    /// What replaces cubics.
    Fitted(Fit),
}

pub(super) fn subpath(contour: &Contour, options: &Options) -> Result<Subpath> {
    let given = pieces(contour, options.transform)?;
    let mut plan = Plan::new(contour, &given, options)?;
    // The ends of an arc may be rounded along it, and its radius.
    let rounding = plan.tolerance - plan.room;
    let slack = ELLIPSE_PART * plan.tolerance;
    let decimals = decimals_given(contour);
    let rules = Rules {
        room: plan.room - 2.0 * rounding - slack,
        decimals,
        moved: Precision::Fixed(decimals).farthest_moved(),
    };
    let (spans, slack) = spans(contour, &given, options, &rules, slack)?;
    let start = given.first().map(Piece::start).unwrap_or_default();
    let mut finished = finish(start, &spans, &plan);
    if finished
        .as_ref()
        .is_none_or(|(_, error)| error + slack > plan.tolerance)
    {
        if options.precision.is_some() {
            return Err(Error::Shape(format!(
                "with so few decimals the arcs stray farther than the tolerance {}: give more decimals or a larger tolerance",
                plan.tolerance
            )));
        }
        plan.precision = Precision::Full;
        finished = finish(start, &spans, &plan);
    }
    let (mut course, error) =
        finished.ok_or_else(|| Error::Shape("an arc of the path vanishes".to_owned()))?;
    course.closed = contour.closed;
    Ok(Subpath {
        curve: Curve {
            segments: Vec::new(),
            closed: contour.closed,
        },
        course: Some(course),
        error: RadialError::balanced(error + slack),
        radius: plan.size,
    })
}

/// The spans, and how far their cubics lie from what was given.
fn spans(
    contour: &Contour,
    given: &[Piece],
    options: &Options,
    rules: &Rules,
    slack: f64,
) -> Result<(Vec<Span>, f64)> {
    let (mut spans, mut cubics, mut strayed) = (Vec::new(), Vec::new(), 0.0_f64);
    for (piece, step) in given.iter().zip(&contour.steps) {
        match (piece, step) {
            (Piece::Cubic(cubic), _) => cubics.push(*cubic),
            (Piece::Line(line), _) => {
                flush(&mut cubics, rules, &mut spans)?;
                spans.push(Span::Kept(line.p1, None));
            }
            (Piece::Arc(_), Step::Arc(arc)) => {
                if let Some(kept) = circular(arc, options) {
                    flush(&mut cubics, rules, &mut spans)?;
                    spans.push(Span::Kept(piece.end(), Some(kept)));
                } else {
                    let options = approximate::Options {
                        cut: Cut::Tolerance(Tolerance::Absolute(slack)),
                        precision: Some(Precision::Full),
                        transform: options.transform,
                        ..Default::default()
                    };
                    let drawing = approximate(&Shape::Arc(*arc), &options)?;
                    strayed = strayed.max(drawing.error.peak());
                    flush(&mut cubics, rules, &mut spans)?;
                    let chain = drawing.curve.segments.iter().map(PathSeg::to_cubic);
                    let chain: Vec<_> = chain.collect();
                    spans.extend(approximated(&chain, rules, spans.len()));
                }
            }
            (Piece::Arc(_), Step::Given(_)) => {}
        }
    }
    flush(&mut cubics, rules, &mut spans)?;
    Ok((spans, strayed))
}

/// The arc under the map, where it is one of a circle there and no whole turn.
fn circular(arc: &Arc, options: &Options) -> Option<Arc> {
    let outline = Shape::Arc(*arc)
        .outline()?
        .transformed(options.transform)
        .ok()?;
    let course = Course::of_arc(&outline)?;
    let [course::Step::Arc(found)] = course.steps[..] else {
        return None;
    };
    let round = Arc {
        center: found.center,
        radii: kurbo::Vec2::new(found.radius, found.radius),
        rotation: crate::Angle::ZERO,
        start: found.start,
        sweep: found.sweep,
        ends: Some([course.start, found.to]),
    };
    (!found.is_circle()).then_some(round)
}

/// Ends a chain of cubics: what they are together becomes spans.
fn flush(cubics: &mut Vec<CubicBez>, rules: &Rules, spans: &mut Vec<Span>) -> Result<()> {
    let chain = core::mem::take(cubics);
    if let Some(halves) = whole(&chain, rules) {
        spans.extend(halves.map(Span::Fitted));
        return Ok(());
    }
    let mut rest = &chain[..];
    while let Some((first, others)) = rest.split_first() {
        let straight = fit::is_straight(first, rules.room);
        if let Some(fit) = straight {
            spans.push(Span::Fitted(fit));
            rest = others;
        } else if let Some((count, fit)) = fit::run(rest, rules) {
            spans.push(Span::Fitted(fit));
            rest = &rest[count..];
        } else {
            let (chain, others) = rest.split_at(fit::free(rest, rules));
            spans.extend(approximated(chain, rules, spans.len()));
            rest = others;
        }
        if spans.len() > MOST_SEGMENTS {
            return Err(Error::Count {
                count: spans.len(),
                most: MOST_SEGMENTS,
            });
        }
    }
    Ok(())
}

fn approximated(chain: &[CubicBez], rules: &Rules, before: usize) -> impl Iterator<Item = Span> {
    let most = MOST_SEGMENTS.saturating_sub(before);
    fit::approximated(chain, rules, most)
        .into_iter()
        .map(Span::Fitted)
}

/// A whole circle as its halves.
fn whole(chain: &[CubicBez], rules: &Rules) -> Option<[Fit; 2]> {
    let returns = chain.first()?.p0 == chain.last()?.p3;
    if !returns || chain.len() % 2 == 1 {
        return None;
    }
    let (first, second) = chain.split_at(chain.len() / 2);
    let half = |cubics: &[CubicBez]| {
        let (count, fit) = fit::run(cubics, rules)?;
        (count == cubics.len()).then_some(fit)
    };
    Some([half(first)?, half(second)?])
}

/// The course as it is printed and a bound of its distance; `None` where rounding leaves nothing of an arc.
fn finish(start: Point, spans: &[Span], plan: &Plan) -> Option<(Course, f64)> {
    let mut course = Course {
        start: plan.end(start),
        steps: Vec::with_capacity(spans.len()),
        closed: false,
    };
    let (mut from, mut error) = (course.start, 0.0_f64);
    for span in spans {
        let (to, arc, strayed) = match span {
            Span::Kept(to, None) => (plan.end(*to), None, 0.0),
            Span::Kept(to, Some(arc)) => {
                let to = plan.end(*to);
                // Radii that were given are not rounded.
                let found = fit::with_radius(from, to, arc, arc.radii.x)?;
                (to, Some(found), moved(arc, &found))
            }
            Span::Fitted(fit) => {
                let to = if fit.ends_given {
                    plan.end(fit.to)
                } else {
                    plan.inner(fit.to)
                };
                let (arc, strayed) = rounded(fit, from, to, plan)?;
                (to, arc, strayed)
            }
        };
        error = error.max(strayed);
        course
            .steps
            .push(arc.map_or(course::Step::Line(to), |arc| step(&arc, to)));
        from = to;
    }
    Some((course, error))
}

/// A bound of how far an arc lies from itself after its ends were rounded.
fn moved(before: &Arc, after: &Arc) -> f64 {
    let (Some(old), Some(new)) = (before.ends, after.ends) else {
        return 0.0;
    };
    let ends = old[0].distance(new[0]).max(old[1].distance(new[1]));
    if ends == 0.0 {
        return 0.0;
    }
    ends + before.center.distance(after.center) + (before.radii.x - after.radii.x).abs()
}

/// The fit between rounded ends, its radius with as many decimals as it needs, and how far it then lies from its cubics.
fn rounded(fit: &Fit, from: Point, to: Point, plan: &Plan) -> Option<(Option<Arc>, f64)> {
    let (Some(arc), true) = (&fit.arc, from != to) else {
        let [first, last] = [fit.parts.first()?.p0, fit.parts.last()?.p3];
        let moved = first.distance(from).max(last.distance(to));
        let strayed = fit.parts.iter().map(cubic_from_chord).fold(0.0, f64::max);
        return Some((None, strayed + moved));
    };
    let precisions = match plan.precision {
        Precision::Fixed(decimals) if !plan.rounds_given => (decimals..=decimals + MORE_DECIMALS)
            .map(Precision::Fixed)
            .collect(),
        precision => vec![precision],
    };
    let mut best: Option<(Arc, f64)> = None;
    for precision in precisions {
        let radius = precision.round(arc.radii.x);
        if let Some(found) = fit::with_radius(from, to, arc, radius) {
            let strayed = fit::distance(&fit.parts, from, to, &found);
            if best.is_none_or(|(_, least)| strayed < least) {
                best = Some((found, strayed));
            }
            if strayed <= plan.room {
                break;
            }
        }
    }
    best.map(|(arc, strayed)| (Some(arc), strayed))
}

fn step(arc: &Arc, to: Point) -> course::Step {
    course::Step::Arc(CircularArc {
        to,
        center: arc.center,
        radius: arc.radii.x,
        start: arc.start,
        sweep: arc.sweep,
        ends_given: true,
    })
}
