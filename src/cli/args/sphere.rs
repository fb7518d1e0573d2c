//! The words for a sphere.

use clap::{ArgAction, Args};
use curveto::picture::figure::Hidden;
use curveto::{Angle, Cut, Method};
use kurbo::Point;

use super::OutputArgs;
use super::values;

#[derive(Debug, Args)]
#[command(mut_arg("format", |arg| arg.value_parser(values::format_but_gcode())))]
#[command(mut_arg("feed", |arg| arg.hide(true)))]
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
    ///
    /// Dashes are in svg, eps, png, pdf and tikz; in path, ps, canvas, glif and dxf dash draws as show does.
    #[arg(long, value_enum, value_name = "HOW", default_value_t)]
    pub(crate) hidden: Hidden,
    /// Where the centre is seen
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, default_value = "0,0")]
    pub(crate) center: Point,
    /// The method, by id or alias
    ///
    /// 'curveto methods' lists them.
    #[arg(short, long, value_name = "ID", value_parser = values::METHOD, hide_possible_values = true, default_value_t, help_heading = "How it is approximated")]
    pub(crate) method: Method,
    /// Segments of a whole circle [default: 4]
    #[arg(
        short = 'n',
        long,
        value_name = "N",
        value_parser = values::count,
        allow_hyphen_values = true,
        conflicts_with = "joints",
        help_heading = "How it is approximated"
    )]
    segments: Option<usize>,
    /// Joints of every circle at these angles instead
    ///
    /// They are longitudes on a parallel, and count from the north pole on a meridian.
    #[arg(
        long,
        value_name = "A,B,...",
        value_delimiter = ',',
        value_parser = values::angle,
        allow_hyphen_values = true,
        action = ArgAction::Set,
        help_heading = "How it is approximated"
    )]
    joints: Vec<Angle>,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

impl SphereArgs {
    /// Where a whole circle is cut.
    pub(crate) fn cut(&self) -> Cut {
        match self.segments {
            Some(count) => Cut::Count(count),
            None if self.joints.is_empty() => Cut::Quarters,
            None => Cut::At(self.joints.clone()),
        }
    }
}
