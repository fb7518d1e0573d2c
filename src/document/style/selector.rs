//! Selectors, taken apart as far as the change of a tag may matter to them.

use std::rc::Rc;

use cssparser::{ParseError, Parser, Token};

use super::property::{ElementKind, Properties};

/// The most characters of a selector that a note quotes.
const MOST_QUOTED: usize = 60;
/// This many classes and this many ids of a compound selector are asked for, so that a long one does not make each of those in its
/// `:is()` long; who asks for fewer matches more.
const MOST_ASKED: usize = 8;

/// One compound selector: simple selectors without a combinator between them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(in crate::document) struct Compound {
    /// The type selector without its prefix; `None` for `*` or none.
    pub(in crate::document) name: Option<Rc<str>>,
    /// The type selector of the compound in whose `:is()` or `:not()` this one stands.
    outer_name: Option<Rc<str>>,
    pub(in crate::document) classes: Vec<Rc<str>>,
    pub(in crate::document) ids: Vec<Rc<str>>,
    /// The attributes among those that a replacement changes of which it speaks.
    attributes: Properties,
    /// Whether it counts siblings by type.
    pub(in crate::document) of_type: bool,
    /// Whether it could not be read.
    pub(in crate::document) unknown: bool,
    /// The text, for notes.
    pub(in crate::document) text: Box<str>,
}

impl Compound {
    /// A selector that may say anything, the names of elements included.
    pub(in crate::document) fn unknown() -> Self {
        Self {
            unknown: true,
            text: "a rule that could not be read".into(),
            ..Self::default()
        }
    }

    /// A selector that matches every element but does not depend on names.
    pub(in crate::document) fn any() -> Self {
        Self::default()
    }

    /// Whether it may single out elements of this kind by what a replacement changes.
    pub(in crate::document) fn is_sensitive(&self, kind: ElementKind) -> bool {
        let names = |name: &Option<Rc<str>>| {
            name.as_deref()
                .is_none_or(|name| name == kind.name() || name == "path")
        };
        // A selector for another element matches neither before nor after.
        let own = names(&self.name) && names(&self.outer_name);
        let by_name = kind != ElementKind::Path && (self.of_type || self.name.is_some());
        self.unknown || own && (by_name || self.attributes.meets(kind.attributes()))
    }
}

/// The compound selectors of a list.
#[derive(Debug, Default)]
pub(in crate::document) struct Selectors {
    /// All of them, those within `:is()` and its like included.
    pub(in crate::document) all: Vec<Compound>,
    /// Those of the elements that the declarations are for.
    pub(in crate::document) subjects: Vec<Compound>,
}

/// Reads a list of selectors.
pub(in crate::document) fn read(text: &str) -> Selectors {
    let mut all = Vec::new();
    let subjects = list(&mut Parser::new(text), &mut all);
    all.extend(subjects.iter().flat_map(Draft::clone_all));
    let subjects = subjects.into_iter().map(|draft| draft.compound).collect();
    Selectors { all, subjects }
}

/// The functions whose arguments speak of the same element.
fn speaks_of_the_same(name: &str) -> bool {
    let same = [
        "is",
        "not",
        "where",
        "matches",
        "any",
        "-webkit-any",
        "-moz-any",
    ];
    same.iter().any(|known| known.eq_ignore_ascii_case(name))
}

/// Reads a list up to its end: gives the last compound of each selector, and puts all others into `others`.
fn list(input: &mut Parser<'_>, others: &mut Vec<Compound>) -> Vec<Draft> {
    let (mut subjects, mut last) = (Vec::new(), None::<Draft>);
    loop {
        let (draft, end) = compound(input, others);
        if !draft.compound.text.is_empty()
            && let Some(before) = last.replace(draft)
        {
            others.extend(before.into_all());
        }
        if end != CompoundEnd::Combinator {
            subjects.extend(last.take());
        }
        if end == CompoundEnd::Input {
            return subjects;
        }
    }
}

/// What ends a compound selector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CompoundEnd {
    Combinator,
    Comma,
    Input,
}

/// A compound selector that is being read.
#[derive(Debug, Default)]
struct Draft {
    compound: Compound,
    /// Whether the next word is a class.
    class: bool,
    /// Whether the next word is a pseudo-class or a pseudo-element.
    pseudo: bool,
    /// What `:is()` and its like say of the same element.
    same: Vec<Compound>,
}

/// Reads one compound selector and what follows it; those in the arguments of its functions go to `others`.
fn compound(input: &mut Parser<'_>, others: &mut Vec<Compound>) -> (Draft, CompoundEnd) {
    let start = input.position();
    let (mut draft, mut is_empty) = (Draft::default(), true);
    let end = loop {
        match input.next_including_whitespace_and_comments() {
            Err(_) => break CompoundEnd::Input,
            Ok(Token::Comma) => break CompoundEnd::Comma,
            Ok(Token::WhiteSpace(_) | Token::CDO | Token::CDC | Token::Delim('>' | '+' | '~')) => {
                break CompoundEnd::Combinator;
            }
            Ok(Token::Comment(_)) => {}
            Ok(token) => {
                let token = token.clone();
                draft.take(&token, input, others);
                is_empty = false;
            }
        }
    };
    let text = if is_empty {
        ""
    } else {
        input.slice_from(start)
    };
    let text = text.trim_matches(|c: char| c.is_ascii_whitespace() || ",>+~".contains(c));
    let Draft { compound, same, .. } = &mut draft;
    compound.text = text.chars().take(MOST_QUOTED).collect();
    // They matter only to the elements that may be of this compound.
    for inner in same {
        inner.outer_name = inner.outer_name.take().or_else(|| compound.name.clone());
        ask(&mut inner.classes, &compound.classes);
        ask(&mut inner.ids, &compound.ids);
    }
    (draft, end)
}

/// Asks for more classes or ids.
fn ask(asked: &mut Vec<Rc<str>>, more: &[Rc<str>]) {
    let room = MOST_ASKED.saturating_sub(asked.len());
    asked.extend(more.iter().take(room).cloned());
}

impl Draft {
    /// The compound, and what its functions say of the same element.
    fn into_all(self) -> impl Iterator<Item = Compound> {
        self.same.into_iter().chain([self.compound])
    }

    fn clone_all(&self) -> impl Iterator<Item = Compound> {
        self.same.iter().chain([&self.compound]).cloned()
    }

    /// Takes up one token.
    fn take(&mut self, token: &Token<'_>, input: &mut Parser<'_>, others: &mut Vec<Compound>) {
        let (class, pseudo) = (self.class, self.pseudo);
        (self.class, self.pseudo) = (false, false);
        let compound = &mut self.compound;
        match token {
            Token::Colon => self.pseudo = true,
            Token::Delim('.') => self.class = true,
            Token::Ident(name) if class => ask(&mut compound.classes, &[name.as_ref().into()]),
            Token::Ident(name) if pseudo => compound.of_type |= is_of_type(name),
            // `svg|circle`: the last name is the element's.
            Token::Ident(name) => compound.name = Some(name.as_ref().into()),
            Token::IDHash(name) | Token::Hash(name) => {
                ask(&mut compound.ids, &[name.as_ref().into()]);
            }
            Token::Function(name) => {
                compound.of_type |= is_of_type(name);
                let subjects = arguments(input, others).into_iter();
                let subjects = subjects.flat_map(Self::into_all);
                if pseudo && speaks_of_the_same(name) {
                    self.same.extend(subjects);
                } else {
                    others.extend(subjects);
                }
            }
            Token::SquareBracketBlock => {
                compound.attributes = compound.attributes.with(attribute(input));
            }
            // `*`, `|`, `&`, numbers of `:nth-child()` and what CSS does not allow.
            _ => {}
        }
    }
}

fn is_of_type(name: &str) -> bool {
    name.to_ascii_lowercase().ends_with("-of-type")
}

/// The list of selectors that a function has for its arguments.
fn arguments(input: &mut Parser<'_>, others: &mut Vec<Compound>) -> Vec<Draft> {
    let mut subjects = None;
    let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
        subjects = Some(list(input, others));
        Ok(())
    });
    // Nested more deeply than the crate goes.
    subjects.unwrap_or_else(|| {
        others.push(Compound::unknown());
        Vec::new()
    })
}

/// The attribute of which `[ns|name=value]` speaks.
fn attribute(input: &mut Parser<'_>) -> Properties {
    let mut found = Properties::NONE;
    let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
        let mut is_name = true;
        while let Ok(token) = input.next() {
            match token {
                Token::Ident(name) if is_name => found = Properties::attribute(name),
                Token::Delim('*' | '|') => {}
                _ => is_name = false,
            }
        }
        Ok(())
    });
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<Compound> {
        read(text).all
    }

    fn sensitive(text: &str, kind: ElementKind) -> bool {
        all(text).iter().any(|compound| compound.is_sensitive(kind))
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
            "a/**/circle, circle/* x */",
            "circle>text",
            "[*|r]",
            ":/**/first-of-type",
            ":/**/not(path)",
            "circle/**/:/**/hover",
        ] {
            assert!(sensitive(text, ElementKind::Circle), "{text}");
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
            "[title=r]",
            "::before",
            "rect[r]",
            "text:not(path)",
            ".\\63ircle",
        ] {
            assert!(!sensitive(text, ElementKind::Circle), "{text}");
        }
        assert!(!sensitive("path:first-of-type", ElementKind::Path));
        assert!(sensitive("path[d*=a]", ElementKind::Path));
    }

    #[test]
    fn what_is_not_or_is_of_a_class_asks_for_the_class() {
        for text in [".a:not(path)", ":not(path).a", ".a:is(b, :where(path))"] {
            let all = all(text);
            let mut sensitive = all.iter().filter(|c| c.is_sensitive(ElementKind::Circle));
            assert!(
                sensitive.all(|compound| compound.classes == ["a".into()]),
                "{text}: {all:?}"
            );
        }
        let has = all(".a:has(path)");
        assert!(
            has.iter()
                .any(|c| c.is_sensitive(ElementKind::Circle) && c.classes.is_empty())
        );
    }

    /// Else the square of 3,000 names would be kept.
    #[test]
    fn what_stands_in_a_long_selector_is_not_long() {
        let inner: Vec<String> = (0..3000).map(|i| format!("a.b{i},")).collect();
        let inner = inner.concat();
        for outer in [".x".repeat(3000), "#x".repeat(3000), "x".repeat(3000)] {
            let all = all(&format!("{outer}:is({inner}c)"));
            assert_eq!(all.len(), 3002);
            let most = |names: fn(&Compound) -> usize| all.iter().map(names).max();
            assert!(most(|c| c.classes.len()) <= Some(MOST_ASKED));
            assert!(most(|c| c.ids.len()) <= Some(MOST_ASKED));
        }
    }

    #[test]
    fn comments_do_not_part_a_selector() {
        let classes = |text: &str| {
            let subjects = read(text).subjects;
            assert_eq!(subjects.len(), 1, "{text}");
            subjects[0].classes.clone()
        };
        for text in [
            "./**/a",
            ".a/**/",
            "/* */.a",
            "/* */ .a /* */",
            "b >/**/./* */a",
        ] {
            assert_eq!(classes(text), ["a".into()], "{text}");
        }
        assert_eq!(classes(".a/**/./**/b"), ["a".into(), "b".into()]);
    }

    #[test]
    fn nesting_ends() {
        let deep = format!("{}circle{}", ":is(".repeat(20_000), ")".repeat(20_000));
        assert!(sensitive(&deep, ElementKind::Circle));
    }
}
