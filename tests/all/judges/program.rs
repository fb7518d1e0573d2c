//! The program as a child process.

use std::io::Write as _;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::{env, fs, iter};

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

/// The same for arguments with spaces between them, in which an underscore is a space.
pub(crate) fn run_words(arguments: &str) -> Output {
    let words = words(arguments).into_iter();
    let words: Vec<String> = words.map(|word| word.replace('_', " ")).collect();
    run(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

/// What those print, which have to succeed.
pub(crate) fn drawn(arguments: &str) -> Vec<u8> {
    let output = run_words(arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "curveto {arguments}: {message}");
    output.stdout
}

/// The same where it is text.
pub(crate) fn drawn_text(arguments: &str) -> String {
    String::from_utf8(drawn(arguments)).unwrap()
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
    fed(spawned(arguments), input)
}

/// The same where nobody reads what it prints.
pub(crate) fn unread(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = spawned(arguments);
    drop(child.stdout.take());
    fed(child, input)
}

fn spawned(arguments: &[&str]) -> Child {
    let streams = || Stdio::piped();
    let mut command = program(arguments);
    command.stdin(streams()).stdout(streams()).stderr(streams());
    command.spawn().unwrap()
}

fn fed(mut child: Child, input: &[u8]) -> Output {
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

/// The shell in a folder, with our program first in PATH.
pub(crate) fn shell(folder: &Path, script: &str) -> Command {
    let program = Path::new(env!("CARGO_BIN_EXE_curveto"));
    let others = env::var_os("PATH").unwrap();
    let path = iter::once(program.parent().unwrap().to_owned()).chain(env::split_paths(&others));
    let mut shell = Command::new("sh");
    shell.current_dir(folder).args(["-c", script]);
    shell.env("PATH", env::join_paths(path).unwrap());
    shell
}

/// What it shows on a terminal of so many columns, without colours; where none is to be had, what it prints.
pub(crate) fn on_terminal(arguments: &str, columns: usize) -> String {
    if cfg!(not(target_os = "linux")) {
        return printed(&words(arguments));
    }
    let program = env!("CARGO_BIN_EXE_curveto");
    let typed = format!("stty rows 50 cols {columns} && exec '{program}' {arguments}");
    let mut script = Command::new("script");
    script.args(["-qec", &typed, "/dev/null"]);
    let variables = [("NO_COLOR", "1"), ("TERM", "dumb")];
    let output = script.envs(variables).env_remove("COLUMNS").output();
    let output = output.unwrap();
    assert!(output.status.success(), "curveto {arguments}");
    String::from_utf8(output.stdout).unwrap().replace('\r', "")
}

/// A value of JSON that is a number.
pub(crate) fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

/// Whether a golden file holds this; where those are written anew, it does from now on.
pub(crate) fn is_golden(file: &Path, text: &[u8]) -> bool {
    if env::var_os("CURVETO_GOLDEN").is_some() {
        fs::write(file, text).unwrap();
    }
    fs::read(file).is_ok_and(|kept| kept == text)
}
