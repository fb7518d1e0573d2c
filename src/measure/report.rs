//! The report: everything that is measured of one curve.

use super::continuity::Joint;
use super::fit::Fit;
use crate::continuity::Continuity;
use crate::numeric::functions::power;

/// Everything that is measured of one curve. Lengths are in user units, angles in degrees, parametric on an ellipse.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Report {
    /// What it was measured against.
    pub reference: ReferenceReport,
    /// How many segments it has.
    pub segments: usize,
    /// Whether it returns to its start.
    pub closed: bool,
    /// Its distance from the true shape.
    pub error: ErrorReport,
    /// Its arc length.
    pub length: Extent,
    /// The area that it encloses or, where it is open, that of its sector.
    pub area: Extent,
    /// Its curvature, positive where it bends towards the inside of the true shape.
    pub curvature: CurvatureReport,
    /// How its segments join.
    pub continuity: ContinuityReport,
    /// How far the angle about the centre is ahead of, or behind, one that grows linearly with t within each segment.
    pub angle_lag: LagReport,
}

/// The true shape.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReferenceReport {
    /// Its centre.
    pub center: [f64; 2],
    /// Its radii along its own axes.
    pub radii: [f64; 2],
    /// The angle from the x axis to the axis of the first radius.
    pub rotation: f64,
    /// The angle where it starts.
    pub start: f64,
    /// How far it runs.
    pub sweep: f64,
    /// How well it fits, where it was fitted to the curve.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub fit: Option<Fit>,
}

/// A place on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Place {
    /// The number of the segment, from 1.
    pub segment: usize,
    /// The parameter there, from 0 to 1.
    pub t: f64,
    /// The angle about the centre.
    pub angle: f64,
}

/// An extreme of the curvature and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Extreme {
    /// The value; `null` where the curvature grows beyond any bound, as it does where the curve stands still.
    pub value: Option<f64>,
    /// Where.
    pub at: Place,
}

/// Distances from the true shape along its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ErrorReport {
    /// The largest outside it, at least 0.
    pub outward: f64,
    /// The largest inside it, at least 0.
    pub inward: f64,
    /// The larger of the two.
    pub peak: f64,
    /// The larger of the two over the larger radius.
    pub relative_peak: f64,
    /// The mean size over t, each segment counted alike.
    pub mean: f64,
    /// The mean size over the angle about the centre.
    pub mean_angle: f64,
    /// The root mean square over t.
    pub rms: f64,
    /// Where it is farthest outside; `null` where it is nowhere outside.
    pub outward_at: Option<Place>,
    /// Where it is farthest inside; `null` where it is nowhere inside.
    pub inward_at: Option<Place>,
}

/// A length or an area beside the true one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Extent {
    /// Of the curve.
    pub curve: f64,
    /// Of the true shape.
    #[cfg_attr(feature = "serde", serde(rename = "true"))]
    pub truth: f64,
    /// The curve's less the true one.
    pub difference: f64,
    /// The difference over the true one; `null` where that is 0.
    pub relative: Option<f64>,
}

impl Extent {
    pub(crate) fn new(curve: f64, truth: f64) -> Self {
        let relative = (curve - truth) / truth;
        Self {
            curve,
            truth,
            difference: curve - truth,
            relative: relative.is_finite().then_some(relative),
        }
    }
}

/// The range of the curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CurvatureReport {
    /// The least; `null` where the curve has none anywhere.
    pub least: Option<Extreme>,
    /// The largest; `null` where the curve has none anywhere.
    pub largest: Option<Extreme>,
    /// The least of the true shape.
    pub true_least: f64,
    /// The largest of the true shape.
    pub true_largest: f64,
}

/// How the segments join.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ContinuityReport {
    /// The lowest order of all joints; `null` where there are none.
    pub order: Option<Continuity>,
    /// How far rounding may have moved each coordinate: jumps that this explains are none.
    pub coordinate_tolerance: f64,
    /// The largest turn of the tangent, in degrees.
    pub largest_turn: f64,
    /// Every joint, in the order of the curve; the first point of a closed curve is the last.
    pub joints: Vec<Joint>,
}

/// The largest angle lag.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LagReport {
    /// In degrees, positive where the angle is ahead.
    pub largest: f64,
    /// Where.
    pub at: Place,
}

impl Report {
    /// From the bench's units back to the user's.
    pub(super) fn rescale(&mut self, unit: f64) {
        let length = |x: &mut f64| *x *= unit;
        let r = &mut self.reference;
        r.center.iter_mut().chain(&mut r.radii).for_each(length);
        let e = &mut self.error;
        for x in [
            &mut e.outward,
            &mut e.inward,
            &mut e.peak,
            &mut e.mean,
            &mut e.mean_angle,
            &mut e.rms,
        ] {
            length(x);
        }
        self.length = Extent::new(self.length.curve * unit, self.length.truth * unit);
        self.area = Extent::new(self.area.curve * unit * unit, self.area.truth * unit * unit);
        let k = &mut self.curvature;
        for extreme in [&mut k.least, &mut k.largest].into_iter().flatten() {
            extreme.value = extreme.value.map(|k| k / unit);
        }
        k.true_least /= unit;
        k.true_largest /= unit;
        length(&mut self.continuity.coordinate_tolerance);
        let per_length = |x: f64, n: i32| x / power(unit, n);
        for joint in &mut self.continuity.joints {
            joint.point.iter_mut().for_each(length);
            length(&mut joint.gap);
            length(&mut joint.tolerance.gap);
            for side in [&mut joint.before, &mut joint.after] {
                *side = side
                    .map(|k| k.map(per_length))
                    .filter(|k| k.to_array().iter().all(|x| x.is_finite()));
            }
            if let Some(parameters) = &mut joint.parameters {
                length(&mut parameters.rest);
            }
            // As the curvatures: none where a figure leaves the range of numbers.
            joint.parameters = joint.parameters.filter(|p| p.rest.is_finite());
            let t = &mut joint.tolerance;
            (t.value, t.d1, t.d2) = (
                per_length(t.value, 1),
                per_length(t.d1, 2),
                per_length(t.d2, 3),
            );
        }
    }
}
