//! A bound, both ways, of the distance between consecutive cubics and a circular arc or a chord.
//!
//! The angle of the cubics about the arc's centre runs without a jump from that of their first point to that of their last. So every
//! direction of the arc meets the cubics, at a distance of no more than their radial error, and no point of the cubics that lies within
//! the arc's sweep is farther from it than that. Where the angle grows with the parameter no point lies beyond; where it may not, the
//! angles of the control points bound how far one does. Beyond the ends there is no more than what the ends are apart.

use kurbo::{CubicBez, PathSeg, Point, Vec2};

use super::piece::{cubic_from_chord, height_and_overshoot};
use crate::measure::radial;
use crate::shape::{Arc, Truth};

/// The bound; infinite where the cubics do not run about the arc's centre.
pub(super) fn distance(parts: &[CubicBez], from: Point, to: Point, arc: &Arc) -> f64 {
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
        return f64::INFINITY;
    };
    let (center, radius) = (arc.center, arc.radii.x);
    let Some(over) = overshoot(parts, center, arc.sweep.radians()) else {
        return f64::INFINITY;
    };
    let off = |p: Point, end: Point| {
        let out = p - center;
        (center + out * (radius / out.hypot2().sqrt())).distance(end)
    };
    let ends = off(first.p0, from).max(off(last.p3, to));
    let segments = parts.iter().map(|&part| PathSeg::Cubic(part));
    let segments: Vec<PathSeg> = segments.collect();
    let peak = radial::error(&segments, &Truth::circle(center, radius)).peak();
    let bound = peak + ends + radius * over;
    if bound.is_finite() {
        bound
    } else {
        f64::INFINITY
    }
}

/// By what angle, in radians, the cubics may run beyond the ends of a sweep about a centre; `None` where they turn over another one.
fn overshoot(parts: &[CubicBez], center: Point, sweep: f64) -> Option<f64> {
    let (sign, sweep) = (sweep.signum(), sweep.abs());
    let (mut swept, mut least, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
    for part in parts {
        let from = part.p0 - center;
        let angle_of = |p: Point| {
            let v = p - center;
            sign * libm::atan2(from.cross(v), from.dot(v))
        };
        let angle = angle_of(part.p3);
        if runs_about(part, center, sign) {
            swept += if angle < -1e-9 {
                angle + core::f64::consts::TAU
            } else {
                angle
            };
        } else {
            let inner = [part.p1, part.p2];
            // Within a quarter of a turn on either side the hull leaves the centre out.
            if inner
                .iter()
                .chain([&part.p3])
                .any(|&p| from.dot(p - center) <= 0.0)
            {
                return None;
            }
            for angle in inner.map(angle_of) {
                least = least.min(swept + angle);
                most = most.max(swept + angle);
            }
            swept += angle;
        }
        least = least.min(swept);
        most = most.max(swept);
    }
    ((swept - sweep).abs() <= 0.5).then(|| (most - swept).max(-least))
}

/// Whether the angle about the centre never falls (`sign` 1) or never grows (-1): no Bernstein coefficient of (q - c) x q' has the
/// other sign.
fn runs_about(cubic: &CubicBez, center: Point, sign: f64) -> bool {
    const WEIGHTS: [[f64; 3]; 4] = [
        [1.0, 2.0, 1.0],
        [3.0, 6.0, 3.0],
        [3.0, 6.0, 3.0],
        [1.0, 2.0, 1.0],
    ];
    let p = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(|p| p - center);
    let slopes = [p[1] - p[0], p[2] - p[1], p[3] - p[2]];
    let mut coefficients = [0.0; 6];
    for (i, p) in p.iter().enumerate() {
        for (j, slope) in slopes.iter().enumerate() {
            coefficients[i + j] += sign * WEIGHTS[i][j] * p.cross(*slope);
        }
    }
    let largest = coefficients.into_iter().fold(0.0, f64::max);
    coefficients.into_iter().all(|c| c >= -1e-9 * largest)
}

/// The same for the chord from the first point of consecutive cubics to their last, by the argument of
/// [`Piece::chord_distance`](super::piece::Piece::chord_distance).
pub(super) fn from_chord(parts: &[CubicBez]) -> f64 {
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
        return f64::INFINITY;
    };
    if parts.len() == 1 {
        return cubic_from_chord(first);
    }
    let chord = last.p3 - first.p0;
    let length = chord.hypot2().sqrt();
    if length == 0.0 {
        return f64::INFINITY;
    }
    let along: Vec2 = chord / length;
    let (mut highest, mut farthest) = (0.0_f64, 0.0_f64);
    for part in parts {
        let points = [part.p0, part.p1, part.p2, part.p3].map(|p| p - first.p0);
        let (height, over) = height_and_overshoot(points, along, length);
        highest = highest.max(height);
        farthest = farthest.max(over);
    }
    (highest * highest + farthest * farthest).sqrt()
}
