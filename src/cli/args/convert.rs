//! The words of `convert`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use curveto::document::{self, Kind, Only};
use curveto::joints::MOST_SEGMENTS;
use curveto::{Cut, Method, Rule, Tolerance};

use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct ConvertArgs {
    /// Files, folders (their *.svg and *.svgz at any depth) or - for standard input [default: -]
    #[arg(value_name = "FILE|DIR|-")]
    pub(crate) inputs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) destination: DestinationArgs,
    /// Replace only these
    #[arg(long, value_enum, value_name = "KIND,...", value_delimiter = ',')]
    only: Vec<KindArg>,
    /// How many files at a time [default: one for each processor]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,
    /// What was replaced and what was left, on standard error; without it, what was left
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) report: Option<Report>,
    /// A method by id or alias; 'curveto methods' lists them [default: minimax]
    #[arg(short, long, value_name = "ID", value_parser = values::MethodReader)]
    method: Option<Method>,
    /// Exactly N segments for each shape and arc, of equal parametric angle
    #[arg(short = 'n', long, value_name = "N", conflicts_with = "tolerance")]
    segments: Option<usize>,
    /// The fewest segments within this distance of the true shape: user units, or a percentage of the larger radius
    #[arg(short, long, value_name = "T", value_parser = values::tolerance, allow_hyphen_values = true)]
    tolerance: Option<Tolerance>,
    /// Decimals after the point, or auto: the fewest that add no more than a tenth of the error
    #[arg(short, long, value_name = "P", value_parser = values::precision, default_value = "auto")]
    precision: values::PrecisionWord,
}

/// Where the result goes; standard output without any of them.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub(crate) struct DestinationArgs {
    /// Write to FILE, atomically; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Write each file below DIR, folders kept
    #[arg(long, value_name = "DIR")]
    pub(crate) out_dir: Option<PathBuf>,
    /// Replace each file, atomically; files with nothing to do are not touched
    #[arg(long)]
    pub(crate) in_place: bool,
    /// Write nothing; list the files with something to do, and end with 1 if there is one
    #[arg(long)]
    pub(crate) check: bool,
}

/// The form of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Report {
    /// A line for everything left, and the counts
    Text,
    /// One JSON object
    Json,
}

/// What is replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum KindArg {
    /// <circle>
    Circle,
    /// <ellipse>
    Ellipse,
    /// <rect> with round corners
    Rect,
    /// Arc commands of <path>
    Path,
}

impl From<KindArg> for Kind {
    fn from(kind: KindArg) -> Self {
        match kind {
            KindArg::Circle => Self::Circle,
            KindArg::Ellipse => Self::Ellipse,
            KindArg::Rect => Self::Rect,
            KindArg::Path => Self::Path,
        }
    }
}

impl ConvertArgs {
    /// The options of the conversion; refuses what no file could meet.
    pub(crate) fn options(&self) -> Result<document::Options, Failure> {
        let kinds: Vec<Kind> = self.only.iter().map(|&kind| kind.into()).collect();
        let only = if kinds.is_empty() {
            Only::ALL
        } else {
            Only::of(&kinds)
        };
        let cut = match (self.segments, self.tolerance) {
            (Some(count), _) if count == 0 || count > MOST_SEGMENTS => {
                return Err(Failure::request(format!(
                    "{count} segments are not between 1 and {MOST_SEGMENTS}"
                )));
            }
            (Some(count), _) => Cut::Count(count),
            (None, Some(tolerance)) => Cut::Tolerance(tolerance),
            (None, None) => Cut::Quarters,
        };
        let options = document::Options {
            rule: Rule::Method(self.method.unwrap_or_default()),
            cut,
            precision: self.precision.decimals(),
            only,
        };
        options.check()?;
        Ok(options)
    }
}
