//! `<circle>`, `<ellipse>` and `<rect>` as path data: SVG 2's equivalent paths, start point, direction and order included.

use std::borrow::Cow;

use kurbo::{ParamCurve, Point, Vec2};

use crate::approximate::approximate;
use crate::document::path::bezier;
use crate::document::path::collapse::is_too_small;
use crate::document::path::scratch::Scratch;
use crate::document::shape::length::{self, Length, LengthAttribute};
use crate::document::shape::text::ShapeText;
use crate::document::shape::used::UsedShape;
use crate::document::style::property::ElementKind;
use crate::document::{Options, Reason};
use crate::number::decimal::Decimal;
use crate::shape::Truth;
use crate::shape::endpoint::SvgArc;
use crate::{Angle, Rule};

/// Reads a shape; `attribute` gives the resolved value of an attribute, if the element has it.
pub(in crate::document) fn read<'v>(
    kind: ElementKind,
    attribute: impl Fn(&str) -> Option<Cow<'v, str>>,
) -> Result<UsedShape, Reason> {
    let stands = |name| {
        attribute(name).is_some_and(|text| match length::read(&text) {
            LengthAttribute::Length(length) => length.value > 0.0,
            LengthAttribute::Auto => false,
            LengthAttribute::TooLarge | LengthAttribute::Unknown => true,
        })
    };
    let get = |name: &'static str| -> Result<Option<Length>, Reason> {
        let Some(text) = attribute(name) else {
            return Ok(None);
        };
        match length::read(&text) {
            LengthAttribute::Length(length) => Ok(Some(length)),
            // `auto` is a value of rx and ry alone, and of width and height, where it is zero. SVG 2 takes the other radius for it,
            // Chromium zero.
            LengthAttribute::Auto if matches!(name, "width" | "height") => Ok(None),
            LengthAttribute::Auto if name == "rx" && !stands("ry") => Ok(None),
            LengthAttribute::Auto if name == "ry" && !stands("rx") => Ok(None),
            LengthAttribute::TooLarge => Err(Reason::TooLarge),
            _ => Err(Reason::Length {
                attribute: name,
                value: text.chars().take(40).collect(),
            }),
        }
    };
    shape(kind, get)
}

/// The shape with these lengths; `get` gives that of an attribute, if the element has one.
pub(in crate::document) fn shape(
    kind: ElementKind,
    get: impl Fn(&'static str) -> Result<Option<Length>, Reason>,
) -> Result<UsedShape, Reason> {
    // SVG 2: a negative radius is an error, and ignored, so that it is `auto`, which is the other one.
    let radius = |name| get(name).map(|found| found.filter(|radius| radius.value >= 0.0));
    let place = |name| get(name).map(|found| found.unwrap_or_else(Length::zero));
    match kind {
        ElementKind::Circle => {
            let radius = positive("r", get("r")?)?;
            Ok(UsedShape::Ellipse(
                [place("cx")?, place("cy")?],
                [radius; 2],
            ))
        }
        ElementKind::Ellipse => {
            let (rx, ry) = (radius("rx")?, radius("ry")?);
            let radii = [positive("rx", rx.or(ry))?, positive("ry", ry.or(rx))?];
            Ok(UsedShape::Ellipse([place("cx")?, place("cy")?], radii))
        }
        ElementKind::Rect => {
            let (rx, ry) = (radius("rx")?, radius("ry")?);
            let radii =
                [rx.or(ry), ry.or(rx)].map(|radius| radius.filter(|radius| radius.value > 0.0));
            let [Some(rx), Some(ry)] = radii else {
                return Ok(UsedShape::Square);
            };
            let size = [
                positive("width", get("width")?)?,
                positive("height", get("height")?)?,
            ];
            let radii = [clamp(rx, size[0]), clamp(ry, size[1])];
            Ok(UsedShape::Rect([place("x")?, place("y")?], size, radii))
        }
        ElementKind::Path => Ok(UsedShape::Square),
    }
}

fn positive(name: &str, length: Option<Length>) -> Result<Length, Reason> {
    let why = match length {
        Some(length) if length.value > 0.0 => return Ok(length),
        Some(length) if length.value < 0.0 => "negative",
        Some(_) => "zero",
        None => "missing",
    };
    Err(Reason::NotDrawn(format!("`{name}` is {why}")))
}

/// A corner radius is at most half of the side.
fn clamp(radius: Length, side: Length) -> Length {
    let half = side.value / 2.0;
    if radius.value <= half {
        return radius;
    }
    let exact = side.exact;
    match exact.units.checked_mul(5) {
        Some(units) if exact.decimals < crate::number::decimal::MAX_DECIMALS => Length {
            value: half,
            exact: Decimal {
                units,
                decimals: exact.decimals + 1,
            },
        },
        _ => Length::computed(half),
    }
}

/// Writes the path data of a shape to `out`; returns how far it lies from the shape at most, where that is to be measured.
pub(in crate::document) fn path_data(
    shape: &UsedShape,
    options: &Options,
    scratch: &mut Scratch,
    out: &mut Vec<u8>,
) -> Result<f64, Reason> {
    out.clear();
    match shape.fine_enough(&options.cut) {
        UsedShape::Ellipse(center, radii) => {
            let [rx, ry] = radii.map(|radius| radius.value);
            check_place(&[&center, &radii], options.rule)?;
            bezier::ellipse(
                Point::new(center[0].value, center[1].value),
                Vec2::new(rx, ry),
                options,
                &mut scratch.memo,
                &mut scratch.beziers,
            )?;
            let drawn = &scratch.beziers;
            let mut text = ShapeText::new(options.precision, drawn.decimals, out);
            // Where digits are asked for that leave some out, sums are rounded as every command rounds them.
            let fits = |length: &Length| {
                let asked = options.precision.map(u32::from);
                asked.is_none_or(|asked| length.exact.decimals <= asked)
            };
            if center.iter().chain(&radii).all(fits) {
                text.known = radii;
            }
            text.base = center;
            text.truth = options.measure.then(|| {
                let [cx, cy] = center.map(|length| length.value);
                Truth::new(Point::new(cx, cy), Vec2::new(rx, ry), Vec2::new(1.0, 0.0))
            });
            // As every command refuses it, by what rounding leaves.
            if options.precision.is_some() && text.is_flat(drawn) {
                return Err(Reason::Collapses);
            }
            let start = drawn.segments.first().map(ParamCurve::start);
            text.move_to(text.place(start.unwrap_or_default()));
            text.curves(drawn, true);
            Ok(text.close())
        }
        UsedShape::Rect(corner, size, radii) => rect(corner, size, radii, options, scratch, out),
        UsedShape::Square => Ok(0.0),
    }
}

/// How many times its size a shape may lie from the origin: beyond, the single precision of renderers moves its points by a hundredth of that.
const FARTHEST: f64 = (1 << 18) as f64;

/// Refuses what arithmetic or a renderer cannot hold.
fn check_place(lengths: &[&[Length; 2]], rule: Rule) -> Result<(), Reason> {
    let largest = |pairs: &[&[Length; 2]]| {
        let lengths = pairs.iter().flat_map(|pair| pair.iter());
        lengths.fold(0.0, |most: f64, length| most.max(length.value.abs()))
    };
    let (place, sizes) = lengths.split_at(1);
    let most = largest(sizes);
    // A literal handle may take control points far beyond the radii.
    let reach = match rule {
        Rule::Handle(k) => k.abs().max(1.0),
        _ => 1.0,
    };
    if largest(lengths) * reach > 1e15 || largest(place) > FARTHEST * most {
        return Err(Reason::TooLarge);
    }
    Ok(())
}

/// The equivalent path of a rectangle: from (x + rx, y) clockwise, lines of no length left out.
fn rect(
    corner: [Length; 2],
    size: [Length; 2],
    radii: [Length; 2],
    options: &Options,
    scratch: &mut Scratch,
    out: &mut Vec<u8>,
) -> Result<f64, Reason> {
    let [rx, ry] = radii.map(|radius| radius.value);
    check_place(&[&corner, &size, &radii], options.rule)?;
    // Of such corners rounding leaves none.
    let leaves_none = |decimals| is_too_small(rx.min(ry), decimals);
    if options.precision.is_some_and(leaves_none) {
        return Err(Reason::Collapses);
    }
    let [x, y] = corner;
    let [right, bottom] = [x.plus(size[0]), y.plus(size[1])];
    let [left_in, top_in] = [x.plus(radii[0]), y.plus(radii[1])];
    let [right_in, bottom_in] = [right.minus(radii[0]), bottom.minus(radii[1])];
    let digits = |length: Length| length.exact;
    // Where each corner begins and ends, the way there, and the line before it.
    let corners = [
        ([[right_in, y], [right, top_in]], (rx, ry), b'H'),
        ([[right, bottom_in], [right_in, bottom]], (-rx, ry), b'V'),
        ([[left_in, bottom], [x, bottom_in]], (-rx, -ry), b'H'),
        ([[x, top_in], [left_in, y]], (rx, -ry), b'V'),
    ];
    let straight = [size[0].value > 2.0 * rx, size[1].value > 2.0 * ry];
    let mut text = ShapeText::new(options.precision, 0, out);
    text.known = radii;
    for (index, ([start, end], to, line)) in corners.into_iter().enumerate() {
        // As for an ellipse: where a precision is asked for, it is points that are rounded.
        let place = Point::new(start[0].value, start[1].value);
        let from = options.precision.map_or(Point::ZERO, |_| place);
        let arc = SvgArc {
            from,
            radii: Vec2::new(rx, ry),
            rotation: Angle::ZERO,
            large_arc: false,
            sweep: true,
            to: from + Vec2::from(to),
        };
        let (memo, beziers) = (&mut scratch.memo, &mut scratch.beziers);
        bezier::arc(approximate, &arc, options, memo, beziers)?;
        if index == 0 {
            text.decimals = scratch.beziers.decimals;
            text.move_to([left_in, y].map(digits));
        }
        if straight[index % 2] {
            text.line_to(line, start.map(digits));
        }
        text.base = start;
        text.end = Some(end.map(digits));
        text.truth = options.measure.then(|| corner_truth(place, to, index));
        text.curves(&scratch.beziers, index == 3);
    }
    Ok(text.close())
}

/// The true shape of a corner of this number that begins there and ends so far away: its centre lies above, below or beside its start in turn.
fn corner_truth(start: Point, to: (f64, f64), number: usize) -> Truth {
    let to_center = if number.is_multiple_of(2) {
        Vec2::new(0.0, to.1)
    } else {
        Vec2::new(to.0, 0.0)
    };
    let radii = Vec2::new(to.0.abs(), to.1.abs());
    Truth::new(start + to_center, radii, Vec2::new(1.0, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementKind::{Circle, Ellipse, Rect};

    fn path(kind: ElementKind, attributes: &[(&str, &str)]) -> Result<String, Reason> {
        let shape = read(kind, |name| {
            attributes
                .iter()
                .find(|(known, _)| *known == name)
                .map(|(_, value)| Cow::Borrowed(*value))
        })?;
        let mut out = Vec::new();
        path_data(
            &shape,
            &Options::default(),
            &mut Scratch::default(),
            &mut out,
        )?;
        Ok(String::from_utf8(out).unwrap())
    }

    #[test]
    fn a_circle_starts_at_three_o_clock_and_closes_on_itself() {
        let text = path(Circle, &[("cx", "12"), ("cy", "12"), ("r", "10")]).unwrap();
        assert_eq!(
            text,
            "M22 12c0 5.5192-4.4808 10-10 10C6.4808 22 2 17.5192 2 12 2 6.4808 6.4808 2 12 2 17.5192 2 22 6.4808 22 12Z"
        );
    }

    #[test]
    fn radii_of_a_rectangle_are_shared_and_clamped() {
        let size = [("width", "10"), ("height", "4")];
        let rounded = path(Rect, &[&size[..], &[("ry", "9")]].concat()).unwrap();
        assert!(rounded.starts_with("M5 0c"), "{rounded}");
        let straight = path(Rect, &[&size[..], &[("rx", "1")]].concat()).unwrap();
        assert!(
            straight.starts_with("M1 0H9c")
                && straight.contains("V3c")
                && straight.ends_with(" 1 0Z"),
            "{straight}"
        );
        assert_eq!(
            path(Rect, &[&size[..], &[("rx", "0"), ("ry", "9")]].concat()).unwrap(),
            ""
        );
        assert_eq!(path(Rect, &size).unwrap(), "");
    }

    #[test]
    fn a_negative_radius_is_the_other_one() {
        let ellipse = |rx, ry| path(Ellipse, &[("rx", rx), ("ry", ry)]).unwrap();
        assert_eq!(ellipse("2", "-1"), ellipse("2", "2"));
        assert_eq!(ellipse("-1", "2"), ellipse("2", "2"));
        let rect = |rx, ry| {
            let size = [("width", "10"), ("height", "4")];
            path(Rect, &[&size[..], &[("rx", rx), ("ry", ry)]].concat()).unwrap()
        };
        assert_eq!(rect("-1", ".5"), rect(".5", ".5"));
        assert_eq!(rect("-1", "-1"), "");
    }

    #[test]
    fn what_draws_nothing_is_told() {
        for (kind, attributes, code) in [
            (Circle, &[("r", "0")][..], "not-drawn"),
            (Circle, &[("r", "-1")], "not-drawn"),
            (Circle, &[], "not-drawn"),
            (Circle, &[("r", "50%")], "length"),
            (Circle, &[("r", "auto")], "length"),
            (Ellipse, &[("rx", "auto")], "not-drawn"),
            (Ellipse, &[("rx", "auto"), ("ry", "auto")], "not-drawn"),
            (Ellipse, &[("rx", "auto"), ("ry", "3")], "length"),
            (Rect, &[("rx", "3"), ("ry", "auto")], "length"),
            (Ellipse, &[("rx", "-2"), ("ry", "-1")], "not-drawn"),
            (Ellipse, &[("rx", "-2"), ("ry", "0")], "not-drawn"),
            (Rect, &[("rx", "2"), ("width", "3")], "not-drawn"),
        ] {
            assert_eq!(
                path(kind, attributes).unwrap_err().code(),
                code,
                "{attributes:?}"
            );
        }
        assert!(path(Ellipse, &[("ry", "3")]).unwrap().starts_with("M3 0C"));
    }

    #[test]
    fn vertices_keep_the_digits_of_the_file() {
        let text = path(Circle, &[("cx", ".12345678"), ("r", "1")]).unwrap();
        assert!(text.starts_with("M1.12345678 0c"), "{text}");
        assert!(text.ends_with(" 1.12345678 0Z"), "{text}");
    }

    #[test]
    fn half_of_a_side_that_has_no_room_for_a_decimal_is_rounded() {
        let side = Length {
            value: 4.0,
            exact: Decimal {
                units: 4_000_000_000_000_000_000,
                decimals: 18,
            },
        };
        assert_eq!(clamp(Length::computed(3.0), side).value, 2.0);
    }

    #[test]
    fn a_rectangle_whose_radii_are_both_automatic_has_square_corners() {
        let sides = [("width", "9"), ("height", "9")];
        let of = |radii: [&'static str; 2]| {
            let all = [("rx", radii[0]), ("ry", radii[1])]
                .into_iter()
                .chain(sides);
            read(Rect, |name| {
                let found = all.clone().find(|(known, _)| *known == name);
                found.map(|(_, value)| Cow::Borrowed(value))
            })
        };
        assert!(matches!(of(["auto", "auto"]), Ok(UsedShape::Square)));
        // Browsers disagree on what the other one is then.
        for other in ["2", "5%"] {
            assert!(matches!(of(["auto", other]), Err(Reason::Length { .. })));
        }
    }
}
