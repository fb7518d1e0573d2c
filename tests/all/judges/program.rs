//! The program as a child process.

use std::path::Path;
use std::process::{Command, ExitStatus, Output};

use serde_json::Value;

/// What it prints, says and ends with.
pub(crate) fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_curveto"))
        .args(arguments)
        .output()
        .unwrap()
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
