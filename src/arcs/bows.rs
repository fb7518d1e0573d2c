//! A contour as lines and arcs.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use super::bound::from_chord;
use super::chain::runs_on;
use super::fit::{Fit, Search, arc_of};
use super::near::{bound, moved};
use super::piece::{Piece, cubic_from_chord};
use super::recognize::{self, Found, Rules};
use super::{Options, Plan, decimals_given, pieces};
use crate::Angle;
use crate::approximate::{self, approximate};
use crate::contour::{Contour, Step, Subpath};
use crate::course::{self, CircularArc, Course};
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::joints::{Cut, MOST_SEGMENTS, Tolerance};
use crate::number::Precision;
use crate::radial_error::RadialError;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Shape};

/// The part of the tolerance within which an elliptical arc becomes cubics first.
const ELLIPSE_PART: f64 = 0.02;

/// How many decimals more a radius may have than the points, where these are not enough for it.
const MORE_DECIMALS: u8 = 8;

/// The most decimals of what was given that are believed: beyond, digits are noise.
const MOST_DECIMALS: u8 = 12;

/// A cubic is a line where it lies no farther from its chord than this part of that.
const STRAIGHT: f64 = 1e-9;

pub(super) fn subpath(contour: &Contour, options: &Options) -> Result<Subpath> {
    let given = pieces(contour, options.transform)?;
    let plan = Plan::new(contour, &given, options)?;
    let decimals = decimals_given(contour).min(MOST_DECIMALS);
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
        },
        options,
        course: Course {
            start: plan.end(given.first().map(Piece::start).unwrap_or_default()),
            steps: Vec::with_capacity(given.len()),
            closed: contour.closed,
        },
        at: Point::ORIGIN,
        error: 0.0,
        plan,
    };
    builder.at = builder.course.start;
    let mut cubics = Vec::new();
    for (piece, step) in given.iter().zip(&contour.steps) {
        if let Piece::Cubic(cubic) = piece {
            cubics.push(*cubic);
        } else {
            builder.flush(&mut cubics, 0.0)?;
            builder.kept(piece, step)?;
        }
    }
    builder.flush(&mut cubics, 0.0)?;
    builder.subpath(contour.closed)
}

/// What a stretch of a chain becomes.
enum Span<'a> {
    /// A line in place of a straight cubic.
    Straight(&'a CubicBez),
    /// An arc in place of cubics that were drawn as one.
    Found(&'a [CubicBez], Found),
    /// A piece of cubics that were not.
    Fitted(Fit),
}

/// Writes the course of a subpath, rounding as it goes.
struct Builder<'a> {
    plan: Plan,
    options: &'a Options,
    rules: Rules,
    course: Course,
    /// Where the course is, as it is printed.
    at: Point,
    error: f64,
}

impl Builder<'_> {
    fn subpath(self, closed: bool) -> Result<Subpath> {
        // What holds for arcs by how they are made holds for lines that were given, unless few decimals were asked for.
        if self.error > self.plan.tolerance && self.options.tolerance.is_some() {
            return Err(self.plan.too_coarse());
        }
        Ok(Subpath {
            curve: Curve {
                segments: Vec::new(),
                closed,
            },
            course: Some(self.course),
            error: RadialError::balanced(self.error),
            room: self.plan.left(self.error),
            truths: Vec::new(),
            radius: self.plan.size,
        })
    }

    /// A line, or an arc that was given.
    fn kept(&mut self, piece: &Piece, step: &Step) -> Result<()> {
        let Step::Arc(arc) = step else {
            self.line(piece.start(), piece.end(), 0.0, true);
            return Ok(());
        };
        let Some(outline) = Shape::Arc(*arc).outline() else {
            self.line(piece.start(), piece.end(), 0.0, true);
            return Ok(());
        };
        let outline = outline.transformed(self.options.transform)?;
        let kept = if outline.unit.closed {
            None
        } else if let Some(course) = Course::of_arc(&outline)
            && let [course::Step::Arc(found)] = course.steps[..]
        {
            Some((Vec2::splat(found.radius), 0.0, found.sweep.degrees()))
        } else if self.options.elliptic {
            let sign = outline.placement.determinant().signum();
            let sweep = sign * outline.unit.sweep.degrees();
            if self.options.transform == Affine::IDENTITY {
                Some((arc.radii, arc.rotation.degrees(), sweep))
            } else {
                let axis = outline.truth.axis;
                let rotation = libm::atan2(axis.y, axis.x).to_degrees();
                Some((outline.truth.radii, rotation, sweep))
            }
        } else {
            None
        };
        match kept {
            Some((radii, rotation, sweep)) => self.kept_arc(piece, radii, rotation, sweep),
            None => self.ellipse(arc),
        }
    }

    fn kept_arc(&mut self, piece: &Piece, radii: Vec2, rotation: f64, sweep: f64) -> Result<()> {
        let before = SvgArc {
            from: piece.start(),
            radii,
            rotation: Angle::from_degrees(rotation),
            large_arc: sweep.abs() > 180.0,
            sweep: sweep > 0.0,
            to: piece.end(),
        };
        let after = SvgArc {
            from: self.at,
            to: self.plan.end(piece.end()),
            ..before
        };
        // Radii that were given are not rounded.
        match (before.shape()?, after.shape()?) {
            (Shape::Arc(old), Shape::Arc(new)) => {
                self.error = self.error.max(moved(&old, &new));
                self.push(&after, &new);
            }
            _ => self.line(before.from, before.to, 2.0 * radii.x.max(radii.y), true),
        }
        Ok(())
    }

    /// An arc of an ellipse by cubics first.
    fn ellipse(&mut self, arc: &Arc) -> Result<()> {
        let slack = ELLIPSE_PART * self.plan.tolerance;
        let options = approximate::Options {
            cut: Cut::Tolerance(Tolerance::Absolute(slack)),
            precision: Some(Precision::Full),
            transform: self.options.transform,
            ..Default::default()
        };
        let drawing = approximate(&Shape::Arc(*arc), &options)?;
        let mut cubics: Vec<_> = drawing
            .curve
            .segments
            .iter()
            .map(PathSeg::to_cubic)
            .collect();
        self.flush(&mut cubics, drawing.error.peak())
    }

    /// Ends a chain of cubics, which stray this far from what was given.
    fn flush(&mut self, cubics: &mut Vec<CubicBez>, strayed: f64) -> Result<()> {
        let chain = core::mem::take(cubics);
        let room = self.rules.absolute - strayed;
        let mut rest = &chain[..];
        while !rest.is_empty() {
            let joint = rest.windows(2).position(|pair| !self.runs_on(pair));
            let (smooth, others) = rest.split_at(joint.map_or(rest.len(), |i| i + 1));
            for span in self.spans(smooth, room) {
                self.span(&span, strayed)?;
            }
            rest = others;
        }
        if self.course.steps.len() > MOST_SEGMENTS {
            return Err(Error::Count {
                count: self.course.steps.len(),
                most: MOST_SEGMENTS,
            });
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

    /// What smooth cubics become: those that were drawn as arcs such, unless that makes more of them.
    fn spans<'a>(&self, chain: &'a [CubicBez], room: f64) -> Vec<Span<'a>> {
        let rules = Rules {
            absolute: room,
            ..self.rules
        };
        let mut search = Search::new(room);
        let (mut spans, mut free, mut at, mut drawn) = (Vec::new(), 0, 0, 0);
        while at < chain.len() {
            let rest = &chain[at..];
            let straight = is_straight(&rest[0]);
            let found = if straight {
                [None; 2]
            } else {
                recognize::halves(rest, &rules)
            };
            let taken: usize = found.iter().flatten().map(|found| found.count).sum();
            if taken == 0 && !straight {
                at += 1;
                continue;
            }
            let pieces = search.pieces(&chain[free..at], MOST_SEGMENTS);
            spans.extend(pieces.into_iter().map(Span::Fitted));
            if straight {
                spans.push(Span::Straight(&rest[0]));
            }
            let mut begin = 0;
            for found in found.into_iter().flatten() {
                spans.push(Span::Found(&rest[begin..begin + found.count], found));
                begin += found.count;
            }
            drawn += 1;
            at += taken.max(1);
            free = at;
        }
        let pieces = search.pieces(&chain[free..], MOST_SEGMENTS);
        spans.extend(pieces.into_iter().map(Span::Fitted));
        if drawn > 0 && spans.len() > 1 {
            let fewer = search.pieces(chain, spans.len());
            if fewer.len() < spans.len() {
                spans = fewer.into_iter().map(Span::Fitted).collect();
            }
        }
        spans
    }

    fn span(&mut self, span: &Span<'_>, strayed: f64) -> Result<()> {
        match span {
            Span::Straight(cubic) => {
                let off = strayed + cubic_from_chord(cubic);
                self.line(cubic.p0, cubic.p3, off, true);
                Ok(())
            }
            Span::Found(cubics, found) => {
                let to = self.plan.end(found.given.to);
                let precision = if self.plan.rounds_given {
                    self.plan.precision
                } else {
                    Precision::Full
                };
                self.arc(cubics, &found.given, to, &[precision], strayed)
            }
            Span::Fitted(fit) => self.fitted(fit, strayed),
        }
    }

    fn fitted(&mut self, fit: &Fit, strayed: f64) -> Result<()> {
        let (Some(first), Some(last)) = (fit.parts.first(), fit.parts.last()) else {
            return Ok(());
        };
        let to = if fit.ends_given {
            self.plan.end(last.p3)
        } else {
            self.plan.inner(last.p3)
        };
        let Some(half) = fit.half.filter(|_| self.at != to) else {
            let off = strayed + from_chord(&fit.parts);
            self.line(first.p0, last.p3, off, fit.ends_given);
            return Ok(());
        };
        let precisions: Vec<_> = match self.plan.precision {
            Precision::Fixed(decimals) if !self.plan.rounds_given => (decimals
                ..=decimals + MORE_DECIMALS)
                .map(Precision::Fixed)
                .chain([Precision::Full])
                .collect(),
            precision => vec![precision],
        };
        self.arc(
            &fit.parts,
            &arc_of(self.at, to, half),
            to,
            &precisions,
            strayed,
        )
    }

    /// An arc in place of cubics, with the fewest decimals of its radii that keep it near enough.
    fn arc(
        &mut self,
        parts: &[CubicBez],
        like: &SvgArc,
        to: Point,
        precisions: &[Precision],
        strayed: f64,
    ) -> Result<()> {
        let room = self.plan.tolerance - strayed;
        let mut best: Option<(SvgArc, Arc, f64)> = None;
        for precision in precisions {
            let round = |x| precision.round(x);
            let given = SvgArc {
                from: self.at,
                radii: Vec2::new(round(like.radii.x), round(like.radii.y)),
                to,
                ..*like
            };
            let Ok(Shape::Arc(arc)) = given.shape() else {
                continue;
            };
            let off = bound(parts, &arc);
            if best.as_ref().is_none_or(|(_, _, least)| off < *least) {
                best = Some((given, arc, off));
            }
            if off <= self.plan.room - strayed {
                break;
            }
        }
        match best {
            Some((given, arc, off)) if off <= room => {
                self.error = self.error.max(off + strayed);
                self.push(&given, &arc);
                Ok(())
            }
            _ => Err(self.plan.too_coarse()),
        }
    }

    fn line(&mut self, from: Point, to: Point, off: f64, ends_given: bool) {
        let end = if ends_given {
            self.plan.end(to)
        } else {
            self.plan.inner(to)
        };
        let moved = from.distance(self.at).max(to.distance(end));
        self.error = self.error.max(off + moved);
        self.course.steps.push(course::Step::Line(end));
        self.at = end;
    }

    fn push(&mut self, given: &SvgArc, arc: &Arc) {
        self.at = given.to;
        self.course.steps.push(if arc.radii.x == arc.radii.y {
            course::Step::Arc(CircularArc {
                to: given.to,
                center: arc.center,
                radius: arc.radii.x,
                start: arc.start,
                sweep: arc.sweep,
                ends_given: true,
            })
        } else {
            course::Step::Elliptical(*given)
        });
    }
}

fn is_straight(cubic: &CubicBez) -> bool {
    cubic_from_chord(cubic) <= STRAIGHT * cubic.p0.distance_squared(cubic.p3).sqrt()
}
