//! `chen-1`, `chen-2`, `chen-3`: Da-Pan Chen, "Formulations of composite parametric cubic curves and circle approximations" (1996).
//!
//! A handle is a third of the nodal derivative. Formulation I takes every segment's parameter from 0 to 1: the derivatives `D_i`
//! solve (7), D_{i-1} + 4 `D_i` + D_{i+1} = 3 (P_{i+1} - P_{i-1}), cyclic in (11); on evenly spaced points of a circle that gives
//! k = s/(2+c). Formulation II takes the parameter t as the curve's own arc length: k = t/3 with t = L(t/3). Formulation III
//! takes the arc length of the circle: k = a/3.

use kurbo::{Point, Vec2};

use crate::angle::Angle;
use crate::measure::RadialError;
use crate::spline::nodal::{self, Ends};

use super::numeric::integral;
use super::{Degree, Piece, Span, tangent};

/// The order-4 limit of the error of all three formulations, a⁴/384.
const LEADING: f64 = 1.0 / 384.0;

/// The most rounds of Formulation II; it halves its error at least in each.
const MOST_ROUNDS: usize = 200;

/// s/(2+c): evenly spaced points of a whole circle.
pub(super) fn formulation_1(span: &Span) -> f64 {
    span.s / (2.0 + span.c)
}

/// t/3 with t = L(t/3), arc length integrated until it no longer changes.
pub(super) fn formulation_2(span: &Span) -> f64 {
    fixed_point(span, |speed| {
        let mut parts = 1_u32;
        let mut length = integral(speed, 0.0, 1.0);
        while parts < 64 {
            parts *= 2;
            let edge = |i: u32| f64::from(i) / f64::from(parts);
            let finer = (0..parts)
                .map(|i| integral(speed, edge(i), edge(i + 1)))
                .sum::<f64>();
            let change = (finer - length).abs();
            length = finer;
            if change <= 1e-15 * finer {
                break;
            }
        }
        length
    })
}

/// The same with his two-point Gauss quadrature, which reproduces the value that he printed.
pub(super) fn formulation_2_gauss(span: &Span) -> f64 {
    // The two points lie symmetrically, and so does the speed.
    fixed_point(span, |speed| speed(1.0 / 3.0_f64.sqrt()))
}

/// Iterates t from the chord, as his Figure 8 does. `length` integrates the speed over one half of the symmetric curve, given by
/// τ = 2t - 1 in [0, 1]; by τ that half is as long as the whole curve is by t.
fn fixed_point(span: &Span, length: impl Fn(&dyn Fn(f64) -> f64) -> f64) -> f64 {
    let mut t = 2.0 * span.sh;
    for _ in 0..MOST_ROUNDS {
        // In the frame of the bisector the curve is (x0 + x2 τ², y1 τ + y3 τ³).
        let k = t / 3.0;
        let x2 = -0.75 * k * span.sh;
        let y3 = 0.75 * k * span.ch - 0.5 * span.sh;
        let y1 = span.sh - y3;
        let next = length(&|tau| 2.0 * (2.0 * x2 * tau).hypot(y1 + 3.0 * y3 * tau * tau));
        if (next - t).abs() <= 1e-16 * t {
            return next / 3.0;
        }
        t = next;
    }
    t / 3.0
}

/// a/3.
pub(super) fn formulation_3(span: &Span) -> f64 {
    span.a / 3.0
}

/// The error of a handle of one of the formulations on evenly spaced points.
pub(super) fn error(span: &Span, k: f64) -> RadialError {
    if span.a < 1e-3 {
        return RadialError {
            outward: 0.0,
            inward: span.a.powi(4) * LEADING,
        };
    }
    tangent::error(span, k)
}

/// Formulation I on points of the circle that may be spaced unevenly: cyclic ends where `closed`, else fixed ends with the
/// circle's own derivatives, a T. Each piece is told from both its ends.
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
        Ends::Cyclic
    } else {
        Ends::Fixed([
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
