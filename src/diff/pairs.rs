//! Which subpaths of two drawings belong together.

use std::collections::HashMap;

use kurbo::Rect;

use super::{Difference, Distance, FarthestPlace, Pair, Side, Track};
use crate::error::{Error, Result, UnmeasurableError};
use crate::measure::hausdorff::{Aim, Effort, hausdorff};

/// How far the bound may lie above the distance, as a part of it.
const GOAL: f64 = 1e-4;

/// How much is done in all: some ten seconds.
pub(super) const MOST_STEPS: u64 = 300_000_000;

/// How many subpaths of like boxes are tried for one.
const MOST_TRIES: usize = 8;

/// How many pairs of boxes are looked at; beyond it, subpaths are taken in their order.
const MOST_PAIRS: usize = 20_000_000;

struct Matcher<'a> {
    old: &'a [Track],
    new: &'a [Track],
    boxes: [Vec<Rect>; 2],
    difference: &'a mut Difference,
    steps: Effort,
    /// The pairs that were measured and do not fit.
    measured: HashMap<(usize, usize), Pair>,
}

/// Finds them in so many steps.
pub(super) fn find(
    old: &[Track],
    new: &[Track],
    difference: &mut Difference,
    steps: u64,
) -> Result<()> {
    let boxes = [old, new].map(|tracks| tracks.iter().map(Track::bounding_box).collect());
    let mut matcher = Matcher {
        old,
        new,
        boxes,
        difference,
        steps: Effort(steps),
        measured: HashMap::new(),
    };
    let mut rest: [Vec<usize>; 2] = [(0..old.len()).collect(), (0..new.len()).collect()];
    matcher.in_order(&mut rest);
    if rest[0].len() * rest[1].len() <= MOST_PAIRS {
        matcher.within_the_tolerance(&mut rest);
        matcher.nearest(&mut rest);
    }
    let together = rest[0].len().min(rest[1].len());
    for (&old, &new) in rest[0].iter().zip(&rest[1]) {
        let pair = matcher.pair(old, new);
        matcher.difference.pairs.push(pair);
    }
    matcher.difference.only_old = rest[0].split_off(together);
    matcher.difference.only_new = rest[1].split_off(together);
    matcher.difference.pairs.sort_by_key(|pair| pair.old);
    if matcher.steps.0 == 0 {
        return Err(Error::Unmeasurable(UnmeasurableError::Entangled));
    }
    Ok(())
}

impl Matcher<'_> {
    fn pair(&mut self, old: usize, new: usize) -> Pair {
        if let Some(pair) = self.measured.remove(&(old, new)) {
            return pair;
        }
        let (a, b) = (&self.old[old], &self.new[new]);
        Pair {
            old,
            new,
            distance: distance(a, b, self.difference.tolerance, &mut self.steps),
            closed_differently: a.closed != b.closed,
        }
    }

    /// How far the boxes lie apart: no subpath lies nearer to another.
    fn box_distance(&self, old: usize, new: usize) -> f64 {
        let (a, b) = (self.boxes[0][old], self.boxes[1][new]);
        let sides = [a.x0 - b.x0, a.y0 - b.y0, a.x1 - b.x1, a.y1 - b.y1];
        sides
            .into_iter()
            .fold(0.0, |most, side| side.abs().max(most))
    }

    /// What the boxes of two subpaths within the tolerance may differ by.
    fn slack(&self, old: usize, new: usize) -> f64 {
        self.difference.tolerance
            + self.old[old].strayed
            + self.new[new].strayed
            + 16.0 * self.difference.noise
    }

    fn try_pair(&mut self, old: usize, new: usize) -> bool {
        if self.box_distance(old, new) > self.slack(old, new) {
            return false;
        }
        let pair = self.pair(old, new);
        let fits = self.difference.allows(&pair);
        if fits {
            self.difference.pairs.push(pair);
        } else {
            self.measured.insert((old, new), pair);
        }
        fits
    }

    fn in_order(&mut self, rest: &mut [Vec<usize>; 2]) {
        let together = self.old.len().min(self.new.len());
        let fits: Vec<bool> = (0..together).map(|i| self.try_pair(i, i)).collect();
        for side in rest {
            side.retain(|&i| !fits.get(i).is_some_and(|&fits| fits));
        }
    }

    fn within_the_tolerance(&mut self, [olds, news]: &mut [Vec<usize>; 2]) {
        olds.retain(|&old| {
            let like = |&&new: &&usize| self.box_distance(old, new) <= self.slack(old, new);
            let tries: Vec<usize> = news.iter().filter(like).take(MOST_TRIES).copied().collect();
            let found = tries.into_iter().find(|&new| self.try_pair(old, new));
            news.retain(|&new| Some(new) != found);
            found.is_none()
        });
    }

    /// What is left, each with the subpath of the nearest box.
    fn nearest(&mut self, [olds, news]: &mut [Vec<usize>; 2]) {
        while !olds.is_empty() && !news.is_empty() && olds.len() * news.len() <= MOST_PAIRS {
            let old = olds.remove(0);
            let nearer = |a: &&usize, b: &&usize| {
                self.box_distance(old, **a)
                    .total_cmp(&self.box_distance(old, **b))
            };
            let Some(&new) = news.iter().min_by(nearer) else {
                return;
            };
            news.retain(|&other| other != new);
            let pair = self.pair(old, new);
            self.difference.pairs.push(pair);
        }
    }
}

/// The distance of two subpaths, the larger of both ways.
fn distance(old: &Track, new: &Track, tolerance: f64, steps: &mut Effort) -> Distance {
    let are_equal = old.segments == new.segments && old.closed == new.closed;
    if are_equal {
        return Distance::default();
    }
    let aim = Aim::new(tolerance, GOAL);
    let apart = hausdorff(steps, [&old.segments, &new.segments], aim);
    let Some((point, segment)) = apart.place else {
        return Distance::default();
    };
    let (side, track) = if apart.on_second {
        (Side::New, new)
    } else {
        (Side::Old, old)
    };
    Distance {
        at_most: apart.at_most + old.strayed + new.strayed,
        place: Some(FarthestPlace {
            point,
            side,
            segment: track.steps.get(segment).copied().unwrap_or(segment),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::contours;
    use kurbo::Affine;

    #[test]
    fn what_takes_too_many_steps_is_refused() {
        let track = |data| Track::new(&contours(data).unwrap()[0], Affine::IDENTITY).unwrap();
        let old = [track("M0 0C9 9 0 9 9 0C0 5 5 0 0 0")];
        let new = [track("M1 0C9 8 0 8 9 1C0 5 5 1 0 0")];
        let found = |steps| find(&old, &new, &mut Difference::default(), steps);
        let refusal = Error::Unmeasurable(UnmeasurableError::Entangled);
        assert_eq!(found(100), Err(refusal));
        assert_eq!(found(100_000), Ok(()));
    }

    #[test]
    fn a_part_that_passes_a_joint_is_not_halved_down_to_it() {
        let track = |data| Track::new(&contours(data).unwrap()[0], Affine::IDENTITY).unwrap();
        let old = [track("M5 0A5 5 0 0 1-5 0A5 5 0 0 1 5 0Z")];
        let new = [track(
            "M5 0C5 2.76 2.76 5 0 5C-2.76 5-5 2.76-5 0C-5-2.76-2.76-5 0-5C2.76-5 5-2.76 5 0Z",
        )];
        let found = find(&old, &new, &mut Difference::default(), MOST_STEPS / 6000);
        assert_eq!(found, Ok(()));
    }
}
