//! Arcs as machines and CAD say them, paths, the forms of a line of `batch`, and what is said on standard error.

use curveto::contour::{BezierTarget, draw};
use curveto::{Cut, Options, Tolerance, path};
use kurbo::{ParamCurve, PathSeg, Point};
use proptest::prelude::*;

use crate::judges::program::{self, drawn, json, printed, refused, run};
use crate::judges::random::uniform;

/// What the program prints for this input, and on standard error.
fn piped(arguments: &[&str], input: &[u8]) -> [String; 2] {
    let output = program::piped(arguments, input);
    [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap())
}

#[test]
fn a_sweep_that_misses_a_turn_by_rounding_is_a_turn() {
    let circle = printed(&["circle", "10"]);
    assert_eq!(
        printed(&["arc", "10", "--sweep", "6.283185307179587rad"]),
        circle
    );
    assert_eq!(printed(&["arc", "10", "--sweep", "359.99998"]), circle);
    let between = [
        "arc",
        "10",
        "--start",
        "4.9774927157884115rad",
        "--end",
        "11.260678022967998rad",
    ];
    assert!(printed(&between).ends_with("Z\n"));
    assert_eq!(piped(&["batch"], b"arc 0 0 10 0 360.0000001\n")[0], circle);
    assert!(!printed(&["arc", "10", "--sweep", "359.9999"]).contains('Z'));
    refused(&["arc", "10", "--sweep", "360.0001"]);
    assert_eq!(
        printed(&["arc", "10", "--sweep", "360", "--open"]),
        circle.replace('Z', "")
    );
}

#[test]
fn an_end_is_read_as_postscript_reads_it() {
    for (ends, sweep) in [
        (["350", "10"], "20"),
        (["10", "350"], "340"),
        (["-90", "-180"], "270"),
        (["0", "360"], "360"),
    ] {
        let by_end = printed(&["arc", "10", "--start", ends[0], "--end", ends[1]]);
        assert_eq!(
            by_end,
            printed(&["arc", "10", "--start", ends[0], "--sweep", sweep])
        );
        let back = printed(&[
            "arc",
            "10",
            "--start",
            ends[1],
            "--end",
            ends[0],
            "--reverse",
        ]);
        let lowered = format!("-{sweep}");
        assert_eq!(
            back,
            printed(&["arc", "10", "--start", ends[1], "--sweep", &lowered])
        );
    }
}

#[test]
fn machines_arcs_are_those_of_the_other_forms() {
    let bulge = |to: &str, b: &str| printed(&["arc", "--from", "10,0", "--to", to, "--bulge", b]);
    let machine =
        |rest: &[&str]| printed(&[&["arc", "--from", "10,0", "--to", "-10,0"], rest].concat());
    assert_eq!(machine(&["--radius", "10"]), bulge("-10,0", "1"));
    assert_eq!(
        machine(&["--radius", "9.9995", "--reverse"]),
        bulge("-10,0", "-1")
    );
    assert_eq!(machine(&["--center", "0,0"]), bulge("-10,0", "1"));
    // A centre that was rounded moves to where both ends are met.
    let met = machine(&["--center", "0,0.0005", "--reverse"]);
    assert!(
        met.starts_with("M10 0C") && met.ends_with(" -10 0\n".trim_start()),
        "{met}"
    );
    let quarter = [
        "arc", "--from", "10,0", "--to", "0,10", "--radius", "10", "-p", "6",
    ];
    assert_eq!(
        printed(&quarter),
        printed(&["arc", "10", "--start", "0", "--sweep", "90", "-p", "6"])
    );
    let long = [
        "arc", "--from", "0,10", "--to", "10,0", "--center", "0,0", "-p", "6",
    ];
    assert_eq!(
        printed(&long),
        printed(&["arc", "10", "--start", "90", "--sweep", "270", "-p", "6"])
    );
    let whole = ["arc", "--from", "10,0", "--to", "10,0", "--center", "0,0"];
    assert_eq!(printed(&whole), printed(&["circle", "10"]));
    let three = ["arc", "--through", "10,0", "-10,0", "10,0"];
    assert_eq!(printed(&three), printed(&["circle", "10"]));
    refused(&["arc", "--from", "0,0", "--to", "10,0", "--radius", "4"]);
    refused(&["arc", "--from", "0,0", "--to", "0,0", "--radius", "4"]);
    refused(&["arc", "--from", "10,0", "--to", "0,11", "--center", "0,0"]);
    refused(&["arc", "--from", "10,0", "--to", "0,11", "--center", "10,0"]);
    refused(&["arc", "--from", "10,0", "--to", "0,11"]);
    refused(&[
        "arc", "--from", "10,0", "--to", "0,11", "--bulge", "1", "--center", "0,0",
    ]);
}

#[test]
fn verbose_states_what_was_done_and_quiet_keeps_notes() {
    let told = |arguments: &[&str]| String::from_utf8(run(arguments).stderr).unwrap();
    assert_eq!(
        told(&["circle", "50", "-v"]),
        "circle of radius 50: 4 segments by minimax, within 0.00985 (1.97e-4 of the larger radius)\n"
    );
    assert_eq!(told(&["circle", "50"]), "");
    assert_eq!(
        told(&["procset", "-q", "-v"]),
        "procedures drawellipse and drawcircle: 4 segments by minimax, within 1.97e-4 of the larger radius\n"
    );
    let svg = br#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="50%"/></svg>"#;
    assert!(piped(&["convert"], svg)[1].starts_with("note: "));
    assert_eq!(piped(&["convert", "-q"], svg)[1], "");
    let svg = br#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg>"#;
    assert_eq!(
        piped(&["convert", "-v"], svg)[1],
        "<stdin>: 1 circle replaced, within 9.85e-4 of the true shapes\n"
    );
    let lines = b"circle 0 0 5\ncircle 0 0 50\n\npath M0 0H9";
    for format in ["path", "ps", "json", "svg"] {
        let said = &piped(&["batch", "-v", "-f", format], lines)[1];
        let start = "<stdin>: 4 lines read, 0 could not be drawn; each within 0.0098";
        assert!(said.starts_with(start), "{format}: {said}");
        assert!(
            said.ends_with(" of its true shape, the farthest on line 2\n"),
            "{format}: {said}"
        );
    }
}

#[test]
fn a_stated_figure_is_rounded_up() {
    let svg = printed(&["circle", "50", "-t", "0.1", "-f", "svg"]);
    let stated = svg
        .split("within ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap();
    let peak =
        json(&["circle", "50", "-t", "0.1", "-f", "json", "-p", "auto"])["error"]["peak"].as_f64();
    let stated: f64 = stated.parse().unwrap();
    assert!(stated >= peak.unwrap() && stated < 1.01 * peak.unwrap());
}

#[test]
fn every_form_of_a_line_is_read() {
    let forms = "\u{feff}bulge 10 0 -10 0 1\nthrough 10 0 0 10 -10 0\npolyline 10 0 1 -10 0 1 close\npath M10 0A10 10 0 0 1-10 0\n";
    let [text, _] = piped(&["batch"], forms.as_bytes());
    let lines: Vec<&str> = text.lines().collect();
    let half = "M10 0C10 5.5192 5.5192 10 0 10C-5.5192 10-10 5.5192-10 0";
    assert_eq!(lines[..2], [half, half]);
    assert_eq!(lines[2], printed(&["circle", "10"]).trim_end());
    assert_eq!(lines[3], half);
    for bad in [
        "polyline 0 0",
        "polyline 0 0 1 close 3",
        "through 0 0 1 1",
        "path M0 0L",
        "polyline a b c",
    ] {
        assert!(
            piped(&["batch"], format!("{bad}\n").as_bytes())[1].starts_with("error: <stdin>:1:"),
            "{bad}"
        );
    }
}

#[test]
fn a_bad_line_is_reported_by_its_id_and_number() {
    let lines = "circle 0 0 1\n{\"id\":[7],\"circle\":{\"radius\":-1}}\nsquare\n";
    for jobs in ["1", "3"] {
        let [text, _] = piped(
            &["batch", "-f", "json", "--on-error", "report", "-j", jobs],
            lines.as_bytes(),
        );
        let answers: Vec<serde_json::Value> = text
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect();
        assert_eq!(answers[1]["id"][0], 7);
        assert_eq!([&answers[1]["line"], &answers[2]["line"]], [2, 3]);
        assert!(answers[1]["error"].as_str().unwrap().contains("radius"));
    }
    refused(&["batch", "--on-error", "report"]);
}

#[test]
fn a_path_keeps_what_is_given() {
    assert_eq!(
        printed(&["path", "M0 0L50 0A50 50 0 0 1 0 50Z"]),
        "M0 0L50 0C50 27.596 27.596 50 0 50Z\n"
    );
    assert_eq!(
        printed(&["path", "m.1.1l.2 0q1 1 2 0t2 0zM1 1z"]),
        "M0.1 0.1L0.3 0.1Q1.3 1.1 2.3 0.1Q3.3-0.9 4.3 0.1ZM1 1L1 1Z\n"
    );
    // Radii of zero make a line, equal ends make nothing.
    assert_eq!(
        printed(&["path", "M0 0A0 5 0 0 1 3 0A5 5 0 0 1 3 0L4 0"]),
        "M0 0L3 0L4 0\n"
    );
    assert_eq!(
        piped(&["path", "-"], b"\xef\xbb\xbfM0 0H5")[0],
        "M0 0L5 0\n"
    );
    refused(&["path", "no-such-file"]);
    refused(&["path", "M0 0L5"]);
    refused(&[
        "path",
        "M0 0A5 5 0 0 1 9 0",
        "--to",
        "quadratics",
        "-m",
        "minimax",
    ]);
    let document = json(&["path", "M0 0A5 5 0 0 1 10 0M0 0L1 1", "-f", "json"]);
    assert_eq!(document["subpaths"].as_array().unwrap().len(), 2);
    assert_eq!(document["subpaths"][1]["error"]["peak"], 0.0);
    assert_eq!(document["error"], document["subpaths"][0]["error"]);
}

#[test]
fn every_format_takes_a_path() {
    for format in [
        "path", "svg", "ps", "eps", "json", "png", "pdf", "tikz", "canvas", "glif", "dxf",
    ] {
        let output = run(&["path", "M0 0L50 0A50 50 0 0 1 0 50ZM5 5h9", "-f", format]);
        assert!(
            output.status.success() && !output.stdout.is_empty(),
            "{format}"
        );
    }
}

fn distance(segments: &[PathSeg], p: Point) -> f64 {
    let points = segments
        .iter()
        .flat_map(|segment| (0..=400).map(move |i| segment.eval(f64::from(i) / 400.0)));
    points.map(|q| q.distance(p)).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn quadratics_stay_within_the_tolerance(
        points in prop::array::uniform3((-100.0_f64..100.0, -100.0_f64..100.0)),
        tolerance in 0.05_f64..5.0,
    ) {
        let [(a, b), (c, d), (e, f)] = points;
        let data = format!("M0 0C{a} {b} {c} {d} {e} {f}");
        let options = Options { cut: Cut::Tolerance(Tolerance::Absolute(tolerance)), ..Options::default() };
        let contours = path::contours(&data).unwrap();
        let drawing = draw(&contours, BezierTarget::Quadratics, &options).unwrap();
        prop_assert!(drawing.error().peak() <= tolerance);
        let given = path::curves(&data).unwrap();
        let drawn = &drawing.subpaths[0].curve.segments;
        prop_assert_eq!(drawn.last().unwrap().end(), Point::new(e, f));
        for i in 0..=40 {
            let p = given[0].segments[0].eval(f64::from(i) / 40.0);
            // Sampling finds no nearer point than there is.
            prop_assert!(distance(drawn, p) <= drawing.error().peak() + 2.0);
        }
    }

    #[test]
    fn neighbouring_arcs_share_their_points(
        radii in prop::collection::vec(1.0_f64..80.0, 2..5),
        precision in prop::option::of(0_u8..6),
    ) {
        let arcs: Vec<String> = radii.iter().map(|r| format!("a{r} {r} 0 0 1 {} 3", r / 2.0)).collect();
        let options = Options { precision: precision.map(curveto::number::Precision::Fixed), ..Options::default() };
        let drawing = draw(&path::contours(&format!("M1 2{}", arcs.concat())).unwrap(), BezierTarget::Beziers, &options).unwrap();
        let segments = &drawing.subpaths[0].curve.segments;
        for pair in segments.windows(2) {
            prop_assert_eq!(pair[0].end(), pair[1].start());
        }
    }
}

#[test]
fn extremes_are_joints() {
    assert_eq!(
        printed(&["circle", "50", "--extremes"]),
        printed(&["circle", "50"])
    );
    let cases: [&[&str]; 4] = [
        &["ellipse", "30", "20", "--rotation", "30"],
        &["ellipse", "30", "2", "--rotation", "-77", "--reverse"],
        &[
            "arc",
            "30",
            "20",
            "--rotation",
            "15",
            "--start",
            "10",
            "--sweep",
            "-300",
        ],
        &[
            "circle",
            "30",
            "--transform",
            "skewX(30) scale(2 1)",
            "--start",
            "45",
        ],
    ];
    for words in cases {
        for (more, parts) in [(&[][..], 1), (&["-n", "3"][..], 3)] {
            let document = json(&[words, &["--extremes", "-f", "json"], more].concat());
            let segments = document["segments"].as_array().unwrap();
            let corner = |i: usize, axis: usize| segments[i]["points"][0][axis].as_f64().unwrap();
            // No point of the curve lies farther out than the joints.
            let count = segments.len();
            assert!(
                count >= 4 * parts && count.is_multiple_of(parts),
                "{words:?}: {count}"
            );
            let path = document["path"].as_str().unwrap();
            let curve = &path::curves(path).unwrap()[0];
            let bounds = curve.bounding_box().unwrap();
            let last = curve.segments.last().unwrap().end();
            for (axis, sides) in [(0, [bounds.x0, bounds.x1]), (1, [bounds.y0, bounds.y1])] {
                let end = if axis == 0 { last.x } else { last.y };
                for side in sides {
                    let nearest = (0..count).map(|i| (corner(i, axis) - side).abs());
                    let nearest = nearest.fold((end - side).abs(), f64::min);
                    assert!(nearest < 1e-9, "{words:?}: {nearest}");
                }
            }
        }
    }
    let within = json(&program::words(
        "ellipse 30 20 --rotation 30 --extremes -t 1e-4 -f json",
    ));
    assert!(within["error"]["peak"].as_f64().unwrap() <= 1e-4);
    // Each piece is cut into as few as it takes.
    for (words, count) in [
        ("arc 50 --start 10 --end 200 --extremes -t 0.001", 5),
        ("ellipse 50 20 --rotation 30 --extremes -t 0.0001", 12),
        ("circle 50 --extremes -t 0.001", 8),
        ("circle 50 --extremes -t 0.0001 -m minimax-free", 12),
        // Between two extremes lie 162 degrees, and the method serves 120.
        ("ellipse 5000 200 --rotation 7 --extremes -m apprich", 6),
        (
            "ellipse 5000 200 --rotation 7 --extremes -m apprich -t 200",
            6,
        ),
    ] {
        let document = json(&program::words(&format!("{words} -f json")));
        assert_eq!(
            document["segments"].as_array().unwrap().len(),
            count,
            "{words}"
        );
    }
    refused(&["path", "M0 0A5 5 0 0 1 9 0", "--extremes"]);
    refused(&["circle", "5", "--extremes", "--joints", "0,90,180"]);
}

fn first_of_piped(arguments: &[&str], input: &[u8]) -> String {
    piped(arguments, input)[0].clone()
}

/// The path data of the only path in a document.
fn path_in(document: &str) -> String {
    let (_, rest) = document.split_once(" d=\"").unwrap();
    rest.split_once('"').unwrap().0.to_owned()
}

#[test]
fn the_single_command_batch_and_convert_give_the_same_numbers() {
    let mut seed = 11_u64;
    for i in 0..60 {
        // Decimal numbers of few digits, halves among them, which rounding decides.
        let mut number = |scale: f64| (uniform(&mut seed) * scale * 20.0).round() / 20.0;
        let (cx, cy) = (number(40.0) - 20.0, number(40.0) - 20.0);
        let (rx, ry) = (3.0 + number(30.0), 3.0 + number(30.0));
        let tolerance = [0.8, 0.3, 0.06][i % 3];
        let precision = ["0", "1", "2"][i % 3];
        let (t, numbers) = (
            tolerance.to_string(),
            [cx, cy, rx, ry].map(|x| x.to_string()),
        );
        let [cx, cy, rx, ry] = &numbers;
        let cut = ["-t", t.as_str()];
        let single = printed(
            &[
                &[
                    "ellipse",
                    rx,
                    ry,
                    "--center",
                    &format!("{cx},{cy}"),
                    "-p",
                    precision,
                ],
                &cut[..],
            ]
            .concat(),
        );
        let line = format!("ellipse {cx} {cy} {rx} {ry}\n");
        let batch = first_of_piped(
            &[&["batch", "-p", precision], &cut[..]].concat(),
            line.as_bytes(),
        );
        assert_eq!(single, batch, "{line}");
        let element = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><ellipse cx=\"{cx}\" cy=\"{cy}\" rx=\"{rx}\" ry=\"{ry}\"/></svg>"
        );
        let converted = first_of_piped(
            &[&["convert", "-p", precision], &cut[..]].concat(),
            element.as_bytes(),
        );
        // The shorter of absolute and relative commands, as `path` reads both.
        let points = |data: &str| -> Vec<kurbo::PathEl> {
            kurbo::BezPath::from_svg(data).unwrap().elements().to_vec()
        };
        let (ours, theirs) = (points(&path_in(&converted)), points(single.trim()));
        assert_eq!(
            ours.len(),
            theirs.len(),
            "{line} {cut:?}: {converted} {single}"
        );
        for (a, b) in ours.iter().zip(&theirs) {
            let apart = a.end_point().unwrap_or_default() - b.end_point().unwrap_or_default();
            assert!(apart.hypot() < 1e-9, "{line} {cut:?}: {converted} {single}");
        }
    }
}

#[test]
fn batch_rounds_json_as_it_is_asked() {
    let auto = first_of_piped(&["batch", "-f", "json", "-p", "auto"], b"circle 0 0 1\n");
    assert!(auto.contains("[1,0.55192]"), "{auto}");
    let full = first_of_piped(&["batch", "-f", "json"], b"circle 0 0 1\n");
    assert!(full.contains("[1,0.5519150244935106]"), "{full}");
}

#[test]
fn a_precision_that_leaves_nothing_is_refused() {
    let output = run(&["circle", "0.4", "-p", "0"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        message.contains("rounded to 0 decimals") && message.contains("hint: "),
        "{message}"
    );
}

#[test]
fn a_huge_radius_costs_no_tolerance() {
    let path = printed(&["arc", "--svg", "M0 0A1e10 1e10 0 0 1 1 0", "-t", "1e-6"]);
    assert!(path.starts_with("M0 0C"), "{path}");
}

#[test]
fn a_method_that_needs_thousands_of_segments_answers() {
    let output = run(&program::words("circle 116 -m apprich-plus -t 4.76e-06 -v"));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        message.contains("segments by apprich-plus, within 0.00000"),
        "{message}"
    );
}

#[test]
fn what_goes_into_a_file_is_the_same_on_every_terminal() {
    for words in [
        "methods",
        "methods minimax",
        "measure circle 50",
        "compare",
        "circle --help",
        "-h",
    ] {
        let mut command = program::program(&program::words(words));
        let narrow = command.env("COLUMNS", "40").output().unwrap().stdout;
        assert_eq!(drawn(words), narrow, "{words}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn the_catalogue_fits_terminals_from_60_to_200_columns() {
    for columns in [60, 66, 72, 80, 100, 200] {
        let table = program::on_terminal("methods", columns);
        let widest = table
            .lines()
            .map(|line| line.chars().count())
            .max()
            .unwrap();
        assert!(widest <= columns, "{columns}: {widest}");
        for method in curveto::Method::ALL {
            let id = format!("\n{} ", method.id());
            assert!(table.contains(&id), "{columns}: {id}");
        }
        // A criterion is not cut into single words.
        assert_eq!(table.contains("criterion"), columns >= 72);
        assert_eq!(table.contains("Lancaster 2005"), columns >= 90);
        // Where there is room, nothing is wrapped.
        for method in curveto::Method::ALL.iter().filter(|_| columns == 200) {
            let whole = |line: &str| {
                line.starts_with(method.id()) && line.contains(method.card().criterion)
            };
            assert!(table.lines().any(whole), "{method}");
        }
    }
}

/// The peak that JSON states, and the farthest that `diff` finds between what is drawn and the true path data.
fn stated_and_found(words: &[&str], truth: &str) -> [f64; 2] {
    let drawn = json(&[words, &["-f", "json"]].concat());
    let path = drawn["path"].as_str().unwrap().to_owned();
    let output = run(&["diff", truth, &path, "-f", "json"]);
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let apart = found["subpaths"][0]["distance"].as_f64();
    [
        drawn["error"]["peak"].as_f64().unwrap(),
        apart.unwrap_or_else(|| panic!("{found}")),
    ]
}

#[test]
fn what_is_stated_holds_where_rounding_moves_lines_and_quadratics() {
    for (words, truth) in [
        // A line, and quadratics in a cubic's place.
        (
            &[
                "arc",
                "--through",
                "0.4,0.4",
                "1.4,1.4",
                "2.4,2.4",
                "-p",
                "0",
            ][..],
            "M0.4 0.4L2.4 2.4",
        ),
        (
            &[
                "path",
                "M0 0C0 400 300 700 700 700",
                "--to",
                "quadratics",
                "-t",
                "0.5",
                "-p",
                "0",
            ],
            "M0 0C0 400 300 700 700 700",
        ),
    ] {
        let [stated, found] = stated_and_found(words, truth);
        // What diff tells may lie a ten-thousandth above.
        assert!(stated >= 0.999_9 * found, "{words:?}: {stated} {found}");
        assert!(stated <= 1.000_001 * found, "{words:?}: {stated} {found}");
    }
}

#[test]
fn a_start_of_many_turns_is_that_of_its_rest() {
    // 1e20 is 280 degrees and whole turns.
    for shape in [
        &["circle", "10"][..],
        &["arc", "10", "--sweep", "90"],
        &["ellipse", "10", "7"],
    ] {
        let far = printed(&[shape, &["--start", "1e20"]].concat());
        assert_eq!(far, printed(&[shape, &["--start", "280"]].concat()));
    }
}

#[test]
fn what_a_format_has_itself_is_stated_as_exact() {
    let told = |arguments: &[&str]| String::from_utf8(run(arguments).stderr).unwrap();
    assert_eq!(
        told(&["circle", "5", "-f", "gcode", "-v"]),
        "Circle of radius 5, exact but for rounding to 6 decimals\n"
    );
    let dxf = ["arc", "5", "--end", "90", "-f", "dxf", "-v"];
    assert_eq!(told(&dxf), "Arc of radius 5 over 90 degrees, exact\n");
    let coarse = [
        "circle", "5", "--center", "0.3,0.2", "-p", "0", "-f", "gcode",
    ];
    assert!(printed(&coarse).contains("which moves it by up to 0."));
    assert!(refused(&[&coarse[..], &["-t", "0.01"]].concat()).contains("give more decimals"));
    // How an arc would be approximated says nothing: one list of flags serves all formats.
    let plain = printed(&["circle", "5", "-f", "gcode"]);
    assert_eq!(
        printed(&["circle", "5", "-f", "gcode", "-m", "chen-3", "-n", "7"]),
        plain
    );
}

#[test]
fn a_sphere_states_what_rounding_adds() {
    let sphere = ["sphere", "10", "-f", "json"];
    let peak = |more: &[&str]| {
        json(&[&sphere[..], more].concat())["error"]["peak"]
            .as_f64()
            .unwrap()
    };
    assert!(peak(&["-p", "0"]) > 0.5 && peak(&[]) < 0.002);
}

#[test]
fn extremes_begin_at_the_start() {
    assert!(printed(&["circle", "50", "--extremes", "--start", "90"]).starts_with("M0 50C"));
    // A start that was asked for wins.
    let words = "ellipse 50 30 --extremes --start 30 -p 2 -f json";
    let document = json(&words.split(' ').collect::<Vec<_>>());
    assert!(document["path"].as_str().unwrap().starts_with("M43.3 15C"));
    assert_eq!(document["segments"].as_array().unwrap().len(), 5);
    // What rounding makes of a rotation moves no start.
    assert!(
        printed(&["ellipse", "50", "30", "--rotation", "1e-13", "--extremes"])
            .starts_with("M50 0C")
    );
}

#[test]
fn what_svg_does_not_render_is_left_out_and_the_rest_is_drawn() {
    let circle = "<circle id='c' r='5'/>";
    let drawn = printed(&["circle", "5"]);
    let flat = "the transform flattens everything to a line or a point: nothing is left to draw";
    let placed = |transform: &str| format!("<g transform='{transform}'>{circle}</g>");
    for (gone, why) in [
        (placed("scale(0)"), flat),
        (placed("scale(1 0)"), flat),
        (placed("skewX(90)"), flat),
        (placed("rotate(30)scale(1 1e-13)"), flat),
        (
            placed("scale(0)").replace(
                "<circle id='c' r='5'/>",
                "<path id='c' d='M0 0C1 1 2 2 3 0'/>",
            ),
            flat,
        ),
        (
            "<ellipse id='c' transform='scale(1 1e-9)' rx='5' ry='1e-5'/>".to_owned(),
            flat,
        ),
        (
            format!("<svg width='0'>{circle}</svg>"),
            "a viewport around it has no size: nothing in it is drawn",
        ),
        (
            format!("<svg viewBox='0 0 0 5' width='9' height='9'>{circle}</svg>"),
            "a viewport around it has no size: nothing in it is drawn",
        ),
        (
            "<circle id='c' r='2em'/>".to_owned(),
            "its r '2em' is not read here",
        ),
        (
            "<path id='c' style='transform:scale(2);transform-box:fill-box' d='M0 0L1 1'/>"
                .to_owned(),
            "its transform-box 'fill-box' is not read here",
        ),
    ] {
        let svg = format!("<svg>{}\n{gone}</svg>", circle.replace(" id='c'", ""));
        let note = format!("note: <stdin>:2#c: left out: {why}\n");
        assert_eq!(
            piped(&["path", "-"], svg.as_bytes()),
            [drawn.clone(), note.clone()]
        );
        let output = program::piped(&["diff", drawn.trim(), "-", "-t", "0.01"], svg.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{svg}");
        assert_eq!(String::from_utf8(output.stderr).unwrap(), note);
    }
    // Negative sizes are errors, which count as if they were not there.
    let svg = "<svg viewBox='0 0 -3 5'><circle r='5'/></svg>";
    assert_eq!(
        piped(&["path", "-"], svg.as_bytes()),
        [drawn, String::new()]
    );
    let [nothing, said] = piped(&["path", "-"], placed("scale(0)").as_bytes());
    assert!(
        nothing.is_empty()
            && said.ends_with("error: <stdin> has no path and no shape that is drawn\n"),
        "{said}"
    );
}

#[test]
fn a_radius_in_percent_is_one_of_the_diagonal() {
    for size in ["viewBox='0 0 70 10'", "width='70' height='10'"] {
        let svg = format!("<svg {size}><circle r='10%'/></svg>");
        let drawn = [printed(&["circle", "5"]), String::new()];
        assert_eq!(piped(&["path", "-"], svg.as_bytes()), drawn);
    }
}

#[test]
fn a_transform_that_leaves_nothing_is_refused_for_every_shape() {
    for shape in [
        "circle 5",
        "arc 5 --sweep 90",
        "conic --from 0,0 --control 1,1 --to 2,0 --weight 1",
        "path M0_0L1_1",
        "path M0_0C1_1_2_2_3_0",
        "spline --points 0,0_1,2_3,1",
        "sphere 5",
        "measure circle 5",
    ] {
        for transform in ["scale(0)", "scale(1_0)", "rotate(30)scale(1_1e-13)"] {
            let output = program::run_words(&format!("{shape} --transform {transform}"));
            let said = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{shape}");
            assert!(
                said.contains("flattens everything to a line or a point"),
                "{said}"
            );
        }
    }
}

#[test]
fn radii_far_too_small_are_scaled_up() {
    for rotation in ["0", "30"] {
        let arc = |radii: &str| printed(&["path", &format!("M0 0A{radii} {rotation} 0 1 1 0")]);
        assert_eq!(arc("1e-160 2e-160"), arc("1e-3 2e-3"), "{rotation}");
        assert_eq!(arc("1e-310 1e-310"), arc("1e-3 1e-3"), "{rotation}");
    }
    let said = refused(&["path", "M0 0A1e-160 1 0 0 1 1 0"]);
    assert!(said.contains("is too flat"), "{said}");
}

#[test]
fn an_arc_that_is_its_chord_to_the_last_digit_is_a_line() {
    let tiny = format!("0.{}1", "0".repeat(199));
    let line = format!("M0 0L{tiny} 0L9 9\n");
    assert_eq!(printed(&["path", "M0 0A5 5 0 0 1 1e-200 0L9 9"]), line);
    assert_eq!(printed(&["path", "M0 0A5 3 20 0 0 1e-200 0L9 9"]), line);
    let svg = |data: &str| format!("<svg><path d='{data}'/></svg>");
    let [converted, said] = piped(
        &["convert", "-"],
        svg("M0 0A5 5 0 0 1 1e-200 0L9 9").as_bytes(),
    );
    assert_eq!([converted, said], [svg("M0 0L1e-200 0L9 9"), String::new()]);
    for arc in [
        &["arc", "--svg", "M0 0A1e40 1e40 0 0 1 1 0", "-t", "1e-20"][..],
        &["arc", "--from", "0,0", "--to", "1,0", "--bulge", "-1e-200"],
        &["arc", "--through", "0,0", "0.5,1e-40", "1,0"],
    ] {
        assert_eq!(printed(arc), "M0 0L1 0\n", "{arc:?}");
    }
    // The longer arc between such ends is all of the circle.
    for (end, zeros) in [("1e-200", 199), ("1e-300", 299)] {
        let drawn = printed(&["path", &format!("M0 0A5 5 0 1 1 {end} 0")]);
        let last = format!("0 0.{}1 0\n", "0".repeat(zeros));
        assert!(
            drawn.starts_with("M0 0C-2.7596 0-5-2.2404-5-5C-5-7.7596") && drawn.ends_with(&last),
            "{drawn}"
        );
    }
    let [_, said] = piped(&["batch"], b"polyline 0 0 1 1e-200 0 0 1 1 0");
    assert!(
        said.contains("the radius 5e-201 is too small: lengths must be at least 1e-100"),
        "{said}"
    );
}

#[test]
fn the_error_of_an_arc_of_huge_radius_is_that_of_its_chord() {
    // The line is what is drawn, and the arc leaves it by a quarter of the chord over the diameter.
    for radius in ["1e18", "1e20", "1e25"] {
        let arc = format!("M0 0A{radius} {radius} 0 0 1 1 0");
        let found = json(&["arc", "--svg", &arc])["error"]["peak"]
            .as_f64()
            .unwrap();
        let sagitta = 0.125 / radius.parse::<f64>().unwrap();
        assert!(
            found >= 0.99 * sagitta && found < 1e-15,
            "{radius}: {found}"
        );
        assert!(printed(&["arc", "--svg", &arc, "-t", "1e-12"]).ends_with("1 0\n"));
    }
}

#[test]
fn curves_so_small_that_squares_vanish_are_refused_as_circles_are() {
    let curve = |size: &str| format!("M0 0C{size} 0 {size} {size} 0 {size}");
    let small = curve("1e-160");
    let (plain, other) = (curve("1e-99"), curve("2e-99"));
    for words in [
        &["path", &small, "--to", "quadratics"][..],
        &["path", &small, "--to", "lines"],
        &["path", &small, "--to", "arcs"],
        &["diff", &small, &small],
    ] {
        let said = refused(words);
        let why = "the size of the path 1e-160 is too small: lengths must be at least 1e-100";
        assert!(said.contains(why), "{words:?}: {said}");
    }
    // Just above, as many segments as at any size.
    for (kind, count) in [("quadratics", 6), ("lines", 39)] {
        let drawn = json(&["path", &plain, "--to", kind, "-f", "json"]);
        let segments = drawn["subpaths"][0]["segments"].as_array().unwrap();
        assert_eq!(segments.len(), count, "{kind}");
        assert!(drawn["error"]["peak"].as_f64().unwrap() > 0.0, "{kind}");
    }
    assert_eq!(run(&["diff", &plain, &other]).status.code(), Some(1));
    // What is measured is measured in a unit of its own.
    let error = |size: &str| {
        let found = json(&["measure", "--path", &curve(size)]);
        found["error"]["outward"].as_f64().unwrap() / size.parse::<f64>().unwrap()
    };
    assert!((error("1e-200") / error("1") - 1.0).abs() < 1e-9);
}

#[test]
fn shapes_of_a_file_have_the_digits_that_the_commands_give_them() {
    let path = |svg: &str| piped(&["path", "-", "-p", "17"], svg.as_bytes())[0].clone();
    for (shape, command) in [
        ("<circle r='5'/>", "circle 5"),
        ("<circle r='50' cx='3' cy='-4'/>", "circle 50 --center 3,-4"),
        ("<ellipse rx='30' ry='20.7'/>", "ellipse 30 20.7"),
        (
            "<rect x='-7' y='-7' width='14' height='14' rx='7'/>",
            "circle 7 --start -90",
        ),
    ] {
        let words = format!("{command} -p 17");
        assert_eq!(
            path(&format!("<svg>{shape}</svg>")),
            program::drawn_text(&words),
            "{shape}"
        );
    }
    // No handle lies outside, and what is symmetric is drawn so.
    let drawn = path("<svg><circle cx='.1' cy='.2' r='.3'/></svg>");
    assert!(
        drawn.starts_with("M0.4 0.2C0.4 ") && drawn.contains(" 0.5 0.1 0.5C"),
        "{drawn}"
    );
    let quarter = printed(&["path", "M5 0A5 5 0 0 1 0 5", "-p", "17"]);
    assert_eq!(quarter, printed(&["arc", "5", "--sweep", "90", "-p", "17"]));
    let other = printed(&["path", "M0 5A5 5 0 0 1-5 0", "-p", "17"]);
    assert_eq!(
        other,
        printed(&["arc", "5", "--start", "90", "--sweep", "90", "-p", "17"])
    );
}

#[test]
fn handles_that_are_level_with_an_end_are_so_by_their_coefficients_too() {
    for radius in ["50", "7.3", "1e-20"] {
        let drawn = printed(&["circle", radius, "-f", "json"]);
        let back = printed(&["path", "--power", &drawn, "-f", "json"]);
        let back: serde_json::Value = serde_json::from_str(&back).unwrap();
        let points = &back["subpaths"][0]["segments"][0]["points"];
        let number = |i: usize, axis: usize| points[i][axis].as_f64().unwrap();
        assert_eq!(
            [number(1, 0), number(2, 1)],
            [number(0, 0), number(3, 1)],
            "{radius}"
        );
    }
}
