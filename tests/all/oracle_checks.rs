//! The oracle's measures against cases with a known answer.

use crate::judges::oracle;

use oracle::real::{abs, agrees, is_zero, ratio};
use oracle::{Real, int, parse, pi, radians, real, to_f64};

/// Control points given in machine numbers.
fn points<const N: usize>(coordinates: [[f64; 2]; N]) -> Vec<[Real; 2]> {
    coordinates.map(|p| p.map(real)).into()
}

/// Equal to 40 decimals.
fn near(value: &Real, expected: &Real) -> bool {
    abs(&(value - expected)) <= parse("1e-40")
}

#[test]
fn numbers_pass_through_unchanged() {
    for x in [0.1, -1.0 / 3.0, 6.02e23, f64::MIN_POSITIVE, f64::EPSILON] {
        assert_eq!(to_f64(&real(x)), x);
        assert_eq!(to_f64(&parse(&format!("{x:e}"))), x);
    }
    assert!(near(&(parse("0.1") * int(10)), &int(1)));
    assert!(near(&parse("-2.5e-3"), &ratio(-1, 400)));
}

#[test]
fn parabola_has_the_length_area_and_curvature_of_calculus() {
    // y = x^2 from 0 to 1, once as a quadratic and once as the same curve of degree 3.
    let quadratic = points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    let third = |n| ratio(n, 3);
    let cubic = vec![
        [int(0), int(0)],
        [third(1), int(0)],
        [third(2), third(1)],
        [int(1), int(1)],
    ];
    let root = int(5).sqrt();
    let length = &root * ratio(1, 2) + (int(2) + &root).ln() * ratio(1, 4);
    let start = [int(2), int(0), int(-24), int(0)];
    let end = [
        int(2) / (int(5) * &root),
        ratio(-24, 125),
        ratio(456, 625) / &root,
        ratio(-11616, 15625),
    ];
    for curve in [quadratic, cubic] {
        assert!(near(&oracle::arc_length(&curve), &length));
        assert!(near(&oracle::sector_area(&curve), &ratio(1, 6)));
        for (at_end, expected) in [(false, &start), (true, &end)] {
            let found = oracle::curvature_derivatives(&curve, at_end, 3);
            for (order, (value, expected)) in found.iter().zip(expected).enumerate() {
                assert!(near(value, expected), "order {order}, at end: {at_end}");
            }
        }
    }
}

#[test]
fn apprich_has_no_first_derivative_of_curvature_at_the_joints() {
    for id in ["apprich", "apprich-plus", "apprich-scaled", "midpoint"] {
        let found = oracle::method(id, &radians(&int(72))).expect("defined");
        for at_end in [false, true] {
            let derivatives = oracle::curvature_derivatives(&found.points, at_end, 3);
            let vanishes = abs(&derivatives[1]) < parse("1e-60");
            assert_eq!(vanishes, id != "midpoint", "{id}");
            assert!(abs(&derivatives[3]) > parse("0.1"), "{id}");
        }
    }
}

#[test]
fn length_area_and_mean_methods_keep_what_they_promise() {
    let a = radians(&int(100));
    let of = |id| oracle::method(id, &a).expect("defined").points;
    assert!(near(&oracle::arc_length(&of("length")), &a));
    assert!(near(&oracle::sector_area(&of("area")), &(&a * ratio(1, 2))));
    let area = oracle::sector_area(&of("quadratic-area"));
    assert!(near(&area, &(&a * ratio(1, 2))));
    let chen = oracle::method("chen-2", &a).expect("defined");
    let handle = chen.handle.expect("a handle");
    assert!(near(&oracle::arc_length(&chen.points), &(handle * int(3))));
    for other in ["minimax", "area", "mean-angle", "rms"] {
        let least = oracle::mean_abs_radial_error_t(&of("mean"));
        assert!(least < oracle::mean_abs_radial_error_t(&of(other)));
        if other != "rms" {
            let least = oracle::rms_radial_error_t(&of("rms"));
            assert!(least < oracle::rms_radial_error_t(&of(other)));
        }
        if other != "mean-angle" {
            let least = oracle::mean_abs_radial_error_angle(&of("mean-angle"));
            assert!(least < oracle::mean_abs_radial_error_angle(&of(other)));
        }
    }
}

#[test]
fn distance_from_a_round_ellipse_is_the_radial_error() {
    for id in [
        "midpoint",
        "minimax",
        "chen-1",
        "minimax-g0-free",
        "quadratic-area",
    ] {
        let found = oracle::method(id, &radians(&int(90))).expect("defined");
        let center = [int(0), int(0)];
        let radii = [int(1), int(1)];
        let (outward, inward) =
            oracle::ellipse_distance_extremes(&found.points, center, radii, &int(17));
        assert!(abs(&(outward - found.outward)) < parse("1e-30"), "{id}");
        assert!(abs(&(inward - found.inward)) < parse("1e-30"), "{id}");
    }
}

#[test]
fn distance_from_an_ellipse_is_measured_along_its_normals() {
    // From the center along the major axis of an ellipse of radii 5 and 2 the nearest points lie
    // at the ends of the minor axis; (10, 3) is 5.725... away (mpmath).
    let turned = |x: f64, y: f64| {
        let (sin, cos) = radians(&int(30)).sin_cos();
        let (x, y) = (real(x), real(y));
        [
            &x * &cos - &y * &sin + int(1),
            &x * &sin + &y * &cos - int(4),
        ]
    };
    let extremes = |curve: [[Real; 2]; 3]| {
        let center = [int(1), int(-4)];
        oracle::ellipse_distance_extremes(&curve, center, [int(5), int(2)], &int(30))
    };
    let (outward, inward) = extremes([turned(0.0, 0.0), turned(2.5, 0.0), turned(5.0, 0.0)]);
    assert!(is_zero(&outward));
    assert!(abs(&(inward - int(2))) < parse("1e-30"));
    let (outward, inward) = extremes([turned(-10.0, 3.0), turned(0.0, 3.0), turned(10.0, 3.0)]);
    assert!(agrees(&outward, "5.72541780924489412352044170071"));
    assert!(is_zero(&inward));
}

/// Quarter arcs as affine images, against a search with mpmath.
#[test]
fn quarter_ellipses_have_the_distances_of_an_independent_search() {
    let quarter = |x: i32, y: i32, handle: &Real| {
        let k = handle.clone();
        [
            [int(1), int(0)],
            [int(1), k.clone()],
            [k, int(1)],
            [int(0), int(1)],
        ]
        .map(|p| [&p[0] * int(x), &p[1] * int(y)])
    };
    let standard = (pi() * ratio(1, 8)).tan() * ratio(4, 3);
    let cases = [
        (7, 2, standard, "0.001327330901955911797803738", "0"),
        (
            100,
            1,
            parse("0.5519150245"),
            "0.0008057013122146576188661476",
            "0.0002810254863287092363100699",
        ),
    ];
    for (x, y, handle, expected_out, expected_in) in cases {
        let curve = quarter(x, y, &handle);
        let center = [int(0), int(0)];
        let radii = [int(x), int(y)];
        let (outward, inward) = oracle::ellipse_distance_extremes(&curve, center, radii, &int(0));
        assert!(agrees(&outward, expected_out), "{x}:{y}");
        assert!(agrees(&inward, expected_in), "{x}:{y}");
    }
}

#[test]
fn means_are_those_of_an_independent_quadrature() {
    let arc = |handle: &str| {
        let k = parse(handle);
        vec![
            [int(1), int(0)],
            [int(1), k.clone()],
            [k, int(1)],
            [int(0), int(1)],
        ]
    };
    let rms = oracle::rms_radial_error_t(&arc("0.5522847498"));
    assert!(agrees(&rms, "0.0001698517828660009999018758"));
    let mean = oracle::mean_abs_radial_error_angle(&arc("0.5519"));
    assert!(agrees(&mean, "0.00011820015206378263908153"));
}
