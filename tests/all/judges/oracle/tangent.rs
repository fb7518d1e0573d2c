//! The handles of the cubics whose ends and end tangents are those of the circle.

use super::bezier::{Powers, arc_length, sector_area, squared_extremes, unit_circle_crossings};
use super::methods::{UnitArc, outward_surplus};
use super::real::{Point, Real, abs, cross, dot, int, norm, parse, radians, ratio};
use super::solve::{integrate, root};

impl UnitArc {
    /// The handle between those of `curvature` and `midpoint` at which f is 0. The first segment
    /// lies inside the circle, the second outside, and every segment between them crosses it.
    fn between(&self, f: impl FnMut(&Real) -> Real) -> Real {
        root(f, &self.curvature(), &self.midpoint())
    }

    /// `r(1/2) = cos h + (3/4) k sin h = 1`.
    pub(super) fn midpoint(&self) -> Real {
        // (1 - cos h) / sin h = tan(h/2), without loss.
        (&self.a * ratio(1, 4)).tan() * ratio(4, 3)
    }

    /// The curvature at the ends, `2 (1 - c - k s) / (3 k^2)`, is 1: `3k^2 + 2ks - 2(1 - c) = 0`.
    pub(super) fn curvature(&self) -> Real {
        let versine = self.versine();
        let root = (&self.sin * &self.sin + &versine * int(6)).sqrt();
        versine * int(2) / (&self.sin + root)
    }

    /// `1 - cos a`.
    fn versine(&self) -> Real {
        &self.sin_half * &self.sin_half * int(2)
    }

    /// Equal largest distances outside and inside.
    pub(super) fn minimax(&self) -> Real {
        self.between(|k| outward_surplus(&self.tangent(k)))
    }

    /// Equal largest values of `r^2 - 1` and `1 - r^2`.
    pub(super) fn goldapp(&self) -> Real {
        self.between(|k| {
            let (high, low) = squared_extremes(&self.tangent(k));
            high + low
        })
    }

    /// The joint of equal segments as a graph x = f(y) has f''' = 0 (Apprich):
    /// `x'''(0) y'(0) = 3 x''(0) y''(0)`, with x'' = 6(c + ks - 1), x''' = 6(2 - 2c - 3ks),
    /// y' = 3k, y'' = 6(s - kc - 2k). That is
    /// `3s (3 + 2c) k^2 - 2 (1 - c) (8 + 6c) k + 6s (1 - c) = 0`: both roots, the smaller first.
    pub(super) fn apprich(&self) -> (Real, Real) {
        let (s, c) = (&self.sin, &self.cos);
        let versine = self.versine();
        let leading = s * (int(3) + c * int(2)) * int(3);
        let half_middle = &versine * (int(8) + c * int(6));
        let last = &versine * s * int(6);
        let root = (&half_middle * &half_middle - &leading * &last).sqrt();
        (
            last / (&half_middle + &root),
            (half_middle + root) / leading,
        )
    }

    /// The area of the sector is a/2.
    pub(super) fn area(&self) -> Real {
        self.between(|k| sector_area(&self.tangent(k)) - &self.a * ratio(1, 2))
    }

    /// The length of the segment is a.
    pub(super) fn length(&self) -> Real {
        self.between(|k| arc_length(&self.tangent(k)) - &self.a)
    }

    /// The derivative by k of the integral of `|r - 1| dt` is 0. At a fixed t, dr/dk is
    /// `p . q / r` with q = dp/dk.
    pub(super) fn mean(&self) -> Real {
        self.between(|k| self.over_the_crossings(k, |p, _, q| dot(p, q) / norm(p)))
    }

    /// The derivative by k of the integral of `|r - 1| d(theta)` is 0. At a fixed theta, dr/dk is
    /// `r_k - r_t theta_k / theta_t`, and times `d(theta) = theta_t dt` that is `(q x p') / r dt`.
    pub(super) fn mean_angle(&self) -> Real {
        self.between(|k| self.over_the_crossings(k, |p, velocity, q| cross(q, velocity) / norm(p)))
    }

    /// The integral of `f(p, p', q)` where the segment lies outside the circle, less that where it
    /// lies inside.
    fn over_the_crossings(&self, k: &Real, f: impl Fn(&Point, &Point, &Point) -> Real) -> Real {
        let points = self.tangent(k);
        let (curve, change) = (Powers::new(&points), self.change_by_handle());
        let velocity = curve.derivative();
        let places = unit_circle_crossings(&points);
        let mut sum = int(0);
        for w in places.windows(2) {
            let part = integrate(
                &|t| f(&curve.at(t), &velocity.at(t), &change.at(t)),
                &w[0],
                &w[1],
            );
            // Not the middle of the panel: the segment may touch the circle there.
            let inner = curve.at(&(&w[0] + (&w[1] - &w[0]) * ratio(1, 3)));
            if dot(&inner, &inner) > int(1) {
                sum += part;
            } else {
                sum -= part;
            }
        }
        sum
    }

    /// dp/dk, a cubic too: control points 0, (0, 1), (s, -c), 0.
    fn change_by_handle(&self) -> Powers {
        let zero = [int(0), int(0)];
        let third = [self.sin.clone(), -&self.cos];
        Powers::new(&[zero.clone(), [int(0), int(1)], third, zero])
    }

    /// The derivative by k of the integral of `(r - 1)^2 dt` is 0:
    /// that of `(r - 1) p . q / r`, and `r - 1 = (r^2 - 1) / (r + 1)`.
    pub(super) fn rms(&self) -> Real {
        let change = self.change_by_handle();
        self.between(|k| {
            let curve = Powers::new(&self.tangent(k));
            let slope = |t: &Real| {
                let p = curve.at(t);
                let square = dot(&p, &p);
                let r = square.sqrt();
                (square - int(1)) * dot(&p, &change.at(t)) / (&r * (&r + int(1)))
            };
            integrate(&slope, &int(0), &int(1))
        })
    }

    /// Chen's Formulation I on a closed, evenly spaced spline: `D_0 + 4 D_1 + D_2 = 3 (P_2 - P_0)` with
    /// tangents of one length d gives `d (4 + 2c) = 6 s`; the handle is d/3.
    pub(super) fn chen_uniform(&self) -> Real {
        &self.sin / (int(2) + &self.cos)
    }

    /// Chen's Formulation II: the parameter runs to t = 3k, the length of the curve itself. The
    /// curve of a handle of a third of the chord is longer than the chord, that of a/3 shorter
    /// than a.
    pub(super) fn chen_length(&self) -> Real {
        let low = &self.sin_half * ratio(2, 3);
        let high = &self.a / int(3);
        root(|k| arc_length(&self.tangent(k)) - k * int(3), &low, &high)
    }

    /// Lancaster's table.
    pub(super) fn lancaster_best(&self) -> Option<Real> {
        let table = [
            (180, "1.333333"),
            (120, "0.7698112"),
            (90, "0.551784"),
            (72, "0.433072"),
            (60, "0.3572045"),
            (45, "0.2652031"),
        ];
        let row = table.iter().find(|(degrees, _)| self.is(*degrees))?;
        Some(parse(row.1))
    }

    /// Lancaster's PostScript procedure.
    pub(super) fn lancaster_drawellipse(&self) -> Option<Real> {
        let handle = parse("0.55228475") - parse("0.00045");
        self.is(90).then_some(handle)
    }

    /// Whether this is the arc of so many degrees.
    fn is(&self, degrees: i32) -> bool {
        abs(&(&self.a - radians(&int(degrees)))) < parse("1e-12")
    }
}
