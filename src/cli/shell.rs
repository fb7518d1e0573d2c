//! `completions` and `man`.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use anyhow::Context;
use clap::{Command, CommandFactory};

use super::args::{Cli, CompletionsArgs, ManArgs};
use super::failure::Failure;
use super::output::OutputTarget;
use super::{Outcome, examples};

pub(super) fn completions(args: &CompletionsArgs) -> Outcome {
    let script = super::completions::script(args.shell);
    OutputTarget::Stdout.write(script.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn man(args: &ManArgs) -> Outcome {
    // Nobody needs a page of the word help.
    let mut program = Cli::command().disable_help_subcommand(true);
    program.build();
    match &args.out_dir {
        Some(folder) => {
            fs::create_dir_all(folder)
                .with_context(|| format!("cannot make the folder {}", folder.display()))?;
            write_page(&program, program.get_name(), folder)?;
            for command in program.get_subcommands() {
                let topic = command.get_name();
                write_page(command, topic, folder)?;
                for inner in command.get_subcommands() {
                    write_page(inner, topic, folder)?;
                }
            }
        }
        None => OutputTarget::Stdout.write(&page(&program, program.get_name())?)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes the page of a command, whose examples are those of a topic.
fn write_page(command: &Command, topic: &str, folder: &Path) -> Result<(), Failure> {
    let name = command.get_display_name().unwrap_or(command.get_name());
    let path = folder.join(format!("{name}.1"));
    OutputTarget::File(path).write(&page(command, topic)?)
}

/// A manual page: what the long help of a command says.
fn page(command: &Command, topic: &str) -> Result<Vec<u8>, Failure> {
    // The page is no short help: it tells of every option.
    let whole = command.clone().mut_args(|arg| arg.hide_short_help(false));
    let man = clap_mangen::Man::new(whole).source("curveto");
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    let notes = command.get_after_long_help().map(ToString::to_string);
    let notes = notes.unwrap_or_default();
    let notes = notes.strip_suffix(&examples::of(topic)).unwrap_or(&notes);
    if !notes.is_empty() {
        let heading = if topic == "batch" { "LINES" } else { "NOTES" };
        let notes = notes.replace(examples::BLANK, " ");
        page.extend(section(heading, notes.trim_end()).bytes());
    }
    let found = examples::find(topic);
    if let Some((_, codes)) = found {
        page.extend(exit_status(codes).bytes());
    }
    man.render_version_section(&mut page)?;
    if let Some((examples, _)) = found {
        let examples = format!("  {}", examples.join("\n  "));
        page.extend(section("EXAMPLES", &examples).bytes());
    }
    Ok(page)
}

/// A section of a page. Its indented lines are to be copied: they stay as they are.
fn section(heading: &str, text: &str) -> String {
    let mut out = format!(".SH {heading}\n");
    let mut is_code = false;
    for line in text.lines() {
        if line.starts_with("  ") != is_code {
            is_code = !is_code;
            out += if is_code {
                ".PP\n.RS 4\n.nf\n"
            } else {
                ".fi\n.RE\n.PP\n"
            };
        }
        let line = escaped(line.trim_start());
        out += if line.is_empty() { ".PP" } else { &line };
        out.push('\n');
    }
    if is_code {
        out += ".fi\n.RE\n";
    }
    out
}

/// What each exit code means, in a list.
fn exit_status(codes: &str) -> String {
    let mut out = ".SH EXIT STATUS\n".to_owned();
    for item in codes.trim_end_matches('.').split("; ") {
        let (code, meaning) = item.split_at(item.find(char::is_alphabetic).unwrap_or(0));
        out.extend([".TP\n.B ", code.trim_end(), "\n", &escaped(meaning), "\n"]);
    }
    out
}

/// A line of text with what roff would take for its own.
fn escaped(line: &str) -> String {
    let mut out = String::new();
    if line.starts_with('.') {
        out += "\\&";
    }
    for letter in line.chars() {
        match letter {
            '\\' => out += "\\e",
            '-' => out += "\\-",
            '\'' => out += "\\(aq",
            '^' => out += "\\(ha",
            '~' => out += "\\(ti",
            _ => out.push(letter),
        }
    }
    out
}
