//! PDF files: what pdftoppm of Poppler makes of them, and that they hold the very control points.

use std::fs;
use std::process::Command;

use crate::judges::program::{drawn, drawn_text, refused};
use crate::judges::raster::Picture;
use resvg::tiny_skia::Pixmap;

/// The first page of a PDF file on white, so many pixels a point.
fn page(pdf: &[u8], pixels: u32) -> Picture {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file.pdf");
    fs::write(&file, pdf).unwrap();
    let output = Command::new("pdftoppm")
        .args(["-png", "-singlefile", "-r", &(72 * pixels).to_string()])
        .args([&file, &folder.path().join("page")])
        .output()
        .unwrap_or_else(|error| {
            panic!("pdftoppm does not run ({error}): this test needs Poppler; install it with 'apt-get install poppler-utils'")
        });
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && message.is_empty(), "{message}");
    let png = fs::read(folder.path().join("page.png")).unwrap();
    Picture::new(&Pixmap::decode_png(&png).unwrap())
}

#[test]
fn pdftoppm_draws_our_pdf_as_the_mirror_image_of_our_png() {
    // Poppler moves thin strokes to whole pixels: the finer the pixels the less it moves them.
    const FINER: u32 = 8;
    for shape in [
        "circle 50 --stroke-width 3",
        "ellipse 100 40 --rotation 30 --center 70,-20 --fill teal --stroke none",
        "circle 50 -m quadratic-area -n 5 --fill rgb(255_0_0/50%) --stroke #00f8 --background #eee",
        "arc 60 20 --start -40 --sweep 250 --rotation 20 --show joints,handles,truth,error=500 --background #ddd",
        "spline --points 0,0_10,20_30,10_40,40 --stroke-width 1",
        "sphere 100 --view 10,35 --stroke-width 4",
    ] {
        let png = drawn(&format!("{shape} --size 160x120 -f png"));
        let png = Picture::new(&Pixmap::decode_png(&png).unwrap());
        let pdf = drawn(&format!("{shape} --size 160x120 -f pdf"));
        let pdf = page(&pdf, FINER).reduced(FINER as usize);
        // On every page the north of a sphere is up.
        let (as_drawn, mirrored) = (&png, &png.upside_down());
        let (like, other) = if shape.starts_with("sphere") {
            (as_drawn, mirrored)
        } else {
            (mirrored, as_drawn)
        };
        let (most, mean) = pdf.difference(like);
        assert!(
            most <= 128.0 && mean <= 16.0,
            "{shape}: {most} at most, {mean} on average"
        );
        let (_, unlike) = pdf.difference(other);
        assert!(
            unlike > 5.0 * mean || shape.starts_with("circle"),
            "{shape} is like the other way up too: {unlike}"
        );
    }
}

#[test]
fn a_plot_in_pdf_is_the_one_in_png_words_and_all() {
    const FINER: u32 = 4;
    let folder = tempfile::tempdir().unwrap();
    let plot = |name: &str| {
        let file = folder.path().join(name);
        let shape = "measure ellipse 3 2 -m apprich,midpoint --size 800x500 --plot";
        drawn(&format!("{shape} {}", file.display()));
        fs::read(file).unwrap()
    };
    let png = Picture::new(&Pixmap::decode_png(&plot("plot.png")).unwrap());
    let pdf = page(&plot("plot.pdf"), FINER).reduced(FINER as usize);
    let (_, mean) = pdf.difference(&png);
    let (_, mirrored) = pdf.difference(&png.upside_down());
    assert!(
        mean <= 12.0 && mirrored > 5.0 * mean,
        "{mean}, mirrored {mirrored}"
    );
}

/// The content of the page: the only stream of the file, as text.
fn content(pdf: &[u8]) -> String {
    let text = String::from_utf8_lossy(pdf).into_owned();
    let start = text.find("stream\n").unwrap() + "stream\n".len();
    let length = text[start..].find("endstream").unwrap();
    text[start..start + length].to_owned()
}

#[test]
fn the_page_holds_the_very_control_points() {
    for shape in [
        "circle 50 -p 12",
        "circle 1e-3 --center 123456.789,-0.5",
        "ellipse 30 20 --rotation 33",
        "arc --from 0.1,0.2 --to 7.3,-4.4 --bulge 0.3",
        "arc --from 0,0 --to 10,5 --bulge 0",
        "circle 5 -m quadratic-minimax -p 5",
    ] {
        let content = content(&drawn(&format!("{shape} -f pdf")));
        let names = [
            ("m", "moveto"),
            ("l", "lineto"),
            ("c", "curveto"),
            ("h", "closepath"),
        ];
        let operators: Vec<String> = content
            .lines()
            .filter_map(|line| {
                let (numbers, short) = line.rsplit_once(' ').unwrap_or(("", line));
                let (_, name) = names.iter().find(|name| name.0 == short)?;
                Some(format!("{numbers} {name}").trim_start().to_owned())
            })
            .collect();
        // PostScript alone runs round closed shapes the other way, from 180 degrees.
        let turned = if shape.starts_with("arc") {
            ""
        } else {
            "--start 0 --reverse"
        };
        let expected = drawn_text(&format!("{shape} {turned} -f ps"));
        let expected: Vec<&str> = expected.lines().collect();
        assert_eq!(operators, expected, "{shape}");
    }
}

#[test]
fn a_page_is_as_large_as_the_coordinates_or_as_readers_take() {
    let size = |arguments: &str| {
        let text = String::from_utf8_lossy(&drawn(arguments)).into_owned();
        let numbers = text
            .split("/MediaBox [0 0 ")
            .nth(1)
            .unwrap()
            .split(']')
            .next()
            .unwrap();
        let (width, height) = numbers.split_once(' ').unwrap();
        [width, height].map(|side| side.parse::<f64>().unwrap())
    };
    assert_eq!(size("circle 50 -f pdf"), [101.0, 101.0]);
    assert_eq!(size("circle 50 -f pdf --size 25.4x50.8mm"), [72.0, 144.0]);
    assert_eq!(size("circle 1e6 -f pdf"), [512.0, 512.0]);
    assert_eq!(
        size("ellipse 1e-3 5e-4 --stroke none -f pdf"),
        [512.0, 256.0]
    );
}

#[test]
fn what_is_huge_or_tiny_or_far_away_fills_its_page() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file.pdf");
    for shape in [
        "circle 50 --size 512x512",
        "circle 1e6",
        "circle 3e9",
        "circle 1e20",
        "circle 1e-7",
        "circle 1e-30",
        "circle 50 --center 1e12,-1e12 --size 512x512",
        "arc 1e-9 --sweep 359 --show joints,truth --background #eee",
    ] {
        fs::write(&file, drawn(&format!("{shape} -f pdf"))).unwrap();
        let output = Command::new("gs")
            .args(["-q", "-sDEVICE=bbox", "-dNOPAUSE", "-dBATCH", "-dSAFER"])
            .arg(&file)
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let (_, found) = text.split_once("%%HiResBoundingBox: ").unwrap();
        let found: Vec<f64> = found
            .split_whitespace()
            .map(|x| x.parse().unwrap())
            .collect();
        for (found, wanted) in found.iter().zip([0.0, 0.0, 512.0, 512.0]) {
            assert!((found - wanted).abs() < 4.0, "{shape}: {text}");
        }
    }
}

#[test]
fn a_page_that_no_reader_takes_is_refused() {
    let message = refused(&["circle", "5", "-f", "pdf", "--size", "6000x10mm"]);
    assert!(message.contains("200 inches"), "{message}");
}
