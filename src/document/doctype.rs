//! What an internal DTD subset declares: entities, which attribute values may use, and attribute defaults.

use std::collections::HashMap;

use core::cell::Cell;

/// How deep entities may refer to one another.
const MAX_DEPTH: usize = 16;

/// The declarations of a document's internal subset.
#[derive(Debug, Default)]
pub(super) struct Doctype<'a> {
    entities: HashMap<&'a str, Entity<'a>>,
    /// (element, text of the declaration) of each attribute list.
    pub(super) attribute_lists: Vec<(&'a str, &'a str)>,
    /// Whether declarations may exist that are not in the file.
    pub(super) external: bool,
    /// How many more bytes entities may expand to in this document.
    budget: Cell<usize>,
}

#[derive(Debug, Clone, Copy)]
enum Entity<'a> {
    Text(&'a str),
    External,
}

/// What a reference stands for.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Resolved {
    /// Text; `true` where it came from a declared entity rather than a character reference.
    Text(String, bool),
    /// An entity whose text is outside the file, too large or not declared.
    Unknown,
    /// Not a reference that XML allows.
    Malformed,
}

const SPACE: [char; 4] = [' ', '\t', '\n', '\r'];

impl<'a> Doctype<'a> {
    /// Reads what stands between `<!DOCTYPE` and its `>`.
    pub(super) fn read(text: &'a str, size: usize) -> Self {
        let mut this = Self {
            budget: Cell::new(size.saturating_mul(2).saturating_add(1 << 20)),
            ..Self::default()
        };
        let (head, subset) = split_head(text);
        this.external = head.contains("SYSTEM") || head.contains("PUBLIC");
        let mut rest = subset;
        while let Some(at) = rest.find(['<', '%']) {
            rest = &rest[at..];
            let length = if rest.starts_with("<!--") {
                rest.find("-->").map_or(rest.len(), |i| i + 3)
            } else if rest.starts_with("<?") {
                rest.find("?>").map_or(rest.len(), |i| i + 2)
            } else if rest.starts_with('<') {
                let length = declaration_length(rest);
                this.declaration(&rest[..length]);
                length
            } else {
                this.external = true;
                1
            };
            rest = &rest[length.max(1)..];
        }
        this
    }

    fn declaration(&mut self, text: &'a str) {
        let inner = text.trim_end_matches('>');
        if let Some(rest) = inner.strip_prefix("<!ENTITY") {
            let rest = rest.trim_start_matches(SPACE);
            if rest.starts_with('%') {
                return;
            }
            let (name, value) = rest.split_once(SPACE).unwrap_or((rest, ""));
            let value = value.trim_matches(SPACE);
            let entity = match value.chars().next() {
                Some(quote @ ('"' | '\'')) => Entity::Text(value.trim_matches(quote)),
                _ => Entity::External,
            };
            // The first declaration binds.
            self.entities.entry(name).or_insert(entity);
        } else if let Some(rest) = inner.strip_prefix("<!ATTLIST") {
            let rest = rest.trim_start_matches(SPACE);
            self.attribute_lists
                .push(rest.split_once(SPACE).unwrap_or((rest, "")));
        }
    }

    /// Whether a reference in the content may bring markup that is not in the document's own text.
    pub(super) fn may_hold_markup(&self) -> bool {
        self.entities.values().any(|entity| match entity {
            Entity::Text(text) => text.contains(['<', '&', '%']),
            Entity::External => true,
        })
    }

    /// Whether `&name;` may stand in a well-formed document.
    pub(super) fn declares(&self, name: &str) -> bool {
        predefined(name).is_some()
            || !name.starts_with('#') && (self.external || self.entities.contains_key(name))
    }

    /// The text of the reference `&name;`.
    pub(super) fn resolve(&self, name: &str) -> Resolved {
        if let Some(character) = predefined(name) {
            return Resolved::Text(character.to_string(), false);
        }
        let mut out = String::new();
        match self.entities.get(name) {
            Some(_) if self.expand(name, 0, &mut out) => Resolved::Text(out, true),
            Some(_) => Resolved::Unknown,
            None if self.external && !name.starts_with('#') => Resolved::Unknown,
            None => Resolved::Malformed,
        }
    }

    /// Appends an entity's text; `false` where it is unknown, circular or too large.
    fn expand(&self, name: &str, depth: usize, out: &mut String) -> bool {
        if let Some(character) = predefined(name) {
            out.push(character);
            return true;
        }
        let Some(&Entity::Text(mut text)) = self.entities.get(name) else {
            return false;
        };
        if depth > MAX_DEPTH || !self.spend(text.len() + 1) {
            return false;
        }
        while let Some((before, rest)) = text.split_once('&') {
            out.push_str(before);
            let Some((inner, behind)) = rest.split_once(';') else {
                return false;
            };
            if !self.expand(inner, depth + 1, out) {
                return false;
            }
            text = behind;
        }
        out.push_str(text);
        true
    }

    fn spend(&self, bytes: usize) -> bool {
        let left = self.budget.get().checked_sub(bytes);
        self.budget.set(left.unwrap_or(0));
        left.is_some()
    }
}

/// The character of a character reference or of one of XML's five own entities, by the text between `&` and `;`.
fn predefined(name: &str) -> Option<char> {
    let code = match name {
        "lt" => return Some('<'),
        "gt" => return Some('>'),
        "amp" => return Some('&'),
        "quot" => return Some('"'),
        "apos" => return Some('\''),
        _ => name.strip_prefix('#')?,
    };
    let (digits, radix) = code.strip_prefix('x').map_or((code, 10), |hex| (hex, 16));
    if digits.is_empty() || !digits.bytes().all(|b| (b as char).is_digit(radix)) {
        return None;
    }
    let character = char::from_u32(u32::from_str_radix(digits, radix).ok()?)?;
    let allowed = matches!(character, '\t' | '\n' | '\r' | ' '..)
        && !matches!(character, '\u{fffe}' | '\u{ffff}');
    allowed.then_some(character)
}

/// Splits a DOCTYPE into what stands before the internal subset and the subset.
fn split_head(text: &str) -> (&str, &str) {
    let mut quote = None;
    for (at, character) in text.char_indices() {
        match (quote, character) {
            (None, '"' | '\'') => quote = Some(character),
            (Some(open), _) if open == character => quote = None,
            (None, '[') => {
                let end = text
                    .rfind(']')
                    .filter(|&end| end > at)
                    .unwrap_or(text.len());
                return (&text[..at], &text[at + 1..end]);
            }
            _ => {}
        }
    }
    (text, "")
}

/// The length of a markup declaration with its `>`; quoted text may contain one.
fn declaration_length(text: &str) -> usize {
    let mut quote = None;
    for (at, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (None, b'"' | b'\'') => quote = Some(byte),
            (Some(open), _) if open == byte => quote = None,
            (None, b'>') => return at + 1,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(resolved: Resolved) -> Option<String> {
        match resolved {
            Resolved::Text(text, _) => Some(text),
            _ => None,
        }
    }

    #[test]
    fn entities_resolve_through_one_another() {
        let doctype = Doctype::read(
            r#" svg PUBLIC "a>[" 'b' [ <!-- <!ENTITY r "9"> --> <!ENTITY r "1&#50;"> <!ENTITY r "7"> <?x <!ENTITY y "1">?>
               <!ENTITY two '&r; &r;'> <!ENTITY ns "http://www.w3.org/2000/svg"> <!ENTITY out SYSTEM "x.svg"> ]"#,
            0,
        );
        assert_eq!(text(doctype.resolve("two")).as_deref(), Some("12 12"));
        assert_eq!(
            text(doctype.resolve("ns")).as_deref(),
            Some("http://www.w3.org/2000/svg")
        );
        assert_eq!(text(doctype.resolve("#x41")).as_deref(), Some("A"));
        assert_eq!(doctype.resolve("out"), Resolved::Unknown);
        assert_eq!(doctype.resolve("y"), Resolved::Unknown);
        assert_eq!(Doctype::default().resolve("nbsp"), Resolved::Malformed);
        assert_eq!(Doctype::default().resolve("#0"), Resolved::Malformed);
        assert!(doctype.may_hold_markup());
    }

    #[test]
    fn bombs_and_circles_end() {
        let mut bomb = String::from("svg [<!ENTITY a0 'aaaaaaaaaa'>");
        for i in 1..40 {
            let before = format!("&a{};", i - 1).repeat(10);
            bomb.extend(["<!ENTITY a", &i.to_string(), " '", &before, "'>"]);
        }
        bomb += "<!ENTITY c1 '&c2;'><!ENTITY c2 '&c1;'>]";
        let doctype = Doctype::read(&bomb, bomb.len());
        assert_eq!(doctype.resolve("c1"), Resolved::Unknown);
        assert_eq!(doctype.resolve("a39"), Resolved::Unknown);
        assert_eq!(doctype.resolve("a9"), Resolved::Unknown);
    }

    #[test]
    fn attribute_lists_are_kept() {
        let doctype = Doctype::read(r#"svg [<!ATTLIST circle r CDATA "5>" cx CDATA "1">]"#, 0);
        assert_eq!(
            doctype.attribute_lists,
            [("circle", r#"r CDATA "5>" cx CDATA "1""#)]
        );
    }
}
