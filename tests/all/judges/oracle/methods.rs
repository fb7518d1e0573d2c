//! The 28 methods, each from the property that defines it.

use super::bezier::radial_extremes;
use super::real::{Point, Real, int, norm, parse, pi, ratio, sign};

/// What a method draws for one angle.
#[derive(Debug, Clone)]
pub struct Oracle {
    /// Control points, 4 or 3, of the arc from (1, 0) to (cos a, sin a). The methods whose ends
    /// leave the circle start at (`end_radius`, 0).
    pub points: Vec<Point>,
    /// The distance of the second control point from the first.
    pub handle: Option<Real>,
    /// The distance of both ends from the center.
    pub end_radius: Real,
    /// The largest distance outside the circle, at least 0.
    pub outward: Real,
    /// The largest distance inside the circle, at least 0.
    pub inward: Real,
}

/// The ids of all methods.
pub const IDS: [&str; 28] = [
    "midpoint",
    "minimax",
    "goldapp",
    "curvature",
    "apprich",
    "apprich-plus",
    "area",
    "length",
    "mean",
    "mean-angle",
    "rms",
    "chen-1",
    "chen-2",
    "chen-3",
    "lancaster-best",
    "lancaster-drawellipse",
    "minimax-g0",
    "minimax-ellipse",
    "minimax-free",
    "minimax-ellipse-free",
    "apprich-scaled",
    "curvature-scaled",
    "minimax-g0-free",
    "quadratic-tangent",
    "quadratic-midpoint",
    "quadratic-area",
    "quadratic-minimax",
    "quadratic-minimax-free",
];

/// The segment of a method for an angle in radians, or nothing where the method is not defined:
/// beyond pi (2 pi/3 for the three of Apprich), and for Lancaster away from his own angles.
pub fn method(id: &str, angle: &Real) -> Option<Oracle> {
    let arc = UnitArc::new(angle);
    if !arc.admits(id) {
        return None;
    }
    let points = arc.points(id)?;
    let (outward, inward) = radial_extremes(&points, [int(0), int(0)], &int(1));
    let arm = [&points[1][0] - &points[0][0], &points[1][1] - &points[0][1]];
    Some(Oracle {
        handle: Some(norm(&arm)),
        end_radius: norm(&points[0]),
        points,
        outward,
        inward,
    })
}

/// The unit arc of an angle a, with h = a/2.
pub(super) struct UnitArc {
    pub(super) a: Real,
    pub(super) sin: Real,
    pub(super) cos: Real,
    pub(super) sin_half: Real,
    pub(super) cos_half: Real,
}

impl UnitArc {
    fn new(angle: &Real) -> Self {
        let (sin, cos) = angle.sin_cos();
        let (sin_half, cos_half) = (angle * ratio(1, 2)).sin_cos();
        Self {
            a: angle.clone(),
            sin,
            cos,
            sin_half,
            cos_half,
        }
    }

    /// Whether the method is defined here. An angle may be an `f64`, hence a little beyond the
    /// limit that it stands for.
    fn admits(&self, id: &str) -> bool {
        let slack = parse("1e-12");
        let below = |limit: Real| self.a <= limit + &slack;
        sign(&self.a) > 0
            && match id {
                "apprich" | "apprich-plus" | "apprich-scaled" => below(pi() * ratio(2, 3)),
                // Not at pi itself: the handle is 0 there, or infinite.
                "chen-1" | "quadratic-tangent" => self.a < pi() - slack,
                _ => below(pi()),
            }
    }

    /// The control points of a method.
    fn points(&self, id: &str) -> Option<Vec<Point>> {
        Some(match id {
            "midpoint" => self.tangent(&self.midpoint()),
            "minimax" | "minimax-ellipse" => self.tangent(&self.minimax()),
            "goldapp" => self.tangent(&self.goldapp()),
            "curvature" => self.tangent(&self.curvature()),
            "apprich" => self.tangent(&self.apprich().0),
            "apprich-plus" => self.tangent(&self.apprich().1),
            "area" => self.tangent(&self.area()),
            "length" => self.tangent(&self.length()),
            "mean" => self.tangent(&self.mean()),
            "mean-angle" => self.tangent(&self.mean_angle()),
            "rms" => self.tangent(&self.rms()),
            "chen-1" => self.tangent(&self.chen_uniform()),
            "chen-2" => self.tangent(&self.chen_length()),
            "chen-3" => self.tangent(&(&self.a / int(3))),
            "lancaster-best" => self.tangent(&self.lancaster_best()?),
            "lancaster-drawellipse" => self.tangent(&self.lancaster_drawellipse()?),
            "minimax-g0" => self.minimax_g0(),
            "minimax-free" | "minimax-ellipse-free" => balanced(&self.tangent(&self.midpoint())),
            "apprich-scaled" => balanced(&self.tangent(&self.apprich().0)),
            "curvature-scaled" => balanced(&self.tangent(&self.curvature())),
            "minimax-g0-free" => self.minimax_g0_free(),
            "quadratic-tangent" => self.quadratic(&(int(1) / &self.cos_half)),
            "quadratic-midpoint" => self.quadratic(&self.quadratic_midpoint()),
            "quadratic-area" => self.quadratic(&self.quadratic_area()),
            "quadratic-minimax" => self.quadratic(&self.quadratic_minimax()),
            "quadratic-minimax-free" => self.quadratic_minimax_free(),
            _ => return None,
        })
    }

    /// The point at a radius on the ray of the arc's end.
    pub(super) fn end(&self, radius: &Real) -> Point {
        [&self.cos * radius, &self.sin * radius]
    }

    /// The cubic with the end radius and the second control point given, symmetric about the
    /// bisector.
    pub(super) fn symmetric(&self, radius: &Real, second: Point) -> Vec<Point> {
        let [x, y] = &second;
        let third = [x * &self.cos + y * &self.sin, x * &self.sin - y * &self.cos];
        let start = [radius.clone(), int(0)];
        vec![start, second, third, self.end(radius)]
    }

    /// The G1 cubic with handle k.
    pub(super) fn tangent(&self, k: &Real) -> Vec<Point> {
        self.symmetric(&int(1), [int(1), k.clone()])
    }
}

/// The largest distance outside the unit circle less that inside.
pub(super) fn outward_surplus(points: &[Point]) -> Real {
    let (outward, inward) = radial_extremes(points, [int(0), int(0)], &int(1));
    outward - inward
}

/// All points times one factor, such that the largest distances outside and inside are equal:
/// `rho (1 + outward) - 1 = 1 - rho (1 - inward)`.
fn balanced(points: &[Point]) -> Vec<Point> {
    let factor = int(2) / (int(2) + outward_surplus(points));
    let scaled = points.iter().map(|[x, y]| [x * &factor, y * &factor]);
    scaled.collect()
}
