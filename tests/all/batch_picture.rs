//! `batch` with all lines in one picture, and into a file.

use std::fs;

use curveto::batch::{OnError, Options, figure};

use crate::judges::program::{piped, printed, refused, run};

const LINES: &str = r#"circle 0 0 50
{"id": "a<1\"", "circle": {"radius": 20}, "fill": "gold", "stroke": "none"}

{"id": 7, "path": "M-60-60h120v120h-120zM-55-55v110h110v-110z", "fill": "rebeccapurple", "stroke_width": 3}
polyline 0 0 1 10 0 0 10 10 0 close
"#;

fn file(name: &str, text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

#[test]
fn an_svg_document_has_every_shape_in_order_with_its_look() {
    let (_folder, lines) = file("lines", LINES);
    let svg = printed(&["batch", &lines, "-f", "svg", "--stroke", "teal"]);
    let paths: Vec<&str> = svg
        .lines()
        .filter(|line| line.starts_with("<path"))
        .collect();
    assert_eq!(paths.len(), 4);
    assert!(paths[0].contains("stroke=\"#008080\"") && !paths[0].contains("id="));
    assert!(paths[1].contains("id=\"a&lt;1&quot;\"") && paths[1].contains("fill=\"#ffd700\""));
    assert!(!paths[1].contains("stroke="));
    assert!(paths[2].contains("id=\"7\"") && paths[2].contains("stroke-width=\"3\""));
    // The document is XML, and its shapes are those of single commands.
    let shapes = curveto::document::svg_shapes(&svg).unwrap().paths;
    assert_eq!(shapes[2].contours.as_ref().unwrap().0.len(), 2);
    assert!(paths[0].contains(printed(&["circle", "50"]).trim()));
}

#[test]
fn every_format_of_pictures_takes_a_batch() {
    let (folder, lines) = file("lines", LINES);
    for format in ["svg", "eps", "png", "pdf", "dxf", "glif", "tikz", "canvas"] {
        let out = folder.path().join(format!("batch.{format}"));
        printed(&["batch", &lines, "-o", out.to_str().unwrap()]);
        let bytes = fs::read(&out).unwrap();
        assert!(bytes.len() > 500, "{format}");
        let direct = run(&["batch", &lines, "-f", format]).stdout;
        assert_eq!(bytes, direct, "{format}");
    }
    let tikz = fs::read_to_string(folder.path().join("batch.tikz")).unwrap();
    assert!(tikz.contains(" % a<1\"\n") && tikz.matches("\\draw").count() == 5);
    let canvas = fs::read_to_string(folder.path().join("batch.canvas")).unwrap();
    assert!(canvas.contains("moveTo(20, 0) // a<1\"\n"));
    assert!(
        canvas
            .lines()
            .all(|line| line.starts_with(|c: char| c.is_ascii_lowercase()))
    );
    let glif = fs::read_to_string(folder.path().join("batch.glif")).unwrap();
    assert_eq!(glif.matches(" name=\"a&lt;1&quot;\"/>\n").count(), 1);
    let eps = fs::read_to_string(folder.path().join("batch.eps")).unwrap();
    assert!(eps.contains("\n% a<1\"\ngsave\n") && eps.contains("\n% 7\ngsave\n"));
    let pdf = fs::read(folder.path().join("batch.pdf")).unwrap();
    let pdf = String::from_utf8_lossy(&pdf);
    assert!(pdf.contains("/Shape <<\n  /ID (a<1\")\n>> BDC\nq\n"));
    assert_eq!(
        (
            pdf.matches("BDC\n").count(),
            pdf.matches("Q\nEMC\n").count()
        ),
        (2, 2)
    );
    let dxf = fs::read_to_string(folder.path().join("batch.dxf")).unwrap();
    let count = |dxf: &str, name: &str| dxf.matches(&format!("\n{name}\n")).count();
    assert!(dxf.contains("\na_1_\n"));
    assert_eq!((count(&dxf, "SPLINE"), count(&dxf, "LWPOLYLINE")), (2, 3));
    let curves = printed(&["batch", &lines, "-f", "dxf", "-n", "4"]);
    assert_eq!(count(&curves, "SPLINE"), 3);
    refused(&["batch", &lines, "-f", "gcode"]);
    refused(&["batch", &lines, "--fill", "red"]);
    refused(&["batch", &lines, "-o", "x.nosuch"]);
}

#[test]
fn a_hole_is_a_hole_in_pixels() {
    let ring =
        r#"{"path": "M0 0h100v100h-100zM20 20v60h60v-60z", "fill": "black", "stroke": "none"}"#;
    let (folder, lines) = file("ring", ring);
    let out = folder.path().join("ring.png");
    printed(&[
        "batch",
        &lines,
        "--size",
        "50x50",
        "-o",
        out.to_str().unwrap(),
    ]);
    let pixmap = resvg::tiny_skia::Pixmap::load_png(&out).unwrap();
    assert_eq!(pixmap.pixel(25, 25).unwrap().red(), 255);
    assert_eq!(pixmap.pixel(5, 25).unwrap().red(), 0);
}

#[test]
fn a_file_is_whole_or_untouched() {
    let (folder, out) = file("out.txt", "old\n");
    let feed = |lines: &str, words: &[&str]| {
        let words = [&["batch", "-o", &out], words].concat();
        let code = piped(&words, lines.as_bytes()).status.code();
        (code, fs::read_to_string(&out).unwrap())
    };
    assert_eq!(
        feed("circle 0 0 5\nnonsense\n", &[]),
        (Some(1), "old\n".to_owned())
    );
    assert_eq!(
        feed("circle 0 0 5\nnonsense\n", &["-f", "svg"]),
        (Some(1), "old\n".to_owned())
    );
    let (code, text) = feed("circle 0 0 5\nnonsense\n\n", &["--on-error", "blank"]);
    assert_eq!((code, text.lines().count()), (Some(1), 3));
    let (code, text) = feed("\u{feff}circle 0 0 5\n", &[]);
    assert_eq!(code, Some(0));
    assert_eq!(text, printed(&["circle", "5"]));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_picture_has_bounds() {
    // An arc without radii is a line, which takes no time.
    let lines = "svgarc 0 0 0 0 0 0 0 1 1\n".repeat(curveto::batch::MOST_SHAPES + 1);
    let error = figure(lines.as_bytes(), &Options::default(), |_, _| ()).unwrap_err();
    assert!(
        error.to_string().contains("at most 100000 shapes"),
        "{error}"
    );
    let options = Options {
        on_error: OnError::Skip,
        ..Options::default()
    };
    let mut bad = Vec::new();
    let lines = "\u{feff}circle 0 0 1\n\ncircle 0 0 x\n# no\ncircle 5 5 1";
    let picture = figure(lines.as_bytes(), &options, |line, _| bad.push(line)).unwrap();
    assert_eq!(
        (bad, picture.summary.lines, picture.figure.layers.len()),
        (vec![3], 5, 2)
    );
    assert!(
        curveto::batch::spec::Spec::parse(r#"{"circle": {"radius": 1}, "fill": "redd"}"#).is_err()
    );
    assert!(
        curveto::batch::spec::Spec::parse(r#"{"circle": {"radius": 1}, "stroke_width": -1}"#)
            .is_err()
    );
}
