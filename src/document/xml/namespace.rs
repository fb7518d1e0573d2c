//! Which elements are SVG.

use std::collections::HashMap;

use super::attributes::Attribute;
use super::doctype::Doctype;
use super::value;

/// The namespaces that matter here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::document) enum Namespace {
    Svg,
    Xhtml,
    Xlink,
    /// The attributes of Android's resources.
    Android,
    Other,
}

/// The declarations in scope.
#[derive(Debug, Default)]
pub(in crate::document) struct Namespaces<'a> {
    /// The default namespaces, each with the depth that declared it.
    default: Vec<(usize, Option<Namespace>)>,
    prefixes: HashMap<&'a str, Vec<Namespace>>,
    /// The prefixes in the order of declaration, to be undone.
    declared: Vec<(usize, &'a str)>,
    /// Whether names without a prefix and without a default namespace count as SVG: a fragment, as people paste it into HTML.
    fragment: bool,
    /// Whether a prefix of Android has been declared.
    knows_android: bool,
}

impl<'a> Namespaces<'a> {
    /// Takes up the declarations of an element at `depth`.
    pub(in crate::document) fn enter(
        &mut self,
        depth: usize,
        attributes: &[Attribute<'a>],
        doctype: &Doctype,
    ) {
        for attribute in attributes
            .iter()
            .filter(|attribute| attribute.name.starts_with("xmlns"))
        {
            let uri = value::text(attribute.value, doctype);
            let namespace = match uri.as_deref() {
                Some("http://www.w3.org/2000/svg") => Namespace::Svg,
                Some("http://www.w3.org/1999/xhtml") => Namespace::Xhtml,
                Some("http://www.w3.org/1999/xlink") => Namespace::Xlink,
                Some("http://schemas.android.com/apk/res/android") => Namespace::Android,
                _ => Namespace::Other,
            };
            if attribute.name == "xmlns" {
                let none = uri.as_deref() == Some("");
                self.default.push((depth, (!none).then_some(namespace)));
            } else if let Some(prefix) = attribute.name.strip_prefix("xmlns:") {
                self.knows_android |= namespace == Namespace::Android;
                self.prefixes.entry(prefix).or_default().push(namespace);
                self.declared.push((depth, prefix));
            }
        }
    }

    /// Forgets what the element at `depth` declared.
    pub(in crate::document) fn leave(&mut self, depth: usize) {
        while self
            .default
            .pop_if(|(declared, _)| *declared == depth)
            .is_some()
        {}
        while let Some((_, prefix)) = self.declared.pop_if(|(declared, _)| *declared == depth) {
            if let Some(stack) = self.prefixes.get_mut(prefix) {
                stack.pop();
            }
        }
    }

    /// The index of the attribute that is the element's link: `href`, or else `xlink:href`; in other namespaces it is none.
    pub(in crate::document) fn link(&self, attributes: &[Attribute<'_>]) -> Option<usize> {
        let is_xlink = |attribute: &Attribute<'_>| {
            let Some(prefix) = attribute.name.strip_suffix(":href") else {
                return false;
            };
            // Many files use the prefix without having declared it.
            self.prefix(prefix)
                .map_or(prefix == "xlink", |namespace| namespace == Namespace::Xlink)
        };
        attributes
            .iter()
            .position(|attribute| attribute.name == "href")
            .or_else(|| attributes.iter().position(is_xlink))
    }

    /// The index of the attribute of an Android drawable that matters here: its path data, or which property it animates.
    pub(in crate::document) fn android(&self, attributes: &[Attribute<'_>]) -> Option<usize> {
        let is_it = |attribute: &Attribute<'_>| {
            attribute
                .name
                .split_once(':')
                .is_some_and(|(prefix, local)| {
                    matches!(local, "pathData" | "propertyName")
                        && self.prefix(prefix) == Some(Namespace::Android)
                })
        };
        self.knows_android
            .then(|| attributes.iter().position(is_it))
            .flatten()
    }

    /// The namespace of a prefix, if it is declared.
    fn prefix(&self, prefix: &str) -> Option<Namespace> {
        self.prefixes.get(prefix)?.last().copied()
    }

    /// The namespace of an element.
    pub(in crate::document) fn of_element(
        &mut self,
        prefix: &str,
        local: &str,
        root: bool,
    ) -> Namespace {
        if !prefix.is_empty() {
            return self.prefix(prefix).unwrap_or(Namespace::Other);
        }
        let default = self.default.last().and_then(|(_, namespace)| *namespace);
        if root {
            const ROOTS: [&str; 12] = [
                "svg", "g", "symbol", "defs", "circle", "ellipse", "rect", "path", "clipPath",
                "mask", "pattern", "marker",
            ];
            self.fragment = default.is_none() && ROOTS.contains(&local);
        }
        default.unwrap_or(if self.fragment {
            Namespace::Svg
        } else {
            Namespace::Other
        })
    }
}
