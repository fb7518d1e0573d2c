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
    foot_and_multiplier(radii, p).0
}

/// The same, and s over the square of the larger radius.
fn foot_and_multiplier(radii: Vec2, p: Vec2) -> (Foot, f64) {
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
    let multiplier = w - b * b;
    let foot = Foot {
        distance: multiplier * length * scale,
        outward: Vec2::new(unit.x.copysign(p.x), unit.y.copysign(p.y)),
    };
    (foot, multiplier)
}

/// The nearest point of an ellipse to a point of which more is known than its coordinates say.
pub(crate) struct FootByExcess {
    pub(crate) foot: Foot,
    /// The root s of the equation of [`foot`], over the square of the larger radius.
    pub(crate) multiplier: f64,
    /// Whether the distance has the digits of the excess, and not those of the coordinates only.
    pub(crate) is_exact: bool,
}

/// Up to this part of the smallest radius of curvature Sampson's distance is a start for Newton's method.
const NEAR: f64 = 0.25;

/// Beside the pole s = -b², where the nearest point jumps from one side of the long axis to the other, 1 + s/b² has no digits left.
const FROM_POLE: f64 = 0.1;

/// How far the excess may differ from what the coordinates say.
const RIGHT: f64 = 1e-6;

/// Far outside the excess, which grows as the square of the distance, tells less than the coordinates.
const FAR_OUTSIDE: f64 = 3.0;

/// The same for a point of which `excess`, (x/a)² + (y/b)² - 1, is known with more digits than the point itself has: the distance
/// then has them too.
///
/// The equation of [`foot`] less the excess is free of cancellation: with u = s/a² and v = s/b² it is
/// (x/a)² u (2 + u)/(1 + u)² + (y/b)² v (2 + v)/(1 + v)². Near the ellipse Sampson's distance is the start.
pub(crate) fn foot_by_excess(radii: Vec2, p: Vec2, excess: f64) -> FootByExcess {
    let scale = radii.x.max(radii.y);
    let in_unit = |v: Vec2| Vec2::new(v.x / scale, v.y / scale);
    let unit = in_unit(radii);
    let alpha = [1.0 / (unit.x * unit.x), 1.0 / (unit.y * unit.y)];
    let mut found = foot_in_unit(unit, alpha, in_unit(p), excess);
    found.foot.distance *= scale;
    found
}

/// The same where the larger radius is 1; the reciprocal squares of the radii are at hand.
#[inline]
pub(crate) fn foot_in_unit(
    radii: Vec2,
    [alpha, beta]: [f64; 2],
    Vec2 { x, y }: Vec2,
    excess: f64,
) -> FootByExcess {
    let (xx, yy) = (x * x * alpha, y * y * beta);
    let largest = alpha.max(beta);
    let mut s = excess / (2.0 * (xx * alpha + yy * beta));
    // Where coefficients that are large beside it cancel, the excess knows less than the coordinates.
    let is_right = (xx + yy - 1.0 - excess).abs() <= RIGHT * (xx + yy);
    if !is_right || s.is_nan() || s.abs() * largest > NEAR {
        let (foot, multiplier) = foot_and_multiplier(radii, Vec2::new(x, y));
        let is_known = is_right && excess <= FAR_OUTSIDE && 1.0 + multiplier * largest >= FROM_POLE;
        if !is_known {
            return FootByExcess {
                foot,
                multiplier,
                is_exact: false,
            };
        }
        s = multiplier;
    }
    for _ in 0..MOST_STEPS {
        let (u, v) = (s * alpha, s * beta);
        let (m, n) = (1.0 / (1.0 + u), 1.0 / (1.0 + v));
        let (xm, yn) = (xx * m * m, yy * n * n);
        let rest = excess - xm * u * (2.0 + u) - yn * v * (2.0 + v);
        let step = rest / (2.0 * (xm * m * alpha + yn * n * beta));
        s += step;
        // The digits double with each step.
        if step.abs() <= 2e-8 * s.abs() {
            break;
        }
    }
    let arm = Vec2::new(x * alpha / (1.0 + s * alpha), y * beta / (1.0 + s * beta));
    let length = arm.hypot();
    FootByExcess {
        foot: Foot {
            distance: s * length,
            outward: arm / length,
        },
        multiplier: s,
        is_exact: true,
    }
}
