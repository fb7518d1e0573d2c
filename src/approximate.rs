//! A shape, a rule and a cut become a curve whose error is known.

mod decimals;
mod doubling;
mod extremes;
pub(crate) mod fewest;
mod rounding;
mod rounds;
mod sketch;
pub(crate) mod within;

pub(crate) use decimals::{KnownCurve, ROUNDING_SHARE, automatic_precision};
pub use extremes::approximate_at_extremes;
pub(crate) use sketch::Sketch;

use kurbo::{Affine, PathSeg};

use crate::curve::{Curve, check_coordinates, turn};
use crate::error::Result;
use crate::joints::adaptive::Balance;
use crate::joints::{Cut, Joints, Tolerance, quarters};
use crate::measure::radial;
use crate::method::{Method, Piece, Rule, ellipse};
use crate::number::Precision;
use crate::place::Placed;
use crate::radial_error::RadialError;
use crate::shape::{Outline, Shape};

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
    /// The map that was applied after the shape.
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
/// Where a number of the shape or of the options is not finite or out of range, the rule cannot do what is asked
/// ([`Impossible`](crate::Error::Impossible)), the joints or the transform cannot be used, or
/// no number of segments meets the tolerance ([`ToleranceOutOfReach`](crate::Error::ToleranceOutOfReach)).
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
    drawn(shape, options, false)
}

/// As [`approximate`], but an arc that was given by its ends keeps them whatever the precision: for a path, whose other segments
/// end there.
///
/// # Errors
///
/// As [`approximate`].
pub(crate) fn approximate_between(shape: &Shape, options: &Options) -> Result<Drawing> {
    drawn(shape, options, true)
}

fn drawn(shape: &Shape, options: &Options, keeps_ends: bool) -> Result<Drawing> {
    match Request::new(shape, options)? {
        Some(request) => Request {
            keeps_ends,
            ..request
        }
        .drawing(),
        None => straight(shape, options),
    }
}

/// The curve of [`approximate`] without its error, which costs most of the time, and before rounding.
pub(crate) fn sketch(shape: &Shape, options: &Options) -> Result<Sketch> {
    if let Some(request) = Request::new(shape, options)? {
        return request.sketch();
    }
    let drawing = straight(shape, options)?;
    Ok(Sketch::plain(drawing.curve, drawing.precision))
}

/// A line, or nothing: both are exact but for rounding.
fn straight(shape: &Shape, options: &Options) -> Result<Drawing> {
    let segments = match shape {
        Shape::Line(line) => {
            vec![options.transform * PathSeg::Line(kurbo::Line::new(line.from, line.to))]
        }
        _ => Vec::new(),
    };
    let precision = options.precision.unwrap_or(Precision::Full);
    check_coordinates("coordinate", &segments)?;
    let exact = Curve {
        segments,
        closed: false,
    };
    let curve = exact.rounded(precision, &[]);
    let tolerance = match options.cut {
        Cut::Tolerance(Tolerance::Absolute(distance)) => Some(distance),
        _ => None,
    };
    let error = rounding::of_line(&exact, &curve, tolerance)?;
    Ok(Drawing {
        shape: *shape,
        rule: options.rule,
        transform: options.transform,
        outline: None,
        curve,
        angles: Vec::new(),
        error,
        precision,
    })
}

struct Request<'a> {
    shape: &'a Shape,
    options: &'a Options,
    outline: Outline,
    /// Whether given ends stay as they are even where a precision was asked for.
    keeps_ends: bool,
}

impl<'a> Request<'a> {
    /// `None` for a line and for nothing.
    fn new(shape: &'a Shape, options: &'a Options) -> Result<Option<Self>> {
        shape.check()?;
        options.rule.check()?;
        let Some(outline) = shape.outline() else {
            return Ok(None);
        };
        Ok(Some(Self {
            shape,
            options,
            outline: outline.transformed(options.transform)?,
            keeps_ends: false,
        }))
    }

    fn drawing(&self) -> Result<Drawing> {
        match self.options.cut {
            Cut::Adaptive(count) => self.adaptive(count),
            _ => self.sketch().map(|sketch| self.finish(sketch)),
        }
    }

    fn sketch(&self) -> Result<Sketch> {
        match &self.options.cut {
            Cut::Quarters => self.equal(quarters(self.outline.unit.sweep), None),
            Cut::Count(count) => self.equal(*count, None),
            Cut::Adaptive(count) => {
                // Which of the two ways to place joints is better, only the measured errors tell.
                let drawing = self.adaptive(*count)?;
                Ok(Sketch::plain(drawing.curve, Precision::Full))
            }
            Cut::At(angles) => self.cut(Joints::at(&self.outline.unit, angles)?, None, None),
            Cut::Tolerance(tolerance) => self.fewest(*tolerance),
        }
    }

    fn equal(&self, count: usize, tolerance: Option<f64>) -> Result<Sketch> {
        self.cut(Joints::equal(&self.outline.unit, count)?, None, tolerance)
    }

    /// This many segments at joints that equalise the error, or at equal angles where those do better.
    fn adaptive(&self, count: usize) -> Result<Drawing> {
        let equal = self.equal(count, None).map(|sketch| self.finish(sketch));
        let Some(balance) = Balance::new(&self.outline, self.options.rule) else {
            return equal;
        };
        let Some((joints, _)) = balance.joints_from(count, None, f64::INFINITY) else {
            return equal;
        };
        let drawn = |joints| Ok(self.finish(self.cut(joints, None, None)?));
        let leaping = balance.leaping(count, f64::INFINITY).map(drawn);
        leaping
            .chain([equal])
            .fold(drawn(joints), |nearest, other| {
                let is_nearer = match (&nearest, &other) {
                    (Ok(nearest), Ok(other)) => other.error.peak() < nearest.error.peak(),
                    (_, other) => other.is_ok(),
                };
                if is_nearer { other } else { nearest }
            })
    }

    /// The curve through these joints; `told` is its peak error over the larger radius, where the lobes told it.
    fn cut(&self, joints: Joints, told: Option<f64>, tolerance: Option<f64>) -> Result<Sketch> {
        #[cfg(test)]
        fewest::TRIES.set(fewest::TRIES.get() + 1);
        let pieces = self.pieces(&joints)?;
        let placed = Placed::new(&self.outline, &joints);
        let curve = placed.curve(pieces, joints.closed);
        let peak = self.peak_by_formula(&joints);
        let precision = self.options.precision.unwrap_or_else(|| {
            let known = KnownCurve {
                rule: self.options.rule,
                truth: &self.outline.truth,
                axes: self.outline.axes(),
                cutting: &joints,
                peak,
                told,
            };
            let most = tolerance.unwrap_or(f64::INFINITY);
            known.precision(most, || curve.segments.iter().copied())
        });
        let sketch = Sketch {
            joints: Some(joints),
            curve,
            // What was given is not rounded unless a precision was asked for.
            kept: self
                .outline
                .ends
                .filter(|_| self.keeps_ends || self.options.precision.is_none()),
            precision,
            peak,
            measured: None,
            written: None,
        };
        self.check_extent(&sketch)?;
        Ok(sketch)
    }

    /// The pieces between these joints: the only methods that see an ellipse are those that are best on it.
    fn pieces(&self, joints: &Joints) -> Result<Vec<[Piece; 2]>> {
        let rule = self.options.rule;
        let axes = self.outline.axes();
        let best_on_ellipse = rule
            .method()
            .filter(|method| method.sees_ellipse() && !self.outline.truth.is_circle());
        if let Cut::At(_) = self.options.cut
            && let Some(largest) = rule.largest_uneven_angle(axes.short)
        {
            joints.check_distances(rule, largest)?;
        }
        match best_on_ellipse {
            Some(method) => ellipse::pieces(method, axes, &joints.angles, joints.closed),
            None => rule.pieces(&joints.spans, joints.closed),
        }
    }

    /// The largest coordinate that the shape may reach, or a little more: its digits end there.
    fn reach(&self) -> f64 {
        let truth = &self.outline.truth;
        let radius = truth.larger_radius();
        match self.outline.ends {
            Some(ends) => {
                let sweep = self.outline.unit.sweep.degrees().abs().to_radians();
                let farthest = ends.map(|end| end.to_vec2().hypot());
                farthest[0].max(farthest[1]) + radius * sweep.min(2.0)
            }
            None => truth.center.to_vec2().hypot() + radius,
        }
    }

    /// The peak error before rounding of equal pieces of a circle, each taken on its own.
    fn peak_by_formula(&self, joints: &Joints) -> Option<f64> {
        let truth = &self.outline.truth;
        let first = joints.spans.first()?;
        let alike = joints
            .spans
            .iter()
            .all(|span| span.degrees() == first.degrees());
        if !truth.is_circle() || !alike || self.options.rule.method() == Some(Method::Chen1) {
            return None;
        }
        let error = self.options.rule.radial_error(first).ok()?;
        Some(error.peak() * truth.radii.x)
    }

    /// The drawing, measured as it is written.
    fn finish(&self, sketch: Sketch) -> Drawing {
        let curve = sketch.rounded();
        let error = sketch
            .measured
            .unwrap_or_else(|| radial::error(&curve.segments, &self.outline.truth));
        Drawing {
            shape: *self.shape,
            rule: self.options.rule,
            transform: self.options.transform,
            outline: Some(self.outline),
            curve,
            angles: sketch.joints.map_or_else(Vec::new, |joints| joints.angles),
            error,
            precision: sketch.precision,
        }
    }
}
