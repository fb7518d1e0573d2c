//! Lines and circular arcs: what machines and CAD draw exactly.

mod rounding;

use kurbo::{Affine, PathSeg, Point, Vec2};

use crate::angle::Angle;
use crate::curve::Curve;
use crate::number::Precision;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Given, Outline};

/// By what part the radii of a circle may differ after a map that turns and scales it: its rounding, and a margin.
const ROUND: f64 = 1e-12;

/// A chain of lines and circular arcs.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Where it begins.
    pub start: Point,
    /// Its steps, each from where the one before it ends.
    pub steps: Vec<CourseStep>,
    /// Whether it ends where it begins and is to be closed.
    pub closed: bool,
}

/// A line or a circular arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CourseStep {
    /// A straight line to this point.
    Line(Point),
    /// An arc.
    Arc(CircularArc),
    /// An arc of an ellipse, which SVG knows and machines do not.
    Elliptical(SvgArc),
}

/// A circular arc from wherever the step before it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularArc {
    /// Where it ends.
    pub to: Point,
    /// The centre of its circle.
    pub center: Point,
    /// The radius of its circle.
    pub radius: f64,
    /// The angle, seen from the centre, at which it starts.
    pub start: Angle,
    /// How far it runs, at most one turn; positive ones turn from +x towards +y.
    pub sweep: Angle,
    /// Whether its end points are what was given, and not its centre and its angles.
    pub ends_given: bool,
}

impl CourseStep {
    /// Where it ends.
    #[must_use]
    pub const fn to(&self) -> Point {
        match self {
            Self::Line(to) => *to,
            Self::Arc(arc) => arc.to,
            Self::Elliptical(arc) => arc.to,
        }
    }
}

impl CourseStep {
    /// The outline of an arc that begins here; `None` of a line.
    #[must_use]
    pub fn outline(&self, from: Point) -> Option<Outline> {
        match self {
            Self::Line(_) => None,
            Self::Arc(arc) => {
                let own = Arc {
                    center: arc.center,
                    radii: Vec2::splat(arc.radius),
                    rotation: Angle::ZERO,
                    start: arc.start,
                    sweep: arc.sweep,
                    ends: Some([from, arc.to]),
                    given: Given::Sweep,
                };
                Some(own.outline())
            }
            Self::Elliptical(arc) => arc.shape().ok()?.outline(),
        }
    }
}

impl CircularArc {
    /// The DXF bulge, tan(sweep/4) = sin(sweep/2) / (1 + cos(sweep/2)); not for a whole turn, which has none.
    #[must_use]
    pub fn bulge(&self) -> f64 {
        let half = Angle::from_degrees(self.sweep.degrees() / 2.0).direction();
        half.y / (1.0 + half.x)
    }

    /// Whether it is a whole circle.
    #[must_use]
    pub fn is_circle(&self) -> bool {
        self.sweep.degrees().abs() >= 360.0
    }

    /// The arc with its end and its centre rounded.
    #[must_use]
    pub fn rounded(&self, precision: Precision) -> Self {
        Self {
            to: precision.round_point(self.to),
            center: precision.round_point(self.center),
            ..*self
        }
    }

    /// The point at a part of its sweep, from 0 to 1.
    #[must_use]
    pub fn point(&self, part: f64) -> Point {
        let angle = self.start.degrees() + part * self.sweep.degrees();
        self.center + Angle::from_degrees(angle).direction() * self.radius
    }
}

impl Course {
    /// Whether all of it are lines and circular arcs.
    #[must_use]
    pub fn is_circular(&self) -> bool {
        let elliptical = |step: &CourseStep| matches!(step, CourseStep::Elliptical(_));
        !self.steps.iter().any(elliptical)
    }

    /// The curve itself, where it has lines only.
    #[must_use]
    pub fn of_lines(curve: &Curve) -> Option<Self> {
        let step = |segment: &PathSeg| match segment {
            PathSeg::Line(line) => Some(CourseStep::Line(line.p1)),
            _ => None,
        };
        Some(Self {
            start: curve.start()?,
            steps: curve.segments.iter().map(step).collect::<Option<_>>()?,
            closed: curve.closed,
        })
    }

    /// The outline as one arc, where it is part of a circle.
    #[must_use]
    pub fn of_arc(outline: &Outline) -> Option<Self> {
        let radii = outline.truth.radii;
        if (radii.x - radii.y).abs() > ROUND * radii.x {
            return None;
        }
        let [start, to] = ends(outline);
        let turned = turn(outline.placement);
        let (from, sweep) = (outline.unit.start.degrees(), outline.unit.sweep.degrees());
        // A mirror image runs the other way round.
        let sign = outline.placement.determinant().signum();
        let arc = CircularArc {
            to,
            center: outline.truth.center,
            radius: radii.x,
            start: Angle::from_degrees(turned + sign * from),
            sweep: Angle::from_degrees(sign * sweep),
            ends_given: outline.ends.is_some(),
        };
        Some(Self {
            start,
            steps: vec![CourseStep::Arc(arc)],
            closed: outline.unit.closed,
        })
    }

    /// The course with its points rounded, centres too.
    #[must_use]
    pub fn rounded(&self, precision: Precision) -> Self {
        let round = |p| precision.round_point(p);
        let step = |step: &CourseStep| match *step {
            CourseStep::Line(to) => CourseStep::Line(round(to)),
            CourseStep::Arc(arc) => CourseStep::Arc(arc.rounded(precision)),
            CourseStep::Elliptical(arc) => CourseStep::Elliptical(SvgArc {
                from: round(arc.from),
                to: round(arc.to),
                ..arc
            }),
        };
        Self {
            start: round(self.start),
            steps: self.steps.iter().map(step).collect(),
            closed: self.closed,
        }
    }
}

/// Where an outline starts and ends.
fn ends(outline: &Outline) -> [Point; 2] {
    if let Some(given) = outline.ends {
        return given;
    }
    let point =
        |degrees: f64| outline.placement * Angle::from_degrees(degrees).direction().to_point();
    let start = outline.unit.start.degrees();
    let last = start + outline.unit.sweep.degrees();
    [
        point(start),
        point(if outline.unit.closed { start } else { last }),
    ]
}

/// The angle, in degrees, that the x axis has after a map.
fn turn(map: Affine) -> f64 {
    let [a, b, ..] = map.as_coeffs();
    libm::atan2(b, a).to_degrees()
}

/// The smallest of the angles that differ from this one by whole turns and are at least 0, in degrees.
#[must_use]
pub fn within_a_turn(angle: f64) -> f64 {
    let within = angle.rem_euclid(360.0);
    // The remainder of a tiny negative angle rounds to a whole turn.
    if within < 360.0 { within } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::endpoint::from_bulge;
    use crate::{Arc, Circle, Shape};

    fn arc(shape: Shape, map: Affine) -> (Point, CircularArc) {
        let outline = shape.outline().unwrap().transformed(map).unwrap();
        let course = Course::of_arc(&outline).unwrap();
        let CourseStep::Arc(arc) = course.steps[0] else {
            panic!("{course:?}")
        };
        (course.start, arc)
    }

    fn quarter() -> Shape {
        let angle = Angle::from_degrees;
        Shape::Arc(
            Arc::new(
                (10.0, 0.0),
                (5.0, 5.0),
                Angle::ZERO,
                angle(30.0),
                angle(90.0),
            )
            .unwrap(),
        )
    }

    #[test]
    fn an_arc_ends_where_its_angles_say_under_any_map_that_keeps_circles() {
        for map in [
            Affine::IDENTITY,
            Affine::translate((3.0, -4.0)) * Affine::rotate(0.3) * Affine::scale(2.5),
            Affine::FLIP_Y,
            Affine::rotate(2.0) * Affine::FLIP_X,
        ] {
            let (start, arc) = arc(quarter(), map);
            assert!(arc.point(0.0).distance(start) < 1e-12, "{map:?}");
            assert!(arc.point(1.0).distance(arc.to) < 1e-12, "{map:?}");
            assert_eq!(arc.sweep.degrees(), 90.0 * map.determinant().signum());
        }
        let squeezed = quarter().outline().unwrap();
        let squeezed = squeezed.transformed(Affine::scale_non_uniform(1.0, 2.0));
        assert_eq!(Course::of_arc(&squeezed.unwrap()), None);
    }

    #[test]
    fn a_bulge_comes_back_with_its_end_points() {
        for bulge in [1.0, -0.4, 0.1, 3.0, -1e-3] {
            let (from, to) = (Point::new(0.1, 0.2), Point::new(7.3, -4.4));
            let (start, arc) = arc(from_bulge(from, to, bulge).unwrap(), Affine::IDENTITY);
            assert_eq!((start, arc.to), (from, to));
            assert!(
                (arc.bulge() / bulge - 1.0).abs() < 1e-14,
                "{bulge}: {}",
                arc.bulge()
            );
        }
    }

    #[test]
    fn a_circle_is_one_arc_that_ends_where_it_begins() {
        let circle = Shape::Circle(Circle::new((1.0, 2.0), 3.0).unwrap());
        let (start, arc) = arc(circle, Affine::IDENTITY);
        assert!(arc.is_circle());
        assert_eq!((start, arc.to), (Point::new(4.0, 2.0), start));
        assert_eq!(arc.center, Point::new(1.0, 2.0));
    }

    #[test]
    fn a_rounded_arc_strays_no_farther_than_is_stated() {
        let ends = (Point::new(0.1, 0.2), Point::new(7.3, -4.4));
        let by_bulge = |bulge| from_bulge(ends.0, ends.1, bulge).unwrap();
        let shapes = [0.3, -1.0, 2.7].map(by_bulge);
        for shape in shapes.into_iter().chain([quarter()]) {
            let map = Affine::translate((0.37, 0.41)) * Affine::scale(1.27);
            let outline = shape.outline().unwrap().transformed(map).unwrap();
            let course = Course::of_arc(&outline).unwrap();
            let (rounded, moved) = course.rounded_for_cad(Precision::Fixed(0)).unwrap();
            let (CourseStep::Arc(old), CourseStep::Arc(new)) = (course.steps[0], rounded.steps[0])
            else {
                panic!("{rounded:?}")
            };
            assert!(new.point(0.0).distance(rounded.start) < 1e-12);
            assert!(new.point(1.0).distance(new.to) < 1e-12);
            let off = |i: u32| {
                let part = f64::from(i) / 100.0;
                old.point(part).distance(new.point(part))
            };
            let farthest = (0..=100).map(off).fold(0.0, f64::max);
            assert!(
                farthest <= moved && farthest > 0.3 * moved,
                "{farthest} {moved}"
            );
        }
    }

    #[test]
    fn angles_are_brought_within_a_turn() {
        for (angle, within) in [(-90.0, 270.0), (360.0, 0.0), (725.0, 5.0), (-1e-300, 0.0)] {
            assert_eq!(within_a_turn(angle), within);
        }
    }

    #[test]
    fn rounding_leaves_the_radii_of_an_elliptical_arc() {
        let arc = SvgArc {
            from: Point::new(0.26, 0.0),
            radii: Vec2::new(3.24, 2.71),
            rotation: Angle::from_degrees(12.34),
            large_arc: true,
            sweep: false,
            to: Point::new(4.04, 1.96),
        };
        let course = Course {
            start: arc.from,
            steps: vec![CourseStep::Elliptical(arc)],
            closed: false,
        };
        let rounded = course.rounded(Precision::Fixed(1));
        let [CourseStep::Elliptical(found)] = rounded.steps[..] else {
            panic!("{rounded:?}")
        };
        assert_eq!(
            (rounded.start, found.from),
            (Point::new(0.3, 0.0), Point::new(0.3, 0.0))
        );
        assert_eq!(found.to, Point::new(4.0, 2.0));
        assert_eq!((found.radii, found.rotation), (arc.radii, arc.rotation));
        assert!(found.large_arc && !found.sweep);
    }
}
