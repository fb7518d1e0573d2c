//! A bound, both ways, of the distance between consecutive cubics and a circular arc or a chord.
//!
//! The angle of the cubics about the arc's centre runs without a jump from that of their first point to that of their last. So every
//! direction of the arc meets the cubics, at a distance of no more than their radial error, and no point of the cubics that lies within
//! the arc's sweep is farther from it than that. Where the angle grows with the parameter no point lies beyond; where it may not, the
//! angles of the control points bound how far one does. Beyond the ends there is no more than what the ends are apart.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use super::near::to_unit;
use crate::measure::radial;
use crate::numeric::bernstein::halves;
use crate::shape::{Arc, Given, Truth};

/// The part of the least radius of curvature of an ellipse within which its normals do not meet.
const NORMALS: f64 = 0.5;

/// The bound; infinite where the cubics do not run about the arc's centre.
///
/// On an ellipse the angles are those in the plane where it is the unit circle, and the distance is that along its normals: cubics that run
/// from one end to the other so near to it that these do not meet cross each of them.
pub(super) fn from_arc(parts: &[CubicBez], arc: &Arc) -> f64 {
    let rough = roughly_from_arc(parts, arc);
    let (Some(ends), false) = (arc.ends, is_circle(arc)) else {
        return rough;
    };
    let Some(past) = past_ends_of_ellipse(parts, ends, arc) else {
        return rough;
    };
    let (larger, smaller) = (arc.radii.x.max(arc.radii.y), arc.radii.x.min(arc.radii.y));
    let peak = farthest(parts, arc.truth(), ends, arc);
    if peak <= NORMALS * smaller * (smaller / larger) {
        rough.min(peak + past)
    } else {
        rough
    }
}

/// The same in less time: on an ellipse the distance where it is the unit circle, times the larger radius, which is the most that the map
/// from there stretches anything.
pub(crate) fn roughly_from_arc(parts: &[CubicBez], arc: &Arc) -> f64 {
    let Some(ends) = arc.ends else {
        return f64::INFINITY;
    };
    let bound = |parts: &[CubicBez], ends: [Point; 2], arc: &Arc| {
        let past = past_ends(parts, ends, arc).filter(|past| past.is_finite())?;
        let circle = Truth::circle(arc.center, arc.radii.x);
        Some(past + farthest(parts, circle, ends, arc))
    };
    let bound = if is_circle(arc) {
        bound(parts, ends, arc)
    } else {
        let (mapped, ends, unit) = all_mapped(parts, ends, arc);
        let larger = arc.radii.x.max(arc.radii.y);
        bound(&mapped, ends, &unit).map(|bound| larger * bound + margin(parts, arc))
    };
    bound
        .filter(|bound| bound.is_finite())
        .unwrap_or(f64::INFINITY)
}

/// Whether that is within a limit, which mostly a look at the sizes of a few coefficients says.
pub(super) fn is_within(parts: &[CubicBez], arc: &Arc, limit: f64) -> bool {
    is_surely_within(parts, arc, limit) || roughly_from_arc(parts, arc) <= limit
}

/// Whether that look says so.
pub(super) fn is_surely_within(parts: &[CubicBez], arc: &Arc, limit: f64) -> bool {
    let Some(ends) = arc.ends else {
        return false;
    };
    if is_circle(arc) {
        return runs_within(parts, ends, arc, limit);
    }
    let limit = (limit - margin(parts, arc)) / arc.radii.x.max(arc.radii.y);
    if let [cubic] = parts {
        let (cubic, ends, unit) = mapped(*cubic, ends, arc);
        return runs_within(&[cubic], ends, &unit, limit);
    }
    let (parts, ends, unit) = all_mapped(parts, ends, arc);
    runs_within(&parts, ends, &unit, limit)
}

/// Cubics between the ends of the arc of a circle, about its centre all the way: the Bernstein coefficients of |q - c|² - r² over four
/// parts of each bound how far it strays.
fn runs_within(parts: &[CubicBez], ends: [Point; 2], arc: &Arc, limit: f64) -> bool {
    /// What rounding may do, as a part of the radius.
    const NOISE: f64 = 1e-13;
    let (center, radius) = (arc.center, arc.radii.x);
    let runs = match parts {
        [] => false,
        [cubic] => {
            ends == [cubic.p0, cubic.p3] && runs_about(cubic, center, arc.sweep.degrees().signum())
        }
        [first, .., last] => {
            ends == [first.p0, last.p3]
                && overshoot(parts, center, arc.sweep.radians()) == Some(0.0)
        }
    };
    let largest = |cubic: &CubicBez| {
        let quarters = halves(excess(cubic, center, radius)).map(halves);
        let all = quarters.iter().flatten().flatten();
        all.fold(0.0_f64, |most, c| most.max(c.abs()))
    };
    runs && parts.iter().all(|cubic| {
        let largest = largest(cubic);
        // From inside, r - sqrt(r² - e) = e / (r + sqrt(r² - e)).
        let inner = (radius * radius - largest).max(0.0).sqrt();
        largest / (radius + inner) + NOISE * radius < limit
    })
}

/// The Bernstein coefficients of |q - c|² - r² over a cubic.
fn excess(cubic: &CubicBez, center: Point, radius: f64) -> [f64; 7] {
    let p = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(|p| p - center);
    let square = radius * radius;
    [
        p[0].hypot2() - square,
        p[0].dot(p[1]) - square,
        (2.0 * p[0].dot(p[2]) + 3.0 * p[1].hypot2()) / 5.0 - square,
        (p[0].dot(p[3]) + 9.0 * p[1].dot(p[2])) / 10.0 - square,
        (2.0 * p[1].dot(p[3]) + 3.0 * p[2].hypot2()) / 5.0 - square,
        p[2].dot(p[3]) - square,
        p[3].hypot2() - square,
    ]
}

fn is_circle(arc: &Arc) -> bool {
    arc.radii.x == arc.radii.y
}

/// How far cubics lie from the shape that an arc is a part of.
fn farthest(parts: &[CubicBez], truth: Truth, ends: [Point; 2], arc: &Arc) -> f64 {
    let truth = match arc.given {
        Given::Sweep => truth,
        // What was given of the arc says more than its centre where this is far away.
        given => truth.through(ends, arc.sweep, given),
    };
    let segments: Vec<PathSeg> = parts.iter().map(|&part| PathSeg::Cubic(part)).collect();
    radial::error(&segments, &truth).peak()
}

/// A cubic, the ends of an arc, and the arc where its ellipse is the unit circle, about its start: nothing of that grows with the radii.
fn mapped(part: CubicBez, ends: [Point; 2], arc: &Arc) -> (CubicBez, [Point; 2], Arc) {
    let [a, b, c, d, ..] = to_unit(arc).as_coeffs();
    let linear = Affine::new([a, b, c, d, 0.0, 0.0]);
    let map = |p: Point| linear * (p - ends[0]).to_point();
    let [p0, p1, p2, p3] = [part.p0, part.p1, part.p2, part.p3].map(map);
    let one = Vec2::new(1.0, 1.0);
    let unit = Arc {
        center: map(arc.center),
        radii: one,
        given: match arc.given {
            Given::Enlarged(_) => Given::Enlarged(one),
            given => given,
        },
        ..*arc
    };
    (CubicBez { p0, p1, p2, p3 }, ends.map(map), unit)
}

/// The same of several cubics.
fn all_mapped(parts: &[CubicBez], ends: [Point; 2], arc: &Arc) -> (Vec<CubicBez>, [Point; 2], Arc) {
    let mapped = |part: &CubicBez| mapped(*part, ends, arc);
    let first = parts
        .first()
        .copied()
        .unwrap_or(CubicBez::new(ends[0], ends[0], ends[1], ends[1]));
    let (_, unit_ends, unit) = mapped(&first);
    let parts = parts.iter().map(|part| mapped(part).0).collect();
    (parts, unit_ends, unit)
}

/// What the roundings of that map may have done to a distance.
fn margin(parts: &[CubicBez], arc: &Arc) -> f64 {
    const MAPPED: f64 = 64.0 * f64::EPSILON;
    let start = arc.ends.map_or(arc.center, |[from, _]| from);
    let points = parts
        .iter()
        .flat_map(|part| [part.p0, part.p1, part.p2, part.p3]);
    let far = points
        .map(|p| p.distance_squared(start))
        .fold(0.0, f64::max);
    let (x, y) = (arc.radii.x, arc.radii.y);
    MAPPED * (x / y).max(y / x) * far.sqrt()
}

/// How far cubics may run past the ends of an arc of a circle, and these past theirs, along it.
fn past_ends(parts: &[CubicBez], [from, to]: [Point; 2], arc: &Arc) -> Option<f64> {
    let (center, radius) = (arc.center, arc.radii.x);
    let (first, last) = (parts.first()?, parts.last()?);
    // From the nearest point of the circle to an end that lies on it.
    let off = |p: Point, end: Point| {
        let (v, out) = (p - end, p - center);
        let distance = out.hypot2().sqrt();
        let height = v.dot((end - center) + out) / (distance + radius);
        (v - out * (height / distance)).hypot2().sqrt()
    };
    let apart = off(first.p0, from).max(off(last.p3, to));
    Some(apart + radius * overshoot(parts, center, arc.sweep.radians())?)
}

/// The same on an ellipse, to which the normals of both ends do not meet: the nearest point of it moves by no more than r/(r - d) times as far as
/// one does that is r - d from where they do.
fn past_ends_of_ellipse(parts: &[CubicBez], ends: [Point; 2], arc: &Arc) -> Option<f64> {
    let (larger, smaller) = (arc.radii.x.max(arc.radii.y), arc.radii.x.min(arc.radii.y));
    let (bend, [from, to]) = (smaller * (smaller / larger), ends);
    let shift = from
        .distance(parts.first()?.p0)
        .max(to.distance(parts.last()?.p3));
    let (mapped, _, unit) = all_mapped(parts, ends, arc);
    let over = larger * overshoot(&mapped, unit.center, arc.sweep.radians())?;
    (shift <= NORMALS * bend).then(|| shift * bend / (bend - shift) + over)
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
