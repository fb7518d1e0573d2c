//! Shapes as the paths that SVG 2 gives them.

use kurbo::{Point, Vec2};

use super::numbers;
use super::placing::Coordinates;
use super::tag::Tag;
use crate::angle::Angle;
use crate::contour::{Contour, ContourPen};
use crate::document::shape::element::shape;
use crate::document::shape::length::Length;
use crate::document::shape::used::UsedShape;
use crate::document::style::property::ElementKind;
use crate::error::{Error, Result, TextError, finite};
use crate::number::decimal_sum;
use crate::path::{self, place_of, shortened};
use crate::path_data::grammar::is_space;
use crate::shape::endpoint::SvgArc;

/// The contours of an element.
pub(super) fn contours(tag: &Tag<'_>, place: &Coordinates) -> Result<Vec<Contour>> {
    let given = |name| place.length(tag, name, Some(0.0));
    let mut pen = ContourPen::default();
    match tag.name {
        "line" => {
            let from = Point::new(given("x1")?, given("y1")?);
            lines(&mut pen, &[from, Point::new(given("x2")?, given("y2")?)])?;
        }
        "polyline" | "polygon" => {
            let points = points(&tag.attribute("points")?.unwrap_or_default())?;
            lines(&mut pen, &points)?;
            if tag.name == "polygon" && !points.is_empty() {
                pen.close();
            }
        }
        name => match ElementKind::named(name).filter(|kind| *kind != ElementKind::Path) {
            Some(kind) => used(kind, tag, place, &mut pen)?,
            None => return path::contours(&tag.property("d")?.unwrap_or_default()),
        },
    }
    Ok(pen.contours())
}

/// The points of a `polyline` or a `polygon`. SVG 2 draws those before an error, as it does with path data: both are refused here.
fn points(text: &str) -> Result<Vec<Point>> {
    let wrong = |at: usize| {
        let place = if text[at..].trim_matches(is_space).is_empty() {
            "at the end".to_owned()
        } else {
            place_of(text, text[..at].chars().count() + 1)
        };
        Error::Text(TextError::Points {
            points: shortened(text),
            why: format!("a number is expected {place}"),
        })
    };
    let numbers = numbers::list(text).map_err(wrong)?;
    match numbers.as_chunks::<2>() {
        (pairs, []) => Ok(pairs.iter().map(|[x, y]| Point::new(*x, *y)).collect()),
        _ => Err(wrong(text.len())),
    }
}

fn lines(pen: &mut ContourPen, points: &[Point]) -> Result<()> {
    for (i, p) in points.iter().enumerate() {
        finite("coordinate", p.x)?;
        finite("coordinate", p.y)?;
        if i == 0 {
            pen.move_to(*p);
        } else {
            pen.line(*p);
        }
    }
    Ok(())
}

/// A circle, an ellipse or a rectangle by its used values.
fn used(kind: ElementKind, tag: &Tag<'_>, place: &Coordinates, pen: &mut ContourPen) -> Result<()> {
    let given = |name| place.length(tag, name, Some(0.0));
    let values = |lengths: [Length; 2]| lengths.map(|length| length.value);
    let lengths: Vec<(&str, Option<f64>)> = (kind.geometry().iter())
        .map(|&name| Ok((name, place.optional_length(tag, name)?)))
        .collect::<Result<_>>()?;
    let get = |name: &str| lengths.iter().find(|(known, _)| *known == name)?.1;
    match shape(kind, |name| Ok(get(name).map(Length::computed))) {
        Ok(UsedShape::Ellipse(center, radii)) => ellipse(pen, values(center), values(radii)),
        Ok(UsedShape::Rect(corner, size, radii)) => {
            rect(pen, values(corner), values(size), values(radii))
        }
        Ok(UsedShape::Square) => {
            let size = [given("width")?, given("height")?];
            if size[0] > 0.0 && size[1] > 0.0 {
                rect(pen, [given("x")?, given("y")?], size, [0.0; 2])?;
            }
            Ok(())
        }
        // With all lengths read, that is that nothing is drawn.
        Err(_) => Ok(()),
    }
}

/// Four quarters from the right on.
fn ellipse(pen: &mut ContourPen, [x, y]: [f64; 2], [rx, ry]: [f64; 2]) -> Result<()> {
    let [right, bottom] = [sum(x, rx)?, sum(y, ry)?];
    let [left, top] = [sum(x, -rx)?, sum(y, -ry)?];
    pen.move_to(Point::new(right, y));
    for to in [(x, bottom), (left, y), (x, top), (right, y)] {
        quarter(pen, [rx, ry], to.into())?;
    }
    pen.close();
    Ok(())
}

/// Lines and quarters from the left end of the upper side on, those of no length left out.
fn rect(
    pen: &mut ContourPen,
    [x, y]: [f64; 2],
    [w, h]: [f64; 2],
    radii @ [rx, ry]: [f64; 2],
) -> Result<()> {
    let [right, bottom] = [sum(x, w)?, sum(y, h)?];
    let [left_in, top_in] = [sum(x, rx)?, sum(y, ry)?];
    let [right_in, bottom_in] = [sum(right, -rx)?, sum(bottom, -ry)?];
    pen.move_to(Point::new(left_in, y));
    for (to, corner) in [
        ((right_in, y), (right, top_in)),
        ((right, bottom_in), (right_in, bottom)),
        ((left_in, bottom), (x, bottom_in)),
        ((x, top_in), (left_in, y)),
    ] {
        let [to, corner] = [to, corner].map(Point::from);
        if pen.here() != to {
            pen.line(to);
        }
        if to != corner {
            quarter(pen, radii, corner)?;
        }
    }
    pen.close();
    Ok(())
}

fn quarter(pen: &mut ContourPen, [rx, ry]: [f64; 2], to: Point) -> Result<()> {
    pen.arc(&SvgArc {
        from: pen.here(),
        radii: Vec2::new(rx, ry),
        rotation: Angle::ZERO,
        large_arc: false,
        sweep: true,
        to,
    })
}

fn sum(a: f64, b: f64) -> Result<f64> {
    finite("coordinate", decimal_sum(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::svg_shapes;

    /// The contours of one shape in a viewport of 100 by 50, or why there are none.
    fn read(shape: &str) -> core::result::Result<Vec<Contour>, String> {
        let svg = format!("<svg viewBox='0 0 100 50'>{shape}</svg>");
        let found = svg_shapes(svg).unwrap().paths.remove(0).contours;
        found
            .map(|(contours, _)| contours)
            .map_err(|error| error.to_string())
    }

    #[test]
    fn shapes_are_the_paths_that_svg_2_gives_them() {
        for (shape, data) in [
            (
                "<circle cx='.1' cy='.2' r='.3'/>",
                "M.4 .2A.3.3 0 0 1 .1 .5A.3.3 0 0 1-.2 .2A.3.3 0 0 1 .1-.1A.3.3 0 0 1 .4 .2Z",
            ),
            (
                "<ellipse cx='50%' rx='4' ry='10%'/>",
                "M54 0A4 5 0 0 1 50 5A4 5 0 0 1 46 0A4 5 0 0 1 50-5A4 5 0 0 1 54 0Z",
            ),
            (
                "<rect x='.1' y='1' width='.2' height='4'/>",
                "M.1 1H.3V5H.1Z",
            ),
            (
                "<rect x='1' y='2' width='10' height='20' rx='3' ry='4'/>",
                "M4 2H8A3 4 0 0 1 11 6V18A3 4 0 0 1 8 22H4A3 4 0 0 1 1 18V6A3 4 0 0 1 4 2Z",
            ),
            (
                "<rect width='2' height='2' rx='9'/>",
                "M1 0A1 1 0 0 1 2 1A1 1 0 0 1 1 2A1 1 0 0 1 0 1A1 1 0 0 1 1 0Z",
            ),
            ("<line x1='1' x2='10%' y2='10%'/>", "M1 0L10 5"),
            ("<line/>", "M0 0L0 0"),
            ("<polyline points=' 1,2 3-4\n.5.5 '/>", "M1 2L3-4L.5.5"),
            ("<polyline points='1 2'/>", ""),
            ("<polyline points=' '/>", ""),
            ("<polygon points='1 2,3,4 5 6'/>", "M1 2L3 4L5 6Z"),
            ("<polygon points='1 2 3 4 1 2'/>", "M1 2L3 4L1 2Z"),
            ("<polygon points='1 2'/>", "M1 2Z"),
            ("<polygon/>", ""),
            ("<rect width='0' height='5'/>", ""),
            ("<rect width='5' height='-1'/>", ""),
            ("<circle r='0'/>", ""),
        ] {
            assert_eq!(
                read(shape).unwrap(),
                path::contours(data).unwrap(),
                "{shape}"
            );
        }
    }

    #[test]
    fn what_is_wrong_with_a_shape_is_said_in_its_own_words() {
        let points = |points: &str| format!("<polygon points='{points}'/>");
        for (shape, why) in [
            (
                points("50 0C50 27.6 27.6 50 0 50"),
                "cannot read the points '50 0C50 27.6 27.6 50 0 50': a number is expected at character 5",
            ),
            (
                points(" 0,0 4 "),
                "cannot read the points ' 0,0 4': a number is expected at the end",
            ),
            (
                points("0,0 4,4,"),
                "cannot read the points '0,0 4,4,': a number is expected at the end",
            ),
            (
                points("0,0,\n,4 4"),
                "cannot read the points '0,0, ,4 4': a number is expected in line 2 at character 1",
            ),
            (
                points(",0 0"),
                "cannot read the points ',0 0': a number is expected at character 1",
            ),
            (
                "<circle cx='inf%' r='4'/>".to_owned(),
                "its cx 'inf%' is not read here",
            ),
        ] {
            assert_eq!(read(&shape).unwrap_err(), why);
        }
        for beyond in [
            points("0 0 1e200 0"),
            "<line x2='1e200'/>".to_owned(),
            "<rect x='1e150' width='1e149' height='1'/>".to_owned(),
            "<circle r='1e200'/>".to_owned(),
        ] {
            assert!(read(&beyond).is_err(), "{beyond}");
        }
    }
}
