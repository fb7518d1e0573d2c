//! The sphere of Chen's Figure 1: its lines, their halves before and behind the limb, and their error.

use crate::judges::program;

use curveto::number::Precision;
use curveto::sphere::{Options, Part, Sphere, SphereLine, SphereView, View};
use curveto::{Angle, Method, Rule};
use kurbo::{ParamCurve, PathSeg, Point};

fn seen(meridians: usize, parallels: usize, view: [f64; 2], method: Method) -> SphereView {
    let [longitude, latitude] = view.map(Angle::from_degrees);
    let view = View {
        longitude,
        latitude,
        y_up: false,
    };
    let options = Options {
        rule: Rule::Method(method),
        precision: Some(Precision::Full),
        ..Options::default()
    };
    Sphere::new((0.0, 0.0), 100.0, meridians, parallels)
        .unwrap()
        .seen(view, &options)
        .unwrap()
}

/// The distance of an end of a part from the outline.
fn off_the_outline(p: Point) -> f64 {
    (p.to_vec2().hypot() - 100.0).abs()
}

fn ends(part: &Part) -> [Point; 2] {
    let segments = &part.curve.segments;
    [segments[0].start(), segments[segments.len() - 1].end()]
}

/// The point of a line on the true sphere, and whether it is on the near side, where the image (x, y) of the line is.
fn depth_of_parallel(p: Point, latitude: Angle, view_latitude: Angle) -> f64 {
    // z = sin(latitude) is what the height on the screen, -y, and the depth make of the two axes of the view.
    let (z, view) = (latitude.direction().y * 100.0, view_latitude.direction());
    (z + p.y * view.x) / view.y
}

#[test]
fn every_part_ends_at_the_limb() {
    for view in [[30.0, 20.0], [0.0, 0.0], [-100.0, -75.0], [13.0, 51.5]] {
        let picture = seen(12, 7, view, Method::Minimax);
        assert!(!picture.back.is_empty());
        for part in picture.front.iter().chain(&picture.back) {
            if !part.curve.closed {
                for end in ends(part) {
                    // The curve itself strays by up to this from the sphere.
                    assert!(
                        off_the_outline(end) <= picture.error.peak() + 1e-9,
                        "{view:?} {part:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn parts_of_parallels_lie_on_their_side() {
    let view = [30.0, 20.0];
    let picture = seen(0, 9, view, Method::Minimax);
    let sides = [(&picture.front, 1.0), (&picture.back, -1.0)];
    for (parts, sign) in sides {
        assert!(parts.len() >= 7);
        for part in parts {
            let SphereLine::Parallel(latitude) = part.line else {
                panic!("{part:?}")
            };
            for segment in &part.curve.segments {
                for i in 1..10 {
                    let p = segment.eval(f64::from(i) / 10.0);
                    let depth = depth_of_parallel(p, latitude, Angle::from_degrees(view[1]));
                    assert!(sign * depth > -1e-9, "{depth} {part:?}");
                }
            }
        }
    }
}

#[test]
fn front_and_back_together_are_whole_circles() {
    let picture = seen(12, 7, [30.0, 20.0], Method::Minimax);
    // Every end at which a front part stops is one at which a back part begins, digit for digit.
    let mut front: Vec<Point> = picture
        .front
        .iter()
        .filter(|p| !p.curve.closed)
        .flat_map(ends)
        .collect();
    let mut back: Vec<Point> = picture
        .back
        .iter()
        .filter(|p| !p.curve.closed)
        .flat_map(ends)
        .collect();
    let order = |a: &Point, b: &Point| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
    front.sort_by(order);
    back.sort_by(order);
    assert_eq!(front, back);
    assert_eq!(front.len(), 2 * (7 + 6));
}

#[test]
fn parallels_near_a_pole_are_seen_whole() {
    let picture = seen(0, 7, [0.0, 60.0], Method::Minimax);
    let whole: Vec<f64> = picture
        .front
        .iter()
        .filter(|part| part.curve.closed)
        .map(|part| match part.line {
            SphereLine::Parallel(latitude) => latitude.degrees(),
            other => panic!("{other:?}"),
        })
        .collect();
    // From latitude 60 everything north of 30 degrees is before the limb.
    assert_eq!(whole, [67.5, 45.0]);
}

#[test]
fn lines_in_the_limb_belong_to_the_front() {
    // Seen from the pole the equator is the outline; seen from the equator the meridians a quarter turn away are.
    let from_the_pole = seen(0, 1, [77.0, 90.0], Method::Minimax);
    assert_eq!(
        (from_the_pole.front.len(), from_the_pole.back.len()),
        (1, 0)
    );
    assert!(from_the_pole.front[0].curve.closed);
    let from_the_side = seen(4, 0, [0.0, 0.0], Method::Minimax);
    assert_eq!(
        (from_the_side.front.len(), from_the_side.back.len()),
        (2, 1)
    );
}

#[test]
fn the_picture_is_symmetric_about_the_meridian_of_the_view() {
    let picture = seen(0, 7, [31.7, 20.0], Method::Minimax);
    for part in &picture.front {
        let points: Vec<Point> = part
            .curve
            .segments
            .iter()
            .flat_map(curveto::curve::control_points)
            .collect();
        for (p, q) in points.iter().zip(points.iter().rev()) {
            assert!(
                (p.x + q.x).abs() < 1e-12 && (p.y - q.y).abs() < 1e-12,
                "{p} {q}"
            );
        }
    }
}

#[test]
fn the_error_is_that_of_a_great_circle() {
    for method in [
        Method::Minimax,
        Method::Chen3,
        Method::QuadraticMidpoint,
        Method::MinimaxFree,
    ] {
        let quarter = method
            .radial_error(&curveto::method::Span::from_degrees(90.0))
            .unwrap();
        let error = seen(12, 7, [30.0, 20.0], method).error;
        assert!(
            (error.outward - 100.0 * quarter.outward).abs() < 1e-11,
            "{method}"
        );
        assert!(
            (error.inward - 100.0 * quarter.inward).abs() < 1e-11,
            "{method}"
        );
    }
}

#[test]
fn images_of_great_circles_are_as_far_off_as_stated() {
    // A meridian seen from the side of the equator is a circle again: its image shows its error in full.
    let picture = seen(2, 0, [90.0, 0.0], Method::Minimax);
    let truth = curveto::shape::Truth::circle(Point::ORIGIN, 100.0);
    let segments: Vec<&PathSeg> = picture
        .front
        .iter()
        .flat_map(|p| &p.curve.segments)
        .collect();
    let error = curveto::measure::radial::error(segments, &truth);
    assert!((error.peak() - picture.error.peak()).abs() < 1e-9);
}

fn printed(arguments: &[&str]) -> String {
    program::printed(&[&["sphere"], arguments].concat())
}

#[test]
fn every_format_has_the_hidden_halves_only_where_they_are_asked_for() {
    let paths = |hidden: &str| printed(&["100", "--hidden", hidden]).matches('M').count();
    assert_eq!([paths("show"), paths("dash"), paths("none")], [27, 27, 14]);
    let eps = printed(&["100", "-f", "eps"]);
    assert!(eps.contains("setdash"));
    assert!(!printed(&["100", "-f", "eps", "--hidden", "show"]).contains("setdash"));
    let json: serde_json::Value = serde_json::from_str(&printed(&["100", "-f", "json"])).unwrap();
    assert_eq!(json["front"].as_array().unwrap().len(), 13);
    assert_eq!(json["back"].as_array().unwrap().len(), 13);
    assert_eq!(json["front"][0]["line"], "parallel");
    assert!((json["error"]["relative_peak"].as_f64().unwrap() - 1.960_764_7e-4).abs() < 1e-10);
}

#[test]
fn north_is_up_on_canvas_and_page() {
    // Seen from latitude 60 the parallel of latitude 45 is whole, and begins below the middle on its own meridian.
    let options = [
        "10",
        "--meridians",
        "0",
        "--parallels",
        "3",
        "--view",
        "0,60",
        "--hidden",
        "none",
    ];
    let height = 10.0
        * (45.0_f64.to_radians().sin() * 60.0_f64.to_radians().cos()
            - 45.0_f64.to_radians().cos() * 60.0_f64.to_radians().sin());
    for (format, sign) in [("path", -1.0), ("ps", 1.0)] {
        let text = printed(&[&options[..], &["-f", format]].concat());
        let wanted = format!("{:.4}", sign * height);
        assert!(
            text.contains(wanted.trim_end_matches('0')),
            "{format}, {wanted}: {text}"
        );
    }
}

#[test]
fn impossible_spheres_are_refused() {
    for (arguments, told) in [
        (&["0"][..], "radius must be a positive"),
        (&["10", "--view", "0,91"], "between -90 and 90 degrees"),
        (&["10", "--view", "0"], "not two angles"),
        (
            &["10", "--meridians", "3", "-m", "minimax-free"],
            "its segments end off the circle",
        ),
        (&["10", "-n", "0"], "the number of segments must be from 1"),
        (&["10", "--parallels", "1000000"], "up to 10000"),
        (
            &["10", "-m", "apprich", "-n", "2"],
            "apprich cannot do this",
        ),
    ] {
        let message = program::refused(&[&["sphere"], arguments].concat());
        assert!(message.contains(told), "{arguments:?}: {message}");
    }
}

/// Chen's eight points, 30 and 60 degrees apart in turn.
const UNEVEN: &str = "0,30,90,120,180,210,270,300";

#[test]
fn arcs_of_different_spans_have_their_joints_where_they_were_asked_for() {
    let words = [
        "sphere", "100", "--view", "25,35", "-m", "chen-3", "--joints", UNEVEN,
    ];
    let found = program::json(&words);
    let circle = program::json(&["circle", "100", "-m", "chen-3", "--joints", UNEVEN]);
    for key in ["outward", "inward"] {
        let of = |value: &serde_json::Value| value["error"][key].as_f64().unwrap();
        assert!((of(&found) - of(&circle)).abs() < 1e-9);
    }
    let joints: Vec<f64> = UNEVEN.split(',').map(|a| a.parse().unwrap()).collect();
    let [view_longitude, view_latitude] = [25.0_f64, 35.0].map(f64::to_radians);
    let seen_at = |longitude: f64, latitude: f64| {
        let east = latitude.cos() * (longitude - view_longitude).sin();
        let toward = latitude.cos() * (longitude - view_longitude).cos();
        let up = latitude.sin() * view_latitude.cos() - toward * view_latitude.sin();
        [100.0 * east, -100.0 * up]
    };
    let mut placed = 0;
    for part in ["front", "back"]
        .iter()
        .flat_map(|side| found[side].as_array().unwrap())
    {
        let degrees = |key: &str| part[key].as_f64().map(f64::to_radians);
        let expected: Vec<[f64; 2]> = joints
            .iter()
            .map(|joint| match (degrees("latitude"), degrees("longitude")) {
                (Some(latitude), _) => seen_at(joint.to_radians(), latitude),
                (_, longitude) => {
                    let latitude = core::f64::consts::FRAC_PI_2 - joint.to_radians();
                    seen_at(longitude.unwrap(), latitude)
                }
            })
            .collect();
        // Parts begin and end at the limb too: the ends between two segments are joints.
        for segment in &part["segments"].as_array().unwrap()[1..] {
            let p: Vec<f64> = segment["points"][0]
                .as_array()
                .unwrap()
                .iter()
                .map(|x| x.as_f64().unwrap())
                .collect();
            assert!(
                expected
                    .iter()
                    .any(|q| (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-9),
                "{part} {p:?}"
            );
            placed += 1;
        }
    }
    assert!(placed > 60, "{placed}");
}

#[test]
fn joints_of_half_circles_are_those_inside_them() {
    let words = [
        "sphere",
        "10",
        "--meridians",
        "1",
        "--parallels",
        "0",
        "--view",
        "0,0",
        "--joints",
        UNEVEN,
    ];
    let found = program::json(&words);
    let meridian = &found["front"].as_array().unwrap()[0];
    assert_eq!(meridian["line"], "meridian");
    // 30, 90 and 120 degrees from the north pole lie inside.
    assert_eq!(meridian["segments"].as_array().unwrap().len(), 4);
    assert!(program::refused(&[&words[..], &["-m", "minimax-free"]].concat()).contains("hint:"));
    assert!(
        program::refused(&["sphere", "10", "--joints", "0,180", "-n", "4"]).contains("--segments")
    );
}

#[test]
fn joints_too_far_apart_are_refused_with_joints_that_do() {
    let far = ["--joints", "0,30,90,120"];
    for words in [
        &["sphere", "100"][..],
        &["sphere", "100", "-m", "chen-3"],
        &["sphere", "100", "-m", "apprich"],
        &["circle", "5", "-m", "chen-1"],
        &["circle", "5", "--handle", "0.5"],
        &["circle", "5", "--reverse", "-m", "quadratic-tangent"],
        &["arc", "5", "--start", "-10", "--end", "345"],
    ] {
        let message = program::refused(&[words, &far].concat());
        let (_, joints) = message
            .trim_end()
            .split_once("hint: take nearer joints, as --joints ")
            .unwrap();
        assert!(joints.contains("120"), "{message}");
        program::printed(&[words, &["--joints", joints]].concat());
    }
    let message = program::refused(&["sphere", "100", "--joints", "0,30,90,120"]);
    assert_eq!(
        message,
        "error: minimax cannot do this: a segment of 240 degrees is beyond its largest, 180 degrees\n\
         hint: take nearer joints, as --joints 0,30,90,120,240\n"
    );
}

/// How far points of the outline and of the parallels, evaluated here, lie from the true circles as they are seen: a lower bound of the error.
fn strays(found: &serde_json::Value, radius: f64, latitude_of_view: f64) -> f64 {
    let view = latitude_of_view.to_radians();
    let mut worst = 0.0_f64;
    let parts = |side: &str| found[side].as_array().unwrap().clone();
    let all = [
        parts("front"),
        parts("back"),
        vec![found["outline"].clone()],
    ]
    .concat();
    for part in all.iter().filter(|part| part["line"] != "meridian") {
        let latitude = part["latitude"].as_f64().map(f64::to_radians);
        let (ring, squeeze, up) = latitude.map_or((radius, 1.0, 0.0), |latitude| {
            let up = radius * latitude.sin() * view.cos();
            (radius * latitude.cos(), view.sin().abs(), -up)
        });
        // How near an ellipse comes: its points sampled around that of the direction.
        let off = |p: Point| {
            let around = f64::atan2((p.y - up) / squeeze.max(1e-9), p.x);
            let at = |i: i32| {
                let angle = around + f64::from(i) * 1e-3;
                Point::new(ring * angle.cos(), up + ring * squeeze * angle.sin()).distance(p)
            };
            // Between samples the true curve may be nearer by this.
            (-300..=300).map(at).fold(f64::INFINITY, f64::min) - ring * 1e-6
        };
        for segment in part["segments"].as_array().unwrap() {
            let points: Vec<[f64; 2]> = serde_json::from_value(segment["points"].clone()).unwrap();
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| Point::from((points[i][0], points[i][1])));
            let cubic = kurbo::CubicBez::new(a, b, c, d);
            for i in 0..=24 {
                let p = cubic.eval(f64::from(i) / 24.0);
                if part["line"] == "outline" {
                    worst = worst.max((p.to_vec2().hypot() - radius).abs());
                } else if squeeze > 0.2 {
                    worst = worst.max(off(p));
                }
            }
        }
    }
    worst
}

#[test]
fn what_a_sphere_states_bounds_the_points_as_printed() {
    use crate::judges::random::Dice;
    let mut dice = Dice(7);
    for i in 0..40 {
        let radius = dice.logarithmic(0.1, 1e4);
        let view = [dice.within(-180.0, 180.0), dice.within(-90.0, 90.0)];
        let view_words = format!("--view={},{}", view[0], view[1]);
        let (r, n) = (radius.to_string(), (3 + i % 4).to_string());
        let method = ["minimax", "midpoint", "chen-3"][i % 3];
        let lines = ["0", "4"][i % 2];
        let (meridians, parallels) = (["--meridians", lines], ["--parallels", lines]);
        let words: [&str; 7] = ["sphere", &r, &view_words, "-n", &n, "-m", method];
        let words = [&words[..], &meridians, &parallels].concat();
        let found = program::json(&[&words[..], &["-p", "auto"]].concat());
        let peak = found["error"]["peak"].as_f64().unwrap();
        let truth = strays(&found, radius, view[1]);
        assert!(truth <= peak * (1.0 + 1e-12), "{words:?}: {truth} {peak}");
        assert!(truth > 0.8 * peak, "{words:?}: {truth} {peak}");
        // Every other place says so too, rounded up.
        let svg = printed(&[&words[1..], &["-f", "svg"]].concat());
        let stated = svg.split_once("; within ").unwrap().1;
        let stated: f64 = stated.split(' ').next().unwrap().parse().unwrap();
        assert!(stated >= peak && stated < 1.02 * peak, "{words:?}: {svg}");
    }
}

#[test]
fn a_sphere_of_no_lines_states_what_its_circle_does() {
    for map in ["", "scale(2)", "scale(3)rotate(20)", "skewX(20)"] {
        let peak = |shape: &[&str]| {
            let found = program::json(&[shape, &["-p", "auto", "--transform", map]].concat());
            [&found["error"]["peak"], &found["error"]["relative_peak"]].map(|x| x.as_f64().unwrap())
        };
        let sphere = peak(&["sphere", "50", "--meridians", "0", "--parallels", "0"]);
        let circle = peak(&["circle", "50"]);
        for (a, b) in sphere.into_iter().zip(circle) {
            assert!((a / b - 1.0).abs() < 1e-9, "{map}: {sphere:?} {circle:?}");
        }
    }
}
