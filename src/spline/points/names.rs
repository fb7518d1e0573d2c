//! Names of columns.

/// What is said of a word in the first line that is neither number nor name.
pub(super) const NO_NAME: &str = "no name of a column: a letter, then letters, digits, _ and -, perhaps a unit in brackets; a # begins a comment";

/// A field without the quotes around it.
pub(super) fn unquoted(field: &str) -> &str {
    let inner = field.strip_prefix('"');
    let inner = inner.and_then(|rest| rest.strip_suffix('"'));
    inner.map_or(field, str::trim)
}

/// A name without quotes of either kind.
fn bare(field: &str) -> &str {
    let inner = field.strip_prefix('\'');
    let inner = inner.and_then(|rest| rest.strip_suffix('\''));
    inner.unwrap_or_else(|| unquoted(field))
}

/// What names are made of; accents may follow their letters.
fn is_made_of(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || ('\u{300}'..='\u{36f}').contains(&c)
}

/// Whether it has digits and is a number but for letters that look like some.
pub(super) fn is_mistyped(name: &str) -> bool {
    let meant = name.replace(['O', 'o'], "0").replace(['l', 'I'], "1");
    name.contains(|c: char| c.is_ascii_digit()) && meant.parse::<f64>().is_ok()
}

/// Whether a word, perhaps with a unit after it, names a column.
fn is_name(word: &str) -> bool {
    let end = word.find(['(', '[']).unwrap_or(word.len());
    let (name, unit) = word.split_at(end);
    let is_number = is_mistyped(name) || name.parse::<f64>().is_ok();
    let is_word =
        name.starts_with(char::is_alphabetic) && name.chars().all(|c| is_made_of(c) || c == '-');
    !is_number && is_word && (unit.is_empty() || is_unit(unit))
}

/// Whether a word is a unit in brackets.
pub(super) fn is_unit(word: &str) -> bool {
    let round = word
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'));
    let square = || word.strip_prefix('[')?.strip_suffix(']');
    let begins_well = |c: char| c.is_alphabetic() || "°%".contains(c);
    let unit = round.or_else(square);
    unit.is_some_and(|unit| unit.starts_with(begins_well) || unit.starts_with("1/"))
}

/// Whether a field of a first line names a column: a name, perhaps with more words after it, with commas too within quotes.
pub(super) fn names_column(field: &str) -> bool {
    let mut words = bare(field).split([' ', '\t', ',', ';']).map(bare);
    let goes_on = |word: &str| word.chars().all(is_made_of) || is_unit(word);
    words.next().is_some_and(is_name) && words.all(goes_on)
}
