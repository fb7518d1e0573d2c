//! How near cubics are to an arc, and whether they are drawn as one is.

use kurbo::{Affine, CubicBez, ParamCurve as _, PathSeg, Point, Vec2};

use crate::Angle;
use crate::curve::first_direction;
use crate::number::digits::EXACT_POWERS;
use crate::number::{Precision, decimals_of};
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Given, Truth};

/// What a rough constant, such as 0.55, may have done to a point, as a part of the radius.
const HANDLE_PART: f64 = 1.3e-3;

/// The largest part of the size of an arc that the rounding of a file explains: with whole numbers anything looks like a circle of a few units.
const ROUNDED_PART: f64 = 0.05;

/// How far a handle may be longer or shorter than the usual one, as a part of it: quadratics of an eighth of a turn differ by 4 %.
const LENGTH_PART: f64 = 0.08;

/// How far a control point may lie from where the arc has it, in units of what the rounding of the file moves a point: it and the end
/// that it is counted from are rounded.
pub(crate) const MARGIN: f64 = 1.2;

/// The largest turn at a joint that rounding explains, in degrees: anything beyond is a corner, which stays.
pub(super) const LARGEST_TURN: f64 = 8.0;

/// How many decimals more than the file radii may have.
pub(super) const MORE_DECIMALS: u8 = 3;

/// How many times the tolerance one cubic may lie from the circle through its ends and its middle: from the circle that was meant, which
/// is looked for next, a balanced one lies half as far.
pub(super) const THROUGH_MIDDLE: f64 = 2.0;

/// tan 8 degrees.
const TANGENT_OF_TURN: f64 = 0.140_540_834_702_391_45;

/// What a run is to keep to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rules {
    /// The tolerance as a part of the [`size`] of an arc, which is added to the absolute one.
    pub(crate) part: f64,
    /// The absolute tolerance.
    pub(crate) absolute: f64,
    /// The decimals of the file.
    pub(crate) decimals: u8,
    /// Whether an arc may be one of an ellipse.
    pub(crate) elliptic: bool,
    /// Whether cubics count as an arc only where their control points are those of one but for the rounding of the file, and not
    /// where they happen to lie near it.
    pub(crate) drawn_only: bool,
    /// How many characters the command of an arc may take without its end point in place of a single cubic: with more it would be the longer
    /// text.
    pub(crate) longest: usize,
}

impl Rules {
    /// How far an arc of this size may lie from its cubics.
    pub(crate) fn room(&self, size: f64) -> f64 {
        let absolute = if self.part > 0.0 {
            self.absolute.min(ROUNDED_PART * size)
        } else {
            self.absolute
        };
        self.part * size + absolute
    }

    /// The same where joints and directions say by themselves what was meant: files without a tolerance may stray by what a rough constant does.
    pub(crate) fn of_what_is_meant(&self) -> Self {
        let part = if self.drawn_only && self.part > 0.0 {
            self.part.max(HANDLE_PART)
        } else {
            self.part
        };
        Self { part, ..*self }
    }

    /// The most decimals that the text has room for in place of so many cubics; `None` where it has none for the radius.
    ///
    /// Besides both radii an arc has at least a letter, a rotation and two flags, with what parts these, and where the second radius does not
    /// begin with its point what parts that.
    pub(super) fn most_decimals(&self, count: usize, radius: f64) -> Option<u8> {
        if count > 1 {
            return Some(u8::MAX);
        }
        // The radius that is meant may be a bit smaller, and have a digit less.
        let whole = whole_digits(0.9 * radius);
        let room = self.longest.saturating_sub(7 + usize::from(whole > 0)) / 2;
        let rest = room.checked_sub(whole)?;
        Some(u8::try_from(rest.saturating_sub(1)).unwrap_or(u8::MAX))
    }

    /// Whether there is room for the text of an arc in place of a single cubic.
    pub(super) fn has_room_for(&self, given: &SvgArc) -> bool {
        // The letter, and both flags with what parts them from what is before each.
        let (mut length, mut last) = (1 + 2 * 2, Spelled::default());
        for (index, number) in [given.radii.x, given.radii.y, given.rotation.degrees()]
            .into_iter()
            .enumerate()
        {
            let spelled = Spelled::of(number);
            let is_parted =
                index > 0 && !spelled.is_negative && !(spelled.begins_with_point && last.has_point);
            length += spelled.length + usize::from(is_parted);
            last = spelled;
        }
        length <= self.longest
    }

    /// How far the rounding of the file moves a point.
    pub(crate) fn moved(&self) -> f64 {
        Precision::Fixed(self.decimals).farthest_moved()
    }

    /// The room of cubics whose ends and directions say what was meant, where so much is explained by how they stray.
    pub(super) fn room_of_what_is_meant(&self, size: f64, explained: f64) -> f64 {
        let meant = self.of_what_is_meant();
        meant.room(size).min(explained.max(meant.part * size))
    }

    /// How far the rounding of the file moves a handle, whose both ends are rounded.
    pub(super) fn moved_handle(&self) -> f64 {
        2.0 * self.moved()
    }

    /// How far a control point may lie from where an arc of this size has it.
    pub(crate) fn slack(&self, size: f64) -> f64 {
        MARGIN * self.moved() + HANDLE_PART * size
    }
}

/// How many digits a number has before its point, none where that is 0.
fn whole_digits(size: f64) -> usize {
    let powers = EXACT_POWERS.iter();
    powers.take_while(|power| **power <= size).count()
}

/// How a number is spelled that has few decimals.
#[derive(Debug, Clone, Copy, Default)]
struct Spelled {
    /// In characters.
    length: usize,
    is_negative: bool,
    begins_with_point: bool,
    has_point: bool,
}

impl Spelled {
    fn of(number: f64) -> Self {
        let (size, decimals) = (number.abs(), usize::from(decimals_of(number)));
        let whole = whole_digits(size);
        let (has_point, is_negative) = (decimals > 0, number < 0.0);
        Self {
            length: (whole + usize::from(has_point) + decimals).max(1) + usize::from(is_negative),
            is_negative,
            begins_with_point: has_point && whole == 0 && !is_negative,
            has_point,
        }
    }
}

/// What the distance of an arc from its cubics is compared with: the larger radius, or the length of the run where that is less. From
/// a sweep of 60 degrees on it is the radius; a flat arc of a huge radius is no larger than it looks.
pub(super) fn size(cubics: &[CubicBez], radius: f64) -> f64 {
    let Some([from, on, to]) = ends_and_middle(cubics) else {
        return radius;
    };
    size_of([from, on, to], radius)
}

/// The same by the ends of the run and its middle.
#[inline]
pub(super) fn size_of([from, on, to]: [Point; 3], radius: f64) -> f64 {
    let sides = [
        from.distance_squared(to),
        from.distance_squared(on),
        on.distance_squared(to),
    ];
    radius.min(sides.into_iter().fold(0.0, f64::max).sqrt())
}

/// The first point of a run, the one in its middle and its last.
pub(super) fn ends_and_middle(cubics: &[CubicBez]) -> Option<[Point; 3]> {
    let middle = cubics.get(cubics.len() / 2)?;
    let on = if cubics.len().is_multiple_of(2) {
        middle.p0
    } else {
        middle.eval(0.5)
    };
    Some([cubics.first()?.p0, on, cubics.last()?.p3])
}

/// Whether two cubics join without a corner.
pub(super) fn joins_smoothly(pair: &[CubicBez]) -> bool {
    let [a, b] = [pair[0], pair[1]].map(PathSeg::Cubic);
    let (u, v) = (-first_direction(&a.reverse()), first_direction(&b));
    u.cross(v).abs() <= TANGENT_OF_TURN * u.dot(v)
}

pub(super) fn larger(arc: &Arc) -> f64 {
    arc.radii.x.max(arc.radii.y)
}

/// Whether cubics are drawn as an arc is: their control points lie where it has them, up to what rounding and other constants do.
pub(super) fn is_drawn_like(cubics: &[CubicBez], arc: &Arc, rules: &Rules) -> bool {
    unlike(cubics, arc, rules.slack(size(cubics, larger(arc)))) <= 0.0
}

/// Whether the ends of cubics lie on an arc and their handles along it, up to rounding: then it was meant, whatever constant they have.
pub(super) fn leaves_its_ends_like(cubics: &[CubicBez], arc: &Arc, rules: &Rules) -> bool {
    unlike(cubics, arc, rules.moved_handle()) <= 0.0
}

/// Whether cubics are drawn as a circle is of which their joints are known to lie on it.
pub(super) fn handles_are_like(cubics: &[CubicBez], arc: &Arc, rules: &Rules) -> bool {
    let slack = rules.moved_handle() + HANDLE_PART * size(cubics, larger(arc));
    unlike(cubics, arc, slack) <= 0.0
}

/// How much farther off than so far control points lie from where an arc has them at most; not positive where none does.
fn unlike(cubics: &[CubicBez], arc: &Arc, slack: f64) -> f64 {
    let to_unit = to_unit(arc);
    let from_unit = to_unit.inverse();
    let on = |p: Point| ((to_unit * p).to_vec2().hypot2().sqrt() - 1.0).abs() * larger(arc) - slack;
    let control = |end: Point, control: Point, unit: Vec2, length: f64| {
        let tip = unit + length * Vec2::new(-unit.y, unit.x);
        let (own, ideal) = (
            control - end,
            from_unit * tip.to_point() - from_unit * unit.to_point(),
        );
        let length = ideal.hypot2().sqrt();
        let (along, across) = (own.dot(ideal) / length, own.cross(ideal) / length);
        unlike_by(along - length, across, length, slack)
    };
    let worst = cubics.iter().map(|cubic| {
        let [u, v] = [cubic.p0, cubic.p3].map(|p| (to_unit * p).to_vec2());
        let length = 4.0 / 3.0 * libm::tan(libm::atan2(u.cross(v), u.dot(v)) / 4.0);
        let joints = larger_of(on(cubic.p0), on(cubic.p3));
        let controls = larger_of(
            control(cubic.p0, cubic.p1, u, length),
            control(cubic.p3, cubic.p2, v, -length),
        );
        larger_of(joints, controls)
    });
    worst.fold(f64::NEG_INFINITY, larger_of)
}

/// How much farther off a handle is than it may be that is longer by so much, and so far across the tangent.
#[inline]
pub(super) fn unlike_by(longer: f64, across: f64, length: f64, slack: f64) -> f64 {
    larger_of(
        across.abs() - slack,
        longer.abs() - slack - LENGTH_PART * length,
    )
}

/// The larger of two numbers; infinite where one is none.
fn larger_of(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

/// How many times as far as the top of an arc what its control points are compared with moves, at most, where its ends stay: over a chord of 2
/// a top at the height u has its control points at (1 - 2/3 (1 - u²), 4/3 u), and their direction turns by 2/(1 + u²) times as much as u grows.
const CONTROLS: f64 = 6.0;

/// The widest sweep of one cubic, in degrees, whose handles say whether it may be an arc.
const WIDEST: f64 = 170.0;

/// The circles through the ends of a run, of which one was found.
pub(super) struct Pencil {
    /// The middle of the chord, and the unit vector to where the centre of an arc of less than half a turn is.
    base: Point,
    across: Vec2,
    /// The square of half the chord.
    square: f64,
    is_large: bool,
    /// A point of the run on the circle that was found.
    on: Point,
    rules: Rules,
    /// How high the arc is that was found, and how unlike it the cubics are.
    height: f64,
    unlike: f64,
}

impl Pencil {
    /// `None` of an ellipse, and where one cubic turns by about half a turn, beyond which it is not compared with what it should be.
    pub(super) fn new(cubics: &[CubicBez], found: &Arc, rules: &Rules) -> Option<Self> {
        let [from, on, to] = ends_and_middle(cubics)?;
        let (chord, sweep) = (to - from, found.sweep.degrees());
        if found.radii.x != found.radii.y || cubics.len() == 1 && sweep.abs() > WIDEST {
            return None;
        }
        let mut pencil = Self {
            base: from.midpoint(to),
            across: Vec2::new(-chord.y, chord.x) * (sweep.signum() / chord.hypot2().sqrt()),
            square: 0.25 * chord.hypot2(),
            is_large: sweep.abs() > 180.0,
            on,
            rules: rules.of_what_is_meant(),
            height: 0.0,
            unlike: unlike(cubics, found, rules.slack(size(cubics, larger(found)))),
        };
        pencil.height = pencil.height_and_off(found.radii.x)[0];
        Some(pencil)
    }

    /// How high the arc of a radius is, and how far the point that was found on one lies from it.
    fn height_and_off(&self, radius: f64) -> [f64; 2] {
        let depth = (radius * radius - self.square).max(0.0).sqrt();
        let radius = (self.square + depth * depth).sqrt();
        let depth = if self.is_large { -depth } else { depth };
        let center = self.base + self.across * depth;
        let out = self.on.distance_squared(center).sqrt();
        [radius - depth, (out - radius).abs()]
    }

    /// Whether the arc of a radius may be near enough, and the cubics be drawn like it: a look that lets none of these go.
    pub(super) fn allows(&self, radius: f64) -> bool {
        let [height, off] = self.height_and_off(radius);
        let (noise, size) = (1e-12 * radius, radius.max(self.square.sqrt()));
        off <= self.rules.room(size) + noise
            && self.unlike <= CONTROLS * (height - self.height).abs() + noise
    }
}

/// Whether the arc leaves its ends as the cubics do, so that a smooth joint stays one.
pub(super) fn is_tangent(cubics: &[CubicBez], arc: &Arc) -> bool {
    let (Some(first), Some(last)) = (cubics.first(), cubics.last()) else {
        return false;
    };
    let (to_unit, sign) = (to_unit(arc), arc.sweep.degrees().signum());
    let from_unit = to_unit.inverse();
    let cosine = libm::cos(LARGEST_TURN.to_radians());
    let agrees = |p: Point, direction: Vec2| {
        let out = (to_unit * p).to_vec2();
        let tangent =
            from_unit * Point::new(-sign * out.y, sign * out.x) - from_unit * Point::ORIGIN;
        let lengths = (tangent.hypot2() * direction.hypot2()).sqrt();
        tangent.dot(direction) >= cosine * lengths
    };
    agrees(first.p0, first_direction(&PathSeg::Cubic(*first)))
        && agrees(last.p3, -first_direction(&PathSeg::Cubic(*last).reverse()))
}

/// The arc of an ellipse from the beginning of a run to its end.
pub(super) fn swept(cubics: &[CubicBez], ellipse: &Truth) -> Option<Arc> {
    let to_unit = ellipse.placement().inverse();
    let mut swept = 0.0;
    for cubic in cubics {
        let [u, m, v] = [cubic.p0, cubic.eval(0.5), cubic.p3].map(|p| (to_unit * p).to_vec2());
        swept += libm::atan2(u.cross(m), u.dot(m)) + libm::atan2(m.cross(v), m.dot(v));
    }
    let from = cubics.first()?.p0;
    let start = (to_unit * from).to_vec2();
    Some(Arc {
        center: ellipse.center,
        radii: ellipse.radii,
        rotation: Angle::of(ellipse.axis),
        start: Angle::of(start),
        sweep: Angle::from_radians(swept),
        ends: Some([from, cubics.last()?.p3]),
        given: Given::Sweep,
    })
}

pub(super) fn to_unit(arc: &Arc) -> Affine {
    if arc.radii.x == arc.radii.y {
        let scale = 1.0 / arc.radii.x;
        let center = arc.center.to_vec2() * -scale;
        return Affine::new([scale, 0.0, 0.0, scale, center.x, center.y]);
    }
    arc.truth().placement().inverse()
}

/// How far a few points of the cubics lie from the arc's ellipse, on a circle; seen from its centre, on another one.
pub(super) fn strays(cubics: &[CubicBez], arc: &Arc) -> f64 {
    let (to_unit, radius) = (to_unit(arc), larger(arc));
    let off = |p: Point| ((to_unit * p).to_vec2().hypot2().sqrt() - 1.0).abs();
    let points = cubics
        .iter()
        .flat_map(|c| [c.p0, c.eval(0.25), c.eval(0.5), c.eval(0.75), c.p3]);
    points.map(off).fold(0.0, f64::max) * radius
}

/// A bound of how far an arc lies from itself after its ends were rounded.
pub(super) fn moved(before: &Arc, after: &Arc) -> f64 {
    let (Some(old), Some(new)) = (before.ends, after.ends) else {
        return 0.0;
    };
    let ends = old[0].distance(new[0]).max(old[1].distance(new[1]));
    if ends == 0.0 {
        return 0.0;
    }
    let radii = before.radii - after.radii;
    ends + before.center.distance(after.center) + radii.x.abs().max(radii.y.abs())
}
