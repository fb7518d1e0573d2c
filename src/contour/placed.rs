//! The numbers of contours that are to be drawn, as they are and under a map.

use kurbo::Affine;

use super::{Contour, Step};
use crate::curve::check_coordinates;
use crate::error::{Error, Result};

/// Refuses numbers that are not finite, or too large for the geometry, as they are or under a map.
pub(crate) fn check_placed(contours: &[Contour], map: Affine) -> Result<()> {
    let check = |step: &Step| match step {
        Step::Given(segment) => check_coordinates("coordinate", [map * *segment]),
        Step::Arc(arc) => arc.check(),
    };
    for (i, contour) in contours.iter().enumerate() {
        for (j, step) in contour.steps.iter().enumerate() {
            check(step).map_err(|why| Error::Segment {
                subpath: i + 1,
                segment: j + 1,
                why: Box::new(why),
            })?;
        }
    }
    Ok(())
}
