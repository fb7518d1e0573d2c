//! Arcs, path data, transforms, points, measures and differences.

use curveto::contour::{BezierTarget, Contour, draw};
use curveto::curve::control_points;
use curveto::diff::{Track, compare};
use curveto::measure::{Reference, fit, report};
use curveto::shape::endpoint::parse_svg_arc;
use curveto::spline::points::Points;
use curveto::spline::{self, Parametrization, Quadrature, Spline};
use curveto::{Circle, Curve, Cut, Drawing, Method, Options, Shape, approximate, number, path};
use kurbo::{Affine, ParamCurve, PathSeg, Point};

use super::{Check, ensure, is_well_formed};
use crate::judges::exact::{Exact, decimal_point};
use crate::judges::oracle::{real, to_f64};

/// What double precision loses of coordinates of this size.
fn noise(segments: &[PathSeg]) -> f64 {
    let largest = |p: Point| p.x.abs().max(p.y.abs());
    let points = segments.iter().flat_map(control_points);
    16.0 * f64::EPSILON * points.map(largest).fold(0.0, f64::max)
}

/// An SVG arc: it starts and ends where it says, and no point of it lies farther from the true one than stated.
pub fn arcs(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let Ok(arc) = parse_svg_arc(&text) else {
        return Ok(());
    };
    let Ok(shape) = arc.shape() else {
        return Ok(());
    };
    let methods = [Method::Minimax, Method::QuadraticMinimax, Method::Midpoint];
    let options = Options {
        rule: methods[input.len() % 3].into(),
        ..Options::default()
    };
    let Ok(drawing) = approximate(&shape, &options) else {
        return Ok(());
    };
    is_well_formed(&path::data([&drawing.curve], false))?;
    is_well_formed(&path::data([&drawing.curve], true))?;
    let Some(last) = drawing.curve.segments.last() else {
        return ensure(arc.from == arc.to, || "nothing is drawn".to_owned());
    };
    let round = |p: Point| Point::new(drawing.precision.round(p.x), drawing.precision.round(p.y));
    let ends = [drawing.curve.segments[0].start(), last.end()];
    let meant = [arc.from, arc.to];
    ensure(ends == meant || ends == meant.map(round), || {
        format!("it runs from {ends:?}")
    })?;
    if drawing.outline.is_none() {
        return Ok(());
    }
    is_bound(&drawing, &Exact::of_svg_arc(&arc))
}

/// Checks points of the first and the last segment against 256-bit arithmetic.
fn is_bound(drawing: &Drawing, exact: &Exact) -> Check {
    let segments = &drawing.curve.segments;
    let slack = noise(segments) / 1000.0;
    for segment in [segments.first(), segments.last()].into_iter().flatten() {
        for t in [0.25, 0.5] {
            let off = to_f64(&exact.distance(&exact_point(segment, t)));
            let error = drawing.error;
            ensure(
                off <= error.outward + slack && -off <= error.inward + slack,
                || format!("{off:e} off at {t}, stated {error:?}"),
            )?;
        }
    }
    Ok(())
}

/// A point of a Bézier by de Casteljau's steps.
fn exact_point(segment: &PathSeg, t: f64) -> crate::judges::oracle::Point {
    let mut points: Vec<_> = control_points(segment)
        .into_iter()
        .map(decimal_point)
        .collect();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| [0, 1].map(|i| &pair[0][i] * real(1.0 - t) + &pair[1][i] * real(t)))
            .collect();
    }
    points.remove(0)
}

/// Path data: what is drawn of them is read again as it is, and drawing that changes nothing.
pub fn path_data(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let Ok(contours) = path::contours(&text) else {
        return Ok(());
    };
    let options = Options::default();
    for target in [BezierTarget::Beziers, BezierTarget::Quadratics] {
        let Ok(drawing) = draw(&contours, target, &options) else {
            continue;
        };
        let peak = drawing.error().peak();
        ensure(peak.is_finite() && peak >= 0.0, || format!("peak {peak}"))?;
        let data = path::data(drawing.curves(), false);
        is_well_formed(&data)?;
        is_well_formed(&path::data(drawing.curves(), true))?;
        let again = path::contours(&data).map_err(|error| format!("{data}: {error}"))?;
        let again =
            draw(&again, BezierTarget::Beziers, &options).map_err(|error| error.to_string())?;
        let second = path::data(again.curves(), false);
        ensure(second == data, || format!("{data} becomes {second}"))?;
    }
    Ok(())
}

/// A transform: that of svgtypes, and a circle under it is drawn or refused.
pub fn transforms(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let Ok(own) = path::transform(&text) else {
        return Ok(());
    };
    let theirs: svgtypes::Transform = text
        .parse()
        .map_err(|error| format!("svgtypes refuses it: {error}"))?;
    let theirs = [theirs.a, theirs.b, theirs.c, theirs.d, theirs.e, theirs.f];
    // How much an error of a factor may grow: all of them are multiplied.
    let mut grown = 1e-12;
    for part in text.split_inclusive(')') {
        if let Ok(t) = part
            .trim_start_matches([',', ' '])
            .parse::<svgtypes::Transform>()
        {
            let size: f64 = [t.a, t.b, t.c, t.d, t.e, t.f].map(f64::abs).iter().sum();
            grown *= (1.0 + size) * (1.0 + size);
        }
        // svgtypes rounds an angle in radians before it takes off whole turns.
        let angle = part
            .split(['(', ',', ' ', ')'])
            .find_map(|word| word.parse::<f64>().ok());
        if let (Some(angle), false) = (angle, part.contains("matrix")) {
            grown *= 1.0 + angle.abs();
        }
    }
    for (a, b) in own.as_coeffs().into_iter().zip(theirs) {
        ensure((a - b).abs() <= grown || !b.is_finite(), || {
            format!("{own:?}, svgtypes {theirs:?}")
        })?;
    }
    let circle = Circle::new((0.0, 0.0), 50.0).map_err(|error| error.to_string())?;
    let options = Options {
        transform: own,
        cut: Cut::Count(4),
        ..Options::default()
    };
    approximate(&Shape::Circle(circle), &options).map_or(Ok(()), |drawing| {
        ensure(drawing.error.peak().is_finite(), || {
            format!("{:?}", drawing.error)
        })?;
        is_well_formed(&path::data([&drawing.curve], false))
    })
}

/// Points: written out they are read again, and a curve through them passes each.
pub fn points(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let forms = [Points::read(input), Points::parse(&text)];
    for points in forms.into_iter().flatten().map(|read| read.points) {
        let pair = |p: &Point| format!("{},{}\n", number::text(p.x), number::text(p.y));
        let written: String = points.iter().map(pair).collect();
        let again = Points::read(written.as_bytes()).map_err(|error| error.to_string())?;
        ensure(again.points == points, || {
            format!("{written} is read otherwise")
        })?;
        let ways = [
            Parametrization::Uniform,
            Parametrization::Chord,
            Parametrization::Centripetal,
            Parametrization::ArcLength(Quadrature::Adaptive),
        ];
        let options = spline::Options {
            parametrization: ways[input.len() % 4],
            ..spline::Options::default()
        };
        let Ok(spline) = Spline::new(points.clone(), options) else {
            continue;
        };
        let passes = |(p, cubic): (&Point, kurbo::CubicBez)| *p == cubic.p0;
        ensure(points.iter().zip(spline.segments()).all(passes), || {
            format!("it misses a point of {points:?}")
        })?;
        if let Ok(curve) = spline.curve(None, Affine::IDENTITY) {
            is_well_formed(&path::data([&curve], false))?;
        }
    }
    Ok(())
}

/// A curve of others: what is reported is finite and in order, and no point lies farther from the circle.
pub fn measure(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let Ok(curves) = path::curves(&text) else {
        return Ok(());
    };
    for curve in curves.iter().filter(|curve| curve.segments.len() <= 50) {
        let Ok((truth, _)) = fit::circle(curve, None) else {
            continue;
        };
        let Ok(report) = report(curve, &Reference::from(truth), None) else {
            continue;
        };
        let error = report.error;
        let sizes = [
            error.outward,
            error.inward,
            error.mean,
            error.mean_angle,
            error.rms,
        ];
        ensure(
            sizes.iter().all(|size| size.is_finite() && *size >= 0.0),
            || format!("{error:?}"),
        )?;
        let slack = noise(&curve.segments) + 16.0 * f64::EPSILON * truth.center.to_vec2().hypot();
        let most = error.peak * (1.0 + 1e-9) + slack;
        ensure(
            error.peak == error.outward.max(error.inward)
                && error.mean <= most
                && error.rms <= most,
            || format!("out of order: {error:?}"),
        )?;
        for segment in &curve.segments {
            for t in (0..=8).map(|i| f64::from(i) / 8.0) {
                let off = (segment.eval(t) - truth.center).hypot() - truth.radii.x;
                ensure(
                    off <= error.outward + slack && -off <= error.inward + slack,
                    || format!("{off:e} off, stated {error:?} against {truth:?}"),
                )?;
            }
        }
    }
    Ok(())
}

fn tracks(data: &str) -> Option<Vec<Track>> {
    let contours: Vec<Contour> = path::contours(data).ok()?;
    contours
        .iter()
        .map(|contour| Track::new(contour, Affine::IDENTITY).ok())
        .collect()
}

/// Two paths, line by line: each is equal to itself, both ways are alike, and no sampled point lies farther off than stated.
pub fn diff(input: &[u8]) -> Check {
    let text = String::from_utf8_lossy(input);
    let (old, new) = text.split_once('\n').unwrap_or((&text, ""));
    let (Some(old), Some(new)) = (tracks(old), tracks(new)) else {
        return Ok(());
    };
    let count = |tracks: &[Track]| tracks.iter().map(|t| t.segments.len()).sum::<usize>();
    if count(&old) + count(&new) > 200 {
        return Ok(());
    }
    let own = compare(&old, &old, 0.0).map_err(|error| error.to_string())?;
    ensure(own.is_within() && own.distance() == 0.0, || {
        format!("it differs from itself: {own:?}")
    })?;
    let ([a], [b]) = (&old[..], &new[..]) else {
        return Ok(());
    };
    let (Ok(there), Ok(back)) = (compare(&old, &new, 0.0), compare(&new, &old, 0.0)) else {
        return Err("200 segments are refused".to_owned());
    };
    let slack = noise(&a.segments) + noise(&b.segments);
    let stated = there.distance();
    ensure(
        (stated - back.distance()).abs() <= 0.01 * stated + slack,
        || format!("{stated} there, {} back", back.distance()),
    )?;
    for (from, to) in [(a, b), (b, a)] {
        let least = least_distance(&from.segments, &to.segments);
        ensure(least <= stated + slack, || {
            format!("{least} apart, stated {stated}")
        })?;
    }
    Ok(())
}

/// How far a point of one curve lies from the other at least: samples of that stand for what is within half a step.
fn least_distance(from: &[PathSeg], to: &[PathSeg]) -> f64 {
    const STEPS: u32 = 32;
    let sampled = |segment: &PathSeg| -> (Vec<Point>, f64) {
        let points = control_points(segment);
        let edge = points.windows(2).map(|pair| (pair[1] - pair[0]).hypot());
        let speed = edge.fold(0.0, f64::max) * (points.len() - 1) as f64;
        let points = (0..=STEPS).map(|i| segment.eval(f64::from(i) / f64::from(STEPS)));
        (points.collect(), speed / f64::from(2 * STEPS))
    };
    let others: Vec<_> = to.iter().map(sampled).collect();
    let nearest = |p: Point| {
        let distances = others
            .iter()
            .flat_map(|(points, half)| points.iter().map(move |q| (*q - p).hypot() - half));
        distances.fold(f64::INFINITY, f64::min)
    };
    let points = from.iter().flat_map(|segment| sampled(segment).0);
    points.map(nearest).fold(0.0, f64::max)
}

/// The path data of finished curves.
pub(super) fn is_drawn(curves: &[&Curve]) -> Check {
    is_well_formed(&path::data(curves.iter().copied(), false))
}
