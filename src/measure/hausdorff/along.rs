//! How far a part of a cubic lies at most from the way along another one.

use kurbo::{CubicBez, ParamCurve as _, ParamCurveDeriv as _, Point, Vec2};

/// The bound of |a(s) - b(f(s))|, f from u0 to u1.
pub(crate) fn along(a: &CubicBez, b: &CubicBez, [u0, u1]: [f64; 2]) -> f64 {
    let (low, high) = (u0.min(u1), u0.max(u1));
    let (velocities, accelerations) = (b.deriv(), b.deriv().deriv());
    let slope = |u: f64, at: Point, velocity: Vec2| {
        let first = velocities.eval(u).to_vec2();
        let second = accelerations.eval(u).to_vec2();
        let below = first.hypot2() - (at - b.eval(u)).dot(second);
        if below > 1e-6 * first.hypot2() {
            velocity.dot(first) / below
        } else {
            u1 - u0
        }
    };
    let inner = [
        u0 + slope(u0, a.p0, 3.0 * (a.p1 - a.p0)) / 3.0,
        u1 - slope(u1, a.p3, 3.0 * (a.p3 - a.p2)) / 3.0,
    ]
    .map(|u| u.clamp(low, high));
    // Bernstein coefficients times their binomials: products are convolutions.
    let f = [u0, 3.0 * inner[0], 3.0 * inner[1], u1];
    let g = [
        1.0 - u0,
        3.0 * (1.0 - inner[0]),
        3.0 * (1.0 - inner[1]),
        1.0 - u1,
    ];
    let (ff, gg): ([f64; 7], [f64; 7]) = (product(&f, &f), product(&g, &g));
    let weights: [[f64; 10]; 4] = [
        product(&gg, &g),
        product(&gg, &f).map(|w| 3.0 * w),
        product(&ff, &g).map(|w| 3.0 * w),
        product(&ff, &f),
    ];
    let mut apart = [[0.0; 10]; 2];
    for (axis, apart) in apart.iter_mut().enumerate() {
        let of = |p: Point| {
            let v = p - a.p0;
            if axis == 0 { v.x } else { v.y }
        };
        let raised: [f64; 10] = product(
            &[of(a.p0), 3.0 * of(a.p1), 3.0 * of(a.p2), of(a.p3)],
            &[1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0],
        );
        for (k, apart) in apart.iter_mut().enumerate() {
            let points = [b.p0, b.p1, b.p2, b.p3].map(of);
            let there: f64 = weights.iter().zip(points).map(|(w, p)| w[k] * p).sum();
            *apart = there - raised[k];
        }
    }
    let squares: [[f64; 19]; 2] = apart.map(|x| product(&x, &x));
    let mut binomial = 1.0;
    let mut largest = 0.0_f64;
    for (k, (x, y)) in squares[0].iter().zip(&squares[1]).enumerate() {
        largest = largest.max((x + y) / binomial);
        binomial = binomial * (18 - k) as f64 / (k + 1) as f64;
    }
    largest.sqrt()
}

/// The convolution, whose length is that of both together less one.
pub(crate) fn product<const N: usize>(a: &[f64], b: &[f64]) -> [f64; N] {
    let mut out = [0.0; N];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::Affine;

    const CURVE: CubicBez = CubicBez {
        p0: Point::new(0.0, 0.0),
        p1: Point::new(0.25, 0.5),
        p2: Point::new(0.75, 0.5),
        p3: Point::new(1.0, 0.25),
    };

    /// The curve's normal, and the point that lies so far along it.
    fn beside(u: f64, distance: f64) -> (Vec2, Point) {
        let normal = CURVE.deriv().eval(u).to_vec2().turn_90().normalize();
        (normal, CURVE.eval(u) + distance * normal)
    }

    /// A part of the curve's parallel, by a cubic with its ends and its tangents, and how far that is bounded.
    fn parallel(distance: f64, [u0, u1]: [f64; 2], scale: f64) -> f64 {
        let ((n0, p0), (n1, p3)) = (beside(u0, distance), beside(u1, distance));
        let handle = p0.distance(p3) / (3.0 * (0.5 * n0.cross(n1).asin()).cos());
        let a = CubicBez::new(
            p0,
            p0 - handle * n0.turn_90(),
            p3 + handle * n1.turn_90(),
            p3,
        );
        let map = Affine::scale(scale);
        along(&(map * a), &(map * CURVE), [u0, u1])
    }

    #[test]
    fn the_bound_nears_the_distance_as_the_fourth_power_of_the_length() {
        for distance in [-0.25, -0.1, 0.1, 0.25] {
            for h in [0.2, 0.1, 0.05, 0.025] {
                let over = parallel(distance, [0.0, h], 1.0) - f64::abs(distance);
                assert!(over <= 0.1 * h.powi(4) + 1e-15, "{distance} {h}: {over}");
            }
        }
    }

    #[test]
    fn the_bound_is_as_many_times_as_large_as_the_curves() {
        for distance in [-0.25, -0.1, 0.1, 0.25] {
            let bound = parallel(distance, [0.3, 0.4], 1.0);
            for scale in [1.0 / 4096.0, 4096.0] {
                assert_eq!(parallel(distance, [0.3, 0.4], scale), scale * bound);
            }
        }
    }

    #[test]
    fn beyond_the_centre_of_curvature_the_parameters_run_evenly() {
        let moved = Affine::translate((0.0, -100.0));
        for (u0, u1) in [(0.25, 0.75), (0.125, 0.5)] {
            let part = moved * CURVE.subsegment(u0..u1);
            let back = CubicBez::new(part.p3, part.p2, part.p1, part.p0);
            for found in [
                along(&part, &CURVE, [u0, u1]),
                along(&back, &CURVE, [u1, u0]),
            ] {
                assert!((found - 100.0).abs() < 1e-12, "{u0} {u1}: {found}");
            }
        }
    }
}
