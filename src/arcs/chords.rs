//! Where a piece is cut into chords: each as long as the tolerance lets it be, and never more of them than by halving.

use super::piece::StepCurve;
use crate::joints::MOST_SEGMENTS;

/// How often a chord's end is moved as its distance says.
const STEPS: u32 = 10;

/// How often what is left is halved after that; twice as often where no chord fits yet.
const HALVINGS: u32 = 20;

/// A chord is long enough where it uses this part of the tolerance.
const USED: f64 = 1.0 - 1e-6;

/// The part that is aimed at.
const WANTED: f64 = 1.0 - 5e-7;

/// How often the parameter is halved at most: beyond that floats are no closer together.
const DEEPEST: u32 = 40;

/// The ends of the chords of a loop that fewer would leave nothing of.
const THIRDS: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

/// How many times as far as a chord ends are looked at beyond it.
const LOOKED_BEYOND: f64 = 3.0;

/// How many of them.
const PLACES: usize = 12;

/// No more chords are looked for from the other end too: of many, one is less than a twentieth.
const FEW: usize = 21;

/// How far chords may lie from a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room {
    /// Those whose ends are rounded.
    pub(super) rounded: f64,
    /// Those whose ends are what was given, or computed to the last digit.
    pub(super) exact: f64,
}

/// Where a piece is cut.
#[derive(Debug)]
pub(super) struct Cuts {
    /// The parameters at which chords end, 1 the last; no more than one above [`MOST_SEGMENTS`].
    pub(super) ends: Vec<f64>,
    /// Whether halving took fewer, were the ends not rounded.
    pub(super) by_rounding: bool,
}

impl Cuts {
    const fn certain(ends: Vec<f64>) -> Self {
        Self {
            ends,
            by_rounding: false,
        }
    }
}

pub(super) fn cuts(piece: &StepCurve, room: Room) -> Cuts {
    if piece.is_line() {
        return Cuts::certain(vec![1.0]);
    }
    let whole = piece.chord_distance(0.0, 1.0);
    let cuts = if whole <= room.exact.max(0.0) {
        Cuts::certain(vec![1.0])
    } else {
        fewest(piece, room)
    };
    // A small loop stays one.
    let is_loop = whole > 0.0 && piece.start() == piece.end();
    let fits = |ends: &[f64]| piece.chord_distance(ends[0], ends[1]) <= room.exact;
    if is_loop && cuts.ends.len() < 3 && THIRDS.windows(2).all(fits) {
        Cuts::certain(THIRDS[1..].to_vec())
    } else {
        cuts
    }
}

/// The longest chords, or those by halving where they are fewer.
fn fewest(piece: &StepCurve, room: Room) -> Cuts {
    let ends = longest(piece, room.rounded);
    if ends.len() > MOST_SEGMENTS {
        return Cuts::certain(ends);
    }
    // What does not fit exactly does not fit rounded.
    if halved(piece, room.exact, ends.len()).is_none() {
        return Cuts::certain(ends);
    }
    match halved(piece, room.rounded, ends.len()) {
        Some(ends) => Cuts::certain(ends),
        None => Cuts {
            ends,
            by_rounding: true,
        },
    }
}

/// Chords as long as they can be, one after the other; where longer parts may lie nearer to their chords than shorter ones, from the end
/// where these are fewer.
fn longest(piece: &StepCurve, tolerance: f64) -> Vec<f64> {
    let walk = |backward| ChordWalk {
        piece,
        tolerance,
        backward,
    };
    let ends = walk(false).ends();
    if ends.len() > FEW || piece.is_convex(0.0, 1.0) {
        return ends;
    }
    let starts = walk(true).ends();
    if starts.len() < ends.len() {
        let inner = starts.iter().rev().skip(1).map(|start| 1.0 - start);
        inner.chain([1.0]).collect()
    } else {
        ends
    }
}

/// The ends of chords by halving the parameter again and again, where these are fewer.
fn halved(piece: &StepCurve, tolerance: f64, fewer_than: usize) -> Option<Vec<f64>> {
    let mut halved = Vec::new();
    halve(
        piece,
        tolerance,
        (0.0, 1.0),
        DEEPEST,
        fewer_than,
        &mut halved,
    );
    (halved.len() < fewer_than).then_some(halved)
}

/// Chords as long as they can be, from the one end of a piece or the other: a parameter is the way from there.
struct ChordWalk<'a> {
    piece: &'a StepCurve,
    tolerance: f64,
    backward: bool,
}

impl ChordWalk<'_> {
    fn ends(&self) -> Vec<f64> {
        let (mut ends, mut from, mut guess) = (Vec::new(), 0.0, 1.0);
        while from < 1.0 && ends.len() <= MOST_SEGMENTS {
            let to = self.farthest(from, guess);
            (from, guess) = (to, to - from);
            ends.push(from);
        }
        ends
    }

    /// The parameters of the piece itself.
    fn part(&self, from: f64, to: f64) -> (f64, f64) {
        if self.backward {
            (1.0 - to, 1.0 - from)
        } else {
            (from, to)
        }
    }

    fn distance(&self, from: f64, to: f64) -> f64 {
        let (from, to) = self.part(from, to);
        self.piece.chord_distance(from, to)
    }

    fn fits(&self, from: f64, to: f64) -> bool {
        let (from, to) = self.part(from, to);
        self.piece.is_chord_within(from, to, self.tolerance)
    }

    /// The farthest end of a chord from here, of about this length at first: the end that comes first, or one beyond it, where the distance
    /// falls again as it does past inflections and folds.
    fn farthest(&self, from: f64, guess: f64) -> f64 {
        if self.fits(from, 1.0) {
            return 1.0;
        }
        let (near, far) = self.end_between(from, [from, 1.0], from + guess);
        // Where not even the shortest fits, floats end: what is left is next to nothing.
        if near <= from {
            return far;
        }
        let reach = (LOOKED_BEYOND * (near - from)).min(1.0 - near);
        let (start, end) = self.part(from, near + reach);
        if self.piece.is_convex(start, end) {
            return near;
        }
        let place = |i: usize| near + reach * i as f64 / PLACES as f64;
        let beyond = (1..=PLACES).rev().find(|&i| self.fits(from, place(i)));
        beyond.map_or(near, |i| {
            let far = if i < PLACES { place(i + 1) } else { 1.0 };
            self.end_between(from, [place(i), far], place(i)).0
        })
    }

    /// The last end that fits and the first that does not, between one and another, from a guess on.
    fn end_between(&self, from: f64, [mut near, mut far]: [f64; 2], mut to: f64) -> (f64, f64) {
        for round in 0..STEPS + 2 * HALVINGS {
            if to <= near || to >= far || round >= STEPS {
                to = f64::midpoint(near, far);
            }
            let off = self.distance(from, to);
            let fits = off <= self.tolerance;
            if fits {
                near = to;
            } else {
                far = to;
            }
            let is_used = fits && off >= USED * self.tolerance;
            if is_used || (round >= STEPS + HALVINGS && near > from) {
                break;
            }
            // The distance grows with the square of the length.
            let factor = (WANTED * self.tolerance / off).sqrt();
            to = from + factor.clamp(0.1, 4.0) * (to - from);
        }
        (near, far)
    }
}

fn halve(
    piece: &StepCurve,
    tolerance: f64,
    (from, to): (f64, f64),
    depth: u32,
    most: usize,
    cuts: &mut Vec<f64>,
) {
    if cuts.len() >= most {
        return;
    }
    if depth == 0 || piece.is_chord_within(from, to, tolerance) {
        cuts.push(to);
        return;
    }
    let middle = 0.5 * (from + to);
    halve(piece, tolerance, (from, middle), depth - 1, most, cuts);
    halve(piece, tolerance, (middle, to), depth - 1, most, cuts);
}
