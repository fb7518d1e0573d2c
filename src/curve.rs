//! The finished curve: Bézier segments in user space.

use core::borrow::Borrow;

use kurbo::{Affine, CubicBez, ParamCurve, PathSeg, Point, QuadBez, Rect, Vec2};

use crate::error::{Error, Result, finite, positive};
use crate::number::{Precision, round};

/// A closing line shorter than this part of the curve's extent is the gap of a joint, not a segment; an open curve whose ends
/// are as near returns to its start.
pub(crate) const CLOSING_GAP: f64 = 1e-4;

/// A segment whose control points are this part of the curve's extent apart has no length.
const EMPTY: f64 = 1e-7;

/// A chain of Bézier segments, each of which starts where the one before it ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// The segments in their order.
    pub segments: Vec<PathSeg>,
    /// Whether the last point is the first and the curve is to be closed.
    pub closed: bool,
}

impl Curve {
    /// The first point.
    #[must_use]
    pub fn start(&self) -> Option<Point> {
        self.segments.first().map(kurbo::ParamCurve::start)
    }

    /// The smallest rectangle around the curve itself, not its control points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<Rect> {
        self.segments
            .iter()
            .map(kurbo::Shape::bounding_box)
            .reduce(|a, b| a.union(b))
    }

    /// The curve with its control points mapped.
    #[must_use]
    pub fn transformed(&self, map: Affine) -> Self {
        Self {
            segments: self.segments.iter().map(|&segment| map * segment).collect(),
            closed: self.closed,
        }
    }

    /// The curve with its control points rounded once, in absolute coordinates; shared points stay shared. Points in `kept` are
    /// not rounded.
    #[must_use]
    pub fn rounded(&self, precision: Precision, kept: &[Point]) -> Self {
        let Precision::Fixed(decimals) = precision else {
            return self.clone();
        };
        self.map_points(|p| {
            if kept.contains(&p) {
                p
            } else {
                Point::new(round(p.x, decimals), round(p.y, decimals))
            }
        })
    }

    /// Refuses a precision that leaves nothing of this curve, which was rounded to it: no extent of a closed one, a point of an open one.
    pub(crate) fn check_left(&self, rounded: &Self, precision: Option<Precision>) -> Result<()> {
        let Some(Precision::Fixed(decimals)) = precision else {
            return Ok(());
        };
        let is_lost = |axis: fn(&Point) -> f64| rounded.is_flat(axis) && !self.is_flat(axis);
        let [x, y] = [is_lost(|p| p.x), is_lost(|p| p.y)];
        let is_point = || rounded.is_flat(|p| p.x) && rounded.is_flat(|p| p.y);
        if (x || y) && (self.closed || is_point()) {
            return Err(Error::Collapsed { decimals });
        }
        Ok(())
    }

    /// Whether all control points are alike along an axis.
    fn is_flat(&self, axis: fn(&Point) -> f64) -> bool {
        let mut all = self
            .segments
            .iter()
            .flat_map(control_points)
            .map(|p| axis(&p));
        let first = all.next();
        all.all(|x| Some(x) == first)
    }

    /// The curve without segments of no length: those whose control points are all within a ten-millionth of the curve's extent of
    /// one another, as the rounding of other programs leaves them; and how many they were.
    #[must_use]
    pub fn without_empty_segments(&self) -> (Self, usize) {
        let near = EMPTY * size(self);
        let mut kept: Vec<PathSeg> = Vec::with_capacity(self.segments.len());
        for &segment in &self.segments {
            let points = control_points(&segment);
            let is_near = |p: &Point| libm::hypot(p.x - points[0].x, p.y - points[0].y) <= near;
            if points.iter().all(is_near) {
                continue;
            }
            // What a segment left out was long is added to the next.
            let start = kept.last().map_or(segment.start(), ParamCurve::end);
            kept.push(match segment {
                PathSeg::Line(l) => PathSeg::Line(kurbo::Line { p0: start, ..l }),
                PathSeg::Quad(q) => PathSeg::Quad(QuadBez { p0: start, ..q }),
                PathSeg::Cubic(c) => PathSeg::Cubic(CubicBez { p0: start, ..c }),
            });
        }
        let left_out = self.segments.len() - kept.len();
        (
            Self {
                segments: kept,
                closed: self.closed,
            },
            left_out,
        )
    }

    fn map_points(&self, f: impl Fn(Point) -> Point) -> Self {
        let map = |segment: &PathSeg| map_points(segment, &f);
        Self {
            segments: self.segments.iter().map(map).collect(),
            closed: self.closed,
        }
    }
}

/// The segment with its control points mapped.
#[inline]
pub(crate) fn map_points(segment: &PathSeg, f: impl Fn(Point) -> Point) -> PathSeg {
    match *segment {
        PathSeg::Line(l) => PathSeg::Line(kurbo::Line::new(f(l.p0), f(l.p1))),
        PathSeg::Quad(q) => PathSeg::Quad(QuadBez::new(f(q.p0), f(q.p1), f(q.p2))),
        PathSeg::Cubic(c) => PathSeg::Cubic(CubicBez::new(f(c.p0), f(c.p1), f(c.p2), f(c.p3))),
    }
}

/// How far control points moved at most.
pub(crate) fn largest_move(before: &Curve, after: &Curve) -> f64 {
    let points = |curve: &Curve| -> Vec<Point> {
        let segments = curve.segments.iter();
        segments.flat_map(control_points).collect()
    };
    let moved = points(before).into_iter().zip(points(after));
    moved.map(|(p, q)| p.distance(q)).fold(0.0, f64::max)
}

/// The control points of a segment: two of a line, three of a quadratic, four of a cubic.
#[must_use]
pub fn control_points(segment: &PathSeg) -> Vec<Point> {
    let (points, count) = points_of(segment);
    points[..count].to_vec()
}

/// The control points of a segment in an array, and how many they are.
#[inline]
pub(crate) fn points_of(segment: &PathSeg) -> ([Point; 4], usize) {
    match *segment {
        PathSeg::Line(l) => ([l.p0, l.p1, l.p1, l.p1], 2),
        PathSeg::Quad(q) => ([q.p0, q.p1, q.p2, q.p2], 3),
        PathSeg::Cubic(c) => ([c.p0, c.p1, c.p2, c.p3], 4),
    }
}

/// The largest coordinate of all control points, without its sign; 0 where there are none.
pub(crate) fn largest_coordinate(segments: impl IntoIterator<Item: Borrow<PathSeg>>) -> f64 {
    let of = |segment: &PathSeg| {
        // What is there twice is no larger.
        let (points, _) = points_of(segment);
        let sizes = points.iter().map(|p| p.x.abs().max(p.y.abs()));
        sizes.fold(0.0, f64::max)
    };
    let sizes = segments.into_iter().map(|segment| of(segment.borrow()));
    sizes.fold(0.0, f64::max)
}

/// The segment with these control points, of which there are at most four.
pub(crate) fn segment_of(points: &[Point]) -> PathSeg {
    match *points {
        [p0, p1, p2, p3] => PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3)),
        [p0, p1, p2] => PathSeg::Quad(QuadBez::new(p0, p1, p2)),
        _ => {
            let [from, to] =
                [points.first(), points.last()].map(|p| p.copied().unwrap_or_default());
            PathSeg::Line(kurbo::Line::new(from, to))
        }
    }
}

/// The cubic between these ends with these handles: out of the first, and into the last.
#[inline(always)]
pub(crate) fn with_handles([p0, p3]: [Point; 2], [out, into]: [Vec2; 2]) -> CubicBez {
    CubicBez::new(p0, p0 + out, p3 - into, p3)
}

/// The angle between the tangents of two segments where they join, in degrees.
pub(crate) fn turn(before: &PathSeg, after: &PathSeg) -> f64 {
    let (incoming, outgoing) = (before.reverse(), *after);
    let (incoming, outgoing) = (-first_direction(&incoming), first_direction(&outgoing));
    libm::atan2(incoming.cross(outgoing), incoming.dot(outgoing)).to_degrees()
}

/// The direction in which a segment leaves its first point.
pub(crate) fn first_direction(segment: &PathSeg) -> Vec2 {
    let (points, _) = points_of(segment);
    let mut ways = points.iter().map(|&p| p - points[0]);
    ways.find(|v| *v != Vec2::ZERO).unwrap_or_default()
}

/// How far the end of a curve lies from its start.
pub(crate) fn gap(curve: &Curve) -> f64 {
    let ends = curve.segments.first().zip(curve.segments.last());
    ends.map_or(0.0, |(first, last)| first.start().distance(last.end()))
}

/// Refuses control points with a coordinate that is not finite or beyond 1e150.
pub(crate) fn check_coordinates(
    what: &'static str,
    segments: impl IntoIterator<Item: Borrow<PathSeg>>,
) -> Result<()> {
    for segment in segments {
        let (points, _) = points_of(segment.borrow());
        for x in points.into_iter().flat_map(|p| [p.x, p.y]) {
            finite(what, x)?;
        }
    }
    Ok(())
}

/// Refuses what is so small, and no point, that squares of its lengths vanish.
pub(crate) fn check_size(segments: impl IntoIterator<Item: Borrow<PathSeg>>) -> Result<()> {
    let points = segments
        .into_iter()
        .flat_map(|segment| control_points(segment.borrow()));
    let boxes = points.map(|p| Rect::from_points(p, p));
    let bounds = boxes.reduce(|a, b| a.union(b)).unwrap_or(Rect::ZERO);
    let size = bounds.width().max(bounds.height());
    if size > 0.0 {
        positive("size of the path", size)?;
    }
    Ok(())
}

/// The diagonal of the curve's bounding box.
pub(crate) fn size(curve: &Curve) -> f64 {
    curve
        .bounding_box()
        .map_or(0.0, |b| libm::hypot(b.width(), b.height()))
}
