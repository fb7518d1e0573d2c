//! Words that stand where the command takes none.

use clap::builder::ValueRange;
use curveto::Method;

use super::SHAPES;
use super::called::Called;

/// What is told of such a word, with those before it and all of them.
pub(super) fn hint(
    word: &str,
    before: &[String],
    words: &[String],
    called: &Called,
) -> Option<String> {
    let is_method = |word: &str| word.parse::<Method>().is_ok();
    let hint = match called.names.first().map_or("", String::as_str) {
        "compare" if SHAPES.contains(&word) => {
            "it compares on the circle of radius 1, or with --ellipse B on the ellipse of the semi-axes 1 and B; 'curveto explore circle 50' takes a shape"
        }
        "methods" => {
            "one method has a card: curveto methods minimax; 'curveto compare -m minimax,midpoint' compares several"
        }
        "completions" => "one shell at a time: curveto completions bash",
        "diff" => "two drawings are compared: curveto diff golden.svg new.svg",
        "spline" => "points have a flag: --points '0,0 5,8 10,0'",
        "path" => "path data is one word, in quotes: curveto path 'M0 0L10 10'",
        "batch" => "it reads one file, or standard input: cat a.txt b.txt | curveto batch",
        _ if is_method(word) && called.flag("-m").is_some() => {
            return Some(of_methods(words, called));
        }
        _ if SHAPES.contains(&word) => "one shape at a time",
        "sphere" if is_number(word) => "a sphere has one radius",
        _ if is_number(word) && called.is_one_of(&["circle"]) => {
            "a circle has one radius; with two it is 'curveto ellipse RX RY'"
        }
        _ if is_pair(word) => {
            "a point is one word, with a comma between its numbers: --center 1.5,2.5"
        }
        _ if follows_text(before, called) => "put words that belong together in quotes",
        _ => return None,
    };
    Some(hint.to_owned())
}

fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok()
}

fn is_pair(word: &str) -> bool {
    let pair = word.split_once(',');
    pair.is_some_and(|(x, y)| is_number(x) && is_number(y))
}

/// How all methods among the words are named: in one list where the command takes several.
fn of_methods(words: &[String], called: &Called) -> String {
    let methods = words.iter().filter(|word| word.parse::<Method>().is_ok());
    let methods: Vec<&str> = methods.map(String::as_str).collect();
    let value = called.flag("-m").and_then(|arg| arg.get_value_names());
    let takes_list = value.is_some_and(|names| names.iter().any(|name| name.contains(',')));
    if takes_list {
        format!(
            "-m names methods, with commas between them: -m {}",
            methods.join(",")
        )
    } else {
        format!(
            "-m names a method: -m {}",
            methods.first().unwrap_or(&"minimax")
        )
    }
}

/// Whether a flag with a text for its value stands just before, so that a next word may belong to that.
fn follows_text(before: &[String], called: &Called) -> bool {
    let [.., flag, value] = before else {
        return false;
    };
    let takes_text = called.flag(flag).is_some_and(|arg| {
        arg.get_num_args() == Some(ValueRange::SINGLE) && arg.get_possible_values().is_empty()
    });
    flag.starts_with('-') && takes_text && !value.split(',').all(is_number)
}
