//! What the drawing of a conic states of its error, against 256-bit arithmetic: parabolas, hyperbolas and ellipses next to them, sharp
//! and flat ones, far away and moved by a map.

use std::fmt::Write as _;

use crate::judges::exact::decimal_point;
use crate::judges::oracle::conic::Branch;
use crate::judges::oracle::{Point, Real, decimal, int, real, to_f64};
use crate::judges::random::{Dice, uniform};
use curveto::conic::Conic;
use curveto::curve::control_points;
use curveto::kurbo;
use curveto::number::Precision;
use curveto::{Cut, Method, Options};
use kurbo::Affine;
use rayon::prelude::*;

const METHODS: [Method; 4] = [
    Method::Minimax,
    Method::Midpoint,
    Method::Goldapp,
    Method::Curvature,
];

#[derive(Debug)]
struct Case {
    conic: Conic,
    options: Options,
}

fn case(dice: &mut Dice) -> Option<Case> {
    let size = dice.logarithmic(1e-3, 1e3);
    let away = match dice.within(0.0, 3.0) as u8 {
        0 => dice.logarithmic(1.0, 1e6) * size,
        _ => size,
    };
    let away = dice.point(away).to_vec2();
    let [from, mut control, mut to] = [(); 3].map(|()| dice.point(size) + away);
    // Thin triangles: both ends side by side, the control point at one of them, or all three in a row.
    let thin = dice.logarithmic(1e-8, 1.0);
    match dice.within(0.0, 6.0) as u8 {
        0 => to = from + thin * (to - from),
        1 => control = from + thin * (control - from),
        2 => {
            let along = dice.within(-2.0, 3.0) * (to - from);
            control = from + along + thin * (control - from);
        }
        _ => {}
    }
    let weight = match dice.within(0.0, 5.0) as u8 {
        4 => 1.0,
        0 => dice.within(0.9999, 1.0001),
        1 => 1.0 + dice.logarithmic(1e-6, 1.0),
        2 => dice.logarithmic(1.0, 100.0),
        _ => dice.logarithmic(1.0, 1e9),
    };
    let transform = match dice.within(0.0, 3.0) as u8 {
        0 => {
            let [a, b, c, d] = [(); 4].map(|()| dice.within(-2.0, 2.0));
            let moved = dice.point(100.0);
            Affine::new([a, b, c, d, moved.x, moved.y])
        }
        _ => Affine::IDENTITY,
    };
    let options = Options {
        rule: METHODS[dice.within(0.0, 4.0) as usize].into(),
        cut: Cut::Count(dice.within(1.0, 9.0) as usize),
        precision: match dice.within(0.0, 4.0) as u8 {
            0 => None,
            1 => Some(Precision::Full),
            _ => Some(Precision::Fixed(dice.within(0.0, 9.0) as u8)),
        },
        transform,
    };
    let conic = Conic::new(from, control, to, weight).ok()?;
    Some(Case { conic, options })
}

struct Verdict {
    /// The least of stated over true, less 1.
    least: f64,
    /// By how many units in the last place, beyond a billionth of the error, the most is stated beyond the truth.
    beyond: f64,
    is_sharp: bool,
    words: String,
}

fn branch(case: &Case, fineness: u32) -> Branch {
    let [a, b, c, d, e, f] = case.options.transform.as_coeffs().map(real);
    let conic = &case.conic;
    let points = [conic.from, conic.control, conic.to].map(|p| -> Point {
        let [x, y] = decimal_point(p);
        [&a * &x + &c * &y + &e, &b * &x + &d * &y + &f]
    });
    Branch::new(points, decimal(conic.weight), fineness)
}

fn judge(case: &Case, fineness: u32) -> Option<Verdict> {
    let drawing = case.conic.draw(&case.options).ok()?;
    let branch = branch(case, fineness);
    let mut largest = 0.0_f64;
    let segments: Vec<Vec<Point>> = drawing
        .curve
        .segments
        .iter()
        .map(|segment| {
            let points = control_points(segment).into_iter().map(|p| {
                largest = largest.max(p.x.abs()).max(p.y.abs());
                decimal_point(p)
            });
            points.collect()
        })
        .collect();
    let mut truth = [int(0), int(0)];
    for points in &segments {
        for (truth, found) in truth.iter_mut().zip(branch.extremes(points)) {
            if found > *truth {
                *truth = found;
            }
        }
    }
    // What is stated of a sharp tip is one figure for both ways.
    let is_sharp = drawing.error.outward == drawing.error.inward;
    let mut most = truth.clone();
    let back = branch.back(&segments, is_sharp);
    let there = truth.iter().map(to_f64).fold(0.0, f64::max);
    // By the digits of `f64`, of which a hairpin leaves fewer.
    let less = back * (1.0 - 1e-12) - 256.0 * f64::EPSILON * largest;
    if is_sharp {
        truth = [(); 2].map(|()| real(there.max(less)));
        most = [(); 2].map(|()| real(there.max(back)));
    }
    let unit = largest.next_up() - largest;
    let mut verdict = Verdict {
        least: f64::INFINITY,
        beyond: f64::NEG_INFINITY,
        is_sharp,
        words: String::new(),
    };
    let stated = [drawing.error.outward, drawing.error.inward];
    assert!(drawing.error.peak().is_finite(), "{case:?}");
    for (i, stated) in stated.into_iter().enumerate() {
        let above = |truth: &Real| to_f64(&(real(stated) - truth));
        let (excess, truth) = (above(&truth[i]), to_f64(&truth[i]));
        if truth > unit * 2.0_f64.powi(-42) {
            verdict.least = verdict.least.min(excess / truth);
        }
        let beyond = above(&most[i]) - 1e-9 * to_f64(&most[i]);
        verdict.beyond = verdict.beyond.max(beyond / unit);
        let _ = write!(verdict.words, "{stated:e} stated, {truth:e} true; ");
    }
    if less > drawing.error.peak() {
        verdict.least = verdict.least.min(drawing.error.peak() / less - 1.0);
        let _ = write!(verdict.words, "{less:e} back; ");
    }
    let _ = write!(
        verdict.words,
        "least {:e}, {:.1} beyond; {:?} {:?}",
        verdict.least, verdict.beyond, case.conic, case.options
    );
    Some(verdict)
}

/// Draws so many cases and prints the worst of those whose tip is sharper than the error, and of the others.
fn campaign(count: u64, seed: u64, fineness: u32) -> Vec<Verdict> {
    let verdicts: Vec<Verdict> = (0..count)
        .into_par_iter()
        .filter_map(|i| {
            let mut dice = Dice(seed + 1_000_003 * i);
            for _ in 0..8 {
                uniform(&mut dice.0);
            }
            judge(&case(&mut dice)?, fineness)
        })
        .collect();
    // Refused are what a precision leaves no points of.
    assert!(2 * verdicts.len() as u64 > count, "{}", verdicts.len());
    assert!(verdicts.iter().any(|v| !v.is_sharp));
    for is_sharp in [false, true] {
        let of = || verdicts.iter().filter(|v| v.is_sharp == is_sharp);
        let least = of().map(|v| v.least).fold(f64::INFINITY, f64::min);
        let beyond = of().map(|v| v.beyond).fold(f64::NEG_INFINITY, f64::max);
        println!(
            "{} conics, sharp {is_sharp}: stated over true at least 1 {least:+.1e}, below in {}; beyond a billionth at most {beyond:.1} units",
            of().count(),
            of().filter(|v| v.least < 0.0).count(),
        );
    }
    verdicts
}

/// What is wrong: below the truth, or farther above it than the guarantee says. Of sharp tips the judge's own search may miss the peak, so
/// that only the first is held of them.
fn wrong(verdicts: &[Verdict]) -> Vec<&str> {
    let is_wrong = |v: &&Verdict| v.least < 0.0 || v.beyond > 4.0 && !v.is_sharp;
    let wrong = verdicts.iter().filter(is_wrong);
    wrong.map(|v| v.words.as_str()).collect()
}

/// Conics whose error was stated five times too small twice, as infinite, right where the judge was wrong twice, and 200 units in the last place
/// too large.
#[test]
fn what_is_stated_of_sharp_conics_is_a_bound() {
    let cases = [
        (
            [
                (-0.022_999_049_252_273_595, -0.007_563_157_332_876_855_5),
                (-0.147_035_374_973_079_72, -0.044_768_475_253_520_54),
                (-0.139_829_520_979_552_3, 0.014_594_507_716_917_188),
            ],
            816_432_891.639_048_1,
            Method::Minimax,
            5,
            Precision::Fixed(5),
        ),
        (
            [
                (0.003_279_085_245_344_403, 0.001_978_263_841_418_905_5),
                (-0.000_906_593_742_459_123_3, 0.000_963_251_764_508_596_2),
                (-0.000_288_019_789_756_842_4, 0.002_728_636_696_921_464_5),
            ],
            56_131_813.094_833_91,
            Method::Curvature,
            7,
            Precision::Full,
        ),
        // The error has its peak over the two thousandth of a segment beside the tip, a third of the radius there.
        (
            [
                (-353.100_612_169_345_5, -473.961_566_441_165_7),
                (-213.496_727_301_535_63, -391.167_501_409_559_8),
                (-352.751_790_479_681_86, -473.742_358_605_828_03),
            ],
            5.817_692_754_660_545,
            Method::Minimax,
            8,
            Precision::Full,
        ),
        // Near an end the curve is on the other side by less than a billionth.
        (
            [
                (0.135_636_563_295_255_92, -0.362_250_723_720_186_85),
                (0.113_750_248_069_668_74, -0.330_862_843_430_957_45),
                (-0.095_261_808_379_701_88, -0.031_111_838_222_118_993),
            ],
            1.141_759_671_778_414_4,
            Method::Minimax,
            3,
            Precision::Fixed(2),
        ),
        (
            [(-40.0, 7.0), (10.0, 60.0), (12.0, -3.0)],
            2.5,
            Method::Midpoint,
            8,
            Precision::Full,
        ),
        // The drawing lies by the other leg of the whole parabola.
        (
            [(50.0, 0.32), (100.0, 0.38), (200.0, 0.44)],
            1.0,
            Method::Minimax,
            1,
            Precision::Fixed(0),
        ),
    ];
    for case in cases {
        assert_bound(case);
    }
}

/// Triangles of which nothing was stated, or after minutes, while the search came to no end where they are thinner than the error.
#[test]
fn what_is_stated_of_thin_triangles_is_a_bound() {
    let thin = [(0.0, 0.0), (100.0, 100.0), (0.01, 0.0)];
    let thinner = [
        (-0.731_301_012_423_247_7, -0.274_971_817_499_230_8),
        (89.523_030_887_959_2, 61.244_718_844_249_08),
        (-0.731_299_832_176_637, -0.274_971_252_923_950_86),
    ];
    let flat = [
        (0.0, 0.0),
        (-2.979_551_596_278_744, 3.989_525_324_385_637e-5),
        (6.199_690_150_549_655, -2.009_761_648_629_191_8e-5),
    ];
    for case in [
        (thin, 4.0, Method::Minimax, 2, Precision::Fixed(3)),
        (thin, 1e4, Method::Minimax, 3, Precision::Fixed(1)),
        (thinner, 1.598, Method::Goldapp, 3, Precision::Full),
        (flat, 122_191.93, Method::Minimax, 2, Precision::Fixed(0)),
    ] {
        assert_bound(case);
    }
}

type Known = ([(f64, f64); 3], f64, Method, usize, Precision);

fn assert_bound(([from, control, to], weight, method, count, precision): Known) {
    let conic = Conic::new(from.into(), control.into(), to.into(), weight).unwrap();
    let options = Options {
        rule: method.into(),
        cut: Cut::Count(count),
        precision: Some(precision),
        ..Options::default()
    };
    let verdict = judge(&Case { conic, options }, 1).unwrap();
    assert!(
        verdict.least >= 0.0 && verdict.beyond <= 4.0,
        "{}",
        verdict.words
    );
}

#[test]
fn what_is_stated_of_conics_is_a_bound() {
    let verdicts = campaign(10, 3, 1);
    assert_eq!(wrong(&verdicts), [""; 0]);
}

#[test]
#[ignore = "takes many minutes: make truth"]
fn what_is_stated_of_conics_is_a_bound_in_many_cases() {
    let number = |name: &str| std::env::var(name).ok().and_then(|n| n.parse().ok());
    let count = number("CURVETO_CASES").unwrap_or(4_000);
    let verdicts = campaign(count, number("CURVETO_SEED").unwrap_or(2), 10);
    let wrong = wrong(&verdicts);
    let first = &wrong[..wrong.len().min(8)];
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        first.join("\n")
    );
}
