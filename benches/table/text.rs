//! Lines of text in, path data or JSON out: `batch` beside the twenty lines that one would write around kurbo.

use std::hint::black_box;
use std::io::{BufRead, Cursor, Write};
use std::sync;

use curveto::batch::{self, Options};
use curveto::number::Precision;
use curveto::write::Format;
use curveto::{Cut, Tolerance};
use kurbo::{Arc, Circle, Ellipse, Shape, Vec2};

use super::numbers::Numbers;

/// Lines of one kind and what is asked of them.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    lines: sync::Arc<[u8]>,
    options: Options,
    /// With which kurbo takes about as many segments.
    tolerance: f64,
}

/// The cases, of so many lines each.
pub(crate) fn cases(count: usize) -> Vec<Case> {
    let mut numbers = Numbers(11);
    let mut lines = |line: fn(&mut Numbers) -> String| -> String {
        (0..count).map(|_| line(&mut numbers)).collect()
    };
    let circles = lines(|n| {
        let [x, y] = center(n);
        format!("circle {x:.3} {y:.3} {:.3}\n", n.uniform(1.0, 500.0))
    });
    let ellipses = lines(|n| {
        let [x, y] = center(n);
        let [rx, ry] = radii(n);
        format!("ellipse {x:.3} {y:.3} {rx:.3} {ry:.3} {:.3}\n", angle(n))
    });
    let arcs = lines(|n| arc(n, radii));
    let round = lines(|n| arc(n, |n| flat(n, 1.0, 6.0)));
    let flat = lines(|n| arc(n, |n| flat(n, 6.0, 50.0)));
    let plain = Options::default();
    let within = Options {
        cut: Cut::Tolerance(Tolerance::Absolute(0.01)),
        ..plain.clone()
    };
    let json = Options {
        format: Format::Json,
        ..plain.clone()
    };
    let thousandths = Options {
        precision: Some(Precision::Fixed(3)),
        ..plain.clone()
    };
    let case = |name, lines: &str, options: &Options, tolerance| Case {
        name,
        lines: lines.as_bytes().into(),
        options: options.clone(),
        tolerance,
    };
    vec![
        case("circles", &circles, &plain, 0.1),
        case("circles, `-t 0.01`", &circles, &within, 0.01),
        case("circles, JSON", &circles, &json, 0.1),
        case("elliptical arcs", &arcs, &plain, 0.1),
        case("elliptical arcs, `-p 3`", &arcs, &thousandths, 0.1),
        case("elliptical arcs, JSON", &arcs, &json, 0.1),
        case("elliptical arcs, `-t 0.01`", &arcs, &within, 0.01),
        case("those up to 1:6, `-t 0.01`", &round, &within, 0.01),
        case("those of 1:6 to 1:50, `-t 0.01`", &flat, &within, 0.01),
        case("ellipses", &ellipses, &plain, 0.1),
        case("ellipses, JSON", &ellipses, &json, 0.1),
        case("ellipses, `-t 0.01`", &ellipses, &within, 0.01),
    ]
}

fn center(numbers: &mut Numbers) -> [f64; 2] {
    [0; 2].map(|_| numbers.uniform(-1000.0, 1000.0))
}

fn radii(numbers: &mut Numbers) -> [f64; 2] {
    [0; 2].map(|_| numbers.uniform(1.0, 500.0))
}

/// Radii whose ratio lies between two.
fn flat(numbers: &mut Numbers, low: f64, high: f64) -> [f64; 2] {
    let large = numbers.uniform(50.0, 500.0);
    [large, large / numbers.uniform(low, high)]
}

fn angle(numbers: &mut Numbers) -> f64 {
    numbers.uniform(-180.0, 180.0)
}

fn arc(numbers: &mut Numbers, radii: impl Fn(&mut Numbers) -> [f64; 2]) -> String {
    let [x, y] = center(numbers);
    let [rx, ry] = radii(numbers);
    let (rotation, start) = (angle(numbers), angle(numbers));
    let sweep = numbers.uniform(-360.0, 360.0);
    format!("arc {x:.3} {y:.3} {rx:.3} {ry:.3} {rotation:.3} {start:.3} {sweep:.3}\n")
}

/// Answers the lines by `batch`, and counts the bytes.
pub(crate) fn ours(case: &Case) -> usize {
    let mut out = Vec::new();
    let lines = Cursor::new(case.lines.clone());
    batch::run(lines, &mut out, &case.options, |_, _| ()).expect("lines that can be drawn");
    black_box(out).len()
}

/// Answers them as path data by kurbo, and counts the bytes.
pub(crate) fn kurbos(case: &Case) -> usize {
    let mut out = Vec::new();
    for line in case.lines.lines() {
        let line = line.expect("text");
        let mut words = line.split(' ');
        let name = words.next();
        let n: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
        let center = (n[0], n[1]);
        let path = match name {
            Some("circle") => Circle::new(center, n[2]).to_path(case.tolerance),
            Some("ellipse") => {
                Ellipse::new(center, (n[2], n[3]), n[4].to_radians()).to_path(case.tolerance)
            }
            _ => Arc::new(
                center,
                Vec2::new(n[2], n[3]),
                n[5].to_radians(),
                n[6].to_radians(),
                n[4].to_radians(),
            )
            .to_path(case.tolerance),
        };
        writeln!(out, "{}", path.to_svg()).expect("memory takes it");
    }
    black_box(out).len()
}
