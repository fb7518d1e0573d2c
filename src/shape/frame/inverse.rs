//! Maps taken back.

use super::{differences, dot};
use crate::numeric::double::{Double, Twice, cross};

/// The inverse of an affine map.
#[derive(Clone, Copy)]
pub(super) struct Inverse {
    moved: Twice,
    /// The rows of the matrix.
    rows: [Twice; 2],
    /// The map's own matrix, by columns.
    pub(super) forth: [Twice; 2],
}

impl Inverse {
    pub(super) fn new([a, b, c, d, e, f]: [Double; 6]) -> Self {
        let area = cross([a, b], [c, d]);
        let over = |x: Double| x.divided(area);
        Self {
            moved: [e, f],
            rows: [
                [over(d), over(c.scaled(-1.0))],
                [over(b.scaled(-1.0)), over(a)],
            ],
            forth: [[a, b], [c, d]],
        }
    }

    #[inline(always)]
    pub(super) fn point(&self, p: Twice) -> Twice {
        let v = differences(p, self.moved);
        self.rows.map(|row| dot(row, v))
    }
}
