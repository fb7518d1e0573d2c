//! The program as a child process.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, ExitStatus, Output, Stdio};

use serde_json::Value;

/// The program with these arguments.
pub(crate) fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_curveto"));
    command.args(arguments);
    command
}

/// Arguments with spaces between them.
pub(crate) fn words(arguments: &str) -> Vec<&str> {
    arguments.split_whitespace().collect()
}

/// What it prints, says and ends with.
pub(crate) fn run(arguments: &[&str]) -> Output {
    program(arguments).output().unwrap()
}

/// The same for arguments with spaces between them.
pub(crate) fn run_words(arguments: &str) -> Output {
    run(&words(arguments))
}

/// The program in a folder.
pub(crate) fn program_in(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = program(arguments);
    command.current_dir(folder);
    command
}

/// What it prints, says and ends with there.
pub(crate) fn run_in(folder: &Path, arguments: &[&str]) -> Output {
    program_in(folder, arguments).output().unwrap()
}

/// The same with this on standard input.
pub(crate) fn piped(arguments: &[&str], input: &[u8]) -> Output {
    let streams = || Stdio::piped();
    let mut command = program(arguments);
    command.stdin(streams()).stdout(streams()).stderr(streams());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    // A program that stops early does not read it all.
    let feeder = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().unwrap();
    feeder.join().unwrap();
    output
}

/// What it prints, where it does so without a word on standard error.
pub(crate) fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(
        output.status.success(),
        "{arguments:?}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(
        output.stderr.is_empty(),
        "{arguments:?}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).unwrap()
}

/// What it prints as JSON.
pub(crate) fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&printed(&[arguments, &["-f", "json"]].concat())).unwrap()
}

/// What standard error says of a request that ends with exit code 2 and prints nothing.
pub(crate) fn refused(arguments: &[&str]) -> String {
    let output = run(arguments);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert!(message.starts_with("error: "), "{arguments:?}: {message}");
    message
}

/// How a line of the shell ends in a folder.
pub(crate) fn shell(folder: &Path, script: &str) -> ExitStatus {
    let mut shell = Command::new("sh");
    shell.current_dir(folder).args(["-c", script]);
    shell.status().unwrap()
}
