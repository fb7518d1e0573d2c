//! Tridiagonal systems, in time and memory linear in their number of unknowns; an unknown is a number or a vector.

use core::ops::{Add, Div, Mul, Sub};

/// One equation: `lower` x[i-1] + `diagonal` x[i] + `upper` x[i+1] = right[i].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TridiagonalRow {
    pub(crate) lower: f64,
    pub(crate) diagonal: f64,
    pub(crate) upper: f64,
}

/// A number or a vector of numbers.
pub(crate) trait Unknown:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> + Div<f64, Output = Self>
{
}

impl Unknown for f64 {}
impl Unknown for kurbo::Vec2 {}

/// Solves the system, in which the first `lower` couples to the last unknown and the last `upper` to the first where it is `cyclic`;
/// else they are not read. A cyclic system has at least three unknowns.
///
/// The matrix has to be diagonally dominant, as a spline's is; then elimination needs no exchange of rows. The solution is corrected
/// once by what it leaves of the right side, so that values with few digits come out as they are.
pub(crate) fn solve<T: Unknown>(
    row: impl Fn(usize) -> TridiagonalRow,
    mut right: Vec<T>,
    cyclic: bool,
) -> Vec<T> {
    let eliminate = |right| {
        if cyclic {
            eliminate_cyclic(&row, right)
        } else {
            eliminate(&row, right)
        }
    };
    let mut x = eliminate(right.clone());
    let count = x.len();
    for (i, right) in right.iter_mut().enumerate() {
        let TridiagonalRow {
            lower,
            diagonal,
            upper,
        } = row(i);
        *right = *right - x[i] * diagonal;
        if cyclic || i > 0 {
            *right = *right - x[(i + count - 1) % count] * lower;
        }
        if cyclic || i + 1 < count {
            *right = *right - x[(i + 1) % count] * upper;
        }
    }
    for (x, correction) in x.iter_mut().zip(eliminate(right)) {
        *x = *x + correction;
    }
    x
}

/// Gaussian elimination from the first row to the last, and back.
fn eliminate<T: Unknown>(row: impl Fn(usize) -> TridiagonalRow, mut right: Vec<T>) -> Vec<T> {
    let mut above: Vec<f64> = Vec::with_capacity(right.len());
    for i in 0..right.len() {
        let TridiagonalRow {
            lower,
            diagonal,
            upper,
        } = row(i);
        if i == 0 {
            above.push(upper / diagonal);
            right[0] = right[0] / diagonal;
        } else {
            let pivot = diagonal - lower * above[i - 1];
            above.push(upper / pivot);
            right[i] = (right[i] - right[i - 1] * lower) / pivot;
        }
    }
    for i in (1..right.len()).rev() {
        right[i - 1] = right[i - 1] - right[i] * above[i - 1];
    }
    right
}

/// The last unknown is taken out: the others are x = y - z `last`, where y answers to the right side and z to its column.
fn eliminate_cyclic<T: Unknown>(
    row: impl Fn(usize) -> TridiagonalRow,
    mut right: Vec<T>,
) -> Vec<T> {
    let count = right.len();
    assert!(count >= 3, "a cyclic system has at least three unknowns");
    let Some(last_right) = right.pop() else {
        return right;
    };
    let inner = count - 1;
    let mut column = vec![0.0; inner];
    column[0] = row(0).lower;
    column[inner - 1] += row(inner - 1).upper;
    let mut x = eliminate(&row, right);
    let z = eliminate(&row, column);
    let end = row(inner);
    let pivot = end.diagonal - end.upper * z[0] - end.lower * z[inner - 1];
    let last = (last_right - x[0] * end.upper - x[inner - 1] * end.lower) / pivot;
    for (x, z) in x.iter_mut().zip(z) {
        *x = *x - last * z;
    }
    x.push(last);
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::Vec2;

    fn row(i: usize) -> TridiagonalRow {
        let (lower, upper) = (0.5 + (i % 3) as f64, 0.3 + (i % 5) as f64);
        TridiagonalRow {
            lower,
            diagonal: 2.1 * (lower + upper),
            upper,
        }
    }

    /// The largest difference of the two sides of the equations.
    fn residual(right: &[Vec2], x: &[Vec2], cyclic: bool) -> f64 {
        let n = x.len();
        let difference = |i: usize| {
            let row = row(i);
            let before = x[(i + n - 1) % n] * row.lower;
            let after = x[(i + 1) % n] * row.upper;
            let wraps = |at: usize| if cyclic || i != at { 1.0 } else { 0.0 };
            (before * wraps(0) + x[i] * row.diagonal + after * wraps(n - 1) - right[i]).hypot()
        };
        (0..n).map(difference).fold(0.0, f64::max)
    }

    #[test]
    fn both_systems_are_satisfied() {
        for n in 1..40_usize {
            let right: Vec<Vec2> = (0..n)
                .map(|i| Vec2::new((i as f64).sin(), (i * i % 7) as f64))
                .collect();
            for cyclic in [false, true] {
                if n >= 3 || !cyclic {
                    let x = solve(row, right.clone(), cyclic);
                    assert!(residual(&right, &x, cyclic) < 1e-14, "{n}, {cyclic}");
                }
            }
        }
    }

    #[test]
    fn values_with_few_digits_come_out_as_they_are() {
        // Formulation I through the corners of a square, and through points with whole coordinates.
        let row = |_| TridiagonalRow {
            lower: 1.0,
            diagonal: 4.0,
            upper: 1.0,
        };
        assert_eq!(
            solve(row, vec![0.0, -6.0, 0.0, 6.0], true),
            [0.0, -1.5, 0.0, 1.5]
        );
        assert_eq!(
            solve(row, vec![21.0, 30.0, -30.0, -45.0, 9.0, 15.0], true),
            [2.6, 8.6, -7.0, -10.6, 4.4, 2.0]
        );
    }
}
