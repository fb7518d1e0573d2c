//! What readers make of DXF and G-code: DXF holds the very control points that JSON states, and lines and circular arcs are exact.
//! `make test-readers` asks ezdxf too.

use crate::judges::chain::{Chain, SHAPES, curves_of_a_sphere, stated};
use crate::judges::program::{drawn_text as printed, run_words};
use curveto::Angle;
use kurbo::{Line, ParamCurve, PathSeg, Point};

// DXF

/// The entities of a DXF file: the codes and values of each.
fn entities(text: &str) -> Vec<Vec<(u16, String)>> {
    let lines: Vec<&str> = text.lines().collect();
    let tags: Vec<(u16, &str)> = lines
        .chunks(2)
        .map(|tag| (tag[0].trim().parse().unwrap(), tag[1]))
        .collect();
    assert_eq!(tags.last(), Some(&(0, "EOF")));
    let start = tags.iter().position(|tag| *tag == (2, "ENTITIES")).unwrap();
    let section = tags[start + 1..]
        .iter()
        .take_while(|tag| **tag != (0, "ENDSEC"));
    let mut found: Vec<Vec<(u16, String)>> = Vec::new();
    for (code, value) in section {
        if *code == 0 {
            found.push(Vec::new());
        }
        found.last_mut().unwrap().push((*code, (*value).to_owned()));
    }
    let handles: Vec<&str> = tags
        .iter()
        .filter(|(code, _)| [5, 105].contains(code))
        .map(|tag| tag.1)
        .collect();
    // The first is $HANDSEED, the next one that is free.
    let free = u32::from_str_radix(handles[0], 16).unwrap();
    let mut used: Vec<u32> = handles[1..]
        .iter()
        .map(|h| u32::from_str_radix(h, 16).unwrap())
        .collect();
    used.sort_unstable();
    assert!(
        used.windows(2).all(|pair| pair[0] < pair[1]),
        "handles are unique"
    );
    assert!(used.iter().all(|&handle| handle < free));
    found
}

fn values(entity: &[(u16, String)], code: u16) -> Vec<f64> {
    let found = entity.iter().filter(|tag| tag.0 == code);
    found.map(|tag| tag.1.parse().unwrap()).collect()
}

fn points(entity: &[(u16, String)], x: u16, y: u16) -> Vec<[f64; 2]> {
    let pairs = values(entity, x).into_iter().zip(values(entity, y));
    pairs.map(|(x, y)| [x, y]).collect()
}

/// A SPLINE as Béziers: every knot inside is there as often as the degree says, so that no point has to be computed.
fn spline(entity: &[(u16, String)]) -> Chain {
    let one = |code| values(entity, code)[0] as usize;
    let (degree, knots, points) = (one(71), values(entity, 40), points(entity, 10, 20));
    assert_eq!((one(72), one(73)), (knots.len(), points.len()));
    let count = (points.len() - 1) / degree;
    let mut expected = vec![0.0; degree + 1];
    for knot in 1..count {
        expected.extend(vec![knot as f64; degree]);
    }
    expected.extend(vec![count as f64; degree + 1]);
    assert_eq!(knots, expected);
    let mut chain = Chain::new(points[0]);
    points[1..]
        .chunks(degree)
        .for_each(|segment| chain.push(segment));
    chain.finished(false)
}

#[test]
fn splines_of_dxf_hold_the_control_points() {
    for shape in SHAPES.iter().filter(|shape| !shape.contains("bulge 0")) {
        let entities = entities(&printed(&format!("{shape} -f dxf")));
        let names: Vec<&str> = entities.iter().map(|entity| entity[0].1.as_str()).collect();
        assert_eq!(names, ["SPLINE"], "{shape}");
        assert_eq!(
            spline(&entities[0]).segments,
            stated(shape).segments,
            "{shape}"
        );
    }
    let sphere = entities(&printed("sphere 5 -f dxf"));
    let layer =
        |entity: &Vec<(u16, String)>| entity.iter().find(|tag| tag.0 == 8).unwrap().1.clone();
    let mut layers: Vec<String> = sphere.iter().map(layer).collect();
    assert_eq!(layers.len(), curves_of_a_sphere());
    layers.dedup();
    assert_eq!(layers, ["outline", "back", "front"]);
}

#[test]
fn lines_and_arcs_are_exact_in_dxf() {
    let only = |arguments: &str| {
        let found = entities(&printed(&format!("{arguments} -f dxf")));
        assert_eq!(found.len(), 1, "{arguments}");
        (found[0][0].1.clone(), found[0].clone())
    };
    let (name, line) = only("arc --from 0,0 --to 10,5 --bulge 0");
    assert_eq!(
        (name.as_str(), points(&line, 10, 20), points(&line, 11, 21)),
        ("LINE", vec![[0.0, 0.0]], vec![[10.0, 5.0]])
    );

    let (name, arc) = only("arc 10 --center 1,2 --start 30 --sweep -100");
    assert_eq!(
        (name.as_str(), points(&arc, 10, 20), values(&arc, 40)),
        ("ARC", vec![[1.0, 2.0]], vec![10.0])
    );
    assert_eq!(
        (values(&arc, 50), values(&arc, 51)),
        (vec![290.0], vec![30.0])
    );

    let (name, circle) = only("arc 10 --start 30 --sweep 360");
    assert_eq!((name.as_str(), values(&circle, 40)), ("CIRCLE", vec![10.0]));

    for bulge in ["0.5", "-0.4", "2.25"] {
        let (name, polyline) = only(&format!("arc --from 0.1,0.2 --to 10,0 --bulge {bulge}"));
        assert_eq!(
            (name.as_str(), points(&polyline, 10, 20)),
            ("LWPOLYLINE", vec![[0.1, 0.2], [10.0, 0.0]])
        );
        assert_eq!(values(&polyline, 42), [bulge.parse::<f64>().unwrap()]);
    }
    // Where anything is said of how an arc is approximated, that is asked for.
    for asked in ["-m chen-1", "-n 2", "-t 0.1", "--handle 0.3", "--joints 30"] {
        let (name, _) = only(&format!("arc 10 --start 0 --sweep 90 {asked}"));
        assert_eq!(name, "SPLINE", "{asked}");
    }
}

// G-code

/// A move of a program, and where it starts.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Move {
    Rapid,
    Line(PathSeg),
    Arc {
        from: Point,
        to: Point,
        center: Point,
        clockwise: bool,
    },
}

/// The start, the end, the centre and the way round of a program of one arc.
fn only_arc(text: &str) -> (Point, Point, Point, bool) {
    let [
        Move::Rapid,
        Move::Arc {
            from,
            to,
            center,
            clockwise,
        },
    ] = gcode(text)[..]
    else {
        panic!("{text}")
    };
    (from, to, center, clockwise)
}

/// Runs a program in absolute coordinates.
fn gcode(text: &str) -> Vec<Move> {
    let mut at = Point::new(f64::NAN, f64::NAN);
    let mut moves = Vec::new();
    let mut lines = text.lines();
    assert!(lines.next().unwrap().starts_with('('));
    assert_eq!(lines.next(), Some("G17 G90"));
    for line in lines {
        let words: Vec<(&str, f64)> = line
            .split(' ')
            .map(|word| (&word[..1], word[1..].parse().unwrap()))
            .collect();
        let word = |letter| {
            words
                .iter()
                .find(|word| word.0 == letter)
                .map(|word| word.1)
        };
        if word("M") == Some(2.0) {
            return moves;
        }
        let to = Point::new(word("X").unwrap(), word("Y").unwrap());
        moves.push(match word("G").unwrap() {
            0.0 => Move::Rapid,
            1.0 => Move::Line(Line::new(at, to).into()),
            code => Move::Arc {
                from: at,
                to,
                center: at + (word("I").unwrap(), word("J").unwrap()),
                clockwise: code == 2.0,
            },
        });
        at = to;
    }
    panic!("the program does not end: {text}")
}

/// How far it turns, in degrees: a whole turn where it ends where it starts.
fn sweep(from: Point, to: Point, center: Point, clockwise: bool) -> f64 {
    let sign = if clockwise { -1.0 } else { 1.0 };
    let turn = sign * ((to - center).atan2() - (from - center).atan2()).to_degrees();
    let turn = turn.rem_euclid(360.0);
    sign * if turn == 0.0 { 360.0 } else { turn }
}

#[test]
fn gcode_runs_along_the_very_circle() {
    for (arguments, center, radius, start, turn) in [
        ("circle 12.5", (0.0, 0.0), 12.5, 0.0, 360.0),
        (
            "circle 12.5 --reverse --center 3,-4",
            (3.0, -4.0),
            12.5,
            0.0,
            -360.0,
        ),
        (
            "circle 1234.567 --start 33",
            (0.0, 0.0),
            1234.567,
            33.0,
            360.0,
        ),
        (
            "arc 10 --start 350 --sweep 20",
            (0.0, 0.0),
            10.0,
            350.0,
            20.0,
        ),
        (
            "arc 10 --start 10 --sweep -270",
            (0.0, 0.0),
            10.0,
            10.0,
            -270.0,
        ),
        ("arc --through 0,1 1,0 0,-1", (0.0, 0.0), 1.0, 90.0, -180.0),
        (
            "arc --from 0,0 --to 10,0 --bulge 1",
            (5.0, 0.0),
            5.0,
            180.0,
            180.0,
        ),
        (
            "circle 5 --transform translate(1)rotate(30)scale(2,-2)",
            (1.0, 0.0),
            10.0,
            30.0,
            -360.0,
        ),
        ("arc 0.003 --sweep 90", (0.0, 0.0), 0.003, 0.0, 90.0),
    ] {
        for (precision, step) in [("", 1e-6 * radius), (" -p 3", 1e-3), (" -p 9", 1e-9)] {
            let text = printed(&format!("{arguments} -f gcode{precision}"));
            let (from, to, c, clockwise) = only_arc(&text);
            // Each of three points is rounded by half a step in each coordinate.
            let allowed = 3.0 * step;
            let truth = |degrees: f64| {
                Point::from(center) + Angle::from_degrees(degrees).direction() * radius
            };
            assert!(
                from.distance(truth(start)) <= allowed,
                "{arguments}{precision}: {from}"
            );
            assert!(
                to.distance(truth(start + turn)) <= allowed,
                "{arguments}{precision}: {to}"
            );
            assert!(
                c.distance(center.into()) <= allowed,
                "{arguments}{precision}: {c}"
            );
            let turned = sweep(from, to, c, clockwise);
            let slack = (allowed / radius).to_degrees();
            assert!(
                (turned - turn).abs() <= 2.0 * slack,
                "{arguments}{precision}: {turned}"
            );
        }
    }
}

#[test]
fn gcode_draws_lines_and_takes_a_feed_rate() {
    let line = gcode(&printed("arc --from 1,2 --to 10,5 --bulge 0 -f gcode"));
    let [Move::Rapid, Move::Line(line)] = line[..] else {
        panic!("{line:?}")
    };
    assert_eq!(
        (line.start(), line.end()),
        (Point::new(1.0, 2.0), Point::new(10.0, 5.0))
    );
    let program = printed("circle 5 -f gcode --feed 600");
    assert_eq!(program.matches(" F600").count(), 1);
    assert!(program.contains("\nG3 X5 Y0 I-5 J0 F600\n"), "{program}");
}

#[test]
fn gcode_of_what_has_no_arcs_is_refused() {
    for arguments in [
        "ellipse 5 3 -f gcode",
        "spline --points 0,0_1,2_3,1_4,4 -f gcode",
        "sphere 5 -f gcode",
        "circle 5 --transform scale(1,2) -f gcode",
        "circle 5 --feed 0 -f gcode",
        "circle 5 --feed 100 -f svg",
    ] {
        assert_eq!(run_words(arguments).status.code(), Some(2), "{arguments}");
    }
}

/// How far points are at most from the chords between other points.
fn apart(points: &[Point], others: &[Point]) -> f64 {
    let off = |p: &Point| {
        let to_chord = |ends: &[Point]| {
            let (along, at) = (ends[1] - ends[0], *p - ends[0]);
            let part = (at.dot(along) / along.hypot2()).clamp(0.0, 1.0);
            (at - along * part).hypot()
        };
        others
            .windows(2)
            .map(to_chord)
            .fold(f64::INFINITY, f64::min)
    };
    points.iter().map(off).fold(0.0, f64::max)
}

#[test]
fn gcode_states_how_far_rounding_moves_an_arc() {
    use crate::judges::random::Dice;
    const COUNT: i32 = 250;
    let mut dice = Dice(11);
    let samples = |center: Point, start: f64, turn: f64, radii: [f64; 2]| -> Vec<Point> {
        let at = |i: i32| {
            let part = f64::from(i) / f64::from(COUNT);
            let radius = radii[0] + part * (radii[1] - radii[0]);
            center + Angle::from_degrees(start + part * turn).direction() * radius
        };
        (0..=COUNT).map(at).collect()
    };
    let (mut needless, mut cases) = (0.0, 0.0);
    for i in 0..90 {
        let radius = dice.logarithmic(1.0, 40.0);
        let (center, start) = (dice.point(9.0), dice.within(0.0, 360.0));
        let turn = match i % 3 {
            0 => 360.0,
            1 => dice.within(-350.0, 350.0),
            _ => dice.within(5.0, 60.0),
        };
        let shape = if i % 3 == 0 {
            format!("circle {radius} --start={start}")
        } else {
            format!("arc {radius} --start={start} --sweep={turn}")
        };
        let words = format!("{shape} --center={},{} -f gcode -p 1", center.x, center.y);
        let text = printed(&words);
        let stated = text.split_once("moves it by up to ");
        let stated = stated.unwrap().1.split_once(')').unwrap().0;
        let stated: f64 = stated.parse().unwrap();
        let (from, to, c, clockwise) = only_arc(&text);
        let radii = [from, to].map(|end| end.distance(c));
        let turned = sweep(from, to, c, clockwise);
        let begin = (from - c).atan2().to_degrees();
        let drawn = samples(c, begin, turned, radii);
        let truth = samples(center, start, turn, [radius; 2]);
        let off = apart(&drawn, &truth).max(apart(&truth, &drawn));
        // By this the chords between samples are off.
        let step = radius * turn.abs().to_radians() / f64::from(COUNT);
        let sagitta = step * step / (8.0 * radius);
        assert!(off <= stated + 1.01 * sagitta, "{words}: {off} {stated}");
        (needless, cases) = (needless + stated / off, cases + 1.0);
    }
    assert!(needless / cases < 1.25, "{}", needless / cases);
}

#[test]
fn gcode_of_a_circle_is_within_what_rounding_really_does() {
    for (words, stated) in [
        ("circle 0.1875 -p 3 -t 0.001", "0.0005"),
        ("circle 6.35 -p 1 -t 0.06", "0.05"),
        ("circle 2.228 -p 1 -t 0.03", "0.028"),
    ] {
        let text = printed(&format!("{words} -f gcode"));
        let all = text.split_once("moves it by up to ").unwrap().1;
        let found: f64 = all.split_once(')').unwrap().0.parse().unwrap();
        let stated: f64 = stated.parse().unwrap();
        assert!(found >= stated && found < 1.01 * stated + 1e-9, "{text}");
    }
}
