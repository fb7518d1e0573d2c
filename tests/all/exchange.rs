//! What readers make of TikZ, calls of the HTML canvas and UFO glyphs. Each is read here by the rules of its specification and has to
//! hold the very control points that JSON states; `make test-tex` and `make test-readers` ask LaTeX and fontTools.

use std::fs;
use std::process::Command;

use crate::judges::chain::{Chain, SHAPES, curves_of_a_sphere, stated};
use crate::judges::program::{drawn_text as printed, run, run_words};
use resvg::usvg::roxmltree;

// TikZ

/// Reads `\draw` commands.
fn tikz(text: &str) -> Vec<Chain> {
    let words: String = text.split_whitespace().collect();
    let commands = words.split_terminator(';');
    commands
        .map(|command| {
            let mut rest = command.strip_prefix("\\draw").unwrap();
            rest = rest.strip_prefix("[dashed]").unwrap_or(rest);
            let mut chain = Chain::new(pair(&mut rest));
            while !rest.is_empty() {
                if let Some(after) = rest.strip_prefix("--cycle") {
                    assert!(after.is_empty(), "{command}");
                    return chain.finished(true);
                }
                if let Some(after) = rest.strip_prefix("--") {
                    rest = after;
                    chain.push(&[pair(&mut rest)]);
                    continue;
                }
                let between = ["..controls", "and", ".."].map(|word| {
                    rest = rest.strip_prefix(word).unwrap();
                    pair(&mut rest)
                });
                chain.push(&between);
            }
            chain.finished(false)
        })
        .collect()
}

/// Takes `(x,y)` from the beginning of a text.
fn pair(text: &mut &str) -> [f64; 2] {
    let (inside, rest) = text.strip_prefix('(').unwrap().split_once(')').unwrap();
    *text = rest;
    let (x, y) = inside.split_once(',').unwrap();
    [x.parse().unwrap(), y.parse().unwrap()]
}

#[test]
fn tikz_holds_the_control_points() {
    for shape in SHAPES {
        let read = tikz(&printed(&format!("{shape} -f tikz")));
        let [read] = &read[..] else {
            panic!("{shape}: {read:?}");
        };
        let right = stated(shape).raised();
        assert!(read.is_near(&right), "{shape}: {read:?} {right:?}");
    }
    let sphere = tikz(&printed("sphere 5 -f tikz -p 3"));
    assert_eq!(sphere.len(), curves_of_a_sphere());
    let long = printed("circle 50 -n 2000 -f tikz");
    assert!(
        long.lines().all(|line| line.len() < 1000),
        "TeX reads no line of any length"
    );
}

#[test]
fn what_tex_cannot_read_is_refused() {
    let output = run_words("circle 20000 -f tikz");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        message.contains("16383") && message.contains("hint: --transform"),
        "{message}"
    );
}

// The HTML canvas

/// Reads calls, one a line.
fn canvas(text: &str) -> Vec<Chain> {
    let mut chains: Vec<Chain> = Vec::new();
    let mut open: Option<Chain> = None;
    for line in text.lines() {
        let (name, numbers) = line.strip_suffix(')').unwrap().split_once('(').unwrap();
        let numbers: Vec<f64> = numbers.split(", ").filter_map(|n| n.parse().ok()).collect();
        let points: Vec<[f64; 2]> = numbers.chunks(2).map(|n| [n[0], n[1]]).collect();
        match (name, points.len()) {
            ("moveTo", 1) => {
                chains.extend(
                    open.replace(Chain::new(points[0]))
                        .map(|chain| chain.finished(false)),
                );
            }
            ("lineTo", 1) | ("quadraticCurveTo", 2) | ("bezierCurveTo", 3) => {
                open.as_mut().unwrap().push(&points);
            }
            ("closePath", 0) => chains.push(open.take().unwrap().finished(true)),
            _ => panic!("{line}"),
        }
    }
    chains.extend(open.map(|chain| chain.finished(false)));
    chains
}

#[test]
fn canvas_calls_hold_the_control_points() {
    for shape in SHAPES {
        let read = canvas(&printed(&format!("{shape} -f canvas")));
        assert_eq!(read, [stated(shape)], "{shape}");
    }
    let sphere = canvas(&printed("sphere 5 -f canvas -p 3"));
    assert_eq!(sphere.len(), curves_of_a_sphere());
}

// UFO glyphs

/// Reads a glyph: a closed contour is a ring of points, in which those off the curve belong to the next one on it.
fn glif(text: &str) -> Vec<Chain> {
    let document = roxmltree::Document::parse(text).unwrap();
    let glyph = document.root_element();
    assert_eq!(
        (glyph.tag_name().name(), glyph.attribute("format")),
        ("glyph", Some("2"))
    );
    assert!(glyph.attribute("name").is_some_and(|name| !name.is_empty()));
    let contours = glyph
        .descendants()
        .filter(|node| node.has_tag_name("contour"));
    let number =
        |node: &roxmltree::Node, name| node.attribute(name).unwrap().parse::<f64>().unwrap();
    contours
        .map(|contour| {
            let mut points: Vec<(Option<String>, [f64; 2])> = contour
                .children()
                .filter(roxmltree::Node::is_element)
                .map(|p| {
                    let kind = p.attribute("type").map(str::to_owned);
                    (kind, [number(&p, "x"), number(&p, "y")])
                })
                .collect();
            let (first, start) = points[0].clone();
            let closed = first.as_deref() != Some("move");
            if closed {
                points.rotate_left(1);
            } else {
                points.remove(0);
            }
            let mut chain = Chain::new(start);
            let mut off = Vec::new();
            for (kind, p) in points {
                off.push(p);
                let Some(kind) = kind else { continue };
                let expected = ["line", "qcurve", "curve"][off.len() - 1];
                assert_eq!(kind, expected, "{off:?}");
                chain.push(&core::mem::take(&mut off));
            }
            assert!(off.is_empty());
            chain.finished(closed)
        })
        .collect()
}

#[test]
fn a_glyph_holds_the_control_points() {
    for shape in SHAPES {
        let read = glif(&printed(&format!("{shape} -f glif")));
        assert_eq!(read, [stated(shape)], "{shape}");
    }
}

#[test]
fn a_glyph_is_called_as_its_file() {
    let folder = tempfile::tempdir().unwrap();
    for (file, name) in [("o.glif", "o"), ("A_E_.glif", "AE"), ("n_o.glif", "n_o")] {
        let file = folder.path().join(file);
        run(&["circle", "300", "-o", file.to_str().unwrap()]);
        let glyph = std::fs::read_to_string(file).unwrap();
        assert!(
            glyph.contains(&format!("<glyph name=\"{name}\"")),
            "{glyph}"
        );
    }
    assert!(printed("circle 300 -f glif").contains("<glyph name=\"circle\""));
}

#[cfg(unix)]
#[test]
fn a_glyph_is_well_formed_whatever_its_file_is_called() {
    let folder = tempfile::tempdir().unwrap();
    for (stem, name) in [
        ("a\"b", "a\"b"),
        ("<&'>", "<&'>"),
        ("a\u{1}b\nc\u{7f}", "a_b_c_"),
        ("\u{ffff}", "_"),
    ] {
        let file = folder.path().join([stem, ".glif"].concat());
        run(&["circle", "300", "-o", file.to_str().unwrap()]);
        let text = std::fs::read_to_string(file).unwrap();
        let glyph = roxmltree::Document::parse(&text).unwrap();
        assert_eq!(glyph.root_element().attribute("name"), Some(name));
    }
}

#[test]
fn a_glyph_lies_on_the_grid_and_states_its_error_there() {
    let glyph = printed("ellipse 300 220.5 --center 310,350 -f glif");
    assert_eq!(
        glif(&glyph),
        [stated("ellipse 300 220.5 --center 310,350 -p 0")]
    );
    let grid = printed("ellipse 300 220.5 --center 310,350 -f svg -p 0");
    let fine = printed("ellipse 300 220.5 --center 310,350 -f svg");
    let within = |text: &str| {
        let at = text.find("within ").unwrap();
        text[at..].split(" of the").next().unwrap().to_owned()
    };
    assert_eq!(within(&glyph), within(&grid));
    assert_ne!(within(&glyph), within(&fine));
    assert_eq!(glyph.matches("smooth=\"yes\"").count(), 4);
}

// Other programs, by make test-tex and make test-browser

/// TeX puts path operators on the page, in PostScript points.
#[test]
#[ignore = "needs LaTeX with TikZ: make test-tex"]
fn latex_draws_the_control_points() {
    const POINT: f64 = 72.0 / 72.27;
    let folder = tempfile::tempdir().unwrap();
    for shape in SHAPES {
        let drawing = printed(&format!("{shape} -f tikz"));
        let document = format!(
            "\\pdfcompresslevel=0 \\documentclass{{article}}\\usepackage{{tikz}}\\begin{{document}}\n\
             \\begin{{tikzpicture}}[x=1pt,y=1pt]\n{drawing}\\end{{tikzpicture}}\\end{{document}}\n"
        );
        fs::write(folder.path().join("drawing.tex"), document).unwrap();
        let output = Command::new("pdflatex")
            .args(["-halt-on-error", "-interaction=nonstopmode", "drawing.tex"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{shape}: {}",
            String::from_utf8_lossy(&output.stdout)
        );
        let page = fs::read(folder.path().join("drawing.pdf")).unwrap();
        let page = String::from_utf8_lossy(&page).into_owned();
        let path: String = page
            .lines()
            .skip_while(|line| !line.contains(" m "))
            .take_while(|line| line.trim() != "S")
            .collect();
        let numbers: Vec<f64> = path
            .split(' ')
            .filter_map(|word| word.parse().ok())
            .collect();
        let ours = stated(shape).raised();
        let expected: Vec<f64> = ours.segments[0][0]
            .iter()
            .chain(
                ours.segments
                    .iter()
                    .flat_map(|segment| segment[1..].iter().flatten()),
            )
            .map(|x| x * POINT)
            .collect();
        assert!(numbers.len() >= expected.len(), "{shape}: {path}");
        for (theirs, ours) in numbers.iter().zip(&expected) {
            assert!(
                (theirs - ours).abs() < 2e-4 + 2e-5 * ours.abs(),
                "{shape}: {theirs} against {ours}"
            );
        }
    }
}

/// The page of tests/browser runs the calls in a browser beside its own ellipse and says how many pixels differ.
#[test]
#[ignore = "needs Chromium"]
fn chromium_draws_canvas_calls_as_its_own_circle() {
    let page = include_str!("../browser/canvas.html");
    let folder = tempfile::tempdir().unwrap();
    let farthest = |shape: &str| {
        let file = folder.path().join("page.html");
        fs::write(
            &file,
            page.replace("@CALLS@", &printed(&format!("{shape} -f canvas"))),
        )
        .unwrap();
        let output = Command::new("chromium")
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"])
            .arg(format!("file://{}", file.display()))
            .output()
            .unwrap();
        let dom = String::from_utf8_lossy(&output.stdout).into_owned();
        let result = dom.split("<pre id=\"result\">").nth(1).unwrap();
        result.split('<').next().unwrap().parse::<f64>().unwrap()
    };
    let fine = farthest("circle 50 -n 8");
    let coarse = farthest("circle 50 -n 3 -m curvature");
    // The browser draws its own circle with other samples: that alone is worth 70 levels at the rim.
    assert!(fine <= 96.0 && coarse > 200.0, "{fine}, {coarse}");
}
