//! The words of `procset`.

use std::path::PathBuf;

use clap::{ArgAction, Args, ValueEnum};
use curveto::Method;
use curveto::write::postscript::Procedures;

use super::{TalkArgs, values};

#[derive(Debug, Args)]
pub(crate) struct ProcsetArgs {
    /// The method whose quarter-circle handle the procedures use
    #[arg(short, long, value_name = "ID", default_value = "minimax", value_parser = values::METHOD, hide_possible_values = true)]
    pub(crate) method: Method,
    /// More of his procedures
    #[arg(long, value_enum, value_name = "WHAT,...", value_delimiter = ',', action = ArgAction::Set)]
    with: Vec<With>,
    /// Write to FILE, atomically; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) talk: TalkArgs,
}

/// More of Lancaster's procedures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum With {
    /// reportpath prints the current path, each point as x before y
    Reporter,
    /// acos, asin, trig.acos and trig.asin, in degrees
    Trig,
}

impl ProcsetArgs {
    /// The other procedures that were asked for, each once.
    pub(crate) fn with(&self) -> Vec<Procedures> {
        let asked = |with: With| self.with.contains(&with);
        [
            (With::Reporter, Procedures::Reporter),
            (With::Trig, Procedures::Trig),
        ]
        .into_iter()
        .filter_map(|(word, procedures)| asked(word).then_some(procedures))
        .collect()
    }
}
