//! The words of `measure`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{ArgAction, Args, Subcommand, ValueEnum, ValueHint};
use curveto::curve::Curve;
use curveto::measure::Quantity;
use curveto::measure::fit::{self, Fit, FitTo};
use curveto::picture::size::Size;
use curveto::shape::Truth;
use curveto::{Angle, Ellipse, Shape};
use kurbo::{Affine, Vec2};

use super::shape::{ArcShape, CircleShape, EllipseShape};
use super::{ApproximationArgs, ConicShape, FileArgs, QuietArgs, values};
use crate::cli::examples;
use crate::cli::formats::FileFormat;

/// What to measure: a shape that is drawn here, or a curve that someone else made.
#[derive(Debug, Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_help_heading = "Shapes",
    subcommand_value_name = "SHAPE",
    after_long_help = examples::of("measure"),
    override_usage = "curveto measure circle|ellipse|arc|conic ... [OPTIONS]\n       curveto measure --path 'M...' | --file F.svg [--against SHAPE] [OPTIONS]"
)]
pub(crate) struct MeasureArgs {
    #[command(subcommand)]
    pub(crate) shape: Option<MeasuredShape>,
    #[command(flatten)]
    pub(crate) foreign: ForeignArgs,
    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

#[derive(Debug, Subcommand)]
pub(crate) enum MeasuredShape {
    /// Measure a circle as it would be drawn
    Circle(Measured<CircleShape>),
    /// Measure an ellipse as it would be drawn
    Ellipse(Measured<EllipseShape>),
    /// Measure an arc as it would be drawn
    Arc(Measured<ArcShape>),
    /// Measure a conic as it would be drawn
    #[command(
        override_usage = "curveto measure conic --from X,Y --control X,Y --to X,Y --weight W\n                             [OPTIONS]"
    )]
    Conic(Measured<ConicShape>),
}

/// A shape, how it is approximated, and what is stated of it. Several methods may be named.
#[derive(Debug, Args)]
#[command(
    after_long_help = examples::of("measure"),
    mut_arg("method", |arg| arg.value_name("ID,ID").help("Methods by id or alias [default: minimax]").long_help("Methods by id or alias [default: minimax]\n\n'curveto methods' lists them.")),
    mut_arg("segments", |arg| arg.value_name("N,N").help("Exactly N segments, of equal parametric angle, once for each number")),
)]
pub(crate) struct Measured<S: Args> {
    #[command(flatten)]
    pub(crate) shape: S,
    #[command(flatten)]
    pub(crate) approximation: ApproximationArgs,
    /// Round the control points to P decimals, or as drawing would with auto [default: full precision]
    #[arg(short, long, value_name = "P", value_parser = values::precision)]
    pub(crate) precision: Option<values::PrecisionWord>,
    /// An SVG transform list, applied to the control points
    #[arg(long, value_name = "LIST", value_parser = values::transform, allow_hyphen_values = true)]
    pub(crate) transform: Option<Affine>,
    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "A curve that someone else made")]
pub(crate) struct ForeignArgs {
    /// SVG path data, or a file that holds it; - is standard input
    #[arg(
        long,
        value_name = "DATA|FILE|-",
        value_hint = ValueHint::AnyPath,
        allow_hyphen_values = true,
        group = "curve"
    )]
    pub(crate) path: Option<OsString>,
    /// Every path of an SVG file, its transforms applied; - is standard input
    #[arg(long, alias = "svg", value_name = "FILE", group = "curve")]
    pub(crate) file: Option<PathBuf>,
    /// The true shape [default: the one that fits best, as --fit says]
    #[arg(long, value_name = "circle:CX,CY,R|ellipse:CX,CY,RX,RY,ROT", value_parser = against, requires = "curve")]
    pub(crate) against: Option<Truth>,
    /// What is fitted where --against names nothing [default: circle]
    ///
    /// A circle, an ellipse, or with auto an ellipse where it is much nearer, and to what: the joints where they determine it, else the
    /// curve.
    #[arg(
        long,
        value_enum,
        value_name = "TO",
        conflicts_with = "against",
        requires = "curve"
    )]
    pub(crate) fit: Option<FitArg>,
}

/// What is fitted to a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum FitArg {
    /// A circle
    #[default]
    Circle,
    /// An ellipse
    Ellipse,
    /// An ellipse where it is at least four times nearer than a circle, else a circle
    Auto,
    /// A circle, to the ends of the segments
    Joints,
    /// A circle, to points all along the curve
    Curve,
}

impl FitArg {
    /// The shape that a curve was meant to be.
    pub(crate) fn fitted(self, curve: &Curve) -> curveto::Result<(Truth, Fit)> {
        match self {
            Self::Circle => fit::circle(curve, None),
            Self::Ellipse => fit::ellipse(curve, None),
            Self::Auto => fit::either(curve),
            Self::Joints => fit::circle(curve, Some(FitTo::Joints)),
            Self::Curve => fit::circle(curve, Some(FitTo::Curve)),
        }
    }
}

/// How a report is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum ReportFormat {
    /// For people, 80 columns wide
    #[default]
    Table,
    /// One object, or an array of several; docs/schema/measurement.json describes it
    Json,
    /// A line a curve
    Csv,
}

impl FileFormat for ReportFormat {
    fn extensions(&self) -> &'static [&'static str] {
        match self {
            Self::Table => &["txt"],
            Self::Json => &["json"],
            Self::Csv => &["csv"],
        }
    }
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Report")]
pub(crate) struct ReportArgs {
    /// The format [default: by the extension of -o, else table]
    #[arg(short, long, value_enum, value_name = "F", ignore_case = true)]
    pub(crate) format: Option<ReportFormat>,
    #[command(flatten)]
    pub(crate) output: FileArgs,
    /// Report N points of each segment in its place
    ///
    /// At equal steps of t, both ends among them: t, x, y, radius, error, degrees.
    #[arg(long, value_name = "N", value_parser = values::count)]
    pub(crate) samples: Option<usize>,
    /// How far rounding may have moved each coordinate, in user units: jumps at joints that this explains do not count
    /// [default: four units in the last place of the largest coordinate]
    #[arg(long, value_name = "D", hide_short_help = true, value_parser = values::number, allow_hyphen_values = true, conflicts_with = "samples")]
    pub(crate) coordinate_tolerance: Option<f64>,
    /// Draw the quantity along the curve too
    ///
    /// The extension says how: svg, eps, png or pdf. Without one, such as /dev/fd/3, it is svg.
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// What the plot shows [default: error] [possible values: error, curvature, curvature-d1, curvature-d2, angle-lag, drawing]
    ///
    /// Several stand one below the other.
    #[arg(long, value_name = "Q,Q,...", requires = "plot", value_delimiter = ',', action = ArgAction::Set, value_parser = values::QUANTITY, hide_possible_values = true)]
    pub(crate) quantity: Vec<Quantity>,
    /// The size of the plot, such as 800x400 or 80x60mm
    ///
    /// Without a unit it is pixels in svg and png, points in eps and pdf; units are mm, cm, in and pt.
    #[arg(
        long,
        value_name = "WxH",
        requires = "plot",
        allow_hyphen_values = true
    )]
    pub(crate) size: Option<Size>,
    #[command(flatten)]
    pub(crate) quiet: QuietArgs,
}

/// Reads the true shape of `--against`.
fn against(text: &str) -> Result<Truth, String> {
    let form = || format!("'{text}' is neither circle:CX,CY,R nor ellipse:CX,CY,RX,RY,ROT");
    let (kind, numbers) = text.split_once(':').ok_or_else(form)?;
    let fields: Vec<&str> = numbers.split(',').map(str::trim).collect();
    let (radii, rotation) = match (kind.trim(), fields.as_slice()) {
        ("circle", [_, _, r]) => (
            Vec2::new(values::number(r)?, values::number(r)?),
            Angle::ZERO,
        ),
        ("ellipse", [_, _, rx, ry]) => (
            Vec2::new(values::number(rx)?, values::number(ry)?),
            Angle::ZERO,
        ),
        ("ellipse", [_, _, rx, ry, rotation]) => (
            Vec2::new(values::number(rx)?, values::number(ry)?),
            values::angle(rotation)?,
        ),
        _ => return Err(form()),
    };
    let center = (values::number(fields[0])?, values::number(fields[1])?);
    let ellipse = Ellipse::new(center, radii, rotation).map_err(|error| error.to_string())?;
    let outline = Shape::Ellipse(ellipse).outline();
    outline.map(|outline| outline.truth).ok_or_else(form)
}
