//! What is wrong with text that svgtypes does not read, in words that say what to do.

/// Why a text is refused, in which `expected` is what could stand at that place.
pub(super) fn refusal(error: &svgtypes::Error, expected: &str) -> String {
    use svgtypes::Error as Theirs;
    match error {
        Theirs::UnexpectedEndOfStream => format!("it ends where {expected} should follow"),
        Theirs::UnexpectedData(at)
        | Theirs::InvalidNumber(at)
        | Theirs::InvalidChar(_, at)
        | Theirs::InvalidString(_, at) => format!("{expected} is expected at character {at}"),
        _ => format!("{expected} is expected"),
    }
}
