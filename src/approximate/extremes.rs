//! Joints at the extremes, as type wants them.

use super::{Drawing, Options, Request, approximate, straight};
use crate::error::{Error, Result};
use crate::joints::{Cut, Joints, MOST_SEGMENTS};
use crate::measure::radial;
use crate::shape::{Shape, Truth};

/// Into how many parts a piece between two extremes is cut at most for a tolerance.
const MOST_PARTS: usize = 256;

/// Draws a shape with joints at all of its horizontal and vertical extremes, as type wants them; `cut` tells into how many parts
/// each piece between them is cut, one by default, or for which tolerance: then each into as few as it takes. `with_start`: a closed
/// shape begins at its own start, which is a joint too, and not at the first extreme from there on.
///
/// # Errors
///
/// As [`approximate`].
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
    let outline = &request.outline;
    let mut extremes = outline.extremes().to_vec();
    extremes.extend(with_start.then_some(outline.unit.start));
    let pieces = Joints::pieces(&outline.unit, &extremes);
    let draw = |parts: &[usize]| {
        let cut = Cut::At(Joints::of_pieces(&outline.unit, &pieces, parts));
        let options = Options {
            cut,
            ..options.clone()
        };
        approximate(shape, &options)
    };
    let mut parts = vec![1; pieces.len().saturating_sub(1)];
    match options.cut {
        Cut::Count(count @ 0) => Err(Error::Count {
            count,
            most: MOST_SEGMENTS,
        }),
        Cut::Count(count) => {
            parts.fill(count);
            draw(&parts)
        }
        Cut::Tolerance(tolerance) => {
            let tolerance = tolerance.for_radius(outline.truth.larger_radius());
            request.check_tolerance(tolerance)?;
            loop {
                let most = parts.iter().copied().max().unwrap_or(1);
                let drawing = match draw(&parts) {
                    // Where ends lie off the circle, pieces are alike.
                    Err(Error::Impossible { .. }) if parts.iter().any(|&count| count < most) => {
                        parts.fill(most);
                        draw(&parts)?
                    }
                    drawn => drawn?,
                };
                if drawing.error.peak() <= tolerance {
                    return Ok(drawing);
                }
                if most == MOST_PARTS {
                    return Err(request.refusal(tolerance, None));
                }
                cut_where_beyond(&mut parts, &drawing, &outline.truth, tolerance);
            }
        }
        _ => draw(&parts),
    }
}

/// Cuts the pieces that are beyond the tolerance once more, or all where none seems to be.
fn cut_where_beyond(parts: &mut [usize], drawing: &Drawing, truth: &Truth, tolerance: f64) {
    let mut segments = drawing.curve.segments.as_slice();
    let mut beyond: Vec<bool> = Vec::with_capacity(parts.len());
    for count in &*parts {
        let (piece, rest) = segments.split_at((*count).min(segments.len()));
        segments = rest;
        beyond.push(radial::error(piece, truth).peak() > tolerance);
    }
    let is_none = !beyond.contains(&true);
    for (count, is_beyond) in parts.iter_mut().zip(beyond) {
        *count += usize::from(is_beyond || is_none);
    }
}
