//! The pictures of the documentation: each has its command in docs/gallery/pictures, and stands on the page of all.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::judges::program::shell;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A picture: its name, what it shows, its command.
struct Picture {
    name: String,
    caption: String,
    command: String,
}

fn pictures() -> Vec<Picture> {
    let list = fs::read_to_string(root().join("docs/gallery/pictures")).unwrap();
    let record = |record: &str| {
        let mut lines = record.trim().splitn(3, '\n').map(str::to_owned);
        Picture {
            name: lines.next().unwrap(),
            caption: lines.next().unwrap(),
            command: lines.next().unwrap(),
        }
    };
    list.split("\n\n").map(record).collect()
}

#[test]
fn every_picture_has_a_command_and_stands_in_the_gallery() {
    let listed: Vec<Picture> = pictures();
    let names: BTreeSet<String> = listed.iter().map(|picture| picture.name.clone()).collect();
    let files = fs::read_dir(root().join("docs/images")).unwrap();
    let files: BTreeSet<String> = files
        .map(|file| file.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(
        names, files,
        "docs/gallery/pictures lists what docs/images holds"
    );
    let page = fs::read_to_string(root().join("docs/gallery/README.md")).unwrap();
    for Picture {
        name,
        caption,
        command,
    } in listed
    {
        let entry = format!(
            "## {name}\n\n{caption}\n\n![{caption}](../images/{name})\n\n```sh\n{command}\n```\n"
        );
        assert!(page.contains(&entry), "{name}: make gallery");
        let magnified = command.contains("error=") || command.contains("explore circle");
        assert!(
            !magnified || caption.contains("orange") || caption.contains("blue"),
            "{name}"
        );
    }
}

/// Pixels are blended in single precision, and other programs have versions: only our own SVG is held to the last byte.
#[test]
fn the_pictures_in_svg_are_what_their_commands_draw() {
    let folder = tempfile::tempdir().unwrap();
    for picture in pictures()
        .into_iter()
        .filter(|picture| Path::new(&picture.name).extension().unwrap() == "svg")
    {
        let script = format!("set -eu\n{}", picture.command);
        let status = shell(folder.path(), &script).status().unwrap();
        assert!(status.success(), "{}", picture.name);
        let drawn = fs::read(folder.path().join(&picture.name)).unwrap();
        let kept = fs::read(root().join("docs/images").join(&picture.name)).unwrap();
        assert!(drawn == kept, "{}: make gallery", picture.name);
    }
}
