//! What a whole document says about its elements from elsewhere: style sheets, scripts, animations, references.
//!
//! Most files have none of it. The rewriting pass starts without facts and asks for them at the first sign.

use std::collections::{HashMap, HashSet};

use super::css::{self, Sheet};
use super::motion;
use super::own;
use super::property::{Effect, Kind, Markers, Properties};
use super::rules::Subject;
use crate::document::doubt::Trust;
use crate::document::reason::Reason;
use crate::document::xml::attributes::Attribute;
use crate::document::xml::doctype::{Doctype, Resolved};
use crate::document::xml::encoding::Source;
use crate::document::xml::fault::Result;
use crate::document::xml::namespace::Namespace;
use crate::document::xml::node::{Element, Node};
use crate::document::xml::scan::Scanner;
use crate::document::xml::value;

/// So often a `<use>` within what another one refers to is followed; what goes on counts as drawn with markers.
const MOST_ROUNDS: usize = 8;

/// Which element an animation changes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Target {
    /// The element whose tag begins at this byte.
    Parent(usize),
    /// The elements with this id.
    Id(String),
}

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
    sheet: Sheet,
    /// What holds for the whole document.
    everywhere: Vec<Reason>,
    animated: HashMap<Target, Properties>,
    changed: Changed,
    motion_paths: HashSet<String>,
    /// Whether the path data of an Android drawable are animated.
    android_morphs: bool,
    has_uses: bool,
    /// The markers that elements of these ids inherit from a `<use>`.
    used: HashMap<String, Markers>,
}

/// Whether an element or one of its attributes may change what holds for other elements.
pub(in crate::document) fn is_sign(element: &Element<'_>, attributes: &[Attribute<'_>]) -> bool {
    const NAMES: [&str; 8] = [
        "style",
        "script",
        "animate",
        "set",
        "animateColor",
        "mpath",
        "link",
        "handler",
    ];
    element.android.is_some() && Kind::named(element.local).is_none()
        || NAMES.contains(&element.local) && element.namespace != Namespace::Other
        || attributes
            .iter()
            .any(|attribute| is_handler(attribute) || motion::moves_along(attribute))
}

/// Whether an attribute holds a script. Event attributes in a namespace (`a:onclick`) do not.
fn is_handler(attribute: &Attribute<'_>) -> bool {
    let scheme = "javascript:";
    attribute.name.len() > 2
        && attribute.name.starts_with("on")
        && !attribute.value.trim().is_empty()
        || attribute.name.ends_with("href")
            && attribute
                .value
                .trim_start()
                .get(..scheme.len())
                .is_some_and(|start| start.eq_ignore_ascii_case(scheme))
}

/// The element whose text is being collected.
struct Collecting {
    depth: usize,
    css: String,
}

impl Facts {
    /// Reads a whole document.
    pub(in crate::document) fn read(source: Source<'_>) -> Result<Self> {
        let mut facts = Self::default();
        let mut scanner = Scanner::new(source)?;
        let mut collecting: Option<Collecting> = None;
        loop {
            match scanner.next()? {
                Node::Start(element) => {
                    if facts.element(&element, &scanner) {
                        collecting = Some(Collecting {
                            depth: scanner.depth(),
                            css: String::new(),
                        });
                    }
                }
                Node::End { .. } => {
                    if let Some(done) =
                        collecting.take_if(|collecting| scanner.depth() < collecting.depth)
                    {
                        css::read(&done.css, &mut facts.sheet);
                    }
                }
                Node::Text(text) => {
                    if let Some(collecting) = &mut collecting {
                        collecting.css.push_str(text);
                    }
                }
                Node::Reference(resolved) => {
                    facts.reference(resolved, collecting.as_mut(), &scanner.doctype);
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
        facts.motion_paths.extend(motion::followed(source.text));
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
        if scanner.attributes.iter().any(is_handler) {
            self.set_everywhere(Reason::Script);
        }
        let attribute = |name: &str| {
            let found = scanner
                .attributes
                .iter()
                .find(|attribute| attribute.name == name)?;
            Some(value::text(found.value, &scanner.doctype).unwrap_or_else(|| found.value.into()))
        };
        let property = element.android.and_then(|i| scanner.attributes.get(i));
        self.android_morphs |= property.is_some_and(|property| {
            property.name.ends_with("Name") && property.value == "pathData"
        });
        match element.local {
            _ if element.namespace == Namespace::Other => {}
            "script" | "handler" => self.set_everywhere(Reason::Script),
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
                    self.animation(name.trim(), target(element, scanner));
                }
            }
            "use" => self.has_uses = true,
            "mpath" => {
                if let Some(Target::Id(id)) = target(element, scanner) {
                    self.motion_paths.insert(id);
                }
            }
            _ => {}
        }
        false
    }

    fn animation(&mut self, name: &str, target: Option<Target>) {
        let property = Properties::named(name);
        self.changed.classes |= name == "class";
        self.changed.links |= name.ends_with("href");
        self.changed.markers |= property.markers().any;
        if let Some(target) = target
            && !property.is_empty()
        {
            let entry = self.animated.entry(target).or_default();
            *entry = entry.with(property);
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
        kind: Kind,
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
        let subject = Subject {
            name: kind.name(),
            class,
            id,
        };
        let moves_along = id.is_some_and(|id| self.motion_paths.contains(id));
        [
            selector.map(|selector| Reason::SelectedByName(selector.to_owned())),
            style_reason(kind, self.sheet.rules.effect(subject)),
            self.animated(kind, start, id),
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

    /// What animations and keyframes do to the geometry of an element.
    fn animated(&self, kind: Kind, start: usize, id: Option<&str>) -> Option<Reason> {
        let sensitive = kind.sensitive();
        if self.sheet.keyframes.reads.meets(kind.attributes()) {
            return style_reason(kind, self.sheet.keyframes);
        }
        let by_place = self.animated.get(&Target::Parent(start)).copied();
        let by_id = id.and_then(|id| self.animated.get(&Target::Id(id.to_owned())).copied());
        [Some(self.sheet.keyframes.sets), by_place, by_id]
            .into_iter()
            .flatten()
            .map(|set| set.and(sensitive))
            .find(|set| !set.is_empty())
            .map(|set| Reason::Animated(set.first_name()))
    }

    /// Whether a style rule may round the corners of a rectangle.
    pub(in crate::document) fn may_round(&self, class: Option<&str>, id: Option<&str>) -> bool {
        let subject = Subject {
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
        let subject = Subject {
            name: element.local,
            class: class.as_deref(),
            id,
        };
        let styled = self.sheet.rules.effect(subject).sets.markers();
        own::markers(inherited, &scanner.attributes, &scanner.doctype).with(styled)
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
pub(in crate::document) fn style_reason(kind: Kind, effect: Effect) -> Option<Reason> {
    let read = effect.reads.and(kind.attributes());
    if !read.is_empty() {
        return Some(Reason::StyleReads(read.first_name()));
    }
    let set = effect.sets.and(kind.sensitive());
    (!set.is_empty()).then(|| Reason::StyleGeometry(set.first_name()))
}

/// What an animation element changes: the element of its link, or else its parent.
fn target(element: &Element<'_>, scanner: &Scanner<'_>) -> Option<Target> {
    if element.link.is_some() {
        return scanner.linked_id(element).map(Target::Id);
    }
    let parent = if element.empty {
        scanner.parent()
    } else {
        scanner.grandparent()
    };
    parent.map(Target::Parent)
}
