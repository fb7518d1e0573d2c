//! `procset`.

use std::process::ExitCode;

use curveto::method::Span;
use curveto::number::{compact, rounded_up};
use curveto::write::postscript;
use curveto::{Result, Rule};

use super::Outcome;
use super::args::ProcsetArgs;

pub(super) fn run(args: &ProcsetArgs) -> Outcome {
    let text = postscript::procset(Rule::Method(args.method), &args.with())?;
    args.output.target().write(text.as_bytes())?;
    let stated = summary(Rule::Method(args.method))?;
    args.talk.state(|| stated);
    Ok(ExitCode::SUCCESS)
}

/// What the procedures draw and how closely, in a line.
fn summary(rule: Rule) -> Result<String> {
    let peak = rule.radial_error(&Span::from_degrees(90.0))?.peak();
    Ok(format!(
        "procedures drawellipse and drawcircle: 4 segments by {}, within {} of the larger radius",
        rule.id(),
        compact(rounded_up(peak, 3), 3)
    ))
}
