//! Joints that equalise the error of an ellipse's segments: flat ellipses need fewer of them so.
//!
//! An affine map M carries a radial error ρ at the parametric angle θ of the unit circle to the distance ρ w(θ) from the ellipse,
//! measured along its normal, with
//!
//! ```text
//! w(θ) = |det M| / |M u'(θ)|,   u(θ) = (cos θ, sin θ)
//! ```
//!
//! (rx ry / sqrt(rx² sin²θ + ry² cos²θ) for the radii rx, ry; derived). A segment errs by the largest ρ w along it, to first order.
//! Marching through the sweep with segments as long as an error T lets them be takes f(T) of them, and no cut takes fewer where
//! a longer segment errs more; f falls with T as T^(-1/order), so that the T of a whole count is found in a few steps.

use core::iter;

use kurbo::{ParamCurve, Point, Vec2};

use super::Joints;
use crate::angle::Angle;
use crate::error::Result;
use crate::method::{Ends, Method, Rule, Span, ellipse};
use crate::numeric::foot::foot;
use crate::numeric::root;
use crate::shape::{Axes, Outline, UnitArc};

/// Joints lie on multiples of this many degrees, so that their mirror images are exact.
const GRID: f64 = 1.0 / (1 << 30) as f64;

/// The parts into which a segment is cut to look for its peak; the peak between two samples follows from a parabola.
const SAMPLES: usize = 12;

/// A smaller radial error drowns in the rounding of samples; the formula tells it, at both lobes and in the middle.
const NOISE: f64 = 1e-11;
const LOBES: [f64; 3] = [0.18, 0.5, 0.82];

/// Where the error is a larger part of the smallest radius of curvature than this, the first order is too rough, and the error
/// no longer grows with the length of a segment alone.
const FIRST_ORDER: f64 = 1e-4;

/// How many lengths are tried then, evenly by their ratio, and how often what lies between two of them is halved.
const LONGER: u32 = 12;
const HALVINGS: u32 = 10;

/// How often the error is halved, by its ratio, that equalises such segments.
const NARROWINGS: u32 = 7;

/// The most steps for the length of one segment, and for the error that makes the count whole.
const MOST_STEPS: usize = 40;

/// Beyond this count joints stay at equal angles: the error of so many segments is below the digits of a coordinate.
const MOST: usize = 4096;

/// Whether the rule's pieces join at uneven angles, each one on its own.
pub(crate) fn serves(rule: Rule) -> bool {
    match rule {
        Rule::Handle(_)
        | Rule::Method(Method::Chen1 | Method::LancasterBest | Method::LancasterDrawellipse) => {
            false
        }
        Rule::Chen2Gauss2 => true,
        Rule::Method(method) => method.card().ends == Ends::OnCircle,
    }
}

/// The weights of a placement, and the method's error.
pub(crate) struct Balance {
    arc: UnitArc,
    rule: Rule,
    /// w(θ)^-2 = 1 + swing cos²(θ - axis), in degrees, over the larger radius.
    swing: f64,
    axis: f64,
    order: f64,
    largest_angle: f64,
    /// The smaller radius over the larger one.
    short: f64,
    /// Whether a piece costs no search.
    is_quick: bool,
}

impl Balance {
    /// `None` where equal angles are best or the rule serves no others: on circles, and for methods that lean on equal pieces.
    pub(crate) fn new(outline: &Outline, rule: Rule) -> Option<Self> {
        if outline.truth.is_circle() || !serves(rule) {
            return None;
        }
        let card = rule.method()?.card();
        let Axes { short, angle } = outline.axes();
        Some(Self {
            arc: outline.unit,
            rule,
            swing: (1.0 - short) * (1.0 + short) / (short * short),
            axis: angle,
            short,
            is_quick: matches!(
                rule,
                Rule::Method(
                    Method::Midpoint
                        | Method::Minimax
                        | Method::Goldapp
                        | Method::Curvature
                        | Method::Apprich
                        | Method::Area
                        | Method::Chen3
                )
            ),
            order: f64::from(card.order),
            largest_angle: card.largest_angle,
        })
    }

    /// The error of a segment of `size` degrees that begins `way` degrees after the start, over the larger radius.
    fn error(&self, way: f64, size: f64) -> f64 {
        let sign = 1.0_f64.copysign(self.arc.sweep.degrees());
        // The axis of the weights along x, the sweep upwards: both leave ρ and w as they are.
        let from = sign * (self.arc.start.degrees() - self.axis) + way;
        if self.rule == Rule::Method(Method::MinimaxEllipse) {
            return ellipse::peak(self.short, from, size).unwrap_or(f64::INFINITY);
        }
        let span = Span::from_degrees(size);
        let (Ok(piece), Ok(error)) = (self.rule.piece(&span), self.rule.radial_error(&span)) else {
            return f64::INFINITY;
        };
        if error.peak() < NOISE {
            let weight = |part: f64| self.weight(from + part * size);
            return error.peak() * LOBES.map(weight).into_iter().fold(0.0, f64::max);
        }
        let ends = [from, from + size].map(|degrees| Angle::from_degrees(degrees).direction());
        let segment = piece.between(ends);
        let mut errors = [0.0; SAMPLES + 1];
        let (mut before, mut tip) = (0.0, 0.0_f64);
        for (i, error) in errors.iter_mut().enumerate().skip(1) {
            let t = i as f64 / SAMPLES as f64;
            let point = segment.eval(t);
            if i < SAMPLES {
                *error = self.strays(point);
            }
            // Where the curve passes a sharp end the distance has a peak that falls between samples.
            let side = if i == 1 { segment.start().x } else { before };
            if (side > 0.0) != (point.x > 0.0) {
                let from = (i - 1) as f64 / SAMPLES as f64;
                let crossing = root(|t| segment.eval(t).x, from, t);
                tip = tip.max(self.strays(segment.eval(crossing)));
            }
            before = point.x;
        }
        peak(&errors).max(tip)
    }

    /// w at so many degrees from the axis of the least weights, over the larger radius.
    fn weight(&self, degrees: f64) -> f64 {
        let cos = libm::cos(degrees.to_radians());
        (1.0 + self.swing * cos * cos).sqrt().recip()
    }

    /// How far a point in the frame where the ellipse is the unit circle, its short axis along x, lies from the ellipse.
    fn strays(&self, point: Point) -> f64 {
        let square = point.to_vec2().hypot2();
        // r - 1 by r² - 1, which keeps its digits.
        let radial = (square - 1.0).abs() / (square.sqrt() + 1.0);
        let error = radial / (1.0 + self.swing * (point.x * point.x) / square).sqrt();
        if self.is_rough(error) {
            let p = Vec2::new(self.short * point.x, point.y);
            return foot(Vec2::new(self.short, 1.0), p).distance.abs();
        }
        error
    }

    /// The longest segment from `way`, up to `most`, whose error is `allowed`, starting the search from `guess`.
    fn longest(&self, way: f64, allowed: f64, guess: f64, most: f64) -> f64 {
        if !self.is_rough(allowed) {
            return self.settled(way, allowed, guess);
        }
        // The sharp ends of a flat ellipse are harmless at a joint, so that a longer segment may err less than a shorter one.
        let least = self.safe(allowed).min(most);
        let step = libm::pow(most / least, 1.0 / f64::from(LONGER));
        let within = |size: f64| size <= most && self.error(way, size) <= allowed;
        let sizes = (0..=LONGER).map(|i| (least * libm::pow(step, f64::from(i))).min(most));
        let longest = sizes.filter(|&size| within(size)).fold(least, f64::max);
        let (mut low, mut high) = (longest, (longest * step).min(most));
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if within(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let sign = 1.0_f64.copysign(self.arc.sweep.degrees());
        let quarters = (sign * (self.arc.start.degrees() - self.axis) + way + low) / 90.0;
        let to_axis = low + 90.0 * (quarters.ceil() - quarters);
        let axes = [to_axis, to_axis + 90.0].into_iter();
        axes.filter(|&size| within(size)).fold(low, f64::max)
    }

    /// The length of a segment whose error is `allowed` on the circle, and so no larger anywhere.
    fn safe(&self, allowed: f64) -> f64 {
        let mut size = 45.0_f64.min(self.largest_angle);
        for _ in 0..MOST_STEPS {
            let error = self.rule.radial_error(&Span::from_degrees(size));
            let error = error.map_or(f64::INFINITY, |error| error.peak());
            if error <= allowed && error > 0.9 * allowed {
                break;
            }
            let factor = libm::pow(0.95 * allowed / error, 1.0 / self.order);
            let next = (size * factor.clamp(0.25, 4.0)).min(self.largest_angle);
            if next == size {
                break;
            }
            size = next;
        }
        size
    }

    /// The length at which the error is `allowed`, near `guess`.
    fn settled(&self, way: f64, allowed: f64, guess: f64) -> f64 {
        let mut size = guess.min(self.largest_angle);
        for _ in 0..MOST_STEPS {
            let factor = libm::pow(allowed / self.error(way, size), 1.0 / self.order);
            let next = (size * factor.clamp(0.25, 4.0)).min(self.largest_angle);
            let settled = (next - size).abs() <= 1e-7 * size;
            size = next;
            if settled {
                break;
            }
        }
        size
    }

    /// How many segments of this error the way takes, the last one counted by its part, or more than `most`; their joints.
    fn march(&self, whole: f64, allowed: f64, most: usize, joints: &mut Vec<f64>) -> f64 {
        joints.clear();
        joints.push(0.0);
        let (mut way, mut size) = (0.0, whole.min(30.0));
        loop {
            size = self
                .longest(way, allowed, size, self.largest_angle.min(whole - way))
                .max(whole / (4 * MOST) as f64);
            let left = whole - way;
            if size >= left || joints.len() > most {
                return (joints.len() - 1) as f64 + left / size;
            }
            way += size;
            joints.push(way);
        }
    }

    /// Whether a closed shape starts on an axis, so that its halves mirror one another.
    fn mirrors(&self) -> bool {
        self.arc.closed && self.on_axis(self.arc.start.degrees())
    }

    /// Whether an angle lies on an axis of the ellipse.
    fn on_axis(&self, degrees: f64) -> bool {
        (degrees - self.axis) % 90.0 == 0.0
    }

    /// The part of the sweep that is computed: half of it where the other half is its mirror image.
    fn computed(&self, mirrored: bool) -> f64 {
        self.arc.sweep.degrees().abs() / if mirrored { 2.0 } else { 1.0 }
    }

    /// The segments that are as long as `allowed` lets them be, over the larger radius, from the start or from the end on; the
    /// last one may be shorter.
    pub(crate) fn greedy(&self, allowed: f64) -> impl Iterator<Item = Joints> {
        let whole = self.computed(false);
        let mut forth = Vec::new();
        self.march(whole, allowed, MOST, &mut forth);
        forth.push(whole);
        let back = (!self.arc.closed).then(|| {
            let from = |end: f64| Angle::from_degrees(end);
            let arc = UnitArc {
                start: from(self.arc.start.degrees() + self.arc.sweep.degrees()),
                sweep: from(-self.arc.sweep.degrees()),
                ..self.arc
            };
            let mut ways = Vec::new();
            Self { arc, ..*self }.march(whole, allowed, MOST, &mut ways);
            ways.push(whole);
            ways.iter().rev().map(|way| whole - way).collect()
        });
        let joints = |ways: Vec<f64>| Joints::after(&self.arc, &ways);
        iter::once(forth)
            .chain(back)
            .filter(|ways| ways.len() <= MOST)
            .map(joints)
    }

    /// Joints that equalise the error of so many segments; an even number of a closed shape's mirror in both axes.
    ///
    /// # Errors
    ///
    /// As [`Joints::equal`], whose joints these are where so few segments have no room to differ.
    pub(crate) fn joints(&self, count: usize) -> Result<Joints> {
        let equal = Joints::equal(&self.arc, count)?;
        let mirrored = self.mirrors() && count.is_multiple_of(2);
        let pieces = if mirrored { count / 2 } else { count };
        if count > MOST || pieces < 2 {
            return Ok(equal);
        }
        let whole = self.computed(mirrored);
        let Some(mut ways) = self.equalised(whole, pieces) else {
            return Ok(equal);
        };
        let middle = self.arc.start.degrees() + whole.copysign(self.arc.sweep.degrees()) / 2.0;
        let symmetric = self.on_axis(middle);
        for i in 1..=pieces / 2 {
            let opposite = pieces - i;
            let mut pair = [ways[i], ways[opposite]];
            if symmetric {
                let way = f64::midpoint(pair[0], whole - pair[1]);
                pair = [way, whole - way];
            }
            let on_grid = |way: f64| (way / GRID).round() * GRID;
            ways[i] = on_grid(pair[0]);
            ways[opposite] = if symmetric {
                whole - ways[i]
            } else {
                on_grid(pair[1])
            };
        }
        if mirrored {
            for i in (0..pieces).rev() {
                ways.push(2.0 * whole - ways[i]);
            }
        }
        Ok(Joints::after(&self.arc, &ways))
    }

    /// The ways of so many segments of equal error, both ends included; `None` where the method's largest angle forbids it.
    fn equalised(&self, whole: f64, pieces: usize) -> Option<Vec<f64>> {
        let count = pieces as f64;
        let mut joints = Vec::with_capacity(pieces + 1);
        let mut allowed = self.error(0.0, whole / count);
        if self.is_rough(allowed) {
            return self.narrowed(whole, pieces);
        }
        for _ in 0..MOST_STEPS {
            let taken = self.march(whole, allowed, 2 * pieces + 8, &mut joints);
            if (taken / count - 1.0).abs() <= 1e-7 {
                joints.truncate(pieces);
                joints.push(whole);
                return (joints.len() == pieces + 1).then_some(joints);
            }
            allowed *= libm::pow(taken / count, self.order).clamp(1e-3, 1e3);
        }
        None
    }
}

impl Balance {
    /// As [`Self::equalised`] where longer segments may err less: the error is narrowed down between that of equal angles and a
    /// thousandth of it.
    fn narrowed(&self, whole: f64, pieces: usize) -> Option<Vec<f64>> {
        let size = whole / pieces as f64;
        let equal = (0..pieces).map(|i| self.error(i as f64 * size, size));
        let mut high = equal.fold(0.0, f64::max);
        let mut low = high / 1000.0;
        let (mut found, mut joints) = (None, Vec::new());
        for _ in 0..NARROWINGS {
            let middle = (low * high).sqrt();
            if self.march(whole, middle, pieces, &mut joints) > pieces as f64 {
                low = middle;
            } else {
                high = middle;
                joints.push(whole);
                found = (joints.len() == pieces + 1).then(|| joints.clone());
            }
        }
        found
    }

    /// Whether the first order does not tell errors of this size, and the method's formula is short enough to find out.
    fn is_rough(&self, error: f64) -> bool {
        self.is_quick && error > FIRST_ORDER * self.short * self.short
    }
}

/// The largest of evenly spaced samples of a smooth curve, by the parabola through it and its neighbours.
fn peak(samples: &[f64]) -> f64 {
    let highest = samples
        .iter()
        .copied()
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((i, top)) = highest else {
        return 0.0;
    };
    let (Some(before), Some(after)) = (
        i.checked_sub(1).and_then(|i| samples.get(i)),
        samples.get(i + 1),
    ) else {
        return top;
    };
    let (slope, bend) = ((after - before) / 2.0, before - 2.0 * top + after);
    if bend < 0.0 {
        top - slope * slope / (2.0 * bend)
    } else {
        top
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cut, Ellipse, Options, Shape, Tolerance, approximate};

    fn ellipse(flatness: f64) -> Shape {
        Shape::Ellipse(Ellipse::new((0.0, 0.0), (3.0, 3.0 * flatness), Angle::ZERO).unwrap())
    }

    fn draw(shape: &Shape, cut: Cut) -> crate::Drawing {
        let options = Options {
            cut,
            ..Options::default()
        };
        approximate(shape, &options).unwrap()
    }

    #[test]
    fn the_law_of_many_segments_is_the_mean_sixth_root_of_the_weight() {
        for (flatness, ratio) in [(0.5, 0.94), (0.2, 0.84), (0.1, 0.76), (0.01, 0.53)] {
            let balance = Balance::new(&ellipse(flatness).outline().unwrap(), Rule::default());
            let balance = balance.unwrap();
            let allowed = 1e-22;
            let equal = 360.0 / balance.settled(0.0, allowed, 0.1);
            let ours = 2.0 * balance.march(180.0, allowed, 2 * MOST, &mut Vec::new());
            assert!(
                (ours / equal - ratio).abs() < 0.006,
                "{flatness}: {ours} of {equal}"
            );
        }
    }

    #[test]
    fn flat_ellipses_need_fewer_segments_within_the_tolerance() {
        for (flatness, most) in [(0.5, 0.98), (0.2, 0.87), (0.1, 0.81), (0.01, 0.69)] {
            let shape = ellipse(flatness);
            let tolerance = 3e-10;
            let equal = (2..1000)
                .find(|&count| draw(&shape, Cut::Count(count)).error.peak() <= tolerance)
                .unwrap();
            let drawing = draw(&shape, Cut::Tolerance(Tolerance::Absolute(tolerance)));
            assert!(drawing.error.peak() <= tolerance);
            let ours = drawing.curve.segments.len() as f64;
            assert!(ours <= most * equal as f64, "{flatness}: {ours} of {equal}");
        }
    }

    #[test]
    fn equal_angles_are_never_better() {
        for flatness in [0.99, 0.9, 0.6, 0.3, 0.1] {
            let shape = ellipse(flatness);
            for tolerance in [0.3, 0.1, 1e-2, 2e-3, 1e-4, 1e-6] {
                let ours = draw(&shape, Cut::Tolerance(Tolerance::Absolute(tolerance)));
                assert!(ours.error.peak() <= tolerance);
                for fewer in 2..ours.curve.segments.len() {
                    let equal = draw(&shape, Cut::Count(fewer));
                    assert!(
                        equal.error.peak() > tolerance,
                        "{flatness} {tolerance} {fewer}"
                    );
                }
            }
        }
    }

    #[test]
    fn peaks_are_equal_and_joints_mirror() {
        for (flatness, count) in [(0.5, 8), (0.1, 10), (0.03, 14), (0.1, 9)] {
            let options = Options {
                cut: Cut::Adaptive(count),
                precision: Some(crate::number::Precision::Full),
                ..Options::default()
            };
            let drawing = approximate(&ellipse(flatness), &options).unwrap();
            let truth = drawing.outline.unwrap().truth;
            let peaks: Vec<f64> = drawing
                .curve
                .segments
                .iter()
                .map(|segment| crate::measure::radial::error([segment], &truth).peak())
                .collect();
            let least = peaks.iter().copied().fold(f64::INFINITY, f64::min);
            let largest = peaks.iter().copied().fold(0.0, f64::max);
            assert!(largest / least < 1.15, "{flatness} {count}: {peaks:?}");
            let angles = &drawing.angles;
            for i in 0..=count {
                assert_eq!(angles[i] + angles[count - i], 360.0);
                if count % 2 == 0 && i <= count / 2 {
                    assert_eq!(angles[i] + angles[count / 2 - i], 180.0);
                }
            }
        }
    }
}
