//! The bench: where a curve lies beside its reference, in units near 1, and every figure is taken.

use kurbo::{PathSeg, Point};

use super::continuity::{Joint, joint};
use super::radial::{Known, Profile};
use super::reference::Reference;
use super::report::{
    ContinuityReport, CurvatureReport, ErrorReport, Extent, Extreme, LagReport, Place,
    ReferenceReport, Report,
};
use super::{curvature, extent};
use crate::curve::{CLOSING_GAP, Curve, gap, size};
use crate::numeric::functions::angle_of;

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
    pub(crate) fn new(curve: &'a Curve, reference: &Reference) -> Self {
        let segments = &curve.segments;
        let framed: Vec<_> = segments.iter().map(|s| reference.framed(s)).collect();
        let measured_start = framed.first().map_or(0.0, |f| f.first_angle().to_degrees());
        let start = reference.arc.map_or(measured_start, |(start, _)| {
            start + remainder(measured_start - start)
        });
        let mut angles = vec![start];
        for (i, f) in framed.iter().enumerate() {
            if f.starts_in_center() {
                angles[i] += remainder(f.first_angle().to_degrees() - angles[i]);
            }
            angles.push(angles[i] + f.turned(1.0).to_degrees());
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
            reference: *reference,
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

    /// Every figure; `delta` is how far rounding may have moved each coordinate.
    pub(crate) fn report(&self, delta: f64) -> Report {
        let truth = &self.reference.truth;
        Report {
            reference: ReferenceReport {
                center: [truth.center.x, truth.center.y],
                radii: [truth.radii.x, truth.radii.y],
                rotation: angle_of(truth.axis).to_degrees(),
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
        let (mut out, mut inside) = (Largest::above(0.0), Largest::above(0.0));
        let (mut mean, mut square, mut over_angle, mut angle) = (0.0, 0.0, 0.0, 0.0);
        for (i, segment) in self.segments() {
            let profile = Profile::new(segment, truth);
            profile.visit_bounds(&mut Known::default(), |t, [least, most]| {
                out.take(most, i, t);
                inside.take(-least, i, t);
            });
            let framed = self.reference.framed(segment);
            mean += profile.integral(|_, d| d);
            square += profile.integral(|_, d| d * d);
            over_angle += profile.integral(|t, d| d * framed.angular_speed(t));
            angle += profile.integral(|t, _| framed.angular_speed(t));
        }
        let count = self.segments.len() as f64;
        let peak = f64::max(out.value, inside.value);
        ErrorReport {
            outward: out.value,
            inward: inside.value,
            peak,
            relative_peak: peak / truth.larger_radius(),
            mean: mean / count,
            mean_angle: if angle > 0.0 {
                over_angle / angle
            } else {
                mean / count
            },
            rms: (square / count).sqrt(),
            outward_at: out.place.map(|(i, t)| self.place(i, t)),
            inward_at: inside.place.map(|(i, t)| self.place(i, t)),
        }
    }

    fn length(&self) -> Extent {
        // A transform turns or mirrors the unit circle, but keeps the size of its angles.
        let truth = &self.reference.truth;
        let first = crate::Angle::from_degrees(self.arc.0)
            .direction()
            .to_point();
        let own = truth.placement().inverse() * (self.reference.placement * first);
        let start = angle_of(own.to_vec2());
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
        let nothing = Largest::above(f64::NEG_INFINITY);
        let (mut least, mut largest) = (nothing, nothing);
        for (i, segment) in self.segments() {
            let inner = curvature::extremes(segment);
            for t in core::iter::once(0.0).chain(inner).chain([1.0]) {
                let pole = curvature::pole(segment, t).map(|sign| f64::INFINITY * sign);
                let value = pole.or_else(|| Some(curvature::at(segment, t)?.value));
                if let Some(value) = value {
                    largest.take(value * self.sense(), i, t);
                    least.take(-value * self.sense(), i, t);
                }
            }
        }
        let extreme = |found: Largest, sign: f64| {
            let (i, t) = found.place?;
            let value = Some(sign * found.value).filter(|k| k.is_finite());
            let at = self.place(i, t);
            Some(Extreme { value, at })
        };
        let (true_least, true_largest) = self.true_curvature();
        CurvatureReport {
            least: extreme(least, -1.0),
            largest: extreme(largest, 1.0),
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
            let speed = libm::hypot(a * v.y, b * v.x);
            (a / speed) * (b / speed) / speed
        };
        let (start, end) = (self.arc.0, self.arc.0 + self.arc.1);
        let axis = angle_of((inverse.inverse() * Point::new(1.0, 0.0)).to_vec2()).to_degrees();
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
        let joints: Vec<Joint> = (0..last)
            .map(|i| {
                let next = &self.segments[(i + 1) % count];
                let mut joint = joint(&self.segments[i], next, delta);
                joint.angle = self.angles[i + 1];
                for side in [&mut joint.before, &mut joint.after] {
                    *side = side.map(|k| k.map(|x, _| x * self.sense()));
                }
                if let Some(parameters) = &mut joint.parameters {
                    parameters.rest *= self.sense();
                }
                joint
            })
            .collect();
        ContinuityReport {
            order: joints.iter().map(|joint| joint.continuity).min(),
            coordinate_tolerance: delta,
            largest_turn: joints
                .iter()
                .map(|joint| joint.turn.abs())
                .fold(0.0, f64::max),
            joints,
        }
    }

    fn angle_lag(&self) -> LagReport {
        let mut largest = Largest::above(0.0);
        for (i, segment) in self.segments() {
            let framed = self.reference.framed(segment);
            for t in framed.lag_extremes() {
                largest.take(framed.lag(t).abs(), i, t);
            }
        }
        let (segment, t) = largest.place.unwrap_or((0, 0.0));
        let lag = self.reference.framed(&self.segments[segment]).lag(t);
        LagReport {
            largest: lag.to_degrees() * 1.0_f64.copysign(self.arc.1),
            at: self.place(segment, t),
        }
    }
}

/// Values that differ by less than this part are alike, so that the first of several equal places is named and rounding picks none.
const ALIKE: f64 = 1e-9;

/// The largest of some values and the first place, as (segment from 0, t), where it is taken.
#[derive(Debug, Clone, Copy)]
struct Largest {
    value: f64,
    /// The value at the place, a rounding below `value`.
    there: f64,
    place: Option<(usize, f64)>,
}

impl Largest {
    /// Nothing yet; only what is above this counts.
    const fn above(value: f64) -> Self {
        Self {
            value,
            there: value,
            place: None,
        }
    }

    fn take(&mut self, value: f64, segment: usize, t: f64) {
        if value <= self.value {
            return;
        }
        self.value = value;
        if self.place.is_none() || value - self.there > ALIKE * self.there.abs() {
            (self.there, self.place) = (value, Some((segment, t)));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_alike_places_is_named() {
        let mut largest = Largest::above(0.0);
        for (value, segment) in [(0.0, 0), (2.0, 1), (1.0, 2), (2.0 + 1e-12, 3)] {
            largest.take(value, segment, 0.5);
        }
        assert_eq!(
            (largest.value, largest.place),
            (2.0 + 1e-12, Some((1, 0.5)))
        );
        largest.take(2.1, 4, 0.25);
        assert_eq!((largest.value, largest.place), (2.1, Some((4, 0.25))));
    }

    #[test]
    fn an_angle_comes_between_half_turns() {
        for (degrees, near) in [(10.0, 10.0), (370.0, 10.0), (-190.0, 170.0), (725.0, 5.0)] {
            assert_eq!(remainder(degrees), near);
        }
    }
}
