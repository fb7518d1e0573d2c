//! On circles the count is the least for the method, by trial of all counts; the engine's too, and never more than kurbo's.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use curveto::method::Span;
use curveto::write::number::Precision;
use curveto::{Angle, Arc, Circle, Cut, Method, Options, Shape, Tolerance, approximate};
use kurbo::Affine;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_count_below_meets_the_tolerance(
        method in prop::sample::select(vec![Method::Minimax, Method::Midpoint, Method::Curvature, Method::MinimaxG0, Method::MinimaxFree, Method::QuadraticMinimax]),
        radius in 1e-2..1e3_f64,
        exponent in -9.0..-1.5_f64,
    ) {
        let shape = Shape::Circle(Circle::new((0.0, 0.0), radius).unwrap());
        let tolerance = 10_f64.powf(exponent) * radius;
        let draw = |cut| {
            let precision = Some(Precision::Full);
            approximate(&shape, &Options { rule: method.into(), cut, precision, transform: Affine::IDENTITY })
        };
        let within = |count: &usize| draw(Cut::Count(*count)).is_ok_and(|drawing| drawing.error.peak() <= tolerance);
        let least = (1..=64).find(within);
        let found = draw(Cut::Tolerance(Tolerance::Absolute(tolerance))).unwrap().curve.segments.len();
        match least {
            Some(least) => prop_assert_eq!(found, least),
            None => prop_assert!(found > 64),
        }
    }

    #[test]
    fn the_engine_takes_the_least_count_and_never_more_than_kurbo(
        radii in (0.1..100.0_f64, 0.1..100.0_f64),
        start in -360.0..360.0_f64,
        sweep in -360.0..360.0_f64,
        exponent in -9.0..-1.0_f64,
    ) {
        let tolerance = 10_f64.powf(exponent);
        let degrees = Angle::from_degrees;
        let arc = Arc::new((3.0, 4.0), radii, degrees(20.0), degrees(start), degrees(sweep)).unwrap();
        let scale = radii.0.max(radii.1);
        let cubics: Vec<_> = arc.cubics(tolerance * scale).collect();
        let fits = |count: usize| {
            Method::Minimax
                .radial_error(&Span::from_degrees(sweep / count as f64))
                .is_ok_and(|error| error.peak() <= tolerance)
        };
        prop_assert_eq!(Some(cubics.len()), (1..1000).find(|&count| fits(count)));
        let theirs = kurbo::Arc::new((3.0, 4.0), radii, start.to_radians(), sweep.to_radians(), 0.35);
        prop_assert!(cubics.len() <= theirs.append_iter(tolerance * scale).count());
        for pair in cubics.windows(2) {
            prop_assert_eq!(pair[0].p3, pair[1].p0);
        }
        let drawn = approximate(&Shape::Arc(arc), &Options { cut: Cut::Count(cubics.len()), precision: Some(Precision::Full), ..Options::default() }).unwrap();
        for (ours, theirs) in cubics.iter().zip(&drawn.curve.segments) {
            let theirs = theirs.to_cubic();
            for (p, q) in [(ours.p0, theirs.p0), (ours.p1, theirs.p1), (ours.p2, theirs.p2), (ours.p3, theirs.p3)] {
                prop_assert!((p - q).hypot() <= 2e-14 * (scale + 5.0), "{p} against {q}");
            }
        }
    }
}
