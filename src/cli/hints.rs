//! What to do about words that the command line does not know: flags of other tools, values in the wrong place.

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::args::hint_of_number;

/// Flags that people try, the commands that they try them on (all where there is none), and what serves instead.
const FLAGS: [(&[&str], &[&str], &str); 29] = [
    (
        &[
            "--clockwise",
            "--cw",
            "--ccw",
            "--counterclockwise",
            "--counter-clockwise",
            "--anticlockwise",
            "--anti-clockwise",
        ],
        &[],
        "--reverse runs the other way round; positive angles turn from +x towards +y, clockwise on an SVG canvas",
    ),
    (
        &["--radius", "-r", "--r"],
        &["circle", "sphere"],
        "the radius stands alone: curveto circle 50",
    ),
    (
        &["--radius", "--radii", "--rx", "--ry", "-r"],
        &["ellipse"],
        "the radii stand alone: curveto ellipse 30 20",
    ),
    (
        &["-j", "--jobs"],
        &[],
        "one shape takes one thread; batch and convert take -j",
    ),
    (
        &["-i", "--inplace"],
        &["convert"],
        "--in-place replaces each file",
    ),
    (
        &["--dry-run", "-d", "--dryrun"],
        &["convert"],
        "--check writes nothing and lists the files with something to do",
    ),
    (
        &["-f", "--format"],
        &["procset"],
        "it prints PostScript and nothing else",
    ),
    (
        &["--cx", "--cy", "-c"],
        &[],
        "--center X,Y says where the centre lies",
    ),
    (
        &["--width", "--height", "-w", "-h"],
        &[],
        "--size WxH sets the size of a picture, --stroke-width that of its lines",
    ),
    (
        &["--color", "--colour"],
        &[],
        "--stroke colours the line, --fill the inside",
    ),
    (
        &["--decimals", "--digits", "--round"],
        &[],
        "-p sets the decimals",
    ),
    (
        &[
            "--circle",
            "--ellipse",
            "--arc",
            "--path",
            "--batch",
            "--convert",
        ],
        &[],
        "commands have no dashes: curveto circle 50",
    ),
    (
        &["--kappa", "--magic", "--k", "-k"],
        &[],
        "--handle K is the length of the handles on the unit circle; -m names a method",
    ),
    (
        &["--flatness", "--error", "--epsilon", "--accuracy", "--tol"],
        &[],
        "-t sets the tolerance, how far a curve may stray",
    ),
    (
        &["--steps", "--count", "--points", "--pieces", "--parts"],
        &[],
        "-n sets the number of segments",
    ),
    (
        &[
            "--svg", "--json", "--png", "--ps", "--eps", "--pdf", "--dxf", "--tikz", "--type",
        ],
        &[],
        "-f names the format, or the extension of -o does: -f svg, -o circle.svg",
    ),
    (
        &[
            "--end",
            "--sweep",
            "--from",
            "--to",
            "--angle",
            "--start-angle",
            "--end-angle",
        ],
        &["circle", "ellipse"],
        "a part of one is an arc: curveto arc 50 --start 0 --end 90",
    ),
    (
        &["--start-angle", "--end-angle", "--angle"],
        &["arc"],
        "angles have flags: curveto arc 50 --start 0 --end 90",
    ),
    (
        &["--rotation", "--rotate", "--angle"],
        &["circle", "sphere"],
        "--start says where the first joint of a circle lies, --view how a sphere is seen",
    ),
    (
        &["--phi", "--tilt"],
        &["ellipse", "arc"],
        "--rotation turns an ellipse",
    ),
    (
        &["--closed", "--close"],
        &[],
        "whole turns are closed by themselves; --open leaves the closing operator out",
    ),
    (&["--silent"], &[], "-q silences notes"),
    (
        &["--quadratic", "--quadratics", "--cubic"],
        &[],
        "-m names a method: quadratic-minimax draws quadratics; 'curveto methods' lists them",
    ),
    (
        &["--radians", "--degrees", "--rad", "--deg"],
        &[],
        "angles take units: 90, 90deg, 1.57rad, 100grad, 0.25turn",
    ),
    (
        &["--scale", "--translate"],
        &[],
        "--transform 'scale(2) translate(5,0)' takes an SVG transform list",
    ),
    (
        &["-r", "-R", "--recursive"],
        &["convert"],
        "folders are walked by themselves",
    ),
    (
        &["--threads"],
        &["batch", "convert"],
        "-j sets the number of threads",
    ),
    (
        &["--input", "-i"],
        &["batch"],
        "the file stands alone: curveto batch shapes.txt",
    ),
    (
        &["--algorithm", "--list-methods", "--methods"],
        &[],
        "-m names a method; 'curveto methods' lists them",
    ),
];

/// Words that people try as commands.
const COMMANDS: [(&[&str], &str); 6] = [
    (
        &["list", "ls", "method"],
        "'curveto methods' lists the methods",
    ),
    (
        &[
            "line",
            "polygon",
            "polyline",
            "rect",
            "rectangle",
            "curve",
            "bezier",
            "pie",
            "sector",
        ],
        "'curveto path' draws any path data: curveto path 'M0 0L10 10'",
    ),
    (
        &["plot", "error"],
        "'curveto measure' and 'curveto compare' state and plot errors",
    ),
    (&["oval"], "an ellipse it is: curveto ellipse 30 20"),
    (&["draw", "shape"], "name the shape: curveto circle 50"),
    (&["version"], "'curveto --version' tells it"),
];

/// What would help, where there is something to say. `words` are those of the command line, the program left out.
pub(crate) fn hint(error: &clap::Error, words: &[String]) -> Option<String> {
    let command = words.first().map_or("", String::as_str);
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    match error.kind() {
        ErrorKind::InvalidSubcommand => of_command(text(ContextKind::InvalidSubcommand)?, command),
        ErrorKind::UnknownArgument => of_argument(text(ContextKind::InvalidArg)?, command),
        ErrorKind::ValueValidation => of_value(
            text(ContextKind::InvalidValue)?,
            text(ContextKind::InvalidArg)?,
        ),
        ErrorKind::TooManyValues | ErrorKind::WrongNumberOfValues => {
            of_values(words, command).map(str::to_owned)
        }
        ErrorKind::ArgumentConflict if command == "measure" => {
            // Flags of one curve that do not go together stand apart from words in the wrong place.
            let flag = text(ContextKind::InvalidArg).unwrap_or_default();
            let apart = ["--fit", "--against"]
                .iter()
                .any(|name| flag.starts_with(name));
            if apart { None } else { of_measure(words) }
        }
        ErrorKind::MissingRequiredArgument if words.iter().any(|word| word == "--adaptive") => {
            Some("it goes with a number of segments: -n 5 --adaptive".to_owned())
        }
        ErrorKind::MissingRequiredArgument if words.iter().any(|word| word == "--quantity") => {
            Some("it says what a plot shows: --plot error.svg --quantity error".to_owned())
        }
        ErrorKind::MissingRequiredArgument => match command {
            "circle" | "sphere" => Some(format!("for example: curveto {command} 50")),
            "ellipse" => Some("for example: curveto ellipse 30 20".to_owned()),
            "path" => Some(
                "for example: curveto path 'M0 0A5 5 0 0 1 10 0'; - reads standard input"
                    .to_owned(),
            ),
            "measure" => Some("for example: curveto measure circle 50".to_owned()),
            "explore" => Some("for example: curveto explore circle 50 -o page.html".to_owned()),
            "conic" => Some(
                "for example: curveto conic --from 0,0 --control 5,8 --to 10,0 --weight 0.7"
                    .to_owned(),
            ),
            "spline" => Some("for example: curveto spline --points '0,0 5,8 10,0'".to_owned()),
            "diff" => Some("for example: curveto diff golden.svg new.svg -t 0.001".to_owned()),
            "completions" => Some("for example: curveto completions bash".to_owned()),
            _ => None,
        },
        _ => None,
    }
}

fn of_command(word: &str, command: &str) -> Option<String> {
    if command == "measure" {
        return Some("a file has a flag: --file drawing.svg, or --path for path data".to_owned());
    }
    if word.parse::<f64>().is_ok() {
        return Some(format!("name a shape first: curveto circle {word}"));
    }
    if word.starts_with(['M', 'm']) && word.len() > 1 && !word.as_bytes()[1].is_ascii_alphabetic() {
        return Some(format!("path data has a command: curveto path '{word}'"));
    }
    let found = COMMANDS.iter().find(|(words, _)| words.contains(&word));
    found.map(|(_, hint)| (*hint).to_owned())
}

fn of_argument(argument: &str, command: &str) -> Option<String> {
    let known = |(flags, commands, _): &&(&[&str], &[&str], &str)| {
        flags.contains(&argument) && (commands.is_empty() || commands.contains(&command))
    };
    if let Some((_, _, hint)) = FLAGS.iter().find(known) {
        return Some((*hint).to_owned());
    }
    if command == "man" || command == "help" {
        return Some(format!(
            "'curveto {argument} --help' shows that page; 'curveto man --out-dir DIR' writes all"
        ));
    }
    let is_number = argument.parse::<f64>().is_ok();
    match command {
        "circle" if is_number => {
            Some("a circle has one radius; with two it is 'curveto ellipse RX RY'".to_owned())
        }
        _ if !argument.starts_with('-') => {
            Some("put words that belong together in quotes".to_owned())
        }
        _ => None,
    }
}

/// What a value is told that is almost a number, or two of them with commas in them.
fn of_value(value: &str, argument: &str) -> Option<String> {
    let is_number = value.parse::<f64>().is_ok();
    if argument.starts_with("--size") {
        let side = value.trim_end_matches(char::is_alphabetic);
        let both = side
            .parse::<f64>()
            .map(|_| format!("--size {side}x{value}"));
        return Some(both.unwrap_or_else(|_| {
            "width, x and height, with mm, cm, in or pt behind both: --size 80x60mm".to_owned()
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
        return Some(format!("both coordinates: {value},0"));
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
    let has_unit =
        value.starts_with(|c: char| c.is_ascii_digit()) && value.ends_with(char::is_alphabetic);
    if has_unit && argument.contains("ANGLE") {
        return Some(
            "angles take the units deg, rad, grad and turn; without one they are degrees"
                .to_owned(),
        );
    }
    if has_unit
        && ["<N>", "<N,N>", "<P>"]
            .iter()
            .any(|name| argument.contains(name))
    {
        return Some("numbers of things have no unit".to_owned());
    }
    let [a, b, c, d] = value.split(',').collect::<Vec<_>>()[..] else {
        return hint_of_number(value.trim());
    };
    let pair = [a, b, c, d].iter().all(|part| part.parse::<f64>().is_ok());
    pair.then(|| format!("decimals come after a point: {a}.{b},{c}.{d}"))
}

/// What `measure` is told where words that belong to a shape stand outside it.
fn of_measure(words: &[String]) -> Option<String> {
    const SHAPES: [&str; 4] = ["circle", "ellipse", "arc", "conic"];
    let is_shape = |word: &&String| SHAPES.contains(&word.as_str());
    if let Some(shape) = words.iter().find(is_shape) {
        let hint = format!("the shape comes first: curveto measure {shape} ... --plot error.svg");
        return Some(hint);
    }
    let has_path = words.iter().any(|word| word == "--path");
    has_path.then(|| "put the path data in quotes: --path 'M0 0C0 5 5 10 10 10'".to_owned())
}

fn of_values(words: &[String], command: &str) -> Option<&'static str> {
    let has = |flag: &str| words.iter().any(|word| word.starts_with(flag));
    match command {
        "arc" if has("--svg") => {
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
