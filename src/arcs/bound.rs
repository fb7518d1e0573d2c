//! A bound, both ways, of the distance between consecutive cubics and a circular arc or a chord.
//!
//! The angle of the cubics about the arc's centre runs without a jump from that of their first point to that of their last. So every
//! direction of the arc meets the cubics, at a distance of no more than their radial error, and no point of the cubics that lies within
//! the arc's sweep is farther from it than that. Where the angle grows with the parameter no point lies beyond; where it may not, the
//! angles of the control points bound how far one does. Beyond the ends there is no more than what the ends are apart.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use super::near::to_unit;
use super::piece::{away, cubic_from_chord, height_and_overshoot, longer};
use crate::Angle;
use crate::measure::radial;
use crate::shape::{Arc, Given, Truth};

/// How far the map to where an ellipse is the unit circle may move a point, as a part of its distance from the arc's start: the map's
/// and the point's roundings, and what they do to the centre of a long arc.
const MAPPED: f64 = 64.0 * f64::EPSILON;

/// The bound; infinite where the cubics do not run about the arc's centre. On an ellipse it is that in the plane where this is the unit
/// circle, times the larger radius, which is the most that the map from there stretches anything.
pub(crate) fn from_arc(parts: &[CubicBez], arc: &Arc) -> f64 {
    let Some([from, to]) = arc.ends else {
        return f64::INFINITY;
    };
    let (larger, smaller) = (arc.radii.x.max(arc.radii.y), arc.radii.x.min(arc.radii.y));
    if larger == smaller {
        return from_circle(parts, [from, to], arc);
    }
    // About the arc's start: nothing of that grows with the radii.
    let [a, b, c, d, ..] = to_unit(arc).as_coeffs();
    let linear = Affine::new([a, b, c, d, 0.0, 0.0]);
    let map = |p: Point| linear * (p - from).to_point();
    let unit = Arc {
        center: map(arc.center),
        radii: Vec2::new(1.0, 1.0),
        rotation: Angle::ZERO,
        given: match arc.given {
            Given::Enlarged(_) => Given::Enlarged(Vec2::new(1.0, 1.0)),
            given => given,
        },
        ..*arc
    };
    let points = |part: &CubicBez| [part.p0, part.p1, part.p2, part.p3];
    let far = parts
        .iter()
        .flat_map(points)
        .map(|p| p.distance_squared(from));
    let far = far.fold(0.0, f64::max).sqrt();
    let mapped = parts.iter().map(|part| {
        let [p0, p1, p2, p3] = points(part).map(map);
        CubicBez { p0, p1, p2, p3 }
    });
    let mapped: Vec<CubicBez> = mapped.collect();
    larger * (from_circle(&mapped, [from, to].map(map), &unit) + MAPPED / smaller * far)
}

fn from_circle(parts: &[CubicBez], ends: [Point; 2], arc: &Arc) -> f64 {
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
        return f64::INFINITY;
    };
    let (center, radius) = (arc.center, arc.radii.x);
    let Some(over) = overshoot(parts, center, arc.sweep.radians()) else {
        return f64::INFINITY;
    };
    // From the nearest point of the circle to an end that lies on it.
    let off = |p: Point, end: Point| {
        let (v, out) = (p - end, p - center);
        let distance = out.hypot2().sqrt();
        let height = v.dot((end - center) + out) / (distance + radius);
        (v - out * (height / distance)).hypot2().sqrt()
    };
    let [from, to] = ends;
    let apart = off(first.p0, from).max(off(last.p3, to));
    // What was given of the arc says more than its centre where this is far away.
    let truth = Truth::circle(center, radius);
    let truth = match arc.given {
        Given::Sweep => truth,
        given => truth.through(ends, arc.sweep, given),
    };
    let segments = parts.iter().map(|&part| PathSeg::Cubic(part));
    let segments: Vec<PathSeg> = segments.collect();
    let bound = radial::error(&segments, &truth).peak() + apart + radius * over;
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
        let angle_of = |p: Point| sign * libm::atan2(from.cross(p - part.p0), from.dot(p - center));
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
/// other sign by more than rounding.
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
    coefficients.into_iter().all(|c| c >= -1e-13 * largest)
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
    let (mut highest, mut farthest, mut longest) = (0.0_f64, 0.0_f64, chord);
    for part in parts {
        let points = [part.p0, part.p1, part.p2, part.p3].map(|p| p - first.p0);
        longest = points.into_iter().fold(longest, longer);
        let (height, over) = height_and_overshoot(points, along, length);
        highest = highest.max(height);
        farthest = farthest.max(over);
    }
    away(highest, farthest, longest)
}
