//! Bounds of a distance that is stated, and where its extremes are looked for.

use kurbo::{Affine, CubicBez, Line, ParamCurve, PathSeg, Point, QuadBez, Vec2};

use super::{EPSILON, apart};
use crate::measure::radial::{DECIMAL_NOISE, NOISE, Profile, error, peak_nearly};
use crate::numeric::bernstein::Polynomial;
use crate::numeric::double::Double;
use crate::shape::Truth;
use crate::{Angle, Circle, Ellipse, Shape};

/// A curve near the upper right quarter of the unit circle, times a factor, some lengths of whose handles are off.
fn quarter(factor: f64, off: f64) -> CubicBez {
    let p = |x: f64, y: f64| Point::new(factor * x, factor * y);
    CubicBez::new(
        p(1.0, 0.0),
        p(1.0, 0.55 + off),
        p(0.553 + off, 1.0),
        p(0.0, 1.0),
    )
}

#[test]
fn roundings_of_the_excess_make_the_margin() {
    let truth = Truth::circle(Point::ORIGIN, 2.0);
    let mut profile = Profile::new(&PathSeg::Cubic(quarter(2.0, 0.0)), &truth);
    profile.excess = Polynomial::new(&[0.0, 0.25, -0.5, 0.75, -1.0, 0.5, 0.25]);
    let margin = |profile: &Profile, t: f64, distance: f64| {
        let [low, high] = profile.bounds(t, distance);
        assert!(apart(high - distance, distance - low) < 1e-15);
        // The wider of both, as both are rounded.
        (high - low) / 2.0
    };
    // An end is one coefficient.
    for t in [0.0, 1.0] {
        assert!(apart(margin(&profile, t, 1.5), 4.0 * EPSILON * 1.5) < EPSILON);
    }
    // Nine roundings of the largest coefficient over twice the radius, and a little more.
    let rough = 9.0 * EPSILON * 0.6 / 2.0;
    assert_eq!(profile.rounding(1.0), rough);
    let distance = 1e-5;
    let expected = 4.0 * EPSILON * distance + rough;
    assert!(apart(margin(&profile, 0.3, distance), expected) < 1e-4 * rough);
    // Where that is much of it, those of the sizes at the place; the place itself is known less well.
    let line: [f64; 7] = core::array::from_fn(|i| 0.5 - i as f64 / 4.0);
    profile.excess = Polynomial::new(&line);
    let distance = 1e-7;
    let sizes = profile.excess.sizes().at(0.25);
    let expected = 1e-11 * distance + profile.rounding(sizes);
    assert!(apart(margin(&profile, 0.25, distance), expected) < 1e-5 * expected);
    // Far inside a point may be nearer to the centre than its place tells.
    let deep = -1.25;
    let more = margin(&profile, 0.25, deep) - profile.nearer(0.25);
    assert!(apart(more, 4.0 * EPSILON * 1.25 + profile.rounding(1.0)) < 2.0 * EPSILON);
}

#[test]
fn another_step_makes_an_extreme_exact() {
    for factor in [1.0, 3.0] {
        let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap());
        let outline = circle.outline().unwrap();
        let truth = outline.transformed(Affine::scale(factor)).unwrap().truth;
        let profile = Profile::new(&PathSeg::Cubic(quarter(factor, 0.0)), &truth);
        let mut extremes = vec![];
        profile.visit_extremes(|t, distance| extremes.push((t, distance)));
        let inner: Vec<_> = extremes
            .iter()
            .filter(|(t, _)| *t > 0.0 && *t < 1.0)
            .collect();
        assert_eq!(inner.len(), 3);
        for &&(t, distance) in &inner {
            for off in [-1e-7, 0.0, 1e-7] {
                let [low, high] = profile.bounds_exactly(t + off).unwrap();
                assert!(high - low < 1e-18 * factor, "{}", high - low);
                assert!(apart(high, distance) < 1e-15 * factor && low < high);
            }
        }
        // Farther inside than a tenth of the radius it says nothing.
        for (off, is_told) in [(-0.12, true), (-0.3, false)] {
            let profile = Profile::new(&PathSeg::Cubic(quarter(factor, off)), &truth);
            let mut middle = f64::NAN;
            profile.visit_extremes(|t, _| {
                if apart(t, 0.5) < 0.1 {
                    middle = t;
                }
            });
            let depth = profile.at(middle) / factor;
            assert_eq!(depth > -0.1, is_told, "{depth}");
            assert!(depth < -0.04, "{depth}");
            assert_eq!(
                profile.bounds_exactly(middle).is_some(),
                is_told,
                "{factor}"
            );
        }
    }
}

#[test]
fn what_is_exactly_nothing_is_stated_as_nothing() {
    let truth = Truth::circle(Point::ORIGIN, 1.0);
    let stated = |to: Point| error(&[PathSeg::Line(Line::new((1.0, 0.0), to))], &truth);
    let nothing = stated(Point::new(1.0, 0.0));
    assert_eq!([nothing.outward, nothing.inward], [0.0; 2]);
    // What twice the digits may be off is added to all else.
    let tiny = stated(Point::new(1.0, 1e-12));
    assert_eq!(tiny.inward, 0.0);
    assert!(apart(tiny.outward - 5e-25, NOISE + DECIMAL_NOISE) < 1e-6 * NOISE);
}

#[test]
fn a_profile_crosses_where_its_excess_changes_its_sign() {
    let truth = Truth::circle(Point::ORIGIN, 1.0);
    let line = PathSeg::Line(Line::new((0.5, -1.0), (0.5, 1.0)));
    let profile = Profile::new(&line, &truth);
    let crossings: Vec<f64> = profile.crossings().iter().collect();
    let high = f64::midpoint(1.0, libm::sqrt(0.75));
    assert_eq!(crossings.len(), 2);
    assert!(apart(crossings[0], 1.0 - high) < 1e-15 && apart(crossings[1], high) < 1e-15);
}

#[test]
fn a_search_finds_the_peaks_at_the_tips_of_flat_ellipses() {
    for (flatness, round) in (1..=6).flat_map(|i| (0..24).map(move |j| (i, j))) {
        let radii = (100.0, libm::pow(10.0, 2.0 - f64::from(flatness)));
        let turned = Angle::from_degrees(15.0 * f64::from(round));
        let ellipse = Shape::Ellipse(Ellipse::new((30.0, -20.0), radii, turned).unwrap());
        let outline = ellipse.outline().unwrap();
        let off = 0.003 * f64::from(round % 5 - 2);
        // Round a tip, beyond it and within, from one side to the other.
        let at = |along: f64, across: f64| outline.placement * Point::new(along, across);
        let reach = 1.0 + off;
        let curve = CubicBez::new(
            at(0.2, 1.0),
            at(reach, 0.9 + off),
            at(reach, -0.9),
            at(0.1 + off, -1.01),
        );
        let segment = PathSeg::Cubic(curve);
        let stated = error([&segment], &outline.truth);
        let (mut outward, mut inward) = (0.0_f64, 0.0_f64);
        Profile::new(&segment, &outline.truth).visit_extremes(|t, distance| {
            assert!((0.0..=1.0).contains(&t) && curve.eval(t).is_finite());
            outward = outward.max(distance);
            inward = inward.max(-distance);
        });
        for (found, stated) in [(outward, stated.outward), (inward, stated.inward)] {
            assert!(
                found <= stated && found > 0.9999 * stated - 1e-12,
                "{flatness} {round}: {found} of {stated}"
            );
        }
    }
}

#[test]
fn the_coordinates_of_a_profile_are_about_its_centre() {
    let arc = crate::shape::endpoint::parse_svg_arc("M10 0A8 3 20 0 1 4 4").unwrap();
    let outline = arc.shape().unwrap().outline().unwrap();
    let ends = outline.ends.unwrap();
    let segment = PathSeg::Line(Line::new(ends[0], ends[1]));
    let radii = outline.truth.radii;
    let profile = Profile::new(&segment, &outline.truth);
    let [first, .., last] = *profile.framed.points();
    for point in [first, last] {
        // In the frame the ellipse is a circle.
        let [x, y] = profile.about_center(point).map(Double::value);
        let radius = profile.exact.radius().value();
        assert!(apart(Vec2::new(x, y).hypot(), radius) < 1e-14, "{x} {y}");
    }
    let [x, y] = profile.coordinates();
    for t in [0.0, 1.0] {
        let q = Vec2::new(x.at(t) / radii.x, y.at(t) / radii.y);
        assert!(apart(q.x * q.x + q.y * q.y, 1.0) < 1e-12, "{q:?}");
    }
}

#[test]
fn another_step_is_off_by_the_square_of_what_it_leaves() {
    let truth = Truth::circle(Point::ORIGIN, 3.0);
    let profile = Profile::new(&PathSeg::Cubic(quarter(3.0, 0.0)), &truth);
    let mut told = 0;
    profile.visit_extremes(|t, distance| {
        if t == 0.0 || t == 1.0 {
            return;
        }
        for off in [-1e-4, 1e-4] {
            let bend = |t: f64| profile.excess.derivative().derivative().at(t);
            let slope = |t: f64| profile.excess.derivative().at(t);
            let next = t + off - slope(t + off) / bend(t + off);
            let [excess, slope] = profile.framed.excess_at(next);
            let found = excess / (3.0 + libm::sqrt(9.0 + excess));
            // Half of F'²/F'' over twice the radius is what it is off, a little more is stated.
            let expected = 0.6 * slope * slope / (bend(next).abs() * 3.0);
            let [low, high] = profile.bounds_exactly(t + off).unwrap();
            let rounding = 4.0 * EPSILON * distance.abs();
            assert!(apart((high - low) / 2.0, expected + rounding) < 0.01 * expected + 1e-19);
            assert!(low <= distance + 1e-18 && distance <= high + 1e-18);
            assert!(apart(f64::midpoint(low, high), found) < 1e-18);
            told += 1;
        }
    });
    assert_eq!(told, 6);
}

#[test]
fn a_root_beside_the_centre_is_off_by_what_its_derivatives_leave() {
    let truth = Truth::circle(Point::ORIGIN, 2.0);
    for (v, w) in [
        (3.0, 0.0),
        (0.0, 4.0),
        (1e-4, 5.0),
        (0.5, 4.0),
        (1e-9, 1e-9),
    ] {
        // p' is v and p'' is w at t = 1/2.
        let at = |t: f64| Point::new(v * (t - 0.5), 0.5 * w * (t - 0.5) * (t - 0.5));
        let middle = Point::new(0.0, -0.125 * w);
        let quad = QuadBez::new(at(0.0), middle, at(1.0));
        let mut profile = Profile::new(&PathSeg::Quad(quad), &truth);
        profile.excess = Polynomial::new(&[4.0; 5]);
        let rounding = 64.0 * EPSILON * 4.0;
        let roots = [
            rounding / (v * v),
            libm::sqrt(rounding / (v * w)),
            libm::cbrt(rounding / (w * w)),
        ];
        let off = roots.into_iter().fold(1.0_f64, f64::min);
        let expected = v * off + w * off * off;
        let found = profile.nearer(0.5);
        assert!(apart(found, expected) < 1e-9 * expected, "{v} {w}: {found}");
    }
}

#[test]
fn a_peak_is_known_nearly_or_beyond_a_limit() {
    let ways = [25.0, 50.0].into_iter().flat_map(|radius| {
        let off = [0.02, -0.02, 0.001, -0.001].into_iter();
        off.map(move |off| (radius, off))
    });
    for (radius, off) in ways {
        let truth = Truth::new(Point::ORIGIN, Vec2::new(50.0, radius), Vec2::new(1.0, 0.0));
        let flat = |p: Point| Point::new(p.x, radius / 50.0 * p.y);
        let CubicBez { p0, p1, p2, p3 } = quarter(50.0, off);
        let segment = PathSeg::Cubic(CubicBez::new(flat(p0), flat(p1), flat(p2), flat(p3)));
        let peak = error([&segment], &truth).peak();
        let [least, most] = peak_nearly([&segment], &truth, f64::INFINITY);
        assert!(
            least <= peak && peak <= most && most < 1.02 * least,
            "{off}"
        );
        let [least, most] = peak_nearly([&segment], &truth, 1.1 * peak);
        assert!(
            least <= peak && peak <= most && most < 1.02 * least,
            "{off}"
        );
        // On a circle the limit saves nothing.
        let [least, most] = peak_nearly([&segment], &truth, 0.9 * peak);
        assert!(least > 0.9 * peak && least <= peak);
        assert_eq!(most == f64::INFINITY, !truth.is_circle(), "{off}");
    }
}

#[test]
fn lines_and_quadratics_keep_their_parameter() {
    let truth = Truth::circle(Point::ORIGIN, 1.0);
    let (a, b) = (Point::new(-1.0, 0.1), Point::new(1.0, 0.1));
    let line = PathSeg::Line(Line::new(a, b));
    let quad = PathSeg::Quad(QuadBez::new(a, Point::new(0.2, 0.1), b));
    for (segment, x) in [(line, -0.2), (quad, -0.104)] {
        // Near the centre the point itself is taken.
        let distance = Profile::new(&segment, &truth).at(0.4);
        assert!(
            apart(distance, f64::hypot(x, 0.1) - 1.0) < 1e-15,
            "{distance}"
        );
        let ellipse = Truth::new(Point::ORIGIN, Vec2::new(4.0, 2.0), Vec2::new(1.0, 0.0));
        let stated = error([&segment], &ellipse);
        assert!(apart(stated.inward, 1.9) < 1e-12 && stated.outward == 0.0);
    }
}
