//! What a whole document says about its elements from elsewhere: style sheets, scripts, animations, references.
//!
//! Most files have none of it. The rewriting pass starts without facts and asks for them at the first sign.

use std::collections::HashMap;

use super::animation::{self, AnimatedTarget, target};
use super::css::{self, StyleSheets};
use super::motion::{self, MotionPaths};
use super::on_element;
use super::property::{Effect, ElementKind, Markers, Properties};
use super::rules::SelectorSubject;
use super::script;
use crate::document::doubt::Trust;
use crate::document::reason::Reason;
use crate::document::xml::doctype::{Doctype, Resolved};
use crate::document::xml::encoding::SourceText;
use crate::document::xml::fault::XmlResult;
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
    motion: MotionPaths,
    /// Whether the path data of an Android drawable are animated.
    android_morphs: bool,
    pub(in crate::document) has_uses: bool,
    /// The markers that elements of these ids inherit from a `<use>`.
    used: HashMap<String, Markers>,
}

/// Whether an element or one of its attributes may change what holds for other elements.
pub(in crate::document) fn is_sign(element: &Element<'_>, scanner: &Scanner<'_>) -> bool {
    const NAMES: [&str; 6] = ["style", "animate", "set", "animateColor", "mpath", "link"];
    element.android.is_some() && ElementKind::named(element.local).is_none()
        || NAMES.contains(&element.local) && element.namespace != Namespace::Other
        || scanner.attributes.iter().any(motion::moves_along)
        || script::may_run(element, scanner).is_some()
}

impl Facts {
    pub(super) fn style_sheet(&mut self, css: &str, scanner: &Scanner<'_>) {
        self.sheet.rules.folds = scanner.is_widened;
        css::read(css, &mut self.sheet);
        self.motion.style(css, scanner);
    }

    pub(super) fn set_everywhere(&mut self, reason: Reason) {
        if !self.everywhere.contains(&reason) {
            self.everywhere.push(reason);
        }
    }

    /// Notes an element that brings styles or passes its own on; whether its text is a style sheet.
    pub(super) fn styles(&mut self, element: &Element<'_>, scanner: &Scanner<'_>) -> bool {
        let attribute = |name: &str| scanner.attribute(name);
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
            "use" => self.has_uses = true,
            _ => {}
        }
        false
    }

    /// Notes what an element may change of others in time.
    pub(super) fn changes(&mut self, element: &Element<'_>, scanner: &Scanner<'_>) {
        if let Some(reason) = script::may_run(element, scanner) {
            self.set_everywhere(reason);
        }
        self.motion.element(scanner);
        let property = element.android.and_then(|i| scanner.attributes.get(i));
        self.android_morphs |= property.is_some_and(|property| {
            property.name.ends_with("Name") && property.value == "pathData"
        });
        match element.local {
            _ if element.namespace == Namespace::Other => {}
            "animate" | "set" | "animateColor" => {
                if let Some(name) = scanner.attribute("attributeName") {
                    self.animation(name.trim(), target(element, scanner), scanner);
                }
            }
            "mpath" => {
                if let Some(AnimatedTarget::Id(id)) = target(element, scanner) {
                    self.motion.follow(id);
                }
            }
            _ => {}
        }
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

    /// Takes up a reference outside of style sheets, or one in them that is not resolved.
    pub(super) fn reference(&mut self, resolved: &Resolved, doctype: &Doctype) {
        let is_plain = match resolved {
            Resolved::Text(_, entity) => !entity || !doctype.may_hold_markup(),
            _ => false,
        };
        if !is_plain {
            self.set_everywhere(Reason::EntityContent);
        }
    }

    pub(super) fn finish(&mut self) {
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
        subject: SelectorSubject<'_>,
        trust: Trust,
    ) -> Option<Reason> {
        let everywhere = self.everywhere.iter().find(|reason| reason.counts(trust));
        if let Some(reason) = everywhere {
            return Some(reason.clone());
        }
        let selector = self.sheet.rules.selected_by_name(kind, subject);
        let id = subject.id;
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

    /// Whether a style sheet is not in the file.
    pub(in crate::document) fn has_external_style(&self) -> bool {
        self.everywhere.contains(&Reason::ExternalStyle)
    }

    /// What style sheets move elements by, whichever these are.
    pub(in crate::document) fn moving(&self) -> Properties {
        let sets = self.sheet.rules.sets.with(self.sheet.keyframes.sets);
        sets.and(Properties::MOVING)
    }

    /// What style sheets set of the geometry of an element.
    pub(in crate::document) fn styled_geometry(
        &self,
        kind: ElementKind,
        subject: SelectorSubject<'_>,
    ) -> Properties {
        let sets = self.sheet.rules.effect(subject).sets;
        sets.with(self.sheet.keyframes.sets).and(kind.sensitive())
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
    pub(in crate::document) fn may_round(&self, subject: SelectorSubject<'_>) -> bool {
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
        let subject = SelectorSubject::new(element.local, class.as_deref(), id);
        let styled = self.sheet.rules.effect(subject).sets.markers();
        on_element::markers(inherited, &scanner.attributes, &scanner.doctype).with(styled)
    }

    /// Follows markers through `<use>` into what it refers to, which may hold further ones.
    pub(super) fn follow_uses(&mut self, source: SourceText<'_>) -> XmlResult<()> {
        for _ in 0..MOST_ROUNDS {
            if self.changed.markers || !self.follow_uses_once(source)? {
                return Ok(());
            }
        }
        self.changed.markers = true;
        Ok(())
    }

    /// Goes over the document once; whether that found something new.
    fn follow_uses_once(&mut self, source: SourceText<'_>) -> XmlResult<bool> {
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
