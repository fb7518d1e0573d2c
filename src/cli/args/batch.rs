//! The words of `batch`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use curveto::batch::{OnError, Options};
use curveto::write::Format;
use curveto::{Cut, Method, Rule, Tolerance};

use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// The lines, one shape each; - is standard input [default: -]
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// The format of the answers, one line each: path, json or ps
    #[arg(short, long, value_name = "F", value_enum, default_value_t)]
    format: BatchFormat,
    /// A method by id or alias, where a line names none [default: minimax]
    #[arg(short, long, value_name = "ID", value_parser = values::MethodReader)]
    method: Option<Method>,
    /// Exactly N segments, of equal parametric angle, where a line does not say
    #[arg(short = 'n', long, value_name = "N", conflicts_with = "tolerance")]
    segments: Option<usize>,
    /// The fewest segments within this distance of the true shape, where a line does not say
    #[arg(short, long, value_name = "T", value_parser = values::tolerance, allow_hyphen_values = true)]
    tolerance: Option<Tolerance>,
    /// Decimals after the point, or auto: for each shape the fewest that add no more than a tenth of its error
    #[arg(short, long, value_name = "P", value_parser = values::precision, default_value = "auto")]
    precision: values::PrecisionWord,
    /// How many threads [default: one for every core]
    #[arg(short, long, value_name = "N")]
    jobs: Option<usize>,
    /// What becomes of a line that cannot be drawn: it ends the run, has no answer, or a blank one
    #[arg(long, value_name = "ACTION", value_enum, default_value_t)]
    on_error: OnErrorArg,
}

#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum BatchFormat {
    #[default]
    Path,
    Json,
    Ps,
}

#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum OnErrorArg {
    #[default]
    Stop,
    Skip,
    Blank,
}

impl BatchArgs {
    pub(crate) fn options(&self) -> Result<Options, Failure> {
        let jobs = match self.jobs {
            Some(0) => return Err(Failure::request("-j 0 leaves nobody to work: at least 1")),
            Some(jobs) => jobs.min(256),
            None => std::thread::available_parallelism().map_or(1, usize::from),
        };
        Ok(Options {
            format: match self.format {
                BatchFormat::Path => Format::Path,
                BatchFormat::Json => Format::Json,
                BatchFormat::Ps => Format::Ps,
            },
            rule: Rule::Method(self.method.unwrap_or_default()),
            cut: match (self.segments, self.tolerance) {
                (Some(count), _) => Cut::Count(count),
                (None, Some(tolerance)) => Cut::Tolerance(tolerance),
                (None, None) => Cut::Quarters,
            },
            precision: self.precision.precision(),
            on_error: match self.on_error {
                OnErrorArg::Stop => OnError::Stop,
                OnErrorArg::Skip => OnError::Skip,
                OnErrorArg::Blank => OnError::Blank,
            },
            jobs,
        })
    }
}
