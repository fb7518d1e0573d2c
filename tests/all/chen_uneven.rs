//! Formulation I on uneven and open chains against an independent solve of his equations, dense and in 256 bits.

use crate::judges::oracle;

use curveto::approximate::{Options, approximate};
use curveto::curve::control_points;
use curveto::number::Precision;
use curveto::{Angle, Arc, Circle, Cut, Method, Shape};
use kurbo::Vec2;
use oracle::real::{abs, cross, norm};
use oracle::{Point, Real, curvature_derivatives, int, parse, radians, real, to_f64};

/// The joints on the unit circle.
fn joints(degrees: &[f64]) -> Vec<Point> {
    degrees
        .iter()
        .map(|&d| {
            let (sin, cos) = radians(&real(d)).sin_cos();
            [cos, sin]
        })
        .collect()
}

/// Solves a dense system, given with its right side as the last two columns, by elimination with the largest pivot.
fn dense(mut rows: Vec<Vec<Real>>) -> Vec<Point> {
    let n = rows.len();
    for column in 0..n {
        let size = |row: &usize| to_f64(&abs(&rows[*row][column]));
        let pivot = (column..n)
            .max_by(|a, b| size(a).total_cmp(&size(b)))
            .unwrap();
        rows.swap(column, pivot);
        let divisor = rows[column][column].clone();
        let own: Vec<Real> = rows[column].iter().map(|x| x / &divisor).collect();
        for (i, row) in rows.iter_mut().enumerate() {
            if i == column {
                row.clone_from(&own);
                continue;
            }
            let factor = row[column].clone();
            for (x, y) in row.iter_mut().zip(&own) {
                *x -= &factor * y;
            }
        }
    }
    rows.iter()
        .map(|row| [row[n].clone(), row[n + 1].clone()])
        .collect()
}

/// 3 (q - p).
fn thrice(p: &Point, q: &Point) -> Point {
    [int(3) * (&q[0] - &p[0]), int(3) * (&q[1] - &p[1])]
}

/// The nodal derivatives of (7): cyclic as in (11), or with the ends fixed to these.
fn derivatives(points: &[Point], ends: Option<&[Point; 2]>) -> Vec<Point> {
    let n = points.len();
    let row = |i: usize| {
        let mut row = vec![int(0); n];
        let right = match ends {
            Some(ends) if i == 0 || i == n - 1 => {
                row[i] = int(1);
                ends[usize::from(i > 0)].clone()
            }
            _ => {
                let (before, after) = ((i + n - 1) % n, (i + 1) % n);
                row[before] = int(1);
                row[i] = int(4);
                row[after] = int(1);
                thrice(&points[before], &points[after])
            }
        };
        row.extend(right);
        row
    };
    dense((0..n).map(row).collect())
}

/// The cubics through the points with these derivatives, each from 0 to 1.
fn segments(points: &[Point], d: &[Point], closed: bool) -> Vec<Vec<Point>> {
    let n = points.len();
    let third = |p: &Point, d: &Point, sign: i32| {
        [
            &p[0] + &d[0] * int(sign) / int(3),
            &p[1] + &d[1] * int(sign) / int(3),
        ]
    };
    (0..if closed { n } else { n - 1 })
        .map(|i| {
            let j = (i + 1) % n;
            vec![
                points[i].clone(),
                third(&points[i], &d[i], 1),
                third(&points[j], &d[j], -1),
                points[j].clone(),
            ]
        })
        .collect()
}

fn drawn(shape: &Shape, cut: Cut) -> Vec<Vec<kurbo::Point>> {
    let options = Options {
        rule: Method::Chen1.into(),
        cut,
        precision: Some(Precision::Full),
        ..Options::default()
    };
    let drawing = approximate(shape, &options).unwrap();
    drawing.curve.segments.iter().map(control_points).collect()
}

fn assert_same(ours: &[Vec<kurbo::Point>], theirs: &[Vec<Point>]) {
    assert_eq!(ours.len(), theirs.len());
    for (p, q) in ours.iter().flatten().zip(theirs.iter().flatten()) {
        let off = (p.x - to_f64(&q[0])).hypot(p.y - to_f64(&q[1]));
        assert!(off < 1.5e-15, "{p:?} off by {off:e}");
    }
}

/// The points of Chen's Figure 6: four segments of 30 and four of 60 degrees.
const FIGURE_6: [f64; 8] = [0.0, 30.0, 90.0, 120.0, 180.0, 210.0, 270.0, 300.0];

#[test]
fn uneven_joints_solve_his_cyclic_system() {
    for degrees in [
        FIGURE_6.as_slice(),
        &[0.0, 100.0, 215.0],
        &[0.0, 1.0, 3.0, 40.0, 160.0, 161.0, 200.0, 310.0, 311.0],
    ] {
        let points = joints(degrees);
        let solved = segments(&points, &derivatives(&points, None), true);
        let angles = degrees.iter().map(|&d| Angle::from_degrees(d)).collect();
        let circle = Shape::Circle(Circle::new((0.0, 0.0), 1.0).unwrap());
        assert_same(&drawn(&circle, Cut::At(angles)), &solved);
    }
}

#[test]
fn an_open_arc_has_fixed_ends_with_the_circles_derivatives() {
    let cases: [&[f64]; 4] = [
        &[0.0, 90.0],
        &[0.0, 60.0, 120.0, 180.0],
        &[0.0, 20.0, 100.0],
        &[0.0, 45.0, 50.0, 170.0, 200.0],
    ];
    for degrees in cases {
        let points = joints(degrees);
        let last = points.len() - 1;
        let end = |i: usize, from: usize| {
            let a = radians(&real(degrees[from + 1] - degrees[from]));
            [-&points[i][1] * &a, &points[i][0] * &a]
        };
        let ends = [end(0, 0), end(last, last - 1)];
        let solved = segments(&points, &derivatives(&points, Some(&ends)), false);
        let sweep = Angle::from_degrees(degrees[last]);
        let arc = Arc::new(
            (0.0, 0.0),
            Vec2::new(1.0, 1.0),
            Angle::ZERO,
            Angle::ZERO,
            sweep,
        );
        let inner: Vec<Angle> = degrees[1..last]
            .iter()
            .map(|&d| Angle::from_degrees(d))
            .collect();
        let cut = if inner.is_empty() {
            Cut::Count(1)
        } else {
            Cut::At(inner)
        };
        assert_same(&drawn(&Shape::Arc(arc.unwrap()), cut), &solved);
    }
}

/// The card of chen-1 says G2 for unequal segments: a C2 spline keeps tangent and curvature, though neither is the circle's.
#[test]
fn uneven_joints_are_g2_and_not_g3_and_leave_the_circles_tangent() {
    let points = joints(&FIGURE_6);
    let d = derivatives(&points, None);
    let solved = segments(&points, &d, true);
    for (i, segment) in solved.iter().enumerate() {
        let next = &solved[(i + 1) % solved.len()];
        let (before, after) = (
            curvature_derivatives(segment, true, 1),
            curvature_derivatives(next, false, 1),
        );
        assert!(abs(&(&before[0] - &after[0])) < parse("1e-60"));
        assert!(abs(&(&before[1] - &after[1])) > parse("0.01"));
        let radial = int(1) - abs(&cross(&points[i], &d[i])) / norm(&d[i]);
        assert!(radial > parse("1e-4"), "joint {i}: {radial:.6}");
    }
}
