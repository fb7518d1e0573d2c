//! True distance of a Bézier segment from an ellipse.

use super::bezier::Powers;
use super::real::{
    Point, Real, abs, cross, dot, int, max, norm, power_of_two, radians, ratio, real, sign, to_f64,
};
use super::solve::root;

/// Pieces into which the segment is cut at first to look for the extremes.
const PIECES: i64 = 64;

/// At how many places the ellipse's tips are looked for.
const SAMPLES: u32 = 200;

/// The largest sine of the turn of the normal over one piece; more, and it is halved. At the tips
/// of a flat ellipse the distance varies with the normal, far faster than with the parameter.
const TURN: f64 = 0.04;

/// The largest distance of a segment outside and inside an ellipse, along the ellipse's normals,
/// both at least 0, and 0 if below 2^-110 of the larger radius, which is rounding. The ellipse is
/// whole: the nearest of all its points counts.
///
/// The signed distance is stationary where the velocity is square to the normal at the nearest
/// point. The segment is cut finely enough that neither moves far over a piece, and each change of
/// sign of their product is followed to 57 digits; the distances are good to 30 digits of the
/// larger radius.
pub fn ellipse_distance_extremes(
    points: &[Point],
    center: Point,
    radii: Point,
    rotation_degrees: &Real,
) -> (Real, Real) {
    let [x, y] = center;
    let (sine, cosine) = radians(rotation_degrees).sin_cos();
    let local: Vec<Point> = points
        .iter()
        .map(|p| {
            let arm = [&p[0] - &x, &p[1] - &y];
            [
                &arm[0] * &cosine + &arm[1] * &sine,
                &arm[1] * &cosine - &arm[0] * &sine,
            ]
        })
        .collect();
    let curve = Powers::new(&local);
    let search = Search {
        velocity: curve.derivative(),
        curve,
        radii,
    };
    let mut distances = Vec::new();
    let mut places = search.tips();
    places.extend((1..=PIECES).map(|i| {
        // Narrower towards the ends, where a curve that touches the ellipse has its smallest lobes: 10 s^3 - 15 s^4 + 6 s^5.
        let s = ratio(i, PIECES);
        &s * &s * &s * (int(10) - int(15) * &s + int(6) * &s * &s)
    }));
    places.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let mut start = search.sample(int(0));
    for t in places {
        let end = search.sample(t);
        search.piece(&start, &end, 24, &mut distances);
        start = end;
    }
    distances.push(start.distance);
    let rounding = max(search.radii[0].clone(), search.radii[1].clone()) * power_of_two(-110);
    let largest = |side: i32| {
        let on_side = distances.iter().filter(|d| sign(d) == side);
        let most = on_side.fold(int(0), |most, d| max(most, abs(d)));
        if most > rounding { most } else { int(0) }
    };
    (largest(1), largest(-1))
}

/// A segment and an ellipse, in the frame of the ellipse.
struct Search {
    curve: Powers,
    velocity: Powers,
    radii: Point,
}

/// What there is at one place of the segment.
struct Sample {
    t: Real,
    distance: Real,
    normal: Point,
    /// The derivative of the distance by t, times a positive number.
    slope: Real,
}

impl Search {
    fn sample(&self, t: Real) -> Sample {
        let (distance, normal) = nearest(&self.curve.at(&t), &self.radii[0], &self.radii[1]);
        Sample {
            distance,
            slope: dot(&normal, &self.velocity.at(&t)),
            normal,
            t,
        }
    }

    /// Where the segment passes the tips of a flat ellipse and their centres of curvature: between those the normal turns by half
    /// a turn and back, unseen from pieces that begin and end farther off.
    fn tips(&self) -> Vec<Real> {
        let [a, b] = [0, 1].map(|i| to_f64(&self.radii[i]));
        let (long, large, small) = if a > b { (0, a, b) } else { (1, b, a) };
        if large < 10.0 * small {
            return Vec::new();
        }
        let along = |t: f64| to_f64(&self.curve.at(&real(t))[long]);
        let samples: Vec<f64> = (0..=SAMPLES)
            .map(|i| along(f64::from(i) / f64::from(SAMPLES)))
            .collect();
        let center = large - small * small / large;
        let mut tips = Vec::new();
        for level in [large, center, -center, -large] {
            for (i, pair) in samples.windows(2).enumerate() {
                let from = i as f64 / f64::from(SAMPLES);
                let mut ends = [from, from + 1.0 / f64::from(SAMPLES)];
                if (pair[0] > level) == (pair[1] > level) {
                    continue;
                }
                for _ in 0..40 {
                    let middle = f64::midpoint(ends[0], ends[1]);
                    ends[usize::from((along(middle) > level) != (pair[0] > level))] = middle;
                }
                tips.push(real(ends[0]));
            }
        }
        tips
    }

    /// Notes the distance at the start of a piece and where it is stationary within.
    fn piece(&self, start: &Sample, end: &Sample, depth: usize, distances: &mut Vec<Real>) {
        let turn = abs(&cross(&start.normal, &end.normal));
        let unit = norm(&start.normal) * norm(&end.normal);
        if depth > 0 && (turn > &unit * real(TURN) || sign(&dot(&start.normal, &end.normal)) < 0) {
            let middle = self.sample((&start.t + &end.t) * ratio(1, 2));
            self.piece(start, &middle, depth - 1, distances);
            self.piece(&middle, end, depth - 1, distances);
            return;
        }
        distances.push(start.distance.clone());
        if sign(&start.slope) * sign(&end.slope) < 0 {
            let t = root(|t| self.sample(t.clone()).slope, &start.t, &end.t);
            distances.push(self.sample(t).distance);
        }
    }
}

/// The signed distance of a point from the ellipse `x^2/a^2 + y^2/b^2 = 1`, positive outside, and
/// the outward normal at the nearest point of the ellipse (not of unit length).
///
/// D. Eberly, Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid (2011): the
/// nearest point is `(a^2 x/(m + a^2), b^2 y/(m + b^2))` with m the largest root of
/// `(a x/(m + a^2))^2 + (b y/(m + b^2))^2 = 1`. So the arm from there to the point is
/// `m (x/(m + a^2), y/(m + b^2))`: m has the sign of the distance, and the arm's factor is the
/// normal. The left side is convex and falls to the right of the poles, so Newton's method
/// started where it is at least 1 climbs to the root without overshooting.
fn nearest(point: &Point, a: &Real, b: &Real) -> (Real, Point) {
    // Off the axes by less than the accuracy promised: on them the root may lie at a pole.
    let tiny = power_of_two(-120);
    let x = max(abs(&point[0]), a * &tiny);
    let y = max(abs(&point[1]), b * &tiny);
    let (a2, b2) = (a * a, b * b);
    let (ax, by) = (a * &x, b * &y);
    // Measured from the poles: beside one the steps start tiny and grow by half each.
    let enough = power_of_two(-110);
    let mut m = max(&ax - &a2, &by - &b2);
    for _ in 0..400 {
        let (p, q) = (&m + &a2, &m + &b2);
        let (u, v) = (&ax / &p, &by / &q);
        let (u2, v2) = (&u * &u, &v * &v);
        let excess = &u2 + &v2 - int(1);
        let step = excess / ((u2 / &p + v2 / &q) * int(2));
        m += &step;
        if abs(&step) <= &p * &enough && abs(&step) <= &q * &enough {
            break;
        }
    }
    let normal = [x / (&m + &a2), y / (&m + &b2)];
    let distance = m * norm(&normal);
    let [p, q] = normal;
    let signed = |value: Real, like: &Real| if sign(like) < 0 { -value } else { value };
    (distance, [signed(p, &point[0]), signed(q, &point[1])])
}

/// The signed distance of a point from an ellipse about the origin with its axes along x and y,
/// positive outside.
pub fn signed_distance(point: &Point, radii: &Point) -> Real {
    nearest(point, &radii[0], &radii[1]).0
}
