//! `path --to quadratics`: the stated distance, and the count, against samples.

use curveto::contour::{BezierTarget, draw};
use curveto::number::Precision;
use curveto::{Cut, Options, Tolerance, path};
use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, QuadBez};

use crate::judges::random::uniform;

/// The largest value of a function of 0 to 1, by samples and then by finer ones around each that is larger than its neighbours.
fn largest(count: u32, of: impl Fn(f64) -> f64) -> f64 {
    let at = |k: u32| f64::from(k) / f64::from(count);
    let values: Vec<f64> = (0..=count).map(|k| of(at(k))).collect();
    let value = |k: u32| values.get(k as usize).copied().unwrap_or(f64::NEG_INFINITY);
    let is_peak = |&k: &u32| value(k) >= value(k.wrapping_sub(1)) && value(k) >= value(k + 1);
    let around = |k: u32| {
        let (mut low, mut high) = (at(k.saturating_sub(1)), at((k + 1).min(count)));
        let mut found = value(k);
        for _ in 0..11 {
            let fine = |k: u32| low + (high - low) * f64::from(k) / 10.0;
            let values = (0..=10).map(|k| (of(fine(k)), k));
            let (value, best) = values.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            found = value.max(found);
            (low, high) = (fine(best.saturating_sub(1)), fine((best + 1).min(10)));
        }
        found
    };
    (0..=count)
        .filter(is_peak)
        .map(around)
        .fold(f64::NEG_INFINITY, f64::max)
}

fn away(p: Point, from: &[PathSeg]) -> f64 {
    let each = from
        .iter()
        .map(|segment| -largest(40, |t| -segment.eval(t).distance(p)));
    each.fold(f64::INFINITY, f64::min)
}

/// Both ways.
fn sampled(a: &[PathSeg], b: &[PathSeg]) -> f64 {
    let way = |a: &[PathSeg], b: &[PathSeg]| {
        let each = a
            .iter()
            .map(|segment| largest(100, |t| away(segment.eval(t), b)));
        each.fold(0.0, f64::max)
    };
    way(a, b).max(way(b, a))
}

fn quadratics(cubic: &CubicBez, tolerance: f64) -> (Vec<PathSeg>, f64) {
    let [a, b, c, d] = [cubic.p0, cubic.p1, cubic.p2, cubic.p3];
    let data = format!(
        "M{} {}C{} {} {} {} {} {}",
        a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y
    );
    let options = Options {
        cut: Cut::Tolerance(Tolerance::Absolute(tolerance)),
        precision: Some(Precision::Fixed(7)),
        ..Options::default()
    };
    let contours = path::contours(&data).unwrap();
    let drawing = draw(&contours, BezierTarget::Quadratics, &options).unwrap();
    (
        drawing.subpaths[0].curve.segments.clone(),
        drawing.error().peak(),
    )
}

/// The quadratics of a rule written anew: equal parts of the parameter, P1 = (3(p1 + p2) - p0 - p3)/4.
fn cut(cubic: &CubicBez, count: usize) -> Vec<PathSeg> {
    let part = |k: usize| k as f64 / count as f64;
    let quadratic = |i| {
        let c = cubic.subsegment(part(i)..part(i + 1));
        let middle =
            0.75 * (c.p1.to_vec2() + c.p2.to_vec2()) - 0.25 * (c.p0.to_vec2() + c.p3.to_vec2());
        PathSeg::Quad(QuadBez::new(c.p0, middle.to_point(), c.p3))
    };
    (0..count).map(quadratic).collect()
}

#[test]
fn the_stated_distance_is_that_of_samples_and_the_count_the_least() {
    let mut seed = 5;
    for _ in 0..24 {
        let mut point = || {
            let round = |x: f64| (2000.0 * x).round() / 100.0;
            Point::new(round(uniform(&mut seed)), round(uniform(&mut seed)))
        };
        let cubic = CubicBez::new(point(), point(), point(), point());
        let tolerance = 10.0_f64.powf(-2.5 + 3.0 * uniform(&mut seed));
        let (drawn, stated) = quadratics(&cubic, tolerance);
        let given = [PathSeg::Cubic(cubic)];
        let found = sampled(&given, &drawn);
        assert!(stated <= tolerance, "{cubic:?} {tolerance}: {stated}");
        assert!(
            stated >= found * (1.0 - 1e-12),
            "{cubic:?} {tolerance}: {stated} {found}"
        );
        assert!(
            stated <= found * (1.0 + 2e-9),
            "{cubic:?} {tolerance}: {stated} {found}"
        );
        let fewer = if drawn.len() <= 8 {
            1..drawn.len()
        } else {
            drawn.len() - 1..drawn.len()
        };
        for count in fewer {
            // The tenth that rounding may add is left.
            let farther = sampled(&given, &cut(&cubic, count));
            assert!(
                1.1 * farther > tolerance,
                "{cubic:?} {tolerance}: {count} would do"
            );
        }
    }
}

#[test]
fn a_cubic_that_turns_sharply_is_measured_at_near_points() {
    let cubic = CubicBez::new((4.0, 4.0), (2.0, 2.0), (3.0, 2.0), (0.0, 0.0));
    let (drawn, stated) = quadratics(&cubic, 0.37797);
    assert_eq!(drawn.len(), 1);
    assert!((0.1431..0.1433).contains(&stated), "{stated}");
}
