//! `area`, `length`, `mean`, `mean-angle`, `rms`: members of the family of `tangent` that an integral singles out (all derived).
//!
//! In the frame of the bisector, with τ = 2t - 1 and v = 1 - τ², a member is
//!
//! ```text
//! X = x0 + x2 τ²,  Y = y1 τ + y3 τ³,   x2 = -(3/4) k sin h,  x0 = cos h - x2,  y3 = y/4,  y1 = sin h - y3
//! r² - 1 = (G/64) v² (w0 - v)
//! ```
//!
//! and each condition is an equation in w0 from which the common factor G has been divided out, so that nothing cancels at tiny angles:
//!
//! - `area`: ∫ (r²-1) dθ = 0, the sector's area is the circle's; in closed form k = 10(a-s)/(6(1-c) + sqrt(36(1-c)² - 30s(a-s)))
//! - `length`: ∫ (ds - dθ) = 0, the arc length is the circle's
//! - `mean`: ∫ |r-1| dt is least; `mean-angle`: ∫ |r-1| dθ is least; `rms`: ∫ (r-1)² dt is least

use crate::numeric::functions::power;
use crate::radial_error::RadialError;

use super::Span;
use super::tangent::{family, family_error, family_y};
use crate::numeric::{angle_minus_sine, integral, root_near};

/// A member of the family at one parameter, with what the integrands ask for; derivatives are by τ or, with `_k`, by the handle.
struct At {
    /// r.
    r: f64,
    /// (r² - 1)/G.
    excess: f64,
    /// ((r²)')²/G.
    turn: f64,
    /// dθ/dτ.
    theta: f64,
    /// dr/dk at fixed τ.
    r_k: f64,
    /// d²θ/dτdk.
    theta_k: f64,
}

/// The member with the zero `w0`.
struct Member<'a> {
    span: &'a Span,
    w0: f64,
    k: f64,
    y3: f64,
    g: f64,
}

impl<'a> Member<'a> {
    fn new(span: &'a Span, w0: f64) -> Self {
        let y = family_y(span, w0);
        Self {
            span,
            w0,
            k: family(span, w0),
            y3: y / 4.0,
            g: 4.0 * y * y,
        }
    }

    fn at(&self, tau: f64) -> At {
        let &Self { span, w0, k, y3, g } = self;
        let x2 = -0.75 * k * span.sh;
        let (x0, y1) = (span.ch - x2, span.sh - y3);
        let square = tau * tau;
        let v = 1.0 - square;
        let (x, y) = (x0 + x2 * square, tau * (y1 + y3 * square));
        let (dx, dy) = (2.0 * x2 * tau, y1 + 3.0 * y3 * square);
        let (x_k, y_k) = (0.75 * span.sh * v, -0.75 * span.ch * tau * v);
        let (dx_k, dy_k) = (-1.5 * span.sh * tau, -0.75 * span.ch * (1.0 - 3.0 * square));
        let excess = v * v * (w0 - v) / 64.0;
        let r_squared = 1.0 + g * excess;
        let r = r_squared.sqrt();
        let r_k = (x * x_k + y * y_k) / r;
        let cross = x * dy - y * dx;
        let cross_k = x_k * dy + x * dy_k - y_k * dx - y * dx_k;
        At {
            r,
            excess,
            turn: g * power(tau * v * (2.0 * w0 - 3.0 * v) / 32.0, 2),
            theta: cross / r_squared,
            r_k,
            theta_k: (cross_k - 2.0 * cross * r_k / r) / r_squared,
        }
    }

    /// The integral over one half of the curve, τ from 0 to 1; the other half gives the same.
    fn integral(&self, f: impl Fn(At) -> f64) -> f64 {
        integral(|tau| f(self.at(tau)), 0.0, 1.0)
    }

    /// The integral of f times the sign of r - 1, which changes where v = w0.
    fn signed_integral(&self, f: impl Fn(At) -> f64) -> f64 {
        let crossing = (1.0 - self.w0).max(0.0).sqrt();
        integral(|tau| f(self.at(tau)), crossing, 1.0)
            - integral(|tau| f(self.at(tau)), 0.0, crossing)
    }
}

/// The root in w0 of a condition on the family's member.
fn zero(span: &Span, condition: impl Fn(&Member) -> f64) -> f64 {
    root_near(|w0| condition(&Member::new(span, w0)), 0.9, 0.02, 1.0)
}

pub(super) fn area(span: &Span) -> f64 {
    let defect = angle_minus_sine(span.a);
    let versine = span.versine();
    10.0 * defect / (6.0 * versine + (36.0 * versine * versine - 30.0 * span.s * defect).sqrt())
}

pub(super) fn area_error(span: &Span) -> RadialError {
    let zero = zero(span, |member| member.integral(|at| at.excess * at.theta));
    family_error(span, zero)
}

pub(super) fn length_zero(span: &Span) -> f64 {
    zero(span, |member| {
        member.integral(|at| {
            // ds² - dθ² over ds + dθ, divided by G.
            let radial = at.turn / (4.0 * at.r * at.r);
            let speed = (at.theta * at.theta * at.r * at.r + radial * member.g).sqrt();
            (radial + at.excess * at.theta * at.theta) / (speed + at.theta)
        })
    })
}

pub(super) fn length(span: &Span) -> f64 {
    family(span, length_zero(span))
}

pub(super) fn mean_zero(span: &Span) -> f64 {
    zero(span, |member| member.signed_integral(|at| at.r_k))
}

pub(super) fn mean(span: &Span) -> f64 {
    family(span, mean_zero(span))
}

pub(super) fn mean_angle_zero(span: &Span) -> f64 {
    zero(span, |member| {
        member.signed_integral(|at| {
            at.r_k * at.theta + member.g * at.excess / (at.r + 1.0) * at.theta_k
        })
    })
}

pub(super) fn mean_angle(span: &Span) -> f64 {
    family(span, mean_angle_zero(span))
}

pub(super) fn rms_zero(span: &Span) -> f64 {
    zero(span, |member| {
        member.integral(|at| at.excess / (at.r + 1.0) * at.r_k)
    })
}

pub(super) fn rms(span: &Span) -> f64 {
    family(span, rms_zero(span))
}
