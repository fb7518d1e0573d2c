//! What an internal DTD subset declares: entities, which attribute values may use, and attribute defaults.

use std::collections::{HashMap, HashSet};

use core::cell::Cell;

/// How deep entities may refer to one another.
const MAX_DEPTH: usize = 16;

/// Why the text of an entity that is declared elsewhere, if at all, cannot be had.
pub(in crate::document) const UNDECLARED: &str = "is not declared in this file";

/// Why the text of an entity is not all that it stands for.
pub(in crate::document) const MARKUP: &str = "holds markup";

/// The declarations of a document's internal subset.
#[derive(Debug, Default)]
pub(in crate::document) struct Doctype {
    entities: HashMap<String, Entity>,
    /// Parameter entities, which stand for declarations.
    parameters: HashMap<String, Entity>,
    /// The elements to which an attribute list gives values, and whether one of these may matter to other elements too.
    defaults: HashSet<String>,
    defaults_matter: bool,
    /// Whether declarations may exist that are not in the file.
    external: bool,
    /// The entities whose text comes to no end.
    endless: HashSet<String>,
    /// How many more bytes entities may expand to in this document.
    budget: Cell<usize>,
}

#[derive(Debug, Clone)]
enum Entity {
    Text(String),
    External,
}

/// What a reference stands for.
#[derive(Debug, PartialEq, Eq)]
pub(in crate::document) enum Resolved {
    /// Text; `true` where it came from a declared entity rather than a character reference.
    Text(String, bool),
    /// An entity whose text is outside the file, too large or not declared.
    Unknown,
    /// Not a reference that XML allows.
    Malformed,
}

const SPACE: [char; 4] = [' ', '\t', '\n', '\r'];

impl Doctype {
    /// Reads what stands between `<!DOCTYPE` and its `>`.
    pub(in crate::document) fn read(text: &str, size: usize) -> Self {
        let mut this = Self {
            budget: Cell::new(size.saturating_mul(2).saturating_add(1 << 20)),
            ..Self::default()
        };
        let (head, subset) = split_head(text);
        this.external = head.contains("SYSTEM") || head.contains("PUBLIC");
        this.subset(subset, 0);
        this.endless = this.without_end();
        this
    }

    /// The entities that refer to themselves, and those that refer to such.
    fn without_end(&self) -> HashSet<String> {
        let texts = self
            .entities
            .iter()
            .filter_map(|(name, entity)| match entity {
                Entity::Text(text) if text.contains('&') => Some((name.as_str(), text)),
                _ => None,
            });
        let mut referring: HashMap<&str, HashSet<&str>> = texts
            .map(|(name, text)| {
                let parts = text.split('&').skip(1);
                (
                    name,
                    parts
                        .filter_map(|part| Some(part.split_once(';')?.0))
                        .collect(),
                )
            })
            .collect();
        referring.retain(|_, others| !others.is_empty());
        let mut users: HashMap<&str, Vec<&str>> = HashMap::new();
        for (name, others) in &referring {
            for other in others {
                users.entry(other).or_default().push(name);
            }
        }
        // What refers to nothing that is left has an end.
        let mut ends: Vec<&str> = users.keys().copied().collect();
        ends.retain(|name| !referring.contains_key(name));
        while let Some(end) = ends.pop() {
            for user in users.remove(end).unwrap_or_default() {
                if let Some(others) = referring.get_mut(user) {
                    others.remove(end);
                    if others.is_empty() {
                        referring.remove(user);
                        ends.push(user);
                    }
                }
            }
        }
        referring.into_keys().map(str::to_owned).collect()
    }

    /// Reads declarations.
    fn subset(&mut self, text: &str, depth: usize) {
        let mut rest = text;
        while let Some(at) = rest.find(['<', '%']) {
            rest = &rest[at..];
            let length = if rest.starts_with("<!--") {
                rest.find("-->").map_or(rest.len(), |i| i + 3)
            } else if rest.starts_with("<?") {
                rest.find("?>").map_or(rest.len(), |i| i + 2)
            } else if rest.starts_with('<') {
                let length = declaration_length(rest);
                self.declaration(&rest[..length]);
                length
            } else {
                let end = rest.find(';').unwrap_or(rest.len());
                self.parameter(&rest[1..end], depth);
                end + 1
            };
            rest = rest.get(length.max(1)..).unwrap_or_default();
        }
    }

    /// Reads the declarations for which `%name;` stands.
    fn parameter(&mut self, name: &str, depth: usize) {
        // A reader may leave the rest of the declarations out from here on.
        self.external = true;
        let Some(Entity::Text(text)) = self.parameters.get(name) else {
            return;
        };
        let text = with_characters(text);
        if depth < MAX_DEPTH && self.spend(text.len() + 1) {
            self.subset(&text, depth + 1);
        } else {
            self.defaults_matter = true;
        }
    }

    fn declaration(&mut self, text: &str) {
        let inner = text.trim_end_matches('>');
        if let Some(rest) = inner.strip_prefix("<!ENTITY") {
            let rest = rest.trim_start_matches(SPACE);
            let parameter = rest.strip_prefix('%');
            let rest = parameter.unwrap_or(rest).trim_start_matches(SPACE);
            let (name, value) = rest.split_once(SPACE).unwrap_or((rest, ""));
            let value = value.trim_matches(SPACE);
            let entity = match value.chars().next() {
                Some(quote @ ('"' | '\'')) => Entity::Text(value.trim_matches(quote).to_owned()),
                _ => Entity::External,
            };
            let table = if parameter.is_some() {
                &mut self.parameters
            } else {
                &mut self.entities
            };
            // The first declaration binds.
            table.entry(name.to_owned()).or_insert(entity);
        } else if let Some(rest) = inner.strip_prefix("<!ATTLIST") {
            let rest = rest.trim_start_matches(SPACE);
            let (element, definitions) = rest.split_once(SPACE).unwrap_or((rest, ""));
            for attribute in with_default(definitions) {
                if !attribute.starts_with("xmlns") {
                    self.defaults.insert(element.to_owned());
                    self.defaults_matter |= matters_elsewhere(element, attribute);
                }
            }
        }
    }

    /// Whether the DTD gives attributes that may make another thing of an element, or of one that becomes a path.
    pub(in crate::document) fn has_defaults_for(&self, name: &str, path: &str) -> bool {
        self.defaults_matter || self.defaults.contains(name) || self.defaults.contains(path)
    }

    /// Whether a reference in the content may bring markup that is not in the document's own text.
    pub(in crate::document) fn may_hold_markup(&self) -> bool {
        self.entities.values().any(|entity| match entity {
            Entity::Text(text) => text.contains(['<', '&', '%']),
            Entity::External => true,
        })
    }

    /// Why `&name;` may not stand in a well-formed document.
    pub(in crate::document) fn refuses(&self, name: &str) -> Option<&'static str> {
        if predefined(name).is_some() {
            None
        } else if name.starts_with('#') {
            Some("is no character that XML allows")
        } else if self.endless.contains(name) {
            Some("stands for a text that refers to itself")
        } else {
            (!self.external && !self.entities.contains_key(name)).then_some("is not declared")
        }
    }

    /// The text of the reference `&name;`.
    pub(in crate::document) fn resolve(&self, name: &str) -> Resolved {
        if let Some(character) = predefined(name) {
            return Resolved::Text(character.to_string(), false);
        }
        let mut out = String::new();
        match self.entities.get(name) {
            _ if self.refuses(name).is_some() => Resolved::Malformed,
            Some(_) if self.expand(name, 0, &mut out) => Resolved::Text(out, true),
            _ => Resolved::Unknown,
        }
    }

    /// Why the text of `&name;` cannot be had, or is no plain text.
    pub(in crate::document) fn why_not(&self, name: &str) -> Option<&'static str> {
        match self.resolve(name) {
            Resolved::Text(text, true) if text.contains('<') => Some(MARKUP),
            Resolved::Text(..) => None,
            _ => Some(match self.entities.get(name) {
                Some(Entity::External) => "has its text in another file",
                Some(Entity::Text(_)) => "is too large, or has a part that cannot be read",
                None => UNDECLARED,
            }),
        }
    }

    /// Appends an entity's text; `false` where it is unknown, circular or too large.
    fn expand(&self, name: &str, depth: usize, out: &mut String) -> bool {
        if let Some(character) = predefined(name) {
            out.push(character);
            return true;
        }
        let Some(Entity::Text(text)) = self.entities.get(name) else {
            return false;
        };
        if depth > MAX_DEPTH || !self.spend(text.len() + 1) {
            return false;
        }
        let mut text = text.as_str();
        while let Some((before, rest)) = text.split_once('&') {
            out.push_str(before);
            let Some((inner, after)) = rest.split_once(';') else {
                return false;
            };
            if !self.expand(inner, depth + 1, out) {
                return false;
            }
            text = after;
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

/// Whether an attribute may say something about other elements, or how rules see its own.
fn matters_elsewhere(element: &str, attribute: &str) -> bool {
    let local = element.rsplit(':').next().unwrap_or(element);
    match attribute {
        "style" | "class" | "id" | "attributeName" => true,
        "type" => matches!(local, "style" | "script"),
        "rel" => local == "link",
        _ => {
            attribute.starts_with("marker")
                || attribute.starts_with("on")
                || attribute.ends_with("href")
        }
    }
}

/// The attributes of a list that have a default value.
fn with_default(definitions: &str) -> Vec<&str> {
    let (mut found, mut name, mut rest) = (Vec::new(), None, definitions);
    loop {
        rest = rest.trim_start_matches(SPACE);
        let (token, length) = match rest.as_bytes() {
            [] => return found,
            [quote @ (b'"' | b'\''), inner @ ..] => {
                let end = inner.iter().position(|byte| byte == quote);
                ("\"", end.map_or(rest.len(), |end| end + 2))
            }
            _ => {
                let ends = |c| SPACE.contains(&c) || matches!(c, '"' | '\'' | '(');
                let end = rest.char_indices().skip(1).find(|&(_, c)| ends(c));
                let length = end.map_or(rest.len(), |(end, _)| end);
                (&rest[..length], length)
            }
        };
        match token {
            "\"" => found.extend(name.take()),
            "#IMPLIED" | "#REQUIRED" => name = None,
            // What follows a name is its type, or a part of it.
            token => name = name.or(Some(token)),
        }
        rest = rest.get(length..).unwrap_or_default();
    }
}

/// A text with its character references resolved, as the value of an entity is.
fn with_characters(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("&#") {
        out.push_str(before);
        let found = after.split_once(';').and_then(|(code, after)| {
            let character = predefined(&format!("#{code}"))?;
            Some((character, after))
        });
        if let Some((character, after)) = found {
            out.push(character);
            rest = after;
        } else {
            out.push_str("&#");
            rest = after;
        }
    }
    out.push_str(rest);
    out
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
mod tests;
