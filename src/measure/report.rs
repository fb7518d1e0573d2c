//! The report: everything that is measured of one curve.

use kurbo::{Affine, ParamCurve, PathSeg, Point};
use schemars::JsonSchema;
use serde::Serialize;

use super::continuity::{Joint, joint};
use super::fit::Fit;
use super::radial::{Profile, visit_extremes};
use super::reference::Reference;
use super::{curvature, extent};
use crate::curve::{Curve, control_points};
use crate::error::{Error, Result, finite};
use crate::method::Continuity;

/// A closing line shorter than this part of the curve's extent is the gap of a joint, not a segment; an open curve whose ends
/// are as near returns to its start.
pub(crate) const CLOSING_GAP: f64 = 1e-4;

/// Everything that is measured of one curve. Lengths are in user units, angles in degrees, parametric on an ellipse.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
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
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<Fit>,
}

/// A place on the curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Place {
    /// The number of the segment, from 1.
    pub segment: usize,
    /// The parameter there, from 0 to 1.
    pub t: f64,
    /// The angle about the centre.
    pub angle: f64,
}

/// A value and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Where.
    pub at: Place,
}

/// Distances from the true shape along its normal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Extent {
    /// Of the curve.
    pub curve: f64,
    /// Of the true shape.
    #[serde(rename = "true")]
    pub truth: f64,
    /// The curve's less the true one.
    pub difference: f64,
    /// The difference over the true one; `null` where that is 0.
    pub relative: Option<f64>,
}

impl Extent {
    fn new(curve: f64, truth: f64) -> Self {
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ContinuityReport {
    /// The lowest order of all joints; `null` where there are none.
    pub order: Option<String>,
    /// How far rounding may have moved each coordinate: jumps that this explains are none.
    pub coordinate_tolerance: f64,
    /// The largest turn of the tangent, in degrees.
    pub largest_turn: f64,
    /// Every joint, in the order of the curve; the first point of a closed curve is the last.
    pub joints: Vec<Joint>,
}

/// The largest angle lag.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LagReport {
    /// In degrees, positive where the angle is ahead.
    pub largest: f64,
    /// Where.
    pub at: Place,
}

/// Measures a curve. `coordinate_tolerance` is how far rounding may have moved each coordinate; without it, four units in the
/// last place of the largest one in double precision.
///
/// # Errors
///
/// Where the curve has no segment or a coordinate is not finite or beyond 1e150.
///
/// ```
/// use curveto::measure::{Reference, report};
/// use curveto::{Circle, Method, Options, Rule, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0)?);
/// let options = Options { rule: Rule::Method(Method::Apprich), ..Options::default() };
/// let drawing = approximate(&circle, &options)?;
/// let outline = drawing.outline.expect("a circle has an outline");
/// let report = report(&drawing.curve, &Reference::from(&outline), None)?;
/// assert_eq!(report.error.outward, drawing.error.outward);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn report(
    curve: &Curve,
    reference: &Reference,
    coordinate_tolerance: Option<f64>,
) -> Result<Report> {
    if curve.segments.is_empty() {
        return Err(Error::Shape(
            "there is nothing to measure: the path is empty".to_owned(),
        ));
    }
    let largest = largest_coordinate(curve, reference)?;
    // A power of two near the largest number brings every power of a length into the range of f64, without a rounding error.
    let unit = 2.0_f64.powi(largest.log2().ceil().clamp(-500.0, 500.0) as i32);
    let scaled = curve.transformed(Affine::scale(1.0 / unit));
    let delta = coordinate_tolerance.unwrap_or(4.0 * f64::EPSILON * largest);
    let bench = Bench::new(&scaled, reference.scaled(1.0 / unit));
    let mut report = bench.report(delta / unit);
    report.rescale(unit);
    Ok(report)
}

/// The largest number among all coordinates.
fn largest_coordinate(curve: &Curve, reference: &Reference) -> Result<f64> {
    let truth = &reference.truth;
    let mut largest = truth.larger_radius().max(f64::MIN_POSITIVE);
    let points = curve.segments.iter().flat_map(control_points);
    for p in points.chain([truth.center]) {
        for x in [p.x, p.y] {
            largest = largest.max(finite("coordinate", x)?.abs());
        }
    }
    Ok(largest)
}

/// A curve on the bench: in units near 1, beside its reference.
pub(crate) struct Bench<'a> {
    segments: &'a [PathSeg],
    reference: Reference,
    returns: bool,
    /// The angle of the first point and how far the true arc runs, in degrees.
    arc: (f64, f64),
    /// The angle where each segment starts, in degrees, whole turns counted; one more than segments.
    angles: Vec<f64>,
}

impl<'a> Bench<'a> {
    pub(crate) fn new(curve: &'a Curve, reference: Reference) -> Self {
        let segments = &curve.segments;
        let framed: Vec<_> = segments.iter().map(|s| reference.framed(s)).collect();
        let measured_start = framed.first().map_or(0.0, |f| f.first_angle().to_degrees());
        let start = reference.arc.map_or(measured_start, |(start, _)| {
            start + remainder(measured_start - start)
        });
        let mut angles = vec![start];
        for f in &framed {
            angles.push(angles[angles.len() - 1] + f.turned(1.0).to_degrees());
        }
        let turned = angles[angles.len() - 1] - start;
        let returns = curve.closed || gap(curve) <= CLOSING_GAP * size(curve);
        let arc = reference.arc.unwrap_or_else(|| {
            let turns = (turned / 360.0).round();
            let sweep = match (returns, turns == 0.0) {
                (false, _) => turned,
                (true, false) => 360.0 * turns,
                (true, true) => 360.0_f64.copysign(enclosed(segments, reference.truth.center)),
            };
            (start, sweep)
        });
        Self {
            segments,
            reference,
            returns,
            arc,
            angles,
        }
    }

    /// 1 where the curve runs from +x towards +y about the centre, else -1.
    pub(crate) fn sense(&self) -> f64 {
        self.reference
            .handedness()
            .copysign(self.arc.1 * self.reference.handedness())
    }

    fn place(&self, segment: usize, t: f64) -> Place {
        let turned = self.reference.framed(&self.segments[segment]).turned(t);
        Place {
            segment: segment + 1,
            t,
            angle: self.angles[segment] + turned.to_degrees(),
        }
    }

    /// The segments with their numbers from 0.
    pub(crate) fn segments(&self) -> impl Iterator<Item = (usize, &'a PathSeg)> {
        self.segments.iter().enumerate()
    }

    pub(crate) fn reference(&self) -> &Reference {
        &self.reference
    }

    /// The angle where a segment starts, in degrees.
    pub(crate) fn angle(&self, segment: usize) -> f64 {
        self.angles[segment]
    }

    fn report(&self, delta: f64) -> Report {
        let truth = &self.reference.truth;
        Report {
            reference: ReferenceReport {
                center: [truth.center.x, truth.center.y],
                radii: [truth.radii.x, truth.radii.y],
                rotation: truth.axis.atan2().to_degrees(),
                start: self.arc.0,
                sweep: self.arc.1,
                fit: None,
            },
            segments: self.segments.len(),
            closed: self.returns,
            error: self.error(),
            length: self.length(),
            area: self.area(),
            curvature: self.curvature(),
            continuity: self.continuity(delta),
            angle_lag: self.angle_lag(),
        }
    }

    fn error(&self) -> ErrorReport {
        let truth = &self.reference.truth;
        let (mut out, mut inside) = ((0.0, None), (0.0, None));
        let (mut mean, mut square, mut over_angle, mut angle) = (0.0, 0.0, 0.0, 0.0);
        for (i, segment) in self.segments() {
            visit_extremes(segment, truth, |t, distance| {
                if distance > out.0 {
                    out = (distance, Some((i, t)));
                }
                if -distance > inside.0 {
                    inside = (-distance, Some((i, t)));
                }
            });
            let profile = Profile::new(segment, truth);
            let framed = self.reference.framed(segment);
            mean += profile.integral(|_, d| d);
            square += profile.integral(|_, d| d * d);
            over_angle += profile.integral(|t, d| d * framed.angular_speed(t));
            angle += profile.integral(|t, _| framed.angular_speed(t));
        }
        let count = self.segments.len() as f64;
        let peak = f64::max(out.0, inside.0);
        ErrorReport {
            outward: out.0,
            inward: inside.0,
            peak,
            relative_peak: peak / truth.larger_radius(),
            mean: mean / count,
            mean_angle: if angle > 0.0 {
                over_angle / angle
            } else {
                mean / count
            },
            rms: (square / count).sqrt(),
            outward_at: out.1.map(|(i, t)| self.place(i, t)),
            inward_at: inside.1.map(|(i, t)| self.place(i, t)),
        }
    }

    fn length(&self) -> Extent {
        // A transform turns or mirrors the unit circle, but keeps the size of its angles.
        let truth = &self.reference.truth;
        let first = crate::Angle::from_degrees(self.arc.0)
            .direction()
            .to_point();
        let own = truth.placement().inverse() * (self.reference.placement * first);
        let start = own.to_vec2().atan2();
        let end = start + self.arc.1.to_radians() * self.reference.handedness();
        Extent::new(
            self.segments.iter().map(extent::length).sum(),
            extent::ellipse_length(truth.radii, start, end).abs(),
        )
    }

    fn area(&self) -> Extent {
        let truth = &self.reference.truth;
        let enclosed = enclosed(self.segments, truth.center);
        let sector = 0.5 * truth.radii.x * truth.radii.y * self.arc.1.to_radians().abs();
        Extent::new(enclosed * self.sense(), sector)
    }

    fn curvature(&self) -> CurvatureReport {
        let (mut least, mut largest): (Option<Extreme>, Option<Extreme>) = (None, None);
        for (i, segment) in self.segments() {
            let inner = curvature::extremes(segment);
            for t in core::iter::once(0.0).chain(inner.iter()).chain([1.0]) {
                let Some(found) = curvature::at(segment, t) else {
                    continue;
                };
                let value = found.value * self.sense();
                if least.is_none_or(|e| value < e.value) {
                    least = Some(Extreme {
                        value,
                        at: self.place(i, t),
                    });
                }
                if largest.is_none_or(|e| value > e.value) {
                    largest = Some(Extreme {
                        value,
                        at: self.place(i, t),
                    });
                }
            }
        }
        let (true_least, true_largest) = self.true_curvature();
        CurvatureReport {
            least,
            largest,
            true_least,
            true_largest,
        }
    }

    /// The range of ab/(a² sin² + b² cos²)^(3/2) over the true arc: its extremes lie on the axes or at the ends.
    fn true_curvature(&self) -> (f64, f64) {
        let truth = &self.reference.truth;
        let (a, b) = (truth.radii.x, truth.radii.y);
        if a == b {
            return (1.0 / a, 1.0 / a);
        }
        let inverse = truth.placement().inverse() * self.reference.placement;
        let at = |degrees: f64| {
            let v = inverse * crate::Angle::from_degrees(degrees).direction().to_point();
            a * b / (a * v.y).hypot(b * v.x).powi(3)
        };
        let (start, end) = (self.arc.0, self.arc.0 + self.arc.1);
        let axis = (inverse.inverse() * Point::new(1.0, 0.0))
            .to_vec2()
            .atan2()
            .to_degrees();
        let (low, high) = (start.min(end), start.max(end));
        let first = ((low - axis) / 90.0).ceil() as i64;
        let last = ((high - axis) / 90.0).floor() as i64;
        let vertices = (first..=last.min(first + 4)).map(|i| at(axis + 90.0 * i as f64));
        vertices
            .chain([at(start), at(end)])
            .fold((f64::INFINITY, 0.0), |(least, most), k| {
                (k.min(least), k.max(most))
            })
    }

    fn continuity(&self, delta: f64) -> ContinuityReport {
        let count = self.segments.len();
        let last = if self.returns { count } else { count - 1 };
        let mut order: Option<Continuity> = None;
        let joints: Vec<Joint> = (0..last)
            .map(|i| {
                let (mut joint, found) =
                    joint(&self.segments[i], &self.segments[(i + 1) % count], delta);
                joint.angle = self.angles[i + 1];
                for side in [&mut joint.before, &mut joint.after] {
                    *side = side.map(|k| k.map(|x, _| x * self.sense()));
                }
                order = Some(order.map_or(found, |order| order.min(found)));
                joint
            })
            .collect();
        ContinuityReport {
            order: order.map(|order| order.to_string()),
            coordinate_tolerance: delta,
            largest_turn: joints
                .iter()
                .map(|joint| joint.turn.abs())
                .fold(0.0, f64::max),
            joints,
        }
    }

    fn angle_lag(&self) -> LagReport {
        let mut largest = (0.0_f64, 0, 0.0);
        for (i, segment) in self.segments() {
            let framed = self.reference.framed(segment);
            for t in framed.lag_extremes() {
                let lag = framed.lag(t);
                if lag.abs() > largest.0.abs() {
                    largest = (lag, i, t);
                }
            }
        }
        let (lag, segment, t) = largest;
        LagReport {
            largest: lag.to_degrees() * 1.0_f64.copysign(self.arc.1),
            at: self.place(segment, t),
        }
    }
}

/// An angle in degrees brought between -180 and 180.
fn remainder(degrees: f64) -> f64 {
    degrees - 360.0 * (degrees / 360.0).round()
}

/// The area within the segments, or of their sector, positive from +x towards +y.
fn enclosed(segments: &[PathSeg], center: Point) -> f64 {
    segments
        .iter()
        .map(|segment| extent::sector_area(segment, center))
        .sum()
}

/// How far the end of a curve lies from its start.
pub(crate) fn gap(curve: &Curve) -> f64 {
    match (curve.segments.first(), curve.segments.last()) {
        (Some(first), Some(last)) => first.start().distance(last.end()),
        _ => 0.0,
    }
}

/// The diagonal of the curve's bounding box.
pub(crate) fn size(curve: &Curve) -> f64 {
    curve
        .bounding_box()
        .map_or(0.0, |b| b.width().hypot(b.height()))
}

impl Report {
    /// From the bench's units back to the user's.
    fn rescale(&mut self, unit: f64) {
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
            extreme.value /= unit;
        }
        k.true_least /= unit;
        k.true_largest /= unit;
        length(&mut self.continuity.coordinate_tolerance);
        let per_length = |x: f64, power: i32| x / unit.powi(power);
        for joint in &mut self.continuity.joints {
            joint.point.iter_mut().for_each(length);
            length(&mut joint.gap);
            length(&mut joint.tolerance.gap);
            for side in [&mut joint.before, &mut joint.after] {
                *side = side
                    .map(|k| k.map(per_length))
                    .filter(|k| k.to_array().iter().all(|x| x.is_finite()));
            }
            let t = &mut joint.tolerance;
            (t.value, t.d1, t.d2) = (
                per_length(t.value, 1),
                per_length(t.d1, 2),
                per_length(t.d2, 3),
            );
        }
    }
}
