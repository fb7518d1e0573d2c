//! Tridiagonal systems with vectors on the right, in time and memory linear in their number.

use kurbo::Vec2;

/// Solves `lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = right[i]`; `lower[0]` and the last `upper` are not read.
///
/// The matrix has to be diagonally dominant, as a spline's is; then elimination needs no exchange of rows.
pub(crate) fn solve(
    lower: &[f64],
    diagonal: &[f64],
    upper: &[f64],
    mut right: Vec<Vec2>,
) -> Vec<Vec2> {
    let count = right.len();
    let mut above = vec![0.0; count];
    for i in 0..count {
        let (left_above, left) = if i == 0 {
            (0.0, Vec2::ZERO)
        } else {
            (above[i - 1], right[i - 1])
        };
        let below = if i == 0 { 0.0 } else { lower[i] };
        let pivot = diagonal[i] - below * left_above;
        above[i] = upper[i] / pivot;
        right[i] = (right[i] - left * below) / pivot;
    }
    for i in (1..count).rev() {
        let known = right[i];
        right[i - 1] -= known * above[i - 1];
    }
    right
}

/// Solves the cyclic system, in which `lower[0]` couples to the last unknown and the last `upper` to the first.
///
/// The corners are taken out by the Sherman-Morrison formula; at least three unknowns.
pub(crate) fn solve_cyclic(
    lower: &[f64],
    diagonal: &[f64],
    upper: &[f64],
    right: Vec<Vec2>,
) -> Vec<Vec2> {
    let count = right.len();
    assert!(count >= 3, "a cyclic system has at least three unknowns");
    let last = count - 1;
    let (corner_top, corner_bottom) = (lower[0], upper[last]);
    let gamma = -diagonal[0];
    let mut changed = diagonal.to_vec();
    changed[0] -= gamma;
    changed[last] -= corner_bottom * corner_top / gamma;
    let mut spike = vec![Vec2::ZERO; count];
    spike[0].x = gamma;
    spike[last].x = corner_bottom;
    let plain = solve(lower, &changed, upper, right);
    let spike = solve(lower, &changed, upper, spike);
    let share = |first: f64, last: f64| first + corner_top / gamma * last;
    let weight = 1.0 + share(spike[0].x, spike[last].x);
    let factor = Vec2::new(
        share(plain[0].x, plain[last].x),
        share(plain[0].y, plain[last].y),
    ) / weight;
    plain
        .into_iter()
        .zip(spike)
        .map(|(x, z)| x - factor * z.x)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn residual(
        lower: &[f64],
        diagonal: &[f64],
        upper: &[f64],
        right: &[Vec2],
        x: &[Vec2],
        cyclic: bool,
    ) -> f64 {
        let n = x.len();
        (0..n)
            .map(|i| {
                let before = if i > 0 || cyclic {
                    x[(i + n - 1) % n] * lower[i]
                } else {
                    Vec2::ZERO
                };
                let after = if i + 1 < n || cyclic {
                    x[(i + 1) % n] * upper[i]
                } else {
                    Vec2::ZERO
                };
                (before + x[i] * diagonal[i] + after - right[i]).hypot()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn both_solvers_satisfy_their_equations() {
        for n in 3..40_usize {
            let lower: Vec<f64> = (0..n).map(|i| 0.5 + (i % 3) as f64).collect();
            let upper: Vec<f64> = (0..n).map(|i| 0.3 + (i % 5) as f64).collect();
            let diagonal: Vec<f64> = (0..n).map(|i| 2.1 * (lower[i] + upper[i])).collect();
            let right: Vec<Vec2> = (0..n)
                .map(|i| Vec2::new((i as f64).sin(), (i * i % 7) as f64))
                .collect();
            let open = solve(&lower, &diagonal, &upper, right.clone());
            assert!(residual(&lower, &diagonal, &upper, &right, &open, false) < 1e-13);
            let cyclic = solve_cyclic(&lower, &diagonal, &upper, right.clone());
            assert!(residual(&lower, &diagonal, &upper, &right, &cyclic, true) < 1e-13);
        }
    }
}
