//! What a whole document says about its elements from elsewhere: style sheets, scripts, animations, references.
//!
//! Most files have none of it. The rewriting pass starts without facts and asks for them at the first sign.

use std::collections::HashMap;

use super::animation::{self, AnimatedTarget, target};
use super::css::{self, StyleSheets};
use super::motion::{self, Motion};
use super::on_element;
use super::property::{Effect, ElementKind, Markers, Properties};
use super::rules::SelectorSubject;
use super::script;
use crate::document::doubt::Trust;
use crate::document::reason::Reason;
use crate::document::xml::doctype::{Doctype, Resolved};
use crate::document::xml::encoding::Source;
use crate::document::xml::fault::Result;
use crate::document::xml::namespace::Namespace;
use crate::document::xml::node::{Element, Node};
use crate::document::xml::scan::Scanner;

/// So often a `<use>` within what another one refers to is followed; what goes on counts as drawn with markers.
const MOST_ROUNDS: usize = 8;

/// What animations set somewhere.
#[derive(Debug, Default)]
struct Changed {
    /// `class`.
    classes: bool,
    /// A link.
    links: bool,
    /// A marker, which keyframes may do as well.
    markers: bool,
}

/// The facts.
#[derive(Debug, Default)]
pub(in crate::document) struct Facts {
    sheet: StyleSheets,
    /// What holds for the whole document.
    everywhere: Vec<Reason>,
    animated: HashMap<AnimatedTarget, Effect>,
    changed: Changed,
    motion: Motion,
    /// Whether the path data of an Android drawable are animated.
    android_morphs: bool,
    has_uses: bool,
    /// The markers that elements of these ids inherit from a `<use>`.
    used: HashMap<String, Markers>,
}

/// Whether an element or one of its attributes may change what holds for other elements.
pub(in crate::document) fn is_sign(element: &Element<'_>, scanner: &Scanner<'_>) -> bool {
    const NAMES: [&str; 6] = ["style", "animate", "set", "animateColor", "mpath", "link"];
    element.android.is_some() && ElementKind::named(element.local).is_none()
        || NAMES.contains(&element.local) && element.namespace != Namespace::Other
        || scanner.attributes.iter().any(motion::moves_along)
        || script::may_run(element, scanner)
}

/// A style sheet whose text is being collected: what stands in the element itself, and not in elements within it.
struct Collecting {
    depth: usize,
    css: String,
}

/// The sheet in whose element the scanner stands.
fn within<'c>(
    collecting: &'c mut [Collecting],
    scanner: &Scanner<'_>,
) -> Option<&'c mut Collecting> {
    let last = collecting.last_mut();
    last.filter(|collecting| collecting.depth == scanner.depth())
}

impl Facts {
    /// Reads a whole document.
    pub(in crate::document) fn read(source: Source<'_>) -> Result<Self> {
        let mut facts = Self::default();
        facts.sheet.rules.folds = source.is_widened;
        let mut scanner = Scanner::new(source)?;
        let mut collecting: Vec<Collecting> = Vec::new();
        loop {
            match scanner.next()? {
                Node::Start(element) => {
                    if facts.element(&element, &scanner) {
                        collecting.push(Collecting {
                            depth: scanner.depth(),
                            css: String::new(),
                        });
                    }
                }
                Node::End { .. } => {
                    if let Some(done) =
                        collecting.pop_if(|collecting| scanner.depth() < collecting.depth)
                    {
                        css::read(&done.css, &mut facts.sheet);
                        facts.motion.style(&done.css, &scanner);
                    }
                }
                Node::Text(text) => {
                    if let Some(collecting) = within(&mut collecting, &scanner) {
                        collecting.css.push_str(text);
                    }
                }
                Node::Reference(_, resolved) => {
                    let collecting = within(&mut collecting, &scanner);
                    facts.reference(resolved, collecting, &scanner.doctype);
                }
                Node::Instruction(text) => {
                    if text.starts_with("xml-stylesheet") {
                        facts.set_everywhere(Reason::ExternalStyle);
                    }
                }
                Node::Other => {}
                Node::Done => break,
            }
        }
        facts.finish();
        if facts.has_uses {
            facts.follow_uses(source)?;
        }
        Ok(facts)
    }

    fn set_everywhere(&mut self, reason: Reason) {
        if !self.everywhere.contains(&reason) {
            self.everywhere.push(reason);
        }
    }

    /// Notes what an element says; whether its text is a style sheet.
    fn element(&mut self, element: &Element<'_>, scanner: &Scanner<'_>) -> bool {
        if script::may_run(element, scanner) {
            self.set_everywhere(Reason::Script);
        }
        self.motion.element(scanner);
        let attribute = |name: &str| scanner.attribute(name);
        let property = element.android.and_then(|i| scanner.attributes.get(i));
        self.android_morphs |= property.is_some_and(|property| {
            property.name.ends_with("Name") && property.value == "pathData"
        });
        match element.local {
            _ if element.namespace == Namespace::Other => {}
            "link"
                if attribute("rel")
                    .is_none_or(|rel| rel.to_ascii_lowercase().contains("stylesheet")) =>
            {
                self.set_everywhere(Reason::ExternalStyle);
            }
            "style" => {
                let kind = attribute("type").unwrap_or_default();
                let kind = kind.trim();
                return !element.empty
                    && (kind.is_empty() || kind.to_ascii_lowercase().starts_with("text/css"));
            }
            "animate" | "set" | "animateColor" => {
                if let Some(name) = attribute("attributeName") {
                    self.animation(name.trim(), target(element, scanner), scanner);
                }
            }
            "use" => self.has_uses = true,
            "mpath" => {
                if let Some(AnimatedTarget::Id(id)) = target(element, scanner) {
                    self.motion.follow(id);
                }
            }
            _ => {}
        }
        false
    }

    fn animation(&mut self, name: &str, target: Option<AnimatedTarget>, scanner: &Scanner<'_>) {
        let effect = animation::effect(name, scanner);
        self.motion.animated(name, scanner);
        self.changed.classes |= name == "class";
        self.changed.links |= name.ends_with("href");
        self.changed.markers |= effect.sets.markers().any;
        if let Some(target) = target
            && !effect.is_empty()
        {
            let entry = self.animated.entry(target).or_default();
            *entry = entry.with(effect);
        }
    }

    fn reference(
        &mut self,
        resolved: Resolved,
        collecting: Option<&mut Collecting>,
        doctype: &Doctype,
    ) {
        match (resolved, collecting) {
            (Resolved::Text(text, _), Some(collecting)) => collecting.css.push_str(&text),
            (Resolved::Text(_, entity), None) if !entity || !doctype.may_hold_markup() => {}
            _ => self.set_everywhere(Reason::EntityContent),
        }
    }

    fn finish(&mut self) {
        if self.sheet.imports {
            self.set_everywhere(Reason::ExternalStyle);
        }
        if self.changed.classes {
            self.sheet.rules.loosen();
        }
        self.changed.markers |= self.sheet.keyframes.sets.markers().any;
    }

    /// Why an element of this kind cannot be replaced, if the document says so and it is not trusted.
    pub(in crate::document) fn forbid(
        &self,
        kind: ElementKind,
        start: usize,
        class: Option<&str>,
        id: Option<&str>,
        trust: Trust,
    ) -> Option<Reason> {
        let everywhere = self.everywhere.iter().find(|reason| reason.counts(trust));
        if let Some(reason) = everywhere {
            return Some(reason.clone());
        }
        let selector = self.sheet.rules.selected_by_name(kind, class, id);
        let subject = SelectorSubject {
            name: kind.name(),
            class,
            id,
        };
        let moves_along = id.is_some_and(|id| self.motion.follows(id));
        let animated = self.animated(start, id);
        let changed = animated.sets.and(kind.sensitive());
        [
            selector.map(|selector| Reason::SelectedByName(selector.to_owned())),
            style_reason(kind, self.sheet.rules.effect(subject)),
            reads_reason(kind, animated),
            (!changed.is_empty()).then(|| Reason::Animated(changed.first_name())),
            moves_along.then_some(Reason::MotionPath),
        ]
        .into_iter()
        .flatten()
        .find(|reason| reason.counts(trust))
    }

    /// Why path data of an Android drawable cannot be replaced: what animates them asks for the same commands.
    pub(in crate::document) fn forbid_android(&self, trust: Trust) -> Option<Reason> {
        let animated = self.android_morphs.then_some(Reason::Animated("pathData"));
        animated.filter(|reason| reason.counts(trust))
    }

    /// What animations and keyframes do to an element.
    fn animated(&self, start: usize, id: Option<&str>) -> Effect {
        let by_place = self.animated.get(&AnimatedTarget::Parent(start)).copied();
        let by_id = id.and_then(|id| {
            self.animated
                .get(&AnimatedTarget::Id(id.to_owned()))
                .copied()
        });
        let found = by_place.into_iter().chain(by_id);
        found.fold(self.sheet.keyframes, Effect::with)
    }

    /// Whether a style rule may round the corners of a rectangle.
    pub(in crate::document) fn may_round(&self, class: Option<&str>, id: Option<&str>) -> bool {
        let subject = SelectorSubject {
            name: "rect",
            class,
            id,
        };
        let radii = Properties::named("rx").with(Properties::named("ry"));
        self.sheet.rules.effect(subject).sets.meets(radii)
    }

    /// The markers in effect on an element, from what its parent passes on.
    pub(in crate::document) fn markers(
        &self,
        inherited: Markers,
        element: &Element<'_>,
        scanner: &Scanner<'_>,
    ) -> Markers {
        if self.changed.markers {
            return Markers::ALL;
        }
        let (class, id) = (scanner.attribute("class"), scanner.attribute("id"));
        let id = id.as_deref();
        let used = id.and_then(|id| self.used.get(id)).copied();
        let inherited = inherited.with(used.unwrap_or_default());
        let subject = SelectorSubject {
            name: element.local,
            class: class.as_deref(),
            id,
        };
        let styled = self.sheet.rules.effect(subject).sets.markers();
        on_element::markers(inherited, &scanner.attributes, &scanner.doctype).with(styled)
    }

    /// Follows markers through `<use>` into what it refers to, which may hold further ones.
    fn follow_uses(&mut self, source: Source<'_>) -> Result<()> {
        for _ in 0..MOST_ROUNDS {
            if self.changed.markers || !self.follow_uses_once(source)? {
                return Ok(());
            }
        }
        self.changed.markers = true;
        Ok(())
    }

    /// Goes over the document once; whether that found something new.
    fn follow_uses_once(&mut self, source: Source<'_>) -> Result<bool> {
        let mut scanner = Scanner::new(source)?;
        let (mut open, mut is_new) = (Vec::<Markers>::new(), false);
        loop {
            match scanner.next()? {
                Node::Start(element) => {
                    let inherited = open.last().copied().unwrap_or_default();
                    let markers = self.markers(inherited, &element, &scanner);
                    if markers.any && is_use(&element) {
                        self.changed.markers |= self.changed.links;
                        if let Some(id) = scanner.linked_id(&element) {
                            let known = self.used.entry(id).or_default();
                            is_new |= known.with(markers) != *known;
                            *known = known.with(markers);
                        }
                    }
                    if !element.empty {
                        open.push(markers);
                    }
                }
                Node::End { .. } => {
                    open.pop();
                }
                Node::Done => return Ok(is_new),
                _ => {}
            }
        }
    }
}

/// Whether an element draws another one, which inherits from it.
pub(in crate::document) fn is_use(element: &Element<'_>) -> bool {
    element.local == "use" && element.namespace == Namespace::Svg
}

/// Why what a style does to an element of this kind forbids a replacement, if it does.
pub(in crate::document) fn style_reason(kind: ElementKind, effect: Effect) -> Option<Reason> {
    let set = effect.sets.and(kind.sensitive());
    reads_reason(kind, effect)
        .or_else(|| (!set.is_empty()).then(|| Reason::StyleGeometry(set.first_name())))
}

/// The same of what values read with `attr()`.
fn reads_reason(kind: ElementKind, effect: Effect) -> Option<Reason> {
    let read = effect.reads.and(kind.attributes());
    (!read.is_empty()).then(|| Reason::StyleReads(read.first_name()))
}
