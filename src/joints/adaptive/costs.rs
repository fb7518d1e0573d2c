//! What searches for joints cost, and how good joints are by trial.

use super::*;
use crate::{Angle, Arc, Shape};

/// A method on an arc of an ellipse, in degrees.
pub(super) fn balance(method: Method, flatness: f64, start: f64, sweep: f64) -> Balance {
    on(method, &arc(flatness, start, sweep))
}

fn on(method: Method, shape: &Shape) -> Balance {
    Balance::new(&shape.outline().unwrap(), Rule::Method(method)).unwrap()
}

fn arc(flatness: f64, start: f64, sweep: f64) -> Shape {
    let [zero, start, sweep] = [0.0, start, sweep].map(Angle::from_degrees);
    let arc = Arc::new((0.0, 0.0), (100.0, 100.0 * flatness), zero, start, sweep);
    Shape::Arc(arc.unwrap())
}

/// Numbers from 0 to 1 that spread evenly with their index.
pub(crate) fn even(index: usize, step: usize) -> f64 {
    (index * step % 1009) as f64 / 1009.0
}

/// Closed shapes and arcs of ellipses of flatnesses between these, evenly by their logarithm; every fifth starts on an axis.
pub(crate) fn arcs([low, high]: [f64; 2], count: usize) -> impl Iterator<Item = Shape> {
    (1..=count).map(move |i| {
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
        arc(flatness, start, sweep)
    })
}

fn balances(method: Method, flat: [f64; 2], count: usize) -> impl Iterator<Item = Balance> {
    arcs(flat, count).map(move |arc| on(method, &arc))
}

/// How many segments are looked at for something.
fn looks<T>(of: impl FnOnce() -> T) -> (usize, T) {
    let before = LOOKS.get();
    let found = of();
    (LOOKS.get() - before, found)
}

#[test]
fn joints_for_a_count_cost_little() {
    for (method, flat, shapes, most, gain) in [
        (Method::Minimax, [0.2, 0.95], 30, 485, 9.457),
        (Method::Midpoint, [0.05, 0.2], 20, 1250, 18.921),
        (Method::Curvature, [0.01, 0.05], 12, 3255, 19.235),
        (Method::Minimax, [0.003, 0.01], 8, 5305, 17.035),
        (Method::MinimaxG0, [0.1, 0.95], 15, 5730, 6.211),
        (Method::QuadraticMinimax, [0.1, 0.95], 15, 3945, 6.215),
    ] {
        let (mut cost, mut gained) = (0, 0.0);
        for (i, balance) in balances(method, flat, shapes).enumerate() {
            let (whole, count) = (balance.arc.sweep.degrees().abs(), 2 + i % 11);
            let (looked, found) = looks(|| balance.joints_from(count, None, f64::INFINITY));
            cost += looked;
            let Some((joints, _)) = found else { continue };
            let ways: Vec<f64> = joints
                .angles
                .iter()
                .map(|a| (a - joints.angles[0]).abs())
                .collect();
            gained += libm::log(balance.equal(whole, count) / balance.most(&ways));
        }
        assert!(
            cost <= most && gained >= gain,
            "{method:?} {flat:?}: {cost} {gained}"
        );
    }
}

#[test]
fn counts_for_an_error_cost_little() {
    for (method, flat, most, segments) in [
        (
            Method::Minimax,
            [0.2, 0.95],
            [250, 835, 1230],
            [88, 92, 142],
        ),
        (
            Method::Midpoint,
            [0.05, 0.2],
            [195, 1180, 1905],
            [39, 82, 129],
        ),
        (
            Method::Curvature,
            [0.01, 0.05],
            [55, 1145, 1770],
            [4, 89, 138],
        ),
        (
            Method::Minimax,
            [0.003, 0.01],
            [20, 1385, 1900],
            [4, 67, 103],
        ),
        (
            Method::QuadraticMinimax,
            [0.1, 0.95],
            [0, 890, 1340],
            [0, 201, 309],
        ),
    ] {
        let (mut costs, mut counts) = ([0; 3], [0; 3]);
        for (i, balance) in balances(method, flat, 30).enumerate() {
            let allowed = libm::pow(10.0, -1.5 - 4.0 * even(i, 773));
            let (looked, found) = looks(|| balance.least(allowed));
            costs[0] += looked;
            counts[0] += found.map_or(0, |least| least.count);
            let (looked, found) = looks(|| balance.marched_count(allowed));
            costs[1] += looked;
            counts[1] += found.unwrap();
            let (looked, found) = looks(|| {
                balance
                    .greedy(allowed)
                    .map(|all| all.count())
                    .sum::<usize>()
            });
            costs[2] += looked;
            counts[2] += found;
        }
        assert!(
            (0..3).all(|i| costs[i] <= most[i]) && counts == segments,
            "{method:?} {flat:?}: {costs:?} {counts:?}"
        );
    }
}

#[test]
fn joints_differ_where_there_is_room_for_it() {
    let open = balance(Method::Minimax, 0.5, 20.0, 300.0);
    let counts = |balance: &Balance, counts: [usize; 4]| {
        counts.map(|count| balance.joints_from(count, None, f64::INFINITY).is_some())
    };
    assert_eq!(
        counts(&open, [1, 2, MOST, MOST + 1]),
        [false, true, true, false]
    );
    // The halves of a closed shape that starts on an axis mirror one another.
    let closed = balance(Method::Minimax, 0.5, 90.0, 360.0);
    assert_eq!(counts(&closed, [1, 2, 3, 4]), [false, false, true, true]);
}

#[test]
fn axes_of_an_ellipse_lie_where_it_is_turned_to() {
    let turned = Balance {
        axis: 20.0,
        ..balance(Method::Minimax, 0.5, 20.0, 360.0)
    };
    for (degrees, is_axis) in [(20.0, true), (-70.0, true), (200.0, true), (70.0, false)] {
        assert_eq!(turned.on_axis(degrees), is_axis, "{degrees}");
    }
    assert!(turned.mirrors());
}

#[test]
fn fewer_are_tried_where_the_first_order_does_not_tell() {
    for (method, is_quick) in [(Method::Minimax, true), (Method::MinimaxG0, false)] {
        let balance = balance(method, 0.5, 20.0, 300.0);
        // Rough errors begin with 0.0001 of the least radius of curvature, 0.25 of the larger radius.
        assert!(!balance.may_take_fewer(0.24e-4));
        assert_eq!(balance.may_take_fewer(0.26e-4), !is_quick);
    }
    for (flatness, is_sharp) in [(0.029, true), (0.031, false)] {
        assert_eq!(
            balance(Method::Minimax, flatness, 0.0, 90.0).is_sharp(),
            is_sharp
        );
    }
}
