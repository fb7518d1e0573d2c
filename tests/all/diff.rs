//! `diff`: exit codes, forms, matches, and distances against samples.

use crate::judges::ghostscript;
use crate::judges::program::{drawn_text, printed, refused, run};

use curveto::diff::{Track, compare};
use curveto::path::contours;
use kurbo::{Affine, ParamCurve as _, Point};
use proptest::prelude::*;
use serde_json::Value;

fn tracks(data: &str) -> Vec<Track> {
    let contours = contours(data).unwrap();
    let track = |contour| Track::new(contour, Affine::IDENTITY).unwrap();
    contours.iter().map(track).collect()
}

/// Both ways, by brute force.
fn sampled(old: &Track, new: &Track, count: u32) -> f64 {
    let points = |track: &Track| -> Vec<Point> {
        let segments = track.segments.iter();
        let on = |s: &kurbo::PathSeg| {
            let s = *s;
            (0..=count).map(move |i| s.eval(f64::from(i) / f64::from(count)))
        };
        segments.flat_map(on).collect()
    };
    let (a, b) = (points(old), points(new));
    let way = |a: &[Point], b: &[Point]| {
        let nearest = |p: &Point| {
            b.iter()
                .map(|q| p.distance(*q))
                .fold(f64::INFINITY, f64::min)
        };
        a.iter().map(nearest).fold(0.0, f64::max)
    };
    way(&a, &b).max(way(&b, &a))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn the_distance_is_a_bound_and_a_tight_one(
        a in prop::collection::vec(-50.0_f64..50.0, 14),
        b in prop::collection::vec(-50.0_f64..50.0, 14),
        near in prop::option::of(0.001_f64..1.0),
    ) {
        let b: Vec<f64> = match near {
            Some(share) => a.iter().zip(&b).map(|(a, b)| a + share * b / 50.0).collect(),
            None => b,
        };
        let path = |n: &[f64]| {
            let words: Vec<String> = n.iter().map(f64::to_string).collect();
            format!("M{}C{}C{}", words[..2].join(" "), words[2..8].join(" "), words[8..].join(" "))
        };
        let (old, new) = (tracks(&path(&a)), tracks(&path(&b)));
        let found = compare(&old, &new, 0.0).unwrap().distance();
        let samples = sampled(&old[0], &new[0], 400);
        // Nearest samples are up to half a step farther than nearest points, farthest ones as much nearer.
        let step = 300.0 / 400.0;
        prop_assert!(found >= samples - step && found <= samples + step, "{found} {samples}");
        let place = compare(&old, &new, 0.0).unwrap().pairs[0].distance.place.unwrap();
        let other = if place.side == curveto::diff::Side::Old { &new } else { &old };
        let at_place = other[0].segments.iter().map(|s| {
            use kurbo::ParamCurveNearest as _;
            s.nearest(place.point, 1e-9).distance_sq.sqrt()
        }).fold(f64::INFINITY, f64::min);
        prop_assert!(at_place <= found * (1.0 + 1e-9) && at_place >= found * 0.999, "{found} {at_place}");
    }
}

#[test]
fn the_stated_error_is_the_distance_from_the_true_circle() {
    let truth = tracks("M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z");
    for method in ["minimax", "midpoint", "quadratic-minimax"] {
        let words = ["circle", "50", "-m", method, "-f", "json"];
        let document: Value = serde_json::from_str(&printed(&words)).unwrap();
        let drawn = tracks(document["path"].as_str().unwrap());
        let (found, stated) = (
            compare(&truth, &drawn, 0.0).unwrap().distance(),
            document["error"]["peak"].as_f64().unwrap(),
        );
        assert!(
            found >= stated * (1.0 - 1e-9) && found <= stated * 1.0002,
            "{method}: {found} {stated}"
        );
    }
}

#[test]
fn a_tolerance_decides_to_the_last_digits() {
    let code = |old: &str, new: &str, tolerance: &str| {
        run(&["diff", old, new, "-t", tolerance, "-q"])
            .status
            .code()
    };
    assert_eq!(code("M0 .7L1 .7", "M0 .8L1 .8", "0.1"), Some(0));
    assert_eq!(code("M0 .7L1 .7", "M0 .8L1 .8", "0.09999999999"), Some(1));
    let circle = "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z";
    let larger = "M50.5 0A50.5 50.5 0 0 1-50.5 0A50.5 50.5 0 0 1 50.5 0Z";
    assert_eq!(code(circle, larger, "0.50001"), Some(0));
    assert_eq!(code(circle, larger, "0.49999"), Some(1));
}

#[test]
fn exit_codes_are_those_of_gnu_diff() {
    let (a, b) = ("M0 0L1 0", "M0 0L1 1");
    assert_eq!(run(&["diff", a, a]).status.code(), Some(0));
    assert_eq!(run(&["diff", a, b]).status.code(), Some(1));
    assert_eq!(
        run(&["diff", a, "M0 0L.5 0L1 0", "-t", "1e-9"])
            .status
            .code(),
        Some(0)
    );
    assert_eq!(run(&["diff", a, "M0 0L1 0Z"]).status.code(), Some(1));
    assert_eq!(run(&["diff", a, "M1 0L0 0"]).status.code(), Some(0));
    refused(&["diff", a, "no-such-file.svg"]);
    refused(&["diff", a, "-t", "-1", b]);
    refused(&["diff", "-", "-"]);
    refused(&["diff", a, "M0 0L"]);
    refused(&["diff", a, "M0 0"]);
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("a.svg", "<svg><path"),
        ("a.json", r#"{"version": 1}"#),
        ("a.ps", "0 0 moveto 1 0 0 1 5 arc"),
        ("b.ps", "5 moveto"),
    ] {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        let said = refused(&["diff", a, file.to_str().unwrap()]);
        assert!(said.contains(name), "{said}");
    }
    refused(&["diff", a, folder.path().to_str().unwrap()]);
}

#[test]
fn subpaths_are_matched_whatever_their_order() {
    let old = tracks("M0 0H9V9H0ZM50 50h5v5h-5ZM0 0L9 0L9 9L0 9.0001Z");
    let new = tracks("M50 50h5v5h-5zM0 0L9 0L9 9L0 9.0001ZM9 9V0H0V9Z");
    let difference = compare(&old, &new, 0.0).unwrap();
    assert!(difference.is_within());
    let pairs: Vec<_> = difference
        .pairs
        .iter()
        .map(|pair| (pair.old, pair.new))
        .collect();
    assert_eq!(pairs, [(0, 2), (1, 0), (2, 1)]);
    let fewer = compare(&old, &new[..2], 1.0).unwrap();
    assert_eq!((fewer.only_old.len(), fewer.only_new.len()), (1, 0));
    assert!(!fewer.is_within());
    let said = String::from_utf8(run(&["diff", "M0 0L1 0", "M0 0L1 0M5 5L6 6"]).stdout).unwrap();
    assert!(
        said.contains("subpath 2 of M0 0L1 0M5 5L6 6 has no like in M0 0L1 0"),
        "{said}"
    );
}

#[test]
fn every_form_of_a_drawing_is_the_same_drawing() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let shape = [
        "arc", "30", "20", "--start", "0", "--sweep", "200", "-p", "4",
    ];
    for name in ["a.svg", "a.json", "a.ps", "a.eps", "a.path"] {
        printed(&[&shape[..], &["-o", &file(name)]].concat());
        assert_eq!(
            run(&["diff", &file("a.svg"), &file(name)]).status.code(),
            Some(0),
            "{name}"
        );
    }
    std::fs::write(
        file("moved.ps"),
        "%!PS\ngsave 3 0 translate 2 dup pop 2 scale 0 0 moveto 1 0 rlineto grestore stroke",
    )
    .unwrap();
    refused(&["diff", "M3 0L5 0", &file("moved.ps")]);
    std::fs::write(
        file("moved.ps"),
        "%!PS\ngsave 3 0 translate 2 2 scale [2 1] 0 setdash 0 0 moveto 1 0 rlineto stroke grestore 9 9 moveto 8 8 lineto",
    )
    .unwrap();
    assert_eq!(
        run(&["diff", "M3 0L5 0M9 9L8 8", &file("moved.ps")])
            .status
            .code(),
        Some(0)
    );
}

#[test]
fn arcs_of_postscript_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arc.ps");
    for (drawing, path) in [
        ("50 50 10 0 270 arc closepath", "M60 50A10 10 0 1 1 50 40Z"),
        (
            "0 0 10 0 360 arc closepath",
            "M10 0A10 10 0 0 1-10 0A10 10 0 0 1 10 0Z",
        ),
        (
            "gsave 5 0 translate 30 rotate 1 -.5 scale 0 0 10 0 360 arc closepath stroke grestore",
            "M13.660254037844386 5A10 5 30 0 0-3.660254037844386-5A10 5 30 0 0 13.660254037844386 5Z",
        ),
        ("0 0 moveto 0 0 10 90 0 arcn", "M0 0L0 10A10 10 0 0 0 10 0"),
        (
            "0 0 10 350 10 arc",
            "M9.848077530122081-1.7364817766693033A10 10 0 0 1 9.848077530122081 1.7364817766693033",
        ),
    ] {
        std::fs::write(&file, drawing).unwrap();
        // Half a turn by its ends is known to half the digits.
        let words = ["diff", path, file.to_str().unwrap(), "-t", "1e-7"];
        let output = run(&words);
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{drawing}: {said}");
    }
    for drawing in ["0 0 10 0 400 arc", "0 0 0 0 90 arc", "0 10 0 90 arc"] {
        std::fs::write(&file, drawing).unwrap();
        refused(&["diff", "M0 0L1 0", file.to_str().unwrap()]);
    }
}

/// What becomes of a path and of the current point when it is painted, discarded, saved and brought back.
#[test]
fn of_postscript_is_drawn_what_ghostscript_paints() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for program in [
        "0 0 moveto 10 0 lineto stroke 0 0 5 90 0 arcn stroke",
        "newpath 0 0 5 0 360 arc stroke newpath 20 0 5 0 360 arc stroke",
        "0 0 5 0 360 arc closepath fill 20 0 5 0 360 arc closepath stroke",
        "0 0 moveto 1 1 lineto newpath 3 3 moveto 4 4 lineto stroke",
        "0 0 moveto 1 1 lineto clip newpath 3 3 moveto 4 4 lineto eofill",
        "0 0 moveto gsave 5 5 lineto stroke grestore 10 0 lineto stroke",
        "0 0 moveto 9 0 lineto gsave newpath 7 7 moveto 8 8 lineto stroke grestore 10 5 rlineto stroke",
        "1 1 moveto gsave 4 0 translate 2 2 scale 1 0 rlineto grestore 3 0 rlineto stroke",
        "0 0 moveto 4 0 lineto save 2 2 scale 1 1 lineto gsave grestore grestore stroke restore 4 5 lineto stroke",
        "newpath closepath 0 0 moveto 5 0 lineto 5 5 lineto closepath closepath stroke",
        "0 0 moveto 5 0 lineto 5 5 lineto closepath 3 -1 rlineto 0 0 2 90 180 arc stroke",
    ] {
        let painted = ghostscript::painted_by(program);
        let words = painted.iter().map(|operator| {
            let numbers = operator.numbers.iter().map(|x| format!("{x} "));
            numbers
                .chain([operator.name.clone() + "\n"])
                .collect::<String>()
        });
        std::fs::write(file("painted.ps"), words.collect::<String>()).unwrap();
        std::fs::write(file("read.ps"), program).unwrap();
        // Ghostscript's own cubics stray so far from a circle of 5.
        let output = run(&[
            "diff",
            &file("painted.ps"),
            &file("read.ps"),
            "-t",
            "0.0015",
        ]);
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{program}: {said}");
    }
}

#[test]
fn a_path_that_is_filled_and_stroked_is_one() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.ps");
    for (drawing, path) in [
        ("gsave fill grestore stroke", "M0 0L9 0"),
        (
            "gsave fill grestore gsave eofill grestore stroke showpage",
            "M0 0L9 0",
        ),
        ("gsave fill grestore", "M0 0L9 0"),
        (
            "gsave fill grestore 9 9 lineto stroke",
            "M0 0L9 0M0 0L9 0L9 9",
        ),
        ("stroke 0 0 moveto 9 0 lineto stroke", "M0 0L9 0M0 0L9 0"),
        (
            "stroke 2 2 scale showpage 0 0 moveto 1 1 lineto stroke",
            "M0 0L9 0M0 0L1 1",
        ),
    ] {
        std::fs::write(&file, format!("0 0 moveto 9 0 lineto {drawing}")).unwrap();
        let output = run(&["diff", path, file.to_str().unwrap()]);
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{drawing}: {said}");
    }
    for lost in [
        "1 1 lineto",
        "0 0 moveto newpath 1 0 rmoveto",
        "0 0 moveto 1 0 lineto stroke 1 1 1 1 2 2 curveto",
    ] {
        std::fs::write(&file, format!("%!PS\n{lost}")).unwrap();
        let said = refused(&["diff", "M0 0L1 0", file.to_str().unwrap()]);
        assert!(said.contains("needs a current point"), "{lost}: {said}");
    }
}

#[test]
fn a_place_is_told_by_a_segment_of_the_drawing() {
    let said = |old, new| String::from_utf8(run(&["diff", old, new]).stdout).unwrap();
    let arcs = said("M0 0A5 5 0 0 1 10 0", "M0 0A5 5 0 0 0 10 0");
    assert!(arcs.contains("on segment 1 of "), "{arcs}");
    let lines = said(
        "M0 0L1 0A5 5 0 0 1 11 0L20 0",
        "M0 0L1 0A5 5 0 0 1 11 0L20 1",
    );
    assert!(lines.contains("on segment 3 of "), "{lines}");
    let closed = said("M0 0H10V10Z", "M0 0H10V10L0 0");
    assert_eq!(closed, "subpath 1: one is closed and the other is not\n");
}

#[test]
fn large_and_tiny_coordinates_are_compared() {
    let found = compare(
        &tracks("M1e140 0L2e140 0"),
        &tracks("M1e140 1e139L2e140 1e139"),
        0.0,
    )
    .unwrap();
    assert!((found.distance() / 1e139 - 1.0).abs() < 1e-9);
    let found = compare(
        &tracks("M0 0L1e-90 0"),
        &tracks("M0 1e-91L1e-90 1e-91"),
        0.0,
    )
    .unwrap();
    assert!((found.distance() / 1e-91 - 1.0).abs() < 1e-9);
    assert_eq!(
        compare(&tracks("M0 0L0 0"), &tracks("M3 4Z"), 0.0)
            .unwrap()
            .distance(),
        5.0
    );
}

#[test]
fn what_is_not_read_of_a_drawing_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg");
    let line = "M0 0L1 0";
    let diff = |text: &str, more: &[&str]| {
        std::fs::write(&file, text).unwrap();
        let output = run(&[&["diff", line, file.to_str().unwrap()], more].concat());
        let said = String::from_utf8(output.stderr).unwrap();
        (output.status.code(), said)
    };
    let path = format!("<path d='{line}'/>");
    let sheet = |css: &str| format!("<svg><style>{css}</style>{path}</svg>");
    for (text, why) in [
        (
            sheet("path{transform:scale(2)}"),
            "a style sheet sets transform;",
        ),
        (
            sheet("@import 'a.css';"),
            "a style sheet lies in another file;",
        ),
        (
            format!("<svg>{path}<use href='#a'/></svg>"),
            "<use> is not followed;",
        ),
    ] {
        let (code, said) = diff(&text, &[]);
        assert_eq!(code, Some(0), "{text}");
        assert!(
            said.starts_with("note: ") && said.contains(&format!("a.svg: {why}")),
            "{said}"
        );
        assert_eq!(diff(&text, &["-q"]), (Some(0), String::new()));
    }
    let entity = |inner: &str| {
        format!("<!DOCTYPE svg [<!ENTITY e SYSTEM 'e.txt'>]><svg>{inner}{path}</svg>")
    };
    let silent = (Some(0), String::new());
    assert_eq!(diff(&entity("<text>&e;</text>"), &[]), silent);
    assert_eq!(diff(&sheet("path{fill:red}"), &[]), silent);
    let (code, said) = diff(&entity("<g>&e;</g>"), &[]);
    assert_eq!(code, Some(2));
    assert!(said.contains("what it draws is not known"), "{said}");
}

#[test]
fn what_is_written_as_postscript_is_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let looks = [
        "",
        "--size 300x300",
        "--size 30mmx20mm --margin 2",
        "--stroke red --stroke-width 3 --background white",
        "--stroke none --fill blue",
        "--fill #ccc --background #eee --size 100x40",
        "--show joints,handles,truth,error=50 --size 200x200",
    ];
    let shapes = [
        "circle 50",
        "ellipse 50 20 --rotation 33",
        "arc 10 --sweep 100 -m chen-3",
        "circle 5 -m quadratic-tangent -n 8",
        "sphere 20 --hidden dash",
        "spline --points 0,0_1,2_3,1_4,4",
        "path M0,0L5,5A3,3,0,0,1,9,9M1,1C2,2,3,1,4,0Z",
    ];
    for shape in shapes {
        for look in looks.into_iter().filter(|look| {
            !look.contains("--show") || !(shape.starts_with("sph") || shape.starts_with("spl"))
        }) {
            let file = folder.path().join("a.eps");
            let words = format!("{shape} {look} -f eps -p 3");
            std::fs::write(&file, drawn_text(&words)).unwrap();
            let file = file.to_str().unwrap();
            let found = printed(&["diff", file, file]);
            assert!(found.ends_with("with equal segments\n"), "{words}: {found}");
        }
    }
    // What has its size is what has none, scaled and moved: on a page as wide as itself it is the same.
    let plain = folder.path().join("plain.eps");
    let sized = folder.path().join("sized.eps");
    let square = "path M0,0L30,0L30,30L0,30Z --margin 0 --stroke none --fill red -f eps";
    std::fs::write(&plain, drawn_text(square)).unwrap();
    let twice = format!("{square} --size 60x60");
    std::fs::write(&sized, drawn_text(&twice)).unwrap();
    let document = "M0,0L60,0L60,60L0,60Z";
    let files = [&plain, &sized].map(|file| file.to_str().unwrap());
    printed(&["diff", files[1], document]);
    assert_eq!(run(&["diff", files[0], files[1]]).status.code(), Some(1));
}

#[test]
fn postscript_is_known_by_its_name_or_its_operators() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = "[1 0 0 1 5 5] concat 0 0 moveto 1 1 lineto stroke\n";
    for name in ["a.ps", "a.EPS", "a"] {
        let file = folder.path().join(name);
        std::fs::write(&file, drawing).unwrap();
        printed(&["diff", file.to_str().unwrap(), "M5 5L6 6"]);
    }
    let file = folder.path().join("b.ps");
    std::fs::write(&file, "<< /A 1 >> pop 0 0 moveto 1 1 lineto\n").unwrap();
    let message = refused(&["diff", file.to_str().unwrap(), "M5 5L6 6"]);
    assert!(
        message.contains("operators of a plain drawing"),
        "{message}"
    );
}
