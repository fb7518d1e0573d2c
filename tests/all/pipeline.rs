//! The pipeline of fixtures/pipeline, run by `make` as a user would run it.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn make(folder: &Path) -> Output {
    let program = env!("CARGO_BIN_EXE_curveto");
    // The outer make's flags are not ours.
    Command::new("make")
        .arg(format!("CURVETO={program}"))
        .current_dir(folder)
        .env_remove("MAKEFLAGS")
        .output()
        .unwrap()
}

#[test]
fn a_makefile_builds_pictures_from_one_line_specs() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/pipeline");
    let folder = tempfile::tempdir().unwrap();
    for entry in fs::read_dir(source).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), folder.path().join(entry.file_name())).unwrap();
    }
    let built = make(folder.path());
    assert!(
        built.status.success(),
        "{}",
        String::from_utf8_lossy(&built.stderr)
    );
    for name in ["seal", "logo", "bow"] {
        let read =
            |extension: &str| fs::read(folder.path().join(format!("{name}.{extension}"))).unwrap();
        assert!(read("svg").starts_with(b"<svg"), "{name}.svg");
        assert!(
            read("eps").starts_with(b"%!PS-Adobe-3.0 EPSF-3.0"),
            "{name}.eps"
        );
        assert!(read("png").starts_with(b"\x89PNG"), "{name}.png");
    }
    let again = String::from_utf8(make(folder.path()).stdout).unwrap();
    assert!(again.contains("Nothing to be done"), "{again}");

    // A spec that cannot be drawn stops the build and leaves the picture that was there.
    let picture = folder.path().join("bow.svg");
    let before = fs::read(&picture).unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1100));
    fs::write(folder.path().join("bow.spec"), "circle -5").unwrap();
    assert!(!make(folder.path()).status.success());
    assert_eq!(fs::read(&picture).unwrap(), before);
}
