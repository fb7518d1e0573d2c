//! A document read node by node for its [`Facts`].

use super::of_document::Facts;
use crate::document::reason::Reason;
use crate::document::xml::doctype::Resolved;
use crate::document::xml::encoding::SourceText;
use crate::document::xml::fault::XmlResult;
use crate::document::xml::node::Node;
use crate::document::xml::scan::Scanner;

/// A style sheet whose text is being collected: what stands in the element itself, and not in elements within it.
#[derive(Debug)]
struct Collecting {
    depth: usize,
    css: String,
}

/// The facts of a document of which not all nodes were seen.
#[derive(Debug, Default)]
pub(in crate::document) struct FactsReader {
    facts: Facts,
    collecting: Vec<Collecting>,
    styles_only: bool,
}

impl FactsReader {
    /// That of style sheets and references alone, for a drawing at rest.
    pub(in crate::document) fn of_styles() -> Self {
        Self {
            styles_only: true,
            ..Self::default()
        }
    }

    /// Takes up the node that was read last.
    pub(in crate::document) fn node(&mut self, node: &Node<'_>, scanner: &Scanner<'_>) {
        match node {
            Node::Start(element) => {
                if !self.styles_only {
                    self.facts.changes(element, scanner);
                }
                if self.facts.styles(element, scanner) {
                    self.collecting.push(Collecting {
                        depth: scanner.depth(),
                        css: String::new(),
                    });
                }
            }
            Node::End { .. } => {
                let is_done = |sheet: &mut Collecting| scanner.depth() < sheet.depth;
                if let Some(done) = self.collecting.pop_if(is_done) {
                    self.facts.style_sheet(&done.css, scanner);
                }
            }
            Node::Text(text) => {
                if let Some(sheet) = self.sheet(scanner) {
                    sheet.css.push_str(text);
                }
            }
            Node::Reference(_, resolved) => match (resolved, self.sheet(scanner)) {
                (Resolved::Text(text, _), Some(sheet)) => sheet.css.push_str(text),
                _ => self.facts.reference(resolved, &scanner.doctype),
            },
            Node::Instruction(text) => {
                if text.starts_with("xml-stylesheet") {
                    self.facts.set_everywhere(Reason::ExternalStyle);
                }
            }
            Node::Other | Node::Done => {}
        }
    }

    /// Whether the scanner stands directly in a style sheet.
    pub(in crate::document) fn is_in_sheet(&self, scanner: &Scanner<'_>) -> bool {
        let last = self.collecting.last();
        last.is_some_and(|sheet| sheet.depth == scanner.depth())
    }

    fn sheet(&mut self, scanner: &Scanner<'_>) -> Option<&mut Collecting> {
        let last = self.collecting.last_mut();
        last.filter(|sheet| sheet.depth == scanner.depth())
    }

    /// The facts, all nodes having been seen.
    pub(in crate::document) fn facts(mut self) -> Facts {
        self.facts.finish();
        self.facts
    }
}

impl Facts {
    /// Reads a whole document.
    pub(in crate::document) fn read(source: SourceText<'_>) -> XmlResult<Self> {
        let mut reader = FactsReader::default();
        let mut scanner = Scanner::new(source)?;
        loop {
            match scanner.next()? {
                Node::Done => break,
                node => reader.node(&node, &scanner),
            }
        }
        let mut facts = reader.facts();
        if facts.has_uses {
            facts.follow_uses(source)?;
        }
        Ok(facts)
    }
}
