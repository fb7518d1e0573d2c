//! The words of `convert`.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgAction, Args, ValueEnum};
use curveto::document::{self, Doubt, ElementKind, Only, Target, Trust};

use super::each::EachArgs;
use super::{TalkArgs, values};
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct ConvertArgs {
    /// Files, folders (their *.svg and *.svgz at any depth) or - for standard input [default: -]
    #[arg(value_name = "FILE|DIR|-")]
    pub(crate) inputs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) destination: DestinationArgs,
    /// What the curves become
    #[arg(long, value_enum, value_name = "KIND", default_value_t)]
    to: TargetArg,
    /// With --to arcs: whole circles, ellipses and rectangles
    ///
    /// Paths that are a whole circle, ellipse or round rectangle become one.
    #[arg(long)]
    shapes: bool,
    /// In folders, take hidden files and folders too
    #[arg(long)]
    pub(crate) hidden: bool,
    /// Replace only these
    #[arg(long, value_enum, value_name = "KIND,...", value_delimiter = ',', action = ArgAction::Set)]
    only: Vec<ElementKind>,
    /// Convert although notes of these codes would hold back: for who knows better
    #[arg(long, value_name = "CODE,...", hide_short_help = true, value_delimiter = ',', value_parser = doubts(), action = ArgAction::Set)]
    trust: Vec<Doubt>,
    /// Tell on standard error what was replaced and left
    ///
    /// Without it, what was left.
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) report: Option<ReportForm>,
    #[command(flatten)]
    pub(crate) talk: TalkArgs,
    #[command(flatten)]
    pub(crate) each: EachArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum TargetArg {
    /// Circles, ellipses, round rectangles and arcs become Béziers
    #[default]
    Beziers,
    /// Béziers that are arcs within -t become arcs; without it a thousandth of the radius (of the length of flat arcs) and the rounding of the file
    Arcs,
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
    /// Replace each file, atomically
    ///
    /// Files with nothing to do are not touched.
    #[arg(long)]
    pub(crate) in_place: bool,
    /// Write nothing; list the files with something to do
    ///
    /// The exit code is 1 if there is one.
    #[arg(long)]
    pub(crate) check: bool,
}

/// The form of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportForm {
    /// A line for everything left, and the counts
    Text,
    /// One JSON object
    Json,
}

/// The codes that `--trust` takes.
fn doubts() -> impl TypedValueParser<Value = Doubt> {
    PossibleValuesParser::new(Doubt::ALL.map(Doubt::code))
        .try_map(|code| Doubt::coded(&code).ok_or("not a code that can be trusted"))
}

impl ConvertArgs {
    /// The options of the conversion; refuses what no file could meet.
    pub(crate) fn options(&self) -> Result<document::Options, Failure> {
        let only = if self.only.is_empty() {
            Only::ALL
        } else {
            Only::of(&self.only)
        };
        let mut options = document::Options {
            to: self.target()?,
            only,
            trust: Trust::of(&self.trust),
            measure: self.talk.verbose || self.report.is_some(),
            ..document::Options::default()
        };
        if options.to == Target::Beziers {
            let precision = self.each.precision;
            options.rule = self.each.rule();
            options.cut = self.each.cut()?;
            options.precision = precision.and_then(values::PrecisionWord::decimals);
        }
        options.check()?;
        Ok(options)
    }

    /// Whether Béziers become arcs.
    pub(crate) fn goes_back(&self) -> bool {
        self.to == TargetArg::Arcs
    }

    fn target(&self) -> Result<Target, Failure> {
        match self.to {
            TargetArg::Arcs => Ok(Target::Arcs {
                tolerance: self.each.only_tolerance()?,
                shapes: self.shapes,
            }),
            TargetArg::Beziers if self.shapes => Err(Failure::request_with_hint(
                "--shapes makes circles, ellipses and rectangles, and Béziers were asked for",
                "--to arcs --shapes is the way back",
            )),
            TargetArg::Beziers => Ok(Target::Beziers),
        }
    }
}
