//! True distance of a Bézier segment from an ellipse.

use super::along::Search;
use super::bezier::Powers;
use super::real::{Point, Real, abs, int, max, norm, power_of_two, radians, real, sign, to_f64};

/// At how many places the ellipse's tips are looked for.
const SAMPLES: u32 = 200;

/// The largest distance of a segment outside and inside an ellipse, along the ellipse's normals,
/// both at least 0, and 0 if below 2^-110 of the larger radius, which is rounding. The ellipse is
/// whole: the nearest of all its points counts.
///
/// The distances are good to 30 digits of the larger radius.
pub fn ellipse_distance_extremes(
    points: &[Point],
    center: Point,
    [a, b]: Point,
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
    let near = |p: &Point| nearest(p, &a, &b);
    let distances = Search::new(&curve, &near).distances(tips(&curve, [&a, &b].map(to_f64)));
    let rounding = max(a, b) * power_of_two(-110);
    let largest = |side: i32| {
        let on_side = distances.iter().filter(|d| sign(d) == side);
        let most = on_side.fold(int(0), |most, d| max(most, abs(d)));
        if most > rounding { most } else { int(0) }
    };
    (largest(1), largest(-1))
}

/// Where the segment passes the tips of a flat ellipse and their centres of curvature: between those the normal turns by half
/// a turn and back, unseen from pieces that begin and end farther off.
fn tips(curve: &Powers, [a, b]: [f64; 2]) -> Vec<Real> {
    let (long, large, small) = if a > b { (0, a, b) } else { (1, b, a) };
    if large < 10.0 * small {
        return Vec::new();
    }
    let along = |t: f64| to_f64(&curve.at(&real(t))[long]);
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
