//! A first look at a cubic that begins no arc, as nearly all do in drawings that have none to be found.
//!
//! It asks what the closer look of [`recognize`](super::recognize) asks, without an angle: of a circle through both ends with its centre on
//! one side tan(sweep/4) is half the chord over the radius and the distance of the centre from it. What is too near to call goes on.

use kurbo::{CubicBez, ParamCurve as _, Point, Vec2};

use super::diameters::ellipse_of;
use super::near::{
    MARGIN, MORE_DECIMALS, Rules, THROUGH_MIDDLE, ends_and_middle, joins_smoothly, size_of,
    unlike_by,
};
use crate::number::digits::EXACT_POWERS;
use crate::shape::Truth;
use crate::shape::endpoint::SvgArc;

/// What rounding may do to a distance, as a part of the radius, and to what it is compared with, as a part of that.
const NOISE: f64 = 1e-11;

/// What part of a step of the last decimal a radius may be off that is rounded.
const TIE: f64 = 1e-3;

/// tan(sweep/4) of the sweeps that surely are those of an arc, and of a minor one.
const BULGES: [f64; 2] = [0.0176, 0.91];

/// The circle through three points.
#[derive(Debug, Clone, Copy)]
pub(super) struct CircleThrough {
    pub(super) center: Point,
    pub(super) radius: f64,
}

impl CircleThrough {
    /// Not finite where the points lie on a line.
    #[inline]
    pub(super) fn through(from: Point, on: Point, to: Point) -> Self {
        let (u, v) = (on - from, to - from);
        let cross = 2.0 * u.cross(v);
        let out = Vec2::new(
            v.y * u.hypot2() - u.y * v.hypot2(),
            u.x * v.hypot2() - v.x * u.hypot2(),
        ) / cross;
        Self {
            center: from + out,
            radius: out.hypot2().sqrt(),
        }
    }

    /// How far a point lies from it.
    #[inline]
    pub(super) fn off(&self, p: Point) -> f64 {
        (self.center.distance_squared(p).sqrt() - self.radius).abs()
    }
}

/// What a first look says of a run that may begin with the first of some cubics.
#[derive(Debug)]
pub(super) enum Glance {
    /// The closer look finds none.
    Nothing,
    /// It finds an arc of about this ellipse, or none.
    Ellipse(Box<Truth>),
    /// It has to say.
    Unknown,
}

pub(super) fn glance(cubics: &[CubicBez], rules: &Rules) -> Glance {
    let [cubic, ..] = cubics else {
        return Glance::Nothing;
    };
    let look = CubicLook::new(cubic);
    let (room, noise) = (look.room(rules), NOISE * look.circle.radius);
    if look.off > room + noise {
        let ellipse = rules.elliptic.then(|| ellipse_of(cubic, rules)).flatten();
        return ellipse.map_or(Glance::Nothing, |ellipse| {
            Glance::Ellipse(Box::new(ellipse))
        });
    }
    // Written so that what is not a number goes on to the closer look.
    let is_clear = look.off < room - noise && look.is_minor() && rules.drawn_only;
    if !is_clear || goes_on(cubics, rules) || look.may_be_meant(rules) {
        Glance::Unknown
    } else {
        Glance::Nothing
    }
}

/// Whether the first two cubics may be one arc of a circle.
fn goes_on(cubics: &[CubicBez], rules: &Rules) -> bool {
    let Some(pair) = cubics.get(..2) else {
        return false;
    };
    joins_smoothly(pair) && !is_askew(pair, |size| rules.room(size))
}

/// Whether cubics cannot be the arc of a circle through their ends and their middle, as one look at a few more points of them says.
pub(super) fn is_askew(cubics: &[CubicBez], room: impl Fn(f64) -> f64) -> bool {
    let Some([from, on, to]) = ends_and_middle(cubics) else {
        return false;
    };
    let circle = CircleThrough::through(from, on, to);
    let room = room(size_of([from, on, to], circle.radius)) + NOISE * circle.radius;
    // Written so that what is not a number goes on to the closer look.
    let is_off = |p: Point| circle.off(p) > room;
    cubics
        .iter()
        .any(|cubic| is_off(cubic.p3) || is_off(cubic.eval(0.25)) || is_off(cubic.eval(0.75)))
}

/// How far, at least, a few points of a cubic lie from an arc between its ends.
pub(super) fn strays_from(cubic: &CubicBez, given: &SvgArc) -> f64 {
    // Where the radii are too small the closer look decides.
    EllipseOfArc::of(given).map_or(0.0, |ellipse| {
        [0.25, 0.5, 0.75]
            .map(|t| ellipse.off(cubic.eval(t)))
            .into_iter()
            .fold(0.0, f64::max)
    })
}

/// Whether the cubic after the first one may go on along the ellipse of an arc that the first one is.
pub(super) fn goes_on_along(cubics: &[CubicBez], given: &SvgArc, rules: &Rules) -> bool {
    let [_, next, ..] = cubics else {
        return false;
    };
    let room = rules.room(given.radii.x.max(given.radii.y));
    EllipseOfArc::of(given).is_none_or(|ellipse| {
        let is_near = |p: Point| ellipse.off(p) <= room;
        is_near(next.p3) && is_near(next.eval(0.5))
    })
}

/// The ellipse of an arc, seen from its start.
struct EllipseOfArc {
    from: Point,
    axis: Vec2,
    radii: Vec2,
    /// The centre, where it is the unit circle.
    center: Vec2,
}

impl EllipseOfArc {
    /// `None` where the radii are too small for the ends.
    #[inline]
    fn of(given: &SvgArc) -> Option<Self> {
        let mut ellipse = Self {
            from: given.from,
            axis: given.rotation.direction(),
            radii: given.radii,
            center: Vec2::ZERO,
        };
        let half = 0.5 * ellipse.unit(given.to);
        let square = half.hypot2();
        let depth = ((1.0 - square) / square).sqrt();
        let depth = if given.large_arc == given.sweep {
            -depth
        } else {
            depth
        };
        ellipse.center = half + Vec2::new(-half.y, half.x) * depth;
        (!depth.is_nan()).then_some(ellipse)
    }

    #[inline]
    fn unit(&self, p: Point) -> Vec2 {
        let v = p - self.from;
        Vec2::new(
            v.dot(self.axis) / self.radii.x,
            self.axis.cross(v) / self.radii.y,
        )
    }

    /// How far a point lies from it, at least, in lengths of the larger radius where it is the unit circle.
    #[inline]
    fn off(&self, p: Point) -> f64 {
        let off = (self.unit(p) - self.center).hypot2().sqrt() - 1.0;
        (off.abs() - NOISE) * self.radii.x.max(self.radii.y)
    }
}

/// A cubic and the circle through its ends and its middle.
struct CubicLook<'a> {
    cubic: &'a CubicBez,
    quarters: [Point; 2],
    on: Point,
    circle: CircleThrough,
    /// How far the cubic lies from it.
    off: f64,
    /// The middle of the chord, and half of that.
    base: Point,
    half: f64,
}

impl<'a> CubicLook<'a> {
    #[inline]
    fn new(cubic: &'a CubicBez) -> Self {
        let on = cubic.eval(0.5);
        let circle = CircleThrough::through(cubic.p0, on, cubic.p3);
        let quarters = [cubic.eval(0.25), cubic.eval(0.75)];
        Self {
            cubic,
            quarters,
            on,
            circle,
            off: quarters
                .map(|p| circle.off(p))
                .into_iter()
                .fold(0.0, f64::max),
            base: cubic.p0.midpoint(cubic.p3),
            half: 0.5 * cubic.p0.distance_squared(cubic.p3).sqrt(),
        }
    }

    fn size(&self, radius: f64) -> f64 {
        size_of([self.cubic.p0, self.on, self.cubic.p3], radius)
    }

    fn room(&self, rules: &Rules) -> f64 {
        let times = if rules.elliptic { 1.0 } else { THROUGH_MIDDLE };
        times * rules.room(self.size(self.circle.radius))
    }

    /// Whether the sweep is that of an arc, and surely less than half a turn.
    fn is_minor(&self) -> bool {
        let depth = self.circle.center - self.base;
        let bulge = self.half / (self.circle.radius + depth.hypot2().sqrt());
        (self.on - self.base).dot(depth) < 0.0 && BULGES[0] < bulge && bulge < BULGES[1]
    }

    /// Whether any radius of few decimals may be one with which the cubic was drawn.
    fn may_be_meant(&self, rules: &Rules) -> bool {
        let Some(limit) = rules.most_decimals(1, self.circle.radius) else {
            return false;
        };
        let most = rules.decimals.saturating_add(MORE_DECIMALS).min(limit);
        let chord = (self.cubic.p3 - self.cubic.p0) / (2.0 * self.half);
        // From the chord to the centre.
        let across = Vec2::new(-chord.y, chord.x);
        let across = across * across.dot(self.circle.center - self.base).signum();
        let explained = MARGIN * self.off + rules.moved();
        let allows = |radius: f64| self.allows(radius, across, explained, rules);
        let guesses = [self.radius_by_tangents(), self.circle.radius];
        let mut tried = [[0.0; 2]; 2];
        for power in EXACT_POWERS.iter().take(usize::from(most) + 1) {
            for (guess, tried) in guesses.iter().zip(&mut tried) {
                let steps = guess * power;
                let candidates = [steps - TIE, steps + TIE].map(|steps| steps.round() / power);
                if core::mem::replace(tried, candidates) != candidates
                    && (allows(candidates[0])
                        || candidates[1] != candidates[0] && allows(candidates[1]))
                {
                    return true;
                }
            }
        }
        false
    }

    /// The radius that the directions at the ends give; infinite where there is none.
    fn radius_by_tangents(&self) -> f64 {
        let (u, v) = (self.cubic.p1 - self.cubic.p0, self.cubic.p3 - self.cubic.p2);
        let lengths = (u.hypot2() * v.hypot2()).sqrt();
        // sin(a/2) = |sin a| / (2 cos(a/2)).
        let cosine = (0.5 + 0.5 * u.dot(v) / lengths).sqrt();
        let sine = 0.5 * u.cross(v).abs() / (lengths * cosine);
        self.half / sine
    }

    /// Whether the cubic may be drawn like the arc of this radius.
    fn allows(&self, radius: f64, across: Vec2, explained: f64, rules: &Rules) -> bool {
        if radius == 0.0 {
            return false;
        }
        let depth = (radius * radius - self.half * self.half).max(0.0).sqrt();
        let circle = CircleThrough {
            center: self.base + across * depth,
            radius: radius.max(self.half),
        };
        let noise = NOISE * circle.radius;
        let size = self.size(circle.radius);
        let most = rules.room_of_what_is_meant(size, explained) + noise;
        let off = circle.off(self.on);
        if off > most {
            return false;
        }
        let [before, after] = self.quarters.map(|p| circle.off(p));
        let off = off.max(before).max(after);
        if off > most {
            return false;
        }
        let bulge = self.half / (circle.radius + depth);
        let length = 4.0 / 3.0 * bulge * circle.radius;
        let slack = if off <= explained.min(rules.room(size)) + noise {
            rules.slack(size).max(rules.moved_handle())
        } else {
            rules.moved_handle()
        } + noise;
        let is_unlike = |end: Point, control: Point| {
            let out = (end - circle.center) / circle.radius;
            let own = control - end;
            let (along, across) = (own.cross(out).abs(), own.dot(out).abs());
            unlike_by(along - length, across, length, slack) > 0.0
        };
        !(is_unlike(self.cubic.p0, self.cubic.p1) || is_unlike(self.cubic.p3, self.cubic.p2))
    }
}
