//! Arcs that go on along one circle, all of them with the radius that their cubics together say.
//!
//! Each run alone says little where its cubics are short or its ends are rounded: over half a turn the ends decide, and two runs of one circle may
//! say two radii. The circle nearest to all of their points knows better. Between which joints its arcs run is chosen so that they
//! are near enough with the round radius, in no more arcs than before.

use kurbo::{CubicBez, ParamCurve as _, Point};

use super::near::{MARGIN, MORE_DECIMALS, Rules, handles_are_like, joins_smoothly, size, strays};
use super::recognize::{Found, is_enlarged, is_of_an_arc, near_enough, run};
use super::turn::UprightEllipse;
use crate::measure::fit::nearest_circle;
use crate::number::{decimals_of, round};

/// The most arcs that are looked at together.
const MOST_ARCS: usize = 16;

/// The most cubics that are looked at together.
const MOST_CUBICS: usize = 1000;

/// How many arcs a whole turn may become so that they have a rounder radius.
const MOST_OF_A_TURN: usize = 4;

/// How many times as far as rounding moves a point the next cubic of a circle may lie from the circle of the first one.
const SEEN: f64 = 4.0;

/// The most joints between which arcs are sought.
const MOST_JOINTS: usize = 24;

/// The arcs at the beginning of a chain; of a whole turn its halves, where its joints let it.
pub(crate) fn arcs(cubics: &[CubicBez], rules: &Rules) -> Vec<Found> {
    let Some(found) = run(cubics, rules) else {
        return Vec::new();
    };
    let mut arcs = halves(cubics, &found, rules).unwrap_or_else(|| vec![found]);
    let known = arcs.len();
    if !is_circular(&arcs[0]) {
        return arcs;
    }
    go_on(cubics, &mut arcs, rules);
    if let Some(whole) = turn_after(cubics, &arcs)
        && let Some(together) = together(whole, &arcs, rules)
    {
        return together;
    }
    for few in (1..=arcs.len()).rev() {
        let arcs = &arcs[..few];
        if let Some(together) = together(&cubics[..taken(arcs)], arcs, rules) {
            return together;
        }
    }
    arcs.truncate(known);
    arcs
}

fn is_circular(found: &Found) -> bool {
    found.given.radii.x == found.given.radii.y
}

/// How many cubics arcs take.
fn taken(arcs: &[Found]) -> usize {
    arcs.iter().map(|found| found.count).sum()
}

/// The index of the first cubic that ends where the arc begins.
fn returning<'a>(mut cubics: impl Iterator<Item = &'a CubicBez>, found: &Found) -> Option<usize> {
    let near = 1e-9 * found.given.radii.x.max(found.given.radii.y);
    let from = found.given.from;
    cubics.position(|cubic| cubic.p3.distance_squared(from) <= near * near)
}

/// The whole turn that arcs and the cubics after them are.
fn turn_after<'a>(cubics: &'a [CubicBez], arcs: &[Found]) -> Option<&'a [CubicBez]> {
    // What is left of a turn after 350 degrees takes no more than it took so far.
    let count = taken(arcs);
    let rest = cubics[count..].iter().take(2 * count);
    let last = returning(rest, arcs.first()?)?;
    Some(&cubics[..=count + last])
}

/// The halves of a whole turn, where a run and the cubics after it are one.
fn halves(cubics: &[CubicBez], found: &Found, rules: &Rules) -> Option<Vec<Found>> {
    let whole = turn_after(cubics, core::slice::from_ref(found))?;
    let (first, second) = whole.split_at(whole.len() / 2);
    let rules = unlimited(rules);
    let half =
        |cubics: &[CubicBez]| run(cubics, &rules).filter(|found| found.count == cubics.len());
    let (first, second) = (half(first)?, half(second)?);
    (first.given.radii == second.given.radii).then(|| vec![first, second])
}

/// The rules without a limit of the text: after an arc that is known, what the next one takes is too.
const fn unlimited(rules: &Rules) -> Rules {
    Rules {
        longest: usize::MAX,
        ..*rules
    }
}

/// Appends what may go on along the circle of the first arc, for a turn at most.
fn go_on(cubics: &[CubicBez], arcs: &mut Vec<Found>, rules: &Rules) {
    let (rules, first) = (unlimited(rules), arcs[0]);
    let (mut cubics, mut end) = (cubics, taken(arcs));
    // With whole numbers the circle of one cubic may lie far from that of the next.
    let near = rules.of_what_is_meant().room(first.arc.radii.x) + SEEN * rules.moved();
    let is_near = |p: Point| {
        let out = p.distance_squared(first.arc.center).sqrt();
        (out - first.arc.radii.x).abs() <= near
    };
    while end < cubics.len()
        && arcs.len() < MOST_ARCS
        && joins_smoothly(&cubics[end - 1..=end])
        && is_near(cubics[end].p3)
        && is_near(cubics[end].eval(0.5))
    {
        let goes_on = |next: &Found| is_circular(next) && next.given.sweep == first.given.sweep;
        let Some(mut next) = run(&cubics[end..], &rules).filter(goes_on) else {
            break;
        };
        if let Some(last) = returning(cubics[end..end + next.count].iter(), &first) {
            cubics = &cubics[..=end + last];
            match run(&cubics[end..], &rules).filter(goes_on) {
                Some(rest) => next = rest,
                None => break,
            }
        }
        end += next.count;
        arcs.push(next);
    }
}

/// The arcs of one circle in place of those that were found one by one, where all of their cubics say a radius that is rounder or more even.
fn together(cubics: &[CubicBez], arcs: &[Found], rules: &Rules) -> Option<Vec<Found>> {
    let is_served = (2..=MOST_CUBICS).contains(&cubics.len());
    if !is_served || !cubics.windows(2).all(joins_smoothly) {
        return None;
    }
    let first = arcs.first()?.given;
    let is_even = arcs
        .iter()
        .all(|found| found.given.radii == first.radii && keeps_its_radius(found));
    let least = least(cubics);
    if is_even && arcs.len() <= least && round(first.radii.x, 0) == first.radii.x {
        return None;
    }
    let points = RunPoints::of(cubics, arcs)?;
    let known = is_even
        .then(|| points.explain(first.radii.x, rules))
        .flatten();
    let most = if is_even && known.is_none() {
        rules.decimals.saturating_add(MORE_DECIMALS)
    } else {
        let decimals = arcs.iter().map(|found| decimals_of(found.given.radii.x));
        decimals.max()?
    };
    let mut tried = [0.0; 2];
    for decimals in 0..=most {
        for (guess, tried) in points.guesses.into_iter().zip(&mut tried) {
            let radius = round(guess, decimals);
            if core::mem::replace(tried, radius) == radius || radius <= 0.0 {
                continue;
            }
            let is_known = known.is_some() && radius == first.radii.x;
            if is_known && arcs.len() <= least {
                return None;
            }
            let explained = if is_known {
                known
            } else {
                points.explain(radius, rules)
            };
            let Some((turn, wide)) = explained else {
                continue;
            };
            // A whole shape is worth some arcs more that have a rounder radius, or the same one.
            let few = match least {
                2 if decimals < most || !is_even => arcs.len().max(MOST_OF_A_TURN),
                _ => arcs.len() - usize::from(is_known),
            };
            let split = turns(cubics, &turn, &wide)
                .then(|| split(cubics, &turn, &wide, (arcs, few)))
                .flatten();
            if split.is_some() || is_known {
                return split;
            }
        }
    }
    None
}

/// Whether the ends of an arc are no farther apart than its diameter, so that no renderer enlarges it.
fn keeps_its_radius(found: &Found) -> bool {
    !is_enlarged(&found.given, &found.arc)
}

/// Points of a run.
struct RunPoints {
    joints: Vec<Point>,
    /// Joints and others.
    all: Vec<Point>,
    /// How far they lie from the circle nearest to them.
    off: f64,
    /// The radius of the circle nearest to the joints, and of that one.
    guesses: [f64; 2],
    /// How far some point lies, at least, from any circle that is larger by one.
    least: f64,
}

impl RunPoints {
    fn of(cubics: &[CubicBez], arcs: &[Found]) -> Option<Self> {
        let closed = cubics.first()?.p0 == cubics.last()?.p3;
        let last = cubics.last().filter(|_| !closed).map(|cubic| cubic.p3);
        let joints: Vec<Point> = cubics.iter().map(|cubic| cubic.p0).chain(last).collect();
        let others = cubics
            .iter()
            .flat_map(|cubic| [0.25, 0.5, 0.75].map(|t| cubic.eval(t)));
        let all: Vec<Point> = joints.iter().copied().chain(others).collect();
        let (center, radius) = nearest_circle(&all, None)?;
        let by_joints = nearest_circle(&joints, None).map_or(radius, |(_, radius)| radius);
        // Of an arc of half the sweep h such a circle lies 1 - s cos a from it where its centre moves by s: by ±(1 - cos h)/(1 + cos h)
        // at its top and its ends if that is least, and from a quarter turn on by 1.
        let sweep: f64 = arcs.iter().map(|found| found.arc.sweep.degrees()).sum();
        let cos = libm::cos(0.5 * sweep.to_radians().abs().min(core::f64::consts::PI)).max(0.0);
        Some(Self {
            least: (1.0 - cos) / (1.0 + cos),
            off: farthest(&all, center, radius),
            guesses: [by_joints, radius],
            joints,
            all,
        })
    }

    /// The circle of a radius on which the run lies, and the rules for its arcs: where it lies there as near as it does to any, or where its joints
    /// do up to rounding. The constant of the handles may then be a rough one, such as 0.55, by which files without a tolerance stray.
    fn explain(&self, radius: f64, rules: &Rules) -> Option<(UprightEllipse, Rules)> {
        let turn = |center| UprightEllipse {
            center,
            radii: kurbo::Vec2::splat(radius),
        };
        let most = MARGIN * (self.off + rules.moved());
        if self.least * (radius - self.guesses[1]).abs() > self.off + 2.0 * most {
            return None;
        }
        let (center, _) = nearest_circle(&self.joints, Some(radius))
            .or_else(|| nearest_circle(&self.all, Some(radius)))?;
        if farthest(&self.joints, center, radius) <= MARGIN * rules.moved() {
            return Some((turn(center), rules.of_what_is_meant()));
        }
        let (center, _) = nearest_circle(&self.all, Some(radius))?;
        let explained = MARGIN * self.off + rules.moved();
        let is_explained = farthest(&self.all, center, radius) <= explained;
        is_explained.then(|| (turn(center), *rules))
    }
}

/// Whether cubics are drawn as arcs of a circle near their joints.
fn turns(cubics: &[CubicBez], turn: &UprightEllipse, rules: &Rules) -> bool {
    turn.arc(cubics).is_some_and(|arc| {
        let room = rules.room(size(cubics, arc.radii.x));
        strays(cubics, &arc) <= room && handles_are_like(cubics, &arc, rules)
    })
}

/// How far points lie from a circle.
fn farthest(points: &[Point], center: Point, radius: f64) -> f64 {
    let off = |p: &Point| (p.distance_squared(center).sqrt() - radius).abs();
    points.iter().map(off).fold(0.0, f64::max)
}

/// The fewest arcs that a run can become.
fn least(cubics: &[CubicBez]) -> usize {
    let ends = cubics.first().zip(cubics.last());
    1 + usize::from(ends.is_some_and(|(first, last)| first.p0 == last.p3))
}

/// The arcs of a circle that the cubics are, no more than so many: between the joints of those that are known, or the fewest.
fn split(
    cubics: &[CubicBez],
    turn: &UprightEllipse,
    rules: &Rules,
    (known, few): (&[Found], usize),
) -> Option<Vec<Found>> {
    let arc = |from: usize, to: usize| {
        let cubics = &cubics[from..to];
        let (given, swept) = turn.between(cubics)?;
        if !is_of_an_arc(swept) {
            return None;
        }
        near_enough(cubics, given, rules, None).filter(keeps_its_radius)
    };
    let alike = || {
        if taken(known) != cubics.len() || known.len() > few {
            return None;
        }
        let mut start = 0;
        let arcs = known.iter().map(|found| {
            let from = start;
            start += found.count;
            arc(from, start)
        });
        arcs.collect()
    };
    let fewest = || fewest(cubics.len(), few, &arc);
    if known.len() > least(cubics) {
        fewest().or_else(alike)
    } else {
        alike().or_else(fewest)
    }
}

/// The fewest arcs, of those the most even ones, between joints of so many cubics, up to so many arcs.
fn fewest(
    count: usize,
    most: usize,
    arc: &impl Fn(usize, usize) -> Option<Found>,
) -> Option<Vec<Found>> {
    let step = count.div_ceil(MOST_JOINTS);
    let joints: Vec<usize> = (0..count).step_by(step).chain([count]).collect();
    // The best way to each joint: how many arcs, how uneven they are, and the last of them with the joint before it.
    let mut ways: Vec<Option<(usize, usize, usize, Found)>> = vec![None; joints.len()];
    for to in 1..joints.len() {
        for from in 0..to {
            let (arcs, uneven) = match ways[from] {
                _ if from == 0 => (0, 0),
                Some((arcs, uneven, ..)) => (arcs, uneven),
                None => continue,
            };
            let uneven = uneven + (joints[to] - joints[from]).pow(2);
            let is_better = ways[to].is_none_or(|way| (arcs + 1, uneven) < (way.0, way.1));
            if arcs < most
                && is_better
                && let Some(found) = arc(joints[from], joints[to])
            {
                ways[to] = Some((arcs + 1, uneven, from, found));
            }
        }
    }
    let mut arcs = Vec::new();
    let mut at = joints.len() - 1;
    while at > 0 {
        let (_, _, from, found) = ways[at]?;
        arcs.push(found);
        at = from;
    }
    arcs.reverse();
    Some(arcs)
}
