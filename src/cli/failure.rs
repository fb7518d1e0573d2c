//! Failures: a message, a hint, an exit code.

use core::fmt;
use std::io::{self, Write as _};
use std::process::ExitCode;

use anstream::{AutoStream, ColorChoice};

use super::hints::called::Called;
use super::remedies;

/// Why a command ended, and how the process is to end.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A wrong or impossible request: exit code 2.
    Request {
        /// What was asked and why it cannot be.
        message: String,
        /// What can be done instead.
        hint: Option<String>,
    },
    /// A failure while running: exit code 1.
    Running(anyhow::Error),
    /// The reader of our output is gone, which is its right: exit code 0.
    ClosedPipe,
}

impl Failure {
    /// A wrong request without a hint.
    pub(crate) fn request(message: impl Into<String>) -> Self {
        Self::Request {
            message: message.into(),
            hint: None,
        }
    }

    /// A wrong request and what to do about it.
    pub(crate) fn request_with_hint(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Request {
            message: message.into(),
            hint: Some(hint.into()),
        }
    }

    /// A wrong request with this hint in place of its own.
    pub(crate) fn with_hint(self, hint: &str) -> Self {
        match self {
            Self::Request { message, .. } => Self::request_with_hint(message, hint),
            other => other,
        }
    }

    /// The same with a hint that names no flags which the command that was called lacks.
    pub(crate) fn fitted(self, called: &Called) -> Self {
        match self {
            Self::Request { message, hint } => Self::Request {
                message,
                hint: hint.and_then(|hint| called.fitting(&hint)),
            },
            other => other,
        }
    }

    /// A failure of any kind as that of a wrong request.
    pub(crate) fn requested(self) -> Self {
        match self {
            Self::Running(error) => Self::request(format!("{error:#}")),
            other => other,
        }
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Request { .. } => ExitCode::from(2),
            Self::Running(_) => ExitCode::from(1),
            Self::ClosedPipe => ExitCode::SUCCESS,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Request { message, hint } => {
                writeln!(f, "error: {message}")?;
                hint.iter().try_for_each(|hint| writeln!(f, "hint: {hint}"))
            }
            Self::Running(error) => writeln!(f, "error: {error:#}"),
            Self::ClosedPipe => Ok(()),
        }
    }
}

impl From<curveto::Error> for Failure {
    fn from(error: curveto::Error) -> Self {
        Self::Request {
            hint: remedies::hint(&error),
            message: remedies::message(&error),
        }
    }
}

impl From<anyhow::Error> for Failure {
    fn from(error: anyhow::Error) -> Self {
        let closed = error
            .chain()
            .filter_map(|cause| cause.downcast_ref::<io::Error>())
            .any(is_closed_pipe);
        if closed {
            Self::ClosedPipe
        } else {
            Self::Running(error)
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        anyhow::Error::from(error).into()
    }
}

fn is_closed_pipe(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}

/// Writes to standard error, whose reader may be a terminal: what is quoted is cut, and its control characters are spelt out.
pub(crate) fn tell(text: &str) {
    // Where standard error is gone, nobody is left to tell.
    let _ = anstream::stderr()
        .lock()
        .write_all(fit_for_terminals(text).as_bytes());
}

/// The longest line of a message, and how much of a longer one is left at its end.
const LONGEST_LINE: usize = 1500;
const LINE_END: usize = 300;

/// A message with control characters spelt out and its longest lines cut; with colours, where standard error shows them.
pub(crate) fn fit_for_terminals(text: &str) -> String {
    let mut out = String::with_capacity(text.len().min(4 * LONGEST_LINE));
    for line in without_numbers_of_the_system(text).split_inclusive('\n') {
        let length = line.chars().count();
        let cut = length > LONGEST_LINE;
        for (i, letter) in line.chars().enumerate() {
            if cut && i == LONGEST_LINE - LINE_END {
                out += " ... ";
            }
            if cut && (LONGEST_LINE - LINE_END..length - LINE_END).contains(&i) {
                continue;
            }
            if letter.is_control() && !matches!(letter, '\n' | '\t') {
                out.extend(letter.escape_default());
            } else {
                out.push(letter);
            }
        }
    }
    if AutoStream::choice(&io::stderr()) == ColorChoice::Never {
        out
    } else {
        coloured(&out)
    }
}

/// What messages begin with, and its colour.
const COLOURS: [(&str, &str); 3] = [
    ("error:", "\x1b[1;31m"),
    ("hint:", "\x1b[1;36m"),
    ("note:", "\x1b[1;32m"),
];

/// A message with the word that each of its lines begins with in colour.
fn coloured(text: &str) -> String {
    let line = |line: &str| {
        let found = COLOURS.iter().find(|(word, _)| line.starts_with(word));
        found.map_or_else(
            || line.to_owned(),
            |(word, colour)| format!("{colour}{word}\x1b[0m{}", &line[word.len()..]),
        )
    };
    text.split_inclusive('\n').map(line).collect()
}

/// A message without the numbers that Rust puts after the system's words: `(os error 2)`.
fn without_numbers_of_the_system(text: &str) -> String {
    let mut parts = text.split(" (os error ");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(')') {
            Some((number, rest)) if number.bytes().all(|b| b.is_ascii_digit()) => out += rest,
            _ => out.extend([" (os error ", part]),
        }
    }
    out
}
