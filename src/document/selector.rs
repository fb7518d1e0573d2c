//! Selectors, taken apart as far as the change of a tag may matter to them.

use super::property::Kind;

/// How deep functional pseudo-classes are followed.
const MAX_DEPTH: usize = 16;

/// One compound selector: simple selectors without a combinator between them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Compound {
    /// The type selector without its prefix; `None` for `*` or none.
    name: Option<String>,
    classes: Vec<String>,
    ids: Vec<String>,
    /// The names of attribute selectors.
    attributes: Vec<String>,
    /// Whether it counts siblings by type.
    of_type: bool,
    /// Whether it could not be read.
    unknown: bool,
    /// The text, for notes.
    text: String,
}

/// What a compound selector is held against.
#[derive(Debug, Clone, Copy)]
pub(super) struct Subject<'a> {
    pub(super) name: &'a str,
    pub(super) class: Option<&'a str>,
    pub(super) id: Option<&'a str>,
    /// Whether classes and ids cannot be relied upon.
    pub(super) loose: bool,
}

impl Compound {
    /// A selector that may say anything, the names of elements included.
    pub(super) fn unknown() -> Self {
        Self {
            unknown: true,
            text: "a rule that could not be read".to_owned(),
            ..Self::default()
        }
    }

    /// A selector that matches every element but does not depend on names.
    pub(super) fn any() -> Self {
        Self {
            text: "&".to_owned(),
            ..Self::default()
        }
    }

    /// The selector as the sheet spells it.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// Whether it may single out elements by what a replacement changes, whatever the element.
    pub(super) fn is_sensitive(&self, kind: Kind) -> bool {
        let names = |name: &String| name == kind.name() || name == "path";
        // A selector for another element matches neither before nor after.
        let own = self.name.as_ref().is_none_or(names);
        let by_name = kind != Kind::Path && (self.of_type || self.name.is_some());
        let by_attribute = || {
            let changes = |name: &String| name == "d" || kind.geometry().contains(&name.as_str());
            self.attributes.iter().any(changes)
        };
        self.unknown || own && (by_name || by_attribute())
    }

    /// Whether its classes and ids may be those of the element. (Counting by type looks at siblings: it always may.)
    pub(super) fn may_concern(&self, subject: Subject<'_>) -> bool {
        if self.unknown || self.of_type || subject.loose {
            return true;
        }
        let has = |class: &String| {
            subject
                .class
                .is_some_and(|list| list.split_ascii_whitespace().any(|own| own == class))
        };
        self.classes.iter().all(has) && self.ids.iter().all(|id| subject.id == Some(id.as_str()))
    }

    /// Whether it may match the element, before or after it became a path.
    pub(super) fn may_match(&self, subject: Subject<'_>) -> bool {
        let named = self
            .name
            .as_ref()
            .is_none_or(|name| name == subject.name || name == "path");
        (named || self.unknown) && self.may_concern(subject)
    }
}

/// All compound selectors of a list, those within `:is()` and its like included, and those that are the subjects.
pub(super) fn read(text: &str) -> (Vec<Compound>, Vec<Compound>) {
    if text.contains('\\') {
        return (vec![Compound::unknown()], vec![Compound::unknown()]);
    }
    let mut all = Vec::new();
    let mut subjects = Vec::new();
    // The arguments of functional pseudo-classes wait here: no recursion, whatever the nesting.
    let mut waiting = vec![(text, 0)];
    while let Some((list, depth)) = waiting.pop() {
        if depth > MAX_DEPTH {
            all.push(Compound::unknown());
            continue;
        }
        for complex in split_outside(list, |b| b == b',') {
            let parts = split_outside(complex, |b| {
                matches!(
                    b,
                    b' ' | b'\t' | b'\n' | b'\r' | b'\x0c' | b'>' | b'+' | b'~'
                )
            });
            let mut last = None;
            for part in parts.into_iter().filter(|part| !part.is_empty()) {
                let (compound, arguments) = compound(part);
                waiting.extend(arguments.into_iter().map(|argument| (argument, depth + 1)));
                last = Some(compound.clone());
                all.push(compound);
            }
            if let Some(last) = last.filter(|_| depth == 0) {
                subjects.push(last);
            }
        }
    }
    (all, subjects)
}

/// Splits at bytes outside parentheses, brackets and strings.
fn split_outside(text: &str, is_separator: impl Fn(u8) -> bool) -> Vec<&str> {
    let (mut parts, mut start, mut depth, mut quote) = (Vec::new(), 0, 0_usize, None);
    for (at, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'(' | b'[') => depth += 1,
            (None, b')' | b']') => depth = depth.saturating_sub(1),
            (None, _) if depth == 0 && is_separator(byte) => {
                parts.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// One compound selector, and the arguments of its functional pseudo-classes.
fn compound(text: &str) -> (Compound, Vec<&str>) {
    let mut compound = Compound {
        text: text.chars().take(60).collect(),
        ..Compound::default()
    };
    let mut arguments = Vec::new();
    let mut rest = text;
    while let Some(mark) = rest.chars().next() {
        match mark {
            '[' => {
                let end = closing(rest);
                let name = rest[1..end].trim_start().trim_start_matches(['*', '|']);
                let name: &str = &name[..name
                    .bytes()
                    .position(|b| !is_identifier(b) && b != b'|')
                    .unwrap_or(name.len())];
                compound
                    .attributes
                    .push(name.rsplit('|').next().unwrap_or(name).to_owned());
                rest = rest.get(end + 1..).unwrap_or_default();
            }
            '.' | '#' | ':' => {
                let body = rest.trim_start_matches(mark);
                let (name, behind) = identifier(body);
                rest = behind;
                match mark {
                    '.' => compound.classes.push(name.to_owned()),
                    '#' => compound.ids.push(name.to_owned()),
                    _ => compound.of_type |= name.to_ascii_lowercase().ends_with("-of-type"),
                }
                if rest.starts_with('(') {
                    let end = closing(rest);
                    arguments.push(&rest[1..end]);
                    rest = rest.get(end + 1..).unwrap_or_default();
                }
            }
            '*' | '|' | '&' => rest = &rest[1..],
            _ => {
                let (name, behind) = identifier(rest);
                if name.is_empty() {
                    // Numbers of `:nth-child()` and what CSS does not allow: one character further.
                    rest = &rest[mark.len_utf8()..];
                } else {
                    // `svg|circle`: the last name is the element's.
                    compound.name = Some(name.to_owned());
                    rest = behind;
                }
            }
        }
    }
    (compound, arguments)
}

const fn is_identifier(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_') || byte >= 0x80
}

fn identifier(text: &str) -> (&str, &str) {
    text.split_at(
        text.bytes()
            .position(|b| !is_identifier(b))
            .unwrap_or(text.len()),
    )
}

/// The index of the bracket that closes the one at the start; the last byte's end where none does.
fn closing(text: &str) -> usize {
    let (mut depth, mut quote) = (0_usize, None);
    for (at, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'(' | b'[') => depth += 1,
            (None, b')' | b']') => {
                depth -= 1;
                if depth == 0 {
                    return at;
                }
            }
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sensitive(text: &str, kind: Kind) -> bool {
        read(text)
            .0
            .iter()
            .any(|compound| compound.is_sensitive(kind))
    }

    #[test]
    fn names_are_found_wherever_they_stand() {
        for text in [
            "circle",
            "svg|circle",
            "*|circle",
            "g > circle + text",
            "path",
            "g:has(> circle)",
            ":not(:is(a, path))",
            ":first-of-type",
            "*:nth-last-of-type(2n+1)",
            "[r]",
            "[ cx = '5' ]",
            "*[d^='M']",
            "circle.a:hover",
            ":nth-child(2 of circle)",
            "\\63ircle",
        ] {
            assert!(sensitive(text, Kind::Circle), "{text}");
        }
        for text in [
            "rect",
            "*",
            ".circle",
            "#path",
            "g:nth-of-type(2)",
            ":nth-child(2n+1)",
            "[rx]",
            "[class='circle, path']",
            "::before",
            "rect[r]",
        ] {
            assert!(!sensitive(text, Kind::Circle), "{text}");
        }
        assert!(!sensitive("path:first-of-type", Kind::Path));
        assert!(sensitive("path[d*=a]", Kind::Path));
    }

    #[test]
    fn classes_and_ids_narrow_a_selector() {
        let subject = Subject {
            name: "circle",
            class: Some("dot big"),
            id: Some("a"),
            loose: false,
        };
        let concerns = |text: &str| read(text).0[0].may_concern(subject);
        assert!(concerns("circle.dot") && concerns("circle#a.big") && concerns("circle:hover"));
        assert!(!concerns("circle.small") && !concerns("circle#b"));
        let matches = |text: &str| {
            read(text)
                .1
                .iter()
                .any(|compound| compound.may_match(subject))
        };
        assert!(matches("g .dot") && matches("*") && matches("path") && matches("a, circle"));
        assert!(!matches(".dot g") && !matches("rect"));
    }

    #[test]
    fn nesting_does_not_recurse() {
        let deep = format!("{}circle{}", ":is(".repeat(20_000), ")".repeat(20_000));
        assert!(sensitive(&deep, Kind::Circle));
    }
}
