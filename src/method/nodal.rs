//! The nodal derivatives of a composite parametric cubic: Chen's systems (7), (11) and (15).
//!
//! With the points `P_i`, the parameter length `t_k` of the segment from P_{k-1} to `P_k` and the derivatives `D_i` with respect
//! to the parameter, the second derivative is continuous where (15) holds:
//!
//! ```text
//! t_{k+1} D_{i-1} + 2 (t_k + t_{k+1}) D_i + t_k D_{i+1} = 3 [ (t_k/t_{k+1}) (P_{i+1} - P_i) + (t_{k+1}/t_k) (P_i - P_{i-1}) ]
//! ```
//!
//! With all t = 1 that is (7), and with cyclic ends (11).

use kurbo::{Point, Vec2};

use crate::numeric::tridiagonal::{self, TridiagonalRow};

/// What holds at the ends of the curve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SplineEnds {
    /// The curve is closed, and its first point a node like every other: Chen's (10).
    Cyclic,
    /// The derivatives at both ends are zero, Chen's (9): what he calls free is not the natural spline, whose second derivatives are.
    #[default]
    Free,
    /// The second derivatives at both ends are zero: the natural spline, 2 `D_0` + `D_1` = 3 (`P_1` - `P_0`)/`t_1` at the first end.
    Natural,
    /// The derivatives at both ends are these, Chen's (8).
    Fixed([Vec2; 2]),
}

impl SplineEnds {
    /// The fewest points that such a curve runs through.
    #[must_use]
    pub const fn least_points(self) -> usize {
        match self {
            Self::Cyclic => 3,
            Self::Free | Self::Natural | Self::Fixed(_) => 2,
        }
    }

    /// The number of segments through this many points.
    pub(crate) const fn segments(self, points: usize) -> usize {
        match self {
            Self::Cyclic => points,
            Self::Free | Self::Natural | Self::Fixed(_) => points - 1,
        }
    }
}

/// The derivative at every point, for at least [`SplineEnds::least_points`] points; `length` tells the parameter length of the segment
/// that starts at a point.
pub(crate) fn derivatives(
    points: &[Point],
    length: impl Fn(usize) -> f64,
    ends: SplineEnds,
) -> Vec<Vec2> {
    let count = points.len();
    // The equation of the node i, whose segments are the one before and the one after.
    let row = |i: usize| {
        let (before, after) = (length((i + count - 1) % count), length(i));
        TridiagonalRow {
            lower: after,
            diagonal: 2.0 * (before + after),
            upper: before,
        }
    };
    let right = |i: usize| {
        let (previous, next) = ((i + count - 1) % count, (i + 1) % count);
        let (before, after) = (length(previous), length(i));
        let step = (points[next] - points[i]) * (before / after);
        (step + (points[i] - points[previous]) * (after / before)) * 3.0
    };
    let [first, last] = match ends {
        SplineEnds::Cyclic => {
            return tridiagonal::solve(row, (0..count).map(right).collect(), true);
        }
        SplineEnds::Natural => return natural(points, &length, row, right),
        SplineEnds::Free => [Vec2::ZERO; 2],
        SplineEnds::Fixed(given) => given,
    };
    let mut inner: Vec<Vec2> = (1..count - 1).map(right).collect();
    if let Some(right) = inner.first_mut() {
        *right -= first * row(1).lower;
    }
    if let Some(right) = inner.last_mut() {
        *right -= last * row(count - 2).upper;
    }
    let mut solved = tridiagonal::solve(|i| row(i + 1), inner, false);
    solved.insert(0, first);
    solved.push(last);
    solved
}

/// The derivatives of the natural spline; `row` and `right` are the equations of the inner nodes.
fn natural(
    points: &[Point],
    length: impl Fn(usize) -> f64,
    row: impl Fn(usize) -> TridiagonalRow,
    right: impl Fn(usize) -> Vec2,
) -> Vec<Vec2> {
    let last = points.len() - 1;
    let end = |segment: usize| (points[segment + 1] - points[segment]) * (3.0 / length(segment));
    let rights = (0..=last).map(|i| match i {
        0 => end(0),
        _ if i == last => end(last - 1),
        _ => right(i),
    });
    let rows = |i: usize| match i {
        _ if i == 0 || i == last => TridiagonalRow {
            lower: 1.0,
            diagonal: 2.0,
            upper: 1.0,
        },
        _ => row(i),
    };
    tridiagonal::solve(rows, rights.collect(), false)
}
