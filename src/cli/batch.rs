//! `batch`.

use std::fs::File;
use std::io::{self, Read, Write};
use std::process::ExitCode;

use anyhow::Context;
use curveto::batch;

use super::Outcome;
use super::args::BatchArgs;

pub(super) fn run(args: &BatchArgs) -> Outcome {
    let options = args.options()?;
    let file = args.file.as_deref().filter(|path| path.as_os_str() != "-");
    let (input, name): (Box<dyn Read + Send>, _) = match file {
        Some(path) => {
            let name = path.display().to_string();
            let input = File::open(path).with_context(|| format!("cannot read {name}"))?;
            (Box::new(input), name)
        }
        None => (Box::new(io::stdin()), "<stdin>".to_owned()),
    };
    let complain = |line: u64, error: &curveto::Error| {
        let mut stderr = io::stderr().lock();
        // Where standard error is gone, nobody is left to tell.
        let _ = writeln!(stderr, "error: {name}:{line}: {error}");
        if let Some(hint) = error.hint() {
            let _ = writeln!(stderr, "hint: {hint}");
        }
    };
    let summary = batch::run(input, io::stdout().lock(), &options, complain)
        .with_context(|| format!("cannot go on with {name}"))?;
    let batch::Summary { lines, failed } = summary;
    args.talk
        .state(|| format!("{name}: {lines} lines read, {failed} could not be drawn"));
    Ok(ExitCode::from(u8::from(failed > 0)))
}
