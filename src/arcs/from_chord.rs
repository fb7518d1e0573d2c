//! How far curves lie from a chord, both ways (Hausdorff): no bound, but the distance itself.
//!
//! Let a chord run from 0 to L in x, and a curve from one of its ends to the other, at the height y. Each x of the chord is taken by some
//! point of the curve, so that no point of the chord is farther from the curve than some point of the curve is from the chord: the farthest
//! of these decides. The square of its distance has a slope without jumps: y² beside the chord, (q - e)² beyond an end e. So it is largest
//! at an end of the curve, where y' = 0, or where (q - e) q' = 0; each of these is looked at, wherever it lies.

use kurbo::{CubicBez, Point, Vec2};

use crate::numeric::bernstein::Polynomial;

/// How far a distance may be off, as a part of the vectors that it was made from.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Half the largest sweep, in radians, of which a chord is looked at: beyond, the ends of an arc are next to each other.
const LARGEST_HALF: f64 = 3.0;

/// The distance of consecutive cubics from the chord between their ends; infinite where these are one point.
pub(super) fn from_chord(parts: &[CubicBez]) -> f64 {
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
        return f64::INFINITY;
    };
    if first.p0 == last.p3 && parts.len() > 1 {
        return f64::INFINITY;
    }
    let off = parts
        .iter()
        .map(|part| Above::new(part, [first.p0, last.p3]).farthest());
    off.fold(0.0, f64::max)
}

/// A cubic by the Bernstein coefficients of its place along a chord and of its height.
pub(super) struct Above {
    x: [f64; 4],
    y: [f64; 4],
    /// That of the chord.
    length: f64,
    /// The largest height, wherever it is.
    highest: f64,
    /// What rounding may do to a distance.
    noise: f64,
}

impl Above {
    pub(super) fn new(cubic: &CubicBez, [from, to]: [Point; 2]) -> Self {
        let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3];
        let (ways, chord) = (points.map(|p| p - from), to - from);
        let length = chord.hypot2().sqrt();
        // From a single point no direction is another.
        let along = if length > 0.0 {
            chord / length
        } else {
            Vec2::new(1.0, 0.0)
        };
        let (mut x, mut y) = (ways.map(|v| along.dot(v)), ways.map(|v| along.cross(v)));
        // The chord's ends lie on it to the last digit.
        for (i, p) in points.iter().enumerate() {
            if *p == from || *p == to {
                (x[i], y[i]) = (if *p == from { 0.0 } else { length }, 0.0);
            }
        }
        let heights = turns(y).map(|t| value(y, t).abs());
        let longest = ways.iter().map(|v| v.hypot2());
        Self {
            highest: heights.fold(y[0].abs().max(y[3].abs()), f64::max),
            noise: ROUNDING * longest.fold(length * length, f64::max).sqrt(),
            length,
            x,
            y,
        }
    }

    pub(super) fn is_within(&self, limit: f64) -> bool {
        let over = self.past().into_iter().flatten().fold(0.0, f64::max);
        if over == 0.0 {
            return self.stated(self.highest) <= limit;
        }
        // Most are far off, or near enough together with as much as they may lie beyond the ends.
        let most = (over * over + self.highest * self.highest).sqrt();
        let beside = turns(self.y).map(|t| self.off(t)).fold(0.0, f64::max);
        beside <= limit && (self.stated(most) <= limit || self.farthest() <= limit)
    }

    /// How far its farthest point is from the chord.
    pub(super) fn farthest(&self) -> f64 {
        let past = self.past();
        if past.iter().flatten().all(|past| *past <= 0.0) {
            return self.stated(self.highest);
        }
        let ends = self.off(0.0).max(self.off(1.0));
        let mut farthest = turns(self.y).map(|t| self.off(t)).fold(ends, f64::max);
        for past in past {
            for (t0, t1) in Polynomial::new(&past).sign_changes().pieces() {
                if value(past, f64::midpoint(t0, t1)) > 0.0 {
                    // Of this part alone, as the digits of what is a bit beyond are lost in the whole.
                    let [x, y] = [past, self.y].map(|c| Polynomial::new(&between(c, [t0, t1])));
                    let slope = x.times(&x.differences());
                    let slope = slope.minus(&y.times(&y.differences()).scaled(-1.0));
                    for s in slope.sign_changes().iter() {
                        farthest = farthest.max(self.off(t0 + s * (t1 - t0)));
                    }
                }
            }
        }
        self.stated(farthest)
    }

    /// How far it is beyond either end of the chord.
    fn past(&self) -> [[f64; 4]; 2] {
        [self.x.map(|x| -x), self.x.map(|x| x - self.length)]
    }

    /// How far a point of it is from the chord.
    fn off(&self, t: f64) -> f64 {
        let (x, y) = (value(self.x, t), value(self.y, t));
        let over = (-x).max(x - self.length).max(0.0);
        (over * over + y * y).sqrt()
    }

    fn stated(&self, distance: f64) -> f64 {
        if distance > 0.0 {
            distance + self.noise
        } else {
            0.0
        }
    }
}

/// The value of a cubic polynomial by its Bernstein coefficients.
fn value([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let s = 1.0 - t;
    s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d)
}

/// The Bernstein coefficients of a part of a cubic polynomial, by de Casteljau's algorithm.
fn between([a, b, c, d]: [f64; 4], [t0, t1]: [f64; 2]) -> [f64; 4] {
    let blossom = |u: f64, v: f64, w: f64| {
        let mix = |a: f64, b: f64, t: f64| (1.0 - t) * a + t * b;
        let [e, f, g] = [mix(a, b, u), mix(b, c, u), mix(c, d, u)];
        mix(mix(e, f, v), mix(f, g, v), w)
    };
    [
        blossom(t0, t0, t0),
        blossom(t0, t0, t1),
        blossom(t0, t1, t1),
        blossom(t1, t1, t1),
    ]
}

/// Where its slope, a multiple of (1-t)² d₀ + 2t(1-t) d₁ + t² d₂, is 0 between 0 and 1.
fn turns([a, b, c, d]: [f64; 4]) -> impl Iterator<Item = f64> {
    let d = [b - a, c - b, d - c];
    let (p, q, r) = (d[0] - 2.0 * d[1] + d[2], 2.0 * (d[1] - d[0]), d[0]);
    let root = (q * q - 4.0 * p * r).max(0.0).sqrt();
    let s = -0.5 * (q + root.copysign(q));
    [s / p, r / s]
        .into_iter()
        .filter(|t| (0.0..=1.0).contains(t))
}

/// The distance from its chord of a part of an ellipse: the points x = a sin φ + b (cos φ - cos h), y = c (cos φ - cos h) for φ from -h to h,
/// in radians, a > 0; infinite where its ends are too near to each other.
///
/// With d² = a² + b² and tan τ = a/b, x = d cos(φ - τ) - b cos h: where τ < h the part from φ₀ = 2τ - h on lies beyond the end, by
/// 2d sin((φ - φ₀)/2) sin((h - φ)/2). With u = tan φ/2 and its values v, w at φ₀, h that and the height are, times 1 + u²,
///
/// 2d cos(φ₀/2) cos(h/2) (w - u) (u - v), 2c cos²(h/2) (w - u) (w + u).
///
/// At the other end the same holds with -b. Some distance above the limit is answered where it is above it.
pub(super) fn of_arc([a, b, c]: [f64; 3], half: f64, limit: f64) -> f64 {
    if half > LARGEST_HALF {
        return f64::INFINITY;
    }
    // cos φ - cos h = 2 sin((h+φ)/2) sin((h-φ)/2).
    let height = |phi: f64| 2.0 * c * libm::sin(0.5 * (half + phi)) * libm::sin(0.5 * (half - phi));
    let mut farthest = height(0.0).abs();
    if farthest > limit {
        return farthest;
    }
    let d = (a * a + b * b).sqrt();
    for turn in [libm::atan2(a, b), libm::atan2(a, -b)] {
        if turn < half {
            let from = 2.0 * turn - half;
            let at = |phi: f64| {
                let over = 2.0 * d * libm::sin(0.5 * (phi - from)) * libm::sin(0.5 * (half - phi));
                let height = height(phi);
                (over * over + height * height).sqrt()
            };
            let [v, w] = [from, half].map(|phi| libm::tan(0.5 * phi));
            let (cosine, cosine0) = (libm::cos(0.5 * half), libm::cos(0.5 * from));
            let over = 2.0 * d * cosine0 * cosine * (w - v) * (w - v);
            let rise = 2.0 * c * cosine * cosine * (w - v);
            let over = Polynomial::new(&[0.0, 0.5 * over, 0.0]);
            let rise = Polynomial::new(&[rise * (w + v), rise * w, 0.0]);
            let below = Polynomial::new(&[1.0 + v * v, 1.0 + v * w, 1.0 + w * w]);
            let square = over.times(&over).minus(&rise.times(&rise).scaled(-1.0));
            let slope = square.derivative().times(&below);
            let slope = slope.minus(&square.times(&below.derivative()).scaled(2.0));
            let stands = slope.sign_changes();
            let stands = stands.iter().map(|s| at(2.0 * libm::atan(v + s * (w - v))));
            farthest = stands.fold(farthest, f64::max);
        }
    }
    if farthest > 0.0 {
        farthest + ROUNDING * d.max(c.abs()) * half.min(1.0)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::random::signed;
    use kurbo::ParamCurve as _;

    const SAMPLES: u32 = 4000;

    fn samples(from: f64, to: f64) -> impl Iterator<Item = f64> {
        (0..=SAMPLES).map(move |i| from + (to - from) * f64::from(i) / f64::from(SAMPLES))
    }

    fn sampled(points: impl Iterator<Item = Point>, [from, to]: [Point; 2]) -> f64 {
        let off = |p: Point| {
            let chord = to - from;
            let part = ((p - from).dot(chord) / chord.hypot2()).clamp(0.0, 1.0);
            p.distance(from + part * chord)
        };
        points.map(off).fold(0.0, f64::max)
    }

    #[test]
    fn a_folded_cubic_is_as_far_as_its_farthest_sample() {
        let (mut state, mut beyond) = (5, 0);
        for round in 0..1500 {
            let flat = [1.0, 0.1, 1e-3][round % 3];
            let mut point = || Point::new(signed(&mut state), flat * signed(&mut state));
            let cubic = CubicBez::new(point(), point(), point(), point());
            let ends = [cubic.p0, cubic.p3];
            let above = Above::new(&cubic, ends);
            let (found, samples) = (
                above.farthest(),
                sampled(samples(0.0, 1.0).map(|t| cubic.eval(t)), ends),
            );
            assert!(samples <= found, "{cubic:?}: {samples} {found}");
            assert!(
                found <= samples * (1.0 + 1e-4) + 1e-7,
                "{cubic:?}: {samples} {found}"
            );
            assert!(above.is_within(1.0001 * found) && !above.is_within(0.9999 * found));
            beyond += usize::from(found > 1.001 * above.highest);
        }
        assert!(beyond > 300, "{beyond}");
    }

    #[test]
    fn an_arc_of_an_ellipse_is_as_far_as_its_farthest_sample() {
        let (mut state, mut beyond) = (9, 0);
        for round in 0..1500 {
            let flat = [1.0, 0.1, 1e-3][round % 3];
            let (a, b) = (0.01 + signed(&mut state).abs(), signed(&mut state));
            let (c, half) = (
                flat * signed(&mut state),
                1.48 * (1.01 + signed(&mut state)),
            );
            let at = |phi: f64| {
                let rise = libm::cos(phi) - libm::cos(half);
                Point::new(a * libm::sin(phi) + b * rise, c * rise)
            };
            let found = of_arc([a, b, c], half, f64::INFINITY);
            let samples = sampled(samples(-half, half).map(at), [at(-half), at(half)]);
            assert!(
                samples <= found + 1e-14,
                "{a} {b} {c} {half}: {samples} {found}"
            );
            assert!(
                found <= samples * (1.0 + 1e-4) + 1e-7,
                "{a} {b} {c} {half}: {samples} {found}"
            );
            beyond += usize::from(found > 1.001 * (c * at(0.0).y / c).abs());
        }
        assert!(beyond > 300, "{beyond}");
    }

    #[test]
    fn what_lies_a_bit_beyond_an_end_is_seen() {
        // By a tenth of a billionth of its length.
        let cubic = CubicBez::new((0.0, 0.0), (0.2, 0.0), (1.0 + 1.1e-5, 0.0), (1.0, 0.0));
        let above = Above::new(&cubic, [cubic.p0, cubic.p3]);
        let most = samples(0.99999, 1.0).map(|t| cubic.eval(t).x - 1.0);
        let most = most.fold(0.0, f64::max);
        assert!(
            (above.farthest() - most).abs() < 1e-14 && most > 1e-11,
            "{most}"
        );
    }
}
