//! How far a finished curve strays from the exact shape. It reads points and nothing of the method that made them, so that it
//! judges any method, rounded output, and curves that others made.

pub(crate) mod bench;
pub mod continuity;
pub mod curvature;
pub mod extent;
pub mod fit;
pub(crate) mod hausdorff;
pub mod profile;
pub mod radial;
pub mod reference;
pub mod report;
pub mod samples;

pub use profile::Quantity;
pub use reference::Reference;
pub use report::Report;

use kurbo::Affine;

use crate::curve::{Curve, control_points};
use crate::error::{Error, Result, UnmeasurableError, finite};
use crate::numeric::functions::power;
use bench::Bench;

/// Measures a curve. `coordinate_tolerance` is how far rounding may have moved each coordinate; without it, four units in the
/// last place of the largest one in double precision.
///
/// # Errors
///
/// Where the curve has no segment, a coordinate is not finite or beyond 1e150, or the true shape is so small that the rounding of
/// the coordinates swallows it.
///
/// ```
/// use curveto::measure::{Reference, report};
/// use curveto::{Circle, Method, Options, Rule, Shape, approximate};
/// let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0)?);
/// let options = Options { rule: Rule::Method(Method::Apprich), ..Options::default() };
/// let drawing = approximate(&circle, &options)?;
/// let outline = drawing.outline.expect("a circle has an outline");
/// let report = report(&drawing.curve, &Reference::from(&outline), None)?;
/// assert_eq!(report.error.outward, drawing.error.outward);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn report(
    curve: &Curve,
    reference: &Reference,
    coordinate_tolerance: Option<f64>,
) -> Result<Report> {
    if curve.segments.is_empty() {
        return Err(Error::Unmeasurable(UnmeasurableError::Empty));
    }
    let largest = largest_coordinate(curve, reference)?;
    let smaller_radius = reference.truth.radii.x.min(reference.truth.radii.y);
    if smaller_radius <= 8.0 * f64::EPSILON * largest {
        return Err(Error::Unmeasurable(UnmeasurableError::Lost {
            radius: smaller_radius,
            coordinate: largest,
        }));
    }
    let unit = unit_for(largest);
    let scaled = curve.transformed(Affine::scale(1.0 / unit));
    let delta = coordinate_tolerance.unwrap_or(4.0 * f64::EPSILON * largest);
    let bench = Bench::new(&scaled, &reference.scaled(1.0 / unit));
    let mut report = bench.report(delta / unit);
    report.rescale(unit);
    Ok(report)
}

/// The unit of the bench: a power of two near the largest number brings every power of a length into the range of f64, without a
/// rounding error.
pub(crate) fn unit_for(largest: f64) -> f64 {
    power(2.0, libm::log2(largest).ceil().clamp(-500.0, 500.0) as i32)
}

/// The largest number among all coordinates, of which none may be too large; the radii are positive too.
pub(crate) fn largest_coordinate(curve: &Curve, reference: &Reference) -> Result<f64> {
    let truth = &reference.truth;
    for value in [truth.radii.x, truth.radii.y] {
        // As small as a curve may be: only a constructor asks for more.
        if finite("radius", value)? <= 0.0 {
            let what = "radius";
            return Err(Error::NotPositive { what, value });
        }
    }
    let mut largest = truth.larger_radius().max(f64::MIN_POSITIVE);
    let points = curve.segments.iter().flat_map(control_points);
    for p in points.chain([truth.center]) {
        for x in [p.x, p.y] {
            largest = largest.max(finite("coordinate", x)?.abs());
        }
    }
    Ok(largest)
}
