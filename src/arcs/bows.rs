//! A contour as lines and arcs.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use super::builder::{Builder, Stretch};
use super::chain::runs_on;
use super::fit::PieceSearch;
use super::from_chord::Above;
use super::half_turn::{from_truth, half_turn};
use super::near::moved;
use super::piece::StepCurve;
use super::recognize::Rules;
use super::{Options, Plan, decimals_given, pieces};
use super::{together, turn};
use crate::Angle;
use crate::approximate::{self, approximate};
use crate::contour::{Contour, Step, Subpath};
use crate::course::{self, Course};
use crate::error::Result;
use crate::joints::{Cut, MOST_SEGMENTS, Tolerance};
use crate::method::Span;
use crate::number::Precision;
use crate::numeric::functions::angle_of;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Given, Outline, Shape};

/// The part of the tolerance within which an elliptical arc becomes cubics first.
const ELLIPSE_PART: f64 = 0.02;

/// The part of what rounding leaves of the tolerance that pieces may use, where what it may do to arcs leaves less.
const LEAST_PART: f64 = 0.25;

/// The most decimals of what was given that are believed: beyond, digits are noise.
const MOST_DECIMALS: u8 = 12;

/// The part of the tolerance that is left to the rounding of centres where that takes as many decimals as it needs.
const ROUNDED_AGAIN: f64 = 1e-3;

/// A cubic is a line where it lies no farther from its chord than this part of that.
const STRAIGHT: f64 = 1e-9;

pub(super) fn subpath(contour: &Contour, options: &Options) -> Result<Subpath> {
    let given = pieces(contour, options.transform)?;
    let decimals = decimals_given(contour);
    let explained = Precision::Fixed(decimals).farthest_moved();
    let plan = Plan::new(&given, options, explained)?;
    let decimals = decimals.min(MOST_DECIMALS);
    // The ends of an arc may be rounded along it, and its radius, or its centre.
    let rounding = plan.tolerance - plan.room;
    let times = if options.rounds_again { 4.0 } else { 2.0 };
    let mut builder = Builder {
        rules: Rules {
            part: 0.0,
            absolute: plan.room - times * rounding,
            decimals,
            elliptic: options.elliptic,
            drawn_only: true,
            longest: usize::MAX,
        },
        options,
        course: Course {
            start: plan.end(given.first().map(StepCurve::start).unwrap_or_default()),
            steps: Vec::with_capacity(given.len()),
            closed: contour.closed,
        },
        at: Point::ORIGIN,
        error: 0.0,
        error_of_arcs: 0.0,
        plan,
    };
    builder.at = builder.course.start;
    let mut cubics = Vec::new();
    for (piece, step) in given.iter().zip(&contour.steps) {
        if let StepCurve::Cubic(cubic) = piece
            && !piece.is_dot()
        {
            cubics.push(*cubic);
        } else {
            builder.flush(&mut cubics, 0.0)?;
            builder.kept(piece, step)?;
        }
    }
    builder.flush(&mut cubics, 0.0)?;
    builder.subpath(contour.closed)
}

impl Builder<'_> {
    /// A line, or an arc that was given.
    fn kept(&mut self, piece: &StepCurve, step: &Step) -> Result<()> {
        let Step::Arc(arc) = step else {
            self.line(piece.start(), piece.end(), 0.0, true);
            return Ok(());
        };
        let outline = arc.outline().transformed(self.options.transform)?;
        let kept = if outline.unit.closed {
            None
        } else if let Some(course) = Course::of_arc(&outline)
            && let [course::CourseStep::Arc(found)] = course.steps[..]
        {
            Some((Vec2::splat(found.radius), 0.0, found.sweep.degrees()))
        } else if self.options.elliptic {
            let sign = outline.placement.determinant().signum();
            let sweep = sign * outline.unit.sweep.degrees();
            if self.options.transform == Affine::IDENTITY {
                Some((arc.radii, arc.rotation.degrees(), sweep))
            } else {
                let axis = outline.truth.axis;
                let rotation = angle_of(axis).to_degrees();
                Some((outline.truth.radii, rotation, sweep))
            }
        } else {
            None
        };
        match kept {
            Some((radii, rotation, sweep)) => {
                let (radii, is_half) = match arc.given {
                    Given::Enlarged(own) if self.options.transform == Affine::IDENTITY => {
                        (own, false)
                    }
                    given => (radii, matches!(given, Given::Enlarged(_))),
                };
                if self.kept_arc(piece, &outline, (radii, rotation, sweep), is_half)? {
                    Ok(())
                } else {
                    self.by_cubics(arc)
                }
            }
            None => self.by_cubics(arc),
        }
    }

    /// Appends an arc that was given, its ends rounded, unless that moves it too far.
    fn kept_arc(
        &mut self,
        piece: &StepCurve,
        outline: &Outline,
        (radii, rotation, sweep): (Vec2, f64, f64),
        is_half: bool,
    ) -> Result<bool> {
        let as_given = |arc: SvgArc| if is_half { half_turn(&arc) } else { arc };
        let before = as_given(SvgArc {
            from: piece.start(),
            radii,
            rotation: Angle::from_degrees(rotation),
            large_arc: sweep.abs() > 180.0,
            sweep: sweep > 0.0,
            to: piece.end(),
        });
        let after = as_given(SvgArc {
            from: self.at,
            to: self.plan.end(piece.end()),
            ..before
        });
        // Radii that were given are not rounded.
        let (Shape::Arc(old), Shape::Arc(new)) = (before.shape()?, after.shape()?) else {
            return Ok(false);
        };
        let mut off = moved(&old, &new);
        if self.options.transform != Affine::IDENTITY {
            off = off.max(from_truth(&new, outline));
        }
        if off > self.plan.tolerance || !self.leaves_room(&after, &new, off) {
            return Ok(false);
        }
        self.push(&after, &new, off);
        Ok(true)
    }

    /// An arc that was given as cubics first, and as what these become.
    ///
    /// How far these stray counts both ways. What is nearer to the ellipse than its smallest radius of curvature has nearest points that
    /// cover the arc. Else radii of the unit circle pair the points of both, which the map moves apart by no more than the larger radius
    /// does.
    fn by_cubics(&mut self, arc: &Arc) -> Result<()> {
        if self.plan.room <= 0.0 {
            return Err(self.plan.too_coarse());
        }
        let slack = (ELLIPSE_PART * self.plan.tolerance).min(LEAST_PART * self.plan.room);
        let mut options = approximate::Options {
            cut: Cut::Tolerance(Tolerance::Absolute(slack)),
            precision: Some(Precision::Full),
            transform: self.options.transform,
            ..Default::default()
        };
        let mut drawing = approximate(&Shape::Arc(*arc), &options)?;
        let mut strayed = drawing.error.peak();
        let is_beyond = |outline: &Outline| strayed >= outline.truth.sharpest_radius();
        if let Some(outline) = drawing.outline.filter(is_beyond) {
            let larger = outline.truth.larger_radius();
            let sweep = outline.unit.sweep.degrees().abs();
            let on_circle = |count| {
                let span = Span::from_degrees(sweep / count as f64);
                let error = options.rule.radial_error(&span).map(|error| error.peak());
                larger * error.unwrap_or(f64::INFINITY)
            };
            let enough = (1..MOST_SEGMENTS).find(|&count| on_circle(count) <= slack);
            let count = enough.unwrap_or(MOST_SEGMENTS);
            options.cut = Cut::Count(count);
            drawing = approximate(&Shape::Arc(*arc), &options)?;
            strayed = on_circle(count).max(drawing.error.peak());
        }
        let mut cubics: Vec<_> = drawing
            .curve
            .segments
            .iter()
            .map(PathSeg::to_cubic)
            .collect();
        self.flush(&mut cubics, strayed)
    }

    /// Ends a chain of cubics, which stray this far from what was given.
    fn flush(&mut self, cubics: &mut Vec<CubicBez>, strayed: f64) -> Result<()> {
        let chain = core::mem::take(cubics);
        if self.plan.room <= 0.0 && !chain.is_empty() && self.plan.size > 0.0 {
            return Err(self.plan.too_coarse());
        }
        let room = self.plan.room - strayed;
        let room = (self.rules.absolute - strayed).max(LEAST_PART * room);
        // An arc that is found runs between ends that were given, with a radius that is not rounded; G-code takes decimals until
        // its centre is near enough.
        let again = if self.options.rounds_again {
            ROUNDED_AGAIN * self.plan.tolerance
        } else {
            0.0
        };
        let rules = Rules {
            absolute: if self.plan.rounds_given {
                room
            } else {
                self.plan.tolerance - again - strayed
            },
            ..self.rules
        };
        let mut rest = &chain[..];
        while !rest.is_empty() {
            let joint = rest.windows(2).position(|pair| !self.runs_on(pair));
            let (smooth, others) = rest.split_at(joint.map_or(rest.len(), |i| i + 1));
            for span in spans(smooth, &rules, room, self.options.tolerance.is_some()) {
                self.span(&span, strayed)?;
            }
            rest = others;
        }
        Ok(())
    }

    fn runs_on(&self, pair: &[CubicBez]) -> bool {
        runs_on(
            &pair[0],
            &pair[1],
            Precision::Fixed(self.rules.decimals).farthest_moved(),
        )
    }
}

/// What smooth cubics become: those that were drawn as arcs such, unless that makes more of them; arcs of ellipses, unless circular ones
/// are fewer. A circle may take arcs more than it needs so that they have its radius, unless the fewest are asked for.
fn spans<'a>(chain: &'a [CubicBez], rules: &Rules, room: f64, fewest: bool) -> Vec<Stretch<'a>> {
    let is_enough = |spans: &[Stretch<'_>]| is_one_shape(spans) && !(fewest && spans.len() > 2);
    let spans = spans_alike(chain, rules, room, &is_enough);
    if !is_enough(&spans)
        && let Some([a, b]) = turn::whole(chain, rules)
    {
        let (first, second) = chain.split_at(a.count);
        return vec![Stretch::Found(first, a), Stretch::Found(second, b)];
    }
    if rules.elliptic && spans.len() > 1 {
        let rules = Rules {
            elliptic: false,
            ..*rules
        };
        let circular = spans_alike(chain, &rules, room, &is_enough);
        if circular.len() < spans.len() {
            return circular;
        }
    }
    spans
}

/// Whether all that was found are arcs of one circle, or two of one ellipse.
fn is_one_shape(spans: &[Stretch<'_>]) -> bool {
    let radii = |span: &Stretch<'_>| match span {
        Stretch::Found(_, found) => Some(found.given.radii),
        _ => None,
    };
    let is_like_first = |span: &Stretch<'_>| {
        let (first, own) = (radii(&spans[0]), radii(span));
        own == first && own.is_some_and(|radii| radii.x == radii.y || spans.len() == 2)
    };
    spans.iter().all(is_like_first)
}

fn spans_alike<'a>(
    chain: &'a [CubicBez],
    rules: &Rules,
    room: f64,
    is_enough: &impl Fn(&[Stretch<'_>]) -> bool,
) -> Vec<Stretch<'a>> {
    let mut search = PieceSearch::new(room, rules.elliptic);
    let (mut spans, mut free, mut at, mut drawn) = (Vec::new(), 0, 0, 0);
    while at < chain.len() {
        let rest = &chain[at..];
        let straight = is_straight(&rest[0], room);
        let found = if straight {
            Vec::new()
        } else {
            together::arcs(rest, rules)
        };
        let taken: usize = found.iter().map(|found| found.count).sum();
        if taken == 0 && !straight {
            at += 1;
            continue;
        }
        let pieces = search.pieces(&chain[free..at], MOST_SEGMENTS);
        spans.extend(pieces.into_iter().map(Stretch::Fitted));
        if straight {
            spans.push(Stretch::Straight(&rest[0]));
        }
        let mut begin = 0;
        for found in found {
            spans.push(Stretch::Found(&rest[begin..begin + found.count], found));
            begin += found.count;
        }
        drawn += 1;
        at += taken.max(1);
        free = at;
    }
    let pieces = search.pieces(&chain[free..], MOST_SEGMENTS);
    spans.extend(pieces.into_iter().map(Stretch::Fitted));
    if drawn > 0 && spans.len() > 1 && !is_enough(&spans) {
        let fewer = search.pieces(chain, spans.len());
        if fewer.len() < spans.len() {
            spans = fewer.into_iter().map(Stretch::Fitted).collect();
        }
    }
    spans
}

fn is_straight(cubic: &CubicBez, room: f64) -> bool {
    let length = cubic.p0.distance_squared(cubic.p3).sqrt();
    Above::new(cubic, [cubic.p0, cubic.p3]).is_within(room.min(STRAIGHT * length))
}
