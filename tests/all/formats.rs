//! Which format a file gets, and that a plot is one picture in all of its formats.

use crate::judges::ghostscript;
use std::fs;
use std::path::Path;
use std::process::Output;

use crate::judges::raster::Picture;
use resvg::tiny_skia::Pixmap;

use crate::judges::program::{self, run_in, words};

fn curveto(folder: &Path, arguments: &str) -> Output {
    run_in(folder, &words(arguments))
}

/// The file that a command writes.
fn written(folder: &Path, arguments: &str, file: &str) -> Vec<u8> {
    let output = curveto(folder, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "curveto {arguments}: {message}");
    fs::read(folder.join(file)).unwrap()
}

#[test]
fn an_unknown_extension_is_refused_with_the_formats_of_the_command() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("points"), "0,0 1,1").unwrap();
    for (arguments, list) in [
        ("circle 5 -o part.ai", "path, svg, "),
        ("ellipse 5 3 -o part.dwg", "path, svg, "),
        ("arc 5 --end 90 -o part.jpg", "path, svg, "),
        ("spline --points-file points -o part.v2", "path, svg, "),
        ("sphere 5 -o part.svgz", "path, svg, "),
        ("compare -o c.xyz", "table, csv, "),
        ("measure circle 5 -o m.svg", "table, json and csv"),
        ("measure circle 5 --plot m.json", "svg, "),
    ] {
        let output = curveto(folder.path(), arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {message}");
        let hint = message.lines().find(|line| line.starts_with("hint: "));
        assert!(
            message.starts_with("error: ") && hint.is_some_and(|hint| hint.contains(list)),
            "{arguments}: {message}"
        );
        assert!(
            arguments.contains("--plot") || message.contains("-f names one"),
            "{arguments}: {message}"
        );
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_plot_without_an_extension_is_svg() {
    let folder = tempfile::tempdir().unwrap();
    let plotted = |words: &str| {
        let output = program::shell(folder.path(), &format!("curveto {words}"))
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), message)
    };
    assert_eq!(plotted("measure circle 5 --plot named.svg").0, Some(0));
    let right = fs::read(folder.path().join("named.svg")).unwrap();
    assert!(right.starts_with(b"<svg") || right.starts_with(b"<?xml"));
    for words in [
        "measure circle 5 --plot a",
        "measure circle 5 --plot /dev/fd/3 3>a",
        "measure circle 5 -o report.txt --plot - >a",
    ] {
        assert_eq!(plotted(words).0, Some(0), "{words}");
        let plot = folder.path().join("a");
        assert_eq!(fs::read(&plot).unwrap(), right, "{words}");
        fs::remove_file(plot).unwrap();
    }
    // One place cannot hold both.
    for words in [
        "measure circle 5 --plot -",
        "measure circle 5 --plot /dev/stdout",
    ] {
        let (code, message) = plotted(words);
        assert_eq!(code, Some(2), "{words}");
        assert!(message.contains("both go to standard output") && message.contains("hint: "));
    }
}

#[test]
fn the_extension_tells_the_format_unless_it_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = curveto(folder.path(), "circle 5").stdout;
    for file in ["a.path", "b.txt", "c", "d.TXT", ".hidden"] {
        let text = written(folder.path(), &format!("circle 5 -o {file}"), file);
        assert_eq!(text, path, "{file}");
    }
    let table = curveto(folder.path(), "compare -n 4").stdout;
    for file in ["e", "f.txt"] {
        let text = written(folder.path(), &format!("compare -n 4 -o {file}"), file);
        assert_eq!(text, table, "{file}");
    }
    let named = written(folder.path(), "circle 5 -f path -o g.ai", "g.ai");
    assert_eq!(named, path);
    let loud = curveto(folder.path(), "circle 5 -f SVG").stdout;
    assert_eq!(written(folder.path(), "circle 5 -o h.Svg", "h.Svg"), loud);
}

#[test]
fn a_plot_in_eps_is_the_one_in_png_words_and_all() {
    // Ghostscript paints every pixel that a shape touches: the finer the pixels the less it adds.
    const FINER: u32 = 8;
    let folder = tempfile::tempdir().unwrap();
    for plot in [
        "compare -m minimax,chen-3,apprich -o",
        "measure ellipse 3 2 -m apprich,midpoint --quantity curvature-d1 --plot",
    ] {
        let png = written(
            folder.path(),
            &format!("{plot} p.png --size 480x300"),
            "p.png",
        );
        let png = Picture::new(&Pixmap::decode_png(&png).unwrap());
        let eps = written(
            folder.path(),
            &format!("{plot} p.eps --size 480x300"),
            "p.eps",
        );
        let eps = String::from_utf8(eps).unwrap();
        assert!(eps.contains("%%BoundingBox: 0 0 480 300\n"), "{plot}");
        let eps = Picture::new(&ghostscript::picture(&eps, FINER)).reduced(FINER as usize);
        let (_, mean) = eps.difference(&png);
        let (_, mirrored) = eps.difference(&png.upside_down());
        assert!(
            mean <= 12.0 && mirrored > 5.0 * mean,
            "{plot}: {mean}, mirrored {mirrored}"
        );
    }
}
