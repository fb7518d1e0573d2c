//! What happens to files, as docs/files.md states it.

use crate::judges::program::{program_in, run_in, shell};
use std::fs;
use std::io::{Read as _, Seek as _};
use std::os::fd::OwnedFd;
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, chown, symlink};
use std::os::unix::net::UnixStream;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

const SVG: &str = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg>"#;

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A folder with one file in it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.svg"), SVG).unwrap();
    folder
}

#[test]
fn mode_and_owner_are_kept() {
    let folder = folder();
    let file = folder.path().join("a.svg");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    // Only root may give a file away.
    let owner = chown(&file, Some(1000), Some(1000))
        .map_or_else(|_| fs::metadata(&file).unwrap().uid(), |()| 1000);
    assert!(
        run_in(folder.path(), &["convert", "--in-place", "a.svg"])
            .status
            .success()
    );
    let data = fs::metadata(&file).unwrap();
    assert_eq!((data.uid(), data.mode() & 0o777), (owner, 0o640));
    assert!(owner != 1000 || data.gid() == 1000);
    assert!(fs::read_to_string(&file).unwrap().contains("<path"));
}

#[test]
fn extended_attributes_are_kept() {
    let folder = folder();
    let file = folder.path().join("a.svg");
    if xattr::set(&file, "user.origin", b"drawn by hand").is_err() {
        eprintln!("skipped: this file system has no extended attributes");
        return;
    }
    for arguments in [
        &["convert", "--in-place", "a.svg"][..],
        &["circle", "5", "-o", "a.svg"],
    ] {
        assert!(run_in(folder.path(), arguments).status.success());
        let kept = xattr::get(&file, "user.origin").unwrap();
        assert_eq!(
            kept.as_deref(),
            Some(&b"drawn by hand"[..]),
            "{arguments:?}"
        );
    }
}

#[test]
fn more_threads_than_files_are_not_started() {
    let folder = folder();
    let threads = run_in(
        folder.path(),
        &["convert", "a.svg", "-j", "5000", "-o", "-"],
    );
    assert!(threads.status.success(), "{}", said(&threads));
    let one = run_in(folder.path(), &["convert", "a.svg", "-j", "1", "-o", "-"]);
    assert_eq!(threads.stdout, one.stdout);
}

#[test]
fn only_plain_files_of_the_folder_are_taken() {
    let outer = folder();
    let inner = outer.path().join("in");
    fs::create_dir_all(inner.join(".hidden")).unwrap();
    fs::write(inner.join("b.svg"), SVG).unwrap();
    fs::write(inner.join(".hidden/c.svg"), SVG).unwrap();
    fs::write(inner.join(".d.svg"), SVG).unwrap();
    symlink("../a.svg", inner.join("out.svg")).unwrap();
    symlink("/dev/zero", inner.join("zero.svg")).unwrap();
    let fifo = inner.join("fifo.svg");
    assert!(
        Command::new("mkfifo")
            .arg(&fifo)
            .status()
            .unwrap()
            .success()
    );
    let output = run_in(outer.path(), &["convert", "--in-place", "in/fifo.svg"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(
        said(&output).contains("in/fifo.svg is no regular file"),
        "{}",
        said(&output)
    );
    let output = run_in(outer.path(), &["convert", "--in-place", "in"]);
    assert!(output.status.success(), "{}", said(&output));
    for name in ["out.svg", "zero.svg", "fifo.svg"] {
        assert!(
            said(&output).contains(&format!("note: in/{name}: is left")),
            "{}",
            said(&output)
        );
    }
    assert_eq!(fs::read_to_string(outer.path().join("a.svg")).unwrap(), SVG);
    assert_eq!(fs::read_to_string(inner.join(".d.svg")).unwrap(), SVG);
    assert!(
        fs::read_to_string(inner.join("b.svg"))
            .unwrap()
            .contains("<path")
    );
    assert!(fs::metadata(&fifo).unwrap().file_type().is_fifo());
    assert!(
        run_in(outer.path(), &["convert", "--in-place", "--hidden", "in"])
            .status
            .success()
    );
    assert!(
        fs::read_to_string(inner.join(".hidden/c.svg"))
            .unwrap()
            .contains("<path")
    );
}

#[test]
fn a_folder_of_results_is_not_walked_and_not_the_input() {
    let folder = folder();
    fs::create_dir(folder.path().join("inner")).unwrap();
    fs::write(folder.path().join("inner/b.svg"), SVG).unwrap();
    for _ in 0..2 {
        assert!(
            run_in(folder.path(), &["convert", ".", "--out-dir", "out"])
                .status
                .success()
        );
        assert!(!folder.path().join("out/out").exists());
        // The next time they are made anew: other folders are walked though there is one of results.
        fs::remove_file(folder.path().join("out/a.svg")).unwrap();
        fs::remove_file(folder.path().join("out/inner/b.svg")).unwrap();
    }
    let output = run_in(folder.path(), &["convert", "a.svg", "--out-dir", "."]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert_eq!(
        fs::read_to_string(folder.path().join("a.svg")).unwrap(),
        SVG
    );
}

/// One of each command that writes.
const WRITERS: [&str; 14] = [
    "circle 3 -p 0",
    "ellipse 3 2",
    "arc 3 --start 0 --sweep 90",
    "conic --from 0,0 --control 5,8 --to 10,0 --weight 0.7",
    "path M0,0A5,5,0,0,1,9,0",
    "spline --points-file points",
    "sphere 3",
    "procset",
    "measure circle 3",
    "compare -m minimax -n 4",
    "explore circle 3 -m minimax -n 4",
    "batch lines",
    "convert a.svg",
    "circle 3 -f png",
];

#[test]
fn what_is_open_already_is_written_through_by_every_command() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("points"), "0 0\n1 0\n1 1\n").unwrap();
    fs::write(at("lines"), "circle 0 0 5\n").unwrap();
    symlink("/dev/stdout", at("link")).unwrap();
    for words in WRITERS {
        let alone = shell(folder.path(), &format!("curveto {words}")).output();
        let expected = [b"a\n", &*alone.unwrap().stdout, b"b\n"].concat();
        assert!(expected.len() > 20, "{words}");
        let ways = [
            ("/dev/stdout", 1, "> f"),
            ("/dev/stdout", 1, "| cat > f"),
            ("/dev/stderr", 2, "2> f"),
            ("/dev/fd/3", 3, "3> f"),
            ("/dev/fd/3", 3, "3>> f"),
            ("/dev/fd/3", 3, "3>&1 | cat > f"),
            ("/dev/stderr", 2, "2>&1 | cat > f"),
            ("/dev/fd/1", 1, "> f"),
            ("link", 1, "> f"),
        ];
        let taken = if words == WRITERS[0] { ways.len() } else { 4 };
        for (name, number, way) in &ways[..taken] {
            let script = format!(
                "rm -f f; {{ echo a >&{number}; curveto {words} -o {name}; echo b >&{number}; }} {way}"
            );
            assert!(shell(folder.path(), &script).status().unwrap().success());
            let found = fs::read(at("f")).unwrap();
            assert!(
                found == expected,
                "{script}: {}",
                String::from_utf8_lossy(&found)
            );
        }
    }
}

#[test]
fn standard_output_may_be_a_socket_or_a_file_without_a_name() {
    let folder = folder();
    for (words, begin) in [("circle 3", "M3 0"), ("convert a.svg", "<svg")] {
        let arguments: Vec<&str> = words.split(' ').chain(["-o", "/dev/stdout"]).collect();
        let (mut here, there) = UnixStream::pair().unwrap();
        let status = program_in(folder.path(), &arguments)
            .stdout(OwnedFd::from(there))
            .status();
        assert!(status.unwrap().success(), "{words}");
        let mut text = String::new();
        here.read_to_string(&mut text).unwrap();
        assert!(text.starts_with(begin), "{text}");
        let mut file = tempfile::tempfile().unwrap();
        let status = program_in(folder.path(), &arguments)
            .stdout(file.try_clone().unwrap())
            .status();
        assert!(status.unwrap().success(), "{words}");
        file.rewind().unwrap();
        assert_eq!(std::io::read_to_string(file).unwrap(), text);
    }
}

#[test]
fn what_is_not_open_is_an_error_and_a_folder_in_memory_is_one_like_any_other() {
    let folder = folder();
    let output = run_in(folder.path(), &["circle", "3", "-o", "/dev/fd/99"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said(&output).starts_with("error: cannot write /dev/fd/99: "),
        "{}",
        said(&output)
    );
    let Ok(memory) = tempfile::tempdir_in("/dev/shm") else {
        eprintln!("skipped: there is no /dev/shm");
        return;
    };
    let file = memory.path().join("new.path");
    for begin in ["M3 ", "M4 "] {
        let words = ["circle", &begin[1..2], "-o", file.to_str().unwrap()];
        assert!(run_in(folder.path(), &words).status.success());
        let text = fs::read_to_string(&file).unwrap();
        assert!(
            text.starts_with(begin) && text.lines().count() == 1,
            "{text}"
        );
    }
}

#[test]
fn endless_input_is_refused() {
    let folder = folder();
    for arguments in [
        ["spline", "--points-file", "/dev/zero"],
        ["measure", "--file", "/dev/zero"],
        ["convert", "/dev/zero", "--check"],
    ] {
        let output = run_in(folder.path(), &arguments);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{arguments:?}");
        assert!(
            said(&output).starts_with("error: /dev/zero"),
            "{}",
            said(&output)
        );
    }
}

#[test]
fn a_signal_ends_between_files_and_says_how_far_it_came() {
    let folder = tempfile::tempdir().unwrap();
    let body = r#"<circle r="5" cx="1.5"/>"#.repeat(20_000);
    for i in 0..60 {
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{body}</svg>");
        fs::write(folder.path().join(format!("{i}.svg")), text).unwrap();
    }
    let child = program_in(folder.path(), &["convert", "--in-place", "-j", "1", "."])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // As soon as one file is done.
    let done = || {
        fs::read_dir(folder.path()).unwrap().any(|entry| {
            let path = entry.unwrap().path();
            path.extension().is_some_and(|e| e == "svg")
                && fs::read(&path).is_ok_and(|b| b.windows(5).take(80).any(|w| w == b"<path"))
        })
    };
    let start = Instant::now();
    while !done() && start.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let pid = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-TERM", &pid])
            .status()
            .unwrap()
            .success()
    );
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(143), "{}", said(&output));
    assert!(
        said(&output).contains("interrupted after"),
        "{}",
        said(&output)
    );
    for entry in fs::read_dir(folder.path()).unwrap() {
        let path = entry.unwrap().path();
        assert!(
            !path
                .file_name()
                .unwrap()
                .to_string_lossy()
                .starts_with(".curveto-")
        );
        assert!(fs::read_to_string(&path).unwrap().ends_with("</svg>"));
    }
}

#[test]
fn two_files_that_lead_to_one_are_refused_and_one_file_by_two_names_is_converted_once() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir_all(at("in")).unwrap();
    fs::create_dir_all(at("out")).unwrap();
    fs::write(at("in/a.svg"), SVG).unwrap();
    fs::write(at("in/b.svg"), SVG).unwrap();
    // Both results would go to one file.
    symlink("a.svg", at("out/b.svg")).unwrap();
    fs::write(at("out/a.svg"), "old").unwrap();
    let output = run_in(folder.path(), &["convert", "in", "--out-dir", "out"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(
        said(&output).contains("would both be written to"),
        "{}",
        said(&output)
    );
    assert_eq!(fs::read_to_string(at("out/a.svg")).unwrap(), "old");
    symlink("a.svg", at("in/c.svg")).unwrap();
    let output = run_in(folder.path(), &["convert", "--in-place", "-v", "in"]);
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("2 of 2 files"), "{}", said(&output));
    assert!(fs::symlink_metadata(at("in/c.svg")).unwrap().is_symlink());
}

#[test]
fn no_result_takes_the_place_of_an_input_or_of_another_result() {
    // What stands below the folder of results, and what is said.
    let rows: [(&[(&str, &str)], &str); 6] = [
        (
            &[("../in/a.svg", "a.svg")],
            "would be written over in/a.svg",
        ),
        (
            &[("../in/sub", "sub")],
            "would be written over in/sub/b.svg",
        ),
        (
            &[("../in/b.svg", "a.svg")],
            "would be written over in/b.svg",
        ),
        (
            &[("real", "a.svg"), ("real", "b.svg")],
            "would both be written",
        ),
        (&[("b.svg", "a.svg")], "would both be written"),
        (&[("sub/b.svg", "a.svg")], "would both be written"),
    ];
    for (links, why) in rows {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("in/sub")).unwrap();
        fs::create_dir_all(at("out")).unwrap();
        for name in ["in/a.svg", "in/b.svg", "in/sub/b.svg"] {
            fs::write(at(name), SVG).unwrap();
        }
        for (target, name) in links {
            symlink(target, at("out").join(name)).unwrap();
        }
        let output = run_in(folder.path(), &["convert", "in", "--out-dir", "out"]);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{links:?}: {}",
            said(&output)
        );
        assert!(said(&output).contains(why), "{links:?}: {}", said(&output));
        for name in ["in/a.svg", "in/b.svg", "in/sub/b.svg"] {
            assert_eq!(fs::read_to_string(at(name)).unwrap(), SVG);
        }
    }
    // A folder of results in which the input lies.
    let folder = folder();
    fs::create_dir_all(folder.path().join("in/in")).unwrap();
    fs::write(folder.path().join("in/a.svg"), SVG).unwrap();
    fs::write(folder.path().join("in/in/a.svg"), SVG).unwrap();
    let output = run_in(folder.path(), &["convert", "in", "--out-dir", "."]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
}

#[test]
fn one_file_by_two_names_is_written_once() {
    let folder = folder();
    fs::create_dir(folder.path().join("in")).unwrap();
    fs::write(folder.path().join("in/b.svg"), SVG).unwrap();
    let words = [
        "convert",
        "in/b.svg",
        "./in//b.svg",
        "in/../in/b.svg",
        "--out-dir",
        "out",
        "-v",
    ];
    let output = run_in(folder.path(), &words);
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("1 circle"), "{}", said(&output));
}

#[test]
fn a_link_that_leads_nowhere_is_left_with_a_note() {
    let folder = folder();
    symlink("nothing", folder.path().join("b.svg")).unwrap();
    symlink("c.svg", folder.path().join("c.svg")).unwrap();
    let output = run_in(folder.path(), &["convert", ".", "--in-place"]);
    assert!(output.status.success(), "{}", said(&output));
    for name in ["b", "c"] {
        let left = format!("note: ./{name}.svg: is left: the link leads nowhere");
        assert!(said(&output).contains(&left), "{}", said(&output));
    }
    // One that is named is what was asked for.
    let output = run_in(folder.path(), &["convert", "b.svg", "--in-place"]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
}

#[test]
fn zeros_after_a_packed_file_fill_it_up() {
    use std::io::Write;
    let folder = folder();
    let mut packed = Vec::new();
    for part in SVG.as_bytes().chunks(20) {
        let mut member = flate2::write::GzEncoder::new(packed, flate2::Compression::best());
        member.write_all(part).unwrap();
        packed = member.finish().unwrap();
    }
    let convert = |more: &[u8]| {
        fs::write(folder.path().join("b.svgz"), [&packed, more].concat()).unwrap();
        run_in(folder.path(), &["convert", "b.svgz", "-o", "b.svg"])
    };
    for zeros in [0, 4, 511] {
        fs::write(folder.path().join("b.svg"), "old").unwrap();
        let output = convert(&vec![0; zeros]);
        assert!(output.status.success(), "{zeros}: {}", said(&output));
        let text = fs::read_to_string(folder.path().join("b.svg")).unwrap();
        assert!(text.contains("<path") && text.ends_with("</svg>"), "{text}");
    }
    for more in [&b"more"[..], &[0, 0, 7], &[0x1f]] {
        let output = convert(more);
        assert_eq!(output.status.code(), Some(1));
        let why = "cannot read it: other bytes follow the packed ones";
        assert!(said(&output).contains(why), "{}", said(&output));
    }
}

#[test]
fn links_to_folders_are_not_walked() {
    // What follows the links stays below the folder all the same.
    let outer = folder();
    fs::create_dir_all(outer.path().join("a/in")).unwrap();
    symlink("..", outer.path().join("a/in/up")).unwrap();
    symlink("../..", outer.path().join("a/in/up.svg")).unwrap();
    let output = run_in(outer.path(), &["convert", "--in-place", "a/in"]);
    assert!(output.status.success(), "{}", said(&output));
    // A link to a folder is no drawing, whatever its name.
    assert!(!said(&output).contains("up.svg"), "{}", said(&output));
    assert_eq!(fs::read_to_string(outer.path().join("a.svg")).unwrap(), SVG);
}

#[test]
fn links_within_the_folder_are_followed_and_those_out_of_it_are_not() {
    let outer = folder();
    let inner = outer.path().join("in/deeper");
    fs::create_dir_all(&inner).unwrap();
    fs::write(inner.join("drawing"), SVG).unwrap();
    symlink("deeper/drawing", outer.path().join("in/within.svg")).unwrap();
    symlink("../a.svg", outer.path().join("in/out.svg")).unwrap();
    let output = run_in(outer.path(), &["convert", "--in-place", "in"]);
    assert!(output.status.success(), "{}", said(&output));
    let left = "out.svg: is left: the link leads out of the folder";
    assert!(said(&output).contains(left), "{}", said(&output));
    assert!(!said(&output).contains("within.svg: is left"));
    let drawing = fs::read_to_string(inner.join("drawing")).unwrap();
    assert!(drawing.contains("<path"), "{drawing}");
    let link = fs::symlink_metadata(outer.path().join("in/within.svg")).unwrap();
    assert!(link.is_symlink());
    assert_eq!(fs::read_to_string(outer.path().join("a.svg")).unwrap(), SVG);
}

#[test]
fn a_mode_that_the_mask_would_not_give_is_kept() {
    let folder = folder();
    let file = folder.path().join("a.svg");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o666)).unwrap();
    let script = "umask 077; curveto convert --in-place a.svg";
    let status = shell(folder.path(), script).status().unwrap();
    assert!(status.success());
    assert_eq!(fs::metadata(&file).unwrap().mode() & 0o777, 0o666);
}

#[test]
fn a_packed_file_with_nothing_to_do_is_copied_byte_by_byte() {
    use std::io::Write;
    let folder = folder();
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::none());
    packed.write_all(b"<svg><path d='M0 0'/></svg>").unwrap();
    let packed = packed.finish().unwrap();
    fs::write(folder.path().join("b.svgz"), &packed).unwrap();
    assert!(
        run_in(folder.path(), &["convert", "b.svgz", "-o", "c.svgz"])
            .status
            .success()
    );
    assert_eq!(fs::read(folder.path().join("c.svgz")).unwrap(), packed);
}

#[test]
fn a_hard_link_keeps_the_old_content_and_a_symbolic_one_leads_to_the_new() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::hard_link(at("a.svg"), at("hard")).unwrap();
    symlink("a.svg", at("soft")).unwrap();
    assert!(
        run_in(folder.path(), &["convert", "a.svg", "-o", "soft"])
            .status
            .success()
    );
    assert_eq!(fs::read_to_string(at("hard")).unwrap(), SVG);
    assert!(fs::symlink_metadata(at("soft")).unwrap().is_symlink());
    assert!(fs::read_to_string(at("a.svg")).unwrap().contains("<path"));
}

#[test]
fn a_link_that_leads_nowhere_yet_is_followed() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    symlink("new.path", at("soft")).unwrap();
    let words = ["circle", "3", "-o", "soft"];
    assert!(run_in(folder.path(), &words).status.success());
    assert!(fs::symlink_metadata(at("soft")).unwrap().is_symlink());
    assert!(
        fs::read_to_string(at("new.path"))
            .unwrap()
            .starts_with("M3 0")
    );
}

#[test]
fn links_that_lead_to_one_another_are_an_error_and_stay() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    symlink("two", at("one")).unwrap();
    symlink("one", at("two")).unwrap();
    // As many as the system follows, and one more.
    symlink("new", at("1")).unwrap();
    for i in 2..=41 {
        symlink((i - 1).to_string(), at(&i.to_string())).unwrap();
    }
    for words in [
        "circle 3 -o one",
        "convert a.svg -o two",
        "batch a.svg -o 41",
    ] {
        let words: Vec<&str> = words.split(' ').collect();
        let output = run_in(folder.path(), &words);
        let why = "too many links lead from one to the next";
        let why = format!("cannot write {}: {why}", words[3]);
        assert_eq!(output.status.code(), Some(1), "{words:?}");
        assert!(said(&output).contains(&why), "{words:?}: {}", said(&output));
        for link in ["one", "two", "41"] {
            assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink());
        }
    }
    let output = run_in(folder.path(), &["circle", "3", "-o", "40"]);
    assert!(output.status.success(), "{}", said(&output));
    assert!(fs::read_to_string(at("new")).unwrap().starts_with("M3 0"));
}

#[test]
fn fifos_and_devices_are_written_to() {
    let folder = folder();
    let fifo = folder.path().join("fifo");
    assert!(
        Command::new("mkfifo")
            .arg(&fifo)
            .status()
            .unwrap()
            .success()
    );
    let reader = {
        let fifo = fifo.clone();
        std::thread::spawn(move || fs::read_to_string(fifo).unwrap())
    };
    assert!(
        run_in(folder.path(), &["circle", "3", "-p", "0", "-o", "fifo"])
            .status
            .success()
    );
    assert!(reader.join().unwrap().starts_with("M3 0"));
    assert!(fs::metadata(&fifo).unwrap().file_type().is_fifo());
    assert!(
        run_in(folder.path(), &["circle", "3", "-o", "/dev/null"])
            .status
            .success()
    );
    assert!(
        fs::metadata("/dev/null")
            .unwrap()
            .file_type()
            .is_char_device()
    );
}

#[test]
fn a_new_file_has_the_mode_of_the_mask_and_is_never_open_to_more_than_the_old_one() {
    let folder = folder();
    let script = "umask 027; curveto circle 3 -o new; curveto convert a.svg -o b.svg";
    let status = shell(folder.path(), script).status().unwrap();
    assert!(status.success());
    for name in ["new", "b.svg"] {
        let mode = fs::metadata(folder.path().join(name)).unwrap().mode() & 0o777;
        assert_eq!(mode, 0o640, "{name}: {mode:o}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_file_name_may_be_of_any_bytes_and_data_is_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;

    let folder = tempfile::tempdir().unwrap();
    let run = |words: &[&[u8]]| {
        let mut command = program_in(folder.path(), &[]);
        command.args(words.iter().map(|word| OsStr::from_bytes(word)));
        command.output().unwrap()
    };
    let name = &b"M\xff.path"[..];
    let power = &b"\xff.json"[..];
    let json = br#"{"x": [0,0,5,0], "y": [0,0,0,5]}"#;
    for (name, data) in [(name, &b"M0 0C0 5 5 10 10 10"[..]), (power, json)] {
        fs::write(folder.path().join(OsStr::from_bytes(name)), data).unwrap();
    }
    for words in [
        &[&b"path"[..], name][..],
        &[b"path", b"--power", power],
        &[b"measure", b"--path", name],
        &[b"diff", name, name],
    ] {
        let output = run(words);
        assert!(output.status.success(), "{words:?}: {}", said(&output));
    }
    for (words, wished) in [
        (
            &[&b"path"[..], b"M0 0L5 \xff"][..],
            "error: cannot read the path: it is no text in UTF-8, from byte 8 on\n",
        ),
        (
            &[b"path", b"--power", b"[\xff]"],
            "error: cannot read the JSON: it is no text in UTF-8, from byte 2 on\n",
        ),
        (&[b"circle", b"\xff"], "hint: names of files"),
    ] {
        let output = run(words);
        assert_eq!(output.status.code(), Some(2), "{words:?}");
        assert!(
            said(&output).contains(wished),
            "{words:?}: {}",
            said(&output)
        );
    }
}
