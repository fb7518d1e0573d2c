//! A shape, a rule and a cut become a curve whose error is known.

use kurbo::{Affine, PathSeg, Vec2};

use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::joints::{Cut, Joints, MOST_SEGMENTS, Tolerance, quarters};
use crate::measure::{RadialError, radial};
use crate::method::{Method, Rule, Span};
use crate::shape::{Outline, Shape};
use crate::write::number::Precision;

/// The part of the peak error, or of the tolerance, that rounding for output may add.
const ROUNDING_SHARE: f64 = 0.1;

/// How to draw.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// What gives the control points.
    pub rule: Rule,
    /// Where the sweep is cut.
    pub cut: Cut,
    /// How control points are rounded; `None` picks the fewest decimals that add no more than a tenth of the error.
    pub precision: Option<Precision>,
    /// Applied to the control points, and to the true shape with them.
    pub transform: Affine,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            rule: Rule::default(),
            cut: Cut::default(),
            precision: None,
            transform: Affine::IDENTITY,
        }
    }
}

/// A finished drawing: what was asked for, the curve as it is written, and how far that strays.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// What was asked for.
    pub shape: Shape,
    /// What gave the control points.
    pub rule: Rule,
    /// The map that was applied behind the shape.
    pub transform: Affine,
    /// The true shape, transformed; `None` for a line and for nothing.
    pub outline: Option<Outline>,
    /// The curve, rounded.
    pub curve: Curve,
    /// The angle of each joint in degrees, one more than there are segments; empty for a line and for nothing.
    pub angles: Vec<f64>,
    /// The error of the curve as it is written.
    pub error: RadialError,
    /// How it is written.
    pub precision: Precision,
}

impl Drawing {
    /// The larger radius of the true shape; 0 for a line and for nothing.
    #[must_use]
    pub fn larger_radius(&self) -> f64 {
        self.outline
            .map_or(0.0, |outline| outline.truth.larger_radius())
    }

    /// The peak error over the larger radius; 0 for a line and for nothing.
    #[must_use]
    pub fn relative_peak(&self) -> f64 {
        let radius = self.larger_radius();
        if radius > 0.0 {
            self.error.peak() / radius
        } else {
            0.0
        }
    }

    /// The largest turn of the tangent at a joint, in degrees; a closed shape's first point is a joint too.
    #[must_use]
    pub fn largest_corner(&self) -> f64 {
        let segments = &self.curve.segments;
        let returns = self.outline.is_some_and(|outline| outline.unit.closed);
        let following = segments
            .iter()
            .cycle()
            .skip(1)
            .take(segments.len() - usize::from(!returns && !segments.is_empty()));
        segments
            .iter()
            .zip(following)
            .map(|(before, after)| turn(before, after).abs())
            .fold(0.0, f64::max)
    }
}

/// Draws a shape.
///
/// # Errors
///
/// Where the rule cannot do what is asked ([`Error::Impossible`]), the joints or the transform cannot be used, or no number of
/// segments meets the tolerance ([`Error::ToleranceOutOfReach`]).
///
/// ```
/// use curveto::{Circle, Options, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
/// let drawing = approximate(&circle, &Options::default())?;
/// assert_eq!(drawing.curve.segments.len(), 4);
/// assert!((drawing.relative_peak() - 1.96e-4).abs() < 2e-5); // rounding for output included
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn approximate(shape: &Shape, options: &Options) -> Result<Drawing> {
    let Some(outline) = shape.outline() else {
        return Ok(straight(shape, options));
    };
    let outline = outline.transformed(options.transform)?;
    let asked = Request {
        shape,
        options,
        outline,
    };
    match &options.cut {
        Cut::Quarters => asked.equal(quarters(outline.unit.sweep), None),
        Cut::Count(count) => asked.equal(*count, None),
        Cut::At(angles) => asked.draw(&Joints::at(&outline.unit, angles)?, None),
        Cut::Tolerance(tolerance) => asked.fewest(*tolerance),
    }
}

/// A line, or nothing: both are exact.
fn straight(shape: &Shape, options: &Options) -> Drawing {
    let segments = match shape {
        Shape::Line(line) => {
            vec![options.transform * PathSeg::Line(kurbo::Line::new(line.from, line.to))]
        }
        _ => Vec::new(),
    };
    let precision = options.precision.unwrap_or(Precision::Full);
    let curve = Curve {
        segments,
        closed: false,
    }
    .rounded(precision, &[]);
    Drawing {
        shape: *shape,
        rule: options.rule,
        transform: options.transform,
        outline: None,
        curve,
        angles: Vec::new(),
        error: RadialError::default(),
        precision,
    }
}

struct Request<'a> {
    shape: &'a Shape,
    options: &'a Options,
    outline: Outline,
}

impl Request<'_> {
    fn equal(&self, count: usize, tolerance: Option<f64>) -> Result<Drawing> {
        self.draw(&Joints::equal(&self.outline.unit, count)?, tolerance)
    }

    /// The curve through these joints before rounding.
    fn curve(&self, joints: &Joints) -> Result<Curve> {
        let pieces = self.options.rule.pieces(&joints.spans, joints.closed)?;
        Ok(Curve::place(&self.outline, joints, &pieces))
    }

    fn draw(&self, joints: &Joints, tolerance: Option<f64>) -> Result<Drawing> {
        let exact = self.curve(joints)?;
        let truth = &self.outline.truth;
        let precision = self.options.precision.unwrap_or_else(|| {
            let peak = radial::error(&exact.segments, truth).peak();
            automatic_precision(
                peak.min(tolerance.unwrap_or(f64::INFINITY)),
                &exact.segments,
            )
        });
        // What was given is not rounded unless a precision was asked for.
        let kept = if self.options.precision.is_none() {
            self.outline.ends
        } else {
            None
        };
        let curve = exact.rounded(precision, kept.as_ref().map_or(&[], |ends| &ends[..]));
        let error = radial::error(&curve.segments, truth);
        Ok(Drawing {
            shape: *self.shape,
            rule: self.options.rule,
            transform: self.options.transform,
            outline: Some(self.outline),
            curve,
            angles: joints.angles.clone(),
            error,
            precision,
        })
    }

    /// The fewest equal segments whose rounded curve is within the tolerance.
    fn fewest(&self, tolerance: Tolerance) -> Result<Drawing> {
        let truth = &self.outline.truth;
        let tolerance = tolerance.for_radius(truth.larger_radius());
        if tolerance <= 0.0 || !tolerance.is_finite() {
            return Err(Error::NotPositive {
                what: "tolerance",
                value: tolerance,
            });
        }
        let reach = truth.center.to_vec2().hypot() + truth.larger_radius();
        if tolerance < 8.0 * f64::EPSILON * reach {
            return Err(self.out_of_reach(
                tolerance,
                "it is finer than the digits of a double-precision coordinate".to_owned(),
                format!(
                    "the finest tolerance at this size is about {:.1e}",
                    8.0 * f64::EPSILON * reach
                ),
            ));
        }
        let mut last_refusal = None;
        for count in self.counts(tolerance) {
            match self.equal(count, Some(tolerance)) {
                Ok(drawing) if drawing.error.peak() <= tolerance => return Ok(drawing),
                Ok(_) => {}
                Err(refusal @ Error::Impossible { .. }) => last_refusal = Some(refusal),
                Err(other) => return Err(other),
            }
        }
        Err(match (last_refusal, self.options.precision) {
            (_, Some(Precision::Fixed(decimals))) if 10_f64.powi(-i32::from(decimals)) > tolerance => self.out_of_reach(
                tolerance,
                format!("rounding to {decimals} decimals moves points farther than that"),
                "give more decimals with -p, or leave the precision to -p auto".to_owned(),
            ),
            (Some(refusal), _) if self.counts(tolerance).count() < 2 => refusal,
            _ => self.out_of_reach(
                tolerance,
                "its error does not fall that far".to_owned(),
                "take a larger tolerance, or -m minimax, whose error falls with the sixth power of the angle".to_owned(),
            ),
        })
    }

    fn out_of_reach(&self, tolerance: f64, why: String, remedy: String) -> Error {
        Error::ToleranceOutOfReach {
            method: self.options.rule.id(),
            tolerance,
            why,
            remedy,
        }
    }

    /// The counts that may be the fewest, ascending.
    fn counts(&self, tolerance: f64) -> impl Iterator<Item = usize> + use<> {
        let sweep = self.outline.unit.sweep.degrees().abs();
        let rule = self.options.rule;
        let (first, last) = match rule {
            Rule::Method(Method::LancasterBest) => (1, 8),
            Rule::Method(Method::LancasterDrawellipse) => (
                quarters(self.outline.unit.sweep),
                quarters(self.outline.unit.sweep),
            ),
            // On an open arc its ends have the circle's derivatives, and it errs less than on a closed shape, which the estimate knows.
            Rule::Method(Method::Chen1) if !self.outline.unit.closed => {
                ((self.least_count(tolerance) / 2).max(1), MOST_SEGMENTS)
            }
            // The error of a literal handle is least near its own angle and grows again beyond it.
            Rule::Handle(k) => (
                1,
                (sweep / (4.0 * (0.75 * k.abs()).atan()).to_degrees()).min(1e4) as usize + 3,
            ),
            _ => (self.least_count(tolerance), MOST_SEGMENTS),
        };
        // Rounding and the error of joints beyond the estimate ask for a few more segments; a rule whose error does not fall ends here.
        first..=last.min(2 * first + 64)
    }

    /// A count below which even the flattest place of the shape would be beyond the tolerance.
    fn least_count(&self, tolerance: f64) -> usize {
        let truth = &self.outline.truth;
        let sweep = self.outline.unit.sweep.degrees().abs();
        let rounding = match self.options.precision {
            Some(Precision::Fixed(decimals)) => 10_f64.powi(-i32::from(decimals)),
            _ => tolerance * ROUNDING_SHARE,
        };
        let allowed = (tolerance + rounding) / truth.radii.x.min(truth.radii.y);
        let beyond = |count: usize| {
            self.options
                .rule
                .radial_error(&Span::from_degrees(sweep / count as f64))
                .map_or(true, |error| error.peak() > allowed)
        };
        let mut high = 1;
        while high < MOST_SEGMENTS && beyond(high) {
            high *= 2;
        }
        let mut low = high / 2;
        while low + 1 < high {
            let middle = usize::midpoint(low, high);
            if beyond(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        high.clamp(1, MOST_SEGMENTS)
    }
}

/// The angle between the tangents of two segments where they join, in degrees.
fn turn(before: &PathSeg, after: &PathSeg) -> f64 {
    let (incoming, outgoing) = (before.reverse(), *after);
    let (incoming, outgoing) = (-first_direction(&incoming), first_direction(&outgoing));
    incoming
        .cross(outgoing)
        .atan2(incoming.dot(outgoing))
        .to_degrees()
}

/// The direction in which a segment leaves its first point.
fn first_direction(segment: &PathSeg) -> Vec2 {
    let points = crate::curve::control_points(segment);
    points
        .iter()
        .map(|&p| p - points[0])
        .find(|v| *v != Vec2::ZERO)
        .unwrap_or_default()
}

/// The fewest decimals for which rounding moves no point farther than a tenth of `error`.
pub(crate) fn automatic_precision<'a>(
    error: f64,
    segments: impl IntoIterator<Item = &'a PathSeg>,
) -> Precision {
    let largest = segments
        .into_iter()
        .flat_map(crate::curve::control_points)
        .flat_map(|p| [p.x.abs(), p.y.abs()])
        .fold(0.0, f64::max);
    Precision::moving_at_most(ROUNDING_SHARE * error, largest)
}
