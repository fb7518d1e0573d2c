//! A contour as lines.

use kurbo::{Line, PathSeg};

use super::chords::{self, Cuts, Room};
use super::piece::StepCurve;
use super::{Options, Plan, pieces};
use crate::contour::{Contour, Subpath};
use crate::curve::Curve;
use crate::error::Result;
use crate::joints::MOST_SEGMENTS;
use crate::radial_error::RadialError;

pub(super) fn subpath(contour: &Contour, options: &Options) -> Result<Subpath> {
    let pieces = pieces(contour, options.transform)?;
    let mut plan = Plan::new(&pieces, options, 0.0)?;
    let curved = pieces.iter().any(|piece| !piece.is_line());
    let room = plan.room_of_chords(options, plan.cut());
    if curved && room <= 0.0 && plan.size > 0.0 {
        return Err(plan.too_coarse());
    }
    let mut cuts = all_cuts(&pieces, &plan, options)?;
    if cuts.iter().any(|cuts| cuts.by_rounding) {
        plan = plan.finer();
        cuts = all_cuts(&pieces, &plan, options)?;
    }
    let (segments, error) = drawn(&pieces, &cuts, &plan);
    if error > plan.tolerance {
        return Err(plan.too_coarse());
    }
    Ok(Subpath {
        curve: Curve {
            segments,
            closed: contour.closed,
        },
        course: None,
        error: RadialError::balanced(error),
        closeness: Some(plan.closeness([error; 2])),
        truths: Vec::new(),
        radius: plan.size,
    })
}

fn all_cuts(pieces: &[StepCurve], plan: &Plan, options: &Options) -> Result<Vec<Cuts>> {
    let rounded = plan.room_of_chords(options, plan.cut());
    let room = Room {
        rounded,
        exact: if options.precision.is_some() || options.rounds_again {
            rounded
        } else {
            plan.tolerance - plan.cut()
        },
    };
    let (mut all, mut count) = (Vec::with_capacity(pieces.len()), 0);
    for piece in pieces {
        let cuts = chords::cuts(piece, room);
        count += cuts.ends.len();
        if count > MOST_SEGMENTS {
            return Err(plan.too_many());
        }
        all.push(cuts);
    }
    Ok(all)
}

/// The chords as they are printed, and how far they lie from the pieces.
fn drawn(pieces: &[StepCurve], cuts: &[Cuts], plan: &Plan) -> (Vec<PathSeg>, f64) {
    let mut segments = Vec::new();
    let mut error = 0.0_f64;
    for (piece, cuts) in pieces.iter().zip(cuts) {
        let before = segments.len();
        let (mut from, mut at) = (plan.end(piece.start()), 0.0);
        let mut moved = from.distance(piece.start());
        for &cut in &cuts.ends {
            let (truth, to) = if cut < 1.0 {
                let truth = piece.point(cut);
                (truth, plan.inner(truth))
            } else {
                (piece.end(), plan.end(piece.end()))
            };
            let shift = to.distance(truth);
            let off = if cut - at < 1.0 { plan.cut() } else { 0.0 };
            error = error.max(piece.chord_distance(at, cut) + off + shift.max(moved));
            // Of a chord that rounding makes a point nothing is left to draw, unless the whole piece is one.
            if from != to || (cut == 1.0 && segments.len() == before) {
                segments.push(PathSeg::Line(Line::new(from, to)));
            }
            (from, at, moved) = (to, cut, shift);
        }
    }
    (segments, error)
}
