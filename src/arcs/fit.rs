//! Circular arcs and lines in place of runs of cubics, and how far they lie from them.
//!
//! A biarc is two arcs that meet the ends p0, p1 of a piece and its unit tangents u0, u1 there, and each other with one tangent.
//! With equal tangent lengths d its polygon is p0, p0 + d u0, p1 - d u1, p1, the joint the middle of the inner two, and
//! |p1 - p0 - d (u0 + u1)| = 2d.

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, Vec2};

use super::piece::cubic_from_chord;
use crate::curve::{first_direction, turn};
use crate::measure::radial;
use crate::shape::endpoint::{from_bulge, through};
use crate::shape::{Arc, Shape, Truth};

/// The largest turn at a joint that rounding explains, in degrees: anything beyond is a corner, which stays.
pub(super) const LARGEST_TURN: f64 = 8.0;

/// What the error of a cubic may have done to a radius: that of the standard handle, of quarters.
const HANDLE_PART: f64 = 3e-4;

/// A run that no chord is to replace lies at least this part of the tolerance from it.
const STRAIGHT_PART: f64 = 0.05;

/// The largest turn at a joint over which a biarc may run, in degrees.
const SMOOTH_TURN: f64 = 1.0;

/// How many cubics a biarc takes at most, so that the time stays linear.
const FARTHEST: usize = 8;

/// How often the bracket of a biarc's end is halved.
const HALVINGS: u32 = 18;

/// How often that of the place of a biarc's joint is: to the last bits.
const JOINT_HALVINGS: u32 = 52;

/// A line or an arc, and the cubics that it replaces.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    pub(super) parts: Vec<CubicBez>,
    pub(super) to: Point,
    /// The arc; without one it is a line.
    pub(super) arc: Option<Arc>,
    /// Whether it ends where a cubic does.
    pub(super) ends_given: bool,
}

/// What the fit is to keep to.
pub(super) struct Rules {
    pub(super) room: f64,
    /// The decimals of the file, and how far rounding to them moves a point.
    pub(super) decimals: u8,
    pub(super) moved: f64,
}

/// A bound, both ways, of the distance between consecutive cubics and an arc; infinite where the cubics do not run about its centre
/// as it does.
///
/// While the angle about the centre grows with the parameter, every direction of the arc meets the cubics, at a distance of no more
/// than their radial error. Beyond the ends there is no more than what the ends are apart along the circle.
pub(super) fn distance(parts: &[CubicBez], from: Point, to: Point, arc: &Arc) -> f64 {
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
        return f64::INFINITY;
    };
    let (center, radius) = (arc.center, arc.radii.x);
    let sign = arc.sweep.degrees().signum();
    let mut swept = 0.0;
    for part in parts {
        if !runs_about(part, center, sign) {
            return f64::INFINITY;
        }
        let (u, v) = (part.p0 - center, part.p3 - center);
        let angle = sign * libm::atan2(u.cross(v), u.dot(v));
        swept += if angle < -1e-9 {
            angle + core::f64::consts::TAU
        } else {
            angle
        };
    }
    if (swept - arc.sweep.radians().abs()).abs() > 0.5 {
        return f64::INFINITY;
    }
    let off = |p: Point, end: Point| {
        let out = p - center;
        (center + out * (radius / out.hypot2().sqrt())).distance(end)
    };
    let ends = off(first.p0, from).max(off(last.p3, to));
    let segments: Vec<PathSeg> = parts.iter().map(|&part| PathSeg::Cubic(part)).collect();
    let bound = radial::error(&segments, &Truth::circle(center, radius)).peak() + ends;
    if bound.is_finite() {
        bound
    } else {
        f64::INFINITY
    }
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

/// How many of the cubics, from the first, are together one arc, and that arc; of whole turns half of it is left to the next.
pub(super) fn run(cubics: &[CubicBez], rules: &Rules) -> Option<(usize, Fit)> {
    let fits = |count: usize| recognised(&cubics[..count], rules);
    let mut best = (1, fits(1)?);
    let smooth = cubics.windows(2).take_while(|pair| {
        turn(&PathSeg::Cubic(pair[0]), &PathSeg::Cubic(pair[1])).abs() <= LARGEST_TURN
    });
    let most = 1 + smooth.count();
    // Doubling, then halving: the longest run takes as many looks as its length has bits.
    let (mut step, mut growing) = (1, true);
    while step > 0 {
        let count = best.0 + step;
        let found = if count <= most { fits(count) } else { None };
        if let Some(fit) = found {
            best = (count, fit);
            step = if growing { 2 * step } else { step / 2 };
        } else {
            growing = false;
            step /= 2;
        }
    }
    Some(best)
}

/// The first point of a run, the one in its middle and its last.
pub(super) fn ends_and_middle(cubics: &[CubicBez]) -> Option<[Point; 3]> {
    let middle = cubics.get(cubics.len() / 2)?;
    let on = if cubics.len().is_multiple_of(2) {
        middle.p0
    } else {
        middle.eval(0.5)
    };
    Some([cubics.first()?.p0, on, cubics.last()?.p3])
}

/// Whether two cubics join without a corner.
pub(super) fn joins_smoothly(pair: &[CubicBez]) -> bool {
    let [a, b] = [pair[0], pair[1]].map(PathSeg::Cubic);
    turn(&a, &b).abs() <= LARGEST_TURN
}

/// The one arc that some cubics are, with a round radius where their rounding explains one.
fn recognised(cubics: &[CubicBez], rules: &Rules) -> Option<Fit> {
    let [from, on, to] = ends_and_middle(cubics)?;
    if from == to {
        return None;
    }
    let Ok(Shape::Arc(found)) = through(from, on, to) else {
        return None;
    };
    let radius = found.radii.x;
    let explained = HANDLE_PART * radius + 2.0 * rules.moved;
    let round = (0..=rules.decimals).find_map(|decimals| {
        let rounded = crate::number::round(radius, decimals);
        let arc = with_radius(from, to, &found, rounded)?;
        let fits =
            (rounded - radius).abs() <= explained && distance(cubics, from, to, &arc) <= rules.room;
        fits.then_some(arc)
    });
    let arc = round.unwrap_or(found);
    let fits = distance(cubics, from, to, &arc) <= rules.room;
    fits.then(|| Fit {
        parts: cubics.to_vec(),
        to,
        arc: Some(arc),
        ends_given: true,
    })
}

/// The arc between these points that lies as that one does, with this radius.
pub(super) fn with_radius(from: Point, to: Point, like: &Arc, radius: f64) -> Option<Arc> {
    let arc = crate::shape::endpoint::SvgArc {
        from,
        radii: Vec2::new(radius, radius),
        rotation: crate::Angle::ZERO,
        large_arc: like.sweep.degrees().abs() > 180.0,
        sweep: like.sweep.degrees() > 0.0,
        to,
    };
    match arc.shape() {
        Ok(Shape::Arc(arc)) => Some(arc),
        _ => None,
    }
}

/// Smooth cubics as biarcs and lines, each as far as it may reach.
pub(super) fn approximated(chain: &[CubicBez], rules: &Rules, most: usize) -> Vec<Fit> {
    let mut fits = Vec::new();
    let mut from = 0.0;
    while from < chain.len() as f64 && fits.len() <= most {
        let (to, found) = farthest(chain, from, rules);
        fits.extend(found);
        from = to;
    }
    if let Some(last) = fits.last_mut() {
        last.ends_given = true;
    }
    fits
}

/// The cubics between two parameters, of which each cubic takes one.
fn between(chain: &[CubicBez], from: f64, to: f64) -> Vec<CubicBez> {
    let first = from.floor() as usize;
    let part = |(i, cubic): (usize, &CubicBez)| {
        let start = i as f64;
        let (a, b) = ((from - start).max(0.0), (to - start).min(1.0));
        (b > a).then(|| match (a, b) {
            (0.0, 1.0) => *cubic,
            (_, 1.0) => CubicBez {
                p3: cubic.p3,
                ..cubic.subsegment(a..b)
            },
            _ => cubic.subsegment(a..b),
        })
    };
    let parts = chain.iter().enumerate().skip(first).take(FARTHEST + 1);
    parts.filter_map(part).collect()
}

fn farthest(chain: &[CubicBez], from: f64, rules: &Rules) -> (f64, Vec<Fit>) {
    let at = |to: f64| {
        let parts = between(chain, from, to);
        line(&parts, rules.room).or_else(|| biarc(&parts, rules.room))
    };
    let end = (from.floor() + FARTHEST as f64).min(chain.len() as f64);
    if let Some(found) = at(end) {
        return (end, found);
    }
    let (mut near, mut far, mut best) = (from, end, None);
    for round in 0..2 * HALVINGS {
        let middle = 0.5 * (near + far);
        if let Some(found) = at(middle) {
            (near, best) = (middle, Some(found));
        } else {
            far = middle;
        }
        if round >= HALVINGS && best.is_some() {
            break;
        }
    }
    // Where not even the shortest fits, floats end: what is left is next to nothing.
    best.map_or_else(
        || (far, between(chain, from, far).iter().map(chord).collect()),
        |found| (near, found),
    )
}

/// How many of the cubics, from the first, run on smoothly without being arcs by themselves: at least one.
pub(super) fn free(cubics: &[CubicBez], rules: &Rules) -> usize {
    let smooth = |pair: &&[CubicBez]| {
        let [a, b] = [pair[0], pair[1]].map(PathSeg::Cubic);
        turn(&a, &b).abs() <= SMOOTH_TURN && recognised(&pair[1..], rules).is_none()
    };
    1 + cubics.windows(2).take_while(smooth).count()
}

fn chord(part: &CubicBez) -> Fit {
    Fit {
        parts: vec![*part],
        to: part.p3,
        arc: None,
        ends_given: false,
    }
}

fn line(parts: &[CubicBez], room: f64) -> Option<Vec<Fit>> {
    match parts {
        [part] => (cubic_from_chord(part) <= room).then(|| vec![chord(part)]),
        _ => None,
    }
}

/// Whether a chord is as good as the cubic itself.
pub(super) fn is_straight(cubic: &CubicBez, room: f64) -> Option<Fit> {
    (cubic_from_chord(cubic) <= STRAIGHT_PART * room).then(|| Fit {
        ends_given: true,
        ..chord(cubic)
    })
}

fn biarc(parts: &[CubicBez], room: f64) -> Option<Vec<Fit>> {
    let unit = |v: Vec2| v / v.hypot2().sqrt();
    let (first, last) = (parts.first()?, parts.last()?);
    let start = unit(first_direction(&PathSeg::Cubic(*first)));
    let end = -unit(first_direction(&PathSeg::Cubic(*last).reverse()));
    let span = last.p3 - first.p0;
    let (along, square) = (span.dot(start + end), span.hypot2());
    let root = (along * along + 2.0 * (1.0 - start.dot(end)) * square).sqrt();
    let length = square / (along + root);
    if !(length.is_finite() && length > 0.0) {
        return None;
    }
    let (a, b) = (first.p0 + length * start, last.p3 - length * end);
    let (joint, tangent) = (a.midpoint(b), b - a);
    let (left, right) = split(parts, joint, tangent)?;
    Some(vec![
        tangent_arc(left, first.p0, joint, start, room)?,
        tangent_arc(right, joint, last.p3, unit(tangent), room)?,
    ])
}

/// The cubics before and after the line of the joint's centres.
fn split(
    parts: &[CubicBez],
    joint: Point,
    tangent: Vec2,
) -> Option<(Vec<CubicBez>, Vec<CubicBez>)> {
    let before = |p: Point| (p - joint).dot(tangent) < 0.0;
    let crossed = parts.iter().position(|part| !before(part.p3))?;
    let part = &parts[crossed];
    let (mut near, mut far) = (0.0, 1.0);
    for _ in 0..JOINT_HALVINGS {
        let middle = 0.5 * (near + far);
        if before(part.eval(middle)) {
            near = middle;
        } else {
            far = middle;
        }
    }
    let at = 0.5 * (near + far);
    let left = [&parts[..crossed], &[part.subsegment(0.0..at)]].concat();
    let right = [&[part.subsegment(at..1.0)], &parts[crossed + 1..]].concat();
    Some((left, right))
}

/// The arc between two points with this tangent at the first.
fn tangent_arc(
    parts: Vec<CubicBez>,
    from: Point,
    to: Point,
    tangent: Vec2,
    room: f64,
) -> Option<Fit> {
    let chord = to - from;
    let half = libm::atan2(tangent.cross(chord), tangent.dot(chord));
    let shape = from_bulge(from, to, libm::tan(half / 2.0)).ok()?;
    let (arc, distance) = match shape {
        Shape::Arc(arc) => (Some(arc), distance(&parts, from, to, &arc)),
        Shape::Line(_) => match parts[..] {
            [part] => {
                let off = part.p0.distance(from).max(part.p3.distance(to));
                (None, cubic_from_chord(&part) + off)
            }
            _ => return None,
        },
        _ => return None,
    };
    (distance <= room).then_some(Fit {
        parts,
        to,
        arc,
        ends_given: false,
    })
}
