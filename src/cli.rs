//! The command line: words to library calls, results to bytes, errors to messages and exit codes.

mod args;
mod batch;
mod compare;
mod completions;
mod conic;
mod convert;
mod diff;
mod draw;
mod examples;
mod explore;
mod failure;
mod formats;
mod hints;
mod input;
mod measure;
mod methods;
mod new_file;
mod output;
mod path;
mod procset;
mod remedies;
mod shell;
mod signals;
mod sphere;
mod spline;
mod table;
mod usage;

use std::io::{self, IsTerminal as _};
use std::process::ExitCode;

use clap::{CommandFactory as _, FromArgMatches as _};

use args::{Cli, Command};
use failure::Failure;
use hints::called::Called;

/// What every command ends with: an exit code, 0 where all went well.
type Outcome = Result<ExitCode, Failure>;

/// Parses the command line, runs it and tells how it went.
pub(crate) fn main() -> ExitCode {
    signals::take_limits_as_errors();
    let cli = match parse() {
        Ok(cli) => cli,
        Err(error) => return usage::tell_of(error),
    };
    match run(cli.command) {
        Ok(code) => code,
        Err(failure) => {
            let failure = failure.fitted(&Called::of(&usage::words()));
            failure::tell(&failure.to_string());
            failure.exit_code()
        }
    }
}

/// Parses the command line. Help that goes into a file is the same on every terminal.
fn parse() -> Result<Cli, clap::Error> {
    let mut command = Cli::command();
    if !io::stdout().is_terminal() {
        command = command.term_width(usize::from(table::PROSE));
    }
    let mut matches = command.try_get_matches_from_mut(std::env::args_os())?;
    Cli::from_arg_matches_mut(&mut matches).map_err(|error| error.format(&mut command))
}

fn run(command: Command) -> Outcome {
    match command {
        Command::Circle(args) => draw::run(&args.0),
        Command::Ellipse(args) => draw::run(&args.0),
        Command::Arc(args) => draw::run(&args.0),
        Command::Conic(args) => conic::run(&args.0),
        Command::Batch(args) => batch::run(&args.0),
        Command::Path(args) => path::run(&args.0),
        Command::Spline(args) => spline::run(&args.0),
        Command::Sphere(args) => sphere::run(&args.0),
        Command::Procset(args) => procset::run(&args.0),
        Command::Methods(args) => methods::run(&args.0),
        Command::Measure(args) => measure::run(&args.0),
        Command::Compare(args) => compare::run(&args.0),
        Command::Diff(args) => diff::run(&args.0),
        Command::Explore(args) => explore::run(&args.0),
        Command::Convert(args) => convert::run(&args.0),
        Command::Completions(args) => shell::completions(&args.0),
        Command::Man(args) => shell::man(&args.0),
    }
}
