//! How much memory the program takes at most: `convert` by the size of its file, `batch` however long its input is.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Stdio};

use crate::judges::program::program;

const MIB: usize = 1 << 20;

fn curveto(args: &[&str]) -> Child {
    let mut command = program(args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    command.stderr(Stdio::null()).spawn().unwrap()
}

/// The largest memory that a living process has had in RAM, in bytes.
fn peak(process: &Child) -> usize {
    let status = std::fs::read_to_string(format!("/proc/{}/status", process.id())).unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM:"));
    let kib = line.unwrap().split_whitespace().nth(1).unwrap();
    kib.parse::<usize>().unwrap() * 1024
}

/// The peak of a conversion from a file to standard output. The result is whole before its first byte is written, and more than a
/// pipe holds keeps the process waiting, so nothing depends on the moment of looking.
fn convert_peak(text: &str) -> usize {
    let mut file = tempfile::NamedTempFile::with_suffix(".svg").unwrap();
    file.write_all(text.as_bytes()).unwrap();
    let mut child = curveto(&["convert", file.path().to_str().unwrap()]);
    let mut out = child.stdout.take().unwrap();
    out.read_exact(&mut [0]).unwrap();
    let peak = peak(&child);
    std::io::copy(&mut out, &mut std::io::sink()).unwrap();
    assert!(child.wait().unwrap().success());
    peak
}

/// A drawing of so many bytes: icons with a circle, a rectangle, arcs and other things.
fn icons(bytes: usize) -> String {
    let icon = r#"<g class="icon" fill="none" stroke="currentColor" stroke-width="2" stroke-linejoin="round">
  <!-- an icon -->
  <circle cx="12" cy="12" r="10" />
  <path d="m14.31 8 5.74 9.94M9.69 8h11.48a2 2 0 0 1 1.71 1.06L14 20H3.95a2 2 0 0 1-1.7-3.06L7.38 12" />
  <path d="M4 6c0-1.66 3.58-3 8-3s8 1.34 8 3-3.58 3-8 3-8-1.34-8-3zm0 12h16l-3.5-4.5-4 2-3-3z" />
  <rect width="18" height="18" x="3" y="3" rx="2" /><line x1="12" x2="12" y1="8" y2="12" />
</g>
"#;
    let icons = icon.repeat(bytes / icon.len());
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 24 24\">\n{icons}</svg>\n")
}

#[test]
fn convert_takes_at_most_three_times_its_file() {
    let small = convert_peak(&icons(MIB / 4));
    for size in [4 * MIB, 8 * MIB] {
        let times = (convert_peak(&icons(size)) - small) as f64 / size as f64;
        assert!(times < 3.0, "{times} times {size} bytes");
    }
}

#[test]
fn a_style_sheet_takes_at_most_four_times_its_size() {
    let sheet = |size: usize, rule: &dyn Fn(usize) -> String| {
        let mut rules = String::new();
        let mut number = 0;
        while rules.len() < size {
            rules += &rule(number);
            number += 1;
        }
        format!("<svg><style>{rules}</style><circle class='c7' r='5'/></svg>")
    };
    let kinds: [&dyn Fn(usize) -> String; 5] = [
        &|_| "circle{r:1px}".to_owned(),
        &|i| format!(".c{i}{{r:1px}}"),
        &|i| format!("c{i}:not(path){{marker:url(#m)}}"),
        &|i| format!(".c.d{i}:is(a,path,#b{i}),"),
        &|i| format!("a{i}:b;"),
    ];
    for (index, kind) in kinds.iter().enumerate() {
        let peak = |size: usize| convert_peak(&sheet(size, kind)) as f64;
        let size = 2 * MIB;
        let times = (peak(2 * size) - peak(size)) / size as f64;
        assert!(times < 4.0, "{times} times its size for kind {index}");
    }
}

#[test]
fn notes_take_little_more_than_what_they_tell_about() {
    let element = "<circle cx=\"50%\" cy=\"50%\" r=\"45%\" fill=\"none\" stroke=\"black\"/>\n";
    let text = |count: usize| format!("<svg>{}</svg>", element.repeat(count));
    let count = 4 * MIB / element.len();
    let times =
        (convert_peak(&text(count)) - convert_peak(&text(count / 16))) as f64 / (4 * MIB) as f64;
    assert!(times < 3.0, "{times} times its size");
}

#[test]
fn batch_stays_below_64_mib_however_long_its_input() {
    let mut child = curveto(&["batch", "-j", "2", "-p", "2"]);
    let mut input = child.stdin.take().unwrap();
    let answers = BufReader::new(child.stdout.take().unwrap());
    let reader = std::thread::spawn(move || answers.lines().count());
    let lines = "arc 0 0 12.5 0 90\n".repeat(1000);
    let mut after = |rounds: usize| {
        for _ in 0..rounds {
            input.write_all(lines.as_bytes()).unwrap();
        }
        peak(&child)
    };
    let (early, late) = (after(100), after(300));
    drop(input);
    assert_eq!(reader.join().unwrap(), 400 * 1000);
    assert!(child.wait().unwrap().success());
    assert!(late < 64 * MIB, "{late} bytes");
    assert!(late - early < 8 * MIB, "{early} bytes, then {late}");
}

#[test]
fn batch_holds_one_long_answer_a_thread() {
    let count = 60;
    for jobs in ["1", "2"] {
        let mut child = curveto(&["batch", "-j", jobs, "-p", "2"]);
        let mut input = child.stdin.take().unwrap();
        // All lines in one chunk; each answer is some 2 MB.
        let line = "{\"circle\":{\"center\":[0,0],\"radius\":50},\"segments\":40000}\n";
        input.write_all(line.repeat(count).as_bytes()).unwrap();
        let mut answers = BufReader::new(child.stdout.take().unwrap());
        let mut text = Vec::new();
        let mut all = 0;
        for _ in 0..count {
            text.clear();
            all += answers.read_until(b'\n', &mut text).unwrap();
        }
        let peak = peak(&child);
        drop(input);
        assert!(child.wait().unwrap().success());
        assert!(all > 64 * MIB, "{all} bytes of answers");
        assert!(peak < 48 * MIB, "{peak} bytes with -j {jobs}");
    }
}
