//! Arcs in lanes have the bits of arcs one by one, whatever the instructions, and whatever shares a block with them.

use curveto::engine::{Instructions, cubics_of_arcs, cubics_of_svg_arcs};
use curveto::shape::endpoint::SvgArc;
use curveto::{Angle, Arc, Tolerance};
use kurbo::{CubicBez, Point, Vec2};
use proptest::prelude::*;

const INSTRUCTIONS: [Instructions; 3] = [
    Instructions::Target,
    Instructions::Avx2,
    Instructions::Avx512,
];

fn bits(cubics: impl Iterator<Item = CubicBez>) -> Vec<[u64; 8]> {
    let numbers = |c: CubicBez| {
        [
            c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y, c.p3.x, c.p3.y,
        ]
    };
    cubics
        .map(|cubic| numbers(cubic).map(f64::to_bits))
        .collect()
}

/// An angle in degrees: any one, or one with a short form.
fn degrees(most: f64) -> impl Strategy<Value = f64> {
    let steps = (most / 15.0) as i32;
    prop_oneof![
        -most..most,
        (-steps..=steps).prop_map(|i| f64::from(i) * 15.0)
    ]
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e3..1e3_f64,
        (-20..20_i32).prop_map(f64::from),
        -1e9..1e9_f64
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(Point::from)
}

fn radii() -> impl Strategy<Value = Vec2> {
    let circle = (1e-3..1e3_f64).prop_map(|r| Vec2::new(r, r));
    prop_oneof![circle, (1e-3..1e3_f64, 1e-3..1e6_f64).prop_map(Vec2::from)]
}

fn arc() -> impl Strategy<Value = Arc> {
    let ends = prop::option::weighted(0.2, [point(), point()]);
    (
        point(),
        radii(),
        degrees(720.0),
        degrees(1e4),
        degrees(360.0),
        ends,
    )
        .prop_map(|(center, radii, rotation, start, sweep, ends)| {
            let [rotation, start, sweep] = [rotation, start, sweep].map(Angle::from_degrees);
            let mut arc = Arc::new(center, radii, rotation, start, sweep).unwrap();
            arc.ends = ends;
            arc
        })
}

fn svg_arc() -> impl Strategy<Value = SvgArc> {
    let any = (
        point(),
        radii(),
        degrees(720.0),
        any::<[bool; 2]>(),
        point(),
    );
    // How far the end is from the start in radii: near a semicircle, where digits cancel, beyond it, not at all, not finite.
    let reach = prop_oneof![
        4 => Just(f64::NAN),
        2 => 1.97..2.01_f64,
        1 => prop::sample::select(vec![0.0, 2.0, 1e-9, f64::INFINITY, 1e200]),
    ];
    (any, reach, 0..30).prop_map(
        |((from, radii, rotation, [large_arc, sweep], to), reach, odd)| {
            let arc = SvgArc {
                from,
                radii,
                rotation: Angle::from_degrees(rotation),
                large_arc,
                sweep,
                to,
            };
            let to = if reach.is_nan() {
                to
            } else {
                from + Vec2::new(reach * radii.x, 0.0)
            };
            match odd {
                0 => SvgArc {
                    radii: Vec2::new(0.0, radii.y),
                    ..arc
                },
                1 => SvgArc {
                    radii: -radii,
                    ..arc
                },
                2 => SvgArc {
                    radii: Vec2::new(radii.x, f64::NAN),
                    ..arc
                },
                3 => SvgArc {
                    radii: Vec2::new(1e-7, 1e7),
                    ..arc
                },
                4..10 => SvgArc {
                    radii: Vec2::new(radii.x, radii.x),
                    rotation: Angle::ZERO,
                    to,
                    ..arc
                },
                _ => SvgArc { to, ..arc },
            }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn arcs_in_lanes_are_arcs_one_by_one(arcs in prop::collection::vec(arc(), 0..80), exponent in -9.0..-1.0_f64) {
        let part = 10_f64.powf(exponent);
        for tolerance in [Tolerance::Relative(part), Tolerance::Absolute(100.0 * part)] {
            let one = |arc: &Arc| bits(arc.cubics(tolerance.for_radius(arc.radii.x.max(arc.radii.y))));
            let expected: Vec<_> = arcs.iter().map(one).collect();
            for instructions in INSTRUCTIONS {
                let lanes = cubics_of_arcs(&arcs, tolerance).at_most(instructions);
                prop_assert_eq!(lanes.len(), arcs.len());
                for (cubics, expected) in lanes.zip(&expected) {
                    prop_assert_eq!(&bits(cubics), expected);
                }
            }
        }
    }

    #[test]
    fn svg_arcs_in_lanes_are_svg_arcs_one_by_one(arcs in prop::collection::vec(svg_arc(), 0..80), exponent in -9.0..-1.0_f64) {
        let tolerance = 100.0 * 10_f64.powf(exponent);
        let expected: Vec<_> = arcs.iter().map(|arc| arc.cubics(tolerance).map(bits)).collect();
        for instructions in INSTRUCTIONS {
            let lanes = cubics_of_svg_arcs(&arcs, Tolerance::Absolute(tolerance)).at_most(instructions);
            prop_assert_eq!(lanes.len(), arcs.len());
            for (cubics, expected) in lanes.zip(&expected) {
                prop_assert_eq!(&cubics.map(bits), expected);
            }
        }
    }
}

#[test]
fn ends_that_are_given_are_met_to_the_last_digit() {
    let arc = |i: i32| SvgArc {
        from: Point::new(0.1 * f64::from(i), 0.2),
        radii: Vec2::new(3.0, 5.0),
        rotation: Angle::from_degrees(33.0),
        large_arc: i % 2 == 0,
        sweep: i % 3 == 0,
        to: Point::new(1.7, 0.3 * f64::from(i)),
    };
    let arcs: Vec<_> = (0..100).map(arc).collect();
    for (arc, cubics) in arcs
        .iter()
        .zip(cubics_of_svg_arcs(&arcs, Tolerance::Relative(1e-6)))
    {
        let cubics: Vec<_> = cubics.unwrap().collect();
        assert_eq!(cubics[0].p0, arc.from);
        assert_eq!(cubics[cubics.len() - 1].p3, arc.to);
    }
}
