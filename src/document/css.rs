//! Just enough of CSS: which selectors name elements by tag, place or geometry, and which declarations move geometry.
//!
//! Whatever cannot be read counts as if it matched everything.

use super::property::Properties;
use super::selector::{self, Compound};

/// One rule that may matter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Rule {
    /// Every compound selector in it, wherever it stands.
    pub(super) compounds: Vec<Compound>,
    /// The compound selectors of the elements that the declarations are for.
    pub(super) subjects: Vec<Compound>,
    pub(super) properties: Properties,
}

/// What the style sheets of a document hold.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Sheet {
    pub(super) rules: Vec<Rule>,
    /// Properties that `@keyframes` move.
    pub(super) keyframes: Properties,
    /// Whether it imports another sheet.
    pub(super) imports: bool,
}

/// What a block stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Block {
    /// Rules: the sheet itself, `@media`, `@supports`, `@layer`.
    Rules,
    /// Declarations of the rule with that index.
    Declarations(usize),
    /// The frames of `@keyframes`.
    Frames,
    /// The declarations of one frame.
    Frame,
    /// A block without a meaning here, such as `@font-face`.
    Ignored,
}

/// Adds the rules of a style sheet.
pub(super) fn read(text: &str, sheet: &mut Sheet) {
    let text = without_comments(text);
    let mut blocks = vec![Block::Rules];
    let mut rest = text.as_str();
    loop {
        rest = rest.trim_start();
        let (end, stop) = item_end(rest);
        let prelude = rest[..end].trim();
        let block = blocks.last().copied().unwrap_or(Block::Rules);
        match stop {
            Some(b'{') => blocks.push(open(prelude, block, sheet)),
            _ => statement(prelude, block, sheet),
        }
        if stop == Some(b'}') && blocks.len() > 1 {
            blocks.pop();
        }
        if stop.is_none() {
            return;
        }
        rest = &rest[end + 1..];
    }
}

/// The declarations of a style attribute.
pub(super) fn declarations(text: &str) -> Properties {
    let mut sheet = Sheet::default();
    sheet.rules.push(Rule {
        compounds: Vec::new(),
        subjects: Vec::new(),
        properties: Properties::NONE,
    });
    let text = without_comments(text);
    let mut rest = text.as_str();
    loop {
        let (end, stop) = item_end(rest);
        statement(rest[..end].trim(), Block::Declarations(0), &mut sheet);
        if stop.is_none() {
            return sheet.rules[0].properties;
        }
        rest = &rest[end + 1..];
    }
}

/// Begins a block and says what it is.
fn open(prelude: &str, outer: Block, sheet: &mut Sheet) -> Block {
    if let Some(at_rule) = prelude.strip_prefix('@') {
        let name: String = at_rule
            .chars()
            .take_while(|c| c.is_ascii_alphanumeric() || *c == '-')
            .collect();
        let name = name.to_ascii_lowercase();
        return match name.as_str() {
            name if name.ends_with("keyframes") => Block::Frames,
            "media" | "supports" | "layer" | "container" | "starting-style" | "document"
            | "-moz-document" => outer,
            "font-face"
            | "page"
            | "property"
            | "counter-style"
            | "font-feature-values"
            | "font-palette-values" => Block::Ignored,
            // `@scope (circle)` and whatever else there may be: any selector may be in it.
            _ => {
                sheet.rules.push(Rule {
                    compounds: vec![Compound::unknown()],
                    subjects: vec![Compound::unknown()],
                    properties: Properties::NONE,
                });
                outer
            }
        };
    }
    match outer {
        Block::Frames => Block::Frame,
        Block::Ignored | Block::Frame => Block::Ignored,
        Block::Rules => {
            let (compounds, subjects) = selector::read(prelude);
            sheet.rules.push(Rule {
                compounds,
                subjects,
                properties: Properties::NONE,
            });
            Block::Declarations(sheet.rules.len() - 1)
        }
        Block::Declarations(_) => {
            // A nested rule: its elements hang on the outer ones in ways that are not followed.
            let (compounds, _) = selector::read(prelude);
            sheet.rules.push(Rule {
                compounds,
                subjects: vec![Compound::any()],
                properties: Properties::NONE,
            });
            Block::Declarations(sheet.rules.len() - 1)
        }
    }
}

/// A declaration or an at-rule without a block.
fn statement(text: &str, block: Block, sheet: &mut Sheet) {
    if text.is_empty() {
        return;
    }
    if let Some(at_rule) = text.strip_prefix('@') {
        sheet.imports |= at_rule
            .get(..6)
            .is_some_and(|name| name.eq_ignore_ascii_case("import"))
            || at_rule.contains('\\');
        return;
    }
    let Some((name, value)) = text.split_once(':') else {
        return;
    };
    let property = if name.contains('\\') {
        Properties::ANY
    } else {
        Properties::declared(name.trim(), value)
    };
    match block {
        Block::Declarations(rule) => {
            if let Some(rule) = sheet.rules.get_mut(rule) {
                rule.properties = rule.properties.with(property);
            }
        }
        Block::Frame => sheet.keyframes = sheet.keyframes.with(property),
        Block::Rules | Block::Frames | Block::Ignored => {}
    }
}

/// Where the item at the start of `text` ends, and with which of `{`, `}` and `;`.
fn item_end(text: &str) -> (usize, Option<u8>) {
    let bytes = text.as_bytes();
    let (mut at, mut depth, mut quote) = (0, 0_usize, None);
    while let Some(&byte) = bytes.get(at) {
        match (quote, byte) {
            (_, b'\\') => at += 1,
            (Some(open), _) if open == byte => quote = None,
            (Some(_), b'\n') => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'(' | b'[') => depth += 1,
            (None, b')' | b']') => depth = depth.saturating_sub(1),
            (None, b'{' | b'}') => return (at, Some(byte)),
            (None, b';') if depth == 0 => return (at, Some(byte)),
            _ => {}
        }
        at += 1;
    }
    (text.len(), None)
}

/// The text with each comment and each SGML comment mark as a space.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once("/*") {
        out.push_str(before);
        out.push(' ');
        rest = behind.split_once("*/").map_or("", |(_, behind)| behind);
    }
    out.push_str(rest);
    if out.contains("<!--") || out.contains("-->") {
        out.replace("<!--", " ").replace("-->", " ")
    } else {
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(text: &str) -> Sheet {
        let mut sheet = Sheet::default();
        read(text, &mut sheet);
        sheet
    }

    #[test]
    fn declarations_are_found_in_nested_blocks() {
        let s = sheet(
            "/* r:1 */ @media print { .a, .b { r: 5px; fill: red } } @font-face { r: 1 } .c { fill: url(a;r:1) }",
        );
        assert_eq!(s.rules.len(), 2);
        assert_eq!(s.rules[0].properties, Properties::named("r"));
        assert!(s.rules[1].properties.is_empty());
        assert!(s.keyframes.is_empty());
    }

    #[test]
    fn keyframes_and_imports_are_seen() {
        let s = sheet(
            "@import url(x.css); @-webkit-keyframes a { from { r: 1 } 50% { fill: red } } g { & path { d: none } }",
        );
        assert!(s.imports);
        assert_eq!(s.keyframes, Properties::named("r"));
        assert!(s.rules[1].properties.meets(Properties::D));
    }

    #[test]
    fn style_attributes_are_lists_of_declarations() {
        assert!(declarations("fill:red;/*r:1*/stroke:url(#a)").is_empty());
        assert_eq!(declarations("fill:red; R : 5px"), Properties::named("r"));
        assert!(declarations("--r: 5; marker: none").is_empty());
        assert!(declarations("\\72: 5").meets(Properties::named("r")));
    }

    #[test]
    fn broken_sheets_end() {
        for text in [
            "}}}", "a{", "{", "a{b:c", "'", "@", "a{{{{", "/*", "(;{};", "\\",
        ] {
            sheet(text);
        }
    }
}
