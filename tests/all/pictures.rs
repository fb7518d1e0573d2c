//! The options of pictures: what they do, what they refuse.

use resvg::tiny_skia::Pixmap;

use crate::judges::program::{drawn, drawn_text, refused, words};

fn svg(arguments: &str) -> String {
    drawn_text(&format!("{arguments} -f svg"))
}

fn png(arguments: &str) -> Pixmap {
    Pixmap::decode_png(&drawn(&format!("{arguments} -f png"))).unwrap()
}

/// The value of the first attribute of this name.
fn attribute<'a>(document: &'a str, name: &str) -> &'a str {
    let start = document.find(&format!("{name}=\"")).unwrap() + name.len() + 2;
    let length = document[start..].find('"').unwrap();
    &document[start..start + length]
}

fn view_box(document: &str) -> [f64; 4] {
    let numbers: Vec<f64> = attribute(document, "viewBox")
        .split(' ')
        .map(|number| number.parse().unwrap())
        .collect();
    numbers.try_into().unwrap()
}

#[test]
fn an_svg_of_a_drawing_is_one_path_with_a_title_and_the_stated_error() {
    for shape in [
        "circle 50",
        "arc 10 20 --start 30 --sweep 90",
        "arc --through 0,0 1,1 2,2",
        "arc 10 --start 0 --sweep 0",
    ] {
        let document = svg(&format!(
            "{shape} --background white --margin 2 --size 100x50"
        ));
        assert_eq!(document.matches("<path").count(), 1, "{shape}");
        assert_eq!(document.matches("<title>").count(), 1);
        assert_eq!(document.matches("<desc>").count(), 1);
        assert_eq!(attribute(&document, "width"), "100");
        assert_eq!(attribute(&document, "height"), "50");
    }
    let document = svg("circle 50");
    assert!(document.contains("<title>Circle of radius 50</title>"));
    assert!(document.contains("4 segments by minimax; within 0.00985 of the true shape"));
    assert!(!document.contains("width=\"") || document.find("width=\"") > document.find("<path"));
}

#[test]
fn the_path_of_an_svg_is_that_of_the_path_format() {
    for shape in [
        "circle 50",
        "circle 50 --relative",
        "circle 5 -m quadratic-area -p 4",
    ] {
        let data = drawn_text(shape);
        assert_eq!(attribute(&svg(shape), " d"), data.trim_end(), "{shape}");
    }
}

#[test]
fn the_view_holds_the_stroke_and_what_is_shown() {
    assert_eq!(view_box(&svg("circle 50")), [-50.5, -50.5, 101.0, 101.0]);
    assert_eq!(
        view_box(&svg("circle 50 --stroke-width 4")),
        [-52.0, -52.0, 104.0, 104.0]
    );
    assert_eq!(
        view_box(&svg("circle 50 --stroke none --margin 3")),
        [-53.0, -53.0, 106.0, 106.0]
    );
    // The handles of an arc leave the box around its curve.
    let [x, y, width, height] = view_box(&svg("arc 10 --start 40 --sweep 100 -n 1 --show handles"));
    let handles = svg("arc 10 --start 40 --sweep 100 -n 1 --show handles --margin 0");
    for dot in handles.split("<circle").skip(1) {
        let number = |name| attribute(dot, name).parse::<f64>().unwrap();
        let (cx, cy, r) = (number("cx"), number("cy"), number("r"));
        assert!(cx - r > x && cx + r < x + width && cy - r > y && cy + r < y + height);
    }
}

#[test]
fn what_is_shown_lies_in_groups_of_its_own() {
    let document = svg("circle 50 --show joints,handles,truth,error=500");
    let classes: Vec<&str> = document
        .split("<g class=\"")
        .skip(1)
        .map(|rest| &rest[..rest.find('"').unwrap()])
        .collect();
    assert_eq!(
        classes,
        [
            "outward",
            "inward",
            "truth",
            "handles",
            "handle-ends",
            "joints"
        ]
    );
    assert!(
        document.contains(
            "; deviation drawn 500 times as large, orange outside and blue inside</desc>"
        )
    );
    assert_eq!(document.matches("<circle").count(), 4 + 8);
    // The true shape is no Bézier curve.
    assert!(document.contains("<path d=\"M50 0A50 50 0 0 1-25 43.301A"));
    let turned = svg("ellipse 30 20 --rotation 33 --show truth");
    assert!(turned.contains("A30 20 33 0 1-"), "{turned}");
    let relative = svg("circle 50 --show truth --relative");
    assert!(relative.contains("<path d=\"M50 0a50 50 0 0 1-75 43.301a"));
}

#[test]
fn the_true_arcs_of_a_path_and_of_lines_lie_beneath() {
    // Two arcs among lines and a Bézier: as many true shapes, and the same lobes as the arc alone has.
    let lobes = |document: &str| {
        let group = |class: &str| {
            let inside = document.split(&format!("class=\"{class}\"")).nth(1);
            inside
                .map_or("", |text| text.split("</g>").next().unwrap())
                .matches("<path")
                .count()
        };
        (group("truth"), group("outward"), group("inward"))
    };
    let arc = lobes(&svg("arc 10 --sweep 90 -n 1 --show truth,error=500"));
    assert_eq!(arc, (1, 2, 1));
    let path =
        "path M20,0L10,0A10,10,0,0,1,0,10C-9,10,-9,9,-9,0A9,9,0,0,1,0,-9Z --show truth,error=500";
    assert_eq!(lobes(&svg(path)), (2, 4, 2));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("lines");
    std::fs::write(
        &file,
        "arc 0 0 10 0 90\n\npath M30 0H40A10 10 0 0 1 30 10Z\n",
    )
    .unwrap();
    let batch = format!("batch {} --show truth,error=500", file.display());
    assert_eq!(lobes(&svg(&batch)), (2, 4, 2));
}

#[test]
fn a_small_shape_far_away_keeps_its_digits_and_no_idle_ones() {
    let document = svg("circle 1e-6 --center 1e6,0");
    let numbers = attribute(&document, "viewBox").split(' ');
    assert!(numbers.into_iter().all(|number| number.len() <= 16));
    let [_, _, width, height] = view_box(&document);
    for side in [width, height] {
        assert!((side / 2.02e-6 - 1.0).abs() < 1e-3, "{side}");
    }
}

#[test]
fn every_number_of_a_picture_is_finite_and_plain() {
    for shape in [
        "circle 1e6",
        "circle 1e-6",
        "circle 3 --center -1000,-2000 -n 3",
        "ellipse 100 1 --rotation 30",
        "ellipse 30 10",
        "ellipse 50 30 --transform skewX(40)rotate(20)scale(-1,2)",
        "arc 50 --start 20 --sweep 1e-3",
        "arc --through 0,0 5,0 10,0",
        "arc 5 --start 0 --sweep 0",
        "circle 50 -m quadratic-minimax",
        "circle 50 --handle 0",
    ] {
        let document = svg(&format!("{shape} --show joints,handles,truth,error=100"));
        for path in document.split("<path").skip(1) {
            let data = attribute(path, " d");
            assert!(
                data.chars().all(|c| "0123456789.- MLQCAZ".contains(c)),
                "{shape}: {data}"
            );
        }
        let [_, _, width, height] = view_box(&document);
        assert!(width > 0.0 && height > 0.0, "{shape}");
        png(&format!("{shape} --show joints,handles,truth,error=100"));
    }
}

#[test]
fn a_png_has_512_pixels_on_its_larger_side_or_the_size_asked_for() {
    let size = |arguments| {
        let picture = png(arguments);
        (picture.width(), picture.height())
    };
    assert_eq!(size("circle 50"), (512, 512));
    assert_eq!(size("ellipse 100 50 --stroke-width 0"), (512, 256));
    assert_eq!(size("ellipse 50 100 --stroke-width 0"), (256, 512));
    assert_eq!(size("circle 50 --size 30x20"), (30, 20));
    assert_eq!(size("arc 5 --start 0 --sweep 0"), (512, 512));
}

#[test]
fn a_png_is_white_beneath_unless_told_otherwise() {
    let middle = |arguments| {
        let picture = png(arguments);
        let c = picture.pixel(10, 10).unwrap().demultiply();
        [c.red(), c.green(), c.blue(), c.alpha()]
    };
    assert_eq!(middle("circle 50 --size 20x20"), [255; 4]);
    assert_eq!(middle("circle 50 --size 20x20 --background none"), [0; 4]);
    assert_eq!(
        middle("circle 50 --size 20x20 --background #123"),
        [0x11, 0x22, 0x33, 255]
    );
    assert_eq!(
        middle("circle 50 --size 20x20 --fill gold"),
        [255, 215, 0, 255]
    );
}

#[test]
fn the_bounding_boxes_of_an_eps_file_hold_its_stroke() {
    let comment = |text: &str, name: &str| -> Vec<f64> {
        let line = text
            .lines()
            .find_map(|line| line.strip_prefix(name))
            .unwrap();
        line.split_whitespace()
            .map(|number| number.parse().unwrap())
            .collect()
    };
    let eps = |arguments: &str| drawn_text(&format!("{arguments} -f eps"));
    let text = eps("ellipse 50.2 30 --center 1000,-0.5");
    assert!(text.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
    assert!(text.ends_with("showpage\n%%EOF\n"));
    assert!(
        text.lines()
            .all(|line| line.len() <= 255 && line.is_ascii())
    );
    assert_eq!(
        comment(&text, "%%BoundingBox:"),
        [949.0, -31.0, 1051.0, 30.0]
    );
    assert_eq!(
        comment(&text, "%%HiResBoundingBox:"),
        [949.3, -31.0, 1050.7, 30.0]
    );
    let text = eps("circle 50 --size 300x200");
    assert_eq!(comment(&text, "%%BoundingBox:"), [0.0, 0.0, 300.0, 200.0]);
    let wide = eps("circle 1e9");
    let line = wide
        .lines()
        .find(|line| line.starts_with("%%BoundingBox:"))
        .unwrap();
    assert!(!line.contains('.') && !line.contains('e'), "{line}");
}

#[test]
fn what_a_picture_cannot_be_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, said) in [
        ("circle 50 -f png --size 40000x25001", "too large"),
        ("circle 50 -f png --size 1e300x1e300", "too large"),
        ("circle 50 -f png --size 0x10", "positive"),
        ("circle 50 -f png --size 10", "like 640x480"),
        ("circle 50 -f svg --stroke blak", "not a colour"),
        ("circle 50 -f svg --fill #12", "not a colour"),
        ("circle 50 -f svg --stroke-width -1", "at least 0"),
        ("circle 50 -f svg --margin inf", "at least 0"),
        ("circle 50 -f svg --stroke-width 1e308", "too large"),
        ("circle 50 -f svg --show error=1e300", "too large"),
        (
            "circle 50 -f svg --show joint",
            "what can is joints, handles, truth, error=K",
        ),
        ("circle 50 -f svg --show error", "like error=500"),
        ("circle 50 -f svg --show error=0", "positive, finite"),
        (
            "circle 50 -f path --show joints",
            "--show says nothing in the format path",
        ),
        (
            "circle 50 -f json --stroke red",
            "--stroke says nothing in the format json",
        ),
        (
            "circle 50 -f ps --stroke-width 2",
            "--stroke-width says nothing in the format ps",
        ),
        (
            "circle 50 -f png --relative",
            "--relative says nothing in the format png",
        ),
        (
            "circle 50 -f json --relative",
            "--relative says nothing in the format json, whose path is absolute",
        ),
        (
            "circle 1e-50 -f svg -p 30",
            "hint: draw it larger, as with --transform",
        ),
        (
            "sphere 50 -f svg --feed 3",
            "--feed is for gcode, which this command does not write",
        ),
        (
            "circle 50 -f eps --fill #ff000080",
            "no translucent colours",
        ),
    ] {
        let file = folder.path().join("picture");
        let output = ["-o", file.to_str().unwrap()];
        let message = refused(&[&words(arguments)[..], &output].concat());
        assert!(message.contains(said), "{arguments}: {message}");
        assert!(!file.exists(), "{arguments}");
    }
}
