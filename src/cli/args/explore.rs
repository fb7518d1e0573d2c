//! The words of `explore`.

use clap::{ArgAction, Args, Subcommand, ValueEnum};
use curveto::Rule;

use super::shape::{ArcShape, CircleShape, EllipseShape};
use super::values::{self, MethodList};
use super::{ConicShape, FileArgs, QuietArgs};
use crate::cli::examples;
use crate::cli::formats::FileFormat;

/// What to look at.
#[derive(Debug, Args)]
#[command(
    subcommand_help_heading = "Shapes",
    subcommand_value_name = "SHAPE",
    override_usage = "curveto explore circle|ellipse|arc|conic ... -o PAGE.html [OPTIONS]",
    after_long_help = examples::of("explore")
)]
pub(crate) struct ExploreArgs {
    #[command(subcommand)]
    pub(crate) shape: ExploredShape,
}

#[derive(Debug, Subcommand)]
pub(crate) enum ExploredShape {
    /// Look at a circle
    Circle(Explored<CircleShape>),
    /// Look at an ellipse
    Ellipse(Explored<EllipseShape>),
    /// Look at an arc
    Arc(Explored<ArcShape>),
    /// Look at a conic that is an arc of an ellipse
    #[command(
        override_usage = "curveto explore conic --from X,Y --control X,Y --to X,Y --weight W\n                             -o PAGE.html [OPTIONS]"
    )]
    Conic(Explored<ConicShape>),
}

/// A shape, and what there is to choose from.
#[derive(Debug, Args)]
#[command(after_long_help = examples::of("explore"))]
pub(crate) struct Explored<S: Args> {
    #[command(flatten)]
    pub(crate) shape: S,
    /// Methods to choose from, by id or alias, or all
    #[arg(short, long, value_name = "ID,ID|all", default_value = "all", value_parser = values::METHODS, hide_possible_values = true, action = ArgAction::Set, help_heading = "Page")]
    method: Vec<MethodList>,
    /// Numbers of segments to choose from [default: 2,3,4,5,6,8; of an open arc 1,2,3,4,6,8]
    #[arg(short = 'n', long, value_name = "N,N", value_parser = values::count, value_delimiter = ',', action = ArgAction::Set, help_heading = "Page")]
    pub(crate) segments: Vec<usize>,
    /// The format [default: by the extension of -o, else html]
    #[arg(
        short,
        long,
        value_enum,
        value_name = "F",
        ignore_case = true,
        help_heading = "Page"
    )]
    pub(crate) format: Option<PageFormat>,
    #[command(flatten, next_help_heading = "Page")]
    pub(crate) output: FileArgs,
    #[command(flatten, next_help_heading = "Page")]
    quiet: QuietArgs,
}

impl<S: Args> Explored<S> {
    /// The rules of the methods.
    pub(crate) fn rules(&self) -> Vec<Rule> {
        self.method
            .iter()
            .flatten()
            .map(|&method| Rule::Method(method))
            .collect()
    }
}

/// How a page is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum PageFormat {
    /// One file that needs nothing else
    #[default]
    Html,
    /// What the page holds; docs/schema/page.json describes it
    Json,
}

impl FileFormat for PageFormat {
    fn extensions(&self) -> &'static [&'static str] {
        match self {
            Self::Html => &["html", "htm"],
            Self::Json => &["json"],
        }
    }
}
