//! Path data the way back: runs of Béziers that are arcs become arc commands, all other bytes stay.
//!
//! What has to be minded: a smooth command after a run reflected a control point that is gone, so that it is spelled out; one that
//! repeated the letter of a run gets its own; the end point keeps its digits, as the file spells them or as their exact sum; and the
//! text becomes no longer, with all that. Path data with an error stay as they are: renderers may stop at another place.

use core::ops::Range;

use kurbo::{CubicBez, QuadBez, Vec2};

use crate::arcs::recognize::Rules;
use crate::arcs::together;
use crate::document::path::arcs::Sink;
use crate::document::path::position::Position;
use crate::document::path::run_text::{self, Edit, Link, Run, family};
use crate::document::reason::Reason;
use crate::joints::Tolerance;
use crate::number::Precision;
use crate::number::read::{WITH_EXPONENT, decimals_spelled};
use crate::path_data::{Handles, Segment, Segments};

/// The tolerance where none is asked for, as a part of the radius.
const DEFAULT_PART: f64 = 1e-3;

/// The most decimals of a file that are believed: beyond, digits are noise.
const MOST_DECIMALS: u8 = 12;

/// How often what lies between runs is looked at again.
const MOST_LEVELS: usize = 8;

/// What became of one path.
#[derive(Debug, Default)]
pub(in crate::document) struct RunsOutcome {
    /// The edits, in their order.
    pub(in crate::document) edits: Vec<Edit>,
    /// The arc commands in them.
    pub(in crate::document) arcs: usize,
    /// A bound of the distance of all arcs from their runs, of those before them too.
    pub(in crate::document) strayed: f64,
    /// Why a run was left, and where it is.
    pub(in crate::document) left: Option<(usize, Reason)>,
}

impl RunsOutcome {
    /// Whether there is nothing to do or to note.
    pub(in crate::document) const fn is_empty(&self) -> bool {
        self.edits.is_empty() && self.left.is_none()
    }

    /// Writes it.
    pub(in crate::document) fn write(self, sink: &mut impl Sink) {
        if let Some((at, reason)) = self.left {
            sink.note(at, reason);
        }
        for edit in self.edits {
            sink.edit(edit.range).extend_from_slice(&edit.text);
        }
    }
}

/// The rules for curves whose numbers have this many decimals.
pub(in crate::document) fn rules(tolerance: Option<Tolerance>, decimals: u8) -> Rules {
    let (part, absolute) = match tolerance {
        Some(Tolerance::Absolute(distance)) => (0.0, distance),
        Some(Tolerance::Relative(part)) => (part, 0.0),
        None => (DEFAULT_PART, Precision::Fixed(decimals).farthest_moved()),
    };
    Rules {
        part,
        absolute,
        decimals,
        elliptic: true,
        drawn_only: tolerance.is_none(),
        longest: usize::MAX,
    }
}

/// The most decimals of the numbers in a text that are believed; `None` where one has an exponent.
pub(in crate::document) fn decimals(text: &[u8]) -> Option<u8> {
    Some(decimals_spelled(text)?.min(MOST_DECIMALS))
}

/// Finds the runs of the path data in `text[span]`, after which the text ends or goes on with a quote; `strayed` is how far those before them do.
pub(in crate::document) fn find(
    text: &str,
    span: Range<usize>,
    tolerance: Option<Tolerance>,
    keeps_vertices: bool,
    strayed: f64,
) -> RunsOutcome {
    let mut finder = Finder {
        text,
        tolerance,
        keeps_vertices,
        at: Position::default(),
        control: Vec2::ZERO,
        family: 0,
        end: span.start,
        has_exponent: false,
        links: Vec::new(),
        cubics: Vec::new(),
        outcome: RunsOutcome {
            strayed,
            ..RunsOutcome::default()
        },
    };
    let mut segments = Segments::new(text, span).with_handles();
    while let Some(segment) = segments.next() {
        finder.segment(&segment, segments.handles().unwrap_or_default());
    }
    finder.flush();
    if let Some(at) = segments.error()
        && finder.outcome.arcs > 0
    {
        return RunsOutcome {
            left: Some((at, Reason::PathError)),
            ..RunsOutcome::default()
        };
    }
    finder.outcome
}

struct Finder<'a> {
    text: &'a str,
    tolerance: Option<Tolerance>,
    /// Whether no vertex may go, because markers stand on them.
    keeps_vertices: bool,
    at: Position,
    /// The last control point, which a smooth command of the same family reflects.
    control: Vec2,
    /// `c` or `q` after a cubic or a quadratic.
    family: u8,
    /// The index of the byte after the last segment.
    end: usize,
    /// Whether a number of the chain has an exponent.
    has_exponent: bool,
    /// The Béziers since anything else.
    links: Vec<Link>,
    cubics: Vec<CubicBez>,
    outcome: RunsOutcome,
}

impl Finder<'_> {
    fn segment(&mut self, segment: &Segment, handles: Handles) {
        let family = family(segment.kind());
        let cubic = (family != 0).then(|| self.cubic(segment, family, handles.points));
        let from = self.at.point;
        self.at.advance(segment);
        match cubic {
            Some(mut cubic) if self.at.point.is_finite() => {
                cubic.p3 = self.at.point.to_point();
                self.control = cubic.p2.to_vec2();
                if family == b'q' {
                    self.control = cubic.p1.to_vec2();
                    let points = [from, self.control, self.at.point].map(Vec2::to_point);
                    cubic = QuadBez::new(points[0], points[1], points[2]).raise();
                }
                self.has_exponent |= handles.decimals == WITH_EXPONENT;
                self.links.push(Link {
                    segment: *segment,
                    previous: self.end,
                    to: self.at.point,
                    decimals: handles.decimals.min(MOST_DECIMALS),
                });
                self.cubics.push(cubic);
            }
            _ => self.flush(),
        }
        (self.family, self.end) = (family, segment.end);
    }

    /// The control points of a Bézier, the end point aside.
    fn cubic(&self, segment: &Segment, family: u8, handles: [Vec2; 2]) -> CubicBez {
        let from = self.at.point;
        let base = if segment.is_relative() {
            from
        } else {
            Vec2::ZERO
        };
        let [a, b] = handles.map(|p| base + p);
        let mirrored = if self.family == family {
            2.0 * from - self.control
        } else {
            from
        };
        let (p1, p2) = match segment.kind() {
            b'c' => (a, b),
            b's' => (mirrored, a),
            b'q' => (a, a),
            _ => (mirrored, mirrored),
        };
        let [p0, p1, p2] = [from, p1, p2].map(Vec2::to_point);
        CubicBez::new(p0, p1, p2, p0)
    }

    /// Ends a chain of Béziers.
    fn flush(&mut self) {
        if !self.links.is_empty() {
            if !self.has_exponent {
                self.chain();
            }
            self.links.clear();
            self.cubics.clear();
        }
        self.has_exponent = false;
    }

    /// Makes arcs of the runs of the chain.
    fn chain(&mut self) {
        let runs = self.runs(0..self.links.len(), None, 0);
        if runs.is_empty() {
            return;
        }
        let (edits, taken) = run_text::edits(self.text, &self.links, &runs);
        for run in &taken {
            let cubics = &self.cubics[run.start..run.end()];
            self.outcome.strayed = run.found.strayed(cubics, self.outcome.strayed);
        }
        self.outcome.arcs += taken.len();
        self.outcome.edits.extend(edits);
    }

    /// The runs of a part of the chain, at the beginning of which the run before it may end. What lies between those that are taken may have fewer
    /// decimals, or other radii by itself, and is looked at again, so that nothing is left that a second conversion would find.
    fn runs(&mut self, part: Range<usize>, before: Option<Run>, level: usize) -> Vec<Run> {
        let decimals = self.decimals(part.clone());
        let mut runs = self.runs_by(part.clone(), before, &rules(self.tolerance, decimals));
        let has_fewer = |link: &Link| link.decimals < decimals;
        let share = |pair: &[Run]| pair[0].found.given.radii == pair[1].found.given.radii;
        let is_final =
            !runs.windows(2).any(share) && !self.links[part.clone()].iter().any(has_fewer);
        if runs.is_empty() || is_final {
            return runs;
        }
        let (_, taken) = run_text::edits(self.text, &self.links, &runs);
        let (mut more, mut start, mut last) = (Vec::new(), part.start, before);
        for next in taken.iter().copied().map(Some).chain([None]) {
            let between = start..next.map_or(part.end, |run| run.start);
            // Runs that were let go may have had the radius of those that were taken.
            let is_free = |run: &Run| between.contains(&run.start);
            if !between.is_empty()
                && between != part
                && (self.decimals(between.clone()) < decimals
                    || level < MOST_LEVELS && runs.iter().any(is_free))
            {
                more.extend(self.runs(between, last, level + 1));
            }
            start = next.map_or(part.end, |run| run.end());
            last = next;
        }
        if !more.is_empty() {
            runs = taken;
            runs.extend(more);
            runs.sort_by_key(|run| run.start);
        }
        runs
    }

    /// The most decimals of the numbers of a part of the chain.
    fn decimals(&self, part: Range<usize>) -> u8 {
        let links = self.links[part].iter();
        links.map(|link| link.decimals).max().unwrap_or(0)
    }

    fn runs_by(&mut self, part: Range<usize>, before: Option<Run>, rules: &Rules) -> Vec<Run> {
        let (mut runs, mut start) = (Vec::<Run>::new(), part.start);
        while start < part.end {
            let before = runs.last().or(before.as_ref());
            let before = before.filter(|run| run.end() == start);
            let rules = Rules {
                longest: run_text::longest(self.text, &self.links, start, before),
                ..*rules
            };
            let arcs = together::arcs(&self.cubics[start..part.end], &rules);
            if arcs.is_empty() {
                start += 1;
            }
            for found in arcs {
                if self.keeps_vertices && found.count > 1 {
                    let at = self.links[start].segment.start;
                    self.outcome.left.get_or_insert((at, Reason::MarkerOnRun));
                } else {
                    runs.push(Run { start, found });
                }
                start += found.count;
            }
        }
        runs
    }
}
