//! Linear equations, a few of them.

/// The solution of the equations whose rows these are, by Gaussian elimination with the largest pivot of each column; `None` where they
/// do not determine the unknowns.
pub(crate) fn solve<const N: usize>(
    mut rows: [[f64; N]; N],
    mut right: [f64; N],
) -> Option<[f64; N]> {
    for i in 0..N {
        let size = |row: &[f64; N]| row[i].abs();
        let best = (i..N).max_by(|&j, &k| size(&rows[j]).total_cmp(&size(&rows[k])))?;
        rows.swap(i, best);
        right.swap(i, best);
        let (pivot, value) = (rows[i], right[i]);
        if pivot[i] == 0.0 || !pivot[i].is_finite() {
            return None;
        }
        for (j, row) in rows.iter_mut().enumerate().filter(|(j, _)| *j != i) {
            let part = row[i] / pivot[i];
            for (entry, above) in row.iter_mut().zip(pivot) {
                *entry -= part * above;
            }
            right[j] -= part * value;
        }
    }
    for (i, (unknown, row)) in right.iter_mut().zip(rows).enumerate() {
        *unknown /= row[i];
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_that_begin_with_a_zero_are_solved_and_dependent_ones_are_not() {
        let rows = [[0.0, 2.0, 1.0], [1.0, 0.0, 3.0], [4.0, 1.0, 0.0]];
        let unknowns = [2.0, -3.0, 5.0];
        let right = rows.map(|row| {
            let products = row.iter().zip(unknowns).map(|(a, x)| a * x);
            products.sum()
        });
        let found = solve(rows, right).unwrap();
        let miss = |(x, y): (f64, f64)| (x - y).abs();
        assert!(found.into_iter().zip(unknowns).map(miss).all(|d| d < 1e-14));
        assert_eq!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
    }
}
