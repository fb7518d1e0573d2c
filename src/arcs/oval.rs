//! Arcs of ellipses between two places of a chain, with the tangents that it has there.
//!
//! Let the tangents at the ends p and r meet in q. In barycentric coordinates (a, b, c) of the triangle p q r the conics with these
//! tangents are
//!
//! F = b² - 4 v a c = 0,
//!
//! an ellipse where the square v of the weight is below 1. To first order a point lies F/|∇F| from one. Of all v the best is that to
//! which the farthest points on both sides are equally near; it is found by exchange, as F is linear in v.

use kurbo::{Point, Vec2};

use super::chain::Chain;
use super::diameters::Diameters;
use crate::Angle;
use crate::shape::endpoint::SvgArc;

/// How often points are exchanged.
const EXCHANGES: usize = 5;

/// How many points of a stretch are looked at, at least.
const POINTS: usize = 16;

/// The least and the largest v: beyond, a renderer's centre has too few digits.
const LEAST: f64 = 1e-3;
const MOST: f64 = 1.0 - 1e-4;

/// How far a point may lie outside of the triangle, as a part of its heights.
const OUTSIDE: f64 = 1e-9;

/// An arc of an ellipse by its directions at both ends and the square of its weight.
#[derive(Debug, Clone, Copy)]
pub(super) struct Oval {
    directions: [Vec2; 2],
    square: f64,
}

impl Oval {
    /// The arc between these ends.
    pub(super) fn arc(&self, from: Point, to: Point) -> Option<SvgArc> {
        let [out, on] = self.directions;
        let tip = Triangle::new((from, out), (to, on))?.tip;
        let ellipse = Diameters::new(from, tip, to, self.square).ellipse()?;
        Some(SvgArc {
            from,
            radii: ellipse.radii,
            rotation: Angle::of(ellipse.axis),
            large_arc: false,
            sweep: out.cross(on) > 0.0,
            to,
        })
    }
}

/// The triangle of two points and where their tangents meet, and its coordinates as linear functions of the plane.
struct Triangle {
    start: Point,
    tip: Point,
    slopes: [Vec2; 3],
}

impl Triangle {
    fn new((start, out): (Point, Vec2), (end, on): (Point, Vec2)) -> Option<Self> {
        let (chord, cross) = (end - start, out.cross(on));
        let [along, back] = [chord.cross(on) / cross, out.cross(chord) / cross];
        if !(along > 0.0 && back > 0.0 && along.is_finite() && back.is_finite()) {
            return None;
        }
        let tip = start + along * out;
        let side = tip - start;
        let area = side.cross(chord);
        let b = Vec2::new(chord.y, -chord.x) / area;
        let c = Vec2::new(-side.y, side.x) / area;
        Some(Self {
            start,
            tip,
            slopes: [-b - c, b, c],
        })
    }

    /// The coordinates of a point, unless it lies outside.
    fn inside(&self, p: Point) -> Option<[f64; 3]> {
        let v = p - self.start;
        let [b, c] = [self.slopes[1].dot(v), self.slopes[2].dot(v)];
        let all = [1.0 - b - c, b, c];
        all.iter().all(|x| *x >= -OUTSIDE).then_some(all)
    }

    /// The parts of F/|∇F| at a point that do not and that do grow with v.
    fn parts(&self, [a, b, c]: [f64; 3], v: f64) -> [f64; 2] {
        let [da, db, dc] = self.slopes;
        let slope = 2.0 * (b * db - 2.0 * v * (c * da + a * dc));
        let length = slope.hypot2().sqrt();
        [b * b / length, 4.0 * a * c / length]
    }
}

/// The nearest arc of an ellipse with the tangents of a chain at both ends, and how far points of the chain lie from it; `None` where
/// these leave the triangle of the tangents.
pub(super) fn nearest(chain: &Chain<'_>, from: f64, to: f64) -> Option<(Oval, f64)> {
    let (first, last) = (chain.leaving(from), chain.arriving(to));
    let triangle = Triangle::new(first, last)?;
    let (mut points, mut outside) = (Vec::with_capacity(2 * POINTS), false);
    chain.visit((from, to), POINTS, |p| match triangle.inside(p) {
        Some(all) => points.push(all),
        None => outside = true,
    });
    let middle = points
        .iter()
        .max_by(|x, y| (x[0] * x[2]).total_cmp(&(y[0] * y[2])))?;
    if outside {
        return None;
    }
    let [a, b, c] = *middle;
    let mut v = (b * b / (4.0 * a * c)).clamp(LEAST, MOST);
    let mut best = (f64::INFINITY, v);
    for _ in 0..EXCHANGES {
        let off = |[fixed, grown]: [f64; 2]| fixed - v * grown;
        let (mut high, mut low) = ([0.0; 2], [0.0; 2]);
        for all in &points {
            let parts = triangle.parts(*all, v);
            if off(parts) > off(high) {
                high = parts;
            }
            if off(parts) < off(low) {
                low = parts;
            }
        }
        let largest = off(high).max(-off(low));
        if largest < best.0 {
            best = (largest, v);
        }
        if (off(high) + off(low)).abs() <= 1e-3 * largest {
            break;
        }
        v = ((high[0] + low[0]) / (high[1] + low[1])).clamp(LEAST, MOST);
    }
    let (off, square) = best;
    let directions = [first.1, last.1];
    Some((Oval { directions, square }, off))
}
