//! Paths along which something moves.

use std::collections::HashSet;

use cssparser::{ParseError, Parser, Token};

use super::animation;
use crate::document::xml::attributes::Attribute;
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;

/// What the properties by which CSS moves an element along a path have in their names: `offset-path`, `offset`, old `motion-path`.
const PROPERTIES: [&[u8]; 2] = [b"offset", b"motion"];

fn moves(name: &str) -> bool {
    PROPERTIES.iter().any(|property| {
        let mut words = name.as_bytes().windows(property.len());
        words.any(|word| word.eq_ignore_ascii_case(property))
    })
}

/// Whether an attribute may move its element along a path.
pub(super) fn moves_along(attribute: &Attribute<'_>) -> bool {
    let may = |text: &str| attribute.has_references || text.contains('\\') || moves(text);
    moves(attribute.name) || attribute.name == "style" && may(attribute.value)
}

/// The paths of a document along which something may move.
#[derive(Debug, Default)]
pub(super) struct Motion {
    /// Those of `<mpath>`.
    followed: HashSet<String>,
    /// Those to which styles link, whichever of the links it is that moves something.
    linked: HashSet<String>,
    /// Whether some style moves something.
    moves: bool,
    /// Whether some style could not be read.
    is_unknown: bool,
}

impl Motion {
    /// Whether something may move along the element of this id.
    pub(super) fn follows(&self, id: &str) -> bool {
        self.followed.contains(id) || self.moves && (self.is_unknown || self.linked.contains(id))
    }

    /// Takes up the element of an `<mpath>`.
    pub(super) fn follow(&mut self, id: String) {
        self.followed.insert(id);
    }

    /// Takes up the styles of an element and of what animates them.
    pub(super) fn element(&mut self, scanner: &Scanner<'_>) {
        for attribute in &scanner.attributes {
            self.moves |= moves(attribute.name);
            if attribute.name == "style"
                || animation::VALUES.contains(&attribute.name)
                || moves(attribute.name)
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

    /// Takes up the name of an animated property.
    pub(super) fn animated(&mut self, name: &str) {
        self.moves |= moves(name);
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
