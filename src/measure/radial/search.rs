//! The extremes of the distance from any shape whose nearest points are known: a search between the crossings.

use core::iter;

use kurbo::{ParamCurve, ParamCurveDeriv, PathSeg, Vec2};

use crate::numeric::foot::Foot;
use crate::numeric::root;

/// How many brackets the search begins with between two crossings; they narrow towards the crossings, as the
/// distance does where the curve touches the ellipse.
const BRACKETS: u32 = 32;

/// A bracket in which the ellipse's normal turns by more than this, as a cosine, is halved: at the tips of a flat ellipse the
/// distance varies with the normal, far faster than with t.
const NORMAL_TURN: f64 = 0.95;

/// How often a bracket is halved at most.
const MOST_HALVINGS: u32 = 24;

/// A place on the segment with the derivative of the distance there.
struct SlopeAt {
    t: f64,
    slope: f64,
    normal: Vec2,
}

/// Visits the ends and every extreme of the signed distance as (t, distance), each between two of these places at which the
/// distance changes its sign or jumps; `foot` finds the nearest point of the true shape at t.
pub(crate) fn visit_between(
    segment: &PathSeg,
    cuts: &[f64],
    foot: impl Fn(f64) -> Foot,
    mut visit: impl FnMut(f64, f64),
) {
    let search = ExtremeSearch { segment, foot };
    visit(0.0, search.distance(0.0));
    let mut cuts = cuts.to_vec();
    cuts.sort_by(f64::total_cmp);
    let ends = iter::once(0.0).chain(cuts.iter().copied());
    for (from, to) in ends.zip(cuts.iter().copied().chain(iter::once(1.0))) {
        let mut before = search.sample(from);
        for i in 1..=BRACKETS {
            let part = libm::cos(core::f64::consts::PI * f64::from(i) / f64::from(BRACKETS));
            let after = search.sample(from + (to - from) * (1.0 - part) / 2.0);
            search.bracket(&before, &after, MOST_HALVINGS, &mut visit);
            before = after;
        }
    }
    visit(1.0, search.distance(1.0));
}

struct ExtremeSearch<'a, F> {
    segment: &'a PathSeg,
    foot: F,
}

impl<F: Fn(f64) -> Foot> ExtremeSearch<'_, F> {
    fn distance(&self, t: f64) -> f64 {
        (self.foot)(t).distance
    }

    fn sample(&self, t: f64) -> SlopeAt {
        let normal = (self.foot)(t).outward;
        SlopeAt {
            t,
            slope: derivative(self.segment, t).dot(normal),
            normal,
        }
    }

    /// Visits the extreme between two places, halving where the normal turns far.
    fn bracket(
        &self,
        before: &SlopeAt,
        after: &SlopeAt,
        halvings: u32,
        visit: &mut impl FnMut(f64, f64),
    ) {
        if halvings > 0 && before.normal.dot(after.normal) < NORMAL_TURN {
            let middle = self.sample(f64::midpoint(before.t, after.t));
            self.bracket(before, &middle, halvings - 1, visit);
            self.bracket(&middle, after, halvings - 1, visit);
        } else if (before.slope > 0.0) != (after.slope > 0.0) {
            let t = root(|t| self.sample(t).slope, before.t, after.t);
            visit(t, self.distance(t));
        }
    }
}

/// The derivative at t.
pub(super) fn derivative(segment: &PathSeg, t: f64) -> Vec2 {
    match segment {
        PathSeg::Line(line) => line.p1 - line.p0,
        PathSeg::Quad(quad) => quad.deriv().eval(t).to_vec2(),
        PathSeg::Cubic(cubic) => cubic.deriv().eval(t).to_vec2(),
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{Point, QuadBez};

    use super::*;
    use crate::numeric::foot::foot;

    #[test]
    fn a_peak_at_a_sharp_tip_is_found_between_two_valleys() {
        // Round the tip (1, 0): x = 1.001 - 3.6 (t - at)², y = -0.0015 (t - at). The farthest point lies before the tip.
        let radii = Vec2::new(1.0, 1e-4);
        for at in [0.51, 0.515, 0.52, 0.53, 0.535, 0.54] {
            let x = |t: f64| 1.001 - 3.6 * (t - at) * (t - at);
            let y = |t: f64| -0.0015 * (t - at);
            let ends = [0.0, 1.0].map(|t| Point::new(x(t), y(t)));
            let middle = Point::new(2.0 * x(0.5) - f64::midpoint(x(0.0), x(1.0)), y(0.5));
            let segment = QuadBez::new(ends[0], middle, ends[1]);
            let mut farthest = 0.0_f64;
            let foot = |t: f64| foot(radii, segment.eval(t).to_vec2());
            visit_between(&PathSeg::Quad(segment), &[], foot, |_, distance| {
                farthest = farthest.max(distance);
            });
            assert!((farthest - 1e-3).abs() < 1e-9, "{at}: {farthest}");
        }
    }

    #[test]
    fn a_line_is_nearest_where_it_runs_along_the_tangent() {
        let line = PathSeg::Line(kurbo::Line::new((-3.0, 2.0), (5.0, 2.0)));
        let foot = |t: f64| foot(Vec2::new(2.0, 1.0), line.eval(t).to_vec2());
        let mut found = Vec::new();
        visit_between(&line, &[], foot, |t, distance| found.push((t, distance)));
        // Above the end of the short axis.
        assert_eq!(found.len(), 3, "{found:?}");
        assert!((found[1].0 - 0.375).abs() < 1e-12 && (found[1].1 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn extremes_are_looked_for_up_to_the_ends_only() {
        // The line is nearest at t = 1.2.
        let line = PathSeg::Line(kurbo::Line::new((-6.0, 2.0), (-1.0, 2.0)));
        let foot = |t: f64| foot(Vec2::new(2.0, 1.0), line.eval(t).to_vec2());
        for cuts in [&[][..], &[0.5], &[0.9, 0.2]] {
            let mut found = Vec::new();
            visit_between(&line, cuts, foot, |t, _| found.push(t));
            assert_eq!(found, [0.0, 1.0], "{cuts:?}");
        }
    }
}
