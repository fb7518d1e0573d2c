//! How far two drawings lie apart, subpath by subpath: the Hausdorff distance, both ways, as a bound.
//!
//! The distance is that of sets of points: where a subpath begins and which way it runs make none.

mod pairs;

use kurbo::{Affine, PathSeg, Point, Rect};

use crate::approximate::{self, approximate};
use crate::contour::{Contour, Step};
use crate::curve::{check_coordinates, check_size, largest_coordinate};
use crate::error::{Error, Result, UnmeasurableError, finite, positive};
use crate::joints::Cut;
use crate::number::Precision;
use crate::shape::Shape;

/// The largest angle of the cubics by which an elliptical arc is compared, in degrees: they lie within some 1e-12 of its radius.
const ARC_ANGLE: f64 = 3.75;

/// A subpath to be compared.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Track {
    /// Its lines and Béziers; arcs are cubics in it.
    pub segments: Vec<PathSeg>,
    /// Whether it is closed.
    pub closed: bool,
    /// The step of its contour that each of them is a part of; none where each is its own.
    pub steps: Vec<usize>,
    /// How far those cubics lie from their arcs at most, in user units.
    pub strayed: f64,
}

impl Track {
    /// A contour under a map.
    ///
    /// # Errors
    ///
    /// Where a coordinate leaves the range of the geometry.
    pub fn new(contour: &Contour, map: Affine) -> Result<Self> {
        let mut track = Self {
            closed: contour.closed,
            ..Self::default()
        };
        for (i, step) in contour.steps.iter().enumerate() {
            match step {
                Step::Given(segment) => track.segments.push(map * *segment),
                Step::Arc(arc) => {
                    let count = (arc.sweep.degrees().abs() / ARC_ANGLE).ceil().max(1.0);
                    let options = approximate::Options {
                        cut: Cut::Count(count as usize),
                        precision: Some(Precision::Full),
                        transform: map,
                        ..Default::default()
                    };
                    let drawing = approximate(&Shape::Arc(*arc), &options)?;
                    track.strayed = track.strayed.max(drawing.error.peak());
                    track.segments.extend(drawing.curve.segments);
                }
            }
            track.steps.resize(track.segments.len(), i);
        }
        track.check()?;
        Ok(track)
    }

    /// Refuses numbers of which no distance is told: every field is open.
    fn check(&self) -> Result<()> {
        check_coordinates("coordinate", &self.segments)?;
        check_size(&self.segments)?;
        finite("distance of cubics from their arcs", self.strayed).map(drop)
    }

    fn bounding_box(&self) -> Rect {
        let boxes = self.segments.iter().map(kurbo::Shape::bounding_box);
        boxes.reduce(|a, b| a.union(b)).unwrap_or(Rect::ZERO)
    }

    /// The largest coordinate, without its sign.
    fn largest(&self) -> f64 {
        largest_coordinate(&self.segments)
    }
}

/// One of two drawings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The first.
    Old,
    /// The second.
    New,
}

/// Where two subpaths lie farthest apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarthestPlace {
    /// The point that is farthest from the other subpath.
    pub point: Point,
    /// The drawing that it belongs to.
    pub side: Side,
    /// The segment that it lies on, from 0, an arc counted as one.
    pub segment: usize,
}

/// How far two subpaths lie apart.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// A bound in user units, in all but hard cases at most a ten-thousandth above the distance, to the rounding of coordinates; 0
    /// for equal segments only.
    pub at_most: f64,
    /// Where; `None` for equal segments.
    pub place: Option<FarthestPlace>,
}

/// Two subpaths that belong together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The number of the subpath in the old drawing, from 0.
    pub old: usize,
    /// In the new one.
    pub new: usize,
    /// How far they lie apart.
    pub distance: Distance,
    /// Whether one is closed and the other is not.
    pub closed_differently: bool,
}

/// What two drawings differ by.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Difference {
    /// The largest distance that was allowed.
    pub tolerance: f64,
    /// The subpaths that belong together, in the order of the old drawing.
    pub pairs: Vec<Pair>,
    /// The subpaths of the old drawing that the new one lacks.
    pub only_old: Vec<usize>,
    /// Those of the new drawing that the old one lacks.
    pub only_new: Vec<usize>,
    /// What the rounding of coordinates may have added to a distance, four units in the last place of the largest: that much beyond the tolerance
    /// is within.
    pub noise: f64,
}

impl Difference {
    /// Whether a pair is within the tolerance. Without one it has to be closed alike too.
    #[must_use]
    pub fn allows(&self, pair: &Pair) -> bool {
        if self.tolerance > 0.0 {
            pair.distance.at_most <= self.tolerance + self.noise
        } else {
            pair.distance.at_most == 0.0 && !pair.closed_differently
        }
    }

    /// Whether everything is within the tolerance.
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.only_old.is_empty()
            && self.only_new.is_empty()
            && self.pairs.iter().all(|pair| self.allows(pair))
    }

    /// The largest distance of all pairs.
    #[must_use]
    pub fn distance(&self) -> f64 {
        let distances = self.pairs.iter().map(|pair| pair.distance.at_most);
        distances.fold(0.0, f64::max)
    }
}

/// Compares two drawings. Subpaths are matched in their order where they lie within the tolerance, else with the nearest ones.
///
/// # Errors
///
/// Where the tolerance is neither 0 nor a positive, finite number, a track has no segment or a number out of range, and where it would take more than some ten seconds: thousands of
/// curves that cross one another everywhere.
///
/// ```
/// use curveto::diff::{Track, compare};
/// use curveto::path::contours;
/// let tracks = |data| -> curveto::Result<Vec<Track>> {
///     contours(data)?.iter().map(|contour| Track::new(contour, Default::default())).collect()
/// };
/// let arc = tracks("M50 0A50 50 0 0 1 0 50")?;
/// let cubic = tracks("M50 0C50 27.614 27.614 50 0 50")?;
/// let difference = compare(&arc, &cubic, 0.02)?;
/// assert!(difference.is_within() && (0.013..0.014).contains(&difference.distance()));
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn compare(old: &[Track], new: &[Track], tolerance: f64) -> Result<Difference> {
    if tolerance != 0.0 {
        positive("tolerance", tolerance)?;
    }
    for track in old.iter().chain(new) {
        track.check()?;
        if track.segments.is_empty() {
            return Err(Error::Unmeasurable(UnmeasurableError::Empty));
        }
    }
    let largest = old.iter().chain(new).map(Track::largest);
    let noise = 4.0 * f64::EPSILON * largest.fold(0.0, f64::max);
    let mut difference = Difference {
        tolerance,
        noise,
        ..Difference::default()
    };
    pairs::find(old, new, &mut difference, pairs::MOST_STEPS)?;
    Ok(difference)
}
