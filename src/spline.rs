//! Composite parametric cubics through points: Da-Pan Chen, "Formulations of composite parametric cubic curves and circle
//! approximations" (1996), Formulations I and II.
//!
//! Formulation I takes every segment's parameter from 0 to 1 ([`Parametrization::Uniform`]). Formulation II takes arc length as the
//! parameter, iterated from the chords ([`Parametrization::ArcLength`]), and makes the nodal derivatives unit vectors
//! ([`Options::unit_tangents`]), which gives up C² for G¹. The segment k is a cubic Bézier curve with handles `t_k` D/3.

pub mod points;

use kurbo::{Affine, CubicBez, ParamCurveArclen, PathSeg, Point, Vec2};

use crate::curve::{Curve, with_handles};
use crate::error::{Error, Result, finite, positive};
pub use crate::method::Quadrature;
use crate::method::nodal;
pub use crate::method::nodal::SplineEnds;
use crate::number::Precision;

/// The arc lengths have settled when none changes by more than this part of itself, where nothing else is asked for.
pub const SETTLED: f64 = 1e-12;

/// The most lengths that are kept of all rounds.
const MOST_KEPT: usize = 1 << 20;

/// The accuracy of an arc length, as a part of the length of its control polygon.
const ACCURACY: f64 = 1e-14;

/// The most rounds in which arc lengths may settle; from the chords of a tame curve it takes a dozen or two.
const MOST_ROUNDS: usize = 500;

/// The part of the shortest distance between neighbours that rounding may move a control point, where no precision is asked for.
const ROUNDING_SHARE: f64 = 1e-4;

/// How far the parameter runs along each segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Parametrization {
    /// From 0 to 1 on every segment: Chen's Formulation I.
    #[default]
    Uniform,
    /// The distance of the segment's ends.
    Chord,
    /// The square root of the distance of the segment's ends.
    Centripetal,
    /// The arc length of the segment itself: Chen's Formulation II.
    ArcLength(Quadrature),
}

impl Parametrization {
    /// The name on the command line and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Chord => "chord",
            Self::Centripetal => "centripetal",
            Self::ArcLength(_) => "arc-length",
        }
    }

    /// The parameter length of a segment whose ends are this far apart, before any iteration.
    fn length(self, chord: f64) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Centripetal => chord.sqrt(),
            Self::Chord | Self::ArcLength(_) => chord,
        }
    }
}

impl Quadrature {
    /// The arc length of a cubic.
    fn length(self, cubic: &CubicBez) -> f64 {
        match self {
            Self::Adaptive => {
                let legs = [
                    cubic.p1 - cubic.p0,
                    cubic.p2 - cubic.p1,
                    cubic.p3 - cubic.p2,
                ];
                cubic.arclen(ACCURACY * legs.map(Vec2::hypot).iter().sum::<f64>())
            }
            Self::Gauss2 => {
                // The points (1 -+ 1/sqrt 3)/2, in Bernstein form: the derivative is 3 (s² d1 + 2 s t d2 + t² d3).
                let speed = |t: f64| {
                    let s = 1.0 - t;
                    let (d1, d2) = (cubic.p1 - cubic.p0, cubic.p2 - cubic.p1);
                    let d3 = cubic.p3 - cubic.p2;
                    3.0 * (d1 * (s * s) + d2 * (2.0 * s * t) + d3 * (t * t)).hypot()
                };
                let half = 0.5 / 3.0_f64.sqrt();
                f64::midpoint(speed(0.5 - half), speed(0.5 + half))
            }
        }
    }
}

/// How a curve runs through its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How far the parameter runs along each segment.
    pub parametrization: Parametrization,
    /// What holds at the ends.
    pub ends: SplineEnds,
    /// Whether the nodal derivatives are made unit vectors: the curve is then G¹ and no longer C². A derivative that is zero, as
    /// that of a free end, stays zero.
    pub unit_tangents: bool,
    /// The iteration of arc lengths ends when none changes by more than this part of itself: the criterion of Chen's Figure 8.
    pub stop: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            parametrization: Parametrization::default(),
            ends: SplineEnds::default(),
            unit_tangents: false,
            stop: SETTLED,
        }
    }
}

/// A composite parametric cubic through points.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// The points, which are the nodes of the curve.
    pub points: Vec<Point>,
    /// How the curve runs through them.
    pub options: Options,
    /// The parameter length of each segment, one for each but with ends that are not cyclic one less than there are points.
    pub lengths: Vec<f64>,
    /// The derivative at each point with respect to the parameter.
    pub derivatives: Vec<Vec2>,
    /// In how many rounds the arc lengths settled; 0 where they are not asked for.
    pub rounds: usize,
    /// The arc lengths after each round, the first with the chords; empty where they are not asked for or beyond a million numbers.
    pub history: Vec<Vec<f64>>,
}

impl Spline {
    /// The curve through these points, in time and memory linear in their number.
    ///
    /// # Errors
    ///
    /// [`Error::TooFewPoints`], [`Error::RepeatedPoint`] where two neighbours coincide, [`Error::TooSmall`] where they
    /// all but do, [`Error::NotFinite`] and [`Error::TooLarge`] for a coordinate, and [`Error::Unsettled`] where the arc lengths do not settle.
    ///
    /// ```
    /// use curveto::spline::{SplineEnds, Options, Spline};
    /// // Chen's Figure 5: Formulation I through four points of the unit circle.
    /// let square = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    /// let options = Options { ends: SplineEnds::Cyclic, ..Options::default() };
    /// let spline = Spline::new(square.map(kurbo::Point::from).to_vec(), options)?;
    /// assert_eq!(spline.derivatives[0], kurbo::Vec2::new(0.0, 1.5));
    /// assert_eq!(spline.segment(0).p1, kurbo::Point::new(1.0, 0.5));
    /// # Ok::<(), curveto::Error>(())
    /// ```
    pub fn new(points: Vec<Point>, options: Options) -> Result<Self> {
        check(&points, options.ends)?;
        let chords = (0..options.ends.segments(points.len()))
            .map(|k| (points[(k + 1) % points.len()] - points[k]).hypot());
        let mut spline = Self {
            lengths: chords.map(|c| options.parametrization.length(c)).collect(),
            derivatives: Vec::new(),
            rounds: 0,
            history: Vec::new(),
            points,
            options,
        };
        spline.solve();
        if let Parametrization::ArcLength(quadrature) = options.parametrization {
            spline.settle(quadrature)?;
        }
        Ok(spline)
    }

    /// The cubic from the point `k` to the next.
    ///
    /// # Panics
    ///
    /// Where there is no such segment.
    #[must_use]
    pub fn segment(&self, k: usize) -> CubicBez {
        let next = (k + 1) % self.points.len();
        let (p0, p3) = (self.points[k], self.points[next]);
        let third = self.lengths[k] / 3.0;
        let derivatives = [self.derivatives[k], self.derivatives[next]];
        with_handles([p0, p3], derivatives.map(|d| d * third))
    }

    /// The segments in their order.
    pub fn segments(&self) -> impl Iterator<Item = CubicBez> + '_ {
        (0..self.lengths.len()).map(|k| self.segment(k))
    }

    /// The curve as it is written: its control points mapped, then rounded once; shared points stay shared.
    ///
    /// Without a precision the points themselves stay as they were given where nothing is mapped, and all others get the fewest
    /// decimals d for which 10^-d/sqrt(2), the farthest that rounding moves a point, is at most a ten-thousandth of the shortest
    /// distance between neighbours.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] and [`Error::TooLarge`] where a control point leaves the range of coordinates.
    pub fn curve(&self, precision: Option<Precision>, transform: Affine) -> Result<Curve> {
        let automatic = precision.is_none();
        let precision = precision.unwrap_or_else(|| self.automatic_precision(transform));
        let coordinate = |x: f64| finite("coordinate of a control point", x);
        let at = |p: Point| {
            let p = transform * p;
            let (x, y) = (precision.round(p.x), precision.round(p.y));
            Ok(Point::new(coordinate(x)?, coordinate(y)?))
        };
        let kept = automatic && transform == Affine::IDENTITY;
        let node = |p: Point| if kept { Ok(p) } else { at(p) };
        let place = |c: CubicBez| {
            let cubic = CubicBez::new(node(c.p0)?, at(c.p1)?, at(c.p2)?, node(c.p3)?);
            Ok(PathSeg::Cubic(cubic))
        };
        let closed = self.options.ends == SplineEnds::Cyclic;
        let segments = self.segments().map(place).collect::<Result<_>>()?;
        let rounded = Curve { segments, closed };
        if !automatic {
            let segments = self
                .segments()
                .map(|c| PathSeg::Cubic(transform * c))
                .collect();
            Curve { segments, closed }.check_left(&rounded, Some(precision))?;
        }
        Ok(rounded)
    }

    fn automatic_precision(&self, transform: Affine) -> Precision {
        let mut shortest = f64::INFINITY;
        let mut largest = 0.0_f64;
        for cubic in self.segments() {
            let cubic = transform * cubic;
            shortest = shortest.min((cubic.p3 - cubic.p0).hypot());
            largest = [cubic.p0, cubic.p1, cubic.p2]
                .iter()
                .fold(largest, |l, p| l.max(p.x.abs()).max(p.y.abs()));
        }
        Precision::moving_at_most(ROUNDING_SHARE * shortest, largest)
    }

    /// Solves for the nodal derivatives with the parameter lengths as they are.
    fn solve(&mut self) {
        // The length after the last point of an open curve is asked for and not used.
        let length = |k: usize| self.lengths.get(k).copied().unwrap_or(1.0);
        self.derivatives = nodal::derivatives(&self.points, length, self.options.ends);
        if self.options.unit_tangents {
            for derivative in &mut self.derivatives {
                if *derivative != Vec2::ZERO {
                    *derivative /= derivative.hypot();
                }
            }
        }
    }

    /// Keeps the lengths of this round, or of none where they are too many.
    fn record(&mut self) {
        if (self.rounds + 1) * self.lengths.len() <= MOST_KEPT {
            self.history.push(self.lengths.clone());
        } else {
            self.history = Vec::new();
        }
    }

    /// Iterates the parameter lengths to the curve's own arc lengths, as Chen's Figure 8 does.
    fn settle(&mut self, quadrature: Quadrature) -> Result<()> {
        self.record();
        for round in 1..=MOST_ROUNDS {
            self.rounds = round;
            let mut change = 0.0_f64;
            for k in 0..self.lengths.len() {
                let measured = quadrature.length(&self.segment(k));
                if !(measured > 0.0 && measured.is_finite()) {
                    return Err(Error::Unsettled { rounds: round });
                }
                change = change.max((measured - self.lengths[k]).abs() / measured);
                self.lengths[k] = measured;
            }
            self.record();
            self.solve();
            if change < self.options.stop {
                return Ok(());
            }
        }
        Err(Error::Unsettled {
            rounds: MOST_ROUNDS,
        })
    }
}

/// Refuses points that no curve with these ends runs through.
fn check(points: &[Point], ends: SplineEnds) -> Result<()> {
    let least = ends.least_points();
    if points.len() < least {
        return Err(Error::TooFewPoints {
            count: points.len(),
            least,
            cyclic: ends == SplineEnds::Cyclic,
        });
    }
    for p in points {
        finite("x coordinate of a point", p.x)?;
        finite("y coordinate of a point", p.y)?;
    }
    if let SplineEnds::Fixed(derivatives) = ends {
        for d in derivatives {
            finite("end derivative", d.x)?;
            finite("end derivative", d.y)?;
        }
    }
    for first in 0..ends.segments(points.len()) {
        let second = (first + 1) % points.len();
        let between = points[second] - points[first];
        if between == Vec2::ZERO {
            return Err(Error::RepeatedPoint { first, second });
        }
        let spacing = between.x.abs().max(between.y.abs());
        positive("spacing of two points", spacing)?;
    }
    Ok(())
}
