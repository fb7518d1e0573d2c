//! The fewest arcs and lines whose ends lie on a chain of cubics: each reaches as far as the tolerance lets it.
//!
//! Let a chord of length L run along x. The circles through its ends are x² + y² - Lx + L y / tan h = 0, h half the sweep of the arc,
//! positive to the left. To first order a point (x, y) lies
//!
//! d = y cos h - w sin h, w = (Lx - x² - y²)/L
//!
//! from one: its distance, in the plane of (w, y), from the line through the origin in the direction h. Of all these lines the best is
//! that to which the farthest points on both sides are equally near; it is found by exchange, as Remez does.

use kurbo::{CubicBez, Vec2};

use super::chain::Chain;
use super::form::{Fitted, Replacement};
use super::oval;
use crate::numeric::functions::angle_of;

/// How often points are exchanged.
const EXCHANGES: usize = 6;

/// An end is near enough to the farthest one where it uses this part of the tolerance.
const USED: f64 = 0.995;

/// How often an end is moved.
const MOVES: usize = 60;

/// How many points of a stretch are looked at, at least.
const POINTS: usize = 12;

/// How many where these say too little, as they do where the curve stands still.
const MANY_POINTS: usize = 64;

/// By how much more points may lower the bound.
const MOVED_BY_POINTS: f64 = 1.25;

/// The part by which a stretch is shortened first, where the bound says more than its points.
const FIRST_STEP: f64 = 1e-3;

/// The part of a stretch that is not looked for.
const LEFT_OUT: f64 = 0.02;

/// The part by which an arc of an ellipse has to reach farther than one of a circle, at first.
const FARTHER: f64 = 0.05;

/// The part of a stretch that is not looked for with arcs of ellipses.
const ELLIPSE_LEFT_OUT: f64 = 0.005;

/// A line is taken where an arc is no more than this many times nearer.
const NEARER: f64 = 2.0;

/// Into how many parts of the length of a piece what lies beyond it is divided to look for a longer one.
const BEYOND: f64 = 16.0;

/// How many of them away the first look is.
const PROBED: u32 = 5;

/// How many times the tolerance a longer piece may stray there, if there is to be a second look; by the third power of the length it were more
/// than twice as much.
const FALLS: f64 = 1.6;

/// Half the largest sweep, in radians: with more the ends are close to each other.
const LARGEST_HALF: f64 = 2.9;

/// What the points between two ends say of the arc between these.
#[derive(Debug, Clone, Copy)]
struct Nearest {
    half: f64,
    /// How far the points lie from it.
    off: f64,
    /// How far they lie from the chord.
    off_line: f64,
}

/// How many times as long as the piece before it the next one may be without a second look.
const MOST_LONGER: f64 = 16.0;

/// Looks for the fewest pieces of chains.
pub(super) struct PieceSearch {
    room: f64,
    /// Whether arcs may be those of ellipses.
    elliptic: bool,
    /// The points (w, y) of the last stretch.
    points: Vec<Vec2>,
}

impl PieceSearch {
    pub(super) const fn new(room: f64, elliptic: bool) -> Self {
        Self {
            room,
            elliptic,
            points: Vec::new(),
        }
    }

    /// The pieces of a chain, no more than one above `most`; with arcs of ellipses where these make fewer.
    pub(super) fn pieces(&mut self, cubics: &[CubicBez], most: usize) -> Vec<Fitted> {
        let walked = self.walk(cubics, most, false);
        let circular = self.even(cubics, walked.len()).unwrap_or(walked);
        if self.elliptic && circular.len() > 1 {
            let mixed = self.walk(cubics, circular.len() - 1, true);
            if mixed.len() < circular.len() {
                return mixed;
            }
        }
        circular
    }

    /// The pieces of a chain, each as long as the tolerance lets it be, no more than one above `most`.
    fn walk(&mut self, cubics: &[CubicBez], most: usize, elliptic: bool) -> Vec<Fitted> {
        let chain = Chain::new(cubics);
        let (mut fits, mut from, mut guess) = (Vec::new(), 0.0, 1.0);
        while from < chain.end() && fits.len() <= most {
            let mut piece = self.longest(&chain, from, guess);
            if elliptic {
                piece = self.farther(&chain, from, piece);
            }
            let (to, fit) = piece;
            guess = to - from;
            fits.push(fit);
            from = to;
        }
        fits
    }

    /// The longest piece from here, one of about so many cubics at first: where a chain comes back to itself again and again all of it may
    /// seem near an arc, and be too much to look at for each piece.
    fn longest(&mut self, chain: &Chain<'_>, from: f64, mut guess: f64) -> (f64, Fitted) {
        loop {
            let most = MOST_LONGER * guess;
            let to = self.farthest(chain, from, guess, most);
            let piece = self.piece(chain, from, to);
            if piece.0 < from + most || most >= chain.reach() {
                return self.beyond(chain, from, piece);
            }
            guess = most;
        }
    }

    /// A longer piece than one that was found, where the distance falls again beyond it, as it does where the curvature falls after a peak.
    fn beyond(&mut self, chain: &Chain<'_>, from: f64, found: (f64, Fitted)) -> (f64, Fitted) {
        let end = chain.end().min(from + chain.reach());
        let length = found.0 - from;
        let place = |i: u32| found.0 + length * f64::from(i) / BEYOND;
        let mut off = |to, points| self.nearest(chain, (from, to), points).off / self.room;
        if place(PROBED) > end || off(place(PROBED), POINTS / 2) > FALLS {
            return found;
        }
        let far = (PROBED - 1..=2 * PROBED).rev().map(place);
        let far = far
            .filter(|&to| to <= end && off(to, POINTS) <= 1.0)
            .collect::<Vec<_>>();
        for to in far {
            if let Ok(fit) = self.attempt(chain, from, to) {
                return self.longer(chain, from, (to, fit), end.min(to + length / BEYOND));
            }
        }
        found
    }

    /// The piece up to where an arc of an ellipse reaches from here, or the one that there is.
    fn farther(&self, chain: &Chain<'_>, from: f64, best: (f64, Fitted)) -> (f64, Fitted) {
        let end = chain.end().min(from + chain.reach());
        let ((mut to, mut fit), mut failed) = (best, f64::INFINITY);
        let mut step = FARTHER * (to - from);
        for _ in 0..MOVES {
            let want = if failed.is_finite() {
                0.5 * (to + failed)
            } else {
                (to + step).min(end)
            };
            if want <= to || failed - to <= ELLIPSE_LEFT_OUT * (to - from) {
                break;
            }
            match self.elliptical(chain, from, want) {
                Some(more) => (to, fit) = (want, more),
                None => failed = want,
            }
            step *= 2.0;
        }
        (to, fit)
    }

    /// The arc of an ellipse between two parameters, where it is near enough.
    fn elliptical(&self, chain: &Chain<'_>, from: f64, to: f64) -> Option<Fitted> {
        let (oval, off) = oval::nearest(chain, from, to)?;
        let fit = || Fitted {
            parts: chain.between(from, to),
            form: Replacement::Elliptical(oval),
            ends_given: to.fract() == 0.0,
        };
        (off <= self.room)
            .then(fit)
            .filter(|fit| fit.bound() <= self.room)
    }

    /// The farthest end of an arc from here, as points of the chain have it, after so many cubics at most.
    fn farthest(&mut self, chain: &Chain<'_>, from: f64, guess: f64, most: f64) -> f64 {
        let end = chain.end().min(from + chain.reach().min(most));
        if end - from <= 2.0 && self.nearest(chain, (from, end), POINTS).off <= self.room {
            return end;
        }
        let (mut near, mut far, mut to) = (from, f64::INFINITY, (from + guess).min(end));
        for _ in 0..MOVES {
            let off = self.nearest(chain, (from, to), POINTS).off;
            if off <= self.room {
                near = to;
                if near >= end || off >= USED * self.room {
                    break;
                }
            } else {
                far = to;
            }
            if far.is_finite() && far - near <= 1e-3 * (far - from) && near > from {
                break;
            }
            // The distance grows with the third power of the length.
            let factor = libm::cbrt(0.999 * self.room / off).clamp(0.1, 2.0);
            let factor = if factor.is_finite() { factor } else { 0.5 };
            let want = (from + factor * (to - from)).min(end);
            let inside = want > near && want < far - 0.02 * (far - near).min(1.0);
            to = if inside || far.is_infinite() {
                want
            } else {
                0.5 * (near + far)
            };
        }
        if near > from { near } else { far.min(end) }
    }

    /// The piece from here to at most there that the bound lets be.
    fn piece(&mut self, chain: &Chain<'_>, from: f64, end: f64) -> (f64, Fitted) {
        let (mut to, mut failed, mut step) = (end, end, FIRST_STEP);
        for _ in 0..MOVES {
            match self.attempt(chain, from, to) {
                Ok(fit) => return self.longer(chain, from, (to, fit), failed),
                Err(bound) => {
                    failed = to;
                    let factor = libm::cbrt(0.995 * self.room / bound);
                    to = from + factor.clamp(0.5, 1.0 - step) * (to - from);
                    step = (2.0 * step).min(0.5);
                }
            }
        }
        // Where not even the shortest fits, floats end: what is left is next to nothing.
        let line = Fitted {
            parts: chain.between(from, failed),
            form: Replacement::Line,
            ends_given: failed.fract() == 0.0,
        };
        (failed, line)
    }

    /// A piece no shorter than one that fits, towards where none does.
    fn longer(
        &mut self,
        chain: &Chain<'_>,
        from: f64,
        best: (f64, Fitted),
        mut failed: f64,
    ) -> (f64, Fitted) {
        let (mut to, mut fit) = best;
        while failed - to > LEFT_OUT * (to - from) {
            let middle = 0.5 * (to + failed);
            match self.attempt(chain, from, middle) {
                Ok(more) => (to, fit) = (middle, more),
                Err(_) => failed = middle,
            }
        }
        (to, fit)
    }

    /// The piece between two parameters, or its bound where that is too far.
    pub(super) fn attempt(&mut self, chain: &Chain<'_>, from: f64, to: f64) -> Result<Fitted, f64> {
        let parts = chain.between(from, to);
        let mut least = f64::INFINITY;
        for points in [POINTS, MANY_POINTS] {
            let nearest = self.nearest(chain, (from, to), points);
            let mut fit = Fitted {
                parts: parts.clone(),
                form: if nearest.off_line > NEARER * nearest.off {
                    Replacement::Circular(nearest.half)
                } else {
                    Replacement::Line
                },
                ends_given: to.fract() == 0.0,
            };
            let bound = fit.bound();
            if bound <= self.room {
                return Ok(fit);
            }
            least = least.min(bound);
            if nearest.off_line <= self.room {
                fit.form = Replacement::Line;
                if fit.bound() <= self.room {
                    return Ok(fit);
                }
            }
            // More points move an arc by little.
            if bound > MOVED_BY_POINTS * self.room {
                break;
            }
        }
        Err(least)
    }

    /// The nearest arc between two parameters of a chain.
    fn nearest(&mut self, chain: &Chain<'_>, (from, to): (f64, f64), count: usize) -> Nearest {
        let (start, chord) = (chain.point(from), chain.point(to) - chain.point(from));
        let length = chord.hypot2().sqrt();
        let along = chord / length;
        self.points.clear();
        let (mut beyond, points) = (0.0_f64, &mut self.points);
        chain.visit((from, to), count, |p| {
            let v = p - start;
            let (x, y) = (along.dot(v), along.cross(v));
            beyond = beyond.max(-x).max(x - length);
            points.push(Vec2::new(x - v.hypot2() / length, y));
        });
        let off_line = farthest_off(points, Vec2::new(1.0, 0.0)).largest();
        let mut direction: Vec2 = points.iter().fold(Vec2::ZERO, |sum, w| sum + *w);
        let mut best = (f64::INFINITY, Vec2::new(1.0, 0.0));
        for _ in 0..EXCHANGES {
            let unit = direction / direction.hypot2().sqrt();
            let sides = farthest_off(points, unit);
            if sides.largest() < best.0 {
                best = (sides.largest(), unit);
            }
            if (sides.left.0 + sides.right.0).abs() <= 1e-3 * sides.largest() {
                break;
            }
            direction = sides.left.1 + sides.right.1;
        }
        let (off, unit) = best;
        let half = angle_of(unit);
        // Of less than half a circle no point lies beyond the ends.
        let beyond = if unit.x > 0.0 { beyond } else { 0.0 };
        let is_arc = half.abs() <= LARGEST_HALF && off.is_finite();
        let off_line = if length > 0.0 {
            off_line.max(beyond)
        } else {
            f64::INFINITY
        };
        Nearest {
            half,
            off: if is_arc {
                off.max(beyond).min(off_line)
            } else {
                off_line
            },
            off_line,
        }
    }
}

/// The points farthest to the left and to the right of a line through the origin, and how far they are, to the left positive.
#[derive(Debug, Clone, Copy)]
struct Sides {
    left: (f64, Vec2),
    right: (f64, Vec2),
}

impl Sides {
    fn largest(&self) -> f64 {
        self.left.0.max(-self.right.0)
    }
}

fn farthest_off(points: &[Vec2], unit: Vec2) -> Sides {
    let off = |i: usize| points.get(i).map_or(0.0, |w| unit.cross(*w));
    let (mut left, mut right) = (0, 0);
    for i in 0..points.len() {
        if off(i) > off(left) {
            left = i;
        }
        if off(i) < off(right) {
            right = i;
        }
    }
    // The top of the parabola through the farthest and its neighbours.
    let top = |i: usize| {
        let before = if i == 0 { 0.0 } else { off(i - 1) };
        let (here, after) = (off(i), off(i + 1));
        let bend = 2.0 * here - before - after;
        let more = (after - before) * (after - before) / (8.0 * bend);
        if more.abs() <= 0.5 * here.abs() {
            here + more
        } else {
            here
        }
    };
    let point = |i: usize| points.get(i).copied().unwrap_or_default();
    Sides {
        left: (top(left).max(0.0), point(left)),
        right: (top(right).min(0.0), point(right)),
    }
}
