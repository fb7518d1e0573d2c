//! A curve point by point: what Lancaster tabulates of a spline to find its error.

use kurbo::{Affine, ParamCurve};

use super::bench::Bench;
use super::radial::Profile;
use super::reference::Reference;
use super::{largest_coordinate, unit_for};
use crate::curve::Curve;
use crate::error::{Error, Result};

/// The most points of a curve: memory is bounded.
const MOST_SAMPLES: usize = 1_000_000;

/// A point of a curve beside the true shape. Lengths are in user units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sample {
    /// The number of its segment, from 1.
    pub segment: usize,
    /// The parameter within the segment, from 0 to 1.
    pub t: f64,
    /// The point's x.
    pub x: f64,
    /// The point's y.
    pub y: f64,
    /// Its distance from the centre.
    pub radius: f64,
    /// Its distance from the true shape along the normal, positive outside.
    pub error: f64,
    /// Its angle about the centre in degrees, parametric on an ellipse; whole turns count.
    pub degrees: f64,
}

/// Refuses a number of points of each segment.
pub(crate) fn check_count(count: usize, segments: usize) -> Result<()> {
    let most = MOST_SAMPLES / segments.max(1);
    if (2..=most).contains(&count) {
        return Ok(());
    }
    Err(Error::Unmeasurable(format!(
        "the samples of a segment number from 2, its ends, to {most}, but {count} were asked for"
    )))
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
/// assert_eq!((middle.segment, middle.t), (1, 0.5));
/// assert!((middle.degrees - 45.0).abs() < 1e-12 && middle.error < 0.0);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn samples(curve: &Curve, reference: &Reference, count: usize) -> Result<Vec<Sample>> {
    check_count(count, curve.segments.len())?;
    let unit = unit_for(largest_coordinate(curve, reference)?);
    let scaled = curve.transformed(Affine::scale(1.0 / unit));
    let bench = Bench::new(&scaled, &reference.scaled(1.0 / unit));
    let truth = &bench.reference().truth;
    let of_segment = |(i, segment): (usize, &kurbo::PathSeg)| {
        let (profile, framed) = (
            Profile::new(segment, truth),
            bench.reference().framed(segment),
        );
        let sample = |step: usize| {
            let t = step as f64 / (count - 1) as f64;
            let p = segment.eval(t);
            Sample {
                segment: i + 1,
                t,
                x: p.x * unit,
                y: p.y * unit,
                radius: (p - truth.center).hypot() * unit,
                error: profile.at(t) * unit,
                degrees: bench.angle(i) + framed.turned(t).to_degrees(),
            }
        };
        (0..count).map(sample).collect::<Vec<_>>()
    };
    Ok(bench.segments().flat_map(of_segment).collect())
}
