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
const MOST_STEPS: usize = 100;

/// The longest step away from the vertex: farther out a hyperbola's points run away as e^θ.
const LONGEST_STEP: f64 = 1.0;

/// How far aside of the normal a point may lie whose nearest point is found, as a part of its distance from the control point.
const SETTLED: f64 = 1e-9;

/// What part of the shortest normal a curve may lie inside: the places of its ends are known nearly.
const COVERED: f64 = 0.9;

/// The parameter and the two arms of a conic.
#[derive(Debug, Clone, Copy)]
pub(super) struct ConicFrame {
    kind: Kind,
    /// P1, U and V.
    origin: Point,
    u: Vec2,
    v: Vec2,
    /// h.
    pub(super) half: f64,
    /// The θ of the sharpest place of the whole branch.
    vertex: f64,
}

impl ConicFrame {
    pub(super) fn new(conic: &Conic) -> Self {
        let (kind, w) = (conic.kind(), conic.weight);
        let half = match kind {
            Kind::Ellipse => 2.0 * libm::asin(((1.0 - w) / 2.0).sqrt()),
            Kind::Parabola => 1.0,
            Kind::Hyperbola => 2.0 * libm::asinh(((w - 1.0) / 2.0).sqrt()),
        };
        let (u, v) = (conic.from - conic.control, conic.to - conic.control);
        Self {
            kind,
            origin: conic.control,
            u,
            v,
            half,
            vertex: vertex(kind, half, [u, v]),
        }
    }

    /// The same where U and V are known better than the points are.
    pub(super) fn with_arms(self, arms: [Vec2; 2]) -> Self {
        let [u, v] = arms;
        let vertex = vertex(self.kind, self.half, arms);
        Self {
            u,
            v,
            vertex,
            ..self
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

    /// The square roots of the parts of p(θ) - P1 along U and V, over a common divisor.
    pub(super) fn shares(&self, x: f64) -> [f64; 2] {
        [self.half - x, self.half + x].map(|x| self.sine(x / 2.0))
    }

    /// p(θ) - P1.
    fn offset(&self, x: f64) -> Vec2 {
        let [s, t] = self.shares(x);
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
        self.opposite_about(p - self.origin)
    }

    fn opposite_about(&self, offset: Vec2) -> f64 {
        let area = self.u.cross(self.v);
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

    /// The nearest point of the whole branch; outward is towards P1.
    pub(super) fn foot(&self, p: Point) -> Foot {
        let offset = p - self.origin;
        self.seen_from(offset, self.nearest(offset))
    }

    /// The θ of the point of the whole branch that is nearest to one about P1.
    ///
    /// It lies on the same side of the vertex as the point, and there is the only place from where the distance is stationary: in the frame of
    /// the axes, x = a cosh s and y = b sinh s, such a place is where b y0 / sinh s + a x0 / cosh s = a² + b², and the left side falls where x0 is
    /// positive; where it is not, b y0 + a x0 tanh s = (a² + b²) sinh s, of which one side falls and the other rises. Of an ellipse the same holds with
    /// cos and sin and a x0 / cos s - b y0 / sin s = a² - b², and a parabola is the limit of both.
    pub(super) fn nearest(&self, offset: Vec2) -> f64 {
        // p'' lies along the axis there.
        let axis = self.second(self.vertex);
        let ahead = axis.cross(offset - self.offset(self.vertex));
        let side = ahead.signum() * axis.cross(self.derivative(self.vertex)).signum();
        let tip = (self.derivative(self.vertex).hypot() / axis.hypot()).min(LONGEST_STEP);
        let (mut low, mut high) = (0.0, self.farthest());
        let start = side * (self.opposite_about(offset) - self.vertex);
        let mut away = if start > 0.0 { start } else { 0.5 * self.half };
        for _ in 0..MOST_STEPS {
            let x = self.vertex + side * away;
            let (near, tangent) = (self.offset(x), self.derivative(x));
            let arm = offset - near;
            let aim = side * arm.dot(tangent);
            let square = tangent.hypot2();
            let slope = arm.dot(self.second(x)) - square;
            let noise = 0.5 * f64::EPSILON * (offset.hypot() + near.hypot());
            let is_stationary = aim.abs() <= noise * tangent.hypot();
            if is_stationary && slope < 0.0 {
                break;
            }
            // Farther than the centre of curvature the vertex is no nearest point, but a farthest one.
            if aim > 0.0 || is_stationary {
                low = away;
            } else {
                high = away;
            }
            let next = if slope < 0.0 {
                away - (aim / slope).max(-LONGEST_STEP.max(0.1 * away))
            } else {
                2.0 * away + tip
            };
            let next = if next > low && next < high {
                next
            } else if high.is_finite() {
                f64::midpoint(low, high)
            } else {
                2.0 * low + LONGEST_STEP.min(self.half)
            };
            if next == away {
                break;
            }
            away = next;
        }
        self.vertex + side * away
    }

    /// The distance of a point about P1 from this place along the normal.
    pub(super) fn seen_from(&self, offset: Vec2, x: f64) -> Foot {
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

    /// How far from the vertex a place may lie.
    const fn farthest(&self) -> f64 {
        match self.kind {
            Kind::Ellipse => core::f64::consts::PI,
            Kind::Parabola | Kind::Hyperbola => f64::INFINITY,
        }
    }

    /// Whether the nearest points of a curve that lies no farther inside than that cover the arc between two parameters, which are those of
    /// the curve's ends: none of its normals reaches the axis so soon.
    pub(super) fn is_covered(&self, between: [f64; 2], distance: f64) -> bool {
        distance < COVERED * self.shortest_normal(between)
    }

    /// The least way along the normal from the arc between two parameters to the axis of the whole branch: the cube of such a way is the
    /// radius of curvature times the square of the vertex's (known of every conic).
    fn shortest_normal(&self, [from, to]: [f64; 2]) -> f64 {
        let [here, vertex] =
            [self.vertex.clamp(from, to), self.vertex].map(|x| libm::cbrt(self.curvature(x)));
        1.0 / here / vertex / vertex
    }

    /// The largest curvature of the arc: |p' × p''| is constant, so that it is where |p'| is least.
    pub(super) fn largest_curvature(&self) -> f64 {
        let [from, to] = self.ends();
        self.curvature(self.vertex.clamp(from, to))
    }

    /// The parameters between which the arc lies and the nearest points of its ends do, moved so.
    pub(super) fn around(&self, moved: [Vec2; 2]) -> [f64; 2] {
        let [from, to] = self.ends();
        let feet = [self.u + moved[0], self.v + moved[1]].map(|end| self.nearest(end));
        let [first, last] = feet;
        [from.min(first).min(last), to.max(first).max(last)]
    }

    /// The parameters of the ends.
    pub(super) const fn ends(&self) -> [f64; 2] {
        [-self.half, self.half]
    }

    /// The curvature at θ.
    pub(super) fn curvature(&self, x: f64) -> f64 {
        let tangent = self.derivative(x);
        (tangent.cross(self.second(x)) / tangent.hypot2() / tangent.hypot()).abs()
    }
}

/// Where |p'| is least on the whole branch: |p'|² = A + B cosh 2θ + C sinh 2θ, of an ellipse with the circular functions, and of a parabola
/// a square of a linear function.
fn vertex(kind: Kind, h: f64, [u, v]: [Vec2; 2]) -> f64 {
    let (squares, apart) = (
        u.hypot2() + v.hypot2(),
        (u.hypot() - v.hypot()) * (u.hypot() + v.hypot()),
    );
    let both = 2.0 * u.dot(v);
    match kind {
        Kind::Parabola => (u - v).dot(u + v) / (u + v).hypot2(),
        Kind::Ellipse => {
            let (sine, cosine) = (libm::sin(2.0 * h), libm::cos(2.0 * h));
            0.5 * libm::atan2(sine * apart, cosine * squares + both)
        }
        // The ratio of the factors of e^-θ and e^θ in p', where it is none of nearly equal numbers.
        Kind::Hyperbola if h > 0.5 => {
            let less = libm::exp(-2.0 * h);
            0.5 * libm::log((u + less * v).hypot() / (v + less * u).hypot())
        }
        Kind::Hyperbola => {
            let (sine, cosine) = (libm::sinh(2.0 * h), libm::cosh(2.0 * h));
            0.5 * libm::atanh(sine * apart / (cosine * squares + both))
        }
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
            let found = ConicFrame::new(&parabola(a, b)).largest_curvature();
            assert!((found / expected - 1.0).abs() < 1e-12, "{a} {b}: {found}");
        }
    }

    #[test]
    fn the_nearest_point_is_where_the_normal_started() {
        let thin = [(0.0, 0.0), (100.0, 100.0), (1e-4, 0.0)];
        let wide = [(0.0, 0.0), (-1.0, 7.0), (9.0, -2.0)];
        for points in [thin, wide] {
            let [from, control, to] = points.map(Point::from);
            for weight in [0.99995, 1.0, 1.5, 1e4, 1e9] {
                let frame = ConicFrame::new(&Conic::new(from, control, to, weight).unwrap());
                let sharpest = frame.largest_curvature();
                for i in -12..=12 {
                    let x = frame.half * f64::from(i) / 8.0;
                    let outward = frame.seen_from(Vec2::ZERO, x).outward;
                    // Inside up to half of the smallest radius, outside anywhere.
                    for away in [-0.5 / sharpest, 0.5 / sharpest, 1.0] {
                        let q = frame.offset(x) + away * outward;
                        let found = frame.offset(frame.nearest(q));
                        let off = (found - frame.offset(x)).hypot();
                        assert!(
                            off <= 1e-12 * q.hypot() + 1e-6 * away.abs(),
                            "{points:?} {weight} {i} {away}: {off}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn the_control_point_is_opposite_to_the_middle() {
        let conic = parabola(-1.0, 1.0);
        let frame = ConicFrame::new(&conic);
        assert_eq!(frame.opposite(conic.control), 0.0);
        assert!((frame.opposite(Point::new(0.5, 0.25)) - 0.5).abs() < 1e-12);
    }
}
