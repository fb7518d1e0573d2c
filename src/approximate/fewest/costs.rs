//! What the search for the fewest segments costs.

use super::*;
use crate::joints::adaptive::LOOKS;
use crate::{Angle, Arc};

/// Numbers from 0 to 1 that spread evenly with their index.
fn even(index: usize, step: usize) -> f64 {
    (index * step % 1009) as f64 / 1009.0
}

/// A method, the flatnesses of ellipses, whether decimals are fixed, and how many there are; what the search costs at most, and the segments
/// of all.
type Group = (Method, [f64; 2], bool, usize, [usize; 2], usize);

fn cost_little(groups: &[Group]) {
    for &(method, [low, high], is_fixed, shapes, most, segments) in groups {
        let (mut costs, mut count) = ([0; 2], 0);
        for i in 1..=shapes {
            let flatness = low * libm::pow(high / low, even(i, 389));
            let start = if i % 5 == 0 {
                90.0
            } else {
                360.0 * even(i, 617)
            };
            let sweep = match i % 3 {
                0 => 360.0,
                1 => 20.0 + 320.0 * even(i, 241),
                _ => -20.0 - 320.0 * even(i, 241),
            };
            let [zero, start, sweep] = [0.0, start, sweep].map(Angle::from_degrees);
            let arc = Arc::new((0.0, 0.0), (100.0, 100.0 * flatness), zero, start, sweep);
            let shape = Shape::Arc(arc.unwrap());
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
            "{method:?} {low}: {costs:?} {count}"
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
        (Method::Chen3, [0.3, 0.95], false, 25, [27, 890], 131),
    ]);
}

#[test]
fn the_fewest_segments_of_flat_ellipses_cost_little() {
    cost_little(&[
        (Method::Midpoint, [0.05, 0.2], false, 20, [22, 4335], 46),
        (Method::Curvature, [0.01, 0.05], false, 15, [27, 8125], 36),
        (Method::Minimax, [0.01, 0.05], true, 15, [15, 6130], 31),
        (Method::Minimax, [0.003, 0.01], false, 15, [57, 12310], 31),
    ]);
}
