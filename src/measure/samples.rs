//! A curve point by point: what Lancaster tabulates of a spline to find its error.

use kurbo::{Affine, ParamCurve, PathSeg, Point};

use super::bench::Bench;
use super::radial::Profile;
use super::reference::Reference;
use super::{largest_coordinate, unit_for};
use crate::curve::Curve;
use crate::error::{Error, Result, UnmeasurableError};

/// The most points of a curve: memory is bounded.
const MOST_SAMPLES: usize = 1_000_000;

/// A point of a curve, and where on the curve it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SamplePoint {
    /// The number of its segment, from 1.
    pub segment: usize,
    /// The parameter within the segment, from 0 to 1.
    pub t: f64,
    /// The point's x.
    pub x: f64,
    /// The point's y.
    pub y: f64,
}

/// A point of a curve beside the true shape. Lengths are in user units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sample {
    /// The point.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub at: SamplePoint,
    /// Its distance from the centre.
    pub radius: f64,
    /// Its distance from the true shape along the normal, positive outside.
    pub error: f64,
    /// Its angle about the centre in degrees, parametric on an ellipse; whole turns count.
    pub degrees: f64,
}

/// `count` points of each segment at equal steps of t; `of_segment` makes what makes a sample of each.
pub(crate) fn sampled<S, F: Fn(SamplePoint) -> S>(
    curve: &Curve,
    count: usize,
    of_segment: impl Fn(usize, &PathSeg) -> F,
) -> Result<Vec<S>> {
    let most = MOST_SAMPLES / curve.segments.len().max(1);
    if !(2..=most).contains(&count) {
        return Err(Error::Unmeasurable(UnmeasurableError::Samples {
            count,
            most,
        }));
    }
    let segments = curve.segments.iter().enumerate();
    let samples = segments.flat_map(|(i, segment)| {
        let sample = of_segment(i, segment);
        let place = move |step: usize| {
            let t = step as f64 / (count - 1) as f64;
            let Point { x, y } = segment.eval(t);
            let segment = i + 1;
            sample(SamplePoint { segment, t, x, y })
        };
        (0..count).map(place)
    });
    Ok(samples.collect())
}

/// `count` points of each segment at equal steps of t, both ends among them.
///
/// # Errors
///
/// Where `count` is below 2 or all points are more than a million, and where a coordinate is not finite or beyond 1e150.
///
/// ```
/// use curveto::measure::{Reference, samples::samples};
/// use curveto::{Circle, Options, Shape, approximate};
/// let drawing = approximate(&Shape::Circle(Circle::new((0.0, 0.0), 1.0)?), &Options::default())?;
/// let reference = Reference::from(&drawing.outline.expect("a circle has an outline"));
/// let middle = samples(&drawing.curve, &reference, 3)?[1];
/// assert_eq!((middle.at.segment, middle.at.t), (1, 0.5));
/// assert!((middle.degrees - 45.0).abs() < 1e-12 && middle.error < 0.0);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn samples(curve: &Curve, reference: &Reference, count: usize) -> Result<Vec<Sample>> {
    let unit = unit_for(largest_coordinate(curve, reference)?);
    let scaled = curve.transformed(Affine::scale(1.0 / unit));
    let bench = Bench::new(&scaled, &reference.scaled(1.0 / unit));
    let (reference, bench) = (bench.reference(), &bench);
    sampled(&scaled, count, |i, segment| {
        let profile = Profile::new(segment, &reference.truth);
        let framed = reference.framed(segment);
        move |at| {
            let p = Point::new(at.x, at.y);
            Sample {
                at: SamplePoint {
                    x: p.x * unit,
                    y: p.y * unit,
                    ..at
                },
                radius: (p - reference.truth.center).hypot() * unit,
                error: profile.at(at.t) * unit,
                degrees: bench.angle(i) + framed.turned(at.t).to_degrees(),
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Truth;
    use kurbo::CubicBez;

    #[test]
    fn samples_are_points_of_the_curve_beside_the_circle() {
        let center = Point::new(30.0, -10.0);
        let curve = Curve {
            segments: vec![
                PathSeg::Cubic(CubicBez::new(
                    (35.0, -10.0),
                    (35.0, -7.0),
                    (33.0, -5.0),
                    (30.0, -5.0),
                )),
                PathSeg::Cubic(CubicBez::new(
                    (30.0, -5.0),
                    (27.0, -5.0),
                    (25.0, -7.5),
                    (25.0, -10.0),
                )),
            ],
            closed: false,
        };
        let found = samples(&curve, &Reference::from(Truth::circle(center, 5.0)), 5).unwrap();
        assert_eq!(found.len(), 10);
        for (i, sample) in found.iter().enumerate() {
            let (segment, t) = (i / 5, (i % 5) as f64 / 4.0);
            let point = curve.segments[segment].eval(t);
            let arm = point - center;
            let at = SamplePoint {
                segment: segment + 1,
                t,
                x: point.x,
                y: point.y,
            };
            assert_eq!(sample.at, at);
            assert!((sample.radius - arm.hypot()).abs() < 1e-14);
            assert!((sample.error - (arm.hypot() - 5.0)).abs() < 1e-14);
            assert!(
                (sample.degrees - arm.atan2().to_degrees()).abs() < 1e-12,
                "{sample:?}"
            );
        }
    }
}
