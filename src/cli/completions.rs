//! Completion for shells. The scripts that clap writes know one word a flag; here lists with commas are taught to them, so that the
//! word after each comma is completed too, and bash offers files where a command takes one.

use clap::builder::PossibleValue;
use clap::{Arg, Command, CommandFactory as _, ValueHint};
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
        Shell::Bash => script + &bash(&lists, &takers_of_files(&command)),
        Shell::Zsh => zsh(script, &lists),
        Shell::Fish => fish(&script, &lists) + &fish_arguments(&command),
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

/// The commands of which a word without a flag may name a file.
fn takers_of_files(program: &Command) -> Vec<&str> {
    let takes = |arg: &Arg| matches!(arg.get_value_hint(), ValueHint::AnyPath);
    let commands = program.get_subcommands();
    let takers = commands.filter(|command| command.get_positionals().any(takes));
    takers.map(Command::get_name).collect()
}

/// A function before clap's own, which sees only what stands after the last comma, and the value of `--flag=value` as that of the flag:
/// bash gives it three words, or one where `=` is not in `COMP_WORDBREAKS`. Where it answers an empty word by flags though a file may stand
/// there, the answer is left to bash, which has the files.
fn bash(lists: &[List], takers_of_files: &[&str]) -> String {
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
    local word="$2" flag="$3" before=""
    if [[ "$flag" == "=" ]]; then
        flag="${{COMP_WORDS[COMP_CWORD-2]}}"
    elif [[ "${{COMP_WORDS[COMP_CWORD]}}" == "=" ]]; then
        word=""
    elif [[ "$word" == --*=* ]]; then
        flag="${{word%%=*}}"
        before="$flag="
        word="${{word#*=}}"
    fi
    case "${{COMP_WORDS[1]}} $flag,$word" in
        {}) before+="${{word%,*}},"
            word="${{word##*,}}" ;;
    esac
    COMP_WORDS[COMP_CWORD]="$word"
    _curveto "$1" "$word" "$flag"
    if [[ -z "$word" && "${{COMPREPLY[0]}}" == -* ]]; then
        case "${{COMP_WORDS[1]}}" in
            {}) COMPREPLY=() ;;
        esac
    fi
    COMPREPLY=("${{COMPREPLY[@]/#/$before}}")
}}
complete -F _curveto_list -o bashdefault -o default curveto
"#,
        patterns
            .iter()
            .map(|pattern| format!("{pattern},*,*"))
            .collect::<Vec<_>>()
            .join("|"),
        takers_of_files.join("|")
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

/// The words of arguments without a flag, such as a shell's name, which clap's script for fish leaves out.
fn fish_arguments(program: &Command) -> String {
    let quoted = |text: &str| text.replace('\\', "\\\\").replace('\'', "\\'");
    let mut out = String::new();
    for command in program.get_subcommands() {
        for argument in command.get_positionals() {
            let values = argument.get_possible_values();
            let word = |value: &PossibleValue| match value.get_help() {
                Some(help) => format!("{}\\t'{}'", value.get_name(), quoted(&help.to_string())),
                None => value.get_name().to_owned(),
            };
            let words: Vec<String> = values.iter().map(word).collect();
            if !words.is_empty() {
                let (name, words) = (command.get_name(), words.join("\n"));
                out.extend([
                    "complete -c curveto -n \"__fish_curveto_using_subcommand ",
                    name,
                    "\" -f -a \"",
                    &words,
                    "\"\n",
                ]);
            }
        }
    }
    out
}
