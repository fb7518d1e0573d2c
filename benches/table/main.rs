//! One table of ours and the peers, in one process on the same inputs: `make bench`.
//!
//! Random elliptical arcs as cubics beside kurbo and `lyon_geom`, and real SVG icons beside usvg. The peers take turns, and the best of
//! many rounds counts, which a busy machine disturbs least. The ratio is to kurbo, and to usvg on documents.

// A benchmark may ask the platform's functions.
#![allow(clippy::disallowed_methods, clippy::expect_used)]

mod documents;
#[path = "../common/numbers.rs"]
mod numbers;
mod text;

use std::hint::black_box;
use std::time::Instant;

use curveto::engine::{Instructions, ManyCubics, cubics_of_arcs, cubics_of_svg_arcs};
use curveto::measure::radial;
use curveto::shape::Truth;
use curveto::shape::endpoint::SvgArc;
use curveto::{Angle, Arc, Tolerance};
use kurbo::{CubicBez, PathEl, PathSeg, Point, Vec2};
use lyon_geom::{Angle as LyonAngle, ArcFlags, point, vector};
use numbers::Numbers;

/// How many arcs; `CURVETO_BENCH_ARCS` overrides it.
const ARCS: usize = 1_000_000;
const ROUNDS: usize = 15;
/// How many lines of text of each kind.
const LINES: usize = 20_000;
/// Every so many arcs one is measured.
const SAMPLE: usize = 997;

/// One arc in the form of each peer.
struct Input {
    ours: Arc,
    kurbo: kurbo::Arc,
    lyon: lyon_geom::Arc<f64>,
    ours_svg: SvgArc,
    kurbo_svg: kurbo::SvgArc,
    lyon_svg: lyon_geom::SvgArc<f64>,
}

impl Input {
    fn random(numbers: &mut Numbers) -> Self {
        let center = Point::new(
            numbers.uniform(-1000.0, 1000.0),
            numbers.uniform(-1000.0, 1000.0),
        );
        let radii = Vec2::new(numbers.uniform(1.0, 500.0), numbers.uniform(1.0, 500.0));
        let rotation = numbers.uniform(-180.0, 180.0);
        let start = numbers.uniform(-180.0, 180.0);
        let sweep = numbers.uniform(-360.0, 360.0);
        let kurbo = kurbo::Arc::new(
            center,
            radii,
            start.to_radians(),
            sweep.to_radians(),
            rotation.to_radians(),
        );
        let at = |angle: f64| {
            let (sin, cos) = angle.to_radians().sin_cos();
            let v = Vec2::new(radii.x * cos, radii.y * sin);
            let (sin, cos) = rotation.to_radians().sin_cos();
            center + Vec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
        };
        let (from, to) = (at(start), at(start + sweep));
        let (large_arc, positive) = (sweep.abs() > 180.0, sweep > 0.0);
        Self {
            ours: Arc::new(
                center,
                radii,
                Angle::from_degrees(rotation),
                Angle::from_degrees(start),
                Angle::from_degrees(sweep),
            )
            .expect("an arc that can be drawn"),
            kurbo,
            lyon: lyon_geom::Arc {
                center: point(center.x, center.y),
                radii: vector(radii.x, radii.y),
                start_angle: LyonAngle::degrees(start),
                sweep_angle: LyonAngle::degrees(sweep),
                x_rotation: LyonAngle::degrees(rotation),
            },
            ours_svg: SvgArc {
                from,
                radii,
                rotation: Angle::from_degrees(rotation),
                large_arc,
                sweep: positive,
                to,
            },
            kurbo_svg: kurbo::SvgArc {
                from,
                to,
                radii,
                x_rotation: rotation.to_radians(),
                large_arc,
                sweep: positive,
            },
            lyon_svg: lyon_geom::SvgArc {
                from: point(from.x, from.y),
                to: point(to.x, to.y),
                radii: vector(radii.x, radii.y),
                x_rotation: LyonAngle::degrees(rotation),
                flags: ArcFlags {
                    large_arc,
                    sweep: positive,
                },
            },
        }
    }

    fn truth(&self) -> Truth {
        Truth::new(
            self.ours.center,
            self.ours.radii,
            self.ours.rotation.direction(),
        )
    }
}

/// Gives the points of an arc at a relative tolerance.
type Peer = fn(&Input, f64, &mut dyn FnMut(Point, Point, Point, Point));

/// Takes points without being optimised away: their sum, and how many segments there were.
#[derive(Default)]
struct Sum {
    sum: f64,
    segments: usize,
}

impl Sum {
    #[inline]
    fn take(&mut self, a: Point, b: Point, c: Point) {
        self.sum += a.x + a.y + b.x + b.y + c.x + c.y;
        self.segments += 1;
    }

    #[inline]
    fn take_lyon(&mut self, c: &lyon_geom::CubicBezierSegment<f64>) {
        let p = |p: lyon_geom::Point<f64>| Point::new(p.x, p.y);
        self.take(p(c.ctrl1), p(c.ctrl2), p(c.to));
    }
}

/// The time of one run over all arcs that a peer has in a list of its own, and how many segments they became.
fn clock<T>(arcs: &[T], run: impl Fn(&T, &mut Sum)) -> (f64, f64) {
    let clock = Instant::now();
    let mut sum = Sum::default();
    for arc in arcs {
        run(arc, &mut sum);
    }
    let elapsed = clock.elapsed().as_secs_f64() * 1e9;
    black_box(sum.sum);
    let count = arcs.len() as f64;
    (elapsed / count, sum.segments as f64 / count)
}

/// The best round of each peer, who take turns.
fn best<const N: usize>(mut peers: [Box<dyn FnMut() -> (f64, f64) + '_>; N]) -> [(f64, f64); N] {
    let mut best = [(f64::INFINITY, 0.0); N];
    for _ in 0..ROUNDS {
        for (best, peer) in best.iter_mut().zip(&mut peers) {
            let round = peer();
            if round.0 < best.0 {
                *best = round;
            }
        }
    }
    best
}

/// Whoever draws all arcs, and what one of them costs and becomes.
type Run<'a> = Box<dyn FnMut() -> (f64, f64) + 'a>;

/// What an arc costs and how many segments it becomes.
fn rows(form: &str, tolerance: f64, [lanes, plain, single, kurbo, lyon]: [Run; 5]) {
    let best = best([lanes, plain, single, kurbo, lyon]);
    let to_kurbo = |i: usize, of: fn(&(f64, f64)) -> f64| of(&best[i]) / of(&best[3]);
    let [a, b, c, d, e] = best.map(|(time, _)| format!("{time:.1}"));
    let [lanes, plain, single] = [0, 1, 2].map(|i| to_kurbo(i, |run| run.0));
    println!(
        "| {form}, {tolerance:e}: ns an arc | {a} | {b} | {c} | {d} | {e} | {lanes:.2} | {plain:.2} | {single:.2} |"
    );
    let [a, b, c, d, e] = best.map(|(_, segments)| format!("{segments:.3}"));
    let [lanes, plain, single] = [0, 1, 2].map(|i| to_kurbo(i, |run| run.1));
    println!(
        "| {form}, {tolerance:e}: segments an arc | {a} | {b} | {c} | {d} | {e} | {lanes:.2} | {plain:.2} | {single:.2} |"
    );
}

/// What a byte of SVG costs and what becomes of it, parsed and written again, in one pass over each set of icons: in a thread that has
/// met none of them, and in one that has.
fn documents_rows() {
    let sets = documents::sets();
    if sets.is_empty() {
        println!("\nNo icons: `make corpora` fetches them.");
        return;
    }
    println!("\n| one pass | cold | warm | usvg | usvg / cold | usvg / warm |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    for (name, set) in sets {
        let bytes: usize = set.iter().map(String::len).sum();
        let run = |pass: &dyn Fn() -> usize| {
            let clock = Instant::now();
            let written = pass();
            let elapsed = clock.elapsed().as_secs_f64() * 1e9;
            (elapsed / bytes as f64, written as f64 / bytes as f64)
        };
        let best = best([
            Box::new(|| run(&|| documents::cold(black_box(&set), documents::ours))),
            Box::new(|| run(&|| documents::warm(black_box(&set), documents::ours))),
            Box::new(|| run(&|| documents::cold(black_box(&set), documents::usvgs))),
        ]);
        for (what, [a, b, c]) in [
            ("ns a byte", best.map(|run| run.0)),
            ("bytes out a byte in", best.map(|run| run.1)),
        ] {
            let (cold, warm) = (c / a, c / b);
            println!("| {name}: {what} | {a:.2} | {b:.2} | {c:.2} | {cold:.2} | {warm:.2} |");
        }
    }
}

/// What a line of text costs and how long its answer is, on one thread.
fn text_rows() {
    println!(
        "\n| lines of text | ours, us a line | kurbo | ours / kurbo | lines a second | bytes out / kurbo's |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    for case in text::cases(LINES) {
        let run = |answer: fn(&text::Case) -> usize| {
            let clock = Instant::now();
            let written = answer(black_box(&case));
            (
                clock.elapsed().as_secs_f64() * 1e6 / LINES as f64,
                written as f64,
            )
        };
        let [ours, kurbo] = best([Box::new(|| run(text::ours)), Box::new(|| run(text::kurbos))]);
        println!(
            "| {} | {:.2} | {:.2} | {:.2} | {:.0} | {:.2} |",
            case.name,
            ours.0,
            kurbo.0,
            ours.0 / kurbo.0,
            1e6 / ours.0,
            ours.1 / kurbo.1
        );
    }
}

fn kurbo_arc(arc: &kurbo::Arc, tolerance: f64, sum: &mut Sum) {
    for el in arc.append_iter(tolerance * arc.radii.x.max(arc.radii.y)) {
        if let PathEl::CurveTo(a, b, c) = el {
            sum.take(a, b, c);
        }
    }
}

/// The time of one run over all arcs in lanes.
fn clock_lanes<C: Iterator<Item = CubicBez>>(
    lanes: impl ExactSizeIterator<Item = C>,
) -> (f64, f64) {
    let count = lanes.len() as f64;
    let clock = Instant::now();
    let mut sum = Sum::default();
    for cubics in lanes {
        for c in cubics {
            sum.take(c.p1, c.p2, c.p3);
        }
    }
    let elapsed = clock.elapsed().as_secs_f64() * 1e9;
    black_box(sum.sum);
    (elapsed / count, sum.segments as f64 / count)
}

fn centre_row(inputs: &[Input], tolerance: f64) {
    let ours: Vec<_> = inputs.iter().map(|input| input.ours).collect();
    let kurbo: Vec<_> = inputs.iter().map(|input| input.kurbo).collect();
    let lyon: Vec<_> = inputs.iter().map(|input| input.lyon).collect();
    let lanes = || cubics_of_arcs(&ours, Tolerance::Relative(tolerance));
    rows(
        "centre",
        tolerance,
        [
            Box::new(|| clock_lanes(lanes())),
            Box::new(|| clock_lanes(lanes().at_most(Instructions::Target))),
            Box::new(|| {
                clock(&ours, |arc, sum| {
                    for c in arc.cubics(tolerance * arc.radii.x.max(arc.radii.y)) {
                        sum.take(c.p1, c.p2, c.p3);
                    }
                })
            }),
            Box::new(|| clock(&kurbo, |arc, sum| kurbo_arc(arc, tolerance, sum))),
            Box::new(|| {
                clock(&lyon, |arc, sum| {
                    arc.for_each_cubic_bezier(&mut |c| sum.take_lyon(c));
                })
            }),
        ],
    );
}

fn svg_row(inputs: &[Input], tolerance: f64) {
    let ours: Vec<_> = inputs.iter().map(|input| input.ours_svg).collect();
    let kurbo: Vec<_> = inputs.iter().map(|input| input.kurbo_svg).collect();
    let lyon: Vec<_> = inputs.iter().map(|input| input.lyon_svg).collect();
    let lanes = || cubics_of_svg_arcs(&ours, Tolerance::Relative(tolerance));
    let drawn = |lanes: ManyCubics<'_, SvgArc>| clock_lanes(lanes.map(|c| c.into_iter().flatten()));
    rows(
        "SVG end points",
        tolerance,
        [
            Box::new(|| drawn(lanes())),
            Box::new(|| drawn(lanes().at_most(Instructions::Target))),
            Box::new(|| {
                clock(&ours, |arc, sum| {
                    let cubics = arc.cubics(tolerance * arc.radii.x.max(arc.radii.y));
                    for c in cubics.into_iter().flatten() {
                        sum.take(c.p1, c.p2, c.p3);
                    }
                })
            }),
            Box::new(|| {
                clock(&kurbo, |arc, sum| {
                    if let Some(arc) = kurbo::Arc::from_svg_arc(arc) {
                        kurbo_arc(&arc, tolerance, sum);
                    }
                })
            }),
            Box::new(|| {
                clock(&lyon, |arc, sum| {
                    arc.for_each_cubic_bezier(&mut |c| sum.take_lyon(c));
                })
            }),
        ],
    );
}

fn main() {
    let count = std::env::var("CURVETO_BENCH_ARCS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(ARCS);
    let mut numbers = Numbers(7);
    let inputs: Vec<Input> = (0..count).map(|_| Input::random(&mut numbers)).collect();
    println!("{count} random elliptical arcs, best of {ROUNDS} rounds");
    println!(
        "| what, relative tolerance | lanes | lanes, any processor | one by one | kurbo | lyon_geom | lanes / kurbo | any / kurbo | one / kurbo |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
    for tolerance in [1e-3, 1e-6] {
        centre_row(&inputs, tolerance);
        svg_row(&inputs, tolerance);
    }
    errors(&inputs);
    text_rows();
    documents_rows();
}

/// The largest relative error of each peer on a sample.
fn errors(inputs: &[Input]) {
    for tolerance in [1e-3, 1e-6] {
        let worst = |peer: Peer| {
            inputs
                .iter()
                .step_by(SAMPLE)
                .map(|input| {
                    let truth = input.truth();
                    let mut segments = Vec::new();
                    peer(input, tolerance, &mut |a, b, c, d| {
                        segments.push(PathSeg::Cubic(CubicBez::new(a, b, c, d)));
                    });
                    radial::error(&segments, &truth).peak() / truth.larger_radius()
                })
                .fold(0.0, f64::max)
        };
        let ours = worst(|input, tolerance, take| {
            let radius = input.ours.radii.x.max(input.ours.radii.y);
            input
                .ours
                .cubics(tolerance * radius)
                .for_each(|c| take(c.p0, c.p1, c.p2, c.p3));
        });
        let kurbo = worst(|input, tolerance, take| {
            let radius = input.ours.radii.x.max(input.ours.radii.y);
            kurbo::Shape::path_segments(&input.kurbo, tolerance * radius).for_each(|segment| {
                if let PathSeg::Cubic(c) = segment {
                    take(c.p0, c.p1, c.p2, c.p3);
                }
            });
        });
        let lyon = worst(|input, _, take| {
            let p = |p: lyon_geom::Point<f64>| Point::new(p.x, p.y);
            input
                .lyon
                .for_each_cubic_bezier(&mut |c| take(p(c.from), p(c.ctrl1), p(c.ctrl2), p(c.to)));
        });
        let ratio = ours / kurbo;
        println!(
            "| largest relative error, {tolerance:e} | {ours:.2e} | {ours:.2e} | {ours:.2e} | {kurbo:.2e} | {lyon:.2e} | {ratio:.2} | {ratio:.2} | {ratio:.2} |"
        );
    }
}
