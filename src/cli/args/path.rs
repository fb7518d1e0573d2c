//! The words of `path`.

use clap::{Args, ValueEnum};
use curveto::contour::Target;
use curveto::{Method, Rule};

use super::{ApproximationArgs, OutputArgs};
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
#[command(
    after_help = "Points that are given stay as they are unless -p or --transform changes them; what is computed is rounded as the arc with the smallest error needs it."
)]
pub(crate) struct PathArgs {
    /// SVG path data, or a file that holds it; - is standard input
    #[arg(value_name = "DATA|FILE|-", allow_hyphen_values = true)]
    pub(crate) source: String,
    /// What it becomes
    #[arg(long, value_enum, value_name = "KIND", default_value_t)]
    to: TargetArg,
    /// Leave out the closing operators
    #[arg(long)]
    pub(crate) open: bool,
    #[command(flatten)]
    pub(crate) approximation: ApproximationArgs,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum TargetArg {
    /// Arcs become Béziers, all else stays as it is
    #[default]
    Beziers,
    /// Arcs and cubics become quadratics, cubics within -t or a thousandth of their size
    Quadratics,
}

impl PathArgs {
    /// What becomes of the Béziers that were given.
    pub(crate) fn target(&self) -> Target {
        match self.to {
            TargetArg::Beziers => Target::Beziers,
            TargetArg::Quadratics => Target::Quadratics,
        }
    }

    /// What gives the control points of arcs.
    pub(crate) fn rule(&self) -> Result<Rule, Failure> {
        if self.to == TargetArg::Beziers {
            return self.approximation.rule();
        }
        match self.approximation.named_rule()? {
            None => Ok(Rule::Method(Method::QuadraticMinimax)),
            Some(rule) if rule.is_quadratic() => Ok(rule),
            Some(rule) => Err(Failure::request_with_hint(
                format!("{} draws cubics", rule.id()),
                "--to quadratics takes a method of quadratics, such as -m quadratic-minimax",
            )),
        }
    }
}
