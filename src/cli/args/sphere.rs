//! The words for a sphere.

use clap::{Args, ValueEnum};
use curveto::{Angle, Method};
use kurbo::Point;

use super::OutputArgs;
use super::values;

#[derive(Debug, Args)]
pub(crate) struct SphereArgs {
    /// The radius
    #[arg(value_name = "RADIUS", value_parser = values::number, allow_negative_numbers = true)]
    pub(crate) radius: f64,
    /// How many meridians, each from pole to pole
    #[arg(long, value_name = "N", value_parser = values::count, allow_hyphen_values = true, default_value_t = 12)]
    pub(crate) meridians: usize,
    /// How many parallels between the poles
    #[arg(long, value_name = "N", value_parser = values::count, allow_hyphen_values = true, default_value_t = 7)]
    pub(crate) parallels: usize,
    /// The longitude and latitude of the point in the middle
    #[arg(long, value_name = "LON,LAT", value_parser = values::angles, allow_hyphen_values = true, default_value = "30,20")]
    pub(crate) view: [Angle; 2],
    /// What becomes of the hidden halves
    #[arg(long, value_enum, value_name = "HOW", default_value_t)]
    pub(crate) hidden: Hidden,
    /// Where the centre is seen
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, default_value = "0,0")]
    pub(crate) center: Point,
    /// A method by id or alias; 'curveto methods' lists them
    #[arg(short, long, value_name = "ID", value_parser = values::MethodReader, default_value_t, help_heading = "How it is approximated")]
    pub(crate) method: Method,
    /// Segments of a whole circle [default: 4]
    #[arg(
        short = 'n',
        long,
        value_name = "N",
        value_parser = values::count,
        allow_hyphen_values = true,
        help_heading = "How it is approximated"
    )]
    pub(crate) segments: Option<usize>,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// What becomes of the hidden halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum Hidden {
    /// Drawn like the others
    Show,
    /// Drawn dashed
    #[default]
    Dash,
    /// Left out
    None,
}

impl From<Hidden> for curveto::picture::figure::Hidden {
    fn from(hidden: Hidden) -> Self {
        match hidden {
            Hidden::Show => Self::Show,
            Hidden::Dash => Self::Dash,
            Hidden::None => Self::None,
        }
    }
}
