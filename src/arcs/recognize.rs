//! Runs of cubics that are one arc of a circle or an ellipse, with the round radii that their author meant.
//!
//! A circle is sought through the ends and the middle of a run. An ellipse comes from one cubic p0, p1, p2, p3 with the middle m:
//! let its end tangents meet in q, M be the middle of p0 and p3, and s the part of the way from M to q at which m lies. As an arc of
//! a conic it has the weight w = s/(1 - s), the cosine of half its sweep, and
//!
//! c = (M - w² q)/(1 - w²),  e₁ = m - c,  e₂ = (p3 - p0)/(2 sqrt(1 - w²))
//!
//! are its centre and two conjugate half diameters. With A = (e₁ e₂) the eigenvalues of A Aᵀ are the squares of its radii.

use core::cell::Cell;

use kurbo::{CubicBez, PathSeg, Vec2};

use super::bound::{is_surely_within, is_within, roughly_from_arc};
use super::diameters::ellipse_of;
use super::glance::{Glance, glance, goes_on_along, is_askew, strays_from};
pub(crate) use super::near::{MARGIN, Rules};
use super::near::{
    MORE_DECIMALS, Pencil, THROUGH_MIDDLE, ends_and_middle, is_drawn_like, is_tangent,
    joins_smoothly, larger, leaves_its_ends_like, size, strays, swept,
};
use crate::Angle;
use crate::curve::first_direction;
use crate::number::{Precision, decimals_of, round};
use crate::shape::endpoint::{SvgArc, through};
use crate::shape::{Arc, Shape, Truth};

/// The least and the largest sweep of an arc, in degrees: less does not determine its radius, and with more its ends are so close
/// that the last bits of a renderer move its centre.
const SWEEPS: [f64; 2] = [4.0, 350.0];

/// Half a turn and the noise of a computed sweep, in degrees.
pub(super) const HALF_TURN: f64 = 180.0 + 1e-9;

/// The part of the tolerance by which a radius is rounded that nobody meant.
const NEAR_PART: f64 = 0.3;

/// What rounding may do to a distance, as a part of it.
const NOISE: f64 = 1e-12;

/// A run of cubics that is one arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    /// How many cubics it takes.
    pub(crate) count: usize,
    /// The arc by its ends, with radii of few decimals.
    pub(crate) given: SvgArc,
    /// The same arc by its centre.
    pub(crate) arc: Arc,
}

impl Found {
    /// A bound, both ways, of its distance from the cubics, or what is known already where that is no less.
    pub(crate) fn strayed(&self, cubics: &[CubicBez], known: f64) -> f64 {
        if is_surely_within(cubics, &self.arc, known) {
            known
        } else {
            roughly_from_arc(cubics, &self.arc).max(known)
        }
    }
}

/// The longest run of the cubics, from the first, that is one arc; of a whole turn no more than 350 degrees.
pub(super) fn run(cubics: &[CubicBez], rules: &Rules) -> Option<Found> {
    match glance(cubics, rules) {
        Glance::Nothing => None,
        Glance::Ellipse(rough) => along_ellipse(cubics, &rough, rules),
        Glance::Unknown => closer(cubics, rules),
    }
}

/// The same without a first look.
pub(super) fn closer(cubics: &[CubicBez], rules: &Rules) -> Option<Found> {
    let (first, _) = cubics.split_first()?;
    if let Some(alone) = circle_of(&cubics[..1], rules) {
        let circle = |count| circle_of(&cubics[..count], rules);
        return longest(cubics, rules, Some(alone), circle);
    }
    if !rules.elliptic {
        return None;
    }
    along_ellipse(cubics, &ellipse_of(first, rules)?, rules)
}

/// The longest run that is an arc of about this ellipse, of which the first cubic is one.
fn along_ellipse(cubics: &[CubicBez], rough: &Truth, rules: &Rules) -> Option<Found> {
    // What one cubic says of its ellipse is too little for those after it, unless it is known by its round numbers.
    let only = &cubics[..1];
    let is_smooth = !is_alone(cubics);
    let has_room = Cell::new(true);
    let alone = meant(only, &placed(only, rough)?, rules, |given| {
        has_room.set(has_room.get() && rules.has_room_for(given));
        match has_room.get() {
            true => Worth::Look,
            false if !is_smooth => Worth::NoMore,
            false if goes_on_along(cubics, given, rules) => Worth::Look,
            false => Worth::None,
        }
    })?;
    let ellipse = alone.arc.truth();
    longest(cubics, rules, None, |count| {
        let run = &cubics[..count];
        placed(run, &ellipse).filter(|arc| strays(run, arc) <= rules.room(size(run, larger(arc))))
    })
}

/// The run of most cubics for which `arc_of` gives an arc that survives a closer look; that of the first one may be known.
fn longest(
    cubics: &[CubicBez],
    rules: &Rules,
    first: Option<Arc>,
    arc_of: impl Fn(usize) -> Option<Arc>,
) -> Option<Found> {
    let smooth = cubics.windows(2).take_while(|pair| joins_smoothly(pair));
    // Doubling, then halving: the longest run takes as many looks as its length has bits.
    let mut smooth = smooth.fuse();
    let (mut best, mut most, mut step, mut growing) = (1, 1, 1, true);
    let mut longest = first;
    while step > 0 {
        while most < best + step && smooth.next().is_some() {
            most += 1;
        }
        let longer = (best + step <= most).then(|| arc_of(best + step)).flatten();
        if longer.is_some() {
            longest = longer;
            best += step;
            step = if growing { 2 * step } else { step / 2 };
        } else {
            growing = false;
            step /= 2;
        }
    }
    let is_alone = is_alone(cubics);
    let worth = |given: &SvgArc| {
        if !is_alone || rules.has_room_for(given) {
            Worth::Look
        } else {
            Worth::None
        }
    };
    let fewer = core::iter::successors(Some(best), |&count| {
        (count > 1).then_some(count.div_ceil(2))
    });
    let mut fewer = fewer.map(|count| (count, longest.take().or_else(|| arc_of(count))));
    fewer.find_map(|(count, found)| meant(&cubics[..count], &found?, rules, worth))
}

/// Whether no run goes on after the first of the cubics.
fn is_alone(cubics: &[CubicBez]) -> bool {
    cubics.get(..2).is_none_or(|pair| !joins_smoothly(pair))
}

/// Whether an arc with some decimals is worth a closer look.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Worth {
    Look,
    /// It is not, but one of more decimals may be.
    None,
    /// None of more decimals is.
    NoMore,
}

/// The arc that is meant: of all radii with which the cubics are drawn like an arc those with the fewest decimals; else those with as
/// many as the tolerance needs.
fn meant(
    cubics: &[CubicBez],
    found: &Arc,
    rules: &Rules,
    worth: impl Fn(&SvgArc) -> Worth,
) -> Option<Found> {
    let limit = if found.radii.x == found.radii.y {
        rules.most_decimals(cubics.len(), found.radii.x)?
    } else {
        u8::MAX
    };
    let most = rules.decimals.saturating_add(MORE_DECIMALS);
    let explained = MARGIN * strays(cubics, found) + rules.moved();
    // What the tangents say does not depend on the constant of the cubics; what the middle says, not on the rounding of handles.
    let guesses = [by_tangents(cubics, found), Some(*found)];
    let pencil = Pencil::new(cubics, found, rules);
    let mut tried = [0.0; 2];
    for decimals in 0..=most.min(limit) {
        for (guess, tried) in guesses.iter().flatten().zip(&mut tried) {
            if let Some(pencil) = &pencil {
                let radius = round(guess.radii.x, decimals);
                if core::mem::replace(tried, radius) == radius || !pencil.allows(radius) {
                    continue;
                }
            }
            let Some(given) = rounded(cubics, guess, decimals) else {
                continue;
            };
            // One that is only near may be shorter.
            if rules.drawn_only {
                match worth(&given) {
                    Worth::Look => {}
                    Worth::None => continue,
                    Worth::NoMore => return None,
                }
            }
            let drawn = near_enough(cubics, given, rules, Some(explained));
            if drawn.is_some() {
                return drawn;
            }
        }
    }
    if rules.drawn_only {
        return None;
    }
    // Nobody meant a radius that is only near: it is rounded by little, however wide the tolerance is.
    let least = Precision::moving_at_most(
        NEAR_PART * rules.room(size(cubics, larger(found))),
        larger(found),
    );
    let Precision::Fixed(least) = least else {
        return None;
    };
    (least..=most.max(least)).find_map(|decimals| {
        let given = rounded(cubics, found, decimals)?;
        let has_room = limit == u8::MAX || decimals_of(given.radii.x) <= limit;
        has_room.then(|| near_enough(cubics, given, rules, None))?
    })
}

/// The arc, where it is near enough to the cubics, and, where that much is explained, these are drawn like it.
pub(super) fn near_enough(
    cubics: &[CubicBez],
    given: SvgArc,
    rules: &Rules,
    explained: Option<f64>,
) -> Option<Found> {
    if let [cubic] = cubics {
        let larger = given.radii.x.max(given.radii.y);
        let most = explained.map_or(rules.room(larger), |explained| {
            rules.room_of_what_is_meant(larger, explained)
        });
        if strays_from(cubic, &given) > most {
            return None;
        }
    }
    let Ok(Shape::Arc(arc)) = given.shape() else {
        return None;
    };
    let size = size(cubics, larger(&arc));
    let off = strays(cubics, &arc);
    let mut room = rules.room(size);
    if let Some(explained) = explained {
        // A radius that is too small for its ends is drawn larger: what was meant is that one.
        if larger(&arc) - given.radii.x.max(given.radii.y) > explained {
            return None;
        }
        if !(off <= explained.min(room) && is_drawn_like(cubics, &arc, rules)) {
            room = rules.room_of_what_is_meant(size, explained);
            if !(off <= room && leaves_its_ends_like(cubics, &arc, rules)) {
                return None;
            }
        }
    }
    if !(off <= room && is_tangent(cubics, &arc)) {
        return None;
    }
    let count = cubics.len();
    is_within(cubics, &arc, room).then_some(Found { count, given, arc })
}

/// Whether the ends of an arc of a circle are farther apart than its diameter, by more than rounding, so that it is drawn larger.
pub(super) fn is_enlarged(given: &SvgArc, arc: &Arc) -> bool {
    arc.radii.x == arc.radii.y && arc.radii.x > given.radii.x * (1.0 + NOISE)
}

/// The arc of a circle with the radius that the directions at its ends give: half the chord over the sine of half the turn.
fn by_tangents(cubics: &[CubicBez], arc: &Arc) -> Option<Arc> {
    if arc.radii.x != arc.radii.y {
        return None;
    }
    let (first, last) = (cubics.first()?, cubics.last()?);
    let u = first_direction(&PathSeg::Cubic(*first));
    let v = -first_direction(&PathSeg::Cubic(*last).reverse());
    let half = libm::sin(libm::atan2(u.cross(v), u.dot(v)) / 2.0).abs();
    let radius = last.p3.distance_squared(first.p0).sqrt() / (2.0 * half);
    radius.is_finite().then_some(Arc {
        radii: Vec2::splat(radius),
        ..*arc
    })
}

/// The arc between the run's ends with rounded radii, upright where it is nearly so.
fn rounded(cubics: &[CubicBez], arc: &Arc, decimals: u8) -> Option<SvgArc> {
    let radii = Vec2::new(round(arc.radii.x, decimals), round(arc.radii.y, decimals));
    let rotation = if radii.x == radii.y {
        0.0
    } else {
        round(arc.rotation.degrees(), decimals.saturating_sub(1))
    };
    (radii.x > 0.0 && radii.y > 0.0).then_some(SvgArc {
        from: cubics.first()?.p0,
        radii,
        rotation: Angle::from_degrees(rotation),
        large_arc: arc.sweep.degrees().abs() > HALF_TURN,
        sweep: arc.sweep.degrees() > 0.0,
        to: cubics.last()?.p3,
    })
}

/// The arc of a circle through the ends and the middle of a run, where its cubics stay near it.
fn circle_of(cubics: &[CubicBez], rules: &Rules) -> Option<Arc> {
    let [from, on, to] = ends_and_middle(cubics)?;
    // Of an ellipse a wider look would make a circle.
    let times = if cubics.len() == 1 && !rules.elliptic {
        THROUGH_MIDDLE
    } else {
        1.0
    };
    let room = |radius: f64| times * rules.room(size(cubics, radius));
    if from == to || is_askew(cubics, |size| times * rules.room(size)) {
        return None;
    }
    let Ok(Shape::Arc(arc)) = through(from, on, to) else {
        return None;
    };
    let fits = is_of_an_arc(arc.sweep) && strays(cubics, &arc) <= room(larger(&arc));
    fits.then_some(arc)
}

/// Whether an arc may sweep so far.
pub(super) fn is_of_an_arc(sweep: Angle) -> bool {
    let [least, most] = SWEEPS;
    (least..=most).contains(&sweep.degrees().abs())
}

/// The arc of an ellipse from the beginning of a run to its end, where it is long enough.
fn placed(cubics: &[CubicBez], ellipse: &Truth) -> Option<Arc> {
    swept(cubics, ellipse).filter(|arc| is_of_an_arc(arc.sweep))
}
