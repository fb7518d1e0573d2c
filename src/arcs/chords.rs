//! Where a piece is cut into chords: each as long as the tolerance lets it be, and never more of them than by halving.

use super::piece::Piece;
use crate::joints::MOST_SEGMENTS;

/// How often the bracket of a chord's end is halved: to a millionth of what is left of the piece.
const HALVINGS: u32 = 20;

/// How often the parameter is halved at most: beyond that floats are no closer together.
const DEEPEST: u32 = 40;

/// The ends of the chords of a loop that fewer would leave nothing of.
const THIRDS: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

/// The parameters at which the chords of a piece end, 1 the last. No more than one above [`MOST_SEGMENTS`] are found.
pub(super) fn cuts(piece: &Piece, tolerance: f64) -> Vec<f64> {
    if piece.is_line() {
        return vec![1.0];
    }
    let whole = piece.chord_distance(0.0, 1.0);
    let found = if whole <= tolerance.max(0.0) {
        vec![1.0]
    } else {
        fewest(piece, tolerance)
    };
    // A small loop stays one.
    let is_loop = whole > 0.0 && piece.start() == piece.end();
    let fits = |ends: &[f64]| piece.chord_distance(ends[0], ends[1]) <= tolerance;
    if is_loop && found.len() < 3 && THIRDS.windows(2).all(fits) {
        THIRDS[1..].to_vec()
    } else {
        found
    }
}

/// The longest chords, or those by halving where they are fewer.
fn fewest(piece: &Piece, tolerance: f64) -> Vec<f64> {
    let longest = longest(piece, tolerance);
    if longest.len() > MOST_SEGMENTS {
        return longest;
    }
    let mut halved = Vec::new();
    // Where longest chords reach less far than others would, as on loops, halving may find fewer.
    halve(
        piece,
        tolerance,
        (0.0, 1.0),
        DEEPEST,
        longest.len(),
        &mut halved,
    );
    if halved.len() < longest.len() {
        halved
    } else {
        longest
    }
}

fn longest(piece: &Piece, tolerance: f64) -> Vec<f64> {
    let mut cuts = Vec::new();
    let mut from = 0.0;
    while from < 1.0 && cuts.len() <= MOST_SEGMENTS {
        from = farthest(piece, tolerance, from);
        cuts.push(from);
    }
    cuts
}

/// The farthest end of a chord from here that bisection finds.
fn farthest(piece: &Piece, tolerance: f64, from: f64) -> f64 {
    let fits = |to: f64| piece.chord_distance(from, to) <= tolerance;
    if fits(1.0) {
        return 1.0;
    }
    let (mut near, mut far) = (from, 1.0);
    for round in 0..2 * HALVINGS {
        let middle = 0.5 * (near + far);
        if fits(middle) {
            near = middle;
        } else {
            far = middle;
        }
        if round >= HALVINGS && near > from {
            break;
        }
    }
    // Where not even the shortest fits, floats end: what is left is next to nothing.
    if near > from { near } else { far }
}

fn halve(
    piece: &Piece,
    tolerance: f64,
    (from, to): (f64, f64),
    depth: u32,
    most: usize,
    cuts: &mut Vec<f64>,
) {
    if cuts.len() >= most {
        return;
    }
    if depth == 0 || piece.chord_distance(from, to) <= tolerance {
        cuts.push(to);
        return;
    }
    let middle = 0.5 * (from + to);
    halve(piece, tolerance, (from, middle), depth - 1, most, cuts);
    halve(piece, tolerance, (middle, to), depth - 1, most, cuts);
}
