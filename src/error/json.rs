//! Why a text is not the JSON that is expected.

/// What serde says, and what we say in its place.
const WORDS: [(&str, &str); 17] = [
    ("EOF while parsing", "the JSON ends within"),
    ("key must be a string", "a key in double quotes is expected"),
    ("expected `,` or `}`", "a comma or } is expected"),
    ("expected `,` or `]`", "a comma or ] is expected"),
    ("expected `:`", "a colon is expected"),
    ("expected value", "a value is expected"),
    ("expected ident", "true, false or null is expected"),
    ("trailing characters", "nothing more is expected here"),
    (
        "trailing comma",
        "a key or a value is expected after the comma",
    ),
    ("invalid number", "not a number"),
    ("invalid escape", "no escape that JSON knows"),
    ("unexpected end of hex escape", "half a surrogate pair"),
    (
        "lone leading surrogate in hex escape",
        "half a surrogate pair",
    ),
    ("number out of range", "the number is too large"),
    (
        "recursion limit exceeded",
        "too many brackets stand within one another",
    ),
    (
        "control character (\\u0000-\\u001F) found while parsing a string",
        "a control character within a string",
    ),
    (
        "data did not match any variant of untagged enum ToleranceValue",
        r#"a tolerance is a number, or a text like "1%""#,
    ),
];

/// What serde calls a value, and what we call it.
const KINDS: [(&str, &str); 6] = [
    ("map", "an object"),
    ("sequence", "an array"),
    ("boolean ", ""),
    ("integer ", "the number "),
    ("floating point ", "the number "),
    ("string ", "the text "),
];

/// Where in its line the reader of JSON stopped, in characters from 1.
///
/// It counts bytes, and of a value of the wrong kind it may name the place before: then the value's own is the one.
#[must_use]
pub fn column(text: &str, error: &serde_json::Error) -> usize {
    let line = text.lines().nth(error.line().saturating_sub(1));
    let line = line.unwrap_or_default().char_indices();
    let is_read = |at: usize, c: char| at + c.len_utf8() < error.column();
    let is_before = |c: char| error.is_data() && (c.is_whitespace() || ":,".contains(c));
    line.take_while(|&(at, c)| is_read(at, c) || is_before(c))
        .count()
        + 1
}

/// What the reader of JSON says, in words of ours and without the names of Rust's types; where is not said.
#[must_use]
pub fn in_plain_words(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let why = text.split(" at line ").next().unwrap_or(&text);
    let expected = |what: &str| match what {
        "f64" => "a number".to_owned(),
        "usize" => "a whole number, at least 0,".to_owned(),
        "a sequence" => "an array".to_owned(),
        other => other.to_owned(),
    };
    let quoted = |text: &str| text.replace('`', "'");
    if let Some((field, fields)) = why
        .strip_prefix("unknown field ")
        .and_then(|rest| rest.split_once(", expected "))
    {
        let fields = fields.strip_prefix("one of ").unwrap_or(fields);
        return format!(
            "there is no key {}, but {}",
            quoted(field),
            fields.replace('`', "")
        );
    }
    if let Some(field) = why.strip_prefix("missing field ") {
        return format!("the key {} is missing", quoted(field));
    }
    if let Some(field) = why.strip_prefix("duplicate field ") {
        return format!("the key {} stands twice", quoted(field));
    }
    let found = ["invalid type: ", "invalid value: ", "invalid length "]
        .iter()
        .find_map(|prefix| why.strip_prefix(prefix));
    if let Some((found, wanted)) = found.and_then(|rest| rest.split_once(", expected ")) {
        let found = if why.starts_with("invalid length ") {
            format!("an array of length {found}")
        } else {
            KINDS
                .iter()
                .find_map(|(theirs, ours)| Some(format!("{ours}{}", found.strip_prefix(theirs)?)))
                .map_or_else(|| quoted(found), |found| found.replace('`', ""))
        };
        return format!("{found} where {} is expected", expected(wanted));
    }
    let ours = WORDS.iter().find(|(theirs, _)| why.starts_with(theirs));
    ours.map_or_else(
        || why.to_owned(),
        |(theirs, words)| why.replacen(theirs, words, 1),
    )
}
