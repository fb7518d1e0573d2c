//! The words of `path`.

use std::ffi::OsString;

use clap::{Args, ValueEnum, ValueHint};
use curveto::contour::BezierTarget;
use curveto::{Method, Rule};

use super::{ApproximationArgs, OutputArgs};
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
#[command(
    // A path has many arcs: -n, -t and -m are for each of them.
    mut_arg("extremes", |arg| arg.hide(true)),
    mut_arg("segments", |arg| arg.help("Exactly N segments for each arc, of equal parametric angle")),
    mut_arg("tolerance", |arg| arg.long_help("The fewest segments within T of the path\n\nT is a distance in user units, or a percentage: of the larger radius of each arc, with --to quadratics for cubics of half the larger side of the box of their control points, with --to lines and --to arcs of half that of the subpath's box. The curve is judged as it is printed: where rounding takes a segment more, more decimals (-p) may save it.")),
    after_long_help = "Points that are given stay as they are unless -p or --transform changes them; what is computed is rounded as the arc with the smallest error needs it."
)]
pub(crate) struct PathArgs {
    /// SVG path data, or a file of it or of SVG; - is standard input
    ///
    /// Of SVG, paths and basic shapes are read, with transforms and nested viewports; <use> and style sheets are not followed.
    #[arg(
        value_name = "DATA|FILE|-",
        value_hint = ValueHint::AnyPath,
        allow_hyphen_values = true,
        required_unless_present = "power"
    )]
    pub(crate) source: Option<OsString>,
    /// Equation-space coefficients in its place
    ///
    /// JSON with the "power" of each segment, as -f json prints it, or a file of it.
    #[arg(long, value_name = "JSON|FILE|-", value_hint = ValueHint::AnyPath, conflicts_with = "source")]
    pub(crate) power: Option<OsString>,
    /// What it becomes
    #[arg(long, value_enum, value_name = "KIND", default_value_t)]
    to: PathTargetArg,
    /// With --to arcs: arcs of ellipses too
    ///
    /// They stand where circles alone would take more, and where one was drawn or given.
    #[arg(long)]
    elliptic: bool,
    /// Leave out the closing operators
    #[arg(long)]
    pub(crate) open: bool,
    #[command(flatten)]
    pub(crate) approximation: ApproximationArgs,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum PathTargetArg {
    /// Arcs become Béziers, all else stays as it is
    #[default]
    Beziers,
    /// Arcs and cubics become quadratics, a cubic the fewest equal parts of its parameter within -t or a thousandth of half the size of its control points' box
    Quadratics,
    /// All becomes lines within -t, or a thousandth of half the subpath's size
    Lines,
    /// All becomes lines and circular arcs within -t, or that and the rounding of its points, but at most a hundredth of that size; the error is the largest of all, each against what it replaces; for path, json, svg, eps, png, pdf, dxf and gcode
    Arcs,
}

/// What a path becomes.
pub(crate) enum PathKind {
    Beziers(BezierTarget),
    Lines,
    Arcs,
}

impl PathArgs {
    /// What it becomes.
    pub(crate) fn kind(&self) -> PathKind {
        match self.to {
            PathTargetArg::Beziers => PathKind::Beziers(BezierTarget::Beziers),
            PathTargetArg::Quadratics => PathKind::Beziers(BezierTarget::Quadratics),
            PathTargetArg::Lines => PathKind::Lines,
            PathTargetArg::Arcs => PathKind::Arcs,
        }
    }

    /// Whether arcs may be those of ellipses.
    pub(crate) fn elliptic(&self) -> Result<bool, Failure> {
        if self.elliptic && self.to != PathTargetArg::Arcs {
            return Err(Failure::request_with_hint(
                "--elliptic is for --to arcs",
                "'curveto path DATA --to arcs --elliptic' makes arcs of circles and ellipses",
            ));
        }
        Ok(self.elliptic)
    }

    /// What gives the control points of arcs.
    pub(crate) fn rule(&self) -> Result<Rule, Failure> {
        if self.to == PathTargetArg::Beziers {
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
