//! `lancaster-best` and `lancaster-drawellipse`: the magic numbers of Don Lancaster, "Approximating a Circle or an Ellipse
//! Using Four Bezier Cubic Splines" (2005).

use crate::error::{MethodError, Remedy, Result};

use super::{Method, Span};

/// His table of best magic numbers: (segments to the circle, handle).
pub(super) const BEST: [(u32, f64); 6] = [
    (2, 1.333_333),
    (3, 0.769_811_2),
    (4, 0.551_784),
    (5, 0.433_072),
    (6, 0.357_204_5),
    (8, 0.265_203_1),
];

/// The number of his PostScript: `/magic 0.55228475 0.00045 sub store % improved value`.
pub(super) const DRAWELLIPSE: f64 = 0.551_834_75;

/// The number of his table for segments of this angle.
pub(super) fn best(span: &Span) -> Result<f64> {
    BEST.iter()
        .find(|&&(count, _)| span.is_about(360.0 / f64::from(count)))
        .map(|&(_, handle)| handle)
        .ok_or_else(|| {
            let counts = BEST.map(|(count, _)| count as usize).to_vec();
            let remedy = Remedy::Segments(counts.clone(), &["midpoint", "minimax"]);
            let degrees = span.degrees();
            Method::LancasterBest.refuse(MethodError::Table { degrees, counts }, remedy)
        })
}
