//! Chen's Figure 1: the parallels and meridians of a sphere, each a circle approximation in space, in orthographic view.
//!
//! Orthographic projection is affine, so that the image of a Bézier curve in space is the Bézier curve of the images of its control
//! points, exactly. Nothing is left of the third coordinate but the depth, which is a polynomial in the curve's own parameter: a
//! curve passes behind the limb where that changes its sign, and is cut there.

mod limb;
mod space;

use core::iter;

use kurbo::{Affine, Point};

use crate::angle::Angle;
use crate::approximate::{self, Drawing, approximate, automatic_precision};
use crate::curve::{Curve, check_coordinates, control_points, largest_move};
use crate::error::{Error, Result, ShapeError, finite, positive};
use crate::joints::{Cut, MOST_SEGMENTS};
use crate::measure::radial;
use crate::method::Rule;
use crate::number::Precision;
use crate::radial_error::RadialError;
use crate::shape::{Arc, Circle, Shape};
use limb::LimbSide;
use space::{Ring, Space};

/// A sphere with the lines on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Where its centre is seen.
    pub center: Point,
    /// Its radius, positive.
    pub radius: f64,
    /// The number of meridians, each from pole to pole, at equal angles from longitude 0.
    pub meridians: usize,
    /// The number of parallels, which divide the way from pole to pole into equal parts; the equator is one where they are odd.
    pub parallels: usize,
}

/// From where a sphere is seen.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct View {
    /// The longitude of the point in the middle.
    pub longitude: Angle,
    /// The latitude of the point in the middle.
    pub latitude: Angle,
    /// Whether north is towards +y, as on a PostScript page, and not towards -y, as on an SVG canvas.
    pub y_up: bool,
}

/// How to draw it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// What gives the control points.
    pub rule: Rule,
    /// Where a whole circle is cut; a half circle gets half of this many segments. Angles are longitudes on a parallel, counted from
    /// the north pole on a meridian, and as they are seen on the outline. An absolute tolerance is in radii.
    pub cut: Cut,
    /// How control points are rounded; `None` picks the fewest decimals that add no more than a tenth of the error.
    pub precision: Option<Precision>,
    /// Applied to the projected control points.
    pub transform: Affine,
}

/// What a line on the sphere is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SphereLine {
    /// The circle of this latitude.
    Parallel(Angle),
    /// The half circle of this longitude, and where meridians come in opposite pairs the other half too.
    Meridian(Angle),
    /// The great circle that is seen as the outline.
    Outline,
}

/// A part of a line on the sphere, as it is seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The line.
    pub line: SphereLine,
    /// The projected curve, closed where it is a whole circle.
    pub curve: Curve,
}

/// A sphere as it is seen.
#[derive(Debug, Clone, PartialEq)]
pub struct SphereView {
    /// What was asked for.
    pub sphere: Sphere,
    /// From where.
    pub view: View,
    /// How it is drawn.
    pub options: Options,
    /// What lies before the limb, and lines that lie in it.
    pub front: Vec<Part>,
    /// What lies behind the limb.
    pub back: Vec<Part>,
    /// The outline.
    pub outline: Part,
    /// Bounds of how far any of the curves, mapped and rounded, lies from its true circle as it is seen: of the outline its own error, of what
    /// else is drawn the error in space, which is never less than what is seen of it, and how far rounding moves it.
    pub error: RadialError,
}

impl Sphere {
    /// A sphere.
    ///
    /// # Errors
    ///
    /// Where a number is not finite, the radius is not positive, or there are more lines than anyone draws.
    pub fn new(
        center: impl Into<Point>,
        radius: f64,
        meridians: usize,
        parallels: usize,
    ) -> Result<Self> {
        let sphere = Self {
            center: center.into(),
            radius,
            meridians,
            parallels,
        };
        sphere.check()?;
        Ok(sphere)
    }

    fn check(&self) -> Result<()> {
        finite("x coordinate of the centre", self.center.x)?;
        finite("y coordinate of the centre", self.center.y)?;
        let counts = [self.meridians, self.parallels];
        if let Some(count) = counts.into_iter().find(|&n| n > MOST_LINES) {
            let most = MOST_LINES;
            return Err(Error::Shape(ShapeError::TooManyLines { count, most }));
        }
        positive("radius", self.radius)?;
        Ok(())
    }

    /// The sphere as it is seen.
    ///
    /// # Errors
    ///
    /// As [`Sphere::new`], since fields are open; where the rule cannot do what is asked: a method whose ends leave the circle draws no half circles, which an odd number of
    /// meridians are; where the latitude of the view is none; and where control points leave the range of coordinates.
    ///
    /// ```
    /// use curveto::sphere::{Options, Sphere, View};
    /// use curveto::Angle;
    /// let view = View { latitude: Angle::from_degrees(90.0), ..View::default() };
    /// let seen = Sphere::new((0.0, 0.0), 100.0, 4, 1)?.seen(view, &Options::default())?;
    /// assert_eq!(seen.front.len(), 3); // the equator lies in the limb; two meridians cross at the pole
    /// assert_eq!(seen.back.len(), 2);
    /// # Ok::<(), curveto::Error>(())
    /// ```
    pub fn seen(&self, view: View, options: &Options) -> Result<SphereView> {
        self.check()?;
        let count = self.meridians.div_ceil(2) + self.parallels + 1;
        let most = MOST_SEGMENTS / count;
        if let Cut::Count(count) = options.cut
            && count > most
        {
            return Err(Error::Count { count, most });
        }
        let space = Space::new(self, view)?;
        let units = Units::new(self, view, options)?;
        let mut picture = SphereView {
            sphere: *self,
            view,
            options: options.clone(),
            front: Vec::new(),
            back: Vec::new(),
            outline: Part {
                line: SphereLine::Outline,
                curve: units.circle.curve.transformed(space.outline()),
            },
            error: units.error().times(self.radius),
        };
        for (line, ring) in self.lines(&space) {
            for (side, curve) in limb::cut(units.curve(line), ring.depth) {
                let curve = curve.transformed(ring.screen);
                match side {
                    LimbSide::Front => picture.front.push(Part { line, curve }),
                    LimbSide::Back => picture.back.push(Part { line, curve }),
                }
            }
        }
        picture.finished()
    }

    /// The lines on the sphere and where they lie.
    fn lines(&self, space: &Space) -> impl Iterator<Item = (SphereLine, Ring)> {
        let parallel = |latitude| (SphereLine::Parallel(latitude), space.parallel(latitude));
        let meridian = |longitude| (SphereLine::Meridian(longitude), space.meridian(longitude));
        let parallels = self.latitudes().map(parallel);
        parallels.chain(self.longitudes().map(meridian))
    }

    /// The latitudes of the parallels, from the north.
    fn latitudes(&self) -> impl Iterator<Item = Angle> + use<> {
        let parts = self.parallels + 1;
        // Counted from the equator, so that both halves mirror to the last digit.
        (1..parts).map(move |i| {
            Angle::from_degrees(90.0 * (parts as f64 - 2.0 * i as f64) / parts as f64)
        })
    }

    /// The longitudes of the meridians; where they come in opposite pairs one of each pair.
    fn longitudes(&self) -> impl Iterator<Item = Angle> + use<> {
        let count = self.meridians;
        let circles = if count.is_multiple_of(2) {
            count / 2
        } else {
            count
        };
        (0..circles).map(move |i| Angle::from_degrees(360.0 * i as f64 / count as f64))
    }
}

impl SphereView {
    /// The larger error over the radius as it is seen.
    #[must_use]
    pub fn relative_peak(&self) -> f64 {
        let [_, largest] = scales(self.options.transform);
        self.error.peak() / (self.sphere.radius * largest)
    }

    /// The picture mapped and rounded.
    fn finished(mut self) -> Result<Self> {
        let transform = self.options.transform;
        for part in self.parts_mut() {
            part.curve = part.curve.transformed(transform);
        }
        let noise = self.noise();
        let segments = self.parts().flat_map(|part| &part.curve.segments);
        check_coordinates("coordinate of a control point", segments)?;
        let [smallest, largest] = scales(transform);
        let precision = self.options.precision.unwrap_or_else(|| {
            automatic_precision(
                self.error.peak() * smallest,
                self.parts().flat_map(|part| &part.curve.segments),
            )
        });
        let outline = &self.outline.curve;
        outline.check_left(&outline.rounded(precision, &[]), self.options.precision)?;
        let (mut moved, mut of_outline) = (None::<f64>, 0.0);
        for part in self.parts_mut() {
            let rounded = part.curve.rounded(precision, &[]);
            let off = noise + largest_move(&part.curve, &rounded);
            match part.line {
                SphereLine::Outline => of_outline = off,
                _ => moved = Some(moved.unwrap_or_default().max(off)),
            }
            part.curve = rounded;
        }
        let mapped = self.error.times(largest);
        let outline = self
            .outline_error()
            .unwrap_or_else(|| mapped.with_more(of_outline));
        self.error = moved.map_or(outline, |moved| outline.with(mapped.with_more(moved)));
        Ok(self)
    }

    /// The error of the outline as it is drawn; `None` where the map leaves it no area.
    fn outline_error(&self) -> Option<RadialError> {
        let circle = Circle::new(self.sphere.center, self.sphere.radius).ok()?;
        let outline = Shape::Circle(circle).outline()?;
        let outline = outline.transformed(self.options.transform).ok()?;
        let segments = &self.outline.curve.segments;
        Some(radial::error(segments, &outline.truth))
    }

    /// How far the arithmetic may have moved a point by the time it is mapped: a few units in the last place, before the map and after it.
    fn noise(&self) -> f64 {
        let [_, largest] = scales(self.options.transform);
        let farthest = |p: Point| p.x.abs().max(p.y.abs());
        let Sphere { center, radius, .. } = self.sphere;
        let before = (farthest(center) + 2.0 * radius) * largest;
        let points = self.parts().flat_map(|part| &part.curve.segments);
        let after = points
            .flat_map(control_points)
            .map(farthest)
            .fold(0.0, f64::max);
        8.0 * f64::EPSILON * (before + after)
    }

    /// All parts.
    fn parts(&self) -> impl Iterator<Item = &Part> {
        let front = self.front.iter();
        self.back
            .iter()
            .chain(front)
            .chain(iter::once(&self.outline))
    }

    fn parts_mut(&mut self) -> impl Iterator<Item = &mut Part> {
        let front = self.front.iter_mut();
        self.back
            .iter_mut()
            .chain(front)
            .chain(iter::once(&mut self.outline))
    }
}

/// How much a map stretches lengths, the least and the most.
fn scales(map: Affine) -> [f64; 2] {
    let radii = kurbo::Ellipse::from_affine(map).radii();
    [radii.x.min(radii.y), radii.x.max(radii.y)]
}

/// The most meridians, and the most parallels.
const MOST_LINES: usize = 10_000;

/// What the lines are images of: the unit circle by the rule, as meridians and the outline take it and as parallels do, which
/// begin at the longitude of the view; and its half where meridians are half circles.
struct Units {
    circle: Drawing,
    parallel: Drawing,
    half: Option<Drawing>,
}

impl Units {
    fn new(sphere: &Sphere, view: View, options: &Options) -> Result<Self> {
        let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0)?);
        let half_turn = Angle::from_degrees(180.0);
        let half = Arc::new((0.0, 0.0), (1.0, 1.0), Angle::ZERO, Angle::ZERO, half_turn)?;
        let in_pairs = sphere.meridians.is_multiple_of(2);
        let draw_half = || draw(&Shape::Arc(half), half_cut(&options.cut), options);
        let whole = draw(&circle, options.cut.clone(), options)?;
        Ok(Self {
            parallel: match &options.cut {
                Cut::At(joints) => draw(&circle, cut_from(joints, view.longitude), options)?,
                _ => whole.clone(),
            },
            circle: whole,
            half: (!in_pairs).then(draw_half).transpose()?,
        })
    }

    /// The curve in the plane of a line.
    fn curve(&self, line: SphereLine) -> &Curve {
        match (line, &self.half) {
            (SphereLine::Parallel(_), _) => &self.parallel.curve,
            (SphereLine::Meridian(_), Some(half)) => &half.curve,
            _ => &self.circle.curve,
        }
    }

    fn error(&self) -> RadialError {
        [&self.parallel]
            .into_iter()
            .chain(&self.half)
            .fold(self.circle.error, |error, unit| error.with(unit.error))
    }
}

/// The cut of the first half of a circle that is cut so.
fn half_cut(cut: &Cut) -> Cut {
    let turned = |joint: &Angle| joint.degrees().rem_euclid(360.0);
    match cut {
        Cut::Count(count) => Cut::Count(count.div_ceil(2)),
        Cut::At(joints) => Cut::At(
            joints
                .iter()
                .copied()
                .filter(|joint| turned(joint) > 0.0 && turned(joint) < 180.0)
                .collect(),
        ),
        other => other.clone(),
    }
}

/// Joints at these angles, counted from `zero`.
fn cut_from(joints: &[Angle], zero: Angle) -> Cut {
    let from_zero = |joint: &Angle| Angle::from_degrees(joint.degrees() - zero.degrees());
    Cut::At(joints.iter().map(from_zero).collect())
}

/// The shape by the rule, in full digits.
fn draw(shape: &Shape, cut: Cut, options: &Options) -> Result<Drawing> {
    let options = approximate::Options {
        rule: options.rule,
        cut,
        precision: Some(Precision::Full),
        transform: Affine::IDENTITY,
    };
    approximate(shape, &options)
}
