//! What is shipped: the tarball works from an empty prefix, and the crate has every file that it is built of.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Makes the tarball in a folder.
fn tarball(folder: &Path) -> PathBuf {
    let output = Command::new(root().join("packaging/dist.sh"))
        .arg(env!("CARGO_BIN_EXE_curveto"))
        .arg(folder)
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    PathBuf::from(String::from_utf8(output.stdout).unwrap().trim())
}

#[test]
fn the_tarball_works_from_an_empty_prefix_and_is_the_same_twice() {
    let folder = tempfile::tempdir().unwrap();
    let first = tarball(&folder.path().join("a"));
    let second = tarball(&folder.path().join("b"));
    assert!(
        first
            .file_name()
            .unwrap()
            .to_str()
            .unwrap()
            .contains(env!("CARGO_PKG_VERSION"))
    );
    assert!(fs::read(&first).unwrap() == fs::read(&second).unwrap());
    let prefix = folder.path().join("prefix");
    fs::create_dir(&prefix).unwrap();
    let unpacked = Command::new("tar")
        .args([
            "-xzf",
            first.to_str().unwrap(),
            "--strip-components=1",
            "-C",
        ])
        .arg(&prefix)
        .status()
        .unwrap();
    assert!(unpacked.success());
    let output = Command::new(prefix.join("bin/curveto"))
        .args(["circle", "50"])
        .env_clear()
        .output()
        .unwrap();
    assert!(output.stdout.starts_with(b"M50 0C50 27.596"));
    for file in [
        "share/man/man1/curveto.1",
        "share/man/man1/curveto-diff.1",
        "share/bash-completion/completions/curveto",
        "share/zsh/site-functions/_curveto",
        "share/fish/vendor_completions.d/curveto.fish",
        "share/doc/curveto/LICENSE-MIT",
        "share/doc/curveto/LICENSE-APACHE",
        "share/doc/curveto/LICENSE-font",
    ] {
        assert!(
            fs::metadata(prefix.join(file)).unwrap().len() > 100,
            "{file}"
        );
    }
}

#[test]
fn the_crate_has_every_file_that_it_is_built_of() {
    let output = Command::new(env!("CARGO"))
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let listed = String::from_utf8(output.stdout).unwrap();
    let listed: Vec<&str> = listed.lines().collect();
    let mut folders = vec![root().join("src")];
    let mut count = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path
                .strip_prefix(root())
                .unwrap()
                .to_str()
                .unwrap()
                .to_owned();
            assert!(
                listed.contains(&name.as_str()),
                "{name} is not in the crate"
            );
            count += 1;
        }
    }
    assert!(count > 100);
    for name in ["README.md", "LICENSE-MIT", "LICENSE-APACHE", "Cargo.lock"] {
        assert!(listed.contains(&name), "{name}");
    }
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let pictures = readme
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .filter(|target| target.starts_with("docs/images/"));
    let pictures: Vec<&str> = pictures.collect();
    assert!(!pictures.is_empty());
    for name in pictures {
        assert!(listed.contains(&name), "{name} of README.md");
    }
    assert!(
        !listed
            .iter()
            .any(|name| name.starts_with("fixtures/") || name.starts_with("target/"))
    );
}

/// The files that the Debian package takes from the repository are there.
#[test]
fn the_debian_package_finds_its_files() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let (_, deb) = manifest.split_once("[package.metadata.deb]").unwrap();
    let assets = deb
        .lines()
        .filter_map(|line| line.trim().strip_prefix("[\"")?.split('"').next());
    let kept: Vec<&str> = assets.filter(|file| !file.starts_with("target/")).collect();
    assert_eq!(kept.len(), 5);
    for file in kept {
        assert!(root().join(file).is_file(), "{file}");
    }
    // No library is left out of the crate by a path that only the repository has.
    assert!(!manifest.contains("path = \"../"));
}
