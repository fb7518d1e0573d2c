//! `minimax-ellipse` and `minimax-ellipse-free`: the least peak of the true distance from an ellipse (derived).
//!
//! An affine image of a circle's best cubic is not an ellipse's best. With the ends and tangents on the ellipse two handles k0 and k1
//! are free, P1 = P0 + k0 T0 and P2 = P3 - k1 T1 with T the derivative by the parametric angle, and the peak is least where the
//! signed distance reaches +E, -E, +E. Newton's method for (k0, k1, E): to first order an extreme's own motion does not count, so
//! that the row of an extreme at t, with the normal n there, is
//!
//! ```text
//! 3t(1-t)² n·T0,   -3t²(1-t) n·T1,   -(its sign)
//! ```
//!
//! `free` serves quarters from axis to axis, whose ends lie E inside: -E, +E, -E, +E, -E; the last entry of the row gains
//! -n·((1-t)²(1+2t) u0 + t²(3-2t) u1), u the unit normals at the ends.
//!
//! The extremes are not looked for anew in every step: each goes one step of Newton's method of its own, d' = p'·n and
//! d'' = p''·n + κ(p'·T)²/(1+κd), and its distance is corrected by d'²/(2d''), so that what is left is of third order. Then it goes
//! where the new handles move it, by -(∂d'/∂k · δk)/d'', and no step moves an extreme far: on a short segment k0 - k1 hardly changes
//! the peak and moves the extremes much. It begins where the problem to first order ([`start`]) ends; where that does not settle, the
//! extremes of the circle's segment are looked for, and where the search does not, those of each step.

mod served;
mod start;
#[cfg(test)]
mod tests;

pub(crate) use served::largest_angle;

use kurbo::{CubicBez, ParamCurve, ParamCurveDeriv, Vec2};

use super::{Degree, Method, Piece, Span, minimax};
use crate::angle::Angle;
use crate::curve::with_handles;
use crate::error::{MethodError, Remedy, Result};
use crate::numeric::foot::{Foot, foot_by_excess};
use crate::numeric::{linear, root};
use crate::shape::Axes;

/// Two or three steps reach the last digits, more where the extremes have far to go.
const MOST_STEPS: usize = 24;

/// The farthest that an extreme goes in a step: by trial the one of which most searches settle.
const LONGEST_STEP: f64 = 0.03;

/// What an extreme may be off at the end: its distance is off by the cube.
const IN_PLACE: f64 = 1e-4;

/// A step that ends the search.
const SETTLED: f64 = 1e-9;

/// The places among which the three extremes are looked for.
const PLACES: u32 = 24;

/// How far from the ends they lie at least.
const FIRST_PLACE: f64 = 0.5 / PLACES as f64;

/// Below this peak, over the larger radius, the distance is rounding noise, and the circle's handles are as good.
const FINEST: f64 = 1e-13;

/// About what part of the peak is left where the ends may leave the ellipse.
const FREE_PEAK: f64 = 0.7;

/// The signs of the distance at the extremes.
const SIGNS: [f64; 3] = [1.0, -1.0, 1.0];

/// The two handles of a segment, and its peak error over the larger radius.
#[derive(Debug, Clone, Copy)]
struct FittedHandles {
    handles: [f64; 2],
    peak: f64,
}

/// An extreme of the distance between the ends, one step of Newton's method from where it was looked for.
struct NearExtreme {
    t: f64,
    distance: f64,
    /// The normal where it was looked for, and how that turns with t.
    outward: Vec2,
    turning: Vec2,
    /// d''; infinite, as `moved`, where the distance bends the other way, so that there is no such extreme near.
    bends: f64,
    moved: f64,
}

/// The point at t and the two derivatives there.
fn derivatives(cubic: &CubicBez, t: f64) -> [Vec2; 3] {
    let s = 1.0 - t;
    let [a, b, c] = [
        cubic.p1 - cubic.p0,
        cubic.p2 - cubic.p1,
        cubic.p3 - cubic.p2,
    ];
    [
        cubic.p0.to_vec2() + (a * (1.0 + s + s * s) + b * (t * (1.0 + 2.0 * s)) + c * (t * t)) * t,
        (a * (s * s) + b * (2.0 * s * t) + c * (t * t)) * 3.0,
        ((b - a) * s + (c - b) * t) * 6.0,
    ]
}

/// A segment of the ellipse whose short axis, from the origin to (`short`, 0), lies along x and whose larger radius is 1.
struct EllipseSegment {
    radii: Vec2,
    /// The points of the unit circle at both ends.
    ends: [Vec2; 2],
    is_free: bool,
}

impl EllipseSegment {
    fn new(short: f64, from: f64, size: f64, is_free: bool) -> Self {
        Self {
            radii: Vec2::new(short, 1.0),
            ends: [from, from + size].map(|degrees| Angle::from_degrees(degrees).direction()),
            is_free,
        }
    }

    fn on_ellipse(&self, v: Vec2) -> Vec2 {
        Vec2::new(self.radii.x * v.x, self.radii.y * v.y)
    }

    /// The derivatives by the parametric angle at both ends.
    fn tangents(&self) -> [Vec2; 2] {
        self.ends.map(|u| self.on_ellipse(Vec2::new(-u.y, u.x)))
    }

    fn cubic(&self, fit: &FittedHandles) -> CubicBez {
        let inside = if self.is_free { fit.peak } else { 0.0 };
        // On an axis the unit normal is the direction itself.
        let [p0, p3] = self.ends.map(|u| self.on_ellipse(u) - u * inside);
        let [t0, t1] = self.tangents();
        let handles = [t0 * fit.handles[0], t1 * fit.handles[1]];
        with_handles([p0, p3].map(Vec2::to_point), handles)
    }

    fn foot(&self, p: Vec2) -> Foot {
        let relative = Vec2::new(p.x / self.radii.x, p.y);
        foot_by_excess(self.radii, p, relative.hypot2() - 1.0).foot
    }

    /// The parameters of the three extremes of the distance between the ends, if there are three.
    fn extremes(&self, cubic: &CubicBez) -> Option<[f64; 3]> {
        let derivative = cubic.deriv();
        let slope = |t: f64| {
            derivative
                .eval(t)
                .to_vec2()
                .dot(self.foot(cubic.eval(t).to_vec2()).outward)
        };
        let place = |i: u32| f64::from(i) / f64::from(PLACES);
        let mut found = [0.0; 3];
        let mut count = 0;
        let mut before = slope(FIRST_PLACE);
        let mut from = FIRST_PLACE;
        for i in 1..=PLACES {
            let to = if i == PLACES {
                1.0 - FIRST_PLACE
            } else {
                place(i)
            };
            let after = slope(to);
            if (before > 0.0) != (after > 0.0) {
                *found.get_mut(count)? = root(slope, from, to);
                count += 1;
            }
            (before, from) = (after, to);
        }
        (count == 3).then_some(found)
    }

    /// The extreme near t.
    fn extreme(&self, cubic: &CubicBez, t: f64, sign: f64) -> NearExtreme {
        let [p, velocity, acceleration] = derivatives(cubic, t);
        let Foot { distance, outward } = self.foot(p);
        // The radius of curvature where the normal is n: a²b²/h³, h² = a²nx² + b²ny².
        let bend = self.on_ellipse(outward).hypot() / self.radii.x;
        let curvature = bend * bend * bend * self.radii.x;
        let slope = velocity.dot(outward);
        let along = outward.cross(velocity);
        let turning = curvature * along / (1.0 + curvature * distance);
        let bends = acceleration.dot(outward) + turning * along;
        let is_extreme = bends * sign < 0.0;
        let step = if is_extreme {
            (-slope / bends).clamp(-LONGEST_STEP, LONGEST_STEP)
        } else {
            0.0
        };
        NearExtreme {
            t: t + step,
            distance: distance + 0.5 * slope * step,
            outward,
            turning: Vec2::new(-outward.y, outward.x) * turning,
            bends: if is_extreme { bends } else { f64::INFINITY },
            moved: if is_extreme {
                step.abs()
            } else {
                f64::INFINITY
            },
        }
    }

    /// One step of Newton's method with the extremes near these times, which go a step too, and whether all has settled.
    fn step(&self, fit: &FittedHandles, times: &mut [f64; 3]) -> Option<(FittedHandles, bool)> {
        let cubic = self.cubic(fit);
        let [t0, t1] = self.tangents();
        let mut rows = [[0.0; 3]; 3];
        let mut misses = [0.0; 3];
        // d' of each extreme by k0 and k1, over -d''.
        let mut pulls = [[0.0; 2]; 3];
        let mut farthest = 0.0_f64;
        for (i, time) in times.iter_mut().enumerate() {
            let sign = SIGNS[i];
            let extreme = self.extreme(&cubic, *time, sign);
            let NearExtreme {
                outward: n,
                turning,
                bends,
                ..
            } = extreme;
            farthest = farthest.max(extreme.moved);
            *time = extreme.t;
            let (s, t) = (1.0 - extreme.t, extreme.t);
            let [first, last] = [3.0 * t * s * s, -3.0 * t * t * s];
            let inward = if self.is_free {
                let [u0, u1] = self.ends.map(|u| n.dot(u));
                s * s * (1.0 + 2.0 * t) * u0 + t * t * (3.0 - 2.0 * t) * u1
            } else {
                0.0
            };
            rows[i] = [first * n.dot(t0), last * n.dot(t1), -sign - inward];
            misses[i] = sign * fit.peak - extreme.distance;
            let [rise, fall] = [3.0 * s * (1.0 - 3.0 * t), -3.0 * t * (2.0 - 3.0 * t)];
            pulls[i] = [
                -(rise * n.dot(t0) + first * turning.dot(t0)) / bends,
                -(fall * n.dot(t1) + last * turning.dot(t1)) / bends,
            ];
        }
        let [k0, k1, peak] = linear::solve(rows, misses)?;
        let moves = pulls.map(|[by_k0, by_k1]| by_k0 * k0 + by_k1 * k1);
        let longest = moves
            .iter()
            .fold(0.0_f64, |longest, x| longest.max(x.abs()));
        let part = if longest > LONGEST_STEP {
            LONGEST_STEP / longest
        } else {
            1.0
        };
        for (time, by) in times.iter_mut().zip(moves) {
            *time += part * by;
        }
        let next = FittedHandles {
            handles: [fit.handles[0] + part * k0, fit.handles[1] + part * k1],
            peak: fit.peak + part * peak,
        };
        // The next step would move by about the square.
        let has_settled = part == 1.0 && k0.abs().max(k1.abs()) < SETTLED && farthest < IN_PLACE;
        Some((next, has_settled))
    }

    /// The best handles, from the circle's; off the ellipse, from the best on it.
    fn fit(&self, span: &Span) -> Option<FittedHandles> {
        if self.is_free {
            let on_ellipse = Self {
                is_free: false,
                ..*self
            }
            .fit(span)?;
            return self.improved(FittedHandles {
                peak: FREE_PEAK * on_ellipse.peak,
                ..on_ellipse
            });
        }
        let k = minimax::handle(span);
        self.improved(FittedHandles {
            handles: [k, k],
            peak: minimax::error(span).peak(),
        })
    }

    /// The best handles from these.
    fn improved(&self, fit: FittedHandles) -> Option<FittedHandles> {
        if fit.peak < FINEST {
            return Some(fit);
        }
        let first_order = || (!self.is_free).then(|| self.start(fit.handles))?;
        let looked_for = || Some((fit, self.extremes(&self.cubic(&fit))?));
        let (start, times) = first_order().or_else(looked_for)?;
        self.settled(start, times, false)
            .or_else(|| self.settled(fit, times, true))
    }

    /// The best handles from these, where they settle, the extremes followed from these times or looked for in each step.
    fn settled(
        &self,
        mut fit: FittedHandles,
        mut times: [f64; 3],
        looks: bool,
    ) -> Option<FittedHandles> {
        for _ in 0..MOST_STEPS {
            if looks {
                times = self.extremes(&self.cubic(&fit))?;
            }
            let (next, has_settled) = self.step(&fit, &mut times)?;
            fit = next;
            if has_settled {
                let [first, middle, last] = times;
                let are_inside = FIRST_PLACE < first
                    && first < middle
                    && middle < last
                    && last < 1.0 - FIRST_PLACE;
                let serves = are_inside
                    && fit.peak > 0.0
                    && fit.handles.iter().all(|k| (0.0..2.0).contains(k));
                return serves.then_some(fit);
            }
        }
        None
    }
}

/// The best handles of a segment that begins `from` degrees after an end of the short axis; `None` where the method does not serve.
fn best(short: f64, from: f64, size: f64, is_free: bool) -> Option<FittedHandles> {
    (size <= largest_angle(short)?).then_some(())?;
    EllipseSegment::new(short, from, size, is_free).fit(&Span::from_degrees(size))
}

/// The least peak of such a segment over the larger radius.
pub(crate) fn peak(short: f64, from: f64, size: f64) -> Option<f64> {
    let fit = best(short, from, size, false)?;
    if fit.peak >= FINEST {
        return Some(fit.peak);
    }
    // The circle's own; it weighs on the short segment as it does in the middle.
    let middle = Angle::from_degrees(from + size / 2.0).direction();
    Some(fit.peak / libm::hypot(middle.x / short, middle.y))
}

/// The pieces of an ellipse with these axes between joints at these angles, in degrees. Each piece comes as [`super::Rule::pieces`] gives it.
///
/// # Errors
///
/// [`crate::Error::Impossible`] beyond what is served, and for the free variant unless
/// the ellipse is closed and cut into quarters on its axes.
pub(crate) fn pieces(
    method: Method,
    axes: Axes,
    angles: &[f64],
    is_closed: bool,
) -> Result<Vec<[Piece; 2]>> {
    let Axes { short, angle: axis } = axes;
    let is_free = method == Method::MinimaxEllipseFree;
    let on_axes = angles.iter().all(|angle| (angle - axis) % 90.0 == 0.0);
    if is_free && !(is_closed && angles.len() == 5 && on_axes) {
        return Err(method.refuse(
            MethodError::OnlyQuartersOfEllipses,
            Remedy::Quarters(&["minimax-ellipse", "minimax"]),
        ));
    }
    let piece = |pair: &[f64]| {
        let sweep = pair[1] - pair[0];
        // Upwards, which leaves the distances as they are.
        let from = 1.0_f64.copysign(sweep) * (pair[0] - axis);
        let Some(fit) = best(short, from, sweep.abs(), is_free) else {
            return Err(served::refusal(method, short, sweep.abs()));
        };
        let end = |degrees: f64, k: f64| {
            // The larger radius is 1; on an axis the radius is the axis'.
            let is_short = (degrees - axis) % 180.0 == 0.0;
            let radius = if is_short { short } else { 1.0 };
            let end_radius = if is_free {
                1.0 - fit.peak / radius
            } else {
                1.0
            };
            Piece {
                degree: Degree::Cubic,
                end_radius,
                handle: Vec2::new(end_radius, k),
            }
        };
        Ok([end(pair[0], fit.handles[0]), end(pair[1], fit.handles[1])])
    };
    angles.windows(2).map(piece).collect()
}

impl Method {
    /// Whether the pieces depend on the ellipse that they are placed on.
    #[must_use]
    pub(crate) const fn sees_ellipse(self) -> bool {
        matches!(self, Self::MinimaxEllipse | Self::MinimaxEllipseFree)
    }
}
