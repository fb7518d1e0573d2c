//! What real renderers make of the output: resvg of SVG and PNG, Ghostscript of PostScript.

use crate::judges::program::{drawn, drawn_text};
use crate::judges::{ghostscript, raster};

use ghostscript::{GRID, Operator, operators, path_of, strokes_of};
use raster::Picture;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg;

// Pictures

/// What resvg makes of an SVG document, on white.
fn resvg(document: &str, width: u32, height: u32) -> Picture {
    let tree = usvg::Tree::from_str(document, &usvg::Options::default()).unwrap();
    let mut pixmap = Pixmap::new(width, height).unwrap();
    pixmap.fill(Color::WHITE);
    let size = tree.size();
    let (across, down) = (width as f32 / size.width(), height as f32 / size.height());
    let scale = across.min(down);
    let fit = Transform::from_translate(
        (width as f32 - scale * size.width()) / 2.0,
        (height as f32 - scale * size.height()) / 2.0,
    );
    resvg::render(&tree, fit.pre_scale(scale, scale), &mut pixmap.as_mut());
    Picture::new(&pixmap)
}

/// The document with another element in place of its path; attributes stay.
fn with_native(document: &str, native: &str) -> String {
    let start = document.find("<path d=\"").unwrap();
    let end = start + 9 + document[start + 9..].find('"').unwrap() + 1;
    [&document[..start], native, &document[end..]].concat()
}

/// How the picture of our SVG of a shape differs from that of a native element in its place.
fn beside_native(shape: &str, native: &str) -> (f64, f64) {
    let ours = drawn_text(&format!("{shape} -f svg"));
    let picture = |document: &str| resvg(document, 1024, 1024).reduced(2);
    picture(&ours).difference(&picture(&with_native(&ours, native)))
}

#[test]
fn resvg_draws_our_circle_as_near_to_its_own_as_its_own_turned() {
    let document = drawn_text("circle 50 -f svg");
    let native = |element: &str| resvg(&with_native(&document, element), 1024, 1024).reduced(2);
    // A turned circle is the same circle: what changes is how resvg samples it.
    let noise =
        native("<circle r=\"50\"").difference(&native("<circle r=\"50\" transform=\"rotate(20)\""));
    for shape in ["circle 50", "circle 50 -t 1e-4", "circle 50 -n 16"] {
        let ours = beside_native(shape, "<circle r=\"50\"");
        assert!(
            ours.0 <= noise.0 && ours.1 <= noise.1,
            "{shape}: {ours:?} beyond {noise:?}"
        );
    }
    let coarse = beside_native("circle 50 -n 3", "<circle r=\"50\"");
    assert!(
        coarse.1 > 2.0 * noise.1,
        "a coarse circle is not told apart: {coarse:?}"
    );
}

#[test]
fn resvg_draws_our_ellipse_as_its_own() {
    let native = "<ellipse rx=\"80\" ry=\"30\" transform=\"translate(10 -20) rotate(25)\"";
    let shape = "ellipse 80 30 --rotation 25 --center 10,-20";
    let (most, mean) = beside_native(shape, native);
    assert!(
        most <= 48.0 && mean <= 3.0,
        "{most} at most, {mean} on average"
    );
    let coarse = beside_native(&format!("{shape} -n 3"), native);
    assert!(
        coarse.1 > 6.0,
        "a coarse ellipse is not told apart: {coarse:?}"
    );
}

#[test]
fn our_png_is_what_resvg_makes_of_our_svg() {
    for shape in [
        "circle 50",
        "circle 1e6 --margin 1e5",
        "circle 1e-3 --center -0.5,0.25",
        "ellipse 300 200 --rotation -15 --center -1000,40 --fill gold --stroke navy",
        "arc 20 --start 30 --sweep 200 -m quadratic-minimax --stroke-width 3",
        "circle 50 --show joints,handles,truth,error=500 --background #eef",
        "ellipse 30 10 --show truth,error=200 --fill #00f8",
    ] {
        let png = Pixmap::decode_png(&drawn(&format!("{shape} --size 400x300 -f png"))).unwrap();
        let svg = drawn_text(&format!("{shape} --size 400x300 -f svg"));
        let (most, mean) = Picture::new(&png).difference(&resvg(&svg, 1600, 1200).reduced(4));
        // One sample of tiny-skia's is worth 64 levels.
        assert!(
            most <= 64.0 && mean <= 8.0,
            "{shape}: {most} at most, {mean} on average"
        );
    }
}

#[test]
fn ghostscript_draws_our_eps_as_the_mirror_image_of_our_png() {
    // Ghostscript paints every pixel that a shape touches: the finer the pixels the less it adds.
    const FINER: u32 = 16;
    for shape in [
        "circle 50 --stroke-width 3",
        "ellipse 100 40 --rotation 30 --center 70,-20 --fill teal --stroke none",
        "arc 60 --start 10 --sweep 130 --stroke-width 4 --margin 3",
        "arc 60 20 --start -40 --sweep 250 --rotation 20 --show joints,handles,truth,error=500 --background #ddd",
    ] {
        let png = drawn(&format!("{shape} --size 120x90 -f png"));
        let png = Picture::new(&Pixmap::decode_png(&png).unwrap());
        let eps = drawn_text(&format!("{shape} --size 120x90 -f eps"));
        let eps = Picture::new(&ghostscript::picture(&eps, FINER)).reduced(FINER as usize);
        let (most, mean) = eps.difference(&png.upside_down());
        assert!(
            most <= 128.0 && mean <= 16.0,
            "{shape}: {most} at most, {mean} on average"
        );
        let (_, unlike) = eps.difference(&png);
        assert!(
            unlike > 10.0 * mean || shape.starts_with("circle"),
            "{shape} is like our png without a mirror too: {unlike}"
        );
    }
}

// Paths

/// Whether the same operators come in the same order, their points within Ghostscript's grid and its single precision.
fn assert_same_path(theirs: &[Operator], ours: &[Operator], what: &str) {
    let names = |path: &[Operator]| path.iter().map(|o| o.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(theirs), names(ours), "{what}");
    for (a, b) in theirs.iter().zip(ours) {
        assert_eq!(a.numbers.len(), b.numbers.len(), "{what}: {a:?}");
        for (x, y) in a.numbers.iter().zip(&b.numbers) {
            let allowed = GRID + f64::from(f32::EPSILON) * y.abs();
            assert!((x - y).abs() <= allowed, "{what}: {x} against {y} in {b:?}");
        }
    }
}

const SHAPES: [&str; 9] = [
    "circle 50",
    "circle 12.345 --center -3.3,1000.25 -n 7 -m apprich",
    "ellipse 300 20 --rotation 33 -t 1e-4",
    "ellipse --diameters 300,200 -m lancaster-drawellipse -p 7 --open",
    "arc 10 --start -90 --sweep -270",
    "arc --svg M10,80a25,25-30,0150-25",
    "arc --through 0,0 5,5 10,10",
    "circle 5 -m quadratic-minimax -n 6",
    "circle 40 --transform skewX(20)scale(1,-2)",
];

#[test]
fn ghostscript_reads_our_ps_as_it_is_written() {
    for shape in SHAPES {
        let text = drawn_text(&format!("{shape} -f ps"));
        assert_same_path(&path_of(&text), &operators(&text), shape);
    }
}

#[test]
fn ghostscript_strokes_in_our_eps_what_our_ps_has() {
    for shape in SHAPES {
        let eps = drawn_text(&format!("{shape} -f eps"));
        let ps = drawn_text(&format!("{shape} -f ps"));
        assert_same_path(&strokes_of(&eps), &operators(&ps), shape);
    }
}

const LANCASTER: &str = include_str!("../../fixtures/lancaster/drawellipse.ps");

#[test]
fn lancasters_own_procedure_draws_what_we_do_in_his_name() {
    let ours = drawn_text("ellipse --diameters 300,200 -m lancaster-drawellipse -f ps -p 7 --open");
    let his = path_of(&format!("{LANCASTER}\n300 200 drawellipse"));
    assert_same_path(&his, &operators(&ours), "drawellipse");

    let ours = drawn_text("circle --diameter 250 -m lancaster-drawellipse -f ps -p 7 --open");
    let his = path_of(&format!("{LANCASTER}\n250 drawcircle"));
    assert_same_path(&his, &operators(&ours), "drawcircle");
}

#[test]
fn our_procedures_draw_what_we_do() {
    for method in ["minimax", "midpoint", "lancaster-drawellipse"] {
        let procedures = drawn_text(&format!("procset -m {method}"));
        let ours = drawn_text(&format!(
            "ellipse --diameters 300,200 -m {method} -f ps -p 9 --open"
        ));
        let theirs = path_of(&format!("{procedures}\n300 200 drawellipse"));
        assert_same_path(&theirs, &operators(&ours), method);
        let ours = drawn_text(&format!(
            "circle --diameter 250 -m {method} -f ps -p 9 --open"
        ));
        let theirs = path_of(&format!("{procedures}\n250 drawcircle"));
        assert_same_path(&theirs, &operators(&ours), method);
    }
}

#[test]
fn our_procedures_leave_nothing_behind() {
    let procedures = drawn_text("procset");
    // Twice in one job, and beside names of the user's own.
    let program = format!(
        "/magic 7 def /xrad 8 def {procedures}\n{procedures}\n\
         300 200 drawellipse newpath 100 drawcircle \
         count = countdictstack = magic = xrad = /xmag where = userdict /drawellipse known ="
    );
    let said = ghostscript::run(&program);
    let clean = ghostscript::run("count = countdictstack =");
    assert_eq!(said, format!("{clean}7\n8\nfalse\ntrue\n"));
}

#[test]
fn our_procedures_work_in_the_prolog_of_an_eps_file() {
    let procedures = drawn_text("procset");
    let eps = format!(
        "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: -151 -101 151 101\n%%EndComments\n%%BeginProlog\n{procedures}%%EndProlog\n\
         2 setlinewidth 300 200 drawellipse closepath stroke\nshowpage\n%%EOF\n"
    );
    let theirs = Picture::new(&ghostscript::picture(&eps, 4)).reduced(4);
    let ours =
        drawn_text("ellipse --diameters 300,200 -p 9 --stroke-width 2 --size 302x202 -f eps");
    let ours = Picture::new(&ghostscript::picture(&ours, 4)).reduced(4);
    let (most, mean) = theirs.difference(&ours);
    assert!(mean < 1.0, "{most} at most, {mean} on average");
}
