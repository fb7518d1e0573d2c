//! Joints at the extremes, as type wants them.

use super::{Drawing, Options, Request, approximate, straight};
use crate::error::{Error, Result};
use crate::joints::{Cut, Joints, MOST_SEGMENTS};
use crate::shape::Shape;

/// How many parts of a piece between two extremes are tried for a tolerance.
const MOST_PARTS: usize = 256;

/// Draws a shape with joints at all of its horizontal and vertical extremes, as type wants them; `cut` tells into how many parts
/// each piece between them is cut, one by default, or for which tolerance. `with_start`: a closed shape begins at its own start, which
/// is a joint too, and not at the first extreme from there on.
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
    let draw = |parts: usize| {
        let cut = Cut::At(Joints::between_extremes(&outline.unit, &extremes, parts));
        let options = Options {
            cut,
            ..options.clone()
        };
        approximate(shape, &options)
    };
    match options.cut {
        Cut::Count(count @ 0) => Err(Error::Count {
            count,
            most: MOST_SEGMENTS,
        }),
        Cut::Count(parts) => draw(parts),
        Cut::Tolerance(tolerance) => {
            let tolerance = tolerance.for_radius(outline.truth.larger_radius());
            request.check_tolerance(tolerance)?;
            for parts in 1..=MOST_PARTS {
                let drawing = draw(parts)?;
                if drawing.error.peak() <= tolerance {
                    return Ok(drawing);
                }
            }
            Err(request.refusal(tolerance, None))
        }
        _ => draw(1),
    }
}
