//! Time per number of the formatter, against the standard library, zmij and ryu: `cargo bench --bench number`.

// A benchmark may ask the platform's functions.
#![allow(clippy::disallowed_methods)]

#[path = "common/numbers.rs"]
mod numbers;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use curveto::number::{push_fixed, push_shortest, round};
use numbers::Numbers;
use std::hint::black_box;
use std::io::Write as _;

const COUNT: usize = 4096;

/// Coordinates of circles: the handles and joints of random centres and radii.
fn coordinates() -> Vec<f64> {
    let mut numbers = Numbers(1);
    let mut uniform = || numbers.uniform(0.0, 1.0);
    let mut out = Vec::with_capacity(COUNT);
    while out.len() < COUNT {
        let (center, radius) = (2000.0 * uniform() - 1000.0, 100.0 * uniform());
        out.extend([
            center,
            center + radius,
            center - radius * 0.551_915_02,
            radius * uniform(),
        ]);
    }
    out
}

fn number(c: &mut Criterion) {
    let numbers = coordinates();
    let mut out = Vec::with_capacity(32 * COUNT);
    let mut group = c.benchmark_group("number");
    group.throughput(Throughput::Elements(COUNT as u64));
    let mut run = |name: String, push: &dyn Fn(&mut Vec<u8>, f64)| {
        group.bench_function(name, |b| {
            b.iter(|| {
                out.clear();
                for &x in &numbers {
                    push(&mut out, x);
                }
                black_box(out.len())
            });
        });
    };
    for decimals in [0_u8, 3, 6, 8, 12, 17] {
        run(format!("fixed/{decimals}"), &|out, x| {
            push_fixed(out, x, decimals);
        });
        run(format!("fixed/{decimals}/std"), &|out, x| {
            drop(write!(out, "{x:.*}", usize::from(decimals)));
        });
    }
    run("round/3".into(), &|_, x| _ = black_box(round(x, 3)));
    run("shortest".into(), &push_shortest);
    run("shortest/zmij".into(), &|out, x| {
        out.extend_from_slice(zmij::Buffer::new().format_finite(x).as_bytes());
    });
    run("shortest/ryu".into(), &|out, x| {
        out.extend_from_slice(ryu::Buffer::new().format_finite(x).as_bytes());
    });
    run("shortest/std".into(), &|out, x| drop(write!(out, "{x}")));
    group.finish();
}

criterion_group!(benches, number);
criterion_main!(benches);
