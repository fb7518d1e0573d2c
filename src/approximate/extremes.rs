//! Joints at the extremes, as type wants them.

use kurbo::PathSeg;

use super::{Drawing, Options, ROUNDING_SHARE, Request, approximate, sketch, straight};
use crate::angle::Angle;
use crate::error::{Error, JointsError, Remedy, Result};
use crate::joints::{Cut, Joints, Tolerance, adaptive, check_count};
use crate::measure::radial;
use crate::method::Rule;
use crate::number::Precision;
use crate::shape::Shape;

/// Into how many parts a piece between two extremes is cut at most for a tolerance.
const MOST_PARTS: usize = 256;

/// What is beyond a limit this many times is so whatever its own rounding.
const OVER: f64 = 1.0 + 1e-9;

/// Draws a shape with joints at all of its horizontal and vertical extremes, as type wants them; `cut` tells into how many parts
/// each piece between them is cut, as few as the method serves by default, or for which tolerance: then each into as few as it takes. `with_start`: a closed
/// shape begins at its own start, which is a joint too, and not at the first extreme from there on.
///
/// # Errors
///
/// As [`approximate`], and [`Error::Joints`] for a cut that has joints of its own: [`Cut::Adaptive`] and [`Cut::At`].
///
/// ```
/// use curveto::{Angle, Ellipse, Options, Shape, approximate::approximate_at_extremes};
/// let slanted = Shape::Ellipse(Ellipse::new((0.0, 0.0), (30.0, 20.0), Angle::from_degrees(30.0))?);
/// let drawing = approximate_at_extremes(&slanted, false, &Options::default())?;
/// let first = drawing.curve.start().unwrap_or_default();
/// let right = drawing.curve.bounding_box().map_or(0.0, |bounds| bounds.x1);
/// assert_eq!(drawing.curve.segments.len(), 4);
/// assert!((drawing.curve.segments.iter().any(|s| (kurbo::ParamCurve::end(s).x - right).abs() < 1e-9)), "{first}");
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn approximate_at_extremes(
    shape: &Shape,
    with_start: bool,
    options: &Options,
) -> Result<Drawing> {
    let Some(request) = Request::new(shape, options)? else {
        return straight(shape, options);
    };
    let pieces = BetweenExtremes::new(request, with_start);
    let mut parts = pieces.fewest();
    match options.cut {
        Cut::Count(count) => {
            check_count(count.saturating_mul(parts.len()))?;
            parts.fill(count);
            let drawn = pieces.draw(&parts);
            drawn.map_err(|error| with_more_parts(error, pieces.largest))
        }
        Cut::Tolerance(tolerance) => pieces.within(parts, tolerance),
        Cut::Quarters => pieces.draw(&parts),
        Cut::Adaptive(_) | Cut::At(_) => Err(Error::Joints(JointsError::Extremes)),
    }
}

/// A shape between its extremes.
struct BetweenExtremes<'a> {
    request: Request<'a>,
    /// How many degrees after the start the pieces meet, both ends included.
    ways: Vec<f64>,
    /// The largest angle that the method serves, in degrees, where it serves uneven ones.
    largest: Option<f64>,
}

impl<'a> BetweenExtremes<'a> {
    fn new(request: Request<'a>, with_start: bool) -> Self {
        let outline = &request.outline;
        let mut extremes = outline.extremes().to_vec();
        extremes.extend(with_start.then_some(outline.unit.start));
        let rule = request.options.rule;
        Self {
            ways: Joints::pieces(&outline.unit, &extremes),
            largest: rule.largest_uneven_angle(outline.axes().short),
            request,
        }
    }

    /// Into how many parts each has to be cut at least for the method to serve.
    fn fewest(&self) -> Vec<usize> {
        let largest = self.largest.unwrap_or(f64::INFINITY);
        let parts = |pair: &[f64]| ((pair[1] - pair[0]) / largest - 1e-9).ceil().max(1.0) as usize;
        self.ways.windows(2).map(parts).collect()
    }

    fn joints(&self, parts: &[usize]) -> Vec<Angle> {
        Joints::of_pieces(&self.request.outline.unit, &self.ways, parts)
    }

    fn draw(&self, parts: &[usize]) -> Result<Drawing> {
        let options = Options {
            cut: Cut::At(self.joints(parts)),
            ..self.request.options.clone()
        };
        approximate(self.request.shape, &options)
    }

    /// Whether rounding alone moves a joint beyond the tolerance.
    fn has_joint_beyond(&self, parts: &[usize], tolerance: f64) -> Result<bool> {
        let joints = Joints::at(&self.request.outline.unit, &self.joints(parts))?;
        Ok(self.request.has_joint_beyond(&joints, tolerance))
    }

    /// Which pieces are beyond a tolerance, cut into so many parts.
    ///
    /// First come those that are beyond it however they are rounded. Where there are none, those that are beyond it as they are written.
    /// `within` holds, for either question, the pieces that an earlier call found within the tolerance; they are not measured again. The caller
    /// clears it when it changes the parts of such a piece.
    fn beyond(
        &self,
        parts: &[usize],
        tolerance: f64,
        within: &mut [Vec<bool>; 2],
    ) -> Result<Vec<bool>> {
        let asked = self.request.options.precision;
        // Decimals that were not asked for add a tenth of the error, and go by all pieces.
        let limit = asked.map_or(tolerance / (1.0 - ROUNDING_SHARE), |precision| {
            tolerance + precision.farthest_moved()
        });
        // Where ends lie off the circle each piece goes by all.
        let rule = self.request.options.rule;
        if !(adaptive::serves(rule) || matches!(rule, Rule::Handle(_))) {
            within.fill(vec![false; parts.len()]);
        }
        let [bare, written] = within;
        let beyond = self.beyond_by(parts, limit, Some(Precision::Full), bare)?;
        if beyond.contains(&true) {
            return Ok(beyond);
        }
        if asked.is_none() {
            written.fill(false);
        }
        self.beyond_by(parts, tolerance, asked, written)
    }

    /// Which pieces are beyond a limit where they are rounded so; the others are noted in `within`.
    fn beyond_by(
        &self,
        parts: &[usize],
        limit: f64,
        precision: Option<Precision>,
        within: &mut [bool],
    ) -> Result<Vec<bool>> {
        let options = Options {
            cut: Cut::At(self.joints(parts)),
            precision,
            ..self.request.options.clone()
        };
        let curve = sketch(self.request.shape, &options)?.rounded();
        let truth = &self.request.outline.truth;
        let limit = OVER * limit;
        for (piece, is_within) in of_each(parts, &curve.segments).zip(&mut *within) {
            *is_within = *is_within
                || (self.request.by_bounds(piece, limit))
                    .unwrap_or_else(|| radial::is_within(piece, truth, limit));
        }
        Ok(within.iter().map(|is_within| !is_within).collect())
    }

    /// From so many parts on, each cut into as few as a tolerance takes.
    fn within(&self, mut parts: Vec<usize>, tolerance: Tolerance) -> Result<Drawing> {
        let truth = &self.request.outline.truth;
        let tolerance = tolerance.checked(truth.larger_radius())?;
        self.request.check_tolerance(tolerance)?;
        if self.has_joint_beyond(&vec![1; parts.len()], tolerance)? {
            return Err(self.request.refusal(tolerance, None));
        }
        let unknown = vec![false; parts.len()];
        let mut within = [unknown.clone(), unknown.clone()];
        loop {
            let most = parts.iter().copied().max().unwrap_or(1);
            if most < MOST_PARTS && self.has_joint_beyond(&parts, tolerance)? {
                for count in &mut parts {
                    *count += 1;
                }
                within.fill(unknown.clone());
                continue;
            }
            if most < MOST_PARTS
                && let Ok(beyond) = self.beyond(&parts, tolerance, &mut within)
                && beyond.contains(&true)
            {
                cut_more(&mut parts, &beyond);
                continue;
            }
            let drawing = match self.draw(&parts) {
                // Where ends lie off the circle, pieces are alike.
                Err(Error::Impossible { .. }) if parts.iter().any(|&count| count < most) => {
                    parts.fill(most);
                    self.draw(&parts)?
                }
                drawn => drawn?,
            };
            if drawing.error.peak() <= tolerance {
                return Ok(drawing);
            }
            if most >= MOST_PARTS {
                return Err(self.request.refusal(tolerance, None));
            }
            let is_beyond = |piece| radial::error(piece, truth).peak() > tolerance;
            let pieces = of_each(&parts, &drawing.curve.segments);
            let mut beyond: Vec<bool> = pieces.map(is_beyond).collect();
            // All where none seems to be.
            if !beyond.contains(&true) {
                beyond.fill(true);
            }
            cut_more(&mut parts, &beyond);
            within.fill(unknown.clone());
        }
    }
}

/// Joints that are too far apart ask for more parts here, since the extremes are given.
fn with_more_parts(mut error: Error, largest: Option<f64>) -> Error {
    if let Error::Impossible {
        remedy: remedy @ Remedy::Joints(_),
        ..
    } = &mut error
    {
        *remedy = Remedy::MoreSegments {
            degrees: largest,
            methods: &["minimax"],
        };
    }
    error
}

/// The segments of each piece.
fn of_each<'a>(
    parts: &'a [usize],
    mut segments: &'a [PathSeg],
) -> impl Iterator<Item = &'a [PathSeg]> {
    parts.iter().map(move |&count| {
        let (piece, rest) = segments.split_at(count.min(segments.len()));
        segments = rest;
        piece
    })
}

/// Cuts pieces into one part more.
fn cut_more(parts: &mut [usize], which: &[bool]) {
    for (count, &is_cut) in parts.iter_mut().zip(which) {
        *count += usize::from(is_cut);
    }
}

#[cfg(test)]
mod tests {
    use super::super::fewest::TRIES;
    use super::*;
    use crate::Circle;

    #[test]
    fn parts_whose_joints_rounding_moves_too_far_are_not_drawn() {
        // Within 0.05 of this circle no point of the grid lies that joins up to so many parts of a quarter.
        let shape = Shape::Circle(Circle::new((0.0, 0.0), 6.0).unwrap());
        let options = Options {
            precision: Some(Precision::Fixed(0)),
            cut: Cut::Tolerance(crate::Tolerance::Absolute(0.05)),
            ..Options::default()
        };
        let before = TRIES.get();
        let drawn = approximate_at_extremes(&shape, false, &options);
        let refused = matches!(drawn, Err(Error::ToleranceOutOfReach { .. }));
        // As many parts as there are at most, and one before, bare and rounded.
        assert!(refused && TRIES.get() - before == 3);
    }

    #[test]
    fn the_decimals_of_one_piece_ask_no_other_for_more_parts() {
        let degrees = Angle::from_degrees;
        let (start, sweep) = (degrees(-45.92), degrees(-172.443));
        let arc = crate::Arc::new((0.0, 0.0), (0.50382, 0.13848), Angle::ZERO, start, sweep);
        let options = Options {
            rule: crate::Method::Goldapp.into(),
            cut: Cut::Tolerance(crate::Tolerance::Absolute(1.52e-6)),
            ..Options::default()
        };
        let drawn = approximate_at_extremes(&Shape::Arc(arc.unwrap()), false, &options).unwrap();
        assert!(drawn.error.peak() <= 1.52e-6);
        assert_eq!(drawn.curve.segments.len(), 4);
    }
}
