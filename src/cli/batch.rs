//! `batch`.

use std::cell::Cell;
use std::io::{self, IsTerminal, Read, Write};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use anyhow::Context;
use curveto::batch::{self, OnError, Options, Summary};
use curveto::number::{compact, counted, rounded_up};
use curveto::write::{Format, Image, write};

use super::args::BatchArgs;
use super::failure::{Failure, tell};
use super::input::Source;
use super::output::OutputTarget;
use super::{Outcome, remedies};

/// How often the progress of a run is shown.
const STEP: Duration = Duration::from_millis(200);

/// Output that says when it failed, for an error alone does not tell whether reading or writing did; and that shows how far a
/// run has come where somebody looks.
struct WatchedOutput<'a, W> {
    inner: W,
    failed: &'a Cell<bool>,
    progress: Option<Progress>,
}

impl<W: Write> Write for WatchedOutput<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self
            .inner
            .write(bytes)
            .inspect_err(|error| self.failed.set(error.kind() != io::ErrorKind::Interrupted))?;
        if let Some(progress) = &mut self.progress {
            progress.add(&bytes[..count]);
        }
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush().inspect_err(|_| self.failed.set(true))
    }
}

/// A line on the terminal that says how many lines were written.
struct Progress {
    lines: usize,
    shown: Instant,
}

impl Progress {
    fn new(target: &OutputTarget) -> Option<Self> {
        let is_shown = matches!(target, OutputTarget::File(_)) && io::stderr().is_terminal();
        is_shown.then(|| Self {
            lines: 0,
            shown: Instant::now(),
        })
    }

    fn add(&mut self, bytes: &[u8]) {
        self.lines += memchr::memchr_iter(b'\n', bytes).count();
        if self.shown.elapsed() >= STEP {
            self.shown = Instant::now();
            // Where standard error is gone, nobody is left to tell.
            let _ = write!(io::stderr().lock(), "\r{} lines", self.lines);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        let _ = write!(io::stderr().lock(), "\r\x1b[K");
    }
}

pub(super) fn run(args: &BatchArgs) -> Outcome {
    let options = args.options()?;
    let looks = args.picture(options.format)?;
    let source = args.file.as_deref().map_or(Source::Stdin, Source::of);
    let (input, name) = (source.open()?, source.name());
    let target = args.output.target();
    let complain = |line: u64, error: &curveto::Error| {
        let hint = remedies::hint_of_line(error).map(|hint| format!("hint: {hint}\n"));
        let message = remedies::message(error);
        tell(&format!(
            "error: {name}:{line}: {message}\n{}",
            hint.unwrap_or_default()
        ));
    };
    let names = (name.as_str(), &target);
    let summary = match options.format {
        Format::Path | Format::Json | Format::Ps => lines(input, &options, names, complain)?,
        _ => picture(input, &options, &looks, names, complain)?,
    };
    let Summary {
        lines,
        failed,
        worst,
    } = summary;
    args.talk.state(|| {
        let lines = counted(lines as usize, "line");
        let within = worst.map(|(line, peak)| {
            if peak == 0.0 {
                return "; each is exact".to_owned();
            }
            let peak = compact(rounded_up(peak, 3), 3);
            format!("; each within {peak} of its true shape, the farthest on line {line}")
        });
        let within = within.unwrap_or_default();
        format!("{name}: {lines} read, {failed} could not be drawn{within}")
    });
    Ok(ExitCode::from(u8::from(failed > 0)))
}

/// Answers line by line, to standard output or to a whole file.
fn lines(
    input: Box<dyn Read + Send>,
    options: &Options,
    names: (&str, &OutputTarget),
    complain: impl FnMut(u64, &curveto::Error),
) -> Result<Summary, Failure> {
    let mut summary = Summary::default();
    names.1.stream(|output| {
        summary = stream(input, output, options, names, complain)?;
        Ok(keeps(summary, options))
    })?;
    Ok(summary)
}

/// Draws all lines as one picture.
fn picture(
    input: Box<dyn Read + Send>,
    options: &Options,
    looks: &curveto::write::Options,
    (name, target): (&str, &OutputTarget),
    complain: impl FnMut(u64, &curveto::Error),
) -> Result<Summary, Failure> {
    let format = options.format;
    if format == Format::Image(Image::Png) {
        target.refuse_terminal()?;
    }
    let picture = batch::figure(input, options, complain).map_err(|error| ended(name, error))?;
    if keeps(picture.summary, options) {
        let bytes = match format {
            Format::Dxf => picture.dxf().into_bytes(),
            _ => write(&picture, format, looks)?,
        };
        target.write(&bytes)?;
    }
    Ok(picture.summary)
}

/// Whether a file is to be written: not where a line ended the run.
fn keeps(summary: Summary, options: &Options) -> bool {
    summary.failed == 0 || options.on_error != OnError::Stop
}

/// Answers line by line.
fn stream(
    input: Box<dyn Read + Send>,
    output: &mut dyn Write,
    options: &Options,
    (name, target): (&str, &OutputTarget),
    complain: impl FnMut(u64, &curveto::Error),
) -> Result<Summary, Failure> {
    let failed = Cell::new(false);
    let output = WatchedOutput {
        inner: output,
        failed: &failed,
        progress: Progress::new(target),
    };
    let summary = batch::run(input, output, options, complain);
    if failed.get() {
        Ok(summary.with_context(|| target.cannot())?)
    } else {
        Ok(summary.map_err(|error| ended(name, error))?)
    }
}

/// Why a run ended at its input. What is wrong with a line begins with the number of that.
fn ended(name: &str, error: io::Error) -> anyhow::Error {
    match error.kind() {
        io::ErrorKind::InvalidData => anyhow::anyhow!("{name}:{error}"),
        _ => anyhow::Error::from(error).context(format!("cannot go on with {name}")),
    }
}
