//! Numbers of which nothing can be drawn, refused wherever they enter the library.

use core::fmt::Debug;
use std::io::ErrorKind;

use curveto::approximate::approximate_at_extremes;
use curveto::arcs;
use curveto::batch;
use curveto::compare::{Comparison, Criterion};
use curveto::contour::{BezierTarget, Contour, Step, draw};
use curveto::engine::cubics_of_arcs;
use curveto::error::{PictureError, UnmeasurableError};
use curveto::joints::MOST_SEGMENTS;
use curveto::measure::fit::{self, FitTo};
use curveto::measure::profile::{Quantity, along};
use curveto::measure::samples::samples;
use curveto::measure::{Reference, report};
use curveto::method::Span;
use curveto::picture::plot::Chart;
use curveto::picture::size::Size;
use curveto::picture::style::{Show, Style};
use curveto::shape::Truth;
use curveto::sphere::{self, Sphere, View};
use curveto::write::{self, Format, Image};
use curveto::{
    Angle, Arc, Circle, Cut, Ellipse, Error, Options, Rule, Shape, Tolerance, approximate, diff,
    document,
};
use kurbo::{Affine, CubicBez, Line, PathSeg, Point};

const NO_NUMBERS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn circle() -> Circle {
    Circle::new((0.0, 0.0), 10.0).unwrap()
}

fn quarter() -> Arc {
    let [none, sweep] = [0.0, 90.0].map(Angle::from_degrees);
    Arc::new((0.0, 0.0), (10.0, 10.0), none, none, sweep).unwrap()
}

fn cut(cut: Cut) -> Options {
    Options {
        cut,
        ..Options::default()
    }
}

fn assert_refused<T>(drawn: Result<T, Error>, number: impl Debug) {
    assert!(drawn.err().is_some(), "{number:?}");
}

#[test]
fn angles_of_shapes_are_finite() {
    let none = Angle::ZERO;
    for number in NO_NUMBERS {
        let no_angle = Angle::from_degrees(number);
        assert_refused(Ellipse::new((0.0, 0.0), (2.0, 1.0), no_angle), number);
        for [rotation, start, sweep] in [
            [no_angle, none, none],
            [none, no_angle, none],
            [none, none, no_angle],
        ] {
            let arc = Arc::new((0.0, 0.0), (2.0, 1.0), rotation, start, sweep);
            assert_refused(arc, number);
        }
    }
}

#[test]
fn fields_of_shapes_are_checked_where_they_are_drawn() {
    let drawn = |shape| approximate(&shape, &cut(Cut::Adaptive(5)));
    for number in NO_NUMBERS.into_iter().chain([-1.0, 0.0]) {
        let radius = Circle {
            radius: number,
            ..circle()
        };
        assert_refused(drawn(Shape::Circle(radius)), number);
        let mut arc = quarter();
        arc.radii.y = number;
        assert_refused(drawn(Shape::Arc(arc)), number);
    }
    for number in NO_NUMBERS {
        let start = Angle::from_degrees(number);
        assert_refused(drawn(Shape::Circle(Circle { start, ..circle() })), number);
        let mut arcs = [quarter(); 3];
        arcs[0].start = start;
        arcs[1].rotation = start;
        arcs[2].ends = Some([(number, 0.0).into(), (0.0, 10.0).into()]);
        for arc in arcs {
            assert_refused(drawn(Shape::Arc(arc)), number);
        }
    }
    let mut arc = quarter();
    arc.sweep = Angle::from_degrees(400.0);
    assert_refused(drawn(Shape::Arc(arc)), arc.sweep);
}

#[test]
fn a_literal_handle_is_at_most_a_thousand_million() {
    let right_angle = Span::from_degrees(90.0);
    for number in NO_NUMBERS.into_iter().chain([1.000_001e9, -1e308]) {
        let rule = Rule::Handle(number);
        assert_refused(rule.piece(&right_angle), number);
        assert_refused(rule.radial_error(&right_angle), number);
        assert_refused(quarter().cubics_by(rule, 1), number);
        assert_refused(
            Comparison::new(&[rule], &[4], Criterion::Peak, None),
            number,
        );
        let by_span = Comparison::by_span(&[rule], &[90.0], Criterion::Peak);
        assert_refused(by_span, number);
        for shape in [Shape::Circle(circle()), Shape::Arc(quarter())] {
            let options = Options {
                rule,
                ..Options::default()
            };
            assert_refused(approximate(&shape, &options), number);
        }
    }
    assert!(Rule::Handle(-1e9).piece(&right_angle).is_ok());
}

#[test]
fn joints_that_are_no_numbers_are_called_so() {
    for shape in [Shape::Circle(circle()), Shape::Arc(quarter())] {
        for number in NO_NUMBERS {
            let joints = [30.0, number].map(Angle::from_degrees).to_vec();
            let drawn = approximate(&shape, &cut(Cut::At(joints)));
            assert!(matches!(drawn, Err(Error::NotFinite { .. })), "{drawn:?}");
        }
    }
}

#[test]
fn parts_between_extremes_are_so_many_segments_at_most() {
    let shape = Shape::Circle(circle());
    for count in [0, MOST_SEGMENTS / 4 + 1, 100_000_000, usize::MAX] {
        let drawn = approximate_at_extremes(&shape, false, &cut(Cut::Count(count)));
        assert!(matches!(drawn, Err(Error::Count { .. })), "{count}");
    }
    for own in [Cut::Adaptive(5), Cut::At(vec![Angle::ZERO])] {
        let drawn = approximate_at_extremes(&shape, false, &cut(own));
        assert!(matches!(drawn, Err(Error::Joints(_))));
    }
}

#[test]
fn a_batch_answers_in_lines_on_as_many_threads_as_serve() {
    let run = |format, jobs| {
        let options = batch::Options {
            format,
            jobs,
            ..batch::Options::default()
        };
        let mut out = Vec::new();
        batch::run(&b"circle 0 0 50\n"[..], &mut out, &options, |_, _| ()).map(|_| out)
    };
    assert!(
        run(Format::Path, usize::MAX)
            .unwrap()
            .starts_with(b"M50 0C")
    );
    let others = Format::ALL
        .iter()
        .copied()
        .filter(|format| !matches!(format, Format::Path | Format::Json | Format::Ps));
    for format in others {
        let refused = run(format, 1).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::InvalidInput, "{format}");
    }
}

#[test]
fn a_sphere_s_fields_are_checked_where_it_is_seen() {
    let sphere = Sphere::new((0.0, 0.0), 100.0, 4, 1).unwrap();
    let options = sphere::Options::default();
    let many = usize::MAX;
    for wrong in [
        Sphere {
            parallels: many,
            ..sphere
        },
        Sphere {
            meridians: many,
            ..sphere
        },
        Sphere {
            radius: f64::NAN,
            ..sphere
        },
    ] {
        assert_refused(wrong.seen(View::default(), &options), wrong);
    }
}

#[test]
fn two_drawings_are_compared_within_a_distance() {
    for tolerance in NO_NUMBERS.into_iter().chain([-1.0]) {
        assert_refused(diff::compare(&[], &[], tolerance), tolerance);
    }
    assert!(diff::compare(&[], &[], 0.0).is_ok());
    let line = |far| diff::Track {
        segments: vec![PathSeg::Line(Line::new((0.0, 0.0), (far, 1.0)))],
        ..diff::Track::default()
    };
    let (one, none) = ([line(1.0)], [diff::Track::default()]);
    assert!(diff::compare(&one, &one, 0.0).is_ok());
    for [old, new] in [[&one, &none], [&none, &one]] {
        let refused = diff::compare(old, new, 0.0);
        let empty = Error::Unmeasurable(UnmeasurableError::Empty);
        assert_eq!(refused, Err(empty));
    }
    for far in NO_NUMBERS {
        assert_refused(diff::compare(&one, &[line(far)], 0.0), far);
    }
}

#[test]
fn an_arc_of_more_than_a_turn_is_a_whole_one() {
    for sweep in [1e9, -1e9, 361.0, f64::NAN, f64::INFINITY] {
        let arc = |sweep| {
            let mut arc = quarter();
            arc.sweep = Angle::from_degrees(sweep);
            arc
        };
        let whole = arc(360.0_f64.copysign(sweep));
        let cubics: Vec<CubicBez> = whole.cubics(1e-3).collect();
        assert_eq!(arc(sweep).cubics(1e-3).collect::<Vec<_>>(), cubics);
        let arcs = [arc(sweep); 3];
        let many = cubics_of_arcs(&arcs, Tolerance::Absolute(1e-3));
        assert!(many.into_iter().all(|own| own.eq(cubics.iter().copied())));
        let by = arc(sweep).cubics_by(Rule::default(), 4).unwrap();
        assert!(by.eq(whole.cubics_by(Rule::default(), 4).unwrap()));
    }
}

#[test]
fn handles_of_converted_documents_are_checked_and_never_overflow() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1e10"/></svg>"#;
    let options = |handle| document::Options {
        rule: Rule::Handle(handle),
        ..document::Options::default()
    };
    for handle in NO_NUMBERS.into_iter().chain([1e20]) {
        assert_refused(options(handle).check(), handle);
        assert_eq!(document::convert(svg, &options(handle)).unwrap().text, svg);
    }
    // Its points are beyond the whole numbers of 64 bits.
    let kept = document::convert(svg, &options(-1e9)).unwrap();
    assert_eq!(kept.text, svg);
}

#[test]
fn looks_are_checked_in_every_picture() {
    let drawing = approximate(&Shape::Circle(circle()), &Options::default()).unwrap();
    let written = |format, style| {
        let options = write::Options {
            style,
            ..write::Options::default()
        };
        write::write(&drawing, format, &options)
    };
    for number in NO_NUMBERS.into_iter().chain([-1.0, 0.0]) {
        for sides in [[number, 10.0], [10.0, number]] {
            let size = Some(Size::plain(sides));
            for format in Image::ALL.iter().copied().map(Format::Image) {
                let style = Style {
                    size,
                    ..Style::default()
                };
                let is_side = matches!(
                    written(format, style),
                    Err(Error::Picture(PictureError::Side(_)))
                );
                assert!(is_side, "{format} {number}");
            }
            let comparison = Comparison::new(&[], &[4], Criterion::Peak, None).unwrap();
            let chart = Chart::comparison(&comparison);
            assert_refused(write::plot(&chart, Image::Svg, size), number);
            assert_refused(write::plot(&chart, Image::Png, size), number);
        }
        let error = Style {
            show: Show {
                error: Some(number),
                ..Show::default()
            },
            ..Style::default()
        };
        assert_refused(written(Format::Image(Image::Svg), error), number);
    }
    for number in NO_NUMBERS.into_iter().chain([-1.0]) {
        let stroke = Style {
            stroke_width: Some(number),
            ..Style::default()
        };
        let margin = Style {
            margin: Some(number),
            ..Style::default()
        };
        for style in [stroke, margin] {
            assert_refused(written(Format::Image(Image::Svg), style), number);
        }
    }
}

#[test]
fn a_machine_moves_at_a_positive_feed() {
    let drawing = approximate(&Shape::Circle(circle()), &Options::default()).unwrap();
    for number in NO_NUMBERS.into_iter().chain([-1.0, 0.0]) {
        let options = write::Options {
            feed: Some(number),
            ..write::Options::default()
        };
        assert_refused(write::write(&drawing, Format::Gcode, &options), number);
    }
}

#[test]
fn a_reference_has_positive_radii() {
    let drawing = approximate(&Shape::Circle(circle()), &Options::default()).unwrap();
    for number in NO_NUMBERS.into_iter().chain([-1.0, 0.0, f64::MAX]) {
        for radii in [(number, 10.0), (10.0, number)] {
            let axis = (1.0, 0.0).into();
            let truth = Truth::new((0.0, 0.0).into(), radii.into(), axis);
            let reference = Reference::from(truth);
            assert_refused(report(&drawing.curve, &reference, None), radii);
            assert_refused(samples(&drawing.curve, &reference, 3), radii);
        }
    }
}

#[test]
fn a_profile_of_no_steps_is_where_each_segment_starts() {
    let drawing = approximate(&Shape::Circle(circle()), &Options::default()).unwrap();
    let reference = Reference::from(&drawing.outline.unwrap());
    for quantity in [Quantity::Drawing, Quantity::Error] {
        let along = along(&drawing.curve, &reference, quantity, 0);
        assert!(along.len() == 4 && along.iter().all(|points| points.len() == 1));
        assert!(along.iter().flatten().all(|(x, y)| (x + y).is_finite()));
    }
}

#[test]
fn a_circle_is_fitted_at_any_size() {
    let drawing = approximate(&Shape::Circle(circle()), &Options::default()).unwrap();
    let fitted = |size, to| {
        let curve = drawing.curve.transformed(Affine::scale(size));
        fit::circle(&curve, Some(to))
    };
    for to in [FitTo::Joints, FitTo::Curve] {
        let (whole, right) = fitted(1.0, to).unwrap();
        for size in [1e-170, 1e148] {
            let (truth, fit) = fitted(size, to).unwrap();
            let off = (truth.radii.x / size - whole.radii.x).abs();
            assert!(off < 1e-13, "{size:e}: {off:e}");
            let off = (fit.rms / size - right.rms).abs();
            assert!(off < 1e-13, "{size:e}: {off:e}");
        }
        assert_refused(fitted(1e150, to), to);
        assert_refused(fitted(f64::NAN, to), to);
    }
}

/// What contours become in each way; what of it is refused.
fn drawn(contours: &[Contour], map: Affine, tolerance: Tolerance) -> Vec<Error> {
    let lines = arcs::Options {
        tolerance: Some(tolerance),
        transform: map,
        ..arcs::Options::default()
    };
    let beziers = Options {
        cut: Cut::Tolerance(tolerance),
        transform: map,
        ..Options::default()
    };
    let targets = [BezierTarget::Beziers, BezierTarget::Quadratics];
    let drawn = targets.map(|target| draw(contours, target, &beziers));
    let chords = [arcs::lines(contours, &lines), arcs::arcs(contours, &lines)];
    drawn
        .into_iter()
        .chain(chords)
        .filter_map(Result::err)
        .collect()
}

#[test]
fn a_path_beyond_the_range_is_refused_by_its_segment() {
    let contour = |far: f64| {
        let (middle, end) = (Point::new(1.0, 2.0), Point::new(far, 5.0));
        let cubic = CubicBez::new(middle, Point::new(2.0, 1.0), Point::new(3.0, 7.0), end);
        Contour {
            steps: vec![
                Step::line(Point::ORIGIN, middle),
                Step::Given(PathSeg::Cubic(cubic)),
            ],
            closed: false,
        }
    };
    let tolerance = Tolerance::Absolute(0.1);
    let near = contour(9.0);
    assert_eq!(
        drawn(core::slice::from_ref(&near), Affine::IDENTITY, tolerance),
        []
    );
    for far in NO_NUMBERS.into_iter().chain([1e150]) {
        let errors = drawn(&[near.clone(), contour(far)], Affine::IDENTITY, tolerance);
        assert_eq!(errors.len(), 4, "{far}");
        let placed = |error: &Error| {
            matches!(
                error,
                Error::Segment {
                    subpath: 2,
                    segment: 2,
                    ..
                }
            )
        };
        assert!(errors.iter().all(placed), "{far}: {errors:?}");
    }
    let mapped = drawn(&[near, contour(1e149)], Affine::scale(10.0), tolerance);
    assert_eq!(mapped.len(), 4);
}

#[test]
fn a_tolerance_is_positive_and_finite_wherever_it_is_asked_for() {
    let cubic = CubicBez::new((0.0, 0.0), (0.0, 50.0), (100.0, 50.0), (100.0, -30.0));
    let contours = [Contour {
        steps: vec![Step::Given(PathSeg::Cubic(cubic)), Step::Arc(quarter())],
        closed: false,
    }];
    for size in NO_NUMBERS.into_iter().chain([0.0, -1.0, 1e-320]) {
        for tolerance in [Tolerance::Absolute(size), Tolerance::Relative(size)] {
            let errors = drawn(&contours, Affine::IDENTITY, tolerance);
            assert_eq!(errors.len(), 4, "{tolerance:?}");
        }
    }
    for text in ["0", "0%", "-1", "nan", "inf%", "1e-323%", "1e309"] {
        assert!(text.parse::<Tolerance>().is_err(), "{text}");
    }
}
