//! What style sheets and style attributes say about the geometry of elements, read from the tokens of `cssparser`.
//!
//! Whatever cannot be read counts as if it matched everything. Time and memory are linear in the sheet: a token is read three
//! times at most (in its rule, in its selector or declaration, in what the parser skips), and only rules that can matter stay.

use cssparser::{Delimiter, ParseError, Parser, Token};

use super::property::{Effect, Properties};
use super::rules::StyleRules;
use super::selector::{self, Compound};

/// What the style sheets of a document hold.
#[derive(Debug, Default)]
pub(in crate::document) struct StyleSheets {
    pub(in crate::document) rules: StyleRules,
    /// What `@keyframes` do.
    pub(in crate::document) keyframes: Effect,
    /// Whether it imports another sheet.
    pub(in crate::document) imports: bool,
}

/// What a block holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Block {
    /// Rules: the sheet itself, `@media`, `@supports`, `@layer`.
    Rules,
    /// The declarations of a rule.
    Declarations,
    /// The frames of `@keyframes`.
    Frames,
    /// The declarations of one frame.
    Frame,
}

/// What an at-rule's block holds.
enum AtRule {
    /// The same as the block around it.
    Same,
    Frames,
    /// Nothing that matters here, such as `@font-face`.
    Ignored,
    /// Rules whose selectors are not all in their preludes, such as `@scope (circle)`, and whatever else there may be.
    Unknown,
}

impl AtRule {
    fn named(name: &str) -> Self {
        match name.to_ascii_lowercase().as_str() {
            name if name.ends_with("keyframes") => Self::Frames,
            "media" | "supports" | "layer" | "container" | "starting-style" | "document"
            | "-moz-document" => Self::Same,
            "font-face"
            | "page"
            | "property"
            | "counter-style"
            | "font-feature-values"
            | "font-palette-values" => Self::Ignored,
            _ => Self::Unknown,
        }
    }
}

/// Adds the rules of a style sheet.
pub(in crate::document) fn read(text: &str, sheet: &mut StyleSheets) {
    let mut effect = Effect::default();
    items(&mut Parser::new(text), Block::Rules, &mut effect, sheet);
}

/// The declarations of a style attribute.
pub(in crate::document) fn declarations(text: &str) -> Effect {
    let (mut effect, mut sheet) = (Effect::default(), StyleSheets::default());
    items(
        &mut Parser::new(text),
        Block::Declarations,
        &mut effect,
        &mut sheet,
    );
    effect
}

/// The value that a style attribute gives a property: the last important one, or else the last one, without comments.
pub(in crate::document) fn declared(text: &str, name: &str) -> Option<String> {
    let mut input = Parser::new(text);
    let mut found = None;
    while !input.is_exhausted() {
        let one = input.parse_until_after(Delimiter::Semicolon, |input| {
            let own = input.expect_ident_cloned()?;
            input.expect_colon()?;
            let is_own = own.eq_ignore_ascii_case(name);
            Ok::<_, ParseError<()>>(is_own.then(|| plain(input)))
        });
        if let Ok(Some((value, bang))) = one
            && bang != Bang::Alone
            && !(found.as_ref().is_some_and(|(_, last)| *last == Bang::Whole)
                && bang == Bang::Missing)
        {
            found = Some((value.trim().to_owned(), bang));
        }
    }
    found.map(|(value, _)| value)
}

/// The text of a value without comments, up to its `!important`.
fn plain(input: &mut Parser<'_>) -> (String, Bang) {
    let (mut out, mut bang) = (String::new(), Bang::Missing);
    loop {
        let start = input.position();
        let is_block = match input.next_including_whitespace_and_comments() {
            Ok(Token::Comment(_)) => continue,
            Ok(Token::Delim('!')) => {
                let is_important =
                    input.expect_ident_matching("important").is_ok() && input.is_exhausted();
                bang = if is_important {
                    Bang::Whole
                } else {
                    Bang::Alone
                };
                return (out, bang);
            }
            Ok(Token::Function(_) | Token::ParenthesisBlock) => true,
            Ok(_) => false,
            Err(_) => return (out, bang),
        };
        out.push_str(input.slice_from(start));
        if is_block {
            let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
                out.push_str(&plain(input).0);
                Ok(())
            });
            out.push(')');
        }
    }
}

/// Reads the rules and the declarations of a block; `effect` is that of the declarations that stand in it.
fn items(input: &mut Parser<'_>, block: Block, effect: &mut Effect, sheet: &mut StyleSheets) {
    let mut start = input.position();
    // What stood before the item: a bracket may make it none.
    let mut before = Some(';');
    loop {
        let stop = match input.next_including_whitespace_and_comments() {
            Ok(Token::CurlyBracketBlock) => Some('{'),
            Ok(Token::Semicolon) => Some(';'),
            // A bracket too many: some drop the rule after it, some do not.
            Ok(Token::CloseCurlyBracket) => Some('}'),
            Ok(_) => continue,
            Err(_) => None,
        };
        let item = input.slice_from(start);
        let item = stop
            .and_then(|stop| item.strip_suffix(stop))
            .unwrap_or(item);
        if stop == Some('{') {
            open(item, block, input, effect, sheet);
        } else {
            let was_off = effect.no_marker;
            statement(item, block, effect, sheet);
            effect.no_marker &= was_off || before == Some(';') && stop != Some('}');
        }
        if stop.is_none() {
            return;
        }
        (start, before) = (input.position(), stop);
    }
}

/// Reads the block of a rule.
fn open(
    prelude: &str,
    outer: Block,
    input: &mut Parser<'_>,
    effect: &mut Effect,
    sheet: &mut StyleSheets,
) {
    if let Some(name) = at_keyword(prelude) {
        match AtRule::named(&name) {
            AtRule::Ignored => {}
            AtRule::Frames => nested(input, Block::Frames, effect, sheet),
            AtRule::Same => {
                // It may not hold, and not at all in a style attribute.
                let was_off = effect.no_marker;
                nested(input, outer, effect, sheet);
                effect.no_marker &= was_off;
            }
            AtRule::Unknown => {
                sheet.rules.select(Compound::unknown());
                nested(input, outer, effect, sheet);
            }
        }
        return;
    }
    let mut own = Effect::default();
    match outer {
        Block::Frames => {
            nested(input, Block::Frame, &mut own, sheet);
            sheet.keyframes = sheet.keyframes.with(own);
        }
        Block::Frame => {}
        Block::Rules | Block::Declarations => {
            let selectors = selector::read(prelude);
            for compound in selectors.all {
                sheet.rules.select(compound);
            }
            nested(input, Block::Declarations, &mut own, sheet);
            if own.is_empty() {
                return;
            }
            if outer == Block::Declarations {
                // A nested rule: its elements hang on the outer ones in ways that are not followed.
                sheet.rules.apply(Compound::any(), own);
            } else {
                for subject in selectors.subjects {
                    sheet.rules.apply(subject, own);
                }
            }
        }
    }
}

/// Reads the block that has just begun.
fn nested(input: &mut Parser<'_>, block: Block, effect: &mut Effect, sheet: &mut StyleSheets) {
    let mut was_read = false;
    let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
        items(input, block, effect, sheet);
        was_read = true;
        Ok(())
    });
    if !was_read {
        // The crate does not go deeper.
        sheet.rules.select(Compound::unknown());
    }
}

/// A declaration or an at-rule without a block.
fn statement(text: &str, block: Block, effect: &mut Effect, sheet: &mut StyleSheets) {
    if let Some(name) = at_keyword(text) {
        sheet.imports |= name.eq_ignore_ascii_case("import");
    } else if matches!(block, Block::Declarations | Block::Frame) {
        declaration(&mut Parser::new(text), effect);
    }
}

/// The name of an at-rule, escapes resolved.
fn at_keyword(text: &str) -> Option<String> {
    let mut input = Parser::new(text);
    loop {
        match input.next() {
            Ok(Token::AtKeyword(name)) => return Some(name.to_string()),
            Ok(Token::CDO | Token::CDC) => {}
            _ => return None,
        }
    }
}

/// Takes up one declaration; what is none has no effect.
fn declaration(input: &mut Parser<'_>, effect: &mut Effect) {
    let Ok(name) = input.expect_ident_cloned() else {
        return;
    };
    if input.expect_colon().is_err() {
        return;
    }
    let property = Properties::named(&name);
    let value = Value::read(input);
    effect.reads = effect.reads.with(value.reads);
    if property.are_markers() && value.is_none() && value.bang != Bang::Alone {
        effect.no_marker |= name.eq_ignore_ascii_case("marker");
    } else {
        effect.sets = effect.sets.with(property);
        effect.no_marker &= !name.eq_ignore_ascii_case("marker");
    }
}

/// Whether the value of a marker attribute leaves it off.
pub(in crate::document) fn is_none(text: &str) -> bool {
    let value = Value::read(&mut Parser::new(text));
    value.is_none() && value.bang == Bang::Missing
}

/// The attributes that a value reads.
pub(in crate::document) fn reads(text: &str) -> Properties {
    Value::read(&mut Parser::new(text)).reads
}

/// How much of `!important` was read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Bang {
    #[default]
    Missing,
    Alone,
    Whole,
}

/// What matters of a value.
#[derive(Debug, Clone, Copy, Default)]
struct Value {
    reads: Properties,
    /// Words that leave a marker off, and tokens that belong neither to them nor to one `!important` after them.
    none_words: usize,
    others: usize,
    bang: Bang,
}

impl Value {
    fn read(input: &mut Parser<'_>) -> Self {
        let mut value = Self::default();
        loop {
            let function = match input.next() {
                Ok(Token::Ident(word)) => {
                    value.word(word);
                    continue;
                }
                Ok(Token::Delim('!')) if value.bang == Bang::Missing => {
                    value.bang = Bang::Alone;
                    continue;
                }
                Ok(Token::Function(name)) => name.eq_ignore_ascii_case("attr"),
                Ok(
                    Token::ParenthesisBlock | Token::SquareBracketBlock | Token::CurlyBracketBlock,
                ) => false,
                Ok(_) => {
                    value.others += 1;
                    continue;
                }
                Err(_) => return value,
            };
            value.others += 1;
            value.reads = value.reads.with(read_by(input, function));
        }
    }

    fn word(&mut self, word: &str) {
        let is = |known: &&str| known.eq_ignore_ascii_case(word);
        match self.bang {
            Bang::Missing if ["none", "initial"].iter().any(is) => self.none_words += 1,
            Bang::Alone if is(&"important") => self.bang = Bang::Whole,
            _ => self.others += 1,
        }
    }

    const fn is_none(self) -> bool {
        self.others == 0 && self.none_words == 1
    }
}

/// The attributes that the arguments of a function or a block read; those of `attr` name them.
fn read_by(input: &mut Parser<'_>, is_attr: bool) -> Properties {
    let mut reads = None;
    let _: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
        let mut found = Properties::NONE;
        loop {
            match input.next() {
                Ok(Token::Ident(name)) if is_attr => found = found.with(Properties::named(name)),
                Ok(Token::Function(name)) => {
                    let is_attr = name.eq_ignore_ascii_case("attr");
                    found = found.with(read_by(input, is_attr));
                }
                Ok(
                    Token::ParenthesisBlock | Token::SquareBracketBlock | Token::CurlyBracketBlock,
                ) => found = found.with(read_by(input, false)),
                Ok(_) => {}
                Err(_) => break,
            }
        }
        reads = Some(found);
        Ok(())
    });
    // Nested more deeply than the crate goes.
    reads.unwrap_or(Properties::ANY)
}

#[cfg(test)]
mod tests;
