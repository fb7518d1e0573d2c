//! The plan of the house: which room may import from which, as docs/design.md lists them, and no circle among the files of a room.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A file of `src` by its module path, like `measure::fit`, and what it imports from the crate.
struct File {
    module: String,
    imports: BTreeSet<String>,
}

impl File {
    fn room(&self) -> &str {
        self.module.split("::").next().unwrap()
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The rooms in their order, the ground floor first: the list in docs/design.md whose items begin with a number and a name in
/// backquotes.
fn rooms() -> Vec<String> {
    let text = fs::read_to_string(root().join("docs/design.md")).unwrap();
    let rooms: Vec<String> = text
        .lines()
        .filter_map(|line| {
            let (number, rest) = line.trim_start().split_once(". `")?;
            number.parse::<usize>().ok()?;
            Some(rest.split_once('`')?.0.to_owned())
        })
        .collect();
    assert!(rooms.len() > 10, "docs/design.md lists {rooms:?}");
    rooms
}

/// The paths that an import names, braces resolved: `a::{b, c::d}` is `a::b` and `a::c::d`.
fn expand(text: &str) -> Vec<String> {
    let Some((head, rest)) = text.split_once('{') else {
        return vec![text.split(" as ").next().unwrap().trim().to_owned()];
    };
    let (mut depth, mut item, mut items) = (1, String::new(), Vec::new());
    for c in rest.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 || (depth == 1 && c == ',') {
            items.push(core::mem::take(&mut item));
            if depth == 0 {
                break;
            }
        } else {
            item.push(c);
        }
    }
    let items = items.iter().filter(|item| !item.trim().is_empty());
    items
        .flat_map(|item| expand(&format!("{}{}", head.trim(), item.trim())))
        .collect()
}

/// What a file imports, unit tests left out, each from the root of the crate.
fn imports(module: &str, text: &str) -> BTreeSet<String> {
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap();
    let code: String = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect::<Vec<_>>()
        .join("\n");
    let mut found = BTreeSet::new();
    let mut add = |path: &str| {
        let mut parts: Vec<&str> = path.split("::").collect();
        let mut base: Vec<&str> = Vec::new();
        match parts[0] {
            "crate" => drop(parts.remove(0)),
            "super" | "self" => {
                base = module.split("::").collect();
                while matches!(parts.first(), Some(&"super" | &"self")) {
                    if parts.remove(0) == "super" {
                        base.pop();
                    }
                }
            }
            _ => return,
        }
        base.extend(parts);
        found.insert(base.join("::"));
    };
    for statement in code.split("use ").skip(1) {
        let statement = statement.split(';').next().unwrap();
        for path in expand(&statement.replace('\n', " ")) {
            add(&path);
        }
    }
    for (at, _) in code.match_indices("crate::") {
        let end = code[at..]
            .find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'))
            .unwrap_or(code.len() - at);
        add(&code[at..at + end]);
    }
    found
}

fn files() -> Vec<File> {
    let mut paths = Vec::new();
    rust_files(&root().join("src"), &mut paths);
    paths.sort();
    paths
        .iter()
        .map(|path| {
            let inner = path
                .strip_prefix(root().join("src"))
                .unwrap()
                .with_extension("");
            let module = inner.to_string_lossy().replace(['/', '\\'], "::");
            File {
                imports: imports(&module, &fs::read_to_string(path).unwrap()),
                module,
            }
        })
        .filter(|file| !matches!(file.room(), "lib" | "main"))
        .collect()
}

/// The names that the root of the crate exports again, each with its room.
fn names_of_the_root() -> BTreeMap<String, String> {
    let text = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    text.lines()
        .filter_map(|line| line.strip_prefix("pub use "))
        .flat_map(|line| expand(line.trim_end_matches(';')))
        .filter_map(|path| {
            let (room, _) = path.split_once("::")?;
            Some((path.rsplit("::").next()?.to_owned(), room.to_owned()))
        })
        .collect()
}

#[test]
fn no_room_imports_from_one_above_it() {
    let (rooms, names) = (rooms(), names_of_the_root());
    let floor = |room: &str| rooms.iter().position(|known| known == room);
    let mut wrong = Vec::new();
    for file in files() {
        let own = floor(file.room())
            .unwrap_or_else(|| panic!("docs/design.md does not list {}", file.room()));
        for import in &file.imports {
            let first = import.split("::").next().unwrap();
            let room = names.get(first).map_or(first, String::as_str);
            if floor(room).is_some_and(|other| other > own) {
                wrong.push(format!("{} imports {import}", file.module));
            }
        }
    }
    assert!(wrong.is_empty(), "upwards: {wrong:#?}");
}

#[test]
fn documents_are_read_as_xml_before_they_are_styled_and_rewritten() {
    let rooms = ["xml", "style", "path", "shape"];
    // What style sheets are told of, and who asks for paths and shapes.
    let (top, askers) = (["doubt", "reason"], ["rewrite", "paths"]);
    for file in files() {
        let Some((own, _)) = file
            .module
            .strip_prefix("document::")
            .and_then(|module| module.split_once("::"))
        else {
            continue;
        };
        let Some(floor) = rooms.iter().position(|room| *room == own) else {
            continue;
        };
        for import in &file.imports {
            let Some(other) = import.strip_prefix("document::") else {
                continue;
            };
            let other = other.split("::").next().unwrap();
            let is_below = rooms[..=floor].contains(&other)
                || floor > 0 && top.contains(&other)
                || floor > 1 && !rooms.contains(&other) && !askers.contains(&other);
            assert!(is_below, "{} imports {import}", file.module);
        }
    }
}

#[test]
fn no_files_import_one_another_in_a_circle() {
    let files = files();
    let modules: BTreeSet<&str> = files.iter().map(|file| file.module.as_str()).collect();
    // An import names a file, or something in it: the longest module path that begins it.
    let target = |import: &str| {
        let mut path = import;
        loop {
            if modules.contains(path) {
                return Some(path.to_owned());
            }
            path = path.rsplit_once("::")?.0;
        }
    };
    // A file and its children are one another's by right: what a circle among siblings would hide, the room's own file shows.
    let related =
        |a: &str, b: &str| a.starts_with(&format!("{b}::")) || b.starts_with(&format!("{a}::"));
    let arrows: BTreeMap<&str, BTreeSet<String>> = files
        .iter()
        .map(|file| {
            let targets = file.imports.iter().filter_map(|import| target(import));
            let own = file.module.as_str();
            (
                own,
                targets
                    .filter(|other| other != own && !related(own, other))
                    .collect(),
            )
        })
        .collect();
    for start in arrows.keys() {
        let mut seen: BTreeSet<&str> = BTreeSet::new();
        let mut waiting: Vec<&str> = arrows[start].iter().map(String::as_str).collect();
        while let Some(here) = waiting.pop() {
            assert!(here != *start, "{start} imports itself through {seen:?}");
            if seen.insert(here) {
                waiting.extend(arrows.get(here).into_iter().flatten().map(String::as_str));
            }
        }
    }
}

#[test]
fn every_file_of_tests_is_a_module_of_the_one_crate() {
    let main = fs::read_to_string(root().join("tests/all/main.rs")).unwrap();
    let mut paths = Vec::new();
    rust_files(&root().join("tests"), &mut paths);
    for path in paths {
        let topic = path.strip_prefix(root().join("tests/all")).ok();
        let Some(topic) = topic.and_then(|path| path.iter().next()?.to_str()) else {
            panic!(
                "{} is a crate of its own, see CONTRIBUTING.md",
                path.display()
            );
        };
        let topic = topic.trim_end_matches(".rs");
        assert!(
            topic == "main" || main.contains(&format!("\nmod {topic};\n")),
            "tests/all/main.rs does not name {topic}"
        );
    }
}

/// The longest function, its line of `fn` and its closing brace counted, and the longest file.
const LONGEST_FUNCTION: usize = 60;
const LONGEST_FILE: usize = 400;

/// Files that are a table: what is known of each method.
const TABLES: [&str; 1] = ["src/method/catalogue.rs"];

/// The functions of a text that `rustfmt` has set: their names and lengths in lines.
fn functions(text: &str) -> Vec<(&str, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let inner = line.trim_start();
        let words = inner.split("fn ").next().unwrap_or_default();
        let is_head = inner.contains("fn ")
            && words.split_whitespace().all(|word| {
                word.starts_with("pub") || matches!(word, "const" | "unsafe" | "extern" | "async")
            });
        if !is_head {
            continue;
        }
        let indent = &line[..line.len() - inner.len()];
        // A declaration without a body ends with a semicolon on its own level.
        let end = lines[i..].iter().position(|line| {
            line.strip_prefix(indent)
                .is_some_and(|rest| rest == "}" || !rest.starts_with(' ') && rest.ends_with(';'))
        });
        let name = inner.split("fn ").nth(1).unwrap_or_default();
        let name = name.split(['(', '<']).next().unwrap_or_default();
        found.push((name, end.map_or(1, |end| end + 1)));
    }
    found
}

#[test]
fn functions_and_files_are_short() {
    let mut paths = Vec::new();
    rust_files(&root().join("src"), &mut paths);
    let (mut count, mut long) = (0, Vec::new());
    for path in paths {
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        let text = fs::read_to_string(&path).unwrap();
        let lines = text.lines().count();
        if lines > LONGEST_FILE && !TABLES.contains(&name.as_str()) {
            long.push(format!("{name}: {lines} lines"));
        }
        for (function, lines) in functions(&text) {
            count += 1;
            if lines > LONGEST_FUNCTION {
                long.push(format!("{name}: {function} has {lines} lines"));
            }
        }
    }
    assert!(count > 1500, "only {count} functions were found");
    assert!(long.is_empty(), "{long:#?}");
}

/// What people read with its module before it, as in `batch::Options`.
const NAMES_OF_MODULES: [&str; 3] = ["Error", "Options", "Report"];

#[test]
fn no_two_types_have_one_name() {
    let mut paths = Vec::new();
    rust_files(&root().join("src"), &mut paths);
    let mut found: BTreeMap<String, PathBuf> = BTreeMap::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        let names = text.lines().filter_map(|line| {
            let mut words = line
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .filter(|word| !["", "pub", "crate", "super", "in", "document"].contains(word));
            let kind = words.next()?;
            // Types of traits are indented and have names that the trait gives.
            let is_type = ["struct", "enum", "trait"].contains(&kind)
                || line.starts_with("type ")
                || line.contains("pub type ");
            is_type.then(|| words.next()).flatten()
        });
        for name in names.filter(|name| !NAMES_OF_MODULES.contains(name)) {
            if let Some(other) = found.insert(name.to_owned(), path.clone()) {
                panic!(
                    "{name} is a type in {} and in {}",
                    other.display(),
                    path.display()
                );
            }
        }
    }
    assert!(found.len() > 500, "{} types were read", found.len());
}
