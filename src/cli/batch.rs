//! `batch`.

use std::cell::Cell;
use std::fs::File;
use std::io::{self, Read, Write};
use std::process::ExitCode;

use anyhow::Context;
use curveto::batch;

use super::Outcome;
use super::args::BatchArgs;
use super::failure::tell;

/// Standard output that says when it failed: an error alone does not tell whether reading or writing did.
struct Output<'a, W> {
    inner: W,
    failed: &'a Cell<bool>,
}

impl<W: Write> Write for Output<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.inner
            .write(bytes)
            .inspect_err(|error| self.failed.set(error.kind() != io::ErrorKind::Interrupted))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush().inspect_err(|_| self.failed.set(true))
    }
}

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
        let hint = error.hint().map(|hint| format!("hint: {hint}\n"));
        tell(&format!(
            "error: {name}:{line}: {error}\n{}",
            hint.unwrap_or_default()
        ));
    };
    let failed = Cell::new(false);
    let output = Output {
        inner: io::stdout().lock(),
        failed: &failed,
    };
    let summary = batch::run(input, output, &options, complain).with_context(|| {
        if failed.get() {
            "cannot write to standard output".to_owned()
        } else {
            format!("cannot go on with {name}")
        }
    })?;
    let batch::Summary { lines, failed } = summary;
    args.talk
        .state(|| format!("{name}: {lines} lines read, {failed} could not be drawn"));
    Ok(ExitCode::from(u8::from(failed > 0)))
}
