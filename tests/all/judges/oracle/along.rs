//! The extremes of a distance from a smooth line along a Bézier segment, by the normals of the line.

use super::bezier::Powers;
use super::real::{Point, Real, abs, cross, dot, int, norm, ratio, real, sign};
use super::solve::root;

/// Pieces into which the segment is cut at first to look for the extremes.
const PIECES: i64 = 64;

/// The largest sine of the turn of the normal over one piece; more, and it is halved. At a tip of the line the distance varies with the
/// normal, far faster than with the parameter.
const TURN: f64 = 0.04;

/// A segment and a line: the signed distance of a point from it, and the normal at the nearest point of the line towards the positive side,
/// of any length.
pub struct Search<'a> {
    curve: &'a Powers,
    velocity: Powers,
    nearest: &'a dyn Fn(&Point) -> (Real, Point),
}

/// What there is at one place of the segment.
struct Sample {
    t: Real,
    distance: Real,
    normal: Point,
    /// The derivative of the distance by t, times a positive number.
    slope: Real,
}

impl<'a> Search<'a> {
    pub fn new(curve: &'a Powers, nearest: &'a dyn Fn(&Point) -> (Real, Point)) -> Self {
        Self {
            velocity: curve.derivative(),
            curve,
            nearest,
        }
    }

    /// The distances where they are stationary and between, cut at these places too.
    ///
    /// The signed distance is stationary where the velocity is square to the normal at the nearest point. The segment is cut finely enough
    /// that neither moves far over a piece, and each change of sign of their product is followed to 57 digits.
    pub fn distances(&self, mut places: Vec<Real>) -> Vec<Real> {
        places.extend((1..=PIECES).map(|i| {
            // Narrower towards the ends, where a curve that touches the line has its smallest lobes: 10 s^3 - 15 s^4 + 6 s^5.
            let s = ratio(i, PIECES);
            &s * &s * &s * (int(10) - int(15) * &s + int(6) * &s * &s)
        }));
        places.sort_by(|a, b| a.partial_cmp(b).unwrap());
        let mut distances = Vec::new();
        let mut start = self.sample(int(0));
        for t in places {
            let end = self.sample(t);
            self.piece(&start, &end, 24, &mut distances);
            start = end;
        }
        distances.push(start.distance);
        distances
    }

    fn sample(&self, t: Real) -> Sample {
        let (distance, normal) = (self.nearest)(&self.curve.at(&t));
        Sample {
            distance,
            slope: dot(&normal, &self.velocity.at(&t)),
            normal,
            t,
        }
    }

    /// Notes the distance at the start of a piece and where it is stationary within.
    fn piece(&self, start: &Sample, end: &Sample, depth: usize, distances: &mut Vec<Real>) {
        let turn = abs(&cross(&start.normal, &end.normal));
        let unit = norm(&start.normal) * norm(&end.normal);
        if depth > 0 && (turn > &unit * real(TURN) || sign(&dot(&start.normal, &end.normal)) < 0) {
            let middle = self.sample((&start.t + &end.t) * ratio(1, 2));
            self.piece(start, &middle, depth - 1, distances);
            self.piece(&middle, end, depth - 1, distances);
            return;
        }
        distances.push(start.distance.clone());
        if sign(&start.slope) * sign(&end.slope) < 0 {
            let t = root(|t| self.sample(t.clone()).slope, &start.t, &end.t);
            distances.push(self.sample(t).distance);
        }
    }
}
