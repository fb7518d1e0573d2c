//! The error that a drawing states, of its points as they are written, against the oracle's extremes of the same points.

use crate::judges::exact::{Exact, decimal_point};
use crate::judges::oracle;
use crate::judges::random::uniform;

use curveto::approximate::{Drawing, Options, approximate};
use curveto::contour::Step;
use curveto::curve::control_points;
use curveto::number::Precision;
use curveto::shape::endpoint::parse_svg_arc;
use curveto::{Angle, Arc, Circle, Cut, Error, Method, Shape, Tolerance, arcs, path};
use kurbo::{Point, Vec2};
use oracle::{decimal, radial_extremes, to_f64};
use rayon::prelude::*;

/// (centre, radius) from the tiny to the far away.
const PLACES: [((f64, f64), f64); 6] = [
    ((0.0, 0.0), 1.0),
    ((0.0, 0.0), 50.0),
    ((12.3, -45.6), 7.89),
    ((1e6, -3e5), 2.5),
    ((-0.001, 0.002), 1e-4),
    ((1.0 / 3.0, 2.0 / 7.0), 123_456.789),
];

const PRECISIONS: [Option<Precision>; 4] = [
    None,
    Some(Precision::Full),
    Some(Precision::Fixed(3)),
    Some(Precision::Fixed(9)),
];

fn cuts() -> Vec<Cut> {
    let mut cuts: Vec<Cut> = [2, 3, 4, 5, 6, 8, 11].map(Cut::Count).into();
    let uneven = [0.0, 50.0, 120.0, 180.0, 300.0].map(Angle::from_degrees);
    cuts.push(Cut::At(uneven.into()));
    cuts
}

/// Compares what is stated with the oracle: it is never less, and at most a billionth and four units in the last place of the
/// largest coordinate more.
fn compare(drawing: &Drawing, centre: (f64, f64), radius: f64) -> Option<String> {
    let (mut outward, mut inward) = (0.0_f64, 0.0_f64);
    for segment in &drawing.curve.segments {
        let points: Vec<oracle::Point> = control_points(segment)
            .iter()
            .map(|p| [decimal(p.x), decimal(p.y)])
            .collect();
        let center = [decimal(centre.0), decimal(centre.1)];
        let found = radial_extremes(&points, center, &decimal(radius));
        outward = outward.max(to_f64(&found.0));
        inward = inward.max(to_f64(&found.1));
    }
    let largest = drawing
        .curve
        .segments
        .iter()
        .flat_map(control_points)
        .map(|p| p.x.abs().max(p.y.abs()))
        .fold(0.0, f64::max);
    let unit = largest.next_up() - largest;
    let near =
        |ours: f64, theirs: f64| ours >= theirs && ours <= theirs * (1.0 + 1e-9) + 4.0 * unit;
    let stated = drawing.error;
    (!near(stated.outward, outward) || !near(stated.inward, inward)).then(|| {
        format!(
            "{} with {} segments of radius {radius} at {:?}: {:e} {:e} stated, {outward:e} {inward:e} true",
            drawing.rule.id(),
            drawing.curve.segments.len(),
            drawing.precision,
            stated.outward,
            stated.inward,
        )
    })
}

/// Draws every case; gives how many could be drawn and what was wrong.
fn check(cases: &[(Method, Cut, usize)], shape: impl Fn(usize) -> Shape + Sync) -> usize {
    let results: Vec<Option<String>> = cases
        .par_iter()
        .enumerate()
        .filter_map(|(i, (method, cut, place))| {
            let options = Options {
                rule: (*method).into(),
                cut: cut.clone(),
                precision: PRECISIONS[i % PRECISIONS.len()],
                ..Options::default()
            };
            match approximate(&shape(*place), &options) {
                Ok(drawing) => Some(compare(&drawing, PLACES[*place].0, PLACES[*place].1)),
                // A tiny arc of which rounding would leave a point is refused.
                Err(Error::Impossible { .. } | Error::Collapsed { .. }) => None,
                Err(other) => Some(Some(other.to_string())),
            }
        })
        .collect();
    let wrong: Vec<&String> = results.iter().flatten().collect();
    assert!(wrong.is_empty(), "{}: {wrong:#?}", wrong.len());
    results.len()
}

fn cases() -> Vec<(Method, Cut, usize)> {
    let mut cases = Vec::new();
    for method in Method::ALL {
        for (i, cut) in cuts().into_iter().enumerate() {
            for place in 0..PLACES.len() {
                // Every third place: each precision meets each of them elsewhere in the table.
                if (i + place) % 3 == 0 {
                    cases.push((method, cut.clone(), place));
                }
            }
        }
    }
    cases
}

#[test]
fn circles_state_the_error_of_the_points_as_printed() {
    let drawn = check(&cases(), |place| {
        let (centre, radius) = PLACES[place];
        Shape::Circle(Circle::new(centre, radius).unwrap())
    });
    assert!(drawn > 250, "only {drawn} drawn");
}

#[test]
fn arcs_state_the_error_of_the_points_as_printed() {
    let arcs: Vec<_> = cases()
        .into_iter()
        .filter(|(_, cut, _)| matches!(cut, Cut::Count(_)))
        .collect();
    let drawn = check(&arcs, |place| {
        let (centre, radius) = PLACES[place];
        let start = Angle::from_degrees(13.7);
        let sweep = Angle::from_degrees([-211.3, 1e-6, 0.01, 3.0, 45.0, -90.0][place]);
        let radii = Vec2::new(radius, radius);
        let centre = Point::from(centre);
        Shape::Arc(Arc::new(centre, radii, Angle::ZERO, start, sweep).unwrap())
    });
    assert!(drawn > 200, "only {drawn} drawn");
}

/// Where the nearest point jumps or the curve runs through the centre, the distance has a peak that no slope shows.
#[test]
fn peaks_without_a_slope_are_found() {
    let peak = |arguments: &[&str]| {
        let document = crate::judges::program::json(arguments);
        let error = if document["error"].is_null() {
            &document["measurements"][0]["error"]
        } else {
            &document["error"]
        };
        error["peak"]
            .as_f64()
            .unwrap_or_else(|| panic!("{document}"))
    };
    let radius = "2.0942030025311213";
    let through = peak(&[
        "circle", radius, "--handle", "0", "-n", "2", "-p", "0", "-f", "json",
    ]);
    assert!(through >= radius.parse().unwrap());
    let wave = "M37.985631324452655 -7.665493302251913C38.236125445571474 9.768917819583411 38.48661956669029 -12.34188137517219 38.73711368780911 15.45396338216095";
    let crossing = peak(&[
        "measure",
        "--path",
        wave,
        "--against",
        "ellipse:0,0,100,21.42,0",
        "-f",
        "json",
    ]);
    // b sqrt(1 - x²/(a² - b²)) at the farthest inside of its three crossings of the long axis, x = 38.236 to 38.487.
    let deepest = |x: f64| 21.42 * (1.0 - x * x / (100.0_f64.powi(2) - 21.42_f64.powi(2))).sqrt();
    assert!(
        crossing > deepest(38.29) && crossing < deepest(38.28),
        "{crossing}"
    );
}

/// Far from the origin the points of a tiny ellipse share their leading digits, which the distance must not lose.
#[test]
fn a_tiny_ellipse_far_from_the_origin_states_no_less_than_the_truth() {
    let (radii, centre) = ([1.03e-7, 0.001_974_92], [-811_458.0, -618_711.0]);
    let words = "ellipse 1.03e-07 0.00197492 --rotation 0 --center -811458,-618711 --start 594.2705418056371 --reverse -n 5 -m minimax-free -p auto -f json";
    let words: Vec<&str> = words.split(' ').collect();
    let document = crate::judges::program::json(&words);
    let (mut outward, mut inward) = (0.0_f64, 0.0_f64);
    for segment in document["segments"].as_array().unwrap() {
        let points: Vec<oracle::Point> = segment["points"]
            .as_array()
            .unwrap()
            .iter()
            .map(|p| [0, 1].map(|i| decimal(p[i].as_f64().unwrap())))
            .collect();
        let found = oracle::ellipse_distance_extremes(
            &points,
            centre.map(decimal),
            radii.map(decimal),
            &oracle::int(0),
        );
        outward = outward.max(to_f64(&found.0));
        inward = inward.max(to_f64(&found.1));
    }
    let unit = centre[0].abs().next_up() - centre[0].abs();
    let near = |stated: &serde_json::Value, truth: f64| {
        let over = stated.as_f64().unwrap() - truth;
        over >= 0.0 && over <= 1e-9 * truth + 4.0 * unit
    };
    assert!(
        near(&document["error"]["outward"], outward) && near(&document["error"]["inward"], inward),
        "{} stated, {outward:e} {inward:e} true",
        document["error"]
    );
}

/// A cubic over a chord that rises by a millionth to a billionth of it, so that radii are up to a billion times its length.
fn nearly_straight(seed: &mut u64) -> (String, [Point; 4], f64) {
    let mut between = |low: f64, high: f64| low + (high - low) * uniform(seed);
    let length = 10.0_f64.powf(between(-1.0, 3.0));
    let height = length * 10.0_f64.powf(between(-9.0, -6.0));
    let origin = Point::new(between(-100.0, 100.0), between(-100.0, 100.0));
    let along = Vec2::from_angle(between(0.0, 6.0));
    let [u, v] = [between(0.2, 0.45), between(0.2, 0.45)];
    let first = between(0.5, 1.0);
    let heights = [0.0, first, first * between(0.5, 1.5), 0.0];
    let places = [0.0, u, 1.0 - v, 1.0].map(|x| x * length);
    let points: [Point; 4] = core::array::from_fn(|i| {
        origin + Vec2::new(places[i], heights[i] * height).rotate_scale(along)
    });
    let [a, b, c, d] = points;
    let data = format!(
        "M{} {}C{} {} {} {} {} {}",
        a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y
    );
    (data, points, height * between(0.2, 0.5))
}

#[test]
fn nearly_straight_arcs_are_no_farther_than_stated() {
    let mut seed = 17;
    let mut judged = 0;
    for _ in 0..300 {
        let (data, points, tolerance) = nearly_straight(&mut seed);
        let options = arcs::Options {
            tolerance: Some(Tolerance::Absolute(tolerance)),
            ..arcs::Options::default()
        };
        let drawing = arcs::arcs(&path::contours(&data).unwrap(), &options).unwrap();
        let stated = drawing.error().peak();
        assert!(stated <= tolerance, "{data}: {stated} beyond {tolerance}");
        let printed = path::data_of_courses(drawing.courses(), false);
        let contours = path::contours(&printed).unwrap();
        let [Step::Arc(_)] = contours[0].steps[..] else {
            continue;
        };
        // The arc that a reader of the text has.
        let exact = Exact::of_svg_arc(&parse_svg_arc(&printed).unwrap());
        let points = points.map(decimal_point);
        let found = radial_extremes(&points, exact.center, &exact.radii[0]);
        let truth = to_f64(&found.0).max(to_f64(&found.1));
        assert!(
            stated >= truth && stated <= truth * (1.0 + 1e-9) + 1e-11,
            "{data} as {printed}: {stated} stated, {truth} true"
        );
        judged += 1;
    }
    assert!(judged > 200, "{judged}");
}
