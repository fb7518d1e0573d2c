//! The rules of a document's style sheets by the classes and ids that they ask for, so that an element meets few of them.

use std::collections::HashMap;
use std::rc::Rc;

use super::property::{Effect, ElementKind, Properties};
use super::selector::Compound;
use crate::document::xml::encoding::folded;

/// This many classes, ids or names are kept apart; what more rules ask for counts as met.
const MOST_KEYS: usize = 1 << 16;
/// This many selectors of one class or id are kept apart; of more only the class or the id is asked for.
const MOST_ITEMS: usize = 64;

/// What a selector is held against.
#[derive(Debug, Clone, Copy)]
pub(in crate::document) struct SelectorSubject<'a> {
    pub(in crate::document) name: &'a str,
    pub(in crate::document) class: Option<&'a str>,
    pub(in crate::document) id: Option<&'a str>,
}

impl<'a> SelectorSubject<'a> {
    pub(in crate::document) const fn new(
        name: &'a str,
        class: Option<&'a str>,
        id: Option<&'a str>,
    ) -> Self {
        Self { name, class, id }
    }
}

/// What rules say, given their classes and ids.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Said {
    /// The text of a selector that may single out elements of each kind by their names or attributes.
    selected: [Option<Box<str>>; 4],
    /// What they do to elements of any name.
    to_any: Effect,
    /// What they do to elements of one name.
    to_named: HashMap<Rc<str>, Effect>,
}

/// A selector that asks for more than one class or id.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Item {
    classes: Vec<Rc<str>>,
    ids: Vec<Rc<str>>,
    said: Said,
}

/// The rules.
#[derive(Debug, Default)]
pub(in crate::document) struct StyleRules {
    anywhere: Said,
    by_class: HashMap<Rc<str>, Vec<Item>>,
    by_id: HashMap<Rc<str>, Vec<Item>>,
    /// What they set, whichever element they do it to.
    pub(in crate::document) sets: Properties,
    /// Whether the document stands for bytes, so that names beyond ASCII are compared as [`folded`].
    pub(in crate::document) folds: bool,
}

impl Said {
    fn select(&mut self, compound: &Compound) {
        for (kind, text) in ElementKind::ALL.into_iter().zip(&mut self.selected) {
            if compound.is_sensitive(kind) {
                text.get_or_insert_with(|| compound.text.clone());
            }
        }
    }

    fn apply(&mut self, name: Option<Rc<str>>, effect: Effect) {
        let old = match name {
            Some(name) if self.to_named.len() < MOST_KEYS || self.to_named.contains_key(&name) => {
                self.to_named.entry(name).or_default()
            }
            _ => &mut self.to_any,
        };
        *old = old.with(effect);
    }

    fn merge(&mut self, other: Self) {
        for (mine, text) in self.selected.iter_mut().zip(other.selected) {
            *mine = mine.take().or(text);
        }
        self.to_any = self.to_any.with(other.to_any);
        for (name, effect) in other.to_named {
            self.apply(Some(name), effect);
        }
    }

    /// What is done to an element of that name, which may become a path.
    fn effect(&self, name: &str) -> Effect {
        let named = |name: &str| self.to_named.get(name).copied().unwrap_or_default();
        let effect = self.to_any.with(named(name));
        if ElementKind::named(name).is_some() {
            effect.with(named("path"))
        } else {
            effect
        }
    }
}

impl Item {
    fn concerns(&self, subject: SelectorSubject<'_>) -> bool {
        let has = |class: &str| {
            let mut own = subject.class.unwrap_or_default().split_ascii_whitespace();
            own.any(|own| own == class)
        };
        self.classes.iter().all(|class| has(class))
            && self.ids.iter().all(|id| subject.id == Some(id))
    }
}

impl StyleRules {
    /// Takes up a compound selector, whatever its rule does.
    pub(in crate::document) fn select(&mut self, compound: Compound) {
        if ElementKind::ALL
            .iter()
            .any(|kind| compound.is_sensitive(*kind))
        {
            let mut said = Said::default();
            said.select(&compound);
            self.add(compound, said);
        }
    }

    /// Takes up what a rule does to the elements of a compound selector.
    pub(in crate::document) fn apply(&mut self, mut compound: Compound, effect: Effect) {
        self.sets = self.sets.with(effect.sets);
        let mut said = Said::default();
        said.apply(compound.name.take().filter(|_| !compound.unknown), effect);
        self.add(compound, said);
    }

    fn add(&mut self, compound: Compound, said: Said) {
        // Counting by type looks at siblings, whatever their classes.
        let bound = !compound.unknown && !compound.of_type;
        let (mut classes, mut ids) = (compound.classes, compound.ids);
        if self.folds {
            for name in classes.iter_mut().chain(&mut ids) {
                *name = folded(name).into();
            }
        }
        let (table, key) = match (ids.last(), classes.last()) {
            (Some(id), _) if bound => (&mut self.by_id, id.clone()),
            (None, Some(class)) if bound => (&mut self.by_class, class.clone()),
            _ => return self.anywhere.merge(said),
        };
        if table.len() >= MOST_KEYS && !table.contains_key(&key) {
            return self.anywhere.merge(said);
        }
        let items = table.entry(key).or_default();
        let same = |item: &&mut Item| item.classes == classes && item.ids == ids;
        if let Some(item) = items.iter_mut().find(same) {
            item.said.merge(said);
        } else if items.len() < MOST_ITEMS {
            items.push(Item { classes, ids, said });
        } else if let Some(first) = items.first_mut() {
            // Asks for no more than the key, which every element has that looks here.
            (first.classes, first.ids) = (Vec::new(), Vec::new());
            first.said.merge(said);
        }
    }

    /// From now on classes and ids are not relied upon.
    pub(in crate::document) fn loosen(&mut self) {
        let items = self.by_class.drain().chain(self.by_id.drain());
        for item in items.flat_map(|(_, items)| items) {
            self.anywhere.merge(item.said);
        }
    }

    /// What rules say that may concern the element.
    fn met<'r, 's>(
        &'r self,
        subject: SelectorSubject<'s>,
    ) -> impl Iterator<Item = &'r Said> + use<'r, 's> {
        let classes = subject.class.unwrap_or_default().split_ascii_whitespace();
        let by_class = classes.filter_map(|class| self.by_class.get(class));
        let by_id = subject.id.and_then(|id| self.by_id.get(id));
        let items = by_id.into_iter().chain(by_class).flatten();
        core::iter::once(&self.anywhere).chain(
            items
                .filter(move |item| item.concerns(subject))
                .map(|item| &item.said),
        )
    }

    /// The text of a selector that may single out the element by what a replacement changes.
    pub(in crate::document) fn selected_by_name(
        &self,
        kind: ElementKind,
        subject: SelectorSubject<'_>,
    ) -> Option<&str> {
        self.met(subject)
            .find_map(|said| said.selected[kind as usize].as_deref())
    }

    /// What the rules may do to an element, before or after it became a path.
    pub(in crate::document) fn effect(&self, subject: SelectorSubject<'_>) -> Effect {
        self.met(subject).fold(Effect::default(), |sum, said| {
            sum.with(said.effect(subject.name))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::selector;
    use super::*;

    /// A rule for each of this many classes, `more` after each.
    fn many(count: usize, more: &str) -> String {
        let numbers = (0..count).map(|i| i.to_string());
        numbers
            .flat_map(|i| [".c", &i, more, "{r:1}"].map(str::to_owned))
            .collect()
    }

    /// The rules of a sheet that sets `r` and nothing else.
    fn rules(text: &str) -> StyleRules {
        let (mut rules, mut effect) = (StyleRules::default(), Effect::default());
        effect.sets = Properties::named("r");
        for selectors in text.split_terminator("{r:1}").map(selector::read) {
            for compound in selectors.all {
                rules.select(compound);
            }
            for subject in selectors.subjects {
                rules.apply(subject, effect);
            }
        }
        rules
    }

    fn sets(rules: &StyleRules, class: &str, id: &str) -> Properties {
        let subject = SelectorSubject::new("circle", Some(class), Some(id));
        rules.effect(subject).sets
    }

    #[test]
    fn classes_and_ids_narrow_a_selector() {
        let subject = SelectorSubject::new("circle", Some("dot big"), Some("a"));
        let concerns = |text: &str| {
            rules(text)
                .selected_by_name(ElementKind::Circle, subject)
                .is_some()
        };
        for text in [
            "circle.dot",
            "circle#a.big",
            "circle:hover",
            ".dot:not(path)",
        ] {
            assert!(concerns(text), "{text}");
        }
        for text in [
            "circle.small",
            "circle#b",
            ".small:not(path)",
            "circle.dot.x",
            "circle.x.dot",
            "circle.x#a",
            "circle#b#a",
        ] {
            assert!(!concerns(text), "{text}");
        }
    }

    #[test]
    fn only_the_subjects_of_a_selector_are_changed() {
        for text in [
            "g .dot{r:1}",
            "*{r:1}",
            "path{r:1}",
            "a, circle{r:1}",
            "#a{r:1}",
        ] {
            assert!(!sets(&rules(text), "dot", "a").is_empty(), "{text}");
        }
        for text in [".dot g{r:1}", "rect{r:1}", "#b.dot{r:1}", ".dot.b{r:1}"] {
            assert!(sets(&rules(text), "dot", "a").is_empty(), "{text}");
        }
    }

    #[test]
    fn many_selectors_are_kept_apart_or_count_as_met() {
        let table = rules(&many(100_000, ""));
        assert!(!sets(&table, "c7", "").is_empty());
        assert!(sets(&rules(&many(1000, "")), "c1000", "").is_empty());
        let one = rules(&many(1000, ".a"));
        assert!(!sets(&one, "a c999", "").is_empty() && sets(&one, "b", "").is_empty());
    }
}
