//! How two segments join: the gap, the turn, the jumps of curvature and of its derivatives, and the order that follows.
//!
//! A jump counts only where it is larger than the rounding of the coordinates explains. How far a rounding of at most δ in every
//! coordinate can move a figure is found from the figure itself: the sum over all coordinates of |change of the figure by that
//! coordinate| times δ. So one δ, stated in the report, decides at every scale and every angle.

use kurbo::{PathSeg, Point};

use super::curvature::{self, Curvature};
use crate::continuity::Continuity;
use crate::curve::{control_points, first_direction, segment_of, turn};

/// One joint.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Joint {
    /// The point where the segment before it ends.
    pub point: [f64; 2],
    /// Its angle about the centre in degrees, parametric on an ellipse.
    pub angle: f64,
    /// How far the segment after it starts from there.
    pub gap: f64,
    /// The turn of the tangent in degrees, positive from +x towards +y.
    pub turn: f64,
    /// The curvature where the segment before it ends; `null` where it has none.
    pub before: Option<Curvature>,
    /// The curvature where the segment after it starts; `null` where it has none.
    pub after: Option<Curvature>,
    /// How the derivatives by the segments' own parameters, each from 0 to 1, go on; `null` where one stands still or they turn.
    pub parameters: Option<Parameters>,
    /// The order: `none` (they do not meet), `G0` (a corner), `G1` (tangent), `G2` (curvature), `G3` and `G4` (its first and
    /// second derivative by arc length too; higher orders are not looked at).
    pub continuity: Continuity,
    /// The jumps that rounding explains.
    pub tolerance: JointTolerance,
}

/// Bias β and tension ν of a joint: p'(after) = β p'(before) and p''(after) = β² p''(before) + ν p'(before) + a rest along the
/// normal, which is 0 where the curvature is continuous (Chen 1996, (23) and (27)).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Parameters {
    /// β: how many times as long the derivative is after the joint.
    pub bias: f64,
    /// ν: what the second derivatives differ by along the tangent, in derivatives before the joint.
    pub tension: f64,
    /// What they differ by along the normal, positive towards the inside of the true shape.
    pub rest: f64,
}

/// The largest jumps that a rounding of the coordinates explains.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JointTolerance {
    /// Of the gap.
    pub gap: f64,
    /// Of the turn, in degrees.
    pub turn: f64,
    /// Of the curvature.
    pub value: f64,
    /// Of its derivative by arc length.
    pub d1: f64,
    /// Of its second derivative by arc length.
    pub d2: f64,
}

/// The joint of two segments whose coordinates are right to `delta`. Its angle is left at 0.
pub(crate) fn joint(before: &PathSeg, after: &PathSeg, delta: f64) -> Joint {
    let (end, start) = (last_point(before), control_points(after)[0]);
    let (ending, starting) = (curvature::at(before, 1.0), curvature::at(after, 0.0));
    let slack = slack(before, after, delta);
    let jump = |of: fn(&Curvature) -> f64| match (&ending, &starting) {
        (Some(a), Some(b)) => (of(b) - of(a)).abs(),
        _ => f64::INFINITY,
    };
    let (gap, turn) = ((start - end).hypot(), turn(before, after));
    // From the lowest order up: the first jump that rounding does not explain ends it.
    let steps = [
        (gap, slack.gap, Continuity::Apart),
        (turn.abs(), slack.turn, Continuity::G0),
        (jump(|k| k.value), slack.value, Continuity::G1),
        (jump(|k| k.d1), slack.d1, Continuity::G2),
        (jump(|k| k.d2), slack.d2, Continuity::G3),
    ];
    let order = steps
        .iter()
        .find(|(jump, explained, _)| jump > explained)
        .map_or(Continuity::G4, |&(.., order)| order);
    Joint {
        point: [end.x, end.y],
        angle: 0.0,
        gap,
        turn,
        before: ending,
        after: starting,
        parameters: parameters(before, after).filter(|_| order > Continuity::G0),
        continuity: order,
        tolerance: slack,
    }
}

/// Bias, tension and the rest, positive along the normal that is a quarter turn from the tangent, from +x towards +y.
fn parameters(before: &PathSeg, after: &PathSeg) -> Option<Parameters> {
    let [p1, p2, _] = curvature::derivatives(&control_points(before), 1.0);
    let [q1, q2, _] = curvature::derivatives(&control_points(after), 0.0);
    let (bias, square) = (q1.hypot() / p1.hypot(), p1.hypot2());
    let differ = q2 - p2 * (bias * bias);
    let found = Parameters {
        bias,
        tension: differ.dot(p1) / square,
        rest: p1.cross(differ) / square.sqrt(),
    };
    [found.bias, found.tension, found.rest]
        .iter()
        .all(|x| x.is_finite())
        .then_some(found)
}

fn last_point(segment: &PathSeg) -> Point {
    control_points(&segment.reverse())[0]
}

/// What a rounding by `delta` explains at this joint.
fn slack(before: &PathSeg, after: &PathSeg, delta: f64) -> JointTolerance {
    // An end and its reverse have the same tangent line, curvature up to the sign, and so on: one side's code serves both.
    let (a, b) = (reach(&before.reverse(), delta), reach(after, delta));
    JointTolerance {
        gap: 2.0 * core::f64::consts::SQRT_2 * delta,
        turn: (a[0] + b[0]).to_degrees(),
        value: a[1] + b[1],
        d1: a[2] + b[2],
        d2: a[3] + b[3],
    }
}

/// How far rounding by `delta` can move the direction (in radians), the curvature and its derivatives where a segment starts.
fn reach(segment: &PathSeg, delta: f64) -> [f64; 4] {
    let points = control_points(segment);
    let handle = first_direction(segment).hypot();
    let direction = 2.0 * core::f64::consts::SQRT_2 * delta / handle;
    let step = 1e-5 * handle;
    let mut reach = [
        if direction.is_finite() {
            direction
        } else {
            0.0
        },
        0.0,
        0.0,
        0.0,
    ];
    for coordinate in 0..2 * points.len() {
        let moved = |by: f64| {
            let mut points = points.clone();
            let p = &mut points[coordinate / 2];
            *(if coordinate % 2 == 0 {
                &mut p.x
            } else {
                &mut p.y
            }) += by;
            curvature::at(&segment_of(&points), 0.0)
        };
        if let (Some(more), Some(less)) = (moved(step), moved(-step)) {
            for (reach, (more, less)) in reach[1..]
                .iter_mut()
                .zip(more.to_array().into_iter().zip(less.to_array()))
            {
                *reach += (more - less).abs() / (2.0 * step) * delta;
            }
        }
    }
    if let Some(here) = curvature::at(segment, 0.0) {
        // The evaluation itself rounds too.
        for (reach, value) in reach[1..].iter_mut().zip(here.to_array()) {
            *reach += 16.0 * f64::EPSILON * value.abs();
        }
    }
    reach
}

#[cfg(test)]
mod tests {
    use kurbo::{CubicBez, Line, ParamCurve};

    use super::*;

    fn order(before: impl Into<PathSeg>, after: impl Into<PathSeg>, delta: f64) -> Continuity {
        joint(&before.into(), &after.into(), delta).continuity
    }

    #[test]
    fn ends_may_be_apart_by_the_rounding_of_both() {
        let line = |to, from| (Line::new((0.0, 0.0), to), Line::new(from, (40.0, 40.0)));
        let apart = |by| {
            let (before, after) = line((20.0, 20.0), (20.0 + by, 20.0 + by));
            order(before, after, 0.25)
        };
        assert!(apart(0.499) > Continuity::Apart);
        assert_eq!(apart(0.501), Continuity::Apart);
    }

    #[test]
    fn what_nothing_explains_is_no_jump_where_nothing_jumps() {
        let (before, after) = (
            Line::new((0.0, 0.0), (1.0, 2.0)),
            Line::new((1.0, 2.0), (2.0, 4.0)),
        );
        assert_eq!(order(before, after, 0.0), Continuity::G4);
    }

    #[test]
    fn a_cubic_that_was_cut_is_smooth_though_its_measure_rounds() {
        // Multiples of 64, so that the quarters are exact.
        for k in 0..40_i32 {
            let at = |x: i32, y: i32| Point::new(f64::from(64 * x), f64::from(64 * y));
            let whole = CubicBez::new(at(0, 0), at(3, 7 + k), at(11 + 2 * k, 9), at(20, 1 - k));
            let (before, after) = (whole.subsegment(0.0..0.25), whole.subsegment(0.25..1.0));
            assert_eq!(order(before, after, 0.0), Continuity::G4, "{k}");
        }
    }

    /// κ of a curve of degree n from (0,0) by (h,0) and (a,b) is f b/h², f = (n-1)/n; its derivatives by the coordinates are
    /// -2fb/h³ and f(a-h)/h³ by the first point's, 2fb/h³ and -fa/h³ by the second's, 0 and f/h² by the third's.
    #[test]
    fn what_a_rounding_explains_is_what_it_moves() {
        let (h, a, b) = (2e-3_f64, 5e-3_f64, -3e-3_f64);
        let [p, q, r, s] = [(0.0, 0.0), (h, 0.0), (a, b), (9e-3, 1e-3)].map(Point::from);
        let line = PathSeg::Line(Line::new((-4e-3, 0.0), p));
        let delta = 1e-9;
        for (after, f) in [
            (PathSeg::Cubic(CubicBez::new(p, q, r, s)), 2.0 / 3.0),
            (PathSeg::Quad(kurbo::QuadBez::new(p, q, r)), 1.0 / 2.0),
        ] {
            let found = joint(&line, &after, delta);
            let sum = f * (4.0 * b.abs() / h + (a - h).abs() / h + a / h + 1.0) / (h * h);
            assert!(
                (found.tolerance.value / (sum * delta) - 1.0).abs() < 1e-6,
                "{found:?}"
            );
            let turn = (8.0_f64.sqrt() * delta * (1.0 / h + 1.0 / 4e-3)).to_degrees();
            assert!(
                (found.tolerance.turn / turn - 1.0).abs() < 1e-12,
                "{found:?}"
            );
            // Where nothing was rounded, the evaluation's own rounding is left.
            let exact = joint(&line, &after, 0.0);
            let curvature = exact.after.unwrap().value.abs();
            assert!((curvature / (f * b.abs() / (h * h)) - 1.0).abs() < 1e-12);
            assert_eq!(exact.tolerance.value, 16.0 * f64::EPSILON * curvature);
        }
    }
}
