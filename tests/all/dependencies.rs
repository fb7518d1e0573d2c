//! The library alone pulls in no crate of the command line.

use std::process::Command;

#[test]
fn the_library_compiles_no_crate_of_the_command_line() {
    let tree = |features: &[&str]| {
        let output = Command::new(env!("CARGO"))
            .args([
                "tree",
                "--edges",
                "normal",
                "--prefix",
                "none",
                "--offline",
                "--locked",
            ])
            .args(features)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        String::from_utf8(output.stdout).unwrap()
    };
    let names = |tree: &str| -> Vec<String> {
        tree.lines()
            .filter_map(|line| line.split(' ').next().map(str::to_owned))
            .collect()
    };
    let library = names(&tree(&["--no-default-features"]));
    let program = names(&tree(&[]));
    for name in [
        "anyhow",
        "clap",
        "clap_builder",
        "clap_complete",
        "clap_mangen",
        "comfy-table",
        "indicatif",
        "tempfile",
    ] {
        assert!(
            program.iter().any(|other| other == name),
            "{name} is not in the program"
        );
        assert!(
            !library.iter().any(|other| other == name),
            "{name} is in the library"
        );
    }
}
