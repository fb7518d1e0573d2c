//! Lines and arcs as they are printed: rounded one after the other, and each of them measured after that.
//!
//! The ends of a piece are rounded before its arc is known, so that a small arc of a large sweep may stray farther than the tolerance.
//! Its cubics then become shorter pieces, and chords where even these are too far: what chords of any curve stray is known beforehand.

use kurbo::{CubicBez, Point, Vec2};

use super::bound::from_arc;
use super::chords;
use super::fit::PieceSearch;
use super::form::Fitted;
use super::from_chord::from_chord;
use super::half_turn::half_turn;
use super::piece::StepCurve;
use super::recognize::{Found, Rules, is_enlarged};
use super::{Options, Plan};
use crate::Angle;
use crate::contour::Subpath;
use crate::course::{self, CircularArc, Course};
use crate::curve::Curve;
use crate::error::Result;
use crate::joints::MOST_SEGMENTS;
use crate::number::Precision;
use crate::radial_error::RadialError;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Shape};

/// How many decimals more a radius may have than the points, where these are not enough for it.
const MORE_DECIMALS: u8 = 8;

/// How many times as far as a point the rounding of its centre moves an arc, at most.
const MOVED_AGAIN: f64 = 4.0;

/// The part of the tolerance that is left to that.
const AGAIN_PART: f64 = 0.25;

/// The parts of the tolerance within which shorter pieces are looked for.
const FINER: [f64; 2] = [0.5, 0.2];

/// What a stretch of a chain becomes.
pub(super) enum Stretch<'a> {
    /// A line in place of a straight cubic.
    Straight(&'a CubicBez),
    /// An arc in place of cubics that were drawn as one.
    Found(&'a [CubicBez], Found),
    /// A piece of cubics that were not.
    Fitted(Fitted),
}

/// Writes the course of a subpath, rounding as it goes.
pub(super) struct Builder<'a> {
    pub(super) plan: Plan,
    pub(super) options: &'a Options,
    pub(super) rules: Rules,
    pub(super) course: Course,
    /// Where the course is, as it is printed.
    pub(super) at: Point,
    pub(super) error: f64,
    /// That of arcs alone.
    pub(super) error_of_arcs: f64,
}

impl Builder<'_> {
    pub(super) fn subpath(self, closed: bool) -> Result<Subpath> {
        if self.error > self.plan.tolerance {
            return Err(self.plan.too_coarse());
        }
        Ok(Subpath {
            curve: Curve {
                segments: Vec::new(),
                closed,
            },
            course: Some(self.course),
            error: RadialError::balanced(self.error),
            closeness: Some(self.plan.closeness([self.error, self.error_of_arcs])),
            truths: Vec::new(),
            radius: self.plan.size,
        })
    }

    /// Appends what a stretch of cubics becomes, which stray this far from what was given.
    pub(super) fn span(&mut self, span: &Stretch<'_>, strayed: f64) -> Result<()> {
        let cut = strayed + self.plan.cut();
        let (parts, ends_given) = match span {
            Stretch::Straight(cubic) => {
                let off = strayed + from_chord(core::slice::from_ref(cubic));
                self.line(cubic.p0, cubic.p3, off, true);
                return self.counted();
            }
            Stretch::Found(cubics, found) => {
                // Half a turn whose radius is too small for its ends is drawn with theirs, which has many digits.
                let is_enlarged = is_enlarged(&found.given, &found.arc);
                let mut given = found.given;
                if is_enlarged {
                    given.radii = found.arc.radii;
                }
                let precisions = if is_enlarged || self.plan.rounds_given {
                    self.precisions()
                } else {
                    vec![Precision::Full]
                };
                let to = self.plan.end(given.to);
                if self.arc(cubics, &given, to, &precisions, strayed) {
                    return self.counted();
                }
                (*cubics, true)
            }
            Stretch::Fitted(fit) => {
                if self.fitted(fit, fit.ends_given, cut) {
                    return self.counted();
                }
                (&fit.parts[..], fit.ends_given)
            }
        };
        self.finer(parts, ends_given, cut)?;
        self.counted()
    }

    fn counted(&self) -> Result<()> {
        let count = self.course.steps.len();
        if count > MOST_SEGMENTS {
            return Err(self.plan.too_many());
        }
        Ok(())
    }

    /// Appends a piece, unless rounding takes it too far.
    fn fitted(&mut self, fit: &Fitted, ends_given: bool, strayed: f64) -> bool {
        let (Some(first), Some(last)) = (fit.parts.first(), fit.parts.last()) else {
            return true;
        };
        let to = self.rounded(last.p3, ends_given);
        let Some(arc) = fit.arc(self.at, to).filter(|_| self.at != to) else {
            let off = strayed + from_chord(&fit.parts);
            let moved = self.at.distance(first.p0).max(to.distance(last.p3));
            let fits = off + moved <= self.plan.tolerance;
            if fits {
                self.line(first.p0, last.p3, off, ends_given);
            }
            return fits;
        };
        self.arc(&fit.parts, &arc, to, &self.precisions(), strayed)
    }

    /// To what radii are rounded: one after the other is tried.
    fn precisions(&self) -> Vec<Precision> {
        match self.plan.precision {
            Precision::Fixed(decimals) if !self.plan.rounds_given => (decimals
                ..=decimals + MORE_DECIMALS)
                .map(Precision::Fixed)
                .chain([Precision::Full])
                .collect(),
            precision => vec![precision],
        }
    }

    /// Cubics as shorter pieces.
    fn finer(&mut self, parts: &[CubicBez], ends_given: bool, strayed: f64) -> Result<()> {
        let (steps, at) = (self.course.steps.len(), self.at);
        let errors = [self.error, self.error_of_arcs];
        for share in FINER {
            let mut search = PieceSearch::new(share * (self.plan.room - strayed), false);
            let fits = search.pieces(parts, MOST_SEGMENTS);
            let last = fits.len().saturating_sub(1);
            let mut fits = fits.iter().enumerate();
            if fits.all(|(i, fit)| {
                let given = if i == last {
                    ends_given
                } else {
                    fit.ends_given
                };
                self.fitted(fit, given, strayed)
            }) {
                return Ok(());
            }
            self.course.steps.truncate(steps);
            self.at = at;
            [self.error, self.error_of_arcs] = errors;
        }
        let room = self.plan.room_of_chords(self.options, strayed);
        if room <= 0.0 {
            return Err(self.plan.too_coarse());
        }
        let last = parts.len().saturating_sub(1);
        for (i, part) in parts.iter().enumerate() {
            let (piece, mut from) = (StepCurve::Cubic(*part), 0.0);
            let room = chords::Room {
                rounded: room,
                exact: room,
            };
            for to in chords::cuts(&piece, room).ends {
                let given = to == 1.0 && (i < last || ends_given);
                let off = strayed + piece.chord_distance(from, to);
                self.line(piece.point(from), piece.point(to), off, given);
                from = to;
            }
            self.counted()?;
        }
        Ok(())
    }

    /// Appends an arc in place of cubics, with the fewest decimals of its radii that keep it near enough, unless none do.
    fn arc(
        &mut self,
        parts: &[CubicBez],
        like: &SvgArc,
        to: Point,
        precisions: &[Precision],
        strayed: f64,
    ) -> bool {
        let mut best: Option<(SvgArc, Arc, f64)> = None;
        for precision in precisions {
            let round = |x| precision.round(x);
            let turned = precision.of_angles();
            let given = SvgArc {
                from: self.at,
                radii: Vec2::new(round(like.radii.x), round(like.radii.y)),
                rotation: Angle::from_degrees(turned.round(like.rotation.degrees())),
                to,
                ..*like
            };
            let Ok(Shape::Arc(arc)) = given.shape() else {
                continue;
            };
            if is_enlarged(&given, &arc) && precisions.len() > 1 && *precision != Precision::Full {
                continue;
            }
            let off = from_arc(parts, &arc) + strayed;
            if best.as_ref().is_none_or(|(_, _, least)| off < *least) {
                best = Some((given, arc, off));
            }
            if off <= self.plan.room {
                break;
            }
        }
        let best = best.filter(|(given, arc, off)| {
            *off <= self.plan.tolerance && self.leaves_room(given, arc, *off)
        });
        if let Some((given, arc, off)) = &best {
            self.push(given, arc, *off);
        }
        best.is_some()
    }

    /// Appends a line between these points, which strays so far before they are rounded.
    pub(super) fn line(&mut self, from: Point, to: Point, off: f64, ends_given: bool) {
        let end = self.rounded(to, ends_given);
        let moved = from.distance(self.at).max(to.distance(end));
        self.error = self.error.max(off + moved);
        // Of a piece of a curve that rounding makes a point nothing is left to draw.
        if end != self.at || ends_given {
            self.course.steps.push(course::CourseStep::Line(end));
        }
        self.at = end;
    }

    fn rounded(&self, p: Point, is_given: bool) -> Point {
        if is_given {
            self.plan.end(p)
        } else {
            self.plan.inner(p)
        }
    }

    /// Appends an arc as it is printed, which strays so far.
    pub(super) fn push(&mut self, given: &SvgArc, arc: &Arc, off: f64) {
        self.error = self.error.max(off);
        self.error_of_arcs = self.error_of_arcs.max(off);
        self.at = given.to;
        let circular = circular(given, arc).map(course::CourseStep::Arc);
        let step = circular.unwrap_or(course::CourseStep::Elliptical(*given));
        self.course.steps.push(step);
    }

    /// Whether an arc that strays so far leaves room for G-code to round its centre to the decimals that were asked for: for all of them the
    /// same, as what is left after all is compared with how far any of them moves.
    pub(super) fn leaves_room(&self, given: &SvgArc, arc: &Arc, off: f64) -> bool {
        if !(self.options.rounds_again && self.plan.rounds_given) {
            return true;
        }
        let (precision, tolerance) = (self.plan.precision, self.plan.tolerance);
        let room = (MOVED_AGAIN * precision.farthest_moved()).min(AGAIN_PART * tolerance);
        let moves = circular(given, arc).map_or(0.0, |arc| {
            arc.strayed(&arc.rounded(precision), given.from, 0.0)
        });
        off + room <= tolerance && moves <= room
    }
}

/// The arc as a step, where it is one of a circle.
fn circular(given: &SvgArc, arc: &Arc) -> Option<CircularArc> {
    (arc.radii.x == arc.radii.y).then(|| CircularArc {
        to: given.to,
        center: arc.center,
        radius: if is_enlarged(given, arc) {
            let radii = arc.radii;
            half_turn(&SvgArc { radii, ..*given }).radii.x
        } else {
            given.radii.x
        },
        start: arc.start,
        sweep: arc.sweep,
        ends_given: true,
    })
}
