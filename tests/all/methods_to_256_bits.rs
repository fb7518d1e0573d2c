//! Every method against the oracle in 256-bit arithmetic, from a millionth of a degree to its largest angle.

use crate::judges::oracle;

use curveto::Method;
use curveto::method::Span;
use oracle::{Real, radians, real, to_f64};
use rayon::prelude::*;

/// In degrees; those beyond a method's largest are left out, its largest is put in.
const ANGLES: [f64; 28] = [
    1e-6, 3e-6, 1e-5, 1e-4, 0.001, 0.005, 0.01, 0.03, 0.07, 0.3, 0.57, 1.1, 3.7, 8.6, 11.3, 17.0,
    23.7, 41.0, 57.2, 57.4, 77.7, 85.9, 86.1, 101.0, 114.7, 133.3, 151.0, 171.0,
];

/// Whether the method is defined by an integral of the error, which the oracle can take from a hundredth of a degree only: below, that
/// integral has lost its digits even there.
fn is_integral(method: Method) -> bool {
    matches!(
        method,
        Method::Length | Method::Mean | Method::MeanAngle | Method::Rms
    )
}

/// The angles at which a method is tried against the oracle.
fn angles(method: Method) -> Vec<f64> {
    let least = if is_integral(method) { 0.01 } else { 0.0 };
    match method {
        Method::LancasterBest => [2.0, 3.0, 4.0, 5.0, 6.0, 8.0]
            .map(|count| 360.0 / count)
            .into(),
        Method::LancasterDrawellipse => vec![90.0],
        _ => {
            let largest = method.card().largest_angle;
            let below = ANGLES
                .into_iter()
                .filter(|&angle| angle < largest && angle >= least);
            below.chain([largest]).collect()
        }
    }
}

/// |ours - theirs| over |theirs|, computed in the oracle's digits.
fn relative(ours: f64, theirs: &Real) -> f64 {
    if ours == 0.0 && to_f64(theirs).abs() < 1e-60 {
        return 0.0;
    }
    let off = to_f64(&((real(ours) - theirs) / theirs)).abs();
    if off.is_nan() { f64::INFINITY } else { off }
}

#[test]
fn handles_and_stated_errors_are_those_of_the_oracle_at_every_angle() {
    let cases: Vec<(Method, f64)> = Method::ALL
        .into_iter()
        .flat_map(|method| angles(method).into_iter().map(move |angle| (method, angle)))
        .collect();
    let wrong: Vec<String> = cases
        .par_iter()
        .filter_map(|&(method, degrees)| compare(method, degrees))
        .collect();
    assert!(cases.len() > 550, "only {} cases", cases.len());
    assert!(wrong.is_empty(), "{}\n{}", wrong.len(), wrong.join("\n"));
}

/// What is wrong with a method at an angle.
fn compare(method: Method, degrees: f64) -> Option<String> {
    let span = Span::from_degrees(degrees);
    let piece = method.piece(&span).unwrap();
    let stated = method.radial_error(&span).unwrap();
    let truth = oracle::method(method.id(), &radians(&real(degrees))).unwrap();
    let off = [
        ("P1.x", relative(piece.handle.x, &truth.points[1][0]), 1e-15),
        (
            "P1.y",
            relative(piece.handle.y, &truth.points[1][1]),
            1.6e-15,
        ),
        (
            "end radius",
            relative(piece.end_radius, &truth.end_radius),
            4e-16,
        ),
        (
            "handle",
            relative(piece.handle_length(), truth.handle.as_ref().unwrap()),
            1.6e-15,
        ),
        ("outward", relative(stated.outward, &truth.outward), 1e-9),
        ("inward", relative(stated.inward, &truth.inward), 1e-9),
    ];
    let told: Vec<String> = off
        .iter()
        .filter(|(_, off, allowed)| off > allowed)
        .map(|(what, off, _)| format!("{what} {off:.1e}"))
        .collect();
    (!told.is_empty()).then(|| format!("{method} at {degrees}: {}", told.join(", ")))
}

/// Below a hundredth of a degree the next term of the error's series is 1e-8 of the first and falls with the square of the angle, and the
/// handles of order 6 differ by 1e-18: what the oracle cannot integrate there is known all the same.
#[test]
fn methods_defined_by_integrals_follow_their_leading_term_down_to_a_millionth_of_a_degree() {
    for method in Method::ALL
        .into_iter()
        .filter(|&method| is_integral(method))
    {
        for degrees in [1e-6, 3e-6, 1e-5, 1e-4, 0.001, 0.005] {
            let span = Span::from_degrees(degrees);
            let law = method.card().law.unwrap();
            let leading = law.constant * span.a.powi(i32::from(law.order));
            let stated = method.radial_error(&span).unwrap().peak();
            let allowed = 2e-10 + span.a * span.a;
            assert!(
                (stated / leading - 1.0).abs() < allowed,
                "{method} at {degrees}: {stated:e} against {leading:e}"
            );
            let midpoint = oracle::method("midpoint", &radians(&real(degrees))).unwrap();
            let handle = method.piece(&span).unwrap().handle_length();
            let off = relative(handle, midpoint.handle.as_ref().unwrap());
            assert!(off < 1.6e-15, "{method} at {degrees}: handle {off:.1e}");
        }
    }
}

/// A dense sweep: noise would show as a jump against the neighbours, whatever the true value.
#[test]
fn stated_errors_grow_smoothly_with_the_angle() {
    for method in Method::ALL {
        let Some(law) = method.card().law else {
            continue;
        };
        let mut before = 0.0;
        let mut degrees = 1e-6;
        while degrees < 120.0 {
            let stated = method.radial_error(&Span::from_degrees(degrees)).unwrap();
            let growth: f64 = if before == 0.0 {
                1.0
            } else {
                stated.peak() / before
            };
            let law = 1.02_f64.powi(i32::from(law.order));
            assert!(
                before == 0.0 || (growth > 1.0 && growth < law * 1.35),
                "{method} at {degrees}: {growth} against {law}"
            );
            if degrees < 0.05 {
                let off = (growth / law - 1.0).abs();
                assert!(
                    before == 0.0 || off < 1e-6,
                    "{method} at {degrees}: {off:e}"
                );
            }
            before = stated.peak();
            degrees *= 1.02;
        }
    }
}
