//! `chen-1`, `chen-2`, `chen-3`: Da-Pan Chen, "Formulations of composite parametric cubic curves and circle approximations" (1996).
//!
//! A handle is a third of the nodal derivative. Formulation I takes every segment's parameter from 0 to 1: the derivatives `D_i`
//! solve (7), D_{i-1} + 4 `D_i` + D_{i+1} = 3 (P_{i+1} - P_{i-1}), cyclic in (11); on evenly spaced points of a circle that gives
//! k = s/(2+c). Formulation II takes the parameter t as the curve's own arc length: k = t/3 with t = L(t/3). Formulation III
//! takes the arc length of the circle: k = a/3.

use kurbo::{Point, Vec2};

use super::nodal::{self, SplineEnds};
use crate::angle::Angle;
use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::{Degree, Piece, Span, tangent};
use crate::numeric::{integral, sine_minus_angle_cosine};

/// The most rounds of Formulation II; it halves its error at least in each.
const MOST_ROUNDS: usize = 200;

/// s/(2+c): evenly spaced points of a whole circle.
pub(super) fn formulation_1(span: &Span) -> f64 {
    span.s / (2.0 + span.c)
}

/// 1 - r² at t = 1/2, where it is largest: (H + G/4)/16 with H = 12 sin⁴ h/(2+c)² and G = 16 sin⁶ h/(2+c)².
pub(super) fn formulation_1_error(span: &Span) -> RadialError {
    let square = span.sh * span.sh;
    let largest = power(square / (2.0 + span.c), 2) * (3.0 + square) / 4.0;
    RadialError {
        outward: 0.0,
        inward: -tangent::root_minus_1(-largest),
    }
}

/// How arc length is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[non_exhaustive]
pub enum Quadrature {
    /// Until it no longer changes.
    #[default]
    Adaptive,
    #[cfg_attr(feature = "cli", value(help = "Chen's two-point Gauss quadrature"))]
    /// Two-point Gauss quadrature of Chen's (16), which reproduces the value of Formulation II that he printed.
    Gauss2,
}

/// How Formulation II finds the length of a segment of the circle: his Figure 8.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Iteration {
    /// How arc length is integrated.
    pub quadrature: Quadrature,
    /// It ends when the length changes by less than this part of itself; at 0, the default, when it no longer changes.
    pub stop: f64,
}

impl Iteration {
    /// The length of a segment of the unit circle round by round, the first the chord.
    pub(crate) fn lengths(self, span: &Span) -> Vec<f64> {
        let mut lengths = Vec::new();
        let (span, part) = span.in_range();
        SelfMeasured::settled(&span, self, |t| lengths.push(t * part));
        lengths
    }
}

/// t/3 with t = L(t/3).
pub(super) fn formulation_2(span: &Span, iteration: Iteration) -> f64 {
    let (span, part) = span.in_range();
    SelfMeasured::new(&span, iteration).handle() * part
}

pub(super) fn formulation_2_error(span: &Span, iteration: Iteration) -> RadialError {
    let (span, part) = span.in_range();
    let error = SelfMeasured::new(&span, iteration).error();
    error.times(power(part, 4))
}

/// The integral, in parts that are halved until it no longer changes.
fn adaptive(f: &dyn Fn(f64) -> f64) -> f64 {
    let mut sum = integral(f, 0.0, 1.0);
    for parts in [2, 4, 8, 16, 32, 64] {
        let edge = |i: i32| f64::from(i) / f64::from(parts);
        let finer = (0..parts)
            .map(|i| integral(f, edge(i), edge(i + 1)))
            .sum::<f64>();
        let change = (finer - sum).abs();
        sum = finer;
        if change <= 1e-15 * finer {
            break;
        }
    }
    sum
}

/// The two points of the whole curve lie symmetrically, and so does the speed: one serves for both.
fn gauss2(f: &dyn Fn(f64) -> f64) -> f64 {
    f(1.0 / 3.0_f64.sqrt())
}

/// The curve whose parameter t is its own length.
///
/// In the frame of the bisector, with τ = 2t - 1 of the unit parameter, it is (x0 + x2 τ², y1 τ + y3 τ³) with x2 = -(t/4) sin h and
/// y3 = y/4. Since the derivative of Y by τ integrates to the chord, the length exceeds the chord 2 sin h by
///
/// ```text
/// e = 2 ∫ X'² / (sqrt(X'² + Y'²) + Y') dτ over [0, 1],   t = 2 sin h + e,   y = e - t (1 - cos h)
/// ```
///
/// in which nothing cancels; two-point Gauss quadrature integrates Y' exactly too.
struct SelfMeasured<'a> {
    span: &'a Span,
    t: f64,
    y: f64,
}

impl<'a> SelfMeasured<'a> {
    fn new(span: &'a Span, iteration: Iteration) -> Self {
        Self::settled(span, iteration, |_| ())
    }

    /// Iterates from the chord, as his Figure 8 does, and calls `visit` with each t.
    fn settled(span: &'a Span, iteration: Iteration, mut visit: impl FnMut(f64)) -> Self {
        let chord = 2.0 * span.sh;
        let with_excess = |e: f64| {
            let t = chord + e;
            let y = e - t * span.half_versine();
            Self { span, t, y }
        };
        let mut curve = with_excess(0.0);
        let mut e = 0.0;
        visit(curve.t);
        for _ in 0..MOST_ROUNDS {
            let integrand = |tau| curve.excess_at(tau);
            let next = match iteration.quadrature {
                Quadrature::Adaptive => adaptive(&integrand),
                Quadrature::Gauss2 => gauss2(&integrand),
            };
            let change = (next - e).abs();
            e = next;
            curve = with_excess(e);
            visit(curve.t);
            if change <= f64::EPSILON * e || change < iteration.stop * curve.t {
                break;
            }
        }
        curve
    }

    /// The integrand of e.
    fn excess_at(&self, tau: f64) -> f64 {
        let dx = -0.5 * self.t * self.span.sh * tau;
        let dy = self.span.sh + 0.25 * self.y * (3.0 * tau * tau - 1.0);
        2.0 * dx * dx / (libm::hypot(dx, dy) + dy)
    }

    fn handle(&self) -> f64 {
        self.t / 3.0
    }

    fn error(&self) -> RadialError {
        tangent::error_by_y(self.span, self.handle(), self.y)
    }
}

/// a/3.
pub(super) fn formulation_3(span: &Span) -> f64 {
    span.a / 3.0
}

/// y = a cos h - 2 sin h.
pub(super) fn formulation_3_error(span: &Span) -> RadialError {
    let y = -2.0 * sine_minus_angle_cosine(span.a / 2.0);
    tangent::error_by_y(span, formulation_3(span), y)
}

/// Formulation I on points of the circle that may be spaced unevenly: cyclic ends where `closed`, else fixed ends with the
/// circle's own derivatives, a T. Each piece is described from both its ends.
pub(super) fn chain(spans: &[Span], closed: bool) -> Vec<[Piece; 2]> {
    let mut angle = 0.0;
    let mut frames = vec![Vec2::new(1.0, 0.0)];
    for span in spans {
        angle += span.degrees();
        frames.push(Angle::from_degrees(angle).direction());
    }
    let tangent_at = |e: Vec2| Vec2::new(-e.y, e.x);
    let last = spans.len();
    let ends = if closed {
        frames.pop();
        SplineEnds::Cyclic
    } else {
        SplineEnds::Fixed([
            tangent_at(frames[0]) * spans[0].a,
            tangent_at(frames[last]) * spans[last - 1].a,
        ])
    };
    let points: Vec<Point> = frames.iter().map(|frame| frame.to_point()).collect();
    let mut derivatives = nodal::derivatives(&points, |_| 1.0, ends);
    if closed {
        frames.push(frames[0]);
        derivatives.push(derivatives[0]);
    }
    let in_frame = |i: usize| {
        Vec2::new(
            derivatives[i].dot(frames[i]),
            derivatives[i].dot(tangent_at(frames[i])),
        ) / 3.0
    };
    let piece = |handle| Piece {
        degree: Degree::Cubic,
        end_radius: 1.0,
        handle,
    };
    (0..spans.len())
        .map(|i| {
            let (start, end) = (in_frame(i), in_frame(i + 1));
            [
                piece(Vec2::new(1.0 + start.x, start.y)),
                piece(Vec2::new(1.0 - end.x, end.y)),
            ]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// methods.md: t = 1.5567523458 with exact arc length, and sqrt(2.4) with two-point Gauss quadrature.
    #[test]
    fn formulation_2_of_a_quarter_has_the_known_fixed_points() {
        let quarter = Span::from_degrees(90.0);
        assert!(
            (3.0 * formulation_2(&quarter, Iteration::default()) - 1.556_752_345_8).abs() < 5e-11
        );
        let gauss = Iteration {
            quadrature: Quadrature::Gauss2,
            stop: 0.0,
        };
        assert!((3.0 * formulation_2(&quarter, gauss) - 2.4_f64.sqrt()).abs() < 1e-15);
        let printed = formulation_2_error(&quarter, gauss).peak();
        assert!((printed - 0.019_031_9).abs() < 5e-8, "{printed}");
    }

    #[test]
    fn formulation_2_is_its_own_length() {
        use kurbo::ParamCurveArclen;
        for degrees in [0.01, 1.0, 30.0, 90.0, 137.0, 180.0] {
            let span = Span::from_degrees(degrees);
            let k = formulation_2(&span, Iteration::default());
            let curve = kurbo::CubicBez::new(
                (1.0, 0.0),
                (1.0, k),
                (span.c + k * span.s, span.s - k * span.c),
                (span.c, span.s),
            );
            let off = curve.arclen(1e-14) / (3.0 * k) - 1.0;
            assert!(off.abs() < 1e-12, "{degrees}: {off:e}");
        }
    }
}
