//! Segments as long as the true error lets them be, one after the other, where estimates of it are too rough to tell the least count.

use crate::approximate::{Request, Sketch};
use crate::joints::Joints;
use crate::joints::adaptive::Balance;
use crate::measure::radial;
use crate::place::Placed;
use crate::shape::UnitArc;

/// Up to this many segments are looked at so.
const MOST: usize = 32;

/// The ratio of the lengths that are tried, from the largest down, and how often the step to the first that serves is halved.
const STEP: f64 = 1.1;
const HALVINGS: u32 = 8;

/// The shortest length that is tried, in degrees.
const SHORTEST: f64 = 1.0;

/// The parts of a tolerance, from the largest on, for which they are marched out: where there is a sharp end, as long a segment as can be may
/// leave the next one a worse start.
const PARTS: [f64; 4] = [1.0, 0.93, 0.8, 0.6];

/// How often the error that takes as many segments is narrowed down, from this part of what is allowed on.
const NARROWINGS: u32 = 5;
const LEAST: f64 = 0.5;

impl Request<'_> {
    /// Fewer segments than this count within the tolerance, where there are such.
    pub(super) fn fewer_truly(
        &self,
        balance: &Balance,
        count: usize,
        tolerance: f64,
    ) -> Option<Sketch> {
        if count > MOST {
            return None;
        }
        let parts = if balance.is_sharp() { PARTS.len() } else { 1 };
        // A closed shape's end is its start.
        let ways: &[bool] = if self.outline.unit.closed {
            &[false]
        } else {
            &[false, true]
        };
        ways.iter().find_map(|&is_back| {
            let march = March {
                request: self,
                balance,
                whole: self.outline.unit.sweep.degrees().abs(),
                is_back,
            };
            let mut parts = PARTS[..parts].iter();
            parts.find_map(|part| march.fewest(count - 1, part * tolerance, tolerance))
        })
    }
}

/// A march along an arc, from its start or from its end on.
struct March<'a> {
    request: &'a Request<'a>,
    balance: &'a Balance,
    whole: f64,
    is_back: bool,
}

impl March<'_> {
    /// The fewest segments, at most so many, of about the least error that takes no more of them, and such as mirror one another where
    /// that does.
    fn fewest(&self, most: usize, mut limit: f64, tolerance: f64) -> Option<Sketch> {
        let request = self.request;
        let within = |ways: &[f64]| {
            let joints = Joints::after(&request.outline.unit, ways);
            request.within(joints, None, tolerance).ok()?
        };
        let ways = self.ways(limit, most)?;
        let mut fewest = ways.len() - 1;
        let mut found = within(&ways);
        let (mut low, mut high) = (LEAST * limit, limit);
        for _ in 0..NARROWINGS {
            limit = (low * high).sqrt();
            let Some(ways) = self.ways(limit, fewest) else {
                low = limit;
                continue;
            };
            high = limit;
            let pairs = ways.iter().zip(ways.iter().rev());
            let even: Vec<f64> = pairs
                .map(|(way, back)| f64::midpoint(*way, self.whole - back))
                .collect();
            if let Some(nearer) = within(&even).or_else(|| within(&ways)) {
                fewest = ways.len() - 1;
                found = Some(nearer);
            }
        }
        found
    }

    /// The ways to the joints from the start of the arc, ascending, both ends included; `None` where more than `most` segments are taken.
    fn ways(&self, limit: f64, most: usize) -> Option<Vec<f64>> {
        let mut ways = vec![0.0];
        let mut way = 0.0;
        let radius = self.request.outline.truth.larger_radius();
        let largest = self.balance.longest_within(limit / radius);
        while way < self.whole {
            if ways.len() > most {
                return None;
            }
            let (left, size) = (self.whole - way, self.longest(way, largest, limit)?);
            way = if size < left { way + size } else { self.whole };
            ways.push(way);
        }
        if self.is_back {
            ways = ways.iter().rev().map(|way| self.whole - way).collect();
        }
        Some(ways)
    }

    /// The longest segment from a way on that is within a limit. It is looked for from above: where a joint hides the sharp end of a flat
    /// ellipse a longer one may err less.
    fn longest(&self, way: f64, largest: f64, limit: f64) -> Option<f64> {
        let mut high = largest.min(self.whole - way);
        if self.is_within(way, high, limit) {
            return Some(high);
        }
        let mut low = high / STEP;
        while !self.is_within(way, low, limit) {
            (low, high) = (low / STEP, low);
            if low < SHORTEST {
                return None;
            }
        }
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if self.is_within(way, middle, limit) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(low)
    }

    fn is_within(&self, way: f64, size: f64, limit: f64) -> bool {
        let request = self.request;
        let from = if self.is_back {
            self.whole - way - size
        } else {
            way
        };
        let open = UnitArc {
            closed: false,
            ..request.outline.unit
        };
        let joints = Joints::after(&open, &[from, from + size]);
        let Ok(pieces) = request.pieces(&joints) else {
            return false;
        };
        let placed = Placed {
            ends: None,
            ..Placed::new(&request.outline, &joints)
        };
        let curve = placed.curve(pieces, false);
        radial::is_within(&curve.segments, &request.outline.truth, limit)
    }
}
