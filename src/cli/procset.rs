//! `procset`.

use std::process::ExitCode;

use curveto::Rule;
use curveto::write::postscript;

use super::Outcome;
use super::args::ProcsetArgs;
use super::output::Target;

pub(super) fn run(args: &ProcsetArgs) -> Outcome {
    let text = postscript::procset(Rule::Method(args.method), &args.with())?;
    Target::new(args.output.as_deref()).write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
