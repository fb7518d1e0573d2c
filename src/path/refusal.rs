//! What is wrong with text that svgtypes does not read, in words that say what to do.

/// Why a text is refused, in which `expected` is what could stand at that place.
pub(super) fn refusal(error: &svgtypes::Error, text: &str, expected: &str) -> String {
    use svgtypes::Error as Theirs;
    match *error {
        Theirs::UnexpectedEndOfStream => format!("it ends where {expected} should follow"),
        Theirs::UnexpectedData(at)
        | Theirs::InvalidNumber(at)
        | Theirs::InvalidChar(_, at)
        | Theirs::InvalidString(_, at) => {
            let place = place(text, at);
            if is_number(text, at) {
                format!("the number is too large {place}")
            } else {
                format!("{expected} is expected {place}")
            }
        }
        _ => format!("{expected} is expected"),
    }
}

/// Where the character is that is counted from 1, with its line where there are several.
pub(crate) fn place(text: &str, at: usize) -> String {
    let (mut line, mut character) = (1, 1);
    for c in text.chars().take(at.saturating_sub(1)) {
        character += 1;
        if c == '\n' {
            (line, character) = (line + 1, 1);
        }
    }
    if line == 1 && !text.trim_end().contains('\n') {
        return format!("at character {at}");
    }
    format!("in line {line} at character {character}")
}

/// Whether a number begins there, which then has no place among those that are held.
fn is_number(text: &str, at: usize) -> bool {
    let start = text.char_indices().nth(at.saturating_sub(1));
    let rest = start.map_or("", |(start, _)| &text[start..]);
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
    rest[..end].parse().is_ok_and(f64::is_infinite)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_lines_and_characters() {
        assert_eq!(place("M0 0X", 5), "at character 5");
        assert_eq!(place("M0 0X\n", 5), "at character 5");
        assert_eq!(place("M0 0\né X", 8), "in line 2 at character 3");
        assert_eq!(place("X\nL1 1", 1), "in line 1 at character 1");
    }
}
