//! Lancaster's two spaces of a cubic: graph space, its control points, and equation space, its power coefficients.
//!
//! Don Lancaster, "Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines" (2005): x = At³ + Bt² + Ct + D with
//! A = x3 - 3x2 + 3x1 - x0, B = 3x2 - 6x1 + 3x0, C = 3x1 - 3x0, D = x0, and the same for y with E, F, G, H.

/// The equation-space coefficients [A, B, C, D] of the graph-space coordinates [x0, x1, x2, x3].
#[must_use]
pub fn coefficients([x0, x1, x2, x3]: [f64; 4]) -> [f64; 4] {
    let (d1, d2, d3) = (x1 - x0, x2 - x1, x3 - x2);
    [(d3 - d2) - (d2 - d1), 3.0 * (d2 - d1), 3.0 * d1, x0]
}
