//! Circles, ellipses and round rectangles, from each of their points and in both senses; and what is nearly one.

use super::*;

/// The part of a quarter's radius that its handles take.
const HANDLE: f64 = 0.552_284_75;

/// The attributes of the shape that path data are, and whether it starts alike.
fn found(d: &str) -> Option<(String, bool)> {
    let whole = find(d, 0..d.len(), None)?;
    let text = String::from_utf8(whole.attributes(b'"')).unwrap();
    Some((text.replace('"', ""), whole.starts_alike))
}

/// A closed outline, a line or a cubic a piece, as path data that begin with the piece `first`.
fn data(pieces: &[PathSeg], first: usize, backwards: bool) -> String {
    let mut pieces: Vec<PathSeg> = pieces.to_vec();
    pieces.rotate_left(first);
    if backwards {
        pieces = pieces.iter().rev().map(PathSeg::reverse).collect();
    }
    let point = |p: Point| format!("{:.3} {:.3}", p.x, p.y);
    let text = |piece: PathSeg| match piece {
        PathSeg::Line(line) => format!("L{}", point(line.p1)),
        PathSeg::Quad(_) => unreachable!(),
        PathSeg::Cubic(c) => format!("C{} {} {}", point(c.p1), point(c.p2), point(c.p3)),
    };
    let start = format!("M{}", point(pieces[0].start()));
    let texts: Vec<String> = pieces.into_iter().map(text).collect();
    format!("{start}{}Z", texts.concat())
}

/// A quarter from `from` to `to`, along the x axis first or last.
fn quarter(from: Point, to: Point, along_x: bool) -> PathSeg {
    let corner = if along_x {
        Point::new(to.x, from.y)
    } else {
        Point::new(from.x, to.y)
    };
    PathSeg::Cubic(CubicBez::new(
        from,
        from.lerp(corner, HANDLE),
        to.lerp(corner, HANDLE),
        to,
    ))
}

/// A round rectangle from the start of its upper side clockwise: eight pieces, lines first.
fn round_rect_pieces([x, y, w, h]: [f64; 4], [rx, ry]: [f64; 2]) -> Vec<PathSeg> {
    let p = Point::new;
    let (right, bottom) = (x + w, y + h);
    let ends = [
        p(x + rx, y),
        p(right - rx, y),
        p(right, y + ry),
        p(right, bottom - ry),
        p(right - rx, bottom),
        p(x + rx, bottom),
        p(x, bottom - ry),
        p(x, y + ry),
    ];
    let piece = |i: usize| {
        let (from, to) = (ends[i], ends[(i + 1) % 8]);
        if i.is_multiple_of(2) {
            PathSeg::Line(kurbo::Line::new(from, to))
        } else {
            quarter(from, to, i % 4 == 1)
        }
    };
    (0..8).map(piece).collect()
}

#[test]
fn round_rectangles_are_found_from_every_point_and_in_both_senses() {
    for ([x, y, w, h], [rx, ry]) in [
        ([1.0, 2.0, 30.0, 20.0], [4.0, 4.0]),
        ([-31.5, -12.25, 20.0, 50.0], [4.0, 9.0]),
        ([-100.0, 7.0, 300.0, 20.0], [90.0, 2.0]),
        ([5.0, 5.0, 8.0, 30.0], [4.0, 3.0]),
        ([5.0, 5.0, 30.0, 8.0], [3.0, 4.0]),
    ] {
        let pieces = round_rect_pieces([x, y, w, h], [rx, ry]);
        let pieces: Vec<PathSeg> = pieces
            .into_iter()
            .filter(|s| s.start() != s.end())
            .collect();
        let radii = if rx == ry {
            format!("rx={rx}")
        } else {
            format!("rx={rx} ry={ry}")
        };
        let expected = format!("x={x} y={y} width={w} height={h} {radii}");
        for first in 0..pieces.len() {
            for backwards in [false, true] {
                let d = data(&pieces, first, backwards);
                let (text, starts_alike) = found(&d).unwrap_or_else(|| panic!("{d}"));
                assert_eq!(text, expected, "{d}");
                let start = Point::new(x + rx, y);
                let alike = !backwards && pieces[first].start() == start;
                assert_eq!(starts_alike, alike, "{d}");
            }
        }
    }
}

fn line(from: Point, to: Point) -> PathSeg {
    PathSeg::Line(kurbo::Line::new(from, to))
}

/// The round rectangle 30 by 20 at (1, 2) with other pieces in place of one.
fn with_other(place: usize, by: &[Point]) -> Vec<PathSeg> {
    let mut pieces = round_rect_pieces([1.0, 2.0, 30.0, 20.0], [4.0; 2]);
    let others = by.windows(2).map(|pair| line(pair[0], pair[1]));
    pieces.splice(place..=place, others);
    pieces
}

fn is_no_shape(name: &str, pieces: &[PathSeg]) {
    for backwards in [false, true] {
        let d = data(pieces, 0, backwards);
        assert_eq!(found(&d), None, "{name} {d}");
    }
}

#[test]
fn a_side_of_a_round_rectangle_is_straight() {
    let right = round_rect_pieces([1.0, 2.0, 30.0, 20.0], [4.0; 2]);
    for side in [0, 2, 4, 6] {
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|t| right[side].eval(t));
        let straight = with_other(side, &[start, middle, end]);
        assert!(found(&data(&straight, 0, false)).is_some());
        let inside = middle.lerp(Point::new(16.0, 12.0), 0.1);
        is_no_shape("dented", &with_other(side, &[start, inside, end]));
        let [beyond, before] = [1.05, 0.6].map(|t| right[side].eval(t));
        is_no_shape("folded", &with_other(side, &[start, beyond, before, end]));
    }
    let crossed = "M5 2L27 2C29.209 2 31 3.791 31 6L31 18C31 20.209 29.209 22 27 22L5 2Z";
    assert_eq!(found(crossed), None);
}

#[test]
fn a_corner_of_a_round_rectangle_is_round() {
    let right = round_rect_pieces([1.0, 2.0, 30.0, 20.0], [4.0; 2]);
    for place in [1, 3, 5, 7] {
        let (from, to) = (right[place].start(), right[place].end());
        let is_along_x = place % 4 == 1;
        let mut hollow = right.clone();
        hollow[place] = quarter(from, to, !is_along_x);
        is_no_shape("hollow", &hollow);
        let corner = if is_along_x {
            Point::new(to.x, from.y)
        } else {
            Point::new(from.x, to.y)
        };
        is_no_shape("sharp", &with_other(place, &[from, corner, to]));
        is_no_shape("cut", &with_other(place, &[from, to]));
    }
    let other = round_rect_pieces([1.0, 2.0, 30.0, 20.0], [6.0; 2]);
    let mut uneven = right.clone();
    uneven[0] = line(right[0].start(), other[1].start());
    uneven[1] = other[1];
    uneven[2] = line(other[1].end(), right[2].end());
    is_no_shape("uneven", &uneven);
}

/// An ellipse from its right end towards +y: four pieces.
fn ellipse_pieces(center: Point, [rx, ry]: [f64; 2]) -> Vec<PathSeg> {
    let ends = [(rx, 0.0), (0.0, ry), (-rx, 0.0), (0.0, -ry)].map(|way| center + Vec2::from(way));
    (0..4)
        .map(|i| quarter(ends[i], ends[(i + 1) % 4], i % 2 == 1))
        .collect()
}

#[test]
fn ellipses_are_found_from_every_point_and_in_both_senses() {
    for (center, [rx, ry], expected) in [
        (Point::new(3.0, -4.0), [5.0, 5.0], "cx=3 cy=-4 r=5"),
        (
            Point::new(-30.0, 1.0),
            [12.5, 5.0],
            "cx=-30 cy=1 rx=12.5 ry=5",
        ),
        (Point::new(0.5, 0.0), [6.0, 30.0], "cx=0.5 cy=0 rx=6 ry=30"),
    ] {
        let pieces = ellipse_pieces(center, [rx, ry]);
        for first in 0..4 {
            for backwards in [false, true] {
                let d = data(&pieces, first, backwards);
                let alike = first == 0 && !backwards;
                assert_eq!(found(&d), Some((expected.to_owned(), alike)), "{d}");
            }
        }
    }
}

#[test]
fn one_closed_subpath_of_moderate_length_is_a_shape() {
    let circle = data(&ellipse_pieces(Point::ORIGIN, [5.0, 5.0]), 0, false);
    assert!(found(&circle).is_some());
    let open = circle.trim_end_matches('Z');
    assert_eq!(found(open), None);
    assert_eq!(found(&format!("{circle}{circle}")), None);
    assert_eq!(found(&format!("{open}M0 0L1 1Z")), None);
    let padded =
        |length: usize| circle.replace("M5", &format!("M{}5", " ".repeat(length - circle.len())));
    assert!(found(&padded(LONGEST)).is_some());
    assert_eq!(found(&padded(LONGEST + 1)), None);
    // Twice around, half of it, and an egg.
    let twice = format!("{open}{}", &circle[circle.find('C').unwrap()..]);
    assert_eq!(found(&twice), None);
    let half = circle.split_inclusive('C').take(3).collect::<String>();
    assert_eq!(found(&format!("{}Z", half.trim_end_matches('C'))), None);
    assert_eq!(found(&circle.replace("-5.000 0.000", "-5.500 0.000")), None);
}
