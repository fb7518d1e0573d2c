//! Lancaster's two spaces of a cubic: graph space, its control points, and equation space, its power coefficients.
//!
//! Don Lancaster, "Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines" (2005): x = At³ + Bt² + Ct + D with
//! A = x3 - 3x2 + 3x1 - x0, B = 3x2 - 6x1 + 3x0, C = 3x1 - 3x0, D = x0, and the same for y with E, F, G, H.

/// The equation-space coefficients [A, B, C, D] of one coordinate of the control points: two of a line, three of a quadratic,
/// four of a cubic. What a curve of lower degree lacks is 0.
#[must_use]
pub fn coefficients(points: &[f64]) -> [f64; 4] {
    match *points {
        [] => [0.0; 4],
        [x0] => [0.0, 0.0, 0.0, x0],
        [x0, x1] => [0.0, 0.0, x1 - x0, x0],
        [x0, x1, x2] => [0.0, (x2 - x1) - (x1 - x0), 2.0 * (x1 - x0), x0],
        [x0, x1, x2, x3, ..] => {
            let (d1, d2, d3) = (x1 - x0, x2 - x1, x3 - x2);
            [(d3 - d2) - (d2 - d1), 3.0 * (d2 - d1), 3.0 * d1, x0]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_quarter_is_as_lancaster_writes_it() {
        // x = (3x1 - 2) t³ + (3 - 6x1) t² + 3x1 t for the points 0, x1, 1, 1.
        let x1 = 0.5;
        assert_eq!(
            coefficients(&[0.0, x1, 1.0, 1.0]),
            [3.0 * x1 - 2.0, 3.0 - 6.0 * x1, 3.0 * x1, 0.0]
        );
    }
}
