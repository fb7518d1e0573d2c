//! Conics by control point and weight: arcs of ellipses, parabolas and hyperbolas.
//!
//! P0, P1, P2 and the weight w of P1 make a rational quadratic: w < 1 an arc of an ellipse, w = 1 a parabola, w > 1 a hyperbola.
//! The first is a [`Shape`] like any other ([`Conic::arc`]); the second is one quadratic Bézier, exactly; the third is drawn here, as
//! is an ellipse so near to a parabola that its centre is out of reach.

mod back;
mod bound;
mod branch;
mod error;
mod frame;
mod halving;
mod report;
mod samples;
mod tolerance;

use kurbo::{PathSeg, Point, QuadBez, Vec2};

use crate::angle::Angle;
use crate::approximate::{Options, automatic_precision};
use crate::curve::{Curve, check_coordinates, with_handles};
use crate::error::{Error, JointsError, Result, ShapeError, finite, positive};
use crate::joints::{Cut, check_count, quarters};
use crate::method::{Method, Rule};
use crate::number::Precision;
use crate::radial_error::{RadialError, within};
use crate::shape::{Arc, Given, Shape, Truth, conic_placement};
use branch::Branch;
use frame::ConicFrame;
pub use report::Report;
pub use samples::ConicSample;

/// A conic between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conic {
    /// Where it starts.
    pub from: Point,
    /// Where the tangents at its ends meet.
    pub control: Point,
    /// Where it ends.
    pub to: Point,
    /// The weight of the control point, positive; those of the ends are 1.
    pub weight: f64,
}

/// What a conic is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// An arc of an ellipse: the weight is below 1.
    Ellipse,
    /// A parabola: the weight is 1.
    Parabola,
    /// A hyperbola: the weight is above 1.
    Hyperbola,
}

impl Kind {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ellipse => "ellipse",
            Self::Parabola => "parabola",
            Self::Hyperbola => "hyperbola",
        }
    }
}

/// From this weight on an ellipse counts as next to a parabola: the distance of its centre costs digits.
const NEXT_TO_PARABOLA: f64 = 1.0 - 1e-4;

/// The largest weight: beyond, a conic is its control polygon.
const LARGEST_WEIGHT: f64 = 1e9;

/// A conic that was drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct ConicDrawing {
    /// What was drawn, the transform applied.
    pub conic: Conic,
    /// What gave the control points; `None` for a parabola, which is exact.
    pub method: Option<Method>,
    /// The curve, rounded.
    pub curve: Curve,
    /// Its largest distances outside (towards the control point) and inside, both ways.
    pub error: RadialError,
}

impl ConicDrawing {
    /// The id of the method, or `exact` for a parabola.
    #[must_use]
    pub fn method_name(&self) -> &'static str {
        self.method.map_or("exact", Method::id)
    }

    /// The peak error over half the longer side of the box of the three points.
    #[must_use]
    pub fn relative_peak(&self) -> f64 {
        self.error.peak() / self.conic.size()
    }
}

impl Conic {
    /// A conic.
    ///
    /// # Errors
    ///
    /// Where a number is not finite, the weight not positive or beyond 1e9, or the three points lie on a line.
    pub fn new(from: Point, control: Point, to: Point, weight: f64) -> Result<Self> {
        for x in [from.x, from.y, control.x, control.y, to.x, to.y] {
            finite("coordinate of a point", x)?;
        }
        if !(weight > 0.0 && weight <= LARGEST_WEIGHT) {
            let most = LARGEST_WEIGHT;
            return Err(Error::Shape(ShapeError::Weight { weight, most }));
        }
        let (u, v) = (from - control, to - control);
        let conic = Self {
            from,
            control,
            to,
            weight,
        };
        if u.cross(v).abs() <= 1e-12 * u.hypot() * v.hypot() {
            return Err(Error::Shape(ShapeError::StraightConic));
        }
        positive("size of the conic", conic.size())?;
        Ok(conic)
    }

    /// What it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self.weight.total_cmp(&1.0) {
            core::cmp::Ordering::Less => Kind::Ellipse,
            core::cmp::Ordering::Equal => Kind::Parabola,
            core::cmp::Ordering::Greater => Kind::Hyperbola,
        }
    }

    /// Half the longer side of the box of its three points.
    fn size(&self) -> f64 {
        let bounds = kurbo::Rect::from_points(self.from, self.to).union_pt(self.control);
        bounds.width().max(bounds.height()) / 2.0
    }

    /// The arc of an ellipse that it is; `None` from a weight of 0.9999 on.
    ///
    /// The unit circle's arc from -h to h, cos h = w, under the affine map that takes its ends and the point (1/w, 0), where its
    /// tangents meet, to the three points.
    ///
    /// # Errors
    ///
    /// Where the ellipse is too flat or too large.
    pub fn arc(&self) -> Result<Option<Shape>> {
        let w = self.weight;
        if w >= NEXT_TO_PARABOLA {
            return Ok(None);
        }
        let ends = [self.from, self.to];
        let placement = conic_placement(ends, self.control, w);
        let truth = Truth::of(placement)?;
        let first = truth.placement().inverse() * self.from;
        let sweep = 4.0 * libm::asin(((1.0 - w) / 2.0).sqrt()).to_degrees();
        let arc = Arc::new(
            truth.center,
            truth.radii,
            Angle::of(truth.axis),
            Angle::of(first.to_vec2()),
            Angle::from_degrees(sweep.copysign(placement.determinant())),
        )?;
        Ok(Some(Shape::Arc(Arc {
            ends: Some(ends),
            given: Given::Conic {
                control: self.control,
                weight: w,
            },
            ..arc
        })))
    }

    /// One segment for every quarter turn of hyperbolic angle, or of an ellipse's.
    fn quarters(&self) -> usize {
        quarters(Angle::from_radians(2.0 * ConicFrame::new(self).half))
    }

    /// Draws it: a parabola as quadratics, exactly; a hyperbola, and an ellipse next to a parabola, as cubics that touch it at both
    /// ends of each. Without a count there is one for every quarter turn; the pieces of a count are of equal hyperbolic angle; those
    /// of a tolerance are each as long as they can be.
    ///
    /// # Errors
    ///
    /// Where the method draws circles and ellipses only, joints or a handle on the unit circle are asked for, or no number of
    /// segments keeps the tolerance.
    ///
    /// ```
    /// use curveto::{Cut, Options, Tolerance, conic::Conic};
    /// let branch = Conic::new((0.0, 0.0).into(), (1.0, 2.0).into(), (3.0, 0.0).into(), 2.5)?;
    /// let cut = Cut::Tolerance(Tolerance::Absolute(1e-3));
    /// let drawing = branch.draw(&Options { cut, ..Options::default() })?;
    /// assert!(drawing.error.peak() <= 1e-3);
    /// # Ok::<(), curveto::Error>(())
    /// ```
    pub fn draw(&self, options: &Options) -> Result<ConicDrawing> {
        let map = options.transform;
        let [from, control, to] = [self.from, self.control, self.to].map(|p| map * p);
        let conic = Self::new(from, control, to, self.weight)?;
        let method = conic.method(options.rule)?;
        let branch = Branch::new(self, map);
        let finish = |segments: Vec<PathSeg>| conic.finish(segments, method, &branch, options);
        match (&options.cut, method) {
            (Cut::Quarters, None) => finish(conic.equal(1, None)?),
            (&Cut::Tolerance(tolerance), None) => {
                let tolerance = tolerance.checked(conic.size())?;
                let drawing = finish(conic.equal(1, None)?)?;
                within(drawing.error.peak(), tolerance)?;
                Ok(drawing)
            }
            (Cut::Quarters, _) => finish(conic.equal(conic.quarters(), method)?),
            (&Cut::Count(count), _) => finish(conic.equal(count, method)?),
            (&Cut::Tolerance(tolerance), Some(method)) => {
                let tolerance = tolerance.checked(conic.size())?;
                conic.within(tolerance, method, &branch, options)
            }
            _ => Err(Error::Joints(JointsError::NoAngles)),
        }
    }

    /// What gives the handles; nothing where none are needed.
    fn method(&self, rule: Rule) -> Result<Option<Method>> {
        let Rule::Method(method) = rule else {
            return Err(Error::Shape(ShapeError::RuleOfEllipses));
        };
        Ok((self.kind() != Kind::Parabola).then_some(method))
    }

    /// Pieces of equal parameter.
    fn equal(&self, count: usize, method: Option<Method>) -> Result<Vec<PathSeg>> {
        check_count(count)?;
        let half = ConicFrame::new(self).half;
        let joint = |i: usize| half * (2.0 * i as f64 - count as f64) / count as f64;
        self.pieces(&(0..=count).map(joint).collect::<Vec<_>>(), method)
    }

    /// The pieces between these parameters, of which the first and the last are the ends.
    fn pieces(&self, joints: &[f64], method: Option<Method>) -> Result<Vec<PathSeg>> {
        if let (None, [_, _]) = (method, joints) {
            let whole = QuadBez::new(self.from, self.control, self.to);
            return Ok(vec![PathSeg::Quad(whole)]);
        }
        let frame = ConicFrame::new(self);
        let ends = joints.windows(2);
        ends.map(|ends| self.piece(&frame, [ends[0], ends[1]], method))
            .collect()
    }

    /// The piece between two parameters.
    fn piece(
        &self,
        frame: &ConicFrame,
        [from, to]: [f64; 2],
        method: Option<Method>,
    ) -> Result<PathSeg> {
        let point = |x: f64| {
            if x == -frame.half {
                self.from
            } else if x == frame.half {
                self.to
            } else {
                frame.point(x)
            }
        };
        let (weight, reach) = frame.piece(to - from);
        let (p0, p3) = (point(from), point(to));
        Ok(match method {
            None => PathSeg::Quad(QuadBez::new(p0, p0 + frame.derivative(from) * reach, p3)),
            Some(method) => {
                let handle = reach * method.conic_handle(weight)?;
                let arms = [from, to].map(|x| -> Vec2 { frame.derivative(x) * handle });
                PathSeg::Cubic(with_handles([p0, p3], arms))
            }
        })
    }

    /// The drawing, measured as it is written. Points that were given stay as they are unless a precision is asked for.
    fn finish(
        &self,
        segments: Vec<PathSeg>,
        method: Option<Method>,
        branch: &Branch,
        options: &Options,
    ) -> Result<ConicDrawing> {
        let curve = Curve {
            segments,
            closed: false,
        };
        check_coordinates("coordinate of a control point", &curve.segments)?;
        let measured = |curve: &Curve| error::error(branch, self, &curve.segments);
        let given = [self.from, self.control, self.to];
        let (precision, kept) = match (options.precision, method, &options.cut) {
            (Some(precision), ..) => (precision, &[][..]),
            (None, None, _) => (Precision::Full, &given[..]),
            (None, Some(_), cut) => {
                let mut error = measured(&curve).peak();
                if let Cut::Tolerance(tolerance) = cut {
                    error = error.min(tolerance.for_radius(self.size()));
                }
                (automatic_precision(error, &curve.segments), &given[..])
            }
        };
        let rounded = curve.rounded(precision, kept);
        curve.check_left(&rounded, options.precision)?;
        let curve = rounded;
        // A map rounds the points.
        let is_mapped = options.transform != kurbo::Affine::IDENTITY;
        let is_whole = method.is_none() && curve.segments.len() == 1;
        let exact = is_whole && precision == Precision::Full && !is_mapped;
        let error = if exact {
            RadialError::default()
        } else {
            measured(&curve)
        };
        Ok(ConicDrawing {
            conic: *self,
            method,
            curve,
            error,
        })
    }
}
