//! What the parser of the command line has to say.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::failure::{Failure, tell};
use super::hints::called::Called;
use super::{examples, hints};

/// Tells it: help and version on standard output, errors on standard error.
pub(crate) fn tell_of(mut error: clap::Error) -> ExitCode {
    if !error.use_stderr() {
        return match print(&error, anstream::stdout()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                tell(&format!(
                    "error: cannot write to standard output: {error}\n"
                ));
                ExitCode::FAILURE
            }
            _ => ExitCode::SUCCESS,
        };
    }
    let words = words();
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let Some(command) = words.first() else {
            // Where standard error is gone, nobody is left to tell.
            let _ = print(&error, anstream::stderr());
            return ExitCode::from(2);
        };
        let failure = Failure::request_with_hint(
            format!("{command}: the shape is missing"),
            format!("for example: curveto {command} circle 50 -o page.html"),
        );
        tell(&failure.to_string());
        return failure.exit_code();
    }
    let mut called = Called::of(&words);
    // The parser's own usage names the flags that it met, whether they matter or not.
    if error.get(ContextKind::Usage).is_some() {
        let usage = called.command.render_usage();
        error.insert(ContextKind::Usage, ContextValue::StyledStr(usage));
    }
    let text = error.render().to_string();
    // Where a value is refused with a hint of its own, that is the better one.
    let (text, own) = match text.split_once("\nhint: ") {
        Some((before, rest)) => {
            let (own, after) = rest.split_once('\n').unwrap_or((rest, ""));
            (format!("{before}\n{after}"), Some(own.to_owned()))
        }
        None => (text, None),
    };
    let hint = own.or_else(|| hints::hint(&error, &words));
    let hint = hint.and_then(|hint| called.fitting(&hint));
    tell(&message(&text, hint.as_deref()));
    ExitCode::from(2)
}

/// The words of the command line, the program left out.
pub(crate) fn words() -> Vec<String> {
    let words = std::env::args_os().skip(1);
    words
        .map(|word| word.to_string_lossy().into_owned())
        .collect()
}

/// Prints help or the version.
fn print(error: &clap::Error, mut out: impl Write) -> io::Result<()> {
    let text = error.render().ansi().to_string();
    out.write_all(text.replace(examples::BLANK, " ").as_bytes())?;
    out.flush()
}

/// The parser's message with its tips, or our hint in their place, directly below what is wrong. Its tip how to pass a flag as a value
/// is left out: hardly anyone means that.
fn message(text: &str, hint: Option<&str>) -> String {
    let mut wrong: Vec<&str> = Vec::new();
    let mut tips: Vec<&str> = Vec::new();
    let mut rest: Vec<&str> = Vec::new();
    for line in text.lines() {
        if !rest.is_empty() || line.starts_with("Usage:") || line.starts_with("For more") {
            rest.push(line);
        } else if let Some(tip) = line.strip_prefix("  tip: ") {
            tips.push(tip);
        } else {
            wrong.push(line);
        }
    }
    tips.retain(|tip| hint.is_none() && !tip.contains("as a value"));
    let mut out = wrong.join("\n").trim_end().to_owned() + "\n";
    for hint in hint.into_iter().chain(tips) {
        out.extend(["hint: ", hint, "\n"]);
    }
    out + "\n" + &rest.join("\n") + "\n"
}
