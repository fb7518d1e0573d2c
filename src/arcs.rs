//! Lines and circular arcs in place of Béziers: the way back, for machines and for what draws nothing else.

mod bound;
mod bows;
mod builder;
mod chain;
mod chords;
mod diameters;
mod even;
mod fit;
mod form;
mod from_chord;
mod glance;
mod half_turn;
mod lines;
mod near;
mod oval;
mod piece;
pub(crate) mod recognize;
#[cfg(test)]
mod tests;
pub(crate) mod together;
pub(crate) mod turn;

use kurbo::{Affine, Point, Rect};

use crate::contour::{
    Closeness, Contour, Maker, Nearness, PathDrawing, Step, Subpath, check_placed,
};
use crate::error::{Error, Result, positive};
use crate::joints::{MOST_IN_ALL, MOST_SEGMENTS, Tolerance};
use crate::number::{Precision, decimals_of, rounded_up};
use crate::numeric::functions::power;
use piece::StepCurve;

/// The part of the tolerance that rounding may use where no precision is asked for: it costs one chord in a hundred.
const ROUNDING_PART: f64 = 0.02;

/// The part that rounding may use where it decides how many chords there are.
const FINER_PART: f64 = 1e-6;

/// By how much the tolerance that is named is larger than that which seems enough.
const SURER: f64 = 1.1;

/// The tolerance where none is asked for, as a part of half the larger side of the subpath's box: of the radius, on a circle.
const DEFAULT_PART: f64 = 1e-3;

/// The largest part of that half side that the rounding of coordinates explains.
const ROUNDED_PART: f64 = 1e-2;

/// The finest tolerance, as a part of the largest coordinate: below it the noise of double precision decides where a piece ends.
const FINEST: f64 = 64.0 * f64::EPSILON;

/// How far the points of a part that is cut from a curve may lie from it, as a part of the largest coordinate.
const CUT: f64 = 8.0 * f64::EPSILON;

/// How lines and arcs are made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// How far they may lie from what was given; a part is one of half the larger side of the subpath's box. Without it, a
    /// thousandth of that and what rounding moves a point: to the precision that is asked for, and of arcs to the decimals of the
    /// file, where these are fewer, but no more than a hundredth of that half side.
    pub tolerance: Option<Tolerance>,
    /// How points are rounded, those that were given too; without it these stay as they are.
    pub precision: Option<Precision>,
    /// A map that is applied before all else.
    pub transform: Affine,
    /// Whether arcs may be those of ellipses.
    pub elliptic: bool,
    /// Whether room is left for numbers to be rounded once more, as G-code rounds centres.
    pub rounds_again: bool,
}

/// Draws contours as lines within a tolerance: each Bézier and each arc as chords that run as far as their distance lets them, never
/// more of them than by halving the parameter. Lines stay as they are.
///
/// The error is a bound of the distance both ways (Hausdorff), of the points as they are printed: the largest of all chords, each against the part
/// that it replaces. That of the whole may be less.
///
/// # Errors
///
/// Where the tolerance is not positive or no more than rounding moves a point, and where a Bézier takes more than a million chords.
///
/// ```
/// use curveto::{Tolerance, arcs, path};
/// let contours = path::contours("M0 0Q50 100 100 0")?;
/// let tolerance = Some(Tolerance::Absolute(5.0));
/// let drawing = arcs::lines(&contours, &arcs::Options { tolerance, ..Default::default() })?;
/// assert!(drawing.error().peak() <= 5.0);
/// assert_eq!(drawing.curves().next().map(|curve| curve.segments.len()), Some(3));
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn lines(contours: &[Contour], options: &Options) -> Result<PathDrawing> {
    Ok(PathDrawing {
        subpaths: subpaths(lines::subpath, 2, contours, options)?,
        maker: Maker::Lines,
    })
}

/// Draws contours as lines and circular arcs within a tolerance: a run of Béziers that was drawn as one arc becomes it, with the round
/// radius that was meant; a whole circle becomes two halves. Other Béziers that join smoothly become the fewest arcs and lines whose ends
/// lie on them, each as long as the tolerance lets it be. Corners, lines and circular arcs stay as they are.
///
/// The result has courses and no curves. The error is a bound of the distance both ways (Hausdorff), of the numbers as they are
/// printed: the largest of all lines and arcs, each against the stretch that it replaces. That of the whole may be less at sharp turns;
/// [`diff`](crate::diff) tells it.
///
/// # Errors
///
/// Where the tolerance is not positive or no more than rounding moves a point, and where a path takes more than a million arcs.
///
/// ```
/// use curveto::{Tolerance, arcs, path};
/// let circle = "M50 0C50 27.6 27.6 50 0 50C-27.6 50-50 27.6-50 0C-50-27.6-27.6-50 0-50C27.6-50 50-27.6 50 0Z";
/// let drawing = arcs::arcs(&path::contours(circle)?, &arcs::Options::default())?;
/// let data = path::data_of_courses(drawing.courses(), false);
/// assert_eq!(data, "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z");
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn arcs(contours: &[Contour], options: &Options) -> Result<PathDrawing> {
    Ok(PathDrawing {
        subpaths: subpaths(bows::subpath, 3, contours, options)?,
        maker: Maker::Arcs,
    })
}

/// The subpaths of all contours, which together have no more segments than memory should hold.
fn subpaths(
    draw: impl Fn(&Contour, &Options) -> Result<Subpath>,
    root: i32,
    contours: &[Contour],
    options: &Options,
) -> Result<Vec<Subpath>> {
    check_placed(contours, options.transform)?;
    let (mut subpaths, mut count) = (Vec::with_capacity(contours.len()), 0);
    let mut given = 0;
    for contour in contours {
        let subpath = advised(&draw, root, contour, options)?;
        count += subpath.count();
        given += contour.steps.len();
        if count > MOST_IN_ALL.max(given) {
            let part = subpaths.len() + 1;
            let all = count as f64 * (contours.len() as f64 / part as f64);
            let lines = subpath.closeness.map(|closeness| closeness.lines);
            let tolerance = lines.map_or(0.0, |near| near.error + near.room);
            let enough = match options.tolerance {
                Some(Tolerance::Absolute(tolerance)) => {
                    let times = power(all / MOST_IN_ALL as f64, root);
                    rounded_up(SURER * times * tolerance, 1)
                }
                _ => f64::INFINITY,
            };
            return Err(Error::TooManySegments {
                tolerance,
                most: MOST_IN_ALL,
                enough,
            });
        }
        subpaths.push(subpath);
    }
    Ok(subpaths)
}

/// What is drawn, or why not, with a tolerance that serves: the number of segments falls by this root of it, and at a ten thousandth of
/// their number or so they are soon counted.
fn advised(
    draw: &impl Fn(&Contour, &Options) -> Result<Subpath>,
    root: i32,
    contour: &Contour,
    options: &Options,
) -> Result<Subpath> {
    /// How many times the finest tolerance leaves a turn of a circle some 300,000 chords.
    const COARSER: f64 = 400.0;
    let drawn = draw(contour, options);
    // A million chords are not enough for the finest tolerance; arcs are.
    if let Err(Error::TooFine { tolerance, finest }) = drawn {
        let finest = if root == 2 {
            rounded_up(COARSER * finest, 1)
        } else {
            finest
        };
        return Err(Error::TooFine { tolerance, finest });
    }
    let Err(Error::TooManySegments {
        tolerance, most, ..
    }) = drawn
    else {
        return drawn;
    };
    let count_within = |wide: f64| {
        let options = Options {
            tolerance: Some(Tolerance::Absolute(wide)),
            ..*options
        };
        let subpath = draw(contour, &options).ok()?;
        Some((wide, subpath.count()))
    };
    let (low, found) = serving(count_within, tolerance, root);
    let enough = found.map_or(f64::INFINITY, |(wide, count)| {
        let part = count as f64 / most as f64;
        let least = rounded_up(SURER * wide * power(part, root), 1).max(low);
        let serves = least >= wide || count_within(least).is_some();
        if serves { least } else { rounded_up(wide, 1) }
    });
    Err(Error::TooManySegments {
        tolerance,
        most,
        enough,
    })
}

/// A tolerance that does not serve, and one that does and the count within it, not much larger where there is one.
fn serving(
    count_within: impl Fn(f64) -> Option<(f64, usize)>,
    tolerance: f64,
    root: i32,
) -> (f64, Option<(f64, usize)>) {
    /// How often a tolerance that serves is looked for halfway to one that does not, until it is so many times as large.
    const MOST_HALVES: usize = 8;
    const NEAR_TIMES: f64 = 8.0;
    let mut low = tolerance;
    let mut found = (1..10).find_map(|exponent| {
        let wide = tolerance * power(1e3, root * exponent);
        let found = count_within(wide);
        low = if found.is_some() { low } else { wide };
        found
    });
    // Many curves are a segment each at the least, so that far above the law fails.
    for _ in 0..MOST_HALVES {
        let Some((wide, _)) = found.filter(|(wide, _)| *wide > NEAR_TIMES * low) else {
            break;
        };
        let middle = (low * wide).sqrt();
        match count_within(middle) {
            None => low = middle,
            nearer => found = nearer,
        }
    }
    (low, found)
}

/// The steps of a contour under a map.
fn pieces(contour: &Contour, transform: Affine) -> Result<Vec<StepCurve>> {
    contour
        .steps
        .iter()
        .map(|step| StepCurve::new(step, transform))
        .collect()
}

/// How far what is made of a subpath may lie from it, and how its points are rounded.
struct Plan {
    tolerance: f64,
    /// The tolerance without what rounding takes.
    room: f64,
    /// How computed points are rounded.
    precision: Precision,
    /// Whether points that were given are rounded too.
    rounds_given: bool,
    /// Half the larger side of the subpath's box.
    size: f64,
    /// The largest coordinate.
    largest: f64,
}

impl Plan {
    /// Without a tolerance the rounding of what was given explains so much more of it.
    fn new(pieces: &[StepCurve], options: &Options, explained: f64) -> Result<Self> {
        let bounds = pieces.iter().map(StepCurve::bounding_box);
        let bounds = bounds.reduce(|a, b| a.union(b)).unwrap_or(Rect::ZERO);
        let size = bounds.width().max(bounds.height()) / 2.0;
        // A path of lines alone has nothing to fit.
        let curved = pieces.iter().any(|piece| !piece.is_line());
        if curved && size > 0.0 {
            positive("size of the path", 2.0 * size)?;
        }
        let corners = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
        let largest = corners
            .into_iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let tolerance = if let Some(tolerance) = options.tolerance {
            // A dot has no size that a part could be of; nothing of it strays.
            let whole = if size > 0.0 { size } else { largest.max(1.0) };
            tolerance.checked(whole)?
        } else {
            let asked = options.precision.map_or(0.0, Precision::farthest_moved);
            DEFAULT_PART * size + explained.min(ROUNDED_PART * size).max(asked)
        };
        let automatic = Precision::moving_at_most(ROUNDING_PART * tolerance, largest);
        let precision = options.precision.unwrap_or(automatic);
        let rounding = precision.farthest_moved();
        let room = tolerance - rounding;
        let finest = FINEST * largest;
        if curved && tolerance <= finest && size > 0.0 {
            return Err(Error::TooFine {
                tolerance,
                finest: rounded_up(2.0 * finest, 1),
            });
        }
        Ok(Self {
            tolerance,
            room: room.max(0.0),
            precision,
            rounds_given: options.precision.is_some(),
            size,
            largest,
        })
    }

    /// How far off a part of a curve may be that is cut from it.
    fn cut(&self) -> f64 {
        CUT * self.largest
    }

    /// The same with next to no rounding.
    fn finer(self) -> Self {
        let precision = Precision::moving_at_most(FINER_PART * self.tolerance, self.largest);
        Self {
            precision,
            room: self.tolerance - precision.farthest_moved(),
            ..self
        }
    }

    /// How far a chord may lie from what strays so far itself; what rounds its ends again takes its part.
    fn room_of_chords(&self, options: &Options, strayed: f64) -> f64 {
        let again = if options.rounds_again && !self.rounds_given {
            2.0 * self.precision.farthest_moved()
        } else {
            0.0
        };
        // A decimal is no binary number: as much again as a cut may be off covers by how much it is missed.
        self.room - strayed - again - self.cut()
    }

    /// Why there is no room for what is computed.
    fn too_coarse(&self) -> Error {
        let rounding = self.precision.farthest_moved();
        if rounding >= self.tolerance {
            return Error::RoundingAlone {
                rounding,
                tolerance: self.tolerance,
            };
        }
        Error::TooCoarse {
            tolerance: self.tolerance,
        }
    }

    const fn too_many(&self) -> Error {
        Error::TooManySegments {
            tolerance: self.tolerance,
            most: MOST_SEGMENTS,
            enough: f64::INFINITY,
        }
    }

    /// How closely lines and arcs follow that stray so far.
    fn closeness(&self, [lines, arcs]: [f64; 2]) -> Closeness {
        let of = |error: f64| Nearness {
            error,
            room: (self.tolerance - error).max(0.0),
        };
        Closeness {
            lines: of(lines),
            arcs: of(arcs),
        }
    }

    fn inner(&self, p: Point) -> Point {
        self.precision.round_point(p)
    }

    /// An end of a step, which stays as it was given.
    fn end(&self, p: Point) -> Point {
        if self.rounds_given { self.inner(p) } else { p }
    }
}

/// The most decimals that a coordinate of the contour's points has: those of the file that it came from.
fn decimals_given(contour: &Contour) -> u8 {
    let points = contour.steps.iter().flat_map(|step| match step {
        Step::Given(segment) => crate::curve::control_points(segment),
        Step::Arc(arc) => arc.ends.map(Vec::from).unwrap_or_default(),
    });
    let decimals = points.map(|p| decimals_of(p.x).max(decimals_of(p.y)));
    decimals.max().unwrap_or(0)
}
