//! What to do about words that the command line does not know: flags of other tools, values in the wrong place.

pub(crate) mod called;
mod foreign;
mod word;

use std::path::Path;

use clap::builder::PossibleValue;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ValueHint};

use called::Called;
use curveto::path::shortened;
use curveto::write::Image;
use foreign::ForeignFlags;

use super::args::hint_of_number;
use super::remedies::in_a_sentence;

/// What would help, where there is something to say. `words` are those of the command line, the program left out.
pub(crate) fn hint(error: &clap::Error, words: &[String]) -> Option<String> {
    let command = words.first().map_or("", String::as_str);
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    match error.kind() {
        ErrorKind::InvalidSubcommand => of_command(text(ContextKind::InvalidSubcommand)?, command),
        ErrorKind::UnknownArgument => of_argument(text(ContextKind::InvalidArg)?, words),
        ErrorKind::ValueValidation => of_value(
            text(ContextKind::InvalidValue)?,
            text(ContextKind::InvalidArg)?,
        ),
        ErrorKind::TooManyValues | ErrorKind::WrongNumberOfValues => {
            of_values(words, command).map(str::to_owned)
        }
        ErrorKind::InvalidValue => of_choice(
            text(ContextKind::InvalidValue)?,
            text(ContextKind::InvalidArg)?,
            command,
        ),
        ErrorKind::ArgumentConflict if has(words, "-n") && has(words, "-t") => Some(
            "-n gives the number of segments, -t finds the fewest: take one of them".to_owned(),
        ),
        ErrorKind::ArgumentConflict if has(words, "-n") && has(words, "--joints") => Some(
            "-n gives a number of segments, --joints the angles where they meet: take one of them"
                .to_owned(),
        ),
        ErrorKind::ArgumentConflict if has(words, "--sweep") && has(words, "--reverse") => {
            Some("a negative sweep runs the other way: --sweep=-90".to_owned())
        }
        ErrorKind::ArgumentConflict if has(words, "--handle") && has(words, "-m") => Some(
            "--handle gives the length of the handles, -m a method that has it: take one of them"
                .to_owned(),
        ),
        ErrorKind::ArgumentConflict => {
            // Only where a word stands that could be a shape.
            error.get(ContextKind::InvalidSubcommand)?;
            of_measure(words)
        }
        ErrorKind::InvalidUtf8 => {
            Some("names of files may be of any bytes, all other words are text in UTF-8".to_owned())
        }
        ErrorKind::MissingRequiredArgument => of_missing(words, command, error),
        _ => None,
    }
}

/// The commands that others take for a shape.
const SHAPES: [&str; 4] = ["circle", "ellipse", "arc", "conic"];

/// The methods that serve no other number of segments.
const QUARTERS_ONLY: [&str; 2] = ["lancaster-drawellipse", "minimax-ellipse-free"];

/// What is told where something is missing: an example, mostly.
fn of_missing(words: &[String], command: &str, error: &clap::Error) -> Option<String> {
    let missing = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::Strings(missing)) => missing.as_slice(),
        _ => &[],
    };
    let hint = match command {
        _ if has(words, "--adaptive") && QUARTERS_ONLY.iter().any(|id| has(words, id)) => {
            "this method serves quarters only: leave --adaptive out, or take -m minimax -n 5 --adaptive"
        }
        _ if has(words, "--adaptive") => "it goes with a number of segments: -n 5 --adaptive",
        _ if has(words, "--quantity") => {
            "it says what a plot shows: --plot error.svg --quantity error"
        }
        "measure" if missing.iter().any(|flag| flag.starts_with("--plot")) => {
            "it says how large a plot is: --plot error.svg --size 400x300"
        }
        "circle" | "sphere" => return Some(format!("for example: curveto {command} 50")),
        "ellipse" => "for example: curveto ellipse 30 20",
        "arc" if has(words, "--large") => {
            "--large goes with --from, --to and --radius; --start and --end tell by themselves how far an arc runs"
        }
        "arc" if missing.iter().all(|flag| flag.starts_with("--")) => {
            "two ends are --from and --to: curveto arc --from 0,0 --to 10,0 --bulge 1"
        }
        "arc" => {
            "the radius stands alone: curveto arc 50 --start 0 --end 90; --radius goes with --from and --to"
        }
        "path" => "for example: curveto path 'M0 0A5 5 0 0 1 10 0'; - reads standard input",
        "measure" => "for example: curveto measure circle 50",
        "explore" => "for example: curveto explore circle 50 -o page.html",
        "conic" => "for example: curveto conic --from 0,0 --control 5,8 --to 10,0 --weight 0.7",
        "spline" => "for example: curveto spline --points '0,0 5,8 10,0'",
        "diff" => "for example: curveto diff golden.svg new.svg -t 0.001",
        "completions" => "for example: curveto completions bash",
        _ => return None,
    };
    Some(hint.to_owned())
}

fn of_command(word: &str, command: &str) -> Option<String> {
    if command == "measure" {
        return Some("a file has a flag: --file drawing.svg, or --path for path data".to_owned());
    }
    if word.parse::<f64>().is_ok() {
        return Some(format!("name a shape first: curveto circle {word}"));
    }
    if is_path_data(word) {
        return Some(format!("path data has a command: curveto path '{word}'"));
    }
    foreign::command(word).map(str::to_owned)
}

/// What is told of a word that the command does not take.
pub(super) fn of_argument(argument: &str, words: &[String]) -> Option<String> {
    // A flag may stand before its value, or one letter before others, in the same word.
    let begins = |word: &String| argument.starts_with('-') && word.starts_with(argument);
    let at = words
        .iter()
        .position(|word| word == argument || begins(word));
    let (before, after) = words.split_at(at.unwrap_or(words.len()));
    let called = Called::of(before);
    if called.is_one_of(&["man", "help"]) {
        return Some(of_page(argument));
    }
    if !argument.starts_with('-') {
        return word::hint(argument, before, words, &called);
    }
    if called.names.is_empty() {
        // A flag before the command is as one after it.
        let called = Called::of(after);
        return of_early_flag(argument, &called).or_else(|| of_flag(argument, &called));
    }
    of_dashed_name(before, after, &called).or_else(|| of_flag(argument, &called))
}

/// What is told of a flag that the command does not have.
pub(super) fn of_flag(flag: &str, called: &Called) -> Option<String> {
    let known = |foreign: &ForeignFlags| {
        let is_for = foreign
            .commands()
            .is_none_or(|commands| called.is_one_of(&commands));
        is_for && foreign.flags().any(|known| known == flag) && called.fits(foreign.hint)
    };
    of_format(flag, called).or_else(|| {
        ForeignFlags::all()
            .find(known)
            .map(|found| found.hint.to_owned())
    })
}

/// What `man` and `help` are told: a page has no other name than its command.
fn of_page(argument: &str) -> String {
    let is_command = !Called::of(&[argument]).names.is_empty();
    let one = if is_command { argument } else { "circle" };
    format!(
        "'curveto {one} --help' shows {} page; 'curveto man --out-dir DIR' writes all",
        if is_command { "that" } else { "its" }
    )
}

/// What is told of the name of a file that begins with a dash.
fn of_dashed_name(before: &[String], after: &[String], called: &Called) -> Option<String> {
    let name = after.first().filter(|word| word.len() > 2)?;
    let ending = Path::new(name).extension()?.to_str()?;
    let is_name = ending.starts_with(char::is_alphabetic) || Path::new(name).exists();
    if !is_name || name.contains('=') {
        return None;
    }
    let takes_file = |arg: &Arg| matches!(arg.get_value_hint(), ValueHint::AnyPath);
    let flag = before.last().filter(|flag| flag.starts_with('-'));
    match flag.and_then(|flag| Some((flag, called.flag(flag)?))) {
        Some((flag, arg)) if takes_file(arg) => Some(format!(
            "a name that begins with a dash is given as {flag} ./{name}"
        )),
        _ => {
            called.command.get_positionals().any(takes_file).then(|| {
                format!("a name that begins with a dash is given as ./{name}, or after --")
            })
        }
    }
}

/// What is told of the name of a format that is taken for a flag.
fn of_format(argument: &str, called: &Called) -> Option<String> {
    const FORMATS: [&str; 12] = [
        "svg", "json", "png", "ps", "eps", "pdf", "dxf", "tikz", "csv", "html", "gcode", "type",
    ];
    let name = argument.strip_prefix("--")?;
    if !FORMATS.contains(&name) {
        return None;
    }
    let values = called.flag("--format")?.get_possible_values();
    let values = values.iter().filter(|value| !value.is_hide_set());
    let values: Vec<&str> = values.map(PossibleValue::get_name).collect();
    let is_picture = Image::ALL.iter().any(|image| image.name() == name);
    Some(if values.contains(&name) {
        format!("-f names the format: -f {name}")
    } else if is_picture && called.flag("--plot").is_some() {
        format!("a plot has a flag: --plot error.{name}")
    } else {
        format!("-f names the format: {}", in_a_sentence(&values, "or"))
    })
}

/// What is told of a flag before the command that has it.
fn of_early_flag(flag: &str, called: &Called) -> Option<String> {
    let (command, _) = (called.names.first()?, called.flag(flag)?);
    Some(format!(
        "options come after the command: curveto {command} ... {flag}"
    ))
}

/// What a value is told that is almost a number, or two of them with commas in them.
fn of_value(value: &str, argument: &str) -> Option<String> {
    let is_number = value.parse::<f64>().is_ok();
    if is_path_data(value) && argument.contains("RADIUS") {
        return Some(format!(
            "path data has a flag, or its command: curveto arc --svg '{0}', curveto path '{0}'",
            shortened(value)
        ));
    }
    if argument.starts_with("--ends") && ["closed", "periodic", "loop"].contains(&value) {
        return Some("--ends cyclic closes it".to_owned());
    }
    if argument.starts_with("--size") {
        let value = value.trim_end_matches(['x', 'X', '×']);
        let side = value.trim_end_matches(char::is_alphabetic);
        let both = side
            .parse::<f64>()
            .map(|_| format!("--size {side}x{value}"));
        return Some(both.unwrap_or_else(|_| {
            "width, x and height, then one unit for both, mm, cm, in or pt: --size 80x60mm"
                .to_owned()
        }));
    }
    if argument.starts_with("--diameters") {
        return Some("width, a comma and height: --diameters 60,40".to_owned());
    }
    if argument.starts_with("--against") {
        return Some(
            "the centre, then the radii: --against circle:0,0,50 or ellipse:0,0,50,30,15"
                .to_owned(),
        );
    }
    if argument.contains("<X,Y>") && is_number {
        let angles = "; angles are --start and --end";
        let is_end = argument.starts_with("--from") || argument.starts_with("--to");
        let more = if is_end { angles } else { "" };
        return Some(format!("both coordinates: {value},0{more}"));
    }
    if argument.contains("<X,Y>") && value.split_whitespace().count() == 2 {
        let pair: Vec<&str> = value.split_whitespace().collect();
        return Some(format!(
            "without a space: {}",
            pair.join(",").replace(",,", ",")
        ));
    }
    let ends = value.split_once("..").or_else(|| value.split_once('-'));
    if argument.contains("<N,N>")
        && ends.is_some_and(|(low, high)| [low, high].iter().all(|n| n.parse::<u32>().is_ok()))
    {
        return Some("a list names each: -n 2,3,4".to_owned());
    }
    if let Some(hint) = of_count_or_angle(value, argument) {
        return Some(hint.to_owned());
    }
    let [a, b, c, d] = value.split(',').collect::<Vec<_>>()[..] else {
        return hint_of_number(value.trim());
    };
    let pair = [a, b, c, d].iter().all(|part| part.parse::<f64>().is_ok());
    pair.then(|| format!("decimals come after a point: {a}.{b},{c}.{d}"))
}

/// What is told of a value with a unit in the wrong place, or of a count with decimals.
fn of_count_or_angle(value: &str, argument: &str) -> Option<&'static str> {
    let has_unit =
        value.starts_with(|c: char| c.is_ascii_digit()) && value.ends_with(char::is_alphabetic);
    let takes = |names: &[&str]| names.iter().any(|name| argument.contains(name));
    if takes(&["ANGLE"]) && value.contains("degree") {
        return Some("without a unit it is in degrees: 60, or 60deg");
    }
    if has_unit && takes(&["ANGLE"]) {
        return Some("angles take the units deg, rad, grad and turn; without one they are degrees");
    }
    if has_unit && takes(&["<N>", "<N,N>", "<P>"]) {
        return Some("numbers of things have no unit");
    }
    let has_decimals =
        value.parse::<i128>().is_err() && value.replace(',', ".").parse::<f64>().is_ok();
    (takes(&["<N>", "<P>"]) && has_decimals).then_some("it is a whole number, without decimals")
}

/// What `measure` is told where words that belong to a shape stand outside it.
fn of_measure(words: &[String]) -> Option<String> {
    let is_shape = |word: &&String| SHAPES.contains(&word.as_str());
    if let Some(shape) = words.iter().find(is_shape) {
        let flag = words.iter().find(|word| word.starts_with('-'))?;
        let flag = flag.split('=').next().unwrap_or_default();
        let measured = Called::of(&["measure", shape]);
        return Some(if measured.flag(flag).is_some() {
            format!("the shape comes first: curveto measure {shape} ... {flag}")
        } else {
            format!(
                "one or the other: 'curveto measure {shape} ...' or 'curveto measure {flag} ...'"
            )
        });
    }
    let has_path_alone = has(words, "--path") && !has(words, "--file");
    has_path_alone.then(|| "put the path data in quotes: --path 'M0 0C0 5 5 10 10 10'".to_owned())
}

/// What is told where a value is none of those that can be.
fn of_choice(value: &str, argument: &str, command: &str) -> Option<String> {
    if argument == "<SHELL>" {
        // A name that looks like its own is no other's.
        return Some("for example: curveto completions bash".to_owned());
    }
    let is_picture = Image::ALL.iter().any(|image| image.name() == value);
    (command == "measure" && argument.starts_with("--format") && is_picture)
        .then(|| format!("a plot has a flag: --plot error.{value}"))
}

fn has(words: &[String], flag: &str) -> bool {
    words.iter().any(|word| word.starts_with(flag))
}

/// Whether a word looks like path data, and not like a name.
fn is_path_data(word: &str) -> bool {
    let rest = word.strip_prefix(['M', 'm']);
    rest.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit() || " -.".contains(c)))
}

fn of_values(words: &[String], command: &str) -> Option<&'static str> {
    let has = |flag: &str| has(words, flag);
    // Shapes have the same words in `measure` and `explore`.
    let command = match words.get(1) {
        Some(shape) if matches!(command, "measure" | "explore") => shape,
        _ => command,
    };
    match command {
        "arc" if has("--svg") || words.iter().any(|word| is_path_data(word)) => {
            Some("put the path data in quotes: --svg 'M0 0A25 25 0 0 1 50 50'")
        }
        "arc" if has("--through") => {
            Some("three points: the start, one on the arc and the end: --through 0,0 5,5 10,0")
        }
        "arc" => Some("angles have flags: curveto arc 50 --start 0 --end 90"),
        "ellipse" => Some(
            "the two radii stand apart: curveto ellipse 30 20; --diameters 60,40 takes the diameters",
        ),
        _ => None,
    }
}
