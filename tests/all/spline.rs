//! Composite parametric cubics: Chen's equations, his circles, and what `curveto spline` reads and refuses.

use std::fs;
use std::process::Output;

use curveto::measure::radial;
use curveto::number::Precision;
use curveto::shape::Truth;
use curveto::spline::{Options, Parametrization, Quadrature, Spline, SplineEnds};
use kurbo::{Affine, CubicBez, ParamCurveArclen, Point, Vec2};
use serde_json::Value;

use crate::judges::program::piped;

const ARC_LENGTH: Parametrization = Parametrization::ArcLength(Quadrature::Adaptive);

/// Points of the unit circle at these angles.
fn on_circle(degrees: &[f64]) -> Vec<Point> {
    let direction = |&d: &f64| curveto::Angle::from_degrees(d).direction().to_point();
    degrees.iter().map(direction).collect()
}

/// Points without any order that an equation could profit from.
fn scattered(count: usize) -> Vec<Point> {
    let point = |i: usize| Point::new(i as f64 + (i as f64 * 1.7).sin(), ((i * i) as f64).cos());
    (0..count).map(point).collect()
}

/// The second derivatives at the start and the end of a segment with respect to its parameter.
fn second_derivatives(c: &CubicBez, length: f64) -> [Vec2; 2] {
    let at = |a: Point, b: Point, c: Point| ((c - b) - (b - a)) * (6.0 / (length * length));
    [at(c.p0, c.p1, c.p2), at(c.p1, c.p2, c.p3)]
}

/// The largest jump of the second derivative at a joint, over the largest second derivative.
fn second_derivative_jump(spline: &Spline) -> f64 {
    let ends: Vec<[Vec2; 2]> = spline
        .segments()
        .zip(&spline.lengths)
        .map(|(segment, &length)| second_derivatives(&segment, length))
        .collect();
    let jumps = ends
        .windows(2)
        .map(|pair| (pair[0][1] - pair[1][0]).hypot());
    let wrap = (spline.options.ends == SplineEnds::Cyclic)
        .then(|| (ends[ends.len() - 1][1] - ends[0][0]).hypot());
    let largest = ends.iter().flatten().map(|v| v.hypot()).fold(0.0, f64::max);
    jumps.chain(wrap).fold(0.0, f64::max) / largest
}

#[test]
fn the_second_derivative_is_continuous_at_inner_nodes() {
    for parametrization in [
        Parametrization::Uniform,
        Parametrization::Chord,
        Parametrization::Centripetal,
        ARC_LENGTH,
    ] {
        let fixed = SplineEnds::Fixed([Vec2::new(0.6, 0.8), Vec2::new(0.0, -1.0)]);
        for ends in [SplineEnds::Cyclic, SplineEnds::Free, fixed] {
            for count in [3, 4, 5, 17, 200] {
                let options = Options {
                    parametrization,
                    ends,
                    unit_tangents: false,
                    ..Options::default()
                };
                let spline = Spline::new(scattered(count), options).unwrap();
                let jump = second_derivative_jump(&spline);
                assert!(
                    jump < 1e-12,
                    "{parametrization:?}, {ends:?}, {count} points: {jump:e}"
                );
            }
        }
    }
}

#[test]
fn unit_tangents_give_up_the_second_derivative() {
    let options = Options {
        parametrization: ARC_LENGTH,
        ends: SplineEnds::Cyclic,
        unit_tangents: true,
        ..Options::default()
    };
    let spline = Spline::new(scattered(9), options).unwrap();
    assert!(
        spline
            .derivatives
            .iter()
            .all(|d| (d.hypot() - 1.0).abs() < 1e-15)
    );
    assert!(second_derivative_jump(&spline) > 1e-3);
}

#[test]
fn derivatives_and_lengths_are_those_of_a_dense_solve_in_forty_digits() {
    // fixtures/reference/spline.py made these: mpmath, a dense system for every round.
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/fixtures/reference/spline.json"
    );
    let cases: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let mut seen = 0;
    for case in cases.as_array().unwrap() {
        let points = vectors(&case["points"])
            .iter()
            .map(|v| v.to_point())
            .collect();
        let options = Options {
            parametrization: match case["parametrization"].as_str().unwrap() {
                "uniform" => Parametrization::Uniform,
                "chord" => Parametrization::Chord,
                "centripetal" => Parametrization::Centripetal,
                _ => ARC_LENGTH,
            },
            ends: match case["ends"].as_str().unwrap() {
                "cyclic" => SplineEnds::Cyclic,
                "free" => SplineEnds::Free,
                _ => SplineEnds::Fixed([Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)]),
            },
            unit_tangents: case["unit_tangents"].as_bool().unwrap(),
            ..Options::default()
        };
        let spline = Spline::new(points, options).unwrap();
        // Lengths have settled to 1e-12 of themselves, all else is solved.
        let tolerance = if options.parametrization == ARC_LENGTH {
            4e-12
        } else {
            4e-15
        };
        let lengths: Vec<f64> = serde_json::from_value(case["lengths"].clone()).unwrap();
        assert_eq!(spline.lengths.len(), lengths.len());
        for (ours, theirs) in spline.lengths.iter().zip(lengths) {
            assert!(
                (ours - theirs).abs() <= tolerance * theirs,
                "{ours} {theirs}: {case}"
            );
        }
        for (ours, theirs) in spline.derivatives.iter().zip(vectors(&case["derivatives"])) {
            let off = (*ours - theirs).hypot();
            assert!(
                off <= tolerance * theirs.hypot().max(1.0),
                "{off:e}: {case}"
            );
        }
        seen += 1;
    }
    assert!(seen >= 20);
}

fn vectors(value: &Value) -> Vec<Vec2> {
    let pairs: Vec<[f64; 2]> = serde_json::from_value(value.clone()).unwrap();
    pairs.into_iter().map(|[x, y]| Vec2::new(x, y)).collect()
}

#[test]
fn every_segment_is_as_long_as_its_parameter() {
    let options = Options {
        parametrization: ARC_LENGTH,
        ends: SplineEnds::Free,
        unit_tangents: false,
        ..Options::default()
    };
    let spline = Spline::new(scattered(40), options).unwrap();
    assert!((2..100).contains(&spline.rounds));
    for (segment, length) in spline.segments().zip(&spline.lengths) {
        assert!((segment.arclen(1e-15) - length).abs() < 2e-12 * length);
    }
}

/// The error of a closed spline as an approximation of the unit circle.
fn radial_error(spline: &Spline) -> curveto::RadialError {
    let curve = spline
        .curve(Some(Precision::Full), Affine::IDENTITY)
        .unwrap();
    radial::error(&curve.segments, &Truth::circle(Point::ORIGIN, 1.0))
}

fn closed(degrees: &[f64], parametrization: Parametrization, unit_tangents: bool) -> Spline {
    let options = Options {
        parametrization,
        ends: SplineEnds::Cyclic,
        unit_tangents,
        ..Options::default()
    };
    Spline::new(on_circle(degrees), options).unwrap()
}

const EVEN: [f64; 4] = [0.0, 90.0, 180.0, 270.0];
const ALTERNATING: [f64; 8] = [0.0, 30.0, 90.0, 120.0, 180.0, 210.0, 270.0, 300.0];

#[test]
fn chens_figures_5_and_6_and_7() {
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.max(1e-6), "{a} is not {b}");
    // Figure 5 and Table 1: Formulation I on quarters.
    close(
        radial_error(&closed(&EVEN, Parametrization::Uniform, false)).inward,
        0.027_728_175_87,
    );
    // Figure 6: the same on alternating 30 and 60 degrees dents the circle by .109112 and bulges it by .0897181.
    let six = radial_error(&closed(&ALTERNATING, Parametrization::Uniform, false));
    close(six.inward, 0.109_112_009_690);
    close(six.outward, 0.089_718_095_997);
    // Figure 7: Formulation II through the same points.
    let seven = radial_error(&closed(&ALTERNATING, ARC_LENGTH, true));
    close(seven.inward, 0.005_897_041_728);
    close(seven.outward, 0.001_156_678_843);
}

#[test]
fn circles_through_uneven_points_by_the_methods_of_circle() {
    let joints = ALTERNATING.map(curveto::Angle::from_degrees).to_vec();
    let circle = curveto::Shape::Circle(curveto::Circle::new((0.0, 0.0), 1.0).unwrap());
    let error = |method| {
        let options = curveto::Options {
            rule: curveto::Rule::Method(method),
            cut: curveto::Cut::At(joints.clone()),
            precision: Some(Precision::Full),
            ..curveto::Options::default()
        };
        curveto::approximate(&circle, &options).unwrap().error
    };
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} is not {b}");
    close(error(curveto::Method::Chen1).inward, 0.109_112_009_690);
    close(error(curveto::Method::Chen1).outward, 0.089_718_095_997);
    // The other two take each piece on its own, so that the longer ones, of 60 degrees, decide.
    for (method, printed) in [
        (curveto::Method::Chen2, 0.003_299_5),
        (curveto::Method::Chen3, 0.003_07),
    ] {
        let sixth = curveto::method::Span::from_degrees(60.0);
        let alone = method.radial_error(&sixth).unwrap();
        close(error(method).inward, alone.inward);
        assert!((alone.inward - printed).abs() < 1e-5 && alone.outward == 0.0);
    }
}

#[test]
fn formulation_2_is_the_method_chen_2() {
    for (quadrature, rule, printed) in [
        (
            Quadrature::Adaptive,
            curveto::Rule::Method(curveto::Method::Chen2),
            0.017_695_683_7,
        ),
        // What Chen prints, 0.01903, comes out of two-point quadrature.
        (
            Quadrature::Gauss2,
            curveto::Rule::CHEN_2_GAUSS_2,
            0.019_031_9,
        ),
    ] {
        let spline = closed(&EVEN, Parametrization::ArcLength(quadrature), true);
        let piece = rule
            .piece(&curveto::method::Span::from_degrees(90.0))
            .unwrap();
        assert!((spline.segment(0).p1.y - piece.handle.y).abs() < 1e-12);
        assert!((radial_error(&spline).inward - printed).abs() < 1e-7);
    }
}

#[test]
fn equal_spacing_gives_formulation_1_whatever_the_parameter() {
    let uniform = closed(&EVEN, Parametrization::Uniform, false);
    for parametrization in [
        Parametrization::Chord,
        Parametrization::Centripetal,
        ARC_LENGTH,
    ] {
        let other = closed(&EVEN, parametrization, false);
        for (a, b) in uniform.segments().zip(other.segments()) {
            assert!(a.p1.distance(b.p1) < 1e-15 && a.p2.distance(b.p2) < 1e-15);
        }
    }
}

#[test]
fn a_curve_through_points_on_a_line_is_that_line() {
    let points = vec![
        Point::new(0.0, 0.0),
        Point::new(1.0, 2.0),
        Point::new(4.0, 8.0),
    ];
    let speed = Vec2::new(1.0, 2.0) / 5.0_f64.sqrt();
    let options = Options {
        parametrization: ARC_LENGTH,
        ends: SplineEnds::Fixed([speed, speed]),
        unit_tangents: false,
        ..Options::default()
    };
    let spline = Spline::new(points, options).unwrap();
    for segment in spline.segments() {
        for p in [segment.p1, segment.p2] {
            assert!((p.y - 2.0 * p.x).abs() < 1e-14);
        }
    }
    assert!((spline.lengths[1] - 45.0_f64.sqrt()).abs() < 1e-14);
}

#[test]
fn a_hundred_thousand_points_are_passed_through_digit_for_digit() {
    let points = scattered(100_000);
    let spline = Spline::new(points.clone(), Options::default()).unwrap();
    let curve = spline.curve(None, Affine::IDENTITY).unwrap();
    assert_eq!(curve.segments.len(), points.len() - 1);
    for (segment, pair) in curve.segments.iter().zip(points.windows(2)) {
        let cubic = segment.to_cubic();
        assert_eq!([cubic.p0, cubic.p3], [pair[0], pair[1]]);
    }
}

fn run(arguments: &[&str], input: &str) -> Output {
    piped(&[&["spline"], arguments].concat(), input.as_bytes())
}

fn printed(arguments: &[&str], input: &str) -> String {
    let output = run(arguments, input);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

fn refused(arguments: &[&str], input: &str) -> String {
    let output = run(arguments, input);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(
        output.stdout.is_empty() && message.starts_with("error: "),
        "{message}"
    );
    message
}

#[test]
fn four_points_of_the_circle_give_formulation_1() {
    let input = "1,0\n0,1\n-1,0\n0,-1\n";
    let text = printed(
        &["--points-file", "-", "--ends", "cyclic", "-f", "json"],
        input,
    );
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        json["segments"][0]["points"][1],
        serde_json::json!([1, 0.5])
    );
    assert_eq!(
        json["segments"][0]["power"]["x"],
        serde_json::json!([0.5, -1.5, 0, 1])
    );
    assert_eq!(
        json["path"],
        "M1 0C1 0.5 0.5 1 0 1C-0.5 1-1 0.5-1 0C-1-0.5-0.5-1 0-1C0.5-1 1-0.5 1 0Z"
    );
    assert_eq!(
        [
            &json["version"],
            &json["closed"],
            &json["rounds"],
            &json["parametrization"]
        ],
        [
            &serde_json::json!(1),
            &serde_json::json!(true),
            &Value::Null,
            &"uniform".into()
        ]
    );
}

#[test]
fn points_come_in_many_forms() {
    let expected = printed(&["--points", "0,0 1,2 3,1 4,4"], "");
    assert_eq!(
        expected,
        "M0 0C0 0 0.4 1.8667 1 2C1.6 2.1333 2.4 0.5333 3 1C3.6 1.4667 4 4 4 4\n"
    );
    for input in [
        "0,0\n1,2\n3,1\n4,4\n",
        "0 0\n1 2\n3 1\n4 4",
        "x,y\r\n0,0\r\n1,2\r\n3,1\r\n4,4\r\n",
        "# made by hand\n\n0\t0\n1;2\n  3 , 1  # the dip\n4e0 +4.0\n",
        "\u{feff}0,0\n1,2\n3,1\n4,4\n",
        "\"0\",\"0\"\n\"1\",2\n3,\" 1 \"\n4,4\n",
        "\"x, in mm\";\"y 2\"\n0;0\n1;2\n3;1\n4;4\n",
        "pos_x0 [mm], 'y-axis' (mm)\n0;0\n1;2\n3;1\n4;4\n",
        "gro\u{308}\u{df}e,x-1\n0;0\n1;2\n3;1\n4;4\n",
        "l\u{e4}nge,h\u{f6}he\n0;0\n1;2\n3;1\n4;4\n",
        "Column 1,Column 2\n0,0\n1,2\n3,1\n4,4\n",
        "Column 1\tColumn 2 [mm]\n0\t0\n1\t2\n3\t1\n4\t4\n",
        "x,y,\n0,0,\n1,2,\n3,1,\n4,4,\n",
        "0;0;\n1;2;\n3;1;\n4;4;\n",
        "x,y\r0,0\r1,2\r\r3,1\r4,4",
        "x [1/mm],y [1/mm]\n0,0\n1,2\n3,1\n4,4\n",
    ] {
        assert_eq!(
            printed(&["--points-file", "-"], input),
            expected,
            "{input:?}"
        );
    }
    assert_eq!(printed(&["--points", "0 0;1 2;3 1;4 4"], ""), expected);
    let negative = printed(&["--points", "-1,-1 0,0"], "");
    assert_eq!(negative, "M-1-1C-1-1 0 0 0 0\n");
}

#[test]
fn bad_points_are_named_by_line_and_column() {
    let file = ["--points-file", "-"];
    for (input, told) in [
        ("0,0\n1,x\n", "<stdin>:2:3: 'x' is not a number"),
        (
            "0,0\n\n1,NaN\n",
            "<stdin>:3:3: 'NaN' is not a finite number",
        ),
        (
            "0,0\n1,1e999\n",
            "<stdin>:2:3: '1e999' is not a finite number",
        ),
        (
            "0,0\n1\n",
            "<stdin>:2:2: a point is two numbers, but this is one",
        ),
        (
            "0,0\n1,2,3\n",
            "<stdin>:2:5: a point is two numbers, but here is a third",
        ),
        ("0,0\n1,,2\n", "<stdin>:2:3: a number is missing"),
        ("x,1\n0,0\n", "<stdin>:1:1: 'x' is not a number"),
        ("x,y\nx,y\n", "<stdin>:2:1: 'x' is not a number"),
        (
            "1mm,0mm\n1,1\n2,0\n",
            "<stdin>:1:1: '1mm' is not a number\nhint: lengths are numbers in user units: 1;",
        ),
        (
            "\"1,5\";2\n1;1\n",
            "<stdin>:1:1: '\"1,5\"' is not a number\nhint: decimals come after a point: 1.5\n",
        ),
        ("\"5,0\n1,1\n", "<stdin>:1:1: '\"5' is not a number"),
        ("-x,y\n1,1\n", "<stdin>:1:1: '-x' is not a number"),
        ("x,.5.\n1,1\n", "<stdin>:1:3: '.5.' is not a number"),
        (
            "'0','0'\n1,1\n",
            "<stdin>:1:1: ''0'' is not a number, and no name of a column",
        ),
        (
            "x,$0\n1,1\n",
            "<stdin>:1:3: '$0' is not a number, and no name",
        ),
        ("~1,~2\n1,1\n", "<stdin>:1:1: '~1' is not"),
        ("x=0,y=0\n1,1\n", "<stdin>:1:1: 'x=0' is not"),
        ("O.5,O.7\n1,1\n", "<stdin>:1:1: 'O.5' is a number but"),
        ("l0,l2\n1,1\n", "<stdin>:1:1: 'l0' is a number but"),
        ("x,O5\n1,1\n", "<stdin>:1:3: 'O5' is a number but"),
        (
            "// c\n1,1\n",
            "<stdin>:1:1: '//' is not a number, and no name of a column: a letter, then letters, digits, _ and -, perhaps a unit in brackets; a # begins a comment",
        ),
        ("(mm) (mm)\n1,1\n", "<stdin>:1:1: '(mm)' is not"),
        ("x (0) y (0)\n1,1\n", "<stdin>:1:3: '(0)' is not"),
        (",\n1,1\n", "<stdin>:1:1: a number is missing"),
        (
            "\u{2212}1,0\n1,1\n",
            "' is not a number, and no name of a column: a letter, then letters, digits, _ and -, perhaps a unit in brackets; a # begins a \
             comment\nhint: the minus of numbers is a hyphen: -1\n",
        ),
        (
            "0,0\n# a\n1,1\n1,1\n",
            "<stdin>:4: point 3 is the same as point 2 (lines 3 and 4)",
        ),
        (
            "\"\",\"x\",\"y\"\n1,0,0\n2,1,1\n",
            "<stdin>:1:1: the first line has 3 columns, and a point is two numbers: keep two of them, as cut -d, -f2,3 does",
        ),
        (
            ";x;y\n1;0;0\n",
            "1:1: the first line has 3 columns, and a point is two numbers: keep two of them, as cut -d ';' -f2,3 does",
        ),
        ("x\ty\tz\n1\t0\t0\n", "keep two of them, as cut -f1,2 does"),
        (
            "Column 1 Column 2\n0 0\n1 1\n",
            "<stdin>:1:1: 'Column' is not a number, and the first line is neither two numbers nor the names of two columns",
        ),
        (
            ",x\n0,0\n",
            "1:1: a number is missing, and the first line is neither two numbers nor the names of two columns",
        ),
        (
            "x,y\n0,0,\n1,1\n",
            "<stdin>:2:5: no number after a separator",
        ),
        (
            "0,0,\n1,1\n",
            "<stdin>:2:4: the lines before end with a separator, and this one does not",
        ),
        ("0,0,,\n1,1\n", "<stdin>:1:5: no number after a separator"),
        ("x,y\r0,0\r1,a\r", "<stdin>:3:3: 'a' is not a number\n"),
        ("0,0\n", "runs through at least 2 points, but there is 1"),
        ("", "runs through at least 2 points, but there are 0"),
    ] {
        let message = refused(&file, input);
        assert!(message.contains(told), "{input:?}: {message}");
    }
    let cyclic = [&file[..], &["--ends", "cyclic"]].concat();
    assert!(refused(&cyclic, "0,0\n1,1\n").contains("cyclic ends runs through at least 3 points"));
    let closed_twice = refused(&cyclic, "0,0\n1,1\n1,0\n0,0\n");
    assert!(closed_twice.contains("<stdin>:4: point 1 is the same as point 4"));
    assert!(closed_twice.contains("hint: leave the last point out"));
}

#[test]
fn bad_requests_are_refused_with_what_would_do() {
    for (arguments, told) in [
        (
            &["--points", "0,0 1"][..],
            "point 2 has no y, at column 6 of --points",
        ),
        (
            &["--points", "0,0 1,a"],
            "'a' is not a number, at column 7 of --points",
        ),
        (&["--points", "0,0 0,0"], "point 2 is the same as point 1"),
        (
            &["--points", "0,0 1e-200,0 2e-200,1e-200"],
            "the spacing of two points 1e-200 is too small",
        ),
        (
            &["--points", "0,0 1,1", "--ends", "fixed:1,2,3"],
            "take four numbers",
        ),
        (
            &["--points", "0,0 1,1", "--ends", "fixed:1,2,3,x"],
            "'x' is not a number",
        ),
        (
            &["--points", "0,0 1,1", "--ends", "fixed:1,2,3,inf"],
            "must be a finite number",
        ),
        (
            &["--points", "0,0 1,1", "--ends", "loose"],
            "cyclic, free, natural or fixed:DX,DY,DX,DY",
        ),
        (
            &["--points", "0,0 1,1", "--quadrature", "gauss2"],
            "integrates no arc length",
        ),
        (&[], "--points"),
        (
            &["--points", "0,0 1,1", "--points-file", "-"],
            "cannot be used with",
        ),
        (
            &[
                "--points",
                "0,0 1,1",
                "--parametrization",
                "arc-length",
                "--ends",
                "fixed:9,0,0,9",
            ],
            "the arc lengths did not settle",
        ),
        (&["--points", "0,0 1e160,1"], "is too large"),
    ] {
        let message = refused(arguments, "");
        assert!(message.contains(told), "{arguments:?}: {message}");
    }
    let missing = run(&["--points-file", "no/such/file"], "");
    assert_eq!(missing.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("no/such/file"));
}

#[test]
fn rounding_never_flattens_what_is_small_beside_the_whole() {
    // A million wide and two high: decimals follow the distance of neighbours, not the size of the whole.
    let input = "0,0\n1,0.5\n2,0\n1000000,1\n";
    let text = printed(&["--points-file", "-"], input);
    assert!(text.contains(" 1 0.5C"), "{text}");
    let path = printed(&["--points-file", "-", "-p", "0"], "0,0\n10.4,5\n20,0\n");
    assert!(
        path.starts_with("M0 0C0 0 ") && path.contains(" 10 5C"),
        "{path}"
    );
}

#[test]
fn natural_ends_have_no_curvature() {
    for count in [2, 3, 4, 30] {
        for parametrization in [Parametrization::Uniform, Parametrization::Chord] {
            let options = Options {
                ends: SplineEnds::Natural,
                parametrization,
                ..Options::default()
            };
            let spline = Spline::new(scattered(count), options).unwrap();
            let last = count - 2;
            let first = second_derivatives(&spline.segment(0), spline.lengths[0])[0];
            let end = second_derivatives(&spline.segment(last), spline.lengths[last])[1];
            assert!(
                first.hypot() < 1e-12 && end.hypot() < 1e-12,
                "{count}: {first:?} {end:?}"
            );
            assert!(count < 3 || second_derivative_jump(&spline) < 1e-9);
        }
    }
    let line = printed(&["--points", "0,0 3,3", "--ends", "natural"], "");
    assert_eq!(line, "M0 0C1 1 2 2 3 3\n");
}

#[test]
fn the_iteration_ends_where_it_is_told_and_its_lengths_are_listed() {
    let arguments = [
        "--points",
        "0,0 1,2 3,1 4,4",
        "--parametrization",
        "arc-length",
        "-f",
        "json",
    ];
    let at = |stop: &str| -> Value {
        serde_json::from_str(&printed(&[&arguments[..], &["--stop", stop]].concat(), "")).unwrap()
    };
    let (rough, fine) = (at("1e-3"), at("1e-12"));
    assert!(rough["rounds"].as_u64() < fine["rounds"].as_u64());
    for drawing in [&rough, &fine] {
        let lengths = drawing["lengths"].as_array().unwrap();
        assert_eq!(
            lengths.len() as u64,
            1 + drawing["rounds"].as_u64().unwrap()
        );
        assert!((lengths[0][0].as_f64().unwrap() - 5.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!(
            lengths.last().unwrap()[2],
            drawing["segments"][2]["parameter_length"]
        );
    }
    let message = refused(&["--points", "0,0 1,2", "--stop", "1e-3"], "");
    assert!(
        message.contains("--parametrization arc-length"),
        "{message}"
    );
}
