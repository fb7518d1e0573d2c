//! Completion for shells. The scripts that clap writes know one word a flag; here lists with commas are taught to them, so that the
//! word after each comma is completed too.

use clap::{Arg, Command, CommandFactory as _};
use clap_complete::Shell;

use super::args::Cli;

/// A flag that takes a list of words, and the command that has it, without what that is a command of.
struct List {
    top: String,
    command: String,
    long: String,
    short: Option<char>,
    value: String,
}

/// The script for a shell.
pub(super) fn script(shell: Shell) -> String {
    let mut command = Cli::command();
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name, &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    let mut lists = Vec::new();
    for top in command.get_subcommands() {
        collect(top, top.get_name(), &mut lists);
    }
    match shell {
        Shell::Bash => script + &bash(&lists),
        Shell::Zsh => zsh(script, &lists),
        Shell::Fish => fish(&script, &lists),
        _ => script,
    }
}

fn collect(command: &Command, top: &str, lists: &mut Vec<List>) {
    // By the comma in its name the value of a list is told from a single one.
    let name = |arg: &Arg| Some(arg.get_value_names()?.first()?.to_string());
    let list = |arg| {
        name(arg)
            .filter(|name| name.contains(','))
            .map(|name| (arg, name))
    };
    for (arg, value) in command.get_arguments().filter_map(list) {
        if !arg.get_possible_values().is_empty() {
            lists.push(List {
                top: top.to_owned(),
                command: command.get_name().to_owned(),
                long: arg.get_long().unwrap_or_default().to_owned(),
                short: arg.get_short(),
                value,
            });
        }
    }
    for inner in command.get_subcommands() {
        collect(inner, top, lists);
    }
}

/// A function before clap's own, which sees only what stands after the last comma.
fn bash(lists: &[List]) -> String {
    let flags = |list: &List| {
        let short = list.short.map(|short| format!("\"{} -{short}\"", list.top));
        let long = format!("\"{} --{}\"", list.top, list.long);
        short.into_iter().chain([long])
    };
    let mut patterns: Vec<String> = lists.iter().flat_map(flags).collect();
    patterns.sort();
    patterns.dedup();
    format!(
        r#"
_curveto_list() {{
    local before="${{2%,*}},"
    case "${{COMP_WORDS[1]}} $3,$2" in
        {}) COMP_WORDS[COMP_CWORD]="${{2##*,}}"
            _curveto "$1" "${{2##*,}}" "$3"
            COMPREPLY=("${{COMPREPLY[@]/#/$before}}") ;;
        *) _curveto "$@" ;;
    esac
}}
complete -F _curveto_list -o bashdefault -o default curveto
"#,
        patterns
            .iter()
            .map(|pattern| format!("{pattern},*,*"))
            .collect::<Vec<_>>()
            .join("|")
    )
}

/// `:ID,ID:((a\:"first" b\:"second"))'` becomes `:ID,ID:_values -s , ID "a[first]" "b[second]"'`.
fn zsh(mut script: String, lists: &[List]) -> String {
    let mut names: Vec<&str> = lists.iter().map(|list| list.value.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    for name in names {
        for (open, close) in [("((", "))'"), ("(", ")'")] {
            let begin = format!(":{name}:{open}");
            let first = name.split(',').next().unwrap_or(name);
            let mut parts = script.split(&begin).map(str::to_owned);
            let before = parts.next().unwrap_or_default();
            let changed = parts.map(|part| {
                let (words, rest) = part.split_once(close).unwrap_or((&part, ""));
                let words: Vec<String> = if open == "((" {
                    words.lines().map(described).collect()
                } else {
                    words.split_whitespace().map(str::to_owned).collect()
                };
                let values = words.join(" ");
                format!(":{name}:_values -s , {first} {values}'{rest}")
            });
            script = core::iter::once(before).chain(changed).collect();
        }
    }
    script
}

/// `a\:"first"` as `"a[first]"`.
fn described(word: &str) -> String {
    match word.split_once("\\:\"") {
        Some((word, text)) => format!("\"{word}[{}]\"", text.trim_end_matches('"')),
        None => word.to_owned(),
    }
}

/// `-a "a\t'first'"`, a word a line, becomes `-a "(__fish_append , a\t'first' ...)"`.
fn fish(script: &str, lists: &[List]) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut lines = script.lines();
    while let Some(line) = lines.next() {
        let is_list = |list: &List| {
            line.contains(&format!("_subcommand {}", list.command))
                && line.contains(&format!(" -l {} ", list.long))
        };
        let split = line
            .split_once(" -a \"")
            .filter(|_| lists.iter().any(is_list));
        let Some((before, first)) = split else {
            out.push(line.to_owned());
            continue;
        };
        let mut words = first.to_owned();
        while !words.ends_with('"') {
            let Some(next) = lines.next() else { break };
            words.push(' ');
            words += next;
        }
        let words = words.trim_end_matches('"');
        out.push(format!("{before} -a \"(__fish_append , {words})\""));
    }
    out.join("\n") + "\n"
}
