//! The orders, leading constants and continuities that the catalogue states, found from the curves themselves.

use crate::judges::oracle;

use curveto::Method;
use curveto::continuity::Continuity;
use curveto::method::{Ends, Span};
use oracle::real::{abs, cross, dot};
use oracle::{Point, Real, curvature_derivatives, int, parse, radians, real};

/// The slope and the factor of a power law through points, by least squares of the logarithms.
fn fit(points: &[(f64, f64)]) -> (f64, f64) {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / count;
    let (mx, my) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - mx) * (p.1 - my)) / mean(&|p| (p.0 - mx).powi(2));
    (slope, (my - slope * mx).exp())
}

#[test]
fn the_stated_orders_and_leading_constants_are_those_of_the_curves() {
    let mut fitted = 0;
    for method in Method::ALL {
        let Some(law) = method.card().law else {
            continue;
        };
        let points: Vec<(f64, f64)> = [0.25, 0.5, 1.0, 2.0, 4.0]
            .map(|degrees| {
                let span = Span::from_degrees(degrees);
                (span.a, method.radial_error(&span).unwrap().peak())
            })
            .into();
        let (order, constant) = fit(&points);
        let stated = f64::from(law.order);
        assert!(
            (order - stated).abs() < 0.05,
            "{method}: order {order}, {stated} stated"
        );
        let off = constant / law.constant - 1.0;
        assert!(off.abs() < 0.02, "{method}: leading constant off by {off}");
        // At the smallest angle the constant stands almost alone.
        let (a, error) = points[0];
        let off = error / a.powf(stated) / law.constant - 1.0;
        assert!(off.abs() < 1e-5, "{method}: leading constant off by {off}");
        fitted += 1;
    }
    assert_eq!(fitted, 26);
}

/// What two segments share where they join on the bisector of nothing: each is told in the frame of its own start, from (r, 0), so
/// that the tangent at its end is seen from there by symmetry.
fn shared(before: &[Point], after: &[Point]) -> Shared {
    let same = |x: &Real, y: &Real| abs(&(x - y)) < parse("1e-40");
    if !same(&before[0][0], &after[0][0]) {
        return Shared::Apart;
    }
    // A symmetric segment leaves its end as it leaves its start, mirrored.
    let lift = |points: &[Point]| [&points[1][0] - &points[0][0], points[1][1].clone()];
    let (incoming, outgoing) = (lift(before), lift(after));
    let arriving = [-&incoming[0], incoming[1].clone()];
    let turned = abs(&cross(&arriving, &outgoing)) > parse("1e-40") * dot(&arriving, &outgoing);
    if turned {
        return Shared::G(0);
    }
    let left = curvature_derivatives(before, true, 3);
    let right = curvature_derivatives(after, false, 3);
    let alike = left.iter().zip(&right).take_while(|(l, r)| same(l, r));
    Shared::G(1 + alike.count())
}

#[derive(Debug, PartialEq)]
enum Shared {
    Apart,
    G(usize),
}

/// The cards' word for it; their G2 means not G3, their G4 not G5.
fn expected(continuity: Continuity) -> Shared {
    match continuity {
        Continuity::Apart => Shared::Apart,
        Continuity::G0 => Shared::G(0),
        Continuity::G1 => Shared::G(1),
        Continuity::G2 => Shared::G(2),
        Continuity::G3 => Shared::G(3),
        Continuity::G4 => Shared::G(4),
    }
}

fn points(method: Method, degrees: f64) -> Vec<Point> {
    oracle::method(method.id(), &radians(&real(degrees)))
        .unwrap()
        .points
}

#[test]
fn the_stated_continuity_is_that_of_the_curves() {
    let mut compared = 0;
    for method in Method::ALL {
        let card = method.card();
        let equal = points(method, 90.0);
        assert_eq!(
            shared(&equal, &equal),
            expected(card.continuity_equal),
            "{method}, equal segments"
        );
        // Formulation I solves uneven joints as a whole (chen_uneven.rs); Lancaster's number serves quarters only.
        if matches!(method, Method::Chen1 | Method::LancasterDrawellipse) {
            continue;
        }
        let uneven = shared(&points(method, 60.0), &equal);
        assert_eq!(
            uneven,
            expected(card.continuity_uneven),
            "{method}, unequal segments"
        );
        assert_eq!(uneven == Shared::Apart, card.ends == Ends::OffCircle);
        compared += 1;
    }
    assert_eq!(compared, 26);
}

#[test]
fn apprich_is_g4_because_its_graph_has_no_third_derivative_and_its_fourth_is_not_the_circles() {
    let quarter = points(Method::Apprich, 90.0);
    let kappa = curvature_derivatives(&quarter, false, 3);
    assert!(abs(&kappa[1]) < parse("1e-60"));
    assert!(abs(&kappa[3]) > int(1), "not G5");
    // f'''' = -(κ'' + 3 κ³) for a graph with f' = 0 that bends as the circle does; methods.md has -2.27015.
    let fourth = -(&kappa[2] + int(3) * &kappa[0] * &kappa[0] * &kappa[0]);
    assert!(abs(&(fourth - parse("-2.27015"))) < parse("5e-6"));
}

#[test]
fn formulation_3_has_two_curvatures_where_thirty_degrees_meet_sixty() {
    let curvature =
        |degrees: f64| curvature_derivatives(&points(Method::Chen3, degrees), true, 0)[0].clone();
    assert!(abs(&(curvature(30.0) - parse("1.0222250509"))) < parse("5e-11"));
    assert!(abs(&(curvature(60.0) - parse("1.0816852721"))) < parse("5e-11"));
}
