//! What a user of the library alone compiles.

use std::collections::BTreeSet;
use std::process::Command;

/// The names of the crates that are compiled with these features.
fn crates(features: &[&str]) -> BTreeSet<String> {
    let words = "tree --edges normal,build --prefix none --offline --locked";
    let output = Command::new(env!("CARGO"))
        .args(words.split(' '))
        .args(features)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let tree = String::from_utf8(output.stdout).unwrap();
    let names = tree.lines().filter_map(|line| line.split(' ').next());
    names.map(str::to_owned).collect()
}

#[test]
fn the_library_alone_compiles_fewer_than_20_crates() {
    let library = crates(&["--no-default-features"]);
    assert!(library.len() < 20, "{}: {library:?}", library.len());
}

#[test]
fn each_feature_brings_its_own_crates_and_the_command_line_has_all() {
    let program = crates(&[]);
    let library = crates(&["--no-default-features"]);
    for (feature, names) in [
        ("document", "quick-xml"),
        ("batch", "serde_json"),
        ("png", "tiny-skia"),
        ("pdf", "pdf-writer"),
        ("plot", "skrifa"),
        ("serde", "serde"),
        ("schema", "schemars"),
        ("simd", "fearless_simd"),
        (
            "cli",
            "anstream anyhow clap clap_builder clap_complete clap_mangen comfy-table flate2 indicatif rayon strsim tempfile",
        ),
    ] {
        let with = crates(&["--no-default-features", "--features", feature]);
        for name in names.split(' ') {
            assert!(program.contains(name), "{name} is not in the program");
            assert!(with.contains(name), "{name} is not in {feature}");
            assert!(!library.contains(name), "{name} is in the library");
        }
        if feature != "cli" {
            assert!(!with.contains("clap"), "{feature} brings the command line");
        }
    }
}

/// docs/dependencies.md says of each crate why it is there, and of no other.
#[test]
fn each_dependency_has_its_reason() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let manifest = read("Cargo.toml");
    let (_, after) = manifest.split_once("\n[dependencies]\n").unwrap();
    let (section, _) = after.split_once("\n[").unwrap();
    let asked = section.lines().filter(|line| !line.starts_with('#'));
    let asked = asked.filter_map(|line| Some(line.split_once(" = ")?.0.to_owned()));
    let reasons = read("docs/dependencies.md");
    let rows = reasons.lines().filter_map(|line| line.strip_prefix("| "));
    let names = rows.filter_map(|row| row.split(" |").next()).skip(1);
    let names = names.filter(|name| !name.starts_with('-'));
    let named = names.flat_map(|names| names.split(", ").map(str::to_owned));
    assert_eq!(
        asked.collect::<BTreeSet<_>>(),
        named.collect::<BTreeSet<_>>()
    );
}
