//! What style sheets and style attributes say about the geometry of elements, read from the tokens of `cssparser`.
//!
//! Whatever cannot be read counts as if it matched everything. Time and memory are linear in the sheet: a token is read three
//! times at most (in its rule, in its selector or declaration, in what the parser skips), and only rules that can matter stay.

use cssparser::{ParseError, Parser, Token};

use super::property::{Effect, Properties};
use super::rules::Rules;
use super::selector::{self, Compound};

/// What the style sheets of a document hold.
#[derive(Debug, Default)]
pub(in crate::document) struct Sheet {
    pub(in crate::document) rules: Rules,
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
pub(in crate::document) fn read(text: &str, sheet: &mut Sheet) {
    let mut effect = Effect::default();
    items(&mut Parser::new(text), Block::Rules, &mut effect, sheet);
}

/// The declarations of a style attribute.
pub(in crate::document) fn declarations(text: &str) -> Effect {
    let (mut effect, mut sheet) = (Effect::default(), Sheet::default());
    items(
        &mut Parser::new(text),
        Block::Declarations,
        &mut effect,
        &mut sheet,
    );
    effect
}

/// Reads the rules and the declarations of a block; `effect` is that of the declarations that stand in it.
fn items(input: &mut Parser<'_>, block: Block, effect: &mut Effect, sheet: &mut Sheet) {
    let mut start = input.position();
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
        match stop {
            Some('{') => open(item, block, input, effect, sheet),
            _ => statement(item, block, effect, sheet),
        }
        if stop.is_none() {
            return;
        }
        start = input.position();
    }
}

/// Reads the block of a rule.
fn open(
    prelude: &str,
    outer: Block,
    input: &mut Parser<'_>,
    effect: &mut Effect,
    sheet: &mut Sheet,
) {
    if let Some(name) = at_keyword(prelude) {
        match AtRule::named(&name) {
            AtRule::Ignored => {}
            AtRule::Frames => nested(input, Block::Frames, effect, sheet),
            AtRule::Same => nested(input, outer, effect, sheet),
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
fn nested(input: &mut Parser<'_>, block: Block, effect: &mut Effect, sheet: &mut Sheet) {
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
fn statement(text: &str, block: Block, effect: &mut Effect, sheet: &mut Sheet) {
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
    if property.markers().any && value.is_none() {
        effect.no_marker |= name.eq_ignore_ascii_case("marker");
    } else {
        effect.sets = effect.sets.with(property);
        effect.no_marker &= !name.eq_ignore_ascii_case("marker");
    }
}

/// Whether the value of a marker property leaves it off.
pub(in crate::document) fn is_none(text: &str) -> bool {
    Value::read(&mut Parser::new(text)).is_none()
}

/// What matters of a value.
#[derive(Debug, Clone, Copy, Default)]
struct Value {
    reads: Properties,
    /// Words that leave a marker off, and other tokens before a `!`.
    none_words: usize,
    others: usize,
}

impl Value {
    fn read(input: &mut Parser<'_>) -> Self {
        let (mut value, mut is_over) = (Self::default(), false);
        loop {
            let function = match input.next() {
                Ok(Token::Ident(word)) => {
                    let is_none = ["none", "initial"]
                        .iter()
                        .any(|none| none.eq_ignore_ascii_case(word));
                    value.none_words += usize::from(is_none && !is_over);
                    value.others += usize::from(!is_none && !is_over);
                    continue;
                }
                Ok(Token::Delim('!')) => {
                    is_over = true;
                    continue;
                }
                Ok(Token::Function(name)) => name.eq_ignore_ascii_case("attr"),
                Ok(
                    Token::ParenthesisBlock | Token::SquareBracketBlock | Token::CurlyBracketBlock,
                ) => false,
                Ok(_) => {
                    value.others += usize::from(!is_over);
                    continue;
                }
                Err(_) => return value,
            };
            value.others += 1;
            value.reads = value.reads.with(read_by(input, function));
        }
    }

    const fn is_none(self) -> bool {
        self.others == 0 && self.none_words <= 1
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
mod tests {
    use super::super::property::Kind;
    use super::super::rules::Subject;
    use super::*;

    fn sheet(text: &str) -> Sheet {
        let mut sheet = Sheet::default();
        read(text, &mut sheet);
        sheet
    }

    /// What the sheet does to a circle of that class.
    fn effect(sheet: &Sheet, class: &str) -> Properties {
        let subject = Subject {
            name: "circle",
            class: Some(class),
            id: None,
        };
        sheet.rules.effect(subject).sets
    }

    #[test]
    fn declarations_are_found_in_nested_blocks() {
        let s = sheet(
            "/* r:1 */ @media print { .a, .b { r: 5px; fill: red } } @font-face { r: 1 } .c { fill: url(a;r:1) }",
        );
        assert_eq!(effect(&s, "a"), Properties::named("r"));
        assert_eq!(effect(&s, "x b"), Properties::named("r"));
        assert!(effect(&s, "c").is_empty() && s.keyframes.is_empty());
    }

    #[test]
    fn comments_do_not_begin_in_strings_and_urls() {
        for text in [
            r#".a{font-family:"/*"} .b{r:5px}"#,
            ".a{cursor:url(img/*.cur),auto} .b{r:5px}",
            "<!-- .a{fill:red} --> .b{/* ; */r/**/:5px}",
            r".a{content:'\'}/*'} .b{r:5px}",
        ] {
            assert_eq!(effect(&sheet(text), "b"), Properties::named("r"), "{text}");
        }
        let style = declarations("font-family:'/*';r:80px");
        assert_eq!(style.sets, Properties::named("r"));
    }

    #[test]
    fn keyframes_and_imports_are_seen() {
        let s = sheet(
            "@import url(x.css); @-webkit-keyframes a { from { r: 1 } 50% { fill: red } } g { & path { d: none } }",
        );
        assert!(s.imports);
        assert_eq!(s.keyframes.sets, Properties::named("r"));
        assert!(effect(&s, "a").meets(Properties::D));
        assert!(sheet(r"@\69mport 'a.css';").imports);
    }

    #[test]
    fn style_attributes_are_lists_of_declarations() {
        assert!(declarations("fill:red;/*r:1*/stroke:url(#a)").is_empty());
        assert_eq!(
            declarations("fill:red; R : 5px").sets,
            Properties::named("r")
        );
        assert!(declarations("--r: 5; marker: none").no_marker);
        assert!(!declarations("marker: none; marker: url(#a)").no_marker);
        assert!(declarations("--r: 5; marker-end: NONE !important").is_empty());
        assert!(declarations("\\72: 5").sets.meets(Properties::named("r")));
    }

    #[test]
    fn attributes_that_values_read_are_found() {
        let read = |text: &str| declarations(text).reads;
        assert_eq!(read("stroke-width:attr(r px)"), Properties::named("r"));
        assert_eq!(
            read("--w: calc(2 * ATTR(cx type(<length>), 1px))"),
            Properties::named("cx")
        );
        assert!(read("content:'attr(r)';fill:url(attr(r))").is_empty());
        assert!(read("width:attr(data-r px)").is_empty());
        assert_eq!(
            read(&format!("a:{}", "f(".repeat(500))),
            Properties::ANY,
            "what is nested too deeply may read anything"
        );
    }

    #[test]
    fn sizes_along_the_text_are_width_and_height() {
        for name in ["inline-size", "block-size", "-webkit-logical-width"] {
            let set = declarations(&format!("{name}: 5px")).sets;
            assert!(set.meets(Kind::Rect.sensitive()), "{name}");
        }
    }

    #[test]
    fn broken_sheets_end() {
        for text in [
            "}}}", "a{", "{", "a{b:c", "'", "@", "a{{{{", "/*", "(;{};", "\\", "a:", "a{b:",
        ] {
            sheet(text);
            declarations(text);
        }
        let deep = sheet(&"a{".repeat(5000));
        assert!(
            deep.rules
                .selected_by_name(Kind::Rect, None, None)
                .is_some()
        );
    }
}
