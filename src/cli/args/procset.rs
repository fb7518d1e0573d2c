//! The words of `procset`.

use clap::{ArgAction, Args};
use curveto::Method;
use curveto::write::postscript::Procedures;

use super::{FileArgs, TalkArgs, values};

#[derive(Debug, Args)]
pub(crate) struct ProcsetArgs {
    /// The method whose quarter-circle handle the procedures use
    #[arg(short, long, value_name = "ID", default_value = "minimax", value_parser = values::METHOD, hide_possible_values = true)]
    pub(crate) method: Method,
    /// More of his procedures
    #[arg(long, value_enum, value_name = "WHAT,...", value_delimiter = ',', action = ArgAction::Set)]
    with: Vec<Procedures>,
    #[command(flatten)]
    pub(crate) output: FileArgs,
    #[command(flatten)]
    pub(crate) talk: TalkArgs,
}

impl ProcsetArgs {
    /// The other procedures that were asked for, each once.
    pub(crate) fn with(&self) -> Vec<Procedures> {
        let asked = |procedures: &Procedures| self.with.contains(procedures);
        let all = [Procedures::Reporter, Procedures::Trig];
        all.into_iter().filter(asked).collect()
    }
}
