//! The words of `batch`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use curveto::batch::{OnError, Options};
use curveto::write::Format;

use super::each::EachArgs;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// The lines, one shape each; what a line says of its method and segments wins; - is standard input [default: -]
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// The format of the answers, one line each: path, json or ps
    #[arg(short, long, value_name = "F", value_enum, default_value_t)]
    format: BatchFormat,
    #[command(flatten)]
    each: EachArgs,
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
        let jobs = self.each.jobs.map_or_else(
            || std::thread::available_parallelism().map_or(1, usize::from),
            |jobs| jobs.get().min(256),
        );
        Ok(Options {
            format: match self.format {
                BatchFormat::Path => Format::Path,
                BatchFormat::Json => Format::Json,
                BatchFormat::Ps => Format::Ps,
            },
            rule: self.each.rule(),
            cut: self.each.cut()?,
            precision: self.each.precision.precision(),
            on_error: match self.on_error {
                OnErrorArg::Stop => OnError::Stop,
                OnErrorArg::Skip => OnError::Skip,
                OnErrorArg::Blank => OnError::Blank,
            },
            jobs,
        })
    }
}
