//! The cubics with free tangents and the quadratics.

use super::bezier::sector_area;
use super::methods::{UnitArc, outward_surplus};
use super::real::{Point, Real, abs, int, norm, pi, power_of_two, ratio};
use super::solve::root;

impl UnitArc {
    /// The symmetric cubic `x = x0 + x2 tau^2, y = y1 tau + y3 tau^3` about the x-axis, with
    /// tau = -1..1, turned so that it starts on the positive x-axis; given are `[x0, x2]` and
    /// `[y1, y3]`. The second control point is the polar form at (-1, -1, 1).
    fn about_the_bisector(&self, x: [&Real; 2], y: [&Real; 2]) -> Vec<Point> {
        let third = ratio(1, 3);
        let p = x[0] - x[1] * &third;
        let q = y[1] - y[0] * &third;
        let second = [
            &p * &self.cos_half - &q * &self.sin_half,
            &p * &self.sin_half + &q * &self.cos_half,
        ];
        let radius = norm(&[x[0] + x[1], y[0] + y[1]]);
        self.symmetric(&radius, second)
    }

    /// Free ends and free tangents: `|p|^2 = 1 + R^2 + 2R T6(tau)`, so that r swings between 1 - R
    /// and 1 + R, seven times. With `q^2 = R` the coefficients of `tau^0` and `tau^6` give
    /// `x0 = 1 - R` and `y3 = -8q`, the ends `x0 + x2 = (1 + R) cos h` and
    /// `y1 + y3 = (1 + R) sin h`. Left is that of `tau^2`: `2 x0 x2 + y1^2 = 36R`.
    pub(super) fn minimax_g0_free(&self) -> Vec<Point> {
        let parts = |q: &Real| {
            let r = q * q;
            let x0 = int(1) - &r;
            let x2 = (int(1) + &r) * &self.cos_half - &x0;
            let y1 = (int(1) + &r) * &self.sin_half + q * int(8);
            (x0, x2, y1, r)
        };
        // q is about h^3/64 for a small angle, less for a large one.
        let guess = self.cube_of_half() * ratio(1, 64);
        let equation = |q: &Real| {
            let (x0, x2, y1, r) = parts(q);
            x0 * x2 * int(2) + &y1 * &y1 - r * int(36)
        };
        let q = root(equation, &int(0), &(&guess * ratio(3, 2)));
        let (x0, x2, y1, _) = parts(&q);
        self.about_the_bisector([&x0, &x2], [&y1, &(q * int(-8))])
    }

    /// `h^3`.
    fn cube_of_half(&self) -> Real {
        &self.a * &self.a * &self.a * ratio(1, 8)
    }

    /// Ends on the circle and free tangents: `|p|^2 = 1 + R^2 + 2R T6(tau / sqrt w)`, with w > 1
    /// such that the ends, which are no extremes now, have radius 1. With `y3 = -v` the
    /// coefficients of `tau^0` and `tau^6` give `x0 = 1 - R` and `R = v^2 w^3 / 64`, the ends
    /// `x0 + x2 = cos h` and `y1 = sin h + v`. Left are those of `tau^2` and `tau^4`, by Newton's
    /// method: `2 x0 x2 + y1^2 = 36R / w` and `x2^2 - 2 v y1 = -96R / w^2`.
    pub(super) fn minimax_g0(&self) -> Vec<Point> {
        let mut v = self.cube_of_half() * ratio(1, 8);
        // For a tiny R the ends are zeros of T6, and v is h^3/8.
        let zero = (pi() * ratio(1, 12)).cos();
        let mut w = int(1) / (&zero * &zero);
        for _ in 0..60 {
            let (dv, dw) = self.minimax_g0_step(&v, &w);
            v += &dv;
            w += &dw;
            let small = abs(&dv) < &v * power_of_two(-100) && abs(&dw) < power_of_two(-60);
            if small {
                break;
            }
        }
        let x0 = int(1) - &v * &v * &w * &w * &w * ratio(1, 64);
        let x2 = &self.cos_half - &x0;
        let y1 = &self.sin_half + &v;
        self.about_the_bisector([&x0, &x2], [&y1, &-v])
    }

    /// One step of Newton's method on the two equations of [`Self::minimax_g0`].
    fn minimax_g0_step(&self, v: &Real, w: &Real) -> (Real, Real) {
        let r = v * v * w * w * w * ratio(1, 64);
        let (r_v, r_w) = (&r * int(2) / v, &r * int(3) / w);
        let x0 = int(1) - &r;
        let x2 = &self.cos_half - &x0;
        let y1 = &self.sin_half + v;
        let w2 = w * w;
        let first = &x0 * &x2 * int(2) + &y1 * &y1 - &r * int(36) / w;
        let second = &x2 * &x2 - v * &y1 * int(2) + &r * int(96) / &w2;
        let by_r = (&x0 - &x2) * int(2) - int(36) / w;
        let first_v = &by_r * &r_v + &y1 * int(2);
        let first_w = by_r * &r_w + &r * int(36) / &w2;
        let by_r = &x2 * int(2) + int(96) / &w2;
        let second_v = &by_r * r_v - (&y1 + v) * int(2);
        let second_w = by_r * r_w - r * int(192) / (w2 * w);
        let determinant = &first_v * &second_w - &first_w * &second_v;
        (
            (&second * &first_w - &first * &second_w) / &determinant,
            (&first * &second_v - &second * &first_v) / &determinant,
        )
    }

    /// The quadratic with its second control point at radius m on the bisector.
    pub(super) fn quadratic(&self, m: &Real) -> Vec<Point> {
        let middle = [&self.cos_half * m, &self.sin_half * m];
        vec![[int(1), int(0)], middle, self.end(&int(1))]
    }

    /// `r(1/2) = (cos h + m) / 2 = 1`.
    pub(super) fn quadratic_midpoint(&self) -> Real {
        int(2) - &self.cos_half
    }

    /// The area of the sector is a/2; it is linear in m.
    pub(super) fn quadratic_area(&self) -> Real {
        let without = sector_area(&self.quadratic(&int(0)));
        let with = sector_area(&self.quadratic(&int(1)));
        (&self.a * ratio(1, 2) - &without) / (with - &without)
    }

    /// Equal largest distances outside and inside. The midpoint curve lies inside, that of equal
    /// area farther out than in.
    pub(super) fn quadratic_minimax(&self) -> Real {
        root(
            |m| outward_surplus(&self.quadratic(m)),
            &self.quadratic_midpoint(),
            &self.quadratic_area(),
        )
    }

    /// Free ends: `|p|^2 = 1 + R^2 + 2R T4(tau)` for `x = x0 + x2 tau^2`, `y = y1 tau`. With
    /// `q^2 = R` the coefficients of `tau^0` and `tau^4` give `x0 = 1 + R` and `x2 = -4q`, and the
    /// ends `x0 + x2 = (1 + R) cos h`: `(1 - cos h) (1 + q^2) = 4q`.
    pub(super) fn quadratic_minimax_free(&self) -> Vec<Point> {
        let quarter = (&self.a * ratio(1, 4)).sin();
        let versine = &quarter * &quarter * int(2);
        let q = &versine / (int(2) + (int(4) - &versine * &versine).sqrt());
        let radius = int(1) + &q * &q;
        let m = &radius + &q * int(4);
        let middle = [&self.cos_half * &m, &self.sin_half * &m];
        vec![[radius.clone(), int(0)], middle, self.end(&radius)]
    }
}
