//! `path --to arcs` and `--to lines` take as few pieces as dynamic programming finds, keep what was given, and stay within the
//! tolerance in the decimals of every format, by judges that share no code with them.

use std::fmt::Write as _;

use curveto::kurbo::{Affine, CubicBez, ParamCurve, Point, Vec2};
use curveto::{arcs, path};
use proptest::prelude::*;

use crate::judges::independent::{P, Segment, segments};
use crate::judges::program::{json, printed, run, words as program_words};
use crate::judges::random::uniform;
use crate::judges::way_back::apart;

/// What rounding leaves of a tolerance, and the fewer ends that a grid has.
const ROUNDING: f64 = 0.93;

/// Curves without an arc in them.
const FREE: [[f64; 8]; 6] = [
    [0.0, 0.0, 30.0, 80.0, 70.0, 90.0, 100.0, 0.0],
    [0.0, 0.0, 30.0, 100.0, 70.0, -100.0, 100.0, 0.0],
    [0.0, 0.0, 90.0, 0.0, 100.0, 40.0, 100.0, 100.0],
    [0.0, 0.0, 150.0, 80.0, -50.0, 80.0, 100.0, 0.0],
    [0.0, 0.0, 10.0, 60.0, 20.0, 90.0, 100.0, 100.0],
    [0.0, 0.0, 0.0, 50.0, 10.0, 100.0, 90.0, 20.0],
];

fn cubic([a, b, c, d, e, f, g, h]: [f64; 8]) -> CubicBez {
    CubicBez::new((a, b), (c, d), (e, f), (g, h))
}

fn data(c: [f64; 8]) -> String {
    format!(
        "M{} {}C{} {} {} {} {} {}",
        c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]
    )
}

/// How far points lie from the arc with this sagitta over a chord, by its circle's centre.
fn from_arc(points: &[Point], a: Point, b: Point, sagitta: f64) -> f64 {
    let half = (b - a).hypot() / 2.0;
    let along = (b - a) / (2.0 * half);
    let left = Vec2::new(-along.y, along.x);
    if sagitta.abs() < 1e-9 * half {
        let off = |p: &Point| along.cross(*p - a).abs();
        return points.iter().map(off).fold(0.0, f64::max);
    }
    let radius = (half * half + sagitta * sagitta) / (2.0 * sagitta);
    let center = a.midpoint(b) + left * (sagitta - radius);
    let off = |p: &Point| ((*p - center).hypot() - radius.abs()).abs();
    points.iter().map(off).fold(0.0, f64::max)
}

/// Whether some arc over the chord of a part stays within the tolerance: the best sagitta by golden section.
fn fits(curve: &CubicBez, from: f64, to: f64, tolerance: f64, is_line: bool) -> bool {
    let count = 40;
    let at = |i: usize| curve.eval(from + (to - from) * i as f64 / count as f64);
    let points: Vec<Point> = (1..count).map(at).collect();
    let (a, b) = (at(0), at(count));
    if is_line {
        return from_arc(&points, a, b, 0.0) <= tolerance;
    }
    let middle = (b - a).cross(at(count / 2) - a) / (b - a).hypot();
    let (mut low, mut high) = (middle - 3.0 * tolerance, middle + 3.0 * tolerance);
    for _ in 0..40 {
        let (x, y) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
        let [u, v] = [x, y].map(|sagitta| from_arc(&points, a, b, sagitta));
        if u.min(v) <= tolerance {
            return true;
        }
        if u < v {
            high = y;
        } else {
            low = x;
        }
    }
    false
}

/// The fewest pieces whose ends lie on a grid of parameters, by dynamic programming.
fn fewest(curve: &CubicBez, tolerance: f64, grid: usize, is_line: bool) -> usize {
    let mut least = vec![usize::MAX; grid + 1];
    least[0] = 0;
    for to in 1..=grid {
        for from in 0..to {
            let [u, v] = [from, to].map(|i| i as f64 / grid as f64);
            if least[from] < usize::MAX
                && least[from] + 1 < least[to]
                && fits(curve, u, v, tolerance, is_line)
            {
                least[to] = least[from] + 1;
            }
        }
    }
    least[grid]
}

/// The pieces that the program draws.
fn pieces(data: &str, to: &str, tolerance: f64) -> usize {
    let text = printed(&["path", data, "--to", to, "-t", &tolerance.to_string()]);
    segments(&text).len() - 1
}

#[test]
fn arcs_are_as_few_as_dynamic_programming_finds() {
    for numbers in FREE {
        for tolerance in [2.0, 0.2, 0.02] {
            let found = pieces(&data(numbers), "arcs", tolerance);
            let optimum = fewest(&cubic(numbers), ROUNDING * tolerance, 120, false);
            assert!(
                found <= optimum,
                "{numbers:?} {tolerance}: {found}, not {optimum}"
            );
        }
    }
}

#[test]
fn what_serves_a_tolerance_serves_a_larger_one() {
    for (words, tolerances, fewest) in [
        // The radius of the first cubic alone is another one than that of the circle.
        (
            "circle 12 --center 12,12 -m chen-3 -n 8 -p 3",
            &["0.009", "0.0095", "0.01", "0.0115"][..],
            2,
        ),
        (
            "circle 10 -m chen-3 -n 12 -p 3",
            &["0.0016", "0.00174", "0.00185"],
            2,
        ),
        // Four arcs have the round radius where two have another one.
        (
            "circle 10 -n 6 -p 3",
            &["0.00035", "0.0004", "0.0005", "0.0006"],
            2,
        ),
        (
            "circle 7.5 --center 3,4 -n 5 -p 2",
            &["0.003", "0.0035", "0.0045", "0.005"],
            2,
        ),
        // Parts of a turn that are near enough where shorter ones are not.
        (
            "circle 12 --center 12,12 -n 10 -p 3",
            &["0.0003016", "0.0003348", "0.00037"],
            3,
        ),
        (
            "circle 50 --center 50,50 -n 10 -p 3",
            &["0.0002", "0.00022", "0.0003"],
            2,
        ),
    ] {
        let circle = printed(&program_words(words));
        for tolerance in tolerances {
            let arcs = printed(&["path", &circle, "--to", "arcs", "-t", tolerance]);
            let found = arcs.matches(['A', 'L']).count();
            assert!(found <= fewest, "{words}, -t {tolerance}: {found}");
        }
    }
}

#[test]
fn an_arc_reaches_past_a_peak_of_curvature() {
    // The first arc is near enough up to 0.43 of the curve, and again from 0.575 to 0.59.
    let curve = "M22.53 1.1C26.99 33.68 96.67 30.73 16.27 8.84";
    assert_eq!(pieces(curve, "arcs", 0.338_944), 3);
}

#[test]
fn chords_are_within_a_twentieth_of_the_optimum() {
    for numbers in FREE {
        for tolerance in [1.0, 0.1] {
            let found = pieces(&data(numbers), "lines", tolerance);
            let optimum = fewest(&cubic(numbers), tolerance, 300, true);
            let most = (1.05 * optimum as f64).ceil() as usize;
            assert!(
                found <= most,
                "{numbers:?} {tolerance}: {found}, not {optimum}"
            );
        }
    }
}

#[test]
fn a_spiral_takes_fewer_arcs_than_biarcs_would() {
    // Over the same length two arcs with shared tangents stray ten times as far as one whose ends lie on the curve.
    assert!(pieces("M1 0A1 0.5 0 0 1 0 0.5", "arcs", 1e-4) <= 7);
}

#[test]
fn arcs_run_over_smooth_joints_and_not_over_corners() {
    // One circle in 40 cubics that nobody drew as arcs of it: their handles are too short.
    let mut smooth = "M100 0".to_owned();
    for i in 1..=40 {
        let [a, b] = [i - 1, i].map(|i| f64::from(i) * std::f64::consts::PI / 80.0);
        let handle = 0.2 * (b - a);
        let _ = write!(
            smooth,
            "C{} {} {} {} {} {}",
            100.0 * (a.cos() - handle * a.sin()),
            100.0 * (a.sin() + handle * a.cos()),
            100.0 * (b.cos() + handle * b.sin()),
            100.0 * (b.sin() - handle * b.cos()),
            100.0 * b.cos(),
            100.0 * b.sin(),
        );
    }
    assert_eq!(pieces(&smooth, "arcs", 0.1), 1);
    let corner = "M0 0C10 0 20 1 30 3C40 1 50 0 60 0";
    let text = printed(&["path", corner, "--to", "arcs", "-t", "0.9"]);
    assert!(text.contains("30 3"), "{text}");
}

// ---- random paths

#[derive(Debug, Clone)]
enum Step {
    Line([f64; 2]),
    Quad([f64; 4]),
    Cubic([f64; 6]),
    Arc([f64; 3], bool, bool, [f64; 2]),
}

fn number() -> impl Strategy<Value = f64> {
    (-9999..9999_i32, 0..4_u32)
        .prop_map(|(x, d)| f64::from(x) / f64::from(10_u32.pow(d)).max(100.0))
}

fn step() -> impl Strategy<Value = Step> {
    let arc = (
        prop::array::uniform3(1.0..80.0_f64),
        any::<bool>(),
        any::<bool>(),
        prop::array::uniform2(number()),
    );
    prop_oneof![
        prop::array::uniform2(number()).prop_map(Step::Line),
        prop::array::uniform4(number()).prop_map(Step::Quad),
        prop::array::uniform6(number()).prop_map(Step::Cubic),
        arc.prop_map(|(radii, large, sweep, to)| Step::Arc(radii, large, sweep, to)),
    ]
}

fn text(steps: &[Step], start: [f64; 2], closed: bool) -> String {
    let mut out = format!("M{} {}", start[0], start[1]);
    let words = |letter: char, numbers: &[f64]| {
        let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
        format!("{letter}{}", words.join(" "))
    };
    for step in steps {
        out += &match step {
            Step::Line(p) => words('L', p),
            Step::Quad(p) => words('Q', p),
            Step::Cubic(p) => words('C', p),
            Step::Arc([rx, ry, turn], large, sweep, to) => {
                let ry = if *turn < 20.0 { rx } else { ry };
                let flags = [*large, *sweep].map(|flag| f64::from(u8::from(flag)));
                words('A', &[*rx, *ry, *turn, flags[0], flags[1], to[0], to[1]])
            }
        };
    }
    if closed { out + "Z" } else { out }
}

fn ends(path: &[Segment]) -> Vec<P> {
    path.iter().filter_map(Segment::end).collect()
}

/// Lines and arcs of G-code as path data, each arc about its I J to where it ends, its radius that of its start.
fn of_gcode(text: &str) -> String {
    let mut out = String::new();
    let mut at = [0.0_f64; 2];
    for line in text.lines().filter(|line| line.starts_with('G')) {
        let word = |letter: char| {
            let word = line.split(' ').find(|word| word.starts_with(letter))?;
            word[1..].parse::<f64>().ok()
        };
        let (Some(x), Some(y)) = (word('X'), word('Y')) else {
            continue;
        };
        match line.split(' ').next() {
            Some("G0") => write!(out, "M{x} {y}").unwrap(),
            Some("G1") => write!(out, "L{x} {y}").unwrap(),
            code => {
                let (i, j) = (word('I').unwrap(), word('J').unwrap());
                let clockwise = code == Some("G2");
                let (u, v) = ([-i, -j], [x - at[0] - i, y - at[1] - j]);
                let turn = f64::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
                let turn = if clockwise { -turn } else { turn };
                let turn = if turn > 1e-12 {
                    turn
                } else {
                    turn + std::f64::consts::TAU
                };
                let radius = i.hypot(j);
                // By many short chords.
                for k in 1..=400 {
                    let part = f64::from(k) / 400.0 * if clockwise { -turn } else { turn };
                    let (sin, cos) = part.sin_cos();
                    let p = [
                        at[0] + i + cos * u[0] - sin * u[1],
                        at[1] + j + sin * u[0] + cos * u[1],
                    ];
                    assert!(radius.is_finite());
                    write!(out, "L{} {}", p[0], p[1]).unwrap();
                }
                write!(out, "L{x} {y}").unwrap();
            }
        }
        at = [x, y];
    }
    out
}

fn stated(path: &str, to: &[&str], tolerance: &str) -> (f64, String) {
    let words = [&["path", path, "-t", tolerance, "-f", "json"][..], to].concat();
    let json: serde_json::Value = serde_json::from_str(&printed(&words)).unwrap();
    let peak = json["error"]["peak"].as_f64().unwrap();
    (peak, json["path"].as_str().unwrap().to_owned())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn any_path_stays_within_the_tolerance_in_every_form(
        steps in prop::collection::vec(step(), 1..6),
        start in prop::array::uniform2(number()),
        closed in any::<bool>(),
        tolerance in prop_oneof![Just("0.05"), Just("0.5"), Just("3")],
    ) {
        let path = text(&steps, start, closed);
        let old = segments(&path);
        let room: f64 = tolerance.parse().unwrap();
        for to in [&["--to", "arcs"][..], &["--to", "arcs", "--elliptic"], &["--to", "lines"]] {
            let (peak, new) = stated(&path, to, tolerance);
            prop_assert!(peak <= room, "{path} {to:?}: {peak}");
            let new = segments(&new);
            let off = apart(&old, &new).unwrap();
            // The points of the judge stand on chords, of which a long arc has few.
            prop_assert!(off <= peak + 0.06, "{path} {to:?}: {off} beyond {peak}");
            let (a, b) = (ends(&old), ends(&new));
            prop_assert_eq!(a[0], b[0]);
            let closes = |path: &[Segment]| matches!(path.last(), Some(Segment::Close));
            prop_assert_eq!(closes(&old), closes(&new));
            if !closed {
                prop_assert_eq!(a.last(), b.last());
            }
            for (step, end) in steps.iter().zip(&a[1..]) {
                let kept = b.contains(end);
                let is_curve = matches!(step, Step::Quad(_) | Step::Cubic(_));
                prop_assert!(kept || is_curve || closed, "{path} {to:?}: {end:?} is lost");
            }
        }
        for precision in [None, Some("3")] {
            let words = ["path", &path, "--to", "arcs", "-f", "gcode", "-t", tolerance];
            let more = precision.map_or(vec![], |p| vec!["-p", p]);
            let gcode = printed(&[&words[..], &more].concat());
            let off = apart(&old, &segments(&of_gcode(&gcode))).unwrap();
            prop_assert!(off <= room + 0.06, "{path} {more:?}: {off}");
        }
    }
}

#[test]
fn gcode_says_how_closely_it_follows_and_refuses_too_few_decimals() {
    let curve = "M0 0C30 80 70 90 100 0";
    for to in ["arcs", "lines"] {
        let told = printed(&["path", curve, "--to", to, "-t", "0.1", "-f", "gcode"]);
        let first = told.lines().next().unwrap();
        let within = first.strip_prefix("(Path, within ").unwrap();
        let within: f64 = within.strip_suffix(')').unwrap().parse().unwrap();
        assert!(within <= 0.1 && within > 0.05, "{first}");
        let words = [
            "path", curve, "--to", to, "-t", "0.1", "-f", "gcode", "-p", "0",
        ];
        assert_eq!(run(&words).status.code(), Some(2), "{to}");
    }
    // An arc that was meant is one, however little its Béziers leave to the rounding of centres.
    let quarter = printed(&["arc", "50", "--sweep", "90"]);
    let whole = printed(&[
        "path", &quarter, "--to", "arcs", "-t", "0.01", "-f", "gcode",
    ]);
    assert_eq!(whole.matches("G3 ").count(), 1, "{whole}");
    let circle = printed(&["path", "M5 0A5 5 0 0 1-5 0", "--to", "arcs", "-f", "gcode"]);
    assert!(
        circle.starts_with("(Path, exact but for rounding"),
        "{circle}"
    );
}

#[test]
fn gcode_draws_nearly_straight_arcs_with_few_decimals() {
    for path in [
        "M0 0C100 .1 200 .1 300 0",
        "M0 0C100 1 200 1 300 0",
        "M0 0C100 10 200 10 300 0",
        "M0 0A1e9 1e9 0 0 1 10 0",
        "M0 0A123456.7 123456.7 0 0 1 100.5 20.3L20 20",
        "M3.3 4.7A98765.4321 98765.4321 0 0 0 -77.7 12.1Z",
        "M0 0A1.2345678901e7 1.2345678901e7 0 0 1 10000.5 20.3",
        "M1 1A5e9 5e9 0 0 1 100 99L50 3",
    ] {
        let old = segments(path);
        for (tolerance, precision) in [
            (0.02, "2"),
            (0.2, "1"),
            (2.0, "0"),
            (0.002, "3"),
            (0.01, "9"),
        ] {
            let text = tolerance.to_string();
            let words = [
                "path", path, "--to", "arcs", "-f", "gcode", "-t", &text, "-p", precision,
            ];
            let program = printed(&words);
            let off = apart(&old, &segments(&of_gcode(&program))).unwrap();
            assert!(off <= 1.02 * tolerance + 1e-6, "{words:?} {off} {program}");
            let (_, within) = program.split_once("within ").unwrap_or(("", "0)"));
            let within: f64 = within.split_once(')').unwrap().0.parse().unwrap();
            assert!(within <= tolerance, "{words:?} {program}");
        }
    }
}

#[test]
fn small_arcs_of_large_sweeps_leave_room_for_their_centres() {
    let path = "M14.51 5.75Q4.62-25.66 52.4 88.94";
    let words = [
        "path", path, "--to", "arcs", "-f", "gcode", "-t", "0.05", "-p", "3",
    ];
    let off = apart(&segments(path), &segments(&of_gcode(&printed(&words)))).unwrap();
    assert!(off <= 0.11, "{off}");
}

#[test]
fn curves_that_stand_still_at_their_ends_are_not_refused() {
    let path = "M1 0C1 0 .85-.01 .475.304C.105.618 0 1.074 0 1.074";
    let (peak, new) = stated(path, &["--to", "arcs"], "0.01");
    assert!(peak <= 0.01, "{peak}");
    let off = apart(&segments(path), &segments(&new)).unwrap();
    assert!(off <= peak + 1e-4, "{new}: {off} beyond {peak}");
    assert!(new.starts_with("M1 0A"), "{new}");
}

#[test]
fn an_arc_that_was_meant_has_the_whole_tolerance() {
    // Balanced cubics, which stray by 0.009851.
    let path = "M50 0C50 27.596 27.596 50 0 50C-27.596 50-50 27.596-50 0";
    let (_, new) = stated(path, &["--to", "arcs"], "0.01");
    assert_eq!(new, "M50 0A50 50 0 0 1-50 0");
}

#[test]
fn rounding_of_what_was_given_counts_too() {
    let (peak, path) = stated("M0 0L10.4 0", &["--to", "arcs", "-p", "0"], "1");
    assert_eq!(path, "M0 0L10 0");
    assert!((0.4..0.41).contains(&peak), "{peak}");
    let coarse = [
        "path",
        "M0 0L10.4 0",
        "--to",
        "arcs",
        "-p",
        "0",
        "-t",
        "0.1",
    ];
    assert_eq!(run(&coarse).status.code(), Some(2));
}

#[test]
fn arcs_of_ellipses_are_found_and_kept_on_request() {
    let quarter = "M0 0C4.97 0 9 1.34 9 3";
    let found = printed(&["path", quarter, "--to", "arcs", "--elliptic"]);
    assert_eq!(found, "M0 0A9 3 0 0 1 9 3\n");
    let given = "M1 0A1 .5 30 0 1 0 .5L3 4";
    let found = printed(&["path", given, "--to", "arcs", "--elliptic"]);
    assert_eq!(found, "M1 0A1 0.5 30 0 1 0 0.5L3 4\n");
    for format in ["gcode", "dxf"] {
        let words = ["path", given, "--to", "arcs", "--elliptic", "-f", format];
        assert_eq!(run(&words).status.code(), Some(2), "{format}");
    }
    let words = ["path", given, "--elliptic"];
    assert_eq!(run(&words).status.code(), Some(2));
}

#[test]
fn arcs_of_ellipses_take_the_place_of_several_of_circles() {
    let quarter = ["path", "M1 0A1 .5 0 0 1 0 .5", "--to", "arcs", "-t", "1e-4"];
    let found = printed(&[&quarter[..], &["--elliptic"]].concat());
    assert_eq!(found, "M1 0A1 0.5 0 0 1 0 0.5\n");
    let count = |path: &str| path.matches(['A', 'L']).count();
    let (mut seed, mut circular, mut elliptic) = (7, 0, 0);
    for _ in 0..40 {
        let numbers = [0; 8].map(|_| (1e4 * uniform(&mut seed)).round() / 100.0);
        let tolerance = 0.003 * 100.0_f64.powf(uniform(&mut seed));
        let (data, words) = (data(numbers), tolerance.to_string());
        let path = |more: &[&str]| {
            let words = ["path", &data, "--to", "arcs", "-t", &words];
            printed(&[&words[..], more].concat())
        };
        let (without, with) = (path(&[]), path(&["--elliptic"]));
        assert!(
            count(&with) <= count(&without),
            "{data} {tolerance}: {with}"
        );
        circular += count(&without);
        elliptic += count(&with);
        let (stated, json) = stated(&data, &["--to", "arcs", "--elliptic"], &words);
        assert!(stated <= tolerance, "{data}: {json}");
        // The points of the judge stand on chords.
        let off = apart(&segments(&data), &segments(&with)).unwrap();
        assert!(
            off <= stated + 0.05,
            "{data} {tolerance}: {off} beyond {stated}"
        );
    }
    assert!(10 * elliptic <= 7 * circular, "{elliptic} of {circular}");
}

#[test]
fn radii_are_those_that_were_meant() {
    for (data, radius) in [
        // By a rough constant, with few decimals.
        ("M24 0C24 13.252 13.252 23.9987 0 24", "A24 24 "),
        ("M7.5 0C7.5 4.1 4.1 7.5 0 7.5", "A7.5 7.5 "),
        (
            "M100 0Q100 19.89 92.39 38.27Q84.78 56.65 70.71 70.71",
            "A100 100 ",
        ),
    ] {
        for wide in [&[][..], &["-t", "0.6"]] {
            let found = printed(&[&["path", data, "--to", "arcs"][..], wide].concat());
            assert!(found.contains(radius), "{data} {wide:?}: {found}");
        }
    }
}

#[test]
fn a_chain_that_comes_back_to_itself_takes_time_in_proportion() {
    // All of it seems near an arc, by its points.
    let length = |count: usize| {
        let data = format!("M0 0C5.5 0 10 4.5 10 10{}", "S5 5 0 0".repeat(count));
        let (error, drawn) = stated(&data, &["--to", "arcs"], "5");
        assert!(error <= 5.0);
        drawn.len()
    };
    let (few, many) = (length(100), length(2000));
    assert!(many < 30 * few, "{few} {many}");
}

#[test]
fn what_no_arc_follows_in_so_few_decimals_becomes_lines_within_what_is_stated() {
    let cases: [(&str, &[&str]); 3] = [
        ("M0.7 0Q-0.2 0.3 -0.717 1", &["-p", "1"]),
        (
            "M-4 3.9C7.6 6-7.483-1.021-8.2 2c3.805 4 9.127 3.814 3 7.432",
            &["--elliptic", "-p", "0"],
        ),
        (
            "M-41.9 30.6A13.1 13-77.2 0 1 83.206-41",
            &["-t", "0.24", "-p", "1"],
        ),
    ];
    for (path, options) in cases {
        let drawn = json(&[&["path", path, "--to", "arcs"], options].concat());
        let peak = drawn["error"]["peak"].as_f64().unwrap();
        let new = drawn["path"].as_str().unwrap();
        let ends = ends(&segments(new));
        // Only an end that was given may stay a step of no length.
        let still = ends.windows(2).filter(|pair| pair[0] == pair[1]).count();
        assert!(still <= 1, "{new}");
        let off = apart(&segments(path), &segments(new)).unwrap();
        assert!(off <= peak + 1e-3, "{path}: {off} beyond {peak}");
        // More than twice as far would be no statement.
        assert!(peak <= 2.2 * off, "{path}: {off} within {peak}");
    }
}

#[test]
fn chords_that_rounding_makes_points_are_left_out() {
    let curve = "M0 0C0.1 0.2 0.3 0.4 2 1L3 2";
    assert_eq!(
        printed(&["path", curve, "--to", "lines", "-p", "0"]),
        "M0 0L1 0L1 1L2 1L3 2\n"
    );
}

/// Ends and a radius tell the centre of half a turn badly: what the last digits of a map move them by, it moves by its root.
#[test]
fn an_arc_under_a_map_states_how_far_its_ends_tell_its_centre() {
    let error = |data: &str, map: Affine| {
        let contours = path::contours(data).unwrap();
        let options = arcs::Options {
            transform: map,
            ..arcs::Options::default()
        };
        let drawing = arcs::arcs(&contours, &options).unwrap();
        assert_eq!(
            drawing
                .courses()
                .map(|course| course.steps.len())
                .sum::<usize>(),
            1
        );
        drawing.error().peak()
    };
    let far = Affine::translate((1e6, 1e6 + 0.3)) * Affine::scale(1.1);
    // Half a turn, which ends too far apart for the radius say of any length.
    assert_eq!(error("M0 0A5 5 0 0 1 10 0", far), 0.0);
    assert_eq!(error("M0 0A1 1 0 0 1 3 1", far), 0.0);
    assert_eq!(error("M0 0A5 5 0 0 1 5 5", far), 0.0);
    // Nearly half a turn, and nearly a whole one.
    for (data, least) in [
        ("M0 0A5 5 0 0 1 9.999999 0", 1e-8),
        ("M0 0A5 5 0 1 1 9.99 0.1", 1e-9),
        ("M0 0A5 5 0 1 1 0.001 0", 1e-8),
    ] {
        let far = error(data, far);
        assert!(far > least && far < 1e-5, "{data}: {far:e}");
        assert_eq!(error(data, Affine::IDENTITY), 0.0, "{data}");
    }
}
