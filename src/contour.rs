//! Contours: lines and Béziers as they were given, and arcs that become Béziers, joined at shared points.

mod closeness;
mod finish;
mod pen;
mod placed;
mod quadratics;

use core::ops::Range;

use kurbo::{Line, PathSeg, Point};

use crate::approximate::{self, Sketch, automatic_precision, sketch};
use crate::course::Course;
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::joints::{Cut, MOST_IN_ALL, MOST_SEGMENTS, Tolerance};
use crate::measure::hausdorff::Effort;
use crate::method::Rule;
use crate::number::Precision;
use crate::radial_error::{RadialError, within};
use crate::shape::{Arc, Outline, Shape};
pub use closeness::{Closeness, Nearness};
use finish::{Finisher, MOST_STEPS};
pub(crate) use pen::ContourPen;
pub(crate) use placed::check_placed;

/// A chain of steps, each of which starts where the one before it ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contour {
    /// The steps in their order.
    pub steps: Vec<Step>,
    /// Whether the last point is the first and the contour is to be closed.
    pub closed: bool,
}

/// A part of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// A line or a Bézier.
    Given(PathSeg),
    /// An arc, with its end points.
    Arc(Arc),
}

impl Step {
    /// A straight line.
    #[must_use]
    pub fn line(from: Point, to: Point) -> Self {
        Self::Given(PathSeg::Line(Line::new(from, to)))
    }

    /// What a shape between two points is as a step; `None` for nothing.
    #[must_use]
    pub fn of_shape(shape: Shape) -> Option<Self> {
        match shape {
            Shape::Arc(arc) => Some(Self::Arc(arc)),
            Shape::Line(line) => Some(Self::line(line.from, line.to)),
            Shape::Circle(_) | Shape::Ellipse(_) | Shape::Empty => None,
        }
    }
}

/// What becomes of the Béziers that were given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BezierTarget {
    /// They stay as they are.
    #[default]
    Beziers,
    /// Cubics become quadratics.
    Quadratics,
}

/// A finished path.
#[derive(Debug, Clone, PartialEq)]
pub struct PathDrawing {
    /// Its subpaths, in their order.
    pub subpaths: Vec<Subpath>,
    /// What made it.
    pub maker: Maker,
}

/// What makes the segments of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Maker {
    /// What gives the control points of arcs.
    Rule(Rule),
    /// Chords.
    Lines,
    /// Lines and circular arcs.
    Arcs,
}

impl Maker {
    /// Its id, as in JSON.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Rule(rule) => rule.id(),
            Self::Lines => "lines",
            Self::Arcs => "arcs",
        }
    }
}

/// A finished subpath.
#[derive(Debug, Clone, PartialEq)]
pub struct Subpath {
    /// Its curve, rounded.
    pub curve: Curve,
    /// The lines and circular arcs that stand in place of the curve, which then has no segments.
    pub course: Option<Course>,
    /// How far it strays from what was given. Where cubics became quadratics, both sides hold the largest distance of one from its own, both ways
    /// (Hausdorff), as a bound.
    pub error: RadialError,
    /// How closely its lines and arcs follow what was given, where it was made of these within a tolerance.
    pub closeness: Option<Closeness>,
    /// The true shapes of its arcs, and which segments of the curve approximate each.
    pub truths: Vec<(Range<usize>, Outline)>,
    /// What its error is compared with: the largest radius of its arcs, or half the larger side of its box where it has none.
    pub radius: f64,
}

impl PathDrawing {
    /// The largest error of all subpaths.
    #[must_use]
    pub fn error(&self) -> RadialError {
        let errors = self.subpaths.iter().map(|subpath| subpath.error);
        errors.fold(RadialError::default(), RadialError::with)
    }

    /// The largest of the subpaths' [`Subpath::relative_peak`].
    #[must_use]
    pub fn relative_peak(&self) -> f64 {
        let peaks = self.subpaths.iter().map(Subpath::relative_peak);
        peaks.fold(0.0, f64::max)
    }

    /// How closely it follows what it replaces, where it was made within a tolerance.
    #[must_use]
    pub fn closeness(&self) -> Option<Closeness> {
        let all = self.subpaths.iter();
        all.filter_map(|subpath| subpath.closeness)
            .reduce(Closeness::with)
    }

    /// Refuses what the precision asked for takes farther away than the tolerance asked for.
    fn check_rounding(&self, cut: &Cut) -> Result<()> {
        let Cut::Tolerance(asked) = *cut else {
            return Ok(());
        };
        for subpath in &self.subpaths {
            within(subpath.error.peak(), asked.for_radius(subpath.radius))?;
        }
        Ok(())
    }

    /// The courses of the subpaths, of those that have one.
    pub fn courses(&self) -> impl Iterator<Item = &Course> {
        self.subpaths
            .iter()
            .filter_map(|subpath| subpath.course.as_ref())
    }

    /// The curves of the subpaths.
    pub fn curves(&self) -> impl Iterator<Item = &Curve> {
        self.subpaths.iter().map(|subpath| &subpath.curve)
    }
}

impl Subpath {
    /// How many segments it has: those of its curve, or the lines and arcs in place of it.
    #[must_use]
    pub fn count(&self) -> usize {
        let course = self.course.as_ref();
        course.map_or(self.curve.segments.len(), |course| course.steps.len())
    }

    /// The peak error over [`Subpath::radius`].
    #[must_use]
    pub fn relative_peak(&self) -> f64 {
        if self.radius > 0.0 {
            self.error.peak() / self.radius
        } else {
            0.0
        }
    }
}

/// Draws contours. The points that were given stay as they are unless a precision is asked for; what is computed is rounded as
/// the arc with the smallest peak error needs it, so that one precision holds for the whole path.
///
/// # Errors
///
/// As [`approximate`](crate::approximate()), and where arcs, or cubics as quadratics, would take more segments than a curve may have, or five times as many in all.
///
/// ```
/// use curveto::contour::{BezierTarget, draw};
/// use curveto::path;
/// let pie = path::contours("M0 0L50 0A50 50 0 0 1 0 50Z")?;
/// let drawing = draw(&pie, BezierTarget::Beziers, &curveto::Options::default())?;
/// assert_eq!(path::data(drawing.curves(), false), "M0 0L50 0C50 27.596 27.596 50 0 50Z");
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn draw(
    contours: &[Contour],
    target: BezierTarget,
    options: &approximate::Options,
) -> Result<PathDrawing> {
    check_placed(contours, options.transform)?;
    let counts = match target {
        BezierTarget::Beziers => vec![Vec::new(); contours.len()],
        BezierTarget::Quadratics => quadratics::counts(contours, options)?,
    };
    let mut count = counts.iter().flatten().map(|&count| count as usize).sum();
    let most = MOST_IN_ALL.max(count);
    let sketches: Vec<Vec<Option<Sketch>>> = contours
        .iter()
        .map(|contour| sketches(contour, options, &mut count, most))
        .collect::<Result<_>>()?;
    let precision = options.precision.unwrap_or_else(|| {
        let arcs = sketches.iter().flatten().flatten();
        let given = contours.iter().zip(&counts).flat_map(|(contour, counts)| {
            let steps = contour.steps.iter().zip(counts);
            steps.filter_map(|(step, &count)| precision_of_quadratics(step, count, options))
        });
        finest(arcs.map(|sketch| sketch.precision).chain(given))
    });
    let finish = |precision| {
        let mut steps = Effort(MOST_STEPS);
        let all = contours.iter().zip(&sketches).zip(&counts);
        let subpaths = all.map(|((contour, arcs), counts)| {
            let finisher = Finisher {
                counts,
                options,
                precision,
            };
            finisher.subpath(contour, arcs, &mut steps)
        });
        Ok(PathDrawing {
            subpaths: subpaths.collect::<Result<_>>()?,
            maker: Maker::Rule(options.rule),
        })
    };
    let drawing: PathDrawing = finish(precision)?;
    if options.precision.is_some() {
        drawing.check_rounding(&options.cut)?;
    }
    // Each arc keeps its tolerance at its own precision; that of another may, by chance, round it worse.
    if options.precision.is_none()
        && let Cut::Tolerance(Tolerance::Absolute(tolerance)) = options.cut
        && drawing.error().peak() > tolerance
    {
        return finish(Precision::Full);
    }
    Ok(drawing)
}

/// The sketches of a contour's arcs; `count` is how many segments all else has so far; refused where it has more
/// than a curve may, or all have more than `most`.
fn sketches(
    contour: &Contour,
    options: &approximate::Options,
    count: &mut usize,
    most: usize,
) -> Result<Vec<Option<Sketch>>> {
    let mut here = 0;
    let sketched = contour.steps.iter().map(|step| {
        let sketch = arc(step, options)?;
        let own = sketch
            .as_ref()
            .map_or(0, |sketch| sketch.curve.segments.len());
        here += own;
        *count += own;
        for (count, most) in [(here, MOST_SEGMENTS), (*count, most)] {
            if count > most {
                return Err(Error::Count { count, most });
            }
        }
        Ok(sketch)
    });
    sketched.collect()
}

fn arc(step: &Step, options: &approximate::Options) -> Result<Option<Sketch>> {
    match step {
        Step::Given(_) => Ok(None),
        Step::Arc(arc) => sketch(&Shape::Arc(*arc), options).map(Some),
    }
}

/// The precision with the most digits; full where there is none.
fn finest(precisions: impl Iterator<Item = Precision>) -> Precision {
    let finer = |a, b| match (a, b) {
        (Precision::Fixed(a), Precision::Fixed(b)) => Precision::Fixed(a.max(b)),
        _ => Precision::Full,
    };
    precisions.reduce(finer).unwrap_or(Precision::Full)
}

/// The precision that a given step asks for that becomes so many quadratics.
fn precision_of_quadratics(
    step: &Step,
    count: u32,
    options: &approximate::Options,
) -> Option<Precision> {
    let Step::Given(PathSeg::Cubic(cubic)) = step else {
        return None;
    };
    let cubic = options.transform * *cubic;
    let distance = quadratics::distance_of_quadratics(&cubic, count as usize);
    (distance > 0.0).then(|| automatic_precision(distance, [&PathSeg::Cubic(cubic)]))
}
