//! The words for a conic.

use clap::Args;
use curveto::Shape;
use curveto::conic::Conic;
use kurbo::Point;

use super::shape::{Direction, ShapeWords};
use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct ConicShape {
    /// The first point
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true)]
    from: Point,
    /// The control point, where the tangents at both ends meet
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true)]
    control: Point,
    /// The last point
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true)]
    to: Point,
    /// The weight of the control point: below 1 an arc of an ellipse, 1 a parabola, above 1 a hyperbola
    #[arg(long, value_name = "W", value_parser = values::number, allow_hyphen_values = true)]
    weight: f64,
}

impl ConicShape {
    pub(crate) fn conic(&self) -> Result<Conic, Failure> {
        Ok(Conic::new(self.from, self.control, self.to, self.weight)?)
    }
}

impl ShapeWords for ConicShape {
    /// The arc of an ellipse that it is.
    fn shape(&self, _: Direction) -> Result<Shape, Failure> {
        self.conic()?
            .arc()?
            .ok_or_else(|| {
                Failure::request_with_hint(
                    "this conic is no arc of an ellipse",
                    "take a weight below 0.9999; 'curveto conic' and 'curveto measure conic' take the others too",
                )
            })
    }
}
