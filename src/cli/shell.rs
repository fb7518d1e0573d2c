//! `completions` and `man`.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use anyhow::Context;
use clap::{Command, CommandFactory};

use super::Outcome;
use super::args::{Cli, CompletionsArgs, ManArgs};
use super::failure::Failure;
use super::output::{Target, write_file};

pub(super) fn completions(args: &CompletionsArgs) -> Outcome {
    let script = super::completions::script(args.shell);
    Target::Stdout.write(script.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn man(args: &ManArgs) -> Outcome {
    let mut command = Cli::command();
    command.build();
    match &args.out_dir {
        Some(folder) => write_pages(&command, folder)?,
        None => Target::Stdout.write(&page(&command)?)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes a page for the program and one for every command.
fn write_pages(program: &Command, folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder)
        .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    for command in std::iter::once(program).chain(
        program
            .get_subcommands()
            .filter(|command| command.get_name() != "help"),
    ) {
        let name = command
            .get_display_name()
            .unwrap_or(command.get_name())
            .to_owned();
        let path = folder.join(format!("{name}.1"));
        write_file(&path, &page(command)?)
            .with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// A manual page, which ends as the long help does.
fn page(command: &Command) -> Result<Vec<u8>, Failure> {
    let man = clap_mangen::Man::new(command.clone());
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    man.render_version_section(&mut page)?;
    let mut extra = Vec::new();
    man.render_extra_section(&mut extra)?;
    page.extend(
        String::from_utf8_lossy(&extra)
            .replacen(".SH EXTRA", ".SH EXAMPLES", 1)
            .bytes(),
    );
    Ok(page)
}
