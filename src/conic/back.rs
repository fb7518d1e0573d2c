//! A bound on how far any point of a conic's arc lies from a curve.
//!
//! A part of the arc with the end points p0 and p2, the control point p1 and the weight w is N/D with D = (1-s)² + 2w s(1-s) + s². Let A be a
//! cubic of the curve and g, of degree 3, the parameter that runs along it beside the arc, or stays at one of its points. Where |N - D A(g)|² - E² D², of degree 22, has no positive
//! Bernstein coefficient, no point of the part is farther from the curve than E. Halves of such a part are such parts, of the weight
//! √((1+w)/2).

use kurbo::{Point, Rect, Vec2};

use super::bound::{at, floor, piece};
use super::branch::{Branch, Cubic, arm};
use super::halving::{Bounds, Halving};
use crate::measure::hausdorff::{away, distance_slope, product};
use crate::number::as_decimal;
use crate::numeric::double::{Double, Twice};

/// How often a part is halved at most, and how many parts are, beside some for each segment.
const MOST_CUTS: u32 = 64;
const MOST_PARTS: usize = 16_000;

/// The most steps that settle a nearest point.
const MOST_SETTLING: usize = 4;

/// What the roundings of a coefficient leave of it, as a part of the sizes that it is the sum of.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A point of the curve: of which cubic, where and how far away.
#[derive(Clone, Copy)]
struct CurveFoot {
    cubic: usize,
    t: f64,
    distance: f64,
}

/// A part of the arc, and the points of the curve that are nearest to its ends.
#[derive(Clone, Copy)]
struct ArcPart {
    points: [Twice; 3],
    weight: Double,
    feet: [CurveFoot; 2],
}

/// Bounds how far the arc of a conic of this weight lies from segments, by no less than what is known; beyond a limit it may be any that is beyond.
pub(super) fn bound(
    branch: &Branch,
    weight: f64,
    segments: &[kurbo::PathSeg],
    known: f64,
    limit: Option<f64>,
) -> f64 {
    let cubics: Vec<Cubic> = segments.iter().map(|s| branch.cubic(s)).collect();
    let search = ArcSearch {
        cubics: &cubics,
        boxes: cubics.iter().map(box_of).collect(),
    };
    let least = branch.noise();
    let bounds = Bounds {
        least,
        floor: floor(segments) / branch.unit,
        limit: limit.map_or(f64::INFINITY, |limit| limit / branch.unit),
        most_cuts: MOST_CUTS,
        most_parts: MOST_PARTS,
    };
    let [from, to] = branch.arms;
    let whole = ArcPart {
        points: [from, [Double::of(0.0); 2], to],
        weight: as_decimal(weight),
        feet: [from, to].map(|q| search.nearest(&q, 0)),
    };
    let start = limit.unwrap_or(known) / branch.unit - least;
    let bound = bounds.bound(&search, [whole], cubics.len(), start.max(least));
    (bound + least) * branch.unit
}

struct ArcSearch<'a> {
    cubics: &'a [Cubic],
    boxes: Vec<Rect>,
}

impl Halving for ArcSearch<'_> {
    type Part = ArcPart;
    type Place = CurveFoot;

    fn halves(&self, part: &ArcPart) -> ([ArcPart; 2], [CurveFoot; 3]) {
        let [a, b, c] = part.points;
        let w = part.weight;
        let whole = w.plus(Double::of(1.0));
        let control = |p: Twice| [0, 1].map(|i| b[i].times(w).plus(p[i]).divided(whole));
        let (first, second) = (control(a), control(c));
        let middle = [0, 1].map(|i| first[i].plus(second[i]).scaled(0.5));
        let [from, to] = part.feet;
        let foot = self.nearest(&middle, from.cubic);
        let half = |points, feet| ArcPart {
            points,
            weight: whole.scaled(0.5).sqrt(),
            feet,
        };
        let halves = [
            half([a, first, middle], [from, foot]),
            half([middle, second, c], [foot, to]),
        ];
        (halves, [from, foot, to])
    }

    fn distance(&self, foot: &CurveFoot) -> f64 {
        foot.distance
    }

    /// Whether no point of a part is farther than that, by what runs beside it.
    fn is_within(&self, part: &ArcPart, &[from, middle, to]: &[CurveFoot; 3], most: f64) -> bool {
        let lets = |cubic: usize, ends: [f64; 2]| {
            let own = piece(&self.cubics[cubic], ends);
            is_beside(
                part,
                &own,
                [slope(part, &own, 0), slope(part, &own, 1)],
                most,
            )
        };
        if from.cubic == to.cubic {
            return lets(from.cubic, [from.t, to.t]) || lets(middle.cubic, [middle.t; 2]);
        }
        let forth = f64::from(from.cubic < to.cubic);
        lets(from.cubic, [from.t, forth])
            || lets(to.cubic, [1.0 - forth, to.t])
            || lets(middle.cubic, [middle.t; 2])
    }

    /// A bound by a single point of the curve.
    fn roughly(&self, part: &ArcPart, [_, middle, _]: &[CurveFoot; 3]) -> f64 {
        let near = at(&self.cubics[middle.cubic], middle.t);
        let far = part.points.iter().map(|p| arm(p, &near).hypot());
        far.fold(0.0, f64::max) * (1.0 + ROUNDING)
    }
}

impl ArcSearch<'_> {
    /// The nearest point of the curve, looked for on the cubic of this number first.
    fn nearest(&self, q: &Twice, first: usize) -> CurveFoot {
        let mut best = self.foot(first, q);
        let p = Point::new(q[0].value(), q[1].value());
        for cubic in 0..self.cubics.len() {
            if cubic != first && away(&self.boxes[cubic], p) < best.distance {
                let foot = self.foot(cubic, q);
                if foot.distance < best.distance {
                    best = foot;
                }
            }
        }
        self.settled(best, q)
    }

    /// The same after some steps of Newton's method in numbers of 106 bits, while they lead nearer: at a hairpin the digits of `f64` say little
    /// of it.
    fn settled(&self, mut foot: CurveFoot, q: &Twice) -> CurveFoot {
        let cubic = &self.cubics[foot.cubic];
        let steps: [Vec2; 3] = core::array::from_fn(|i| arm(&cubic[i + 1], &cubic[i]));
        for _ in 0..MOST_SETTLING {
            let (s, t) = (1.0 - foot.t, foot.t);
            let first = 3.0 * (s * s * steps[0] + 2.0 * s * t * steps[1] + t * t * steps[2]);
            let second = 6.0 * (s * (steps[1] - steps[0]) + t * (steps[2] - steps[1]));
            let way = arm(&at(cubic, t), q);
            let t = t - way.dot(first) / (first.hypot2() + way.dot(second));
            let distance = arm(&at(cubic, t), q).hypot();
            if !(0.0..=1.0).contains(&t) || distance >= foot.distance {
                break;
            }
            foot = CurveFoot {
                t,
                distance,
                ..foot
            };
        }
        foot
    }

    /// The nearest point of a cubic: an end, or where (A - q)·A' changes its sign.
    fn foot(&self, cubic: usize, q: &Twice) -> CurveFoot {
        let arms = self.cubics[cubic].map(|p| arm(&p, q));
        let inner = distance_slope(&arms).sign_changes();
        let at = |t: f64| CurveFoot {
            cubic,
            t,
            distance: arm(&at(&self.cubics[cubic], t), q).hypot(),
        };
        let nearer = |a: CurveFoot, b: CurveFoot| if b.distance < a.distance { b } else { a };
        inner.iter().map(at).fold(nearer(at(0.0), at(1.0)), nearer)
    }
}

/// A box of the control points.
fn box_of(cubic: &Cubic) -> Rect {
    let [a, b, c, d] = cubic.map(|[x, y]| Point::new(x.value(), y.value()));
    Rect::from_points(a, d).union_pt(b).union_pt(c)
}

/// How fast the nearest point of a cubic runs at an end of a part, A'·q' / (A'·A' - (q - A)·A''), a third of it.
fn slope(part: &ArcPart, cubic: &Cubic, end: usize) -> f64 {
    let (near, next, last) = [(0, 1, 2), (3, 2, 1)][end];
    let first = 3.0 * arm(&cubic[next], &cubic[near]);
    let second = 6.0 * (arm(&cubic[last], &cubic[next]) - arm(&cubic[next], &cubic[near]));
    let own = 2.0 * part.weight.value() * arm(&part.points[1], &part.points[2 * end]);
    let square = first.hypot2();
    let below = square - arm(&part.points[2 * end], &cubic[near]).dot(second);
    let slope = first.dot(own) / if below > 0.1 * square { below } else { square };
    if slope.is_finite() {
        (slope / 3.0).clamp(0.0, 1.0)
    } else {
        1.0 / 3.0
    }
}

/// Whether no point of a part is farther than that from the point of a cubic that runs beside it: at first and at last by these steps to the
/// next of four parameters.
fn is_beside(part: &ArcPart, cubic: &Cubic, [first, last]: [f64; 2], most: f64) -> bool {
    let weights = [1.0, 2.0 * part.weight.value(), 1.0];
    // Bernstein coefficients times their binomials: products are convolutions.
    let (g, h) = (
        [0.0, 3.0 * first, 3.0 * (1.0 - last), 1.0],
        [1.0, 3.0 * (1.0 - first), 3.0 * last, 0.0],
    );
    let (gg, hh): ([f64; 7], [f64; 7]) = (product(&g, &g), product(&h, &h));
    let shares: [[f64; 10]; 4] = [
        product(&hh, &h),
        product(&hh, &g).map(|x| 3.0 * x),
        product(&gg, &h).map(|x| 3.0 * x),
        product(&gg, &g),
    ];
    // N - D A, how far it may be off, and D E.
    let (mut arms, mut off, mut whole) = ([Vec2::ZERO; 12], [0.0; 12], [0.0; 12]);
    for (i, p) in part.points.iter().enumerate() {
        for (q, share) in cubic.iter().zip(&shares) {
            let arm = arm(p, q);
            let size = ROUNDING * arm.hypot();
            for (k, share) in share.iter().enumerate() {
                let weight = weights[i] * share;
                arms[i + k] += weight * arm;
                off[i + k] += weight * size;
                whole[i + k] += weight * most;
            }
        }
    }
    let sizes: [f64; 12] = core::array::from_fn(|k| arms[k].hypot());
    (0..23_usize).all(|k| {
        let mut sum = 0.0;
        let mut size = 0.0;
        for i in k.saturating_sub(11)..=k.min(11) {
            let j = k - i;
            let allowed = whole[i] * whole[j];
            sum += arms[i].dot(arms[j]) + sizes[i] * off[j] + off[i] * sizes[j] + off[i] * off[j]
                - allowed;
            size += sizes[i] * sizes[j] + allowed;
        }
        sum + ROUNDING * size <= 0.0
    })
}
