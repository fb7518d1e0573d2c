//! The nearest point of an ellipse.

use kurbo::Vec2;

/// The nearest point of an ellipse, described by what is needed of it.
pub(crate) struct Foot {
    /// From there to the point, positive outside.
    pub(crate) distance: f64,
    /// The unit normal there, outward.
    pub(crate) outward: Vec2,
}

/// The most steps of Newton's method; beside the evolute's cusp the start may be off by a factor of 1e8, and each step gains half.
const MOST_STEPS: usize = 100;

/// The nearest point of the ellipse of these radii about the origin, its axes along the coordinates'.
///
/// For x²/a² + y²/b² = 1 with a >= b it is (a²x/(a²+s), b²y/(b²+s)) with s the largest root of
/// (ax/(a²+s))² + (by/(b²+s))² = 1 (Eberly, "Distance from a Point to an Ellipse"), and the arm from there to the point is s times
/// (x/(a²+s), y/(b²+s)). The left side falls and is convex, so that Newton's method converges from the left of the root.
/// The unknown here is w = b² + s, which keeps its digits where s nears the pole, close to the long axis.
pub(crate) fn foot(radii: Vec2, p: Vec2) -> Foot {
    let scale = radii.x.max(radii.y);
    let swap = radii.x < radii.y;
    let in_order = |v: Vec2| if swap { Vec2::new(v.y, v.x) } else { v };
    let Vec2 { x: a, y: b } = in_order(radii) / scale;
    let Vec2 { x, y } = in_order(p) / scale;
    // On an axis the root lies at a pole; beside it, it does not.
    let (x, y) = (x.abs().max(1e-150), y.abs().max(1e-150));
    let apart = (a - b) * (a + b);
    let (ax, by) = (a * x, b * y);
    let least = by.max(ax - apart);
    // Close to the ellipse s is about 0; one step from there leads to the left of the root, or beyond `least`.
    let mut w = least.max(b * b);
    for _ in 0..MOST_STEPS {
        let (u, v) = (ax / (w + apart), by / w);
        let step = (u * u + v * v - 1.0) / (2.0 * (u * u / (w + apart) + v * v / w));
        let next = (w + step).max(least);
        let change = (next - w).abs();
        w = next;
        // The digits double with each step.
        if change <= 1e-9 * w {
            break;
        }
    }
    let arm = Vec2::new(x / (w + apart), y / w);
    let length = arm.hypot();
    let unit = in_order(arm / length);
    Foot {
        distance: (w - b * b) * length * scale,
        outward: Vec2::new(unit.x.copysign(p.x), unit.y.copysign(p.y)),
    }
}

/// The nearest point of an ellipse, and how the ellipse bends there.
pub(crate) struct BentFoot {
    pub(crate) foot: Foot,
    /// The curvature of the ellipse.
    pub(crate) curvature: f64,
}

/// How far a point may lie from the ellipse for [`foot_by_excess`], in units of the radius of curvature beside it.
const NEAR: f64 = 0.25;

/// The same for a point near the ellipse of which `excess`, (x/a)² + (y/b)² - 1, is known with more digits than the point itself
/// has: the distance then has them too.
///
/// The equation of [`foot`] less the excess is free of cancellation: with u = s/a² and v = s/b² it is
/// (x/a)² u (2 + u)/(1 + u)² + (y/b)² v (2 + v)/(1 + v)². Sampson's distance is the start. `None` where the point is not near.
pub(crate) fn foot_by_excess(radii: Vec2, p: Vec2, excess: f64) -> Option<BentFoot> {
    let scale = radii.x.max(radii.y);
    let (a, b) = (radii.x / scale, radii.y / scale);
    let (alpha, beta) = (1.0 / (a * a), 1.0 / (b * b));
    let (x, y) = (p.x / scale, p.y / scale);
    let (xx, yy) = (x * x * alpha, y * y * beta);
    let mut s = excess / (2.0 * (xx * alpha + yy * beta));
    if s.is_nan() || s.abs() * alpha.max(beta) > NEAR {
        return None;
    }
    for _ in 0..MOST_STEPS {
        let (u, v) = (s * alpha, s * beta);
        let (m, n) = (1.0 / (1.0 + u), 1.0 / (1.0 + v));
        let (xm, yn) = (xx * m * m, yy * n * n);
        let rest = excess - xm * u * (2.0 + u) - yn * v * (2.0 + v);
        let step = rest / (2.0 * (xm * m * alpha + yn * n * beta));
        s += step;
        if step.abs() <= 1e-9 * s.abs() {
            break;
        }
    }
    let arm = Vec2::new(x * alpha / (1.0 + s * alpha), y * beta / (1.0 + s * beta));
    let length = arm.hypot();
    Some(BentFoot {
        foot: Foot {
            distance: s * length * scale,
            outward: arm / length,
        },
        // G of the foot is |arm|², and the curvature 1/(a² b² G^(3/2)).
        curvature: alpha * beta / (length * length * length * scale),
    })
}
