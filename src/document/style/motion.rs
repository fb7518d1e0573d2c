//! Paths along which something moves.

use std::collections::HashSet;

use cssparser::{ParseError, Parser, Token};

use super::animation;
use crate::document::xml::attributes::Attribute;
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;

/// What the properties by which CSS moves an element along a path have in their names: `offset-path`, `offset`, old `motion-path`.
const PROPERTIES: [&str; 2] = ["offset", "motion"];

/// Whether a text speaks of one of them.
fn moves(text: &str) -> bool {
    PROPERTIES.iter().any(|property| {
        let mut words = text.as_bytes().windows(property.len());
        words.any(|word| word.eq_ignore_ascii_case(property.as_bytes()))
    })
}

/// Whether an attribute is one of them.
fn is_motion(attribute: &Attribute<'_>) -> bool {
    let name = attribute.name;
    PROPERTIES.iter().any(|property| name.starts_with(property))
}

/// Whether an attribute may move its element along a path.
pub(super) fn moves_along(attribute: &Attribute<'_>) -> bool {
    let may = |text: &str| attribute.has_references || text.contains('\\') || moves(text);
    is_motion(attribute) || attribute.name == "style" && may(attribute.value)
}

/// The paths of a document along which something may move.
#[derive(Debug, Default)]
pub(super) struct MotionPaths {
    /// Those of `<mpath>`.
    followed: HashSet<String>,
    /// Those to which an animation leads a link, which may be that of an `<mpath>`.
    relinked: HashSet<String>,
    /// Those to which styles link, whichever of the links it is that moves something.
    linked: HashSet<String>,
    /// Whether some style moves something.
    moves: bool,
    /// Whether some style could not be read.
    is_unknown: bool,
}

impl MotionPaths {
    /// Whether something may move along the element of this id.
    pub(super) fn follows(&self, id: &str) -> bool {
        self.followed.contains(id)
            || !self.followed.is_empty() && self.relinked.contains(id)
            || self.moves && (self.is_unknown || self.linked.contains(id))
    }

    /// Takes up the element of an `<mpath>`.
    pub(super) fn follow(&mut self, id: String) {
        self.followed.insert(id);
    }

    /// Takes up the styles of an element and of what animates them.
    pub(super) fn element(&mut self, scanner: &Scanner<'_>) {
        for attribute in &scanner.attributes {
            self.moves |= is_motion(attribute);
            if attribute.name == "style"
                || animation::VALUES.contains(&attribute.name)
                || is_motion(attribute)
            {
                if let Some(text) = value::text(attribute.value, &scanner.doctype) {
                    self.style(&text, scanner);
                } else {
                    (self.moves, self.is_unknown) = (true, true);
                }
            }
        }
    }

    /// Takes up a style sheet, declarations or a value.
    pub(super) fn style(&mut self, text: &str, scanner: &Scanner<'_>) {
        if text.contains(['(', '\\']) || moves(text) {
            self.tokens(&mut Parser::new(text), scanner);
        }
    }

    /// Takes up the animation of an attribute or a property.
    pub(super) fn animated(&mut self, name: &str, scanner: &Scanner<'_>) {
        self.moves |= moves(name);
        if name.ends_with("href") {
            let values = animation::VALUES
                .iter()
                .filter_map(|name| scanner.attribute(name));
            for value in values {
                let ids = value.split(';').filter_map(|link| scanner.id_of(link));
                self.relinked.extend(ids);
            }
        }
    }

    fn tokens(&mut self, input: &mut Parser<'_>, scanner: &Scanner<'_>) {
        loop {
            match input.next() {
                Ok(Token::Ident(name)) => self.moves |= moves(name),
                Ok(Token::UnquotedUrl(url) | Token::QuotedString(url)) => {
                    self.linked.extend(scanner.id_of(url));
                }
                Ok(
                    Token::Function(_)
                    | Token::ParenthesisBlock
                    | Token::SquareBracketBlock
                    | Token::CurlyBracketBlock,
                ) => self.nested(input, scanner),
                Ok(_) => {}
                Err(_) => return,
            }
        }
    }

    fn nested(&mut self, input: &mut Parser<'_>, scanner: &Scanner<'_>) {
        let mut was_read = false;
        let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
            self.tokens(input, scanner);
            was_read = true;
            Ok(())
        });
        if !was_read {
            // The crate does not go deeper.
            (self.moves, self.is_unknown) = (true, true);
        }
    }
}
