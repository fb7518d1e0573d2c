//! Steps as segments, rounded and measured.

use core::ops::Range;

use kurbo::{PathSeg, Rect};

use super::quadratics::{Replaced, quadratics, room, tolerance};
use super::{Contour, Step, Subpath};
use crate::approximate::{self, Sketch};
use crate::curve::{Curve, largest_move};
use crate::error::Result;
use crate::measure::hausdorff::Effort;
use crate::measure::radial;
use crate::number::Precision;
use crate::radial_error::RadialError;

/// How much is done in all to measure cubics that became quadratics, about a second; what is beyond is bounded at near points.
pub(super) const MOST_STEPS: u64 = 20_000_000;

/// Turns steps into segments that are written alike.
pub(super) struct Finisher<'a> {
    /// How many quadratics each step becomes that is a cubic; 0, or nothing, where it stays.
    pub(super) counts: &'a [u32],
    pub(super) options: &'a approximate::Options,
    pub(super) precision: Precision,
}

/// A cubic that became quadratics: its step, where these are among the segments, and a bound of their distance.
struct ReplacedStep {
    step: usize,
    quadratics: Range<usize>,
    at_most: f64,
}

impl Finisher<'_> {
    pub(super) fn subpath(
        &self,
        contour: &Contour,
        arcs: &[Option<Sketch>],
        steps: &mut Effort,
    ) -> Result<Subpath> {
        let mut segments = Vec::new();
        let mut error = RadialError::default();
        let mut radius = 0.0_f64;
        let mut truths = Vec::new();
        let mut replaced = Vec::new();
        for (i, (step, sketch)) in contour.steps.iter().zip(arcs).enumerate() {
            let before = segments.len();
            if let (Step::Arc(arc), Some(sketch)) = (step, sketch) {
                let kept = sketch.kept.as_ref().map_or(&[][..], |ends| &ends[..]);
                let curve = sketch.curve.rounded(self.precision, kept);
                let outline = arc.outline().transformed(self.options.transform)?;
                error = error.with(radial::error(&curve.segments, &outline.truth));
                radius = radius.max(outline.truth.larger_radius());
                segments.extend(curve.segments);
                truths.push((before..segments.len(), outline));
            } else if let Step::Given(segment) = step {
                let count = self.counts.get(i).copied().unwrap_or_default();
                let moved = self.given(self.options.transform * *segment, count, &mut segments)?;
                if count == 0 {
                    error = error.with(RadialError::balanced(moved));
                } else {
                    replaced.push(ReplacedStep {
                        step: i,
                        quadratics: before..segments.len(),
                        at_most: moved,
                    });
                }
            }
        }
        let moved = self.farthest(contour, &segments, replaced, steps);
        let curve = Curve {
            segments,
            closed: contour.closed,
        };
        if radius == 0.0 {
            let bounds = curve.bounding_box().unwrap_or(Rect::ZERO);
            radius = bounds.width().max(bounds.height()) / 2.0;
        }
        Ok(Subpath {
            curve,
            course: None,
            error: error.with(RadialError::balanced(moved)),
            closeness: None,
            truths,
            radius,
        })
    }

    /// Appends a segment that was given, or that many quadratics in its place, and tells a bound of how far it was moved.
    fn given(&self, segment: PathSeg, count: u32, segments: &mut Vec<PathSeg>) -> Result<f64> {
        let before = segments.len();
        let cubic = match segment {
            PathSeg::Cubic(cubic) if count > 0 => Some(cubic),
            _ => None,
        };
        let kept = if let Some(cubic) = &cubic {
            segments.extend(quadratics(cubic, count as usize).map(PathSeg::Quad));
            vec![cubic.p0, cubic.p3]
        } else {
            segments.push(segment);
            crate::curve::control_points(&segment)
        };
        let curve = Curve {
            segments: segments.split_off(before),
            closed: false,
        };
        let given = self.options.precision.is_none().then_some(kept);
        let kept = given.unwrap_or_default();
        let rounded = curve.rounded(self.precision, &kept);
        // A point of a Bézier moves no farther than its control points do.
        let mut moved = largest_move(&curve, &rounded);
        if let Some(cubic) = &cubic {
            let quadratics = &rounded.segments[..];
            let by_count = room(tolerance(cubic, &self.options.cut)?) + moved;
            moved = by_count.min(Replaced { cubic, quadratics }.at_parameters());
        }
        segments.extend(rounded.segments);
        Ok(moved)
    }

    /// The largest distance of cubics from the quadratics in their place: those with the largest bounds are measured first, and others no more
    /// once no bound is larger than what was found.
    fn farthest(
        &self,
        contour: &Contour,
        segments: &[PathSeg],
        mut replaced: Vec<ReplacedStep>,
        steps: &mut Effort,
    ) -> f64 {
        replaced.sort_by(|a, b| b.at_most.total_cmp(&a.at_most));
        let mut farthest = 0.0_f64;
        for of in replaced {
            if of.at_most <= farthest {
                break;
            }
            if let Step::Given(PathSeg::Cubic(cubic)) = &contour.steps[of.step] {
                let replaced = Replaced {
                    cubic: &(self.options.transform * *cubic),
                    quadratics: &segments[of.quadratics],
                };
                farthest = farthest.max(replaced.distance(of.at_most, farthest, steps));
            }
        }
        farthest
    }
}
