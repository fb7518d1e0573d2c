//! The command line of `curveto`.

use std::process::ExitCode;

mod cli;

fn main() -> ExitCode {
    cli::main()
}
