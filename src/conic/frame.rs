//! A conic by the parameter in which it has equal pieces, and its nearest points.
//!
//! With U = P0 - P1 and V = P2 - P1 a hyperbola of weight w = cosh h is, for θ from -h to h,
//!
//! ```text
//! p(θ) - P1 = (sinh((h-θ)/2) / sinh h)² U + (sinh((h+θ)/2) / sinh h)² V
//! ```
//!
//! (derived: the rational quadratic with its weights made constant). An ellipse, w = cos h, has sines in their place, a parabola
//! their arguments with h = 1. The piece from θ1 to θ2 has the weight cosh((θ2-θ1)/2), and its control point lies
//! tanh((θ2-θ1)/2) p'(θ1) from its start.

use kurbo::{Point, Vec2};

use super::{Conic, Kind};
use crate::numeric::foot::Foot;

/// The most steps of Newton's method.
const MOST_STEPS: usize = 60;

/// How far aside of the normal a point may lie whose nearest point is found, as a part of its distance from the control point.
const SETTLED: f64 = 1e-9;

/// The parameter and the two arms of a conic.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    kind: Kind,
    /// P1, U and V.
    origin: Point,
    u: Vec2,
    v: Vec2,
    /// h.
    pub(super) half: f64,
}

impl Frame {
    pub(super) fn new(conic: &Conic) -> Self {
        let (kind, w) = (conic.kind(), conic.weight);
        let half = match kind {
            Kind::Ellipse => 2.0 * libm::asin(((1.0 - w) / 2.0).sqrt()),
            Kind::Parabola => 1.0,
            Kind::Hyperbola => 2.0 * libm::asinh(((w - 1.0) / 2.0).sqrt()),
        };
        Self {
            kind,
            origin: conic.control,
            u: conic.from - conic.control,
            v: conic.to - conic.control,
            half,
        }
    }

    fn sine(&self, x: f64) -> f64 {
        match self.kind {
            Kind::Ellipse => libm::sin(x),
            Kind::Parabola => x,
            Kind::Hyperbola => libm::sinh(x),
        }
    }

    fn cosine(&self, x: f64) -> f64 {
        match self.kind {
            Kind::Ellipse => libm::cos(x),
            Kind::Parabola => 1.0,
            Kind::Hyperbola => libm::cosh(x),
        }
    }

    /// The sum of both arms at these lengths, over sinh² h.
    fn arms(&self, u: f64, v: f64) -> Vec2 {
        let scale = self.sine(self.half);
        self.u * (u / scale / scale) + self.v * (v / scale / scale)
    }

    /// p(θ) - P1.
    fn offset(&self, x: f64) -> Vec2 {
        let (s, t) = (
            self.sine((self.half - x) / 2.0),
            self.sine(f64::midpoint(self.half, x)),
        );
        self.arms(s * s, t * t)
    }

    /// p(θ).
    pub(super) fn point(&self, x: f64) -> Point {
        self.origin + self.offset(x)
    }

    /// p'(θ).
    pub(super) fn derivative(&self, x: f64) -> Vec2 {
        self.arms(
            -self.sine(self.half - x) / 2.0,
            self.sine(self.half + x) / 2.0,
        )
    }

    /// p''(θ).
    fn second(&self, x: f64) -> Vec2 {
        self.arms(
            self.cosine(self.half - x) / 2.0,
            self.cosine(self.half + x) / 2.0,
        )
    }

    /// The weight of a piece of this length, and how many times p' its control point lies from its start.
    pub(super) fn piece(&self, length: f64) -> (f64, f64) {
        let (s, c) = (self.sine(length / 2.0), self.cosine(length / 2.0));
        (c, s / c)
    }

    /// How far the parts of p along U and V are, and the θ of the conic's point on the line through P1 and p.
    pub(super) fn opposite(&self, p: Point) -> f64 {
        let (offset, area) = (p - self.origin, self.u.cross(self.v));
        let along = offset.cross(self.v) / area;
        let across = self.u.cross(offset) / area;
        let (s, t) = (along.max(0.0).sqrt(), across.max(0.0).sqrt());
        if s + t == 0.0 {
            return 0.0;
        }
        let part = (t - s) / (t + s);
        let half = self.half / 2.0;
        match self.kind {
            Kind::Ellipse => 2.0 * libm::atan(libm::tan(half) * part),
            Kind::Parabola => part,
            Kind::Hyperbola => 2.0 * libm::atanh(libm::tanh(half) * part),
        }
    }

    /// The nearest point near the line through P1 and p; outward is towards P1.
    pub(super) fn foot(&self, p: Point) -> Foot {
        let offset = p - self.origin;
        let mut x = self.opposite(p);
        for _ in 0..MOST_STEPS {
            let (arm, tangent) = (offset - self.offset(x), self.derivative(x));
            let square = tangent.hypot2();
            let slope = arm.dot(self.second(x)) - square;
            // Where the point is farther than the centre of curvature the step is that of Gauss and Newton.
            let step = arm.dot(tangent) / if slope < 0.0 { -slope } else { square };
            let step = step.clamp(-self.half, self.half);
            x += step;
            if step.abs() <= 1e-16 * self.half {
                break;
            }
        }
        let tangent = self.derivative(x);
        let side = 1.0_f64.copysign(self.u.cross(self.v));
        let outward = Vec2::new(-tangent.y, tangent.x) * (side / tangent.hypot());
        let arm = offset - self.offset(x);
        let (distance, aside) = (arm.dot(outward), arm.cross(outward));
        // Where the steps came to no end, what lies aside counts too.
        let is_found = aside.abs() <= SETTLED * offset.hypot();
        let distance = if is_found {
            distance
        } else {
            arm.hypot().copysign(distance)
        };
        Foot { distance, outward }
    }

    /// Whether points that lie so far from the arc at most have normals that cover it: it bends no sharper than that.
    pub(super) fn is_covered(&self, distance: f64) -> bool {
        distance * self.largest_curvature() < 0.5
    }

    /// The largest curvature of the arc: |p' × p''| is constant, so that it is where |p'| is least, and |p'|² is convex.
    pub(super) fn largest_curvature(&self) -> f64 {
        let grows = |x: f64| self.derivative(x).dot(self.second(x));
        let h = self.half;
        let x = match (grows(-h) > 0.0, grows(h) > 0.0) {
            (true, _) => -h,
            (false, false) => h,
            (false, true) => crate::numeric::root(grows, -h, h),
        };
        let tangent = self.derivative(x);
        (tangent.cross(self.second(x)) / tangent.hypot2() / tangent.hypot()).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parabola y = x² between two places.
    fn parabola(a: f64, b: f64) -> Conic {
        let points = [(a, a * a), (f64::midpoint(a, b), a * b), (b, b * b)];
        let [from, control, to] = points.map(|(x, y)| Point::new(x, y));
        Conic::new(from, control, to, 1.0).unwrap()
    }

    #[test]
    fn a_parabola_bends_most_where_it_is_nearest_to_its_tip() {
        for (a, b, nearest) in [(1.0, 2.0, 1.0), (-2.0, -1.0, -1.0), (-1.0, 2.0, 0.0)] {
            let expected = 2.0 / libm::pow(1.0 + 4.0 * nearest * nearest, 1.5);
            let found = Frame::new(&parabola(a, b)).largest_curvature();
            assert!((found / expected - 1.0).abs() < 1e-12, "{a} {b}: {found}");
        }
    }

    #[test]
    fn the_control_point_is_opposite_to_the_middle() {
        let conic = parabola(-1.0, 1.0);
        let frame = Frame::new(&conic);
        assert_eq!(frame.opposite(conic.control), 0.0);
        assert!((frame.opposite(Point::new(0.5, 0.25)) - 0.5).abs() < 1e-12);
    }
}
