//! What is asked for seldom, each with the answer that it must have.

use curveto::method::{Method, Rule};
use curveto::shape::endpoint::SvgArc;
use curveto::{Angle, Arc, Error};
use kurbo::{CubicBez, ParamCurve, Point, Vec2};

use crate::judges::program::{json, piped, printed, refused, run, run_in, words};

#[test]
fn a_closed_shape_starts_at_the_joint_that_is_named() {
    let from_joint = "circle 5 --joints 0,90,180,270 --start 90 -p 2";
    let data = printed(&words(from_joint));
    assert_eq!(
        data,
        "M0 5C-2.76 5-5 2.76-5 0C-5-2.76-2.76-5 0-5C2.76-5 5-2.76 5 0C5 2.76 2.76 5 0 5Z\n"
    );
}

#[test]
fn open_paths_are_drawn_to_their_start_and_not_closed() {
    let lines = printed(&["path", "M0 0L5 5L9 0Z", "--open"]);
    assert_eq!(lines, "M0 0L5 5L9 0L0 0\n");
    let arcs = printed(&["path", "M0 0A5 5 0 0 0 10 0Z", "--to", "arcs", "--open"]);
    assert_eq!(arcs, "M0 0A5 5 0 0 0 10 0L0 0\n");
}

#[test]
fn comparisons_say_what_was_compared() {
    let of_ellipse = json(&words("compare --ellipse 0.5 -n 4 -m midpoint"));
    assert_eq!(of_ellipse["ellipse"], 0.5);
    let several = json(&words("compare --by peak,mean -n 4 -m midpoint"));
    assert_eq!(
        (&several[0]["by"], &several[1]["by"]),
        (&"peak".into(), &"mean".into())
    );
    let page = "compare -m chen-2 --quadrature gauss2 --ellipse 0.5 -n 4 -f html";
    let command = "curveto compare --ellipse 0.5 --quadrature gauss2 -m chen-2 -n 4 -o page.html";
    assert!(printed(&words(page)).contains(command));
}

#[test]
fn subpaths_in_another_order_are_named_by_both_numbers() {
    let [old, new] = ["M0 0L1 0M5 5L6 6", "M5 5L6 6.5M0 0L1 0"];
    let output = run(&["diff", old, new, "-t", "0.01"]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.starts_with("subpath 2 and 1: up to 0.5 apart"),
        "{said}"
    );
    let alone = run(&["diff", old, "M0 0L1 0", "-f", "json"]);
    let document: serde_json::Value = serde_json::from_slice(&alone.stdout).unwrap();
    let pair = &document["subpaths"][1];
    assert_eq!(pair["old"], 2, "{document}");
    assert!(
        pair["new"].is_null() && pair["distance"].is_null(),
        "{document}"
    );
}

#[test]
fn drawings_of_json_are_read_from_arrays() {
    let folder = tempfile::tempdir().unwrap();
    let documents = r#"[{"path":"M0 0L1 0"},{"path":"M5 5L6 6"}]"#;
    std::fs::write(folder.path().join("a.json"), documents).unwrap();
    let output = run_in(folder.path(), &["diff", "a.json", "M0 0L1 0M5 5L6 6"]);
    assert_eq!(output.stdout, b"2 subpaths with equal segments\n");
}

#[test]
fn true_shapes_are_fitted_and_named() {
    let half = "M5 0C5 2.7614 2.7614 5 0 5C-2.7614 5-5 2.7614-5 0";
    let fit = printed(&["measure", "--path", half, "--fit", "joints"]);
    assert!(
        fit.contains("against the circle about 0,0 of radius 5,"),
        "{fit}"
    );
    // Twice as wide as high: from the same formula, so that the nearest ellipse is the one it was made of but for some 1e-3.
    let wide = "M6 0C6 1.6569 3.3137 3 0 3C-3.3137 3-6 1.6569-6 0C-6-1.6569-3.3137-3 0-3C3.3137-3 6-1.6569 6 0";
    let near = json(&["measure", "--path", wide, "--fit", "ellipse"]);
    let radii = &near["reference"]["radii"];
    for (i, radius) in [6.0, 3.0].into_iter().enumerate() {
        let found = radii[i].as_f64().unwrap();
        assert!((found - radius).abs() < 2e-3, "{near}");
    }
    let quarter = "M6 0C6 1.6569 3.3137 3 0 3";
    let turned = "M0 6C-1.6569 6-3 3.3137-3 0";
    let of = |path: &str, against: &str| {
        json(&["measure", "--path", path, "--against", against])["error"]["outward"]
            .as_f64()
            .unwrap()
    };
    let [straight, upright] = [
        of(quarter, "ellipse:0,0,6,3"),
        of(turned, "ellipse:0,0,6,3,90"),
    ];
    assert!((straight / upright - 1.0).abs() < 1e-9 && straight > 1e-4);
}

#[test]
fn long_tables_of_joints_are_cut_and_say_so() {
    let data = printed(&words("circle 5 -n 20"));
    let against = "circle:0,0,5";
    let table = printed(&["measure", "--path", data.trim(), "--against", against]);
    let last = table.lines().last();
    assert_eq!(last, Some("... and 4 more joints: -f json lists them all"));
}

#[test]
fn uses_are_not_followed_by_measure_and_it_says_so() {
    let drawing = br##"<svg><path id="a" d="M5 0C5 2.76 2.76 5 0 5"/><use href="#a"/></svg>"##;
    let output = piped(&["measure", "--file", "-"], drawing);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success());
    assert!(said.contains("<use> is not followed"), "{said}");
}

#[test]
fn measures_of_conics_are_csv_too() {
    let conic = "measure conic --from 0,0 --control 5,8 --to 10,0 --weight 2 -n 2 -m minimax";
    let csv = printed(&[&words(conic)[..], &["-f", "csv"]].concat());
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let [names, values] = &lines[..] else {
        panic!("{csv}")
    };
    assert_eq!(names.len(), values.len());
    let document = json(&words(conic));
    let peak = names.iter().position(|name| *name == "peak").unwrap();
    assert_eq!(
        values[peak].parse::<f64>().ok(),
        document["error"]["peak"].as_f64()
    );
    assert_eq!(values[0], "hyperbola");
}

#[test]
fn natural_ends_are_named() {
    let spline = ["spline", "--points", "0,0 5,5 9,0", "--ends", "natural"];
    assert_eq!(json(&spline)["ends"], "natural");
}

#[test]
fn each_kind_of_element_can_be_converted_alone() {
    let drawing = br#"<svg><circle r="5"/><ellipse rx="5" ry="3"/><rect width="9" height="9" rx="1"/><path d="M0 0A5 5 0 0 1 5 5"/></svg>"#;
    for kind in ["circle", "ellipse", "rect", "path"] {
        let output = piped(&["convert", "--only", kind], drawing);
        let text = String::from_utf8(output.stdout).unwrap();
        let left = ["<circle", "<ellipse", "<rect", "A5 5"].map(|mark| text.contains(mark));
        let others = ["circle", "ellipse", "rect", "path"].map(|other| other != kind);
        assert_eq!(left, others, "{kind}: {text}");
    }
}

#[test]
fn pages_name_the_whole_command() {
    let page = printed(&words(
        "explore circle 5 --center 3,4 --open -n 4 -m minimax -f html",
    ));
    assert!(
        page.contains("circle 5 --center 3,4") && page.contains("--open"),
        "no command with both"
    );
}

#[test]
fn angles_are_shown_in_degrees() {
    assert_eq!(Angle::from_degrees(22.5).to_string(), "22.5deg");
}

#[test]
fn arcs_give_as_many_cubics_by_a_rule_as_are_asked_for() {
    let rule = Rule::from(Method::Midpoint);
    let quarter = Angle::from_degrees(90.0);
    let arc = Arc::new((0.0, 0.0), (5.0, 5.0), Angle::ZERO, Angle::ZERO, quarter).unwrap();
    let k = 20.0 / 3.0 * (2.0_f64.sqrt() - 1.0);
    let by_hand = CubicBez::new((5.0, 0.0), (5.0, k), (k, 5.0), (0.0, 5.0));
    let ends = SvgArc {
        from: Point::new(5.0, 0.0),
        radii: Vec2::new(5.0, 5.0),
        rotation: Angle::ZERO,
        large_arc: false,
        sweep: true,
        to: Point::new(0.0, 5.0),
    };
    for cubics in [
        arc.cubics_by(rule, 1).unwrap(),
        ends.cubics_by(rule, 1).unwrap().unwrap(),
    ] {
        let cubics: Vec<CubicBez> = cubics.collect();
        let [cubic] = cubics[..] else { panic!() };
        let off = [cubic.p0, cubic.p1, cubic.p2, cubic.p3]
            .iter()
            .zip([by_hand.p0, by_hand.p1, by_hand.p2, by_hand.p3])
            .map(|(p, q)| p.distance(q))
            .fold(0.0, f64::max);
        assert!(off < 1e-14, "{cubic:?}");
    }
    assert_eq!(arc.cubics_by(rule, 3).unwrap().count(), 3);
    assert!(matches!(
        arc.cubics_by(rule, 0),
        Err(Error::Count { count: 0, .. })
    ));
    let free = Rule::from(Method::MinimaxFree);
    assert!(matches!(
        arc.cubics_by(free, 1),
        Err(Error::Impossible { .. })
    ));
    let line = SvgArc {
        radii: Vec2::ZERO,
        ..ends
    };
    assert!(line.cubics_by(rule, 1).unwrap().is_none());
}

#[test]
fn hints_name_what_was_meant() {
    let path = "M0 0A5 5 0 0 1 9 9";
    for (arguments, hint) in [
        (&["arc", path][..], "curveto arc --svg 'M0 0A5 5 0 0 1 9 9'"),
        (
            &["circle", "50", "--center", "1.5 2.5"],
            "without a space: 1.5,2.5",
        ),
        (
            &["spline", "0,0", "5,8"],
            "points have a flag: --points '0,0 5,8 10,0'",
        ),
        (
            &["spline", "--points", "0,0 5,8 9,0", "--ends", "closed"],
            "--ends cyclic closes it",
        ),
        (
            &["circle", "5", "--joints", "0,90,180", "--start", "45"],
            "--start may name another of them",
        ),
    ] {
        let said = refused(arguments);
        assert!(said.contains(hint), "{arguments:?}: {said}");
    }
}

#[test]
fn another_kind_of_drawing_is_named_with_what_reads_it() {
    let diff = "'curveto diff' reads PostScript drawings";
    let json = "JSON holds path data under its key path, and 'curveto diff' reads it whole";
    for (words, drawing, hint) in [
        (&["path", "-"][..], "%!PS\n0 0 moveto", diff),
        (&["path", "-"], "0 0 moveto", diff),
        (&["path", "-"], "{\"path\": \"M0 0\"}", json),
        (&["measure", "--path", "-"], "<svg/>", "--file reads SVG"),
        (&["measure", "--path", "-"], "[{}]", json),
        (&["measure", "--path", "-"], "0 0 moveto", diff),
        (
            &["measure", "--file", "-"],
            "M0 0L1 1",
            "--path reads path data",
        ),
        (&["measure", "--file", "-"], "0 0 moveto", diff),
        (&["measure", "--file", "-"], "{}", json),
        (&["convert", "-"], "0 0 moveto", diff),
        (
            &["convert", "-"],
            "M0 0L1 1",
            "path data alone goes through 'curveto path'",
        ),
    ] {
        let said = String::from_utf8(piped(words, drawing.as_bytes()).stderr).unwrap();
        assert!(
            said.contains(&format!("hint: {hint}")),
            "{words:?} {drawing}: {said}"
        );
    }
}

#[test]
fn a_shape_of_a_file_that_cannot_be_drawn_is_named_with_its_line() {
    let arc = |id: &str, radius: &str| {
        format!("<path id=\"{id}\" d=\"M0 0A{radius} {radius} 0 0 1 {radius} {radius}\"/>\n")
    };
    let svg = |second: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\">\n{}{second}</svg>",
            arc("a", "5")
        )
    };
    let large = svg(&arc("b", "1e9"));
    for words in [
        &["path", "-", "-t", "1e-8"][..],
        &["path", "-", "--to", "lines", "-t", "1e-9"],
    ] {
        let said = String::from_utf8(piped(words, large.as_bytes()).stderr).unwrap();
        assert!(
            said.starts_with("error: <stdin>:3#b: "),
            "{words:?}: {said}"
        );
    }
    // Wherever the fault is no shape's, none is named.
    let said =
        String::from_utf8(piped(&["path", "-", "-n", "2000000"], large.as_bytes()).stderr).unwrap();
    assert!(said.starts_with("error: the number of segments"), "{said}");
    let far = svg("<g transform=\"scale(1e140)\">\n<path d=\"M0 0L1e20 0\"/></g>");
    for words in [&["path", "-"][..], &["diff", "-", "M0 0"]] {
        let said = String::from_utf8(piped(words, far.as_bytes()).stderr).unwrap();
        assert!(said.starts_with("error: <stdin>:4: "), "{words:?}: {said}");
    }
}

#[test]
fn quadratics_of_a_straight_cubic_are_one_in_any_tolerance() {
    for tolerance in ["1", "1%", "1e-9"] {
        let words = [
            "path",
            "M0 0C1 0 2 0 3 0",
            "--to",
            "quadratics",
            "-t",
            tolerance,
        ];
        assert_eq!(printed(&words), "M0 0Q1.5 0 3 0\n");
    }
}

#[test]
fn elliptic_arcs_are_scaled_exactly() {
    for (transform, path) in [
        ("scale(.5)", "M0 0A2.5 1.5 0 0 1 5 0\n"),
        ("translate(1,2)", "M1 2A5 3 0 0 1 11 2\n"),
    ] {
        let words = ["path", "M0 0A5 3 0 0 1 10 0", "--to", "arcs", "--elliptic"];
        assert_eq!(
            printed(&[&words[..], &["--transform", transform]].concat()),
            path
        );
    }
}

#[test]
fn the_side_that_reaches_farther_is_named() {
    for (old, new, side) in [
        ("M0 0L2 0", "M0 0L1 0", "old"),
        ("M0 0L1 0", "M0 0L2 0", "new"),
    ] {
        let output = run(&["diff", old, new, "-f", "json"]);
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(
            document["subpaths"][0]["farthest"]["drawing"], side,
            "{document}"
        );
        assert_eq!(document["distance"], 1);
    }
}

#[test]
fn pictures_of_elliptic_arcs_have_their_box() {
    // Half an ellipse above the axis, as SVG looks at it, and a line below; half the width of the line around.
    let path = "M0 0A5 3 0 0 1 10 0L5 5";
    let eps = printed(&[
        "path",
        path,
        "--to",
        "arcs",
        "--elliptic",
        "-f",
        "eps",
        "-p",
        "1",
    ]);
    let bounds = "%%HiResBoundingBox: -0.05 -3.05 10.05 5.05";
    assert!(eps.lines().any(|line| line == bounds), "{eps}");
}

#[test]
fn a_path_that_nobody_paints_is_forgotten() {
    let eps = printed(&words("circle 5 -f eps --stroke none"));
    assert_eq!(eps.matches("newpath").count(), 1, "{eps}");
}

#[test]
fn derivatives_of_the_curvature_of_conics_are_plotted() {
    let folder = tempfile::tempdir().unwrap();
    let conic = "measure conic --from 0,0 --control 5,8 --to 10,0 --weight 2 -n 2 --plot a.svg";
    let quantities = ["--quantity", "curvature-d1,curvature-d2"];
    let output = run_in(folder.path(), &[&words(conic)[..], &quantities].concat());
    assert!(output.status.success());
    let plot = std::fs::read_to_string(folder.path().join("a.svg")).unwrap();
    for title in [
        "First derivative of curvature",
        "Second derivative of curvature",
    ] {
        assert!(plot.contains(title), "{title}");
    }
}

#[test]
fn styles_that_may_round_a_rectangle_leave_it_unless_they_are_trusted() {
    let rect = |style: &str| {
        format!(
            "<svg><style>.a{{rx:{style}}}</style><rect class='a' width='9' height='9' rx='1'/></svg>"
        )
    };
    let unread = rect("var([a])");
    let left = piped(&["convert"], unread.as_bytes());
    assert_eq!(left.stdout, unread.as_bytes());
    assert!(!left.stderr.is_empty());
    let trusted = piped(&["convert", "--trust", "style-geometry"], unread.as_bytes());
    assert!(trusted.stderr.is_empty() && !trusted.stdout.windows(5).any(|text| text == b"<rect"));
    // Without corners of its own a trusted one is a plain rectangle, which has no arcs.
    let plain = unread.replace(" rx='1'", "");
    let trusted = piped(&["convert", "--trust", "style-geometry"], plain.as_bytes());
    assert!(trusted.stderr.is_empty());
    assert_eq!(trusted.stdout, plain.as_bytes());
}

#[test]
fn pictures_without_a_stroke_have_black_joints_and_a_height() {
    let circle = "circle 5 -f svg --stroke none --fill red --show joints";
    assert!(printed(&words(circle)).contains(r##"<g class="joints" fill="#000""##));
    let line = "arc --from 0,0 --to 5,0 --bulge 0 -f svg --stroke none --fill red";
    assert!(printed(&words(line)).starts_with(r#"<svg viewBox="-0.05 -0.05 5.1 0.1""#));
}

#[test]
fn only_the_kinds_that_are_named_come_back() {
    let path = r#"<path d="M5 0C5 2.76 2.76 5 0 5C-2.76 5-5 2.76-5 0C-5-2.76-2.76-5 0-5C2.76-5 5-2.76 5 0Z"/>"#;
    let drawing = format!("<svg>{path}</svg>");
    let arcs = r#"<svg><path d="M5 0A5 5 0 0 1-5 0A5 5 0 0 1 5 0Z"/></svg>"#;
    let circle = r#"<svg><circle cx="0" cy="0" r="5"/></svg>"#;
    for (only, shapes, expected) in [
        ("rect", true, &drawing[..]),
        ("circle", false, &drawing),
        ("rect,path", true, arcs),
        ("path", true, arcs),
        ("circle", true, circle),
    ] {
        let mut words = vec!["convert", "--to", "arcs", "--only", only];
        words.extend(shapes.then_some("--shapes"));
        let output = piped(&words, drawing.as_bytes());
        assert_eq!(
            String::from_utf8(output.stdout).unwrap(),
            expected,
            "{only}"
        );
    }
}

/// The numbers of an attribute, wherever it stands in front of a text.
fn numbers(text: &str, attribute: &str, before: &str) -> Vec<f64> {
    let lines = text.lines().filter(|line| line.contains(before));
    let value = |line: &str| {
        line.split_once(attribute)?
            .1
            .split_once('"')?
            .0
            .parse()
            .ok()
    };
    lines.filter_map(value).collect()
}

#[test]
fn a_legend_that_is_too_wide_takes_two_rows() {
    let folder = tempfile::tempdir().unwrap();
    let methods = "minimax,midpoint,area,goldapp,curvature,apprich,chen-2,chen-3,standard";
    let plot = [
        "measure", "circle", "5", "-m", methods, "--plot", "p.svg", "-q",
    ];
    assert!(run_in(folder.path(), &plot).status.success());
    let text = std::fs::read_to_string(folder.path().join("p.svg")).unwrap();
    let [mut rows, mut ends] = [Vec::new(), Vec::new()];
    for method in methods
        .split(',')
        .chain(["midpoint"])
        .filter(|id| *id != "standard")
    {
        let name = format!(">{method}</text>");
        rows.extend(numbers(&text, " y=\"", &name));
        ends.extend(numbers(&text, " x=\"", &name));
    }
    rows.sort_by(f64::total_cmp);
    rows.dedup();
    assert_eq!(rows, [46.0, 64.0]);
    assert!(ends.iter().all(|&x| x < 760.0));
}

#[test]
fn the_control_points_of_a_drawing_below_a_chart_are_moved_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let plot = ["--plot", "p.svg", "--quantity", "error,drawing", "-q"];
    let words = [&["measure", "circle", "5"][..], &plot].concat();
    assert!(run_in(folder.path(), &words).status.success());
    let text = std::fs::read_to_string(folder.path().join("p.svg")).unwrap();
    let [x, y] = [" cx=\"", " cy=\""].map(|name| numbers(&text, name, "<circle"));
    // The control polygon is as wide as it is high, below the first chart.
    let extent = |values: &[f64]| {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        values.iter().copied().fold(0.0, f64::max) - least
    };
    assert_eq!((x.len(), y.len()), (16, 16));
    assert!((extent(&x) - extent(&y)).abs() < 0.02, "{x:?} {y:?}");
    assert!(y.iter().all(|&y| y > 280.0 && y < 560.0), "{y:?}");
}

#[test]
fn the_farthest_place_may_be_on_the_new_drawing() {
    let found = run(&[
        "diff",
        "M0 0L10 0",
        "M0 0L5 3L10 0",
        "-f",
        "json",
        "-t",
        "1",
    ]);
    let document: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
    let farthest = &document["subpaths"][0]["farthest"];
    assert_eq!(farthest["drawing"], "new", "{document}");
    assert_eq!(farthest["point"], serde_json::json!([5, 3]));
    assert_eq!(document["distance"], 3);
}

#[test]
fn measurements_name_a_literal_handle_and_no_other() {
    let with = json(&words("measure circle 5 --handle 0.55"));
    assert_eq!(with["subject"]["handle"], 0.55);
    let without = json(&words("measure circle 5"));
    assert!(without["subject"]["handle"].is_null());
}

#[test]
fn samples_of_an_exact_conic_have_no_error() {
    let of = |weight: &str| {
        let conic = "measure conic --from 0,0 --control 5,8 --to 10,0 -f csv --samples 5 --weight";
        let csv = printed(&[&words(conic)[..], &[weight]].concat());
        let rows: Vec<Vec<String>> = csv
            .lines()
            .skip(1)
            .map(|l| l.split(',').map(str::to_owned).collect())
            .collect();
        assert_eq!(rows.len(), 5, "{csv}");
        rows
    };
    let exact = of("1");
    assert!(
        exact
            .iter()
            .all(|row| row[0] == "parabola" && row[7] == "0"),
        "{exact:?}"
    );
    // Beside the parabola an ellipse is drawn as one of its own.
    let nearly = of("0.99999");
    assert!(nearly.iter().all(|row| row[0] == "ellipse"), "{nearly:?}");
    assert!(nearly.iter().any(|row| row[7] != "0"), "{nearly:?}");
}

#[test]
fn what_has_no_size_has_no_relative_error() {
    let dot = json(&["path", "M5 5Z"]);
    assert_eq!(dot["subpaths"][0]["error"]["relative_peak"], 0);
    let line = run(&words("arc --from 0,0 --to 5,0 --bulge 0 -v"));
    let said = String::from_utf8(line.stderr).unwrap();
    assert_eq!(said, "line: exact\n");
}

#[test]
fn exact_arcs_in_postscript_stray_no_farther_than_it_says() {
    let text = printed(&["path", "M0 0A5 5 0 0 1 5 5", "--to", "arcs", "-f", "eps"]);
    let stated = text
        .split_once(", within ")
        .unwrap()
        .1
        .lines()
        .next()
        .unwrap();
    let stated: f64 = stated.parse().unwrap();
    assert!(stated < 1e-6, "{stated}");
    let mut from = Point::ZERO;
    let mut count = 0;
    for line in text
        .lines()
        .filter(|line| !line.starts_with('%'))
        .filter_map(|line| line.strip_suffix(" curveto"))
    {
        let numbers = line
            .split(' ')
            .map(str::parse)
            .collect::<Result<Vec<f64>, _>>();
        let c = numbers.unwrap_or_else(|error| panic!("{line}: {error}"));
        let [p1, p2, p3] = [0, 2, 4].map(|i| Point::new(c[i], c[i + 1]));
        let cubic = CubicBez::new(from, p1, p2, p3);
        for i in 0..=20 {
            let p = cubic.eval(f64::from(i) / 20.0);
            let off = (p.distance(Point::new(0.0, 5.0)) - 5.0).abs();
            assert!(off <= stated, "{off}");
        }
        (from, count) = (p3, count + 1);
    }
    assert!(count > 4 && from == Point::new(5.0, 5.0));
}

#[test]
fn a_side_of_a_rectangle_that_comes_back_is_no_side() {
    let rect = br#"<svg><rect width="20" height="10" rx="3"/></svg>"#;
    let path = String::from_utf8(piped(&["convert"], rect).stdout).unwrap();
    let back = |text: &str| {
        let words = ["convert", "--to", "arcs", "--shapes", "--only", "rect"];
        String::from_utf8(piped(&words, text.as_bytes()).stdout).unwrap()
    };
    assert!(
        back(&path).contains(r#"<rect x="0" y="0" width="20" height="10" rx="3""#),
        "{path}"
    );
    let hesitating = path.replacen("H17", "H10H8H17", 1);
    assert_ne!(hesitating, path);
    assert_eq!(back(&hesitating), hesitating);
}

#[test]
fn what_style_sheets_hold_beside_declarations_says_nothing_of_arcs() {
    let with = |css: &str, data: &str| {
        format!(r#"<svg><marker id="m"/><style>{css}</style><path d="{data}"/></svg>"#)
    };
    let arc = "M0 0A5 5 0 1 1 5 5";
    // Two joints more, on which a marker would stand.
    let cubic = "M0 0C0-2.7596 2.2404-5 5-5 7.7596-5 10-2.7596 10 0 10 2.7596 7.7596 5 5 5";
    for (css, expected) in [
        ("@keyframes k{from{fill:red;.a{stroke:blue}}}", cubic),
        (".a{fill:(5) [b] {c}}", cubic),
        ("path{marker:none}", cubic),
        // A value that is not understood may be a marker.
        ("path{marker:none (5)}", arc),
        ("path{marker:[none]}", arc),
    ] {
        let output = piped(&["convert"], with(css, arc).as_bytes());
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(text, with(css, expected), "{css}");
    }
}

#[test]
fn the_smallest_arc_of_a_path_has_its_digits_and_so_have_the_others() {
    let digits = |data: &str| printed(&["path", data]).split(' ').map(str::len).max();
    let large = "M0 0A5 5 0 0 1 5 5";
    assert!(digits(large) < Some(10));
    let both = format!("{large}M0 0A1e-40 1e-40 0 0 1 1e-40 1e-40");
    assert!(printed(&["path", &both]).starts_with("M0 0C2.75957512246755"));
}

#[test]
fn a_point_after_seven_digits_does_not_end_a_number() {
    let svg = "<svg><path d='M1000087.5 0A5 5 0 0 1 1000090.5 0'/></svg>";
    let output = piped(&["convert"], svg.as_bytes());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let made = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.is_empty() && made.contains("M1000087.5 0C"),
        "{said}{made}"
    );
    assert!(made.contains(" 1000090.5 0'"), "{made}");
}
