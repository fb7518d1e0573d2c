//! What happens when things fail: a process is killed, a disk is full, a pipe is closed, a reader stops, someone else writes.

use crate::judges::program::{program_in, run_in, shell};
use crate::judges::random::uniform;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant, SystemTime};

const HEAD: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\">";

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A drawing with so many circles.
fn drawing(circles: usize) -> String {
    HEAD.to_owned() + &"<circle r=\"5\" cx=\"1.5\"/>".repeat(circles) + "</svg>\n"
}

/// The files in a folder that were being made.
fn temporary(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let is_temporary = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy();
        name.starts_with(".curveto-")
    };
    entries.filter(is_temporary).collect()
}

/// The signals that end the program, with the exit codes; not those that it is told to ignore, as SIGINT in a background job of some shells.
fn signals() -> impl Iterator<Item = (&'static str, i32)> + Clone {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .unwrap_or(0);
    let all = [("-INT", 130), ("-TERM", 143), ("-HUP", 129)];
    let is_heard = move |code: i32| ignored >> (code - 129) & 1 == 0;
    all.into_iter().filter(move |&(_, code)| is_heard(code))
}

fn kill(child: &Child, signal: &str) {
    let status = Command::new("kill")
        .args([signal, &child.id().to_string()])
        .status();
    assert!(status.unwrap().success());
}

/// Waits until something holds; not for ever.
fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "{what} never came"
        );
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Kills this many runs at random moments; `make kills` asks for a hundred.
#[test]
fn a_killed_run_leaves_every_file_whole_and_the_next_one_finishes() {
    let kills = std::env::var("CURVETO_KILLS")
        .ok()
        .and_then(|count| count.parse().ok());
    let old = drawing(3000);
    let mut random = 12345_u64;
    let mut running = 0;
    // What the last run took that nobody killed: the moments are spread over it, on a slow machine and on a fast one.
    let mut whole = Duration::from_millis(100);
    for round in 0..kills.unwrap_or(5) {
        let folder = tempfile::tempdir().unwrap();
        let names: Vec<String> = (0..12).map(|i| format!("{i}.svg")).collect();
        for name in &names {
            fs::write(folder.path().join(name), &old).unwrap();
        }
        let new = run_in(folder.path(), &["convert", "0.svg"]).stdout;
        let ways: [&[&str]; 2] = [
            &["convert", "--in-place", "."],
            &["convert", ".", "--out-dir", "out"],
        ];
        let way = ways[round % 2];
        let mut child = program_in(folder.path(), way)
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(whole.mul_f64(uniform(&mut random)));
        running += usize::from(child.try_wait().unwrap().is_none());
        child.kill().unwrap();
        child.wait().unwrap();
        let target = if round % 2 == 0 {
            folder.path().to_owned()
        } else {
            folder.path().join("out")
        };
        let is_whole = |name: &String| match fs::read(target.join(name)) {
            Ok(bytes) => bytes == new || (round % 2 == 0 && bytes == old.as_bytes()),
            Err(_) => round % 2 == 1,
        };
        assert!(names.iter().all(is_whole), "{way:?}, kill {round}");
        if target.is_dir() {
            for left in temporary(&target) {
                let file = File::options().write(true).open(left).unwrap();
                file.set_modified(SystemTime::now() - Duration::from_secs(120))
                    .unwrap();
            }
        }
        let start = Instant::now();
        let again = run_in(folder.path(), way);
        whole = start.elapsed();
        assert!(again.status.success(), "{}", said(&again));
        assert!(
            names
                .iter()
                .all(|name| fs::read(target.join(name)).unwrap() == new)
        );
        assert_eq!(temporary(&target), Vec::<PathBuf>::new(), "{way:?}");
    }
    assert!(running > 0, "every run ended before it was killed");
}

#[test]
fn what_another_run_is_making_and_what_is_not_ours_stays() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("a.svg"), drawing(1)).unwrap();
    let old = |name: &str| {
        let file = File::create(at(name)).unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(120))
            .unwrap();
        file
    };
    let locked = old(".curveto-aB3dE6");
    locked.try_lock().unwrap();
    let ours = [".curveto-notes.txt", ".curveto-no.txt", ".curveto-longname"];
    for name in ours {
        drop(old(name));
    }
    drop(old(".curveto-000000"));
    File::create(at(".curveto-young1")).unwrap();
    assert!(
        run_in(folder.path(), &["convert", "--in-place", "."])
            .status
            .success()
    );
    assert!(at(".curveto-aB3dE6").exists() && ours.iter().all(|name| at(name).exists()));
    assert!(at(".curveto-young1").exists() && !at(".curveto-000000").exists());
    // A process that another test is just starting may still have the file open: unlocking holds for all that share it, closing does not.
    locked.unlock().unwrap();
    assert!(
        run_in(folder.path(), &["convert", "--in-place", "."])
            .status
            .success()
    );
    assert!(!at(".curveto-aB3dE6").exists());
}

/// A small file system, which takes root.
struct SmallDisk(tempfile::TempDir);

impl SmallDisk {
    fn new() -> Option<Self> {
        let folder = tempfile::tempdir().unwrap();
        let mount = Command::new("mount")
            .args(["-t", "tmpfs", "-o", "size=64k", "tmpfs"])
            .arg(folder.path())
            .output();
        if mount.is_ok_and(|output| output.status.success()) {
            return Some(Self(folder));
        }
        eprintln!("skipped: no file system can be mounted here");
        None
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0.path()).status();
    }
}

#[test]
fn a_full_disk_leaves_the_old_file_and_the_message_names_the_target() {
    let Some(disk) = SmallDisk::new() else { return };
    let folder = disk.0.path();
    // Half of the disk; its curves take more than the other half.
    let old = drawing(1200);
    fs::write(folder.join("a.svg"), &old).unwrap();
    let path = folder.join("a.svg");
    let path = path.to_str().unwrap();
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("a.svg"), &old).unwrap();
    let runs: [(&Path, &[&str]); 4] = [
        (folder, &["convert", "--in-place", "a.svg"]),
        (
            folder,
            &["circle", "5", "-n", "5000", "-p", "6", "-o", "a.svg"],
        ),
        (outside.path(), &["convert", "a.svg", "-o", path]),
        (
            outside.path(),
            &["convert", "a.svg", "--out-dir", folder.to_str().unwrap()],
        ),
    ];
    for (at, arguments) in runs {
        let output = run_in(at, arguments);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert!(
            said.contains("a.svg: No space left on device"),
            "{arguments:?}: {said}"
        );
        assert!(!said.contains(".curveto-"), "{said}");
        assert_eq!(fs::read_to_string(path).unwrap(), old, "{arguments:?}");
        assert_eq!(temporary(folder), Vec::<PathBuf>::new(), "{arguments:?}");
    }
    let output = program_in(folder, &["circle", "5", "-n", "5000"])
        .stdout(File::create(folder.join("out")).unwrap())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said(&output).contains("cannot write to standard output: No space left"),
        "{}",
        said(&output)
    );
    let mut batch = program_in(folder, &["batch"])
        .stdin(Stdio::piped())
        .stdout(File::create(folder.join("out")).unwrap())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // It may have ended before it has read all of them.
    let _ = batch
        .stdin
        .take()
        .unwrap()
        .write_all("circle 0 0 5\n".repeat(5000).as_bytes());
    let output = batch.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said(&output).contains("cannot write to standard output: No space left"),
        "{}",
        said(&output)
    );
}

/// Commands that write more than a pipe holds, or at least something.
const TALKERS: [&[&str]; 16] = [
    &["circle", "5", "-n", "20000"],
    &["circle", "5", "-n", "3000", "-f", "json"],
    &["circle", "5", "-f", "png", "--size", "900x900"],
    &["ellipse", "5", "3", "-f", "pdf"],
    &["arc", "5", "--sweep", "90", "-f", "dxf"],
    &["path", "M0 0C1 2 3 4 5 6", "--to", "lines", "-t", "1e-9"],
    &["spline", "--points", "0,0 1,0 1,1"],
    &["sphere", "5", "-f", "svg"],
    &["procset"],
    &["methods", "-f", "json"],
    &["measure", "circle", "5", "-n", "500", "-f", "json"],
    &["compare", "-m", "minimax", "-f", "html"],
    &["completions", "bash"],
    &["man"],
    &["convert", "large.svg"],
    &["convert", "large.svg", "--check"],
];

#[test]
fn a_pipe_that_is_closed_at_any_stage_ends_every_command_quietly() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("large.svg"), drawing(3000)).unwrap();
    for arguments in TALKERS {
        for taken in [0, 1, 4000] {
            let mut child = program_in(folder.path(), arguments)
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            let mut out = child.stdout.take().unwrap();
            std::io::copy(&mut (&mut out).take(taken), &mut std::io::sink()).unwrap();
            drop(out);
            let output = child.wait_with_output().unwrap();
            let expected =
                i32::from(arguments.contains(&"--check") && output.status.code() == Some(1));
            assert_eq!(
                output.status.code(),
                Some(expected),
                "{arguments:?} after {taken} bytes: {}",
                said(&output)
            );
            assert!(
                !said(&output).contains("error"),
                "{arguments:?}: {}",
                said(&output)
            );
        }
    }
}

#[test]
fn every_command_says_that_standard_output_is_full() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("large.svg"), drawing(10)).unwrap();
    for arguments in TALKERS.into_iter().chain([&["circle", "--help"][..]]) {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = program_in(folder.path(), arguments)
            .stdout(full)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(
            said(&output).contains("cannot write to standard output: No space left on device\n"),
            "{arguments:?}: {}",
            said(&output)
        );
    }
}

#[test]
fn a_closed_standard_error_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("a.svg"),
        format!("{HEAD}<circle r=\"5%\"/></svg>"),
    )
    .unwrap();
    for (words, code) in [
        ("circle 5 -v", 0),
        ("circle nan", 2),
        ("convert a.svg -v", 0),
        ("convert nosuch.svg", 1),
    ] {
        let script = format!("curveto {words} 2>&- >/dev/null");
        let status = shell(folder.path(), &script).status().unwrap();
        assert_eq!(status.code(), Some(code), "{words}");
        let script = format!("curveto {words} 2>/dev/full >/dev/null");
        let status = shell(folder.path(), &script).status().unwrap();
        assert_eq!(status.code(), Some(code), "{words}");
    }
}

#[test]
fn batch_waits_for_a_reader_that_stops_and_ends_when_it_goes() {
    for jobs in ["1", "3"] {
        let mut child = program_in(Path::new("."), &["batch", "-j", jobs])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut input = child.stdin.take().unwrap();
        let writer = std::thread::spawn(move || {
            let lines = "circle 0 0 5\n".repeat(1000);
            (0..300).try_for_each(|_| input.write_all(lines.as_bytes()))
        });
        let mut answers = BufReader::new(child.stdout.take().unwrap());
        let mut line = String::new();
        answers.read_line(&mut line).unwrap();
        std::thread::sleep(Duration::from_millis(300));
        // All of it would be 30 MB; what is not taken is not made.
        assert!(
            !writer.is_finished(),
            "it reads on although nobody takes its answers"
        );
        for _ in 0..1000 {
            line.clear();
            answers.read_line(&mut line).unwrap();
            assert!(line.starts_with("M5 0C"), "{line}");
        }
        drop(answers);
        assert!(child.wait().unwrap().success());
        // Its pipe is closed, too.
        assert!(writer.join().unwrap().is_err());
    }
}

#[test]
fn every_signal_ends_a_run_between_files() {
    for (signal, code) in signals() {
        let folder = tempfile::tempdir().unwrap();
        for i in 0..40 {
            fs::write(folder.path().join(format!("{i:02}.svg")), drawing(3000)).unwrap();
        }
        let child = program_in(
            folder.path(),
            &["convert", "-j", "1", ".", "--out-dir", "out"],
        )
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
        wait_until("the first file", || {
            folder.path().join("out/00.svg").exists()
        });
        kill(&child, signal);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{}", said(&output));
        assert!(
            said(&output).contains("error: interrupted after"),
            "{}",
            said(&output)
        );
        assert_eq!(temporary(&folder.path().join("out")), Vec::<PathBuf>::new());
    }
}

#[test]
fn one_signal_ends_a_run_that_waits_for_a_fifo() {
    for (signal, code) in signals() {
        for (words, writer) in [
            ("in.svg --out-dir out", false),
            ("a.svg in.svg b.svg -j 1 --out-dir out", false),
            ("a.svg in.svg b.svg -j 3 --out-dir out", true),
        ] {
            let folder = tempfile::tempdir().unwrap();
            assert!(
                shell(folder.path(), "mkfifo in.svg")
                    .status()
                    .unwrap()
                    .success()
            );
            for name in ["a.svg", "b.svg"] {
                fs::write(folder.path().join(name), drawing(3)).unwrap();
            }
            let words: Vec<&str> = ["convert"].into_iter().chain(words.split(' ')).collect();
            let mut child = program_in(folder.path(), &words)
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            // One that writes nothing is waited for in reading.
            let held = writer.then(|| {
                let fifo = folder.path().join("in.svg");
                fs::File::options().write(true).open(fifo).unwrap()
            });
            std::thread::sleep(Duration::from_millis(100));
            kill(&child, signal);
            wait_until("the end", || child.try_wait().unwrap().is_some());
            let status = child.wait().unwrap();
            // A signal that comes before the program listens ends it by itself.
            let ended = status.code().or_else(|| Some(128 + status.signal()?));
            assert_eq!(ended, Some(code), "{words:?}");
            drop(held);
            let out = folder.path().join("out");
            for place in [folder.path(), &out]
                .into_iter()
                .filter(|place| place.exists())
            {
                assert_eq!(temporary(place), Vec::<PathBuf>::new());
            }
        }
    }
}

/// Feeds `batch -o` a line and waits for its answer: from that moment on a signal is heard.
fn first_line_answered(folder: &Path, child: &mut Child) -> std::process::ChildStdin {
    wait_until("the new file", || !temporary(folder).is_empty());
    let mut input = child.stdin.take().unwrap();
    input.write_all(b"circle 0 0 5\n").unwrap();
    wait_until("the answer", || {
        let written = |path: &PathBuf| fs::metadata(path).is_ok_and(|data| data.len() > 0);
        temporary(folder).iter().any(written)
    });
    input
}

#[test]
fn a_signal_removes_what_batch_was_writing_and_leaves_the_old_file() {
    for (signal, code) in signals() {
        let folder = tempfile::tempdir().unwrap();
        let old = folder.path().join("shapes.json");
        fs::write(&old, "old").unwrap();
        let mut child = program_in(folder.path(), &["batch", "-o", "shapes.json"])
            .stdin(Stdio::piped())
            .spawn()
            .unwrap();
        let input = first_line_answered(folder.path(), &mut child);
        kill(&child, signal);
        assert_eq!(child.wait().unwrap().code(), Some(code));
        drop(input);
        assert_eq!(temporary(folder.path()), Vec::<PathBuf>::new());
        assert_eq!(fs::read_to_string(&old).unwrap(), "old");
    }
}

/// A drawing of which little is to be converted, and much to be written.
fn long_drawing() -> String {
    let comment = format!("<!--{}-->\n", "x".repeat(100));
    HEAD.to_owned() + &comment.repeat(60_000) + "<circle r=\"5\"/></svg>\n"
}

#[test]
fn a_signal_at_any_moment_leaves_the_old_file_or_the_new_one_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("long.svg"), long_drawing()).unwrap();
    fs::write(at("lines"), "circle 0 0 5\n".repeat(300)).unwrap();
    fs::create_dir(at("out")).unwrap();
    let mut random = 54321_u64;
    let mut caught = 0;
    for words in [
        &["convert", "long.svg", "-o", "out/x"][..],
        &["circle", "5", "-n", "3000", "-o", "out/x"],
        &["batch", "lines", "-f", "svg", "-o", "out/x"],
    ] {
        let start = Instant::now();
        assert!(run_in(folder.path(), words).status.success());
        let (whole, new) = (start.elapsed(), fs::read(at("out/x")).unwrap());
        for (round, (signal, code)) in signals().cycle().take(6).enumerate() {
            fs::write(at("out/x"), "old").unwrap();
            let mut child = program_in(folder.path(), words).spawn().unwrap();
            if round % 3 == 0 {
                std::thread::sleep(whole.mul_f64(uniform(&mut random)));
            } else {
                // Just when it is being written.
                let ended = || fs::metadata(at("out/x")).unwrap().len() != 3;
                wait_until("the new file", || {
                    ended() || !temporary(&at("out")).is_empty()
                });
            }
            kill(&child, signal);
            let status = child.wait().unwrap();
            caught += usize::from(status.code() == Some(code));
            // Before a file is made, the signal ends the program by itself.
            let by_signal = status.signal().map(|number| 128 + number);
            assert!(
                [0, code].contains(&status.code().or(by_signal).unwrap()),
                "{words:?}: {status}"
            );
            assert_eq!(temporary(&at("out")), Vec::<PathBuf>::new(), "{words:?}");
            let left = fs::read(at("out/x")).unwrap();
            assert!(
                left == new || (left == b"old" && !status.success()),
                "{words:?}"
            );
        }
    }
    assert!(caught > 0, "no signal came while a file was being made");
}

#[test]
fn a_file_that_would_be_larger_than_the_process_may_make_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let larger = |place: &str, name: &str| {
        let script = format!("ulimit -f 8; curveto circle 5 -n 5000 {place}");
        let output = shell(folder.path(), &script).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{}", said(&output));
        let expected = format!("error: cannot write {name}: File too large");
        assert!(said(&output).starts_with(&expected), "{}", said(&output));
    };
    larger("-o x", "x");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    larger("> x", "to standard output");
}

/// As under `nohup`.
#[test]
#[cfg(target_os = "linux")]
fn a_signal_that_is_ignored_ends_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let script = "trap '' HUP; exec \"$0\" batch -o shapes.txt";
    let mut child = Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_curveto")])
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = first_line_answered(folder.path(), &mut child);
    kill(&child, "-HUP");
    input.write_all(b"circle 0 0 6\n").unwrap();
    drop(input);
    assert!(child.wait().unwrap().success());
    let text = fs::read_to_string(folder.path().join("shapes.txt")).unwrap();
    assert_eq!(text.lines().count(), 2);
}

#[test]
fn a_file_that_changes_while_it_is_converted_is_left_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    let text = drawing(200_000);
    fs::write(&path, &text).unwrap();
    let child = program_in(folder.path(), &["convert", "--in-place", "a.svg"])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The file is in memory and is being converted.
    let status = format!("/proc/{}/io", child.id());
    wait_until("its reading", || {
        let io = fs::read_to_string(&status).unwrap_or_default();
        let read = io.lines().find_map(|line| line.strip_prefix("rchar: "));
        read.is_some_and(|count| count.parse::<usize>().unwrap() > text.len())
    });
    let mut file = File::options().append(true).open(&path).unwrap();
    file.write_all(b"<!-- mine -->").unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(
        said(&output).contains("changed by someone else"),
        "{}",
        said(&output)
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), text + "<!-- mine -->");
    assert_eq!(temporary(folder.path()), Vec::<PathBuf>::new());
}

#[test]
fn in_place_has_each_file_on_its_disk_before_it_takes_its_place_and_each_folder_at_the_end() {
    if Command::new("strace").arg("-V").output().is_err() {
        eprintln!("skipped: there is no strace");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.svg", "b.svg"] {
        fs::write(folder.path().join(name), drawing(1)).unwrap();
    }
    let calls = |arguments: &[&str]| {
        let log = folder.path().join("log");
        let status = Command::new("strace")
            .args([
                "-f",
                "-y",
                "-e",
                "trace=fsync,rename,renameat,renameat2",
                "-o",
            ])
            .arg(&log)
            .arg(env!("CARGO_BIN_EXE_curveto"))
            .args(arguments)
            .current_dir(folder.path())
            .status();
        assert!(status.unwrap().success());
        let log = fs::read_to_string(log).unwrap();
        log.lines()
            .filter_map(|line| {
                let call = line.split_once(' ')?.1.trim_start();
                let kind = if call.starts_with("fsync(") && call.contains(".curveto-") {
                    "file"
                } else if call.starts_with("fsync(") {
                    "folder"
                } else if call.starts_with("rename") {
                    "rename"
                } else {
                    return None;
                };
                Some(kind)
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(
        calls(&["convert", ".", "--out-dir", "out"]),
        ["rename", "rename"]
    );
    let in_place = calls(&["convert", "--in-place", "-j", "1", "a.svg", "b.svg"]);
    assert_eq!(in_place, ["file", "rename", "file", "rename", "folder"]);
    assert_eq!(
        calls(&["convert", "--in-place", "a.svg"]),
        Vec::<&str>::new()
    );
}

#[test]
fn what_takes_the_place_of_a_private_file_is_private_from_its_first_moment() {
    if Command::new("strace").arg("-V").output().is_err() {
        eprintln!("skipped: there is no strace");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg");
    fs::write(&file, drawing(1)).unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    let log = folder.path().join("log");
    let status = Command::new("strace")
        .args(["-f", "-e", "trace=open,openat", "-o"])
        .arg(&log)
        .arg(env!("CARGO_BIN_EXE_curveto"))
        .args(["convert", "--in-place", "a.svg"])
        .current_dir(folder.path())
        .status();
    assert!(status.unwrap().success());
    let log = fs::read_to_string(log).unwrap();
    let made = log
        .lines()
        .find(|line| line.contains("O_CREAT") && line.contains(".curveto-"));
    assert!(made.unwrap().contains(", 0600)"), "{made:?}");
}
