//! What the search for the fewest segments costs.

use super::*;
use crate::joints::adaptive::LOOKS;
use crate::joints::adaptive::costs::{arcs, even};
use crate::{Angle, Arc};

/// A method, the flatnesses of ellipses, whether decimals are fixed, and how many there are; what the search costs at most, and the segments
/// of all.
type CostCase = (Method, [f64; 2], bool, usize, [usize; 2], usize);

fn cost_little(groups: &[CostCase]) {
    for &(method, flat, is_fixed, shapes, most, segments) in groups {
        let (mut costs, mut count) = ([0; 2], 0);
        for (i, shape) in (1..).zip(arcs(flat, shapes)) {
            let exponent = 0.5 - 3.0 * even(i, 773);
            let options = Options {
                rule: method.into(),
                // Two digits more than the tolerance has.
                precision: is_fixed.then_some(Precision::Fixed((1.0 - exponent) as u8)),
                ..Options::default()
            };
            let request = Request::new(&shape, &options).unwrap().unwrap();
            let before = [TRIES.get(), LOOKS.get()];
            let found = request.fewest(Tolerance::Absolute(libm::pow(10.0, exponent)));
            costs[0] += TRIES.get() - before[0];
            costs[1] += LOOKS.get() - before[1];
            count += found.map_or(0, |sketch| sketch.curve.segments.len());
        }
        let is_cheap = costs[0] <= most[0] && costs[1] <= most[1];
        assert!(
            is_cheap && count <= segments,
            "{method:?} {flat:?}: {costs:?} {count}"
        );
    }
}

#[test]
fn the_fewest_segments_of_ellipses_cost_little() {
    cost_little(&[
        (Method::Minimax, [0.2, 0.95], false, 25, [26, 295], 59),
        (Method::Minimax, [0.2, 0.95], true, 25, [42, 650], 60),
        (
            Method::QuadraticMinimax,
            [0.1, 0.95],
            false,
            10,
            [49, 7430],
            47,
        ),
        (Method::MinimaxG0, [0.3, 0.95], false, 12, [38, 1380], 26),
        (Method::Chen3, [0.3, 0.95], false, 25, [27, 895], 131),
    ]);
}

#[test]
fn the_fewest_segments_of_flat_ellipses_cost_little() {
    cost_little(&[
        (Method::Midpoint, [0.05, 0.2], false, 20, [22, 4335], 46),
        (Method::Curvature, [0.01, 0.05], false, 15, [36, 9478], 36),
        (Method::Minimax, [0.01, 0.05], true, 15, [18, 6323], 31),
        (Method::Minimax, [0.003, 0.01], false, 15, [70, 10946], 30),
    ]);
}

#[test]
fn counts_are_doubled_and_then_halved() {
    let tries = |request: &Request, first: usize, tolerance: f64| {
        let before = TRIES.get();
        let found = request.fewest_by_doubling(None, first, tolerance);
        let count = found.map(|sketch| sketch.curve.segments.len());
        (count, TRIES.get() - before)
    };
    let shape = Shape::Circle(crate::Circle::new((0.0, 0.0), 100.0).unwrap());
    let options = |rule: Rule| Options {
        rule,
        precision: Some(Precision::Full),
        ..Options::default()
    };
    let minimax = options(Rule::default());
    let request = Request::new(&shape, &minimax).unwrap().unwrap();
    for tolerance in [1e-2, 1e-4, 1e-6] {
        let is_within = |count: usize| {
            let span = Span::from_degrees(360.0 / count as f64);
            Rule::default().radial_error(&span).unwrap().peak() <= tolerance / 100.0
        };
        let least = (3..1000).find(|&count| is_within(count)).unwrap();
        for first in [3, 4, 5] {
            let (mut high, mut doublings) = (first, 0);
            while high < least {
                (high, doublings) = (2 * high, doublings + 1);
            }
            let halvings = if doublings == 0 {
                0
            } else {
                (high / 2).ilog2() as usize
            };
            let (count, tried) = tries(&request, first, tolerance);
            assert_eq!(count, Some(least.max(first)));
            let costs = 1 + doublings + halvings..=2 + doublings + halvings;
            assert!(costs.contains(&tried), "{tolerance} {first}: {tried}");
        }
    }
    // The error of a literal handle does not fall.
    let small = Shape::Circle(crate::Circle::new((0.0, 0.0), 0.1).unwrap());
    let handle = options(Rule::Handle(0.55));
    let request = Request::new(&small, &handle).unwrap().unwrap();
    assert_eq!(tries(&request, 4, 1e-9), (None, 2));
}

#[test]
fn marched_joints_serve_where_rounding_moves_the_others() {
    // Two are the fewest: a segment takes half a turn at most.
    for (short, start, sweep, tolerance) in [
        (
            43.535_270_169_4,
            21.407_333_994_1,
            338.097_125_867_2,
            0.654_868_7,
        ),
        (
            48.069_765_255_4,
            290.782_953_419_2,
            326.362_735_381_6,
            0.685_450_7,
        ),
    ] {
        let [zero, start, sweep] = [0.0, start, sweep].map(Angle::from_degrees);
        let arc = Arc::new((0.0, 0.0), (100.0, short), zero, start, sweep);
        let shape = Shape::Arc(arc.unwrap());
        let options = Options {
            precision: Some(Precision::Fixed(1)),
            ..Options::default()
        };
        let request = Request::new(&shape, &options).unwrap().unwrap();
        let found = request.fewest(Tolerance::Absolute(tolerance)).unwrap();
        assert_eq!(found.curve.segments.len(), 2, "{short}");
    }
}
