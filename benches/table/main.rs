//! One table of ours and the peers, in one process on the same inputs: `make bench`.
//!
//! Random elliptical arcs as cubics beside kurbo and `lyon_geom`, and real SVG icons beside usvg. The peers take turns, and the best of
//! many rounds counts, which a busy machine disturbs least. The ratio is to kurbo, and to usvg on documents.

// A benchmark may ask the platform's functions.
#![allow(clippy::disallowed_methods)]

mod documents;

use std::hint::black_box;
use std::time::Instant;

use curveto::measure::radial;
use curveto::shape::Truth;
use curveto::shape::endpoint::SvgArc;
use curveto::{Angle, Arc};
use kurbo::{CubicBez, PathEl, PathSeg, Point, Vec2};
use lyon_geom::{Angle as LyonAngle, ArcFlags, point, vector};

/// How many arcs; `CURVETO_BENCH_ARCS` overrides it.
const ARCS: usize = 1_000_000;
const ROUNDS: usize = 15;
/// Every so many arcs one is measured.
const SAMPLE: usize = 997;

/// Random numbers, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / 2f64.powi(53))
    }
}

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
            ours: Arc {
                center,
                radii,
                rotation: Angle::from_degrees(rotation),
                start: Angle::from_degrees(start),
                sweep: Angle::from_degrees(sweep),
                ends: None,
            },
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

/// What an arc costs and how many segments it becomes.
fn rows(form: &str, tolerance: f64, peers: [Box<dyn FnMut() -> (f64, f64) + '_>; 3]) {
    let best = best(peers);
    let [a, b, c] = best.map(|(time, _)| format!("{time:.1}"));
    let ratio = best[0].0 / best[1].0;
    println!("| {form}, {tolerance:e}: ns an arc | {a} | {b} | {c} | - | {ratio:.2} |");
    let [a, b, c] = best.map(|(_, segments)| format!("{segments:.3}"));
    let ratio = best[0].1 / best[1].1;
    println!("| {form}, {tolerance:e}: segments an arc | {a} | {b} | {c} | - | {ratio:.2} |");
}

/// What a byte of SVG costs and what becomes of it, parsed and written again, in one pass over each set of icons.
fn documents_rows() {
    let sets = documents::sets();
    if sets.is_empty() {
        println!("\nNo icons: `make corpora` fetches them.");
    }
    for (name, set) in sets {
        let bytes: usize = set.iter().map(String::len).sum();
        let run = |convert: fn(&str) -> usize| {
            let clock = Instant::now();
            let written = documents::pass(black_box(&set), convert);
            let elapsed = clock.elapsed().as_secs_f64() * 1e9;
            (elapsed / bytes as f64, written as f64 / bytes as f64)
        };
        let [a, b] = best([
            Box::new(|| run(documents::ours)),
            Box::new(|| run(documents::usvgs)),
        ]);
        let (time, size) = (a.0 / b.0, a.1 / b.1);
        let name = format!("{name}, one pass");
        println!(
            "| {name}: ns a byte | {:.2} | - | - | {:.2} | {time:.2} |",
            a.0, b.0
        );
        println!(
            "| {name}: bytes out a byte in | {:.2} | - | - | {:.2} | {size:.2} |",
            a.1, b.1
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

fn centre_row(inputs: &[Input], tolerance: f64) {
    let ours: Vec<_> = inputs.iter().map(|input| input.ours).collect();
    let kurbo: Vec<_> = inputs.iter().map(|input| input.kurbo).collect();
    let lyon: Vec<_> = inputs.iter().map(|input| input.lyon).collect();
    rows(
        "centre",
        tolerance,
        [
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
    rows(
        "SVG end points",
        tolerance,
        [
            Box::new(|| {
                clock(&ours, |arc, sum| {
                    let cubics = arc.cubics(tolerance * arc.radii.x.max(arc.radii.y));
                    if let Some(cubics) = cubics {
                        for c in cubics {
                            sum.take(c.p1, c.p2, c.p3);
                        }
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
    println!("| what, relative tolerance | ours | kurbo | lyon_geom | usvg | ratio |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    for tolerance in [1e-3, 1e-6] {
        centre_row(&inputs, tolerance);
        svg_row(&inputs, tolerance);
    }
    errors(&inputs);
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
        println!(
            "| largest relative error, {tolerance:e} | {ours:.2e} | {kurbo:.2e} | {lyon:.2e} | - | {:.2} |",
            ours / kurbo
        );
    }
}
