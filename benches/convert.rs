//! `document::convert` beside the usvg library (parse and write) on real icon sets: `make bench-convert`.
//!
//! Throughput on one thread, the files in memory, and what the output weighs in times of the input. `curveto` runs in a thread
//! that goes over the same files again and again, and so has met their arcs before; `curveto-anew` begins every pass in a new
//! thread, which has met none. `one-file` is one document of both sets, gone over again from the first icon on until it holds
//! as many icons as some collections on the web.

#![allow(clippy::unwrap_used, clippy::format_collect)]

use std::hint::black_box;
use std::path::Path;
use std::thread;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use curveto::document::{self, Options};
use resvg::usvg;

const SETS: [(&str, &str); 2] = [
    ("lucide", "lucide-static-1.62.0"),
    ("bootstrap-icons", "bootstrap-icons-1.13.2"),
];

fn files(folder: &str) -> Option<Vec<String>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpora")
        .join(folder)
        .join("package/icons");
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .ok()?
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "svg"));
    paths.sort();
    Some(
        paths
            .iter()
            .map(|path| std::fs::read_to_string(path).unwrap())
            .collect(),
    )
}

/// How many icons the one file holds.
const ICONS_IN_ONE_FILE: usize = 7_000;

/// One document of many, each as a group.
fn concatenated<'a>(files: impl Iterator<Item = &'a String>) -> String {
    let groups: String = files
        .map(|file| {
            let start = file.find("<svg").unwrap();
            let inner = start + file[start..].find('>').unwrap() + 1;
            format!("<g>{}</g>\n", &file[inner..file.rfind("</svg>").unwrap()])
        })
        .collect();
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 24 24\">\n{groups}</svg>\n")
}

fn ours(text: &str) -> usize {
    document::convert(text, &Options::default())
        .unwrap()
        .text
        .len()
}

fn usvgs(text: &str) -> usize {
    usvg::Tree::from_str(text, &usvg::Options::default())
        .unwrap()
        .to_string(&usvg::WriteOptions::default())
        .len()
}

fn compare(criterion: &mut Criterion, name: &str, files: &[String]) {
    let bytes: usize = files.iter().map(String::len).sum();
    for (tool, convert) in [("curveto", ours as fn(&str) -> usize), ("usvg", usvgs)] {
        let written: usize = files.iter().map(|file| convert(file)).sum();
        println!(
            "{name}: {tool} writes {:.4} times the input of {bytes} bytes",
            written as f64 / bytes as f64
        );
    }
    let mut group = criterion.benchmark_group(name);
    group
        .throughput(Throughput::Bytes(bytes as u64))
        .sample_size(20)
        .measurement_time(Duration::from_secs(5));
    let pass = |convert: fn(&str) -> usize| -> usize {
        files.iter().map(|file| convert(black_box(file))).sum()
    };
    group.bench_function("curveto", |bencher| bencher.iter(|| pass(ours)));
    group.bench_function("curveto-anew", |bencher| {
        bencher.iter(|| thread::scope(|scope| scope.spawn(|| pass(ours)).join().unwrap()));
    });
    group.bench_function("usvg", |bencher| bencher.iter(|| pass(usvgs)));
    group.finish();
}

fn corpora(criterion: &mut Criterion) {
    let mut all = Vec::new();
    for (name, folder) in SETS {
        let Some(files) = files(folder) else {
            println!("{folder} is not there: `make corpora` fetches it");
            return;
        };
        compare(criterion, name, &files);
        all.extend(files);
    }
    compare(criterion, "both", &all);
    let icons = all.iter().cycle().take(ICONS_IN_ONE_FILE);
    compare(criterion, "one-file", &[concatenated(icons)]);
}

criterion_group!(benches, corpora);
criterion_main!(benches);
