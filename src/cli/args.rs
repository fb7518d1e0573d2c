//! The words of the command line, as clap reads them; nothing is computed here.

mod approximation;
mod batch;
pub(crate) mod compare;
mod conic;
mod convert;
mod deferred;
pub(crate) mod diff;
mod each;
pub(crate) mod explore;
pub(crate) mod measure;
pub(crate) mod methods;
mod output;
mod path;
mod picture;
mod procset;
pub(crate) mod shape;
mod sphere;
mod spline;
mod talk;
mod values;

pub(crate) use approximation::ApproximationArgs;
pub(crate) use batch::BatchArgs;
pub(crate) use compare::CompareArgs;
pub(crate) use conic::ConicShape;
pub(crate) use convert::{ConvertArgs, DestinationArgs, ReportForm};
pub(crate) use deferred::Deferred;
pub(crate) use explore::ExploreArgs;
pub(crate) use measure::MeasureArgs;
pub(crate) use methods::MethodsArgs;
pub(crate) use output::{FileArgs, OutputArgs};
pub(crate) use path::{PathArgs, PathKind};
pub(crate) use procset::ProcsetArgs;
pub(crate) use shape::{ArcShape, CircleShape, EllipseShape};
pub(crate) use sphere::SphereArgs;
pub(crate) use spline::{SplineArgs, SplineSource};
pub(crate) use talk::{QuietArgs, TalkArgs};
pub(crate) use values::{MOST_DECIMALS, PrecisionWord, hint_of_number};

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Draw circles, ellipses and arcs as Bézier curves, and say how far they stray.
#[derive(Debug, Parser)]
#[command(
    version,
    about,
    propagate_version = true,
    arg_required_else_help = true,
    // The last of a flag given twice counts, so that a Makefile can override.
    args_override_self = true,
    after_long_help = super::examples::of("curveto"),
    max_term_width = 100
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Draw a circle
    Circle(Deferred<Draw<CircleShape>>),
    /// Draw an ellipse
    Ellipse(Deferred<Draw<EllipseShape>>),
    /// Draw an arc of a circle or an ellipse
    Arc(Deferred<Draw<ArcShape>>),
    /// Draw a conic by its control point and weight
    ///
    /// An arc of an ellipse, a parabola or a hyperbola.
    #[command(
        override_usage = "curveto conic --from X,Y --control X,Y --to X,Y --weight W [OPTIONS]"
    )]
    Conic(Deferred<Draw<ConicShape>>),
    /// Draw SVG path data with Béziers, lines or circular arcs
    ///
    /// Every arc becomes Béziers, all else stays as it is; or all of it becomes lines or circular arcs.
    Path(Deferred<PathArgs>),
    /// Draw the shapes of a stream, one a line in, one a line out
    Batch(Deferred<BatchArgs>),
    /// Draw a composite parametric cubic curve through points, after Chen
    Spline(Deferred<SplineArgs>),
    /// Draw the parallels and meridians of a sphere, after Chen's Figure 1
    Sphere(Deferred<SphereArgs>),
    /// Print PostScript procedures that draw ellipses and circles, after Lancaster
    Procset(Deferred<ProcsetArgs>),
    /// Tell what is known of the methods
    Methods(Deferred<MethodsArgs>),
    /// Measure a curve: its error, length, area, curvature and joints
    Measure(Deferred<Box<MeasureArgs>, true>),
    /// Compare methods by their error and the number of segments
    Compare(Deferred<CompareArgs>),
    /// Tell how far two drawings lie apart
    Diff(Deferred<diff::DiffArgs>),
    /// Write a page to look at: choose methods and counts, magnify, compare, copy
    Explore(Deferred<Box<ExploreArgs>, true>),
    /// Replace circles, ellipses and arcs in SVG files by Béziers
    ///
    /// Rounded rectangles too; every other byte stays. --to arcs is the way back.
    Convert(Deferred<ConvertArgs>),
    /// Print a completion script for a shell
    Completions(Deferred<CompletionsArgs>),
    /// Print the manual page, or write those of all commands
    Man(Deferred<ManArgs>),
}

/// A shape, how it is approximated and how it is written.
#[derive(Debug, Args)]
pub(crate) struct Draw<S: Args> {
    #[command(flatten)]
    pub(crate) shape: S,
    #[command(flatten)]
    pub(crate) approximation: ApproximationArgs,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL", value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// Write curveto.1 and a page for every command into DIR
    #[arg(long, value_name = "DIR")]
    pub(crate) out_dir: Option<PathBuf>,
}

#[cfg(test)]
mod tests {
    use clap::{ArgAction, Command, CommandFactory as _};

    use super::Cli;

    /// Notes the flags that would take the values of all of their occurrences.
    fn visit(command: &Command, path: &str, growing: &mut Vec<String>) {
        assert!(command.is_args_override_self(), "{path}");
        for argument in command.get_arguments() {
            let id = format!("{path} {}", argument.get_id()).trim().to_owned();
            if !argument.is_positional() && matches!(argument.get_action(), ArgAction::Append) {
                growing.push(id);
            }
        }
        for inner in command.get_subcommands() {
            let path = format!("{path} {}", inner.get_name());
            visit(inner, path.trim(), growing);
        }
    }

    #[test]
    fn the_last_of_a_flag_counts() {
        let mut command = Cli::command();
        command.build();
        let mut growing = Vec::new();
        visit(&command, "", &mut growing);
        assert_eq!(growing, Vec::<String>::new());
    }
}
