//! One shape asked for in three ways, as a command, as a line of `batch` and as an element of a file, is one curve: the same numbers.
//!
//! An arc of a path with more decimals than its ends have: these, which other segments share, stay as the file has them.

use curveto::batch;
use curveto::batch::spec::{LineContent, Spec};
use curveto::document;
use curveto::number::Precision;
use curveto::path;
use curveto::{Cut, Method, Options, Rule, Tolerance, approximate};
use kurbo::{ParamCurve, PathSeg, Point};
use proptest::prelude::*;

/// A shape as a line of `batch` and as an element of SVG.
#[derive(Debug, Clone)]
struct Asked {
    line: String,
    element: String,
}

/// A number of at most two decimals.
fn number(most: i32) -> impl Strategy<Value = f64> {
    (-100 * most..=100 * most).prop_map(|n| f64::from(n) / 100.0)
}

fn length() -> impl Strategy<Value = f64> {
    prop_oneof![1..400, 400..20_000].prop_map(|n| f64::from(n) / 100.0)
}

fn asked() -> impl Strategy<Value = Asked> {
    let circle = (number(90), number(90), length()).prop_map(|(x, y, r)| Asked {
        line: format!("circle {x} {y} {r}"),
        element: format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"),
    });
    let radii = (number(90), number(90), length(), length());
    let ellipse = radii.prop_map(|(x, y, rx, ry)| Asked {
        line: format!("ellipse {x} {y} {rx} {ry}"),
        element: format!("<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{rx}\" ry=\"{ry}\"/>"),
    });
    let radius = prop_oneof![
        (length(), length()),
        length().prop_map(|radius| (radius, radius))
    ];
    let ends = [number(50), number(50), number(50), number(50)];
    let arc = (ends, radius, number(180), any::<[bool; 2]>()).prop_map(
        |([x1, y1, x2, y2], (rx, ry), rotation, flags)| {
            let [large, sweep] = flags.map(u8::from);
            Asked {
                line: format!("svgarc {x1} {y1} {rx} {ry} {rotation} {large} {sweep} {x2} {y2}"),
                element: format!(
                    "<path d=\"M{x1} {y1}A{rx} {ry} {rotation} {large} {sweep} {x2} {y2}\"/>"
                ),
            }
        },
    );
    prop_oneof![circle, ellipse, arc]
}

fn cut() -> impl Strategy<Value = Cut> {
    prop_oneof![
        Just(Cut::Quarters),
        (1..40_usize).prop_map(Cut::Count),
        (1..12_usize).prop_map(Cut::Adaptive),
        (0..5_i32).prop_map(|n| Cut::Tolerance(Tolerance::Absolute(f64::powi(0.1, n)))),
        (2..6_i32).prop_map(|n| Cut::Tolerance(Tolerance::Relative(f64::powi(0.1, n)))),
    ]
}

/// The points that a reader of the path data gets.
fn points(data: &str) -> Vec<Point> {
    let curves = path::curves(data).unwrap();
    curves
        .iter()
        .flat_map(|curve| of(&curve.segments))
        .collect()
}

fn of(segments: &[PathSeg]) -> Vec<Point> {
    let first = segments.first().map(ParamCurve::start);
    let rest = segments.iter().flat_map(|segment| match *segment {
        PathSeg::Line(l) => vec![l.p1],
        PathSeg::Quad(q) => vec![q.p1, q.p2],
        PathSeg::Cubic(c) => vec![c.p1, c.p2, c.p3],
    });
    first.into_iter().chain(rest).collect()
}

fn smallest_radius(asked: &Asked) -> f64 {
    match Spec::parse(&asked.line).unwrap().subject {
        LineContent::Shape(shape) => shape.outline().map_or(0.0, |outline| {
            outline.truth.radii.x.min(outline.truth.radii.y)
        }),
        LineContent::Path(_) => 0.0,
    }
}

/// The points of a curve, and its peak error as it is stated.
type Curve = (Vec<Point>, f64);

fn single(asked: &Asked, options: &Options) -> Option<Curve> {
    let LineContent::Shape(shape) = Spec::parse(&asked.line).ok()?.subject else {
        return None;
    };
    let drawing = approximate(&shape, options).ok()?;
    Some((of(&drawing.curve.segments), drawing.error.peak()))
}

fn by_batch(asked: &Asked, options: &Options) -> Option<Curve> {
    let options = batch::Options {
        rule: options.rule,
        cut: options.cut.clone(),
        precision: options.precision,
        on_error: batch::OnError::Blank,
        ..batch::Options::default()
    };
    let answer = |measure| {
        let options = batch::Options {
            measure,
            ..options.clone()
        };
        let (mut out, line) = (Vec::new(), asked.line.clone());
        let run = batch::run(std::io::Cursor::new(line), &mut out, &options, |_, _| ());
        (String::from_utf8(out).unwrap(), run.unwrap().worst)
    };
    let (text, worst) = answer(true);
    assert_eq!(text, answer(false).0);
    (!text.trim().is_empty()).then(|| (points(text.trim()), worst.unwrap().1))
}

fn by_convert(asked: &Asked, options: &Options) -> Option<Curve> {
    let precision = match options.precision {
        Some(Precision::Fixed(decimals)) => Some(decimals),
        _ => None,
    };
    let options = document::Options {
        rule: options.rule,
        cut: options.cut.clone(),
        precision,
        measure: true,
        ..document::Options::default()
    };
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\">{}</svg>",
        asked.element
    );
    let converted = document::convert(&svg, &options).ok()?;
    let text = converted.text.into_owned();
    let data = text.split(" d=\"").nth(1)?.split('"').next()?;
    (!data.contains('A')).then(|| (points(data), converted.strayed))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn three_ways_to_ask_give_one_curve(
        asked in asked(),
        cut in cut(),
        decimals in 0..8_u8,
        method in proptest::sample::select(&Method::ALL[..]),
    ) {
        let options = Options {
            rule: Rule::Method(method),
            cut,
            precision: Some(Precision::Fixed(decimals)),
            ..Options::default()
        };
        let one = single(&asked, &options);
        prop_assert_eq!(&one, &by_batch(&asked, &options), "batch");
        // A path of a file keeps what a coarse precision would make a dot; and see above.
        let is_dot = smallest_radius(&asked) * f64::powi(10.0, decimals.into()) <= 0.5;
        let is_path = asked.element.starts_with("<path");
        if !is_path || decimals >= 4 && !is_dot {
            let (one, other) = (one.unzip(), by_convert(&asked, &options).unzip());
            prop_assert_eq!(one.0, other.0, "convert");
            // Both are bounds, at most a billionth above the truth; a file measures its segments one by one.
            let apart = one.1.zip(other.1).map_or(0.0, |(x, y)| (x - y).abs() / x.max(1e-9));
            prop_assert!(apart < 2e-9, "convert: {:?} and {:?}", one.1, other.1);
        }
    }

    #[test]
    fn a_line_of_batch_is_a_command(
        asked in asked(),
        cut in cut(),
        precision in prop_oneof![
            Just(None),
            Just(Some(Precision::Full)),
            (0..16_u8).prop_map(|decimals| Some(Precision::Fixed(decimals)))
        ],
    ) {
        let options = Options { cut, precision, ..Options::default() };
        prop_assert_eq!(single(&asked, &options), by_batch(&asked, &options));
    }
}

/// Whether rounding leaves nothing of a flat ellipse depends on where it lies and on the number of segments.
#[test]
fn files_and_commands_draw_the_same_flat_ellipses() {
    let (mut drawn, mut refused) = (0, 0);
    for n in 1..400 {
        let at = |step: u32, most: u32| f64::from(n * step % most) / 100.0;
        let (x, y, short) = (at(37, 500), at(53, 700), at(7, 59) + 0.01);
        let [rx, ry] = if n % 2 == 0 {
            [at(91, 5000) + 1.0, short]
        } else {
            [short, short]
        };
        let asked = Asked {
            line: format!("ellipse {x} {y} {rx} {ry}"),
            element: format!("<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{rx}\" ry=\"{ry}\"/>"),
        };
        let options = Options {
            cut: Cut::Count(2 + n as usize % 4),
            precision: Some(Precision::Fixed(0)),
            ..Options::default()
        };
        let one = single(&asked, &options).map(|curve| curve.0);
        let other = by_convert(&asked, &options).map(|curve| curve.0);
        assert_eq!(one, other, "{asked:?}");
        *if one.is_some() {
            &mut drawn
        } else {
            &mut refused
        } += 1;
    }
    assert!(drawn > 50 && refused > 50, "{drawn} {refused}");
}

/// The line of a side is that of the handles beside it, also where it lies on half a unit of the last decimal.
#[test]
fn handles_of_round_rectangles_lie_on_the_lines_of_their_sides() {
    let half = |n: u32| f64::from(n * 37 % 2000) / 100.0 + 0.05;
    let (mut on_sides, mut quadratics) = (0, 0);
    for n in 1..400 {
        let [x, y, rx, ry] = [n, 3 * n, 11 * n, 13 * n].map(half);
        let [width, height] = [2.0 * rx + 2.0 + half(5 * n), 2.0 * ry + 2.0 + half(7 * n)];
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect x=\"{x}\" y=\"{y}\" width=\"{width:.2}\" height=\"{height:.2}\" rx=\"{rx}\" ry=\"{ry}\"/></svg>"
        );
        let methods = [Method::Minimax, Method::QuadraticTangent];
        let options = document::Options {
            rule: methods[n as usize % 2].into(),
            cut: Cut::Count(1 + n as usize % 3),
            precision: Some((n % 3) as u8),
            ..document::Options::default()
        };
        let Some((data, curve)) = converted_curve(&svg, &options) else {
            continue;
        };
        for line in curve.segments.iter().enumerate() {
            let (i, PathSeg::Line(line)) = line else {
                continue;
            };
            let count = curve.segments.len();
            let beside = [
                curve.segments[(i + count - 1) % count],
                curve.segments[(i + 1) % count],
            ];
            let [before, after] = beside.map(|segment| match segment {
                PathSeg::Cubic(cubic) => [cubic.p1, cubic.p2],
                PathSeg::Quad(quad) => {
                    quadratics += 1;
                    [quad.p1; 2]
                }
                PathSeg::Line(_) => [line.p0; 2],
            });
            let axis = |p: Point| if line.p0.y == line.p1.y { p.y } else { p.x };
            for handle in [before[1], after[0]] {
                let off = axis(handle) - axis(line.p0);
                assert!(off.abs() < 1e-9, "{svg} {data}");
            }
            on_sides += 1;
        }
    }
    assert!(
        on_sides > 1000 && quadratics > 500,
        "{on_sides} {quadratics}"
    );
}

/// The path data that the first shape of a file became, and its curve.
fn converted_curve(svg: &str, options: &document::Options) -> Option<(String, curveto::Curve)> {
    let converted = document::convert(svg, options).unwrap();
    let data = converted.text.split(" d=\"").nth(1)?.split('"').next()?;
    Some((data.to_owned(), path::curves(data).unwrap().remove(0)))
}

/// Joints of round rectangles lie on half a unit of the last decimal, where sums of floats fall to either side.
#[test]
fn round_rectangles_close_on_their_first_point() {
    let half = |n: u32| f64::from(n * 37 % 2000) / 100.0 + 0.05;
    for n in 1..300 {
        let [x, y, width, height, rx, ry] = [n, 3 * n, 5 * n, 7 * n, 11 * n, 13 * n].map(half);
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"{rx}\" ry=\"{ry}\"/></svg>"
        );
        let options = document::Options {
            precision: Some(1),
            ..document::Options::default()
        };
        let Some((data, curve)) = converted_curve(&svg, &options) else {
            continue;
        };
        let last = curve.segments.last().unwrap();
        // A gap would be a line.
        assert!(matches!(last, PathSeg::Cubic(_)), "{svg} {data}");
    }
}
