//! The words for a curve through points.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use curveto::method::Quadrature;
use curveto::spline::{self, Options, SplineEnds};
use kurbo::Vec2;

use super::OutputArgs;
use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
#[command(
    after_long_help = "A curve through points states no error: -p auto keeps the points as they were given and moves no control point farther than a ten-thousandth of the shortest distance between neighbours.",
    mut_arg("format", |arg| arg.value_parser(values::format_but_gcode())),
    mut_arg("feed", |arg| arg.hide(true))
)]
pub(crate) struct SplineArgs {
    #[command(flatten)]
    pub(crate) source: SplineSource,
    #[command(flatten)]
    way: SplineWay,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub(crate) struct SplineSource {
    /// The points, one after the other: 'x,y x,y ...'
    #[arg(long, value_name = "POINTS", allow_hyphen_values = true)]
    pub(crate) points: Option<String>,
    /// A file of points: CSV or one pair a line; - is standard input
    ///
    /// Blank lines, what follows a # and a first line of names are skipped. Names are words of letters, digits, _ and - that begin with a
    /// letter, quoted or not, and units in brackets beside them: x [mm],y [mm]; where commas end them, also Column 1,Column 2. A word such as l0 is a mistyped number.
    #[arg(long, value_name = "FILE")]
    pub(crate) points_file: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "How it runs through them")]
struct SplineWay {
    /// How far the parameter runs along each segment
    #[arg(long, value_enum, value_name = "P", default_value_t)]
    parametrization: ParametrizationArg,
    /// Nodal derivatives of length 1: G1 in place of C2
    ///
    /// Chen makes them unit vectors with arc length.
    #[arg(long)]
    unit_tangents: bool,
    /// What holds at the ends: cyclic, free, natural or fixed:DX,DY,DX,DY
    ///
    /// cyclic is a closed curve, free has derivatives zero, natural no curvature, fixed:DX,DY,DX,DY these derivatives.
    #[arg(long, value_name = "ENDS", value_parser = values::ENDS, hide_possible_values = true, default_value = "free")]
    ends: SplineEnds,
    /// How arc length is integrated
    #[arg(
        long,
        value_enum,
        value_name = "RULE",
        hide_short_help = true,
        default_value_t
    )]
    quadrature: Quadrature,
    /// The iteration of arc lengths ends when none changes by more than this part of itself [default: 1e-12]
    #[arg(long, value_name = "E", hide_short_help = true, value_parser = values::positive, allow_hyphen_values = true)]
    stop: Option<f64>,
}

/// How far the parameter runs along each segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum ParametrizationArg {
    /// From 0 to 1: Formulation I
    #[default]
    Uniform,
    /// The distance of its ends
    Chord,
    /// The square root of that distance
    Centripetal,
    /// Its own arc length, iterated from the chords: Formulation II
    ArcLength,
}

impl SplineArgs {
    /// How the curve runs through its points.
    pub(crate) fn options(&self) -> Result<Options, Failure> {
        let parametrization = match self.way.parametrization {
            ParametrizationArg::Uniform => spline::Parametrization::Uniform,
            ParametrizationArg::Chord => spline::Parametrization::Chord,
            ParametrizationArg::Centripetal => spline::Parametrization::Centripetal,
            ParametrizationArg::ArcLength => {
                spline::Parametrization::ArcLength(self.way.quadrature)
            }
        };
        let measures = matches!(parametrization, spline::Parametrization::ArcLength(_));
        if self.way.quadrature == Quadrature::Gauss2 && !measures {
            return Err(Failure::request_with_hint(
                format!(
                    "{} parametrization integrates no arc length, so that --quadrature has nothing to say",
                    parametrization.name()
                ),
                "--quadrature gauss2 goes with --parametrization arc-length",
            ));
        }
        if self.way.stop.is_some() && !measures {
            return Err(Failure::request_with_hint(
                format!(
                    "{} parametrization iterates nothing, so that --stop has nothing to say",
                    parametrization.name()
                ),
                "--stop goes with --parametrization arc-length",
            ));
        }
        Ok(Options {
            stop: self.way.stop.unwrap_or(spline::SETTLED),
            parametrization,
            ends: self.way.ends,
            unit_tangents: self.way.unit_tangents,
        })
    }
}

pub(super) fn ends(text: &str) -> Result<SplineEnds, String> {
    match text {
        "cyclic" => Ok(SplineEnds::Cyclic),
        "free" => Ok(SplineEnds::Free),
        "natural" => Ok(SplineEnds::Natural),
        _ => {
            let numbers = text.strip_prefix("fixed:").ok_or(
                "ends are cyclic, free, natural or fixed:DX,DY,DX,DY, with the derivatives at the first and the last point",
            )?;
            let numbers: Vec<f64> = numbers
                .split(',')
                .map(values::number)
                .collect::<Result<_, _>>()?;
            let [x0, y0, x1, y1] = numbers[..] else {
                return Err(format!(
                    "fixed ends take four numbers, the derivatives at the first and the last point: fixed:DX,DY,DX,DY, but here {} {}",
                    if numbers.len() == 1 { "is" } else { "are" },
                    numbers.len()
                ));
            };
            Ok(SplineEnds::Fixed([Vec2::new(x0, y0), Vec2::new(x1, y1)]))
        }
    }
}
