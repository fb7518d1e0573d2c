//! Circles of other libraries, each drawn by that library and measured by ours. The paths in `fixtures/peers` are what
//! docs/peers.md measures; with `CURVETO_GOLDEN=1` those of the dev-dependencies and of Ghostscript are written anew.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use curveto::Method;
use curveto::curve::Curve;
use curveto::measure::{Reference, Report, report};
use curveto::method::Span;
use curveto::path;

use curveto::shape::Truth;
use kurbo::{BezPath, Point, Shape};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fixtures/peers")
}

/// What the fixture holds, after it was compared with what the peer draws now.
fn kept(name: &str, drawn: &str) -> Report {
    let file = folder().join(format!("{name}.path"));
    if std::env::var_os("CURVETO_GOLDEN").is_some() {
        fs::write(&file, format!("{}\n", drawn.trim())).unwrap();
    }
    let stored = fs::read_to_string(&file).unwrap();
    assert_eq!(
        stored.trim(),
        drawn.trim(),
        "{name} draws something else now"
    );
    measured(&stored)
}

fn measured(data: &str) -> Report {
    let curves = path::curves(data.trim()).unwrap();
    assert_eq!(curves.len(), 1);
    report(
        &curves[0],
        &Reference::from(Truth::circle(Point::ORIGIN, 1.0)),
        None,
    )
    .unwrap()
}

fn data(path: &BezPath) -> String {
    let curve = Curve {
        segments: path.segments().collect(),
        closed: true,
    };
    path::data([&curve], false)
}

/// The peak error of a method at so many segments.
fn peak(method: Method, count: usize) -> f64 {
    let span = Span::from_degrees(360.0 / count as f64);
    method.radial_error(&span).unwrap().peak()
}

#[test]
fn kurbo_draws_circles_by_minimax_and_arcs_by_midpoint() {
    let circle = kurbo::Circle::new((0.0, 0.0), 1.0);
    let found = kept("kurbo", &data(&circle.to_path(1e-3)));
    assert_eq!(found.segments, 4);
    assert!((found.error.peak - peak(Method::Minimax, 4)).abs() < 1e-11);
    let arc = kurbo::Arc::new((0.0, 0.0), (1.0, 1.0), 0.0, core::f64::consts::TAU, 0.0);
    let found = kept("kurbo-arc", &data(&arc.to_path(1e-3)));
    assert!((found.error.peak - peak(Method::Midpoint, found.segments)).abs() < 1e-11);
}

#[test]
fn tiny_skia_draws_eight_quadratics_along_the_tangents() {
    let circle = tiny_skia::PathBuilder::from_circle(0.0, 0.0, 1.0).unwrap();
    let mut path = BezPath::new();
    let at = |p: tiny_skia::Point| (f64::from(p.x), f64::from(p.y));
    for segment in circle.segments() {
        match segment {
            tiny_skia::PathSegment::MoveTo(p) => path.move_to(at(p)),
            tiny_skia::PathSegment::LineTo(p) => path.line_to(at(p)),
            tiny_skia::PathSegment::QuadTo(a, p) => path.quad_to(at(a), at(p)),
            tiny_skia::PathSegment::CubicTo(a, b, p) => path.curve_to(at(a), at(b), at(p)),
            tiny_skia::PathSegment::Close => path.close_path(),
        }
    }
    let found = kept("tiny-skia", &data(&path));
    assert_eq!(found.segments, 8);
    // Its coordinates have 24 bits.
    assert!((found.error.peak - peak(Method::QuadraticTangent, 8)).abs() < 1e-6);
}

#[test]
fn lyon_draws_cubics_by_curvature_and_quadratics_along_the_tangents() {
    let arc = lyon_geom::Arc::circle(lyon_geom::point(0.0, 0.0), 1.0);
    let at = |p: lyon_geom::Point<f64>| (p.x, p.y);
    let (mut cubics, mut quadratics) = (BezPath::new(), BezPath::new());
    for path in [&mut cubics, &mut quadratics] {
        path.move_to((1.0, 0.0));
    }
    arc.for_each_cubic_bezier(&mut |c| cubics.curve_to(at(c.ctrl1), at(c.ctrl2), at(c.to)));
    arc.for_each_quadratic_bezier(&mut |q| quadratics.quad_to(at(q.ctrl), at(q.to)));
    let cubic = kept("lyon", &data(&cubics));
    let quadratic = kept("lyon-quadratic", &data(&quadratics));
    assert_eq!((cubic.segments, quadratic.segments), (4, 8));
    // Both are bounds, each with the rounding of its own points.
    assert!((cubic.error.peak - peak(Method::Curvature, 4)).abs() < 1e-13);
    assert!((quadratic.error.peak - peak(Method::QuadraticTangent, 8)).abs() < 1e-13);
}

#[test]
fn ghostscript_draws_by_midpoint() {
    let output = Command::new("gs")
        .args(["-q", "-dNODISPLAY", "-dBATCH", "-dNOPAUSE"])
        .arg(folder().join("ghostscript.ps"))
        .output()
        .expect("Ghostscript (gs) is one of the judges: apt-get install ghostscript");
    let found = kept("ghostscript", &String::from_utf8(output.stdout).unwrap());
    assert_eq!(found.segments, 4);
    // It prints six digits.
    assert!((found.error.peak - peak(Method::Midpoint, 4)).abs() < 1e-6);
}

#[test]
fn cairo_draws_by_midpoint_within_its_tolerance_of_a_tenth_of_a_pixel() {
    for (radius, count) in [(100.0, 4), (10_000.0, 8)] {
        let file = folder().join(format!("cairo-{radius}.path"));
        let stored = fs::read_to_string(file).unwrap();
        let curves = path::curves(stored.trim()).unwrap();
        let reference = Reference::from(Truth::circle(Point::ORIGIN, radius));
        let found = report(&curves[0], &reference, None).unwrap();
        assert_eq!(found.segments, count);
        assert!(found.error.peak < 0.1);
        // Its coordinates are multiples of 1/256.
        assert!((found.error.peak - radius * peak(Method::Midpoint, count)).abs() < 1.0 / 256.0);
    }
}
