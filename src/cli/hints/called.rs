//! The command that was called, as the parser declares it: a hint may name a flag only where the command has it.

use clap::{Arg, Command, CommandFactory as _};

use crate::cli::args::Cli;

/// A command with the words that lead to it, such as `measure circle`.
pub(crate) struct Called {
    pub(crate) names: Vec<String>,
    pub(crate) command: Command,
}

impl Called {
    /// The command that these words call.
    pub(crate) fn of(words: &[impl AsRef<str>]) -> Self {
        let mut command = Cli::command();
        command.build();
        let names = Vec::new();
        let mut called = Self { names, command };
        let mut is_value = false;
        for word in words.iter().map(AsRef::as_ref) {
            if core::mem::take(&mut is_value) {
                continue;
            }
            if let Some(inner) = called.command.find_subcommand(word) {
                called.names.push(inner.get_name().to_owned());
                called.command = inner.clone();
            } else {
                let takes_value = |arg: &Arg| arg.get_action().takes_values();
                is_value = !word.contains('=') && called.flag(word).is_some_and(takes_value);
            }
        }
        called
    }

    /// Whether one of these names leads to it; `curveto` is the program itself.
    pub(crate) fn is_one_of(&self, names: &[&str]) -> bool {
        let is_called = |name: &&str| self.names.iter().any(|own| own == name);
        names.iter().any(is_called) || self.names.is_empty() && names.contains(&"curveto")
    }

    /// Its flag that is written so, with or without a value.
    pub(crate) fn flag(&self, word: &str) -> Option<&Arg> {
        let word = word.split('=').next().unwrap_or_default();
        let is_long = |arg: &Arg, long: &str| {
            let mut names = arg.get_long_and_visible_aliases().unwrap_or_default();
            names.extend(arg.get_all_aliases().unwrap_or_default());
            names.contains(&long)
        };
        let is_it = |arg: &&Arg| {
            let short = arg.get_short().map(|letter| format!("-{letter}"));
            let long = word.strip_prefix("--");
            short.as_deref() == Some(word) || long.is_some_and(|long| is_long(arg, long))
        };
        let shown = |arg: &&Arg| !arg.is_hide_set();
        self.command.get_arguments().filter(shown).find(is_it)
    }

    /// Whether it has every flag that a text names, but for those of commands that the text calls itself.
    pub(crate) fn fits(&self, text: &str) -> bool {
        let mut named = flags_named(text).into_iter();
        named.all(|(owner, flag)| owner.is_some() || self.flag(flag).is_some())
    }

    /// A hint without the clauses that do not fit.
    pub(crate) fn fitting(&self, hint: &str) -> Option<String> {
        let clauses = hint.split("; ").filter(|clause| self.fits(clause));
        let clauses: Vec<&str> = clauses.collect();
        (!clauses.is_empty()).then(|| clauses.join("; "))
    }
}

/// The flags in a text, each with the command that is called there: `curveto COMMAND ... --flag`, up to a semicolon or a closing quote.
fn flags_named(text: &str) -> Vec<(Option<&str>, &str)> {
    let mut found = Vec::new();
    let (mut owner, mut before) = (None, "");
    for word in text.split_whitespace() {
        let bare = word.trim_matches(|c| "'\",;:()".contains(c));
        let name = bare.trim_start_matches('-');
        let is_flag = match bare.len() - name.len() {
            1 => name.len() == 1 && name.starts_with(char::is_alphabetic),
            2 => name.starts_with(char::is_alphabetic),
            _ => false,
        };
        if is_flag {
            found.push((owner, bare));
        }
        if before == "curveto" {
            owner = Some(bare);
        }
        if word.trim_end_matches(',').ends_with(['\'', ';']) {
            owner = None;
        }
        before = bare;
    }
    found
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::foreign::ForeignFlags;
    use super::super::of_flag;
    use super::*;
    use clap::error::ErrorKind;

    /// Every command and every shape of one.
    fn commands() -> Vec<Vec<String>> {
        let mut found = vec![Vec::new()];
        let program = Called::of(&[""]).command;
        for command in program.get_subcommands() {
            let name = command.get_name().to_owned();
            let inner = command.get_subcommands().filter(|_| name != "help");
            let shapes = inner.map(|shape| vec![name.clone(), shape.get_name().to_owned()]);
            found.extend(shapes.filter(|names| names[1] != "help"));
            found.push(vec![name]);
        }
        found
    }

    /// Whether the parser takes a flag for one of a command.
    fn takes(names: &[&str], flag: &str) -> bool {
        let words = [&["curveto"], names, &[flag]].concat();
        let parsed = Cli::command().try_get_matches_from(words);
        parsed.map_or_else(|error| error.kind() != ErrorKind::UnknownArgument, |_| true)
    }

    #[test]
    fn a_hint_names_flags_that_the_command_takes() {
        let formats = ["--svg", "--json", "--png", "--csv", "--html", "--type"];
        let all = ForeignFlags::all().flat_map(ForeignFlags::flags);
        let all: BTreeSet<&str> = all.chain(formats).collect();
        let mut typed = BTreeSet::new();
        let mut hints = 0;
        for names in commands() {
            let called = Called::of(&names);
            for flag in &all {
                if called.flag(flag).is_some() {
                    continue;
                }
                let Some(hint) = of_flag(flag, &called) else {
                    continue;
                };
                hints += 1;
                for (owner, named) in flags_named(&hint) {
                    let names = owner.map_or_else(|| names.join(" "), str::to_owned);
                    typed.insert((names, named.to_owned()));
                }
            }
        }
        assert!(hints > 500 && typed.len() > 100, "{hints} {}", typed.len());
        for (names, flag) in typed {
            let names: Vec<&str> = names.split_whitespace().collect();
            assert!(takes(&names, &flag), "{names:?} {flag}");
        }
    }

    #[test]
    fn flags_in_a_hint_belong_to_the_command_that_is_called_there() {
        let hint =
            "-n 4, as 'curveto arc 5 --sweep 9', or -f; curveto path - --to arcs; --k -3 x-y --";
        let found = flags_named(hint);
        let expected = [
            (None, "-n"),
            (Some("arc"), "--sweep"),
            (None, "-f"),
            (Some("path"), "--to"),
            (None, "--k"),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn what_does_not_fit_is_left_out_clause_by_clause() {
        let hint = "numbers have no unit: 5; --size 80x60mm gives a picture its size";
        let of = |name: &str| Called::of(&[name]).fitting(hint);
        assert_eq!(of("convert").as_deref(), Some("numbers have no unit: 5"));
        assert_eq!(of("circle").as_deref(), Some(hint));
        assert_eq!(Called::of(&["path"]).fitting("--reverse turns it"), None);
    }
}
