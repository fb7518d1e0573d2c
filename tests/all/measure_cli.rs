//! `measure` and `compare` on the command line.

use crate::judges::program;

use std::fs;
use std::io::Write;
use std::path::Path;

use program::{json, number, piped, printed, refused, run};
use serde_json::Value;

fn close(value: &Value, expected: f64, allowed: f64) {
    assert!(
        (number(value) - expected).abs() <= allowed,
        "{value} is not {expected}"
    );
}

#[test]
fn lancasters_best_number_measured() {
    let error = &json(&["measure", "circle", "1", "-m", "lancaster-best", "-n", "4"])["error"];
    close(&error["peak"], 2.655_627_01e-4, 5e-13);
    close(&error["mean"], 1.262_780e-4, 5e-10);
}

#[test]
fn a_printed_circle_measures_as_the_one_that_was_asked_for() {
    let path = printed(&["circle", "50", "-p", "12"]);
    let (read, drawn) = (
        json(&["measure", "--path", path.trim()]),
        json(&["measure", "circle", "50"]),
    );
    for key in ["outward", "inward", "peak", "mean", "mean_angle", "rms"] {
        close(&read["error"][key], number(&drawn["error"][key]), 1e-11);
    }
    close(
        &read["length"]["curve"],
        number(&drawn["length"]["curve"]),
        1e-11,
    );
    close(&read["area"]["true"], number(&drawn["area"]["true"]), 1e-9);
    assert_eq!(read["continuity"]["order"], "G2");
    assert_eq!(read["reference"]["fit"]["to"], "joints");
}

#[test]
fn an_arc_is_measured_against_the_circle_that_is_named() {
    let path = printed(&["arc", "5", "--start", "0", "--end", "90", "-m", "chen-3"]);
    let found = json(&[
        "measure",
        "--path",
        path.trim(),
        "--against",
        "circle:0,0,5",
    ]);
    // Five times Chen's 0.0152130, and the rounding of the two decimals printed.
    close(&found["error"]["peak"], 5.0 * 0.015_213_035_2, 2e-3);
    close(&found["reference"]["sweep"], 90.0, 1e-9);
    close(&found["length"]["true"], 2.5 * core::f64::consts::PI, 1e-9);
}

#[test]
fn an_ellipse_is_measured_against_the_one_that_is_named() {
    let path = printed(&[
        "ellipse",
        "3",
        "2",
        "--rotation",
        "30",
        "--center",
        "7,1",
        "-p",
        "13",
    ]);
    let against = [
        "measure",
        "--path",
        path.trim(),
        "--against",
        "ellipse:7,1,3,2,30deg",
    ];
    let drawn = json(&[
        "measure",
        "ellipse",
        "3",
        "2",
        "--rotation",
        "30",
        "--center",
        "7,1",
    ]);
    close(
        &json(&against)["error"]["peak"],
        number(&drawn["error"]["peak"]),
        1e-11,
    );
    assert!(
        refused(&["measure", "--path", "M0 0L1 1", "--against", "circle:0,0"]).contains("CX,CY,R")
    );
    assert!(
        refused(&[
            "measure",
            "--path",
            "M0 0L1 1",
            "--against",
            "circle:0,0,-1"
        ])
        .contains("positive")
    );
}

#[test]
fn every_path_of_a_file_is_measured_where_its_transforms_place_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("drawing.svg");
    let path = printed(&["circle", "1", "-p", "12"]);
    fs::write(
        &file,
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<g transform=\"translate(5 6) scale(10)\">\n<path id=\"ring\" d=\"{}\"/>\n</g>\n<path d=\"M0 0A1 1 0 0 1 2 0\"/></svg>",
            path.trim()
        ),
    )
    .unwrap();
    for flag in ["--file", "--svg"] {
        let output = run(&["measure", flag, file.to_str().unwrap(), "-f", "json"]);
        assert!(output.status.success());
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.contains("drawing.svg:5: not measured") && said.contains("arc (A)"),
            "{said}"
        );
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        let found = found.as_array().unwrap();
        assert_eq!(found.len(), 1);
        assert!(
            found[0]["subject"]["source"]
                .as_str()
                .unwrap()
                .ends_with("drawing.svg:3#ring")
        );
        close(&found[0]["reference"]["radii"][0], 10.0, 1e-10);
        close(&found[0]["reference"]["center"][1], 6.0, 1e-10);
        close(&found[0]["error"]["relative_peak"], 1.960_764_7e-4, 1e-11);
    }
    let missing = run(&["measure", "--file", "no-such.svg"]);
    assert_eq!(missing.status.code(), Some(1));
    fs::write(&file, "<svg><circle r=\"4\"/></svg>").unwrap();
    assert!(refused(&["measure", "--file", file.to_str().unwrap()]).contains("no path"));
    fs::write(&file, "<svg><path").unwrap();
    assert!(refused(&["measure", "--file", file.to_str().unwrap()]).contains("XML"));
}

#[test]
fn what_cannot_be_measured_is_refused_and_said_why() {
    let cases: [(&[&str], &str); 12] = [
        (&["measure"], "nothing to measure"),
        (&["measure", "--path", ""], "empty"),
        (&["measure", "--path", "M5 5"], "empty, or a single point"),
        (&["measure", "--path", "M5 5Z"], "single point"),
        (
            &["measure", "--path", "NaN"],
            "neither path data nor a file",
        ),
        (&["measure", "--path", "M1e300 0L1 1L2 0Z"], "1e150"),
        (&["measure", "--path", "M0 0A5 5 0 0 1 5 5"], "arc (A)"),
        (&["measure", "--path", "M0 0L5 5L9 9"], "line"),
        (&["measure", "--path", "M0 0C0 0 0 0 0 0"], "single point"),
        (
            &["measure", "circle", "1", "--coordinate-tolerance", "NaN"],
            "tolerance",
        ),
        (&["measure", "circle", "1e300"], "1e150"),
        (
            &["measure", "circle", "1", "--plot", "plot.gif"],
            "svg, eps, png and pdf",
        ),
    ];
    for (arguments, why) in cases {
        let said = refused(arguments);
        assert!(
            said.starts_with("error: ") && said.contains(why),
            "{arguments:?}: {said}"
        );
    }
}

#[test]
fn what_is_no_circle_is_measured_and_the_fit_says_so() {
    let square = json(&[
        "measure",
        "--path",
        "M0 0L10 0L10 10L0 10Z",
        "--fit",
        "curve",
    ]);
    assert!(number(&square["reference"]["fit"]["relative_rms"]) > 0.05);
    assert_eq!(square["continuity"]["order"], "G0");
    close(&square["length"]["curve"], 40.0, 1e-12);
    close(&square["area"]["curve"], 100.0, 1e-12);
    for wild in [
        "M0 0C100 0-100 0 1 1S9 9 2 1",
        "M0 0Q1 1 0 0Q1-1 0 0",
        "M0 0C1e140 0 0 1e140 3 3Z",
    ] {
        let text = printed(&["measure", "--path", wild, "-f", "json"]);
        let found: Value = serde_json::from_str(&text).unwrap();
        assert!(found["error"]["peak"].is_number(), "{wild}");
        for format in ["table", "csv"] {
            let text = printed(&["measure", "--path", wild, "-f", format]);
            assert!(
                !text.contains("NaN") && !text.contains("inf"),
                "{wild}: {text}"
            );
        }
    }
}

#[test]
fn an_ellipse_is_fitted_where_it_was_meant_and_a_circle_where_that_was() {
    let drawn = |words: &str| printed(&words.split(' ').collect::<Vec<_>>());
    let measured = |data: &str, fit: &str| json(&["measure", "--path", data, "--fit", fit]);
    let ellipse = drawn("ellipse 120 50 --rotation 20 --center 3,7 -n 8 -p 9");
    for fit in ["ellipse", "auto"] {
        let found = measured(ellipse.trim_end(), fit);
        let reference = &found["reference"];
        for (value, wished) in [
            (&reference["radii"][0], 120.0),
            (&reference["radii"][1], 50.0),
            (&reference["center"][0], 3.0),
            (&reference["center"][1], 7.0),
        ] {
            assert!((number(value) - wished).abs() < 1e-6, "{fit}: {reference}");
        }
        assert_eq!(reference["fit"]["to"], "joints", "{reference}");
        // The error is that which drawing states.
        let stated = json(&[
            "ellipse",
            "120",
            "50",
            "--rotation",
            "20",
            "--center",
            "3,7",
            "-n",
            "8",
            "-p",
            "9",
        ]);
        close(
            &found["error"]["peak"],
            number(&stated["error"]["peak"]),
            1e-4,
        );
    }
    let circle = drawn("circle 50 -n 4 -p 9");
    for fit in ["circle", "auto"] {
        let found = measured(circle.trim_end(), fit);
        for radius in 0..2 {
            close(&found["reference"]["radii"][radius], 50.0, 1e-9);
        }
    }
    let said = refused(&["measure", "--path", "M0 0L5 5L9 9", "--fit", "ellipse"]);
    assert!(
        said.contains("no ellipse fits") && said.contains("--against"),
        "{said}"
    );
}

#[test]
fn tables_are_80_columns_wide() {
    let cases: [&[&str]; 7] = [
        &["measure", "circle", "1"],
        &[
            "measure",
            "ellipse",
            "300",
            "0.02",
            "--rotation",
            "33.3333",
            "--center",
            "123456.789,-98765.4321",
            "-n",
            "7",
        ],
        &[
            "measure",
            "circle",
            "1e-7",
            "-m",
            "chen-1",
            "--joints",
            "0,50,120.123456,200,300",
        ],
        &[
            "measure",
            "--path",
            "M1 0C1 .55 .55 1 0 1C-.55 1-1 .55-1.001 0C-1-.55-.55-1 0-1C.55-1 1-.55 1 0Z",
        ],
        &["measure", "arc", "5", "--start", "0", "--end", "45"],
        &["compare"],
        &["compare", "-n", "4"],
    ];
    for arguments in cases {
        for line in printed(arguments).lines() {
            assert!(line.chars().count() <= 80, "{arguments:?}: {line}");
        }
    }
}

#[test]
fn several_methods_give_several_reports_and_one_plot() {
    let folder = tempfile::tempdir().unwrap();
    let plot = folder.path().join("plot.svg");
    let arguments = [
        "measure",
        "circle",
        "1",
        "-m",
        "midpoint,minimax,chen-3",
        "--plot",
        plot.to_str().unwrap(),
    ];
    assert_eq!(json(&arguments).as_array().unwrap().len(), 3);
    let svg = fs::read_to_string(&plot).unwrap();
    for word in [
        ">midpoint<",
        ">minimax<",
        ">chen-3<",
        "user units",
        ">0°<",
        ">360°<",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    let csv = printed(&[
        "measure",
        "circle",
        "1",
        "-m",
        "midpoint,minimax",
        "-f",
        "csv",
    ]);
    let columns: Vec<usize> = csv.lines().map(|line| line.matches(',').count()).collect();
    assert_eq!(columns.len(), 3);
    // The title of a subject holds a comma, in quotes.
    assert_eq!((columns[1], columns[2]), (columns[0] + 1, columns[0] + 1));
    assert!(refused(&["circle", "1", "-m", "midpoint,minimax"]).contains("one method"));
}

/// The y coordinates of each line of a plot that has more than 20 points, part by part.
fn drawn_parts(svg: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(svg).unwrap();
    let lines = text
        .lines()
        .filter_map(|line| line.strip_prefix("<path d=\"M"));
    lines
        .map(|line| {
            let data = line.split('"').next().unwrap();
            data.split('L')
                .map(|p| p.split(' ').nth(1).unwrap().parse().unwrap())
                .collect()
        })
        .filter(|part: &Vec<f64>| part.len() > 20)
        .collect()
}

#[test]
fn the_plot_of_apprichs_second_derivative_runs_through_the_joints() {
    let folder = tempfile::tempdir().unwrap();
    let plot = folder.path().join("k2.svg");
    let draw = |method| {
        printed(&[
            "measure",
            "circle",
            "1",
            "-m",
            method,
            "-n",
            "4",
            "--plot",
            plot.to_str().unwrap(),
            "--quantity",
            "curvature-d2",
        ]);
        let parts = drawn_parts(&plot);
        assert_eq!(parts.len(), 4);
        parts
            .windows(2)
            .map(|pair| (pair[0].last().unwrap() - pair[1][0]).abs())
            .fold(0.0, f64::max)
    };
    assert!(draw("apprich") <= 0.011);
    // The same picture of a derivative that jumps.
    printed(&[
        "measure",
        "circle",
        "1",
        "-m",
        "minimax",
        "-n",
        "4",
        "--plot",
        plot.to_str().unwrap(),
        "--quantity",
        "curvature-d1",
    ]);
    let parts = drawn_parts(&plot);
    assert!((parts[0].last().unwrap() - parts[1][0]).abs() > 50.0);
}

#[test]
fn every_plot_renders_and_says_what_it_shows() {
    let folder = tempfile::tempdir().unwrap();
    for quantity in [
        "error",
        "curvature",
        "curvature-d1",
        "curvature-d2",
        "angle-lag",
        "drawing",
    ] {
        for extension in ["svg", "png"] {
            let plot = folder.path().join(format!("{quantity}.{extension}"));
            let arguments = [
                "measure",
                "ellipse",
                "3",
                "2",
                "-m",
                "apprich,minimax",
                "--quantity",
                quantity,
            ];
            printed(
                &[
                    &arguments[..],
                    &["--plot", plot.to_str().unwrap(), "--size", "640x400"],
                ]
                .concat(),
            );
            let bytes = fs::read(&plot).unwrap();
            if extension == "png" {
                let pixmap = tiny_skia::Pixmap::decode_png(&bytes).unwrap();
                assert_eq!((pixmap.width(), pixmap.height()), (640, 400));
                continue;
            }
            let tree =
                resvg::usvg::Tree::from_data(&bytes, &resvg::usvg::Options::default()).unwrap();
            assert_eq!((tree.size().width(), tree.size().height()), (640.0, 400.0));
        }
    }
}

#[test]
fn a_drawing_has_its_control_points_at_one_scale() {
    let folder = tempfile::tempdir().unwrap();
    let plot = folder.path().join("plot.svg");
    let file = plot.to_str().unwrap();
    let shapes = [
        &["arc", "1", "--sweep", "90"][..],
        // An arc of a hyperbola that is its own mirror image about y = x.
        &[
            "conic",
            "--from",
            "1,0",
            "--control",
            "1,1",
            "--to",
            "0,1",
            "--weight",
            "2",
        ],
    ];
    for shape in shapes {
        let words = ["-n", "1", "--plot", file, "--quantity", "drawing"];
        printed(&[&["measure"], shape, &words[..]].concat());
        let text = fs::read_to_string(&plot).unwrap();
        let number = |tag: &str, name: &str| -> f64 {
            let value = tag.split(&format!("{name}=\"")).nth(1).unwrap();
            value.split('"').next().unwrap().parse().unwrap()
        };
        let dots: Vec<[f64; 2]> = text
            .split("<circle")
            .skip(1)
            .map(|tag| [number(tag, "cx"), number(tag, "cy")])
            .collect();
        let [[x0, y0], [x1, y1], [x2, y2], [x3, y3]] = dots[..] else {
            panic!("{dots:?}");
        };
        assert!((x0 - x1).abs() < 0.02 && (y2 - y3).abs() < 0.02, "{dots:?}");
        assert!(((y0 - y1) - (x2 - x3)).abs() < 0.04, "{dots:?}");
        assert!(y0 - y1 > 50.0 && y0 > y3, "{dots:?}");
    }
}

/// How many pixels of a rectangle are darker than mid-grey.
fn dark_pixels(pixmap: &tiny_skia::Pixmap, [x0, y0, x1, y1]: [u32; 4]) -> usize {
    let dark = |x, y| {
        pixmap
            .pixel(x, y)
            .is_some_and(|p| p.red() < 128 && p.green() < 128)
    };
    (y0..y1)
        .flat_map(|y| (x0..x1).map(move |x| (x, y)))
        .filter(|&(x, y)| dark(x, y))
        .count()
}

#[test]
fn the_words_of_a_png_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |radius: &str| {
        let plot = folder.path().join("plot.png");
        printed(&[
            "measure",
            "circle",
            radius,
            "--plot",
            plot.to_str().unwrap(),
            "--size",
            "800x500",
        ]);
        tiny_skia::Pixmap::decode_png(&fs::read(&plot).unwrap()).unwrap()
    };
    // The title stands in the first 32 rows, the ticks of x below the frame; a longer title is more ink.
    let (short, long) = (draw("1"), draw("1234567"));
    let title = |pixmap| dark_pixels(pixmap, [0, 0, 800, 32]);
    assert!(title(&short) > 300, "{}", title(&short));
    assert!(title(&long) > title(&short));
    assert!(dark_pixels(&short, [60, 455, 800, 470]) > 100);
}

#[test]
fn compare_prints_chens_first_table() {
    // Rounded up: Chen prints 0.0152130.
    let text = printed(&["compare", "-m", "chen-1,chen-2,chen-3", "-n", "4"]);
    for figure in ["0.0277282", "0.0176957", "0.0152131"] {
        assert!(text.contains(figure), "{text}");
    }
}

#[test]
fn compare_states_orders_and_what_is_impossible() {
    let found = json(&["compare", "-n", "4,8,16,32"]);
    for row in found["methods"].as_array().unwrap() {
        let order = match row["method"].as_str().unwrap() {
            "lancaster-best" | "lancaster-drawellipse" => continue,
            "apprich-plus" => 2.0,
            id if id.starts_with("chen") || id.starts_with("quadratic") => 4.0,
            _ => 6.0,
        };
        assert!((number(&row["order"]) - order).abs() < 0.1, "{row}");
    }
    let impossible = json(&["compare", "-m", "chen-1,lancaster-drawellipse", "-n", "2"]);
    for row in impossible["methods"].as_array().unwrap() {
        assert!(row["values"][0].is_null() && row["order"].is_null());
    }
    assert!(refused(&["compare", "-m", "nonesuch"]).contains("unknown method"));
    assert!(refused(&["compare", "-n", "0"]).contains("segments"));
    assert!(
        refused(&["compare", "--by", "beauty"]).contains("peak, square, mean, rms, area, length")
    );
}

#[test]
fn compare_by_area_and_length_finds_the_methods_named_for_them() {
    for (by, id) in [
        ("area", "area"),
        ("length", "length"),
        ("mean", "mean"),
        ("rms", "rms"),
        ("peak", "minimax"),
    ] {
        let tangent = "midpoint,minimax,goldapp,curvature,area,length,mean,mean-angle,rms";
        let found = json(&["compare", "-m", tangent, "-n", "4", "--by", by]);
        let rows = found["methods"].as_array().unwrap();
        let best = rows
            .iter()
            .min_by(|a, b| number(&a["values"][0]).total_cmp(&number(&b["values"][0])));
        assert_eq!(best.unwrap()["method"], id, "{by}");
    }
}

#[test]
fn compare_draws_every_method_in_every_picture_format() {
    let folder = tempfile::tempdir().unwrap();
    for extension in ["svg", "html", "png"] {
        let file = folder.path().join(format!("compare.{extension}"));
        printed(&[
            "compare",
            "-m",
            "all",
            "-n",
            "2,3,4,5,6,8",
            "-o",
            file.to_str().unwrap(),
        ]);
        let bytes = fs::read(&file).unwrap();
        if extension == "png" {
            assert!(tiny_skia::Pixmap::decode_png(&bytes).is_ok());
            continue;
        }
        let text = String::from_utf8(bytes).unwrap();
        for method in curveto::Method::ALL {
            assert!(text.contains(&format!(">{}<", method.id())), "{method}");
        }
        assert!(!text.contains("NaN") && !text.contains("http://") || text.contains("www.w3.org"));
    }
}

#[test]
fn each_subpath_is_judged_by_itself() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bad.svg");
    let quarter = "M10 0C10 5.5228 5.5228 10 0 10";
    fs::write(
        &file,
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><style>a{{transform:none}}</style><path id=\"one\" d=\"{quarter}M5 5L9 9M0 0A1 1 0 0 1 2 0\"/>\n<path id=\"two\" d=\"{quarter}\"/>\n<path d=\"M1 1C\"/></svg>"
        ),
    )
    .unwrap();
    let output = run(&["measure", "--file", file.to_str().unwrap(), "-f", "json"]);
    assert!(output.status.success());
    let said = String::from_utf8(output.stderr).unwrap();
    for wished in [
        "bad.svg:1#one, subpath 2: not measured",
        "bad.svg:1#one, subpath 3: not measured",
        "bad.svg:3: not measured",
        "a style sheet sets transform; style sheets are not applied",
    ] {
        assert!(said.contains(wished), "{said}");
    }
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let sources = found.as_array().unwrap().iter();
    let sources: Vec<&str> = sources
        .map(|one| one["subject"]["source"].as_str().unwrap())
        .collect();
    assert_eq!(sources.len(), 2);
    assert!(sources[0].ends_with("#one, subpath 1") && sources[1].ends_with("#two"));
}

#[test]
fn segments_of_no_length_are_left_out_and_said() {
    let circle = "M10 0C10 5.523 5.523 10 0 10C-5.523 10-10 5.523-10 0C-10-5.523-5.523-10 0-10";
    let last = "C5.523-10 10-5.523 10 0";
    let clean = json(&["measure", "--path", &format!("{circle}{last}Z")]);
    for (middle, end, count) in [
        // A closing line of rounding is none, with or without an L.
        ("", "L10 0Z", 0),
        ("c0 0 0 0 0 0", "Z", 1),
        ("h0", "Z", 1),
        ("l1e-9 0l0 0", "Z", 2),
    ] {
        let data = format!("{circle}{middle}{last}{end}");
        let output = run(&["measure", "--path", &data, "-f", "json"]);
        let said = String::from_utf8(output.stderr).unwrap();
        let wished = format!("{count} segment");
        assert!(
            count == 0 || (said.contains(&wished) && said.contains("left out")),
            "{data}: {said}"
        );
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        for figure in ["peak", "mean"] {
            close(
                &found["error"][figure],
                clean["error"][figure].as_f64().unwrap(),
                1e-8,
            );
        }
        assert_eq!(
            found["joints"].as_array().map(Vec::len),
            clean["joints"].as_array().map(Vec::len)
        );
    }
}

#[test]
fn several_counts_and_methods_are_measured_in_their_order() {
    let found = json(&[
        "measure",
        "ellipse",
        "5",
        "3",
        "-n",
        "2,4",
        "-m",
        "minimax,midpoint",
    ]);
    let found = found.as_array().unwrap();
    let names: Vec<String> = found
        .iter()
        .map(|one| format!("{}", one["subject"]["title"]))
        .collect();
    assert_eq!(names.len(), 4);
    for (name, (count, method)) in names.iter().zip([
        (2, "minimax"),
        (4, "minimax"),
        (2, "midpoint"),
        (4, "midpoint"),
    ]) {
        assert!(
            name.contains(&format!("{count} segments by {method}")),
            "{name}"
        );
    }
    let peak = |i: usize| found[i]["error"]["peak"].as_f64().unwrap();
    assert!(peak(0) > 10.0 * peak(1) && peak(2) > 10.0 * peak(3));
    assert!(refused(&["ellipse", "5", "3", "-n", "2,4"]).contains("one number of segments"));
    assert!(refused(&["measure", "circle", "5", "-n", "2,0"]).contains("from 1"));
    assert!(refused(&["measure", "circle", "5", "-n", "90000,90000"]).contains("at most"));
}

#[test]
fn files_are_read_as_convert_reads_them() {
    let circle = |attributes: &str| {
        let d = "M50 0C50 27.6 27.6 50 0 50C-27.6 50-50 27.6-50 0C-50-27.6-27.6-50 0-50C27.6-50 50-27.6 50 0Z";
        format!("<path {attributes} d=\"{d}\"/>")
    };
    let radius = |svg: &[u8]| -> Option<f64> {
        let output = piped(
            &["measure", "--file", "-", "--fit", "circle", "-f", "json"],
            svg,
        );
        let found: Value = serde_json::from_slice(&output.stdout).ok()?;
        let radius = found[0]["reference"]["radii"][0].as_f64()?;
        Some(radius.round())
    };
    let svg = |inner: &str| {
        format!("<svg xmlns='http://www.w3.org/2000/svg' xmlns:x='urn:x'>{inner}</svg>")
    };
    for (style, expected) in [
        ("/*;transform:scale(3);*/", 50.0),
        ("transform:scale(2) !important;transform:scale(3)", 100.0),
        ("transform:scale(2) ! important", 100.0),
        ("transform:scale(3);transform:scale(2)", 100.0),
        ("transform:scale(/*3*/2)", 100.0),
        ("transform:scale(2)!", 50.0),
        ("TRANSFORM:scale(2)", 100.0),
    ] {
        let drawing = svg(&circle(&format!("style='{style}'")));
        assert_eq!(radius(drawing.as_bytes()), Some(expected), "{style}");
    }
    // A path by an entity of the DTD.
    let d = circle("").split('"').nth(1).unwrap().to_owned();
    let drawing = format!("<!DOCTYPE svg [<!ENTITY d '{d}'>]><svg><path d='&d;'/></svg>");
    assert_eq!(radius(drawing.as_bytes()), Some(50.0));
    // An element of another vocabulary is none, and what stands in comments neither.
    let foreign = circle("").replace("<path", "<x:path");
    let drawing = svg(&format!(
        "<!-- <use/><style>a{{transform:none}}</style> -->{foreign}{}",
        circle("transform='scale(2)'")
    ));
    let output = piped(
        &["measure", "--file", "-", "-f", "json"],
        drawing.as_bytes(),
    );
    assert!(
        output.status.success() && output.stderr.is_empty(),
        "{output:?}"
    );
    assert_eq!(radius(drawing.as_bytes()), Some(100.0));
    // Bytes of a declared encoding, and those of gzip.
    let latin = [
        &b"<?xml version='1.0' encoding='ISO-8859-1'?><svg><title>\xe9</title>"[..],
        circle("").as_bytes(),
        b"</svg>",
    ]
    .concat();
    assert_eq!(radius(&latin), Some(50.0));
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packed.write_all(&latin).unwrap();
    assert_eq!(radius(&packed.finish().unwrap()), Some(50.0));
    for (wrong, why) in [
        (
            "<svg><path d='M0 0' d='M1 1'/></svg>",
            "1:21: not well-formed XML: the attribute `d` stands twice in one tag",
        ),
        (
            "<svg/><svg/>",
            "1:7: not well-formed XML: a second root element",
        ),
        ("<svg>", "1:1: not well-formed XML: `<svg>` is never closed"),
    ] {
        let output = piped(&["measure", "--file", "-"], wrong.as_bytes());
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains(&format!("<stdin>:{why}")), "{said}");
    }
}

#[test]
fn a_corner_of_the_distance_beside_an_end_is_in_its_mean() {
    let data = "M11.2075 8.43884C6.55935 11.3949 6.91967 1.00526 8.72304 8.2916C7.41428 12.6926 9.10758 8.29169 4.00161 11.1476C6.9373 8.33311 2.68967 5.81608 12.4903 8.30411";
    let ellipse = "ellipse:-3.56249,8.3064,16.942,2.8745,0";
    let error = &json(&["measure", "--path", data, "--against", ellipse])["error"];
    // By the mean of 600,000 places, each with its nearest point from a search over all angles.
    close(&error["mean"], 0.870_980_991_97, 2e-11);
    close(&error["rms"], 1.083_440_625_08, 2e-11);
}
