//! Icons for the table: the sets of `make corpora`, as a user meets them, once.

use std::fs;
use std::path::Path;
use std::thread;

use curveto::document::{self, Options};
use resvg::usvg;

/// The sets that were fetched, each with its name.
pub(crate) fn sets() -> Vec<(&'static str, Vec<String>)> {
    let names = ["lucide-static-1.62.0", "bootstrap-icons-1.13.2"];
    let sets = names.map(|name| (name, icons(name)));
    sets.into_iter()
        .filter(|(_, set)| !set.is_empty())
        .collect()
}

fn icons(name: &str) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpora");
    let folder = root.join(name).join("package/icons");
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = files.map(|file| file.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "svg"));
    paths.sort();
    let texts = paths.into_iter().map(fs::read_to_string);
    texts.filter_map(Result::ok).collect()
}

pub(crate) fn warm(set: &[String], convert: fn(&str) -> usize) -> usize {
    set.iter().map(|icon| convert(icon)).sum()
}

/// In a thread of its own, which has met none of the icons before.
pub(crate) fn cold(set: &[String], convert: fn(&str) -> usize) -> usize {
    thread::scope(|scope| scope.spawn(|| warm(set, convert)).join().unwrap_or(0))
}

pub(crate) fn ours(text: &str) -> usize {
    document::convert(text, &Options::default()).map_or(0, |converted| converted.text.len())
}

pub(crate) fn usvgs(text: &str) -> usize {
    usvg::Tree::from_str(text, &usvg::Options::default()).map_or(0, |tree| {
        tree.to_string(&usvg::WriteOptions::default()).len()
    })
}
