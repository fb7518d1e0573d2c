//! What the three documents say beyond the methods: their tables, procedures and figures, each by a command.

use curveto::kurbo::{CubicBez, Point};
use curveto::measure::radial;
use curveto::shape::Truth;
use curveto::{Method, method::Span};
use serde_json::Value;

use crate::judges::ghostscript;
use crate::judges::program::{json, number, piped, printed, refused, shell, words};

#[test]
fn samples_are_the_points_of_the_curve_beside_the_circle() {
    let k = 0.551_784;
    let found = json(&words(
        "measure arc 1 --start 0 --end 90 -m lancaster-best --samples 91",
    ));
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 91);
    for (i, sample) in samples.iter().enumerate() {
        let t = i as f64 / 90.0;
        let u = 1.0 - t;
        let x = u * u * u + 3.0 * u * u * t + 3.0 * u * t * t * k;
        let y = 3.0 * u * u * t * k + 3.0 * u * t * t + t * t * t;
        let expected = [
            ("t", t),
            ("x", x),
            ("y", y),
            ("radius", x.hypot(y)),
            ("error", x.hypot(y) - 1.0),
            ("degrees", y.atan2(x).to_degrees()),
        ];
        for (key, value) in expected {
            assert!((number(&sample[key]) - value).abs() < 1e-13, "{key} at {t}");
        }
    }
}

#[test]
fn samples_of_an_ellipse_err_along_its_normal() {
    let found = json(&["measure", "ellipse", "3", "1", "-n", "5", "--samples", "33"]);
    let peak = number(&json(&["measure", "ellipse", "3", "1", "-n", "5"])["error"]["peak"]);
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 5 * 33);
    let largest = samples
        .iter()
        .map(|s| number(&s["error"]).abs())
        .fold(0.0, f64::max);
    assert!(largest <= peak && largest > 0.9 * peak, "{largest} {peak}");
    // The distance from the centre is another figure.
    assert!((number(&samples[16]["radius"]) - number(&samples[16]["error"]) - 1.0).abs() > 0.1);
}

#[test]
fn samples_as_a_table_and_csv_say_the_same() {
    let words = [
        "measure",
        "circle",
        "50",
        "-m",
        "midpoint,minimax",
        "--samples",
        "3",
    ];
    let csv = printed(&[&words[..], &["-f", "csv"]].concat());
    assert_eq!(csv.lines().count(), 1 + 2 * 4 * 3);
    assert!(csv.starts_with("subject,method,segment,t,x,y,radius,error,degrees\n"));
    let table = printed(&words);
    assert_eq!(table.matches("of 12 points: peak").count(), 2, "{table}");
    assert!(refused(&["measure", "circle", "1", "--samples", "1"]).contains("from 2"));
    assert!(refused(&["measure", "circle", "1", "--samples", "99999999"]).contains("250000"));
}

#[test]
fn the_reporter_prints_x_before_y() {
    let procedures = printed(&["procset", "--with", "reporter"]);
    let said = ghostscript::run(&format!(
        "{procedures}\nnewpath 10 20 moveto 30 40 lineto 1 2 3 4 5 6.5 curveto closepath reportpath count ="
    ));
    assert_eq!(
        said,
        "10.0 20.0 moveto \n30.0 40.0 lineto \n1.0 2.0 3.0 4.0 5.0 6.5 curveto \nclosepath\n0\n"
            .replace(" \n", "\n")
    );
    // What his own gives: y first, since that lies on top of the stack.
    let his =
        ghostscript::run("newpath 10 20 moveto {== == (moveto\n) print flush} {} {} {} pathforall");
    assert_eq!(his, "20.0\n10.0\nmoveto\n");
}

#[test]
fn the_inverse_trigonometry_is_right_in_all_its_quadrants() {
    let procedures = printed(&["procset", "--with", "trig"]);
    let values = (-20..=20).map(|step| f64::from(step) / 20.0);
    let program = values.clone().fold(procedures, |program, value| {
        let x = 7.0 * value;
        program + &format!("{value} trig.acos = {value} trig.asin = {x} 7 acos = {x} 7 asin =\n")
    });
    let said = ghostscript::run(&(program + "count ="));
    let found: Vec<f64> = said.lines().map(|line| line.parse().unwrap()).collect();
    let expected = values.flat_map(|value| {
        let [acos, asin] = [value.acos().to_degrees(), value.asin().to_degrees()];
        [acos, asin, acos, asin]
    });
    assert_eq!(found.len(), 4 * 41 + 1);
    for (found, expected) in found.iter().zip(expected.chain([0.0])) {
        // It prints six digits.
        assert!((found - expected).abs() < 1e-3, "{found} is not {expected}");
    }
    // His asin, as printed.
    let his = "/asin {2 copy dup mul exch dup mul sub abs sqrt exch pop atan} def -0.5 1 asin =";
    assert_eq!(ghostscript::run(his), "330.0\n");
}

#[test]
fn procedures_are_named_once_and_stand_alone() {
    let all = printed(&["procset", "--with", "trig,reporter,trig"]);
    assert_eq!(all.matches("%%BeginResource").count(), 3);
    assert_eq!(all.matches("%%EndResource").count(), 3);
    let said = ghostscript::run(&format!(
        "/say 7 def {all}\n2 drawcircle reportpath say = count ="
    ));
    assert!(
        said.starts_with("-1.0 0.0 moveto\n") && said.ends_with("curveto\n7\n0\n"),
        "{said}"
    );
    assert!(refused(&["procset", "--with", "printer"]).contains("reporter"));
}

/// Apprich's own formulas: delta-minus, E and E*.
fn apprich(phi: f64) -> [f64; 3] {
    let (s, c) = phi.sin_cos();
    let delta = (1.0 - c) / (3.0 * s * (3.0 + 2.0 * c))
        * (2.0 * (4.0 + 3.0 * c) - (2.0 * (5.0 + 3.0 * c)).sqrt());
    let e = 9.0 / 32.0 * (c - 1.0) * delta * delta - 0.75 * delta * s + 0.5 - 0.5 * c;
    let root = (1.0 - e).sqrt();
    [delta, e, (1.0 - root) / (1.0 + root)]
}

#[test]
fn apprichs_errors_are_his_formulas_at_any_angle() {
    let compared = |words: &[&str]| {
        let spans = ["--spans", "20,30,50,90,110,120"];
        json(&[&["compare"], words, &spans[..]].concat())["methods"][0]["values"].clone()
    };
    let e = compared(&["-m", "apprich", "--by", "square"]);
    let scaled = compared(&["-m", "apprich-scaled"]);
    for (i, degrees) in [20.0_f64, 30.0, 50.0, 90.0, 110.0, 120.0]
        .into_iter()
        .enumerate()
    {
        let [_, big_e, star] = apprich(degrees.to_radians());
        assert!((number(&e[i]) - big_e).abs() < 1e-14, "{degrees}");
        assert!((number(&scaled[i]) - star).abs() < 1e-14, "{degrees}");
    }
}

#[test]
fn apprichs_error_has_one_maximum_at_the_middle() {
    let truth = Truth::circle(Point::ORIGIN, 1.0);
    for degrees in 10..=120 {
        let phi = f64::from(degrees).to_radians();
        let (s, c) = phi.sin_cos();
        let k = Method::Apprich
            .piece(&Span::from_degrees(f64::from(degrees)))
            .unwrap()
            .handle
            .y;
        assert!((k - apprich(phi)[0]).abs() < 1e-14);
        let curve = CubicBez::new((1.0, 0.0), (1.0, k), (c + k * s, s - k * c), (c, s));
        let mut extremes = Vec::new();
        // At the ends, where the curve touches the circle, nothing is left but rounding.
        radial::visit_extremes(&curve.into(), &truth, |t, distance| {
            if distance.abs() > 1e-15 {
                extremes.push((t, distance));
            }
        });
        let [(t, distance)] = extremes.as_slice() else {
            panic!("{degrees}: {extremes:?}");
        };
        assert!((t - 0.5).abs() < 1e-9 && *distance < 0.0, "{degrees}: {t}");
    }
}

#[test]
fn spans_and_counts_of_a_turn_compare_alike() {
    let figures = |words: &[&str]| {
        let found = json(&[&["compare", "--by", "peak"], words].concat());
        found["methods"].as_array().unwrap().clone()
    };
    let (by_span, by_count) = (figures(&["--spans", "90,60,45"]), figures(&["-n", "4,6,8"]));
    assert_eq!(by_span.len(), Method::ALL.len());
    for (a, b) in by_span.iter().zip(&by_count) {
        for i in 0..3 {
            match (a["values"][i].as_f64(), b["values"][i].as_f64()) {
                (Some(x), Some(y)) => assert!((x - y).abs() <= 1e-12, "{a} {b}"),
                (x, y) => assert_eq!(x, y, "{a} {b}"),
            }
        }
    }
    let page = printed(&["compare", "--spans", "22.5,45,90", "-f", "svg"]);
    assert!(page.contains("22.5") && page.contains("angle (degrees)"));
    for wrong in [
        &["--spans", "0"][..],
        &["--spans", "-30"],
        &["--spans", "361"],
    ] {
        assert!(refused(&[&["compare"], wrong].concat()).contains("360 degrees"));
    }
    assert!(refused(&["compare", "--spans", "30", "-n", "4"]).contains("--segments"));
    assert!(refused(&["compare", "--spans", "30", "--ellipse", "0.5"]).contains("--ellipse"));
}

#[test]
fn coefficients_lead_back_to_the_points_that_they_came_from() {
    let shapes: [&[&str]; 5] = [
        &["circle", "50", "-p", "6"],
        &[
            "ellipse",
            "30",
            "20",
            "--rotation",
            "15",
            "--center",
            "1e3,-7",
        ],
        &["circle", "1", "-m", "quadratic-minimax", "-p", "9"],
        &["path", "M0 0L10 0C12 3 14 5.5 9 9Q3 3 1 2ZM5 5L6 7.25 8 1"],
        &["spline", "--points", "0,0 1,2 3,1 4,4"],
    ];
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("power.json");
    for shape in shapes {
        let document = printed(&[shape, &["-f", "json"]].concat());
        std::fs::write(&file, &document).unwrap();
        let back = json(&["path", "--power", file.to_str().unwrap()]);
        let there: Value = serde_json::from_str(&document).unwrap();
        let points = |document: &Value| -> Vec<f64> {
            let chains = document["subpaths"].as_array().cloned();
            chains
                .unwrap_or_else(|| vec![document.clone()])
                .iter()
                .flat_map(|chain| chain["segments"].as_array().unwrap().clone())
                .flat_map(|segment| segment["points"].as_array().unwrap().clone())
                .flat_map(|p| [number(&p[0]), number(&p[1])])
                .collect()
        };
        let (there, back) = (points(&there), points(&back));
        assert_eq!(there.len(), back.len(), "{shape:?}");
        let largest = there.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (a, b) in there.iter().zip(&back) {
            assert!((a - b).abs() <= 1e-15 * largest * 4.0, "{shape:?}: {a} {b}");
        }
    }
    // Several drawings, one a line, and the lines of a sphere.
    let lines = piped(&["batch", "-f", "json"], b"circle 0 0 5\narc 0 0 8 0 90");
    std::fs::write(&file, &lines.stdout).unwrap();
    let both = printed(&["path", "--power", file.to_str().unwrap(), "-p", "4"]);
    assert_eq!(both.matches(['M', 'Z']).count(), 3, "{both}");
    let sphere = ["sphere", "5", "--meridians", "4", "--parallels", "1"];
    std::fs::write(&file, printed(&[&sphere[..], &["-f", "json"]].concat())).unwrap();
    assert_eq!(
        printed(&["path", "--power", file.to_str().unwrap(), "-p", "4"]),
        printed(&[&sphere[..], &["-p", "4"]].concat())
    );
    // Few decimals come back digit for digit.
    let path = printed(&["circle", "50", "-p", "6"]);
    std::fs::write(&file, printed(&["circle", "50", "-p", "6", "-f", "json"])).unwrap();
    assert_eq!(printed(&["path", "--power", file.to_str().unwrap()]), path);
}

#[test]
fn coefficients_that_are_none_are_refused() {
    let wrong = [
        "{",
        "[1,2]",
        r#"{"x": [1,2,3,4]}"#,
        r#"{"x": [1,2,3,1e200], "y": [0,0,0,0]}"#,
        "no-such-file",
    ];
    for json in wrong {
        assert!(
            refused(&["path", "--power", json]).contains("error: "),
            "{json}"
        );
    }
    assert!(refused(&["path", "--power", "[1,2]"]).contains("[A,B,C,D]"));
    assert!(refused(&["path", "--power", "[]", "M0 0"]).contains("--power"));
    // Segments that do not meet are subpaths of their own.
    let apart = r#"[{"x": [0,0,1,0], "y": [0,0,1,0]}, {"x": [0,0,1,5], "y": [0,0,1,5]}]"#;
    assert_eq!(printed(&["path", "--power", apart]), "M0 0L1 1M5 5L6 6\n");
}

#[test]
fn an_arc_by_points_and_radius_is_chens_formula_26() {
    for (from, to, radius) in [
        ([2.0_f64, 1.0_f64], [1.0, 2.0], 1.0_f64),
        ([3.0, -4.0], [-4.0, -3.0], 7.0),
        ([0.0, 0.0], [10.0, 0.0], 5.01),
    ] {
        let words = [
            "arc",
            "--from",
            &format!("{},{}", from[0], from[1]),
            "--to",
            &format!("{},{}", to[0], to[1]),
            "--radius",
            &radius.to_string(),
            "-m",
            "chen-3",
            "-n",
            "1",
        ];
        let found = json(&words);
        let chord = (to[0] - from[0]).hypot(to[1] - from[1]);
        let alpha = 2.0 * (chord / 2.0 / radius).asin();
        // (24): the length of the arc; (25): the tangents are at right angles to the radii.
        let length = alpha * radius;
        let center: Vec<f64> = found["shape"]["center"]
            .as_array()
            .unwrap()
            .iter()
            .map(number)
            .collect();
        let segment = &found["segments"][0];
        let point = |i: usize| {
            [
                number(&segment["points"][i][0]),
                number(&segment["points"][i][1]),
            ]
        };
        for (i, end) in [from, to].into_iter().enumerate() {
            let d = [0, 1].map(|axis| number(&segment["derivatives"][i][axis]));
            let expected = [
                -(end[1] - center[1]) / radius * length,
                (end[0] - center[0]) / radius * length,
            ];
            for axis in 0..2 {
                assert!(
                    (d[axis] - expected[axis]).abs() < 1e-9,
                    "{words:?}: {d:?} {expected:?}"
                );
                // A third of it is the handle.
                let handle = if i == 0 {
                    point(1)[axis] - point(0)[axis]
                } else {
                    point(3)[axis] - point(2)[axis]
                };
                assert!((3.0 * handle - d[axis]).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn a_joint_of_uneven_arcs_has_the_bias_and_tension_of_chens_27() {
    let joints = "0,30,90,120,180,210,270,300";
    let of = |method: &str, radius: &str| {
        let found = json(&[
            "measure", "circle", radius, "-m", method, "--joints", joints,
        ]);
        found["continuity"]["joints"][0]["parameters"].clone()
    };
    // Where 60 degrees follow 30. The end curvatures are 1.0222250509 and 1.0816852721.
    let found = of("chen-3", "1");
    assert!((number(&found["bias"]) - 2.0).abs() < 1e-12);
    assert!((number(&found["tension"]) + 0.0860).abs() < 5e-5, "{found}");
    let after = core::f64::consts::FRAC_PI_3;
    let rest = (1.081_685_272_1 - 1.022_225_050_9) * after * after;
    assert!((number(&found["rest"]) - rest).abs() < 1e-9 && (rest - 0.0652).abs() < 5e-5);
    // Lengths grow with the circle, and so does the rest.
    let larger = of("chen-3", "50");
    assert!((number(&larger["rest"]) - 50.0 * rest).abs() < 1e-7);
    assert!((number(&larger["tension"]) - number(&found["tension"])).abs() < 1e-12);
    // The circle's own curvature at both sides leaves nothing.
    assert!(number(&of("curvature", "1")["rest"]).abs() < 1e-13);
    // Equal segments: no bias, no tension, no rest.
    let even = json(&["measure", "circle", "1", "-m", "chen-3"]);
    let even = &even["continuity"]["joints"][0]["parameters"];
    assert!((number(&even["bias"]) - 1.0).abs() < 1e-13 && number(&even["rest"]).abs() < 1e-13);
    // A corner has neither.
    let corner = json(&["measure", "circle", "1", "-m", "quadratic-area"]);
    assert!(corner["continuity"]["joints"][0]["parameters"].is_null());
}

#[test]
fn several_quantities_and_counts_stand_one_below_the_other() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |words: &[&str]| {
        let file = folder.path().join("plot.svg");
        printed(
            &[
                &["measure", "circle", "1"],
                words,
                &["--plot", file.to_str().unwrap()],
            ]
            .concat(),
        );
        std::fs::read_to_string(file).unwrap()
    };
    let figure = draw(&[
        "-m",
        "apprich",
        "-n",
        "4",
        "--quantity",
        "curvature,curvature-d1,curvature-d2",
    ]);
    for (words, places) in [
        ("angle about the centre", 3),
        ("First derivative", 1),
        ("Second derivative", 1),
    ] {
        assert_eq!(figure.matches(words).count(), places, "{words}");
    }
    assert!(figure.contains("height=\"840\""), "{}", &figure[..300]);
    let errors = draw(&["-m", "lancaster-best", "-n", "2,3,4,5,6,8"]);
    assert_eq!(errors.matches("angle about the centre").count(), 6);
    for count in [2, 3, 4, 5, 6, 8] {
        assert!(
            errors.contains(&format!("{count} segments by lancaster-best")),
            "{count}"
        );
    }
    // The size that was asked for holds all of them.
    let small = draw(&[
        "-n",
        "2,4",
        "--quantity",
        "error,curvature",
        "--size",
        "400x800",
    ]);
    assert!(
        small.contains("height=\"800\"") && small.matches("angle about the centre").count() == 4
    );
    let measured = json(&words("measure circle 1 -n 3,5 -m midpoint,minimax"));
    let counts: Vec<f64> = measured
        .as_array()
        .unwrap()
        .iter()
        .map(|m| number(&m["segments"]))
        .collect();
    assert_eq!(counts, [3.0, 5.0, 3.0, 5.0]);
    assert!(refused(&["circle", "1", "-n", "3,5"]).contains("hint: 'curveto measure'"));
    assert!(
        refused(&words(
            "measure circle 1 --plot x.svg --quantity error,beauty"
        ))
        .contains("angle-lag")
    );
}

/// Lancaster's spline of n pieces at 91 points in single precision: the peak and the mean of |r - 1|.
fn in_single_precision(n: u32, k: f32) -> [f32; 2] {
    let a = core::f64::consts::TAU / f64::from(n);
    let (s, c) = (a.sin() as f32, if n == 4 { 0.0 } else { a.cos() as f32 });
    let (xs, ys) = ([1.0, 1.0, c + k * s, c], [0.0, k, s - k * c, s]);
    let at = |p: [f32; 4], t: f32| {
        let [a, b, d] = [
            p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0],
            3.0 * p[2] - 6.0 * p[1] + 3.0 * p[0],
            3.0 * p[1] - 3.0 * p[0],
        ];
        ((a * t + b) * t + d) * t + p[0]
    };
    let errors = (0..=90_u8).map(|i| {
        let t = f32::from(i) / 90.0;
        ((at(xs, t).powi(2) + at(ys, t).powi(2)).sqrt() - 1.0).abs()
    });
    let all: Vec<f32> = errors.collect();
    let sum: f32 = all.iter().sum();
    [all.iter().copied().fold(0.0, f32::max), sum / 91.0]
}

#[test]
fn lancasters_table_is_single_precision() {
    // His peaks of 4, 5, 6 and 8 splines are whole multiples of 2^-24, to the digits that he prints.
    for (peak, units) in [
        (0.000_265_718, 4458.0),
        (6.788_97e-5, 1139.0),
        (2.384_19e-5, 400.0),
        (4.053_12e-6, 68.0),
    ] {
        let found: f64 = peak * 2.0_f64.powi(24);
        assert!((found - units).abs() < 0.01, "{found}");
    }
    // Two and three splines: the printed peak, and the printed mean to within 5e-3 of itself, at other numbers than the printed.
    let [peak, mean] = in_single_precision(2, 1.307_103_3);
    assert!(
        (peak - 0.019_672_5).abs() < 6e-8 && (mean - 0.008_694_06).abs() < 1e-7,
        "{peak} {mean}"
    );
    let [peak, mean] = in_single_precision(3, 0.767_48);
    assert!(
        (peak - 0.001_507_16).abs() < 6e-9 && (mean - 0.000_705_631).abs() < 5e-3 * mean,
        "{peak} {mean}"
    );
    let [printed_number, _] = in_single_precision(2, 1.333_333);
    assert!((printed_number - 0.019_672_5).abs() > 1e-3);
    // Four splines at the printed number: one unit off the printed peak, and the printed mean.
    let [peak, mean] = in_single_precision(4, 0.551_784);
    assert!(
        (peak - 0.000_265_718).abs() < 1.1 * 2.0_f32.powi(-24)
            && (mean - 0.000_124_82).abs() < 1e-8,
        "{peak} {mean}"
    );
    // The program tells the same.
    let card = printed(&["methods", "lancaster-best"])
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    for words in [
        "peak 0.0196725 (330050) mean 0.00869409",
        "(4457) mean 0.000124811",
        "peak 0.00150716",
    ] {
        assert!(card.contains(words), "{words}: {card}");
    }
}

/// The rows of the tables of docs/documents.md: what is shown, and the last column.
fn rows(text: &str) -> Vec<(String, String)> {
    let is_row = |line: &&str| {
        line.starts_with("| ")
            && !line.starts_with("| ---")
            && !line.starts_with("| in the document")
    };
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|')
            .split(" | ")
            .map(|cell| cell.trim().to_owned())
            .collect()
    };
    text.lines()
        .filter(is_row)
        .map(|line| {
            let cells = cells(line);
            assert_eq!(cells.len(), 3, "{line}");
            (cells[1].clone(), cells[2].clone())
        })
        .collect()
}

#[test]
fn every_row_of_the_documents_runs_or_says_why_not() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("docs/documents.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (mut ran, mut reasons) = (0, 0);
    for (what, shown) in rows(&text) {
        if let Some(reason) = shown.strip_prefix("none: ") {
            assert!(reason.len() > 10, "{what}");
            reasons += 1;
            continue;
        }
        let command = shown
            .strip_prefix("`curveto ")
            .and_then(|words| words.strip_suffix('`'));
        let command =
            command.unwrap_or_else(|| panic!("{what}: neither a command nor a reason: {shown}"));
        let mut shell = shell(folder.path(), &format!("curveto {command}"));
        let output = shell.output().unwrap();
        assert!(
            output.status.success() && !output.stdout.is_empty(),
            "{what}: {command}"
        );
        ran += 1;
    }
    assert!(ran > 115 && reasons < 15, "{ran} {reasons}");
}

#[test]
fn apprichs_third_derivative_as_a_graph_is_0_at_a_joint() {
    let arc = json(&["arc", "1", "--sweep", "90", "-m", "apprich"]);
    let power = &arc["segments"][0]["power"];
    let [x, y] = ["x", "y"]
        .map(|axis| -> Vec<f64> { power[axis].as_array().unwrap().iter().map(number).collect() });
    // x''' y' = 3 x'' y'' at t = 0, where x''' = 6 A, x'' = 2 B, y'' = 2 F and y' = G.
    assert!((6.0 * x[0] * y[2] - 3.0 * 2.0 * x[1] * 2.0 * y[1]).abs() < 1e-13);
    // f'' = x''/y'^2 is the curvature there, but for its sign.
    let curvature = -2.0 * x[1] / (y[2] * y[2]);
    let report = json(&["measure", "arc", "1", "--sweep", "90", "-m", "apprich"]);
    let largest = number(&report["curvature"]["largest"]["value"]);
    assert!((curvature - largest).abs() < 1e-12, "{curvature} {largest}");
}

#[test]
fn the_parameter_of_one_segment_does_not_matter() {
    let points = ["spline", "--points", "0,0 1,1", "-p", "9"];
    let by_length = [
        "--parametrization",
        "arc-length",
        "--unit-tangents",
        "--ends",
        "fixed:1,0,0,1",
    ];
    let ends = "fixed:1.55675234579,0,0,1.55675234579";
    assert_eq!(
        printed(&[&points[..], &by_length].concat()),
        printed(&[&points[..], &["--ends", ends]].concat())
    );
}
